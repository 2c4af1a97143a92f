//! Polynomials fitted at Chebyshev nodes.

use std::f64::consts::PI;

/// A polynomial on [lo, hi], kept as powers of u = 2(x − lo)/(hi − lo) − 1 so that
/// Horner's rule evaluates it without the cancellation of powers of x.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Polynomial {
    /// c₀ … c_d of Σ c_k u^k.
    pub coefficients: Vec<f64>,
    /// u = scale·x + shift.
    pub scale: f64,
    /// u = scale·x + shift.
    pub shift: f64,
}

impl Polynomial {
    /// Interpolates `f` on [lo, hi] with the lowest of a few degrees whose last Chebyshev
    /// coefficients are below `tolerance`, or the highest. A tolerance below the rounding
    /// of `f` only costs: high degrees amplify it. The ends themselves are not
    /// evaluated.
    pub(crate) fn fit(f: impl Fn(f64) -> f64, lo: f64, hi: f64, tolerance: f64) -> Self {
        let mut chebyshev = vec![];
        for degree in [14, 19, 24, 32, 40] {
            chebyshev = coefficients(&f, lo, hi, degree);
            if chebyshev[degree - 1..].iter().all(|c| c.abs() <= tolerance) {
                break;
            }
        }
        Self {
            coefficients: to_powers(&chebyshev),
            scale: 2.0 / (hi - lo),
            shift: -(hi + lo) / (hi - lo),
        }
    }

    /// Interpolates `f` on [lo, hi] with this degree; the ends themselves are not evaluated.
    pub(crate) fn of_degree(f: impl Fn(f64) -> f64, lo: f64, hi: f64, degree: usize) -> Self {
        Self {
            coefficients: to_powers(&coefficients(&f, lo, hi, degree)),
            scale: 2.0 / (hi - lo),
            shift: -(hi + lo) / (hi - lo),
        }
    }

    /// Value at `x`.
    pub(crate) fn value(&self, x: f64) -> f64 {
        let u = self.scale * x + self.shift;
        self.coefficients
            .iter()
            .rev()
            .fold(0.0, |sum, c| sum * u + c)
    }

    /// Value and slope at `x`.
    pub(crate) fn value_and_slope(&self, x: f64) -> [f64; 2] {
        let u = self.scale * x + self.shift;
        let mut both = [0.0; 2];
        for c in self.coefficients.iter().rev() {
            both = [both[0] * u + c, both[1] * u + both[0]];
        }
        [both[0], both[1] * self.scale]
    }
}

/// Chebyshev coefficients of the interpolant at the `degree + 1` Chebyshev nodes.
fn coefficients(f: &impl Fn(f64) -> f64, lo: f64, hi: f64, degree: usize) -> Vec<f64> {
    let n = degree + 1;
    let node = |k: usize| PI * (k as f64 + 0.5) / n as f64;
    let values: Vec<f64> = (0..n)
        .map(|k| f(lo + (hi - lo) * (node(k).cos() + 1.0) / 2.0))
        .collect();
    (0..n)
        .map(|j| {
            let sum: f64 = values
                .iter()
                .enumerate()
                .map(|(k, v)| v * (j as f64 * node(k)).cos())
                .sum();
            sum * if j == 0 { 1.0 } else { 2.0 } / n as f64
        })
        .collect()
}

/// Σ a_j T_j(u) as powers of u, by T_{j+1} = 2u T_j − T_{j−1}.
pub(crate) fn to_powers(chebyshev: &[f64]) -> Vec<f64> {
    let n = chebyshev.len();
    let mut powers = vec![0.0; n];
    let mut previous = vec![0.0; n];
    let mut current = vec![0.0; n];
    current[0] = 1.0;
    for (j, a) in chebyshev.iter().enumerate() {
        for (p, c) in powers.iter_mut().zip(&current) {
            *p += a * c;
        }
        let mut next: Vec<f64> = previous.iter().map(|p| -p).collect();
        let factor = if j == 0 { 1.0 } else { 2.0 };
        for k in 1..n {
            next[k] += factor * current[k - 1];
        }
        if j == 0 {
            // T_1 = u has no T_{−1} term.
            next[0] = 0.0;
        }
        previous = std::mem::replace(&mut current, next);
    }
    powers
}

#[cfg(test)]
mod tests {
    use super::Polynomial;

    #[test]
    fn follows_an_analytic_function() {
        let p = Polynomial::fit(f64::exp, -0.5, 0.25, 1e-15);
        for k in 0..=100 {
            let x = -0.5 + 0.0075 * f64::from(k);
            assert!((p.value(x) - x.exp()).abs() < 3e-15, "{x}");
        }
    }
}
