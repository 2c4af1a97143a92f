//! The drop of a rotor into several touchdown bearings.

use cageless::simulation::{Ending, RotorDrop};
use cageless_io::case_file::CaseDocument;
use cageless_io::results::{SCHEMA, VERSION};
use cageless_io::rotor_file::RotorFile;
use serde::Serialize;

use super::{DropRecord, DropResult, watched};
use crate::progress::Progress;
use crate::run::{Rows, RunError};

/// A drop into several bearings with its record.
pub struct SeveralBearings {
    /// What each bearing went through.
    pub bearings: Vec<DropRecord>,
    /// What the energy ledger of the rotor alone lacks, over the sum of its absolute terms.
    pub rotor_energy_residual_relative: f64,
}

/// Drops a rotor into its bearings on the calling thread; `rows` has a store for each bearing, or
/// none.
///
/// # Errors
/// A bearing cannot start, or the last rows could not be stored. Everything else is an
/// [`Ending`] of the outcomes.
pub fn drop_into_bearings<'r>(
    drop: &RotorDrop,
    rows: Vec<Option<&'r mut (dyn Rows + Send + 'r)>>,
    progress: &dyn Progress,
) -> Result<SeveralBearings, RunError> {
    let cases: Vec<_> = drop.cases().iter().collect();
    let work = progress.begin("drop", 1.0);
    let mut control = work.run_control(cases[0].solver.duration_s, 1.0);
    let mut rotor_energy_residual_relative = 0.0;
    let bearings = watched(&cases, rows, |observers| {
        let outcome = drop.run(observers, &mut *control)?;
        rotor_energy_residual_relative = outcome.rotor_energy_residual_relative;
        Ok(outcome.bearings)
    })?;
    Ok(SeveralBearings {
        bearings,
        rotor_energy_residual_relative,
    })
}

impl SeveralBearings {
    /// Names and results of the bearings side by side, those with conventional outer rings last.
    pub fn columns<'a>(&'a self, conventional: Option<&'a Self>) -> Vec<(String, &'a DropResult)> {
        let of = |drop: &'a Self, note: &'static str| {
            let records = drop.bearings.iter().enumerate();
            records.map(move |(k, r)| (format!("bearing {}{note}", k + 1), &r.result))
        };
        let other = conventional.into_iter();
        of(self, "")
            .chain(other.flat_map(|drop| of(drop, ", conventional")))
            .collect()
    }

    /// The record of the bearing at which the drop ended: the one that stopped, or else the first.
    pub fn last(&self) -> &DropRecord {
        &self.bearings[self.last_index()]
    }

    /// [`Self::last`], taken out.
    pub fn into_last(mut self) -> DropRecord {
        self.bearings.swap_remove(self.last_index())
    }

    fn last_index(&self) -> usize {
        let mut endings = self.bearings.iter().map(|bearing| &bearing.outcome.ending);
        let stopped = endings.position(|ending| matches!(ending, Ending::Stopped(_)));
        stopped.unwrap_or(0)
    }

    /// Whether the drop ran to its end.
    pub fn completed(&self) -> bool {
        let mut endings = self.bearings.iter().map(|bearing| &bearing.outcome.ending);
        endings.all(|ending| matches!(ending, Ending::Complete))
    }

    /// Whether the drop was interrupted.
    pub fn interrupted(&self) -> bool {
        matches!(self.last().outcome.ending, Ending::Interrupted)
    }

    /// `summary.json` of the drop of the rotor of `file`, and of that onto conventional outer rings.
    ///
    /// # Errors
    /// None that its fields can cause; those of the JSON writer are passed on.
    pub fn to_json(
        &self,
        file: &RotorFile,
        conventional: Option<&Self>,
    ) -> Result<String, serde_json::Error> {
        let rotor = file.drop().rotor();
        let bearings = file.bearings().iter().zip(&self.bearings);
        let summary = Summary {
            schema: SCHEMA,
            version: VERSION,
            isa: self.bearings[0].outcome.instruction_set.name(),
            title: file.title(),
            rotor: RotorSummary {
                mass_kg: rotor.mass_kg(),
                polar_inertia_kg_m2: rotor.polar_inertia_kg_m2(),
                coordinates: rotor.coordinates(),
                mass_shares_kg: rotor.mass_shares_kg(),
                energy_residual_relative: self.rotor_energy_residual_relative,
            },
            bearings: bearings
                .map(|(file, record)| BearingSummary {
                    case: file.document_as_run(),
                    drop: &record.result,
                })
                .collect(),
            conventional: conventional.map(|other| {
                let records = other.bearings.iter();
                records.map(|record| &record.result).collect()
            }),
        };
        serde_json::to_string_pretty(&summary).map(|json| json + "\n")
    }
}

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
