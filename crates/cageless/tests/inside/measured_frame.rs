//! A ring that lies anywhere in the machine that measures it: frame, dimensions and their uncertainties.

use std::f64::consts::TAU;

use cageless::numerics::random::RandomStream;
use cageless::surface::{
    MeasuredRaceway, MeasuredRing, MeasuredValue, OuterRing, OuterRingDimensions, Pose,
};
use cageless::{Case, Raceway};

use crate::common::structure;

/// How a ring is touched.
#[derive(Clone, Copy)]
struct Touch {
    pose: Pose,
    /// Turn about its axis, rad.
    turn_rad: f64,
    /// Scatter along the normal, m.
    sigma_m: f64,
    /// Share of outliers, 0.5 mm off.
    outliers: f64,
    /// Share of the points that are there.
    kept: f64,
    seed: u64,
}

/// Points of a ring anywhere on its groove, and which of them are outliers.
fn touched(case: &Case, touch: &Touch) -> (Vec<[f64; 3]>, Vec<usize>) {
    let dimensions = OuterRingDimensions {
        outer_ring_outer_radius_m: 31e-3,
        outer_ring_width_m: 16e-3,
        blend_m: 0.0,
    };
    let ring = OuterRing::of(case, dimensions).unwrap();
    let mut random = RandomStream::new(touch.seed, 0, 0, 0);
    let (mut points, mut outliers) = (vec![], vec![]);
    for _ in 0..4000 {
        // Between the ridge and the shoulders.
        let across = random.between(-0.7, 0.7);
        let (psi, eta) = (random.between(0.0, TAU), across + 0.04_f64.copysign(across));
        let normal = touch.sigma_m * random.normal();
        let (outlier, kept) = (random.uniform(), random.uniform());
        if kept >= touch.kept {
            continue;
        }
        let off = match outlier < touch.outliers {
            true => {
                outliers.push(points.len());
                0.5e-3_f64.copysign(random.uniform() - 0.5)
            }
            false => normal,
        };
        let point = ring.point(psi, ring.section_angle_rad + eta);
        let [x, y, z] = std::array::from_fn(|c| point.position_m[c] + off * point.normal[c]);
        let (sin, cos) = touch.turn_rad.sin_cos();
        points.push(
            touch
                .pose
                .in_machine_m([x * cos - y * sin, x * sin + y * cos, z]),
        );
    }
    (points, outliers)
}

fn upright() -> Touch {
    Touch {
        pose: Pose::default(),
        turn_rad: 0.0,
        sigma_m: 0.0,
        outliers: 0.0,
        kept: 1.0,
        seed: 0,
    }
}

fn tilted() -> Touch {
    Touch {
        pose: Pose {
            shift_m: [2e-6, -5e-6, 10e-6],
            tilt_rad: [1e-4, -1e-4],
        },
        turn_rad: 1f64.to_radians(),
        ..upright()
    }
}

/// The structure (d) of Zhao 2022, and one whose sections are turned.
fn rings() -> [Case; 2] {
    let case = structure(5.1, 25.2);
    let turned = case.raceways[0].clone();
    let turned = turned.with_section_angle(4f64.to_radians(), &case.bearing);
    let turned = case.with_raceways(vec![turned.unwrap()]);
    [case, turned]
}

