//! Conversion of the numbers of a document to SI units, and errors in terms of the file.

use cageless::InputError;

use super::document::CaseDocument;
use super::error::CaseError;
use super::key::Key;
use super::spanned_toml::{Places, join, nth};
use super::unit::Side;
use super::{keys, messages};

/// Conversion of one document; `places` says where its values come from.
pub(crate) struct Converter<'a> {
    pub document: &'a CaseDocument,
    pub places: &'a Places,
}

impl Converter<'_> {
    /// The value of a dotted key in SI units; refuses what is not finite.
    pub(super) fn si(&self, path: &str, value: f64) -> Result<f64, CaseError> {
        let (section, name) = split(path);
        let unit = keys::unit(section, name);
        let si = unit.to_si(value);
        if si.is_finite() {
            return Ok(si);
        }
        let allowed = match unit.symbol() {
            "" => "a finite number".to_owned(),
            symbol => format!("a finite number of {symbol}"),
        };
        Err(self.refuse(path, &value.to_string(), &allowed))
    }

    /// An error of [`cageless`] in terms of the file. `raceway` is the index of the
    /// raceway at fault, if one is.
    pub(super) fn refused(&self, error: &InputError, raceway: Option<usize>) -> CaseError {
        self.refused_in(None, error, raceway)
    }

    /// Error of the case file for `error` of the library, in `section` where several sections have
    /// such a field.
    pub(super) fn refused_in(
        &self,
        section: Option<&str>,
        error: &InputError,
        raceway: Option<usize>,
    ) -> CaseError {
        let Some((section, key)) = keys::of_field(section, error.field) else {
            return self.places.error("", error.to_string());
        };
        let path = match raceway {
            Some(index) => nth(section, index, self.document.raceway.len()),
            None => section.to_owned(),
        };
        let path = join(&path, key.name);
        let allowed = messages::in_file_units(error, key, self.document, raceway);
        // A key that is optional by itself, and that something else in the case needs.
        if error.value.is_nan() && self.document.value(&path).is_none() {
            let meaning = Key::describe(key);
            let message =
                format!("{path} is missing in [{section}]: {meaning}; it must be {allowed}");
            return self.places.error(&path, message);
        }
        let value = key.unit.show(error.value, Side::Nearest);
        if let Some((origin, how)) = self.origin_of(&path) {
            let message = format!("{path} = {value} ({how}) is not possible: it must be {allowed}");
            return self.places.error(origin, message);
        }
        self.refuse(&path, &value, &allowed)
    }

    /// An error of a key that is left out.
    pub(super) fn missing(&self, section: &str, name: &str) -> CaseError {
        let path = join(section, name);
        let meaning = keys::find(section, name).map_or_else(String::new, Key::describe);
        let message = match self.places.written(section) {
            Some(_) => format!("{path} is missing in [{section}]: {meaning}"),
            None => format!("{path} is missing, as is its section [{section}]: {meaning}"),
        };
        self.places.error(&path, message)
    }

    /// "KEY = VALUE is not possible: it must be ALLOWED", the value as written if it
    /// is, otherwise `value`.
    pub(super) fn refuse(&self, path: &str, value: &str, allowed: &str) -> CaseError {
        let value = self.places.written(path).unwrap_or(value);
        let message = format!("{path} = {value} is not possible: it must be {allowed}");
        self.places.error(path, message)
    }
}

/// Section and key of a dotted path: `raceway.2.axial_span_mm` is in `raceway`.
fn split(path: &str) -> (&str, &str) {
    let section = path.split_once('.').map_or("", |(section, _)| section);
    let name = path.rsplit_once('.').map_or(path, |(_, name)| name);
    (section, name)
}
