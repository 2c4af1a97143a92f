//! Linear equations with a symmetric positive definite matrix.
//!
//! ```
//! use cageless::numerics::cholesky::solve;
//!
//! let [x, y] = solve(&[[4.0, 2.0], [2.0, 3.0]], 0.0, [10.0, 9.0]).unwrap();
//! assert!((x - 1.5).abs() < 1e-15 && (y - 2.0).abs() < 1e-15);
//! ```

/// x of (H + shift) x = b by the factors L D Lᵀ, of H the lower half; `None` where that is not positive
/// definite.
#[inline(always)]
pub fn solve<const N: usize>(hessian: &[[f64; N]; N], shift: f64, b: [f64; N]) -> Option<[f64; N]> {
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
