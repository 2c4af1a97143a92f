//! A rotor file with its cases and every default, in the units of the file.

use std::collections::BTreeMap;

use serde::Serialize;
use toml::Value;

use super::keys::REPLACED;
use super::{RotorBody, RotorClearance, RotorDescription, RotorPlace, RotorUnbalance};
use crate::case_file::format::SCHEMA;
use crate::case_file::{CaseDocument, CaseError, CaseValue};

/// A rotor file that was read, its cases in it.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorFileDocument {
    /// Free text.
    pub title: String,
    /// The rotor with the places of its bearings.
    pub rotor: RotorDescription,
    /// Speed when the magnets let go, rpm.
    pub speed_rpm: f64,
    /// Torque on the rotor, N·m.
    pub drive_torque_n_m: f64,
    /// The case of each bearing.
    pub cases: Vec<CaseDocument>,
}

impl RotorFileDocument {
    /// The document as a rotor file that needs no other.
    ///
    /// # Errors
    /// Those of [`RotorFileDocument::to_value`].
    pub fn to_toml(&self) -> Result<String, CaseError> {
        toml::to_string(&self.to_value()?).map_err(unwritable)
    }

    /// The document as TOML that a plan takes as its case: bearings and unbalances are numbered
    /// sections, cases and matrices stand in it.
    ///
    /// # Errors
    /// None that a document from a file can cause.
    pub fn to_value(&self) -> Result<Value, CaseError> {
        let RotorDescription {
            body,
            bearings,
            unbalances,
            clearances,
        } = &self.rotor;
        let bearings = bearings.iter().zip(&self.cases).map(|(&place, case)| {
            let mut case = Value::try_from(case).map_err(unwritable)?;
            if let Some(Value::Table(section)) = case.get_mut("rotor") {
                section.retain(|key, _| !REPLACED.contains(&key));
            }
            Ok(BearingText { place, case })
        });
        let text = RotorText {
            schema: SCHEMA,
            title: &self.title,
            rotor: Rotor {
                body,
                speed_rpm: self.speed_rpm,
                drive_torque_n_m: self.drive_torque_n_m,
            },
            bearing: numbered(bearings.collect::<Result<Vec<_>, CaseError>>()?),
            unbalance: numbered(unbalances),
            clearance: numbered(clearances),
        };
        Value::try_from(text).map_err(unwritable)
    }

    /// The value of a key of the rotor, `section.key` or `section.2.key`, its default if it has
    /// one; `None` if it is left out or no key of the rotor.
    pub(super) fn value(&self, key: &str) -> Option<CaseValue> {
        let text = self.to_value().ok()?;
        let mut value = &text;
        for part in key.split('.') {
            // The number of a section that is alone may be left out.
            let alone = || match value.get("2") {
                None => value.get("1")?.get(part),
                Some(_) => None,
            };
            value = value.get(part).or_else(alone)?;
        }
        match value {
            Value::Float(number) => Some(CaseValue::Number(*number)),
            Value::Integer(number) => Some(CaseValue::Integer(*number)),
            Value::String(text) => Some(CaseValue::Text(text.clone())),
            _ => None,
        }
    }
}

/// The text of a rotor file.
#[derive(Serialize)]
struct RotorText<'a> {
    schema: u64,
    title: &'a str,
    rotor: Rotor<'a>,
    bearing: Numbered<BearingText>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    unbalance: Numbered<&'a RotorUnbalance>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    clearance: Numbered<&'a RotorClearance>,
}

/// `[rotor]`.
#[derive(Serialize)]
struct Rotor<'a> {
    #[serde(flatten)]
    body: &'a RotorBody,
    speed_rpm: f64,
    drive_torque_n_m: f64,
}

/// `[[bearing]]` with its case.
#[derive(Serialize)]
struct BearingText {
    #[serde(flatten)]
    place: RotorPlace,
    case: Value,
}

/// Sections by their numbers.
type Numbered<T> = BTreeMap<String, T>;

fn numbered<T>(sections: impl IntoIterator<Item = T>) -> Numbered<T> {
    let numbers = (1..).map(|number: usize| number.to_string());
    numbers.zip(sections).collect()
}

fn unwritable(error: toml::ser::Error) -> CaseError {
    CaseError::of_file("", format!("the rotor cannot be written as TOML: {error}"))
}
