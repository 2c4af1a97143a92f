//! A case in a few lines, checked before anything is computed.

use std::sync::Arc;

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
    own_friction: Option<Arc<dyn FrictionLaw>>,
    own_journal_friction: Option<Arc<dyn FrictionLaw>>,
}

impl CaseBuilder {
    /// Changes to the case of a bearing.
    pub fn of(bearing: Bearing) -> Self {
        Self {
            case: Case::of(bearing),
            regularisation_m_s: None,
            step_s: None,
            own_friction: None,
            own_journal_friction: None,
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

    /// A law of friction of one's own at the contacts of the balls, with the raceways and with each other.
    ///
    /// That of journal and bore is [`Self::own_journal_friction`].
    pub fn own_friction(mut self, law: impl FrictionLaw + 'static) -> Self {
        self.own_friction = Some(Arc::new(law));
        self
    }

    /// A law of friction of one's own between the journal of the [rotor](Self::rotor) and the bore of the inner ring,
    /// with the regularisation speed of [`Rotor::friction`].
    pub fn own_journal_friction(mut self, law: impl FrictionLaw + 'static) -> Self {
        self.own_journal_friction = Some(Arc::new(law));
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
    ///
    /// [`Rotor::estimated`] makes one, and [`Bearing::with_inner_ring_bore`] gives the bearing what it needs: the bore
    /// that catches the journal, and the polar inertia of the ring that it spins up. The case has no speed and no load
    /// of its own.
    ///
    /// ```
    /// use cageless::prelude::*;
    ///
    /// /// Friction of a bronze that smears, between journal and bore.
    /// struct Smearing;
    ///
    /// impl FrictionLaw for Smearing {
    ///     fn coefficient(&self, sliding_m_s: f64) -> [f64; 2] {
    ///         let excess = 0.1 * (-sliding_m_s / 5.0).exp();
    ///         [0.1 + excess, -excess / 5.0]
    ///     }
    /// }
    ///
    /// let bore = InnerRingBore { radius_m: 15e-3, polar_inertia_kg_m2: 5.5e-5 };
    /// let bearing = reference::bearing().with_inner_ring_bore(bore)?;
    /// let rotor = Rotor { eccentricity_m: 1e-6, ..Rotor::estimated(20.0, 0.02, 3142.0, 2e-4) };
    /// let case = CaseBuilder::of(bearing).rotor(rotor, None).own_journal_friction(Smearing).build()?;
    /// Simulation::new(&case)?.advance_to(1e-3)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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
        let mut case = self.case;
        let scale_m_s =
            (self.regularisation_m_s).unwrap_or_else(|| case.automatic_regularisation_m_s());
        case.contact.friction.regularisation_speed_m_s = scale_m_s;
        check_bore(&case)?;
        case.check()?;
        // The speeds of the case, up to which laws are tried, are possible.
        let most_m_s = case.sliding_speed_bound_m_s();
        if let Some(law) = self.own_friction {
            let law = OwnFriction::new(law, "own_friction", most_m_s)?;
            case.contact.friction_law = FrictionModel::Own;
            case.contact.friction = FrictionParameters::own(law, scale_m_s);
        }
        if let Some(law) = self.own_journal_friction {
            let field = "own_journal_friction";
            let law = OwnFriction::new(law, field, most_m_s)?;
            let rule = "left out, or given with a rotor: it is the friction of its journal";
            let rotor = case.rotor.as_mut();
            let rotor =
                rotor.ok_or_else(|| InputError::rule(field, law.coefficient_fast(), rule))?;
            rotor.friction_law = FrictionModel::Own;
            rotor.friction = FrictionParameters::own(law, rotor.friction.regularisation_speed_m_s);
        }
        case.check()?;
        match self.step_s {
            Some(step_s) => case.solver.step_s = step_s,
            None => case.set_method(case.solver.method),
        }
        step_limits::check(&case)?;
        Ok(case)
    }
}

/// Refuses a rotor above an inner ring without a bore.
fn check_bore(case: &Case) -> Result<(), InputError> {
    match (&case.rotor, case.bearing.inner_ring_bore()) {
        (Some(_), None) => {
            let rule = "given, by `Bearing::with_inner_ring_bore`: the rotor spins the inner ring up in its bore";
            Err(InputError::rule("inner_ring_bore", f64::NAN, rule))
        }
        _ => Ok(()),
    }
}
