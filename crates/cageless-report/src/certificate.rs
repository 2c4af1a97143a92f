//! How far the results of a run can be trusted.

use cageless::certificate::Verdict;
use cageless_io::results::{CertificateFile, CertificateNumber, rounded};
use serde::Serialize;

use crate::data::Provenance;
use crate::table::{Cell, Row, Table};

/// The certificate of a run as it is shown.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct CertificateTable {
    /// Predictability and balances, a sentence each.
    pub facts: Vec<String>,
    /// A row for each number.
    pub rows: Vec<CertificateRow>,
}

/// One number.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct CertificateRow {
    /// Its key in `summary.json`.
    pub name: String,
    /// Value as it is to be printed.
    pub value: String,
    /// Unit; may be empty.
    pub unit: String,
    /// `converged`, `statistical` or `neither`.
    pub verdict: String,
    /// Why, in numbers.
    pub reason: String,
    /// Whether the row is called out.
    pub marked: bool,
}

impl CertificateTable {
    /// Of the certificate of a summary.
    pub fn of(c: &CertificateFile) -> Self {
        Self {
            facts: facts(c)
                .into_iter()
                .map(|(name, fact)| format!("{name}: {fact}"))
                .collect(),
            rows: c
                .ranked()
                .into_iter()
                .map(|(name, number)| CertificateRow {
                    name: name.to_owned(),
                    value: value(number),
                    unit: number.unit.clone(),
                    verdict: number.verdict.clone(),
                    reason: number.reason.clone(),
                    marked: number.verdict == Verdict::Neither.name(),
                })
                .collect(),
        }
    }
}

/// The value to the digits that are known of it.
pub fn value(number: &CertificateNumber) -> String {
    let known = if number.verdict == Verdict::Converged.name() {
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

/// Predictability and balances: name and finding.
pub fn facts(c: &CertificateFile) -> [(&'static str, String); 4] {
    [
        (
            "verified",
            format!(
                "{} numbers converged, {} statistical, {} neither ({} starts, steps of {} and {} µs)",
                c.converged,
                c.statistical,
                c.neither,
                c.members,
                c.step_us,
                c.step_us / 2.0
            ),
        ),
        ("predictability", c.predictability.clone()),
        (
            "energy balance",
            format!(
                "{:.1e} of all flows missing, {:.1e} at half the step",
                c.energy_residual_relative, c.energy_residual_relative_half_step
            ),
        ),
        (
            "momentum balance",
            format!(
                "{:.1e} of all impulses missing, {:.1e} at half the step",
                c.momentum_residual_relative, c.momentum_residual_relative_half_step
            ),
        ),
    ]
}

/// The table of the certificate.
pub fn certificate_table(certificate: &CertificateTable, source: Provenance) -> Table {
    let text = |name: &str| (name.to_owned(), false);
    Table {
        label: "Certificate".to_owned(),
        caption: "Each number of the run, repeated from turned starts and at half the step. \
                  Converged: neither changes it by more than the tolerance. Statistical: it \
                  changes from start to start, and no more with the step. Neither: the step \
                  biases it."
            .to_owned(),
        columns: vec![
            text("Number"),
            ("Value".to_owned(), true),
            text("Unit"),
            text("Verdict"),
            text("Because"),
        ],
        rows: certificate
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
