//! Closed forms of slots.

use crate::common::slotted;
use cageless::closed_forms::{kinematic_gap_rad, span_angle_curve};
use cageless::{Raceway, RacewayDimensions};

/// The curve of Eq. (11) begins where the two ends of a slot leave room for it.
#[test]
fn slots_have_a_curve_of_their_own() {
    let case = slotted();
    let form = case.raceways[0].form();
    let curve = span_angle_curve(&case.bearing, form, 40);
    let polar = curve
        .iter()
        .filter_map(|p| Some((p.axial_span_m, p.half_angle_polar_rad?)));
    let polar: Vec<(f64, f64)> = polar.collect();
    assert!(polar.len() > 5, "{curve:?}");
    let nominal = case.bearing.nominal_gap_rad();
    for (axial_span_m, half_angle_rad) in polar {
        let dimensions = RacewayDimensions {
            axial_span_m,
            half_angle_rad,
            centre_angle_rad: 0.0,
        };
        let raceway = Raceway::formed(dimensions, form, &case.bearing).unwrap();
        // Eq. (11) has no sink.
        let rm = case.bearing.pitch_radius_m();
        let gap = kinematic_gap_rad(&case.bearing, &raceway, 0.0, 0.0);
        let most = raceway.depth_at_m(0.0)[0] / rm * case.bearing.ball_angle_rad() * 2.0;
        assert!(
            gap > nominal && gap < nominal + most,
            "{axial_span_m}: {gap}"
        );
    }
}
