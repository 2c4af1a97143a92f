//! Static equilibrium in the plane.

use super::error::EquilibriumError;
use crate::bearing::Bearing;
use crate::contact::hertz::STRESS_LIMIT_PA;
use crate::raceway_contact::RacewayContact;

/// Balls at rest in the turning frame, and the ring.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Equilibrium {
    /// Centre of the inner ring.
    pub ring_x_m: f64,
    /// Centre of the inner ring.
    pub ring_y_m: f64,
    /// ψ of each ball, increasing from that of ball 1 through one turn.
    pub ball_angle_rad: Vec<f64>,
    /// |rb| of each ball.
    pub ball_distance_m: Vec<f64>,
    /// r of each ball.
    pub effective_radius_m: Vec<f64>,
    /// Normal force at the inner raceway.
    pub inner_force_n: Vec<f64>,
    /// Normal force at the outer raceway.
    pub outer_force_n: Vec<f64>,
    /// K of a nominal ball at the inner raceway.
    pub inner_stiffness_n_m1_5: f64,
    /// K of a nominal ball at the outer raceway.
    pub outer_stiffness_n_m1_5: f64,
    /// Contact of each ball with the inner raceway.
    pub inner_contact: Vec<RacewayContact>,
    /// Contact of each ball with the outer raceway; on a discrete raceway one of its two.
    pub outer_contact: Vec<RacewayContact>,
    /// Stiffness matrix of the bearing ∂F/∂(X, Y) at its operating point, rows x and y, N/m:
    /// force on the inner ring over its displacement, every ball staying in equilibrium. `None`
    /// where nothing holds the ring in some direction: without load, or in the clearance.
    pub stiffness_n_m: Option<[[f64; 2]; 2]>,
    /// Largest Hertz pressure at the inner raceway.
    pub inner_pressure_max_pa: f64,
    /// Largest Hertz pressure at the outer raceway; on a discrete raceway that of one of
    /// the two contact points.
    pub outer_pressure_max_pa: f64,
}

impl Equilibrium {
    /// Warning if the contact pressure exceeds [`STRESS_LIMIT_PA`].
    pub(crate) fn overload(&self) -> Option<String> {
        let (ring, stress) = if self.inner_pressure_max_pa > self.outer_pressure_max_pa {
            ("inner", self.inner_pressure_max_pa)
        } else {
            ("outer", self.outer_pressure_max_pa)
        };
        (stress > STRESS_LIMIT_PA).then(|| {
            format!(
                "the contact pressure at the {ring} raceway is {:.0} MPa, above the {:.0} MPa that \
                 leave a lasting indentation (ISO 76)",
                stress * 1e-6,
                STRESS_LIMIT_PA * 1e-6
            )
        })
    }
}

/// Overlap of two balls, as a fraction of their radius, that a start may have: balls that touch on the pitch
/// circle are seated some deflections further in, or at other contact angles. The pressure between balls of
/// steel is 2 GPa then, half of what their contact bears (ISO 76).
const OVERLAP_MAX: f64 = 4e-4;

impl Equilibrium {
    /// Passes balls that are not pressed through each other at their places between the rings.
    ///
    /// # Errors
    /// [`EquilibriumError::BallsOverlap`] for the two that overlap most.
    pub(crate) fn check_balls_apart(&self, bearing: &Bearing) -> Result<(), EquilibriumError> {
        let (n, row) = (self.ball_angle_rad.len(), bearing.balls());
        let of = |k: usize| {
            let next = k - k % row + (k + 1) % row;
            let [a, b] = [k, next].map(|k| self.ball_distance_m[k]);
            let [own, ahead] = [k, next].map(|k| bearing.ball(k % row).radius_m);
            let reach = own + ahead;
            // Balls at the angle of this cosine touch.
            let cosine = (a * a + b * b - reach * reach) / (2.0 * a * b);
            let angle = self.ball_angle_rad[next] - self.ball_angle_rad[k];
            let apart = (a * a + b * b - 2.0 * a * b * angle.cos()).sqrt();
            (k, reach - apart, cosine.acos())
        };
        let deepest = (0..n).map(of).max_by(|a, b| a.1.total_cmp(&b.1));
        match deepest {
            Some((ball, overlap_m, angle)) if overlap_m > OVERLAP_MAX * bearing.ball_radius_m() => {
                Err(EquilibriumError::BallsOverlap {
                    ball,
                    overlap_m,
                    gap_rad: angle - bearing.pair_angle_rad(ball % row),
                })
            }
            _ => Ok(()),
        }
    }
}
