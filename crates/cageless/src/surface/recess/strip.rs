//! The rounded edge and the wall of a slot along one of its stretches, as sheets.

use super::edge::Edge;
use super::edge_place::EdgePlace;
use super::recess_frame::RecessFrame;
use crate::numerics::bspline::Vec3;
use crate::numerics::vector::{dot, plus};
use crate::surface::sheet::{Fibre, Sheet};

/// Step of differences along a stretch: their errors are below 1e-11 of the radius of the end.
const STEP_RAD: f64 = 2e-3;
/// Central differences of fourth order: multiples of the step and weights.
const STENCIL: [(f64, f64); 4] = [
    (-2.0, 1.0 / 12.0),
    (-1.0, -2.0 / 3.0),
    (1.0, 2.0 / 3.0),
    (2.0, -1.0 / 12.0),
];

/// Part of a slot between the groove and the floor.
#[derive(Clone, Copy)]
pub(super) enum Part {
    /// From the groove to the wall.
    Rounded,
    /// From there to the floor.
    Wall,
}

/// A part along a stretch, over the angle from a place on it and a share of the arc or of the wall.
pub(super) struct Strip<'a> {
    pub frame: &'a RecessFrame,
    pub from: EdgePlace,
    pub part: Part,
}

impl Strip<'_> {
    fn edge(&self, along_rad: f64) -> Edge {
        Edge::new(self.frame, self.from.moved(along_rad))
    }
}

impl Sheet for Strip<'_> {
    type Fibre = StripFibre;

    fn fibre(&self, along_rad: f64) -> StripFibre {
        StripFibre {
            part: self.part,
            edge: self.edge(along_rad),
            around: STENCIL.map(|(steps, _)| self.edge(along_rad + steps * STEP_RAD)),
        }
    }

    /// Along the normal; at the floor also from it.
    fn off_m(&self, point: Vec3, along_rad: f64, across: f64) -> f64 {
        let edge = self.edge(along_rad);
        let share = match self.part {
            Part::Rounded => across,
            Part::Wall => 1.0,
        };
        let from = plus(point, -1.0, self.part.point(&edge, across));
        let off = dot(from, edge.normal(share)).abs();
        match self.part {
            Part::Wall if across == 1.0 => off.max(self.frame.above_floor_m(point).abs()),
            _ => off,
        }
    }
}

impl Part {
    fn point(self, edge: &Edge, across: f64) -> Vec3 {
        match self {
            Self::Rounded => edge.arc_m(across),
            Self::Wall => edge.wall_m(across),
        }
    }

    fn slope(self, edge: &Edge, across: f64) -> Vec3 {
        match self {
            Self::Rounded => edge.arc_slope_m(across),
            Self::Wall => edge.mill.map(|c| edge.wall_length_m * c),
        }
    }
}

/// A part at one angle.
pub(super) struct StripFibre {
    part: Part,
    edge: Edge,
    around: [Edge; 4],
}

impl StripFibre {
    fn difference(&self, of: impl Fn(&Edge) -> Vec3) -> Vec3 {
        let terms = self.around.iter().zip(STENCIL);
        terms.fold([0.0; 3], |total, (edge, (_, weight))| {
            plus(total, weight / STEP_RAD, of(edge))
        })
    }
}

impl Fibre for StripFibre {
    fn point(&self, across: f64) -> Vec3 {
        self.part.point(&self.edge, across)
    }

    fn across(&self, across: f64) -> Vec3 {
        self.part.slope(&self.edge, across)
    }

    fn along(&self, across: f64) -> Vec3 {
        self.difference(|edge| self.part.point(edge, across))
    }

    fn twist(&self, across: f64) -> Vec3 {
        self.difference(|edge| self.part.slope(edge, across))
    }
}
