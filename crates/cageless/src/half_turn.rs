//! Lag of the balls against rolling over the half of their orbit away from the load.
//!
//! The lag is the orbital speed of rolling times the time from ψ = 90° to 270°, less 180°, in the mean over all balls and
//! orbits; the film of a flooded bearing makes most of it. That speed is ωi Ri/(2 Rm) in the plane, in space the mean of
//! the balls at rest on plain raceways, under their contact angles.
//!
//! ```
//! use cageless::film::{Film, OilGrade};
//! use cageless::reference;
//! use cageless::simulation::{Control, run};
//! use cageless::summary::SummaryRecorder;
//!
//! let mut case = reference::conventional(); // Zhao 2022, Table 1
//! case.solver.duration_s = 0.02;
//! case.film = Some(Film::flooded(OilGrade::IsoVg10.at(60.0)));
//! let mut recorder = SummaryRecorder::new();
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! assert!(recorder.summary().unwrap().half_turn_lag_rad.unwrap() > 0.0);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use std::f64::consts::PI;

use crate::case::Case;
use crate::equilibrium::settle;
use crate::numerics::vector::PlaneVector;
use crate::simulation::{Control, Observer, ObserverError, StepView};

/// Follows a run with a film for the lag of its balls.
#[derive(Debug, Clone, Default)]
pub(crate) struct HalfTurnTracker {
    /// Orbital speed of rolling, rad/s.
    rolling_rad_s: f64,
    /// Time at which each ball passed ψ = 90°; NaN until then.
    entered_s: Vec<f64>,
    /// Y of each ball at the last step, m.
    height_m: Vec<f64>,
    lag_sum_rad: f64,
    passes: u64,
}

impl HalfTurnTracker {
    /// Tracker of a case with a film at constant speed; `None` of any other.
    pub(crate) fn new(case: &Case) -> Option<Self> {
        let followed = case.film.is_some() && case.has_constant_operation();
        followed.then(|| Self::of(case))
    }

    /// Tracker of a case at constant speed, dry or wet.
    fn of(case: &Case) -> Self {
        Self {
            rolling_rad_s: rolling_rad_s(case).unwrap_or(f64::NAN),
            entered_s: vec![f64::NAN; case.balls()],
            height_m: vec![f64::NAN; case.balls()],
            ..Self::default()
        }
    }

    /// Takes a step.
    #[inline]
    pub(crate) fn step(&mut self, view: &StepView<'_>) {
        let (PlaneVector { x, y }, step) = (view.positions(), view.step);
        for (k, before) in self.height_m.iter_mut().enumerate() {
            let height = y[k];
            if (*before < 0.0) != (height < 0.0) && !before.is_nan() {
                // The place of the crossing within the step.
                let part = *before / (*before - height);
                let time_s = step.t0_s + part * step.size_s();
                match x[k] > 0.0 {
                    true => self.entered_s[k] = time_s,
                    false if !self.entered_s[k].is_nan() => {
                        self.lag_sum_rad += self.rolling_rad_s * (time_s - self.entered_s[k]) - PI;
                        self.passes += 1;
                    }
                    false => {}
                }
            }
            *before = height;
        }
    }

    /// The lag in the mean, rad; `None` before the first half orbit.
    pub(crate) fn lag_rad(&self) -> Option<f64> {
        let lag_rad = self.lag_sum_rad / self.passes as f64;
        lag_rad.is_finite().then_some(lag_rad)
    }
}

/// Mean orbital speed of rolling of a case that oil supplies at constant speed, rad/s; `None` of any other.
pub(crate) fn rolling_with_film_rad_s(case: &Case) -> Option<f64> {
    let supplied = case.film.as_ref().is_some_and(|film| film.supply > 0.0);
    (supplied && case.has_constant_operation()).then(|| rolling_rad_s(case))?
}

/// Mean orbital speed of rolling, rad/s; `None` without an equilibrium.
fn rolling_rad_s(case: &Case) -> Option<f64> {
    let speeds_rad_s = settle(&case.conventional()).ok()?.orbit_speed_rad_s;
    Some(speeds_rad_s.iter().sum::<f64>() / speeds_rad_s.len() as f64)
}

/// Follows a run, dry or wet, from a time on.
pub struct HalfTurnRecorder {
    from_s: f64,
    tracker: HalfTurnTracker,
}

impl HalfTurnRecorder {
    /// Recorder of a case at constant speed, from `from_s` on.
    pub fn new(case: &Case, from_s: f64) -> Self {
        let tracker = HalfTurnTracker::of(case);
        Self { from_s, tracker }
    }

    /// The lag in the mean, rad; `None` before the first half orbit.
    pub fn lag_rad(&self) -> Option<f64> {
        self.tracker.lag_rad()
    }
}

impl Observer for HalfTurnRecorder {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        if view.step.t1_s > self.from_s {
            self.tracker.step(view);
        }
        Ok(Control::Continue(()))
    }
}
