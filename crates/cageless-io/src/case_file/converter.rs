//! Errors of [`cageless`] in terms of the file.

use cageless::InputError;

use super::document::CaseDocument;
use super::error::CaseError;
use super::key::Key;
use super::reader::missing;
use super::sections::CaseSections;
use super::spanned_toml::{join, nth};
use super::unit::Side;
use super::{keys, messages};

/// Conversion of the sections of one document.
pub(crate) struct Converter<'a> {
    pub sections: &'a CaseSections,
    pub document: &'a CaseDocument,
    /// Whether the file gives the regularisation speed of the balls.
    pub regularised: bool,
}

impl Converter<'_> {
    /// An error of [`cageless`] in terms of the file. `raceway` is the index of the
    /// raceway at fault, if one is.
    pub(super) fn refused(&self, error: &InputError, raceway: Option<usize>) -> CaseError {
        refused_in(self.document, None, error, raceway)
    }

    /// An error of a key that is left out.
    pub(super) fn missing(&self, section: &str, name: &str) -> CaseError {
        missing(
            &self.document.tree,
            &join(section, name),
            keys::find(section, name),
        )
    }

    /// "KEY = VALUE is not possible: it must be ALLOWED".
    pub(super) fn refuse(&self, path: &str, allowed: &str) -> CaseError {
        let value = self.document.value(path).map(|value| value.written());
        let value = value.unwrap_or_default();
        self.document.tree.refusal(path, &value, allowed)
    }
}

/// Error of the case file for `error` of the library, in `section` where several sections have
/// such a field.
pub(super) fn refused_in(
    document: &CaseDocument,
    section: Option<&str>,
    error: &InputError,
    raceway: Option<usize>,
) -> CaseError {
    let tree = &document.tree;
    let Some((section, key)) = keys::of_field(section, error.field) else {
        return tree.error("", error.to_string());
    };
    let several = document.count(section);
    // The row at fault is the one that has the value.
    let has_value = |index: &usize| {
        let number = document.number(&join(&nth(section, *index, several), key.name));
        number.map(|value| key.unit.to_si(value)) == Some(error.value)
    };
    let index = match section {
        "row" => (0..several).find(has_value),
        _ => raceway,
    };
    let path = index.map_or_else(|| section.to_owned(), |index| nth(section, index, several));
    let path = join(&path, key.name);
    let allowed = messages::in_file_units(error, key, document, raceway);
    // A key that is optional by itself, and that something else in the case needs.
    if error.value.is_nan() && !document.has(&path) {
        let meaning = Key::describe(key);
        let message = format!("{path} is missing in [{section}]: {meaning}; it must be {allowed}");
        return tree.error(&path, message);
    }
    let value = match document.value(&path) {
        // No number: a name, or rows.
        Some(value) if error.value.is_nan() => value.written(),
        _ => key.unit.show(error.value, Side::Nearest),
    };
    if let Some((origin, how)) = messages::origin_of(document, &path) {
        let message = format!("{path} = {value} ({how}) is not possible: it must be {allowed}");
        return tree.error(origin, message);
    }
    tree.refusal(&path, &value, &allowed)
}
