//! Factor on the loads of a case at which its largest contact pressure reaches the limit.

use crate::case::{Case, Tilt};
use crate::contact::hertz::STRESS_LIMIT_PA;
use crate::equilibrium::settle;
use crate::numerics::root;

/// Error of the factor, relative.
const TOLERANCE: f64 = 1e-7;
/// Factors that are tried on the way to one beyond the limit.
const STEPS: usize = 60;
/// Next factor over the last: at least, and at most.
const STEP: [f64; 2] = [1.2, 1e3];
/// Ratio of two factors, one with equilibrium and one without, between which nothing is sought.
const NARROW: f64 = 1.001;

/// Factor on radial load, axial load and moments together at which the largest contact pressure in equilibrium
/// reaches [`STRESS_LIMIT_PA`]; preload, weights and speed stay. 0 where they alone exceed it; `None` without load, and
/// where there is no equilibrium up to the limit, as when a contact leaves its groove.
pub(super) fn load_factor(case: &Case) -> Option<f64> {
    let space = &case.operation.space;
    let moments = match space.tilt {
        Tilt::Free {
            moment_x_n_m,
            moment_y_n_m,
        } => [moment_x_n_m, moment_y_n_m],
        Tilt::Held { .. } => [0.0; 2],
    };
    let [about_x, about_y] = moments;
    let loads = [
        case.operation.radial_load_n,
        space.axial_load_n,
        about_x,
        about_y,
    ];
    if loads == [0.0; 4] {
        return None;
    }
    let [low, high] = match excess(case, 1.0)? {
        at_once if at_once < 0.0 => bracket(case, at_once)?,
        _ if excess(case, 0.0)? >= 0.0 => return Some(0.0),
        _ => [0.0, 1.0],
    };
    let of = |factor: f64| excess(case, factor).ok_or(());
    root::try_brent(of, low, high, TOLERANCE * high).ok()?
}

/// Two factors from 1 on with the limit between them, where `excess_at_one` is that of the loads as they are.
fn bracket(case: &Case, excess_at_one: f64) -> Option<[f64; 2]> {
    let [least, most] = STEP;
    let (mut low, mut excess_at_low) = (1.0, excess_at_one);
    for _ in 0..STEPS {
        // Of one contact the cube of the pressure is the force.
        let high = low * (least / (1.0 + excess_at_low)).clamp(least, most);
        match excess(case, high) {
            Some(above) if above >= 0.0 => return Some([low, high]),
            Some(below) => (low, excess_at_low) = (high, below),
            None => return before(case, low, high),
        }
    }
    None
}

/// Two factors with the limit between them below `none`, at which there is no equilibrium.
fn before(case: &Case, mut low: f64, mut none: f64) -> Option<[f64; 2]> {
    while none > NARROW * low {
        let middle = (low * none).sqrt();
        match excess(case, middle) {
            Some(above) if above >= 0.0 => return Some([low, middle]),
            Some(_) => low = middle,
            None => none = middle,
        }
    }
    None
}

/// Cube of the largest pressure over the limit less 1 with all loads times this factor; `None` without equilibrium.
fn excess(case: &Case, factor: f64) -> Option<f64> {
    let mut case = case.clone();
    let operation = &mut case.operation;
    operation.radial_load_n *= factor;
    operation.space.axial_load_n *= factor;
    if let Tilt::Free {
        moment_x_n_m,
        moment_y_n_m,
    } = &mut operation.space.tilt
    {
        *moment_x_n_m *= factor;
        *moment_y_n_m *= factor;
    }
    let rest = settle(&case).ok()?.rest;
    let peak_pa = rest.inner_pressure_max_pa.max(rest.outer_pressure_max_pa);
    Some((peak_pa / STRESS_LIMIT_PA).powi(3) - 1.0)
}
