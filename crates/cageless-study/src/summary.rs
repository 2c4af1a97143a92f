//! `summary.json`.

use std::collections::BTreeMap;

use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_io::results::{SCHEMA, VERSION};
use serde::Serialize;

use crate::warnings::warnings;
use cageless_results::{Finished, LimitJudgement, RUN, Record, Results, Stopped, Subject};

/// The summary of a run. A number that is not finite becomes `null`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunSummary {
    /// Version of the layout, [`SCHEMA`].
    pub schema: u64,
    /// Version of Cageless.
    pub version: String,
    /// Instruction set.
    pub isa: String,
    /// The case as run, every default filled in.
    pub case: CaseDocument,
    /// Dotted keys of the case that took their default.
    pub defaults: Vec<String>,
    /// Scalar results.
    #[serde(flatten)]
    pub results: Results,
    /// Limits of a user on the results.
    #[serde(flatten)]
    pub limits: LimitJudgement,
    /// Terms of the energy ledger, J.
    pub energy: BTreeMap<String, f64>,
    /// Warnings of the run.
    pub warnings: Vec<String>,
    /// Numerical verification, if requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verification: Option<Record>,
    /// Reason of an early stop: the run left the physical range, or was interrupted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stopped: Option<Stopped>,
}

impl RunSummary {
    /// Summary of a run of `file`.
    pub fn new(file: &CaseFile, run: &Finished<'_>) -> Self {
        let outcome = run.outcome;
        let mut energy: BTreeMap<String, f64> = outcome
            .state
            .layout()
            .energy_terms()
            .iter()
            .map(|&term| (term.name().to_owned(), outcome.state.energy_term_j(term)))
            .collect();
        energy.insert(
            "change".to_owned(),
            outcome.end_energy_j - outcome.start_energy_j,
        );
        let results = Results::of(RUN, Subject::Run(run));
        Self {
            limits: LimitJudgement::of(&file.particulars().limits, &results),
            schema: SCHEMA,
            version: VERSION.to_owned(),
            isa: outcome.instruction_set.name().to_owned(),
            case: file.document_as_run(),
            defaults: file.defaults().to_vec(),
            results,
            energy,
            warnings: warnings(run),
            verification: None,
            stopped: Stopped::of(file.case(), outcome),
        }
    }

    /// Whether the passages of the run keep the limits; `None` if none was judged.
    pub fn passes(&self) -> Option<bool> {
        self.results.flag("passes")
    }

    /// Whether it works, with the verdict, the criterion that decides, and its margin.
    pub fn headline(&self) -> &str {
        self.results.text("headline")
    }

    /// The summary as indented JSON with a final line end.
    ///
    /// # Errors
    /// None that its fields can cause; those of the JSON writer are passed on.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self).map(|json| json + "\n")
    }
}
