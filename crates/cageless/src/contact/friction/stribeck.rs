//! Friction that drops from static to sliding.

use super::parameters::FrictionParameters;
use super::law::{Law, LawConstants, knee};
use crate::numerics::exponential::{exponential, tanh};
use crate::numerics::lanes::lane_struct;

law_struct! {
    /// (μ + (μs − μ)·exp(−|ΔV|/v))·tanh(ΔV/scale)·N.
    pub(crate) struct Stribeck per lane StribeckLanes {
        /// μ of fast sliding.
        coefficient,
        /// μs − μ.
        static_excess,
        /// 1/v, s/m.
        inverse_stribeck_speed,
        /// 1/scale, s/m.
        inverse_regularisation_speed,
    }
}

impl Law for Stribeck {
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let largest = self.coefficient * normal_n;
        let knee = tanh(sliding_m_s * inverse_knee_s_m);
        let decay = exponential((-sliding_m_s.abs() * self.inverse_stribeck_speed).max(-80.0));
        let excess = self.static_excess * decay * normal_n;
        let slope = (largest + excess) * (1.0 - knee * knee) * inverse_knee_s_m
            - excess * self.inverse_stribeck_speed * knee.abs();
        [(largest + excess) * knee, slope]
    }

    /// Zero sliding, from which μ falls to both sides.
    #[inline(always)]
    fn edge(&self, sliding_m_s: f64) -> Option<f64> {
        Some(sliding_m_s)
    }

    knee!();
}

impl LawConstants for Stribeck {
    const NAME: &'static str = "stribeck";

    fn new(parameters: &FrictionParameters, _stick_gain_n_s_m: f64) -> Self {
        Self {
            coefficient: parameters.coefficient,
            static_excess: Self::coefficient_max(parameters) - parameters.coefficient,
            inverse_stribeck_speed: parameters.stribeck_speed_m_s.map_or(0.0, |v| 1.0 / v),
            inverse_regularisation_speed: 1.0 / parameters.regularisation_speed_m_s,
        }
    }

    fn describe(parameters: &FrictionParameters) -> String {
        format!(
            "Stribeck, {} to {}",
            Self::coefficient_max(parameters),
            parameters.coefficient
        )
    }

    fn coefficient_max(parameters: &FrictionParameters) -> f64 {
        let sliding = parameters.coefficient;
        parameters
            .static_coefficient
            .map_or(sliding, |s| s.max(sliding))
    }

    /// μs.
    fn coefficient_at_rest(parameters: &FrictionParameters) -> f64 {
        Self::coefficient_max(parameters)
    }

    /// (μs − μ)/v, that of the exponential at rest.
    fn steepest_fall(parameters: &FrictionParameters) -> f64 {
        let excess = Self::coefficient_max(parameters) - parameters.coefficient;
        parameters.stribeck_speed_m_s.map_or(0.0, |v| excess / v)
    }
}
