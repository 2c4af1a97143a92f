//! Work arrays of an evaluation in space, and the contacts that it finds.

use super::block::{INNER, SpaceBlock};
use super::model::SpaceModel;
use super::ring::RingMotion;
use super::rotor_touch::RotorTouch;
use crate::dynamics::model::Model;
use crate::numerics::lanes::LANES;

/// Contacts of a ball with the rings as of the last evaluation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallContacts {
    /// Force at the inner raceway along the radius and against the axis of the ring, N.
    inner_force_n: [f64; 2],
    /// Force at the outer raceway along the radius and the axis, N.
    outer_force_n: [f64; 2],
    /// Force of the more loaded of two contact points with the outer raceway, N.
    outer_point_n: f64,
}

/// Angle of a force of a contact from the radius; NaN without one.
fn angle_rad([along, across]: [f64; 2]) -> f64 {
    match [along, across] == [0.0; 2] {
        true => f64::NAN,
        false => across.atan2(along),
    }
}

impl BallContacts {
    /// Contact angle at the inner raceway, positive where an axial load along +Z presses, rad;
    /// NaN without contact.
    pub fn inner_contact_angle_rad(&self) -> f64 {
        angle_rad(self.inner_force_n)
    }

    /// Normal force of the more loaded of the contact points with the outer raceway, N.
    pub(crate) fn outer_point_n(&self) -> f64 {
        self.outer_point_n
    }

    /// Angle of the force at the outer raceway, rad; NaN without contact.
    pub fn outer_contact_angle_rad(&self) -> f64 {
        angle_rad(self.outer_force_n)
    }
}

/// Work arrays of an evaluation in space.
#[derive(Debug, Clone)]
pub(crate) struct SpaceWorkspace {
    pub ring: RingMotion,
    /// Velocity of the outer ring, m/s.
    pub outer_ring_velocity: [f64; 3],
    pub blocks: Vec<SpaceBlock>,
    /// Contacts of a rotor, if there is one.
    pub rotor: RotorTouch,
    /// Whether the last evaluation with friction was the end of an implicit step.
    pub known: bool,
}

impl SpaceWorkspace {
    pub fn new(model: &Model, space: &SpaceModel) -> Self {
        Self {
            ring: RingMotion::at_rest(),
            outer_ring_velocity: [0.0; 3],
            blocks: (0..space.balls.len())
                .step_by(LANES)
                .map(|first| SpaceBlock::new(model, space, first))
                .collect(),
            known: false,
            rotor: RotorTouch::new(space.rotor.as_ref()),
        }
    }

    /// Contacts of ball `k`.
    pub fn contacts(&self, k: usize) -> BallContacts {
        let (block, lane) = (&self.blocks[k / LANES], k % LANES);
        let inner_n = block.frames[INNER].force_n.0[lane];
        let (outer, inner) = (block.outer.get(lane), block.inner.get(lane));
        let outer_n = block.outer_force_n.0[lane];
        BallContacts {
            inner_force_n: [inner.cosine, inner.sine].map(|part| part * inner_n),
            outer_force_n: outer.resultant().map(|part| part * outer_n),
            outer_point_n: outer.share_0.max(outer.share_1) * outer_n,
        }
    }

    /// Force of the balls on the outer ring, N.
    pub fn outer_ring_force_n(&self) -> [f64; 3] {
        [0, 1, 2].map(|axis| {
            let lanes = self.blocks.iter().map(|b| b.outer_ring_force_n[axis].0);
            lanes.flatten().sum()
        })
    }
}
