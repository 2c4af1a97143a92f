//! Rings whose sections are turned by a contact angle, against the model of the equilibrium in space.

use crate::common::{conventional, dimensions, raceway, steel};
use cageless::equilibrium::space::outer_section::{Flanks, OuterSection};
use cageless::numerics::taylor::Taylor;
use cageless::numerics::vector::SectionVector;
use cageless::surface::{DrawnGroove, Mesh, OuterRing, OuterRingDimensions, Patch, Side};
use cageless::{Bearing, Case, InputError, Row};

const SIZE: OuterRingDimensions = OuterRingDimensions {
    outer_ring_outer_radius_m: 31e-3,
    outer_ring_width_m: 16e-3,
    blend_m: 0.5e-3,
};

/// A bearing of the contact angle α0 whose raceways (lC, θ and centre as in `raceway`) are turned
/// by αg, in degrees.
fn case(free_deg: f64, raceways: &[(f64, f64, f64)], section_deg: f64) -> Case {
    let mut case = conventional(dimensions());
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    case.bearing = bearing
        .with_contact_angle(free_deg.to_radians(), 0.0)
        .unwrap();
    let turned = |&(span, angle, centre): &(f64, f64, f64)| {
        let raceway = raceway(&case.bearing, span, angle, centre);
        let turned = raceway.with_section_angle(section_deg.to_radians(), &case.bearing);
        turned.unwrap()
    };
    case.raceways = raceways.iter().map(turned).collect();
    case
}

fn ring(case: &Case) -> OuterRing {
    OuterRing::of(case, SIZE).unwrap()
}

/// The ring of structure (d) of the paper in a bearing of α0 = 15°, turned by it.
pub fn angular() -> OuterRing {
    ring(&case(15.0, &[(5.1, 25.2, 0.0)], 15.0))
}

/// Two raceways in a radial bearing, turned by a small angle to the other side.
pub fn turned_back() -> OuterRing {
    let raceways = [(5.1, 25.2, 17.3), (6.0, 12.717, -141.9)];
    ring(&case(0.0, &raceways, -4.0))
}

fn with_row(mut case: Case, contact_sign: f64) -> Case {
    case.rows = vec![Row {
        axial_position_m: 3e-3,
        contact_sign,
        ..Row::default()
    }];
    case
}

/// A section of a bearing is that of its ring, turned to either side, deeper and on the plain groove.
#[test]
fn a_section_needs_no_ring() {
    for sign in [1.0, -1.0] {
        let mut case = with_row(case(15.0, &[(5.1, 25.2, 17.3)], 12.0), sign);
        case.raceways = vec![case.raceways[0].clone().with_depth(15e-6).unwrap()];
        let size = OuterRingDimensions {
            blend_m: 0.0,
            ..SIZE
        };
        let ring = OuterRing::of(&case, size).unwrap();
        for psi in [0.1f64, 0.3, 0.7] {
            let groove = DrawnGroove::new(&case.bearing, case.raceways.first(), sign);
            assert_eq!(groove.meridian(psi), ring.meridian(psi));
        }
        let plain = DrawnGroove::new(&case.bearing, None, sign)
            .meridian(0.3)
            .point(0.2 * sign)
            .position_m;
        let wanted = ring.point(2.0, 0.2 * sign).position_m;
        let apart = plain[0].hypot(plain[1]) - wanted[0].hypot(wanted[1]);
        assert!(apart.abs() < 1e-15 && (plain[2] - wanted[2]).abs() < 1e-15);
    }
}

/// Distance of a point from a B-spline, by finer and finer grids around the nearest point.
fn distance_m(patch: &Patch, [x, y, z]: [f64; 3]) -> f64 {
    let (mut psi, mut u) = (x.atan2(-y), 0.5);
    let (mut wide, mut high, mut least) = (0.01, 0.5, f64::INFINITY);
    let ends = [
        patch.along_rad[0],
        patch.along_rad[patch.along_rad.len() - 1],
    ];
    for _ in 0..16 {
        let (at, across) = (psi, u);
        for i in -4..=4 {
            for j in -4..=4 {
                let place = [
                    (at + wide * f64::from(i) / 4.0).clamp(ends[0], ends[1]),
                    (across + high * f64::from(j) / 4.0).clamp(0.0, 1.0),
                ];
                let p = patch.point_m(place[0], place[1]);
                let off = (p[0] - x).hypot(p[1] - y).hypot(p[2] - z);
                if off < least {
                    (least, psi, u) = (off, place[0], place[1]);
                }
            }
        }
        (wide, high) = (0.4 * wide, 0.4 * high);
    }
    least
}

