//! Number and diameter of balls, pitch diameter and clearance of a bearing of a designation.

use std::f64::consts::{PI, TAU};

use cageless::Bearing;

use super::BoundaryDimensions;

/// Radial internal clearance of deep groove ball bearings (ISO 5753-1; SKF PUB 17000 (2018)): bores up to a diameter in
/// mm, and the limits of C2, Normal, C3, C4 and C5, µm; 0 where there are none.
const CLEARANCE_UM: [(u16, [[u16; 2]; 5]); 10] = [
    (6, [[0, 7], [2, 13], [8, 23], [0, 0], [0, 0]]),
    (10, [[0, 7], [2, 13], [8, 23], [14, 29], [20, 37]]),
    (18, [[0, 9], [3, 18], [11, 25], [18, 33], [25, 45]]),
    (24, [[0, 10], [5, 20], [13, 28], [20, 36], [28, 48]]),
    (30, [[1, 11], [5, 20], [13, 28], [23, 41], [30, 53]]),
    (40, [[1, 11], [6, 20], [15, 33], [28, 46], [40, 64]]),
    (50, [[1, 11], [6, 23], [18, 36], [30, 51], [45, 73]]),
    (65, [[1, 15], [8, 28], [23, 43], [38, 61], [55, 90]]),
    (80, [[1, 15], [10, 30], [25, 51], [46, 71], [65, 105]]),
    (100, [[1, 18], [12, 36], [30, 58], [53, 84], [75, 120]]),
];

/// Ball diameter over the difference of outside and bore diameter.
const BALL_SHARE: f64 = 0.29;
/// Steps of stock sizes of balls per millimetre: 1/64 inch is 0.396875 mm.
const BALL_STEPS_PER_MM: f64 = 1e6 / 396_875.0;
/// Share of the pitch circle that the balls of an angular contact bearing fill beside the bars of a cage.
const CAGED_SHARE: f64 = 0.87;
/// Angle that balls fill which enter between eccentric rings (Conrad).
const FILLING_ANGLE: f64 = 195.0 / 180.0 * PI;

/// Source of number and diameter of the balls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BallSource {
    /// Load ratings of the maker's bearing.
    Maker,
    /// Formula on the boundary dimensions.
    Formula,
    /// Ball diameter of the deep groove bearing of this size, and the number that a cage leaves room for.
    AngularContact,
}

/// Internal geometry of a bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct InternalGeometry {
    /// Dw.
    pub ball_diameter_mm: f64,
    /// Dpw.
    pub pitch_diameter_mm: f64,
    /// N.
    pub balls: usize,
    /// Number of balls with a cage.
    pub caged_balls: usize,
    /// Source of `ball_diameter_mm` and `caged_balls`.
    pub source: BallSource,
    /// Gr.
    pub clearance_um: f64,
}

impl BoundaryDimensions {
    /// Least and largest radial internal clearance of the group; `None` where ISO 5753-1 has none.
    pub(super) fn clearance_limits_um(&self) -> Option<[u16; 2]> {
        let mut rows = CLEARANCE_UM.iter();
        let (_, limits) = rows.find(|(bore, _)| self.bore_mm <= f64::from(*bore))?;
        let limits = limits[self.suffixes.clearance_group as usize];
        (limits[1] > 0).then_some(limits)
    }

    /// Internal geometry: with `full_complement`, as many balls as the pitch circle holds, else
    /// as many as with a cage, but enough to hold the inner ring when all are in one group.
    pub fn internal_geometry(&self, full_complement: bool) -> InternalGeometry {
        let section = self.outside_mm - self.bore_mm;
        let pitch_diameter_mm = (self.outside_mm + self.bore_mm) / 2.0;
        let ball_angle = |diameter: f64| 2.0 * (diameter / pitch_diameter_mm).asin();
        let (caged_balls, ball_diameter_mm, source) = match self.balls {
            Some((balls, diameter)) => (balls, diameter, BallSource::Maker),
            None => {
                let steps = (BALL_SHARE * section * BALL_STEPS_PER_MM).round().max(1.0);
                let diameter = steps * 396_875.0 / 1e6;
                let balls = 1.0 + FILLING_ANGLE / ball_angle(diameter);
                (balls as usize, diameter, BallSource::Formula)
            }
        };
        let angle = ball_angle(ball_diameter_mm);
        let [least, most] = self.clearance_limits_um().unwrap_or_default();
        let (caged_balls, source, clearance_um) = match self.contact_angle_deg > 0.0 {
            false => (caged_balls, source, f64::from(least + most) / 2.0),
            // The contact angle is that without load.
            true => (
                (CAGED_SHARE * TAU / angle) as usize,
                BallSource::AngularContact,
                0.0,
            ),
        };
        let balls = if full_complement {
            (TAU / angle) as usize
        } else {
            let [ball, pitch] = [ball_diameter_mm, pitch_diameter_mm].map(|mm| 0.5e-3 * mm);
            caged_balls.max(Bearing::balls_that_hold_ring(ball, pitch))
        };
        InternalGeometry {
            ball_diameter_mm,
            pitch_diameter_mm,
            balls,
            caged_balls,
            source,
            clearance_um,
        }
    }
}
