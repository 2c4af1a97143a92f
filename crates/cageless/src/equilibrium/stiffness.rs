//! Stiffness matrix of the bearing at its operating point.
//!
//! The force that the balls put on the ring is −∂V/∂**R** of the potential energy in which every
//! ball is already in equilibrium (see `potential`). Its derivative, the Hessian of V, is the
//! stiffness with the balls re-equilibrated: symmetric, with the geometric part −F/L of loaded
//! contacts and with the softening by the centrifugal force in the outer contacts.

use super::minimum::Local;

/// Stiffness of the softest direction over that of the stiffest below which the ring is free.
const FREE: f64 = 1e-9;

impl Local<2> {
    /// ∂F/∂(X, Y), N/m, rows x and y; `None` where nothing holds the ring in some direction.
    pub fn stiffness_n_m(&self) -> Option<[[f64; 2]; 2]> {
        let [flat, steep] = self.eigenvalues();
        (steep > 0.0 && flat > FREE * steep).then_some(self.hessian)
    }
}
