//! What a report on touch-down bearings has beside the simulation, in the order of the scope of
//! ISO 14839-5.

use std::ops::Range;

use cageless::contact::hertz::STRESS_LIMIT_PA;
use cageless_io::plan_file::VariantFile;
use cageless_results::{Aim, DROP, DropResult, Quantity, Record, SUCCESSION};
use cageless_study::drop::DropStudy;
use cageless_study::{Parameter, parameters, provenance};

use super::label::label;
use crate::page::Page;
use crate::table::Table;
use crate::text::short;

/// Contact pressures, which have a limit in every drop.
const PRESSURES: [&str; 3] = [
    "inner_pressure_max_mpa",
    "outer_pressure_max_mpa",
    "ball_pressure_max_mpa",
];
/// Failure modes, and the results that show them.
const FAILURE_MODES: [(&str, &[&str]); 6] = [
    ("Indentation of raceways and balls", &PRESSURES),
    (
        "Backward whirl",
        &["backward_whirl_hz", "backward_whirl_max_hz"],
    ),
    (
        "Contact of rotor and stator",
        &["rotor_displacement_max_um", "housing_displacement_max_um"],
    ),
    (
        "Wear of journal and bore",
        &["spin_up_ms", "rotor_sliding_max_m_s", "rotor_friction_j"],
    ),
    (
        "Impacts between balls",
        &["end_collision_rate_above_0_5_m_s_hz", "ball_force_max_n"],
    ),
    (
        "Overheating",
        &["ball_standstill_c", "inner_ring_standstill_c"],
    ),
];
/// What an acceptance test measures, with what, and the results to compare.
const MEASUREMENTS: [(&str, &[&str]); 5] = [
    (
        "Displacement probes of the magnetic bearing",
        &["rotor_displacement_max_um", "backward_whirl_hz"],
    ),
    (
        "Load cells between support and housing",
        &["housing_force_max_n", "housing_force_max_over_weight"],
    ),
    ("Mark on the inner ring", &["spin_up_ms", "ring_speed_rpm"]),
    ("Speed of the rotor", &["rotor_speed_rpm", "spin_down_s"]),
    (
        "Thermocouple at the outer ring",
        &["outer_ring_temperature_c", "outer_ring_standstill_c"],
    ),
];

/// Contact pressure that ISO 76 allows, MPa.
pub(super) fn pressure_limit_mpa() -> f64 {
    1e-6 * STRESS_LIMIT_PA
}

/// What catches the rotor, of each bearing.
pub(super) fn architecture(page: &mut Page, study: &DropStudy) {
    for (k, case) in study.drop.cases().iter().enumerate() {
        let balls = case.bearing.balls();
        let ring = match case.raceways.len() {
            0 => "a conventional outer ring".to_owned(),
            1 => "one discrete raceway in the outer ring".to_owned(),
            several => format!("{several} discrete raceways in the outer ring"),
        };
        let mount = match &case.support {
            None => "fixed",
            Some(support) if support.stop.is_some() => "on a support with a hard stop",
            Some(_) => "on a support",
        };
        let name = label(study, "Bearing", k);
        page.paragraph(&format!(
            "{name}: {balls} balls without a cage, {ring}, which is {mount}; the inner ring is at \
             rest until the rotor lands in its bore."
        ));
    }
}

/// The temperatures before the drop and the friction, of each bearing.
pub(super) fn environment(page: &mut Page, study: &DropStudy) {
    for (k, case) in study.drop.cases().iter().enumerate() {
        let [inner, balls, outer] = case.parts_c().map(short);
        let journal = case.rotor.as_ref().map_or(0.0, |r| r.friction.coefficient);
        let name = label(study, "Before the first drop", k);
        page.paragraph(&format!(
            "{name}: inner ring {inner} °C, balls {balls} °C, outer ring {outer} °C. Friction \
             coefficient of the balls {}, of journal and bore {}.",
            short(case.contact.friction.coefficient),
            short(journal)
        ));
    }
}

/// A folded table of the keys of some sections of each case.
pub(super) fn keys(page: &mut Page, file: &VariantFile, study: &DropStudy, sections: &[&str]) {
    for (k, case) in file.cases().iter().enumerate() {
        let of_section = |line: &Parameter| {
            let mut parts = line.name.split('.');
            parts.next().is_some_and(|first| sections.contains(&first))
        };
        let lines: Vec<Parameter> = parameters(case).into_iter().filter(of_section).collect();
        if !lines.is_empty() {
            let listed = sections.join(", ");
            page.fold(&label(study, &format!("Keys of {listed}"), k));
            let name = label(study, &format!("Keys: {listed}"), k);
            page.parameters(&name, "", &lines, None);
            page.end_fold();
        }
    }
}

