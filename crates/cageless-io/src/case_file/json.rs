//! A case in JSON: the same sections and keys, or the file of a result that holds the case as it
//! was run.

use serde_json::{Map, Value as Json};

use super::error::CaseError;
use super::former;
use super::key::{Key, Presence};
use super::keys;
use super::spanned_toml::{Node, Origin, Section, Value, join};
use crate::text_file::excerpt;

/// Kind of a case file among the files of a drop.
pub(crate) const CASE_KIND: &str = "case";

/// Parses a document.
pub(super) fn parse(text: &str, name: &str) -> Result<Section, CaseError> {
    let text = text.trim_start_matches('\u{feff}');
    let json: Map<String, Json> = serde_json::from_str(text).map_err(|e| {
        CaseError::on_line(name, e.line().max(1), None, format!("is not JSON: {e}"))
    })?;
    let result = result(&json, name)?;
    let case = match result.get("case") {
        Some(Json::Object(case)) => case,
        _ => result,
    };
    let mut root = section(case, "");
    former::rename(&mut root, name)?;
    // What was derived is derived again: from the same numbers, to the same bits.
    let defaults = result.get("defaults").and_then(Json::as_array);
    for key in defaults.into_iter().flatten().filter_map(Json::as_str) {
        let Some((section, key)) = key.split_once('.') else {
            continue;
        };
        let key = former::present(section, key);
        let derived = |k: &Key| match (k.presence)() {
            Presence::Derived | Presence::Optional => true,
            _ => k.name == "step_us",
        };
        if keys::find(section, key).is_some_and(derived)
            && let Some(Value::Section(entries)) = root.get_mut(section).map(|n| &mut n.value)
        {
            entries.remove(key);
        }
    }
    Ok(root)
}

/// The results of the only bearing of a drop, or a document that has no bearings.
fn result<'j>(json: &'j Map<String, Json>, name: &str) -> Result<&'j Map<String, Json>, CaseError> {
    let Some(Json::Array(bearings)) = json.get("bearings") else {
        return Ok(json);
    };
    let of_case = json.get("file").and_then(Json::as_str) == Some(CASE_KIND);
    let only = bearings.first().and_then(Json::as_object);
    only.filter(|_| of_case).ok_or_else(|| {
        let why = "has the results of the bearings of a rotor file and their cases, not the rotor itself: \
                   give the rotor file, or the rotor.toml of the same folder";
        CaseError::of_file(name, why.to_owned())
    })
}

fn section(map: &Map<String, Json>, path: &str) -> Section {
    map.iter()
        .filter(|(_, value)| !value.is_null())
        .map(|(key, value)| (key.clone(), node(value, &join(path, key))))
        .collect()
}

fn node(json: &Json, path: &str) -> Node {
    let value = match json {
        Json::String(text) => Value::Text(text.clone()),
        Json::Number(number) => match (number.as_i64(), number.as_f64()) {
            (Some(integer), _) => Value::Integer(integer),
            (None, Some(number)) => Value::Number(number),
            (None, None) => Value::Other,
        },
        Json::Array(items) => Value::List(items.iter().map(|item| node(item, path)).collect()),
        Json::Object(map) => Value::Section(section(map, path)),
        Json::Null | Json::Bool(_) => Value::Other,
    };
    let written = json.to_string();
    Node::new(value, Origin::File, excerpt(&written))
}
