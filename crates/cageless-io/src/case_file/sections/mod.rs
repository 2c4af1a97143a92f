//! The sections of the case file, one file each: the declaration of their keys, and their
//! conversion to SI units where it is not key by key.

pub(crate) mod bearing;
pub(crate) mod contact;
pub(crate) mod housing;
pub(crate) mod material;
pub(crate) mod model;
pub(crate) mod operation;
pub(crate) mod output;
pub(crate) mod raceway;
pub(crate) mod rotor;
pub(crate) mod search;
pub(crate) mod solver;
pub(crate) mod start;
pub(crate) mod support;

use super::spanned_toml::{Node, Section, Value};

/// A key that `key` needs next to it, by those that give way to it: a clearance takes the pitch
/// diameter of the groove radii.
pub(super) fn derived_of(
    name: &str,
    key: &str,
    section: &Section,
    node: &Node,
) -> Option<(String, Node)> {
    if (name, key) != ("bearing", "radial_internal_clearance_um") {
        return None;
    }
    let number = |key: &str| match section.get(key)?.value {
        Value::Number(value) => Some(value),
        Value::Integer(value) => Some(value as f64),
        _ => None,
    };
    let inner = number("inner_groove_bottom_radius_mm")?;
    let sum = inner + number("outer_groove_bottom_radius_mm")?;
    // Millimetres of a drawing do not add up exactly.
    let value = Value::Number((sum * 1e9).round() / 1e9);
    let node = Node {
        value,
        ..node.clone()
    };
    Some(("pitch_diameter_mm".to_owned(), node))
}

/// Keys of a section that say the same as `key`, and give way to it.
pub(super) fn alternatives_of(section: &str, key: &str) -> &'static [&'static str] {
    match section {
        "bearing" => {
            let found = bearing::ALTERNATIVES.iter().find_map(|(one, other)| {
                let either = |a: &[&str], b| a.contains(&key).then_some(b);
                either(one, *other).or_else(|| either(other, *one))
            });
            found.unwrap_or_default()
        }
        "material" | "ball_material" | "ring_material" => match key {
            "preset" => &material::NUMBERS,
            _ => &["preset"],
        },
        _ => &[],
    }
}
