//! Files of the repository that follow from the declaration of the case file: the table of the
//! documentation and the Python classes. Schemas of editors: `derived_files_for_editors`. `CAGELESS_WRITE=1 cargo test -p cageless-io --test
//! derived_files` writes them after a key was added.

use std::fmt::Write;
use std::path::Path;

use cageless_io::case_file::{CaseValue, Key, Kind, Presence, RangeEnd, SectionTable, reference};

pub fn in_step(path: &str, expected: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path);
    if std::env::var_os("CAGELESS_WRITE").is_some() {
        std::fs::write(&path, expected).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap();
    assert!(
        found == expected,
        "{} is not what the declarations give: \
         CAGELESS_WRITE=1 cargo test -p cageless-io --test all derived_files",
        path.display()
    );
}

fn names(names: &[&str]) -> String {
    let quoted: Vec<_> = names.iter().map(|n| format!("`\"{n}\"`")).collect();
    quoted.join(", ")
}

fn value(value: Kind) -> String {
    match value {
        Kind::Number => "number".to_owned(),
        Kind::Whole => "whole number".to_owned(),
        Kind::Text => "text".to_owned(),
        Kind::Numbers => "list of numbers".to_owned(),
        Kind::Range => "number or `[lowest, highest]`".to_owned(),
        Kind::OverTime => "number or `[[time in s, value], …]`".to_owned(),
        Kind::Rows(row) => format!("`[{row}, …]`"),
        Kind::Choice(choices) => names(&choices()),
        Kind::NumberOr(choices) => format!("number, {}", names(choices)),
        Kind::NumbersOr(choices) => format!("list of numbers, {}", names(choices)),
    }
}

fn left_out(key: &Key) -> String {
    match (key.presence)() {
        Presence::Required => "required".to_owned(),
        Presence::Default(value) => format!("`{}`", value.written()),
        Presence::Derived => "derived".to_owned(),
        Presence::Optional => "none".to_owned(),
    }
}

/// `0.5 to 1300`, `above 0`, `(0 to 90)`.
fn range(range: [Option<RangeEnd>; 2]) -> String {
    let at = |end: RangeEnd| CaseValue::Number(end.at).written();
    match range {
        [None, None] => String::new(),
        [Some(low), None] if low.included => format!("{} or more", at(low)),
        [Some(low), None] => format!("above {}", at(low)),
        [None, Some(high)] => format!("up to {}", at(high)),
        [Some(low), Some(high)] => format!(
            "{}{} to {}{}",
            if low.included { "" } else { "(" },
            at(low),
            at(high),
            if high.included { "" } else { ")" },
        ),
    }
}

#[test]
fn the_table_of_the_documentation_has_every_key() {
    let mut text = String::from(
        "# Case file\n\n\
         One bearing, its operating conditions and the simulation, in TOML. `cageless new` prints a commented \
         case file,\nand `cageless check` validates one. Names of keys end in their unit. The tables are generated \
         from the source:\n\n\
         - *derived*: the value follows from the rest of the case unless given; `cageless check` lists it with the \
         defaults\n\
         - *formerly*: the name in earlier versions, read as well\n\
         - *range*: what a number may be whatever the other values are, without ends in parentheses\n\n\
         Editors with a TOML language server complete keys and mark impossible values by the JSON schema\n\
         [case-file.schema.json](case-file.schema.json), named in the first line of the case file:\n\
         `#:schema case-file.schema.json`. Plans and rotor files have [plan.schema.json](plan.schema.json) and\n\
         [rotor-file.schema.json](rotor-file.schema.json). Releases have all three in `docs`, the Python package in \
         its folder\n`schemas`.\n",
    );
    for section in reference() {
        let heading = match (section.name, section.optional) {
            ("", _) => "Head of the file".to_owned(),
            (name, false) => format!("`[{name}]`: {}", section.meaning),
            (name, true) => format!("`[{name}]`: {} (optional)", section.meaning),
        };
        let _ = write!(
            text,
            "\n## {heading}\n\n| key | value | unit | range | if left out | meaning |\n|---|---|---|---|---|---|\n"
        );
        for key in section.keys {
            let _ = writeln!(
                text,
                "| `{}` | {} | {} | {} | {} | {}{} |",
                key.name,
                value(key.kind),
                key.unit(),
                range(section.range(key)),
                left_out(key),
                key.meaning.replace('|', "\\|"),
                match key.formerly {
                    "" => String::new(),
                    former => format!("; formerly `{former}`"),
                },
            );
        }
    }
    in_step("docs/case-file.md", &text);
}

