//! Cubic B-splines through given points.
//!
//! The breakpoints of a spline are its interpolation sites; the knots are the sites with
//! the first and the last four times over, so n + 1 sites go with n + 3 control points.
//!
//! ```
//! use cageless::numerics::Vec3;
//!
//! let point: Vec3 = [0.0, 0.0, 1.0];
//! assert_eq!(point.len(), 3);
//! ```

/// A point or a vector.
pub type Vec3 = [f64; 3];

/// Control points of the C² cubic through `values` at ascending `sites` with the given
/// derivatives at the first and the last site (de Boor 1978, chapter XIII).
pub(crate) fn interpolate(sites: &[f64], values: &[Vec3], end_slopes: [Vec3; 2]) -> Vec<Vec3> {
    let n = sites.len() - 1;
    let mut control = vec![[0.0; 3]; n + 3];
    let (first, last) = ((sites[1] - sites[0]) / 3.0, (sites[n] - sites[n - 1]) / 3.0);
    control[0] = values[0];
    control[n + 2] = values[n];
    for c in 0..3 {
        control[1][c] = values[0][c] + first * end_slopes[0][c];
        control[n + 1][c] = values[n][c] - last * end_slopes[1][c];
    }
    // At an interior site three basis functions differ from 0; forward elimination.
    let mut above = vec![0.0; n + 3];
    for i in 1..n {
        let [b0, b1, b2, _] = basis(sites, i, sites[i]);
        let pivot = b1 - b0 * above[i];
        above[i + 1] = b2 / pivot;
        for c in 0..3 {
            control[i + 1][c] = (values[i][c] - b0 * control[i][c]) / pivot;
        }
    }
    for i in (1..n).rev() {
        for c in 0..3 {
            control[i + 1][c] -= above[i + 1] * control[i + 2][c];
        }
    }
    control
}

/// Index of the interval between sites that holds `x`.
pub(crate) fn interval(sites: &[f64], x: f64) -> usize {
    sites[1..sites.len() - 1].partition_point(|&s| s <= x)
}

/// The four basis functions that differ from 0 in `interval`, at `x`; they belong to the
/// control points `interval` to `interval + 3` (Piegl & Tiller 1997, algorithm A2.2).
pub(crate) fn basis(sites: &[f64], interval: usize, x: f64) -> [f64; 4] {
    let last = sites.len() as isize - 1;
    let knot = |k: isize| sites[(interval as isize + k).clamp(0, last) as usize];
    let mut values = [1.0, 0.0, 0.0, 0.0];
    for degree in 1..4 {
        let mut carried = 0.0;
        for r in 0..degree {
            let right = knot(r as isize + 1) - x;
            let left = x - knot(1 - degree as isize + r as isize);
            let fraction = values[r] / (right + left);
            values[r] = carried + right * fraction;
            carried = left * fraction;
        }
        values[degree] = carried;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cubic is its own interpolant, whatever the sites.
    #[test]
    fn reproduces_a_cubic() {
        let f = |x: f64| [x * x * x - x, 2.0 * x * x + 1.0, 0.5 - x];
        let slope = |x: f64| [3.0 * x * x - 1.0, 4.0 * x, -1.0];
        let sites = [-1.0, -0.7, 0.1, 0.2, 1.3];
        let control = interpolate(&sites, &sites.map(f), [slope(sites[0]), slope(sites[4])]);
        assert_eq!(control.len(), 7);
        for k in 0..=100 {
            let x = -1.0 + 2.3 * f64::from(k) / 100.0;
            let i = interval(&sites, x);
            let b = basis(&sites, i, x);
            assert!((b.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            for c in 0..3 {
                let value: f64 = (0..4).map(|j| b[j] * control[i + j][c]).sum();
                assert!((value - f(x)[c]).abs() < 1e-13, "{x} {c}");
            }
        }
    }

    /// Fourth order on a function that is none.
    #[test]
    fn converges_with_the_fourth_order() {
        let error = |n: usize| {
            let sites: Vec<f64> = (0..=n).map(|k| k as f64 / n as f64).collect();
            let values: Vec<Vec3> = sites.iter().map(|x| [x.exp(), 0.0, 0.0]).collect();
            let ends = [[1.0, 0.0, 0.0], [1f64.exp(), 0.0, 0.0]];
            let control = interpolate(&sites, &values, ends);
            (0..1000)
                .map(|k| {
                    let x = f64::from(k) / 1000.0;
                    let i = interval(&sites, x);
                    let b = basis(&sites, i, x);
                    let value: f64 = (0..4).map(|j| b[j] * control[i + j][0]).sum();
                    (value - x.exp()).abs()
                })
                .fold(0.0, f64::max)
        };
        let order = (error(8) / error(16)).log2();
        assert!((3.8..4.3).contains(&order), "{order}");
    }
}
