//! Values that a case takes for keys that are left out, in the units of the file. Those of
//! `[material]`, `[contact]`, `[solver]` and `[output]` are the values of the template.

use cageless::{FrictionLaw, Method, Profile};

use super::document::StartState;

/// Bearing steel.
pub(super) const DENSITY_KG_M3: f64 = 7850.0;
/// Bearing steel.
pub(super) const YOUNGS_MODULUS_GPA: f64 = 206.0;
/// Bearing steel.
pub(super) const POISSON_RATIO: f64 = 0.3;
/// On the Earth, with the axis of the bearing horizontal.
pub(super) const GRAVITY_M_S2: f64 = 9.81;
/// Zhao 2022, Table 1.
pub(super) const FRICTION_COEFFICIENT: f64 = 0.007;
pub(super) const FRICTION_LAW: FrictionLaw = FrictionLaw::Smooth;
pub(super) const SLIP_SCALE_M_S: f64 = 0.02;
/// N s/m^1.5.
pub(super) const DAMPING: f64 = 2.0e5;
/// Steel on steel at the approach speeds of neighbouring balls.
pub(super) const BALL_RESTITUTION: f64 = 0.95;
pub(super) const PROFILE: Profile = Profile::Physical;
pub(super) const START_STATE: StartState = StartState::Settled;
pub(super) const METHOD: Method = Method::Symplectic;
/// Error per step of the adaptive method: a hundredth of what a figure shows.
pub(super) const TOLERANCE: f64 = 1e-8;
pub(super) const DURATION_S: f64 = 0.5;
pub(super) const INTERVAL_US: f64 = 100.0;
