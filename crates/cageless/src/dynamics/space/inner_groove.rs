//! Contact of a ball with the inner ring, in the meridian plane of the ring through the ball.

use super::Vector;
use super::ring::RingMotion;

/// Groove constants of one ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct InnerGroove {
    /// ri − R, m.
    pub gap: f64,
    /// ri, m.
    pub curvature: f64,
    /// Ri + ri, distance of the groove's centre from the axis of the ring, m.
    pub centre: f64,
    /// zi of the groove's centre, m.
    pub axial: f64,
}

/// Contact of one ball with the inner ring.
#[derive(Debug, Clone, Copy)]
pub(crate) struct InnerTouch {
    /// δi, m; negative: apart.
    pub approach: f64,
    /// **n** from the ball into the ring, and **l** across the groove.
    pub normal: Vector,
    pub across: Vector,
    /// Place of the contact from the centre of the ring, on the undeformed groove, m.
    pub arm: Vector,
    /// Place of the ball from the centre of the ring, m.
    pub ball: Vector,
    /// Sine and cosine of the contact angle, positive where an axial load along +Z presses.
    pub sine: f64,
    pub cosine: f64,
}

impl InnerGroove {
    #[inline]
    pub fn touch(&self, place: Vector, ring: &RingMotion) -> InnerTouch {
        let ball = place - ring.centre;
        let along = ball.dot(&ring.axis);
        let radial = ball - ring.axis * along;
        let distance = radial.norm();
        let direction = radial / distance;
        let (x, y) = (distance - self.centre, along - self.axial);
        let length = (x * x + y * y).sqrt();
        // Near the centre of the groove there is no direction.
        let (approach, [n_radial, n_axial]) = match length < 0.5 * self.gap {
            true => (-self.gap, [-1.0, 0.0]),
            false => (length - self.gap, [x / length, y / length]),
        };
        let normal = direction * n_radial + ring.axis * n_axial;
        InnerTouch {
            approach,
            normal,
            across: ring.axis * n_radial - direction * n_axial,
            arm: ball + normal * (self.curvature - length),
            ball,
            sine: -n_axial,
            cosine: -n_radial,
        }
    }
}
