//! Path of a rotor in a plane.

use crate::linear_rotor::Clearance;

/// Points from which on every second one is dropped.
const POINTS: usize = 4096;

/// Largest displacement of a rotor in a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneDisplacement {
    /// The plane.
    pub clearance: Clearance,
    /// Largest distance of the axis of the rotor from the centre of the stator, m.
    pub displacement_max_m: f64,
    /// Path of the axis, thinned evenly: points, m from the centre of the stator.
    pub path_m: Vec<[f64; 2]>,
    /// The farthest point of the axis, m from the centre of the stator.
    pub farthest_m: [f64; 2],
}

/// Path of the axis of a rotor in a plane, thinned evenly as it grows, with its farthest point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlanePath {
    /// Points, m from the centre of the stator.
    pub points_m: Vec<[f64; 2]>,
    /// The farthest point, m.
    pub farthest_m: [f64; 2],
    /// Looks from one point to the next.
    stride: usize,
    /// Looks so far.
    looks: usize,
}

impl Default for PlanePath {
    fn default() -> Self {
        Self {
            points_m: vec![],
            farthest_m: [0.0; 2],
            stride: 1,
            looks: 0,
        }
    }
}

impl PlanePath {
    /// Takes the place of the axis.
    pub(crate) fn look(&mut self, place_m: [f64; 2]) {
        if square(place_m) > square(self.farthest_m) {
            self.farthest_m = place_m;
        }
        if self.looks.is_multiple_of(self.stride) {
            self.points_m.push(place_m);
        }
        self.looks += 1;
        if self.points_m.len() == POINTS {
            let mut keep = false;
            self.points_m.retain(|_| {
                keep = !keep;
                keep
            });
            self.stride *= 2;
        }
    }

    /// Largest distance from the centre of the stator, m.
    pub(crate) fn farthest_distance_m(&self) -> f64 {
        square(self.farthest_m).sqrt()
    }
}

fn square([x, y]: [f64; 2]) -> f64 {
    x * x + y * y
}

#[cfg(test)]
mod tests {
    use super::*;

    /// However long it is, the points are evenly apart and the farthest is none of the thinned.
    #[test]
    fn a_path_keeps_its_farthest_point_and_even_distances() {
        let mut path = PlanePath::default();
        for k in 0..10_000 {
            let y_m = if k == 7777 { -5e4 } else { 0.0 };
            path.look([f64::from(k), y_m]);
        }
        let points = &path.points_m;
        assert!(
            points.len() < POINTS && points.len() > POINTS / 4,
            "{}",
            points.len()
        );
        assert!(
            points
                .iter()
                .zip(0..)
                .all(|(p, k)| p[0] == f64::from(4 * k))
        );
        assert_eq!(path.farthest_m, [7777.0, -5e4]);
        assert!((path.farthest_distance_m() - 7777f64.hypot(5e4)).abs() < 1e-6);
    }
}
