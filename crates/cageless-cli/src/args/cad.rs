//! Arguments of the commands that write and measure rings.

use std::path::PathBuf;

use cageless_io::cad::Format;
use clap::{Args as Group, ValueEnum};

use super::case::{CaseArgs, number};
use super::tolerances::DrawingTolerances;

/// `export`.
#[derive(Debug, Group)]
pub struct ExportArgs {
    /// Case file (TOML) with bearing.outer_ring_outer_radius_mm and
    /// bearing.outer_ring_width_mm.
    #[arg(value_name = "CASE")]
    pub case: PathBuf,
    /// Replace a value of the case file; may be repeated.
    #[arg(long, value_name = "SECTION.KEY=VALUE")]
    pub set: Vec<String>,
    /// Kind of file.
    #[arg(long)]
    pub format: CadFormat,
    /// Length of the blend between each end of a discrete raceway and the plain groove, inside
    /// the raceway; 0 leaves the slope discontinuity. Default: 0.5, or a fifth of the shortest half raceway if
    /// that is shorter.
    #[arg(long, value_parser = number, value_name = "MM", allow_negative_numbers = true)]
    pub blend_mm: Option<f64>,
    /// step: largest distance of the B-splines from the analytic surface. Default: 0.01.
    #[arg(long, value_parser = number, value_name = "UM", allow_negative_numbers = true)]
    pub tolerance_um: Option<f64>,
    /// stl: largest distance of a triangle from the analytic surface. Default: 5.
    #[arg(long, value_parser = number, value_name = "UM", allow_negative_numbers = true)]
    pub chord_um: Option<f64>,
    /// csv: largest distance of neighbouring points. Default: 0.5.
    #[arg(long, value_parser = number, value_name = "MM", allow_negative_numbers = true)]
    pub spacing_mm: Option<f64>,
    /// Print the numbers as one JSON document.
    #[arg(long)]
    pub json: bool,
    /// File, if the name ends in .step, .stp, .stl or .csv; else a folder, which gets
    /// outer_ring.step, .stl or .csv and export.json. Without it the file is written to stdout, and
    /// with --json only the numbers.
    #[arg(long, value_name = "PATH")]
    pub out: Option<PathBuf>,
}

/// `measure`.
#[derive(Debug, Group)]
pub struct MeasureArgs {
    /// Case with the raceways as designed, output.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Points of the groove with the axis along z: lines of x, y, z in mm, with a head that
    /// names x_mm, y_mm, z_mm or without.
    #[arg(value_name = "POINTS")]
    pub points: PathBuf,
    /// Tolerances of the drawing.
    #[command(flatten)]
    pub drawing: DrawingTolerances,
}

/// Kinds of files of `export`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CadFormat {
    /// One solid of B-splines, tori, cylinders and planes, AP214.
    Step,
    /// Triangles, binary.
    Stl,
    /// Surface points, normals and contact track for a five-axis program.
    Csv,
}

impl From<CadFormat> for Format {
    fn from(format: CadFormat) -> Self {
        match format {
            CadFormat::Step => Self::Step,
            CadFormat::Stl => Self::Stl,
            CadFormat::Csv => Self::Csv,
        }
    }
}
