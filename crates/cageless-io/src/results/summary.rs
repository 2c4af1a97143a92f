//! `summary.json`.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;

use super::certificate::CertificateFile;
use super::error::ResultError;
use super::partial::write_atomically;
use crate::case_file::CaseDocument;

/// The summary of a run. A number that is not finite becomes `null`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SummaryFile {
    /// Version of the layout, [`super::SCHEMA`].
    pub schema: u64,
    /// Version of Cageless.
    pub version: String,
    /// Instruction set.
    pub isa: String,
    /// The case as run, every default filled in.
    pub case: CaseDocument,
    /// Dotted keys of the case that took their default.
    pub defaults: Vec<String>,
    /// Number of collisions between balls.
    pub collisions: u64,
    /// Smallest gap.
    pub gap_min_deg: f64,
    /// Largest gap.
    pub gap_max_deg: f64,
    /// Mean place of the inner ring.
    pub ring_x_um_mean: f64,
    /// Mean place of the inner ring.
    pub ring_y_um_mean: f64,
    /// Largest sliding speed at a raceway.
    pub slip_max_m_s: f64,
    /// What the energy ledger misses, relative to the energy turned over.
    pub energy_residual_relative: f64,
    /// Terms of the energy ledger, J.
    pub energy: BTreeMap<String, f64>,
    /// Steps taken.
    pub steps: u64,
    /// Evaluations of the right-hand side.
    pub rhs_evaluations: u64,
    /// Time that the computation took.
    pub wall_s: f64,
    /// The statistics cover the run from here on.
    pub settled_after_s: f64,
    /// What the user should know.
    pub warnings: Vec<String>,
    /// How far the numbers can be trusted, if that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub certificate: Option<CertificateFile>,
    /// Why the run stopped early, if it did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stopped: Option<Stopped>,
}

/// Why a run stopped early.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stopped {
    /// Simulated time reached.
    pub time_s: f64,
    /// What happened.
    pub cause: String,
    /// What to change.
    pub advice: String,
}

impl SummaryFile {
    /// The summary as indented JSON with a final line end.
    ///
    /// # Errors
    /// None that its fields can cause; those of the JSON writer are passed on.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self).map(|json| json + "\n")
    }

    /// Writes `summary.json` in `dir`.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, dir: &Path) -> Result<(), ResultError> {
        let path = dir.join("summary.json");
        let json = self
            .to_json()
            .map_err(|e| ResultError::out(&path, std::io::Error::other(e)))?;
        write_atomically(&path, json.as_bytes())
    }
}
