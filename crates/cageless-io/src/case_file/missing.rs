//! Required keys that a file leaves out, all of them in one message.

use super::document::CaseDocument;
use super::error::CaseError;
use super::key::Key;
use super::keys;
use super::sections::CASE_FILE;
use super::spanned_toml::{Value, join};

/// Required keys of `[bearing]`, `[operation]`, `[film]` and `[raceway]`, each with those that may replace it.
const ALTERNATIVES: [(&str, &[&str], &[&str]); 7] = [
    ("raceway", &["axial_span_mm"], &["profile"]),
    ("raceway", &["half_angle_deg"], &["profile"]),
    ("bearing", &["ball_radius_mm"], &["ball_diameter_mm"]),
    (
        "bearing",
        &[
            "inner_groove_bottom_radius_mm",
            "outer_groove_bottom_radius_mm",
        ],
        &["pitch_diameter_mm", "radial_internal_clearance_um"],
    ),
    ("operation", &["inner_speed_rpm"], &[]),
    ("operation", &["radial_load_n"], &[]),
    ("film", &["supply"], &["inlet_film_um"]),
];

/// Keys that a bearing needs under a rotor.
const UNDER_A_ROTOR: [&str; 2] = [
    "inner_ring_polar_inertia_kg_m2",
    "inner_ring_bore_radius_mm",
];

/// A key that is left out, with those that go with it or stand in its place.
struct Missing<'a> {
    section: &'a str,
    key: &'a str,
    more: String,
}

impl<'a> Missing<'a> {
    fn new(section: &'a str, key: &'a str) -> Self {
        Self {
            section,
            key,
            more: String::new(),
        }
    }
}

/// Required keys that a file leaves out.
fn missing(document: &CaseDocument) -> Vec<Missing<'_>> {
    let root = &document.tree.root;
    let rotor = root.contains_key("rotor");
    let has = |section: &str, key: &str| match root.get(section).map(|node| &node.value) {
        Some(Value::Section(entries)) => entries.contains_key(key),
        // Several sections are checked one by one.
        Some(_) => true,
        None => false,
    };
    let mut missing = vec![];
    for section in CASE_FILE.sections {
        let name = section.name;
        if !root.contains_key(name) && name != "bearing" {
            continue;
        }
        let required = section
            .keys
            .iter()
            .filter(|key| key.is_required() && !has(name, key.name));
        missing.extend(required.map(|key| Missing::new(name, key.name)));
        let of_rotor = UNDER_A_ROTOR.iter().filter(|key| !has(name, key));
        if rotor && name == "bearing" {
            missing.extend(of_rotor.map(|key| Missing::new(name, key)));
        }
    }
    for (section, keys, others) in ALTERNATIVES {
        let given = |list: &[&str]| list.iter().any(|key| has(section, key));
        let left_out = match section {
            "operation" => rotor,
            "raceway" | "film" => !root.contains_key(section),
            _ => false,
        };
        if given(keys) || given(others) || left_out {
            continue;
        }
        let more = keys[1..].iter().map(|key| format!(" and {key}"));
        let instead = match others {
            [] => String::new(),
            _ => format!(" (or {})", others.join(" and ")),
        };
        missing.push(Missing {
            section,
            key: keys[0],
            more: more.collect::<String>() + &instead,
        });
    }
    missing
}

/// Refuses a file without required keys, and lists them.
pub(super) fn check(document: &CaseDocument) -> Result<(), CaseError> {
    let missing = missing(document);
    let [first, rest @ ..] = missing.as_slice() else {
        return Ok(());
    };
    let Missing { section, key, more } = first;
    // One key by itself has a message of its own.
    if rest.is_empty() && more.is_empty() {
        return Ok(());
    }
    let path = join(section, key);
    let meaning = keys::find(section, key).map_or_else(String::new, Key::describe);
    let place = match document.tree.root.contains_key(*section) {
        true => format!(" in [{section}]"),
        false => format!(", as is its section [{section}]"),
    };
    let also = rest.iter().map(|m| join(m.section, m.key) + &m.more);
    let also: Vec<_> = also.collect();
    let also = match also.as_slice() {
        [] => String::new(),
        _ => format!("; missing as well: {}", also.join(", ")),
    };
    let message = format!("{path}{more} is missing{place}: {meaning}{also}");
    Err(document.tree.error(&path, message))
}
