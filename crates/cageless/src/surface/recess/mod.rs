//! A slot as it is cut through the bottom of the plain groove: rounded edges, walls and floor.
//!
//! The edges have the radius re about a closed line of centres, Re + re from the centre of the groove's arc
//! and ze(ψ) on both sides of the axis of the section, as a ball feels them ([`crate::raceway::Slot`]). On
//! the half circles of the ends, where it crosses the sections, the arcs are square to the line. The walls
//! go on from them along the axis of the mill, which points outwards in the middle of the section; over an
//! end it stays where it is at its last full width. The floor is the surface of revolution at the depth D.

mod centre_line;
mod edge;
mod edge_fit;
mod edge_place;
mod measured_slot;
mod recess_frame;
mod strip;
mod volume;

use std::f64::consts::FRAC_PI_2;

pub use edge::Edge;
pub use edge_place::EdgePlace;
pub use measured_slot::MeasuredSlot;

use super::patch::{Patch, PatchError};
use super::section_frame::SectionFrame;
use super::side::Side;
use crate::error::InputError;
use crate::numerics::bspline::Vec3;
use crate::numerics::vector::{dot, plus};
use crate::raceway::{Raceway, Slot};
use recess_frame::RecessFrame;
use strip::{Part, Strip};
use volume::volume_m3;

/// A slot in the ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recess {
    /// Index of its raceway.
    raceway: usize,
    frame: RecessFrame,
    /// ψ of the middle.
    pub middle_rad: f64,
    /// θ, half of the length along the bottom.
    pub half_angle_rad: f64,
    /// ψ from the middle of the last places at full width; `None` if the ends meet there.
    pub straight_rad: Option<f64>,
    /// αg.
    pub section_angle_rad: f64,
    /// re.
    pub edge_radius_m: f64,
    /// Width between the walls.
    pub width_m: f64,
    /// D, depth of the floor below the bottom of the plain groove.
    pub depth_m: f64,
}

/// ψ below which there is no straight stretch: it is rounding of its length.
const STRAIGHT_MIN_RAD: f64 = 1e-9;
/// Steps to the nearest place of an edge.
const STEPS: usize = 12;

impl Recess {
    /// Recess of a slot in a ring with such sections.
    pub(super) fn new(
        section: &SectionFrame,
        index: usize,
        raceway: &Raceway,
        slot: &Slot,
    ) -> Result<Self, InputError> {
        let frame = RecessFrame::new(section, raceway, slot)?;
        let straight_rad = Some(frame.straight_rad);
        Ok(Self {
            raceway: index,
            middle_rad: frame.middle_rad,
            half_angle_rad: raceway.half_angle_rad(),
            straight_rad: straight_rad.filter(|straight| *straight > STRAIGHT_MIN_RAD),
            section_angle_rad: frame.axis_rad,
            edge_radius_m: frame.edge_radius_m,
            width_m: slot.width_m(),
            depth_m: slot.depth_m,
            frame,
        })
    }

    /// Index of its raceway.
    pub(super) fn raceway(&self) -> usize {
        self.raceway
    }

    /// Angle about the axis that an end takes up.
    pub(super) fn end_rad(&self) -> f64 {
        self.frame.half_span_m / self.frame.groove_bottom_radius_m
    }

    /// Edge of the slot at a place.
    pub fn edge(&self, place: EdgePlace) -> Edge {
        Edge::new(&self.frame, place)
    }

    /// Both edges, lower and upper, where their centres are at ψ from the middle, within ±θ.
    pub fn edges_at(&self, local_rad: f64) -> [Edge; 2] {
        let into = (local_rad.abs() - self.frame.straight_rad) / self.end_rad();
        let turn = into.min(1.0).acos();
        [-1.0, 1.0].map(|side| {
            self.edge(match into > 0.0 {
                true => EdgePlace::End(1f64.copysign(local_rad), side * turn),
                false => EdgePlace::Straight(side, local_rad),
            })
        })
    }

    /// ρ and z of the plain groove where the straight edge of a side leaves it, of the centre of its arc, of
    /// the arc's end at the wall and of the wall's end at the floor.
    pub fn straight_m(&self, side: Side) -> [[f64; 2]; 4] {
        let edge = self.edge(EdgePlace::Straight(side.sign(), 0.0));
        let points = [
            edge.arc_m(0.0),
            edge.centre_m,
            edge.arc_m(1.0),
            edge.wall_m(1.0),
        ];
        points.map(|[x, y, z]| [x.hypot(y), z])
    }

