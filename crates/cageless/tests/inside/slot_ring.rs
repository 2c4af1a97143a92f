//! The ring of a slot: its surface against the edges that balls feel, closed forms and itself.

use std::f64::consts::FRAC_PI_2;

use crate::common::{conventional, dimensions, steel};
use cageless::equilibrium::space::outer_section::{Flanks, OuterSection};
use cageless::numerics::taylor::Taylor;
use cageless::numerics::vector::SectionVector;
use cageless::surface::{
    DrawnGroove, EdgePlace, Grid, Mesh, OuterRing, OuterRingDimensions, Patch, PointKind, Side,
};
use cageless::{
    Bearing, Case, InputError, Raceway, RacewayDimensions, RacewayForm, RacewayShape, Row,
};

pub const SIZE: OuterRingDimensions = OuterRingDimensions {
    outer_ring_outer_radius_m: 31e-3,
    outer_ring_width_m: 16e-3,
    blend_m: 0.5e-3,
};

/// lC and re in mm, θ and ψ of the middle in degrees.
pub type Given = [f64; 4];

pub fn slot(bearing: &Bearing, [span, edge, angle, centre]: Given) -> Result<Raceway, InputError> {
    let dimensions = RacewayDimensions {
        axial_span_m: span * 1e-3,
        half_angle_rad: angle.to_radians(),
        centre_angle_rad: centre.to_radians(),
    };
    let form = RacewayForm {
        shape: RacewayShape::Slot,
        edge_radius_m: edge * 1e-3,
        ..RacewayForm::default()
    };
    Raceway::formed(dimensions, form, bearing)
}

/// Share of the end of a slot before which it is the same for contacts as for a mill: 0.03 Rw are left of half its
/// width.
const RUNS_OUT: f64 = 0.86;

/// A bearing of the contact angle α0 with slots turned by αg, in degrees, in a row of this contact sign.
pub fn case(free: f64, section: f64, sign: f64, slots: &[Given]) -> Case {
    let mut case = conventional(dimensions());
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    let opened = bearing.with_contact_angle(free.to_radians(), 0.0);
    case.bearing = opened.unwrap();
    let turned = |given: &Given| {
        let slot = slot(&case.bearing, *given).unwrap();
        let turned = slot.with_section_angle(section.to_radians(), &case.bearing);
        turned.unwrap()
    };
    case.raceways = slots.iter().map(turned).collect();
    case.rows = vec![Row {
        contact_sign: sign,
        ..Row::default()
    }];
    case
}

fn ring(slots: &[Given]) -> OuterRing {
    OuterRing::of(&case(0.0, 0.0, 1.0, slots), SIZE).unwrap()
}

