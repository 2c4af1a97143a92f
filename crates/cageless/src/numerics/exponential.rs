//! tanh, exp, ln and arsinh as expressions without branches, the same bits on every instruction set.

/// ln 2 split so that k·LN2_HI is exact.
const LN2_HI: f64 = 0.693_147_180_369_123_8;
const LN2_LO: f64 = 1.908_214_929_270_587_7e-10;

/// tanh, the same bits on every instruction set, absolute error below 4e-16: one
/// expression without branches, so that a loop over it becomes vector code.
///
/// tanh |x| = (1 − q)/(1 + q) with q = exp(−2|x|).
#[inline(always)]
pub(crate) fn tanh(x: f64) -> f64 {
    let q = exponential((-2.0 * x.abs()).max(-80.0));
    ((1.0 - q) / (1.0 + q)).copysign(x)
}

/// [`tanh`] of two numbers with one division for both, absolute error below 1e-15.
#[inline(always)]
pub(crate) fn tanh_pair([x, y]: [f64; 2]) -> [f64; 2] {
    let p = exponential((-2.0 * x.abs()).max(-80.0));
    let q = exponential((-2.0 * y.abs()).max(-80.0));
    let inverse = 1.0 / ((1.0 + p) * (1.0 + q));
    [
        ((1.0 - p) * ((1.0 + q) * inverse)).copysign(x),
        ((1.0 - q) * ((1.0 + p) * inverse)).copysign(y),
    ]
}

/// exp for −700 ≤ x ≤ 700: x = k ln 2 + f, exp x = 2^k · exp f with the Taylor series
/// of exp to f¹³ (|f| ≤ ln 2/2: remainder below 5e-18).
#[inline(always)]
pub(crate) fn exponential(x: f64) -> f64 {
    /// Adding it leaves the nearest integer in the low bits of the mantissa.
    const ROUND: f64 = 6_755_399_441_055_744.0;
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

/// ln x of normal numbers, absolute error below 1e-15 near 1: x = 2^k m with m between √½ and √2,
/// ln m = 2 artanh s of s = (m − 1)/(m + 1), |s| < 0.172, by its series to s¹⁹.
#[inline(always)]
pub(crate) fn logarithm(x: f64) -> f64 {
    /// Bits by which those of √½ miss the next exponent.
    const TO_NEXT: u64 = (1 << 52) - 0x6_a09e_667f_3bcd;
    /// 2⁵²: numbers below it are the low bits of the mantissa of the sum.
    const SHIFT: f64 = 4_503_599_627_370_496.0;
    const BIAS: u64 = 1023;
    let bits = x.to_bits();
    let biased = bits.wrapping_add(TO_NEXT) >> 52;
    let m = f64::from_bits(bits.wrapping_sub(biased.wrapping_sub(BIAS) << 52));
    let k = f64::from_bits(biased | SHIFT.to_bits()) - (SHIFT + BIAS as f64);
    let s = (m - 1.0) / (m + 1.0);
    let square = s * s;
    let fourth = square * square;
    // Even and odd powers of s², which do not wait for each other.
    let (mut even, mut odd) = (2.0 / 17.0, 2.0 / 19.0);
    for [c0, c1] in [
        [2.0 / 13.0, 2.0 / 15.0],
        [2.0 / 9.0, 2.0 / 11.0],
        [2.0 / 5.0, 2.0 / 7.0],
        [2.0, 2.0 / 3.0],
    ] {
        even = even * fourth + c0;
        odd = odd * fourth + c1;
    }
    k * LN2_HI + (s * (even + odd * square) + k * LN2_LO)
}

/// arsinh x, absolute error below 2e-15, and √(1 + x²); |x| up to 1e150.
#[inline(always)]
pub(crate) fn arsinh_and_root(x: f64) -> [f64; 2] {
    let root = (x * x + 1.0).sqrt();
    [logarithm(x.abs() + root).copysign(x), root]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_others_follow_the_standard_library() {
        for k in -20_000..=20_000 {
            let x = f64::from(k) * 0.035;
            let relative = exponential(x) / x.exp() - 1.0;
            assert!(relative.abs() < 4e-14, "{x}: {relative:e}");
            let error = logarithm(x.exp()) - x;
            assert!(error.abs() < 2e-15 + 2e-16 * x.abs(), "{x}: {error:e}");
            let near_1 = (0.01 * x.tanh()).exp();
            let error = logarithm(near_1) - near_1.ln();
            assert!(error.abs() < 4e-16, "{near_1}: {error:e}");
            let large = x * x * x;
            let [found, root] = arsinh_and_root(large);
            let error = found - large.asinh();
            assert!(error.abs() < 1e-14, "{large}: {error:e}");
            assert_eq!(root, (large * large + 1.0).sqrt());
        }
        assert_eq!(logarithm(1.0), 0.0);
        assert_eq!(arsinh_and_root(0.0), [0.0, 1.0]);
    }

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
