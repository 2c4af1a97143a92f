//! Requests that only the server answers: search, tolerance and export, which take all cores or
//! the libraries of files. All others are those of the engine in the page.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use cageless_design::search::BUDGET;
use cageless_io::cad::{ExportError, ExportOptions, Format, export};
use cageless_io::case_file::CaseFile;
use cageless_live::{REQUEST_BYTES_MAX, Refusal, answer as engine_answer, answered, parsed};
use cageless_study::tolerance::{Request as Tolerances, tolerance};
use cageless_study::{StudyError, search};
use serde::Deserialize;
use serde_json::{Value, json};

use super::client::Client;

/// Operations of the server alone.
pub const OPERATIONS: [&str; 3] = ["search", "tolerance", "export"];

/// A request to the server alone.
#[derive(Debug, Deserialize)]
#[serde(tag = "op", rename_all = "kebab-case", deny_unknown_fields)]
enum Request {
    /// Search for the best raceway.
    Search {
        case: String,
        /// Largest number of simulations, instead of that of the case.
        budget: Option<usize>,
    },
    /// Verdicts within tolerances.
    Tolerance {
        case: String,
        #[serde(default)]
        tolerances: Tolerances,
    },
    /// The outer ring as a file.
    Export { case: String, format: Format },
}

/// The operation of a request, whatever else is in it.
#[derive(Debug, Deserialize)]
struct Operation {
    op: String,
}

/// The refusal of a study that has failed.
fn refused(error: StudyError) -> Refusal {
    match error {
        StudyError::File(error) => error.into(),
        StudyError::Interrupted => Refusal::new("cancelled"),
        StudyError::Option(error) => Refusal::new(format!(
            "{} {}: {}",
            error.option, error.value, error.problem
        )),
        error => Refusal::new(error.to_string()),
    }
}

/// Answers one request: `{"ok": …}` or `{"error": …}`, as the engine does.
pub fn answer(text: &str, client: &Client<'_>) -> String {
    let operation = match serde_json::from_str::<Operation>(text) {
        Ok(request) if text.len() <= REQUEST_BYTES_MAX => request.op,
        _ => String::new(),
    };
    if OPERATIONS.contains(&operation.as_str()) {
        return answered(result(text, client));
    }
    let answer = engine_answer(text, &mut |fraction| client.control(fraction));
    if operation == "about" {
        return with_operations(&answer).unwrap_or(answer);
    }
    answer
}

/// The answer to `about` with the operations of the server.
fn with_operations(answer: &str) -> Option<String> {
    let mut answer: Value = serde_json::from_str(answer).ok()?;
    let about = answer.get_mut("ok")?;
    let operations = about.get_mut("operations")?.as_array_mut()?;
    operations.extend(OPERATIONS.map(Value::from));
    about["tolerances"] = json!(Tolerances::default());
    about["runs_max"] = json!(BUDGET);
    Some(answer.to_string())
}

fn result(text: &str, client: &Client<'_>) -> Result<Value, Refusal> {
    match parsed(text)? {
        Request::Search { case, budget } => {
            let set = budget.map(|budget| format!("search.runs_max={budget}"));
            let set: Vec<String> = set.into_iter().collect();
            searched(&CaseFile::parse(&case, "case", &set)?, client)
        }
        Request::Tolerance { case, tolerances } => {
            let file = CaseFile::parse(&case, "case", &[])?;
            let judged = tolerance(&file, "case", &tolerances, client);
            Ok(json!(judged.map_err(refused)?))
        }
        Request::Export { case, format } => exported(&CaseFile::parse(&case, "case", &[])?, format),
    }
}

/// The Pareto front of a search and what it recommends.
fn searched(file: &CaseFile, client: &Client<'_>) -> Result<Value, Refusal> {
    let (found, record) = search::run(file, None, &[], client).map_err(refused)?;
    let mut data = json!(record);
    data["verdicts"] = data["recommended_verdicts"].take();
    let names = [
        "findings",
        "points",
        "recommended",
        "verdicts",
        "front",
        "rejections",
    ];
    let mut answer: Value = names
        .iter()
        .map(|name| (*name, data[name].take()))
        .collect();
    answer["looked_at"] = record.parts("band").len().into();
    answer["none"] = json!(search::refusal(file, &found));
    Ok(answer)
}

/// The outer ring as a file: text, or base64 where it is binary.
fn exported(file: &CaseFile, format: Format) -> Result<Value, Refusal> {
    let made = export(file, format, &ExportOptions::default()).map_err(|error| match error {
        ExportError::Case(error) => error.into(),
        error => Refusal::new(error.to_string()),
    })?;
    let mut bytes = vec![];
    let numbers = made
        .write(&mut bytes)
        .map_err(|error| Refusal::new(error.to_string()))?;
    let mut answer = json!({
        "name": format!("outer_ring.{}", format.name()),
        "numbers": numbers,
    });
    match String::from_utf8(bytes) {
        Ok(text) => answer["text"] = text.into(),
        Err(binary) => answer["base64"] = STANDARD.encode(binary.as_bytes()).into(),
    }
    Ok(answer)
}

/// Longest computation of a request, s: of studies of many runs, and of others.
pub fn seconds_max(text: &str) -> u64 {
    let operation = serde_json::from_str::<Operation>(text);
    match operation.as_ref().map(|request| request.op.as_str()) {
        Ok("search" | "tolerance") => 3600,
        _ => 300,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_studies_of_many_runs_may_take_an_hour() {
        for (text, seconds) in [
            (r#"{"op":"search","case":""}"#, 3600),
            (r#"{"op":"tolerance"}"#, 3600),
            (r#"{"op":"export"}"#, 300),
            (r#"{"op":"verdict","case":"search"}"#, 300),
            ("[", 300),
        ] {
            assert_eq!(seconds_max(text), seconds, "{text}");
        }
    }
}
