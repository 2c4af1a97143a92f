//! Look-up of the keys of a case file.

use super::key::Key;
use super::sections::CASE_FILE;

/// Every key with its section, in the order of the file format; the head of the file first.
pub(crate) fn all() -> impl Iterator<Item = (&'static str, &'static Key)> {
    CASE_FILE.all()
}

/// Looks up a key.
pub(crate) fn find(section: &str, name: &str) -> Option<&'static Key> {
    CASE_FILE.find(section, name)
}

/// Message on a case without a rotor to drop, with the keys that it lacks.
pub fn missing_rotor() -> String {
    let names = |section: &str| {
        let keys = CASE_FILE
            .of_section(section)
            .iter()
            .filter(|key| key.is_required());
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

/// Whether the key of a column takes a bearing out of its plane.
pub fn is_spatial(column: &str) -> bool {
    cageless::SPATIAL_FIELDS.iter().any(|field| {
        of_field(None, field).is_some_and(|(section, key)| {
            column.starts_with(&format!("{section}_"))
                && column.ends_with(&format!("_{}", key.name))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case_file::format::nearest;
    use crate::case_file::key::Presence;

    #[test]
    fn spatial_fields_have_keys() {
        for field in cageless::SPATIAL_FIELDS {
            assert!(of_field(None, field).is_some(), "{field}");
        }
        for column in [
            "operation_axial_load_n",
            "raceway_2_contact_angle_deg",
            "row_1_axial_position_mm",
            "model_motion",
        ] {
            assert!(is_spatial(column), "{column}");
        }
        assert!(!is_spatial("operation_radial_load_n"));
    }

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
                // The title is free, the flanks are those of the paper.
                let own = [("", "title"), ("model", "flanks")].contains(&(section, key.name));
                assert!(own || shown == Some(default.written()), "{}", key.name);
            }
        }
    }

    #[test]
    fn a_slip_of_the_pen_finds_its_key() {
        let names = || CASE_FILE.of_section("raceway").iter().map(|k| k.name);
        assert_eq!(nearest("axial_spam_mm", names()), Some("axial_span_mm"));
        assert_eq!(nearest("axial_span_m", names()), Some("axial_span_mm"));
        assert_eq!(nearest("Half_Angle_Deg", names()), Some("half_angle_deg"));
        assert_eq!(nearest("colour", names()), None);
    }
}
