//! Static equilibrium in space against the plane, closed forms, published values and symmetry.

use crate::common::{conventional, dimensions, raceway, steel, structure};
use cageless::closed_forms::{ContactAngleEstimate, kinematic_lag_rad};
use cageless::equilibrium::space::outer_section::{Flanks, OuterSection};
use cageless::equilibrium::space::{SpatialEquilibrium, solve};
use cageless::equilibrium::{self, EquilibriumError};
use cageless::numerics::taylor::Taylor;
use cageless::numerics::vector::SectionVector;
use cageless::{Bearing, BearingDimensions, Case, Gaps, Material, Row, Start, StartState, Tilt};

/// A bearing that hardly turns, without weight.
fn still(dimensions: BearingDimensions, material: Material) -> Case {
    let mut case = conventional(crate::common::dimensions());
    case.bearing = Bearing::new(dimensions, material).unwrap();
    case.operation.inner_speed_rad_s = 1e-3;
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    case
}

/// The 218 bearing of the literature.
fn bearing_218() -> BearingDimensions {
    BearingDimensions {
        balls: 16,
        ball_radius_m: 22.23e-3 / 2.0,
        inner_groove_bottom_radius_m: 102.79e-3 / 2.0,
        outer_groove_bottom_radius_m: 147.73e-3 / 2.0,
        outer_shoulder_radius_m: 147.73e-3 / 2.0 - 8e-3,
        inner_groove_curvature_radius_m: 11.63e-3,
        outer_groove_curvature_radius_m: 11.63e-3,
        ..dimensions()
    }
}

/// The bearing of which MASTA's results are quoted (ISO/TS 16281), with a radial clearance.
fn bearing_of_masta(clearance_m: f64) -> Case {
    let half = clearance_m / 4.0;
    let d = BearingDimensions {
        balls: 7,
        ball_radius_m: 5.75e-3,
        inner_groove_bottom_radius_m: 16e-3 - half,
        outer_groove_bottom_radius_m: 27.5e-3 + half,
        outer_shoulder_radius_m: 24.5e-3,
        inner_groove_curvature_radius_m: 0.52 * 11.5e-3,
        outer_groove_curvature_radius_m: 0.53 * 11.5e-3,
        ..dimensions()
    };
    let steel = Material {
        youngs_modulus_pa: 210e9,
        ..steel()
    };
    still(d, steel)
}

fn at_lead(mut case: Case, lead_ball_angle_rad: f64) -> Case {
    case.start = Start::new(StartState::Settled, Gaps::Uniform, lead_ball_angle_rad);
    case
}

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * (a.abs() + b.abs()), "{a} {b}");
}

/// Contact angles with what has none as 0.
fn angles(values: &[f64]) -> Vec<f64> {
    let known = |a: &f64| if a.is_nan() { 0.0 } else { *a };
    values.iter().map(known).collect()
}

#[test]
fn without_axial_load_and_tilt_a_conventional_ring_is_the_planar_one() {
    for (clearance, lead, load) in [(0.0, 0.0, 1500.0), (10e-6, 0.1, 300.0), (-4e-6, 0.2, 0.0)] {
        let mut d = dimensions();
        d.outer_groove_bottom_radius_m += clearance;
        let mut case = at_lead(conventional(d), lead);
        case.operation.radial_load_n = load;
        let (plane, space) = (equilibrium::solve(&case).unwrap(), solve(&case).unwrap());
        close(plane.ring_x_m + 1e-3, space.rest.ring_x_m + 1e-3, 1e-12);
        close(plane.ring_y_m, space.rest.ring_y_m, 1e-9);
        assert!(space.ring_z_m.abs() < 1e-15);
        for k in 0..14 {
            let loads = [
                (plane.inner_force_n[k], space.rest.inner_force_n[k]),
                (plane.outer_force_n[k], space.rest.outer_force_n[k]),
            ];
            for (a, b) in loads {
                assert!((a - b).abs() < 1e-9 * 1500.0, "{k}: {a} {b}");
            }
            close(
                plane.outer_contact[k].pressure_pa,
                space.rest.outer_contact[k].pressure_pa,
                1e-8,
            );
        }
        let (a, b) = (
            plane.stiffness_n_m.unwrap(),
            space.rest.stiffness_n_m.unwrap(),
        );
        close(a[1][1], b[1][1], 1e-7);
        close(a[0][0], b[0][0], 1e-7);
    }
}

