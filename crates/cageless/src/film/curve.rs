//! The rolling force as the equations of motion evaluate it.

use super::Film;
use super::contact::LubricatedContact;
use super::rolling_force::{AXIS_EXPONENT, EHL, HEAT, HEAT_EXPONENT, IVR, TRANSITION};
use crate::numerics::inverse_root::{binary_logarithm, inverse_cube_root};
use crate::numerics::lanes::lane_struct;

/// u₀², m²/s²: F_R(ū) u/ū with ū² = u² + u₀² goes through zero with the speed.
const LEAST_SPEED_SQUARE: f64 = 1e-6;

lane_struct! {
    /// Constants of the rolling force of one contact in one oil, F_R = Q^(1/3) (a u^(2/3) w + c Q)/(w + b Q) with
    /// w = u^(3/4) but for a factor w.
    pub(crate) struct RollingCurve per lane RollingCurveLanes {
        /// a, of rigid surfaces.
        rigid,
        /// c, of elastic ones: that of the limit u^(3/4) times b.
        elastic,
        /// b, of the transition.
        load,
        /// k of the factor of the inlet 1/(1 + k u^1.56).
        heat,
    }
}

impl RollingCurve {
    /// Constants of a contact under a film.
    pub(super) fn new(contact: &LubricatedContact, film: &Film) -> Self {
        let oil = &film.oil;
        let (modulus, radius) = (contact.modulus_pa, contact.rolling_radius_m);
        let beta = contact.ellipse_factor;
        let speed = 2.0 * oil.viscosity_pa_s / (modulus * radius);
        let scale = film.supply * modulus * radius * 2.0 * contact.cross_axis_m_n1_3;
        let load = beta.powf(0.25) * contact.axis_ratio
            / (modulus * radius * radius)
            / speed.powf(0.75)
            / TRANSITION;
        let heating =
            oil.viscosity_pa_s * oil.viscosity_temperature_1_k / oil.thermal_conductivity_w_m_k;
        Self {
            rigid: scale
                * IVR
                * beta.powf(-1.0 / 3.0)
                * contact.axis_ratio.powf(AXIS_EXPONENT)
                * speed.powf(2.0 / 3.0),
            elastic: scale * EHL * beta.powf(-0.25) * speed.powf(0.75) * load,
            load,
            heat: match film.inlet_heat {
                true => HEAT * heating.powf(HEAT_EXPONENT),
                false => 0.0,
            },
        }
    }

    /// F_R of a contact under the load Q at the mean speed u, N; odd in u.
    #[inline(always)]
    pub(crate) fn force_n(&self, load_n: f64, speed_m_s: f64) -> f64 {
        // All powers of z = ū² from y = z^(−1/24), which r = 1 − z y²⁴ corrects: z^(−n/24) = yⁿ (1 + n r/24).
        let z = speed_m_s * speed_m_s + LEAST_SPEED_SQUARE;
        let logarithm = binary_logarithm(z);
        let y = inverse_root_24(logarithm);
        let y2 = y * y;
        let (y3, y4) = (y2 * y, y2 * y2);
        let y8 = y4 * y4;
        let zy4 = z * y4;
        let zy8 = zy4 * y4;
        let r = 1.0 - zy8 * (y8 * y8);
        let w = zy8 * (y4 * y3) * (1.0 + 0.625 * r);
        let two_thirds = zy8 * y8 * (1.0 + 2.0 / 3.0 * r);
        let warming = zy4 * y * inverse_power_0_28(logarithm) * (1.0 + 5.0 / 24.0 * r);
        let over = (w + self.load * load_n) * (1.0 + self.heat * warming);
        let under = self.rigid * two_thirds + self.elastic * load_n;
        let root = inverse_cube_root(load_n);
        // w/ū = z^(−1/8).
        load_n * (root * root) * (speed_m_s * y3 * (1.0 + 0.125 * r)) * under / over
    }
}

/// z^(−1/24) of log₂ z from −20 to 18, relative error below 3e-5.
#[inline(always)]
fn inverse_root_24(logarithm: f64) -> f64 {
    let square = logarithm * logarithm;
    (0.999_995_070_200_889 - 0.028_874_329_870_709_94 * logarithm)
        + square
            * ((4.170_633_461_506_846e-4 - 4.091_252_878_739_64e-6 * logarithm)
                + square * 2.946_703_105_145_09e-8)
}

/// z^(−0.28/24), the same; relative error below 1e-7 where a film warms, 2e-6 at creeping speeds.
#[inline(always)]
fn inverse_power_0_28(logarithm: f64) -> f64 {
    let square = logarithm * logarithm;
    (0.999_999_045_343_687_4 - 0.008_086_171_196_766_977 * logarithm)
        + square * (3.259_841_977_939_031e-5 - 8.105_052_240_231_016e-8 * logarithm)
}

#[cfg(test)]
mod tests {
    use super::super::Oil;
    use super::super::rolling_force::Rolling;
    use super::*;
    use crate::reference;

    /// From creeping to 500 m/s and from the weight of a ball to its hardest load: the formula, but for u₀.
    #[test]
    fn curve_follows_the_formula() {
        let bearing = reference::bearing();
        let film = Film {
            supply: 0.4,
            ..Film::flooded(Oil::mineral(5e-3, 0.035))
        };
        for contact in [
            LubricatedContact::inner(&bearing),
            LubricatedContact::outer(&bearing, 0.85),
        ] {
            let curve = RollingCurve::new(&contact, &film);
            for speed_m_s in [0.1, 1.0, 13.75, 70.0, 500.0] {
                for load_n in [0.03, 20.0, 2000.0] {
                    let rolling = Rolling { load_n, speed_m_s };
                    let expected = film.rolling_force_n(&contact, rolling);
                    let relative = curve.force_n(load_n, speed_m_s) / expected - 1.0;
                    let least = LEAST_SPEED_SQUARE / speed_m_s.powi(2);
                    assert!(
                        relative.abs() < 1e-6 + least,
                        "{speed_m_s} {load_n}: {relative:e}"
                    );
                    let back = curve.force_n(load_n, -speed_m_s);
                    assert_eq!(back, -curve.force_n(load_n, speed_m_s));
                }
            }
            assert_eq!(curve.force_n(0.0, 5.0), 0.0);
            assert_eq!(curve.force_n(5.0, 0.0), 0.0);
        }
    }
}
