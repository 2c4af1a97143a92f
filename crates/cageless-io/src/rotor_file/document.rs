//! A rotor file with its cases and every default, in the units of the file.

use cageless::linear_rotor::RotorMatrices;
use toml::{Table, Value};

use super::keys::REPLACED;
use super::matrices::MatricesFile;
use super::{RotorBody, RotorDescription, RotorPlace};
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
        let mut rotor = Table::new();
        match &self.rotor.body {
            RotorBody::Rigid {
                mass_kg,
                polar_inertia_kg_m2,
                transverse_inertia_kg_m2,
            } => {
                for (key, value) in [
                    ("mass_kg", mass_kg),
                    ("polar_inertia_kg_m2", polar_inertia_kg_m2),
                    ("transverse_inertia_kg_m2", transverse_inertia_kg_m2),
                ] {
                    rotor.insert(key.to_owned(), (*value).into());
                }
            }
            RotorBody::Matrices {
                matrices,
                frequency_max_hz,
                kept_nodes,
            } => {
                rotor.insert("matrices".to_owned(), of_matrices(matrices)?);
                if let Some(frequency) = frequency_max_hz {
                    rotor.insert("frequency_max_hz".to_owned(), (*frequency).into());
                }
                let nodes = kept_nodes.iter().map(|node| whole(*node));
                rotor.insert("kept_nodes".to_owned(), Value::Array(nodes.collect()));
            }
        }
        rotor.insert("speed_rpm".to_owned(), self.speed_rpm.into());
        rotor.insert("drive_torque_n_m".to_owned(), self.drive_torque_n_m.into());
        let bearings = self.rotor.bearings.iter().zip(&self.cases);
        let bearings = bearings.map(|(place, case)| {
            let mut bearing = of_place(*place);
            let mut case = Value::try_from(case).map_err(unwritable)?;
            if let Some(Value::Table(section)) = case.get_mut("rotor") {
                section.retain(|key, _| !REPLACED.contains(&key));
            }
            bearing.insert("case".to_owned(), case);
            Ok(bearing)
        });
        let unbalances = self.rotor.unbalances.iter().map(|unbalance| {
            let mut section = of_place(unbalance.place);
            section.insert("amount_g_mm".to_owned(), unbalance.amount_g_mm.into());
            section.insert("angle_deg".to_owned(), unbalance.angle_deg.into());
            section
        });
        let clearances = self.rotor.clearances.iter().map(|clearance| {
            let mut section = of_place(clearance.place);
            section.insert("name".to_owned(), clearance.name.clone().into());
            section.insert("radial_um".to_owned(), clearance.radial_um.into());
            section
        });
        let mut document = Table::new();
        document.insert("schema".to_owned(), Value::Integer(SCHEMA as i64));
        document.insert("title".to_owned(), self.title.clone().into());
        document.insert("rotor".to_owned(), rotor.into());
        let bearings: Vec<Table> = bearings.collect::<Result<_, CaseError>>()?;
        document.insert("bearing".to_owned(), numbered(bearings));
        if !self.rotor.unbalances.is_empty() {
            document.insert("unbalance".to_owned(), numbered(unbalances.collect()));
        }
        if !self.rotor.clearances.is_empty() {
            document.insert("clearance".to_owned(), numbered(clearances.collect()));
        }
        Ok(document.into())
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

fn numbered(sections: Vec<Table>) -> Value {
    let sections = sections.into_iter().enumerate();
    let numbered: Table = sections
        .map(|(k, section)| ((k + 1).to_string(), section.into()))
        .collect();
    numbered.into()
}

fn of_place(place: RotorPlace) -> Table {
    let (key, value) = match place {
        RotorPlace::AxialMm(z) => ("axial_mm", z.into()),
        RotorPlace::Node(node) => ("node", whole(node)),
    };
    [(key.to_owned(), value)].into_iter().collect()
}

fn whole(node: usize) -> Value {
    Value::Integer(node as i64)
}

fn of_matrices(matrices: &RotorMatrices) -> Result<Value, CaseError> {
    Value::try_from(MatricesFile::new(matrices)).map_err(unwritable)
}

fn unwritable(error: toml::ser::Error) -> CaseError {
    CaseError::of_file("", format!("the rotor cannot be written as TOML: {error}"))
}