/// Harris' 218 bearing: F = Z Kn [A (cos αf/cos α − 1)]^(3/2) sin α, z = A sin(α − αf)/cos α.
#[test]
fn the_218_bearing_under_axial_load_has_the_known_values() {
    let mut case = still(bearing_218(), steel());
    let free = case.bearing.dimensions();
    let room = 2.0 * free.inner_groove_curvature_radius_m - 2.0 * free.ball_radius_m;
    let angle = (1.0_f64 - 0.24e-3 / room).acos();
    case.bearing = case.bearing.with_contact_angle(angle, 0.0).unwrap();
    case.operation.space.axial_load_n = 17_800.0;
    let space = solve(&case).unwrap();
    let contact = space.inner_contact_angle_rad[0];
    assert!((contact.to_degrees() - 41.4249).abs() < 5e-5);
    assert!((space.outer_contact_angle_rad[3] - contact).abs() < 1e-9);
    assert!((space.ring_z_m * 1e3 - 0.03618).abs() < 5e-6);
    assert!((space.rest.inner_force_n[7] - 1681.43).abs() < 5e-3);
    let [ki, ko, _] = case.stiffness_n_m1_5();
    let series = (ki.powf(-2.0 / 3.0) + ko.powf(-2.0 / 3.0)).powf(-1.5);
    let closed =
        16.0 * series * (room * (angle.cos() / contact.cos() - 1.0)).powf(1.5) * contact.sin();
    close(closed, 17_800.0, 1e-9);
    close(
        space.ring_z_m,
        room * (contact - angle).sin() / contact.cos(),
        1e-9,
    );
}

/// Results of MASTA (SMT) that minzhun/ISO16281, `Test_BallBearing.py`, quotes.
#[test]
fn displacements_of_masta_come_out() {
    for (clearance, radial, axial, um) in [
        (0.0, 1000.0, 0.0, 15.1101),
        (0.0, 0.0, 1000.0, 133.5381),
        (10e-6, 1000.0, 0.0, 21.223),
    ] {
        let mut case = bearing_of_masta(clearance);
        case.operation.radial_load_n = radial;
        case.operation.space.axial_load_n = axial;
        let space = solve(&case).unwrap();
        let found = if axial > 0.0 {
            space.ring_z_m
        } else {
            -space.rest.ring_y_m
        };
        close(found * 1e6, um, 5e-4);
    }
}

/// Radial and axial load and a tilt on structure (d).
fn loaded() -> Case {
    let mut case = at_lead(structure(5.1, 25.2), 0.07);
    case.operation.space.axial_load_n = 400.0;
    case.operation.space.tilt = Tilt::Held {
        x_rad: 0.8e-3,
        y_rad: -0.5e-3,
    };
    case
}

#[test]
fn the_other_way_along_the_axis_all_is_mirrored() {
    let (one, mut mirrored) = (loaded(), loaded());
    mirrored.operation.space.axial_load_n = -400.0;
    mirrored.operation.space.tilt = Tilt::Held {
        x_rad: -0.8e-3,
        y_rad: 0.5e-3,
    };
    let (a, b) = (solve(&one).unwrap(), solve(&mirrored).unwrap());
    close(a.ring_z_m, -b.ring_z_m, 1e-10);
    close(a.rest.ring_y_m, b.rest.ring_y_m, 1e-10);
    for k in 0..14 {
        close(
            a.rest.inner_force_n[k] + 1.0,
            b.rest.inner_force_n[k] + 1.0,
            1e-9,
        );
        let angle = |e: &SpatialEquilibrium| angles(&e.inner_contact_angle_rad)[k];
        assert!((angle(&a) + angle(&b)).abs() < 1e-9);
        let [plus, minus] = a.flank_force_n[k];
        if minus > 0.0 {
            close(plus + 1.0, b.flank_force_n[k][1] + 1.0, 1e-8);
        }
    }
}

