//! Keys of rotor files.

use crate::case_file::declaration::prelude::*;

const OF_RIGID: &str = "of a rigid rotor; or matrices, of a flexible one";
const PLACE: &str = "place from the mass centre along the axis";
const NODE: &str = "node of the rotor, from 0";

sections! {
    /// The sections of a rotor file.
    RotorSections, ROTOR_FILE, "rotor file", HeadSection {
        rotor: RotorSection, "the rotor", Heading::Absent;
        bearing: Vec<BearingSection>, "a bearing of the rotor", Heading::Absent;
        unbalance: Vec<UnbalanceSection>, "an unbalance of the rotor", Heading::Absent;
        clearance: Vec<ClearanceSection>, "a clearance between rotor and stator", Heading::Absent;
    }
}

section! {
    /// The head of the file.
    struct HeadSection {
        schema => schema: u64 = default(SCHEMA as i64), Plain, "version of the file format", Absent;
        title => title: String = default(""), Plain, "free text", Absent;
    }
}

section! {
    /// `[rotor]`: a rotor, rigid or by its matrices.
    struct RotorSection {
        mass_kg => mass_kg: Option<f64> = Optional, Si("kg"), OF_RIGID, Absent;
        polar_inertia_kg_m2 => polar_inertia_kg_m2: Option<f64> = Optional, Si("kg m^2"),
            OF_RIGID, Absent;
        transverse_inertia_kg_m2 => transverse_inertia_kg_m2: Option<f64> = Optional, Si("kg m^2"),
            OF_RIGID, Absent;
        matrices => matrices: Option<FileOrSection> = Optional, Plain,
            "matrices of a flexible rotor", Absent;
        frequency_max_hz => frequency_max_hz: Option<f64> = Optional, Si("Hz"),
            "highest frequency of the modes that are kept", Absent;
        kept_nodes => kept_nodes: Option<Vec<usize>> = Optional, Plain; AtLeast(0.0),
            "further nodes that are kept", Absent;
        speed_rpm => speed_rpm: AsGiven = Required, RevolutionPerMinute,
            "rotor speed at the start of the drop (loss of AMB power)", Absent;
        drive_torque_n_m => drive_torque_n_m: f64 = default(0.0), Si("N m"),
            "torque on the rotor", Absent;
    }
}

section! {
    /// `[[bearing]]`: a bearing of the rotor.
    struct BearingSection {
        case => case: FileOrSection = Required, Plain, "path of the case file of this bearing", Absent;
        axial_mm => axial_mm: Option<AsGiven> = Optional, Millimetre, PLACE, Absent;
        node => node: Option<usize> = Optional, Plain; AtLeast(0.0), NODE, Absent;
    }
}

section! {
    /// `[[unbalance]]`: an unbalance of the rotor.
    struct UnbalanceSection {
        axial_mm => axial_mm: Option<AsGiven> = Optional, Millimetre, PLACE, Absent;
        node => node: Option<usize> = Optional, Plain; AtLeast(0.0), NODE, Absent;
        amount_g_mm formerly moment_g_mm => amount_g_mm: AsGiven = Required, Si("g mm"),
            "m·ε of the unbalance", Absent;
        angle_deg formerly phase_deg => angle_deg: AsGiven = default(0.0), Degree,
            "direction at the start", Absent;
    }
}

section! {
    /// `[[clearance]]`: a clearance between rotor and stator.
    struct ClearanceSection {
        axial_mm => axial_mm: Option<AsGiven> = Optional, Millimetre, PLACE, Absent;
        node => node: Option<usize> = Optional, Plain; AtLeast(0.0), NODE, Absent;
        name => name: String = Required, Plain, "name of the plane in results", Absent;
        radial_um => radial_um: AsGiven = Required, Micrometre; Above(0.0),
            "radial clearance between rotor and stator in the plane", Absent;
    }
}

/// A number in the unit of the file, which a rotor keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AsGiven(pub f64);

field!(AsGiven, Kind::Number, |reader, name, node| {
    reader.number(name, node)?;
    reader.plain_number(name, node).map(Self)
});

/// The path of another file, or its content as a section, which its own reader reads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FileOrSection;

field!(FileOrSection, Kind::Text, |reader, name, node| {
    match node.value {
        Value::Text(_) | Value::Section(_) => Ok(Self),
        _ => Err(reader.refuse(name, node, "the path of its file in quotes")),
    }
});

field!(Vec<usize>, Kind::Numbers, |reader, name, node| {
    match &node.value {
        Value::List(items) => items
            .iter()
            .map(|item| usize::read(reader, name, item))
            .collect(),
        _ => Err(reader.refuse(name, node, "a list of nodes in brackets")),
    }
});

/// Keys of the section `[rotor]` of a case that the rotor of the file replaces.
pub(super) const REPLACED: [&str; 6] = [
    "mass_kg",
    "polar_inertia_kg_m2",
    "speed_rpm",
    "drive_torque_n_m",
    "eccentricity_um",
    "eccentricity_phase_deg",
];
