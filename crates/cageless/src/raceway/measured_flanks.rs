//! Flank angles of a ring that has been measured.
//!
//! ```
//! use cageless::raceway::MeasuredFlanks;
//!
//! // A shuttle of 20° in its middle and a half angle of 25°, measured from the middle to an end.
//! let angle = |psi: f64| 20.0 * (1.0 - (psi / 25.0).powi(2));
//! let rows: Vec<_> = (0..=10).map(|k| 2.5 * f64::from(k)).collect();
//! let rows: Vec<_> = rows.iter().map(|psi| [psi.to_radians(), angle(*psi).to_radians()]).collect();
//! let flanks = MeasuredFlanks::fit(&rows)?;
//! assert!((flanks.middle_rad().to_degrees() - 20.0).abs() < 1e-9);
//! assert!(flanks.deviation_rad[1] < 1e-9);
//! # Ok::<(), cageless::InputError>(())
//! ```

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use super::flank_angle::Flanks;
use super::power_angle::{PowerAngle, TERMS_MAX};
use crate::error::InputError;
use crate::numerics::chebyshev::to_powers;
use crate::numerics::cholesky;

/// Fewest and most points.
const POINTS: [usize; 2] = [5, 20_000];
/// Powers of 1 − (ψ/θ)² with which αc may run out: at a right angle to the plain raceway, or at a
/// slope.
const EXPONENTS: [f64; 2] = [0.5, 1.0];
/// Places over half a raceway at which a fit must not rise.
const PLACES: i32 = 200;
/// Rounds of linearised least squares, and α0 before the first, rad.
const ROUNDS: usize = 6;
const START_RAD: f64 = 0.3;
/// Largest root-mean-square deviation, in parts of α0.
const DEVIATION_MAX: f64 = 0.1;

/// αc over ψ fitted to points by least squares: αc = (1 − u²)ⁿ P(u²) with u = ψ/θ, n = ½ or 1 and P of up
/// to 7 terms. Among those that fall steadily from the middle to the ends, n and number of terms are
/// chosen by generalised cross-validation (Craven & Wahba 1979, Numerische Mathematik 31, 377–403).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredFlanks {
    flanks: PowerAngle,
    /// Root mean square and largest deviation of the points from the fit.
    pub deviation_rad: [f64; 2],
}

impl MeasuredFlanks {
    /// The flanks with another α0 and θ than measured.
    pub(super) fn scaled(&self, middle_rad: f64, half_angle_rad: f64) -> Flanks {
        Arc::new(self.flanks.scaled(middle_rad, half_angle_rad))
    }

    /// Fit to rows of ψ from the middle of the raceway and αc, both in rad, of one side or both; the
    /// ends ±θ are the rows farthest from the middle and have αc = 0.
    ///
    /// # Errors
    /// An [`InputError`] of `profile` if there are fewer than 5 rows or more than 20 000, the farthest
    /// has another αc than 0, or no function that falls steadily comes near the points.
    pub fn fit(rows: &[[f64; 2]]) -> Result<Self, InputError> {
        let refuse = |value: f64, rule: &str| Err(InputError::rule("profile", value, rule));
        let [least, most] = POINTS;
        if !(least..=most).contains(&rows.len()) {
            let rule = format!("{least} to {most} rows of ψ and flank angle");
            return refuse(rows.len() as f64, &rule);
        }
        let numbers = rows.iter().flatten();
        if let Some(angle) = numbers.clone().find(|angle| !(angle.abs() < FRAC_PI_2)) {
            return refuse(*angle, "angles of less than 90°");
        }
        let theta = rows
            .iter()
            .fold(0.0, |far: f64, [psi, _]| far.max(psi.abs()));
        let ends = rows.iter().filter(|[psi, _]| psi.abs() == theta);
        if theta == 0.0 || ends.clone().any(|[_, angle]| *angle != 0.0) {
            return refuse(
                theta,
                "rows up to an end of the raceway, where the flank angle is 0",
            );
        }
        let linear: Vec<_> = rows
            .iter()
            .map(|[psi, angle]| [*psi, 1.0, *angle])
            .collect();
        match fit_flanks(theta, &|_| linear.clone()) {
            Some((flanks, deviation_rad))
                if deviation_rad[0] <= DEVIATION_MAX * flanks.middle_rad() =>
            {
                Ok(Self {
                    flanks,
                    deviation_rad,
                })
            }
            _ => refuse(
                theta,
                "flank angles that fall steadily from the middle to 0 at the ends",
            ),
        }
    }

    /// α0, the fitted flank angle in the middle.
    pub fn middle_rad(&self) -> f64 {
        self.flanks.middle_rad()
    }

    /// θ of the measurement.
    pub fn half_angle_rad(&self) -> f64 {
        self.flanks.half_angle_rad()
    }

    /// lC of the measurement for balls of this radius.
    #[cfg(test)]
    pub(crate) fn axial_span_m(&self, ball_radius_m: f64) -> f64 {
        2.0 * ball_radius_m * self.middle_rad().sin()
    }
}

/// Rows ψ, a, b of observations whose errors near a flank angle αc are a αc(ψ) − b.
pub(crate) type Linearised = Vec<[f64; 3]>;