#[test]
fn turned_about_the_axis_all_turns() {
    // The load stands: the balls and the raceway turn by one pitch, which is nothing for the balls.
    let pitch = std::f64::consts::TAU / 14.0;
    let mut case = conventional(dimensions());
    case.operation.space.axial_load_n = 700.0;
    case.operation.gravity_m_s2 = 0.0;
    let (a, b) = (
        solve(&case).unwrap(),
        solve(&at_lead(case.clone(), 3.0 * pitch)).unwrap(),
    );
    close(a.rest.ring_y_m, b.rest.ring_y_m, 1e-10);
    close(a.ring_z_m, b.ring_z_m, 1e-10);
    for k in 0..14 {
        close(
            a.rest.inner_force_n[(k + 3) % 14] + 1.0,
            b.rest.inner_force_n[k] + 1.0,
            1e-9,
        );
    }
    // A tilt turned by three pitches under a purely axial load turns the loads of the balls.
    case.operation.radial_load_n = 0.0;
    let turned = |by: f64| {
        let mut case = case.clone();
        let (sin, cos) = by.sin_cos();
        let (x, y) = (0.4e-3, 0.9e-3);
        case.operation.space.tilt = Tilt::Held {
            x_rad: x * cos - y * sin,
            y_rad: x * sin + y * cos,
        };
        solve(&case).unwrap()
    };
    let (a, b) = (turned(0.0), turned(3.0 * pitch));
    close(a.ring_z_m, b.ring_z_m, 1e-10);
    for k in 0..14 {
        close(
            a.rest.inner_force_n[k],
            b.rest.inner_force_n[(k + 3) % 14],
            1e-8,
        );
    }
    let spread = a.rest.inner_force_n[0] / a.rest.inner_force_n[7];
    assert!(
        (spread - 1.0).abs() > 0.01,
        "the tilt must matter: {spread}"
    );
}

/// Derivatives of the solution by differences of whole solutions, rows of the stiffness matrix.
#[test]
fn the_stiffness_is_the_derivative_of_the_loads_over_the_displacements() {
    let mut case = conventional(dimensions());
    // Centrifugal forces, which follow the contact angles, are no part of it.
    case.operation.inner_speed_rad_s = 1.0;
    case.operation.space.axial_load_n = 400.0;
    let free = |case: &Case, [fy, fz, mx, my]: [f64; 4]| {
        let mut case = case.clone();
        case.operation.radial_load_n += fy;
        case.operation.space.axial_load_n += fz;
        case.operation.space.tilt = Tilt::Free {
            moment_x_n_m: 1.0 + mx,
            moment_y_n_m: 0.4 + my,
        };
        let e = solve(&case).unwrap();
        let place = [
            e.rest.ring_x_m,
            e.rest.ring_y_m,
            e.ring_z_m,
            e.tilt_x_rad,
            e.tilt_y_rad,
        ];
        (place, e.stiffness.unwrap())
    };
    let (_, stiffness) = free(&case, [0.0; 4]);
    for i in 0..5 {
        for j in 0..5 {
            close(stiffness[i][j] + 1.0, stiffness[j][i] + 1.0, 1e-6);
        }
    }
    let by = [0.1, 0.1, 1e-3, 1e-3];
    for (load, row, sign) in [(0, 1, -1.0), (1, 2, 1.0), (2, 3, 1.0), (3, 4, 1.0)] {
        let moved = |way: f64| {
            let mut loads = [0.0; 4];
            loads[load] = way * by[load];
            free(&case, loads).0
        };
        let (up, down) = (moved(1.0), moved(-1.0));
        // K dx = dF: what the other rows give must be 0.
        for i in 0..5 {
            let of = |k: usize| (up[k] - down[k]) / (2.0 * by[load]);
            let force: f64 = (0..5).map(|j| stiffness[i][j] * of(j)).sum();
            let expected = if i == row { sign } else { 0.0 };
            let scale: f64 = (0..5).map(|j| (stiffness[i][j] * of(j)).abs()).sum();
            assert!(
                (force - expected).abs() < 1e-5 * scale.max(1.0),
                "{load} {i}: {force}"
            );
        }
    }
}

fn angular_contact(angle_deg: f64) -> Case {
    let mut case = still(dimensions(), steel());
    case.operation.inner_speed_rad_s = 100.0;
    case.bearing = case
        .bearing
        .with_contact_angle(angle_deg.to_radians(), 0.0)
        .unwrap();
    case
}

fn pair(case: &Case, sign: f64, preload_m: f64) -> Case {
    let row = |axial_position_m: f64, contact_sign: f64| Row {
        axial_position_m,
        contact_sign,
        preload_m,
        ..Row::default()
    };
    Case {
        rows: vec![row(-10e-3, sign), row(10e-3, -sign)],
        ..case.clone()
    }
}

