//! The text of a case file with other values: its comments, order and spelling stay.

use toml_edit::{ArrayOfTables, DocumentMut, Item, TableLike, Value};

use super::document::CaseDocument;
use super::error::CaseError;
use super::template::CONVENTIONAL;

/// `text` with the values of `document` but for the dotted keys `left_out`. What has that value
/// already stays as it is written.
pub(super) fn edited(
    text: &str,
    document: &CaseDocument,
    left_out: &[String],
) -> Result<String, CaseError> {
    let unreadable = |error: toml_edit::TomlError| CaseError::of_file("case", error.to_string());
    let text = text.trim_start_matches('\u{feff}');
    let mut file: DocumentMut = text.parse().map_err(unreadable)?;
    let wanted = document.to_toml_without(left_out)?;
    let mut wanted: DocumentMut = wanted.parse().map_err(unreadable)?;
    let added = wanted.iter().filter(|(key, _)| !file.contains_key(key));
    let added: Vec<&str> = added.map(|(key, _)| key).collect();
    file = without_stand_ins(text, &added)
        .parse()
        .map_err(unreadable)?;
    for head in ["schema", "title"] {
        if !file.contains_key(head) && left_out.iter().any(|key| key == head) {
            wanted.remove(head);
        }
    }
    // The seed may stand at the head of the file as well.
    if file.contains_key("seed")
        && let Some(solver) = wanted["solver"].as_table_mut()
        && let Some(seed) = solver.remove("seed")
    {
        wanted.insert("seed", seed);
    }
    merge(file.as_table_mut(), wanted.as_table_mut());
    Ok(file.to_string())
}

/// `text` without the comments that stand for sections which it gets: their keys commented out, or the
/// line of a template that says that there are none.
fn without_stand_ins(text: &str, sections: &[&str]) -> String {
    let stands_in = |line: &str| {
        sections.iter().any(|section| {
            line.trim_end() == format!("# [{section}]")
                || *section == "raceway" && line.trim_end() == CONVENTIONAL
        })
    };
    let is_left_out = |paragraph: &&str| {
        paragraph.lines().all(|line| line.starts_with('#')) && paragraph.lines().any(stands_in)
    };
    let kept: Vec<&str> = text.split("\n\n").filter(|p| !is_left_out(p)).collect();
    kept.join("\n\n").trim_end().to_owned() + "\n"
}

/// Gives a section the keys and values of another.
fn merge(section: &mut dyn TableLike, wanted: &mut dyn TableLike) {
    let keys = section.iter().map(|(key, _)| key.to_owned());
    for key in keys.collect::<Vec<_>>() {
        if !wanted.contains_key(&key) {
            section.remove(&key);
        }
    }
    let keys = wanted.iter().map(|(key, _)| key.to_owned());
    for key in keys.collect::<Vec<_>>() {
        let Some(new) = wanted.remove(&key) else {
            continue;
        };
        match section.get_mut(&key) {
            Some(old) => replace(old, new),
            None => _ = section.insert(&key, without_place(new)),
        }
    }
}

/// A section that stands after the one before it, not where it stood in its own file.
fn without_place(mut item: Item) -> Item {
    match &mut item {
        Item::Table(table) => table.set_position(None),
        Item::ArrayOfTables(tables) => tables.iter_mut().for_each(|t| t.set_position(None)),
        _ => {}
    }
    item
}

fn replace(old: &mut Item, mut new: Item) {
    match (&mut *old, &mut new) {
        (Item::ArrayOfTables(old), Item::ArrayOfTables(new)) => each(old, new),
        // One `[[raceway]]` is as good as a `[raceway]`.
        (Item::ArrayOfTables(old), Item::Table(new)) if old.len() == 1 => {
            old.iter_mut().for_each(|section| merge(section, new));
        }
        (Item::Value(old), Item::Value(new)) => {
            if !same(old, new) {
                *new.decor_mut() = old.decor().clone();
                *old = new.clone();
            }
        }
        (old, new) => match (old.as_table_like_mut(), new.as_table_like_mut()) {
            (Some(old), Some(new)) => merge(old, new),
            _ => *old = without_place(new.clone()),
        },
    }
}

fn each(old: &mut ArrayOfTables, new: &mut ArrayOfTables) {
    while old.len() > new.len() {
        old.remove(old.len() - 1);
    }
    for (k, section) in new.iter_mut().enumerate() {
        match old.get_mut(k) {
            Some(old) => merge(old, section),
            None => {
                section.set_position(None);
                old.push(section.clone());
            }
        }
    }
}

/// Whether two values are equal however they are written.
fn same(a: &Value, b: &Value) -> bool {
    let number = |v: &Value| v.as_float().or(v.as_integer().map(|i| i as f64));
    match (a, b) {
        (Value::String(a), Value::String(b)) => a.value() == b.value(),
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b))
        }
        _ => number(a).is_some_and(|a| number(b) == Some(a)),
    }
}
