//! A drop into several bearings with what is shown beside it.

use cageless::simulation::RotorDrop;
use cageless::touchdown::Scatter;
use cageless_io::case_file::CaseDocument;
use cageless_io::results::{SCHEMA, VERSION};
use cageless_io::rotor_file::RotorFile;
use serde::Serialize;

use super::rotor_verification::verify;
use super::several::drop_into_bearings;
use super::study::{Subject, beside};
use super::{DropRequest, RotorEnsemble, SeveralBearings, Study, rotor_ensemble};
use crate::StudyError;
use crate::progress::Progress;
use crate::run::{Rows, RunError};
use crate::warnings::{of_drop, of_scattered};
use cageless_results::{DropResult, Record, number_text::short, plane_records};

/// A drop into several bearings with what is shown beside it.
pub type RotorStudy = Study<SeveralBearings, RotorEnsemble>;

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

    fn warnings(&self, drop: &SeveralBearings) -> Vec<String> {
        let mut warnings = unloaded(self);
        for (k, (case, record)) in self.cases().iter().zip(&drop.bearings).enumerate() {
            let own = of_drop(case, &record.result).into_iter();
            warnings.extend(own.map(|text| in_bearing(k, &text)));
        }
        warnings
    }

    fn scattered_warnings(&self, ensemble: &RotorEnsemble) -> Vec<String> {
        let mut warnings = vec![];
        for (k, case) in self.cases().iter().enumerate() {
            let drops = ensemble.drops.iter();
            let drops = drops.map(|drop| (drop.index, &drop.bearings[k].result));
            let own = of_scattered(case, drops).into_iter();
            warnings.extend(own.map(|text| in_bearing(k, &text)));
        }
        warnings
    }

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
    ) -> Result<Record, StudyError> {
        verify(self, drop, progress)
    }
}

fn in_bearing(k: usize, text: &str) -> String {
    format!("bearing {}: {text}", k + 1)
}

/// Warnings of bearings that carry nothing of a rotor at rest, or hold it down.
pub fn unloaded(drop: &RotorDrop) -> Vec<String> {
    let shares = drop.rotor().mass_shares_kg().into_iter();
    let shares = shares.zip(drop.carried_n()).enumerate();
    let unloaded = shares.filter(|(_, (_, carried_n))| carried_n.is_none());
    unloaded
        .map(|(k, (share_kg, _))| {
            let what = match share_kg < -1e-9 * drop.rotor().mass_kg() {
                true => format!(
                    "the rotor pulls it upwards, with {} kg: the mass centre is not between the \
                     bearings, and the rotor tips over at rest",
                    short(-share_kg)
                ),
                false => "it carries nothing of the rotor at rest: the mass centre is at another \
                          bearing"
                    .to_owned(),
            };
            in_bearing(
                k,
                &format!("{what}; its forces have no weight to be compared with"),
            )
        })
        .collect()
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
        let judgement = self.drop.judgement();
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
            verdict: judgement.name(),
            passes: judgement.passes,
            headline: judgement.headline(),
            reasons: &judgement.reasons,
            clearances: plane_records(&self.drop.planes),
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
    verdict: &'static str,
    passes: Option<bool>,
    headline: String,
    reasons: &'a [String],
    clearances: Vec<Record>,
    bearings: Vec<BearingSummary<'a>>,
    /// Results of each bearing with conventional outer rings.
    #[serde(skip_serializing_if = "Option::is_none")]
    conventional: Option<Vec<&'a DropResult>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ensemble: Option<&'a RotorEnsemble>,
    #[serde(skip_serializing_if = "Option::is_none")]
    verification: Option<&'a Record>,
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