#[test]
fn two_equal_rows_under_a_load_in_the_middle_are_mirror_images() {
    let mut case = angular_contact(15.0);
    case.operation.radial_load_n = 1500.0;
    let mut stiffness = vec![];
    for sign in [1.0, -1.0] {
        let mut case = pair(&case, sign, 15e-6);
        case.operation.space.tilt = Tilt::Free {
            moment_x_n_m: 0.0,
            moment_y_n_m: 0.0,
        };
        let e = solve(&case).unwrap();
        assert!(
            e.ring_z_m.abs() < 1e-12 && e.tilt_x_rad.abs() < 1e-10 && e.tilt_y_rad.abs() < 1e-10
        );
        for k in 0..14 {
            close(e.rest.inner_force_n[k], e.rest.inner_force_n[k + 14], 1e-8);
            let [one, other] = [k, k + 14].map(|k| e.inner_contact_angle_rad[k]);
            assert!((one + other).abs() < 1e-8 && one * sign > 0.0);
        }
        stiffness.push(e.stiffness.unwrap()[3][3]);
    }
    // Pressure lines that meet the axis outside hold moments better.
    assert!(stiffness[0] > 1.5 * stiffness[1], "{stiffness:?}");
}

/// Rows of one sign share an axial load; each is the single row under half of it.
#[test]
fn tandem_rows_share_the_load() {
    let mut case = angular_contact(25.0);
    case.operation.space.axial_load_n = 1000.0;
    let single = solve(&case).unwrap();
    let row = |axial_position_m: f64| Row {
        axial_position_m,
        ..Row::default()
    };
    case.rows = vec![row(-8e-3), row(8e-3)];
    case.operation.space.axial_load_n = 2000.0;
    let tandem = solve(&case).unwrap();
    close(single.ring_z_m, tandem.ring_z_m, 1e-9);
    close(
        single.rest.inner_force_n[3],
        tandem.rest.inner_force_n[20],
        1e-9,
    );
}

/// Preloaded by u, two rows press each other as an axial displacement u presses one.
#[test]
fn preload_by_displacement_is_an_axial_displacement_of_each_row() {
    let case = angular_contact(15.0);
    let preloaded = solve(&pair(&case, 1.0, 12e-6)).unwrap();
    let axial: f64 = (0..14)
        .map(|k| preloaded.rest.inner_force_n[k] * preloaded.inner_contact_angle_rad[k].sin())
        .sum();
    let mut single = case;
    single.operation.space.axial_load_n = axial;
    let e = solve(&single).unwrap();
    close(e.ring_z_m, 12e-6, 1e-6);
}

#[test]
fn a_turned_section_without_flanks_is_the_plain_raceway() {
    let section = |flanks| OuterSection {
        gap_m: 0.19e-3,
        axial_m: 12e-6,
        flanks,
    };
    let flat = section(Some(Flanks {
        angle_rad: 0.0,
        section_angle_rad: 0.3,
        nominal_gap_m: 0.19e-3,
        depth_error_m: 0.0,
        depth_m: 0.0,
        slot: None,
    }));
    let nearly = section(Some(Flanks {
        angle_rad: 2e-5,
        section_angle_rad: 0.3,
        nominal_gap_m: 0.19e-3,
        depth_error_m: 0.0,
        depth_m: 0.0,
        slot: None,
    }));
    let plain = section(None);
    for [radial, axial] in [[3e-6, 5e-6], [1e-6, 60e-6], [8e-6, -20e-6]] {
        let at = SectionVector { radial, axial }.map(Taylor::<0>::constant);
        let of = |s: &OuterSection| {
            let flank = Taylor::constant(s.flanks.map_or(0.0, |f| f.angle_rad));
            s.approach(at, flank).unwrap().value
        };
        assert_eq!(of(&flat), of(&plain));
        assert!((of(&nearly) - of(&plain)).abs() < 1e-8);
    }
}