/// A nominal ball next to its place of rest sinks as deep into the B-splines of the file as into the
/// flanks of the model, at 200 places of each flank within the blends.
#[test]
fn balls_feel_the_flanks_of_the_model() {
    for (free, section, sign, depth) in [
        (0.0, 12.0, 1.0, 0.0),
        (15.0, 15.0, 1.0, 0.0),
        (15.0, 0.0, 1.0, 0.0),
        (20.0, 14.0, -1.0, 0.0),
        (0.0, -7.0, -1.0, 0.0),
        (0.0, 0.0, 1.0, 20e-6),
        (20.0, 14.0, -1.0, 15e-6),
    ] {
        let mut case = with_row(case(free, &[(5.1, 25.2, 0.0)], section), sign);
        case.raceways = vec![case.raceways[0].clone().with_depth(depth).unwrap()];
        let ring = ring(&case);
        let (d, raceway) = (case.bearing.dimensions(), &case.raceways[0]);
        let re = d.outer_groove_curvature_radius_m;
        let gap_m = re - d.ball_radius_m;
        let room = re + d.inner_groove_curvature_radius_m - 2.0 * d.ball_radius_m;
        let middle = *ring
            .sectors()
            .iter()
            .find(|s| s.raceway.is_some() && !s.blend)
            .unwrap();
        let pair = Patch::pair(&ring, &middle, 1e-8).unwrap();
        let mut deepest = 0.0f64;
        for k in 0..200 {
            let psi = raceway.half_angle_rad() * (f64::from(k) - 99.5) / 118.0;
            let [angle_rad, _] = raceway.contact_angle_rad(psi);
            let section_angle_rad = sign * section.to_radians();
            let [depth_m, _] = raceway.depth_at_m(psi);
            let model = OuterSection {
                gap_m,
                axial_m: -0.5 * sign * room * free.to_radians().sin(),
                flanks: Some(Flanks {
                    angle_rad,
                    section_angle_rad,
                    nominal_gap_m: gap_m,
                    depth_error_m: 0.0,
                    depth_m,
                    slot: None,
                }),
            };
            for (patch, side) in pair.iter().zip([1.0, -1.0]) {
                // Almost along the other flank, so that the ball leaves it.
                let towards = section_angle_rad + side * (94f64.to_radians() - angle_rad);
                let back = gap_m + depth_m;
                let beyond = back * section_angle_rad.cos() - gap_m + 8e-6 * towards.cos();
                let axial = model.axial_m + back * section_angle_rad.sin() + 8e-6 * towards.sin();
                let place = SectionVector {
                    radial: beyond,
                    axial,
                };
                let expected = (model.approach(
                    place.map(Taylor::<0>::constant),
                    Taylor::constant(angle_rad),
                ))
                .unwrap();
                assert_eq!(model.contacts(place).len(), 1);
                let rho = d.outer_groove_bottom_radius_m - d.ball_radius_m + beyond;
                let centre = [rho * psi.sin(), -rho * psi.cos(), axial];
                let felt = d.ball_radius_m - distance_m(patch, centre);
                let off = felt - expected.value;
                assert!(
                    off.abs() < 0.02e-6,
                    "{free} {section} {psi} {side}: {off:e}"
                );
                deepest = deepest.max(felt);
            }
        }
        assert!(deepest > 5e-6, "{deepest}");
    }
}

/// Both flanks meet on the line through the centre of the ball at αg, at the angle that a section
/// that is not turned has: 2 asin((Re − Rw) sin α/Re).
#[test]
fn flanks_meet_in_the_axis_of_the_section() {
    for (free, section) in [(15.0, 15.0), (15.0, 0.0), (0.0, -8.0)] {
        let case = case(free, &[(5.1, 25.2, 0.0)], section);
        let ring = ring(&case);
        let (rw, re): (f64, f64) = (4.7625e-3, 4.953e-3);
        for k in 0..100 {
            let psi = 0.4399 * f64::from(k) / 100.0;
            let m = ring.meridian(psi);
            let [upper, lower] = m.arcs.map(|arc| {
                let p = arc.point(psi, arc.valley_rad()).position_m;
                [p[0].hypot(p[1]), p[2]]
            });
            assert!((upper[0] - lower[0]).hypot(upper[1] - lower[1]) < 1e-16);
            let [up, down] = [0, 1].map(|k| m.arcs[k].contact_angle_rad);
            assert!((up - down - 2.0 * section.to_radians()).abs() < 1e-15);
            let wedge = 2.0 * ((re - rw) * m.flank_angle_rad.sin() / re).asin();
            assert!((m.ridge_rad() - wedge).abs() < 1e-14);
            // Halfway between the points where the ball touches is the axis.
            let [a, b] = Side::BOTH.map(|side| {
                let arc = m.arc(side);
                let p = arc.point(psi, arc.contact_angle_rad).position_m;
                [p[0].hypot(p[1]), p[2]]
            });
            let half = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
            let along = (upper[1] - half[1]).atan2(upper[0] - half[0]);
            if upper[0] - half[0] > 1e-5 {
                assert!(
                    (along - section.to_radians()).abs() < 1e-9,
                    "{psi}: {along}"
                );
            }
        }
        let widest = ring.meridian(0.0).ridge_rad();
        assert_eq!(ring.ridge_rad(), widest);
    }
}

