//! The line on which the centres of the rounded edges of a slot lie, at one place.

use super::edge_place::EdgePlace;
use super::recess_frame::RecessFrame;
use crate::numerics::bspline::Vec3;
use crate::surface::directions::vector;

/// Re + re from the centre of the groove's arc and ze(ψ) from the axis of the section.
#[derive(Debug, Clone, Copy)]
pub(super) struct CentreLine {
    /// ψ.
    pub angle_rad: f64,
    /// Distance from the axis of the section, towards +z.
    pub across_m: f64,
    /// The point.
    pub centre_m: Vec3,
    /// d/dχ or d/dψ of it.
    pub along_m: Vec3,
    /// ψ of the mill.
    pub mill_rad: f64,
    /// Side of the line on which the slot is.
    pub sense: f64,
}

impl CentreLine {
    pub(super) fn new(frame: &RecessFrame, place: EdgePlace) -> Self {
        let half = frame.half_span_m;
        // ψ from the middle and distance from the axis of the section with their slopes.
        let ([local, turning], [across, crossing], mill_rad, sense) = match place {
            EdgePlace::End(end, turn) => {
                let (sin, cos) = turn.sin_cos();
                let angle = half / frame.groove_bottom_radius_m;
                let local = end * (frame.straight_rad + angle * cos);
                let turning = -end * angle * sin;
                let last = end * frame.straight_rad;
                ([local, turning], [half * sin, half * cos], last, -end)
            }
            EdgePlace::Straight(side, local) => ([local, 1.0], [side * half, 0.0], local, side),
        };
        let reach = frame.curvature_radius_m + frame.edge_radius_m;
        let depth = (reach * reach - across * across).sqrt();
        let [radius, height] = frame.section_m(depth, across);
        let [climb, rise] = frame.turned(-across * crossing / depth, crossing);
        let angle_rad = frame.middle_rad + local;
        Self {
            angle_rad,
            across_m: across,
            centre_m: vector(angle_rad, [radius, 0.0, height]),
            along_m: vector(angle_rad, [climb, radius * turning, rise]),
            mill_rad: frame.middle_rad + mill_rad,
            sense,
        }
    }
}
