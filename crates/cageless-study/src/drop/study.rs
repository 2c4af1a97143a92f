//! A drop with what is shown beside it.

use cageless::simulation::Ending;
use cageless::touchdown::Scatter;
use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_io::results::{SCHEMA, VERSION};
use serde::Serialize;

use super::{
    DropRecord, DropResult, DropVerification, EnsembleResult, check_drops, check_rotor, drop_rotor,
    ensemble,
};
use crate::StudyError;
use crate::progress::Progress;
use crate::run::{Rows, RunError};

/// What a study of a drop computes beside the drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct DropRequest {
    /// Whether the rotor drops onto the same bearing with a conventional outer ring as well.
    pub compare: bool,
    /// Number of drops with scattered conditions.
    pub samples: Option<u64>,
    /// Whether the drop is verified.
    pub verify: bool,
}

impl DropRequest {
    /// Checks that the drop of a case can be studied; `name` is what messages call the case.
    ///
    /// # Errors
    /// The case has no rotor, or the number of drops is impossible.
    pub fn check(&self, file: &CaseFile, name: &str) -> Result<(), StudyError> {
        check_rotor(file.case(), name)?;
        self.samples.map_or(Ok(()), check_drops)
    }
}

/// A drop with what is shown beside it.
pub struct DropStudy {
    /// The drop.
    pub drop: DropRecord,
    /// The same with a conventional outer ring.
    pub conventional: Option<DropRecord>,
    /// Scattered drops.
    pub ensemble: Option<EnsembleResult>,
    /// Verification of the drop.
    pub verification: Option<DropVerification>,
    /// What was asked for and could not be computed, and why.
    pub warnings: Vec<String>,
    /// Whether the progress cancelled it.
    pub interrupted: bool,
}

/// Drops the rotor of a case, and whatever else is asked for. What there is when the progress
/// cancels is kept; a drop that does not complete has nothing beside it.
///
/// # Errors
/// The case cannot start, or its rows could not be stored.
pub fn study(
    file: &CaseFile,
    request: DropRequest,
    rows: Option<&mut (dyn Rows + Send)>,
    progress: &dyn Progress,
) -> Result<DropStudy, RunError> {
    let case = file.case();
    let drop = drop_rotor(case, rows, progress)?;
    let mut study = DropStudy::new(drop);
    if !matches!(study.drop.outcome.ending, Ending::Complete) {
        return Ok(study);
    }
    if request.compare {
        let other = drop_rotor(&case.conventional(), None, progress)?;
        study.interrupted = matches!(other.outcome.ending, Ending::Interrupted);
        study.conventional = Some(other);
    }
    if let (Some(count), false) = (request.samples, study.interrupted) {
        let done = ensemble(case, count, &Scatter::default(), progress);
        study.ensemble = study.keep("the scattered drops", done);
    }
    if request.verify && !study.interrupted {
        let done = DropVerification::new(case, &study.drop.result, progress);
        study.verification = study.keep("the verification", done);
    }
    Ok(study)
}

impl DropStudy {
    /// A drop with nothing beside it.
    pub fn new(drop: DropRecord) -> Self {
        Self {
            interrupted: matches!(drop.outcome.ending, Ending::Interrupted),
            drop,
            conventional: None,
            ensemble: None,
            verification: None,
            warnings: vec![],
        }
    }

    /// A result, or the reason why there is none among the warnings.
    fn keep<T>(&mut self, what: &str, done: Result<T, StudyError>) -> Option<T> {
        match done {
            Ok(done) => Some(done),
            Err(error) => {
                self.interrupted |= matches!(error, StudyError::Interrupted);
                self.warnings.push(format!("{what}: {error}"));
                None
            }
        }
    }

    /// `summary.json` of the study of `file`.
    ///
    /// # Errors
    /// None that its fields can cause; those of the JSON writer are passed on.
    pub fn to_json(&self, file: &CaseFile) -> Result<String, serde_json::Error> {
        let summary = Summary {
            schema: SCHEMA,
            version: VERSION,
            isa: self.drop.outcome.instruction_set.name(),
            case: file.document_as_run(),
            drop: &self.drop.result,
            conventional: self.conventional.as_ref().map(|other| &other.result),
            ensemble: self.ensemble.as_ref(),
            verification: self.verification.as_ref(),
            warnings: &self.warnings,
        };
        serde_json::to_string_pretty(&summary).map(|json| json + "\n")
    }
}

/// `summary.json` of a drop.
#[derive(Serialize)]
struct Summary<'a> {
    schema: u64,
    version: &'static str,
    isa: &'static str,
    case: CaseDocument,
    #[serde(flatten)]
    drop: &'a DropResult,
    #[serde(skip_serializing_if = "Option::is_none")]
    conventional: Option<&'a DropResult>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ensemble: Option<&'a EnsembleResult>,
    #[serde(skip_serializing_if = "Option::is_none")]
    verification: Option<&'a DropVerification>,
    warnings: &'a [String],
}
