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
mod description;
mod document;
pub(crate) mod keys;
mod matrices;
mod read;
mod source;

use crate::case_file::SectionTable;

pub use description::{RotorBody, RotorClearance, RotorDescription, RotorPlace, RotorUnbalance};
pub use document::RotorFileDocument;
pub use matrices::{MATRICES_SCHEMA, read_matrices, write_matrices};
pub(crate) use source::{ReadRotor, RotorSource};

/// Every section of a rotor file with its keys; the head of the file first, without a name.
pub fn reference() -> impl Iterator<Item = SectionTable> {
    keys::ROTOR_FILE.reference()
}
