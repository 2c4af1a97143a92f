//! Completion of a document: its keys are known, none is missing, and defaults are filled in.

use super::document::{CaseDocument, SCHEMA};
use super::error::CaseError;
use super::key::{Key, Presence};
use super::keys::{self, hint};
use super::missing;
use super::sections::material::NUMBERS;
use super::sections::{HEAD, SECTIONS, bearing};
use super::spanned_toml::{Node, Section, Value, join, nth};
use super::value::CaseValue;

/// Completes a document; the dotted keys that took their default.
pub(super) fn complete(document: &mut CaseDocument) -> Result<Vec<String>, CaseError> {
    // A later schema may have other keys: say so before complaining about them.
    if document.has("schema") && document.number("schema") != Some(SCHEMA as f64) {
        let allowed = format!("{SCHEMA}, the only schema that this version of Cageless reads");
        let value = document.value("schema").map(|value| value.written());
        return Err(document
            .tree
            .refusal("schema", &value.unwrap_or_default(), &allowed));
    }
    check_names(document)?;
    missing::check(document)?;
    move_seed(document)?;
    let mut left_out: Vec<(String, &Key)> = vec![];
    let absent = |path: &str, keys: &'static [Key], entries: &Section| {
        let keys = keys.iter().filter(|key| !entries.contains_key(key.name));
        let keys = keys.map(|key| (join(path, key.name), key));
        keys.collect::<Vec<_>>()
    };
    left_out.extend(absent("", HEAD, &document.tree.root));
    for table in SECTIONS {
        let sections = document.sections(table)?;
        if sections.is_empty() && !table.optional {
            left_out.extend(absent(table.name, table.keys, &Section::new()));
        }
        for (path, entries) in sections {
            left_out.extend(absent(&path, table.keys, entries));
        }
    }
    let mut defaults = vec![];
    for (path, key) in left_out {
        match (key.presence)() {
            Presence::Default(value) => document.set(&path, value),
            Presence::Derived => {}
            Presence::Required | Presence::Optional => continue,
        }
        defaults.push(path);
    }
    complete_sections(document, &mut defaults);
    Ok(defaults)
}

/// Fills in what follows from other keys of a section.
fn complete_sections(document: &mut CaseDocument, defaults: &mut Vec<String>) {
    let assumed = bearing::conformities(document).into_iter();
    defaults.extend(
        assumed
            .filter(|(_, assumed)| *assumed)
            .map(|(key, _)| key.to_owned()),
    );
    let is_default = |key: &str, defaults: &[String]| defaults.iter().any(|d| d == key);
    // The last μ of a friction table is that of fast sliding.
    let coefficient = "contact.friction_coefficient";
    if let (Some(CaseValue::Table(rows)), true) = (
        document.value("contact.friction_table"),
        is_default(coefficient, defaults),
    ) && let Some([_, last]) = rows.last()
    {
        document.set(coefficient, *last);
    }
    // A preset takes the place of the three numbers.
    if document.has("material.preset") {
        for key in NUMBERS.map(|name| join("material", name)) {
            if is_default(&key, defaults) {
                document.remove(&key);
                defaults.retain(|d| *d != key);
            }
        }
    }
    if document.count("rotor") > 0 && is_default("start.state", defaults) {
        document.set("start.state", "at-rest");
    }
    if document.value("start.state") == Some("rolling".into()) {
        for key in ["start.ring_x_um", "start.ring_y_um"] {
            if !document.has(key) {
                document.set(key, 0.0);
                defaults.push(key.to_owned());
            }
        }
    }
}

/// Puts a seed at the head of the file into its section.
fn move_seed(document: &mut CaseDocument) -> Result<(), CaseError> {
    let root = &mut document.tree.root;
    let Some(seed) = root.remove("seed") else {
        return Ok(());
    };
    let solver = root.entry("solver".to_owned()).or_insert(Node {
        value: Value::Section(Section::new()),
        place: seed.place.clone(),
    });
    let Value::Section(solver) = &mut solver.value else {
        return Ok(());
    };
    match solver.insert("seed".to_owned(), seed) {
        None => Ok(()),
        Some(_) => {
            let why = "solver.seed is at the head of the file as well: drop one";
            Err(document.tree.error("solver.seed", why.to_owned()))
        }
    }
}

/// Refuses names that the table of keys does not have; the first in the file
/// if there are several.
fn check_names(document: &CaseDocument) -> Result<(), CaseError> {
    let mut wrong: Vec<CaseError> = Vec::new();
    let mut check = |section: &str, path: &str, entries: &Section| {
        for (key, node) in entries {
            let known = keys::find(section, key).is_some();
            if !known && !(section.is_empty() && keys::section_meaning(key).is_some()) {
                wrong.push(unknown(document, section, path, key, node));
            }
        }
    };
    check("", "", &document.tree.root);
    for (name, node) in &document.tree.root {
        let items = match &node.value {
            Value::List(items) => items.as_slice(),
            _ => std::slice::from_ref(node),
        };
        for (k, item) in items.iter().enumerate() {
            if let (Value::Section(entries), Some(_)) = (&item.value, keys::section_meaning(name)) {
                check(name, &nth(name, k, items.len()), entries);
            }
        }
    }
    let first = wrong
        .into_iter()
        .min_by_key(|e| e.line().unwrap_or(usize::MAX));
    first.map_or(Ok(()), Err)
}

fn unknown(
    document: &CaseDocument,
    section: &str,
    path: &str,
    name: &str,
    node: &Node,
) -> CaseError {
    let dotted = join(path, name);
    let hint = hint(section, name);
    let what = match node.value {
        Value::Section(_) if section.is_empty() => {
            format!("[{name}] is not a section of a case file")
        }
        _ if section.is_empty() => format!("{dotted} is not a key of a case file"),
        _ => format!("{dotted} is not a key of [{section}]"),
    };
    node.error(&document.tree.name, &dotted, format!("{what}; {hint}"))
}
