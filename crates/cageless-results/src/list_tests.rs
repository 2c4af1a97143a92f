//! The list of results of the documentation, which follows from the table of results:
//! `CAGELESS_WRITE=1 cargo test -p cageless-results --lib list` writes it.

use std::fmt::Write;
use std::path::Path;

use crate::table::*;
use crate::{
    Across, Aim, DESIGN, DROP, Kind, PASSAGES, Quantity, RACEWAY, ROTOR_DROP, RUN, STATIC, VERDICT,
    quantities,
};

const HEAD: &str = "# Results

This page lists every result with its unit and its definition. Names are the same in JSON, in the columns of
sweeps and in Python, and end in their unit; `_deg` is °, `_um` µm, `_mpa` MPa. The table is generated from the source.

*Better* is the direction in which a bearing is better, where there is one. A column of a sweep is named
after its computation: `run_collisions`, and `drop_bearing_2_collisions` for one of several bearings. Results marked \u{2020} are in no sweep.

Tables of a run over time: [command line and result files](command-line.md). Symbols: [glossary](glossary.md).
";

/// Table, heading, and where its results are.
#[rustfmt::skip]
const SECTIONS: [(&[Quantity], &str, &str); 46] = [
    (STATIC, "Static equilibrium", "In `cageless static --json`, `static.json`, its page and the columns `static_\u{2026}` of a sweep."),
    (DEFECTS, "Static equilibrium: frequencies of defects", "In `cageless static --json`, `static.json` and its page, next to those above: the table for vibration analysts, in pure rolling. A bearing without a cage has the orbital frequency of its balls in the place of a cage's."),
    (FIT, "Static equilibrium with fits and temperatures", "In `cageless static --json`, `static.json` and its page, next to those above, for a case with `[fit]`."),
    (CLEARANCE_RANGE, "Static equilibrium with tolerances of shaft, housing or clearance", "Next to those above, for a case with `fit.shaft`, `fit.housing` or `fit.clearance_tolerance_um`."),
    (LUBRICATION, "Static equilibrium with a lubricant", "In `cageless static --json`, `static.json` and its page, next to those above, for a planar case with `[lubrication]`."),
    (SPACE, "Static equilibrium in space", "In `cageless static --json`, `static.json` and its page, next to those above, for a case with an axial load, moments, a tilt, a contact angle or several rows."),
    (DESIGN, "Design: closed forms", "In `cageless design --json`, `design.json`, its page and the columns `design_\u{2026}` of a sweep."),
    (CONTACT_ANGLE, "Design: contact angle", "In `cageless design --json`, `design.json` and its page: estimates of what an axial load or a tilt would leave of the first raceway."),
    (PROFILE, "Design: measured raceway", "In `cageless design --json`, `design.json` and its page, next to those above, for a case with `raceway.profile`, and for each of `raceways` of `cageless measure --json`."),
    (MEASURED, "Measured ring", "In `cageless measure --json`, `measure.json` and its page."),
    (FRAME, "Measured ring: frame", "Under `frame` of `measure.json`: shift, tilt, turn about z and errors of the radii, each in its unit."),
    (DIMENSION, "Measured ring: dimensions", "Under `dimensions` of each of `raceways` of `measure.json`, each in its unit."),
    (GROOVE, "Measured raceways", "For each of `raceways` of `cageless measure --json` and `measure.json`."),
    (SLOT, "Measured slots", "Next to those above for a slot."),
    (AXIAL, "Design: axial load and tilt", "Under `axial` of `cageless design --axial --json` and `design.json`, from motion in space with the balls evenly spaced at the start; lists have an element for each pair of axial load and tilt."),
    (VERDICT, "Design: verdict from the motion", "In `cageless design --json`, `design.json`, its page and the columns `verdict_\u{2026}` of a sweep."),
    (PASSAGES, "Design: passages of the raceway", "Under `passages` of `cageless design --json` and `design.json`, and in the columns `verdict_\u{2026}` of a sweep."),
    (RACEWAY, "Design: each raceway", "Under `raceways` of `cageless design --json` and `design.json`."),
    (RECOMMENDATION, "Design: recommendation", "Under `recommendation` of `cageless design --json` and `design.json`."),
    (CURVE, "Design: curve of Eq. (11)", "Under `curve` of `cageless design --json` and `design.json`."),
    (RUN, "Run", "In `cageless run --json`, `summary.json`, its page and the columns `run_\u{2026}` of a sweep. Statistics are over the time after the transient, `settled_after_s`."),
    (DROP, "Rotor drop", "In `cageless drop --json`, `summary.json`, its page and the columns `drop_\u{2026}` of a sweep. *Rotor* is how the result of a rotor on several touch-down bearings follows from those of its bearings, which are under `bearings`."),
    (ROTOR_DROP, "Rotor drop: the rotor on several bearings", "In the columns `drop_\u{2026}` of a sweep of a rotor file. `cageless drop --json` has the margin of each plane under `clearances`, and the energy balance error under `rotor`, as `energy_residual_relative`."),
    (PLANE, "Rotor drop: planes with a clearance", "Under `clearances` of `cageless drop --json` of a rotor file."),
    (SUCCESSION, "Rotor drop: drops in succession", "Under `succession` of `cageless drop --json` and `summary.json`, for each drop and bearing, with the list `reasons`."),
    (SEARCH, "Search", "Under `search` of `cageless design --search --json` and `design.json`, with the sentences `findings`."),
    (POINT, "Search: operating points", "Under `search.points`, and `point` of each of `search.maps`."),
    (STRUCTURE, "Search: structures", "Under `search.recommended`, `unconfirmed`, `own`, `recommended_from_usual_starts`, `own_from_usual_starts`, `front`, `band` and `placements` (`best`)."),
    (STRUCTURE_AT, "Search: a structure at an operating point", "Under `points` of a structure."),
    (MOTION, "Search: motion of all balls", "Under `motion` of a structure at an operating point, means over the initial states, and `errors`, their standard errors."),
    (REJECTION, "Search: excluded structures", "Under `search.rejections`."),
    (PLACEMENT, "Search: angular positions and shapes", "Under `search.placements`."),
    (MAP, "Search: maps", "Under `search.maps`: a list of rows of equal θ."),
    (PAPER, "Search: structures of the paper", "Under `search.paper`, for the bearing of Zhao 2022."),
    (TOLERANCE, "Tolerance analysis", "In `cageless tolerance --json`, `tolerance.json` and its page."),
    (INFLUENCE, "Tolerance analysis: one influence at a time", "Under `influences` of `tolerance.json`, with the list `verdicts`. Ranges are over the bearings with this deviation and the nominal one."),
    (SAMPLES, "Tolerance analysis: everything at once", "Under `samples` of `tolerance.json`."),
    (STEADY, "Steady operation", "In `cageless compare --json` and `compare.json`: means over the draws of balls with their standard errors."),
    (COMPARED, "Comparison of outer rings", "In `cageless compare --json` and `compare.json`, with the results of a run and of steady operation: means over the draws with their standard errors, differences and what is better. `benefits` has `benefit`, `benefit_reasons`, score and criteria of each ring against the first, `verdicts` whether single balls are slowed as intended."),
    (VERIFICATION, "Verification of a run", "Under `verification` of `cageless run --verify --json` and `summary.json`."),
    (VERIFIED, "Verification of a run: results that are judged", "Under `verification.numbers`."),
    (DROP_VERIFICATION, "Verification of a drop", "Under `verification` of `cageless drop --verify --json` and `summary.json`; of a rotor on several bearings under `verification.bearings`."),
    (ROTOR_VERIFICATION, "Verification of a drop of a rotor on several bearings", "Under `verification` of `cageless drop --verify --json` of a rotor file, with `bearings`."),
    (JUDGEMENT, "Verification: the judgement of a result", "Each of `verification.numbers`, in the unit of the result."),
    (DISTANCE, "Verification of a run: distances of the replicas", "Under `verification.distance`."),
    (VERDICT_COUNT, "Tolerance analysis: bearings by verdict", "Under `samples.verdicts` of `tolerance.json`."),
];

