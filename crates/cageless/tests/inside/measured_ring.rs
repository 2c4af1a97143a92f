//! A raceway from points of its surface, as a measuring machine gives them.

use cageless::kinematics::raceway_delay_rad;
use cageless::numerics::random::RandomStream;
use cageless::raceway::MeasuredFlanks;
use cageless::surface::{MeasuredGroove, OuterRing, OuterRingDimensions};
use cageless::{Case, Raceway, RacewayDimensions, RacewayForm, RacewayShape, Row};

use crate::common::structure;

/// Points of the ring of a case on `sections` sections of its first raceway, 40 on each, moved by a
/// normal error across the surface.
fn touched(case: &Case, sections: i32, sigma_m: f64, seed: u64) -> Vec<[f64; 3]> {
    let dimensions = OuterRingDimensions {
        outer_ring_outer_radius_m: 31e-3,
        outer_ring_width_m: 16e-3,
        blend_m: 0.0,
    };
    let ring = OuterRing::of(case, dimensions).unwrap();
    let raceway = &case.raceways[0];
    let mut random = RandomStream::new(seed, 0, 0, 0);
    let mut points = vec![];
    for k in 0..sections {
        let share = (f64::from(2 * k) + 1.0) / f64::from(sections) - 1.0;
        let psi = raceway.dimensions().centre_angle_rad + share * raceway.half_angle_rad();
        for j in 0..20 {
            for side in [1.0, -1.0] {
                let eta = side * (0.45 + 0.02 * f64::from(j));
                let point = ring.point(psi, eta + ring.section_angle_rad);
                let error = sigma_m * random.normal();
                let moved = |c: usize| point.position_m[c] + error * point.normal[c];
                points.push([moved(0), moved(1), moved(2)]);
            }
        }
    }
    points
}

/// Raceways of a radial bearing, a deep one, turned by 4°, and turned in a row that presses to −Z.
fn rings() -> [Case; 4] {
    let case = structure(5.1, 25.2);
    let dimensions = RacewayDimensions {
        centre_angle_rad: 0.7,
        ..*case.raceways[0].dimensions()
    };
    let raceway = Raceway::new(dimensions, &case.bearing).unwrap();
    let deep = case.with_raceways(vec![raceway.clone().with_depth(30e-6).unwrap()]);
    let turned = raceway.with_section_angle(4f64.to_radians(), &case.bearing);
    let turned = case.with_raceways(vec![turned.unwrap()]);
    let mut mirrored = turned.clone();
    mirrored.rows = vec![Row {
        axial_position_m: 0.0,
        contact_sign: -1.0,
        ..Row::default()
    }];
    [case, deep, turned, mirrored]
}

#[test]
fn points_of_the_surface_give_its_flank_angle() {
    for case in rings() {
        let raceway = &case.raceways[0];
        let groove = MeasuredGroove::fit(&case, 0, &touched(&case, 40, 0.0, 0)).unwrap();
        let deviation = groove.deviation;
        assert_eq!(deviation.points, 1600);
        let [rms, largest] = [deviation.mean_m, deviation.largest_m];
        assert!(rms <= largest && largest < 1e-9, "{largest:e}");
        for k in -99..100 {
            let psi = raceway.half_angle_rad() * f64::from(k) / 100.0;
            let miss = groove.flank_angle_rad(psi) - raceway.contact_angle_rad(psi)[0];
            assert!(miss.abs() < 1e-5, "{psi} {miss:e}");
        }
    }
}