#[test]
fn joined_flanks_are_one_plain_contact_or_two_that_share_it() {
    let angle = 32.4_f64.to_radians();
    let g = 0.1905e-3;
    for turned in [0.0, 0.35] {
        let section = OuterSection {
            gap_m: g,
            axial_m: 0.0,
            flanks: Some(Flanks {
                angle_rad: angle,
                section_angle_rad: turned,
                nominal_gap_m: g,
                depth_error_m: 0.0,
                depth_m: 0.0,
                slot: None,
            }),
        };
        let (sin_t, cos_t) = turned.sin_cos();
        // From where the nominal ball rests, along the middle of the section and across it.
        let place = |along: f64, across: f64| SectionVector {
            radial: g * cos_t - g + along * cos_t - across * sin_t,
            axial: g * sin_t + along * sin_t + across * cos_t,
        };
        let approach = |p: SectionVector| {
            let flank = Taylor::<0>::constant(angle);
            section
                .approach(p.map(Taylor::constant), flank)
                .map_or(0.0, |d| d.value)
        };
        // Both alike: δe = δ/cos αc of each, N = F/(2 cos αc).
        let both = section.contacts(place(6e-6, 0.0));
        let deep = |c: f64, s: f64| (6e-6 + g * c).hypot(g * s) - g;
        let (sin, cos) = angle.sin_cos();
        close(approach(place(6e-6, 0.0)), deep(cos, sin) / cos, 1e-9);
        assert_eq!(both.len(), 2);
        for contact in &both {
            close(contact.share, 1.0 / (2.0 * cos), 1e-9);
        }
        // One flank: the plain law.
        let (along, across) = (4e-6, 30e-6);
        let only = section.contacts(place(along, across));
        assert_eq!(only.len(), 1);
        close(only[0].share, 1.0, 1e-14);
        let plain = (along + g * cos).hypot(across + g * sin) - g;
        close(approach(place(along, across)), plain, 1e-9);
    }
}

/// Along the radius, the axis and ψ, on both flanks unequally.
#[test]
fn the_gradient_of_the_joined_flanks_is_that_of_differences() {
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    let raceway = raceway(&bearing, 5.1, 25.2, 0.0);
    let g = dimensions().outer_groove_curvature_radius_m - dimensions().ball_radius_m;
    let approach = |[u, zeta, psi]: [f64; 3]| {
        let [angle, slope] = raceway.contact_angle_rad(psi);
        let section = OuterSection {
            gap_m: g,
            axial_m: 0.0,
            flanks: Some(Flanks {
                angle_rad: angle,
                section_angle_rad: 0.1,
                nominal_gap_m: g,
                depth_error_m: 0.0,
                depth_m: 0.0,
                slot: None,
            }),
        };
        let [u, zeta, psi] = Taylor::<3>::variables([u, zeta, psi]);
        section
            .approach(
                SectionVector {
                    radial: u,
                    axial: zeta,
                },
                psi.map([angle, slope, 0.0]),
            )
            .unwrap()
    };
    for at in [[8e-6, 3e-6, 0.1], [9e-6, 20e-6, 0.25], [7e-6, 21e-6, -0.3]] {
        let exact = approach(at);
        for (k, step) in [(0, 1e-9), (1, 1e-9), (2, 1e-6)] {
            let moved = |by: f64| {
                let mut place = at;
                place[k] += by;
                approach(place).value
            };
            let slope = (moved(step) - moved(-step)) / (2.0 * step);
            let scale = [1.0, 1.0, g][k];
            assert!(
                (slope - exact.gradient[k]).abs() < 1e-6 * scale,
                "{k}: {slope} {exact:?}"
            );
        }
    }
}

