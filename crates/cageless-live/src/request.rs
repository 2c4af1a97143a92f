//! One request and its answer.

use cageless::critical_gap::CriticalGapError;
use cageless::equilibrium::EquilibriumError;
use cageless::simulation::Control;
use cageless_io::case_file::{CaseError, CaseFile};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::{compare, geometry, keys, map, motion, ranges, verdict};

/// Largest request that is read, bytes.
pub const REQUEST_BYTES_MAX: usize = 1 << 20;

/// Operations of the engine.
pub(crate) const OPERATIONS: [&str; 8] = [
    "about", "geometry", "ranges", "map", "static", "motion", "verdict", "compare",
];

/// A request. Operations other than `about` work on a case.
#[derive(Debug, Deserialize)]
#[serde(tag = "op", rename_all = "kebab-case", deny_unknown_fields)]
enum Request {
    /// Version, keys of a case file, templates.
    About,
    /// Document, geometry and estimate of a case.
    Geometry(OfCase),
    /// Possible values of controls.
    Ranges {
        case: String,
        controls: Vec<ranges::Span>,
    },
    /// Estimates over lC and θ.
    Map(map::Grid),
    /// Static equilibrium.
    Static(OfCase),
    /// A stretch of the motion, or of the drop of a rotor.
    Motion {
        case: String,
        #[serde(flatten)]
        stretch: motion::Stretch,
    },
    /// Verdict on the raceways by simulation.
    Verdict(OfCase),
    /// The case against another, from the same uneven starts.
    Compare { case: String, reference: String },
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct OfCase {
    case: String,
}

/// A request that cannot be answered: what the command prints for the same mistake.
#[derive(Debug, Serialize)]
pub(crate) struct Refusal {
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
    pub(crate) fn new(message: impl Into<String>) -> Self {
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
        Self::new(error.to_string())
    }
}

impl From<cageless::InputError> for Refusal {
    fn from(error: cageless::InputError) -> Self {
        Self::new(error.to_string())
    }
}

impl From<CriticalGapError> for Refusal {
    fn from(error: CriticalGapError) -> Self {
        Self::new(error.to_string())
    }
}

/// Reads the case of a request; its messages name the case file `case`.
pub(crate) fn read(case: &str) -> Result<CaseFile, Refusal> {
    Ok(CaseFile::parse(case, "case", &[])?)
}

fn result(request: &str, control: &mut dyn FnMut(f64) -> Control) -> Result<Value, Refusal> {
    if request.len() > REQUEST_BYTES_MAX {
        return Err(Refusal::new(format!(
            "the request has {} bytes; {REQUEST_BYTES_MAX} are allowed",
            request.len()
        )));
    }
    let request = serde_json::from_str(request)
        .map_err(|error| Refusal::new(format!("the request cannot be read: {error}")))?;
    match request {
        Request::About => Ok(keys::about()),
        Request::Geometry(OfCase { case }) => geometry::geometry(&read(&case)?),
        Request::Ranges { case, controls } => ranges::ranges(&case, &controls, control),
        Request::Map(grid) => map::map(&grid, control),
        Request::Static(OfCase { case }) => geometry::equilibrium(read(&case)?.case()),
        Request::Motion { case, stretch } => motion::motion(read(&case)?.case(), &stretch, control),
        Request::Compare { case, reference } => compare::compare(&case, &reference, control),
        Request::Verdict(OfCase { case }) => verdict::verdict(read(&case)?.case(), control),
    }
}

/// Answers one request: `{"ok": …}` or `{"error": {"message", "line", "key"}}`. `control` is
/// called with the fraction of the work that is done, 0 to 1, and can end it.
pub fn answer(request: &str, control: &mut dyn FnMut(f64) -> Control) -> String {
    match result(request, control) {
        Ok(value) => json!({ "ok": value }),
        Err(refusal) => json!({ "error": refusal }),
    }
    .to_string()
}
