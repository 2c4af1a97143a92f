//! Values of a result as CSV.

use cageless_results::quantities;
use serde_json::Value;

use crate::declared::units;

/// Every value of a result, from its JSON, as CSV with the columns name, value, unit and label. Names of
/// parts are joined by dots; elements of lists have their number, from 1, in brackets.
pub fn values_csv(result: &Value) -> String {
    let mut out = "name,value,unit,label\n".to_owned();
    lines("", result, &mut out);
    out
}

fn lines(name: &str, value: &Value, out: &mut String) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                let dot = if name.is_empty() { "" } else { "." };
                lines(&format!("{name}{dot}{key}"), value, out);
            }
        }
        Value::Array(list) => {
            for (k, value) in list.iter().enumerate() {
                lines(&format!("{name}[{}]", k + 1), value, out);
            }
        }
        leaf => {
            let own = name.rsplit('.').next().unwrap_or(name);
            let own = own.split('[').next().unwrap_or(own);
            let unit = units().find(|(name, _)| *name == own).map_or("", |u| u.1);
            let label = quantities().find(|q| q.name == own);
            let label = label.map_or("", |q| q.label.trim());
            let value = match leaf {
                Value::Null => String::new(),
                Value::String(text) => quoted(text),
                other => other.to_string(),
            };
            *out += &format!("{name},{value},{unit},{}\n", quoted(label));
        }
    }
}

fn quoted(text: &str) -> String {
    match text.is_empty() {
        true => String::new(),
        false => format!("\"{}\"", text.replace('"', "\"\"")),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::values_csv;

    #[test]
    fn parts_lists_and_quotes_are_lines() {
        let result = json!({
            "critical_gap_deg": 1.5, "beta0_deg": null, "reasons": ["5 \"%\", at most"],
            "raceways": [{ "passes": true, "axial_span_mm": 5.1 }], "inner_force_n": [0.25],
            "case": { "material": { "youngs_modulus_gpa": 206.0 } },
        });
        let text = values_csv(&result);
        let mut lines: Vec<&str> = text.lines().skip(1).collect();
        lines.sort_unstable();
        assert_eq!(
            lines,
            [
                "beta0_deg,,deg,\"β0, Eq. (11)\"",
                "case.material.youngs_modulus_gpa,206.0,GPa,",
                "critical_gap_deg,1.5,deg,\"critical gap\"",
                "inner_force_n[1],0.25,N,\"contact force, inner raceway\"",
                "raceways[1].axial_span_mm,5.1,mm,\"axial span lC\"",
                "raceways[1].passes,true,,\"passes\"",
                "reasons[1],\"5 \"\"%\"\", at most\",,",
            ]
        );
    }
}
