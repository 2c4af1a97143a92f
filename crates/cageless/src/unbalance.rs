//! Unbalance of the inner ring and of what turns with it.

use crate::time_table::TimeTable;

/// Unbalance that turns with the inner ring.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Unbalance {
    /// m·e, product of unbalanced mass and its distance from the axis, kg·m, 0 or more.
    pub amount_kg_m: f64,
    /// Direction of the unbalance from +X at t = 0, rad.
    pub phase_rad: f64,
}

/// The force of an unbalance on the inner ring over time.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct UnbalanceForce {
    unbalance: Unbalance,
    /// ωi at t = 0, rad/s.
    speed_rad_s: f64,
    /// ωi over time, where it changes, rad/s.
    speed: Option<TimeTable>,
}

impl UnbalanceForce {
    /// The force at a constant speed, rad/s, or one over time; none without an unbalance.
    pub(crate) fn new(
        unbalance: Unbalance,
        speed_rad_s: f64,
        speed: Option<&TimeTable>,
    ) -> Option<Self> {
        (unbalance.amount_kg_m > 0.0).then(|| Self {
            unbalance,
            speed_rad_s,
            speed: speed.cloned(),
        })
    }

    /// φ, direction of the unbalance from +X at a time, rad.
    pub(crate) fn direction_rad(&self, time_s: f64) -> f64 {
        let turned_rad = match &self.speed {
            None => self.speed_rad_s * time_s,
            Some(table) => table.integral(0.0..time_s),
        };
        self.unbalance.phase_rad + turned_rad
    }

    /// Force at a time, N: −m·e d²/dt² (cos φ, sin φ) with φ̇ = ωi.
    pub(crate) fn at(&self, time_s: f64) -> [f64; 2] {
        let (speed, rate) = match &self.speed {
            None => (self.speed_rad_s, 0.0),
            Some(table) => (table.value(time_s), table.slope(time_s)),
        };
        let (sin, cos) = self.direction_rad(time_s).sin_cos();
        let amount = self.unbalance.amount_kg_m;
        let square = speed * speed;
        [
            amount * (square * cos + rate * sin),
            amount * (square * sin - rate * cos),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In a run-up the force is −m·e times the second derivative of the direction.
    #[test]
    fn the_force_is_that_of_the_turning_mass() {
        let table = TimeTable::new("f", vec![0.0, 2.0], vec![10.0, 70.0]).unwrap();
        let unbalance = Unbalance {
            amount_kg_m: 0.3,
            phase_rad: 0.7,
        };
        let force = UnbalanceForce::new(unbalance, 10.0, Some(&table)).unwrap();
        let place = |t: f64| (0.7 + 10.0 * t + 15.0 * t * t).sin_cos();
        let (h, t) = (1e-4, 1.1);
        let [before, now, after] = [t - h, t, t + h].map(place);
        let second = |a: f64, b: f64, c: f64| (a - 2.0 * b + c) / (h * h);
        let expected = [
            -0.3 * second(before.1, now.1, after.1),
            -0.3 * second(before.0, now.0, after.0),
        ];
        for (found, expected) in force.at(t).into_iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-4 * expected.abs(),
                "{found} {expected}"
            );
        }
    }
}