/// A section turned the other way is the mirror image: points, B-splines, mesh and volume.
#[test]
fn the_opposite_angle_gives_the_mirror_image() {
    let raceways = [(5.1, 25.2, 17.3), (6.0, 12.717, -141.9)];
    for (free, section, blend_m) in [(15.0, 10.0, 0.5e-3), (0.0, 8.0, 0.0)] {
        let one = with_row(case(free, &raceways, section), 1.0);
        let size = OuterRingDimensions { blend_m, ..SIZE };
        let other = match free {
            0.0 => case(0.0, &raceways, -section),
            _ => with_row(one.clone(), -1.0),
        };
        let [one, other] = [one, other].map(|case| OuterRing::of(&case, size).unwrap());
        assert_eq!(one.volume_m3(), other.volume_m3());
        assert_eq!(one.relief_m(), other.relief_m());
        assert_eq!(one.design_kink_rad(), other.design_kink_rad());
        for k in 0..360 {
            let psi = f64::from(k).to_radians();
            for eta in [-0.8, -0.1, 0.2, 0.6] {
                let (p, q) = (one.point(psi, eta), other.point(psi, -eta));
                let flip = |[x, y, z]: [f64; 3]| [x, y, -z];
                assert_eq!(p.position_m, flip(q.position_m));
                assert_eq!(p.normal, flip(q.normal));
            }
        }
        let sector = one.sectors()[0];
        let [upper, lower] = Patch::pair(&one, &sector, 1e-8).unwrap();
        let [up, down] = Patch::pair(&other, &sector, 1e-8).unwrap();
        for (p, q) in [(&upper, &down), (&lower, &up)] {
            for (p, q) in p
                .control_m
                .iter()
                .flatten()
                .zip(q.control_m.iter().flatten())
            {
                assert_eq!([p[0], p[1], -p[2]], *q);
            }
        }
        let [a, b] = [&one, &other].map(|ring| Mesh::new(ring, 20e-6, 0.0).unwrap());
        assert_eq!(a.vertices_m.len(), b.vertices_m.len());
        assert!((a.volume_m3() / b.volume_m3() - 1.0).abs() < 1e-9);
    }
}

/// The plain groove of a bearing of α0 = 15° is offset so that a ball in the middle of the ring
/// touches it at 15°; the loss of volume is that of the groove in the middle.
#[test]
fn an_angular_contact_groove_is_offset() {
    let case = case(15.0, &[], 0.0);
    let turned = ring(&case);
    let d = case.bearing.dimensions();
    let m = turned.meridian(1.0);
    let (sin, cos) = 15f64.to_radians().sin_cos();
    for side in Side::BOTH {
        let p = m
            .arc(side)
            .point(1.0, m.arc(side).contact_angle_rad)
            .position_m;
        let ball = [
            p[0].hypot(p[1]) - d.ball_radius_m * cos,
            p[2] - d.ball_radius_m * sin,
        ];
        // Equal grooves: the ball is halfway between their centres, on the pitch circle.
        assert!(
            (ball[0] - case.bearing.pitch_radius_m()).abs() < 1e-8,
            "{ball:?}"
        );
        assert!(ball[1].abs() < 1e-8, "{ball:?}");
    }
    let [upper, lower] = Side::BOTH.map(|side| {
        let arc = m.arc(side);
        arc.point(1.0, arc.shoulder_rad()).position_m[2]
    });
    assert!(((upper + lower) / 2.0 - turned.groove_height_m).abs() < 1e-16);
    assert!(turned.groove_height_m < -40e-6);
    // Without its contact angle the same groove is in the middle.
    let radial = Bearing::new(d.clone(), steel()).unwrap();
    let middle = OuterRing::new(&radial, &[], SIZE).unwrap();
    assert!((turned.volume_m3() / middle.volume_m3() - 1.0).abs() < 1e-13);
}

#[test]
fn rings_that_cannot_be_are_refused() {
    let turned = |section| case(0.0, &[(5.1, 20.0, 9.0 * section)], section);
    let mut one = turned(10.0);
    one.raceways.extend(turned(0.0).raceways);
    let field = |result: Result<OuterRing, InputError>| result.unwrap_err().field;
    assert_eq!(
        field(OuterRing::of(&one, SIZE)),
        "raceway_contact_angle_rad"
    );
    let mut pair = with_row(case(15.0, &[], 0.0), 1.0);
    pair.rows.push(pair.rows[0]);
    assert_eq!(field(OuterRing::of(&pair, SIZE)), "axial_position_m");
    // The offset of the groove takes twice as much of the width.
    let fits = |case: &Case, outer_ring_width_m| {
        let size = OuterRingDimensions {
            outer_ring_width_m,
            ..SIZE
        };
        OuterRing::of(case, size).is_ok()
    };
    let [middle, offset] = [0.0, 15.0].map(|free| case(free, &[], 0.0));
    let edge = |case: &Case| {
        let arc = ring(case).meridian(0.0).arcs[1];
        2.0 * arc.height_m(arc.shoulder_rad())
    };
    let least = edge(&offset);
    assert!(least > edge(&middle) + 90e-6);
    assert!(fits(&offset, least + 1e-9) && !fits(&offset, least - 1e-9));
}
