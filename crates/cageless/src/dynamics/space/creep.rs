//! Knees of the law at every place, from the creep of rolling contacts.
//!
//! ρ is the distance of the ball from the axis of the ring, vτ its orbital velocity, R nρ the radial distance of the
//! contact from its centre, wτ the velocity of the surface of the ring, sτ the sliding velocity. The rolling speed is
//! u = wτ − vτ (1 + R nρ/ρ) + sτ/2. N^(1/3) is the semi-axis a of the contact over that under 1 N.

use super::block::{INNER, SpaceBlock};
use super::frame::of_lane;
use crate::ball::PolarMotionLanes;
use crate::contact::creep::rolling_speed_m_s;
use crate::numerics::lanes::{LANES, Lanes};

/// Keeps the knee of contacts that do not bear finite, m.
const NO_LENGTH_M: f64 = 1e-12;

/// Sets the knees of a block from the loads and velocities of the last evaluation.
#[inline(always)]
pub(super) fn set_knees(polar: &PolarMotionLanes, b: &mut SpaceBlock) {
    for &place in b.places {
        let rolling = rolling_m_s(polar, b, place);
        let creep = b.creep_length_m[usize::from(place == INNER)];
        let mut inverse_knees = Lanes::ZERO;
        for lane in 0..LANES {
            let length = b.frames[place].half_length_m.0[lane] + NO_LENGTH_M;
            inverse_knees.0[lane] = creep.0[lane] / (length * rolling_speed_m_s(rolling.0[lane]));
        }
        b.inverse_knees[place] = inverse_knees;
    }
}

/// u at a place, m/s.
#[inline(always)]
pub(super) fn rolling_m_s(polar: &PolarMotionLanes, b: &SpaceBlock, place: usize) -> Lanes {
    let sliding = b.sliding(place, &b.velocity, 1);
    let mut rolling = Lanes::ZERO;
    for lane in 0..LANES {
        let (frame, v) = (b.frames[place].get(lane), of_lane(&b.velocity, lane));
        let orbit = frame.along_x * v[0] + frame.along_y * v[1] + frame.along_z * v[2];
        let radial = frame.normal_x * polar.ex.0[lane] + frame.normal_y * polar.ey.0[lane];
        let reach = b.inverse_radius.0[lane] * polar.distance.0[lane];
        let surface = -b.at_rest[1][place].along.0[lane];
        rolling.0[lane] =
            surface - orbit * ((reach + radial) / reach) + 0.5 * sliding.along.0[lane];
    }
    rolling
}
