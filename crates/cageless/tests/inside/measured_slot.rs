//! A slot from points of its surface, as a measuring machine gives them.

use std::f64::consts::FRAC_PI_2;

use cageless::closed_forms::kinematic_lag_rad;
use cageless::numerics::random::RandomStream;
use cageless::surface::{EdgePlace, Grid, MeasuredSlot, OuterRing, PointKind};
use cageless::{Case, Raceway};

use super::slot_ring::{Given, SIZE, case, slot};

/// A point and what it is on.
type Point = (PointKind, [f64; 3]);

/// Points of the groove and of all faces of slots, and 1500 more anywhere on the edges of each, moved by a normal
/// error along the normal.
fn touched(case: &Case, sigma_m: f64, seed: u64) -> Vec<Point> {
    let ring = OuterRing::of(case, SIZE).unwrap();
    let grid = Grid::new(&ring, 0.3e-3);
    let mut random = RandomStream::new(seed, 0, 0, 0);
    let points = grid.rows.iter().flat_map(|row| grid.points(row));
    let mut points: Vec<_> = points
        .map(|p| (p.kind, p.point.position_m, p.point.normal))
        .collect();
    for recess in ring.recesses {
        let straight_rad = recess.straight_rad.unwrap_or(0.0);
        for k in 0..1500 {
            let way = f64::from(k % 2 * 2 - 1);
            let along = 2.0 * random.uniform() - 1.0;
            let place = match k % 3 {
                0 => EdgePlace::End(way, along * FRAC_PI_2),
                _ => EdgePlace::Straight(way, along * straight_rad),
            };
            let (edge, share) = (recess.edge(place), random.uniform());
            points.push((PointKind::Edge, edge.arc_m(share), edge.normal(share)));
        }
    }
    let mut moved = |position: [f64; 3], normal: [f64; 3]| {
        let error = sigma_m * random.normal();
        std::array::from_fn(|c| position[c] + error * normal[c])
    };
    points
        .into_iter()
        .map(|(kind, position, normal)| (kind, moved(position, normal)))
        .collect()
}

fn places(points: &[Point]) -> Vec<[f64; 3]> {
    points.iter().map(|(_, place)| *place).collect()
}

/// The case with other slots, as a drawing says what was to be made.
fn drawn(made: &Case, [span, edge, angle, centre]: [f64; 4]) -> Case {
    let given = |k: usize| {
        let raceway = &made.raceways[k];
        let (d, bearing) = (raceway.dimensions(), made.bearing.dimensions());
        let span_mm = d.axial_span_m * 1e3 * span;
        let edge_mm = raceway.form().edge_radius_m * 1e3 * edge;
        let ends_mm = (1.0 + 1e-3 * edge_mm / bearing.ball_radius_m) * span_mm / 2.0;
        let ends_rad = 1e-3 * ends_mm / bearing.outer_groove_bottom_radius_m;
        let theta_deg = d.half_angle_rad.max(ends_rad / angle).to_degrees() * angle;
        let centre_deg = d.centre_angle_rad.to_degrees() + centre;
        let given = [span_mm, edge_mm, theta_deg * (1.0 + 1e-12), centre_deg];
        let slot = slot(&made.bearing, given).unwrap();
        slot.with_section_angle(raceway.section_angle_rad(), &made.bearing)
            .unwrap()
    };
    Case {
        raceways: (0..made.raceways.len()).map(given).collect(),
        ..made.clone()
    }
}

/// A slot, a wide one with a small radius, one that is all end, two, and turned ones.
fn made() -> Vec<Case> {
    let of = |slots: &[Given]| case(0.0, 0.0, 1.0, slots);
    vec![
        of(&[[2.4, 0.3, 25.2, 17.3]]),
        of(&[[5.1, 0.15, 25.2, 180.0]]),
        of(&[[2.4, 0.3, 2.632_305_24, -141.9]]),
        of(&[[2.4, 0.3, 20.0, 0.0], [1.9, 0.5, 30.0, 51.1]]),
        case(15.0, 15.0, 1.0, &[[2.4, 0.3, 25.2, 17.3]]),
        case(20.0, 14.0, -1.0, &[[2.4, 0.3, 25.2, 17.3]]),
    ]
}

/// Points without errors give the slots back to the rounding of the grid, whatever the drawing has near them.
#[test]
fn points_of_the_edges_give_the_slot() {
    for made in made() {
        let points = places(&touched(&made, 0.0, 0));
        for drawing in [
            [1.0, 1.0, 1.0, 0.0],
            [1.08, 1.4, 1.03, 0.4],
            [0.94, 0.7, 1.05, -0.4],
        ] {
            let drawing = drawn(&made, drawing);
            for (k, raceway) in made.raceways.iter().enumerate() {
                let found = MeasuredSlot::fit(&drawing, k, &points).unwrap();
                let (d, slot) = (raceway.dimensions(), raceway.slot().unwrap());
                let bottom_m = made.bearing.dimensions().outer_groove_bottom_radius_m;
                for (what, found, expected) in [
                    ("re", found.edge_radius_m.value, slot.edge_radius_m),
                    ("lC", found.axial_span_m.value, d.axial_span_m),
                    ("width", found.width_m, slot.width_m()),
                    (
                        "θ",
                        found.half_angle_rad.value * bottom_m,
                        d.half_angle_rad * bottom_m,
                    ),
                    (
                        "ψ",
                        found.centre_angle_rad.value * bottom_m,
                        d.centre_angle_rad * bottom_m,
                    ),
                    ("depth", found.depth_error_m.value, 0.0),
                ] {
                    let miss = found - expected;
                    assert!(miss.abs() < 3e-9, "{what} {k}: {expected:e} {miss:e}");
                }
                assert!(found.deviation.points > 150 && found.deviation.largest_m < 2e-9);
                if let Some(depth) = found.slot_depth_m {
                    assert!((depth - slot.depth_m).abs() < 1e-9, "{depth}");
                }
                assert_eq!(found.slot_depth_m.is_some(), d.half_angle_rad > 0.1);
            }
        }
    }
}

