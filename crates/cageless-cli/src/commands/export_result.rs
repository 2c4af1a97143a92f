//! The numbers of `cageless export`.

use cageless::surface::OuterRing;
use serde::Serialize;

use crate::args::CadFormat;
use crate::format::pairs;

/// `export --json`.
#[derive(Debug, Serialize)]
pub struct ExportResult {
    format: &'static str,
    /// Where it was written; null if nowhere or to stdout.
    file: Option<String>,
    bytes: usize,
    /// Of the analytic solid.
    volume_mm3: f64,
    /// Largest distance of the file from the analytic surface.
    deviation_um: f64,
    /// Length of the blends; 0 for none.
    blend_mm: f64,
    /// Largest distance between the blended surface and the one designed.
    blend_deviation_um: f64,
    /// Angle left between the normals at an end of a raceway, 45° up the groove and at the
    /// shoulder; 0 if blended.
    kink_45_deg: f64,
    kink_shoulder_deg: f64,
    /// The same of the raceway as designed.
    design_kink_45_deg: f64,
    design_kink_shoulder_deg: f64,
    /// Angle between the normals of the two halves of a raceway, which meet at z = 0.
    ridge_deg: f64,
    /// How far the raceways stand out of the plain groove, and lie below it.
    above_plain_um: f64,
    below_plain_um: f64,
    raceways: usize,
    #[serde(flatten)]
    counts: Counts,
}

/// What the file holds.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Counts {
    Step {
        tolerance_um: f64,
        faces: usize,
        bspline_faces: usize,
        edges: usize,
        control_points: usize,
    },
    Stl {
        chord_um: f64,
        triangles: usize,
        vertices: usize,
        mesh_volume_mm3: f64,
    },
    Csv {
        spacing_mm: f64,
        row_distance_mm: f64,
        surface_points: usize,
        contact_points: usize,
    },
}

impl ExportResult {
    /// The numbers of a file of `bytes` bytes.
    pub fn new(
        ring: &OuterRing,
        format: CadFormat,
        file: Option<String>,
        bytes: usize,
        deviation_m: f64,
        counts: Counts,
    ) -> Self {
        let [kink_45_deg, kink_shoulder_deg] = ring.kink_rad().map(f64::to_degrees);
        let [design_kink_45_deg, design_kink_shoulder_deg] =
            ring.design_kink_rad().map(f64::to_degrees);
        let [above_plain_um, below_plain_um] = ring.relief_m().map(|m| m * 1e6);
        let raceways = ring.raceways().count();
        Self {
            format: format.name(),
            file,
            bytes,
            volume_mm3: ring.volume_m3() * 1e9,
            deviation_um: deviation_m * 1e6,
            blend_mm: if raceways == 0 {
                0.0
            } else {
                ring.dimensions().blend_m * 1e3
            },
            blend_deviation_um: ring.blend_deviation_m() * 1e6,
            kink_45_deg,
            kink_shoulder_deg,
            design_kink_45_deg,
            design_kink_shoulder_deg,
            ridge_deg: ring.ridge_rad().to_degrees(),
            above_plain_um,
            below_plain_um,
            raceways,
            counts,
        }
    }

    /// For the terminal.
    pub fn text(&self) -> String {
        let r = self;
        let mut lines = vec![
            (
                "file",
                format!(
                    "{}, {} bytes",
                    r.file.as_deref().unwrap_or("stdout"),
                    r.bytes
                ),
            ),
            ("volume of the ring", format!("{:.6} mm³", r.volume_mm3)),
            (
                "deviation from the surface",
                format!("{:.6} µm", r.deviation_um),
            ),
        ];
        lines.push(match r.counts {
        Counts::Step {
            tolerance_um,
            faces,
            bspline_faces,
            edges,
            control_points,
        } => (
            "solid",
            format!(
                "{faces} faces, {bspline_faces} of them B-splines with {control_points} control \
                 points; {edges} edges; tolerance {tolerance_um} µm"
            ),
        ),
        Counts::Stl {
            chord_um,
            triangles,
            vertices,
            mesh_volume_mm3,
        } => (
            "mesh",
            format!(
                "{triangles} triangles, {vertices} corners, {mesh_volume_mm3:.6} mm³; chord error \
                 at most {chord_um} µm"
            ),
        ),
        Counts::Csv {
            spacing_mm,
            row_distance_mm,
            surface_points,
            contact_points,
        } => (
            "points",
            format!(
                "{surface_points} of the surface, {contact_points} of the contact track; sections \
                 {row_distance_mm:.4} mm apart, spacing at most {spacing_mm} mm"
            ),
        ),
    });
        if r.raceways > 0 {
            let kink = format!(
                "{:.4}° 45° up the groove, {:.4}° at the shoulder",
                r.design_kink_45_deg, r.design_kink_shoulder_deg
            );
            lines.extend([
                ("discrete raceways", r.raceways.to_string()),
                (
                    "kink at their ends",
                    if r.blend_mm > 0.0 {
                        format!(
                            "blended over {} mm (was {kink}); off the design by {:.4} µm at most",
                            (r.blend_mm * 1e6).round() / 1e6,
                            r.blend_deviation_um
                        )
                    } else {
                        format!("left: {kink}")
                    },
                ),
                (
                    "ridge between contact points",
                    format!("{:.4}°", r.ridge_deg),
                ),
                (
                    "against the plain groove",
                    format!(
                        "{:.3} µm proud at most, {:.3} µm deeper at most",
                        r.above_plain_um, r.below_plain_um
                    ),
                ),
            ]);
        }
        pairs(&lines)
    }
}
