//! Attributes of results in Python follow from the table of quantities and from the figures by name:
//! `CAGELESS_WRITE=1 cargo test -p cageless-report --test all attributes` writes them after one was
//! added.

use std::fmt::Write;
use std::path::Path;

use cageless_report::figures;
use cageless_results::{Kind, Quantity, of_kind};

const FILE: &str = "crates/cageless-py/python/cageless/attributes.py";
const HEAD: &str = r#""""Attributes of results with their types: scalar results with label and unit, NaN where there is no
number; figures.

Written by ``cargo test -p cageless-report --test all attributes`` from the table of quantities.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    import plotly.graph_objects as go

Floats = npt.NDArray[np.float64]
"#;

/// Kinds of results with attributes.
const KINDS: [&str; 8] = [
    "run",
    "drop",
    "static",
    "design",
    "search",
    "tolerance",
    "comparison",
    "analysis",
];

fn annotation(quantity: &Quantity) -> &'static str {
    match quantity.kind {
        Kind::Number => "float",
        Kind::Integer => "int | None",
        Kind::Flag => "bool | None",
        // What decided nothing has no criterion.
        Kind::Text if quantity.name == "criterion" => "str | None",
        Kind::Text => "str",
        Kind::Numbers | Kind::Few | Kind::Range => "Floats",
    }
}

fn attributes() -> String {
    let mut text = HEAD.to_owned();
    for kind in KINDS {
        let (first, rest) = kind.split_at(1);
        let class = first.to_uppercase() + rest;
        let _ = write!(
            text,
            "\n\nclass {class}Attributes:\n    \"\"\"Attributes of a result of this kind.\"\"\"\n\n"
        );
        for q in of_kind(kind) {
            let unit = match q.unit {
                "" => String::new(),
                unit => format!(", {unit}"),
            };
            let (label, name) = (q.label.trim(), q.name);
            let _ = writeln!(text, "    {name}: {}  # {label}{unit}", annotation(q));
        }
        for (name, about) in figures::of_kind(kind) {
            let _ = writeln!(text, "    plot_{name}: Callable[..., go.Figure]  # {about}");
        }
    }
    text
}

#[test]
fn python_has_the_attributes_of_every_kind() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(FILE);
    let expected = attributes();
    if std::env::var_os("CAGELESS_WRITE").is_some() {
        std::fs::write(&path, &expected).unwrap();
    }
    assert!(
        std::fs::read_to_string(&path).unwrap() == expected,
        "{FILE} is not what the table of quantities gives: CAGELESS_WRITE=1 cargo test \
         -p cageless-report --test all attributes"
    );
}
