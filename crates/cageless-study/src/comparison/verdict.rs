//! Verdict on each ring of a comparison.

use cageless_design::{Criterion, RacewayVerdict, RunVerdict};
use serde::Serialize;
use serde_json::{Map, Value};

/// Verdict on a ring: by the means over its starts, of a finished run that in its `summary.json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RingVerdict {
    /// Name of the verdict, as in the results of a run.
    pub verdict: String,
    /// Whether it passes; `None` if it was not judged.
    pub passes: Option<bool>,
    /// Whether it works, with the criterion that decides, and its margin.
    pub headline: String,
    /// Name of this criterion.
    pub criterion: Option<String>,
    /// Margin to its limit.
    pub margin: Option<f64>,
    /// Standard error of the margin over the starts; `None` of one run.
    pub standard_error: Option<f64>,
}

impl From<RunVerdict> for RingVerdict {
    fn from(run: RunVerdict) -> Self {
        Self {
            verdict: run.verdict.name().to_owned(),
            passes: run.verdict.passes(),
            headline: run.headline,
            criterion: run.deciding.map(|c| c.name().to_owned()),
            margin: run.deciding.map(Criterion::margin),
            standard_error: run.standard_error,
        }
    }
}

impl RingVerdict {
    /// Verdict of a finished run; not judged where its summary has none.
    pub(super) fn of_summary(summary: &Map<String, Value>) -> Self {
        let value = |name: &str| summary.get(name);
        let text = |name: &str| value(name).and_then(Value::as_str).map(str::to_owned);
        Self {
            verdict: text("verdict").unwrap_or(RacewayVerdict::NotJudged.name().to_owned()),
            passes: value("passes").and_then(Value::as_bool),
            headline: text("headline").unwrap_or_default(),
            criterion: text("criterion"),
            margin: value("margin").and_then(Value::as_f64),
            standard_error: None,
        }
    }
}
