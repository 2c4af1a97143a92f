//! The automatic step where no load sets it: balls of unequal size, raceways not milled deep
//! enough, rolling starts with overlap, light bearings at low speed.

use std::f64::consts::TAU;

use crate::common::{complete, conventional, dimensions, steel, structure, undamped};
use cageless::step_limits::StepLimits;
use cageless::{
    Bearing, BearingDimensions, Case, FrictionModel, Gaps, IntegrationMethod, Start, StartState,
};

fn automatic(mut case: Case, load_n: f64, rpm: f64, duration_s: f64) -> Case {
    case.operation.radial_load_n = load_n;
    case.operation.inner_speed_rad_s = rpm * TAU / 60.0;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.duration_s = duration_s;
    case
}

fn alternating(mut case: Case, deviation_m: f64) -> Case {
    let sign = |k: usize| if k.is_multiple_of(2) { 1.0 } else { -1.0 };
    let deviations = (0..case.bearing.balls()).map(|k| sign(k) * deviation_m);
    case.bearing = case
        .bearing
        .clone()
        .with_ball_radius_deviations(deviations.collect())
        .unwrap();
    case
}

#[test]
fn balls_of_unequal_size_preload_an_unloaded_bearing() {
    for rpm in [100.0, 1000.0] {
        let case = alternating(undamped(structure(5.1, 25.2)), 5e-6);
        let outcome = complete(&automatic(case, 0.0, rpm, 0.02));
        let residual = outcome.energy_residual_relative.abs();
        assert!(residual < 1e-3, "{rpm}: {residual:e}");
    }
}

#[test]
fn a_raceway_not_milled_deep_enough_preloads_too() {
    let mut case = alternating(undamped(structure(5.1, 25.2)), 5e-6);
    let shallow = case.raceways[0].clone().with_depth_error(-3e-6).unwrap();
    case.raceways = vec![shallow];
    let outcome = complete(&automatic(case, 100.0, 1000.0, 0.02));
    let residual = outcome.energy_residual_relative.abs();
    assert!(residual < 1e-3, "{residual:e}");
}

#[test]
fn overlap_of_a_rolling_start_shortens_the_step() {
    let mut case = conventional(dimensions());
    let settled = automatic(case.clone(), 0.0, 100.0, 0.01).solver.step_s;
    case.start = Start::new(
        StartState::Rolling {
            ring_x_m: 0.0,
            ring_y_m: -30e-6,
        },
        Gaps::Uniform,
        0.0,
    );
    let overlapping = automatic(case, 0.0, 100.0, 0.01).solver.step_s;
    assert!(overlapping < 0.8 * settled, "{overlapping:e} {settled:e}");
}

#[test]
fn a_light_bearing_at_low_speed_keeps_its_energy_balance() {
    for (load, rpm, damped) in [
        (0.0, 100.0, true),
        (0.0, 300.0, false),
        (1.0, 100.0, true),
        (10.0, 1000.0, false),
    ] {
        let mut case = conventional(dimensions());
        if !damped {
            case = undamped(case);
        }
        let outcome = complete(&automatic(case, load, rpm, 0.05));
        let residual = outcome.energy_residual_relative.abs();
        assert!(residual < 1e-3, "{load} N {rpm} rpm: {residual:e}");
    }
}

#[test]
fn nothing_is_unaccounted_for_where_nothing_flows() {
    let mut case = undamped(conventional(dimensions()));
    case.operation.gravity_m_s2 = 0.0;
    let outcome = complete(&automatic(case, 0.0, 12_000.0, 0.02));
    let residual = outcome.energy_residual_relative.abs();
    assert!(residual < 1e-4, "{residual:e}");
}

