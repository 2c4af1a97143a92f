//! Laws of friction over the sliding speed.

use crate::case::FrictionLaw;
use crate::simd::lanes::lane_struct;

lane_struct! {
    /// Constants of the friction of a contact.
    pub struct Friction per lane FrictionLanes {
        /// μ; of the Stribeck law that of fast sliding, μd.
        coefficient,
        /// Stribeck law: μs − μd.
        static_excess,
        /// Stribeck law: 1/v of μs − μd falling as exp(−|ΔV|/v), s/m.
        inverse_stribeck_speed,
        /// 1/ΔV at which tanh(ΔV/scale) of the smooth and Stribeck laws has its knee, s/m.
        inverse_slip_scale,
        /// Coulomb's law in explicit methods: friction per sliding speed within the cone, N·s/m.
        stick_gain,
    }
}

/// Friction force along −ΔV under the normal force `normal_n`, N, and its slope over ΔV, N·s/m
/// (Zhao 2022, Eq. (20) and Eq. (21)).
///
/// Smooth law: μ·tanh(ΔV/scale)·N. Stribeck law: the same with μ = μd + (μs − μd)·exp(−|ΔV|/v).
/// Coulomb's law: g·ΔV bounded by ±μN, the cone with the relaxed stick of
/// [`crate::dynamics::Model`]; where the ball slides, μ·sign(ΔV)·N. Implicit methods solve
/// Coulomb's law exactly instead ([`super::coulomb_friction`]).
#[inline(always)]
pub fn friction_force(law: FrictionLaw, f: &Friction, slip_m_s: f64, normal_n: f64) -> [f64; 2] {
    let largest = f.coefficient * normal_n;
    match law {
        FrictionLaw::Smooth => {
            let knee = tanh(slip_m_s * f.inverse_slip_scale);
            let slope = largest * (1.0 - knee * knee) * f.inverse_slip_scale;
            [largest * knee, slope]
        }
        FrictionLaw::Stribeck => {
            let knee = tanh(slip_m_s * f.inverse_slip_scale);
            let decay = exp_negative((-slip_m_s.abs() * f.inverse_stribeck_speed).max(-80.0));
            let excess = f.static_excess * decay * normal_n;
            let slope = (largest + excess) * (1.0 - knee * knee) * f.inverse_slip_scale
                - excess * f.inverse_stribeck_speed * knee.abs();
            [(largest + excess) * knee, slope]
        }
        FrictionLaw::Coulomb => {
            let wanted = f.stick_gain * slip_m_s;
            let bounded = if wanted > largest { largest } else { wanted };
            [
                if bounded < -largest {
                    -largest
                } else {
                    bounded
                },
                f.stick_gain,
            ]
        }
    }
}

/// tanh, the same bits on every instruction set, absolute error below 4e-16: one
/// expression without branches, so that a loop over it becomes vector code.
///
/// tanh |x| = (1 − q)/(1 + q) with q = exp(−2|x|).
#[inline(always)]
pub fn tanh(x: f64) -> f64 {
    let q = exp_negative((-2.0 * x.abs()).max(-80.0));
    ((1.0 - q) / (1.0 + q)).copysign(x)
}

/// exp for −80 ≤ x ≤ 0: x = k ln 2 + f, exp x = 2^k · exp f with the Taylor series
/// of exp to f¹³ (|f| ≤ ln 2/2: remainder below 5e-18).
#[inline(always)]
fn exp_negative(x: f64) -> f64 {
    /// Adding it leaves the nearest integer in the low bits of the mantissa.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    /// ln 2 split so that k·LN2_HI is exact.
    const LN2_HI: f64 = 0.693_147_180_369_123_8;
    const LN2_LO: f64 = 1.908_214_929_270_587_7e-10;
    let shifted = x * std::f64::consts::LOG2_E + ROUND;
    let k = shifted - ROUND;
    let f = (x - k * LN2_HI) - k * LN2_LO;
    // Even and odd powers, which do not wait for each other.
    let square = f * f;
    let (mut even, mut odd) = (1.0 / 479_001_600.0, 1.0 / 6_227_020_800.0);
    for [c0, c1] in [
        [1.0 / 3_628_800.0, 1.0 / 39_916_800.0],
        [1.0 / 40_320.0, 1.0 / 362_880.0],
        [1.0 / 720.0, 1.0 / 5_040.0],
        [1.0 / 24.0, 1.0 / 120.0],
        [0.5, 1.0 / 6.0],
        [1.0, 1.0],
    ] {
        even = even * square + c0;
        odd = odd * square + c1;
    }
    let sum = even + odd * f;
    let power = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    sum * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tanh_follows_the_standard_library() {
        for k in -200_000..=200_000 {
            let x = f64::from(k) * 2.1e-4;
            assert!((tanh(x) - x.tanh()).abs() < 4e-16, "{x}");
        }
        assert_eq!(tanh(0.0), 0.0);
        assert_eq!(tanh(1e9), 1.0);
        assert_eq!(tanh(-1e9), -1.0);
    }

    /// The slope is the derivative of the force, by central differences.
    #[test]
    fn slopes_are_derivatives() {
        let f = Friction {
            coefficient: 0.1,
            static_excess: 0.2,
            inverse_stribeck_speed: 10.0,
            inverse_slip_scale: 50.0,
            stick_gain: 1.0,
        };
        for law in [FrictionLaw::Smooth, FrictionLaw::Stribeck] {
            for slip in [-1.0, -0.3, -0.02, 1e-3, 0.05, 0.7] {
                let force = |slip: f64| friction_force(law, &f, slip, 100.0)[0];
                let h = 1e-6;
                let expected = (force(slip + h) - force(slip - h)) / (2.0 * h);
                let found = friction_force(law, &f, slip, 100.0)[1];
                assert!(
                    (found - expected).abs() < 1e-5 * (1.0 + expected.abs()),
                    "{slip}"
                );
            }
        }
    }
}
