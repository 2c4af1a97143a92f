//! Figures and self-contained HTML reports of Cageless.
//!
//! Nothing is simulated here: data in display units go in ([`ReproduceData`],
//! [`RunData`], [`DesignData`], [`SweepData`]), one HTML page comes out ([`reproduce_page`],
//! [`run_page`], [`design_page`], [`sweep_page`]) that opens without a network, and the same
//! numbers as one JSON document
//! ([`to_json`]).

mod axes;
pub mod claim;
pub mod compare;
pub mod compared_run;
pub mod comparison;
pub mod data;
pub mod description;
pub mod design;
pub mod design_report;
pub mod drawing;
pub mod drop;
pub mod figure;
pub mod figures;
mod from_json;
pub mod geometry;
mod groove_contacts;
pub mod head;
mod lead;
mod length;
mod load_profile;
mod margin;
pub mod measured;
pub mod motion;
pub mod names;
pub mod page;
pub mod plot;
pub mod recommended;
pub mod reproduce;
pub mod reproduce_data;
mod rotor_track;
pub mod run;
pub mod run_data;
mod run_json;
pub mod run_report;
pub mod sampling;
pub mod search_tables;
pub mod sheet;
mod static_page;
pub mod studio;
pub mod studio_page;
pub mod sweep;
pub mod table;
pub mod tables;
pub mod text;
pub mod tolerance;
mod trace;
pub mod verification;

pub use cageless_io::estimate::{Change, Estimate};
pub use claim::{Claim, ClaimStatus, Holds, Requirement};
pub use comparison::{ComparisonCell, RecordChange, RingComparison, RingNumbers};
pub use data::*;
pub use design::*;
pub use figure::Figure;
pub use from_json::{from_json, to_json};
pub use geometry::{ContactTrack, RacewaySurface};
pub use groove_contacts::{ContactHistory, GrooveContacts};
pub use head::Head;
pub use motion::MotionFigure;
pub use page::{Note, Page};
pub use recommended::ShownRaceway;
pub use reproduce::reproduce_page;
pub use reproduce_data::*;
pub use run::run_page;
pub use run_data::*;
pub use run_json::{RunJsonError, run_from_json, run_json};
pub use static_page::{load_distribution, static_page};
pub use studio::{ENGINE_REMEDY, Opening, engine};
pub use studio_page::studio_page;
pub use sweep::*;
pub use verification::VerificationTable;
