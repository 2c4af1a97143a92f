//! Effect of discrete raceways under axial load and tilt, by motion in space.
//!
//! The lag of [`ContactAngleEstimate`](cageless::closed_forms::ContactAngleEstimate) is that of rolling; here the
//! balls of a case, evenly spaced and settled, move under axial loads and tilts with all friction, and the lag is what
//! they lose.

use super::verdict::steady_case;
use crate::critical_gap::{CriticalGapError, PairTest, critical_gap_rad, pair_steps};
use cageless::equilibrium::EquilibriumError;
use cageless::passage::{PassageRecorder, PassageTally};
use cageless::simulation::{Control, Ending, Stop, run};
use cageless::step_limits;
use cageless::summary::SummaryRecorder;
use cageless::{Allowed, InputError};
use cageless::{Case, Motion, Tilt};

/// Axial loads as fractions of the radial load.
const LOAD_RATIOS: [f64; 8] = [0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1.0];
/// Tilts about the horizontal axis, rad.
const TILTS_RAD: [f64; 5] = [-2e-3, -1e-3, 0.0, 1e-3, 2e-3];
/// Ball orbits discarded before the passages are counted, and counted.
pub const AXIAL_ORBITS: [f64; 2] = [8.0, 8.0];

/// Error of a critical gap in space.
const GAP_TOLERANCE_RAD: f64 = 2e-5;

/// Axial load and tilt under which the lag is found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AxialPoint {
    /// Fa.
    pub axial_load_n: f64,
    /// Tilt of the inner ring about X.
    pub tilt_x_rad: f64,
}

impl AxialPoint {
    /// An axial load at no tilt.
    pub fn untilted(axial_load_n: f64) -> Self {
        Self {
            axial_load_n,
            tilt_x_rad: 0.0,
        }
    }
}

/// Lag per pass and contact angle at the inner raceway, means over the balls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LagAndAngle {
    /// Lag per pass.
    pub lag_rad: f64,
    /// Contact angle at the inner raceway.
    pub inner_contact_angle_rad: f64,
}

/// Reason for a load and tilt without a lag.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoLag {
    /// No static equilibrium, or a contact left its groove.
    #[error("the bearing does not bear it: {0}")]
    NotBorne(String),
    /// The run left the physical range.
    #[error("the run stopped {}; {}", .0.reason(), .0.advice())]
    Stopped(Stop),
    /// No ball passed a raceway.
    #[error("no ball passed the raceway")]
    NoPassage,
}

impl From<Stop> for NoLag {
    fn from(stop: Stop) -> Self {
        match stop.cause.gives_way() {
            true => Self::NotBorne(stop.cause.to_string()),
            false => Self::Stopped(stop),
        }
    }
}

/// Lag of the balls under one axial load and tilt.
#[derive(Debug, Clone, PartialEq)]
pub struct AxialLag {
    /// Fa.
    pub axial_load_n: f64,
    /// Tilt of the inner ring about X.
    pub tilt_x_rad: f64,
    /// Lag and contact angle, or why there are none.
    pub lag: Result<LagAndAngle, NoLag>,
    /// Critical gap of the first raceway, or why there is none; `None` if it was not asked for.
    pub critical_gap_rad: Option<Result<f64, CriticalGapError>>,
}

/// Axial load, at no tilt, up to which balls keep a share of the lag.
#[derive(Debug, Clone, PartialEq)]
pub enum AxialLimit {
    /// Up to this load, N.
    Load(f64),
    /// Under every load of the list.
    EveryLoad,
    /// Under every load that the bearing bears, the last of the list being this, N.
    EveryLoadBorne(f64),
    /// Not known: a run has no lag.
    Unknown {
        /// Axial load of that run, N.
        axial_load_n: f64,
        /// Why it has none.
        reason: NoLag,
    },
}

impl AxialLimit {
    /// The load, if there is one.
    pub fn load_n(&self) -> Option<f64> {
        match self {
            Self::Load(load_n) => Some(*load_n),
            _ => None,
        }
    }
}

