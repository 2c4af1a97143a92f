//! Roots of a function of one variable.
//!
//! ```
//! use cageless::numerics::brent;
//!
//! let root = brent(|x| x * x - 2.0, 0.0, 2.0, 1e-15);
//! assert!((root.unwrap() - 2f64.sqrt()).abs() < 1e-15);
//! ```

/// Root of `f` in the bracket `[a, b]` by Brent's method (Brent 1973, chapter 4),
/// to `tolerance` in the argument.
///
/// Returns `None` if `f` has the same sign at both ends or is not finite there.
pub fn brent(mut f: impl FnMut(f64) -> f64, a: f64, b: f64, tolerance: f64) -> Option<f64> {
    try_brent(|x| Ok::<_, std::convert::Infallible>(f(x)), a, b, tolerance).unwrap_or(None)
}

/// The last place on the way from `good`, where `holds`, to `bad`, where it does not, by bisection to
/// `tolerance`.
pub fn last_where(mut good: f64, mut bad: f64, tolerance: f64, holds: impl Fn(f64) -> bool) -> f64 {
    while (bad - good).abs() > tolerance {
        let middle = 0.5 * (good + bad);
        match holds(middle) {
            true => good = middle,
            false => bad = middle,
        }
    }
    good
}

/// [`brent`] for a function that can fail; the first failure ends the search.
///
/// # Errors
/// Errors of `f`.
pub fn try_brent<E>(
    mut f: impl FnMut(f64) -> Result<f64, E>,
    a: f64,
    b: f64,
    tolerance: f64,
) -> Result<Option<f64>, E> {
    let mut at = |x: f64| Ok(Sample { x, value: f(x)? });
    let (mut a, mut b) = (at(a)?, at(b)?);
    // NaN fails all comparisons.
    if !((a.value <= 0.0 && b.value >= 0.0) || (a.value >= 0.0 && b.value <= 0.0)) {
        return Ok(None);
    }
    let mut c = a;
    let mut d = b.x - a.x;
    let mut e = d;
    for _ in 0..200 {
        if b.value * c.value > 0.0 {
            c = a;
            d = b.x - a.x;
            e = d;
        }
        if c.value.abs() < b.value.abs() {
            (a, b, c) = (b, c, b);
        }
        let tol = 2.0 * f64::EPSILON * b.x.abs() + 0.5 * tolerance;
        let m = 0.5 * (c.x - b.x);
        if m.abs() <= tol || b.value == 0.0 {
            return Ok(Some(b.x));
        }
        if e.abs() < tol || a.value.abs() <= b.value.abs() {
            d = m;
            e = m;
        } else {
            let (p, q) = interpolated(a, b, c);
            if 2.0 * p < (3.0 * m * q - (tol * q).abs()).min((e * q).abs()) {
                e = d;
                d = p / q;
            } else {
                d = m;
                e = m;
            }
        }
        a = b;
        b = at(b.x + if d.abs() > tol { d } else { tol.copysign(m) })?;
    }
    Ok(Some(b.x))
}

/// A place and the value of a function there.
#[derive(Debug, Clone, Copy)]
struct Sample {
    x: f64,
    value: f64,
}

/// Step p/q from `b` to the root of the line through `a` and `b`, or of the inverse parabola through all three; p is 0
/// or more.
fn interpolated(a: Sample, b: Sample, c: Sample) -> (f64, f64) {
    let m = 0.5 * (c.x - b.x);
    let s = b.value / a.value;
    let (p, q) = if a.x == c.x {
        (2.0 * m * s, 1.0 - s)
    } else {
        let (q, r) = (a.value / c.value, b.value / c.value);
        (
            s * (2.0 * m * q * (q - r) - (b.x - a.x) * (r - 1.0)),
            (q - 1.0) * (r - 1.0) * (s - 1.0),
        )
    };
    (p.abs(), if p > 0.0 { -q } else { q })
}

#[cfg(test)]
mod tests {
    use super::{brent, last_where};

    #[test]
    fn finds_the_root_of_a_cubic() {
        let root = brent(|x| x * x * x - 2.0, 0.0, 2.0, 1e-15).unwrap();
        assert!((root - 2f64.cbrt()).abs() < 1e-14);
    }

    #[test]
    fn what_holds_ends_at_its_edge_from_either_side() {
        let up = last_where(1.0, 2.0, 1e-12, |x| x * x < 2.0);
        let down = last_where(2.0, 1.0, 1e-12, |x| x * x > 2.0);
        assert!(up * up < 2.0 && 2.0 < down * down);
        assert!((0.0..2e-12).contains(&(down - up)));
    }

    #[test]
    fn refuses_an_interval_without_sign_change() {
        assert_eq!(brent(|x| x * x + 1.0, -1.0, 1.0, 1e-12), None);
        assert_eq!(brent(|_| f64::NAN, -1.0, 1.0, 1e-12), None);
    }
}
