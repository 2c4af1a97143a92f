//! The outer ring as a solid: against Pappus, finite differences and itself.

use std::f64::consts::{FRAC_PI_2, PI};

use super::slot_ring;
use super::turned_ring::{angular, turned_back};
use crate::common::{OUTER_RING, dimensions, raceway, steel, structures};
use cageless::surface::{Grid, Mesh, OuterRing, OuterRingDimensions, Patch, PointKind, Side};
use cageless::{Bearing, Raceway};

pub fn bearing() -> Bearing {
    Bearing::new(dimensions(), steel()).unwrap()
}

pub fn ring(raceways: &[Raceway], blend_m: f64) -> OuterRing {
    OuterRing::new(
        &bearing(),
        raceways,
        OuterRingDimensions {
            blend_m,
            ..OUTER_RING
        },
    )
    .unwrap()
}

fn structure_d(blend_m: f64) -> OuterRing {
    ring(&[raceway(&bearing(), 5.1, 25.2, 0.0)], blend_m)
}

fn several(blend_m: f64) -> OuterRing {
    let b = bearing();
    let at = |span, angle, centre| raceway(&b, span, angle, centre);
    // The last two touch.
    let raceways = [
        at(5.1, 25.2, 17.3),
        at(6.0, 12.717, -141.9),
        at(5.4, 18.0, -111.182_999_999_9),
    ];
    ring(&raceways, blend_m)
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Cylinder less the circular segment of the groove turned about the axis (Pappus).
#[test]
fn volume_of_the_conventional_ring() {
    let (ro, re, ros) = (27.765e-3, 4.953e-3, 26e-3f64);
    let half = ((ros - (ro - re)) / re).acos();
    let segment = re * re * (half - half.sin() * half.cos());
    let centroid = 4.0 * re * half.sin().powi(3) / (3.0 * (2.0 * half - (2.0 * half).sin()));
    let blank = PI * (31e-3f64.powi(2) - ros * ros) * 16e-3;
    let expected = blank - 2.0 * PI * (ro - re + centroid) * segment;
    let volume = ring(&[], 0.0).volume_m3();
    assert!(
        (volume / expected - 1.0).abs() < 1e-13,
        "{volume} {expected}"
    );
}

/// What discrete raceways change agrees with a plain sum over many thin slices.
#[test]
fn volume_with_raceways() {
    let plain = ring(&[], 0.0).volume_m3();
    for r in [structure_d(0.0), structure_d(0.5e-3), several(0.4e-3)] {
        let volume = r.volume_m3();
        let slices = 100_000;
        let added: f64 = (0..slices)
            .map(|k| {
                let psi = 2.0 * PI * (f64::from(k) + 0.5) / f64::from(slices);
                let [here, there] = [&r, &ring(&[], 0.0)].map(|r| r.meridian(psi).arcs[0]);
                let moment = |m: cageless::surface::Arc| {
                    let n = 40;
                    let top = m.height_m(m.shoulder_rad());
                    let sum: f64 = (0..n)
                        .map(|j| {
                            // Midpoints in η, where ρ² dz has no edge.
                            let (lo, hi) = (m.valley_rad(), m.shoulder_rad());
                            let eta = lo + (hi - lo) * (f64::from(j) + 0.5) / f64::from(n);
                            let dz = m.curvature_radius_m * eta.cos() * (hi - lo) / f64::from(n);
                            m.radius_at_m(eta).powi(2) * dz
                        })
                        .sum();
                    sum - 26e-3f64.powi(2) * top
                };
                (moment(there) - moment(here)) * 2.0 * PI / f64::from(slices)
            })
            .sum();
        assert!(((volume - plain) / added - 1.0).abs() < 1e-3, "{added}");
    }
}

/// α against its own slope by finite differences, up to the very ends.
#[test]
fn contact_angle_has_its_slope() {
    for (span, angle, ..) in structures() {
        let raceway = raceway(&bearing(), span, angle, 0.0);
        let theta = raceway.half_angle_rad();
        for fraction in [-0.999_99, -0.7, 0.1, 0.5, 0.9, 0.999, 0.999_95] {
            let h = 1e-6;
            let at = |x: f64| raceway.contact_angle_rad(fraction * theta + x)[0];
            let found = (at(h) - at(-h)) / (2.0 * h);
            let slope = raceway.contact_angle_rad(fraction * theta)[1];
            assert!(
                (found - slope).abs() < 1e-5,
                "{span} {fraction}: {found} {slope}"
            );
        }
        assert!(raceway.contact_angle_rad(theta)[0].abs() < 1e-15);
        let kink = raceway.kink_angle_rad(std::f64::consts::FRAC_PI_4);
        let r = ring(&[raceway], 0.0);
        assert!((r.kink_rad()[0] / kink - 1.0).abs() < 1e-4);
        assert!(r.kink_rad()[1] > r.kink_rad()[0]);
    }
}

/// Position, normal and curvature along ψ are continuous across both ends of each blend;
/// without it the normal jumps by the stated kink.
#[test]
fn blend_is_smooth() {
    let h = 1e-5;
    for blend in [0.1e-3, 0.5e-3, 2e-3] {
        let r = several(blend);
        assert_eq!(r.kink_rad(), [0.0; 2]);
        for raceway in r.raceways() {
            let d = raceway.dimensions();
            let start = d.half_angle_rad - blend / 27.765e-3;
            for local in [start, d.half_angle_rad, -start, -d.half_angle_rad] {
                let psi = d.centre_angle_rad + local;
                let arc = |k: f64| r.meridian(psi + k * h).arcs[0];
                let height = |k: f64| arc(k).centre_height_m;
                let slope = |k: f64| arc(k).height_slope_m;
                assert!((height(1e-3) - height(-1e-3)).abs() < 1e-10);
                let jump = slope(1e-3) - slope(-1e-3);
                assert!(jump.abs() < 1e-9, "{blend} {local}: {jump}");
                let bend = |side: f64| (slope(2.0 * side) - slope(side)) / (side * h);
                // The third derivative grows as the blend shortens.
                let allowed = 40.0 * h / blend.powi(2) * 1e-6 * 27.0;
                let jump = (bend(1.0) - bend(-1.0)).abs();
                assert!(jump < allowed, "{blend} {local}: {jump} {allowed}");
                let n = |k: f64| r.point(psi + k * 1e-9, 0.7).normal;
                assert!(dot(sub(n(1.0), n(-1.0)), sub(n(1.0), n(-1.0))).sqrt() < 1e-7);
            }
        }
    }
    let r = structure_d(0.0);
    let end = 25.2f64.to_radians();
    let eta = r.meridian(end).arcs[0].shoulder_rad();
    let [a, b] = [1e-9, -1e-9].map(|x| r.point(end + x, eta).normal);
    assert!((dot(a, b).acos() - r.kink_rad()[1]).abs() < 1e-6);
}

/// The blend touches the last stretch alone, less the shorter it is.
#[test]
fn blend_deviates_as_stated() {
    let mut last = f64::INFINITY;
    for blend in [2e-3, 1e-3, 0.5e-3, 0.25e-3] {
        let (blended, designed) = (structure_d(blend), structure_d(0.0));
        let stated = blended.blend_deviation_m();
        let (start, end) = (
            25.2f64.to_radians() - blend / 27.765e-3,
            25.2f64.to_radians(),
        );
        let mut worst = 0.0f64;
        for k in -2000..=2000 {
            let psi = f64::from(k) * 3e-4;
            for eta in [0.1, 0.5, 0.85] {
                let off = designed
                    .distance_m(blended.point(psi, eta).position_m)
                    .abs();
                assert!(
                    off < 1e-15 || (start..=end).contains(&psi.abs()),
                    "{psi} {off}"
                );
                worst = worst.max(off);
            }
        }
        assert!(worst <= stated && worst > 0.8 * stated, "{worst} {stated}");
        assert!(stated < 0.6 * last);
        last = stated;
    }
    assert!(structure_d(0.5e-3).blend_deviation_m() < 2e-6);
}

/// The contact points of a ball on its circle, blended or not: on the surface, and the
/// normal there points at the ball's centre within the meridian plane.
#[test]
fn contact_points_touch_the_ball() {
    let (touching, rw) = (27.765e-3 - 4.7625e-3, 4.7625e-3);
    for r in [structure_d(0.0), several(0.5e-3)] {
        for k in 0..720 {
            let psi = f64::from(k).to_radians() / 2.0;
            let m = r.meridian(psi);
            let e = [psi.sin(), -psi.cos(), 0.0];
            let ball = e.map(|c| c * touching);
            for side in [1.0, -1.0] {
                let contact = m.point(side * m.flank_angle_rad);
                let arm = sub(ball, contact.position_m);
                assert!((dot(arm, arm).sqrt() - rw).abs() < 1e-16 * 1e3);
                let t = [psi.cos(), psi.sin(), 0.0];
                let n = contact.normal;
                let flat = sub(n, t.map(|c| c * dot(n, t)));
                let cosine = dot(flat, arm) / (dot(flat, flat).sqrt() * rw);
                assert!((cosine - 1.0).abs() < 1e-12, "{psi}");
                assert!(r.distance_m(contact.position_m).abs() < 1e-16);
            }
        }
    }
}

/// The walls that meet the ball at ±α stand out of the plain groove, the ridge between them
/// lies below it: both against the arcs at the middle of the raceway.
#[test]
fn relief_against_the_plain_groove() {
    assert_eq!(ring(&[], 0.0).relief_m(), [0.0; 2]);
    let r = structure_d(0.5e-3);
    let [above, below] = r.relief_m();
    let (middle, plain) = (r.meridian(0.0), r.meridian(PI));
    let depth = middle.deepest_radius_m() - plain.deepest_radius_m();
    assert!((below / depth - 1.0).abs() < 1e-6, "{below} {depth}");
    // At the contact point the plain arc is Re − Rw less its component along the normal away.
    let contact = middle.point(middle.flank_angle_rad).position_m;
    let out = contact[1].hypot(contact[0]) - (27.765e-3 - 4.953e-3);
    let gap = 4.953e-3 - out.hypot(contact[2]);
    assert!(above >= gap && gap > 20e-6, "{above} {gap}");
}

/// Sectors tile the turn; each raceway is one.
#[test]
fn sectors_go_all_round() {
    for (r, count) in [
        (ring(&[], 0.0), 2),
        (structure_d(0.0), 3),
        (several(0.0), 5),
    ] {
        let sectors = r.sectors();
        assert_eq!(sectors.len(), count, "{sectors:?}");
        for (k, sector) in sectors.iter().enumerate() {
            assert!(sector.end_rad > sector.start_rad);
            assert!(sector.end_rad - sector.start_rad <= PI * (1.0 + 1e-12));
            let next = sectors[(k + 1) % count].start_rad;
            let gap = next - sector.end_rad;
            assert!((gap - (gap / (2.0 * PI)).round() * 2.0 * PI).abs() < 1e-9);
        }
    }
}

#[test]
fn patches_follow_the_surface() {
    let rings = [
        structure_d(0.0),
        structure_d(0.5e-3),
        several(0.3e-3),
        angular(),
        turned_back(),
    ];
    for r in rings {
        let symmetric = r.section_angle_rad == 0.0;
        for sector in r.sectors() {
            for tolerance in [1e-7, 1e-8, 1e-9] {
                let pair = Patch::pair(&r, &sector, tolerance).unwrap();
                for (patch, side) in pair.iter().zip(Side::BOTH) {
                    let stated = patch.deviation_m(&r, &sector, side);
                    assert!(stated <= tolerance);
                    let mut worst = 0.0f64;
                    for i in 0..=97 {
                        for j in 0..=53 {
                            let span = sector.end_rad - sector.start_rad;
                            let psi = sector.start_rad + span * f64::from(i) / 97.0;
                            let p = patch.point_m(psi, f64::from(j) / 53.0);
                            worst = worst.max(r.distance_m(p).abs());
                            let z = side.sign() * p[2];
                            assert!(!symmetric || z >= 0.0 && (j > 0 || z == 0.0));
                        }
                    }
                    assert!(worst <= 1.01 * stated, "{worst:e} {stated:e}");
                }
                // One ridge.
                let [upper, lower] = &pair;
                assert_eq!(upper.along_rad, lower.along_rad);
                for (a, b) in upper.control_m.iter().zip(&lower.control_m) {
                    let off = sub(a[0], b[0]);
                    assert!(dot(off, off).sqrt() < 1e-16, "{off:?}");
                    let mirrored = |(a, b): (&[f64; 3], &[f64; 3])| *a == [b[0], b[1], -b[2]];
                    assert!(!symmetric || a.iter().zip(b).all(mirrored));
                }
            }
        }
    }
}

/// A control point that is a micrometre off is not overlooked.
#[test]
fn deviation_is_honest() {
    let r = structure_d(0.5e-3);
    let sector = r.sectors()[1];
    let [good, _] = Patch::pair(&r, &sector, 1e-8).unwrap();
    for (i, j) in [(3, 3), (10, 0), (0, 5), (10, 5)] {
        let mut bad = good.clone();
        let p = &mut bad.control_m[i][j];
        let e = [p[0] / p[0].hypot(p[1]), p[1] / p[0].hypot(p[1])];
        p[0] += 1e-6 * e[0];
        p[1] += 1e-6 * e[1];
        let found = bad.deviation_m(&r, &sector, Side::Upper);
        // At least the square of the largest fraction of a cubic's middle control point.
        assert!((0.1e-6..1.01e-6).contains(&found), "{i} {j}: {found:e}");
    }
}

/// At the ends of a blended raceway a patch has the tangents of the plain raceway.
#[test]
fn patches_meet_the_plain_raceway_smoothly() {
    let r = structure_d(0.5e-3);
    let sector = r.sectors()[0];
    let [patch, _] = Patch::pair(&r, &sector, 1e-8).unwrap();
    let h = (patch.along_rad[1] - patch.along_rad[0]) * 1e-4;
    for u in [0.0, 0.37, 1.0] {
        let (p, q) = (
            patch.point_m(sector.start_rad, u),
            patch.point_m(sector.start_rad + h, u),
        );
        let tangent = sub(q, p);
        let eta = f64::from(u as f32) * r.meridian(1.0).arcs[0].shoulder_rad();
        let normal = r.meridian(1.0).angle_rad;
        assert_eq!(normal, 1.0);
        // The plain raceway's normal where the patch starts.
        let (sin, cos) = sector.start_rad.sin_cos();
        let n = [-eta.cos() * sin, eta.cos() * cos, -eta.sin()];
        let lean = dot(tangent, n) / dot(tangent, tangent).sqrt();
        assert!(lean.abs() < 1e-5, "{u}: {lean:e}");
    }
}

pub fn edges_are_shared_by_two(mesh: &Mesh) {
    use std::collections::HashMap;
    let mut edges = HashMap::new();
    for t in &mesh.triangles {
        for k in 0..3 {
            *edges.entry((t[k], t[(k + 1) % 3])).or_insert(0) += 1;
        }
    }
    for (&(a, b), &count) in &edges {
        assert!(count == 1 && edges.get(&(b, a)) == Some(&1), "{a} {b}");
    }
}

#[test]
fn meshes_are_closed_and_keep_the_chord_error() {
    let others = [
        ring(&[], 0.0),
        structure_d(0.0),
        several(0.5e-3),
        angular(),
        turned_back(),
    ];
    for r in others.into_iter().chain(slot_ring::rings()) {
        let volume = r.volume_m3();
        for chord in [20e-6, 2e-6] {
            let mesh = Mesh::new(&r, chord, 0.0).unwrap();
            edges_are_shared_by_two(&mesh);
            assert!(mesh.deviation_m <= chord && mesh.deviation_m > 0.3 * chord);
            // Area of the ring: below 9000 mm².
            let off = (mesh.volume_m3() - volume).abs();
            assert!(off < 9000e-6 * chord, "{off:e}");
            assert!(off < 2e-3 * volume);
        }
    }
}

#[test]
fn grid_covers_the_groove() {
    for r in [several(0.5e-3), angular(), turned_back()] {
        check_grid(&r);
    }
}

fn check_grid(r: &OuterRing) {
    let grid = Grid::new(r, 0.5e-3);
    assert!(grid.row_distance_m(r) <= 0.5e-3 * (1.0 + 1e-9));
    assert!(
        grid.rows
            .windows(2)
            .all(|w| w[0].angle_rad < w[1].angle_rad)
    );
    for row in &grid.rows {
        let points = grid.points(row);
        assert_eq!(points.len(), 2 * (grid.steps + 1));
        assert!(points.iter().all(|p| p.kind == PointKind::Surface));
        let eta: Vec<f64> = points.iter().map(|p| p.meridian_rad).collect();
        assert!(eta.windows(2).all(|w| w[0] <= w[1]));
        let arc = (eta[1] - eta[0]) * r.curvature_radius_m;
        assert!(arc <= 0.5e-3 * (1.0 + 1e-9), "{arc}");
        assert!(eta[0] > -FRAC_PI_2);
        // From shoulder to shoulder.
        let end = points[0].point.position_m;
        assert!((end[0].hypot(end[1]) - 26e-3).abs() < 1e-15);
    }
}

#[test]
fn rings_that_cannot_be_are_refused() {
    let b = bearing();
    let zone = raceway(&b, 5.1, 25.2, 0.0);
    let with = |change: &dyn Fn(&mut OuterRingDimensions)| {
        let mut size = OUTER_RING;
        change(&mut size);
        OuterRing::new(&b, std::slice::from_ref(&zone), size).map_err(|e| e.field)
    };
    // The groove reaches 27.784 mm in the middle of the raceway.
    for (radius, fits) in [
        (27.77e-3, false),
        (27.8e-3, true),
        (0.0, false),
        (f64::NAN, false),
    ] {
        let result = with(&|d| d.outer_ring_outer_radius_m = radius);
        assert_eq!(result.is_ok(), fits, "{radius}");
        assert!(fits || result.unwrap_err() == "outer_ring_outer_radius_m");
    }
    for (width, fits) in [
        (7.5e-3, false),
        (7.6e-3, true),
        (-1.0, false),
        (f64::NAN, false),
    ] {
        let result = with(&|d| d.outer_ring_width_m = width);
        assert_eq!(result.is_ok(), fits, "{width}");
        assert!(fits || result.unwrap_err() == "outer_ring_width_m");
    }
    for (blend, fits) in [
        (1e-6, false),
        (0.05e-3, true),
        (6e-3, true),
        (7e-3, false),
        (-1e-3, false),
    ] {
        let result = with(&|d| d.blend_m = blend);
        assert_eq!(result.is_ok(), fits, "{blend}");
        assert!(fits || result.unwrap_err() == "blend_m");
    }
    for chord in [0.0, 1e-9, 1e-2, f64::NAN] {
        assert!(Mesh::new(&structure_d(0.0), chord, 1e-9).is_err());
    }
}
