//! Remedies for colliding balls: a discrete raceway, fewer balls, or both.

use cageless_io::case_file::{CaseError, CaseFile};

use crate::error::StudyError;

/// Balls of the smallest bearing.
const FEWEST: usize = 3;

/// The case with a conventional outer ring, itself if it has one.
///
/// # Errors
/// A [`CaseError`] if the case is not possible without its raceways.
pub(crate) fn plain_ring(file: &CaseFile) -> Result<CaseFile, CaseError> {
    match file.case().raceways.is_empty() {
        true => Ok(file.clone()),
        false => file.with_conventional_ring(),
    }
}

/// The case with so many balls less.
///
/// # Errors
/// Too few balls are left, or the case is not possible with them.
pub(crate) fn with_fewer_balls(file: &CaseFile, less: usize) -> Result<CaseFile, StudyError> {
    let balls = file.case().bearing.balls();
    if balls < FEWEST + less {
        return Err(StudyError::Input(format!(
            "bearing.balls = {balls}: with {less} fewer too few are left to compare with, {FEWEST} at least"
        )));
    }
    Ok(file.with_balls(balls - less)?)
}

/// The plain ring of a case first, then its raceway, one and two balls fewer, and its raceway with one ball fewer;
/// of a case without a raceway what has none.
///
/// # Errors
/// The bearing does not take the balls.
pub fn remedies(file: &CaseFile) -> Result<Vec<(String, CaseFile)>, StudyError> {
    let balls = file.case().bearing.balls();
    let plain = plain_ring(file)?;
    let mut all = vec![(format!("plain, {balls} balls"), plain.clone())];
    if !file.case().raceways.is_empty() {
        all.push((format!("raceway, {balls} balls"), file.clone()));
        let fewer = with_fewer_balls(file, 1)?;
        all.push((format!("raceway, {} balls", balls - 1), fewer));
    }
    for less in [1, 2] {
        let fewer = with_fewer_balls(&plain, less)?;
        all.push((format!("plain, {} balls", balls - less), fewer));
    }
    Ok(all)
}
