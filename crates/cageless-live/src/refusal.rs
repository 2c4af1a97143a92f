//! Refusal of a request.

use cageless::equilibrium::EquilibriumError;
use cageless_design::critical_gap::CriticalGapError;
use cageless_io::case_file::{CaseError, CaseFile};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

/// A request that cannot be answered: what the command prints for the same mistake.
#[derive(Debug, Serialize)]
pub struct Refusal {
    /// The message.
    message: String,
    /// Line of the case, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    /// Dotted key of the case.
    #[serde(skip_serializing_if = "Option::is_none")]
    key: Option<String>,
}

impl Refusal {
    /// A message about the request as a whole.
    pub fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            line: None,
            key: None,
        }
    }
}

impl From<CaseError> for Refusal {
    fn from(error: CaseError) -> Self {
        Self {
            message: error.to_string(),
            line: error.line(),
            key: error.key().map(str::to_owned),
        }
    }
}

impl From<EquilibriumError> for Refusal {
    fn from(error: EquilibriumError) -> Self {
        match error {
            EquilibriumError::Interrupted => Self::new("cancelled"),
            error => Self::new(error.to_string()),
        }
    }
}

impl From<cageless::InputError> for Refusal {
    fn from(error: cageless::InputError) -> Self {
        Self::new(error.to_string())
    }
}

impl From<CriticalGapError> for Refusal {
    fn from(error: CriticalGapError) -> Self {
        match error {
            CriticalGapError::Stopped(stop) => Self::new(stop.by_key()),
            error => Self::new(error.to_string()),
        }
    }
}

/// The answer to a request: `{"ok": …}` or `{"error": {"message", "line", "key"}}`.
pub fn answered(result: Result<Value, Refusal>) -> String {
    match result {
        Ok(value) => json!({ "ok": value }),
        Err(refusal) => json!({ "error": refusal }),
    }
    .to_string()
}

/// Reads a request.
///
/// # Errors
/// The text is not JSON, or not of such a request.
pub fn parsed<R: DeserializeOwned>(request: &str) -> Result<R, Refusal> {
    let refused = |error| Refusal::new(format!("the request cannot be read: {error}"));
    serde_json::from_str(request).map_err(refused)
}

/// Balls of all rows of a case, at most.
const BALLS_MAX: usize = 2000;

/// Reads the case of a request; its messages name the case file `case`.
pub(crate) fn read(case: &str) -> Result<CaseFile, Refusal> {
    let file = CaseFile::parse(case, "case", &[])?;
    let rows = file.case().rows.len().max(1);
    let balls = rows * file.case().bearing.balls();
    match balls > BALLS_MAX {
        // Its equilibrium takes minutes.
        true => Err(Refusal::new(format!(
            "the case has {balls} balls; the studio computes up to {BALLS_MAX}, the command has no such limit"
        ))),
        false => Ok(file),
    }
}
