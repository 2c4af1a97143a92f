//! Linear equations with a symmetric positive definite matrix.

use crate::numerics::lanes::{LANES, Lanes};

/// x of (H + shift) x = b by the factors L D Lᵀ, of H the lower half; `None` where that is not positive
/// definite.
#[inline(always)]
pub(crate) fn solve<const N: usize>(
    hessian: &[[f64; N]; N],
    shift: f64,
    b: [f64; N],
) -> Option<[f64; N]> {
    let mut l = [[0.0; N]; N];
    let mut inverse = [0.0; N];
    for j in 0..N {
        // L D of the row.
        let mut scaled = [0.0; N];
        let mut pivot = hessian[j][j] + shift;
        for k in 0..j {
            scaled[k] = l[j][k];
            l[j][k] *= inverse[k];
            pivot -= l[j][k] * scaled[k];
        }
        // A pivot that is the rounding of its sum is none.
        if !(pivot > 1e-13 * hessian[j][j].abs()) {
            return None;
        }
        inverse[j] = 1.0 / pivot;
        for i in j + 1..N {
            let mut entry = hessian[i][j];
            for k in 0..j {
                entry -= l[i][k] * l[j][k];
            }
            l[i][j] = entry;
        }
    }
    let mut x = b;
    for i in 0..N {
        for k in 0..i {
            x[i] -= l[i][k] * x[k];
        }
    }
    for i in (0..N).rev() {
        x[i] *= inverse[i];
        for k in i + 1..N {
            x[i] -= l[k][i] * x[k];
        }
    }
    Some(x)
}

/// [`solve`] without shift in every lane, of matrices that are positive definite; x in the place of
/// b, the factors in that of the matrix.
#[inline(always)]
pub(crate) fn solve_lanes<const N: usize>(l: &mut [[Lanes; N]; N], b: &mut [Lanes; N]) {
    let mut inverse = [Lanes::ZERO; N];
    let mut scaled = [Lanes::ZERO; N];
    for j in 0..N {
        for k in 0..j {
            scaled[k] = l[j][k];
            for lane in 0..LANES {
                l[j][k].0[lane] *= inverse[k].0[lane];
                let product = l[j][k].0[lane] * scaled[k].0[lane];
                l[j][j].0[lane] -= product;
            }
        }
        for lane in 0..LANES {
            inverse[j].0[lane] = 1.0 / l[j][j].0[lane];
        }
        for i in j + 1..N {
            for k in 0..j {
                for lane in 0..LANES {
                    let product = l[i][k].0[lane] * l[j][k].0[lane];
                    l[i][j].0[lane] -= product;
                }
            }
        }
    }
    for i in 0..N {
        for k in 0..i {
            for lane in 0..LANES {
                let product = l[i][k].0[lane] * b[k].0[lane];
                b[i].0[lane] -= product;
            }
        }
    }
    for i in (0..N).rev() {
        for lane in 0..LANES {
            b[i].0[lane] *= inverse[i].0[lane];
        }
        for k in i + 1..N {
            for lane in 0..LANES {
                let product = l[k][i].0[lane] * b[k].0[lane];
                b[i].0[lane] -= product;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each lane is solved as alone.
    #[test]
    fn lanes_are_solved_as_alone() {
        let entry = |i: usize, j: usize, lane: usize| {
            let off = (0.7 * (3 * i + 5 * j + lane) as f64).sin();
            if i == j { 5.0 + off } else { off }
        };
        let right = |i: usize, lane: usize| (1.3 * (i + lane) as f64).cos();
        let mut matrix: [[Lanes; 4]; 4] = std::array::from_fn(|i| {
            std::array::from_fn(|j| Lanes(std::array::from_fn(|lane| entry(i, j, lane))))
        });
        let mut x = std::array::from_fn(|i| Lanes(std::array::from_fn(|lane| right(i, lane))));
        solve_lanes(&mut matrix, &mut x);
        for lane in 0..LANES {
            let alone: [[f64; 4]; 4] =
                std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j, lane)));
            let b = std::array::from_fn(|i| right(i, lane));
            for (x, alone) in x.iter().zip(solve(&alone, 0.0, b).unwrap()) {
                assert!((x.0[lane] - alone).abs() < 1e-15, "{lane}");
            }
        }
    }
}
