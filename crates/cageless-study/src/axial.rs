//! What axial load and tilt leave of the lag in the raceways of a case, point by point in parallel.

use cageless::design::{AxialLag, axial_lag, axial_points};
use cageless_io::case_file::CaseFile;
use rayon::prelude::*;

use crate::error::StudyError;
use crate::progress::Progress;

/// Name of the task of [`axial_lags`].
const TASK: &str = "axial load";
/// One point takes about as long as so many verdicts on a raceway.
const POINT_WORK: f64 = 5.0;

/// The task of [`axial_lags`] with its work, for `Progress::whole`.
///
/// # Errors
/// The case cannot be computed, see [`axial_points`].
pub fn task(file: &CaseFile) -> Result<(String, f64), StudyError> {
    let points = file.checked(axial_points)?;
    Ok((TASK.to_owned(), POINT_WORK * points.len() as f64))
}

/// Lags at the points of [`axial_points`], in their order.
///
/// # Errors
/// The case cannot be computed, or the progress ended the work.
pub fn axial_lags(file: &CaseFile, progress: &dyn Progress) -> Result<Vec<AxialLag>, StudyError> {
    let points = file.checked(axial_points)?;
    let task = progress.begin(TASK, POINT_WORK * points.len() as f64);
    let lags: Result<Vec<AxialLag>, StudyError> = points
        .into_par_iter()
        .map(|point| {
            let lag = axial_lag(file.case(), point, &mut task.run_control(1.0, POINT_WORK));
            lag.map_err(|error| StudyError::of_run(file, error.into()))
        })
        .collect();
    match progress.interrupted() {
        true => Err(StudyError::Interrupted),
        false => lags,
    }
}
