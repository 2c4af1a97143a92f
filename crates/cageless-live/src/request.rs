//! One request and its answer.

use cageless::simulation::Control;
use serde::Deserialize;
use serde_json::Value;

use crate::refusal::{Refusal, answered, parsed, read};
use crate::{compare, geometry, keys, map, motion, ranges, verdict};

/// Largest request that is read, bytes.
pub const REQUEST_BYTES_MAX: usize = 1 << 20;

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
    /// Estimates over two keys.
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

fn result(request: &str, control: &mut dyn FnMut(f64) -> Control) -> Result<Value, Refusal> {
    if request.len() > REQUEST_BYTES_MAX {
        return Err(Refusal::new(format!(
            "the request has {} bytes; {REQUEST_BYTES_MAX} are allowed",
            request.len()
        )));
    }
    match parsed(request)? {
        Request::About => Ok(keys::about()),
        Request::Geometry(OfCase { case }) => geometry::geometry(&read(&case)?, control),
        Request::Ranges { case, controls } => ranges::ranges(&case, &controls, control),
        Request::Map(grid) => map::map(&grid, control),
        Request::Static(OfCase { case }) => geometry::equilibrium(&read(&case)?, control),
        Request::Motion { case, stretch } => motion::motion(read(&case)?.case(), &stretch, control),
        Request::Compare { case, reference } => compare::compare(&case, &reference, control),
        Request::Verdict(OfCase { case }) => verdict::verdict(&read(&case)?, control),
    }
}

/// Answers one request: `{"ok": …}` or `{"error": {"message", "line", "key"}}`. `control` is
/// called with the fraction of the work that is done, 0 to 1, and can end it; while an equilibrium is
/// sought the fraction stays.
pub fn answer(request: &str, control: &mut dyn FnMut(f64) -> Control) -> String {
    answered(result(request, control))
}
