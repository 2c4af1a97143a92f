//! What axial load and tilt leave of the effect of discrete raceways, by motion in space.
//!
//! The lag of [`super::ContactAngleEstimate`] is that of rolling; here the balls of a case, evenly
//! spaced and settled, move under axial loads and tilts with all friction, and the lag is what
//! they lose.

use super::verdict::steady_case;
use crate::case::{Case, Motion, Tilt};
use crate::critical_gap::{CriticalGapError, PairTest, critical_gap_rad};
use crate::equilibrium::EquilibriumError;
use crate::error::{Allowed, InputError};
use crate::passage::{PassageRecorder, PassageTally};
use crate::simulation::{Control, Ending, run};
use crate::step_limits;
use crate::summary::SummaryRecorder;

/// Axial loads as fractions of the radial load.
const LOAD_RATIOS: [f64; 8] = [0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1.0];
/// Tilts about the horizontal axis, rad.
const TILTS_RAD: [f64; 5] = [-2e-3, -1e-3, 0.0, 1e-3, 2e-3];
/// Ball orbits discarded before the passages are counted, and counted.
pub const AXIAL_ORBITS: [f64; 2] = [8.0, 8.0];

/// Error of a critical gap in space.
const GAP_TOLERANCE_RAD: f64 = 2e-5;

/// Lag of the balls under one axial load and tilt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxialLag {
    /// Fa.
    pub axial_load_n: f64,
    /// Tilt of the inner ring about X.
    pub tilt_x_rad: f64,
    /// Mean lag per pass, and mean contact angle at the inner raceway; `None` if the bearing does not bear
    /// it: a contact leaves its groove, or the run stopped.
    pub lag_and_angle_rad: Option<[f64; 2]>,
    /// Critical gap of the first raceway; `None` if it was not asked for, the gap of a pair never closes or
    /// always does, or the run stopped.
    pub critical_gap_rad: Option<f64>,
}

/// Axial loads and tilts for the raceways of a case: every load with each tilt.
///
/// # Errors
/// An [`InputError`] if the case has no raceway, carries no radial load, is not planar but for slots, cannot
/// move in space, or has too large a step for the heaviest axial load.
pub fn axial_points(case: &Case) -> Result<Vec<[f64; 2]>, InputError> {
    case.check_planar_but_for_slots()?;
    case.check_constant_operation("--axial")?;
    let radial = case.operation.radial_load_n;
    Allowed::Above(0.0, "axial loads are fractions of it").check("radial_load_n", radial)?;
    if case.raceways.is_empty() {
        let rule = "given: axial loads are judged by the lag in the raceway";
        return Err(InputError::rule("axial_span_m", f64::NAN, rule));
    }
    under(case, [0.0, 0.0]).check_motion()?;
    let loads = |tilt| LOAD_RATIOS.map(|ratio| [ratio * radial, tilt]);
    let points: Vec<[f64; 2]> = TILTS_RAD.into_iter().flat_map(loads).collect();
    for point in &points {
        step_limits::check(&under(case, *point))?;
    }
    Ok(points)
}

/// The case, evenly spaced, under this axial load and tilt.
fn under(case: &Case, [axial_load_n, tilt_x_rad]: [f64; 2]) -> Case {
    let mut loaded = steady_case(&Case {
        motion: Motion::Space,
        ..case.clone()
    });
    loaded.solver.duration_s = AXIAL_ORBITS.iter().sum::<f64>() * case.rolling_orbit_s();
    loaded.operation.space.axial_load_n = axial_load_n;
    loaded.operation.space.tilt = Tilt::Held {
        x_rad: tilt_x_rad,
        y_rad: 0.0,
    };
    loaded
}