/// A slot, one without straight stretch, two next to each other, and turned ones.
pub fn rings() -> Vec<OuterRing> {
    let turned = |free, section, sign| {
        let case = case(free, section, sign, &[[2.4, 0.3, 25.2, 17.3]]);
        OuterRing::of(&case, SIZE).unwrap()
    };
    vec![
        ring(&[[5.1, 0.3, 25.2, 33.0]]),
        ring(&[[2.4, 0.3, 2.632_305_24, 180.0]]),
        ring(&[[2.4, 0.3, 20.0, 0.0], [1.9, 0.5, 30.0, 51.1]]),
        turned(15.0, 15.0, 1.0),
        turned(20.0, 14.0, -1.0),
    ]
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// Distance of a point from the lower or upper half of the patch around an end: of all its points, and of
/// those in the plane of the point and the bearing axis, by finer and finer steps around the nearest.
fn distances_m(patch: &Patch, centre: [f64; 3], side: f64) -> [f64; 2] {
    let (mut turn, mut share) = (side * 0.8, 0.3);
    let (mut wide, mut high, mut least) = (0.8, 0.4, f64::INFINITY);
    for _ in 0..24 {
        let (at, across) = (turn, share);
        for i in -4..=4 {
            for j in -4..=4 {
                let place = [
                    (at + wide * f64::from(i) / 4.0).clamp(-FRAC_PI_2, FRAC_PI_2),
                    (across + high * f64::from(j) / 4.0).clamp(0.0, 1.0),
                ];
                let off = length(sub(patch.point_m(place[0], place[1]), centre));
                if off < least {
                    (least, turn, share) = (off, place[0], place[1]);
                }
            }
        }
        (wide, high) = (0.5 * wide, 0.5 * high);
    }
    let psi = |[x, y, _]: [f64; 3]| x.atan2(-y);
    let own = psi(centre);
    let in_plane = |share: f64| {
        let (mut near, mut far) = (0.0, side * FRAC_PI_2);
        let [first, last] = [near, far].map(|turn| psi(patch.point_m(turn, share)));
        let rises = last > first;
        if (own - first) * (own - last) > 0.0 {
            return f64::INFINITY;
        }
        for _ in 0..50 {
            let middle = (near + far) / 2.0;
            let beyond = psi(patch.point_m(middle, share)) > own;
            (near, far) = if beyond == rises {
                (near, middle)
            } else {
                (middle, far)
            };
        }
        length(sub(patch.point_m(near, share), centre))
    };
    let (mut low, mut high) = (0.0, 0.9);
    for _ in 0..50 {
        let third = (high - low) / 3.0;
        // Close to the tip the plane misses the lower part of the edge.
        let upper = in_plane(high - third);
        if upper.is_infinite() || in_plane(low + third) < upper {
            high -= third;
        } else {
            low += third;
        }
    }
    [least, in_plane(low)]
}

/// A nominal ball next to its place of rest sinks as deep into the edges of the file as into those of the
/// model: on 200 places of each straight edge, and as many around the ends in its section. That it touches
/// ahead of or behind its section there is left out of the model, and less than 0.3 µm.
#[test]
fn balls_feel_the_edges_of_the_model() {
    let mut ahead = 0.0f64;
    for (free, section, sign, given) in [
        (0.0, 0.0, 1.0, [2.4, 0.3, 25.2, 0.0]),
        (0.0, 0.0, 1.0, [1.9, 0.5, 30.0, 0.0]),
        (15.0, 15.0, 1.0, [2.4, 0.3, 25.2, 0.0]),
        (20.0, 14.0, -1.0, [2.2, 0.3, 12.0, 0.0]),
    ] {
        let case = case(free, section, sign, &[given]);
        let ring = OuterRing::of(&case, SIZE).unwrap();
        let (d, raceway) = (case.bearing.dimensions(), &case.raceways[0]);
        let recess = &ring.recesses[0];
        let rw = d.ball_radius_m;
        let gap_m = d.outer_groove_curvature_radius_m - rw;
        let room = gap_m + d.inner_groove_curvature_radius_m - rw;
        let turned = sign * section.to_radians();
        let straight = recess.straight_rad.unwrap();
        let patches = [-1.0, 1.0].map(|end| recess.end_patches(end, 1e-8).unwrap());
        let model = |psi: f64| OuterSection {
            gap_m,
            axial_m: -0.5 * sign * room * free.to_radians().sin(),
            flanks: Some(Flanks {
                angle_rad: raceway.contact_angle_rad(psi)[0],
                section_angle_rad: turned,
                nominal_gap_m: gap_m,
                depth_error_m: 0.0,
                depth_m: raceway.depth_at_m(psi)[0],
                slot: Some(raceway.slot().unwrap().at(psi)),
            }),
        };
        // Centre of a ball and δe there, pressed by a distance along a direction in the section.
        let pressed = |psi: f64, by: f64, towards: f64| {
            let model = model(psi);
            let flanks = model.flanks.unwrap();
            let back = gap_m + flanks.depth_m;
            let beyond = back * turned.cos() - gap_m + by * towards.cos();
            let axial = model.axial_m + back * turned.sin() + by * towards.sin();
            let place = SectionVector {
                radial: beyond,
                axial,
            };
            let place = place.map(Taylor::<0>::constant);
            let approach = model.approach(place, Taylor::constant(flanks.angle_rad));
            let rho = d.outer_groove_bottom_radius_m - rw + beyond;
            let centre = [rho * psi.sin(), -rho * psi.cos(), axial];
            (centre, approach.unwrap().value)
        };
        for k in 0..200 {
            let share = (f64::from(k) - 99.5) / 100.0;
            for side in Side::BOTH {
                // Almost along the other edge, so that the ball leaves it. The file has a torus.
                let psi = share * straight;
                let [angle, _] = raceway.contact_angle_rad(psi);
                let towards = turned + side.sign() * (94f64.to_radians() - angle);
                let (ball, expected) = pressed(psi, 8e-6, towards);
                let [_, [major, height], ..] = recess.straight_m(side);
                let apart = (ball[0].hypot(ball[1]) - major).hypot(ball[2] - height);
                let felt = rw + recess.edge_radius_m - apart;
                assert!((felt - expected).abs() < 0.02e-6, "{given:?} {psi}: {felt}");
                assert!(expected > 1e-6);
                // Into both edges, up to where the end of the slot runs out as contacts meet it.
                let end = share.signum();
                let into = RUNS_OUT * share.abs() * (raceway.half_angle_rad() - straight);
                let psi = end * (straight + into);
                let (ball, both) = pressed(psi, 3e-6, turned);
                let inverse = raceway.slot().unwrap().at(psi).inverse_exponent[0];
                let expected = both / 2f64.powf(inverse);
                let [patch, _] = &patches[usize::from(end > 0.0)];
                let [all, section] = distances_m(patch, ball, side.sign()).map(|off| rw - off);
                let off = section - expected;
                assert!(off.abs() < 0.02e-6, "{given:?} {psi} {side:?}: {off:e}");
                ahead = ahead.max(all - expected);
                assert!(all - expected > -0.02e-6, "{all} {expected}");
            }
        }
    }
    assert!((0.2e-6..0.3e-6).contains(&ahead), "{ahead:e}");
}

/// Every point of the rounded edge around an end, up to where it runs out as contacts meet it, is re from the line on which the model has the centres of
/// its edges, and none is nearer.
#[test]
fn edges_are_round_about_the_line_of_the_model() {
    let given = [5.1, 0.3, 25.2, 0.0];
    let case = case(0.0, 0.0, 1.0, &[given]);
    let ring = OuterRing::of(&case, SIZE).unwrap();
    let (d, raceway) = (case.bearing.dimensions(), &case.raceways[0]);
    let (recess, theta) = (&ring.recesses[0], raceway.half_angle_rad());
    let (rw, re) = (d.ball_radius_m, recess.edge_radius_m);
    // From the centre of a ball that rests in the model, along the line through its contact.
    let centre = |psi: f64, side: f64| {
        let [angle, _] = raceway.contact_angle_rad(psi);
        let [sink, _] = raceway.depth_at_m(psi);
        let rho = d.outer_groove_bottom_radius_m - rw + sink + (rw + re) * angle.cos();
        let z = side * (rw + re) * angle.sin();
        [rho * psi.sin(), -rho * psi.cos(), z]
    };
    let [patch, _] = recess.end_patches(1.0, 1e-8).unwrap();
    let straight = recess.straight_rad.unwrap();
    for i in 0..=40 {
        for j in 0..=10 {
            let turn = FRAC_PI_2 * f64::from(i) / 40.0;
            if turn.cos() > RUNS_OUT {
                continue;
            }
            let point = patch.point_m(turn, f64::from(j) / 10.0);
            let off = |turn: f64| {
                let psi = straight + (theta - straight) * turn.cos();
                length(sub(centre(psi, turn.signum()), point))
            };
            let (mut near, mut wide) = (turn, 0.4);
            for _ in 0..40 {
                let places = (-4..=4).map(|k| near + wide * f64::from(k) / 4.0);
                near = places.fold(near, |a, b| if off(b) < off(a) { b } else { a });
                wide *= 0.6;
            }
            assert!((off(near) - re).abs() < 0.02e-6, "{i} {j}: {:e}", off(near));
        }
    }
}

/// An edge is tangent to the groove and to its wall, which goes along the axis of the mill to the floor.
#[test]
fn an_edge_runs_into_groove_and_wall() {
    for ring in rings() {
        for recess in &ring.recesses {
            let straight = recess.straight_rad.unwrap_or(0.0);
            let ends = (-20..=20).map(|k| f64::from(k) / 20.0);
            let places = ends.flat_map(|share| {
                [1.0, -1.0].map(|one| {
                    let turn = share * FRAC_PI_2;
                    [
                        EdgePlace::End(one, turn),
                        EdgePlace::Straight(one, share * straight),
                    ]
                })
            });
            for place in places.flatten() {
                let edge = recess.edge(place);
                let rim = edge.arc_m(0.0);
                assert!(ring.distance_m(rim).abs() < 1e-17);
                let groove = ring.point(edge.angle_rad, edge.groove_rad);
                assert!(length(sub(groove.position_m, rim)) < 1e-16);
                assert!(length(sub(groove.normal, edge.normal(0.0))) < 1e-14);
                assert!(dot(edge.normal(1.0), edge.mill).abs() < 1e-15);
                assert!(edge.normal(0.5).iter().all(|c| c.is_finite()));
                let [top, foot] = [0.0, 1.0].map(|share| edge.wall_m(share));
                assert!(length(sub(top, edge.arc_m(1.0))) < 1e-17);
                let along = sub(foot, top).map(|c| c / edge.wall_length_m);
                assert!(length(sub(along, edge.mill)) < 1e-12);
                assert!(recess.below_floor_m(foot).abs() < 1e-17);
                assert!(edge.wall_length_m > 0.9 * recess.edge_radius_m);
                // Around an end the mill stands still: no wall is undercut.
                if let EdgePlace::End(end, _) = place {
                    assert_eq!(edge.mill, recess.edge(EdgePlace::End(end, 0.0)).mill);
                }
            }
        }
    }
}

/// What a longer straight stretch takes away is its section turned about the axis, summed in slices.
#[test]
fn volume_of_a_longer_slot() {
    let (ro, re, edge, depth) = (27.765e-3, 4.953e-3, 0.3e-3, 0.8e-3f64);
    let made = |angle: f64| {
        let bearing = Bearing::new(dimensions(), steel()).unwrap();
        let form = RacewayForm {
            shape: RacewayShape::Slot,
            edge_radius_m: edge,
            slot_depth_m: Some(depth),
            ..RacewayForm::default()
        };
        let size = RacewayDimensions {
            axial_span_m: 3e-3,
            half_angle_rad: angle,
            centre_angle_rad: 0.4,
        };
        let slot = Raceway::formed(size, form, &bearing).unwrap();
        OuterRing::new(&bearing, &[slot], SIZE).unwrap().volume_m3()
    };
    let taken = (made(0.2) - made(0.35)) / 0.3;
    let centre = (4.7625e-3 + edge) * 3e-3 / (2.0 * 4.7625e-3);
    let behind = ro - re + ((re + edge).powi(2) - centre * centre).sqrt();
    let leaves = centre * re / (re + edge);
    let slices = 200_000;
    let expected: f64 = (0..slices)
        .map(|k| {
            let z = leaves * (f64::from(k) + 0.5) / f64::from(slices);
            let groove = ro - re + (re * re - z * z).sqrt();
            let beside = centre - z;
            let below = if beside < edge {
                behind - (edge * edge - beside * beside).sqrt()
            } else {
                ro + depth
            };
            (below * below - groove * groove) * leaves / f64::from(slices)
        })
        .sum();
    assert!((taken / expected - 1.0).abs() < 1e-4, "{taken} {expected}");
    // A mesh knows nothing of the formulas.
    for ring in rings() {
        let plain = OuterRing::new(&case(0.0, 0.0, 1.0, &[]).bearing, &[], SIZE).unwrap();
        let mesh = |ring: &OuterRing| Mesh::new(ring, 0.4e-6, 0.0).unwrap().volume_m3();
        if ring.section_angle_rad == 0.0 {
            let taken = plain.volume_m3() - ring.volume_m3();
            let off = (mesh(&plain) - mesh(&ring)) / taken - 1.0;
            assert!(off.abs() < 3e-3, "{off:e}");
        }
    }
}

/// Rows of points pass a slot from shoulder to shoulder, face by face, and the tracks of the contacts its edges.
#[test]
fn rows_of_points_pass_a_slot() {
    use PointKind::{Edge, Floor, Surface, Wall};
    for ring in rings() {
        let spacing = 0.2e-3;
        let grid = Grid::new(&ring, spacing);
        let angles: Vec<f64> = grid.rows.iter().map(|row| row.angle_rad).collect();
        assert!(angles.windows(2).all(|w| w[0] < w[1]));
        assert!(grid.row_distance_m(&ring) <= spacing * (1.0 + 1e-9));
        let (mut through, mut straight) = (0, 0);
        for row in &grid.rows {
            let points = grid.points(row);
            let mut kinds: Vec<PointKind> = points.iter().map(|p| p.kind).collect();
            kinds.dedup();
            if kinds.len() > 1 {
                assert_eq!(kinds, [Surface, Edge, Wall, Floor, Wall, Edge, Surface]);
                through += 1;
            }
            for pair in points.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|p| p.point);
                let step = length(sub(a.position_m, b.position_m));
                assert!(step <= spacing * (1.0 + 1e-9), "{step}");
                // Only at the foot of the walls, and at the ridge between flanks, is there a corner.
                let smooth = pair.iter().all(|p| p.kind != Floor) || pair[0].kind == pair[1].kind;
                assert!(!smooth || step > 0.0 || dot(a.normal, b.normal) > 1.0 - 1e-12);
            }
            for side in Side::BOTH {
                let contact = row.contact(side);
                assert!((length(contact.point.normal) - 1.0).abs() < 1e-12);
                // On straight edges a ball touches at ±αc.
                let turned = ring.section_angle_rad;
                for (raceway, recess) in ring.raceways().zip(&ring.recesses) {
                    let local = raceway.local_angle_rad(row.angle_rad);
                    if local.abs() < recess.straight_rad.unwrap_or(0.0) {
                        let [angle, _] = raceway.contact_angle_rad(local);
                        let off = contact.meridian_rad - turned - side.sign() * angle;
                        assert!(off.abs() < 1e-12, "{off}");
                        straight += 1;
                    }
                }
            }
        }
        assert!(through > 10 && (straight > 100 || ring.recesses[0].straight_rad.is_none()));
    }
}