/// Errors of 1 µm leave the lag of a ball within 0.01° and the dimensions within micrometres, and show as the
/// deviation; points far off the surface do not count.
#[test]
fn errors_of_the_machine_average_out() {
    let made = case(0.0, 0.0, 1.0, &[[2.4, 0.3, 25.2, 17.3]]);
    let drawing = drawn(&made, [1.01, 0.9, 1.01, 0.2]);
    let lag = |raceway: &Raceway| kinematic_lag_rad(&made.bearing, raceway, 0.0, 0.0).to_degrees();
    for seed in 0..5 {
        for burr in [false, true] {
            let mut points = places(&touched(&made, 1e-6, seed));
            if burr {
                let mut random = RandomStream::new(seed, 1, 0, 0);
                for point in points.iter_mut().step_by(50) {
                    *point = point.map(|c| c + 30e-6 * random.normal());
                }
            }
            let found = MeasuredSlot::fit(&drawing, 0, &points).unwrap();
            let d = *made.raceways[0].dimensions();
            let given = [
                found.axial_span_m.value * 1e3,
                found.edge_radius_m.value * 1e3,
                found.half_angle_rad.value.to_degrees(),
                found.centre_angle_rad.value.to_degrees(),
            ];
            let miss = lag(&slot(&made.bearing, given).unwrap()) - lag(&made.raceways[0]);
            assert!(miss.abs() < 0.01, "{seed} {miss}");
            let around = found.half_angle_rad.value - d.half_angle_rad;
            for (what, miss) in [
                ("re", found.edge_radius_m.value - 0.3e-3),
                ("lC", found.axial_span_m.value - d.axial_span_m),
                (
                    "θ",
                    around * made.bearing.dimensions().outer_groove_bottom_radius_m,
                ),
                ("depth", found.depth_error_m.value),
            ] {
                assert!(miss.abs() < 5e-6, "{seed} {what} {miss:e}");
            }
            if !burr {
                let rms = found.deviation.mean_m;
                assert!((rms / 1e-6 - 1.0).abs() < 0.05, "{seed} {rms:e}");
            }
            assert!((found.deviation.largest_m > 20e-6) == burr);
        }
    }
}

/// A ring whose groove is 8 µm deeper, with its edges: a ball sits as much deeper.
#[test]
fn deeper_edges_are_a_depth_error() {
    let drawing = case(0.0, 0.0, 1.0, &[[2.4, 0.3, 25.2, 17.3]]);
    let points: Vec<_> = places(&touched(&drawing, 0.0, 0))
        .iter()
        .map(|[x, y, z]| {
            let scale = 1.0 + 8e-6 / x.hypot(*y);
            [x * scale, y * scale, *z]
        })
        .collect();
    let found = MeasuredSlot::fit(&drawing, 0, &points).unwrap();
    let alpha = drawing.raceways[0].contact_angle_rad(0.0)[0];
    let miss = found.depth_error_m.value - 8e-6 * alpha.cos();
    assert!(
        miss.abs() < 0.05e-6,
        "{:e} {miss:e}",
        found.depth_error_m.value
    );
    assert!((found.axial_span_m.value - 2.4e-3).abs() < 0.2e-6);
}

#[test]
fn points_of_something_else_are_refused() {
    let made = case(0.0, 0.0, 1.0, &[[2.4, 0.3, 25.2, 17.3]]);
    let all = touched(&made, 0.0, 0);
    let of = |kept: &dyn Fn(&Point) -> bool| -> Vec<[f64; 3]> {
        places(
            &all.iter()
                .filter(|point| kept(point))
                .copied()
                .collect::<Vec<_>>(),
        )
    };
    let everything = of(&|_| true);
    let edges = of(&|(kind, _)| *kind == PointKind::Edge);
    let moved = |by: &dyn Fn([f64; 3]) -> [f64; 3]| everything.iter().map(|p| by(*p)).collect();
    let middle = made.raceways[0].dimensions().centre_angle_rad;
    let few = "50 or more on the rounded edges of the slot";
    let plain = touched(&made.with_raceways(vec![]), 0.0, 0);
    for (points, said) in [
        (vec![], few),
        (edges[..40].to_vec(), few),
        (of(&|(kind, _)| *kind != PointKind::Edge), few),
        (places(&plain), few),
        (moved(&|p| p.map(|c| 1e3 * c)), few),
        (moved(&|[x, y, z]| [x, y, z + 4e-3]), few),
        // Without the ends.
        (
            of(&|(_, [x, y, _])| (x.atan2(-y) - middle).abs() < 0.3),
            "10 of them around each of its ends",
        ),
    ] {
        let error = MeasuredSlot::fit(&made, 0, &points).unwrap_err();
        assert_eq!(error.field, "points");
        assert!(error.to_string().contains(said), "{said}: {error}");
    }
}