/// Axial loads and tilts for the raceways of a case: every load with each tilt.
///
/// # Errors
/// An [`InputError`] if the case has no raceway, carries no radial load, is not planar but for slots, cannot
/// move in space, or has too large a step for the heaviest axial load.
pub fn axial_points(case: &Case) -> Result<Vec<AxialPoint>, InputError> {
    case.check_planar_but_for_slots()?;
    case.check_constant_operation("--axial")?;
    let radial = case.operation.radial_load_n;
    if !(radial > 0.0) {
        let allowed = Allowed::Above(0.0, "axial loads are fractions of it");
        return Err(InputError {
            field: "radial_load_n",
            value: radial,
            allowed,
        });
    }
    if case.raceways.is_empty() {
        let rule = "given: axial loads are judged by the lag in the raceway";
        return Err(InputError::rule("axial_span_m", f64::NAN, rule));
    }
    under(case, AxialPoint::default()).check_motion()?;
    let loads = |tilt_x_rad| {
        LOAD_RATIOS.map(|ratio| AxialPoint {
            axial_load_n: ratio * radial,
            tilt_x_rad,
        })
    };
    let points: Vec<AxialPoint> = TILTS_RAD.into_iter().flat_map(loads).collect();
    for point in &points {
        step_limits::check(&under(case, *point))?;
    }
    Ok(points)
}

/// A case as it runs at one of [`axial_points`], and the steps that lag and critical gap take there as a rule.
pub fn axial_sample(case: &Case, point: AxialPoint) -> (Case, [f64; 2]) {
    let case = under(case, point);
    let steps = [case.solver.steps(), pair_steps(&case, &PairTest::default())];
    (case, steps)
}

/// The case, evenly spaced, under this axial load and tilt.
fn under(case: &Case, point: AxialPoint) -> Case {
    let mut loaded = steady_case(&Case {
        motion: Motion::Space,
        ..case.clone()
    });
    loaded.solver.duration_s = AXIAL_ORBITS.iter().sum::<f64>() * case.rolling_orbit_s();
    loaded.operation.space.axial_load_n = point.axial_load_n;
    loaded.operation.space.tilt = Tilt::Held {
        x_rad: point.tilt_x_rad,
        y_rad: 0.0,
    };
    loaded
}

