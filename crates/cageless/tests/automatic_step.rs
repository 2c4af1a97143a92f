//! The automatic step where no load sets it: balls of unequal size, raceways not milled deep
//! enough, rolling starts with overlap, light bearings at low speed.

use std::f64::consts::TAU;

use crate::common::{conventional, dimensions, structure, undamped};
use cageless::simulation::{Control, Ending, RunOutcome, run};
use cageless::step_limits::StepLimits;
use cageless::{Case, FrictionLaw, Gaps, IntegrationMethod, Start};

fn automatic(mut case: Case, load_n: f64, rpm: f64, duration_s: f64) -> Case {
    case.operation.radial_load_n = load_n;
    case.operation.inner_speed_rad_s = rpm * TAU / 60.0;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.duration_s = duration_s;
    case
}

fn complete(case: &Case) -> RunOutcome {
    let outcome = run(case, &mut [], &mut |_| Control::Continue(())).unwrap();
    assert!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    outcome
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
    case.start = Start::Rolling {
        gaps: Gaps::Uniform,
        lead_ball_angle_rad: 0.0,
        ring_x_m: 0.0,
        ring_y_m: -30e-6,
    };
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
    case.contact.friction_law = FrictionLaw::Coulomb;
    let low = creep(&case, IntegrationMethod::Abm4);
    case.contact.friction_coefficient = 0.3;
    let high = creep(&case, IntegrationMethod::Abm4);
    // Friction is implicit there, and sticking exact.
    assert_eq!(creep(&case, IntegrationMethod::VelocityVerlet), 0.0);
    assert!((high / low - 0.3 / 0.007).abs() < 1e-9);
    let force = high / 0.3 * 0.4 * 2.0 / 7.0 * case.bearing.ball_mass_kg();
    assert!((500.0..2000.0).contains(&force), "{force} N");
}
