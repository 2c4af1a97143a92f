//! A rotor file with its cases and every default, in the units of the file.

use serde::Serialize;
use toml::{Table, Value};

use super::RotorDescription;
use super::keys::REPLACED;
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
        let mut rotor = section(body)?;
        rotor.insert("speed_rpm".to_owned(), self.speed_rpm.into());
        rotor.insert("drive_torque_n_m".to_owned(), self.drive_torque_n_m.into());
        let bearings = bearings.iter().zip(&self.cases).map(|(place, case)| {
            let mut case = section(case)?;
            if let Some(Value::Table(rotor)) = case.get_mut("rotor") {
                rotor.retain(|key, _| !REPLACED.contains(&key));
            }
            let mut bearing = section(place)?;
            bearing.insert("case".to_owned(), case.into());
            Ok(bearing)
        });
        let mut text = Table::new();
        text.insert("schema".to_owned(), (SCHEMA as i64).into());
        text.insert("title".to_owned(), self.title.as_str().into());
        text.insert("rotor".to_owned(), rotor.into());
        for (name, sections) in [
            ("bearing", bearings.collect::<Result<Vec<_>, _>>()?),
            (
                "unbalance",
                unbalances.iter().map(section).collect::<Result<_, _>>()?,
            ),
            (
                "clearance",
                clearances.iter().map(section).collect::<Result<_, _>>()?,
            ),
        ] {
            let numbers = (1..).map(|number: usize| number.to_string());
            let numbered = numbers.zip(sections.into_iter().map(Value::from));
            let numbered: Table = numbered.collect();
            if !numbered.is_empty() {
                text.insert(name.to_owned(), numbered.into());
            }
        }
        Ok(text.into())
    }

    /// The value of a key of the rotor, `section.key` or `section.2.key`, its default if it has
    /// one; `None` if it is left out or no key of the rotor.
    pub(crate) fn value(&self, key: &str) -> Option<CaseValue> {
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

/// A part of the document as a section.
fn section(part: &impl Serialize) -> Result<Table, CaseError> {
    Table::try_from(part).map_err(unwritable)
}

fn unwritable(error: toml::ser::Error) -> CaseError {
    CaseError::of_file("", format!("the rotor cannot be written as TOML: {error}"))
}