/// Lag at one of [`axial_points`], after eight orbits of the balls over eight more. `control` is
/// called with the completed fraction.
///
/// # Errors
/// The case is impossible, or `control` ended the work.
pub fn axial_lag(
    case: &Case,
    point: AxialPoint,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<AxialLag, CriticalGapError> {
    Ok(AxialLag {
        axial_load_n: point.axial_load_n,
        tilt_x_rad: point.tilt_x_rad,
        lag: lag_and_angle(&under(case, point), control)?,
        critical_gap_rad: None,
    })
}

/// Lag per pass and contact angle at the inner raceway of a case in space.
fn lag_and_angle(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Result<LagAndAngle, NoLag>, CriticalGapError> {
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
        Err(error @ (EquilibriumError::Input(_) | EquilibriumError::Interrupted)) => {
            return Err(error.into());
        }
        Err(error) => return Ok(Err(NoLag::NotBorne(error.to_string()))),
    };
    match outcome.ending {
        Ending::Complete => {}
        Ending::Stopped(stop) => return Ok(Err(stop.into())),
        _ => return Err(CriticalGapError::Interrupted),
    }
    let space = summary.summary().and_then(|summary| summary.space);
    let space = space.filter(|_| tally.count > 0);
    let found = space.map(|s| LagAndAngle {
        lag_rad: tally.means().lag_rad,
        inner_contact_angle_rad: s.inner_contact_angle_mean_rad,
    });
    Ok(found.ok_or(NoLag::NoPassage))
}

/// Critical gap of the first raceway of a case at one of [`axial_points`], or why there is none.
///
/// # Errors
/// The case is impossible, or `control` ended the work.
pub fn axial_critical_gap_rad(
    case: &Case,
    point: AxialPoint,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Result<f64, CriticalGapError>, CriticalGapError> {
    let first = case.raceways.iter().take(1);
    let alone = under(case, point).with_raceways(first.cloned().collect());
    let test = PairTest {
        tolerance_rad: GAP_TOLERANCE_RAD,
        ..PairTest::default()
    };
    match critical_gap_rad(&alone, &test, control) {
        Err(
            error @ (CriticalGapError::Case(EquilibriumError::Input(_))
            | CriticalGapError::Interrupted),
        ) => Err(error),
        found => Ok(found),
    }
}

/// Axial load up to which the balls keep this share of the lag that they have without it, at no
/// tilt, by linear interpolation between neighbouring loads. A run without a lag ends the list: what lies
/// beyond is not known.
pub fn axial_load_keeping(lags: &[AxialLag], share: f64) -> AxialLimit {
    let mut last: Option<[f64; 2]> = None;
    let mut least = f64::NAN;
    for at in lags.iter().filter(|at| at.tilt_x_rad == 0.0) {
        let lag = match (&at.lag, last) {
            (Ok(found), _) => found.lag_rad,
            (Err(NoLag::NotBorne(_)), Some([borne_n, _])) => {
                return AxialLimit::EveryLoadBorne(borne_n);
            }
            (Err(reason), _) => {
                return AxialLimit::Unknown {
                    axial_load_n: at.axial_load_n,
                    reason: reason.clone(),
                };
            }
        };
        match last {
            None => least = share * lag,
            Some([load_n, before]) if lag < least => {
                let part = (before - least) / (before - lag);
                return AxialLimit::Load(load_n + (at.axial_load_n - load_n) * part);
            }
            Some(_) => {}
        }
        last = Some([at.axial_load_n, lag]);
    }
    AxialLimit::EveryLoad
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::structure;
    use cageless::simulation::Cause;

    fn stop(cause: Cause) -> Stop {
        Stop {
            time_s: 0.002,
            step_s: 1e-6,
            drop: false,
            automatic_step_s: 1e-6,
            cause,
        }
    }

    fn at(axial_load_n: f64, tilt_x_rad: f64, lag: Result<f64, NoLag>) -> AxialLag {
        AxialLag {
            axial_load_n,
            tilt_x_rad,
            lag: lag.map(|lag_rad| LagAndAngle {
                lag_rad,
                inner_contact_angle_rad: 0.0,
            }),
            critical_gap_rad: None,
        }
    }

    #[test]
    fn loads_that_keep_a_share_are_interpolated() {
        let lags = [
            at(0.0, 0.0, Ok(2.0)),
            at(100.0, 0.0, Ok(1.6)),
            at(200.0, 0.0, Ok(0.8)),
            at(0.0, 1e-3, Ok(0.1)),
        ];
        for (share, expected) in [(0.75, 112.5), (0.5, 175.0)] {
            let load_n = axial_load_keeping(&lags, share).load_n().unwrap();
            assert!((load_n - expected).abs() < 1e-9, "{share}: {load_n}");
        }
        assert_eq!(axial_load_keeping(&lags, 0.0), AxialLimit::EveryLoad);
    }

    /// A limit below the load of a run that stopped is known, one beyond it is not; a bearing that gives way
    /// has borne the loads before.
    #[test]
    fn no_limit_is_read_beyond_a_run_that_stopped() {
        let list = |end: NoLag| {
            [
                at(0.0, 0.0, Ok(2.0)),
                at(100.0, 0.0, Ok(1.2)),
                at(200.0, 0.0, Err(end)),
                at(300.0, 0.0, Ok(0.2)),
            ]
        };
        let stopped = NoLag::from(stop(Cause::NotFinite));
        let lags = list(stopped.clone());
        assert_eq!(axial_load_keeping(&lags, 0.75).load_n(), Some(62.5));
        let unknown = AxialLimit::Unknown {
            axial_load_n: 200.0,
            reason: stopped,
        };
        assert_eq!(axial_load_keeping(&lags, 0.5), unknown);
        let lags = list(NoLag::NotBorne("no equilibrium".to_owned()));
        assert_eq!(
            axial_load_keeping(&lags, 0.5),
            AxialLimit::EveryLoadBorne(100.0)
        );
        // Without a lag at no load there is nothing to keep a share of.
        let first = [at(0.0, 0.0, Err(NoLag::NoPassage)), at(100.0, 0.0, Ok(1.0))];
        let limit = axial_load_keeping(&first, 0.5);
        assert!(matches!(
            limit,
            AxialLimit::Unknown {
                axial_load_n: 0.0,
                ..
            }
        ));
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
        assert!(of(|c| c.formulation = cageless::Formulation::Paper).contains("formulation"));
    }
}
