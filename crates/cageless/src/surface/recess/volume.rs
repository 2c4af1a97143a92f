//! Volume of a slot below the plain groove.
//!
//! By Gauss's theorem for the field (x, y, 0)/2: its flux through the rounded edge and the walls, and
//! through floor and groove, which are surfaces of revolution, ∬ ρ²/2 dz dψ = −∮ (∫ ρ²/2 dz) dψ along their
//! borders (Green).

use std::f64::consts::FRAC_PI_2;

use super::edge_place::EdgePlace;
use super::recess_frame::RecessFrame;
use super::strip::{Part, Strip};
use crate::numerics::bspline::Vec3;
use crate::numerics::quadrature::gauss;
use crate::numerics::vector::{cross, dot};
use crate::surface::sheet::{Fibre, Sheet};

/// Gauss panels of ten points along a stretch.
const PANELS: usize = 6;

/// ∫ over all stretches of the edge.
pub(super) fn volume_m3(frame: &RecessFrame) -> f64 {
    let straight = frame.straight_rad;
    let stretches = [
        (EdgePlace::End(1.0, 0.0), FRAC_PI_2, 1.0),
        (EdgePlace::End(-1.0, 0.0), FRAC_PI_2, -1.0),
        (EdgePlace::Straight(1.0, 0.0), straight, -1.0),
        (EdgePlace::Straight(-1.0, 0.0), straight, 1.0),
    ];
    // Anticlockwise in a plane with ψ to the right and z up.
    let of = |(from, half, sense): (EdgePlace, f64, f64)| {
        let column = |along| column_m3(frame, from, along);
        sense * gauss(column, -half, half, PANELS)
    };
    stretches.into_iter().map(of).sum()
}

/// Volume under one line across the edge, m³ per radian along the edge.
fn column_m3(frame: &RecessFrame, from: EdgePlace, along_rad: f64) -> f64 {
    let [arc, wall] =
        [Part::Rounded, Part::Wall].map(|part| Strip { frame, from, part }.fibre(along_rad));
    let flux = |fibre: &dyn Fibre| {
        let through = |u: f64| {
            let [x, y, _] = fibre.point(u);
            dot([x, y, 0.0], cross(fibre.along(u), fibre.across(u))) / 2.0
        };
        gauss(through, 0.0, 1.0, 1)
    };
    let [groove, floor] = [arc.point(0.0), wall.point(1.0)];
    let turning = |[x, y, _]: Vec3, [dx, dy, _]: Vec3| (x * dy - y * dx) / (x * x + y * y);
    flux(&arc) + flux(&wall) - frame.floor_moment_m3(floor) * turning(floor, wall.along(1.0))
        + frame.groove_moment_m3(groove) * turning(groove, arc.along(0.0))
}
