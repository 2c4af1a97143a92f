//! tanh and exp as expressions without branches.

/// tanh, the same bits on every instruction set, absolute error below 4e-16: one
/// expression without branches, so that a loop over it becomes vector code.
///
/// tanh |x| = (1 − q)/(1 + q) with q = exp(−2|x|).
#[inline(always)]
pub(crate) fn tanh(x: f64) -> f64 {
    let q = exp_negative((-2.0 * x.abs()).max(-80.0));
    ((1.0 - q) / (1.0 + q)).copysign(x)
}

/// [`tanh`] of two numbers with one division for both, absolute error below 1e-15.
#[inline(always)]
pub(super) fn tanh_pair([x, y]: [f64; 2]) -> [f64; 2] {
    let p = exp_negative((-2.0 * x.abs()).max(-80.0));
    let q = exp_negative((-2.0 * y.abs()).max(-80.0));
    let inverse = 1.0 / ((1.0 + p) * (1.0 + q));
    [
        ((1.0 - p) * ((1.0 + q) * inverse)).copysign(x),
        ((1.0 - q) * ((1.0 + p) * inverse)).copysign(y),
    ]
}

/// exp for −80 ≤ x ≤ 0: x = k ln 2 + f, exp x = 2^k · exp f with the Taylor series
/// of exp to f¹³ (|f| ≤ ln 2/2: remainder below 5e-18).
#[inline(always)]
pub(super) fn exp_negative(x: f64) -> f64 {
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
            let [first, second] = tanh_pair([x, 0.3 - x]);
            assert!((first - x.tanh()).abs() < 1e-15, "{x}");
            assert!((second - (0.3 - x).tanh()).abs() < 1e-15, "{x}");
        }
        assert_eq!(tanh(0.0), 0.0);
        assert_eq!(tanh(1e9), 1.0);
        assert_eq!(tanh(-1e9), -1.0);
    }
}
