//! The sections of the case file, one file each: the declaration of their keys, and what
//! a section completes by itself.

pub(crate) mod bearing;
pub(crate) mod contact;
pub(crate) mod film;
pub(crate) mod fit;
pub(crate) mod friction;
pub(crate) mod housing;
pub(crate) mod limit;
pub(crate) mod lubrication;
pub(crate) mod material;
pub(crate) mod model;
pub(crate) mod operation;
pub(crate) mod output;
pub(crate) mod raceway;
pub(crate) mod rotor;
pub(crate) mod row;
pub(crate) mod search;
pub(crate) mod solver;
pub(crate) mod start;
pub(crate) mod steady;
pub(crate) mod support;
pub(crate) mod thermal;

use super::declaration::prelude::*;
use super::spanned_toml::Section;

sections! {
    /// The sections of a case file in SI units.
    CaseSections, CASE_FILE, "case file", HeadSection {
    bearing: bearing::BearingSection, "dimensions and masses of rings and balls", Heading::Shown("");
    material: material::MaterialSection, "elastic material of rings and balls",
        Heading::Shown("of rings and balls: bearing steel");
    ball_material: Option<material::PartMaterialSection>, "material of the balls, if different",
        Heading::Commented("of the balls, if different (hybrid bearing)");
    ring_material: Option<material::PartMaterialSection>, "material of the rings, if different",
        Heading::Commented("of the rings, if different");
    raceway: Vec<raceway::RacewaySection>, "the discrete raceway",
        Heading::Shown("several: [[raceway]] sections; none: a conventional ring");
    row: Vec<cageless::Row>, "a row of balls, where one inner ring has several",
        Heading::Absent;
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
    thermal: Option<cageless::touchdown::Thermal>, "what the heat of drops warms",
        Heading::Absent;
    limit: Vec<cageless::touchdown::Limit>, "a limit on a result, with whose it is",
        Heading::Absent;
    fit: Option<cageless::Fit>, "fits and temperatures, from which the clearance in operation follows",
        Heading::Commented("fits and temperatures: the clearance in operation");
    lubrication: Option<cageless::Lubrication>, "the lubricant, for modified life and minimum load of `static`",
        Heading::Commented("lubricant, for modified life and minimum load of `static`");
    film: Option<film::FilmSection>, "oil film of the rolling contacts, which resists rolling and spaces balls",
        Heading::Commented("oil film, which resists rolling and spaces balls");
    output: output::OutputSection, "what a run writes", Heading::Shown("");
    steady: Option<steady::SteadySection>, "steady operation with real balls, for `compare`",
        Heading::Commented("steady operation with real balls, for `cageless compare`");
    search: Option<search::SearchSection>, "what a search for the raceway looks at",
        Heading::Commented("ranges of `design --search`");
}}

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

/// A key that `key` needs next to it, by those that give way to it: a clearance takes the pitch diameter of the
/// groove radii and the other way round, one of these radii the other one of pitch diameter and clearance.
pub(super) fn derived_of(
    name: &str,
    key: &str,
    section: &Section,
    node: &Node,
) -> Option<(String, Node)> {
    const INNER: &str = "inner_groove_bottom_radius_mm";
    const OUTER: &str = "outer_groove_bottom_radius_mm";
    const PITCH: &str = "pitch_diameter_mm";
    const CLEARANCE: &str = "radial_internal_clearance_um";
    if name != "bearing" {
        return None;
    }
    let number = |key: &str| match section.get(key)?.value {
        Value::Number(value) => Some(value),
        Value::Integer(value) => Some(value as f64),
        _ => None,
    };
    let ball = || {
        let radius = number("ball_radius_mm").map(|radius| 2.0 * radius);
        radius.or_else(|| number("ball_diameter_mm"))
    };
    // Ri + Ro = Dpw and 2 (Ro − Ri − Dw) = Gr.
    let half = || Some(0.5 * ball()? + 0.25e-3 * number(CLEARANCE)?);
    let (needed, value) = match key {
        CLEARANCE => (PITCH, number(INNER)? + number(OUTER)?),
        PITCH => (CLEARANCE, 2e3 * (number(OUTER)? - number(INNER)? - ball()?)),
        INNER => (OUTER, 0.5 * number(PITCH)? + half()?),
        OUTER => (INNER, 0.5 * number(PITCH)? - half()?),
        _ => return None,
    };
    // Millimetres of a drawing do not add up exactly; not −0.
    let value = Value::Number((value * 1e9).round() / 1e9 + 0.0);
    let node = Node {
        value,
        ..node.clone()
    };
    Some((needed.to_owned(), node))
}

/// Keys of a section that say the same: either those of the first column or those of the second.
pub(super) fn alternatives_in(
    section: &str,
) -> &'static [(&'static [&'static str], &'static [&'static str])] {
    match section {
        "bearing" => bearing::ALTERNATIVES,
        "fit" => fit::ALTERNATIVES,
        _ => &[],
    }
}

/// Keys of a section that say the same as `key`, and give way to it.
pub(crate) fn alternatives_of(section: &str, key: &str) -> &'static [&'static str] {
    match section {
        "bearing" | "fit" => {
            let found = alternatives_in(section).iter().find_map(|(one, other)| {
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
