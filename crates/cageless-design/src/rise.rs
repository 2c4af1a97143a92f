//! Root of a rising function that costs much.

use std::ops::RangeInclusive;

/// Root of a rising function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rise {
    /// Here, the last point at which it was evaluated.
    At(f64),
    /// Below the range: it is above zero at the low end.
    Below,
    /// Above the range: it is not above zero at the high end.
    Above,
}

/// Root of a rising `f` within a range, to `tolerance` in the argument.
/// For an `f` that costs much, is smooth above its root and of a slope near 1, and tells
/// little of the root's distance below it: Newton's method with the slope between the last
/// points above, bisection where that leads nowhere.
///
/// Values below the root may be small anywhere: one within the tolerance counts as the root
/// only where a slope between two points above led to it.
///
/// # Errors
/// Errors of `f`.
pub(crate) fn try_rise<E>(
    mut f: impl FnMut(f64) -> Result<f64, E>,
    guess: f64,
    range: RangeInclusive<f64>,
    tolerance: f64,
) -> Result<Rise, E> {
    let (low, high) = range.into_inner();
    let mut x = guess.clamp(low, high);
    let (mut above, mut below) = (None::<(f64, f64)>, None::<f64>);
    let mut slope = 1.0;
    let (mut measured, mut led) = (false, false);
    let mut reach = 2e-3 * (high - low);
    let mut was_below = false;
    for _ in 0..200 {
        let value = f(x)?;
        if value > 0.0 && x <= low {
            return Ok(Rise::Below);
        }
        if value <= 0.0 && x >= high {
            return Ok(Rise::Above);
        }
        // Newton's method from below led to another point below.
        let misled = was_below && value <= 0.0;
        was_below = value <= 0.0;
        if value > 0.0 {
            if let Some((right, more)) = above
                && more > value
            {
                slope = (more - value) / (right - x);
                measured = true;
            }
            above = Some((x, value));
        } else {
            below = Some(x);
        }
        let (left, right) = (below.unwrap_or(low), above.map_or(high, |(x, _)| x));
        let near = value.abs() <= slope * tolerance && (value > 0.0 || led);
        // Where nothing was above zero yet, the high end is no bound before it is evaluated.
        if near || above.is_some() && right - left <= tolerance {
            return Ok(Rise::At(x));
        }
        let newton = x - value / slope;
        led = measured && value > 0.0 && newton > left;
        x = if above.is_none() {
            reach *= 2.0;
            (x + reach).min(high)
        } else if newton > left && newton < right && !misled {
            newton
        } else if below.is_none() {
            low
        } else {
            0.5 * (left + right)
        };
    }
    Ok(Rise::At(x))
}

#[cfg(test)]
mod tests {
    use super::{Rise, try_rise};

    /// Smooth above the root, flat or jumping below: what the smallest gap of a pair does.
    #[test]
    fn a_rise_is_found_with_few_evaluations() {
        for root in [0.011, 0.024, 0.0313, 0.0319, 0.05] {
            let mut calls = 0;
            let mut f = |x: f64| {
                calls += 1;
                let d = x - root;
                Ok::<_, ()>(if d > 0.0 {
                    0.9 * d + 8.0 * d * d
                } else {
                    -2e-4 * (-d / (1e-3 - d))
                })
            };
            let Ok(Rise::At(found)) = try_rise(&mut f, 0.0317, 0.0..=0.4, 2e-7) else {
                panic!("no root at {root}");
            };
            assert!((found - root).abs() < 3e-7, "{found} {root}");
            assert!(calls <= 9, "{calls} for {root}");
        }
    }

    /// Touching balls are pressed together by next to nothing, however far below the root: at the
    /// low end, where bisection begins, and at the first guess.
    #[test]
    fn a_small_value_below_is_no_root() {
        for root in [0.0083, 0.0302, 0.0331] {
            let f = |x: f64| {
                let d = x - root;
                Ok::<_, ()>(if d > 0.0 { 2.5 * d } else { -1e-5 })
            };
            let Ok(Rise::At(found)) = try_rise(f, 0.0317, 0.0..=0.4, 2e-5) else {
                panic!("no root at {root}");
            };
            assert!((found - root).abs() < 3e-5, "{found} {root}");
        }
    }

    /// Steps upwards that end just short of the high end, with nothing above zero before it.
    #[test]
    fn the_high_end_is_evaluated_before_it_bounds_the_root() {
        let (high, tolerance) = (1.0, 1e-3);
        // The steps are 0.004, 0.008, and so on: the fifth ends 0.4 tolerances short of the end.
        let guess = 1.0 - 0.4e-3 - 0.002 * (2.0 + 4.0 + 8.0 + 16.0 + 32.0);
        let rise = try_rise(|_| Ok::<_, ()>(-0.5), guess, 0.0..=high, tolerance);
        assert_eq!(rise, Ok(Rise::Above));
    }

    #[test]
    fn a_rise_outside_the_range_is_told() {
        let rise = |at: f64| try_rise(|x| Ok::<_, ()>(x - at), 0.3, 0.0..=1.0, 1e-9);
        assert_eq!(rise(-0.1), Ok(Rise::Below));
        assert_eq!(rise(1.1), Ok(Rise::Above));
        assert!(matches!(rise(0.77), Ok(Rise::At(x)) if (x - 0.77).abs() < 1e-9));
    }
}
