//! Work arrays of an evaluation in space, and the contacts that it finds.

use super::block::{INNER, PLACES, SpaceBlock};
use super::model::SpaceModel;
use super::ring::{RingMotion, RingMotions};
use crate::dynamics::layout::Layout;
use crate::dynamics::model::Model;
use crate::numerics::lanes::LANES;
use crate::numerics::vector::SectionVector;
use crate::raceway_contact::RacewayPoint;
use crate::world::body::sliding_ring::SlidingWork;
use crate::world::joint::rotor_touch::RotorTouch;

/// Normal force of a ball on a groove, and where it acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactPoint {
    /// Normal force, N; 0 without contact.
    pub force_n: f64,
    /// Cosine and sine of its contact angle, positive where an axial load along +Z presses.
    pub normal: [f64; 2],
    /// a, m.
    pub half_length_m: f64,
}

impl ContactPoint {
    /// Force, N.
    fn force(&self) -> SectionVector {
        SectionVector {
            radial: self.normal[0] * self.force_n,
            axial: self.normal[1] * self.force_n,
        }
    }
}

/// Contacts of a ball with the rings as of the last evaluation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallContacts {
    /// Both points at the outer raceway, that at the inner one.
    points: [ContactPoint; PLACES],
}

/// Angle of a force of a contact from the radius; NaN without one.
fn angle_rad(force: SectionVector) -> f64 {
    match force == SectionVector::default() {
        true => f64::NAN,
        false => force.axial.atan2(force.radial),
    }
}

impl From<ContactPoint> for RacewayPoint {
    fn from(point: ContactPoint) -> Self {
        Self {
            force_n: point.force_n,
            cosine: point.normal[0],
        }
    }
}

impl BallContacts {
    /// Contact angle at the inner raceway, positive where an axial load along +Z presses, rad;
    /// NaN without contact.
    pub(crate) fn inner_contact_angle_rad(&self) -> f64 {
        angle_rad(self.inner_force_n())
    }

    /// Angle of the force at the outer raceway, rad; NaN without contact.
    pub(crate) fn outer_contact_angle_rad(&self) -> f64 {
        angle_rad(self.outer_force_n())
    }

    /// Force at the inner raceway along the radius and against the axis of the ring, N.
    pub(crate) fn inner_force_n(&self) -> SectionVector {
        self.points[INNER].force()
    }

    /// Force at the outer raceway along the radius and the axis, N.
    pub(crate) fn outer_force_n(&self) -> SectionVector {
        let [a, b] = [0, 1].map(|place| self.points[place].force());
        SectionVector {
            radial: a.radial + b.radial,
            axial: a.axial + b.axial,
        }
    }

    /// Where the ball bears on the inner raceway.
    #[inline]
    pub(crate) fn inner_point(&self) -> RacewayPoint {
        self.points[INNER].into()
    }

    /// The more loaded of the points at the outer raceway.
    #[inline]
    pub(crate) fn outer_point(&self) -> RacewayPoint {
        let [a, b, _] = self.points;
        if b.force_n > a.force_n { b } else { a }.into()
    }

    /// The points that bear, each with its ring: 0 for the inner, 1 for the outer one.
    #[inline]
    pub(crate) fn bearing_points(&self) -> impl Iterator<Item = (usize, &ContactPoint)> {
        let rings = [1, 1, 0].into_iter().zip(&self.points);
        rings.filter(|(_, point)| point.force_n > 0.0)
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
    /// Outer rings that slide.
    pub sliding: Vec<SlidingWork>,
    /// Whether the last evaluation with friction was the end of an implicit step.
    pub known: bool,
}

impl SpaceWorkspace {
    pub(crate) fn new(model: &Model, space: &SpaceModel) -> Self {
        let under = model.under_rotor.as_ref();
        let shoulder = under.and_then(|under| under.shoulder.as_ref());
        Self {
            ring: RingMotion::at_rest(),
            outer_ring_velocity: [0.0; 3],
            blocks: (0..space.balls.len())
                .step_by(LANES)
                .map(|first| SpaceBlock::new(model, space, first))
                .collect(),
            known: false,
            rotor: RotorTouch::new(shoulder),
            sliding: vec![SlidingWork::default(); space.sliding.len()],
        }
    }

    /// Motions of the rings as of the last evaluation.
    #[inline(always)]
    pub(super) fn rings(&self) -> RingMotions {
        RingMotions {
            inner: self.ring,
            outer_velocity: self.outer_ring_velocity,
        }
    }

    /// Contacts of ball `k`.
    #[inline]
    pub(crate) fn contacts(&self, k: usize) -> BallContacts {
        let (block, lane) = (&self.blocks[k / LANES], k % LANES);
        let normals = [
            [&block.outer.radial_0, &block.outer.axial_0],
            [&block.outer.radial_1, &block.outer.axial_1],
            [&block.inner.cosine, &block.inner.sine],
        ];
        let point = |place: usize| ContactPoint {
            force_n: block.frames[place].force_n.0[lane],
            normal: normals[place].map(|lanes| lanes.0[lane]),
            half_length_m: block.frames[place].half_length_m.0[lane],
        };
        BallContacts {
            points: [point(0), point(1), point(INNER)],
        }
    }

    /// Force of the balls of a row on its outer ring along +Z, N.
    pub(crate) fn row_force_n(&self, layout: Layout, row: usize) -> f64 {
        let balls = row * layout.row..(row + 1) * layout.row;
        let along = |k: usize| self.blocks[k / LANES].outer_ring_force_n[2].0[k % LANES];
        balls.map(along).sum()
    }

    /// Force of the balls on the outer ring, N.
    pub(crate) fn outer_ring_force_n(&self) -> [f64; 3] {
        [0, 1, 2].map(|axis| {
            let lanes = self.blocks.iter().map(|b| b.outer_ring_force_n[axis].0);
            lanes.flatten().sum()
        })
    }
}
