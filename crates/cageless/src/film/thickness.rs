//! Thickness of the film, and the share of the load that asperities carry.

use super::contact::LubricatedContact;
use super::oil::Oil;
use super::rolling_force::Rolling;

/// Film of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct FilmThickness {
    /// h_min, least thickness, m.
    pub least_m: f64,
    /// h_c, thickness in the middle, m.
    pub central_m: f64,
}

impl LubricatedContact {
    /// Flooded, isothermal film, an upper bound, with U = ηu/(E′R_x), G = αE′ and κ = a/b:
    ///
    ///   h_c = 2.69 R_x U^0.67 G^0.53 W^(−0.067) (1 − 0.61 e^(−0.73κ)),
    ///   h_min = 3.63 R_x U^0.68 G^0.49 W^(−0.073) (1 − e^(−0.68κ))
    ///
    /// (Hamrock & Dowson). Zero without load or speed.
    pub(crate) fn film_thickness(&self, oil: &Oil, rolling: Rolling) -> FilmThickness {
        let Rolling { load_n, speed_m_s } = rolling;
        if !(load_n > 0.0) || speed_m_s == 0.0 {
            return FilmThickness::default();
        }
        let radius_m = self.rolling_radius_m;
        let speed = oil.viscosity_pa_s * speed_m_s.abs() / (self.modulus_pa * radius_m);
        let stiffening = oil.pressure_viscosity_1_pa * self.modulus_pa;
        let load = self.load_parameter(load_n);
        let ellipse = 1.0 / self.axis_ratio;
        FilmThickness {
            least_m: 3.63
                * radius_m
                * speed.powf(0.68)
                * stiffening.powf(0.49)
                * load.powf(-0.073)
                * (1.0 - (-0.68 * ellipse).exp()),
            central_m: 2.69
                * radius_m
                * speed.powf(0.67)
                * stiffening.powf(0.53)
                * load.powf(-0.067)
                * (1.0 - 0.61 * (-0.73 * ellipse).exp()),
        }
    }
}

/// Factor and exponent of Λ in the share of the load on asperities.
pub(super) const ASPERITY_FACTOR: f64 = 2.1;
pub(super) const ASPERITY_EXPONENT: f64 = 0.85;

/// φ = exp(−2.1 Λ^0.85), share of the load on asperities, Λ = h_c/R_q (Zhou & Hoeprich, as in Wingertszahn et al.,
/// Lubricants 11 (2023) 369, Eq. (29) to (31)).
pub(crate) fn asperity_share(film_parameter: f64) -> f64 {
    (-ASPERITY_FACTOR * film_parameter.powf(ASPERITY_EXPONENT)).exp()
}
