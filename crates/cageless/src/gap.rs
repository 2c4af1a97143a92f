//! Gaps between neighbouring balls.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! use cageless::dynamics::Model;
//! use cageless::dynamics::coordinates::BallCoordinate;
//! use cageless::gap::GapRange;
//! use cageless::initial_conditions::initial_state;
//!
//! let case = common::structure(5.1, 25.2); // Zhao 2022, Table 2, structure (d)
//! let (state, _angles) = initial_state(&case)?;
//! let [x, y] = [BallCoordinate::X, BallCoordinate::Y]
//!     .map(|coordinate| state.layout().balls_of(state.values(), coordinate));
//! let mut range = GapRange::new(&Model::new(&case)?);
//! range.look(x, y, [0.0; 2]);
//! // All gaps are equal at the start.
//! let [least, most] = range.range_rad();
//! assert!((most - least).abs() < 1e-12 && (least.to_degrees() - 1.816).abs() < 1e-3);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use std::f64::consts::TAU;

use crate::dynamics::Model;
use crate::dynamics::layout::Balls;

/// An angle from 0 to 2π by its sine and cosine, both times the same length: two can be
/// compared without angle functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Direction {
    sine: f64,
    cosine: f64,
}

impl Direction {
    /// Direction from ball `k` to the ball ahead, forwards, about the centre of the outer ring.
    #[inline]
    pub fn to_next(x_m: Balls<'_>, y_m: Balls<'_>, centre_m: [f64; 2], k: usize) -> Self {
        let next = x_m.next(k);
        let [x, y] = [x_m[k] - centre_m[0], y_m[k] - centre_m[1]];
        let [next_x, next_y] = [x_m[next] - centre_m[0], y_m[next] - centre_m[1]];
        Self {
            sine: x * next_y - y * next_x,
            cosine: x * next_x + y * next_y,
        }
    }

    /// Whether the angle is the smaller one.
    #[inline]
    pub fn below(self, other: Self) -> bool {
        let (beyond, other_beyond) = (self.sine < 0.0, other.sine < 0.0);
        if beyond != other_beyond {
            return other_beyond;
        }
        // Within half a turn the sign of sin(a − b) orders a and b.
        self.sine * other.cosine < self.cosine * other.sine
    }

    /// The angle, less `pair_angle_rad`, that of two balls that touch
    /// ([`Model::pair_angle_rad`]).
    pub fn gap_rad(self, pair_angle_rad: f64) -> f64 {
        let angle = self.sine.atan2(self.cosine);
        (if angle < 0.0 { angle + TAU } else { angle }) - pair_angle_rad
    }
}

/// Smallest and largest gap that was seen between each pair of neighbours.
#[derive(Debug, Clone, Default)]
pub struct GapRange {
    pair_angles: Vec<f64>,
    /// Smallest and largest angle of each pair; empty before the first look.
    range: Vec<[Direction; 2]>,
}

impl GapRange {
    /// Gap range of the balls of a model.
    pub fn new(model: &Model) -> Self {
        Self {
            pair_angles: (0..model.balls())
                .map(|k| model.pair_angle_rad(k))
                .collect(),
            range: vec![],
        }
    }

    /// Takes the positions of the balls and of the centre of the outer ring.
    pub fn look(&mut self, x_m: Balls<'_>, y_m: Balls<'_>, centre_m: [f64; 2]) {
        let at = |k| Direction::to_next(x_m, y_m, centre_m, k);
        if self.range.is_empty() {
            self.range = (0..self.pair_angles.len()).map(|k| [at(k); 2]).collect();
        }
        for (k, [least, most]) in self.range.iter_mut().enumerate() {
            let now = at(k);
            if now.below(*least) {
                *least = now;
            }
            if most.below(now) {
                *most = now;
            }
        }
    }

    /// Smallest and largest gap of all, rad; infinite before the first look.
    pub fn range_rad(&self) -> [f64; 2] {
        let pairs = self.range.iter().zip(&self.pair_angles);
        pairs.fold(
            [f64::INFINITY, f64::NEG_INFINITY],
            |[low, high], (range, &pair)| {
                let [least, most] = range.map(|d| d.gap_rad(pair));
                [low.min(least), high.max(most)]
            },
        )
    }
}
