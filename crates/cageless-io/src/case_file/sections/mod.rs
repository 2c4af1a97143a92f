//! The sections of the case file, one file each: the declaration of their keys, and what
//! a section completes by itself.

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

use super::declaration::{SectionKeys, section};
use super::document::{CaseDocument, SCHEMA};
use super::error::CaseError;
use super::key::Line::{Absent, Shown};
use super::key::Presence::Optional;
use super::key::{Key, default};
use super::reader::Reader;
use super::spanned_toml::{Node, Section, Value};
use super::unit::Unit::None as Plain;

/// One section of the file format.
#[derive(Debug)]
pub(crate) struct SectionTable {
    pub name: &'static str,
    /// What the section holds.
    pub meaning: &'static str,
    pub keys: &'static [Key],
    /// Whether the section may be left out as a whole, and then has no values.
    pub optional: bool,
    /// Whether there may be several of the name.
    pub several: bool,
    /// Its heading in the template: in force or not, with a comment.
    pub heading: Heading,
}

/// Heading of a section in the template.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Heading {
    /// In force.
    Shown(&'static str),
    /// The whole section is commented out.
    Commented(&'static str),
    /// The template does not have it.
    Absent,
}

/// A kind of section: required or with defaults, optional, or several of one name.
trait SectionField: Sized {
    const KEYS: &'static [Key];
    const OPTIONAL: bool = true;
    const SEVERAL: bool = false;

    /// Takes the sections of the name that are there, or a reader that misses every key.
    fn read(sections: &[Reader<'_>], missing: &Reader<'_>) -> Result<Self, CaseError>;
}

impl<D: SectionKeys> SectionField for D {
    const KEYS: &'static [Key] = D::KEYS;
    const OPTIONAL: bool = false;

    fn read(sections: &[Reader<'_>], missing: &Reader<'_>) -> Result<Self, CaseError> {
        D::read(sections.first().unwrap_or(missing))
    }
}

impl<D: SectionKeys> SectionField for Option<D> {
    const KEYS: &'static [Key] = D::KEYS;

    fn read(sections: &[Reader<'_>], _: &Reader<'_>) -> Result<Self, CaseError> {
        sections.first().map(D::read).transpose()
    }
}

impl<D: SectionKeys> SectionField for Vec<D> {
    const KEYS: &'static [Key] = D::KEYS;
    const SEVERAL: bool = true;

    fn read(sections: &[Reader<'_>], _: &Reader<'_>) -> Result<Self, CaseError> {
        sections.iter().map(D::read).collect()
    }
}

/// Declares the sections in the order of the file format.
macro_rules! case_sections {
    ($( $section:ident: $Keys:ty, $meaning:literal, $heading:expr; )*) => {
        /// The sections of a case file in SI units.
        #[derive(Debug)]
        pub(crate) struct CaseSections {
            pub head: HeadSection,
            $( #[doc = $meaning] pub $section: $Keys, )*
        }

        /// Sections and what each holds, in the order of the template.
        pub(crate) const SECTIONS: &[SectionTable] = &[ $( SectionTable {
            name: stringify!($section),
            meaning: $meaning,
            keys: <$Keys as SectionField>::KEYS,
            optional: <$Keys as SectionField>::OPTIONAL,
            several: <$Keys as SectionField>::SEVERAL,
            heading: $heading,
        }, )* ];

        impl CaseSections {
            /// Reads the sections of a complete document.
            pub(super) fn read(document: &CaseDocument) -> Result<Self, CaseError> {
                let head = <HeadSection as SectionKeys>::read(&Reader {
                    tree: &document.tree,
                    section: "",
                    keys: HEAD,
                    path: String::new(),
                    entries: Some(&document.tree.root),
                })?;
                let mut tables = SECTIONS.iter();
                $( let $section = read_section(document, tables.next())?; )*
                Ok(Self { head, $( $section, )* })
            }
        }
    };
}

fn read_section<T: SectionField>(
    document: &CaseDocument,
    table: Option<&'static SectionTable>,
) -> Result<T, CaseError> {
    let table = table.unwrap_or(&SECTIONS[0]);
    let reader = |path, entries| Reader {
        tree: &document.tree,
        section: table.name,
        keys: table.keys,
        path,
        entries,
    };
    let sections = document.sections(table)?.into_iter();
    let readers: Vec<_> = sections
        .map(|(path, entries)| reader(path, Some(entries)))
        .collect();
    T::read(&readers, &reader(table.name.to_owned(), None))
}

case_sections! {
    bearing: bearing::BearingSection, "dimensions and masses of rings and balls", Heading::Shown("");
    material: material::MaterialSection, "elastic material of rings and balls",
        Heading::Shown("of rings and balls: bearing steel");
    ball_material: Option<material::PartMaterialSection>, "material of the balls, if different",
        Heading::Commented("of the balls, if different (hybrid bearing)");
    ring_material: Option<material::PartMaterialSection>, "material of the rings, if different",
        Heading::Commented("of the rings, if different");
    raceway: Vec<raceway::RacewaySection>, "the discrete raceway",
        Heading::Shown("several: [[raceway]] sections; none: a conventional ring");
    operation: operation::OperationSection, "speed and load", Heading::Shown("");
    contact: cageless::Contact, "friction, damping and stiffness", Heading::Shown("");
    model: model::ModelSection, "the set of equations", Heading::Shown("");
    start: start::StartSection, "the initial state",
        Heading::Commented("the whole section may be left out");
    solver: solver::SolverSection, "integration", Heading::Shown("");
    housing: Option<cageless::Housing>, "the support of the outer ring",
        Heading::Commented("support of the outer ring; gives its vibration");
    rotor: Option<cageless::Rotor>, "a rotor that falls onto the inner ring",
        Heading::Absent;
    support: Option<support::SupportSection>, "support of the outer ring under a falling rotor",
        Heading::Absent;
    output: cageless::Output, "what a run writes", Heading::Shown("");
    search: Option<search::SearchSection>, "what a search for the raceway looks at",
        Heading::Commented("ranges of `design --search`");
}

section! {
    /// The head of the file.
    struct HeadSection {
        schema => schema: u64 = default(SCHEMA as i64), Plain,
            "version of the file format", Shown("1", "version of this file format");
        title => title: String = default(""), Plain,
            "free text", Shown("\"Zhao 2022, structure (d)\"", "free text");
        seed => seed: Option<u64> = Optional, Plain,
            "solver.seed, which may be given here as well", Absent;
    }
}

/// Keys of the head of the file.
pub(crate) const HEAD: &[Key] = <HeadSection as SectionKeys>::KEYS;

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
