//! A contact in lanes, as friction sees it: frame, load, and what a ball does along it.
//!
//! Velocities of a ball are V = (**v**, R**ω**), forces on it (**F**, **M**/R).

use super::strips::Sliding;
use crate::numerics::lanes::{Lanes, lane_struct};
use crate::numerics::vector::{cross, dot};

/// Numbers of V, and of the force on a ball.
pub(super) const SIZE: usize = 6;

lane_struct! {
    /// A contact of a ball with a ring.
    pub(crate) struct Frame per lane FrameLanes {
        /// **n**, from the ball into the ring.
        normal_x,
        /// **n**.
        normal_y,
        /// **n**.
        normal_z,
        /// **l**, across the groove.
        across_x,
        /// **l**.
        across_y,
        /// **l**.
        across_z,
        /// **τ** = **n** × **l**, along the groove.
        along_x,
        /// **τ**.
        along_y,
        /// **τ**.
        along_z,
        /// Place from the centre of the inner ring, m.
        arm_x,
        /// Place from the centre of the inner ring, m.
        arm_y,
        /// Place from the centre of the inner ring, m.
        arm_z,
        /// Normal force, N.
        force_n,
        /// Normal force under which friction acts, N.
        friction_normal_n,
        /// a, m.
        half_length_m,
    }
}

/// One number of each lane in each of several arrays.
#[inline(always)]
pub(super) fn of_lane<const N: usize>(lanes: &[Lanes; N], lane: usize) -> [f64; N] {
    let mut values = [0.0; N];
    for i in 0..N {
        values[i] = lanes[i].0[lane];
    }
    values
}

lane_struct! {
    /// Friction of a contact on the ball: force and moment about its centre, in the frame of the
    /// contact.
    pub(crate) struct Traction per lane TractionLanes {
        /// Force along τ, N.
        along,
        /// Force along l, N.
        across,
        /// Moment about n beyond that of the force at the distance R, N·m.
        spin,
        /// Moment about l beyond that of the force at the distance R, N·m.
        roll,
        /// Moment about τ beyond that of the force at the distance R, N·m.
        yaw,
    }
}

impl TractionLanes {
    /// Adds a strip at x with this force along τ and l and this moment.
    #[inline(always)]
    pub(super) fn add(&mut self, lane: usize, strip: [f64; 3], x_m: f64, curvature: f64) {
        let [along, across, moment] = strip;
        let bend = curvature * x_m * x_m;
        self.along.0[lane] += along;
        self.across.0[lane] += across;
        self.spin.0[lane] += x_m * along + moment;
        self.roll.0[lane] += bend * along + 2.0 * curvature * x_m * moment;
        self.yaw.0[lane] -= bend * across;
    }
}

impl Frame {
    /// **n**, **l**, **τ**.
    #[inline(always)]
    fn axes(&self) -> [[f64; 3]; 3] {
        [
            [self.normal_x, self.normal_y, self.normal_z],
            [self.across_x, self.across_y, self.across_z],
            [self.along_x, self.along_y, self.along_z],
        ]
    }

    /// Place from the centre of the inner ring, m.
    #[inline(always)]
    fn arm(&self) -> [f64; 3] {
        [self.arm_x, self.arm_y, self.arm_z]
    }

    /// Sliding of a ball at rest against a ring with this velocity of its centre and rotation.
    #[inline(always)]
    pub(crate) fn sliding_at_rest(&self, velocity: [f64; 3], rotation: [f64; 3]) -> Sliding {
        let [normal, across, along] = self.axes();
        let turning = cross(rotation, self.arm());
        let mut surface = [0.0; 3];
        for i in 0..3 {
            surface[i] = velocity[i] + turning[i];
        }
        Sliding {
            along: -dot(surface, along),
            across: -dot(surface, across),
            spin: -dot(rotation, normal),
            roll: -dot(rotation, across),
            yaw: -dot(rotation, along),
        }
    }

    /// Sliding of a ball with these velocities against a ring at which a ball at rest slides with
    /// `at_rest`.
    #[inline(always)]
    pub(crate) fn sliding(
        &self,
        v: [f64; SIZE],
        inverse_radius: f64,
        at_rest: &Sliding,
    ) -> Sliding {
        let [normal, across, along] = self.axes();
        let (linear, turning) = ([v[0], v[1], v[2]], [v[3], v[4], v[5]]);
        let (roll, yaw) = (dot(across, turning), dot(along, turning));
        Sliding {
            along: (dot(along, linear) - roll) + at_rest.along,
            across: (dot(across, linear) + yaw) + at_rest.across,
            spin: dot(normal, turning) * inverse_radius + at_rest.spin,
            roll: roll * inverse_radius + at_rest.roll,
            yaw: yaw * inverse_radius + at_rest.yaw,
        }
    }

    /// Rows of the matrix J from V to the sliding along τ and l and to the spin times R.
    #[inline(always)]
    pub(crate) fn rows(&self) -> [[f64; SIZE]; 3] {
        let [n, l, t] = self.axes();
        [
            [t[0], t[1], t[2], -l[0], -l[1], -l[2]],
            [l[0], l[1], l[2], t[0], t[1], t[2]],
            [0.0, 0.0, 0.0, n[0], n[1], n[2]],
        ]
    }

    /// Force on the ball.
    #[inline(always)]
    pub(crate) fn on_ball(&self, traction: &Traction, inverse_radius: f64) -> [f64; SIZE] {
        let [n, l, t] = self.axes();
        let (along, across) = (traction.along, traction.across);
        let spin = traction.spin * inverse_radius;
        let roll = traction.roll * inverse_radius - along;
        let yaw = traction.yaw * inverse_radius + across;
        let mut force = [0.0; SIZE];
        for i in 0..3 {
            force[i] = t[i] * along + l[i] * across;
            force[3 + i] = n[i] * spin + l[i] * roll + t[i] * yaw;
        }
        force
    }

    /// Force on the inner ring and moment about its centre.
    #[inline(always)]
    pub(crate) fn on_ring(&self, traction: &Traction) -> [f64; SIZE] {
        let [n, l, t] = self.axes();
        let mut force = [0.0; SIZE];
        for i in 0..3 {
            force[i] = -(t[i] * traction.along + l[i] * traction.across);
        }
        let turning = cross(self.arm(), [force[0], force[1], force[2]]);
        for i in 0..3 {
            force[3 + i] =
                turning[i] - (n[i] * traction.spin + l[i] * traction.roll + t[i] * traction.yaw);
        }
        force
    }
}
