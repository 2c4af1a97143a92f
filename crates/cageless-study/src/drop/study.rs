//! A drop with what is shown beside it.

use cageless::Case;
use cageless::simulation::Ending;
use cageless::touchdown::Scatter;
use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_io::results::{SCHEMA, VERSION};
use cageless_results::{DropResult, Record};
use serde::Serialize;

use super::verification::verify;
use super::{DropRecord, EnsembleResult, check_drops, check_rotor, drop_rotor, ensemble};
use crate::StudyError;
use crate::progress::Progress;
use crate::run::{Rows, RunError};
use crate::warnings::{of_drop, of_scattered};

/// What a study of a drop computes beside the drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct DropRequest {
    /// Whether the rotor drops onto the same bearings with conventional outer rings as well.
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
        self.check_samples()
    }

    /// Checks the number of drops.
    ///
    /// # Errors
    /// It is impossible.
    pub fn check_samples(&self) -> Result<(), StudyError> {
        self.samples.map_or(Ok(()), check_drops)
    }
}

/// A drop with what is shown beside it.
pub struct Study<D, E> {
    /// The drop.
    pub drop: D,
    /// The drop of the same rotor onto conventional outer rings.
    pub conventional: Option<D>,
    /// Scattered drops.
    pub ensemble: Option<E>,
    /// Verification of the drop.
    pub verification: Option<Record>,
    /// What the numbers do not show, and what no bearing stands; what was asked for and could not be
    /// computed, and why.
    pub warnings: Vec<String>,
    /// Whether the progress cancelled it.
    pub interrupted: bool,
}

/// A drop onto one bearing with what is shown beside it.
pub type DropStudy = Study<DropRecord, EnsembleResult>;

/// A drop that has ended.
pub trait Ended {
    /// How it ended.
    fn ending(&self) -> &Ending;
}

impl Ended for DropRecord {
    fn ending(&self) -> &Ending {
        &self.outcome.ending
    }
}

/// What is dropped: a rotor with its bearing, or with several.
pub(super) trait Subject {
    /// A drop of it.
    type Drop: Ended;
    /// Scattered drops of it.
    type Ensemble;

    /// Warnings of a drop of it.
    fn warnings(&self, drop: &Self::Drop) -> Vec<String>;

    /// Warnings of the worst of scattered drops of it.
    fn scattered_warnings(&self, ensemble: &Self::Ensemble) -> Vec<String>;

    /// Drops it onto conventional outer rings.
    fn drop_conventional(&self, progress: &dyn Progress) -> Result<Self::Drop, RunError>;

    /// Drops it `count` times under conditions that scatter.
    fn scattered(&self, count: u64, progress: &dyn Progress) -> Result<Self::Ensemble, StudyError>;

    /// Verifies a drop.
    fn verified(&self, drop: &Self::Drop, progress: &dyn Progress) -> Result<Record, StudyError>;
}

/// Study of a subject.
pub(super) type StudyOf<S> = Study<<S as Subject>::Drop, <S as Subject>::Ensemble>;

impl Subject for Case {
    type Drop = DropRecord;
    type Ensemble = EnsembleResult;

    fn warnings(&self, drop: &DropRecord) -> Vec<String> {
        of_drop(self, &drop.result)
    }

    fn scattered_warnings(&self, ensemble: &EnsembleResult) -> Vec<String> {
        let drops = ensemble.drops.iter();
        of_scattered(self, drops.map(|drop| (drop.index, &drop.bearing.result)))
    }

    fn drop_conventional(&self, progress: &dyn Progress) -> Result<DropRecord, RunError> {
        drop_rotor(&self.conventional(), None, progress)
    }

    fn scattered(&self, count: u64, progress: &dyn Progress) -> Result<EnsembleResult, StudyError> {
        ensemble(self, count, &Scatter::default(), progress)
    }

    fn verified(&self, drop: &DropRecord, progress: &dyn Progress) -> Result<Record, StudyError> {
        verify(self, &drop.result, progress)
    }
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
    let drop = drop_rotor(file.case(), rows, progress)?;
    beside(file.case(), drop, request, progress)
}

/// Computes what is asked for beside a drop.
pub(super) fn beside<S: Subject>(
    subject: &S,
    drop: S::Drop,
    request: DropRequest,
    progress: &dyn Progress,
) -> Result<StudyOf<S>, RunError> {
    let mut study = StudyOf::<S>::new(drop);
    study.warnings = subject.warnings(&study.drop);
    if !matches!(study.drop.ending(), Ending::Complete) {
        return Ok(study);
    }
    if request.compare {
        let other = subject.drop_conventional(progress)?;
        study.interrupted = matches!(other.ending(), Ending::Interrupted);
        study.conventional = Some(other);
    }
    if let (Some(count), false) = (request.samples, study.interrupted) {
        let done = subject.scattered(count, progress);
        study.ensemble = study.keep("the scattered drops", done);
        if let Some(ensemble) = &study.ensemble {
            study.warnings.extend(subject.scattered_warnings(ensemble));
        }
    }
    if request.verify && !study.interrupted {
        let done = subject.verified(&study.drop, progress);
        study.verification = study.keep("the verification", done);
    }
    Ok(study)
}

impl<D: Ended, E> Study<D, E> {
    /// A drop with nothing beside it.
    pub fn new(drop: D) -> Self {
        Self {
            interrupted: matches!(drop.ending(), Ending::Interrupted),
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
}

impl DropStudy {
    /// The drop onto one bearing, whose case is `case`, of a rotor in several.
    pub fn of_bearing(case: &Case, drop: DropRecord) -> Self {
        Self {
            warnings: of_drop(case, &drop.result),
            ..Self::new(drop)
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
    verification: Option<&'a Record>,
    warnings: &'a [String],
}
