//! Inverse roots as expressions without branches, the same bits on every instruction set.

/// 2⁵²: numbers below it are the low bits of the mantissa of the sum.
const SHIFT: f64 = 4_503_599_627_370_496.0;
/// Adding it leaves the nearest integer in the low bits of the mantissa.
const ROUND: f64 = 6_755_399_441_055_744.0;
const BIAS: u64 = 1023;
const MANTISSA: u64 = (1 << 52) - 1;

/// x^(−share) with a relative error below 2e-5: 2^(−share log₂ x) by short polynomials.
#[inline(always)]
fn estimate(x: f64, share: f64) -> f64 {
    let bits = x.to_bits();
    let exponent = f64::from_bits((bits >> 52) | SHIFT.to_bits()) - (SHIFT + BIAS as f64);
    let m = f64::from_bits((bits & MANTISSA) | (BIAS << 52)) - 1.5;
    let square = m * m;
    let logarithm = (0.584_950_762_749_590_7 + 0.961_803_433_666_309_2 * m)
        + square
            * ((-0.319_757_710_731_619_5 + 0.142_005_483_998_225_5 * m)
                + square * (-0.079_976_210_109_998_4 + 0.043_004_957_791_827_3 * m));
    let power = -share * (exponent + logarithm);
    let shifted = power + ROUND;
    let f = power - (shifted - ROUND);
    let square = f * f;
    let part = (1.0 + 0.693_121_045_203_426_3 * f)
        + square
            * ((0.240_223_490_380_204_66 + 0.055_921_975_842_26 * f)
                + square * 0.009_666_368_515_379_987);
    part * f64::from_bits(shifted.to_bits().wrapping_add(BIAS) << 52)
}

/// x^(−1/3), relative error below 1e-15; a finite number for x = 0.
#[inline(always)]
pub(crate) fn inverse_cube_root(x: f64) -> f64 {
    let y = estimate(x, 1.0 / 3.0);
    // (1 − r)^(−1/3) with r = 1 − x y³.
    let r = 1.0 - x * y * (y * y);
    y + y * r * (1.0 / 3.0 + r * (2.0 / 9.0 + r * (14.0 / 81.0)))
}

/// x^(−1/24), relative error below 2e-14, of normal numbers.
#[inline(always)]
pub(crate) fn inverse_root_24(x: f64) -> f64 {
    let y = estimate(x, 1.0 / 24.0);
    let square = y * y;
    let fourth = square * square;
    let eighth = fourth * fourth;
    let r = 1.0 - x * eighth * (eighth * eighth);
    y + y * r * (1.0 / 24.0 + r * (25.0 / 1152.0 + r * (1225.0 / 82_944.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_follow_the_standard_library() {
        for k in -4000..=4000 {
            let x = (f64::from(k) * 0.01).exp();
            let cube = inverse_cube_root(x) * x.cbrt() - 1.0;
            assert!(cube.abs() < 2e-15, "{x}: {cube:e}");
            let other = inverse_root_24(x) * x.powf(1.0 / 24.0) - 1.0;
            assert!(other.abs() < 2e-14, "{x}: {other:e}");
        }
        assert_eq!(0.0 * inverse_cube_root(0.0).powi(2), 0.0);
    }
}
