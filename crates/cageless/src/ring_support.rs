//! Where the balls hold the inner ring, however they are spaced, and where its shoulders end a fall
//! between them.

use std::f64::consts::PI;

use crate::bearing::Bearing;

impl Bearing {
    /// Displacement of the inner ring from the centre of the outer one at which their shoulders
    /// meet, m: Ros − Ri − hi, the shoulders of the inner ring hi high.
    pub(crate) fn shoulder_clearance_m(&self) -> f64 {
        let d = self.dimensions();
        let shoulder = d.inner_shoulder_height_m();
        d.outer_shoulder_radius_m - d.inner_groove_bottom_radius_m - shoulder
    }

    /// Angle between the centres of the two end balls across the gap, all balls touching in one
    /// row: the largest angle without support that the ring can meet.
    pub(crate) fn bunched_opening_rad(&self) -> f64 {
        let widest = (0..self.balls()).map(|k| self.pair_angle_rad(k));
        widest.fold(0.0, f64::max) + self.balls() as f64 * self.mean_gap_rad()
    }

    /// Whether the inner ring can leave the bearing between the balls: bunched, they leave half
    /// of the pitch circle or more without support.
    pub(crate) fn can_fall_between_balls(&self) -> bool {
        self.bunched_opening_rad() >= PI
    }

    /// Least number of equal balls between which the inner ring cannot fall however they bunch:
    /// 2π − (N − 1) ε < π.
    pub fn balls_that_hold_ring(ball_radius_m: f64, pitch_radius_m: f64) -> usize {
        let epsilon = 2.0 * (ball_radius_m / pitch_radius_m).asin();
        (PI / epsilon).floor() as usize + 2
    }

    /// Warning where `can_fall_between_balls`.
    pub fn fall_warning(&self) -> Option<String> {
        let holding = Self::balls_that_hold_ring(self.ball_radius_m(), self.pitch_radius_m());
        self.can_fall_between_balls().then(|| {
            format!(
                "when its {} balls bunch, they leave {:.0}° of the pitch circle open, and the inner \
                 ring can fall between them: {holding} or more (bearing.balls) hold it",
                self.balls(),
                self.bunched_opening_rad().to_degrees()
            )
        })
    }
}
