//! Motion of the balls in cageless (full-complement) ball bearings whose outer ring carries a *discrete raceway*: a
//! short local groove that slows each ball a little as it passes, so that the balls spread apart.
//!
//! The model is that of Zhao, Zhou, Wang, *Discrete Dynamics of Balls in Cageless Ball Bearings*, Symmetry 2022, 14,
//! 2242 ("Zhao 2022" below), as published or in a physically consistent form ([`Formulation`]), in the plane or in
//! space, with static equilibrium, life and touch-down of rotors. The crate `cageless-design` has the verdict on a
//! raceway, the search for one, and tolerances.
//!
//! # First program
//! A bearing, a raceway, a case, and 2 ms of motion. What is not given has a default that [`Case::of`] and
//! [`BearingDimensions::estimated`] state. Everything is SI (radians, seconds, metres, newtons); names end in their unit.
//!
//! ```
//! use cageless::prelude::*;
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let dimensions = BearingDimensions::estimated(14, 4.7625e-3, 23.0e-3); // balls, ball radius, pitch radius: m
//!     let bearing = Bearing::new(dimensions, Material::STEEL)?;
//!     let raceway = reference::Structure::D.raceway(&bearing)?;
//!     let case = CaseBuilder::of(bearing).raceway(raceway).inner_speed_rad_s(1257.0).radial_load_n(1500.0);
//!     let mut simulation = Simulation::new(&case.build()?)?;
//!     simulation.advance_to(2e-3)?;
//!     for ball in simulation.view().balls() {
//!         println!("ball {}: {:.2}° to the next", ball.index() + 1, ball.gap_rad().to_degrees());
//!     }
//!     Ok(())
//! }
//! ```
//!
//! A case file is read into the same [`Case`] by `cageless_io::case_file::CaseFile`.
//!
//! # A loop of one's own
//! [`Simulation`](simulation::Simulation) makes one step, or those up to a time. Between them its
//! [view](simulation::StepView) shows balls, ring, rotor and contacts without copying, and a controller sets the speed,
//! the load or the torque of a drive.
//!
//! ```
//! # use cageless::prelude::*;
//! let mut simulation = Simulation::new(&reference::Structure::D.case())?;
//! while simulation.time_s() < 1e-3 {
//!     simulation.step()?;
//!     let loads_n = simulation.view().balls().map(|ball| ball.outer_force_n());
//!     if loads_n.fold(0.0, f64::max) > 620.0 {
//!         simulation.set_radial_load_n(1400.0)?;
//!     }
//! }
//! assert!(simulation.outcome().energy_residual_relative.abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Observers
//! [`run`](simulation::Simulation::run) goes on to a time and shows every step to observers: those of the crate
//! ([`collision`], [`recorder`], [`summary`]), closures by [`each_step`](simulation::each_step), or any
//! [`Observer`](simulation::Observer). A guard ends a run that has left the physical range, with time, cause and advice.
//!
//! ```
//! # use cageless::prelude::*;
//! let mut simulation = Simulation::new(&reference::Structure::D.case())?;
//! let mut least_rad = f64::INFINITY;
//! let mut gaps = each_step(|view| {
//!     least_rad = view.balls().fold(least_rad, |least, ball| least.min(ball.gap_rad()));
//!     Control::Continue(())
//! });
//! let outcome = simulation.run(1e-3, &mut [&mut gaps]);
//! assert!(matches!(outcome.ending, Ending::Complete) && least_rad > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A law of friction, a method
//! One method makes a [law](FrictionLaw): μ and its slope over the sliding speed. Regularisation, implicit treatment and
//! step limits follow from it. μ lies between 0 and 2: a law is tried before a run, up to four times the speed of the
//! fastest surface, and watched in it. [`CaseBuilder::own_friction`] gives it to the contacts of the balls,
//! [`CaseBuilder::own_journal_friction`] to the journal of a rotor in the bore.
//!
//! ```
//! # use cageless::prelude::*;
//! struct Falling;
//! impl FrictionLaw for Falling {
//!     fn coefficient(&self, sliding_m_s: f64) -> [f64; 2] {
//!         let excess = 0.06 * (-sliding_m_s).exp();
//!         [0.06 + excess, -excess]
//!     }
//! }
//! let case = CaseBuilder::of(reference::bearing()).own_friction(Falling).inner_speed_rad_s(100.0);
//! Simulation::new(&case.radial_load_n(100.0).build()?)?.advance_to(1e-4)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`with_method`](simulation::Simulation::with_method) goes on by any [`Method`](integrator::Method) of integration:
//! the example `own_integrator` is Verlet's, with guard, ledger and observers.
//!
//! # Where things are
//! | question | module |
//! |---|---|
//! | where a ring settles, and what each ball bears | [`equilibrium`], [`rating`], [`Fit`] |
//! | how far a raceway slows a ball | [`closed_forms`], [`BallAdvance`], [`steady`] |
//! | whether a raceway works, and which | crate `cageless-design`: `judge`, `critical_gap`, `search` |
//! | axial load, tilt, several rows: motion in space | [`SpatialLoad`], [`Row`]; z, tilt and contact angles in the [view](simulation::StepView) |
//! | oil in the contacts | [`Film`], [`film::OilGrade`]; `case.film` in [`CaseBuilder::change`] |
//! | a rotor of one's own that falls | [`Rotor::estimated`], [`CaseBuilder::rotor`], [`Bearing::with_inner_ring_bore`] |
//! | a rotor that falls onto its touch-down bearings, run or stepped | [`simulation::RotorDrop`], [`touchdown`], [`linear_rotor`]; the examples `drop`, `rotor_controller` |
//! | what deviations from the drawing change | [`surface`]; `tolerance` of `cageless-design` |
//! | whether a result can be trusted | [`verification`], [`reference`](mod@reference) |
//! | forces on the housing | [`vibration`] |
//!
//! The examples of the crate, a screen each: `first_bearing`, `own_friction_law`, `own_observer`, `own_integrator`,
//! `speed_controller`, `drop`, `rotor_controller` (`cargo run -p cageless --example first_bearing`).
//!
//! # Frame
//! Origin at the centre of the fixed outer ring; +Y up, gravity and radial load
//! along −Y, the inner ring turns counter-clockwise. ψ is the position angle of
//! a ball from −Y, counter-clockwise positive. Balls are numbered along the
//! motion: ball i+1 is ahead of ball i.

