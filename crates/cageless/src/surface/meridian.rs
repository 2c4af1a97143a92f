//! The groove in one meridian plane: two arcs that meet in the ridge between the flanks, on the
//! plain raceway one arc in two parts.

use super::arc::{Arc, SurfacePoint};
use super::section_frame::SectionFrame;
use super::side::Side;

/// Section of the groove at one ψ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meridian {
    /// ψ.
    pub angle_rad: f64,
    /// α, half the angle between the flanks' contacts; 0 on the plain raceway.
    pub flank_angle_rad: f64,
    /// Upper and lower.
    pub arcs: [Arc; 2],
}

impl Meridian {
    /// Section at ψ with the flank angle α and dα/dψ.
    pub(super) fn new(frame: &SectionFrame, angle_rad: f64, flank: [f64; 2]) -> Self {
        Self {
            angle_rad,
            flank_angle_rad: flank[0],
            arcs: Side::BOTH.map(|side| Arc::new(frame, side, flank)),
        }
    }

    /// The arc of one side.
    pub fn arc(&self, side: Side) -> &Arc {
        match side {
            Side::Upper => &self.arcs[0],
            Side::Lower => &self.arcs[1],
        }
    }

    /// Largest distance of the groove from the axis.
    pub(crate) fn deepest_radius_m(&self) -> f64 {
        let [upper, lower] = self.arcs.map(|arc| arc.deepest_radius_m());
        upper.max(lower)
    }

    /// Angle between the normals on both sides of the ridge.
    pub(crate) fn ridge_rad(&self) -> f64 {
        self.arcs.iter().map(Arc::valley_rad).sum()
    }

    /// Point of the surface at η, the angle at the centre of an arc from the outward radius
    /// towards +z: of the upper arc from αg on, of the lower one below it.
    pub(crate) fn point(&self, meridian_rad: f64) -> SurfacePoint {
        let [upper, lower] = &self.arcs;
        let below = meridian_rad < upper.axis_rad;
        let arc = if below { lower } else { upper };
        arc.point(self.angle_rad, arc.side.sign() * meridian_rad)
    }

    /// Distance of the point (ρ, z) of this plane from the surface along its normal,
    /// positive inside the material.
    pub(super) fn distance_m(&self, radius_m: f64, z_m: f64) -> f64 {
        let [upper, lower] = &self.arcs;
        if upper.has(radius_m, z_m) {
            upper.distance_m(radius_m, z_m)
        } else {
            lower.distance_m(radius_m, -z_m)
        }
    }
}
