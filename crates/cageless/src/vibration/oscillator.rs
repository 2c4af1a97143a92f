//! The housing: one mass on a spring and a damper.

use crate::case::Housing;

/// A damped oscillator under a force constant over each interval, advanced exactly.
#[derive(Debug, Clone)]
pub(super) struct Oscillator {
    mass: f64,
    stiffness: f64,
    damping: f64,
    /// exp(A h) of d(x, v)/dt = A (x, v) about the static deflection.
    propagator: [[f64; 2]; 2],
    state: [f64; 2],
}

impl Oscillator {
    /// Oscillator at rest under `force`.
    pub(super) fn new(housing: &Housing, h: f64, force: f64) -> Self {
        let (m, k, c) = (
            housing.mass_kg,
            housing.stiffness_n_m,
            housing.damping_n_s_m,
        );
        Self {
            mass: m,
            stiffness: k,
            damping: c,
            propagator: exponential([[0.0, h], [-k / m * h, -c / m * h]]),
            state: [force / k, 0.0],
        }
    }

    /// Advances one interval; returns the acceleration at its end.
    pub(super) fn push(&mut self, force: f64) -> f64 {
        let rest = force / self.stiffness;
        let [[a, b], [c, d]] = self.propagator;
        let (x, v) = (self.state[0] - rest, self.state[1]);
        self.state = [rest + a * x + b * v, c * x + d * v];
        (force - self.stiffness * self.state[0] - self.damping * self.state[1]) / self.mass
    }
}

/// Matrix exponential by scaling and squaring of its Taylor series.
fn exponential(matrix: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let multiply = |p: [[f64; 2]; 2], q: [[f64; 2]; 2]| {
        let mut r = [[0.0; 2]; 2];
        for i in 0..2 {
            for j in 0..2 {
                r[i][j] = p[i][0] * q[0][j] + p[i][1] * q[1][j];
            }
        }
        r
    };
    let size = matrix.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    let squarings = if size > 0.1 {
        (size / 0.1).log2().ceil() as i32
    } else {
        0
    };
    let small = matrix.map(|row| row.map(|x| x / 2f64.powi(squarings)));
    let mut sum = [[1.0, 0.0], [0.0, 1.0]];
    let mut term = sum;
    for k in 1..=14 {
        term = multiply(term, small).map(|row| row.map(|x| x / f64::from(k)));
        for i in 0..2 {
            for j in 0..2 {
                sum[i][j] += term[i][j];
            }
        }
    }
    for _ in 0..squarings {
        sum = multiply(sum, sum);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steady state of the driven oscillator: |a| = F ω²/√((k − mω²)² + (cω)²).
    #[test]
    fn housing_follows_the_closed_form() {
        let housing = Housing {
            mass_kg: 1.0,
            stiffness_n_m: 1e7,
            damping_n_s_m: 500.0,
        };
        let h = 1e-6;
        let omega = 2000.0;
        let mut o = Oscillator::new(&housing, h, 0.0);
        let mut largest = 0.0f64;
        for k in 0..200_000 {
            let a = o.push((omega * (k as f64 + 0.5) * h).sin());
            if k > 100_000 {
                largest = largest.max(a.abs());
            }
        }
        let expected =
            omega * omega / ((1e7 - omega * omega).powi(2) + (500.0f64 * omega).powi(2)).sqrt();
        assert!(
            (largest / expected - 1.0).abs() < 1e-3,
            "{largest} {expected}"
        );
    }
}
