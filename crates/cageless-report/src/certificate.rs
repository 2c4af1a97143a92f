//! How far the results of a run can be trusted.

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
