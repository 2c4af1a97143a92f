//! The inner ring in space: place, axis and velocities.

use super::Vector;
use crate::dynamics::coordinates::RingCoordinate;
use crate::dynamics::layout::Layout;

/// Motion of the inner ring.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RingMotion {
    /// **R**, m.
    pub centre: Vector,
    /// Ṙ, m/s.
    pub velocity: Vector,
    /// **a**.
    pub axis: Vector,
    /// ȧ, 1/s.
    pub axis_rate: Vector,
    /// **a** × ȧ + ωi **a**, rad/s.
    pub rotation: Vector,
    /// **a** × ȧ, rad/s.
    pub tilting: Vector,
}

/// Motions of both rings.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RingMotions {
    /// Motion of the inner ring.
    pub inner: RingMotion,
    /// Velocity of the outer ring, m/s.
    pub outer_velocity: [f64; 3],
}

impl RingMotion {
    /// A ring at rest in the middle.
    pub(crate) fn at_rest() -> Self {
        let zero = Vector::zeros();
        Self {
            centre: zero,
            velocity: zero,
            axis: Vector::z(),
            axis_rate: zero,
            rotation: zero,
            tilting: zero,
        }
    }

    #[inline(always)]
    pub(crate) fn new(layout: Layout, y: &[f64], inner_speed_rad_s: f64) -> Self {
        let at = |coordinate| y[layout.ring(coordinate)];
        let (p, q) = (at(RingCoordinate::TiltP), at(RingCoordinate::TiltQ));
        let (p_rate, q_rate) = (at(RingCoordinate::TiltPRate), at(RingCoordinate::TiltQRate));
        let height = (1.0 - p * p - q * q).sqrt();
        let axis = Vector::new(p, q, height);
        let axis_rate = Vector::new(p_rate, q_rate, -(p * p_rate + q * q_rate) / height);
        let tilting = axis.cross(&axis_rate);
        Self {
            centre: Vector::new(
                at(RingCoordinate::X),
                at(RingCoordinate::Y),
                at(RingCoordinate::Z),
            ),
            velocity: Vector::new(
                at(RingCoordinate::Vx),
                at(RingCoordinate::Vy),
                at(RingCoordinate::Vz),
            ),
            axis,
            axis_rate,
            rotation: tilting + axis * inner_speed_rad_s,
            tilting,
        }
    }

    /// The ring at this place with the velocities of another motion.
    pub(crate) fn with_velocities_of(&self, other: &Self) -> Self {
        Self {
            centre: self.centre,
            axis: self.axis,
            ..*other
        }
    }
}
