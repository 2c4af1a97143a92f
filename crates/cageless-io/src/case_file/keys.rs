//! Look-up of the keys of a case file.

use super::key::Key;
use super::sections::{HEAD, SECTIONS};
use super::spanned_toml::join;
use super::unit::Unit;

/// Every key with its section, in the order of the file format; the head of the file first.
pub(crate) fn all() -> impl Iterator<Item = (&'static str, &'static Key)> {
    let of = |(name, keys): (&'static str, &'static [Key])| keys.iter().map(move |k| (name, k));
    std::iter::once(("", HEAD))
        .chain(SECTIONS.iter().map(|s| (s.name, s.keys)))
        .flat_map(of)
}

/// The keys of a section.
pub(crate) fn of_section(section: &str) -> &'static [Key] {
    if section.is_empty() {
        return HEAD;
    }
    SECTIONS
        .iter()
        .find(|s| s.name == section)
        .map_or(&[], |s| s.keys)
}

/// Looks up a key.
pub(crate) fn find(section: &str, name: &str) -> Option<&'static Key> {
    of_section(section).iter().find(|k| k.name == name)
}

/// What a case lacks that is to drop a rotor.
pub fn missing_rotor() -> String {
    let names = |section: &str| {
        let keys = of_section(section).iter().filter(|key| key.is_required());
        keys.map(|key| key.name).collect::<Vec<_>>().join(", ")
    };
    format!(
        "the case has no [rotor] to drop: give {} there, inner_ring_bore_radius_mm and \
         inner_ring_polar_inertia_kg_m2 in [bearing], friction_coefficient of the balls in \
         [contact], and, unless the outer ring is fixed, {} in [support] (`cageless new --bearing \
         6008 --touchdown` prints a case with all of them)",
        names("rotor"),
        names("support")
    )
}

/// Unit of a key.
pub(crate) fn unit(section: &str, name: &str) -> Unit {
    find(section, name).map_or(Unit::None, |k| k.unit)
}

/// Section and key that set a field of [`cageless`]: in `section` if it is given, else the first
/// one with a field of that name.
pub(crate) fn of_field(section: Option<&str>, field: &str) -> Option<(&'static str, &'static Key)> {
    let named = |field: &str, section: Option<&str>| {
        all().find(|(s, k)| {
            !k.field.is_empty() && k.field == field && section.is_none_or(|one| one == *s)
        })
    };
    // `rotor_mass_kg` is `mass_kg` of the rotor.
    let prefixed = || {
        let (prefix, rest) = field.split_once('_')?;
        named(rest, Some(prefix))
    };
    named(field, section).or_else(prefixed)
}

/// Meaning of a section, if there is one of that name.
pub(crate) fn section_meaning(section: &str) -> Option<&'static str> {
    SECTIONS
        .iter()
        .find(|s| s.name == section)
        .map(|s| s.meaning)
}

/// Suggestion for an unknown name.
pub(crate) fn hint(section: &str, name: &str) -> String {
    let known = || of_section(section).iter().map(|k| k.name);
    let sections = || SECTIONS.iter().map(|s| s.name);
    if section.is_empty() {
        if let Some(near) = nearest(name, known().chain(sections())) {
            return match section_meaning(near) {
                Some(_) => format!("did you mean [{near}]?"),
                None => format!("did you mean {near}?"),
            };
        }
    } else if let Some(near) = nearest(name, known()) {
        return format!("did you mean {near}?");
    }
    if let Some((section, key)) = all().find(|(_, k)| k.name == name) {
        return format!("did you mean {}?", join(section, key.name));
    }
    if section.is_empty() {
        let near = nearest(name, all().map(|(_, k)| k.name));
        if let Some((section, key)) = near.and_then(|n| all().find(|(_, k)| k.name == n)) {
            return format!("did you mean {}?", join(section, key.name));
        }
        let sections: Vec<_> = sections().collect();
        return format!("its sections are {}", sections.join(", "));
    }
    format!("its keys are {}", known().collect::<Vec<_>>().join(", "))
}

/// The candidate that `given` was most likely meant to be.
pub fn nearest<'a>(given: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    // A third of the letters wrong is no longer a slip of the pen.
    let most = (given.chars().count() / 3).max(2);
    candidates
        .map(|c| (strsim::damerau_levenshtein(&given.to_lowercase(), c), c))
        .filter(|&(distance, _)| distance <= most)
        .min()
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case_file::key::Presence;

    #[test]
    fn every_key_sets_a_field_of_its_own() {
        let all: Vec<_> = all().collect();
        for (k, (section, one)) in all.iter().enumerate() {
            for (other_section, other) in &all[k + 1..] {
                let place = (section, one.name);
                assert_ne!(place, (other_section, other.name));
                let same = !one.field.is_empty() && one.field == other.field;
                assert!(!same || section != other_section, "{place:?}");
            }
        }
    }

    /// The template says what a key that is left out takes.
    #[test]
    fn values_in_the_template_are_the_defaults() {
        use crate::case_file::key::Line::{Absent, Commented, Shown};
        for (section, key) in all() {
            let (Shown(value, _) | Commented(value, _)) = key.line else {
                assert!(matches!(key.line, Absent));
                continue;
            };
            if let Presence::Default(default) = (key.presence)() {
                let text = format!("x = {value}");
                let shown = crate::case_file::spanned_toml::parse(&text, "").unwrap();
                let shown = crate::case_file::CaseValue::from_toml(&shown["x"].value);
                let shown = shown.map(|v| v.written());
                let title = (section, key.name) == ("", "title");
                assert!(title || shown == Some(default.written()), "{}", key.name);
            }
        }
    }

    #[test]
    fn a_slip_of_the_pen_finds_its_key() {
        let names = || of_section("raceway").iter().map(|k| k.name);
        assert_eq!(nearest("axial_spam_mm", names()), Some("axial_span_mm"));
        assert_eq!(nearest("axial_span_m", names()), Some("axial_span_mm"));
        assert_eq!(nearest("Half_Angle_Deg", names()), Some("half_angle_deg"));
        assert_eq!(nearest("colour", names()), None);
    }
}
