//! Keys of the cases in which the rings of a comparison differ.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;
use serde_json::Value;

/// Numbers of a list that are written out.
const WRITTEN_OUT: usize = 4;
/// Section that stands as one key where a ring has none.
const RACEWAY: &str = "raceway";

/// Key in which cases differ.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DifferingKey {
    /// Dotted name.
    pub key: String,
    /// Value of the key in every case, as text; `None` where it is left out.
    pub values: Vec<Option<String>>,
}

/// Keys in which cases differ, by their documents as JSON; raceways that a case lacks are one.
pub(super) fn differing_keys(cases: &[Value]) -> Vec<DifferingKey> {
    let is_plain = |case: &&Value| case.get(RACEWAY).is_none();
    let plain = cases.iter().filter(is_plain).count();
    let whole = plain > 0 && plain < cases.len();
    let all: Vec<BTreeMap<String, String>> = cases
        .iter()
        .map(|case| {
            let mut keys = BTreeMap::new();
            collect("", case, &mut keys);
            if whole {
                keys.retain(|key, _| !key.starts_with(RACEWAY));
                keys.extend(case.get(RACEWAY).map(raceways));
            }
            keys
        })
        .collect();
    let names: BTreeSet<&String> = all.iter().flat_map(BTreeMap::keys).collect();
    let keys = names.into_iter().map(|key| DifferingKey {
        key: key.clone(),
        values: all.iter().map(|keys| keys.get(key).cloned()).collect(),
    });
    keys.filter(|key| key.key != "title" && key.values.iter().any(|v| *v != key.values[0]))
        .collect()
}

/// How many raceways a case has.
fn raceways(section: &Value) -> (String, String) {
    let count = section.as_array().map_or(1, Vec::len);
    (RACEWAY.to_owned(), format!("{count} given"))
}

/// Takes the keys of a value under their dotted names; of several sections each has its number.
fn collect(path: &str, value: &Value, keys: &mut BTreeMap<String, String>) {
    let joined = |name: &str| match path {
        "" => name.to_owned(),
        path => format!("{path}.{name}"),
    };
    match value {
        Value::Object(entries) => {
            for (name, value) in entries {
                collect(&joined(name), value, keys);
            }
        }
        Value::Array(sections) if sections.iter().any(Value::is_object) => {
            for (k, section) in sections.iter().enumerate() {
                collect(&joined(&(k + 1).to_string()), section, keys);
            }
        }
        value => {
            keys.insert(path.to_owned(), text(value));
        }
    }
}

/// A value as text, a long list by its length.
fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number
            .as_f64()
            .map_or(number.to_string(), |value| value.to_string()),
        Value::Array(list) if list.len() > WRITTEN_OUT => {
            format!("{} values from {}", list.len(), text(&list[0]))
        }
        Value::Array(list) => list.iter().map(text).collect::<Vec<_>>().join(", "),
        value => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// Keys of any section, left out or other, in the order of their names; titles are no difference.
    #[test]
    fn every_key_that_differs_is_found() {
        let dry = json!({
            "title": "dry", "operation": { "radial_load_n": 1500.0, "inner_speed_rpm": 12000.0 },
            "raceway": [{ "axial_span_mm": 5.1 }, { "axial_span_mm": 4.9 }], "start": { "gaps": "uniform" },
        });
        let mut wet = dry.clone();
        wet["title"] = json!("wet");
        assert_eq!(differing_keys(&[dry.clone(), wet.clone()]), []);
        wet["film"] = json!({ "supply": "two-drops", "viscosity_mpa_s": 5.0 });
        wet["operation"]["inner_speed_rpm"] = json!(3000.0);
        wet["raceway"][1]["axial_span_mm"] = json!(5.25);
        wet["start"]["gaps"] = json!([1.0, 2.0, 3.0, 4.0, 5.0]);
        let found = differing_keys(&[dry.clone(), wet.clone()]);
        let lines = found.iter().map(|key| {
            let of = |k: usize| key.values[k].clone().unwrap_or("–".to_owned());
            format!("{}: {} / {}", key.key, of(0), of(1))
        });
        let expected = [
            "film.supply: – / two-drops",
            "film.viscosity_mpa_s: – / 5",
            "operation.inner_speed_rpm: 12000 / 3000",
            "raceway.2.axial_span_mm: 4.9 / 5.25",
            "start.gaps: uniform / 5 values from 1",
        ];
        assert_eq!(lines.collect::<Vec<_>>(), expected);
        let mut plain = dry.clone();
        plain.as_object_mut().unwrap().remove("raceway");
        let found = differing_keys(&[plain, dry]);
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].values, [None, Some("2 given".to_owned())]);
    }
}
