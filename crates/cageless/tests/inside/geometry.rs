//! Geometry of the discrete raceway against the numbers of Zhao 2022 and against itself.

use crate::common::OUTER_RING;
use crate::common::{dimensions, steel, structure, structures};
use cageless::closed_forms::{
    Eq11, balls_in_raceway_max, half_angle_for_gap_rad, steady_gap_rad, theoretical_gap_rad,
};
use cageless::raceway::axial_span_limit_m;
use cageless::surface::OuterRing;
use cageless::{Bearing, BearingDimensions, Raceway, RacewayDimensions, RacewayForm};
use proptest::prelude::*;

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance
}

#[test]
fn table_1_gives_the_papers_angles() {
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    assert!(close(bearing.ball_angle_rad().to_degrees(), 23.8982, 5e-5));
    assert!(close(bearing.nominal_gap_rad().to_degrees(), 1.8161, 5e-5));
    assert!(close(axial_span_limit_m(&bearing) * 1e3, 7.4017, 5e-5));
    assert_eq!(bearing.radial_internal_clearance_m(), 0.0);
}

#[test]
fn eq_11_gives_table_2_to_four_decimals() {
    for (span, angle, beta0, _) in structures() {
        let case = structure(span, angle);
        let gap = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Published);
        assert!(
            close(gap.to_degrees(), beta0, 5.1e-5),
            "{span}: {}",
            gap.to_degrees()
        );
    }
}

/// With the true polar angle; values from an independent quadrature.
#[test]
fn eq_11_with_the_polar_angle() {
    let polar = [
        1.8238, 1.8277, 1.8302, 1.8304, 1.8330, 1.8317, 1.8368, 1.8404, 1.8432, 1.8457,
    ];
    for ((span, angle, ..), expected) in structures().into_iter().zip(polar) {
        let case = structure(span, angle);
        let gap = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Polar);
        assert!(close(gap.to_degrees(), expected, 5.1e-5), "{span}");
    }
}

#[test]
fn half_angle_inverts_eq_11() {
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    for meaning in [Eq11::Published, Eq11::Polar] {
        for span in [5.0e-3, 5.7e-3, 7.0e-3] {
            let gap = bearing.nominal_gap_rad();
            let angle =
                half_angle_for_gap_rad(&bearing, RacewayForm::default(), span, gap, meaning)
                    .unwrap();
            let raceway = Raceway::new(
                RacewayDimensions {
                    axial_span_m: span,
                    half_angle_rad: angle,
                    centre_angle_rad: 0.0,
                },
                &bearing,
            )
            .unwrap();
            assert!(close(
                theoretical_gap_rad(&bearing, &raceway, meaning),
                gap,
                1e-11
            ));
        }
        // So narrow a groove cannot slow the balls enough at any angle.
        assert_eq!(
            half_angle_for_gap_rad(
                &bearing,
                RacewayForm::default(),
                1e-3,
                bearing.nominal_gap_rad(),
                meaning
            ),
            None
        );
    }
}

#[test]
fn as_many_balls_inside_as_fit() {
    let counts: Vec<usize> = structures()
        .iter()
        .map(|&(span, angle, ..)| {
            let case = structure(span, angle);
            balls_in_raceway_max(&case.bearing, &case.raceways[0])
        })
        .collect();
    assert_eq!(counts, [3, 3, 3, 3, 2, 2, 2, 2, 2, 2]);
}

/// The groove delays each ball, so that the balls outside stand wider than evenly spaced
/// ones; on a plain ring they do not.
#[test]
fn steady_flow_widens_the_gaps_outside() {
    let case = structure(5.1, 25.2);
    let uniform = case.bearing.nominal_gap_rad();
    assert!(close(steady_gap_rad(&case.bearing, &[]), uniform, 1e-12));
    let steady = steady_gap_rad(&case.bearing, &case.raceways);
    assert!(steady > uniform + 0.1f64.to_radians());
    // Two like raceways delay twice.
    let other = crate::common::raceway(&case.bearing, 5.1, 25.2, 180.0);
    let twice = steady_gap_rad(&case.bearing, &[case.raceways[0].clone(), other]);
    assert!(close(twice - uniform, 2.0 * (steady - uniform), 1e-12));
}

/// The gaps of Eq. (11) are those of the raceway itself, wherever it is.
#[test]
fn theoretical_gaps_turn_with_the_raceway() {
    for meaning in [Eq11::Published, Eq11::Polar] {
        let gap = |centre_deg: f64| {
            let case = structure(5.1, 25.2);
            let raceway = crate::common::raceway(&case.bearing, 5.1, 25.2, centre_deg);
            theoretical_gap_rad(&case.bearing, &raceway, meaning)
        };
        for centre_deg in [30.0, -100.0, 180.0] {
            assert!(
                close(gap(centre_deg), gap(0.0), 1e-12),
                "{meaning:?} {centre_deg}"
            );
        }
    }
}

