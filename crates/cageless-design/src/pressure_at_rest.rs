//! Contact pressure at rest, wherever the balls are.

use std::f64::consts::TAU;

use cageless::equilibrium::{EquilibriumError, settle_controlled};
use cageless::simulation::Control;
use cageless::{Case, Gaps, Start, StartState};

/// Places within one spacing of the balls at which the load is looked at.
const POSITIONS: usize = 8;

/// Largest Hertz pressure at the inner and at the outer raceway in static equilibrium, over places of the evenly
/// spaced balls within one spacing, Pa.
///
/// # Errors
/// The case is impossible or has no equilibrium.
pub(crate) fn pressure_at_rest_pa(case: &Case) -> Result<[f64; 2], EquilibriumError> {
    pressure_at_rest_controlled_pa(case, &mut || Control::Continue(()))
}

/// [`pressure_at_rest_pa`], with `control` called before every place of the ring that is tried.
///
/// # Errors
/// Those of [`pressure_at_rest_pa`], or `control` ended the search.
pub(super) fn pressure_at_rest_controlled_pa(
    case: &Case,
    control: &mut dyn FnMut() -> Control,
) -> Result<[f64; 2], EquilibriumError> {
    let pitch = TAU / case.bearing.balls() as f64;
    let mut case = case.clone();
    let mut peak = [0.0f64; 2];
    for k in 0..POSITIONS {
        case.start = Start::new(
            StartState::Settled,
            Gaps::Uniform,
            pitch * k as f64 / POSITIONS as f64,
        );
        let e = settle_controlled(&case, control)?.rest;
        let here = [e.inner_pressure_max_pa, e.outer_pressure_max_pa];
        peak = std::array::from_fn(|raceway| peak[raceway].max(here[raceway]));
    }
    Ok(peak)
}
