//! The film in the motion: coasting, momentum, ledger, lag and power.

use crate::common::*;
use crate::film::oil;
use cageless::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use cageless::dynamics::energy::EnergyTerm;
use cageless::dynamics::{Model, RightHandSide};
use cageless::film::{Film, FilmAtRest};
use cageless::integrator::System;
use cageless::prelude::*;
use cageless::summary::Summary;
use cageless::{equilibrium, reference};

fn with_oil(mut case: Case, mpa_s: f64) -> Case {
    case.film = Some(Film::flooded(oil(mpa_s)));
    case
}

/// Structure (d) at rest in 5 mPa·s, flooded: torque and power, both flanks of ball 1, and what a free ball loses.
#[test]
fn films_at_rest() {
    for (mpa_s, torque_n_m) in [(2.0, 24.003e-3), (5.0, 47.476e-3), (20.0, 122.855e-3)] {
        let case = with_oil(reference::Structure::D.case(), mpa_s);
        let rest = equilibrium::solve(&case).unwrap();
        let film = FilmAtRest::new(&case, &rest).unwrap();
        // The flanks of ball 1 have ellipses of their own, which the numbers do not know.
        let relative = film.torque_n_m / torque_n_m - 1.0;
        assert!(relative.abs() < 3e-4, "{mpa_s}: {}", film.torque_n_m);
        let power_w = film.torque_n_m * case.operation.inner_speed_rad_s;
        assert!((film.power_w / power_w - 1.0).abs() < 1e-12);
        if mpa_s == 5.0 {
            let [inner, outer] = [film.inner[0], film.outer[0]];
            assert!((inner.force_n - 0.138877).abs() < 2e-6, "{}", inner.force_n);
            // The ellipse of the flank, not that of the plain groove.
            assert!(
                (outer.force_n / 0.116043 - 1.0).abs() < 4e-3,
                "{}",
                outer.force_n
            );
            assert_eq!([inner.contacts, outer.contacts], [1.0, 2.0]);
            assert!(!film.may_queue());
            assert!(
                (film.free_share - 0.071).abs() < 1e-3,
                "{}",
                film.free_share
            );
        }
    }
}

/// Without supply and without a film the motion is the same but for the sign of zero.
#[test]
fn no_supply_is_no_film() {
    let dry = reference::Structure::D.case();
    let mut case = with_oil(dry.clone(), 5.0);
    case.film.as_mut().unwrap().supply = 0.0;
    for method in [IntegrationMethod::VelocityVerlet, IntegrationMethod::Abm4] {
        let end = |case: &Case| {
            let mut case = case.clone();
            case.solver.method = method;
            case.solver.duration_s = 2e-3;
            complete(&case).state.values().to_vec()
        };
        assert_eq!(end(&dry), end(&case));
    }
}

