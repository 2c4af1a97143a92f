//! Keys of a plan: those of a case, `section.key` or `raceway.2.key`; of a rotor file with several
//! bearings, its own and those of its cases, of all bearings or of one, `bearing.2.section.key`.

use crate::case_file::key::Kind;
use crate::case_file::keys;
use crate::case_file::unit::Unit;
use crate::rotor_file::address::is_number;
use crate::rotor_file::keys as rotor_keys;

/// The key in the case: `bearing.2.raceway.half_angle_deg` is `raceway.half_angle_deg` in the case
/// of bearing 2. Any other key is itself.
pub fn key_in_case(key: &str) -> &str {
    let inner = || {
        let (number, inner) = key.strip_prefix("bearing.")?.split_once('.')?;
        (is_number(number) && inner.contains('.')).then_some(inner)
    };
    inner().unwrap_or(key)
}

/// Unit of a dotted key; empty if none.
pub fn unit(key: &str) -> &'static str {
    unit_of(key).symbol()
}

/// Whether the values of a key are whole numbers.
pub fn is_whole(key: &str) -> bool {
    let (section, name) = split(key);
    let of_case = keys::find(section, name).map(|key| key.kind);
    matches!(of_case, Some(Kind::Whole)) || name == "node"
}

fn unit_of(key: &str) -> Unit {
    let (section, name) = split(key);
    let of_case = keys::find(section, name).map(|key| key.unit);
    let of_rotor = || Some(rotor_keys::find(section, name)?.unit);
    of_case.or_else(of_rotor).unwrap_or(Unit::None)
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
