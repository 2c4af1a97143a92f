//! `summary.json` of the study of a drop.

use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseDocument;
use cageless_io::results::{SCHEMA, VERSION};
use cageless_results::{DropResult, Record, plane_records};
use serde::Serialize;

use super::{Bearings, DropBenefit, DropRecord, DropStudy, Ensemble};

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
        let summary = Summary {
            schema: SCHEMA,
            version: VERSION,
            isa: records[0].outcome.instruction_set.name(),
            rotor: self.rotor(file),
            bearings: Bearings::new(&self.drop, bearings),
            conventional: self.conventional.as_ref().map(OfBearings::results),
            ensemble: self.ensemble.as_ref(),
            benefit: self.benefit.as_ref(),
            succession: &self.succession.records,
            verification: self.verification.as_ref(),
            warnings: &self.warnings,
        };
        serde_json::to_string_pretty(&summary).map(|json| json + "\n")
    }

    fn rotor<'a>(&'a self, file: &'a BearingArrangement) -> Option<Rotor<'a>> {
        let rotor = self.drop.rotor()?;
        let outcome = self.record.rotor.as_ref()?;
        let judgement = &self.judgement;
        Some(Rotor {
            title: file.title(),
            rotor: RotorNumbers {
                mass_kg: rotor.mass_kg(),
                polar_inertia_kg_m2: rotor.polar_inertia_kg_m2(),
                coordinates: rotor.coordinates(),
                mass_shares_kg: rotor.mass_shares_kg(),
                energy_residual_relative: outcome.energy_residual_relative,
            },
            verdict: judgement.name(),
            passes: judgement.passes(),
            headline: judgement.headline(),
            reasons: judgement.reasons(),
            clearances: plane_records(&outcome.planes),
        })
    }
}

/// `summary.json` of the study of a drop.
#[derive(Serialize)]
struct Summary<'a> {
    schema: u64,
    version: &'static str,
    isa: &'static str,
    #[serde(flatten)]
    rotor: Option<Rotor<'a>>,
    #[serde(flatten)]
    bearings: Bearings<Bearing<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    conventional: Option<OfBearings<'a>>,
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

/// A linear rotor and the verdict on its drop.
#[derive(Serialize)]
struct Rotor<'a> {
    title: &'a str,
    rotor: RotorNumbers,
    verdict: &'static str,
    passes: Option<bool>,
    headline: String,
    reasons: Vec<String>,
    clearances: Vec<Record>,
}

/// The numbers of a linear rotor.
#[derive(Serialize)]
struct RotorNumbers {
    mass_kg: f64,
    polar_inertia_kg_m2: f64,
    coordinates: usize,
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

/// Results of the bearings: those of the only one of a case, or a list.
#[derive(Serialize)]
#[serde(untagged)]
enum OfBearings<'a> {
    Case(&'a DropResult),
    Rotor(Vec<&'a DropResult>),
}

impl<'a> OfBearings<'a> {
    fn results(record: &'a DropRecord) -> Self {
        match record.rotor {
            None => Self::Case(&record.bearings[0].result),
            Some(_) => Self::Rotor(record.bearings.iter().map(|b| &b.result).collect()),
        }
    }
}
