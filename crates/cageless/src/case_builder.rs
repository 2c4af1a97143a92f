//! A case in a few lines, checked before anything is computed.

use crate::bearing::Bearing;
use crate::case::{Case, Gaps, StartState};
use crate::contact::{FrictionLaw, FrictionModel, FrictionParameters, OwnFriction, Regularisation};
use crate::error::InputError;
use crate::integrator::IntegrationMethod;
use crate::raceway::Raceway;
use crate::rotor::{Rotor, Support};
use crate::step_limits;

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

    /// Where the regularisation speed of friction at the raceways comes from.
    pub fn regularisation(self, regularisation: Regularisation) -> Self {
        self.change(|case| case.contact.regularisation = regularisation)
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
