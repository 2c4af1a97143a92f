//! A drop against a reference computed independently: a second implementation of the equations
//! in quadruple precision. The rotor starts 1 µm above contact with the speed of its fall; gaps
//! are uneven, balls collide.

use crate::common::{drop_case, raceway};
use cageless::dynamics::ball::BallMotion;
use cageless::dynamics::state::State;
use cageless::simulation::{Control, Ending, RunOutcome, run};
use cageless::step_limits::StepLimits;
use cageless::{Case, Gaps, IntegrationMethod, Start};

/// The case of `reference/td1_2ms.csv`.
fn td1() -> Case {
    let mut case = drop_case();
    let raceway = raceway(&case.bearing, 5.1, 25.2, 0.0);
    case = case.with_raceways(vec![raceway]);
    case.contact.inner_stiffness_n_m1_5 = Some(2.77e10);
    case.contact.outer_stiffness_n_m1_5 = Some(2.94e10);
    case.contact.ball_stiffness_n_m1_5 = Some(7.36e9);
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s) = (-199e-6, -0.0625);
    let gaps = [
        0.15,
        2.9,
        0.4,
        1.1,
        0.2,
        0.05,
        3.4,
        2.7,
        1.3,
        2.2,
        3.3,
        3.6,
        2.0,
        2.125_096_075_410_7,
    ];
    case.start = Start::AtRest {
        gaps: Gaps::List(gaps.map(f64::to_radians).to_vec()),
        lead_ball_angle_rad: (-12.0_f64).to_radians(),
    };
    case.solver.duration_s = 2e-3;
    case
}

/// x, y, ẋ, ẏ, spin or speed, and angle of one body of the reference; empty fields are 0.
fn row(line: &str) -> Vec<f64> {
    line.split(',')
        .skip(1)
        .map(|field| field.parse().unwrap_or(0.0))
        .collect()
}

/// RMS over the states of (y − reference)/scale, and the largest.
fn error(state: &State) -> [f64; 2] {
    let text = include_str!("reference/td1_2ms.csv");
    let rows: Vec<Vec<f64>> = text.lines().skip(2).map(row).collect();
    assert_eq!(rows.len(), 17);
    let mut errors = vec![];
    for (k, reference) in rows[..14].iter().enumerate() {
        let BallMotion { x, y, vx, vy, spin } = state.ball_motion(k);
        for (value, (reference, scale)) in [x, y, vx, vy, spin]
            .into_iter()
            .zip(reference.iter().zip([1e-5, 1e-5, 1.0, 1.0, 200.0]))
        {
            errors.push((value - reference) / scale);
        }
    }
    let (ring, outer) = (state.ring_motion(), state.outer_ring_motion());
    let rotor = state.rotor_motion().unwrap();
    let speed = state.ring_speed_rad_s().unwrap();
    let bodies = [
        vec![ring.x, ring.y, ring.vx, ring.vy, speed],
        vec![outer.x, outer.y, outer.vx, outer.vy],
        vec![
            rotor.x,
            rotor.y,
            rotor.vx,
            rotor.vy,
            rotor.speed,
            rotor.angle,
        ],
    ];
    let scales = [1e-5, 1e-5, 0.1, 0.1, 1.0, 1e-3];
    for (values, reference) in bodies.iter().zip(&rows[14..]) {
        for (value, (reference, scale)) in values.iter().zip(reference.iter().zip(scales)) {
            errors.push((value - reference) / scale);
        }
    }
    let rms = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
    [rms, errors.iter().fold(0.0, |m, e| e.abs().max(m))]
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

/// Under 1e-5 with error control. At 1e-9 steps run over the edges of contacts and leave 4e-5.
#[test]
fn adaptive_agrees_with_the_reference() {
    for (tolerance, most_rms) in [(1e-10, 1e-5), (1e-12, 1e-6)] {
        let mut case = td1();
        case.solver.method = IntegrationMethod::Adaptive;
        case.solver.tolerance = tolerance;
        let outcome = complete(&case);
        let [rms, most] = error(&outcome.state);
        println!(
            "adaptive {tolerance:e}: rms {rms:.2e}, largest {most:.2e}, {} evaluations, ledger {:.1e}",
            outcome.rhs_evaluations, outcome.energy_residual_relative
        );
        assert!(rms < most_rms && outcome.energy_residual_relative.abs() < 1e-9);
    }
}

/// Under 1e-2 with the production method at its automatic step.
#[test]
fn the_production_method_agrees_with_the_reference() {
    let mut case = td1();
    case.solver.method = IntegrationMethod::VelocityVerlet;
    let automatic = StepLimits::new(&case).automatic_s(IntegrationMethod::VelocityVerlet);
    let mut errors = vec![];
    for step_s in [automatic, automatic / 2.0, automatic / 4.0] {
        case.solver.step_s = step_s;
        let outcome = complete(&case);
        let [rms, most] = error(&outcome.state);
        println!(
            "symplectic {step_s:e}: rms {rms:.2e}, largest {most:.2e}, ledger {:.1e}",
            outcome.energy_residual_relative
        );
        assert!(outcome.energy_residual_relative.abs() < 1e-3);
        errors.push(rms);
    }
    assert!(
        errors[0] < 1e-2 && errors[2] < 0.5 * errors[0],
        "{errors:?}"
    );
}
