//! Flanks by a spline through given angles.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use super::flank_angle::{FlankAngle, Flanks};
use crate::error::InputError;

/// Fewest and most rows: end slopes take four, and each row is a stretch of its own.
const ROWS: [usize; 2] = [5, 30];
/// Places between two rows at which αc must not rise.
const PLACES: i32 = 16;

/// αc over ψ² as a cubic spline through rows of ψ and αc: even, and free of jumps up to the second derivative,
/// which that of the friction demand follows. The slopes at both ends are those of the cubics through the four rows there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SplineFlanks {
    /// α0.
    middle_rad: f64,
    /// θ.
    half_angle_rad: f64,
    /// Number of rows.
    count: usize,
    /// (ψ/θ)², αc/α0 and its slope over (ψ/θ)² in the rows.
    knots: [[f64; 3]; ROWS[1]],
}

impl SplineFlanks {
    /// Flanks through rows of ψ and αc, both in rad, from the middle of the raceway, ψ = 0, to an end, where
    /// αc = 0.
    ///
    /// # Errors
    /// An [`InputError`] of `profile` if there are fewer than 5 rows or more than 30, an angle is not below 90°, they do not
    /// lead from the middle to an end, or αc does not fall from row to row and between them.
    pub(crate) fn through(rows: &[[f64; 2]]) -> Result<Self, InputError> {
        let refuse = |rule: &str| Err(InputError::rule("profile", f64::NAN, rule));
        let [least, most] = ROWS;
        if !(least..=most).contains(&rows.len()) {
            let rule = format!("{least} to {most} rows of ψ and flank angle for a spline");
            return refuse(&rule);
        }
        if !rows.iter().flatten().all(|a| (0.0..FRAC_PI_2).contains(a)) {
            return refuse(
                "angles from 0° to less than 90° for a spline, of one side of the raceway",
            );
        }
        let (first, last) = (rows[0], rows[rows.len() - 1]);
        if first[0] != 0.0 || last[1] != 0.0 {
            return refuse(
                "rows from the middle of the raceway, ψ = 0, to its end, where the flank angle is 0",
            );
        }
        if !rows
            .windows(2)
            .all(|w| w[0][0] < w[1][0] && w[0][1] > w[1][1])
        {
            return refuse(
                "rows of rising ψ, in each of which the flank angle is less than before",
            );
        }
        let scaled: Vec<_> = rows
            .iter()
            .map(|[psi, angle]| [(psi / last[0]).powi(2), angle / first[1]])
            .collect();
        let mut knots = [[0.0; 3]; ROWS[1]];
        for ((knot, row), slope) in knots.iter_mut().zip(&scaled).zip(slopes(&scaled)) {
            *knot = [row[0], row[1], slope];
        }
        let flanks = Self {
            middle_rad: first[1],
            half_angle_rad: last[0],
            count: rows.len(),
            knots,
        };
        let falls = |pair: &[[f64; 2]]| {
            let place =
                |k| pair[0][0] + (pair[1][0] - pair[0][0]) * f64::from(k) / f64::from(PLACES);
            (0..=PLACES).all(|k| flanks.at(place(k))[1] <= 0.0)
        };
        if !rows.windows(2).all(falls) {
            return refuse(
                "rows between which the spline falls as well; more rows where it bends most keep it from rising",
            );
        }
        Ok(flanks)
    }

    /// The flanks with another α0 and θ than those of the rows.
    pub(super) fn scaled(&self, middle_rad: f64, half_angle_rad: f64) -> Flanks {
        Arc::new(Self {
            middle_rad,
            half_angle_rad,
            ..*self
        })
    }

    /// α0 of the rows.
    pub(crate) fn middle_rad(&self) -> f64 {
        self.middle_rad
    }

    /// θ of the rows.
    pub(crate) fn half_angle_rad(&self) -> f64 {
        self.half_angle_rad
    }
}

