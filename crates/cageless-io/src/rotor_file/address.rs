//! Place of a key: in a rotor file, or in the case of one of its bearings or of all.

use super::keys::{REPLACED, ROTOR_FILE};

/// Place of a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Address<'k> {
    /// In the rotor file itself.
    Rotor,
    /// In the case of a bearing, from 0, or of every bearing; the key there.
    Case(Option<usize>, &'k [&'k str]),
}

/// The place of a key, in a case file its case; in a rotor file `rotor.speed_rpm`, `bearing.2.axial_mm` and `unbalance.1.amount_g_mm` are
/// keys of the rotor file, `contact.damping_n_s_m1_5` is one of every case and `bearing.2.contact.damping_n_s_m1_5`
/// one of the case of bearing 2. Whether the case has the key, its reader says.
///
/// # Errors
/// Why there is nothing to change at such a key.
pub(crate) fn address<'k>(in_rotor_file: bool, path: &'k [&'k str]) -> Result<Address<'k>, String> {
    if !in_rotor_file {
        return Ok(Address::Case(None, path));
    }
    let of_rotor = |section: &str, key: &str| match (section, key) {
        ("rotor", "matrices") | ("bearing", "case") => {
            Err("stays as the rotor file gives it".to_owned())
        }
        _ => Ok(Address::Rotor),
    };
    match *path {
        ["title" | "schema"] => Ok(Address::Rotor),
        ["rotor", key] if ROTOR_FILE.find("rotor", key).is_some() => of_rotor("rotor", key),
        ["rotor", key] if REPLACED.contains(&key) => Err(unbalances()),
        ["bearing", key] | ["bearing", _, key] if ROTOR_FILE.find("bearing", key).is_some() => {
            of_rotor("bearing", key)
        }
        ["unbalance", ..] => Ok(Address::Rotor),
        ["bearing", number, ref key @ ..] if is_number(number) => match *key {
            ["rotor", name] if REPLACED.contains(&name) => Err(match name {
                "eccentricity_um" | "eccentricity_phase_deg" => unbalances(),
                _ => format!("belongs to the rotor as a whole: write rotor.{name}"),
            }),
            // 0 and what is too large are no bearings, as any number above theirs.
            [_, _, ..] => Ok(Address::Case(
                Some(number.parse::<usize>().unwrap_or(0).wrapping_sub(1)),
                key,
            )),
            _ => Err(format!(
                "is no key of a bearing of a rotor file; {}, or write bearing.{number}.section.key for \
                 a key of its case",
                ROTOR_FILE.hint("bearing", key.first().unwrap_or(&""))
            )),
        },
        _ => Ok(Address::Case(None, path)),
    }
}

/// Whether a part of a key counts sections.
pub(crate) fn is_number(part: &str) -> bool {
    !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit())
}

fn unbalances() -> String {
    "is replaced by the unbalances of the rotor: write unbalance.1.amount_g_mm".to_owned()
}