/// The flanks that fit observations best, with the root mean square and the largest of their errors;
/// `None` if none fall steadily.
pub(crate) fn fit_flanks(
    theta: f64,
    observed: &dyn Fn(&PowerAngle) -> Linearised,
) -> Option<(PowerAngle, [f64; 2])> {
    let fits = EXPONENTS.iter().flat_map(|exponent| {
        (1..=TERMS_MAX).filter_map(|terms| with_terms(theta, observed, *exponent, terms))
    });
    let best = fits.min_by(|(a, ..), (b, ..)| a.total_cmp(b));
    best.map(|(_, flanks, errors)| (flanks, errors))
}

/// The fit of an exponent and a number of terms, after its score, which is lowest for the best.
fn with_terms(
    theta: f64,
    observed: &dyn Fn(&PowerAngle) -> Linearised,
    exponent: f64,
    terms: usize,
) -> Option<(f64, PowerAngle, [f64; 2])> {
    let mut flanks = PowerAngle::new(START_RAD, theta, exponent);
    for _ in 0..ROUNDS {
        let rows = observed(&flanks);
        if terms > rows.len() / 2 {
            return None;
        }
        flanks = flanks.with_polynomial(least_squares(&rows, theta, exponent, terms)?);
    }
    let falls = |k: i32| flanks.at(theta * f64::from(k) / f64::from(PLACES))[1] <= 0.0;
    if !(flanks.middle_rad() > 0.0 && (0..=PLACES).all(falls)) {
        return None;
    }
    let rows = observed(&flanks);
    let errors = rows
        .iter()
        .map(|[psi, a, b]| (a * flanks.at(*psi)[0] - b).abs());
    let squares: f64 = errors.clone().map(|error| error * error).sum();
    let count = rows.len() as f64;
    let deviation = [(squares / count).sqrt(), errors.fold(0.0, f64::max)];
    // Rounding must not choose.
    let scale = rows
        .iter()
        .fold(0.0, |most: f64, [_, a, _]| most.max(a.abs()));
    let rounding = 1e-12 * scale * flanks.middle_rad();
    let score = deviation[0].max(rounding) / (count - terms as f64);
    Some((score, flanks, deviation))
}

/// Polynomial P in ascending powers of 2 u² − 1 with the least squares of the errors.
fn least_squares(
    rows: &[[f64; 3]],
    theta: f64,
    exponent: f64,
    terms: usize,
) -> Option<[f64; TERMS_MAX]> {
    // Of Chebyshev polynomials; those that are not used have a coefficient of 0.
    let mut normal = [[0.0; TERMS_MAX]; TERMS_MAX];
    let mut right = [0.0; TERMS_MAX];
    (terms..TERMS_MAX).for_each(|k| normal[k][k] = 1.0);
    for [psi, a, b] in rows {
        let share = (psi / theta).powi(2);
        let place = 2.0 * share - 1.0;
        let scale = a * (1.0 - share).powf(exponent);
        let mut basis = [0.0; TERMS_MAX];
        [basis[0], basis[1]] = [scale, scale * place];
        for k in 2..terms {
            basis[k] = 2.0 * place * basis[k - 1] - basis[k - 2];
        }
        for i in 0..terms {
            right[i] += basis[i] * b;
            (0..=i).for_each(|j| normal[i][j] += basis[i] * basis[j]);
        }
    }
    to_powers(&cholesky::solve(&normal, 0.0, right)?)
        .try_into()
        .ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of αc = 0.35 (1 − u²) with errors of ±1 mrad in turn but at the end, at 12 places.
    fn noisy() -> Vec<[f64; 2]> {
        let theta = 0.44;
        let row = |k: u32| {
            let u = f64::from(k) / 11.0;
            let error = match k {
                11 => 0.0,
                _ if k.is_multiple_of(2) => 1e-3,
                _ => -1e-3,
            };
            [theta * u, 0.35 * (1.0 - u * u) + error]
        };
        (0..12).map(row).collect()
    }

    /// Generalised cross-validation, RSS n/(n − p)² (Craven & Wahba 1979): p terms of n rows are better only where they lower the
    /// deviation by more than n − p. Errors need no terms.
    #[test]
    fn errors_of_the_rows_do_not_buy_terms() {
        let rows = noisy();
        let linear: Vec<_> = rows
            .iter()
            .map(|[psi, angle]| [*psi, 1.0, *angle])
            .collect();
        let fit = |exponent, terms| with_terms(0.44, &|_| linear.clone(), exponent, terms).unwrap();
        let fits = [1, 2, 3].map(|terms| (terms, fit(1.0, terms)));
        let [(_, (least, one, [deviation, _])), more @ ..] = fits;
        for (terms, (score, _, [other, _])) in more {
            // Least squares of more terms come nearer to the rows.
            assert!(other < deviation, "{terms}: {other} {deviation}");
            let expected = other / deviation * 11.0 / (12.0 - f64::from(terms as u8));
            assert!((score / least / expected - 1.0).abs() < 1e-12, "{terms}");
            assert!(score > least, "{terms}: {score} {least}");
        }
        let found = MeasuredFlanks::fit(&rows).unwrap();
        assert_eq!(found.flanks, one);
        // Errors of ±1 mrad of which one, at the end, is 0.
        let [found, _] = found.deviation_rad;
        assert!(
            (found / (11.0f64 / 12.0).sqrt() / 1e-3 - 1.0).abs() < 0.02,
            "{found}"
        );
    }
}