fn better(quantity: &Quantity) -> &'static str {
    match quantity.aim {
        Some(Aim::Low) => "lower",
        Some(Aim::High) => "higher",
        None => "",
    }
}

/// Label and definition. Labels of parts are indented in tables.
fn definition(quantity: &Quantity) -> String {
    let (label, meaning) = (quantity.label.trim(), quantity.meaning);
    let label = match quantity.kind {
        Kind::Numbers | Kind::Few | Kind::Range => format!("{label} (list)"),
        _ => label.to_owned(),
    };
    match meaning {
        "" => label,
        _ => format!("{label}: {meaning}"),
    }
}

fn across(quantity: &Quantity) -> &'static str {
    match quantity.across {
        None => "",
        Some(Across::Largest) => "largest",
        Some(Across::LargestOfAll) => "largest, if all have one",
        Some(Across::Smallest) => "smallest",
        Some(Across::Sum) => "sum",
        Some(Across::Same) => "the same",
        Some(Across::Verdict) => "all bearings and planes",
        Some(Across::WorstState) => "the worst",
    }
}

#[test]
fn the_list_of_results_has_every_quantity() {
    let mut text = HEAD.to_owned();
    for (table, heading, introduction) in SECTIONS {
        let with_rotor = table.iter().any(|q| q.across.is_some());
        let (more, rule) = if with_rotor {
            (" rotor |", "---|")
        } else {
            ("", "")
        };
        let _ = write!(
            text,
            "\n## {heading}\n\n{introduction}\n\n| name | unit | better | definition |{more}\n|---|---|---|---|{rule}\n"
        );
        for quantity in table {
            let mark = if quantity.in_sweeps { "" } else { " \u{2020}" };
            let _ = write!(
                text,
                "| `{}`{mark} | {} | {} | {} |",
                quantity.name,
                quantity.unit_text(),
                better(quantity),
                definition(quantity),
            );
            let _ = match with_rotor {
                true => writeln!(text, " {} |", across(quantity)),
                false => writeln!(text),
            };
        }
    }
    assert_eq!(
        SECTIONS.iter().map(|s| s.0.len()).sum::<usize>(),
        quantities().count()
    );
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/results.md");
    if std::env::var_os("CAGELESS_WRITE").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    assert!(
        std::fs::read_to_string(&path).unwrap() == text,
        "docs/results.md is not what the table of results gives: \
         CAGELESS_WRITE=1 cargo test -p cageless-results --lib list"
    );
}

#[test]
fn a_definition_is_no_sentence_and_no_second_label() {
    for quantity in quantities().filter(|q| !q.meaning.is_empty()) {
        let (name, meaning) = (quantity.name, quantity.meaning);
        assert!(!meaning.ends_with('.'), "{name}");
        assert!(quantity.label.trim() != meaning, "{name}");
    }
}
