//! What figures draw against the data that they name: every number another, every trace accounted for.

mod drops;
mod runs;
mod studies;

use cageless_report::Figure;
use serde_json::Value;

/// Cases of the repository.
const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");

pub(super) fn spec(figure: &Figure) -> Value {
    serde_json::from_str(&figure.json()).unwrap()
}

/// A list of a trace; NaN where it has no number.
pub(super) fn list(trace: &Value, key: &str) -> Vec<f64> {
    let values = trace[key].as_array();
    let values = values.unwrap_or_else(|| panic!("no {key} in {trace}"));
    values
        .iter()
        .map(|v| v.as_f64().unwrap_or(f64::NAN))
        .collect()
}

/// Whether numbers are those, to the six digits that figures keep.
pub(super) fn same(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (found, expected) in found.iter().zip(expected) {
        let alike = (found - expected).abs() <= 1e-5 * expected.abs() + 1e-300;
        assert!(
            alike || (found.is_nan() && expected.is_nan()),
            "{what}: {found}, not {expected}"
        );
    }
}

/// A trace by its name and the axis or diagram that it is on.
pub(super) struct Drawn {
    pub name: &'static str,
    pub on: &'static str,
    pub keys: [&'static str; 2],
    pub values: [Vec<f64>; 2],
}

pub(super) fn drawn(name: &'static str, on: &'static str, values: [Vec<f64>; 2]) -> Drawn {
    Drawn {
        name,
        on,
        keys: ["x", "y"],
        values,
    }
}

/// The axis or diagram of a trace.
pub(super) fn place(trace: &Value) -> &str {
    let keys = ["subplot", "yaxis"].iter();
    keys.filter_map(|key| trace[key].as_str())
        .next()
        .unwrap_or("y")
}

/// Every trace of a plot, each once, apart from `others` by name.
pub(super) fn traces(spec: &Value, expected: &[Drawn], others: &[&str]) {
    let all = spec["data"].as_array().unwrap();
    for wanted in expected {
        let is = |t: &&Value| t["name"] == wanted.name && place(t) == wanted.on;
        let found: Vec<&Value> = all.iter().filter(is).collect();
        let [found] = found[..] else {
            panic!("{} of {} on {}", found.len(), wanted.name, wanted.on);
        };
        for (key, values) in wanted.keys.iter().zip(&wanted.values) {
            let what = format!("{} on {}, {key}", wanted.name, wanted.on);
            same(&list(found, key), values, &what);
        }
    }
    let other = |t: &&Value| t["name"].as_str().is_none_or(|name| others.contains(&name));
    let more = all.iter().filter(other).count();
    assert_eq!(all.len(), expected.len() + more, "{all:?}");
}

/// Numbers that all differ.
pub(super) struct Counter(pub(super) f64);

impl Counter {
    pub(super) fn next(&mut self) -> f64 {
        self.0 = 1.07 * self.0 + 0.013;
        self.0
    }

    pub(super) fn several(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.next()).collect()
    }
}