/// Force and moment of all balls on the ring, put together again from the result.
#[test]
fn ring_and_balls_are_in_balance() {
    let mut case = loaded();
    case.operation.space.tilt = Tilt::Free {
        moment_x_n_m: -2.0,
        moment_y_n_m: 1.5,
    };
    let e = solve(&case).unwrap();
    let down = case.operation.radial_load_n + 0.2 * 9.81;
    let axis = [e.tilt_y_rad, -e.tilt_x_rad];
    let axis = [
        axis[0],
        axis[1],
        (1.0 - axis[0].powi(2) - axis[1].powi(2)).sqrt(),
    ];
    let (mut force, mut moment) = ([0.0, -down, 400.0], [-2.0, 1.5, 0.0]);
    for k in 0..14 {
        let (load, angle) = (e.rest.inner_force_n[k], e.inner_contact_angle_rad[k]);
        if load == 0.0 {
            continue;
        }
        let (sin, cos) = e.rest.ball_angle_rad[k].sin_cos();
        let outer = e.rest.outer_force_n[k];
        // Along the axis a ball is held by its contacts alone.
        let [out, inn] = [
            outer * e.outer_contact_angle_rad[k].sin(),
            load * angle.sin(),
        ];
        assert!((out - inn).abs() < 1e-2 * load, "{k}: {out} {inn}");
        let d = case.bearing.dimensions();
        let reach = d.inner_groove_bottom_radius_m
            + d.inner_groove_curvature_radius_m * (1.0 - angle.cos());
        // Unit vector from the axis of the ring to the ball.
        let radial = [sin, -cos, 0.0];
        let dot: f64 = (0..3).map(|i| radial[i] * axis[i]).sum();
        let across: Vec<f64> = (0..3).map(|i| radial[i] - dot * axis[i]).collect();
        let length = across.iter().map(|c| c * c).sum::<f64>().sqrt();
        let unit = |i: usize| across[i] / length;
        let push: [f64; 3] =
            std::array::from_fn(|i| load * (-angle.cos() * unit(i) - angle.sin() * axis[i]));
        let arm: [f64; 3] = std::array::from_fn(|i| {
            reach * unit(i) - d.inner_groove_curvature_radius_m * angle.sin() * axis[i]
        });
        for i in 0..3 {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            force[i] += push[i];
            moment[i] += arm[j] * push[l] - arm[l] * push[j];
        }
    }
    // The angle of the ball about the ring's axis differs from ψ by the eccentricity.
    for i in 0..3 {
        assert!(force[i].abs() < 1.0, "{force:?}");
    }
    assert!(
        moment[0].abs() < 0.05 && moment[1].abs() < 0.05,
        "{moment:?}"
    );
}

/// A thrust that the usual shoulders of the inner ring bear is too much for lower ones; the rings meet between
/// shoulders.
#[test]
fn the_shoulders_of_the_inner_ring_are_as_high_as_given() {
    let with = |inner_shoulder_radius_m: Option<f64>| {
        let mut case = conventional(BearingDimensions {
            outer_shoulder_radius_m: 25e-3,
            inner_shoulder_radius_m,
            ..dimensions()
        });
        case.operation.space.axial_load_n = 40_000.0;
        case
    };
    let lower = solve(&with(Some(18.74e-3))).unwrap_err().to_string();
    assert!(lower.contains("shoulder of the inner ring"), "{lower}");
    assert!(solve(&with(None)).is_ok());
    let higher = with(Some(21.24e-3));
    let [inner, _] = higher.bearing.shoulder_angles_rad();
    close(inner.cos(), 1.0 - 3.0 / 4.953, 1e-12);
    close(
        higher.bearing.shoulder_clearance_m(),
        25e-3 - 21.24e-3,
        1e-12,
    );
    for (radius_m, allowed) in [(18e-3, "0.0182"), (23.1e-3, "0.0230")] {
        let d = BearingDimensions {
            inner_shoulder_radius_m: Some(radius_m),
            ..dimensions()
        };
        let error = Bearing::new(d, steel()).unwrap_err();
        assert_eq!(error.field, "inner_shoulder_radius_m");
        assert!(error.to_string().contains(allowed), "{error}");
    }
}

#[test]
fn what_cannot_be_is_named() {
    let mut case = conventional(dimensions());
    case.bearing = Bearing::new(
        BearingDimensions {
            outer_shoulder_radius_m: 27.3e-3,
            ..dimensions()
        },
        steel(),
    )
    .unwrap();
    case.operation.space.axial_load_n = 20_000.0;
    assert!(matches!(
        solve(&case),
        Err(EquilibriumError::BeyondGroove { .. })
    ));
    case.operation.space.axial_load_n = f64::NAN;
    let field = |case: &Case| match solve(case) {
        Err(EquilibriumError::Input(error)) => error.field,
        other => panic!("{other:?}"),
    };
    assert_eq!(field(&case), "axial_load_n");
    let mut tilted = conventional(BearingDimensions {
        outer_groove_bottom_radius_m: dimensions().outer_groove_bottom_radius_m + 20e-6,
        ..dimensions()
    });
    tilted.operation.radial_load_n = 0.0;
    tilted.operation.gravity_m_s2 = 0.0;
    tilted.operation.space.tilt = Tilt::Held {
        x_rad: 1e-4,
        y_rad: 0.0,
    };
    assert_eq!(field(&tilted), "tilt_x_rad");
    let most = angular_contact(15.0).bearing.axial_preload_max_m();
    assert_eq!(
        field(&pair(&angular_contact(15.0), 1.0, 1.01 * most)),
        "preload_m"
    );
    let mut empty = pair(&angular_contact(15.0), 1.0, 0.0);
    empty.rows[1].balls = Some(0);
    assert_eq!(field(&empty), "row_balls");
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    let error = bearing
        .clone()
        .with_contact_angle(60_f64.to_radians(), 0.0)
        .unwrap_err();
    assert_eq!(error.field, "contact_angle_rad");
    let raceway = raceway(&bearing, 5.1, 25.2, 0.0);
    let error = raceway
        .with_section_angle(25_f64.to_radians(), &bearing)
        .unwrap_err();
    assert_eq!(error.field, "raceway_contact_angle_rad");
    // What is planar says who computes the rest.
    let error = equilibrium::solve(&loaded()).unwrap_err().to_string();
    assert!(
        error.contains("axial_load_n") && error.contains("cageless static"),
        "{error}"
    );
}

