//! Former names of keys: a file that has them is read, with a note that gives the present name.

use std::collections::BTreeSet;
use std::sync::{Mutex, OnceLock};

use super::error::CaseError;
use super::sections::CASE_FILE;
use super::spanned_toml::{Node, Section, Value, join};

/// Section, key, former and present value.
const VALUES: [(&str, &str, &str, &str); 2] = [
    ("solver", "method", "symplectic", "verlet"),
    ("start", "gaps", "any", "random"),
];

static LISTENER: OnceLock<fn(&str)> = OnceLock::new();
static NOTES: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// Sets the function that gets each note on a former name, once for each place of a file.
pub fn on_former_name(listener: fn(&str)) {
    // A second listener would get none of the notes: the first one stays.
    let _ = LISTENER.set(listener);
}

fn note(node: &Node, file: &str, former: &str, present: &str) {
    let message = format!("{former} is now {present}; the former name is read as well");
    let text = node.error(file, former, message).to_string();
    let new = NOTES
        .lock()
        .is_ok_and(|mut notes| notes.insert(text.clone()));
    if let (true, Some(listener)) = (new, LISTENER.get()) {
        listener(&text);
    }
}

/// The present name of a key.
pub(super) fn present<'a>(section: &str, key: &'a str) -> &'a str {
    #[cfg(feature = "files")]
    let of_rotor = crate::rotor_file::keys::ROTOR_FILE.of_section(section);
    #[cfg(not(feature = "files"))]
    let of_rotor = &[];
    let mut all = CASE_FILE.of_section(section).iter().chain(of_rotor);
    let found = all.find(|of| !key.is_empty() && of.formerly == key);
    found.map_or(key, |of| of.name)
}

/// Gives the keys of a case, of a rotor file or of a plan their present names, at any depth.
///
/// # Errors
/// A [`CaseError`] if a section has a key under both names.
pub(crate) fn rename(root: &mut Section, file: &str) -> Result<(), CaseError> {
    rename_in("", root, file)
}

fn rename_in(section: &str, entries: &mut Section, file: &str) -> Result<(), CaseError> {
    let names: Vec<String> = entries.keys().cloned().collect();
    for name in names {
        let mut path: Vec<String> = name.split('.').map(str::to_owned).collect();
        if !is_former(section, &path) {
            continue;
        }
        if let Some(node) = entries.remove(&name) {
            path_to_present(section, &mut path, &node, file);
            let (former, present) = (join(section, &name), path.join("."));
            if entries.contains_key(&present) {
                let present = join(section, &present);
                let message = format!(
                    "{former} is the former name of {present}, which is given as well: drop one"
                );
                return Err(node.error(file, &former, message));
            }
            entries.insert(present, node);
        }
    }
    for (name, node) in entries.iter_mut() {
        // Sections with numbers are those of a list; a key in quotes may be dotted.
        let is_number = name.bytes().all(|b| b.is_ascii_digit());
        let inner = if is_number { section } else { name.as_str() };
        match &mut node.value {
            Value::Section(entries) => rename_in(inner, entries, file)?,
            _ => {
                let (of, key) = inner.rsplit_once('.').unwrap_or((section, inner));
                rename_value(of, key, node, file)?;
            }
        }
    }
    Ok(())
}

/// The section of the last part of a dotted key below `section`.
fn section_of<'a>(section: &'a str, path: &'a [String]) -> &'a str {
    let front = path.iter().rev().skip(1).map(String::as_str);
    let mut names = front.filter(|part| !part.bytes().all(|b| b.is_ascii_digit()));
    names.next().unwrap_or(section)
}

fn is_former(section: &str, path: &[String]) -> bool {
    let key = path.last().map_or("", String::as_str);
    present(section_of(section, path), key) != key
}

fn path_to_present(section: &str, path: &mut [String], node: &Node, file: &str) {
    let former = join(section, &path.join("."));
    let of = section_of(section, path).to_owned();
    if let Some(key) = path.last_mut() {
        *key = present(&of, key).to_owned();
    }
    note(node, file, &former, &join(section, &path.join(".")));
}

/// Gives the key of a `--set` or of a plan, and its value, their present names.
pub(super) fn replacement(path: &mut [String], node: &mut Node) {
    if is_former("", path) {
        path_to_present("", path, node, "");
    }
    if let Some(key) = path.last() {
        // A list of names is an error of the reader.
        let _ = rename_value(section_of("", path), key, node, "");
    }
}

fn rename_value(section: &str, key: &str, node: &mut Node, file: &str) -> Result<(), CaseError> {
    if let Value::List(items) = &mut node.value {
        for item in items {
            match &mut item.value {
                Value::Section(entries) => rename_in(key, entries, file)?,
                _ => rename_value(section, key, item, file)?,
            }
        }
        return Ok(());
    }
    let Value::Text(text) = &node.value else {
        return Ok(());
    };
    let mut all = VALUES.iter();
    let found = all.find(|(of, name, former, _)| (*of, *name, *former) == (section, key, text));
    if let Some((.., former, present)) = found {
        let of = |value| format!("{section}.{key} = \"{value}\"");
        note(node, file, &of(former), &of(present));
        node.value = Value::Text((*present).to_owned());
        node.place.written = format!("\"{present}\"");
    }
    Ok(())
}
