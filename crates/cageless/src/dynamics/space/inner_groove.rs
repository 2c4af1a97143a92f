//! Contact of a ball with the inner ring, in the meridian plane of the ring through the ball.

use crate::numerics::lanes::lane_struct;
use crate::numerics::vector::{cross, dot, plus};

lane_struct! {
    /// Groove constants of one ball.
    pub(crate) struct InnerGroove per lane InnerGrooveLanes {
        /// ri − R, m.
        gap,
        /// ri, m.
        curvature,
        /// Ri + ri, distance of the groove's centre from the axis of the ring, m.
        centre,
        /// zi of the groove's centre, m.
        axial,
    }
}

lane_struct! {
    /// Contact of one ball with the inner ring.
    pub(crate) struct InnerTouch per lane InnerTouchLanes {
        /// δi, m; negative: apart.
        approach,
        /// X of the unit vector from the axis of the ring to the ball.
        direction_x,
        /// Y of that vector.
        direction_y,
        /// Z of that vector.
        direction_z,
        /// Distance of the ball from the centre of the groove, m.
        length,
        /// Sine of the contact angle, positive where an axial load along +Z presses.
        sine,
        /// Cosine of the contact angle.
        cosine,
    }
}

impl InnerTouch {
    /// **n** from the ball into the ring, **l** across the groove and **τ** = **n** × **l**.
    #[inline(always)]
    pub(crate) fn axes(&self, axis: [f64; 3]) -> [[f64; 3]; 3] {
        let direction = [self.direction_x, self.direction_y, self.direction_z];
        let still = [0.0; 3];
        let normal = plus(plus(still, -self.cosine, direction), -self.sine, axis);
        let across = plus(plus(still, -self.cosine, axis), self.sine, direction);
        [normal, across, cross(normal, across)]
    }
}

impl InnerGroove {
    /// Contact of a ball at this place from the centre of the ring with this axis.
    #[inline(always)]
    pub(crate) fn touch(&self, ball: [f64; 3], axis: [f64; 3]) -> InnerTouch {
        let along = dot(ball, axis);
        let radial = plus(ball, -along, axis);
        let distance = dot(radial, radial).sqrt();
        let (x, y) = (distance - self.centre, along - self.axial);
        let length = (x * x + y * y).sqrt();
        // Near the centre of the groove there is no direction.
        let near = length < 0.5 * self.gap;
        InnerTouch {
            approach: if near { -self.gap } else { length - self.gap },
            direction_x: radial[0] / distance,
            direction_y: radial[1] / distance,
            direction_z: radial[2] / distance,
            length,
            sine: if near { 0.0 } else { -y / length },
            cosine: if near { 1.0 } else { -x / length },
        }
    }
}
