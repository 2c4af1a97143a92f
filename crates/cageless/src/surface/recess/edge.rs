//! The rounded edge of a slot at one place along it.

use super::centre_line::CentreLine;
use super::edge_place::EdgePlace;
use super::recess_frame::RecessFrame;
use crate::numerics::bspline::Vec3;
use crate::numerics::vector::{cross, dot, plus};
use crate::surface::directions::vector;

/// Section of the edge across its line of centres: an arc of radius re from the groove to the wall, and
/// the wall from there to the floor, along the axis of the mill.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// ψ of the centre of the arc.
    pub angle_rad: f64,
    /// η at which the plain groove runs into the arc, from the outward radius towards +z.
    pub groove_rad: f64,
    /// Centre of the arc.
    pub centre_m: Vec3,
    /// d/dχ or d/dψ of it.
    pub(super) along_m: Vec3,
    /// Unit normal out of the material where the arc leaves the groove.
    pub groove: Vec3,
    /// Unit vector into the slot, square to it and to the line of centres.
    pub inside: Vec3,
    /// Unit vector in the section to the centre of the nominal ball that rests on both edges.
    pub ball: Vec3,
    /// Axis of the mill, into the material.
    pub mill: Vec3,
    /// Angle of the arc.
    pub arc_rad: f64,
    /// re.
    pub radius_m: f64,
    /// Length of the wall.
    pub wall_length_m: f64,
}

impl Edge {
    pub(super) fn new(frame: &RecessFrame, place: EdgePlace) -> Self {
        let mut edge = Self::without_wall(frame, &CentreLine::new(frame, place));
        // The floor is nearly square to the mill, so that few steps reach it.
        for _ in 0..8 {
            edge.wall_length_m += frame.above_floor_m(edge.wall_m(1.0));
        }
        edge
    }

    /// With a wall of no length.
    pub(super) fn without_wall(frame: &RecessFrame, line: &CentreLine) -> Self {
        let across = line.across_m;
        let reach = frame.curvature_radius_m + frame.edge_radius_m;
        let groove_rad = frame.axis_rad + (across / reach).asin();
        let groove = vector(line.angle_rad, [-groove_rad.cos(), 0.0, -groove_rad.sin()]);
        let inside = cross(groove, line.along_m);
        let length = dot(inside, inside).sqrt();
        let inside = inside.map(|c| line.sense * c / length);
        let sin = across / frame.ball_reach_m;
        let to_ball = frame.turned((1.0 - sin * sin).sqrt(), sin);
        let [out, up] = frame.turned(1.0, 0.0);
        let mill = vector(line.mill_rad, [out, 0.0, up]);
        Self {
            angle_rad: line.angle_rad,
            groove_rad,
            centre_m: line.centre_m,
            along_m: line.along_m,
            groove,
            inside,
            ball: vector(line.angle_rad, [-to_ball[0], 0.0, -to_ball[1]]),
            mill,
            // The normal of the wall is square to the mill.
            arc_rad: (-dot(groove, mill)).atan2(dot(inside, mill)),
            radius_m: frame.edge_radius_m,
            wall_length_m: 0.0,
        }
    }

    /// Unit normal out of the material at a share of the arc, from the groove on.
    pub(crate) fn normal(&self, share: f64) -> Vec3 {
        let (sin, cos) = (share * self.arc_rad).sin_cos();
        plus(self.groove.map(|c| cos * c), sin, self.inside)
    }

    /// Point at a share of the arc.
    pub fn arc_m(&self, share: f64) -> Vec3 {
        plus(self.centre_m, self.radius_m, self.normal(share))
    }

    /// Derivative of the point over the share, m.
    pub(super) fn arc_slope_m(&self, share: f64) -> Vec3 {
        let (sin, cos) = (share * self.arc_rad).sin_cos();
        let scale = self.radius_m * self.arc_rad;
        plus(
            self.groove.map(|c| -scale * sin * c),
            scale * cos,
            self.inside,
        )
    }

    /// Point at a share of the wall, from the arc on.
    pub fn wall_m(&self, share: f64) -> Vec3 {
        plus(self.arc_m(1.0), share * self.wall_length_m, self.mill)
    }

    /// Share of the arc at which its normal is nearest to this direction.
    pub(crate) fn share_towards(&self, direction: Vec3) -> f64 {
        dot(direction, self.inside).atan2(dot(direction, self.groove)) / self.arc_rad
    }
}
