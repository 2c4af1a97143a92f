//! Lag in the raceways of a case under axial load and tilt, point by point in parallel.

use cageless_design::critical_gap::CriticalGapError;
use cageless_design::{
    AxialLag, AxialLimit, axial_critical_gap_rad, axial_lag, axial_load_keeping, axial_points,
    axial_sample,
};
use cageless_io::case_file::CaseFile;
use rayon::prelude::*;

use crate::error::StudyError;
use crate::progress::Progress;
use crate::task::Task;
use crate::threads::each_of;

/// Name of the task of [`axial_lags`].
const TASK: &str = "axial load";
/// The task of [`axial_lags`], for `Progress::whole`.
///
/// # Errors
/// The case cannot be computed, see [`axial_points`].
pub fn task(file: &CaseFile) -> Result<Task, StudyError> {
    let points = file.checked(axial_points)?;
    let (sample, steps) = axial_sample(file.case(), points[0]);
    let all = points.len() as f64 * steps.iter().sum::<f64>();
    Ok(Task::new(TASK).with(&sample, all, points.len()))
}

/// Lags and critical gaps at the points of [`axial_points`], in their order.
///
/// # Errors
/// The case cannot be computed, or the progress ended the work.
pub fn axial_lags(file: &CaseFile, progress: &dyn Progress) -> Result<Vec<AxialLag>, StudyError> {
    let points = file.checked(axial_points)?;
    let task = progress.begin(TASK, self::task(file)?.steps());
    let lags: Result<Vec<AxialLag>, StudyError> = each_of(points)
        .map(|point| {
            let case = file.case();
            let (_, [lag_steps, gap_steps]) = axial_sample(case, point);
            let lag = axial_lag(case, point, &mut task.run_control(1.0, lag_steps));
            let lag = lag.map_err(|error| of_run(file, error))?;
            let mut control = task.run_control(1.0, gap_steps);
            if lag.lag.is_err() {
                return Ok(lag);
            }
            let gap = axial_critical_gap_rad(case, point, &mut *control);
            Ok(AxialLag {
                critical_gap_rad: Some(gap.map_err(|error| of_run(file, error))?),
                ..lag
            })
        })
        .collect();
    match progress.interrupted() {
        true => Err(StudyError::Interrupted),
        false => lags,
    }
}

/// Whether a limit under axial load is not known because a run has no lag.
pub fn stops_a_limit(lags: &[AxialLag]) -> bool {
    // Where any limit is unknown the smallest share is.
    matches!(axial_load_keeping(lags, 0.0), AxialLimit::Unknown { .. })
}

fn of_run(file: &CaseFile, error: CriticalGapError) -> StudyError {
    match error {
        CriticalGapError::Interrupted => StudyError::Interrupted,
        error => StudyError::of_run(file, error),
    }
}
