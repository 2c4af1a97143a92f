//! One point of contact between a ball and a ring: frame, sliding, and what friction does there.

use super::Vector;
use super::ring::RingMotion;
use super::strips::Sliding;

/// A point of contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contact {
    /// From the ball into the ring.
    pub normal: Vector,
    /// Across the groove.
    pub across: Vector,
    /// **n** × **l**, along the groove.
    pub along: Vector,
    /// Place from the centre of the inner ring, m; of no use at the outer ring.
    pub arm: Vector,
    /// Whether the inner ring is touched.
    pub inner: bool,
    /// Normal force, N.
    pub force_n: f64,
    /// Normal force under which friction acts, N.
    pub friction_normal_n: f64,
    /// a, m.
    pub half_length_m: f64,
}

impl Default for Contact {
    fn default() -> Self {
        Self {
            normal: Vector::zeros(),
            across: Vector::zeros(),
            along: Vector::zeros(),
            arm: Vector::zeros(),
            inner: false,
            force_n: 0.0,
            friction_normal_n: 0.0,
            half_length_m: 0.0,
        }
    }
}

/// Friction of a contact on the ball: force and moment about its centre, in the frame of the contact.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Traction {
    /// Force along τ and l, N.
    pub force: [f64; 2],
    /// Moment about n, l and τ beyond that of the force at the distance R, N·m.
    pub moment: [f64; 3],
}

impl Traction {
    /// Adds a strip at x with this force and moment.
    #[inline(always)]
    pub fn add(&mut self, [along, across]: [f64; 2], moment: f64, x_m: f64, curvature: f64) {
        let bend = curvature * x_m * x_m;
        self.force[0] += along;
        self.force[1] += across;
        self.moment[0] += x_m * along + moment;
        self.moment[1] += bend * along + 2.0 * curvature * x_m * moment;
        self.moment[2] -= bend * across;
    }
}

impl Contact {
    /// Sliding of a ball of this radius with these velocities.
    #[inline(always)]
    pub fn sliding(
        &self,
        velocity: Vector,
        rotation: Vector,
        radius_m: f64,
        ring: &RingMotion,
    ) -> Sliding {
        let mut middle = velocity + rotation.cross(&self.normal) * radius_m;
        let mut relative = rotation;
        if self.inner {
            middle -= ring.velocity + ring.rotation.cross(&self.arm);
            relative -= ring.rotation;
        }
        Sliding {
            along: middle.dot(&self.along),
            across: middle.dot(&self.across),
            spin: relative.dot(&self.normal),
            roll: relative.dot(&self.across),
            yaw: relative.dot(&self.along),
        }
    }

    /// Force and moment about its centre on a ball of this radius.
    #[inline(always)]
    pub fn on_ball(&self, traction: &Traction, radius_m: f64) -> [Vector; 2] {
        let ([along, across], [spin, roll, yaw]) = (traction.force, traction.moment);
        [
            self.along * along + self.across * across,
            self.normal * spin
                + self.across * (roll - radius_m * along)
                + self.along * (yaw + radius_m * across),
        ]
    }

    /// Moment about the centre of the inner ring on that ring.
    #[inline(always)]
    pub fn on_ring(&self, traction: &Traction) -> Vector {
        let [along, across] = traction.force;
        let [spin, roll, yaw] = traction.moment;
        let force = self.along * along + self.across * across;
        -self.arm.cross(&force) - self.normal * spin - self.across * roll - self.along * yaw
    }
}
