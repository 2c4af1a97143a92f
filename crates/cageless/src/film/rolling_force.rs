//! Force of the inlet of a lubricated contact that resists rolling.
//!
//! With U = 2ηu/(E′R_x), W = Q/(E′R_x²), M = β^(1/4) κ W U^(−3/4):
//!
//!   F_R = E′ R_x² (2a/R_x) [(0.77 β^(−1/3) κ^0.12 U^(2/3) − 1.8 β^(−1/4) U^(3/4))/(1 + M/6.6) + 1.8 β^(−1/4) U^(3/4)]
//!
//! (Biboulet & Houpert, Proc. IMechE J 224 (2010) 777, Eq. (14), (30) to (32)), times the factor of the heat of the
//! inlet, 1/(1 + 0.29 L^0.78) with L = η β_T u²/λ (Aihara, J. Tribol. 109 (1987), Eq. (21), of line contacts).

use super::contact::LubricatedContact;
use super::oil::Oil;

/// Factors of the two limits of the force.
pub(super) const IVR: f64 = 0.77;
pub(super) const EHL: f64 = 1.8;
/// Exponent of κ in the limit of rigid surfaces.
pub(super) const AXIS_EXPONENT: f64 = 0.12;
/// M at the middle of the transition.
pub(super) const TRANSITION: f64 = 6.6;
/// Factor and exponent of the heat of the inlet.
pub(super) const HEAT: f64 = 0.29;
pub(super) const HEAT_EXPONENT: f64 = 0.78;

/// Load and speed of a rolling contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rolling {
    /// Q, N; without load, or apart, there is no force.
    pub load_n: f64,
    /// u, mean speed of both surfaces relative to the contact, m/s.
    pub speed_m_s: f64,
}

/// Rolling force on either surface of a contact, in parts; zero without load or speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RollingForce {
    /// Force of rigid surfaces in oil of constant viscosity, N.
    pub rigid_n: f64,
    /// Force of an elastohydrodynamic contact, N.
    pub elastohydrodynamic_n: f64,
    /// M, load over speed: 0 rigid, large elastohydrodynamic.
    pub transition: f64,
    /// Factor of the heat of the inlet, 1 without.
    pub heat_factor: f64,
}

impl RollingForce {
    /// F_R of an inlet at the temperature of the rings, N.
    pub(crate) fn isothermal_n(&self) -> f64 {
        (self.rigid_n - self.elastohydrodynamic_n) / (1.0 + self.transition / TRANSITION)
            + self.elastohydrodynamic_n
    }

    /// F_R with the heat of the inlet, N.
    #[cfg(test)]
    pub(crate) fn heated_n(&self) -> f64 {
        self.heat_factor * self.isothermal_n()
    }
}

/// U = 2ηu/(E′R_x).
pub(super) fn speed_parameter(contact: &LubricatedContact, oil: &Oil, speed_m_s: f64) -> f64 {
    2.0 * oil.viscosity_pa_s * speed_m_s / (contact.modulus_pa * contact.rolling_radius_m)
}

impl LubricatedContact {
    /// Flooded rolling force; odd in the speed.
    pub(crate) fn rolling_force(&self, oil: &Oil, rolling: Rolling) -> RollingForce {
        let Rolling { load_n, speed_m_s } = rolling;
        if !(load_n > 0.0) || speed_m_s == 0.0 {
            return RollingForce {
                heat_factor: 1.0,
                ..RollingForce::default()
            };
        }
        let speed = speed_parameter(self, oil, speed_m_s.abs());
        let beta = self.ellipse_factor;
        let scale = self.modulus_pa * self.rolling_radius_m * 2.0 * self.cross_axis_m(load_n);
        let scale = scale.copysign(speed_m_s);
        let heating = oil.viscosity_pa_s * oil.viscosity_temperature_1_k * speed_m_s.powi(2)
            / oil.thermal_conductivity_w_m_k;
        let rigid = IVR * beta.powf(-1.0 / 3.0) * self.axis_ratio.powf(AXIS_EXPONENT);
        RollingForce {
            rigid_n: scale * rigid * speed.powf(2.0 / 3.0),
            elastohydrodynamic_n: scale * EHL * beta.powf(-0.25) * speed.powf(0.75),
            transition: beta.powf(0.25) * self.axis_ratio * self.load_parameter(load_n)
                / speed.powf(0.75),
            heat_factor: 1.0 / (1.0 + HEAT * heating.powf(HEAT_EXPONENT)),
        }
    }
}
