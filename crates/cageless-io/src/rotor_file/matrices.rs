//! Matrices of a rotor in a JSON file, or in a plan.

use std::path::Path;

use cageless::linear_rotor::{DMatrix, RotorMatrices};
use serde::{Deserialize, Serialize, Serializer};

use crate::case_file::spanned_toml::{Section, Value};
use crate::case_file::{CaseError, read_named};
use crate::results::{ResultError, write_atomically};

/// The only schema of files of matrices so far.
pub const MATRICES_SCHEMA: u64 = 1;

/// A file of matrices: rows of the coordinates [x, y, α, β] of each node in turn, then of [x, y] of
/// each housing.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case)] // symbols of rotor dynamics
struct MatricesFile {
    schema: u64,
    polar_inertia_kg_m2: f64,
    #[serde(default, skip_serializing_if = "is_none")]
    housings: usize,
    M: Vec<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    Ma: Option<Vec<Vec<f64>>>,
    K: Vec<Vec<f64>>,
    C: Option<Vec<Vec<f64>>>,
    G: Option<Vec<Vec<f64>>>,
    Ksdt: Option<Vec<Vec<f64>>>,
}

fn is_none(count: &usize) -> bool {
    *count == 0
}

/// Reads the matrices of a rotor; Ma, C, G and Ksdt are 0 where they are left out.
///
/// # Errors
/// A [`CaseError`] if the file cannot be read or its matrices are no rectangles of numbers.
pub fn read_matrices(path: &Path) -> Result<RotorMatrices, CaseError> {
    let (name, text) = read_named(path, "file of matrices")?;
    let file: MatricesFile = serde_json::from_str(&text).map_err(|error| {
        let message = format!("is no file of the matrices of a rotor: {error}");
        CaseError::on_line(&name, error.line().max(1), None, message)
    })?;
    let wrong = |(key, message): (String, String)| CaseError::of_file(&name, message).with_key(key);
    file.matrices().map_err(wrong)
}

/// The matrices of a section; the error is what is wrong with it.
pub(super) fn matrices_of_section(section: &Section) -> Result<RotorMatrices, String> {
    let values = serde_json::Value::Object(
        (section.iter())
            .map(|(key, node)| (key.clone(), json(&node.value)))
            .collect(),
    );
    let file: MatricesFile = serde_json::from_value(values)
        .map_err(|error| format!("are no matrices of a rotor: {error}"))?;
    file.matrices().map_err(|(_, message)| message)
}

fn json(value: &Value) -> serde_json::Value {
    match value {
        Value::Integer(value) => (*value).into(),
        Value::Number(value) => (*value).into(),
        Value::Text(text) => text.clone().into(),
        Value::List(items) => items.iter().map(|item| json(&item.value)).collect(),
        Value::Section(_) | Value::Other => serde_json::Value::Null,
    }
}

/// The matrices of a rotor as those of a file.
pub(super) fn as_in_file<S: Serializer>(
    matrices: &RotorMatrices,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    MatricesFile::new(matrices).serialize(serializer)
}

/// Writes the matrices of a rotor.
///
/// # Errors
/// The file cannot be written; none is left under its name then.
pub fn write_matrices(path: &Path, matrices: &RotorMatrices) -> Result<(), ResultError> {
    let text = serde_json::to_string(&MatricesFile::new(matrices)).unwrap_or_default();
    write_atomically(path, text.as_bytes())
}

impl MatricesFile {
    fn new(matrices: &RotorMatrices) -> Self {
        let rows = |matrix: &DMatrix<f64>| -> Vec<Vec<f64>> {
            let rows = matrix.row_iter();
            rows.map(|row| row.iter().copied().collect()).collect()
        };
        Self {
            schema: MATRICES_SCHEMA,
            polar_inertia_kg_m2: matrices.polar_inertia_kg_m2,
            housings: matrices.housings,
            M: rows(&matrices.mass),
            Ma: (matrices.added_mass.amax() > 0.0).then(|| rows(&matrices.added_mass)),
            K: rows(&matrices.stiffness),
            C: Some(rows(&matrices.damping)),
            G: Some(rows(&matrices.gyroscopic)),
            Ksdt: Some(rows(&matrices.spin_up)),
        }
    }

    /// The matrices, or the key at fault and what is wrong with it.
    fn matrices(self) -> Result<RotorMatrices, (String, String)> {
        if self.schema != MATRICES_SCHEMA {
            let message = format!(
                "schema = {} is not possible: it must be {MATRICES_SCHEMA}",
                self.schema
            );
            return Err(("schema".to_owned(), message));
        }
        let size = self.M.len();
        let matrix = |key: &str, rows: Option<Vec<Vec<f64>>>| {
            let rows = rows.unwrap_or_else(|| vec![vec![0.0; size]; size]);
            let columns = rows.first().map_or(0, Vec::len);
            if let Some(row) = rows.iter().position(|row| row.len() != columns) {
                let message = format!(
                    "row {} of {key} has {} numbers and row 1 {columns}: all rows must have the \
                     same",
                    row + 1,
                    rows[row].len()
                );
                return Err((key.to_owned(), message));
            }
            Ok(DMatrix::from_row_iterator(
                rows.len(),
                columns,
                rows.into_iter().flatten(),
            ))
        };
        Ok(RotorMatrices {
            mass: matrix("M", Some(self.M))?,
            added_mass: matrix("Ma", self.Ma)?,
            damping: matrix("C", self.C)?,
            gyroscopic: matrix("G", self.G)?,
            stiffness: matrix("K", Some(self.K))?,
            spin_up: matrix("Ksdt", self.Ksdt)?,
            housings: self.housings,
            polar_inertia_kg_m2: self.polar_inertia_kg_m2,
        })
    }
}