/// Lags of structure (d) over the plain contact angle, rigid, and under a load that presses the ball
/// in by 5 µm; the contact angles that leave a part of them for four structures. Computed with an
/// independent program.
#[test]
fn a_contact_angle_takes_the_effect_of_a_raceway_as_worked_out_before() {
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    let lag = |angle: f64, pressed_in: f64| {
        let raceway = raceway(&bearing, 5.1, 25.2, 30.0);
        kinematic_lag_rad(&bearing, &raceway, angle.to_radians(), pressed_in).to_degrees()
    };
    let angles = [0.0, 2.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 14.0, 18.0];
    let rigid = [
        2.314, 2.226, 1.980, 1.807, 1.606, 1.141, 0.622, 0.092, -0.400, -0.908,
    ];
    let loaded = [
        2.189, 2.102, 1.857, 1.686, 1.487, 1.027, 0.516, -0.001, -0.474, -0.908,
    ];
    for (k, angle) in angles.into_iter().enumerate() {
        assert!((lag(angle, 0.0) - rigid[k]).abs() < 5.1e-4, "{angle}");
        // Where a flank lets go under load is worth a digit.
        assert!((lag(angle, 5e-6) - loaded[k]).abs() < 1.1e-3, "{angle}");
    }
    for (span, half, lag_deg, left) in [
        (4.95, 35.0, 2.83, [5.1, 7.6, 11.8]),
        (5.10, 25.2, 2.31, [5.4, 7.9, 12.4]),
        (5.40, 18.167, 1.97, [5.8, 8.5, 13.3]),
        (6.00, 12.717, 1.85, [6.6, 9.8, 15.3]),
    ] {
        let raceway = raceway(&bearing, span, half, 0.0);
        let e = ContactAngleEstimate::new(&bearing, &raceway, 0.0);
        assert!((e.lag_rad.to_degrees() - lag_deg).abs() < 5.1e-3, "{span}");
        let delay = cageless::kinematics::raceway_delay_rad(&bearing, &[raceway]);
        close(e.lag_rad, delay, 1e-6);
        for (found, known) in [e.three_quarters_rad, e.half_rad, e.none_rad]
            .iter()
            .zip(left)
        {
            let found = found.unwrap().to_degrees();
            assert!((found - known).abs() < 0.0501, "{span}: {found} {known}");
        }
    }
}

/// The estimates of a turned section are contact angles, not angles from its direction: at them the lag is
/// the share of that at its direction.
#[test]
fn estimates_of_a_turned_section_are_contact_angles() {
    let bearing = angular_contact(15.0).bearing;
    let turned = 0.2;
    let raceway = raceway(&bearing, 5.1, 25.2, 0.0);
    let raceway = raceway.with_section_angle(turned, &bearing).unwrap();
    let lag = |angle: f64| kinematic_lag_rad(&bearing, &raceway, angle, 3e-6);
    let e = ContactAngleEstimate::new(&bearing, &raceway, 3e-6);
    close(e.lag_rad, lag(turned), 1e-12);
    for (angle, share) in [
        (e.three_quarters_rad, 0.75),
        (e.half_rad, 0.5),
        (e.none_rad, 0.0),
    ] {
        let angle = angle.unwrap();
        assert!(angle > turned, "{angle}");
        assert!(
            (lag(angle) / lag(turned) - share).abs() < 1e-6,
            "{angle} {share}"
        );
    }
}

