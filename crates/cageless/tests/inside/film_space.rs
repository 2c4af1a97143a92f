//! The film in space: at rest, in the motion, moments, ledger.

use super::film_motion::{change, summary, with_oil};
use crate::common::*;
use cageless::case::Motion;
use cageless::dynamics::coordinates::BallCoordinate;
use cageless::dynamics::energy::EnergyTerm;
use cageless::film::{Film, FilmAtRest};
use cageless::prelude::*;
use cageless::{Gaps, Start, StartState, equilibrium, reference};

fn in_space(case: Case) -> Case {
    Case {
        motion: Motion::Space,
        ..case
    }
}

fn at_rest(case: &Case) -> FilmAtRest {
    FilmAtRest::new(case, &equilibrium::settle(case).unwrap()).unwrap()
}

fn pressed(axial_load_n: f64) -> Case {
    let mut case = with_oil(reference::conventional(), 5.0);
    case.operation.space.axial_load_n = axial_load_n;
    case
}

/// Without axial load the films at rest, the free arc and the lag are those of the plane; structure (d) rests on flanks
/// of its own in both.
#[test]
fn at_rest_as_in_the_plane() {
    for case in [reference::conventional(), reference::Structure::D.case()] {
        let mut case = with_oil(case, 5.0);
        case.film.as_mut().unwrap().hysteresis = true;
        let plane = at_rest(&case);
        let space = at_rest(&in_space(case));
        let torques_n_m = [&plane, &space].map(|film| film.hysteresis_torque_n_m.unwrap());
        for (a, b) in [
            (torques_n_m[0], torques_n_m[1]),
            (plane.power_w, space.power_w),
            (plane.free_arc_rad, space.free_arc_rad),
            (plane.lag_rad, space.lag_rad),
            (plane.thickness_mean_m, space.thickness_mean_m),
        ] {
            assert!((a / b - 1.0).abs() < 2e-3, "{a} {b}");
        }
    }
}

/// Balls under an axial load alone: each contact by the formula at its angle, α of both from the load
/// Fa = Z Qi sin αi, and the power of the motion.
#[test]
fn power_under_axial_load() {
    let mut case = pressed(4000.0);
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    let film = at_rest(&case);
    assert_eq!(film.free_arc_rad, 0.0);
    assert_eq!(film.speed_deficit, 0.0);
    let settled = equilibrium::settle(&case).unwrap();
    let (bearing, d) = (&case.bearing, case.bearing.dimensions());
    let [inner_rad, outer_rad] = [
        settled.inner_contact_angle_rad[0],
        settled.outer_contact_angle_rad[0],
    ];
    let inner_n = 4000.0 / (14.0 * inner_rad.sin());
    assert!((settled.rest.inner_force_n[0] / inner_n - 1.0).abs() < 1e-6);
    assert!(
        inner_rad > 0.2 && outer_rad < inner_rad,
        "{inner_rad} {outer_rad}"
    );
    // Rolling without sliding at the outer raceway, across its force.
    let (rw, speed) = (bearing.ball_radius_m(), case.operation.inner_speed_rad_s);
    let inner_m = d.inner_groove_bottom_radius_m
        + d.inner_groove_curvature_radius_m * (1.0 - inner_rad.cos());
    let spin = speed * inner_m / (rw + rw * (inner_rad - outer_rad).cos());
    let orbit_m = settled.rest.ball_distance_m[0];
    let orbit = spin * rw / orbit_m;
    // Mean of both surfaces in the frame that orbits with the ball.
    let outer_u = orbit * (orbit_m + rw * outer_rad.cos());
    let ball_u = spin * rw * (inner_rad - outer_rad).cos() + orbit * rw * inner_rad.cos();
    let inner_u = 0.5 * ((speed - orbit) * inner_m + ball_u);
    let films = [(film.inner[0], inner_u), (film.outer[0][0], outer_u)];
    for (contact, speed_m_s) in films {
        let relative = contact.speed_m_s / speed_m_s - 1.0;
        assert!(relative.abs() < 2e-3, "{} {speed_m_s}", contact.speed_m_s);
    }
    case.solver.duration_s = 10e-3;
    let power_w = summary(&case)
        .means
        .unwrap()
        .power_w(EnergyTerm::RollingResistance);
    assert!(
        (film.power_w / power_w - 1.0).abs() < 5e-3,
        "{} at rest, {power_w}",
        film.power_w
    );
}

