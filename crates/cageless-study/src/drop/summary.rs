//! `summary.json` of the study of a drop.

use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseDocument;
use cageless_io::results::{SCHEMA, VERSION};
use cageless_results::{DropResult, Record, plane_records};
use serde::Serialize;

use super::{DropBenefit, DropRecord, DropStudy, Ensemble};

impl DropStudy {
    /// `summary.json` of the study of the drop of `file`.
    ///
    /// # Errors
    /// None that its fields can cause; those of the JSON writer are passed on.
    pub fn to_json(&self, file: &BearingArrangement) -> Result<String, serde_json::Error> {
        let records = &self.record.bearings;
        let bearings = file
            .cases()
            .iter()
            .zip(records)
            .map(|(file, record)| Bearing {
                case: file.document_as_run(),
                defaults: file.defaults(),
                result: &record.result,
            });
        let judgement = &self.judgement;
        let summary = Summary {
            schema: SCHEMA,
            version: VERSION,
            isa: records[0].outcome.instruction_set.name(),
            file: file.kind(),
            title: file.title(),
            rotor: self.rotor(),
            verdict: judgement.name(),
            passes: judgement.passes(),
            headline: judgement.headline(),
            reasons: judgement.reasons(),
            clearances: plane_records(&self.record.rotor.planes),
            bearings: bearings.collect(),
            conventional: self.conventional.as_ref().map(Conventional::of),
            ensemble: self.ensemble.as_ref(),
            benefit: self.benefit.as_ref(),
            succession: &self.succession.records,
            verification: self.verification.as_ref(),
            warnings: &self.warnings,
        };
        serde_json::to_string_pretty(&summary).map(|json| json + "\n")
    }

    fn rotor(&self) -> Rotor {
        let linear = self.drop.rotor();
        let of_case = self.drop.cases()[0].rotor.as_ref();
        let of_case = |value: fn(&cageless::Rotor) -> f64| of_case.map_or(0.0, value);
        let mass_kg = linear.map_or(of_case(|rotor| rotor.mass_kg), |rotor| rotor.mass_kg);
        Rotor {
            mass_kg,
            polar_inertia_kg_m2: of_case(|rotor| rotor.polar_inertia_kg_m2),
            coordinates: linear.map(|rotor| rotor.coordinates()),
            mass_shares_kg: linear.map_or(vec![mass_kg], |rotor| rotor.mass_shares_kg()),
            energy_residual_relative: self.record.rotor.energy_residual_relative,
        }
    }
}

/// `summary.json` of the study of a drop.
#[derive(Serialize)]
struct Summary<'a> {
    schema: u64,
    version: &'static str,
    isa: &'static str,
    /// Kind of the file with the rotor.
    file: &'static str,
    title: &'a str,
    rotor: Rotor,
    verdict: &'static str,
    passes: Option<bool>,
    headline: String,
    reasons: Vec<String>,
    clearances: Vec<Record>,
    bearings: Vec<Bearing<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    conventional: Option<Conventional<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ensemble: Option<&'a Ensemble>,
    #[serde(skip_serializing_if = "Option::is_none")]
    benefit: Option<&'a DropBenefit>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    succession: &'a [Record],
    #[serde(skip_serializing_if = "Option::is_none")]
    verification: Option<&'a Record>,
    warnings: &'a [String],
}

/// The numbers of a rotor.
#[derive(Serialize)]
struct Rotor {
    mass_kg: f64,
    polar_inertia_kg_m2: f64,
    /// Number of coordinates of a linear rotor.
    coordinates: Option<usize>,
    mass_shares_kg: Vec<f64>,
    energy_residual_relative: f64,
}

/// One bearing: its case, below a linear rotor as one plane, what of it took its default, and its results.
#[derive(Serialize)]
struct Bearing<'a> {
    case: CaseDocument,
    defaults: &'a [String],
    #[serde(flatten)]
    result: &'a DropResult,
}

/// Drop of the rotor onto conventional outer rings.
#[derive(Serialize)]
struct Conventional<'a> {
    bearings: Vec<&'a DropResult>,
}

impl<'a> Conventional<'a> {
    fn of(record: &'a DropRecord) -> Self {
        let results = record.bearings.iter().map(|bearing| &bearing.result);
        Self {
            bearings: results.collect(),
        }
    }
}