/// A pair whose second row a spring presses.
fn sprung_pair(case: &Case, force_n: f64) -> Case {
    let mut case = pair(case, 1.0, 0.0);
    case.rows[1].preload_n = force_n;
    case
}

/// A spring displaces the outer ring as far as a displacement that presses with its force.
#[test]
fn preload_by_a_spring_is_the_displacement_of_the_same_force() {
    let case = angular_contact(15.0);
    let sprung = solve(&sprung_pair(&case, 400.0)).unwrap();
    close(sprung.row_axial_force_n[0], 400.0, 1e-9);
    close(sprung.row_axial_force_n[1], -400.0, 1e-9);
    let mut displaced = pair(&case, 1.0, 0.0);
    displaced.rows[1].preload_m = sprung.row_preload_m[1];
    let same = solve(&displaced).unwrap();
    assert!(sprung.row_preload_m[1] > 1e-6 && sprung.row_preload_m[0] == 0.0);
    close(same.row_axial_force_n[0], 400.0, 1e-9);
    for k in 0..28 {
        close(
            sprung.rest.inner_force_n[k],
            same.rest.inner_force_n[k],
            1e-8,
        );
        close(sprung.ball_z_m[k], same.ball_z_m[k], 1e-9);
    }
    // F = Z Q sin α of one row (Harris, Rolling Bearing Analysis).
    let of_row: f64 = (14..28)
        .map(|k| sprung.rest.inner_force_n[k] * sprung.inner_contact_angle_rad[k].sin())
        .sum();
    close(of_row, -400.0, 1e-6);
}

/// The held row takes all of an axial load, and the ring is as stiff as on that row alone; across the
/// axis both rows carry it.
#[test]
fn a_spring_bears_its_force_whatever_the_load() {
    let mut case = sprung_pair(&angular_contact(15.0), 400.0);
    case.operation.radial_load_n = 300.0;
    case.operation.space.axial_load_n = 250.0;
    let at = |radial_n: f64, axial_n: f64| {
        let mut case = case.clone();
        case.operation.radial_load_n = radial_n;
        case.operation.space.axial_load_n = axial_n;
        solve(&case).unwrap()
    };
    let e = at(300.0, 250.0);
    close(e.row_axial_force_n[1], -400.0, 1e-9);
    close(e.row_axial_force_n[0], 650.0, 1e-9);
    let stiffness = e.stiffness.unwrap();
    // Displacements of loads are those of the stiffness.
    let step = 0.02;
    let [more, less] = [at(300.0, 250.0 + step), at(300.0, 250.0 - step)];
    let moved = [
        more.rest.ring_y_m - less.rest.ring_y_m,
        more.ring_z_m - less.ring_z_m,
    ];
    let push = |row: usize| stiffness[row][1] * moved[0] + stiffness[row][2] * moved[1];
    close(push(2), 2.0 * step, 1e-5);
    assert!(push(1).abs() < 1e-5 * step, "{}", push(1));
    let mut alone = angular_contact(15.0);
    alone.operation.space.axial_load_n = 400.0;
    let sprung = solve(&sprung_pair(&angular_contact(15.0), 400.0)).unwrap();
    let alone = solve(&alone).unwrap().stiffness.unwrap();
    let both = sprung.stiffness.unwrap();
    close(both[2][2], alone[2][2], 1e-6);
    close(both[1][1], 2.0 * alone[1][1], 1e-6);
}

#[test]
fn impossible_springs_are_named() {
    let error = |case: &Case| match solve(case) {
        Err(EquilibriumError::Input(error)) => error.to_string(),
        other => panic!("{other:?}"),
    };
    let good = sprung_pair(&angular_contact(15.0), 400.0);
    let mut all = good.clone();
    all.rows[0].preload_n = 400.0;
    assert!(error(&all).contains("one row at least"), "{}", error(&all));
    let mut twice = good.clone();
    twice.rows[1].preload_m = 1e-6;
    assert!(error(&twice).contains("displaced already"));
    let mut heavy = good.clone();
    heavy.rows[1].preload_n = 1e6;
    assert!(error(&heavy).contains("4200 MPa"));
    assert!(good.check_motion().is_ok());
}
