//! Keys of a plan: those of a case, `section.key` or `raceway.2.key`; of a rotor file with several
//! bearings, its own and those of its cases, of all bearings or of one, `bearing.2.section.key`.

use crate::case_file::key::{Key, Kind};
use crate::case_file::keys;
use crate::case_file::sections::alternatives_of;
use crate::rotor_file::address::is_number;
use crate::rotor_file::keys::ROTOR_FILE;

/// The key in the case: `bearing.2.raceway.half_angle_deg` is `raceway.half_angle_deg` in the case
/// of bearing 2. Any other key is itself.
pub fn key_in_case(key: &str) -> &str {
    let inner = || {
        let (number, inner) = key.strip_prefix("bearing.")?.split_once('.')?;
        (is_number(number) && inner.contains('.')).then_some(inner)
    };
    inner().unwrap_or(key)
}

/// Deviation of the radius of each ball.
pub const BALL_DEVIATIONS: &str = "bearing.ball_radius_deviation_um";
/// Gap behind each ball.
pub const GAPS: &str = "start.gaps";

/// Whether a key is a list with an item for each ball.
pub fn is_per_ball(key: &str) -> bool {
    [BALL_DEVIATIONS, GAPS].contains(&key_in_case(key))
}

/// Unit of a dotted key; empty if none.
pub fn unit(key: &str) -> &'static str {
    declared(key).map_or("", |key| key.unit.symbol())
}

/// Whether the values of a key are whole numbers.
pub fn is_whole(key: &str) -> bool {
    matches!(declared(key), Some(key) if matches!(key.kind, Kind::Whole))
}

/// The declaration of a key, of a case or of a rotor file.
fn declared(key: &str) -> Option<&'static Key> {
    let (section, name) = split(key);
    keys::find(section, name).or_else(|| ROTOR_FILE.find(section, name))
}

/// Section and name: `raceway.2.half_angle_deg` is `half_angle_deg` in `raceway`.
pub(super) fn split(key: &str) -> (&str, &str) {
    let key = key_in_case(key);
    let section = key.split_once('.').map_or("", |(section, _)| section);
    (section, key.rsplit_once('.').map_or(key, |(_, name)| name))
}

/// Order of keys: those of one bearing after those of all, and otherwise as in a case file, after
/// the keys that only a rotor has.
pub(super) fn order(key: &str) -> (bool, Option<usize>, String) {
    let place = keys::all().position(|(section, k)| (section, k.name) == split(key));
    (of_one_bearing(key), place, key.to_owned())
}

/// Whether a change of `one` replaces all that a change of `other` does.
pub(super) fn covers(one: &str, other: &str) -> bool {
    plain(one) == plain(other) || !of_one_bearing(one) && plain(one) == plain(key_in_case(other))
}

/// Whether two keys give the same quantity in different terms, of which a case takes one.
pub(super) fn say_the_same(one: &str, other: &str) -> bool {
    let scope = |key: &str| key[..key.len() - key_in_case(key).len()].to_owned();
    let (scopes, (section, name)) = ([scope(one), scope(other)], split(one));
    // The key of all bearings is that of each.
    (scopes[0] == scopes[1] || scopes.iter().any(String::is_empty))
        && split(other).0 == section
        && alternatives_of(section, name).contains(&split(other).1)
}

/// Whether a key belongs to the case of one of several bearings.
fn of_one_bearing(key: &str) -> bool {
    key_in_case(key).len() < key.len()
}

/// The key without the number of the first section, which may be left out.
fn plain(key: &str) -> String {
    let inner = key_in_case(key);
    let bearing = &key[..key.len() - inner.len()];
    format!("{bearing}{}", inner.replacen(".1.", ".", 1))
}
