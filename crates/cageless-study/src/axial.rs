//! What axial load and tilt leave of the lag in the raceways of a case, point by point in parallel.

use cageless::critical_gap::CriticalGapError;
use cageless::design::{AxialLag, axial_critical_gap_rad, axial_lag, axial_points};
use cageless_io::case_file::CaseFile;
use rayon::prelude::*;

use crate::error::StudyError;
use crate::progress::Progress;

/// Name of the task of [`axial_lags`].
const TASK: &str = "axial load";
/// One point takes about as long as so many verdicts on a raceway.
const POINT_WORK: f64 = 6.0;
/// The part of it that the lag takes.
const LAG_WORK: f64 = 5.0;

/// The task of [`axial_lags`] with its work, for `Progress::whole`.
///
/// # Errors
/// The case cannot be computed, see [`axial_points`].
pub fn task(file: &CaseFile) -> Result<(String, f64), StudyError> {
    let points = file.checked(axial_points)?;
    Ok((TASK.to_owned(), POINT_WORK * points.len() as f64))
}

/// Lags and critical gaps at the points of [`axial_points`], in their order.
///
/// # Errors
/// The case cannot be computed, or the progress ended the work.
pub fn axial_lags(file: &CaseFile, progress: &dyn Progress) -> Result<Vec<AxialLag>, StudyError> {
    let points = file.checked(axial_points)?;
    let task = progress.begin(TASK, POINT_WORK * points.len() as f64);
    let lags: Result<Vec<AxialLag>, StudyError> = points
        .into_par_iter()
        .map(|point| {
            let case = file.case();
            let lag = axial_lag(case, point, &mut task.run_control(1.0, LAG_WORK));
            let lag = lag.map_err(|error| StudyError::of_run(file, error.into()))?;
            let mut control = task.run_control(1.0, POINT_WORK - LAG_WORK);
            if lag.lag_and_angle_rad.is_none() {
                return Ok(lag);
            }
            match axial_critical_gap_rad(case, point, &mut *control) {
                Ok(critical_gap_rad) => Ok(AxialLag {
                    critical_gap_rad,
                    ..lag
                }),
                Err(CriticalGapError::Interrupted) => Err(StudyError::Interrupted),
                Err(error) => Err(StudyError::of_run(file, error)),
            }
        })
        .collect();
    match progress.interrupted() {
        true => Err(StudyError::Interrupted),
        false => lags,
    }
}
