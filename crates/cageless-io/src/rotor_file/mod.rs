//! The file of a rotor above several touchdown bearings: the rotor, its unbalances, and the case of
//! each bearing.
//!
//! ```toml
//! [rotor]
//! mass_kg = 40.0
//! polar_inertia_kg_m2 = 0.04
//! transverse_inertia_kg_m2 = 0.6
//! speed_rpm = 30000.0
//!
//! [[bearing]]
//! case = "drive-end.toml"
//! axial_mm = -100.0
//!
//! [[bearing]]
//! case = "free-end.toml"
//! axial_mm = 200.0
//! ```
//!
//! Every error becomes one [`CaseError`], as in a case file.

mod matrices;
mod read;

use std::path::Path;

use cageless::Case;
use cageless::linear_rotor::{LinearRotor, RotorError};
use cageless::simulation::RotorDrop;

use crate::case_file::spanned_toml::{self, Value};
use crate::case_file::{CaseError, CaseFile, StepDocument, read_text};

pub use matrices::{MATRICES_SCHEMA, read_matrices, write_matrices};

/// A rotor with its bearings, read and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorFile {
    title: String,
    bearings: Vec<CaseFile>,
    drop: RotorDrop,
}

impl RotorFile {
    /// Whether the file at `path` is a rotor file rather than a case: it lists bearings.
    pub fn is_at(path: &Path) -> bool {
        let text = read_text(path, "case file").unwrap_or_default();
        let root = spanned_toml::parse(&text, "");
        root.is_ok_and(|root| matches!(root.get("bearing").map(|n| &n.value), Some(Value::List(_))))
    }

    /// Reads a rotor file and the files that it names, whose paths count from its folder.
    /// `overrides` apply to the case of every bearing.
    ///
    /// # Errors
    /// A [`CaseError`] if one of the files cannot be read, or for anything but a complete and
    /// possible rotor and possible cases.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let name = path.display().to_string();
        let text = read_text(path, "rotor file").map_err(|m| CaseError::of_file(&name, m))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        read::rotor_file(&text, &name, folder, overrides)
    }

    /// A rotor at `speed_rpm` under `drive_torque_n_m` above the bearings of `cases`. Steps are as
    /// long as the shortest that a case gives, and automatic if none gives one.
    ///
    /// # Errors
    /// Those of [`RotorDrop::new`].
    pub fn new(
        title: &str,
        rotor: LinearRotor,
        speed_rpm: f64,
        drive_torque_n_m: f64,
        cases: &[CaseFile],
    ) -> Result<Self, RotorError> {
        let given = cases.iter().filter_map(|file| {
            let automatic = file.document().solver.step_us == StepDocument::Auto;
            (!automatic).then_some(file.case().solver.step_s)
        });
        let step = given.reduce(f64::min);
        let speed_rad_s = speed_rpm * std::f64::consts::TAU / 60.0;
        let own = cases.iter().enumerate().map(|(k, file)| Case {
            title: bearing_title(title, k, cases.len()),
            ..file.case().clone()
        });
        let drop = RotorDrop::new(rotor, speed_rad_s, drive_torque_n_m, own.collect(), step)?;
        let mut bearings = vec![];
        for (k, (file, case)) in cases.iter().zip(drop.cases()).enumerate() {
            let mut document = file.document().clone();
            document.title = case.title.clone();
            document.solver.step_us = StepDocument::FixedUs(1e6 * case.solver.step_s);
            if let (Some(section), Some(rotor)) = (&mut document.rotor, &case.rotor) {
                section.mass_kg = rotor.mass_kg;
                section.polar_inertia_kg_m2 = rotor.polar_inertia_kg_m2;
                section.speed_rpm = speed_rpm;
                section.eccentricity_um = 0.0;
                section.drive_torque_n_m = drive_torque_n_m;
            }
            let carried = CaseFile::from_document(document, &format!("bearing {}", k + 1))
                .map_err(|error| RotorError::Bearings(error.to_string()))?;
            bearings.push(carried);
        }
        Ok(Self {
            title: title.to_owned(),
            bearings,
            drop,
        })
    }

    /// Free text.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The case of each bearing as one plane of the rotor: with the part of the mass that the
    /// bearing carries and without unbalance.
    pub fn bearings(&self) -> &[CaseFile] {
        &self.bearings
    }

    /// The drop of the rotor into the bearings.
    pub fn drop(&self) -> &RotorDrop {
        &self.drop
    }
}

/// "title: bearing 1 of 2".
fn bearing_title(title: &str, k: usize, count: usize) -> String {
    let bearing = format!("bearing {} of {count}", k + 1);
    if title.is_empty() {
        bearing
    } else {
        format!("{title}: {bearing}")
    }
}