fn summary(case: &Case) -> Summary {
    let mut recorder = SummaryRecorder::new();
    cageless::simulation::run(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    recorder.summary().unwrap()
}

/// Long enough for the transient of a film, with the step of the prototype.
fn steady(mut case: Case) -> Case {
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 2e-6;
    case.solver.duration_s = 0.12;
    case.solver.transient_s = Some(0.06);
    case
}

/// Lag of the film and its power on the plain ring, at 12 000 rpm.
#[test]
fn lag_and_power_of_a_run() {
    for (mpa_s, lag_deg, power_w) in [
        (2.0, 0.924, 28.76),
        (5.0, 1.952, 56.60),
        (20.0, 5.512, 143.5),
    ] {
        let case = steady(with_oil(reference::conventional(), mpa_s));
        let summary = summary(&case);
        let lag = summary.half_turn_lag_rad.unwrap().to_degrees() - 0.176;
        let power = summary
            .means
            .unwrap()
            .power_w(EnergyTerm::RollingResistance);

        assert!((lag - lag_deg).abs() < 0.01, "{lag}, expected {lag_deg}");
        assert!(
            (power / power_w - 1.0).abs() < 2e-3,
            "{power}, expected {power_w}"
        );
    }
}

/// The ledger closes with the order of the method, oil, collisions and all.
#[test]
fn ledger_closes() {
    let residual = |film: bool, step_s: f64| {
        let mut case = reference::Structure::D.case();
        if film {
            case = with_oil(case, 20.0);
        }
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.step_s = step_s;
        case.solver.duration_s = 5e-3;
        let mut simulation = Simulation::new(&case).unwrap();
        simulation.advance_to(5e-3).unwrap();
        simulation.outcome().energy_residual_relative.abs()
    };
    let all = [false, true].map(|film| [1e-6, 0.5e-6].map(|step| residual(film, step)));

    assert!(
        all[1][0] < 2.0 * all[0][0].max(1e-6) && all[1][1] < 2.0 * all[0][1].max(1e-6),
        "{all:?}"
    );
}

/// A ball on the plain outer raceway after 10 ms from 11 m/s under its centrifugal force: a run without inner contact
/// and weight gives what the equation of the rolling ball gives.
#[test]
fn coasting_ball_in_the_motion() {
    let mut case = with_oil(reference::conventional(), 5.0);
    case.operation.gravity_m_s2 = 0.0;
    case.operation.radial_load_n = 0.0;
    case.contact.friction.coefficient = 0.1;
    case.contact.friction.regularisation_speed_m_s = 1e-3;
    let radii = case.bearing.dimensions();
    let (ri, rw) = (
        radii.inner_groove_bottom_radius_m,
        case.bearing.ball_radius_m(),
    );
    // Balls of vt = 11 m/s, and a ring that the clearance keeps away from them.
    case.operation.inner_speed_rad_s = 2.0 * 11.0 / ri;
    let mut dimensions = radii.clone();
    dimensions.inner_groove_bottom_radius_m -= 50e-6;
    case.bearing = Bearing::new(dimensions, Material::STEEL).unwrap();
    case.start.state = cageless::StartState::Rolling {
        ring_x_m: 0.0,
        ring_y_m: 0.0,
    };
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 1e-6;
    case.solver.duration_s = 1e-2;
    let mut simulation = Simulation::new(&case).unwrap();
    let ball = |simulation: &Simulation| {
        let view = simulation.view();
        let ball = view.ball(0);
        ball.vx_m_s().hypot(ball.vy_m_s())
    };
    simulation.advance_to(1e-3).unwrap();
    let start = ball(&simulation);
    simulation.advance_to(9e-3).unwrap();
    let end = ball(&simulation);
    let film = case.film.as_ref().unwrap();
    let expected = cageless::film::FreeBall::new(&case.bearing, film).speed_after_m_s(start, 8e-3);
    // The ball is pressed in by 6 µm, and so a little further out.
    assert!(
        (end - expected).abs() < 1e-4 * (start - end),
        "{start} {end}, expected {expected}; {rw}"
    );
}

/// The film adds no momentum, and takes the power of its loss from that of the drive.
#[test]
fn momentum_and_power_close() {
    let dry = reference::Structure::D.case();
    let wet = with_oil(dry.clone(), 20.0);
    let mut simulation = Simulation::new(&dry).unwrap();
    simulation.advance_to(1.234e-3).unwrap();
    let state = simulation.outcome().state;
    let rates = [&dry, &wet].map(|case| {
        let model = Model::new(case).unwrap();
        let mut equations = RightHandSide::new(&model);
        let mut rates = vec![0.0; state.values().len()];
        equations.derivative(0.0, state.values(), &mut rates);
        (rates, equations.contacts().outer_ring_force_n())
    });
    let [(dry_rates, dry_outer), (rates, outer)] = &rates;
    let layout = state.layout();
    let ball = dry.bearing.ball(0);
    let ring_kg = dry.bearing.dimensions().inner_ring_mass_kg;
    let change = |at: usize| rates[at] - dry_rates[at];
    let mut force_n = [outer[0] - dry_outer[0], outer[1] - dry_outer[1]];
    let mut power_w = 0.0;
    let mut size_n: f64 = 0.0;
    for k in 0..14 {
        for (axis, coordinate) in [BallCoordinate::Vx, BallCoordinate::Vy]
            .into_iter()
            .enumerate()
        {
            let at = layout.ball(coordinate, k);
            force_n[axis] += ball.mass_kg * change(at);
            size_n = size_n.max((ball.mass_kg * change(at)).abs());
            power_w += ball.mass_kg * change(at) * state.values()[at];
        }
        let at = layout.ball(BallCoordinate::Spin, k);
        power_w += ball.inertia_kg_m2 * change(at) * state.values()[at];
    }
    for (axis, coordinate) in [RingCoordinate::Vx, RingCoordinate::Vy]
        .into_iter()
        .enumerate()
    {
        let at = layout.ring(coordinate);
        force_n[axis] += ring_kg * change(at);
        power_w += ring_kg * change(at) * state.values()[at];
    }
    assert!(size_n > 0.1, "{size_n}");
    assert!(
        force_n.iter().all(|f| f.abs() < 1e-9 * size_n),
        "{force_n:?}"
    );
    let term = |term| change(layout.energy_term(term));
    let loss_w = term(EnergyTerm::RollingResistance);
    let closing = power_w - (term(EnergyTerm::Drive) - loss_w);
    assert!(
        loss_w > 50.0 && closing.abs() < 1e-9 * loss_w,
        "{loss_w} {closing}"
    );
}

/// Where no film is computed it is refused by name.
#[test]
fn what_has_no_film_is_refused() {
    let film = Some(Film::flooded(oil(5.0)));
    let refused = |case: Case| {
        let error = case.check().unwrap_err();
        assert_eq!(error.field, "supply");
        error.to_string()
    };
    let mut case = Case {
        film,
        ..reference::conventional()
    };
    assert!(case.check().is_ok());
    case.operation.space.axial_load_n = 100.0;
    assert!(refused(case).contains("plane only"));
    let drop = Case {
        film,
        ..reference::rotor_drop()
    };
    assert!(refused(drop).contains("falling rotor"));
    let paper = Case {
        film,
        formulation: cageless::Formulation::Paper,
        ..reference::conventional()
    };
    assert!(refused(paper).contains("published"));
    let case = Case {
        film,
        ..reference::Structure::D.case()
    };
    let judged = cageless::design::judge(&case, &mut |_| Control::Continue(()));
    assert!(judged.unwrap_err().to_string().contains("lag of a film"));
}