    /// Rounded edge and wall around the end that is 1 or −1 along ψ, over χ from −90° to 90° and across
    /// from the groove to the wall and from there to the floor.
    ///
    /// # Errors
    /// That of [`Patch::pair`].
    pub fn end_patches(&self, end: f64, tolerance_m: f64) -> Result<[Patch; 2], PatchError> {
        Patch::of(&self.strips(end), -FRAC_PI_2..FRAC_PI_2, tolerance_m)
    }

    /// Largest distance of both from the analytic surface.
    pub fn end_deviation_m(&self, end: f64, patches: &[Patch; 2]) -> f64 {
        let pairs = patches.iter().zip(self.strips(end));
        pairs
            .map(|(patch, strip)| patch.off_m(&strip))
            .fold(0.0, f64::max)
    }

    fn strips(&self, end: f64) -> [Strip<'_>; 2] {
        let (frame, from) = (&self.frame, EdgePlace::End(end, 0.0));
        [Part::Rounded, Part::Wall].map(|part| Strip { frame, from, part })
    }

    /// Largest distance of the floor from the axis.
    pub(super) fn deepest_radius_m(&self) -> f64 {
        Side::BOTH
            .map(|side| self.straight_m(side)[3][0])
            .into_iter()
            .fold(0.0, f64::max)
    }

    /// Largest |z| of the floor.
    pub(super) fn widest_m(&self) -> f64 {
        Side::BOTH
            .map(|side| self.straight_m(side)[3][1].abs())
            .into_iter()
            .fold(0.0, f64::max)
    }

    /// Point of the floor between the walls below two edges, lower and upper, at a share of the way from the
    /// one of a side.
    pub(super) fn floor_m(&self, edges: &[Edge; 2], share: f64, side: Side) -> Vec3 {
        let [lower, upper] = edges.each_ref().map(|edge| edge.wall_m(1.0));
        let (from, to) = match side {
            Side::Lower => (lower, upper),
            Side::Upper => (upper, lower),
        };
        let chord = plus(from, share, plus(to, -1.0, from));
        plus(
            chord,
            -self.frame.above_floor_m(chord),
            self.floor_normal(chord),
        )
    }

    /// Unit normal of the floor at a point, out of the material.
    pub(crate) fn floor_normal(&self, [x, y, _]: Vec3) -> Vec3 {
        let [out, up] = self.frame.turned(-1.0, 0.0);
        super::directions::vector(x.atan2(-y), [out, 0.0, up])
    }

    /// Distance of a point near the floor from it, positive inside the material.
    pub(crate) fn below_floor_m(&self, point: Vec3) -> f64 {
        -self.frame.above_floor_m(point)
    }

    /// Distance of a point near the rounded edge from it, positive inside the material; the edge is
    /// sought from a place on.
    pub(crate) fn below_edge_m(&self, point: Vec3, near: EdgePlace) -> f64 {
        self.below_arc_m(point, near, |_, from| from)
    }

    /// [`Self::below_edge_m`] of the wall.
    pub(crate) fn below_wall_m(&self, point: Vec3, near: EdgePlace) -> f64 {
        // Along the mill wall and edge are one circle around the line of centres.
        self.below_arc_m(point, near, |edge, from| {
            plus(from, -dot(from, edge.mill), edge.mill)
        })
    }

    fn below_arc_m(&self, point: Vec3, near: EdgePlace, seen: impl Fn(&Edge, Vec3) -> Vec3) -> f64 {
        let mut place = near;
        for _ in 0..STEPS {
            let edge = self.edge(place);
            let from = seen(&edge, plus(point, -1.0, edge.centre_m));
            let along = seen(&edge, edge.along_m);
            place = place.moved(dot(from, along) / dot(along, along));
        }
        let edge = self.edge(place);
        let from = seen(&edge, plus(point, -1.0, edge.centre_m));
        edge.radius_m - dot(from, from).sqrt()
    }

    /// Volume below the plain groove.
    pub(super) fn volume_m3(&self) -> f64 {
        volume_m3(&self.frame)
    }
}
