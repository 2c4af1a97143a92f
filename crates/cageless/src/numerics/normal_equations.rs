//! Normal equations of linear least squares whose number of unknowns is known at run time.

/// JᵀWJ x = −JᵀW ε of errors ε with slopes J over the unknowns and weights W.
#[derive(Debug, Clone)]
pub(crate) struct NormalEquations {
    /// Lower half, row by row.
    matrix: Vec<Vec<f64>>,
    right: Vec<f64>,
}

/// Factors L D Lᵀ.
struct Factors {
    lower: Vec<Vec<f64>>,
    diagonal: Vec<f64>,
}

/// A pivot below this part of its diagonal element is rounding.
const PIVOT_MIN: f64 = 1e-12;

impl NormalEquations {
    pub(crate) fn new(unknowns: usize) -> Self {
        Self {
            matrix: vec![vec![0.0; unknowns]; unknowns],
            right: vec![0.0; unknowns],
        }
    }

    /// Adds an error with its weight and its slopes over some of the unknowns.
    pub(crate) fn add(
        &mut self,
        slopes: impl Iterator<Item = (usize, f64)> + Clone,
        error: f64,
        weight: f64,
    ) {
        for (i, slope) in slopes.clone() {
            self.right[i] -= weight * slope * error;
            for (j, other) in slopes.clone().filter(|(j, _)| *j <= i) {
                self.matrix[i][j] += weight * slope * other;
            }
        }
    }

    /// Solution and inverse of JᵀWJ, with those unknowns 0 that are held; `None` if errors leave another open.
    pub(crate) fn solve(&self, held: &[bool]) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
        let free: Vec<usize> = (0..self.right.len()).filter(|k| !held[*k]).collect();
        let factors = self.factors(&free)?;
        let spread = |part: Vec<f64>| {
            let mut all = vec![0.0; self.right.len()];
            free.iter().zip(part).for_each(|(k, value)| all[*k] = value);
            all
        };
        let right = free.iter().map(|k| self.right[*k]).collect();
        let mut inverse = vec![vec![0.0; self.right.len()]; self.right.len()];
        for (row, k) in free.iter().enumerate() {
            let mut unit = vec![0.0; free.len()];
            unit[row] = 1.0;
            inverse[*k] = spread(factors.solved(unit));
        }
        Some((spread(factors.solved(right)), inverse))
    }

    fn factors(&self, free: &[usize]) -> Option<Factors> {
        let size = free.len();
        let mut lower = vec![vec![0.0; size]; size];
        let mut diagonal = vec![0.0; size];
        for j in 0..size {
            let element = self.matrix[free[j]][free[j]];
            let sum = |row: &[f64], other: &[f64], d: &[f64]| -> f64 {
                (0..j).map(|k| row[k] * other[k] * d[k]).sum()
            };
            let pivot = element - sum(&lower[j], &lower[j], &diagonal);
            if !(pivot > PIVOT_MIN * element) {
                return None;
            }
            diagonal[j] = pivot;
            for i in j + 1..size {
                let entry = self.matrix[free[i]][free[j]] - sum(&lower[i], &lower[j], &diagonal);
                lower[i][j] = entry / pivot;
            }
        }
        Some(Factors { lower, diagonal })
    }
}

impl Factors {
    fn solved(&self, mut x: Vec<f64>) -> Vec<f64> {
        let size = x.len();
        for i in 0..size {
            x[i] -= (0..i).map(|k| self.lower[i][k] * x[k]).sum::<f64>();
        }
        for i in (0..size).rev() {
            x[i] /= self.diagonal[i];
            x[i] -= (i + 1..size).map(|k| self.lower[k][i] * x[k]).sum::<f64>();
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::NormalEquations;

    /// A line through three points: y = 1 + 2 x by hand, and its inverse of [[3, 3], [3, 5]]; with the slope held, the
    /// mean.
    #[test]
    fn a_line_is_fitted() {
        let mut equations = NormalEquations::new(2);
        for (x, y) in [(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)] {
            let slopes = [(0, 1.0), (1, x)];
            equations.add(slopes.into_iter(), -y, 1.0);
        }
        let (line, inverse) = equations.solve(&[false, false]).unwrap();
        let close =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12, "{found}");
        close(line[0], 1.0);
        close(line[1], 2.0);
        for (row, expected) in inverse.iter().zip([[5.0 / 6.0, -0.5], [-0.5, 0.5]]) {
            row.iter().zip(expected).for_each(|(f, e)| close(*f, e));
        }
        let (held, inverse) = equations.solve(&[false, true]).unwrap();
        close(held[0], 3.0);
        close(held[1], 0.0);
        close(inverse[0][0], 1.0 / 3.0);
        assert!(NormalEquations::new(1).solve(&[false]).is_none());
    }
}