#[test]
fn slots_that_cannot_be_made_are_refused() {
    let of = |slots: &[Given], size| {
        OuterRing::of(&case(0.0, 0.0, 1.0, slots), size).map_err(|e| e.field)
    };
    let two = |centre: f64| of(&[[2.4, 0.3, 20.0, 0.0], [2.4, 0.3, 20.0, centre]], SIZE);
    // 40° and the radius of the edges, 0.62° at the bottom of the groove.
    assert_eq!(two(40.61).unwrap_err(), "centre_angle_rad");
    assert!(two(40.63).is_ok() && two(-40.63).is_ok());
    let thin = |outer_ring_outer_radius_m: f64| {
        let size = OuterRingDimensions {
            outer_ring_outer_radius_m,
            ..SIZE
        };
        of(&[[2.4, 0.3, 20.0, 0.0]], size)
    };
    // The floor is 2 re and the sink of 6.1 µm below the bottom.
    assert_eq!(thin(28.37e-3).unwrap_err(), "slot_depth_m");
    assert!(thin(28.372e-3).is_ok());
    // Half a slot of 11 µm, less than what its ends are longer than half circles.
    assert_eq!(
        of(&[[1.085, 0.6, 20.0, 0.0]], SIZE).unwrap_err(),
        "edge_radius_m"
    );
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    let deep = |shape, edge_radius_m, slot_depth_m| {
        let form = RacewayForm {
            shape,
            edge_radius_m,
            slot_depth_m,
            ..RacewayForm::default()
        };
        let dimensions = RacewayDimensions {
            axial_span_m: 2.4e-3,
            half_angle_rad: 0.4,
            centre_angle_rad: 0.0,
        };
        Raceway::formed(dimensions, form, &bearing).map_err(|e| e.field)
    };
    let slot = |depth| deep(RacewayShape::Slot, 0.3e-3, depth);
    for depth in [0.0, 0.306e-3, f64::NAN] {
        assert_eq!(slot(Some(depth)).unwrap_err(), "slot_depth_m");
    }
    assert!(slot(Some(0.3062e-3)).is_ok());
    let depth = slot(None).unwrap().slot().unwrap().depth_m;
    assert!((depth - 0.6061e-3).abs() < 1e-7, "{depth}");
    let other = deep(RacewayShape::Quartic, 0.0, Some(1e-3));
    assert_eq!(other.unwrap_err(), "slot_depth_m");
}