const PYTHON_HEAD: &str = r#""""The sections of a case. Fields are the keys of the case file, in its units, with their meaning; what
is left ``None`` takes its default.

Written by ``cargo test -p cageless-io --test all derived_files`` from the declaration of the case file.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypedDict

from .section import Section

if TYPE_CHECKING:
    from typing_extensions import Required

    from .rotors import LinearRotor

"#;

/// What the class of `[rotor]` has beside its fields.
const ROTOR_METHODS: &str = r#"
    @staticmethod
    def from_ross(rotor: Any, nodes: Sequence[int], **options: Any) -> LinearRotor:
        """A rotor on several bearings, from ROSS: :meth:`LinearRotor.from_ross`."""
        from .rotors import LinearRotor

        return LinearRotor.from_ross(rotor, nodes, **options)
"#;

/// Class of a section: `ball_material` and `material` are both a `Material`.
fn class(section: &SectionTable) -> String {
    let last = section.name.rsplit('_').next().unwrap_or_default();
    let (first, rest) = last.split_at(1);
    first.to_uppercase() + rest
}

fn literal(names: &[&str]) -> String {
    let quoted: Vec<_> = names.iter().map(|n| format!("\"{n}\"")).collect();
    format!("Literal[{}]", quoted.join(", "))
}

fn annotation(value: Kind) -> String {
    match value {
        Kind::Number => "float".to_owned(),
        Kind::Whole => "int".to_owned(),
        Kind::Text => "str".to_owned(),
        Kind::Numbers => "Sequence[float]".to_owned(),
        Kind::Range => "float | Sequence[float]".to_owned(),
        Kind::OverTime => "float | Sequence[Sequence[float]]".to_owned(),
        Kind::Rows(_) => "Sequence[Sequence[float]]".to_owned(),
        Kind::Choice(names) => literal(&names()),
        Kind::NumberOr(names) => format!("{} | float", literal(names)),
        Kind::NumbersOr(names) => format!("{} | Sequence[float]", literal(names)),
    }
}

#[test]
fn python_has_a_class_for_every_section() {
    let mut written: Vec<String> = vec![];
    let (mut classes, mut sections, mut arguments) = (String::new(), String::new(), String::new());
    for section in reference() {
        // Keys of the head are arguments of `Case`; the ranges of a search are those of `Case.search`.
        match section.name {
            "" => {
                for key in section.keys {
                    let _ = writeln!(arguments, "    {}: {}", key.name, annotation(key.kind));
                }
                continue;
            }
            "search" => {
                arguments.push_str("    search: Keys | None\n");
                continue;
            }
            _ => {}
        }
        let (class, name) = (class(&section), section.name);
        let _ = match name {
            _ if section.several => writeln!(
                arguments,
                "    {name}: {class} | Keys | Sequence[{class} | Keys] | None"
            ),
            "bearing" | "operation" => writeln!(arguments, "    {name}: Required[{class} | Keys]"),
            _ => writeln!(arguments, "    {name}: {class} | Keys | None"),
        };
        if !section.several {
            let none = if section.optional { " | None" } else { "" };
            let _ = writeln!(sections, "    {name}: {class}{none}");
        }
        if written.contains(&class) {
            continue;
        }
        let _ = write!(
            classes,
            "\n\n@dataclass(frozen=True, kw_only=True)\nclass {class}(Section):\n    \"\"\"`[{name}]`: {}.\"\"\"\n\n",
            section.meaning,
        );
        // Keyword arguments, so that the order is that of the file.
        for key in section.keys {
            let kind = annotation(key.kind);
            let (none, default) = match (key.presence)() {
                Presence::Required => ("", ""),
                _ => (" | None", " = None"),
            };
            let _ = writeln!(
                classes,
                "    {}: Annotated[{kind}{none}, {:?}]{default}",
                key.name, key.meaning
            );
        }
        if name == "rotor" {
            classes.push_str(ROTOR_METHODS);
        }
        written.push(class);
    }
    let mut all = written;
    all.push("Section".to_owned());
    all.sort();
    let all = all.join("\", \"");
    let text = format!(
        "{PYTHON_HEAD}__all__ = [\"{all}\"]\n\nKeys = Mapping[str, Any]\n{classes}\n\nclass OfCase:\n    \
         \"\"\"Sections of a case, None where it has none.\"\"\"\n\n{sections}\n\n\
         class Arguments(TypedDict, total=False):\n    \
         \"\"\"Keywords of a case: its sections, or mappings of their keys.\"\"\"\n\n{arguments}"
    );
    in_step("crates/cageless-py/python/cageless/sections.py", &text);
}

