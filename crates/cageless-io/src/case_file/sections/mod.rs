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