#![cfg_attr(not(test), warn(unreachable_pub))]

mod assembly;
mod ball;
mod ball_advance;
mod ball_grade;
mod bearing;
mod case;
mod case_builder;
pub mod closed_forms;
pub mod collision;
pub mod contact;
mod contact_peaks;
mod contact_tally;
mod contact_tracker;
mod control;
mod creep_mean;
pub mod dynamics;
mod ellipse_edges;
mod equations;
pub mod equilibrium;
mod error;
pub mod film;
mod fit;
mod flank_model;
mod formulation;
mod gap;
mod gap_scatter;
mod half_turn;
mod initial_conditions;
pub mod integrator;
pub mod kinematics;
mod limits;
pub mod linear_rotor;
mod lubrication;
mod material;
pub mod min_max_decimator;
mod named_enum;
pub mod numerics;
mod orbit_means;
mod outer_contact_geometry;
pub mod passage;
pub mod prelude;
pub mod raceway;
mod raceway_contact;
pub mod rating;
pub mod recorder;
pub mod reference;
mod ring_support;
mod rotating_ring;
mod rotor;
mod scope;
pub(crate) mod simd;
pub mod simulation;
mod snapshot;
mod spatial_summary;
pub mod steady;
pub mod step_limits;
pub mod summary;
pub mod surface;
mod time_table;
pub mod touchdown;
mod unbalance;
pub mod verification;
pub mod vibration;
pub(crate) mod world;

pub use assembly::Assembly;
pub use ball_advance::BallAdvance;
pub use ball_grade::{BallGrade, ball_grade, ball_grades_text};
pub use bearing::{
    BALLS_MIN, Ball, Bearing, BearingDimensions, CONFORMITY, INNER_RING_DAMPING_N_S_M,
    InnerRingBore, SHOULDER_HEIGHT,
};
pub use case::{
    Case, Contact, Gaps, Housing, Motion, Operation, Row, SPATIAL_FIELDS, STRIPS_MAX, Solver,
    SpatialLoad, Start, StartState, Tilt,
};
pub use case_builder::CaseBuilder;
pub use collision::Collision;
pub use contact::{FrictionLaw, FrictionModel, FrictionParameters, FrictionTable, Regularisation};
pub use contact_tally::ContactTally;
pub use contact_tracker::ContactCounts;
pub use error::{Allowed, InputError};
pub use film::Film;
pub use fit::{
    BearingClass, ClearanceRange, Fit, HoleClass, OperatingClearance, REFERENCE_TEMPERATURE_C,
    SMOOTHING_M, STEEL_EXPANSION_PER_K, ShaftClass,
};
pub use flank_model::FlankModel;
pub use formulation::Formulation;
pub use half_turn::HalfTurnRecorder;
pub use initial_conditions::{initial_state, initial_state_controlled, unloaded_equilibrium};
pub use integrator::IntegrationMethod;
pub use limits::{LIMITS, Limit};
pub use lubrication::{Lubricant, Lubrication, SkfSeries};
pub use material::{Material, Materials};
pub use orbit_means::OrbitMeans;
pub use raceway::{Ends, Raceway, RacewayDimensions, RacewayForm, RacewayShape};
pub use raceway_contact::{RacewayContact, RacewayPoint};
pub use rotor::{Rotor, Shaft, Support, SupportStop};
pub use scope::SCOPE;
pub use snapshot::{RingSnapshot, RotorSnapshot, Snapshot};
pub use spatial_summary::SpatialSummary;
pub use time_table::TimeTable;
pub use unbalance::Unbalance;

// The tests of what is not public, and the cases that they share with the tests from outside.
#[cfg(test)]
extern crate self as cageless;
#[cfg(test)]
#[path = "../tests/common/mod.rs"]
mod common;
#[cfg(test)]
#[path = "../tests/inside/mod.rs"]
mod inside;
