//! Contacts of a ball as scalar functions on plain structs: Hertz, damping, friction, and the
//! contacts with outer raceway, inner raceway and neighbouring ball (Zhao 2022, Eq. (16) to
//! (22)).
//!
//! The functions are free of branches on data and of lane indices, so that the vector harness
//! (`simd`) can call them lane by lane; static equilibrium, energy and tests call the
//! same ones.
//!
//! ```
//! use cageless::contact::FrictionTable;
//!
//! // Dry steel: 0.3 at rest, 0.2 from 0.5 m/s on.
//! let table = FrictionTable::new(vec![[0.0, 0.3], [0.1, 0.24], [0.5, 0.2]])?;
//! assert!(FrictionTable::new(vec![[0.0, -0.3], [0.5, 0.2]]).is_err());
//! # Ok::<(), cageless::InputError>(())
//! ```

mod ball_ball;
pub(crate) mod creep;
mod flank_friction;
mod flank_section;
mod flanks;
pub mod flash_temperature;
pub(crate) mod friction;
pub(crate) mod friction_step;
pub mod hertz;
mod implicit_friction;
mod inner;
mod journal;
mod normal_force;
mod outer;
mod outer_geometry;
pub(crate) mod published;
mod regularisation;
mod slip_problem;

pub(crate) use ball_ball::{ball_ball_contact, ball_deflection};
pub(crate) use flank_friction::{AtFlanks, FlankSliding};
pub(crate) use flank_section::FlankSection;
#[cfg(test)]
pub(crate) use flanks::FlankContact;
pub(crate) use flanks::flank_contact;
pub(crate) use friction::Friction;
pub(crate) use friction::Law;
pub use friction::OwnFriction;
pub use friction::{FrictionFault, FrictionLaw, FrictionModel, FrictionParameters, FrictionTable};
pub(crate) use friction_step::{MAX_ITERATIONS, end_weights};
pub(crate) use implicit_friction::RacewayContacts;
pub(crate) use implicit_friction::{further_step, newton_step};
pub(crate) use inner::inner_contact;
pub(crate) use inner::inner_load;
pub(crate) use inner::{InnerContact, InnerRaceway, inner_deflection, inner_slip};
pub(crate) use journal::{Journal, JournalContact, JournalMotion, JournalSlip, journal_contact};
pub(crate) use journal::{implicit_slip, journal_energy_j, journal_slip};
pub(crate) use normal_force::NormalForce;
pub(crate) use normal_force::restitution_damping;
pub(crate) use outer::outer_contact;
pub(crate) use outer::{OuterContact, OuterGeometry, OuterRaceway, outer_deflection, outer_slip};
pub(crate) use outer::{outer_load, slope_force};
pub(crate) use outer_geometry::{FlankShape, RacewayConstants, RacewayPosition, RacewayValues};
pub(crate) use outer_geometry::{nominal_geometry, unequal_geometry};
pub use regularisation::Regularisation;

pub(crate) use slip_problem::{SlipProblem, Slips};

pub(crate) use ball_ball::BallBallContactLanes;
pub(crate) use creep::CreepLanes;
pub(crate) use flank_friction::FlankSlidingLanes;
pub(crate) use flanks::FlankContactLanes;
pub(crate) use friction::{AtKnees, EvaluatedLaws, FrictionLanes, LawLanes, with_law};
pub(crate) use inner::{InnerContactLanes, InnerRacewayLanes};
pub(crate) use outer::{OuterContactLanes, OuterGeometryLanes, OuterRacewayLanes};
pub(crate) use outer_geometry::{RacewayConstantsLanes, RacewayPositionLanes, RacewayValuesLanes};
pub(crate) use slip_problem::{SlipProblemLanes, SlipsLanes};

/// The larger of `x` and 0; 0 for NaN.
#[inline(always)]
pub(crate) fn positive(x: f64) -> f64 {
    if x > 0.0 { x } else { 0.0 }
}
