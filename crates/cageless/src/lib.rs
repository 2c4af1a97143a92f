//! Physics of cageless (full-complement) ball bearings whose outer ring carries
//! a *discrete raceway*: a short local groove that slows each ball a little as
//! it passes, so that the balls spread apart.
//!
//! The model is that of Zhao, Zhou, Wang, *Discrete Dynamics of Balls in
//! Cageless Ball Bearings*, Symmetry 2022, 14, 2242 ("Zhao 2022" below), with a
//! switch between the equations as published and a physically consistent set
//! ([`Formulation`]).
//!
//! # Frame
//! Origin at the centre of the fixed outer ring; +Y up, gravity and radial load
//! along −Y, the inner ring turns counter-clockwise. ψ is the position angle of
//! a ball from −Y, counter-clockwise positive. Balls are numbered along the
//! motion: ball i+1 is ahead of ball i. Everything is plain SI `f64` (radians,
//! seconds, metres, newtons); public names end in their unit.

mod assembly;
pub mod ball_advance;
pub mod bearing;
pub mod case;
pub mod collision;
pub mod contact;
pub mod contact_peaks;
pub mod contact_tracker;
mod control;
pub mod critical_gap;
pub mod design;
pub mod dynamics;
mod ellipse_edges;
pub mod equilibrium;
pub mod error;
pub mod fit;
mod flank_model;
mod formulation;
pub mod gap;
mod gap_scatter;
pub mod initial_conditions;
pub mod integrator;
pub mod kinematics;
pub mod limits;
pub mod linear_rotor;
mod lubrication;
mod material;
pub mod min_max_decimator;
mod named_enum;
pub mod numerics;
pub mod orbit_means;
pub mod outer_contact_geometry;
pub mod passage;
pub mod prelude;
pub mod raceway;
pub mod raceway_contact;
pub mod rating;
pub mod recorder;
pub mod reference;
pub mod ring_support;
pub mod rotating_ring;
pub mod rotor;
mod scope;
pub(crate) mod simd;
pub mod simulation;
pub mod snapshot;
pub mod spatial_summary;
pub mod steady;
pub mod step_limits;
pub mod summary;
pub mod surface;
pub mod time_table;
pub mod tolerance;
pub mod touchdown;
pub mod verification;
pub mod vibration;

pub use assembly::Assembly;
pub use bearing::{Ball, Bearing, BearingDimensions, InnerRingBore};
pub use case::{
    Case, CaseBuilder, Contact, Gaps, Housing, Motion, Operation, Output, Row, SPATIAL_FIELDS,
    Solver, SpatialLoad, Start, StartState, Tilt,
};
pub use collision::Collision;
pub use contact::{FrictionLaw, FrictionModel, FrictionParameters, FrictionTable};
pub use error::InputError;
pub use fit::{BearingClass, ClearanceRange, Fit, HoleClass, OperatingClearance, ShaftClass};
pub use flank_model::FlankModel;
pub use formulation::Formulation;
pub use integrator::IntegrationMethod;
pub use lubrication::{Lubricant, Lubrication, SkfSeries};
pub use material::{Material, Materials};
pub use raceway::{Ends, Raceway, RacewayDimensions, RacewayForm, RacewayShape};
pub use rotor::{Rotor, Shaft, Support, SupportStop};
pub use scope::SCOPE;
pub use snapshot::{RingSnapshot, RotorSnapshot, Snapshot};
pub use time_table::TimeTable;

// Cases that unit tests share with the tests beside them.
#[cfg(test)]
extern crate self as cageless;
#[cfg(test)]
#[path = "../tests/common/mod.rs"]
mod common;
