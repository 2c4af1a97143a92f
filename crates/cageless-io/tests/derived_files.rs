//! Files of the repository that follow from the declaration of the case file: the table of the
//! documentation and the Python classes. `CAGELESS_WRITE=1 cargo test -p cageless-io --test
//! derived_files` writes them after a key was added.

use std::fmt::Write;
use std::path::Path;

use cageless_io::case_file::{KeyReference, LeftOut, SectionReference, ValueType, reference};

fn in_step(path: &str, expected: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path);
    if std::env::var_os("CAGELESS_WRITE").is_some() {
        std::fs::write(&path, expected).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap();
    assert!(
        found == expected,
        "{} is not what the declaration of the case file gives: \
         CAGELESS_WRITE=1 cargo test -p cageless-io --test all derived_files",
        path.display()
    );
}

fn names(names: &[&str]) -> String {
    let quoted: Vec<_> = names.iter().map(|n| format!("`\"{n}\"`")).collect();
    quoted.join(", ")
}

fn value(value: &ValueType) -> String {
    match value {
        ValueType::Number => "number".to_owned(),
        ValueType::Whole => "whole number".to_owned(),
        ValueType::Text => "text".to_owned(),
        ValueType::Numbers => "list of numbers".to_owned(),
        ValueType::Range => "number or `[lowest, highest]`".to_owned(),
        ValueType::OverTime => "number or `[[time in s, value], …]`".to_owned(),
        ValueType::Rows(row) => format!("`[{row}, …]`"),
        ValueType::Choice(choices) => names(choices),
        ValueType::NumberOr(choices) => format!("number, {}", names(choices)),
        ValueType::NumbersOr(choices) => format!("list of numbers, {}", names(choices)),
    }
}

fn left_out(key: &KeyReference) -> String {
    match &key.left_out {
        LeftOut::Refused => "required".to_owned(),
        LeftOut::Default(value) => format!("`{}`", value.written()),
        LeftOut::Derived => "derived".to_owned(),
        LeftOut::Nothing => "none".to_owned(),
    }
}

#[test]
fn the_table_of_the_documentation_has_every_key() {
    let mut text = String::from(
        "# Case file\n\n\
         A case file describes one bearing, its operating conditions and the simulation, in TOML. \
         The names of its keys end in their unit. `cageless new` prints a commented case file, and \
         `cageless check` validates one. The tables are generated from the source and list every \
         key. *Derived*: the value follows from the rest of the case unless it is given; \
         `cageless check` lists it with the defaults. A name after *formerly* is that of earlier \
         versions, and is read as well.\n",
    );
    for section in reference() {
        let heading = match (section.name, section.optional) {
            ("", _) => "Head of the file".to_owned(),
            (name, false) => format!("`[{name}]`: {}", section.meaning),
            (name, true) => format!("`[{name}]`: {} (optional)", section.meaning),
        };
        let _ = write!(
            text,
            "\n## {heading}\n\n| key | value | unit | if left out | meaning |\n|---|---|---|---|---|\n"
        );
        for key in &section.keys {
            let _ = writeln!(
                text,
                "| `{}` | {} | {} | {} | {}{} |",
                key.name,
                value(&key.value),
                key.unit,
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
fn class(section: &SectionReference) -> String {
    let last = section.name.rsplit('_').next().unwrap_or_default();
    let (first, rest) = last.split_at(1);
    first.to_uppercase() + rest
}

fn literal(names: &[&str]) -> String {
    let quoted: Vec<_> = names.iter().map(|n| format!("\"{n}\"")).collect();
    format!("Literal[{}]", quoted.join(", "))
}

fn annotation(value: &ValueType) -> String {
    match value {
        ValueType::Number => "float".to_owned(),
        ValueType::Whole => "int".to_owned(),
        ValueType::Text => "str".to_owned(),
        ValueType::Numbers => "Sequence[float]".to_owned(),
        ValueType::Range => "float | Sequence[float]".to_owned(),
        ValueType::OverTime => "float | Sequence[Sequence[float]]".to_owned(),
        ValueType::Rows(_) => "Sequence[Sequence[float]]".to_owned(),
        ValueType::Choice(names) => literal(names),
        ValueType::NumberOr(names) => format!("{} | float", literal(names)),
        ValueType::NumbersOr(names) => format!("{} | Sequence[float]", literal(names)),
    }
}

#[test]
fn python_has_a_class_for_every_section() {
    let mut written: Vec<String> = vec![];
    let (mut classes, mut sections, mut arguments) = (String::new(), String::new(), String::new());
    for section in reference() {
        // The head is arguments of `Case`; the ranges of a search are those of `Case.search`.
        if ["", "search"].contains(&section.name) {
            continue;
        }
        let (class, name) = (class(&section), section.name);
        let _ = match name {
            "raceway" => writeln!(
                arguments,
                "    {name}: {class} | Keys | Sequence[{class} | Keys] | None"
            ),
            "bearing" | "operation" => writeln!(arguments, "    {name}: Required[{class} | Keys]"),
            _ => writeln!(arguments, "    {name}: {class} | Keys | None"),
        };
        if name != "raceway" {
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
        for key in &section.keys {
            let kind = annotation(&key.value);
            let (none, default) = match key.left_out {
                LeftOut::Refused => ("", ""),
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
         \"\"\"Keywords of a case: its sections, or mappings of their keys.\"\"\"\n\n{arguments}    title: str\n"
    );
    in_step("crates/cageless-py/python/cageless/sections.py", &text);
}
