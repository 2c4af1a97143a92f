//! Friction with a smooth knee at zero sliding speed.

use super::parameters::FrictionParameters;
use super::law::{Law, LawConstants, knee};
use crate::numerics::exponential::{tanh, tanh_pair};
use crate::numerics::lanes::lane_struct;

law_struct! {
    /// μ·tanh(ΔV/scale)·N.
    pub(crate) struct Smooth per lane SmoothLanes {
        /// μ.
        coefficient,
        /// 1/scale, s/m.
        inverse_regularisation_speed,
    }
}

impl Smooth {
    /// Force and slope where the knee at a speed has this value.
    #[inline(always)]
    fn at_knee(&self, knee: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let largest = self.coefficient * normal_n;
        let slope = largest * (1.0 - knee * knee) * inverse_knee_s_m;
        [largest * knee, slope]
    }
}

impl Law for Smooth {
    /// μ·tanh(ΔV/scale)·N along −ΔV, N, in place of the step of Zhao 2022, Eq. (20) and Eq. (21),
    /// and its slope over ΔV, N·s/m.
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        self.at_knee(tanh(sliding_m_s * inverse_knee_s_m), normal_n, inverse_knee_s_m)
    }

    #[inline(always)]
    fn forces_with_knees(&self, slips_m_s: [f64; 2], normals_n: [f64; 2], inverse_knees_s_m: [f64; 2]) -> [[f64; 2]; 2] {
        let ([s, t], [first, second]) = (slips_m_s, inverse_knees_s_m);
        let [outer, inner] = tanh_pair([s * first, t * second]);
        [
            self.at_knee(outer, normals_n[0], first),
            self.at_knee(inner, normals_n[1], second),
        ]
    }

    knee!();
}

impl LawConstants for Smooth {
    const NAME: &'static str = "smooth";

    fn new(parameters: &FrictionParameters, _stick_gain_n_s_m: f64) -> Self {
        Self {
            coefficient: parameters.coefficient,
            inverse_regularisation_speed: 1.0 / parameters.regularisation_speed_m_s,
        }
    }

    fn describe(parameters: &FrictionParameters) -> String {
        format!("smooth, tanh(ΔV/{} m/s)", parameters.regularisation_speed_m_s)
    }
}
