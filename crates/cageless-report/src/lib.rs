//! Figures and self-contained HTML reports of Cageless.
//!
//! Nothing is simulated here: data in display units go in ([`ReproduceData`],
//! [`RunData`], [`DesignData`], [`SweepData`]), one HTML page comes out ([`reproduce_page`],
//! [`run_page`], [`design_page`], [`sweep_page`]) that opens without a network, and the same
//! numbers as one JSON document
//! ([`to_json`]).

pub mod claim;
pub mod compare;
pub mod comparison;
pub mod data;
pub mod description;
pub mod design;
pub mod design_report;
pub mod drop;
pub mod figure;
pub mod figures;
mod from_json;
pub mod geometry;
pub mod head;
mod load_profile;
pub mod motion;
pub mod names;
pub mod page;
pub mod plot;
pub mod recommended;
pub mod reproduce;
mod rotor_track;
pub mod run;
mod run_json;
pub mod run_report;
pub mod sampling;
pub mod search_tables;
pub mod studio;
pub mod sweep;
pub mod table;
pub mod tables;
pub mod text;
pub mod tolerance;
pub mod verification;

pub use cageless_io::estimate::{Change, Estimate};
pub use claim::{Claim, ClaimStatus, Holds, Requirement};
pub use comparison::{ComparisonCell, Difference, RecordChange, RingComparison};
pub use data::*;
pub use design::*;
pub use figure::Figure;
pub use from_json::from_json;
pub use geometry::{ContactTrack, RacewaySurface};
pub use head::Head;
pub use motion::MotionFigure;
pub use page::{Note, Page};
pub use recommended::ShownRaceway;
pub use reproduce::*;
pub use run::*;
pub use run_json::{RunJsonError, run_from_json, run_json};
pub use studio::{Opening, engine, studio_page};
pub use sweep::*;
pub use verification::{VerificationRow, VerificationTable};

/// All numbers of a report as one JSON document, unrounded.
///
/// # Errors
/// Never for the data of this crate: their keys are all text.
pub fn to_json<T: serde::Serialize>(data: &T) -> Result<String, serde_json::Error> {
    serde_json::to_string(data)
}