/// Under a light axial load friction at the inner raceway is too weak for a thick film: at rest all balls are counted, in
/// the motion they fall behind; under a heavy load they roll.
#[test]
fn thick_oil_overcomes_lightly_loaded_balls() {
    for (axial_load_n, mpa_s, overcome) in [(60.0, 20.0, 14), (4000.0, 5.0, 0)] {
        let mut case = with_oil(reference::conventional(), mpa_s);
        case.operation.space.axial_load_n = axial_load_n;
        case.operation.radial_load_n = 0.0;
        case.operation.gravity_m_s2 = 0.0;
        assert_eq!(at_rest(&case).overcome_balls, overcome);
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.step_s = 2e-6;
        case.solver.duration_s = 0.04;
        case.solver.transient_s = Some(0.02);
        let lag_deg = summary(&case).half_turn_lag_rad.unwrap().to_degrees();
        match overcome {
            0 => assert!(lag_deg.abs() < 0.3, "{lag_deg}"),
            _ => assert!(lag_deg > 1.0, "{lag_deg}"),
        }
    }
}

/// The moments of the film about the axis of the bearing cancel under an axial load alone: balls, drive, outer ring.
#[test]
fn moments_close_in_space() {
    let mut case = reference::conventional();
    case.operation.space.axial_load_n = 4000.0;
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    let settled = equilibrium::settle(&case).unwrap();
    let (d, ball) = (case.bearing.dimensions(), case.bearing.ball(0));
    let (state, _) = cageless::initial_conditions::initial_state(&case).unwrap();
    let (layout, values) = (state.layout(), state.values());
    let rates = change(&case, 20.0, values);
    let [mut orbits_n_m, mut spins_n_m, mut across_n_m] = [0.0; 3];
    for k in 0..14 {
        let of = |values: &[f64], c| values[layout.ball(c, k)];
        let [x, y] = [BallCoordinate::X, BallCoordinate::Y].map(|c| of(values, c));
        let [ax, ay] = [BallCoordinate::Vx, BallCoordinate::Vy].map(|c| of(&rates, c));
        let turned = [BallCoordinate::OmegaX, BallCoordinate::OmegaY].map(|c| of(&rates, c));
        orbits_n_m += ball.mass_kg * (x * ay - y * ax);
        // Clockwise, as the rotation of a ball.
        spins_n_m -= ball.inertia_kg_m2 * of(&rates, BallCoordinate::Spin);
        across_n_m += ball.inertia_kg_m2 * turned[0].hypot(turned[1]);
    }
    let (inner_rad, outer_rad) = (
        settled.inner_contact_angle_rad[0],
        settled.outer_contact_angle_rad[0],
    );
    let inner_m = d.inner_groove_bottom_radius_m
        + d.inner_groove_curvature_radius_m * (1.0 - inner_rad.cos());
    let drive_w = rates[layout.energy_term(EnergyTerm::Drive)];
    let inner_n_m = drive_w / case.operation.inner_speed_rad_s;
    let (rw, inner_n) = (case.bearing.ball_radius_m(), inner_n_m / inner_m);
    let outer_n = (spins_n_m / rw - inner_n * inner_rad.cos()) / outer_rad.cos();
    let outer_n_m = outer_n * (settled.rest.ball_distance_m[0] + rw * outer_rad.cos());
    let sum = orbits_n_m + spins_n_m - inner_n_m + outer_n_m;
    assert!(inner_n > 1.0 && outer_n > 1.0, "{inner_n} {outer_n}");
    assert!(sum.abs() < 1e-6 * outer_n_m, "{sum:e} of {outer_n_m}");
    // The moments across the axis of both contacts, in the meridian plane of each ball.
    let expected_n_m = rw * (inner_n * inner_rad.sin() + outer_n * outer_rad.sin());
    assert!(
        (across_n_m / expected_n_m - 1.0).abs() < 1e-6,
        "{across_n_m} {expected_n_m}"
    );
}

