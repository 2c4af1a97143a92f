//! Force of the outer raceway on a ball along the radius, without friction.

use crate::contact::FlankSection;

/// Force at the outer raceway and its derivatives over the place of the ball along the radius.
#[derive(Debug, Clone, Copy)]
pub(super) struct OuterForce {
    /// δo, or δe on elastic flanks, m; 0 apart.
    pub deflection_m: f64,
    /// Radial force, N.
    pub force_n: f64,
    /// Its derivative, N/m.
    pub slope_n_m: f64,
}

impl OuterForce {
    /// Force on a ball `beyond_m` outwards of where it just touches: K δ^(3/2), on elastic flanks
    /// K δe^(3/2) ∂δe/∂ρ.
    pub fn new(stiffness_n_m1_5: f64, flanks: Option<&FlankSection>, beyond_m: f64) -> Self {
        let press = flanks.map(|flanks| flanks.press(beyond_m));
        let deflection_m = press.map_or(beyond_m.max(0.0), |p| p.deflection);
        let force_n = stiffness_n_m1_5 * deflection_m.powf(1.5);
        let slope_n_m = 1.5 * stiffness_n_m1_5 * deflection_m.sqrt();
        let plain = Self {
            deflection_m,
            force_n,
            slope_n_m,
        };
        press.map_or(plain, |p| Self {
            deflection_m,
            force_n: force_n * p.lever,
            slope_n_m: slope_n_m * p.lever * p.lever + force_n * p.curvature,
        })
    }
}
