//! A case whose values are replaced before it is read: what the variants of a plan share.

use std::path::Path;

use super::error::CaseError;
use super::overrides::Replacement;
use super::spanned_toml::{Node, Origin, Place, Section, Value};
use super::value::CaseValue;
use super::{CaseFile, read_text};

/// The text of a case, parsed but not yet read.
#[derive(Debug, Clone)]
pub struct CaseBase {
    root: Section,
    name: String,
}

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

impl CaseBase {
    /// Reads the text of a case file.
    ///
    /// # Errors
    /// A [`CaseError`] if the file cannot be read or is not TOML.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let name = path.display().to_string();
        let text =
            read_text(path, "case file").map_err(|message| CaseError::of_file(&name, message))?;
        Self::parse(&text, &name)
    }

    /// Parses the text of a case file; `name` stands for it in messages.
    ///
    /// # Errors
    /// A [`CaseError`] if the text is not TOML.
    pub fn parse(text: &str, name: &str) -> Result<Self, CaseError> {
        let root = super::source(text, name)?;
        Ok(Self {
            root,
            name: name.to_owned(),
        })
    }

    pub(crate) fn from_sections(root: Section, name: &str) -> Self {
        Self {
            root,
            name: name.to_owned(),
        }
    }

    /// Replaces values for good.
    ///
    /// # Errors
    /// A [`CaseError`] if a key has no place in this case. Whether it exists and the
    /// value fits, [`CaseBase::with`] says.
    pub fn change(&mut self, changes: &[Change<'_>]) -> Result<(), CaseError> {
        let mut changes = changes.iter().map(Replacement::from_change);
        changes.try_for_each(|change| self.replace(&change))
    }

    pub(crate) fn replace(&mut self, replacement: &Replacement) -> Result<(), CaseError> {
        replacement.apply(&mut self.root)
    }

    /// The case with `changes`.
    ///
    /// # Errors
    /// A [`CaseError`] that names file and line of the change at fault, or of the base.
    pub fn with(&self, changes: &[Change<'_>]) -> Result<CaseFile, CaseError> {
        let mut base = self.clone();
        base.change(changes)?;
        CaseFile::from_sections(&base.root, &base.name)
    }
}

impl Replacement {
    /// The replacement of a change.
    pub(crate) fn from_change(change: &Change<'_>) -> Self {
        let (file, line) = change.place;
        let origin = Origin::Elsewhere(file.to_owned(), line);
        let path = change.key.split('.').map(str::to_owned).collect();
        Self::new(path, node(change.value, &origin))
    }
}

fn node(value: &CaseValue, origin: &Origin) -> Node {
    let number = |f: &f64| node(&CaseValue::Number(*f), origin);
    Node {
        value: match value {
            CaseValue::Number(f) => Value::Number(*f),
            CaseValue::Integer(i) => Value::Integer(*i),
            CaseValue::Text(text) => Value::Text(text.clone()),
            CaseValue::Numbers(list) => Value::List(list.iter().map(number).collect()),
            CaseValue::Table(rows) => {
                let row = |row: &[f64; 2]| node(&CaseValue::Numbers(row.to_vec()), origin);
                Value::List(rows.iter().map(row).collect())
            }
        },
        place: Place {
            origin: origin.clone(),
            written: value.written(),
        },
    }
}