/// At the edges of a slot the contact is longer along rolling than across, beyond the fit: R_x of the flank, R_y of the
/// edge. The power at rest, with ball 1 in the middle of the slot, is about that of the motion.
#[test]
fn film_at_the_edges_of_a_slot() {
    let mut case = with_oil(slotted(), 5.0);
    let (settled, film) = (equilibrium::settle(&case).unwrap(), at_rest(&case));
    let (bearing, slot) = (&case.bearing, case.raceways[0].slot().unwrap());
    let (rw, angle_rad) = (bearing.ball_radius_m(), settled.flank_angle_rad[0][0]);
    let contact_m = settled.rest.ball_distance_m[0] + rw * angle_rad.cos();
    let ring = [-angle_rad.cos() / contact_m, 1.0 / slot.edge_radius_m];
    let materials = [&bearing.materials().ball, &bearing.materials().ring];
    let contact = cageless::film::LubricatedContact::between([1.0 / rw; 2], ring, materials);
    assert!(contact.axis_ratio > 2.0, "{}", contact.axis_ratio);
    let rolling = cageless::film::Rolling {
        load_n: settled.flank_force_n[0][0],
        speed_m_s: film.outer[0][0].speed_m_s,
    };
    let force_n = case.film.unwrap().rolling_force_n(&contact, rolling);
    let relative = film.outer[0][0].force_n / force_n - 1.0;
    assert!(
        relative.abs() < 2e-3,
        "{} {force_n}",
        film.outer[0][0].force_n
    );
    assert_eq!(film.exceeded.unwrap().parameter, "κ");
    case.solver.duration_s = 10e-3;
    let means = summary(&case).means.unwrap();
    let power_w = means.power_w(EnergyTerm::RollingResistance);
    assert!(
        (film.power_w / power_w - 1.0).abs() < 0.15,
        "{} {power_w}",
        film.power_w
    );
}

/// Without supply and without a film the motion in space is the same but for the sign of zero.
#[test]
fn no_supply_is_no_film_in_space() {
    let wet = pressed(300.0);
    let end = |supply: Option<f64>| {
        let mut case = wet.clone();
        case.film = case.film.and_then(|film| {
            Some(Film {
                supply: supply?,
                ..film
            })
        });
        case.solver.duration_s = 1e-3;
        complete(&case).state.values().to_vec()
    };
    assert_eq!(end(None), end(Some(0.0)));
    assert_ne!(end(None), end(Some(0.1)));
}

/// The ledger closes at second order or better in thick oil under an axial load, at collisions and on flanks.
#[test]
fn ledger_closes_in_space() {
    let mut bunched = reference::conventional();
    let gaps = Gaps::random(&bunched.bearing, 0);
    bunched.start = Start::new(StartState::Settled, gaps, 0.0);
    for case in [bunched, reference::Structure::D.case()] {
        let mut case = with_oil(case, 20.0);
        case.operation.space.axial_load_n = 200.0;
        case.solver.method = IntegrationMethod::Abm4;
        case.solver.duration_s = 4e-3;
        let residuals = [2e-6, 1e-6, 0.5e-6].map(|step_s| {
            case.solver.step_s = step_s;
            complete(&case).energy_residual_relative.abs()
        });
        assert!(
            residuals.is_sorted_by(|coarse, fine| *fine < coarse / 3.5) && residuals[2] < 1e-6,
            "{residuals:?}"
        );
    }
}

/// The lag of the half orbit and the power in space are those of the plane.
#[test]
fn lag_and_power_in_space() {
    let mut case = with_oil(reference::conventional(), 5.0);
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 2e-6;
    case.solver.duration_s = 0.06;
    case.solver.transient_s = Some(0.04);
    let [plane, space] = [case.clone(), in_space(case)].map(|case| {
        let summary = summary(&case);
        let power_w = summary
            .means
            .unwrap()
            .power_w(EnergyTerm::RollingResistance);
        (summary.half_turn_lag_rad.unwrap().to_degrees(), power_w)
    });
    assert!((plane.0 - space.0).abs() < 0.02, "{plane:?} {space:?}");
    assert!(
        (plane.1 / space.1 - 1.0).abs() < 2e-3,
        "{plane:?} {space:?}"
    );
}