/// The creep of the relaxed stick is μN over its gain 0.4·(2/7)m/h.
#[test]
fn coulomb_friction_says_how_far_it_creeps() {
    let mut case = conventional(dimensions());
    let creep = |case: &Case, method| StepLimits::new(case).creep_m_s2(method);
    assert_eq!(creep(&case, IntegrationMethod::Abm4), 0.0);
    case.contact.friction_law = FrictionModel::Coulomb;
    let low = creep(&case, IntegrationMethod::Abm4);
    case.contact.friction.coefficient = 0.3;
    let high = creep(&case, IntegrationMethod::Abm4);
    // Friction is implicit there, and sticking exact.
    assert_eq!(creep(&case, IntegrationMethod::VelocityVerlet), 0.0);
    assert!((high / low - 0.3 / 0.007).abs() < 1e-9);
    let force = high / 0.3 * 0.4 * 2.0 / 7.0 * case.bearing.ball_mass_kg();
    assert!((500.0..2000.0).contains(&force), "{force} N");
}

/// A settled bearing of balls in one row, with grooves of 0.52 Dw and 20 µm of play or less.
fn row(balls: usize, diameter_m: f64, pitch_m: f64, play_m: f64, ring_kg: f64) -> Case {
    let mut case = conventional(dimensions());
    let (rw, middle) = (diameter_m / 2.0, pitch_m / 2.0);
    let half = rw + play_m / 2.0;
    let dimensions = BearingDimensions {
        balls,
        ball_radius_m: rw,
        inner_groove_bottom_radius_m: middle - half,
        outer_groove_bottom_radius_m: middle + half,
        outer_shoulder_radius_m: middle + half - 0.2 * diameter_m,
        inner_shoulder_radius_m: None,
        inner_groove_curvature_radius_m: 0.52 * diameter_m,
        outer_groove_curvature_radius_m: 0.52 * diameter_m,
        inner_ring_mass_kg: ring_kg,
        inner_ring_damping_n_s_m: 2000.0,
    };
    case.bearing = Bearing::new(dimensions, steel()).unwrap();
    let mut gaps = vec![0.0; balls];
    gaps[balls - 1] = balls as f64 * case.bearing.mean_gap_rad();
    case.start = Start::new(StartState::Settled, Gaps::List(gaps), 0.15);
    case
}

/// The ring wedged into the opening of 173° between the ends of a row of 22 balls has ten times
/// the force of even spacing: half of 170 N over cos 86.5°, and not 5/22 of it.
#[test]
fn a_ring_wedged_between_the_ends_of_a_row_keeps_its_energy_balance() {
    let wedged = row(22, 3.572e-3, 46e-3, 6.5e-6, 0.05);
    let case = automatic(wedged.clone(), 170.0, 6500.0, 0.0035);
    let residual = complete(&case).energy_residual_relative.abs();
    assert!(
        residual < 1e-3,
        "{residual:e} at {:e} s",
        case.solver.step_s
    );
    let mut even = wedged;
    even.start = Start::new(StartState::Settled, Gaps::Uniform, 0.15);
    let even = automatic(even, 170.0, 6500.0, 0.0035).solver.step_s;
    assert!(
        case.solver.step_s < 0.5 * even,
        "{:e} {even:e}",
        case.solver.step_s
    );
}

/// Without load, too: the ring follows a row, or four balls at 90°, round through its clearance,
/// against its damping of 2000 N·s/m with 50 N and more, and friction is stiff under that force.
#[test]
fn a_ring_that_whirls_with_its_balls_keeps_its_energy_balance() {
    let bunched = row(9, 2e-3, 7.087e-3, 40e-6, 5e-4);
    let mut four = row(4, 2.21e-3, 5.435e-3, 37e-6, 5e-4);
    four.start = Start::new(StartState::Settled, Gaps::Uniform, 5.1);
    for (mut case, rpm) in [(bunched, 16_000.0), (four, 80_000.0)] {
        case.contact.friction_law = FrictionModel::Stribeck;
        case.contact.friction.coefficient = 0.04;
        case.contact.friction.static_coefficient = Some(0.12);
        case.contact.friction.stribeck_speed_m_s = Some(1.3);
        case.contact.friction.regularisation_speed_m_s = 2.5e-3;
        case.contact.damping_n_s_m1_5 = 7.7e5;
        let case = automatic(case, 0.0, rpm, 2e-4);
        let residual = complete(&case).energy_residual_relative.abs();
        let balls = case.bearing.balls();
        assert!(
            residual < 1e-3,
            "{balls}: {residual:e} at {:e} s",
            case.solver.step_s
        );
    }
}