/// Lag at one of [`axial_points`], after eight orbits of the balls over eight more. `control` is
/// called with the completed fraction; what it ends has no lag.
///
/// # Errors
/// The case is impossible.
pub fn axial_lag(
    case: &Case,
    point: [f64; 2],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<AxialLag, EquilibriumError> {
    Ok(AxialLag {
        axial_load_n: point[0],
        tilt_x_rad: point[1],
        lag_and_angle_rad: lag_and_angle_rad(&under(case, point), control)?,
        critical_gap_rad: None,
    })
}

/// Lag per pass and contact angle at the inner raceway, both mean, of a case in space; `None` if the bearing
/// does not bear its load, the run stopped, or no ball passed a raceway.
fn lag_and_angle_rad(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Option<[f64; 2]>, EquilibriumError> {
    let after_s = AXIAL_ORBITS[0] * case.rolling_orbit_s();
    let duration_s = case.solver.duration_s;
    let mut tally = PassageTally::new();
    let mut summary = SummaryRecorder::new();
    let ran = {
        let mut passages = PassageRecorder::new(|passage| {
            if passage.enter_s > after_s {
                tally.add(&passage);
            }
            Ok(())
        });
        run(case, &mut [&mut passages, &mut summary], &mut |time_s| {
            control(time_s / duration_s)
        })
    };
    let outcome = match ran {
        Ok(outcome) => outcome,
        Err(error @ EquilibriumError::Input(_)) => return Err(error),
        Err(_) => return Ok(None),
    };
    let space = summary.summary().and_then(|summary| summary.space);
    let complete = matches!(outcome.ending, Ending::Complete) && tally.count > 0;
    let space = space.filter(|_| complete);
    Ok(space.map(|s| [tally.lag_mean_rad(), s.inner_contact_angle_mean_rad]))
}

/// Critical gap of the first raceway of a case at one of [`axial_points`]; `None` if there is none, or
/// the bearing does not bear the load.
///
/// # Errors
/// The case is impossible.
pub fn axial_critical_gap_rad(
    case: &Case,
    point: [f64; 2],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Option<f64>, CriticalGapError> {
    let first = case.raceways.iter().take(1);
    let alone = under(case, point).with_raceways(first.cloned().collect());
    let test = PairTest {
        tolerance_rad: GAP_TOLERANCE_RAD,
        ..PairTest::default()
    };
    match critical_gap_rad(&alone, &test, control) {
        Ok(gap) => Ok(Some(gap)),
        Err(
            error @ (CriticalGapError::Case(EquilibriumError::Input(_))
            | CriticalGapError::Interrupted),
        ) => Err(error),
        Err(_) => Ok(None),
    }
}

/// Axial load up to which the balls keep this share of the lag that they have without it, at no
/// tilt, by linear interpolation; `None` if they keep it under every load.
pub fn axial_load_keeping_n(lags: &[AxialLag], share: f64) -> Option<f64> {
    let straight: Vec<[f64; 2]> = lags
        .iter()
        .filter(|at| at.tilt_x_rad == 0.0)
        .map_while(|at| Some([at.axial_load_n, at.lag_and_angle_rad?[0]]))
        .collect();
    let least = share * straight.first()?[1];
    straight.windows(2).find_map(|pair| {
        let [[load, lag], [next_load, next_lag]] = [pair[0], pair[1]];
        (next_lag < least).then(|| load + (next_load - load) * (lag - least) / (lag - next_lag))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::structure;

    #[test]
    fn loads_that_keep_a_share_are_interpolated() {
        let at = |axial_load_n, tilt_x_rad, lag: Option<f64>| AxialLag {
            axial_load_n,
            tilt_x_rad,
            lag_and_angle_rad: lag.map(|lag| [lag, 0.0]),
            critical_gap_rad: None,
        };
        let lags = [
            at(0.0, 0.0, Some(2.0)),
            at(100.0, 0.0, Some(1.6)),
            at(200.0, 0.0, Some(0.8)),
            at(0.0, 1e-3, Some(0.1)),
            at(300.0, 0.0, None),
        ];
        for (share, expected) in [(0.75, 112.5), (0.5, 175.0)] {
            let load_n = axial_load_keeping_n(&lags, share).unwrap();
            assert!((load_n - expected).abs() < 1e-9, "{share}: {load_n}");
        }
        assert_eq!(axial_load_keeping_n(&lags, 0.0), None);
    }

    #[test]
    fn impossible_cases_are_refused() {
        let of = |change: fn(&mut Case)| {
            let mut case = structure(5.1, 25.2);
            change(&mut case);
            axial_points(&case).unwrap_err().to_string()
        };
        assert!(of(|c| c.raceways.clear()).contains("axial_span_m"));
        assert!(of(|c| c.operation.radial_load_n = 0.0).contains("radial_load_n"));
        assert!(of(|c| c.operation.space.axial_load_n = 1.0).contains("axial_load_n"));
        assert!(of(|c| c.formulation = crate::Formulation::Paper).contains("formulation"));
    }
}
