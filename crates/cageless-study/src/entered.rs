//! Cases as they are when a found raceway is entered in their file.

use cageless::Case;
use cageless::design::search::OperatingPoint;
use cageless::raceway::RacewayDimensions;
use cageless_io::case_file::{CaseFile, OverTime, RacewayDocument};

/// A raceway as it is printed and entered: whole micrometres and thousandths of a degree.
pub fn raceway_document(dimensions: &RacewayDimensions) -> RacewayDocument {
    let degrees = |angle: f64| (angle.to_degrees() * 1e3).round() / 1e3;
    RacewayDocument {
        axial_span_mm: (dimensions.axial_span_m * 1e6).round() / 1e3,
        half_angle_deg: degrees(dimensions.half_angle_rad),
        centre_angle_deg: degrees(dimensions.centre_angle_rad),
        depth_error_um: 0.0,
    }
}

/// The case with these raceways in the place of its own, at this speed and load or its own;
/// `None` if that is impossible. An automatic step follows the raceways.
pub fn entered(
    file: &CaseFile,
    raceways: Vec<RacewayDocument>,
    point: Option<&OperatingPoint>,
) -> Option<Case> {
    let mut document = file.document().clone();
    document.raceway = raceways;
    if let Some(point) = point {
        let rpm = point.inner_speed_rad_s * 60.0 / std::f64::consts::TAU;
        // Rounding away what the conversion to SI leaves.
        let rpm = (rpm * 1e6).round() / 1e6;
        document.operation.inner_speed_rpm = Some(OverTime::Constant(rpm));
        document.operation.radial_load_n = Some(OverTime::Constant(point.radial_load_n));
    }
    let entered = CaseFile::from_document(document, "case").ok()?;
    Some(entered.case().clone())
}
