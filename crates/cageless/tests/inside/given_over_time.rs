//! Speed and load that are given over time.

use crate::common::{complete, structure};
use cageless::dynamics::energy::EnergyTerm;
use cageless::kinematics::rolling_orbit_speed_rad_s;
use cageless::simulation::RunOutcome;
use cageless::{IntegrationMethod, Operation, Start, StartState, TimeTable};

fn table(times_s: &[f64], values: &[f64]) -> Option<TimeTable> {
    Some(TimeTable::new("inner_speed_rad_s", times_s.to_vec(), values.to_vec()).unwrap())
}

fn mean_orbit_rad_s(outcome: &RunOutcome) -> f64 {
    let state = &outcome.state;
    let n = state.x_m().len();
    let orbit = |k: usize| {
        let (x, y) = (state.x_m()[k], state.y_m()[k]);
        (x * state.vy_m_s()[k] - y * state.vx_m_s()[k]) / (x * x + y * y)
    };
    (0..n).map(orbit).sum::<f64>() / n as f64
}

/// Tables that hold one value give the bits of the constant.
/// Speed and load of an operation as tables over time that hold them.
fn in_tables(mut operation: Operation) -> Operation {
    let speed_rad_s = operation.inner_speed_rad_s;
    operation.inner_speed_table = table(&[0.0, 1.0], &[speed_rad_s; 2]);
    operation.radial_load_table = table(&[0.0], &[operation.radial_load_n]);
    operation
}

#[test]
fn a_constant_table_is_a_constant() {
    for method in [IntegrationMethod::Abm4, IntegrationMethod::VelocityVerlet] {
        let mut case = structure(5.1, 25.2);
        case.solver.method = method;
        case.solver.duration_s = 2e-3;
        let constant = complete(&case);
        case.operation = in_tables(case.operation.clone());
        assert_eq!(complete(&case).state, constant.state);
    }
}

/// In a run-up from rest balls follow the rolling speed of the moment, and the work of the drive
/// balances the ledger.
#[test]
fn balls_follow_a_run_up() {
    let mut case = structure(5.1, 25.2);
    (case.solver.method, case.solver.step_s) = (IntegrationMethod::VelocityVerlet, 2e-6);
    case.solver.duration_s = 0.03;
    case.contact.friction.coefficient = 0.05;
    case.operation.inner_speed_rad_s = 0.0;
    case.operation.inner_speed_table = table(&[0.005, 0.025], &[0.0, 400.0]);
    let outcome = complete(&case);
    let rolling = rolling_orbit_speed_rad_s(&case.bearing, 400.0, case.bearing.ball_radius_m());
    let orbit = mean_orbit_rad_s(&outcome);
    assert!((orbit / rolling - 1.0).abs() < 0.02, "{orbit} {rolling}");
    assert!(outcome.energy_residual_relative.abs() < 1e-3);
    assert!(outcome.state.energy_term_j(EnergyTerm::Drive) > 0.0);
}

/// A load step moves the ring to where the new load holds it.
#[test]
fn a_load_step_moves_the_ring() {
    let settled_y = |load_n: f64| {
        let mut case = structure(5.1, 25.2);
        case.operation.radial_load_n = load_n;
        cageless::equilibrium::solve(&case).unwrap().ring_y_m
    };
    let mut case = structure(5.1, 25.2);
    case.operation.radial_load_n = 500.0;
    case.operation.radial_load_table = table(&[0.005, 0.006], &[500.0, 1500.0]);
    let outcome = complete(&case);
    let y = outcome.state.ring_motion().y;
    let expected = settled_y(1500.0);
    assert!((y / expected - 1.0).abs() < 0.05, "{y} {expected}");
    assert!((settled_y(500.0) / expected - 1.0).abs() > 0.3);
}

/// In space tables that hold one value give the bits of the constant, and a load step moves the ring to where the new
/// load holds it.
#[test]
fn tables_work_in_space() {
    let mut case = structure(5.1, 25.2);
    case.operation.space.axial_load_n = 100.0;
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.duration_s = 5e-4;
    let constant = complete(&case);
    case.operation = in_tables(case.operation.clone());
    assert_eq!(complete(&case).state, constant.state);

    let settled_y = |load_n: f64| {
        let mut case = case.clone();
        case.operation.radial_load_table = None;
        case.operation.radial_load_n = load_n;
        cageless::equilibrium::settle(&case).unwrap().rest.ring_y_m
    };
    let expected = settled_y(1500.0);
    let mut step = case.clone();
    step.operation.radial_load_n = 500.0;
    step.operation.radial_load_table = table(&[0.001, 0.0012], &[500.0, 1500.0]);
    step.solver.duration_s = 4e-3;
    let y = complete(&step).state.ring_motion().y;
    assert!((y / expected - 1.0).abs() < 0.05, "{y} {expected}");
    assert!((settled_y(500.0) / expected - 1.0).abs() > 0.3);
}

/// Tables must begin with the value of the start, not be negative, and studies at one speed
/// refuse them.
#[test]
fn impossible_tables_are_named() {
    let mut case = structure(5.1, 25.2);
    case.operation.inner_speed_table = table(&[0.0, 1.0], &[1.0, 2.0]);
    assert_eq!(case.check().unwrap_err().field, "inner_speed_rad_s");
    case.operation.inner_speed_rad_s = 1.0;
    assert!(case.check().is_ok());
    case.operation.radial_load_table = table(&[0.0, 1.0], &[1500.0, -2.0]);
    assert_eq!(case.check().unwrap_err().field, "radial_load_n");
    case.operation.radial_load_table = None;
    let error = case.check_constant_operation("a verdict").unwrap_err();
    assert_eq!(error.field, "inner_speed_rad_s");
    case.operation.inner_speed_table = None;
    case.start = Start::new(StartState::AtRest, cageless::Gaps::Uniform, 0.0);
    assert!(case.check().is_ok());
}