/// r over ψ: the polynomial against the contact path itself.
#[test]
fn effective_radius_lies_on_the_contact_path() {
    for (span, angle, ..) in structures() {
        let case = structure(span, angle);
        let raceway = &case.raceways[0];
        let touching = case.bearing.outer_orbit_radius_m();
        for k in -500..=500 {
            let psi = raceway.half_angle_rad() * f64::from(k) / 500.0 * 0.999_999;
            let path = raceway.contact_path().unwrap();
            let x = path.x_m(psi);
            let y = path.y_m(x);
            assert!(close(x.atan2(-y), psi, 1e-13), "{span} {psi}");
            let r = x.hypot(y) - touching;
            // Rounding of Ro alone is 3e-18 m.
            let error = (raceway.effective_radius_m(psi) - r).abs();
            assert!(error < 1e-16, "{span} {psi}: {error:e}");
        }
    }
}

#[test]
fn path_meets_the_plain_raceway_with_zero_slope() {
    for (span, angle, ..) in structures() {
        let case = structure(span, angle);
        let raceway = &case.raceways[0];
        let (rw, theta) = (case.bearing.ball_radius_m(), raceway.half_angle_rad());
        let inside = raceway.effective_radius_m(theta * (1.0 - 1e-7));
        assert!(close(inside, rw, 1e-15));
        let slope = (raceway.effective_radius_m(theta * 0.9999) - rw) / (1e-4 * theta);
        assert!(slope.abs() < 1e-5, "{slope}");
        // Deepest in the middle, where the span is lC.
        assert!(close(
            2.0 * raceway.contact_path().unwrap().z_m(0.0),
            span * 1e-3,
            1e-15
        ));
    }
}

/// The groove curve is Re − Rw behind the ball on the line through the contact point,
/// and the surface passes through the contact point with that line as its normal in the
/// meridian plane.
#[test]
fn surface_touches_the_ball_at_the_contact_path() {
    let case = structure(5.1, 25.2);
    let raceway = &case.raceways[0];
    let ring = OuterRing::new(&case.bearing, &case.raceways, OUTER_RING).unwrap();
    let (rw, re) = (case.bearing.ball_radius_m(), 4.953e-3);
    let touching = case.bearing.outer_orbit_radius_m();
    for k in -20..=20 {
        let psi = raceway.half_angle_rad() * f64::from(k) / 20.5;
        let path = raceway.contact_path().unwrap();
        let x = path.x_m(psi);
        let (y, z) = (path.y_m(x), path.z_m(x));
        let ball = [touching * psi.sin(), -touching * psi.cos(), 0.0];
        let centre = path.groove_centre_m(x);
        let contact = [x, y, z];
        for i in 0..3 {
            let expected = ball[i] + (contact[i] - ball[i]) * (rw - re) / rw;
            assert!(close(centre[i], expected, 1e-15), "{i}");
        }
        let meridian = ((x.hypot(y) - touching) / rw).acos();
        let point = ring.point(psi, meridian);
        for i in 0..3 {
            assert!(
                close(point.position_m[i], contact[i], 2e-14),
                "{i}: {:?}",
                point
            );
        }
        let mirrored = ring.point(psi, -meridian);
        assert!(close(mirrored.position_m[2], -z, 2e-14));
        assert!(close(mirrored.normal[2], -point.normal[2], 1e-15));
    }
}

/// Normals against finite differences of the surface itself.
#[test]
fn normals_are_normal() {
    let case = structure(5.6, 15.774);
    let ring = OuterRing::new(&case.bearing, &case.raceways, OUTER_RING).unwrap();
    let step = 1e-6;
    for (psi, meridian) in [
        (0.0, 0.5),
        (0.1, 0.3),
        (-0.2, 0.8),
        (0.15, -0.4),
        (0.6, 0.5),
    ] {
        let at = |a: f64, b: f64| ring.point(psi + a, meridian + b).position_m;
        let normal = ring.point(psi, meridian).normal;
        for (plus, minus) in [
            (at(step, 0.0), at(-step, 0.0)),
            (at(0.0, step), at(0.0, -step)),
        ] {
            let tangent: Vec<f64> = (0..3)
                .map(|i| (plus[i] - minus[i]) / (2.0 * step))
                .collect();
            let length = tangent.iter().map(|t| t * t).sum::<f64>().sqrt();
            let along: f64 = (0..3).map(|i| tangent[i] * normal[i]).sum::<f64>() / length;
            assert!(along.abs() < 1e-7, "{psi} {meridian}: {along}");
        }
        assert!(close(normal.iter().map(|n| n * n).sum::<f64>(), 1.0, 1e-14));
    }
}

