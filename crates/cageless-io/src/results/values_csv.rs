//! Values of a result as CSV.

use cageless_results::{Quantity, quantities, result_at};
use serde_json::{Map, Value};

use crate::declared::units;
use crate::on_terminal;

/// Statistics of the result or the deviation that a row of a list is about.
const OF_ROW: [&str; 14] = [
    "value",
    "half_step_value",
    "tolerance",
    "step_change",
    "start_change",
    "mean",
    "half_step_mean",
    "spread",
    "standard_error",
    "low",
    "least",
    "median",
    "high",
    "most",
];

/// Every value of the document `kind` (`design` of `design.json`), from its JSON, as CSV with the columns name, value,
/// unit and label. Names of parts are joined by dots; elements of lists have their number, from 1, in brackets.
pub fn values_csv(kind: &str, result: &Value) -> String {
    let mut out = "name,value,unit,label\n".to_owned();
    let place = Place {
        kind,
        name: String::new(),
        path: vec![],
        row: None,
    };
    place.lines(result, &mut out);
    out
}

/// A place in a document.
#[derive(Clone)]
struct Place<'v> {
    kind: &'v str,
    name: String,
    /// Names of the objects on the way.
    path: Vec<&'v str>,
    /// The nearest object that is about one result or has a unit of its own.
    row: Option<&'v Map<String, Value>>,
}

impl<'v> Place<'v> {
    fn lines(&self, value: &'v Value, out: &mut String) {
        match value {
            Value::Object(map) => {
                let of_one = map.contains_key("unit") || result_named(map).is_some();
                for (key, value) in map {
                    let dot = if self.name.is_empty() { "" } else { "." };
                    let mut inside = self.clone();
                    inside.name = format!("{}{dot}{key}", self.name);
                    inside.path.push(key);
                    inside.row = if of_one { Some(map) } else { self.row };
                    inside.lines(value, out);
                }
            }
            Value::Array(list) => {
                for (k, value) in list.iter().enumerate() {
                    let mut inside = self.clone();
                    inside.name = format!("{}[{}]", self.name, k + 1);
                    inside.lines(value, out);
                }
            }
            leaf => {
                let (unit, label) = self.unit_and_label();
                let value = match leaf {
                    Value::Null => String::new(),
                    Value::String(text) => quoted(text),
                    other => other.to_string(),
                };
                *out += &format!("{},{value},{unit},{}\n", self.name, quoted(label));
            }
        }
    }

    fn unit_and_label(&self) -> (&str, &'static str) {
        let own = self.path.last().copied().unwrap_or_default();
        let unit = |name: &str| {
            units()
                .find(|(known, _)| *known == name)
                .map_or("", |u| u.1)
        };
        let label = |quantity: Option<&Quantity>| quantity.map_or("", |q| q.label.trim());
        let here = result_at(self.kind, &self.path);
        match self.row.filter(|_| OF_ROW.contains(&own)) {
            Some(row) => match result_named(row) {
                Some(result) => (result.unit, label(here.or(Some(result)))),
                None => (row["unit"].as_str().unwrap_or_default(), label(here)),
            },
            None => (unit(own), label(here)),
        }
    }
}

/// The result that a row is about by its `name`.
fn result_named(row: &Map<String, Value>) -> Option<&'static Quantity> {
    let name = row.get("name")?.as_str()?;
    quantities().find(|q| q.name == name)
}

/// Text as a cell. An apostrophe comes before what a spreadsheet would take for a formula.
fn quoted(text: &str) -> String {
    if text.is_empty() {
        return String::new();
    }
    let formula = text.trim_start().starts_with(['=', '+', '-', '@']);
    let mark = if formula { "'" } else { "" };
    format!("\"{mark}{}\"", on_terminal(text).replace('"', "\"\""))
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::values_csv;

    fn sorted(kind: &str, result: &Value) -> Vec<String> {
        let text = values_csv(kind, result);
        let mut lines: Vec<String> = text.lines().skip(1).map(str::to_owned).collect();
        lines.sort_unstable();
        lines
    }

    #[test]
    fn parts_lists_and_quotes_are_lines() {
        let result = json!({
            "critical_gap_deg": 1.5, "beta0_deg": null, "reasons": ["5 \"%\", at most"],
            "titles": ["=HYPERLINK(1)", "+1", "-1", "@a", " =1", "a\u{1b}[2J=1"],
            "raceways": [{ "passes": true, "axial_span_mm": 5.1 }], "inner_force_n": [0.25],
            "case": { "material": { "youngs_modulus_gpa": 206.0 } },
        });
        assert_eq!(
            sorted("design", &result),
            [
                "beta0_deg,,deg,\"β0, Eq. (11)\"",
                "case.material.youngs_modulus_gpa,206.0,GPa,",
                "critical_gap_deg,1.5,deg,\"critical gap\"",
                "inner_force_n[1],0.25,N,\"contact force, inner raceway\"",
                "raceways[1].axial_span_mm,5.1,mm,\"axial span lC\"",
                "raceways[1].passes,true,,\"passes\"",
                "reasons[1],\"5 \"\"%\"\", at most\",,",
                "titles[1],\"'=HYPERLINK(1)\",,",
                "titles[2],\"'+1\",,",
                "titles[3],\"'-1\",,",
                "titles[4],\"'@a\",,",
                "titles[5],\"' =1\",,",
                "titles[6],\"a\\u001b[2J=1\",,",
            ]
        );
    }

    /// Statistics have the unit of what they are of, and no line the label of another table.
    #[test]
    fn rows_of_one_result_have_its_unit_and_label() {
        let row = json!({
            "name": "gap_min_deg", "unit": "°", "better": [null],
            "values": [{ "mean": 1.8, "standard_error": 0.1, "starts": 8 }],
        });
        let result = json!({ "starts": { "count": 8 }, "results": [row] });
        assert_eq!(
            sorted("compare", &result),
            [
                "results[1].better[1],,,",
                "results[1].name,\"gap_min_deg\",,",
                "results[1].unit,\"°\",,",
                "results[1].values[1].mean,1.8,deg,\"smallest gap\"",
                "results[1].values[1].standard_error,0.1,deg,\"smallest gap\"",
                "results[1].values[1].starts,8,,",
                "starts.count,8,,",
            ]
        );
        let row = json!({
            "name": "groove depth", "low": -2.0, "high": 2.0, "unit": "µm", "trials": 2,
            "critical_gap_deg": [1.7, 1.9],
        });
        let result = json!({ "influences": [row] });
        assert_eq!(
            sorted("tolerance", &result),
            [
                "influences[1].critical_gap_deg[1],1.7,deg,\"critical gap\"",
                "influences[1].critical_gap_deg[2],1.9,deg,\"critical gap\"",
                "influences[1].high,2.0,µm,\"to\"",
                "influences[1].low,-2.0,µm,\"from\"",
                "influences[1].name,\"groove depth\",,\"deviates\"",
                "influences[1].trials,2,,\"bearings\"",
                "influences[1].unit,\"µm\",,\"unit\"",
            ]
        );
    }
}