/// Drawn points of a slot are on the plain groove, on an edge, a wall or the floor of its ring, from shoulder to shoulder.
#[test]
fn a_drawn_groove_is_that_of_the_ring() {
    for sign in [1.0, -1.0] {
        let case = case(15.0, 12.0, sign, &[[2.4, 0.3, 25.2, 17.3]]);
        let ring = OuterRing::of(&case, SIZE).unwrap();
        let recess = &ring.recesses[0];
        let groove = DrawnGroove::new(&case.bearing, case.raceways.first(), sign);
        for share in [-0.999, -0.95, -0.5, 0.0, 0.7, 0.9, 1.0, 1.1] {
            let local = share * recess.half_angle_rad;
            let points = groove.points(recess.middle_rad + local, 25);
            assert_eq!(points.len(), 50);
            let mut found = [0; 4];
            for (k, point) in points.iter().enumerate() {
                let side = if k < 25 { -1.0 } else { 1.0 };
                let into = (local.abs() - recess.straight_rad.unwrap()).max(0.0);
                let end = recess.half_angle_rad - recess.straight_rad.unwrap();
                let near = match into > 0.0 {
                    true => EdgePlace::End(local.signum(), side * (into / end).min(1.0).acos()),
                    false => EdgePlace::Straight(side, local),
                };
                let off = [
                    ring.distance_m(*point),
                    recess.below_edge_m(*point, near),
                    recess.below_wall_m(*point, near),
                    recess.below_floor_m(*point),
                ];
                let on = off.map(|off| off.abs() < 1e-11);
                assert!(on.contains(&true), "{share} {k}: {off:?}");
                for (count, on) in found.iter_mut().zip(on) {
                    *count += usize::from(on);
                }
            }
            for end in [points[0], points[49]] {
                assert!((end[0].hypot(end[1]) - ring.shoulder_radius_m).abs() < 1e-12);
            }
            // Every kind of face, and beyond the tips the groove alone.
            let inside = share.abs() < 1.0;
            assert!(
                found[0] >= 20 && (found[1] > 10) == inside,
                "{share}: {found:?}"
            );
            assert!((found[3] > 4) == inside, "{share}: {found:?}");
        }
    }
}
