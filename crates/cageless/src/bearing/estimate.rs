//! Dimensions and masses that a bearing has unless they are known.

use std::f64::consts::PI;

use super::dimensions::{BearingDimensions, SHOULDER_HEIGHT};

/// Radius of a groove in the meridian plane over the diameter of the ball, usual in deep groove ball bearings.
pub const CONFORMITY: f64 = 0.52;

/// Width of the inner ring over the diameter of the ball.
const WIDTH: f64 = 1.6;

/// Density of rings of bearing steel, kg/m³.
const RING_DENSITY_KG_M3: f64 = 7850.0;

/// C of Zhao 2022, Eq. (14), N·s/m.
pub const INNER_RING_DAMPING_N_S_M: f64 = 2000.0;

impl BearingDimensions {
    /// Dimensions of a deep groove bearing by the number of its balls, their *radius* and the *radius* of the pitch
    /// circle, m: half of Dw and half of dm in a catalogue.
    ///
    /// No internal clearance, grooves of conformity [`CONFORMITY`], shoulders 0.2 ball diameters high, an inner ring of
    /// steel 0.3 ball diameters thick below its groove and 1.6 wide, damped by [`INNER_RING_DAMPING_N_S_M`].
    ///
    /// ```
    /// use cageless::prelude::*;
    ///
    /// let dimensions = BearingDimensions::estimated(14, 4.7625e-3, 23.0e-3); // balls, ball radius, pitch radius: m
    /// let bearing = Bearing::new(dimensions, Material::STEEL)?;
    /// assert!((bearing.pitch_radius_m() - 23.0e-3).abs() < 1e-15);
    /// assert!(bearing.mean_gap_rad() > 0.0);
    /// # Ok::<(), InputError>(())
    /// ```
    pub fn estimated(balls: usize, ball_radius_m: f64, pitch_radius_m: f64) -> Self {
        let diameter_m = 2.0 * ball_radius_m;
        let outer_groove_bottom_radius_m = pitch_radius_m + ball_radius_m;
        let mut estimated = Self {
            balls,
            ball_radius_m,
            inner_groove_bottom_radius_m: pitch_radius_m - ball_radius_m,
            outer_groove_bottom_radius_m,
            outer_shoulder_radius_m: outer_groove_bottom_radius_m - SHOULDER_HEIGHT * diameter_m,
            inner_shoulder_radius_m: None,
            inner_groove_curvature_radius_m: CONFORMITY * diameter_m,
            outer_groove_curvature_radius_m: CONFORMITY * diameter_m,
            inner_ring_mass_kg: 0.0,
            inner_ring_damping_n_s_m: INNER_RING_DAMPING_N_S_M,
        };
        estimated.inner_ring_mass_kg = estimated.inner_ring_mass_estimate_kg(None);
        estimated
    }

    /// Mass of an inner ring of steel between its bore and its shoulders, kg; 1.6 ball diameters wide unless a width
    /// is given.
    pub fn inner_ring_mass_estimate_kg(&self, width_m: Option<f64>) -> f64 {
        let shoulder_m = self.inner_groove_bottom_radius_m + self.inner_shoulder_height_m();
        let width_m = width_m.unwrap_or(WIDTH * 2.0 * self.ball_radius_m);
        let section = shoulder_m.powi(2) - self.bore_radius_estimate_m().powi(2);
        RING_DENSITY_KG_M3 * PI * section * width_m
    }
}
