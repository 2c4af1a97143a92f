//! Unbalance of the inner ring.

use std::f64::consts::TAU;

use crate::common::{complete, conventional, dimensions, structure};
use cageless::simulation::{Control, Observer, ObserverError, Simulation, StepView, run};
use cageless::{Case, Formulation, IntegrationMethod, Motion, TimeTable, Unbalance};

/// 6000 rpm.
const SPEED_RAD_S: f64 = 100.0 * TAU;
const AMOUNT_KG_M: f64 = 4e-4;

fn unbalanced(mut case: Case) -> Case {
    (case.solver.method, case.solver.step_s) = (IntegrationMethod::VelocityVerlet, 2e-6);
    case.operation.inner_speed_rad_s = SPEED_RAD_S;
    case.operation.unbalance = Unbalance {
        amount_kg_m: AMOUNT_KG_M,
        phase_rad: 0.4,
    };
    case.solver.duration_s = 0.07;
    case
}

/// Force on the outer ring that turns with the inner one, over the last five turns.
#[derive(Default)]
struct TurningForce {
    along_n: f64,
    across_n: f64,
    time_s: f64,
}

impl Observer for TurningForce {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let (time_s, step_s) = (view.step.t1_s, view.step.size_s());
        if time_s > 0.02 {
            let [x, y] = view.contacts.outer_ring_force_n();
            let (sin, cos) = (0.4 + SPEED_RAD_S * time_s).sin_cos();
            self.along_n += (x * cos + y * sin) * step_s;
            self.across_n += (y * cos - x * sin) * step_s;
            self.time_s += step_s;
        }
        Ok(Control::Continue(()))
    }
}

/// The outer ring bears m·e·ω² in the direction of the unbalance, in the plane and in space: far below the
/// natural frequency of the ring on its balls nothing amplifies it.
#[test]
fn the_outer_ring_bears_the_unbalance() {
    for motion in [Motion::BySymmetry, Motion::Space] {
        let mut case = unbalanced(conventional(dimensions()));
        case.motion = motion;
        let mut force = TurningForce::default();
        run(&case, &mut [&mut force], &mut |_| Control::Continue(())).unwrap();
        let expected = AMOUNT_KG_M * SPEED_RAD_S * SPEED_RAD_S;
        let [along, across] = [force.along_n, force.across_n].map(|n| n / force.time_s);
        assert!(
            (along / expected - 1.0).abs() < 0.01,
            "{motion:?}: {along} {expected}"
        );
        assert!(
            across.abs() < 0.02 * expected,
            "{motion:?}: {across} {expected}"
        );
    }
}

/// The ledger counts its work, with contacts between balls and on flanks.
#[test]
fn the_work_of_the_unbalance_balances_the_ledger() {
    for motion in [Motion::BySymmetry, Motion::Space] {
        let mut case = unbalanced(structure(5.1, 25.2));
        (case.solver.method, case.solver.step_s) = (IntegrationMethod::Abm4, 5e-7);
        (case.motion, case.solver.duration_s) = (motion, 0.01);
        let residual = complete(&case).energy_residual_relative;
        assert!(residual.abs() < 1e-4, "{motion:?}: {residual:e}");
    }
}

/// In a run-up the unbalance has turned as far as the ring: a constant table gives the bits of the constant, and a
/// run that begins later the force of that time.
#[test]
fn the_unbalance_turns_with_the_ring() {
    let mut case = unbalanced(conventional(dimensions()));
    case.solver.duration_s = 5e-3;
    let constant = complete(&case).state;
    let table = |values: [f64; 2]| {
        Some(TimeTable::new("inner_speed_rad_s", vec![0.0, 1.0], values.to_vec()).unwrap())
    };
    case.operation.inner_speed_table = table([SPEED_RAD_S; 2]);
    assert_eq!(complete(&case).state, constant);
    case.operation.inner_speed_table = table([SPEED_RAD_S, 3.0 * SPEED_RAD_S]);
    let later = case.operation.from_time(0.5);
    // ½·(ω + 2ω)·0.5 s is 75 turns.
    let turned = (later.unbalance.phase_rad - 0.4) / TAU;
    assert!((turned - 75.0).abs() < 1e-9, "{turned}");
    let force = case.operation.unbalance_force_n();
    assert!((force / (9.0 * AMOUNT_KG_M * SPEED_RAD_S * SPEED_RAD_S) - 1.0).abs() < 1e-12);
}

#[test]
fn impossible_unbalances_are_named() {
    let mut case = unbalanced(structure(5.1, 25.2));
    let refused = |case: &Case| case.check().unwrap_err();
    let mut simulation = Simulation::new(&case).unwrap();
    assert!(simulation.set_inner_speed_rad_s(1.0).is_err());
    case.operation.unbalance.amount_kg_m = -1e-4;
    assert_eq!(refused(&case).field, "unbalance_kg_m");
    // More than the balls bear: 5 % of their radius.
    case.operation.unbalance.amount_kg_m = 1.0;
    assert_eq!(refused(&case).field, "unbalance_kg_m");
    case.operation.radial_load_n = 1e6;
    assert_eq!(refused(&case).field, "radial_load_n");
    case.operation.radial_load_n = 1500.0;
    case.operation.unbalance.amount_kg_m = AMOUNT_KG_M;
    case.formulation = Formulation::Paper;
    assert_eq!(refused(&case).field, "unbalance_kg_m");
}
