//! A drop against a reference computed independently: a second implementation of the equations
//! in quadruple precision. The rotor starts 1 µm above contact with the speed of its fall; gaps
//! are uneven, balls collide.

use crate::common::{complete, drop_case, raceway};
use cageless::ball::BallMotion;
use cageless::dynamics::state::State;
use cageless::step_limits::StepLimits;
use cageless::{Case, Gaps, IntegrationMethod, Start, StartState};

/// The case of `reference/td1_2ms.csv`.
pub fn td1() -> Case {
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
    case.start = Start::new(
        StartState::AtRest,
        Gaps::List(gaps.map(f64::to_radians).to_vec()),
        (-12.0_f64).to_radians(),
    );
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

/// Coordinates of a drop in their scales: those of the balls, of the rings, of the rotor.
pub fn scaled(state: &State) -> Vec<f64> {
    let mut values = vec![];
    for k in 0..state.x_m().len() {
        let BallMotion { x, y, vx, vy, spin } = state.ball_motion(k);
        values.extend([x / 1e-5, y / 1e-5, vx, vy, spin / 200.0]);
    }
    let (ring, outer) = (state.ring_motion(), state.outer_ring_motion());
    let rotor = state.rotor_motion().unwrap();
    for centre in [
        [ring.x, ring.y, ring.vx, ring.vy],
        [outer.x, outer.y, outer.vx, outer.vy],
    ] {
        values.extend(
            centre
                .iter()
                .zip([1e-5, 1e-5, 0.1, 0.1])
                .map(|(v, s)| v / s),
        );
    }
    let rotor = [
        rotor.x,
        rotor.y,
        rotor.vx,
        rotor.vy,
        rotor.speed,
        rotor.angle,
    ];
    let scales = [1e-5, 1e-5, 0.1, 0.1, 1.0, 1e-3];
    values.extend(rotor.iter().zip(scales).map(|(v, s)| v / s));
    values.push(state.ring_speed_rad_s().unwrap());
    values
}

/// Root mean square of the differences of two states, and the largest.
pub fn difference(values: &[f64], reference: &[f64]) -> [f64; 2] {
    assert_eq!(values.len(), reference.len());
    let each = values.iter().zip(reference).map(|(v, r)| (v - r).abs());
    let squares: f64 = each.clone().map(|d| d * d).sum();
    [
        (squares / values.len() as f64).sqrt(),
        each.fold(0.0, f64::max),
    ]
}

/// [`scaled`] of the reference.
pub fn td1_reference() -> Vec<f64> {
    let text = include_str!("../reference/td1_2ms.csv");
    let rows: Vec<Vec<f64>> = text.lines().skip(2).map(row).collect();
    assert_eq!(rows.len(), 17);
    let scales = |row: &[f64], scales: &[f64]| -> Vec<f64> {
        row.iter().zip(scales).map(|(v, s)| v / s).collect()
    };
    let balls = rows[..14].iter();
    let mut values: Vec<f64> = balls
        .flat_map(|r| scales(r, &[1e-5, 1e-5, 1.0, 1.0, 200.0]))
        .collect();
    for ring in &rows[14..16] {
        values.extend(scales(ring, &[1e-5, 1e-5, 0.1, 0.1]));
    }
    values.extend(scales(&rows[16], &[1e-5, 1e-5, 0.1, 0.1, 1.0, 1e-3]));
    values.push(rows[14][4]);
    values
}

/// RMS over the states of (y − reference)/scale, and the largest.
fn error(state: &State) -> [f64; 2] {
    difference(&scaled(state), &td1_reference())
}

/// Under 1e-5 with error control.
#[test]
fn adaptive_agrees_with_the_reference() {
    for (tolerance, most_rms) in [(1e-10, 1e-5), (1e-12, 1e-6)] {
        let mut case = td1();
        case.solver.method = IntegrationMethod::Adaptive;
        case.solver.tolerance = tolerance;
        let outcome = complete(&case);
        let [rms, most] = error(&outcome.state);
        println!(
            "adaptive {tolerance:e}: rms {rms:.2e}, largest {most:.2e}, {} evaluations, energy balance {:.1e}",
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
            "symplectic {step_s:e}: rms {rms:.2e}, largest {most:.2e}, energy balance {:.1e}",
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
