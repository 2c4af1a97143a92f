//! Angles on the circle.
//!
//! ```
//! use cageless::numerics::wrap_angle_rad;
//! use std::f64::consts::TAU;
//!
//! assert!((wrap_angle_rad(3.0 * TAU - 0.5) + 0.5).abs() < 1e-14);
//! ```

use std::f64::consts::TAU;

/// `angle_rad` wrapped to [−π, π].
pub fn wrap_angle_rad(angle_rad: f64) -> f64 {
    let turns = angle_rad / TAU;
    (turns - turns.round()) * TAU
}

/// `angle_rad` plus whole turns, nearest to `reference_rad`.
pub(crate) fn unwrap_angle_rad(angle_rad: f64, reference_rad: f64) -> f64 {
    angle_rad + ((reference_rad - angle_rad) / TAU).round() * TAU
}

/// α/sin α; 1 at 0.
pub(crate) fn over_sine(angle_rad: f64) -> f64 {
    if angle_rad == 0.0 {
        1.0
    } else {
        angle_rad / angle_rad.sin()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_turns_come_off_and_back_on() {
        for turns in [-3.0, 0.0, 1.0, 7.0] {
            for angle in [-3.1, -0.5, 0.0, 2.0] {
                let continuous = angle + turns * TAU;
                assert!((wrap_angle_rad(continuous) - angle).abs() < 1e-14);
                assert!((unwrap_angle_rad(angle, continuous + 3.0) - continuous).abs() < 1e-14);
            }
        }
    }
}
