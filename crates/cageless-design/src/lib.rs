//! Design of cageless ball bearings on the physics of the crate `cageless`: a verdict on a raceway from the motion of
//! its balls, the critical gap, a search for raceways, and what deviations from the drawing change.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::Control;
//! use cageless_design::{RacewayVerdict, judge};
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2
//! let judgement = judge(&case, &mut |_done| Control::Continue(()))?;
//! assert_eq!(judgement.verdict, RacewayVerdict::Smooth);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | question | item |
//! |---|---|
//! | whether a raceway slows single balls as intended | [`judge`], [`RacewayVerdict`]; of a run [`RunVerdict`] |
//! | the gap at the entrance that just closes in the raceway | [`critical_gap`]; the example `critical_gap` |
//! | which raceway, for several speeds and loads, in oil | [`search`]; [`search::Request::points`], `case.film`; the example `search` |
//! | which lengths of a raceway are worth a search | [`recommend`] |
//! | what axial load and tilt leave | [`axial_lag`] |
//! | what deviations from the drawing change | [`tolerance`] |
//!
//! Whether a raceway *helps*, real balls in long runs tell: `cageless compare` and `cageless_study::comparison`.

#![cfg_attr(not(test), warn(unreachable_pub))]

mod axial;
mod criterion;
pub mod critical_gap;
mod distinct_rows;
mod estimate;
mod film_evidence;
mod pressure_at_rest;
mod raceway_tallies;
mod raceway_verdict;
mod recommendation;
mod rise;
mod run_verdict;
pub mod search;
pub mod tolerance;
mod verdict;

pub use axial::{
    AXIAL_ORBITS, AxialLag, AxialLimit, AxialPoint, LagAndAngle, NoLag, axial_critical_gap_rad,
    axial_lag, axial_load_keeping, axial_points, axial_sample,
};
#[cfg(test)]
pub(crate) use criterion::DECELERATION;
pub(crate) use criterion::{AXIAL_LAG, BOTH_NEIGHBOURS, LAG, PRESSURE_AT_REST, SEPARATION};
pub use criterion::{CauseKind, Criterion, Requirement, STEADY_GAP};
use criterion::{IN_OIL, OF_SEARCH, RETAINED_GAP, STEADY_GAP_MAX, THEORETICAL_GAP};
pub use estimate::{Estimate, EstimateTerm};
pub use film_evidence::FilmEvidence;
pub(crate) use pressure_at_rest::pressure_at_rest_pa;
pub use raceway_tallies::RacewayTallies;
pub use raceway_verdict::RacewayVerdict;
pub use recommendation::{
    Recommendation, StartingPoint, recommend, recommendation_steps, starting_point,
};
pub use run_verdict::{RunEvidence, RunVerdict};
pub use verdict::{
    Judgement, PassageStatistics, RacewayJudgement, judge, judge_watched, steady_after_s,
    steady_case, verdict_steps,
};

// The tests of what is not public, and the cases that they share with the tests from outside.
#[cfg(test)]
extern crate self as cageless_design;
#[cfg(test)]
#[path = "../../cageless/tests/common/mod.rs"]
mod common;
#[cfg(test)]
#[path = "../tests/inside/mod.rs"]
mod inside;