/// Limits on the drop, with whose they are.
pub(super) fn requirements(page: &mut Page, file: &VariantFile, study: &DropStudy) {
    let cases = study.drop.cases();
    let mut rows = head(study, &["Result", "Limit", "Whose"]);
    let mut add = |name: &str, bound: f64, whose: &str, bearings: Range<usize>| {
        let Some(quantity) = quantity(name) else {
            return;
        };
        let side = match quantity.aim {
            Some(Aim::High) => "at least",
            _ => "at most",
        };
        let limit = format!("{side} {}", with_unit(quantity, bound));
        let values = (0..cases.len()).map(|k| match bearings.contains(&k) {
            true => value(study, k, quantity),
            false => String::new(),
        });
        let first = [quantity.label.trim().to_owned(), limit, whose.to_owned()];
        rows.push(first.into_iter().chain(values).collect());
    };
    for name in PRESSURES {
        add(name, pressure_limit_mpa(), "ISO 76", 0..cases.len());
    }
    for (k, case) in cases.iter().enumerate() {
        let document = file.cases()[k].document();
        if let Some(bound) = document.number("rotor.clearance_limit_um") {
            let whose = "the case: rotor.clearance_limit_um";
            add("rotor_displacement_max_um", bound, whose, k..k + 1);
        }
        for limit in &case.limits {
            add(&limit.result, limit.value, &limit.source, k..k + 1);
        }
    }
    let caption = "No standard gives numbers for touch-down bearings: limits are those of the user, in \
                   [[limit]] sections of the case, each with its source.";
    let source = provenance(&cases[0], String::new());
    page.table(&Table::of("Limits", caption, rows, Some(source)));
}

/// Failure modes with the results that show them.
pub(super) fn failure_modes(page: &mut Page, study: &DropStudy) {
    let caption = "What can go wrong in a touch-down bearing, with the results that show it. The inner \
                   ring slides on the journal until it has come up to speed; the temperatures are those \
                   at standstill, with all heat kept.";
    let titles = ["Failure modes", caption, "Failure mode"];
    listed(page, study, titles, &FAILURE_MODES);
}

/// What an acceptance test measures.
pub(super) fn acceptance_test(page: &mut Page, study: &DropStudy) {
    let caption = "What to measure in a drop at the conditions of this one, and what this simulation \
                   predicts for it. One drop is one sample: --samples gives the distribution to compare \
                   with.";
    let titles = ["Acceptance test", caption, "Measured by"];
    listed(page, study, titles, &MEASUREMENTS);
}

/// A table of groups of results by its name, caption and first heading.
fn listed(
    page: &mut Page,
    study: &DropStudy,
    [name, caption, first]: [&str; 3],
    groups: &[(&str, &[&str])],
) {
    let mut rows = head(study, &[first, "Result"]);
    for (group, names) in groups {
        for (row, quantity) in names.iter().filter_map(|name| quantity(name)).enumerate() {
            let group = if row == 0 { group } else { &"" };
            let bearings = 0..study.drop.cases().len();
            let values = bearings.map(|k| value(study, k, quantity));
            let first = [(*group).to_owned(), quantity.label.trim().to_owned()];
            rows.push(first.into_iter().chain(values).collect());
        }
    }
    let source = provenance(&study.drop.cases()[0], String::new());
    page.table(&Table::of(name, caption, rows, Some(source)));
}

/// The head of a table with a column for each bearing.
fn head(study: &DropStudy, first: &[&str]) -> Vec<Vec<String>> {
    let first = first.iter().map(|name| (*name).to_owned());
    let bearings = (0..study.drop.cases().len()).map(|k| match study.drop.rotor() {
        None => "This drop".to_owned(),
        Some(_) => format!("Bearing {}", k + 1),
    });
    vec![first.chain(bearings).collect()]
}

/// A result of the drop or of its succession.
fn quantity(name: &str) -> Option<&'static Quantity> {
    DROP.iter().chain(SUCCESSION).find(|q| q.name == name)
}

/// Its value in bearing `k` with its unit, in the first drop.
fn value(study: &DropStudy, k: usize, quantity: &Quantity) -> String {
    let result: &DropResult = &study.record.bearings[k].result;
    let after: Option<&Record> = study.succession.records.get(k);
    let found = result.results.value(quantity.name);
    let found = found.or_else(|| after?.value(quantity.name));
    found.map_or("–".to_owned(), |value| with_unit(quantity, value))
}

fn with_unit(quantity: &Quantity, value: f64) -> String {
    let text = quantity.number_text(value);
    format!("{text} {}", quantity.printed_unit())
        .trim_end()
        .to_owned()
}
