//! Friction, damping and stiffness of the contacts.

use crate::contact::friction::ContactKind;
use crate::contact::{FrictionModel, FrictionParameters, Regularisation};
use crate::error::InputError;
use crate::limits::{not_negative, positive, require};

/// Contact and friction parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Law of friction.
    pub friction_law: FrictionModel,
    /// Parameters of the law of friction.
    pub friction: FrictionParameters,
    /// Where the regularisation speed of friction at the raceways comes from; between balls it is that of `friction`.
    pub regularisation: Regularisation,
    /// Friction at the outer raceway over that of the law, which the inner raceway has.
    pub outer_friction_factor: f64,
    /// Friction between balls over that of the law.
    pub ball_friction_factor: f64,
    /// Strips into which motion in space divides the friction of a contact across the groove.
    pub friction_strips: usize,
    /// c of the raceway contacts, F = K δ^(3/2) + c √δ dδ/dt, N·s·m^(−3/2).
    pub damping_n_s_m1_5: f64,
    /// Coefficient of restitution between balls, above 0, at most 1.
    pub ball_restitution: f64,
    /// K at the inner raceway, N·m^(−3/2); from Hertz if `None`.
    pub inner_stiffness_n_m1_5: Option<f64>,
    /// K at the outer raceway, N·m^(−3/2); from Hertz if `None`.
    pub outer_stiffness_n_m1_5: Option<f64>,
    /// K between balls, N·m^(−3/2); from Hertz if `None`.
    pub ball_stiffness_n_m1_5: Option<f64>,
}

/// Most strips of a contact: twice as many change the sliding by less than a hundredth.
pub const STRIPS_MAX: usize = 21;

/// Lubricated steel, μ = 0.007 with the smooth law, damped.
impl Default for Contact {
    fn default() -> Self {
        Self {
            friction_law: FrictionModel::Smooth,
            friction: FrictionParameters::smooth(0.007, FrictionParameters::REGULARISATION_MAX_M_S),
            regularisation: Regularisation::Speed,
            outer_friction_factor: 1.0,
            ball_friction_factor: 1.0,
            friction_strips: 3,
            damping_n_s_m1_5: 2e5,
            ball_restitution: 0.95,
            inner_stiffness_n_m1_5: None,
            outer_stiffness_n_m1_5: None,
            ball_stiffness_n_m1_5: None,
        }
    }
}

impl Contact {
    /// Largest friction of a kind of contact over that of the law.
    pub(crate) fn friction_factor_max(&self) -> f64 {
        self.outer_friction_factor
            .max(self.ball_friction_factor)
            .max(1.0)
    }

    /// The law of friction with its parameters in a few words.
    pub(crate) fn describe_friction(&self) -> String {
        let law = self.friction_law.describe(&self.friction);
        match self.regularisation {
            Regularisation::Speed => law,
            Regularisation::Kalker => {
                format!("{law} between balls, Kalker's creep at the raceways")
            }
        }
    }

    /// Adds to μ; with a table or a law of one's own every μ grows by the same fraction.
    pub fn shift_friction(&mut self, by: f64) {
        let sliding = self.friction.coefficient;
        let by_speed = self.friction.table.is_some() || self.friction.own.is_some();
        if by_speed && sliding > 0.0 {
            self.friction.scale((sliding + by) / sliding);
        } else {
            self.friction.coefficient += by;
        }
    }

    /// Checks the values.
    pub(super) fn check(&self) -> Result<(), InputError> {
        self.friction_law
            .check(&self.friction, ContactKind::Balls)?;
        not_negative("outer_friction_factor", self.outer_friction_factor)?;
        not_negative("ball_friction_factor", self.ball_friction_factor)?;
        not_negative("damping_n_s_m1_5", self.damping_n_s_m1_5)?;
        let e = self.ball_restitution;
        let rule = "more than 0 and at most 1";
        require("ball_restitution", e, e > 0.0 && e <= 1.0, rule)?;
        let strips = self.friction_strips;
        let rule = format!("a whole number from 1 to {STRIPS_MAX}");
        let kept = (1..=STRIPS_MAX).contains(&strips);
        require("friction_strips", strips as f64, kept, rule)?;
        for (field, stiffness) in [
            ("inner_stiffness_n_m1_5", self.inner_stiffness_n_m1_5),
            ("outer_stiffness_n_m1_5", self.outer_stiffness_n_m1_5),
            ("ball_stiffness_n_m1_5", self.ball_stiffness_n_m1_5),
        ] {
            if let Some(value) = stiffness {
                positive(field, value)?;
            }
        }
        Ok(())
    }
}
