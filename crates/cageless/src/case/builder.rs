//! A case in a few lines.

use super::{
    Case, Contact, Gaps, Motion, Operation, Output, Solver, SpatialLoad, Start, StartState,
};
use crate::bearing::Bearing;
use crate::contact::{FrictionLaw, FrictionModel, FrictionParameters, OwnFriction};
use crate::error::InputError;
use crate::flank_model::FlankModel;
use crate::formulation::Formulation;
use crate::integrator::IntegrationMethod;
use crate::raceway::Raceway;
use crate::rotor::{Rotor, Support};
use crate::step_limits;

/// Method of a case unless one is given.
const METHOD: IntegrationMethod = IntegrationMethod::VelocityVerlet;
/// Step until the automatic one is known, s.
const PROVISIONAL_STEP_S: f64 = 1e-6;

impl Case {
    /// The case of a bearing that nothing loads or turns.
    ///
    /// No raceway, elastic flanks, μ = 0.007 (lubricated) with the smooth law, contact damping 2·10⁵ N·s·m^(−3/2),
    /// restitution 0.95 between balls, balls evenly spaced in static equilibrium, g = 9.81 m/s², velocity Verlet over
    /// 0.5 s with a step of 1 µs, a row of output each 0.1 ms.
    pub fn of(bearing: Bearing) -> Self {
        Self {
            title: String::new(),
            bearing,
            raceways: vec![],
            operation: Operation {
                clockwise: false,
                inner_speed_rad_s: 0.0,
                radial_load_n: 0.0,
                gravity_m_s2: 9.81,
                inner_speed_table: None,
                radial_load_table: None,
                space: SpatialLoad::default(),
            },
            contact: Contact {
                friction_law: FrictionModel::Smooth,
                friction: FrictionParameters::smooth(
                    0.007,
                    FrictionParameters::REGULARISATION_MAX_M_S,
                ),
                outer_friction_factor: 1.0,
                ball_friction_factor: 1.0,
                friction_strips: 3,
                damping_n_s_m1_5: 2e5,
                ball_restitution: 0.95,
                inner_stiffness_n_m1_5: None,
                outer_stiffness_n_m1_5: None,
                ball_stiffness_n_m1_5: None,
            },
            formulation: Formulation::Physical,
            motion: Motion::BySymmetry,
            flanks: FlankModel::Elastic,
            start: Start::new(StartState::Settled, Gaps::Uniform, 0.0),
            solver: Solver {
                method: METHOD,
                step_s: PROVISIONAL_STEP_S,
                tolerance: 1e-8,
                duration_s: 0.5,
                transient_s: None,
            },
            seed: 0,
            housing: None,
            rotor: None,
            support: None,
            rows: vec![],
            fit: None,
            lubrication: None,
            thermal: Default::default(),
            limits: vec![],
            output: Output { interval_s: 1e-4 },
        }
    }

    /// Regularisation speed that goes with the speed of the bearing, m/s; with a rotor the largest one.
    pub fn automatic_regularisation_m_s(&self) -> f64 {
        match self.rotor {
            Some(_) => FrictionParameters::REGULARISATION_MAX_M_S,
            None => {
                let orbit_rad_s = self.rolling_orbit_speed_rad_s().abs();
                let rolling_m_s = orbit_rad_s * self.bearing.pitch_radius_m();
                FrictionParameters::regularisation_of_rolling_m_s(rolling_m_s)
            }
        }
    }
}

/// A case under construction: that of [`Case::of`] with changes.
///
/// ```
/// use cageless::prelude::*;
///
/// let case = CaseBuilder::of(reference::bearing())
///     .inner_speed_rad_s(1256.0)
///     .radial_load_n(1500.0)
///     .build()?;
/// assert!(case.solver.step_s < 5e-6); // the automatic step
/// assert!(CaseBuilder::of(reference::bearing()).radial_load_n(-1.0).build().is_err());
/// # Ok::<(), InputError>(())
/// ```
#[derive(Debug, Clone)]
#[must_use = "`build` makes the case"]
pub struct CaseBuilder {
    case: Case,
    regularisation_m_s: Option<f64>,
    step_s: Option<f64>,
    refused: Option<InputError>,
}

