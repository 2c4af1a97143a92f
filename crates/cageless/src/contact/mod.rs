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
pub(crate) mod flash_temperature;
pub(crate) mod friction;
pub(crate) mod friction_step;
pub(crate) mod hertz;
mod implicit_friction;
mod inner;
mod journal;
mod normal_force;
mod outer;
mod outer_geometry;
pub(crate) mod published;
mod regularisation;
mod slip_problem;

pub use flash_temperature::FLASH_TEMPERATURE_LIMIT_K;
pub use hertz::STRESS_LIMIT_PA;

pub(crate) use ball_ball::{BallBallContactLanes, ball_ball_contact, ball_deflection};
pub(crate) use creep::CreepLanes;
pub(crate) use flank_friction::{AtFlanks, FlankSliding, FlankSlidingLanes};
pub(crate) use flank_section::FlankSection;
#[cfg(test)]
pub(crate) use flanks::FlankContact;
pub(crate) use flanks::{FlankContactLanes, flank_contact};
pub(crate) use friction::OwnFriction;
pub(crate) use friction::{
    AtKnees, AtRaceways, EvaluatedLaws, FilmTraction, FilmTractionLanes, Friction, FrictionLanes,
    Law, LawLanes, with_law,
};
pub use friction::{FrictionLaw, FrictionModel, FrictionParameters, FrictionTable};
pub(crate) use friction_step::{MAX_ITERATIONS, end_weights};
pub(crate) use implicit_friction::{RacewayContacts, further_step, newton_step};
pub(crate) use inner::{
    InnerContact, InnerContactLanes, InnerRaceway, InnerRacewayLanes, inner_contact,
    inner_deflection, inner_load, inner_slip,
};
pub(crate) use journal::{
    Journal, JournalContact, JournalMotion, JournalSlip, implicit_slip, journal_contact,
    journal_energy_j, journal_slip,
};
pub(crate) use normal_force::{NormalForce, restitution_damping};
pub(crate) use outer::{
    OuterContact, OuterContactLanes, OuterGeometry, OuterGeometryLanes, OuterRaceway,
    OuterRacewayLanes, outer_contact, outer_deflection, outer_load, outer_slip, slope_force,
};
pub(crate) use outer_geometry::{
    FlankShape, RacewayConstants, RacewayConstantsLanes, RacewayPosition, RacewayPositionLanes,
    RacewayValues, RacewayValuesLanes, nominal_geometry, unequal_geometry,
};
pub use regularisation::Regularisation;
pub(crate) use slip_problem::{SlipProblem, SlipProblemLanes, Slips, SlipsLanes};

/// The larger of `x` and 0; 0 for NaN.
#[inline(always)]
pub(crate) fn positive(x: f64) -> f64 {
    if x > 0.0 { x } else { 0.0 }
}
