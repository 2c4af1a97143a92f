//! Keys of rotor files.

use crate::case_file::nearest;
use crate::case_file::unit::Unit::{
    self, Degree, Micrometre, Millimetre, None as Plain, RevolutionPerMinute, Si,
};

/// A key of a section of a rotor file.
pub(crate) struct RotorKey {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: Unit,
    /// What it means, for messages.
    pub meaning: &'static str,
}

/// Keys of the head of the file, sections last.
pub(super) const HEAD: [&str; 6] = [
    "schema",
    "title",
    "rotor",
    "bearing",
    "unbalance",
    "clearance",
];

const OF_RIGID: &str = "of a rigid rotor; or matrices, of a flexible one";
const PLACE: RotorKey = key(
    "axial_mm",
    Millimetre,
    "place from the mass centre along the axis",
);
const NODE: RotorKey = key("node", Plain, "node of the rotor, from 0");

/// The sections with their keys; `bearing`, `unbalance` and `clearance` may be there several times.
const SECTIONS: [(&str, &[RotorKey]); 4] = [
    (
        "rotor",
        &[
            key("mass_kg", Si("kg"), OF_RIGID),
            key("polar_inertia_kg_m2", Si("kg m^2"), OF_RIGID),
            key("transverse_inertia_kg_m2", Si("kg m^2"), OF_RIGID),
            key("matrices", Plain, "matrices of a flexible rotor"),
            key(
                "frequency_max_hz",
                Si("Hz"),
                "highest frequency of the modes that are kept",
            ),
            key("kept_nodes", Plain, "further nodes that are kept"),
            key(
                "speed_rpm",
                RevolutionPerMinute,
                "rotor speed at the start of the drop (loss of AMB power)",
            ),
            key("drive_torque_n_m", Si("N m"), "torque on the rotor"),
        ],
    ),
    (
        "bearing",
        &[
            key("case", Plain, "path of the case file of this bearing"),
            PLACE,
            NODE,
        ],
    ),
    (
        "unbalance",
        &[
            PLACE,
            NODE,
            key("amount_g_mm", Si("g mm"), "m·ε of the unbalance"),
            key("angle_deg", Degree, "direction at the start"),
        ],
    ),
    (
        "clearance",
        &[
            PLACE,
            NODE,
            key("name", Plain, "name of the plane in results"),
            key(
                "radial_um",
                Micrometre,
                "radial clearance between rotor and stator in the plane",
            ),
        ],
    ),
];

/// Keys of the section `[rotor]` of a case that the rotor of the file replaces.
pub(super) const REPLACED: [&str; 6] = [
    "mass_kg",
    "polar_inertia_kg_m2",
    "speed_rpm",
    "drive_torque_n_m",
    "eccentricity_um",
    "eccentricity_phase_deg",
];

const fn key(name: &'static str, unit: Unit, meaning: &'static str) -> RotorKey {
    RotorKey {
        name,
        unit,
        meaning,
    }
}

/// The keys of a section; none if there is no such section.
pub(super) fn of_section(section: &str) -> &'static [RotorKey] {
    let mut sections = SECTIONS.iter();
    let found = sections.find(|(name, _)| *name == section);
    found.map_or(&[], |(_, keys)| keys)
}

/// Looks up a key.
pub(crate) fn find(section: &str, name: &str) -> Option<&'static RotorKey> {
    of_section(section).iter().find(|key| key.name == name)
}

/// Suggestion for an unknown name, if there is one.
pub(crate) fn hint(section: &str, name: &str) -> Option<String> {
    let names = || of_section(section).iter().map(|key| key.name);
    match (nearest(name, names()), section) {
        (Some(near), _) => Some(format!("did you mean {near}?")),
        (None, "unbalance" | "clearance") => Some(format!("its keys are {}", listed(section))),
        (None, _) => None,
    }
}

/// Names of the keys of a section.
pub(super) fn listed(section: &str) -> String {
    let names: Vec<_> = of_section(section).iter().map(|key| key.name).collect();
    names.join(", ")
}