impl FlankAngle for SplineFlanks {
    fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        let share = local_angle_rad / self.half_angle_rad;
        let knots = &self.knots[..self.count];
        let above = knots[1..self.count - 1].partition_point(|knot| knot[0] <= share * share);
        let [[from, value, slope], [to, next, next_slope]] = [knots[above], knots[above + 1]];
        // Cubic Hermite: the values meet the rows exactly.
        let (width, t) = (to - from, (share * share - from) / (to - from));
        let rise = next - value;
        let [c2, c3] = [
            3.0 * rise - width * (2.0 * slope + next_slope),
            width * (slope + next_slope) - 2.0 * rise,
        ];
        let angle = match t == 1.0 {
            true => next,
            false => value + t * (width * slope + t * (c2 + t * c3)),
        };
        let slope = slope + t * (2.0 * c2 + t * 3.0 * c3) / width;
        [
            self.middle_rad * angle,
            self.middle_rad * slope * 2.0 * share / self.half_angle_rad,
        ]
    }

    fn junctions_rad(&self) -> Vec<f64> {
        let inner = self.knots[1..self.count - 1].iter();
        inner.map(|k| k[0].sqrt() * self.half_angle_rad).collect()
    }
}

/// Slopes of the cubic spline through rows x, y (de Boor 1978, chapter IV).
fn slopes(rows: &[[f64; 2]]) -> Vec<f64> {
    let last = rows.len() - 1;
    let secant = |k: usize| (rows[k + 1][1] - rows[k][1]) / (rows[k + 1][0] - rows[k][0]);
    let width = |k: usize| rows[k + 1][0] - rows[k][0];
    let ends = [[0, 1, 2, 3], [last, last - 1, last - 2, last - 3]];
    let [first, final_slope] = ends.map(|four| end_slope(four.map(|k| rows[k])));
    // m of k − 1, k and k + 1: forward elimination of a tridiagonal system.
    let mut above = vec![0.0; last + 1];
    let mut slopes = vec![first; last + 1];
    slopes[last] = final_slope;
    for k in 1..last {
        let (before, after) = (width(k - 1), width(k));
        let pivot = 2.0 * (before + after) - after * above[k - 1];
        above[k] = before / pivot;
        let right = 3.0 * (after * secant(k - 1) + before * secant(k));
        slopes[k] = (right - after * slopes[k - 1]) / pivot;
    }
    for k in (1..last).rev() {
        slopes[k] -= above[k] * slopes[k + 1];
    }
    slopes
}

/// Slope in the first of four rows of the cubic through them (Newton's divided differences).
fn end_slope([a, b, c, d]: [[f64; 2]; 4]) -> f64 {
    let first = |p: [f64; 2], q: [f64; 2]| (q[1] - p[1]) / (q[0] - p[0]);
    let second = |p, q, r: [f64; 2]| (first(q, r) - first(p, q)) / (r[0] - p[0]);
    let third = (second(b, c, d) - second(a, b, c)) / (d[0] - a[0]);
    first(a, b) + (a[0] - b[0]) * (second(a, b, c) + (a[0] - c[0]) * third)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Slopes at both ends of a spline are those of cubics, so that a spline through a cubic is that cubic.
    #[test]
    fn a_spline_through_a_cubic_is_the_cubic() {
        let (middle, half_angle): (f64, f64) = (0.5, 0.44);
        let cubic = |s: f64| middle * (1.0 - s) * (1.0 + 0.3 * s + 0.2 * s * s);
        let slope = |s: f64| middle * (-0.7 - 0.2 * s - 0.6 * s * s);
        let places = [0.0, 0.3, 0.5, 0.6, 0.75, 0.9, 1.0];
        let rows = places.map(|share: f64| [share * half_angle, cubic(share * share)]);
        let flanks = SplineFlanks::through(&rows).unwrap();
        for k in -50..=50 {
            let share = f64::from(k) / 50.0;
            let [angle, rate] = flanks.at(share * half_angle);
            let square = share * share;
            assert!((angle - cubic(square)).abs() < 1e-14, "{share}");
            let expected = slope(square) * 2.0 * share / half_angle;
            assert!((rate - expected).abs() < 1e-12, "{share} {rate} {expected}");
        }
    }
}
