//! `--set section.key=value`: changes to a case file from the command line.

use super::error::CaseError;
use super::former;
use super::sections;
use super::spanned_toml::{self, Node, Origin, Section, Value, section_at};
use super::value::CaseValue;

/// A key and its new value.
#[derive(Debug, Clone, Copy)]
pub struct Change<'a> {
    /// `section.key`, or `raceway.2.key` for the second of several raceways.
    pub key: &'a str,
    /// The value.
    pub value: &'a CaseValue,
    /// File and line that the change comes from, for messages.
    pub place: (&'a str, usize),
}

impl<'a> Change<'a> {
    /// A change of `key` to `value` that comes from a file and line.
    pub fn new(key: &'a str, value: &'a CaseValue, place: (&'a str, usize)) -> Self {
        Self { key, value, place }
    }
}

/// A key and the value that replaces its own.
#[derive(Debug, Clone)]
pub(crate) struct Replacement {
    /// Parts of the dotted key.
    pub path: Vec<String>,
    /// The value, with its origin.
    pub node: Node,
}

/// Applies the overrides in order; the last one wins. Whether the keys exist and
/// the values fit is for the reader to say: it finds the override in their place.
pub(super) fn apply(root: &mut Section, overrides: &[String]) -> Result<(), CaseError> {
    overrides
        .iter()
        .try_for_each(|text| Replacement::from_override(text)?.apply(root))
}

impl Replacement {
    /// The replacement of the text of one `--set`.
    pub(crate) fn from_override(text: &str) -> Result<Self, CaseError> {
        let fail = |key: Option<&str>, message: String| {
            let key = key.map(str::to_owned);
            Err(CaseError::of_override(text, key, message))
        };
        let Some((key, value)) = text.split_once('=') else {
            return fail(None, "has no `=`: write section.key=value".to_owned());
        };
        let (key, value) = (key.trim(), value.trim());
        let path: Vec<&str> = key.split('.').map(str::trim).collect();
        if path.len() > PARTS_MAX || path.iter().any(|part| !is_bare(part)) {
            let message = format!("`{key}` is not a key: write section.key=value");
            return fail(None, message);
        }
        if value.is_empty() {
            let message = "has no value: write section.key=value".to_owned();
            return fail(Some(key), message);
        }
        let node = match spanned_toml::parse_override(value, text) {
            Ok(node) => node,
            Err(_) if is_word(value) => {
                let origin = Origin::Override(text.to_owned());
                Node::new(
                    Value::Text(value.to_owned()),
                    origin,
                    format!("\"{value}\""),
                )
            }
            Err(why) => {
                let message = format!("`{value}` is not a value of TOML: {why}");
                return fail(Some(key), message);
            }
        };
        let path = path.into_iter().map(str::to_owned).collect();
        Ok(Self::new(path, node))
    }

    /// The replacement of a key, which may have its former name, by a value.
    fn new(mut path: Vec<String>, mut node: Node) -> Self {
        former::replacement(&mut path, &mut node);
        Self { path, node }
    }

    /// The dotted key.
    pub(crate) fn key(&self) -> String {
        self.path.join(".")
    }

    /// The replacement of a change.
    pub(crate) fn from_change(change: &Change<'_>) -> Self {
        let (file, line) = change.place;
        let path = change.key.split('.').map(str::to_owned).collect();
        let origin = Origin::Elsewhere(file.to_owned(), line);
        Self::new(path, change.value.node(&origin))
    }

    /// Puts the value into a file.
    pub(crate) fn apply(&self, root: &mut Section) -> Result<(), CaseError> {
        let path: Vec<&str> = self.path.iter().map(String::as_str).collect();
        insert(root, &path, self.node.clone()).map_err(|message| self.error(message))
    }

    /// The error that the key cannot be replaced.
    pub(crate) fn error(&self, message: String) -> CaseError {
        let key = self.key();
        match &self.node.place.origin {
            // The text of the option has the key.
            Origin::Override(_) => self.node.error("", &key, message),
            _ => self.node.error("", &key, format!("{key}: {message}")),
        }
    }
}

/// Parts of the longest key: `bearing.2.raceway.1.axial_span_mm`.
const PARTS_MAX: usize = 5;

/// Puts the value where it belongs, in place of what says the same.
fn insert(root: &mut Section, path: &[&str], node: Node) -> Result<(), String> {
    match *path {
        // The two places of the seed are one key; the file may have the other.
        ["seed"] => {
            if let Some(Value::Section(solver)) = root.get_mut("solver").map(|n| &mut n.value) {
                solver.remove("seed");
            }
        }
        ["solver", "seed"] => _ = root.remove("seed"),
        _ => {}
    }
    let (section, key) = section_at(root, path, &node.place)?;
    let name = if path.len() > 1 { path[0] } else { "" };
    let derived = sections::derived_of(name, key, section, &node);
    let others = sections::alternatives_of(name, key);
    if let [one, another] = others
        && is_override(Some(&node))
        && others.iter().any(|other| is_override(section.get(*other)))
    {
        // One of two would be lost.
        return Err(format!(
            "another --set gives {one} or {another}: groove radii, and pitch diameter with clearance, \
             both say the same, give one of them"
        ));
    }
    for other in others {
        section.remove(*other);
    }
    section.extend(derived);
    section.insert(key.to_owned(), node);
    Ok(())
}

fn is_override(node: Option<&Node>) -> bool {
    node.is_some_and(|node| matches!(node.place.origin, Origin::Override(_)))
}

fn is_bare(part: &str) -> bool {
    !part.is_empty()
        && part
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'))
}

/// Text that was meant as a string, its quotes lost to the shell.
fn is_word(value: &str) -> bool {
    !value.starts_with(['"', '\'', '[', '{']) && !value.contains(['"', '=', '#'])
}
