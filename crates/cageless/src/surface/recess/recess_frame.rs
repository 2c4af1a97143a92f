//! Dimensions of a slot in the frame of its section.

use crate::error::{Allowed, InputError};
use crate::numerics::bspline::Vec3;
use crate::raceway::{Raceway, Slot};
use crate::surface::arc::moment_m3;
use crate::surface::section_frame::SectionFrame;

/// Where a slot is and how large. A place in a section counts from the centre of the plain groove's arc,
/// outwards along the axis of the section and across it towards +z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RecessFrame {
    /// αg.
    pub axis_rad: f64,
    /// ρ and z of the centre of the plain groove's arc.
    pub groove_m: [f64; 2],
    /// Re.
    pub curvature_radius_m: f64,
    /// Ro.
    pub groove_bottom_radius_m: f64,
    /// ψ of the middle.
    pub middle_rad: f64,
    /// ψ from there of the last places at full width.
    pub straight_rad: f64,
    /// re.
    pub edge_radius_m: f64,
    /// Rw + re.
    pub ball_reach_m: f64,
    /// ze in the middle, and radius of the ends.
    pub half_span_m: f64,
    /// Floor along the axis of the section.
    pub floor_m: f64,
}

impl RecessFrame {
    /// Frame of a slot in a ring with such sections.
    ///
    /// # Errors
    /// An [`InputError`] if the edges around an end would meet.
    pub(super) fn new(
        section: &SectionFrame,
        raceway: &Raceway,
        slot: &Slot,
    ) -> Result<Self, InputError> {
        let ([radius, height], (sin, cos)) = (section.ball_m, section.axis_rad.sin_cos());
        let groove_m = [
            radius - section.offset_m * cos,
            height - section.offset_m * sin,
        ];
        let frame = Self {
            axis_rad: section.axis_rad,
            groove_m,
            curvature_radius_m: section.curvature_radius_m,
            groove_bottom_radius_m: slot.groove_bottom_radius_m(),
            middle_rad: raceway.dimensions().centre_angle_rad,
            straight_rad: slot.straight_rad(),
            edge_radius_m: slot.edge_radius_m,
            ball_reach_m: section.curvature_radius_m - section.offset_m + slot.edge_radius_m,
            half_span_m: slot.half_span_m(),
            floor_m: section.curvature_radius_m + slot.depth_m,
        };
        // Curvature of the line of centres at the tip, where it is an ellipse in plan.
        let [tip_m, _] = frame.section_m(frame.curvature_radius_m + frame.edge_radius_m, 0.0);
        let sharpest_m = frame.half_span_m * frame.groove_bottom_radius_m / tip_m;
        let why = "the walls around the ends of the slot would meet";
        Allowed::Below(sharpest_m, why).check("edge_radius_m", frame.edge_radius_m)?;
        Ok(frame)
    }

    /// ρ and z of a place in a section.
    pub(super) fn section_m(&self, along_m: f64, across_m: f64) -> [f64; 2] {
        let [radial, axial] = self.turned(along_m, across_m);
        [self.groove_m[0] + radial, self.groove_m[1] + axial]
    }

    /// Components outwards and along z of a vector in a section.
    pub(super) fn turned(&self, along: f64, across: f64) -> [f64; 2] {
        let (sin, cos) = self.axis_rad.sin_cos();
        [along * cos - across * sin, along * sin + across * cos]
    }

    /// Distance of a point from the floor, positive inside the slot.
    pub(super) fn above_floor_m(&self, [x, y, z]: Vec3) -> f64 {
        let (sin, cos) = self.axis_rad.sin_cos();
        let along = (x.hypot(y) - self.groove_m[0]) * cos + (z - self.groove_m[1]) * sin;
        self.floor_m - along
    }

    /// Distance of a point from the axis of its section, towards +z.
    pub(super) fn across_m(&self, [x, y, z]: Vec3) -> f64 {
        let (sin, cos) = self.axis_rad.sin_cos();
        (z - self.groove_m[1]) * cos - (x.hypot(y) - self.groove_m[0]) * sin
    }

    /// ∫ ρ²/2 dz along the floor, to this point of it.
    pub(super) fn floor_moment_m3(&self, point: Vec3) -> f64 {
        let ((sin, cos), [middle, _]) =
            (self.axis_rad.sin_cos(), self.section_m(self.floor_m, 0.0));
        let across = self.across_m(point);
        let square = middle * (middle - across * sin) + (across * sin).powi(2) / 3.0;
        cos / 2.0 * across * square
    }

    /// ∫ ρ²/2 dz along the plain groove, to this point of it.
    pub(super) fn groove_moment_m3(&self, [x, y, z]: Vec3) -> f64 {
        let eta = (z - self.groove_m[1]).atan2(x.hypot(y) - self.groove_m[0]);
        moment_m3(self.groove_m[0], self.curvature_radius_m, eta) / 2.0
    }
}
