//! The problem that everything here is measured on: case CB74 and its reference
//! trajectory.

use anyhow::{Result, ensure};
use cageless::dynamics::coordinates::{BALL, RING};
use cageless::dynamics::state::State;
use cageless::initial_conditions::initial_state;
use cageless::{Case, FrictionLaw, Profile};
use cageless_io::case_file::CaseFile;

const CASE: &str = include_str!("../../../cases/cb74.toml");
const STRUCTURE_D: &str = include_str!("../../../cases/zhao-d.toml");
const REFERENCE: &str = include_str!("../../cageless-io/tests/reference/cb74_2ms.csv");

/// Time at which the reference trajectory gives the state.
pub const REFERENCE_S: f64 = 0.002;

/// CB74 with overrides as the command line takes them (`section.key=value`).
///
/// # Errors
/// A key or value that the case file does not admit.
pub fn cb74(overrides: &[String]) -> Result<Case> {
    let case = CaseFile::parse(CASE, "cb74.toml", overrides)?
        .case()
        .clone();
    ensure!(
        case.profile == Profile::Physical && case.contact.friction_law == FrictionLaw::Smooth,
        "the bench knows CB74 in the physical profile with the smooth law only"
    );
    Ok(case)
}

/// Structure (d) of the paper with overrides as the command line takes them.
///
/// # Errors
/// A key or value that the case file does not admit.
pub fn structure_d(overrides: &[String]) -> Result<Case> {
    let file = CaseFile::parse(STRUCTURE_D, "zhao-d.toml", overrides)?;
    Ok(file.case().clone())
}

/// The 5 N + 4 states without padding and energy ledger, each over its scale: x of every
/// ball, then y, vx, vy, spin, then the ring.
pub fn scaled(state: &State) -> Vec<f64> {
    let groups = [
        state.x_m(),
        state.y_m(),
        state.vx_m_s(),
        state.vy_m_s(),
        state.spin_state_rad_s(),
    ];
    let balls = groups
        .iter()
        .zip(BALL)
        .flat_map(|(group, c)| group.iter().map(move |v| v / c.error_scale));
    let ring = state.ring_motion();
    let ring = [ring.x, ring.y, ring.vx, ring.vy].into_iter().zip(RING);
    balls.chain(ring.map(|(v, c)| v / c.error_scale)).collect()
}

/// Scale of each of the 5 N + 4 states.
pub fn scales(balls: usize) -> Vec<f64> {
    BALL.iter()
        .flat_map(|c| std::iter::repeat_n(c.error_scale, balls))
        .chain(RING.iter().map(|c| c.error_scale))
        .collect()
}

/// Start of a case and ψ of its balls.
///
/// # Errors
/// The start has no equilibrium.
pub fn start(case: &Case) -> Result<(State, Vec<f64>)> {
    Ok(initial_state(case)?)
}

/// The reference at 2 ms in the order and the scales of [`scaled`].
pub fn reference() -> Vec<f64> {
    let rows: Vec<Vec<f64>> = REFERENCE
        .lines()
        .filter(|line| !line.starts_with('#') && !line.starts_with("body"))
        .map(|line| {
            line.split(',')
                .skip(1)
                .filter_map(|v| v.parse().ok())
                .collect()
        })
        .collect();
    let Some((ring, balls)) = rows.split_last() else {
        return vec![];
    };
    let states = (0..5).flat_map(|group| {
        balls
            .iter()
            .map(move |row| row[group] / BALL[group].error_scale)
    });
    states
        .chain(ring.iter().zip(RING).map(|(v, c)| v / c.error_scale))
        .collect()
}

/// RMS over the states of the difference of two scaled states.
pub fn rms_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let sum: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    (sum / a.len() as f64).sqrt()
}
