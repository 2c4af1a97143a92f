//! The numbers of an exported ring.

use cageless::surface::{OuterRing, Recess, RingMeasures};
use serde::Serialize;

use super::format::Format;

/// `export --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExportNumbers {
    /// Kind of file.
    pub format: Format,
    /// Path of the file; `None` without one or on stdout.
    pub file: Option<String>,
    /// Size of the file.
    pub bytes: u64,
    /// Volume of the analytic solid.
    pub volume_mm3: f64,
    /// Largest distance of the file from the analytic surface.
    pub deviation_um: f64,
    /// Length of the blends; 0 for none.
    pub blend_mm: f64,
    /// Sentence about a blend not simulated by the case; `None` without such a blend.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blend_not_simulated: Option<String>,
    /// Largest distance between the blended surface and the one designed.
    pub blend_deviation_um: f64,
    /// Angle left between the normals at an end of a raceway, 45° up the groove; 0 if
    /// blended.
    pub slope_discontinuity_45_deg: f64,
    /// Value at the shoulder.
    pub slope_discontinuity_shoulder_deg: f64,
    /// Slope discontinuity of the raceway as designed.
    pub design_slope_discontinuity_45_deg: f64,
    /// Value at the shoulder.
    pub design_slope_discontinuity_shoulder_deg: f64,
    /// Angle between the normals of the two flanks of a raceway where they meet.
    pub apex_angle_deg: f64,
    /// Largest material above the plain groove.
    pub above_plain_um: f64,
    /// Below it.
    pub below_plain_um: f64,
    /// Number of discrete raceways.
    pub raceways: usize,
    /// Dimensions of the slots among them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub slots: Vec<SlotNumbers>,
    /// Contact angle by which the sections are turned, positive towards +z; `None` for 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_angle_deg: Option<f64>,
    /// z of the centre of the groove from the middle of the ring; `None` for 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub groove_centre_z_mm: Option<f64>,
    /// Contents of the file.
    #[serde(flatten)]
    pub counts: Counts,
}

/// Dimensions of a slot.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SlotNumbers {
    /// Angle of its middle.
    pub centre_angle_deg: f64,
    /// Distance of its walls.
    pub width_mm: f64,
    /// Depth of its floor below the bottom of the plain groove.
    pub depth_mm: f64,
    /// Radius of its edges.
    pub edge_radius_mm: f64,
    /// Half the angle that it takes up.
    pub half_angle_deg: f64,
    /// Half the angle over which it is as wide as in the middle.
    pub straight_half_angle_deg: f64,
}

/// A file of the ring.
#[derive(Debug)]
pub(super) struct RingFile {
    pub bytes: Vec<u8>,
    /// Largest distance of its surfaces from the analytic ones.
    pub deviation_m: f64,
    pub counts: Counts,
}

/// Contents of the file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Counts {
    /// Counts of a STEP file.
    Step {
        /// Largest distance from the analytic surface that was allowed.
        tolerance_um: f64,
        /// Faces.
        faces: usize,
        /// B-spline faces.
        bspline_faces: usize,
        /// Edges.
        edges: usize,
        /// Deviation of the B-splines.
        control_points: usize,
    },
    /// Counts of an STL file.
    Stl {
        /// Largest distance from the analytic surface that was allowed.
        chord_um: f64,
        /// Triangles.
        triangles: usize,
        /// Corners.
        vertices: usize,
        /// Volume of the mesh.
        mesh_volume_mm3: f64,
    },
    /// Counts of a CSV file.
    Csv {
        /// Largest distance of neighbouring points that was allowed.
        spacing_mm: f64,
        /// Distance of the sections.
        row_distance_mm: f64,
        /// Points of the surface.
        surface_points: usize,
        /// Points of the contact track.
        contact_points: usize,
    },
}

impl ExportNumbers {
    /// The numbers of a file of `bytes` bytes.
    pub(super) fn new(
        ring: &OuterRing,
        format: Format,
        bytes: u64,
        deviation_m: f64,
        counts: Counts,
    ) -> Self {
        let RingMeasures {
            volume_m3,
            design_kink_rad,
            kink_rad,
            ridge_rad,
            blend_deviation_m,
            relief_m,
        } = ring.measures();
        let [slope_discontinuity_45_deg, slope_discontinuity_shoulder_deg] =
            kink_rad.map(f64::to_degrees);
        let [
            design_slope_discontinuity_45_deg,
            design_slope_discontinuity_shoulder_deg,
        ] = design_kink_rad.map(f64::to_degrees);
        let [above_plain_um, below_plain_um] = relief_m.map(|m| m * 1e6);
        let [blend_mm, groove_centre_z_mm] =
            [ring.blend_m(), ring.groove_height_m].map(millimetres);
        let raceways = ring.raceways().count();
        Self {
            format,
            file: None,
            bytes,
            volume_mm3: volume_m3 * 1e9,
            deviation_um: deviation_m * 1e6,
            blend_mm,
            blend_not_simulated: None,
            blend_deviation_um: blend_deviation_m * 1e6,
            slope_discontinuity_45_deg,
            slope_discontinuity_shoulder_deg,
            design_slope_discontinuity_45_deg,
            design_slope_discontinuity_shoulder_deg,
            apex_angle_deg: ridge_rad.to_degrees(),
            above_plain_um,
            below_plain_um,
            raceways,
            slots: ring.recesses.iter().map(SlotNumbers::new).collect(),
            contact_angle_deg: unless_zero(ring.section_angle_rad.to_degrees()),
            groove_centre_z_mm: unless_zero(groove_centre_z_mm),
            counts,
        }
    }
}

impl SlotNumbers {
    fn new(slot: &Recess) -> Self {
        let [width_mm, depth_mm, edge_radius_mm] =
            [slot.width_m, slot.depth_m, slot.edge_radius_m].map(millimetres);
        let straight_rad = slot.straight_rad.unwrap_or(0.0);
        let [centre_angle_deg, half_angle_deg, straight_half_angle_deg] =
            [slot.middle_rad, slot.half_angle_rad, straight_rad].map(f64::to_degrees);
        Self {
            centre_angle_deg,
            width_mm,
            depth_mm,
            edge_radius_mm,
            half_angle_deg,
            straight_half_angle_deg,
        }
    }
}

fn millimetres(m: f64) -> f64 {
    m * 1e3
}

fn unless_zero(value: f64) -> Option<f64> {
    (value != 0.0).then_some(value)
}