impl CaseBuilder {
    /// Changes to the case of a bearing.
    pub fn of(bearing: Bearing) -> Self {
        Self {
            case: Case::of(bearing),
            regularisation_m_s: None,
            step_s: None,
            refused: None,
        }
    }

    /// Any other change.
    pub fn change(mut self, change: impl FnOnce(&mut Case)) -> Self {
        change(&mut self.case);
        self
    }

    /// Speed of the inner ring, rad/s, counter-clockwise.
    pub fn inner_speed_rad_s(self, speed_rad_s: f64) -> Self {
        self.change(|case| case.operation.inner_speed_rad_s = speed_rad_s)
    }

    /// Radial load on the inner ring, N, along −Y.
    pub fn radial_load_n(self, load_n: f64) -> Self {
        self.change(|case| case.operation.radial_load_n = load_n)
    }

    /// A discrete raceway more.
    pub fn raceway(self, raceway: Raceway) -> Self {
        self.change(|case| case.raceways.push(raceway))
    }

    /// μ of the smooth law.
    pub fn friction_coefficient(self, coefficient: f64) -> Self {
        self.change(|case| case.contact.friction.coefficient = coefficient)
    }

    /// A law of friction of one's own.
    pub fn own_friction(mut self, law: impl FrictionLaw + 'static) -> Self {
        match OwnFriction::new(law) {
            Ok(law) => {
                let contact = &mut self.case.contact;
                contact.friction_law = FrictionModel::Own;
                let scale_m_s = contact.friction.regularisation_speed_m_s;
                contact.friction = FrictionParameters::own(law, scale_m_s);
            }
            Err(error) => self.refused = self.refused.or(Some(error)),
        }
        self
    }

    /// Regularisation speed of friction, m/s; that of [`Case::automatic_regularisation_m_s`] unless it is given.
    pub fn regularisation_speed_m_s(mut self, speed_m_s: f64) -> Self {
        self.regularisation_m_s = Some(speed_m_s);
        self
    }

    /// Gaps between the balls at the start.
    pub fn gaps(self, gaps: Gaps) -> Self {
        self.change(|case| case.start.gaps = gaps)
    }

    /// A rotor that falls onto the inner ring at t = 0, and the support of the outer ring; all parts at rest.
    pub fn rotor(self, rotor: Rotor, support: Option<Support>) -> Self {
        self.change(|case| {
            case.rotor = Some(rotor);
            case.support = support;
            case.start.state = StartState::AtRest;
        })
    }

    /// Method of integration.
    pub fn method(self, method: IntegrationMethod) -> Self {
        self.change(|case| case.solver.method = method)
    }

    /// Step, s; the automatic one of the method unless it is given.
    pub fn step_s(mut self, step_s: f64) -> Self {
        self.step_s = Some(step_s);
        self
    }

    /// Duration of a run, s.
    pub fn duration_s(self, duration_s: f64) -> Self {
        self.change(|case| case.solver.duration_s = duration_s)
    }

    /// The case, with its step and regularisation speed.
    ///
    /// # Errors
    /// An [`InputError`] with the first value that cannot be, and what is allowed.
    pub fn build(self) -> Result<Case, InputError> {
        if let Some(error) = self.refused {
            return Err(error);
        }
        let mut case = self.case;
        case.contact.friction.regularisation_speed_m_s = self
            .regularisation_m_s
            .unwrap_or_else(|| case.automatic_regularisation_m_s());
        case.check()?;
        match self.step_s {
            Some(step_s) => case.solver.step_s = step_s,
            None => case.set_method(case.solver.method),
        }
        step_limits::check(&case)?;
        Ok(case)
    }
}