/// What was measured of frame and first raceway, with what it is.
fn misses(case: &Case, touch: &Touch, found: &MeasuredRing) -> [(&'static str, MeasuredValue); 11] {
    let MeasuredRaceway::Flanks(made) = &found.raceways[0] else {
        panic!("no raceway");
    };
    let d = case.raceways[0].dimensions();
    let [x, y, z] = [0, 1, 2].map(|k| found.shift_m[k].plus(-touch.pose.shift_m[k]));
    let [a, b] = [0, 1].map(|k| found.tilt_rad[k].plus(-touch.pose.tilt_rad[k]));
    [
        ("x", x),
        ("y", y),
        ("z", z),
        ("tilt x", a),
        ("tilt y", b),
        ("turn", found.turn_rad.unwrap().plus(-touch.turn_rad)),
        ("Ro", found.bottom_radius_error_m),
        ("Re", found.curvature_radius_error_m),
        ("lC", made.axial_span_m.plus(-d.axial_span_m)),
        ("θ", made.half_angle_rad.plus(-d.half_angle_rad)),
        ("depth", made.depth_error_m),
    ]
}

/// Points without errors give frame and dimensions back, however the ring lies.
#[test]
fn a_ring_is_found_where_it_lies() {
    for case in rings() {
        let far = Touch {
            pose: Pose {
                shift_m: [0.3e-3, -0.2e-3, 0.5e-3],
                tilt_rad: [3e-3, -2e-3],
            },
            turn_rad: 2.0,
            ..upright()
        };
        for touch in [upright(), tilted(), far] {
            let (points, _) = touched(&case, &touch);
            let found = MeasuredRing::fit(&case, &points).unwrap();
            for (what, miss) in misses(&case, &touch, &found) {
                assert!(miss.value.abs() < 1e-7, "{what} {miss:?}");
            }
            assert!(found.outliers.is_empty() && found.deviation_m < 1e-9);
            // All of the groove but what is next to its shoulders.
            assert!(
                found.used as f64 > 0.98 * points.len() as f64,
                "{}",
                found.used
            );
            let most = |k: f64, p: &cageless::surface::PointOff| k.max(p.deviation_m.abs());
            assert!(found.deviations.iter().fold(0.0, most) < 1e-8);
        }
    }
}

/// With errors of 0.5 µm, 1 % of outliers and half of the points, what is stated with k = 2 holds in about 95 % of
/// measurements, outliers are named, and the uncertainties are those of the points.
#[test]
fn uncertainties_cover_the_errors() {
    const SEEDS: u64 = 40;
    let case = structure(5.1, 25.2);
    let mut covered = [0; 11];
    for seed in 0..SEEDS {
        let touch = Touch {
            sigma_m: 0.5e-6,
            outliers: 0.01,
            kept: 0.5,
            seed,
            ..tilted()
        };
        let (points, outliers) = touched(&case, &touch);
        let found = MeasuredRing::fit(&case, &points).unwrap();
        assert!(
            (found.deviation_m / 0.5e-6 - 1.0).abs() < 0.1,
            "{:e}",
            found.deviation_m
        );
        let named = outliers
            .iter()
            .filter(|k| found.outliers.contains(k))
            .count();
        // Some lie on the shoulders, some on the other flank.
        assert!(
            named + 2 >= outliers.len(),
            "seed {seed}: {named} of {}",
            outliers.len()
        );
        let wrong: Vec<_> = found
            .outliers
            .iter()
            .filter(|k| !outliers.contains(k))
            .collect();
        assert!(
            wrong.is_empty(),
            "seed {seed}: {wrong:?} of {}",
            points.len()
        );
        let misses = misses(&case, &touch, &found);
        for (covered, (_, miss)) in covered.iter_mut().zip(misses) {
            *covered += u64::from(miss.value.abs() <= miss.expanded());
        }
        let expanded = misses.map(|(what, miss)| (what, miss.expanded()));
        for (what, most) in [
            ("x", 0.2e-6),
            ("z", 0.2e-6),
            ("tilt x", 1e-5),
            ("lC", 40e-6),
            ("θ", 3e-3),
        ] {
            let found = expanded.iter().find(|(name, _)| *name == what).unwrap().1;
            assert!(found < most && found > most / 20.0, "{what} {found:e}");
        }
    }
    println!("{covered:?}");
    for (covered, what) in covered.iter().zip(misses_names()) {
        assert!(*covered * 100 >= 85 * SEEDS, "{what}: {covered} of {SEEDS}");
    }
    let all: u64 = covered.iter().sum();
    assert!(all * 100 <= 99 * SEEDS * 11, "too wide: {covered:?}");
}

fn misses_names() -> [&'static str; 11] {
    [
        "x", "y", "z", "tilt x", "tilt y", "turn", "Ro", "Re", "lC", "θ", "depth",
    ]
}

/// A groove whose raceway was never cut has none, a shallow one has.
#[test]
fn a_plain_groove_has_no_raceway() {
    let case = structure(5.1, 25.2);
    let touch = Touch {
        sigma_m: 0.5e-6,
        outliers: 0.01,
        ..tilted()
    };
    for sigma_m in [0.0, 0.5e-6] {
        let (points, _) = touched(&case.with_raceways(vec![]), &Touch { sigma_m, ..touch });
        let found = MeasuredRing::fit(&case, &points).unwrap();
        assert!(
            matches!(found.raceways[0], MeasuredRaceway::None { .. }),
            "{}",
            found.outliers.len()
        );
        assert_eq!(found.turn_rad, None);
        let near = |k: usize| found.shift_m[k].plus(-touch.pose.shift_m[k]).value.abs();
        assert!((0..3).all(|k| near(k) < 1e-7));
    }
    let made: Raceway = structure(1.2, 25.2).raceways[0].clone();
    let (points, _) = touched(&case.with_raceways(vec![made]), &touch);
    let found = MeasuredRing::fit(&case, &points).unwrap();
    let MeasuredRaceway::Flanks(made) = &found.raceways[0] else {
        panic!()
    };
    let miss = made.axial_span_m.plus(-1.2e-3);
    assert!(miss.value.abs() <= 2.0 * miss.expanded(), "{miss:?}");
}

/// Radii of the groove other than drawn are told from raceway and frame, and do not change the flanks.
#[test]
fn other_radii_are_found() {
    let case = structure(5.1, 25.2);
    let mut dimensions = case.bearing.dimensions().clone();
    dimensions.outer_groove_bottom_radius_m += 6e-6;
    dimensions.outer_groove_curvature_radius_m -= 4e-6;
    let bearing = cageless::Bearing::new(dimensions, crate::common::steel()).unwrap();
    let raceway = Raceway::new(*case.raceways[0].dimensions(), &bearing).unwrap();
    let mut made = case.with_raceways(vec![raceway]);
    made.bearing = bearing;
    let (points, _) = touched(&made, &tilted());
    let found = MeasuredRing::fit(&case, &points).unwrap();
    let close = |found: f64, expected: f64, most: f64| {
        assert!((found - expected).abs() < most, "{found:e} {expected:e}");
    };
    close(found.bottom_radius_error_m.value, 6e-6, 2e-8);
    close(found.curvature_radius_error_m.value, -4e-6, 2e-8);
    let MeasuredRaceway::Flanks(raceway) = &found.raceways[0] else {
        panic!()
    };
    close(raceway.axial_span_m.value, 5.1e-3, 1e-6);
    let [designed, _] = case.raceways[0].contact_angle_rad(0.0);
    close(raceway.groove.flank_angle_rad(0.0), designed, 2e-4);
}

/// Points of the raceway alone, and points of shoulders and faces among those of the groove.
#[test]
fn points_of_a_part_and_of_other_faces_are_taken() {
    let case = structure(5.1, 25.2);
    let touch = Touch {
        sigma_m: 0.5e-6,
        ..tilted()
    };
    let (all, _) = touched(&case, &touch);
    let within = |[x, y, _]: &[f64; 3]| x.atan2(-y).abs() < 27f64.to_radians();
    let alone: Vec<_> = all.iter().copied().filter(within).collect();
    let mut random = RandomStream::new(1, 0, 0, 0);
    let mut faces = all.clone();
    for _ in 0..8000 {
        let (psi, z) = (random.between(0.0, TAU), random.between(-8e-3, 8e-3));
        let radius = if z.abs() < 5e-3 { 31e-3 } else { 26e-3 };
        faces.push(
            touch
                .pose
                .in_machine_m([radius * psi.sin(), -radius * psi.cos(), z]),
        );
    }
    for points in [alone, faces] {
        let found = MeasuredRing::fit(&case, &points).unwrap();
        for (what, miss) in misses(&case, &touch, &found) {
            assert!(miss.value.abs() < 2.0 * miss.expanded(), "{what} {miss:?}");
        }
        assert!(found.outliers.len() < 4, "{}", found.outliers.len());
    }
}

#[test]
fn points_of_another_ring_are_refused() {
    let case = structure(5.1, 25.2);
    let (good, _) = touched(&case, &upright());
    let scaled = |factor: f64| good.iter().map(|p| p.map(|c| factor * c)).collect();
    let across = good.iter().map(|[x, y, z]| [*z, *x, *y]).collect();
    for points in [
        vec![],
        good[..40].to_vec(),
        scaled(1e3),
        scaled(1e-3),
        scaled(1.05),
        across,
    ] {
        let error = MeasuredRing::fit(&case, &points).err();
        assert_eq!(error.map(|e| e.error.field), Some("points"));
    }
}
