//! A ring that has been measured: its raceways from points of its surface.

use std::path::Path;

use cageless::surface::MeasuredGroove;
use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_io::point_file::read_points;
use cageless_results::{GROOVE, PROFILE, Part, Record, Results, Subject};

use crate::error::StudyError;

/// Intervals of a profile between the middle of a raceway and its end.
const INTERVALS: usize = 24;

/// A case with the raceways that were measured.
#[derive(Debug, Clone)]
pub struct Measured {
    /// The case with their profiles in the place of its raceways.
    pub file: CaseFile,
    /// Its document.
    pub document: CaseDocument,
    /// Points, deviations and profile of each, `raceways`.
    pub record: Record,
}

/// Fits the raceways of a case, which messages call `name`, to the points in a file.
///
/// # Errors
/// The case has no raceway, the file cannot be read, or its points do not give a raceway.
pub fn measured(file: &CaseFile, name: &str, points: &Path) -> Result<Measured, StudyError> {
    let case = file.case();
    if case.raceways.is_empty() {
        let why = "has no [raceway], whose half angle and centre say where the points of one lie";
        return Err(StudyError::Input(format!("{name}: {why}")));
    }
    let found = read_points(points).map_err(StudyError::Input)?;
    let mut document = file.document().clone();
    let mut grooves = vec![];
    for index in 0..case.raceways.len() {
        let groove = MeasuredGroove::fit(case, index, &found).map_err(|e| {
            StudyError::Input(format!(
                "{}: {} points of raceway {} are not possible: they must be {}; coordinates are in mm",
                points.display(),
                e.value,
                index + 1,
                e.allowed
            ))
        })?;
        document.enter_profile(index, &groove.rows(INTERVALS));
        grooves.push(groove);
    }
    let file = CaseFile::from_document(document.clone(), name)?;
    let raceways = file.case().raceways.iter();
    let records = grooves.iter().zip(raceways).map(|(groove, raceway)| {
        let mut results = Results::of(GROOVE, Subject::Groove(groove));
        if let Some(profile) = &raceway.form().measured {
            results = results.and(Results::of(PROFILE, Subject::Profile(profile)));
        }
        Record::from(results)
    });
    Ok(Measured {
        record: Record::default().with_part("raceways", Part::Many(records.collect())),
        document,
        file,
    })
}
