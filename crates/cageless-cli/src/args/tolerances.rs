//! Arguments with tolerances.

use cageless::ball_grades_text;
use cageless_study::measured::Limits;
use cageless_study::tolerance::Request as Tolerances;
use clap::Args as Group;

use super::case::{CaseArgs, number, whole};

/// Machining tolerances of a discrete raceway.
#[derive(Debug, Group)]
pub struct RacewayTolerances {
    /// Tolerance of the raceway depth, ± µm.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "UM", default_value_t = Tolerances::default().groove_depth_um)]
    pub groove_depth_um: f64,
    /// Tolerance of the axial span lC, ± µm.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "UM", default_value_t = Tolerances::default().axial_span_um)]
    pub axial_span_um: f64,
    /// Tolerance of the half angle θ, ± degrees.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "DEG", default_value_t = Tolerances::default().half_angle_deg)]
    pub half_angle_deg: f64,
}

/// Tolerances of a drawing: those of a discrete raceway and of its place.
#[derive(Debug, Group)]
pub struct DrawingTolerances {
    /// Tolerances of the raceway.
    #[command(flatten)]
    raceway: RacewayTolerances,
    /// Tolerance of the angular position ψ, of measured points in their frame, ± degrees; default: none.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "DEG")]
    centre_angle_deg: Option<f64>,
}

impl DrawingTolerances {
    /// Limits of a drawing with these.
    pub fn limits(&self) -> Limits {
        Limits {
            groove_depth_um: self.raceway.groove_depth_um,
            axial_span_um: self.raceway.axial_span_um,
            half_angle_deg: self.raceway.half_angle_deg,
            centre_angle_deg: self.centre_angle_deg,
        }
    }
}

/// `tolerance`.
#[derive(Debug, Group)]
pub struct ToleranceArgs {
    /// Case, output.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Monte Carlo sample size; 0: one-at-a-time only.
    #[arg(long, value_parser = whole, allow_negative_numbers = true, default_value_t = Tolerances::default().samples)]
    pub samples: u64,
    /// Tolerances of the raceway.
    #[command(flatten)]
    pub raceway: RacewayTolerances,
    /// Tolerance of the contact angle of the raceway, ± degrees; of cases in space.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "DEG", default_value_t = Tolerances::default().contact_angle_deg)]
    pub contact_angle_deg: f64,
    /// Ball grade of ISO 3290-1; 0: equal balls.
    #[arg(long, value_parser = ball_grade, allow_negative_numbers = true, value_name = "G", default_value_t = Tolerances::default().ball_grade)]
    pub ball_grade: u32,
    /// Tolerance of the friction coefficient, ±.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "MU", default_value_t = Tolerances::default().friction)]
    pub friction: f64,
    /// Tolerance of the radial internal clearance Gr (ISO 5753-1), ± µm.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "UM", default_value_t = Tolerances::default().clearance_um)]
    pub clearance_um: f64,
    /// Tolerance of the speed, ± %.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "PERCENT", default_value_t = Tolerances::default().speed_percent)]
    pub speed_percent: f64,
    /// Tolerance of the load, ± %.
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "PERCENT", default_value_t = Tolerances::default().load_percent)]
    pub load_percent: f64,
    /// Tolerance of the viscosity of the oil, ± %; with [film].
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "PERCENT", default_value_t = Tolerances::default().viscosity_percent)]
    pub viscosity_percent: f64,
    /// Tolerance of the supply of oil, a factor to either side, within flooded contacts; with [film].
    #[arg(long, value_parser = number, allow_negative_numbers = true, value_name = "FACTOR", default_value_t = Tolerances::default().supply_factor)]
    pub supply_factor: f64,
    /// Say whether the raceway helps in steady operation, as drawn and at both ends of its machining tolerances.
    #[arg(long)]
    pub benefit: bool,
}

/// The study validates the grade.
fn ball_grade(text: &str) -> Result<u32, String> {
    text.parse()
        .map_err(|_| format!("allowed are 0 for balls all equal, {}", ball_grades_text()))
}
