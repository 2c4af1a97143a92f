//! A drop into several bearings with what is shown beside it.

use cageless::simulation::RotorDrop;
use cageless::touchdown::Scatter;
use cageless_io::case_file::CaseDocument;
use cageless_io::results::{SCHEMA, VERSION};
use cageless_io::rotor_file::RotorFile;
use serde::Serialize;

use super::several::drop_into_bearings;
use super::study::{Subject, beside};
use super::{
    DropRequest, DropResult, RotorEnsemble, RotorVerification, SeveralBearings, Study,
    rotor_ensemble,
};
use crate::StudyError;
use crate::progress::Progress;
use crate::run::{Rows, RunError};

/// A drop into several bearings with what is shown beside it.
pub type RotorStudy = Study<SeveralBearings, RotorEnsemble, RotorVerification>;

/// Drops the rotor of a file into its bearings, and whatever else is asked for; `rows` has a store
/// for each bearing, or none. What there is when the progress cancels is kept; a drop that does
/// not complete has nothing beside it.
///
/// # Errors
/// A bearing cannot start, or the last rows could not be stored.
pub fn rotor_study<'r>(
    file: &RotorFile,
    request: DropRequest,
    rows: Vec<Option<&'r mut (dyn Rows + Send + 'r)>>,
    progress: &dyn Progress,
) -> Result<RotorStudy, RunError> {
    let drop = drop_into_bearings(file.drop(), rows, progress)?;
    beside(file.drop(), drop, request, progress)
}

impl Subject for RotorDrop {
    type Drop = SeveralBearings;
    type Ensemble = RotorEnsemble;
    type Verification = RotorVerification;

    fn drop_conventional(&self, progress: &dyn Progress) -> Result<SeveralBearings, RunError> {
        let none = self.cases().iter().map(|_| None).collect();
        drop_into_bearings(&self.conventional(), none, progress)
    }

    fn scattered(&self, count: u64, progress: &dyn Progress) -> Result<RotorEnsemble, StudyError> {
        rotor_ensemble(self, count, &Scatter::default(), progress)
    }

    fn verified(
        &self,
        drop: &SeveralBearings,
        progress: &dyn Progress,
    ) -> Result<RotorVerification, StudyError> {
        RotorVerification::new(self, drop, progress)
    }
}

impl RotorStudy {
    /// Names and results of the bearings side by side, those with conventional outer rings last.
    pub fn columns(&self) -> Vec<(String, &DropResult)> {
        let other = self.conventional.iter();
        let conventional = other.flat_map(|drop| drop.columns(", conventional"));
        self.drop.columns("").chain(conventional).collect()
    }

    /// `summary.json` of the study of `file`.
    ///
    /// # Errors
    /// None that its fields can cause; those of the JSON writer are passed on.
    pub fn to_json(&self, file: &RotorFile) -> Result<String, serde_json::Error> {
        let rotor = file.drop().rotor();
        let records = &self.drop.bearings;
        let summary = Summary {
            schema: SCHEMA,
            version: VERSION,
            isa: records[0].outcome.instruction_set.name(),
            title: file.title(),
            rotor: RotorSummary {
                mass_kg: rotor.mass_kg(),
                polar_inertia_kg_m2: rotor.polar_inertia_kg_m2(),
                coordinates: rotor.coordinates(),
                mass_shares_kg: rotor.mass_shares_kg(),
                energy_residual_relative: self.drop.rotor_energy_residual_relative,
            },
            bearings: (file.bearings().iter().zip(records))
                .map(|(file, record)| BearingSummary {
                    case: file.document_as_run(),
                    drop: &record.result,
                })
                .collect(),
            conventional: self.conventional.as_ref().map(|other| {
                let records = other.bearings.iter();
                records.map(|record| &record.result).collect()
            }),
            ensemble: self.ensemble.as_ref(),
            verification: self.verification.as_ref(),
            warnings: &self.warnings,
        };
        serde_json::to_string_pretty(&summary).map(|json| json + "\n")
    }
}

/// `summary.json` of a drop into several bearings.
#[derive(Serialize)]
struct Summary<'a> {
    schema: u64,
    version: &'static str,
    isa: &'static str,
    title: &'a str,
    rotor: RotorSummary,
    bearings: Vec<BearingSummary<'a>>,
    /// Results of each bearing with conventional outer rings.
    #[serde(skip_serializing_if = "Option::is_none")]
    conventional: Option<Vec<&'a DropResult>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ensemble: Option<&'a RotorEnsemble>,
    #[serde(skip_serializing_if = "Option::is_none")]
    verification: Option<&'a RotorVerification>,
    warnings: &'a [String],
}

/// The rotor above its bearings.
#[derive(Serialize)]
struct RotorSummary {
    mass_kg: f64,
    polar_inertia_kg_m2: f64,
    coordinates: usize,
    mass_shares_kg: Vec<f64>,
    energy_residual_relative: f64,
}

/// One bearing: its case as one plane, and its results.
#[derive(Serialize)]
struct BearingSummary<'a> {
    case: CaseDocument,
    #[serde(flatten)]
    drop: &'a DropResult,
}
