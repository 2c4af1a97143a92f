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
//! Every error becomes one [`CaseError`](crate::case_file::CaseError), as in a case file.

pub(crate) mod address;
mod base;
mod description;
mod document;
pub(crate) mod keys;
mod matrices;
mod read;

use cageless::linear_rotor::{LinearRotor, RotorError};
use cageless::simulation::RotorDrop;

use crate::case_file::{CaseFile, CaseValue, SectionTable};
use address::{Address, address};

pub use base::RotorBase;
pub use description::{RotorBody, RotorClearance, RotorDescription, RotorPlace, RotorUnbalance};
pub use document::RotorFileDocument;
pub use matrices::{MATRICES_SCHEMA, read_matrices, write_matrices};

/// Every section of a rotor file with its keys; the head of the file first, without a name.
pub fn reference() -> impl Iterator<Item = SectionTable> {
    keys::ROTOR_FILE.reference()
}

/// A rotor with its bearings, read and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorFile {
    document: RotorFileDocument,
    bearings: Vec<CaseFile>,
    drop: RotorDrop,
}

impl RotorFile {
    /// A rotor at `speed_rpm` under `drive_torque_n_m` above the bearings of `cases`. Steps are as
    /// long as the shortest that a case gives, and automatic if none gives one.
    ///
    /// # Errors
    /// Those of [`RotorDescription::linear`] and [`RotorDrop::new`].
    pub fn new(
        title: &str,
        rotor: &RotorDescription,
        speed_rpm: f64,
        drive_torque_n_m: f64,
        cases: &[CaseFile],
    ) -> Result<Self, RotorError> {
        let document = RotorFileDocument {
            title: title.to_owned(),
            rotor: rotor.clone(),
            speed_rpm,
            drive_torque_n_m,
            cases: cases.iter().map(|case| case.document().clone()).collect(),
        };
        Self::assemble(document, rotor.linear()?, cases)
    }

    /// The rotor of a document whose lateral motion is `rotor`, above the bearings of `cases`.
    fn assemble(
        document: RotorFileDocument,
        rotor: LinearRotor,
        cases: &[CaseFile],
    ) -> Result<Self, RotorError> {
        let (title, speed_rpm) = (document.title.as_str(), document.speed_rpm);
        let drive_torque_n_m = document.drive_torque_n_m;
        let given = cases.iter().filter_map(|file| {
            let automatic = file.has_automatic_step();
            (!automatic).then_some(file.case().solver.step_s)
        });
        let step = given.reduce(f64::min);
        let speed_rad_s = speed_rpm * std::f64::consts::TAU / 60.0;
        let own = cases.iter().map(|file| file.case().clone()).collect();
        let drop = RotorDrop::new(rotor, speed_rad_s, drive_torque_n_m, own, step)?;
        let mut bearings = vec![];
        for (k, (file, case)) in cases.iter().zip(drop.cases()).enumerate() {
            let mut document = file.document().clone();
            document.set("title", bearing_title(title, k, cases.len()).as_str());
            document.set("solver.step_us", 1e6 * case.solver.step_s);
            if let Some(rotor) = &case.rotor {
                document.set("rotor.mass_kg", rotor.mass_kg);
                document.set("rotor.polar_inertia_kg_m2", rotor.polar_inertia_kg_m2);
                document.set("rotor.speed_rpm", speed_rpm);
                document.set("rotor.eccentricity_um", 0.0);
                document.set("rotor.drive_torque_n_m", drive_torque_n_m);
            }
            let carried = CaseFile::from_document(document, &format!("bearing {}", k + 1))
                .map_err(|error| RotorError::Bearings(error.to_string()))?;
            bearings.push(carried.with_defaults_of(file));
        }
        Ok(Self {
            document,
            bearings,
            drop,
        })
    }

    /// Free text.
    pub fn title(&self) -> &str {
        &self.document.title
    }

    /// The file with its cases and every default.
    pub fn document(&self) -> &RotorFileDocument {
        &self.document
    }

    /// The values of a key as `--set` names it, its default if it has one: one of a key of the
    /// rotor or of one bearing, one for each bearing of a key of all cases; `None` where it is left
    /// out or no key.
    pub fn values(&self, key: &str) -> Vec<Option<CaseValue>> {
        let path: Vec<&str> = key.split('.').collect();
        let cases = &self.document.cases;
        match address(&path) {
            Err(_) => vec![None],
            Ok(Address::Rotor) => vec![self.document.value(key)],
            Ok(Address::Case(Some(k), key)) => {
                vec![cases.get(k).and_then(|case| case.value(&key.join(".")))]
            }
            Ok(Address::Case(None, _)) => cases.iter().map(|case| case.value(key)).collect(),
        }
    }

    /// Indices of the bearings whose cases a key concerns, as `--set` names it; none of a key of
    /// the rotor.
    pub fn bearings_of(&self, key: &str) -> std::ops::Range<usize> {
        let path: Vec<&str> = key.split('.').collect();
        match address(&path) {
            Ok(Address::Case(Some(k), _)) if k < self.bearings.len() => k..k + 1,
            Ok(Address::Case(None, _)) => 0..self.bearings.len(),
            _ => 0..0,
        }
    }

    /// The case of each bearing as one plane of the rotor: with the part of the mass that the
    /// bearing carries and without unbalance.
    pub fn bearings(&self) -> &[CaseFile] {
        &self.bearings
    }

    /// The lateral motion of the rotor.
    ///
    /// # Panics
    /// Never: the drop of a rotor file has one.
    pub fn rotor(&self) -> &LinearRotor {
        self.drop.rotor().expect("a linear rotor")
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
