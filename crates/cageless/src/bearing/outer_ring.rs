//! The body of an outer ring of which only the groove is given.

use std::f64::consts::{PI, TAU};

use super::Bearing;

/// Width of the ring over the diameter of a ball.
const WIDTH: f64 = 1.6;
/// Wall of the ring behind its groove over the diameter of a ball.
const WALL: f64 = 0.3;

impl Bearing {
    /// Mass of a ring of the density of the rings from its shoulders to the wall behind its groove, 0.3 ball
    /// diameters thick and 1.6 wide, kg.
    pub(crate) fn outer_ring_mass_kg(&self) -> f64 {
        let area =
            PI * (self.outside_m().powi(2) - self.dimensions.outer_shoulder_radius_m.powi(2));
        self.materials().ring.density_kg_m3 * area * self.width_m()
    }

    /// Area of the seat of that ring in its housing, m².
    pub(crate) fn outer_seat_area_m2(&self) -> f64 {
        TAU * self.outside_m() * self.width_m()
    }

    fn outside_m(&self) -> f64 {
        let d = &self.dimensions;
        d.outer_groove_bottom_radius_m + WALL * 2.0 * d.ball_radius_m
    }

    fn width_m(&self) -> f64 {
        WIDTH * 2.0 * self.dimensions.ball_radius_m
    }
}