/// Changes by which a case can have a key.
fn needed(section: &str, key: &str) -> Vec<String> {
    let stribeck = ["static_friction_coefficient=0.5", "stribeck_speed_m_s=1.0"];
    let all = match (section, key) {
        ("support", _) => vec!["stop_gap_um=9", "stop_stiffness_n_m=1e8"],
        ("row", _) => vec!["axial_position_mm=0"],
        ("film", _) => vec!["supply=1", "oil=iso-vg-32", "temperature_c=70"],
        (_, "static_friction_coefficient") => vec!["friction_law=stribeck", stribeck[1]],
        (_, "stribeck_speed_m_s") => vec!["friction_law=stribeck", stribeck[0]],
        _ => vec![],
    };
    let all = all.into_iter().map(|change| format!("{section}.{change}"));
    all.collect()
}

/// The ends of a range in schema and documentation are those that the reader keeps: what is beyond
/// is refused for its key, and no value at an end is refused for these limits.
#[test]
fn ranges_are_those_of_the_reader() {
    use cageless_io::case_file::CaseFile;
    // Every commented line of the template in force.
    let template = cageless_io::case_file::template(false);
    let dry = crate::common::without_film(&template);
    let lines = dry.lines().map(|line| match line.strip_prefix("# ") {
        Some(key) if key.starts_with('[') => key,
        Some(key)
            if key
                .split_once(" = ")
                .is_some_and(|(key, _)| !key.contains(' ')) =>
        {
            key
        }
        _ => line,
    });
    let case = lines.collect::<Vec<_>>().join("\n");
    let case = case.replace("\"settled\"", "\"rolling\"");
    let drop = include_str!("../../../cases/touchdown-d.toml");
    let mut ends = 0;
    for section in reference() {
        for key in section.keys {
            let name = format!("{}.{}", section.name, key.name);
            for (end, sign) in section.range(key).into_iter().zip([-1.0, 1.0]) {
                let Some(end) = end else { continue };
                let step = if matches!(key.kind, Kind::Whole) {
                    1.0
                } else {
                    1e-3 * end.at.abs().max(1.0)
                };
                let (beyond, within) = match end.included {
                    true => (end.at + sign * step, end.at),
                    false => (end.at, end.at - sign * step),
                };
                let dropped = ["rotor.", "support.", "bearing.inner_ring_"];
                let text = match dropped.iter().any(|start| name.starts_with(start)) {
                    true => drop,
                    // Used where balls and rings have no material of their own, and ratings no viscosity.
                    false if ["material", "film"].contains(&section.name) => template.as_str(),
                    false => case.as_str(),
                };
                let parse = |at: f64| {
                    let value = match key.kind {
                        Kind::Numbers => format!("[{at:?}]"),
                        Kind::Whole => format!("{at}"),
                        _ => format!("{at:?}"),
                    };
                    let mut set = needed(section.name, key.name);
                    set.push(format!("{name}={value}"));
                    CaseFile::parse(text, "case.toml", &set)
                };
                let error = parse(beyond).unwrap_err();
                assert!(
                    error.key() == Some(&name) && error.to_string().contains("--set"),
                    "{name} = {beyond}: {error}"
                );
                // What else is refused there has other words.
                let allowed = |text: &str| text.split_once("it must be").map(|(_, a)| a.to_owned());
                if let Err(other) = parse(within).map_err(|e| e.to_string()) {
                    assert_ne!(allowed(&other), allowed(&error.to_string()), "{other}");
                }
                ends += 1;
            }
        }
    }
    assert!(ends > 80, "{ends}");
}
