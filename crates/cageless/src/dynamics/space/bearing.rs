//! A bearing in space with what drives it, and what its contacts add up to.

use super::Vector;
use super::frame::SIZE;
use super::model::{FreeTilt, SpaceModel};
use super::ring::RingMotion;
use crate::dynamics::model::Model;
use crate::simd::Parameters;

/// Loads and speed at one time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Drive {
    /// ωi, rad/s.
    pub inner_speed: f64,
    /// Fr, N.
    pub radial_load: f64,
    /// Force of the unbalance in the plane of the bearing, N.
    pub unbalance: [f64; 2],
}

/// A bearing in space and what drives it.
#[derive(Clone, Copy)]
pub(crate) struct Bearing<'a> {
    pub parameters: &'a Parameters,
    pub model: &'a Model,
    pub space: &'a SpaceModel,
    pub drive: Drive,
}

/// Second derivatives of p and q that a moment on the ring adds.
pub(super) fn tilting_by(free: &FreeTilt, ring: &RingMotion, moment: Vector) -> [f64; 2] {
    let turning = moment.cross(&ring.axis) / free.transverse;
    [turning.x, turning.y]
}

/// Sums over the contacts.
#[derive(Default)]
pub(super) struct Totals {
    /// Force on the inner ring and moment about its centre, N, N·m.
    pub ring: [f64; SIZE],
    /// Friction of the balls on the outer ring, N.
    pub outer_ring: [f64; 3],
    /// Heat at the outer and the inner contacts, W.
    pub heat: [f64; 2],
    pub weight: f64,
    pub ball_friction: f64,
    pub damping: f64,
    /// Heat of the rolling force of films, W.
    pub rolling: f64,
}

impl Totals {
    /// Force on the inner ring and moment about its centre.
    pub(super) fn on_ring(&self) -> [Vector; 2] {
        let [fx, fy, fz, mx, my, mz] = self.ring;
        [Vector::new(fx, fy, fz), Vector::new(mx, my, mz)]
    }

    /// Moment on the inner ring about its axis, N·m.
    pub(super) fn torque_on(&self, ring: &RingMotion) -> f64 {
        let [_, moment] = self.on_ring();
        moment.dot(&ring.axis)
    }
}
