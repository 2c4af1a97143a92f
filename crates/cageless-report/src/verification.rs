//! Verification of a run or a drop on its page.

use cageless::verification::Convergence;
use cageless_results::{Record, table_of_judgements};
use cageless_study::lines;
use serde::{Deserialize, Serialize};

use crate::data::{Parameter, Provenance};
use crate::page::Page;
use crate::table::Table;

/// Verification as it is shown.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct VerificationTable {
    /// Step, replicas, predictability and balances.
    pub facts: Vec<Parameter>,
    /// The judgement of each result; the first row is the head.
    pub rows: Vec<Vec<String>>,
}

impl VerificationTable {
    /// A verification with the judgements `numbers`.
    pub fn new<'r>(verification: &Record, numbers: impl Iterator<Item = &'r Record>) -> Self {
        Self {
            facts: lines(verification.rows()),
            rows: table_of_judgements(numbers),
        }
    }

    /// Adds the tables to a page; `label` is that of the judgements.
    pub fn show(&self, page: &mut Page, label: &str, source: &Provenance) {
        let caption = "Repetitions from perturbed initial states and at half the step.";
        page.parameters(
            &format!("{label}: replicas"),
            caption,
            &self.facts,
            Some(source),
        );
        let caption = "Converged: neither perturbed initial states nor half the step change the \
                       result by more than the tolerance. Statistical: chaotic but statistically \
                       consistent, one sample of a distribution that does not depend on the step. \
                       Step-biased: it changes with the step by more than the scatter explains.";
        let mut table = Table::of(label, caption, self.rows.clone(), Some(source.clone()));
        for row in &mut table.rows {
            let biased = Convergence::StepBiased.name();
            row.marked = row.cells.iter().any(|text| text == biased);
        }
        page.table(&table);
    }
}
