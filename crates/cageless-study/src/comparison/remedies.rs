//! Remedies for colliding balls: a discrete raceway, fewer balls, or both.

use cageless_io::case_file::{CaseError, CaseFile};

/// The plain ring of a case first, then its raceway, one and two balls fewer, and its raceway with one ball fewer;
/// of a case without a raceway what has none.
///
/// # Errors
/// A [`CaseError`] if a bearing does not take the balls.
pub fn remedies(file: &CaseFile) -> Result<Vec<(String, CaseFile)>, CaseError> {
    let balls = file.case().bearing.balls();
    let conventional = if file.case().raceways.is_empty() {
        file.clone()
    } else {
        file.with_conventional_ring()?
    };
    let fewer =
        |file: &CaseFile, less: usize| -> Result<_, CaseError> { file.with_balls(balls - less) };
    let mut all = vec![(format!("plain, {balls} balls"), conventional.clone())];
    if !file.case().raceways.is_empty() {
        all.push((format!("raceway, {balls} balls"), file.clone()));
        all.push((format!("raceway, {} balls", balls - 1), fewer(file, 1)?));
    }
    all.push((
        format!("plain, {} balls", balls - 1),
        fewer(&conventional, 1)?,
    ));
    all.push((
        format!("plain, {} balls", balls - 2),
        fewer(&conventional, 2)?,
    ));
    Ok(all)
}
