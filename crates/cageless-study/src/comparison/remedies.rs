//! Remedies for colliding balls: a discrete raceway, fewer balls, or both.

use cageless_io::case_file::{CaseError, CaseFile};

use super::left_out::LeftOut;
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

/// Remedies for a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Remedies {
    /// Each with its name; the first is what the others are compared with.
    pub rings: Vec<(String, CaseFile)>,
    /// Remedies that the bearing does not take, with reasons.
    pub left_out: Vec<LeftOut>,
}

impl Remedies {
    /// The plain ring of a case first, then its raceway, one and two balls fewer, and its raceway with one ball fewer;
    /// of a case without a raceway what has none.
    ///
    /// # Errors
    /// The bearing does not take a plain ring.
    pub fn new(file: &CaseFile) -> Result<Self, StudyError> {
        let balls = file.case().bearing.balls();
        let plain = plain_ring(file)?;
        let mut all = Self {
            rings: vec![(format!("plain, {balls} balls"), plain.clone())],
            left_out: vec![],
        };
        if !file.case().raceways.is_empty() {
            all.rings
                .push((format!("raceway, {balls} balls"), file.clone()));
            all.add_fewer("raceway", file, 1);
        }
        for less in [1, 2] {
            all.add_fewer("plain", &plain, less);
        }
        Ok(all)
    }

    /// Adds a ring with so many balls less.
    fn add_fewer(&mut self, ring: &str, file: &CaseFile, less: usize) {
        let balls = file.case().bearing.balls().saturating_sub(less);
        let name = format!("{ring}, {balls} balls");
        match with_fewer_balls(file, less) {
            Ok(fewer) => self.rings.push((name, fewer)),
            Err(error) => self.left_out.push(LeftOut {
                name,
                why: error.to_string(),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use cageless_io::case_file::template;

    use super::*;

    /// A bearing of four balls has the remedy of one ball fewer, not that of two.
    #[test]
    fn too_few_balls_are_left_out() {
        let plain = CaseFile::parse(&template(true), "case", &[]).unwrap();
        let found = Remedies::new(&plain.with_balls(4).unwrap()).unwrap();
        let names: Vec<&str> = found.rings.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["plain, 4 balls", "plain, 3 balls"]);
        assert_eq!(found.left_out.len(), 1);
        assert!(found.left_out[0].why.contains("3 at least"), "{found:?}");
    }
}
