//! A ring that has been measured: its raceways from points of its surface.

use std::path::Path;

use cageless::surface::{MeasuredGroove, MeasuredSlot};
use cageless::{Case, InputError};
use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_io::point_file::read_points;
use cageless_results::{FittedRaceway, GROOVE, PROFILE, Part, Record, Results, SLOT, Subject};

use crate::error::StudyError;

/// Intervals of a profile between the middle of a raceway and its end.
const INTERVALS: usize = 24;

/// A case with the raceways that were measured.
#[derive(Debug, Clone)]
pub struct Measured {
    /// The case with their profiles, or the dimensions of slots, in the place of its raceways.
    pub file: CaseFile,
    /// Its document.
    pub document: CaseDocument,
    /// Points, deviations and profile or dimensions of each, `raceways`.
    pub record: Record,
}

/// A raceway that was measured.
enum Fitted {
    Groove(MeasuredGroove),
    Slot(MeasuredSlot),
}

impl Fitted {
    fn of(case: &Case, index: usize, points_m: &[[f64; 3]]) -> Result<Self, InputError> {
        match case.raceways[index].slot() {
            Some(_) => MeasuredSlot::fit(case, index, points_m).map(Self::Slot),
            None => MeasuredGroove::fit(case, index, points_m).map(Self::Groove),
        }
    }

    fn enter(&self, document: &mut CaseDocument, index: usize) {
        match self {
            Self::Groove(groove) => {
                document.enter_profile(index, &groove.rows(INTERVALS), groove.depth_error_m());
            }
            Self::Slot(slot) => document.enter_slot(index, slot),
        }
    }

    fn results(&self) -> Results {
        let (deviation, depth_error_m) = match self {
            Self::Groove(groove) => (groove.deviation(), groove.depth_error_m()),
            Self::Slot(slot) => (slot.deviation, slot.depth_error_m),
        };
        let fitted = FittedRaceway {
            deviation,
            depth_error_m,
        };
        let results = Results::of(GROOVE, Subject::Points(&fitted));
        match self {
            Self::Groove(_) => results,
            Self::Slot(slot) => results.and(Results::of(SLOT, Subject::Slot(slot))),
        }
    }
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
    let mut fitted = vec![];
    for index in 0..case.raceways.len() {
        let raceway = Fitted::of(case, index, &found).map_err(|e| {
            StudyError::Input(format!(
                "{}: {} points of raceway {} are not possible: they must be {}; coordinates are in mm",
                points.display(),
                e.value,
                index + 1,
                e.allowed
            ))
        })?;
        raceway.enter(&mut document, index);
        fitted.push(raceway);
    }
    let file = CaseFile::from_document(document.clone(), name)?;
    let raceways = file.case().raceways.iter();
    let records = fitted.iter().zip(raceways).map(|(fitted, raceway)| {
        let mut results = fitted.results();
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