/// The kink at the end of the groove, 45° up.
#[test]
fn kink_where_the_groove_meets_the_plain_raceway() {
    for (span, angle, expected) in [(5.1, 25.2, 0.65), (6.0, 12.717, 1.7)] {
        let case = structure(span, angle);
        let kink = case.raceways[0]
            .kink_angle_rad(45f64.to_radians())
            .to_degrees();
        assert!(close(kink, expected, 0.03), "{kink}");
        // At the bottom of the groove both normals point to the axis.
        assert!(case.raceways[0].kink_angle_rad(0.0) < 1e-6);
    }
}

proptest! {
    #![proptest_config(super::trials(256))]

    /// Any raceway that is accepted obeys Eq. (8) and (9) and has a smooth r.
    #[test]
    fn accepted_raceways_obey_the_constraints(
        span in 0.1f64..9.0,
        angle in 0.5f64..89.0,
        clearance in 0.0f64..50e-6,
        centre in -180.0f64..180.0,
    ) {
        let mut d = dimensions();
        d.outer_groove_bottom_radius_m += clearance;
        let bearing = Bearing::new(d, steel()).unwrap();
        let dimensions = RacewayDimensions {
            axial_span_m: span * 1e-3,
            half_angle_rad: angle.to_radians(),
            centre_angle_rad: centre.to_radians(),
        };
        if let Ok(raceway) = Raceway::new(dimensions, &bearing) {
            prop_assert!(span * 1e-3 < axial_span_limit_m(&bearing));
            let rw = bearing.ball_radius_m();
            let deepest = (rw * rw - (span * 0.5e-3).powi(2)).sqrt();
            let mut last = 0.0;
            for k in 0..=200 {
                let psi = raceway.half_angle_rad() * f64::from(k) / 200.0;
                let r = raceway.effective_radius_m(dimensions.centre_angle_rad + psi);
                let mirrored = raceway.effective_radius_m(dimensions.centre_angle_rad - psi);
                prop_assert!((r - mirrored).abs() < 1e-15);
                prop_assert!(r >= deepest - 1e-12 && r <= rw + 1e-15, "{}", r);
                prop_assert!(r >= last - 1e-12);
                last = r;
            }
        } else {
            // A very shallow path over a wide angle cannot follow the ring (Eq. (9)); ordinary
            // ones are accepted.
            let ordinary = (3.0..7.3).contains(&span) && angle < 30.0;
            prop_assert!(!ordinary, "{span} {angle}");
        }
    }
}

/// The arrangement itself: balls laid out one after the other on the pitch circle.
#[test]
fn ring_that_falls_between_bunched_balls_is_known_by_their_number() {
    let holding = Bearing::balls_that_hold_ring(4.7625e-3, 23.0025e-3);
    for balls in 3..=14 {
        let dimensions = BearingDimensions {
            balls,
            ..dimensions()
        };
        let bearing = Bearing::new(dimensions, steel()).unwrap();
        let across = (4.7625f64 / 23.0025).asin().to_degrees() * 2.0;
        let last = across * (balls - 1) as f64;
        let opening = bearing.bunched_opening_rad().to_degrees();
        assert!(
            (opening - (360.0 - last)).abs() < 1e-9,
            "{balls}: {opening}"
        );
        // The end balls are on one side of the middle, or on both.
        let beyond_half = last > 180.0;
        assert_eq!(bearing.can_fall_between_balls(), !beyond_half, "{balls}");
        assert_eq!(balls >= holding, beyond_half, "{balls}: {holding}");
    }
    assert_eq!(holding, 9); // The centres of 8 balls span 167.3°, those of 9 span 191.2°.
}

/// In the middle of the raceway the surface curves along the rolling direction as the contact
/// stress supposes: (r/Rw)/(Ro − Rw + r), hollow.
#[test]
fn curvature_behind_the_contact_stress() {
    let case = structure(5.1, 25.2);
    let raceway: &Raceway = &case.raceways[0];
    let bearing = &case.bearing;
    let (rw, r) = (bearing.ball_radius_m(), raceway.effective_radius_m(0.0));
    let meridian = (r / rw).acos();
    let h = 1e-4;
    let ring = OuterRing::new(bearing, &case.raceways, OUTER_RING).unwrap();
    let point = |psi: f64| ring.point(psi, meridian);
    let (before, here, after) = (point(-h), point(0.0), point(h));
    let along: Vec<f64> = (0..3)
        .map(|k| (after.position_m[k] - before.position_m[k]) / (2.0 * h))
        .collect();
    let bending: Vec<f64> = (0..3)
        .map(|k| (after.position_m[k] - 2.0 * here.position_m[k] + before.position_m[k]) / (h * h))
        .collect();
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
    // Of the curve at constant meridian angle; the normal points to the ball.
    let curvature = dot(&bending, &here.normal) / dot(&along, &along);
    let expected = (r / rw) / (bearing.outer_orbit_radius_m() + r);
    // The contact path goes the same way there, so it has the same normal curvature.
    assert!(
        (curvature / expected - 1.0).abs() < 1e-3,
        "{curvature} {expected}"
    );
}
