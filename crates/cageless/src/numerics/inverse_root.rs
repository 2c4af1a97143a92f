//! Inverse roots as expressions without branches, the same bits on every instruction set.

/// 2⁵²: numbers below it are the low bits of the mantissa of the sum.
const SHIFT: f64 = 4_503_599_627_370_496.0;
const BIAS: u64 = 1023;
const MANTISSA: u64 = (1 << 52) - 1;
/// Bits of x^(−1/3) plus a third of those of x, within 3.4 % of x^(−1/3), without the last [`DROPPED`].
const CUBE_ROOT_BITS: f64 = 1_499_659_093_495_775.0;
/// Low bits that a first approximation has no use for.
const DROPPED: u32 = 12;

/// x^(−1/3), relative error below 1e-7; a finite number for x = 0.
#[inline(always)]
pub(crate) fn inverse_cube_root(x: f64) -> f64 {
    let bits = f64::from_bits((x.to_bits() >> DROPPED) | SHIFT.to_bits()) - SHIFT;
    let third = (CUBE_ROOT_BITS - bits * (1.0 / 3.0)) + SHIFT;
    let y = f64::from_bits(third.to_bits() << DROPPED);
    // (1 − r)^(−1/3) with r = 1 − x y³ between ±0.103.
    let r = 1.0 - x * y * (y * y);
    let square = r * r;
    let part = (1.000_000_004_782_002 + 0.333_329_052_726_767_44 * r)
        + square
            * ((0.222_214_815_153_115_45 + 0.174_478_843_189_229_65 * r)
                + square * 0.145_829_285_040_695_26);
    y * part
}

/// log₂ x within 1e-4, of normal numbers.
#[inline(always)]
pub(crate) fn binary_logarithm(x: f64) -> f64 {
    let bits = x.to_bits();
    let exponent = f64::from_bits((bits >> 52) | SHIFT.to_bits()) - (SHIFT + BIAS as f64);
    let m = f64::from_bits((bits & MANTISSA) | (BIAS << 52)) - 1.5;
    let square = m * m;
    exponent
        + ((0.584_937_965_923_078_3 + 0.960_962_886_325_554 * m)
            + square
                * ((-0.319_347_924_968_590_6 + 0.155_447_920_919_060_84 * m)
                    + square * -0.081_615_745_874_140_42))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_follow_the_standard_library() {
        for k in -4000..=4000 {
            let x = (f64::from(k) * 0.01).exp();
            let cube = inverse_cube_root(x) * x.cbrt() - 1.0;
            assert!(cube.abs() < 1e-7, "{x}: {cube:e}");
            let logarithm = binary_logarithm(x) - x.log2();
            assert!(logarithm.abs() < 1e-4, "{x}: {logarithm:e}");
        }
        assert_eq!(0.0 * inverse_cube_root(0.0).powi(2), 0.0);
    }
}
