//! Table of the verification of a run.

use cageless::verification::Convergence;
use cageless_io::results::{VerificationFile, VerificationNumber, rounded};
use serde::{Deserialize, Serialize};

use crate::data::Provenance;
use crate::table::{Cell, Row, Table};
use crate::text::short;

/// Verification of a run as a table.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct VerificationTable {
    /// Predictability and balances, a sentence each.
    pub facts: Vec<String>,
    /// Row of each result.
    pub rows: Vec<VerificationRow>,
}

/// Verification of one result as a table row.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct VerificationRow {
    /// Key of the result in `summary.json`.
    pub name: String,
    /// Value as printed.
    pub value: String,
    /// Unit; may be empty.
    pub unit: String,
    /// `converged`, `statistical` or `step-biased`.
    pub verdict: String,
    /// Reason with its numbers.
    pub reason: String,
    /// Whether the row is highlighted.
    pub marked: bool,
}

impl VerificationTable {
    /// Table of the verification of a summary.
    pub fn new(c: &VerificationFile) -> Self {
        Self {
            facts: facts(c)
                .into_iter()
                .map(|(name, fact)| format!("{name}: {fact}"))
                .collect(),
            rows: c
                .ranked()
                .into_iter()
                .map(|(name, number)| VerificationRow {
                    name: name.to_owned(),
                    value: value(number),
                    // A count has none.
                    unit: Some(&number.unit)
                        .filter(|unit| *unit != "1")
                        .cloned()
                        .unwrap_or_default(),
                    verdict: number.verdict.clone(),
                    reason: number.reason.clone(),
                    marked: number.verdict == Convergence::StepBiased.name(),
                })
                .collect(),
        }
    }
}

/// Value to its significant digits.
pub fn value(number: &VerificationNumber) -> String {
    let known = if number.verdict == Convergence::Converged.name() {
        number.tolerance
    } else {
        number.spread
    };
    if number.unit == "1" {
        format!("{}", number.value)
    } else {
        rounded(number.value, known)
    }
}

/// Counts, predictability and balances: name and finding.
pub fn facts(c: &VerificationFile) -> [(&'static str, String); 4] {
    [
        (
            "verification",
            format!(
                "{} results converged, {} chaotic but statistically consistent, {} step-size \
                 dependent ({} starts, steps of {} and {} µs)",
                c.converged,
                c.statistical,
                c.step_biased,
                c.replicas,
                c.step_us,
                c.step_us / 2.0
            ),
        ),
        ("predictability", c.predictability.clone()),
        (
            "energy balance",
            format!(
                "relative error {}, {} at half the step",
                short(c.energy_residual_relative),
                short(c.energy_residual_relative_half_step)
            ),
        ),
        (
            "momentum balance",
            format!(
                "relative error {}, {} at half the step",
                short(c.momentum_residual_relative),
                short(c.momentum_residual_relative_half_step)
            ),
        ),
    ]
}

/// Table of the verification.
pub fn verification_table(verification: &VerificationTable, source: Provenance) -> Table {
    let text = |name: &str| (name.to_owned(), false);
    Table {
        label: "Numerical verification".to_owned(),
        caption: "Results of the run repeated from perturbed initial states and at half the step. \
                  Converged: neither changes the result by more than the tolerance. \
                  Statistical: chaotic but statistically consistent, one sample of a distribution \
                  that does not depend on the step. Step-biased: step-size dependent."
            .to_owned(),
        columns: vec![
            text("Result"),
            ("Value".to_owned(), true),
            text("Unit"),
            text("Convergence"),
            text("Reason"),
        ],
        rows: verification
            .rows
            .iter()
            .map(|row| Row {
                cells: vec![
                    Cell::text(&row.name),
                    Cell::number(&row.value),
                    Cell::text(&row.unit),
                    Cell::text(&row.verdict),
                    Cell::text(&row.reason),
                ],
                marked: row.marked,
                summary: false,
            })
            .collect(),
        provenance: Some(source),
        ..Table::default()
    }
}
