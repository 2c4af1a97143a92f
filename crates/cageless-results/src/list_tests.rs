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

Every result with its unit and its definition. Names are the same in JSON, in the columns of sweeps and in Python, and
end in their unit; `_deg` is °, `_um` µm, `_mpa` MPa. The tables are generated from the source.

| results of | are in `--json`, the page and | columns of a sweep |
|---|---|---|
| `static` | `static.json` | `static_\u{2026}` |
| `design` | `design.json` | `design_\u{2026}`, of the motion `verdict_\u{2026}` |
| `run` | `summary.json` | `run_\u{2026}` |
| `drop` | `summary.json` | `drop_\u{2026}`, of one of several bearings `drop_bearing_2_\u{2026}` |
| `measure`, `tolerance`, `compare` | `measure.json`, `tolerance.json`, `compare.json` | none |

*Better* is the direction in which a bearing is better, where there is one. Results marked \u{2020} are in no sweep.
Tables of a run over time: [command line and result files](command-line.md). Symbols: [glossary](glossary.md).
";

/// Table, heading, and where its results are.
#[rustfmt::skip]
const SECTIONS: [(&[Quantity], &str, &str); 48] = [
    (STATIC, "Static equilibrium", "Of `static`."),
    (DEFECTS, "Static equilibrium: frequencies of defects", "For vibration analysts, in pure rolling. The orbital frequency of the balls takes the place of a cage's."),
    (FIT, "Static equilibrium with fits and temperatures", "With `[fit]`."),
    (CLEARANCE_RANGE, "Static equilibrium with tolerances of shaft, housing or clearance", "With `fit.shaft`, `fit.housing` or `fit.clearance_tolerance_um`."),
    (LUBRICATION, "Static equilibrium with a lubricant", "With `[lubrication]`, in the plane."),
    (FILM, "Static equilibrium with an oil film", "With `[film]`."),
    (SPACE, "Static equilibrium in space", "With an axial load, moments, a tilt, a contact angle or several rows."),
    (DESIGN, "Design: closed forms", "Of `design`."),
    (CONTACT_ANGLE, "Design: contact angle", "What an axial load or a tilt would leave of the first raceway, by estimate."),
    (PROFILE, "Design: measured raceway", "With `raceway.profile`, and for each of `raceways` of `measure`."),
    (MEASURED, "Measured ring", "Of `measure`."),
    (FRAME, "Measured ring: frame", "Under `frame`: shift, tilt, turn about z and errors of the radii, each in its unit."),
    (DIMENSION, "Measured ring: dimensions", "Under `dimensions` of each of `raceways`, each in its unit."),
    (GROOVE, "Measured raceways", "For each of `raceways`."),
    (SLOT, "Measured slots", "For each of `raceways` that is a slot."),
    (AXIAL, "Design: axial load and tilt", "Of `design --axial`, under `axial`, in space with even spacing at the start; lists go over axial load and tilt."),
    (VERDICT, "Design: verdict from the motion", "Of `design`."),
    (FILM_VERDICT, "Design: verdict with an oil film", "Of `design`, with `[film]`."),
    (PASSAGES, "Design: passages of the raceway", "Under `passages`."),
    (RACEWAY, "Design: each raceway", "Under `raceways`."),
    (RECOMMENDATION, "Design: recommendation", "Under `recommendation`."),
    (CURVE, "Design: curve of Eq. (11)", "Under `curve`."),
    (RUN, "Run", "Of `run`, after the transient, `settled_after_s`."),
    (DROP, "Rotor drop", "Of `drop`, under `bearings`; the verdict on the drop stands above them. *Rotor* is how, in a sweep, the result of a\nrotor on several bearings follows from those of each."),
    (ROTOR_DROP, "Rotor drop: the rotor on several bearings", "Of a sweep of a rotor file. `drop` has margins under `clearances`, and under `rotor` `energy_residual_relative`."),
    (PLANE, "Rotor drop: planes with a clearance", "Under `clearances`, of a rotor file."),
    (SUCCESSION, "Rotor drop: drops in succession", "Under `succession`, for each drop and bearing, with the list `reasons`."),
    (SEARCH, "Search", "Of `design --search`, under `search`, with the sentences `findings`."),
    (POINT, "Search: operating points", "Under `search.points`, and `point` of each of `search.maps`."),
    (STRUCTURE, "Search: structures", "Under `search.recommended`, `unconfirmed`, `own`, `recommended_from_usual_starts`, `own_from_usual_starts`, `front`,\n`band` and `placements` (`best`)."),
    (STRUCTURE_AT, "Search: a structure at an operating point", "Under `points` of a structure."),
    (MOTION, "Search: motion of all balls", "Under `motion` of a structure at an operating point: means over the starts, and `errors`, their standard errors."),
    (REJECTION, "Search: excluded structures", "Under `search.rejections`."),
    (PLACEMENT, "Search: angular positions and shapes", "Under `search.placements`."),
    (MAP, "Search: maps", "Under `search.maps`: a list of rows of equal θ."),
    (PAPER, "Search: structures of the paper", "Under `search.paper`, for the bearing of Zhao 2022."),
    (TOLERANCE, "Tolerance analysis", "Of `tolerance`."),
    (INFLUENCE, "Tolerance analysis: one influence at a time", "Under `influences`, with the list `verdicts`; ranges include the nominal bearing."),
    (SAMPLES, "Tolerance analysis: everything at once", "Under `samples`."),
    (STEADY, "Steady operation", "Of `compare`: means over the draws of balls with their standard errors."),
    (COMPARED, "Comparison of outer rings", "Of `compare`, with the results of a run and of steady operation: means over the draws with their standard errors,\ndifferences and what is better. `benefits` has `benefit`, `benefit_reasons`, score and criteria of each ring against the\nfirst, `verdicts` whether single balls are slowed as intended, `left_out` remedies that cannot run."),
    (VERIFICATION, "Verification of a run", "Of `run --verify`, under `verification`."),
    (VERIFIED, "Verification of a run: results that are judged", "Under `verification.numbers`."),
    (DROP_VERIFICATION, "Verification of a drop", "Of `drop --verify`, under `verification.bearings`."),
    (ROTOR_VERIFICATION, "Verification of a drop of the rotor of a rotor file", "Under `verification`, above `bearings`."),
    (JUDGEMENT, "Verification: the judgement of a result", "Each of `verification.numbers`, of a drop of `verification.bearings.numbers`, in the unit of the result."),
    (DISTANCE, "Verification of a run: distances of the replicas", "Under `verification.distance`."),
    (VERDICT_COUNT, "Tolerance analysis: bearings by verdict", "Under `samples.verdicts`."),
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