/// A ring that is milled too deep has the flank angle and the depth error that it was made with, with errors of
/// 1 µm to 0.1 µm.
#[test]
fn a_depth_error_is_no_flank_angle() {
    for error_m in [-8e-6, 3e-6, 15e-6] {
        for (sigma_m, close) in [(0.0, [1e-4, 1e-8]), (1e-6, [5e-3, 2e-7])] {
            let case = structure(5.1, 25.2);
            let raceway = case.raceways[0].clone().with_depth_error(error_m).unwrap();
            let d = case.bearing.dimensions();
            let offset_m = d.outer_groove_curvature_radius_m - d.ball_radius_m;
            let ball_m = d.outer_groove_bottom_radius_m - d.ball_radius_m;
            // Flanks of radius Re + e about the same centres, Re − Rw behind that of the ball, as in a run.
            let deeper = |[x, y, z]: [f64; 3]| {
                let psi = x.atan2(-y);
                let (sin, cos) = raceway.contact_angle_rad(psi)[0].sin_cos();
                let along = x.hypot(y) - (ball_m - offset_m * cos);
                let across = z + offset_m * sin * z.signum();
                let by = raceway.depth_error_at_m(psi) / along.hypot(across);
                let outward = 1.0 + by * along / x.hypot(y);
                [outward * x, outward * y, z + by * across]
            };
            let points: Vec<_> = touched(&case, 100, sigma_m, 3)
                .into_iter()
                .map(deeper)
                .collect();
            let groove = MeasuredGroove::fit(&case, 0, &points).unwrap();
            let misses = [
                groove.flank_angle_rad(0.0) - raceway.contact_angle_rad(0.0)[0],
                groove.depth_error_m - error_m,
            ];
            for (miss, close) in misses.into_iter().zip(close) {
                assert!(miss.abs() < close, "{error_m:e} {sigma_m:e}: {misses:?}");
            }
        }
    }
}

/// Errors of 1 µm at 4000 points leave the lag of a ball within 0.01° and show as the deviation.
#[test]
fn errors_of_the_machine_average_out() {
    let case = structure(5.1, 25.2);
    let raceway = &case.raceways[0];
    let lag = |raceway: &Raceway| {
        raceway_delay_rad(&case.bearing, std::slice::from_ref(raceway)).to_degrees()
    };
    for seed in 0..5 {
        let groove = MeasuredGroove::fit(&case, 0, &touched(&case, 100, 1e-6, seed)).unwrap();
        let [rms, largest] = [groove.deviation.mean_m, groove.deviation.largest_m];
        assert!((rms / 1e-6 - 1.0).abs() < 0.05, "{seed} {rms:e}");
        assert!(largest > 2e-6 && largest < 6e-6, "{seed} {largest:e}");
        let theta = raceway.half_angle_rad();
        let row = |k: i32| theta * (f64::from(k) / 24.0);
        let rows: Vec<_> = (0..=24)
            .map(row)
            .map(|psi| [psi, groove.flank_angle_rad(psi)])
            .collect();
        let flanks = MeasuredFlanks::fit(&rows).unwrap();
        let dimensions = RacewayDimensions {
            axial_span_m: flanks.axial_span_m(case.bearing.ball_radius_m()),
            ..*raceway.dimensions()
        };
        let form = RacewayForm {
            shape: RacewayShape::Measured,
            measured: Some(flanks),
            ..RacewayForm::default()
        };
        let measured = Raceway::formed(dimensions, form, &case.bearing).unwrap();
        let miss = lag(&measured) - lag(raceway);
        assert!(miss.abs() < 0.01, "{seed} {miss}");
    }
}

#[test]
fn points_of_another_surface_are_refused() {
    let case = structure(5.1, 25.2);
    let good = touched(&case, 40, 0.0, 0);
    let scaled = |factor: f64| good.iter().map(|p| p.map(|c| factor * c)).collect();
    let shifted = good.iter().map(|[x, y, z]| [*x, *y, z + 1e-3]).collect();
    // A raceway 20° from where the case has it.
    let (sin, cos) = 20f64.to_radians().sin_cos();
    let turned = good
        .iter()
        .map(|[x, y, z]| [x * cos - y * sin, x * sin + y * cos, *z])
        .collect();
    for points in [
        good[..40].to_vec(),
        vec![],
        scaled(1e3),
        scaled(1e-3),
        shifted,
        turned,
    ] {
        let error = MeasuredGroove::fit(&case, 0, &points).unwrap_err();
        assert_eq!(error.field, "points");
    }
}
