//! Parts of a report on touch-down bearings beside the simulation, in the order of the scope of
//! ISO 14839-5.

use cageless::Shaft;
use cageless::contact::STRESS_LIMIT_PA;
use cageless::simulation::PlaneDisplacement;
use cageless_io::arrangement::BearingArrangement;
use cageless_results::{DROP, Quantity, SUCCESSION, judged_limit};
use cageless_study::drop::DropStudy;
use cageless_study::{Parameter, parameters};

use super::bearing::Bearing;
use crate::lead;
use crate::length::um;
use crate::page::Page;
use crate::table::{Row, Table};
use crate::text::short;

/// Contact pressures, which have a limit in every drop.
pub(super) const PRESSURES: [&str; 3] = [
    "inner_pressure_max_mpa",
    "outer_pressure_max_mpa",
    "ball_pressure_max_mpa",
];
/// Failure modes, and the results that show them.
const FAILURE_MODES: [(&str, &[&str]); 6] = [
    ("Indentation of raceways and balls", &PRESSURES),
    (
        "Backward whirl",
        &[
            "backward_whirl_end_hz",
            "backward_whirl_hz",
            "backward_whirl_max_hz",
        ],
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
/// Measurements of an acceptance test: instrument or quantity, and the results to compare.
const MEASUREMENTS: [(&str, &[&str]); 4] = [
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
];

/// Contact pressure that ISO 76 allows, MPa.
pub(super) fn pressure_limit_mpa() -> f64 {
    1e-6 * STRESS_LIMIT_PA
}

/// Paragraph on each bearing: balls, outer ring, mounting and the place of the landing.
pub(super) fn architecture(page: &mut Page, bearings: &[Bearing<'_>]) {
    for bearing in bearings {
        let case = bearing.case;
        let balls = lead::balls(case);
        let place = match case.rotor.as_ref().map(|rotor| rotor.shaft) {
            Some(Shaft::Vertical) => "on its face",
            _ => "in its bore",
        };
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
        let name = bearing.label("Bearing");
        page.paragraph(&format!(
            "{name}: {balls} without a cage, {ring}, which is {mount}; the inner ring is at \
             rest until the rotor lands {place}."
        ));
    }
}

/// The temperatures before the drop and the friction, of each bearing.
pub(super) fn environment(page: &mut Page, bearings: &[Bearing<'_>]) {
    for bearing in bearings {
        let case = bearing.case;
        let [inner, balls, outer] = bearing.particulars.parts_c().map(short);
        let journal = case.rotor.as_ref().map_or(0.0, |r| r.friction.coefficient);
        let name = bearing.label("Before the first drop");
        page.paragraph(&format!(
            "{name}: inner ring {inner} °C, balls {balls} °C, outer ring {outer} °C. Friction \
             coefficient of the balls {}, of journal and bore {}.",
            short(case.contact.friction.coefficient),
            short(journal)
        ));
    }
}

/// A folded table of the keys of some sections of each case.
pub(super) fn keys(
    page: &mut Page,
    file: &BearingArrangement,
    bearings: &[Bearing<'_>],
    sections: &[&str],
) {
    for (bearing, case) in bearings.iter().zip(file.cases()) {
        let of_section = |line: &Parameter| {
            let mut parts = line.name.split('.');
            parts.next().is_some_and(|first| sections.contains(&first))
        };
        let lines: Vec<Parameter> = parameters(case).into_iter().filter(of_section).collect();
        let listed = sections.join(", ");
        page.fold(&bearing.label(&format!("Keys of {listed}")), |page| {
            let name = bearing.label(&format!("Keys: {listed}"));
            page.parameters(&name, "", &lines, None);
        });
    }
}

/// A requirement on a drop.
struct Requirement {
    /// Quantity under the limit.
    on: String,
    /// The limit, with whose it is.
    limit: String,
    /// Value found, with its unit, or words in its place.
    found: String,
    /// Whether it is kept; `None` where that cannot be judged.
    kept: Option<bool>,
}

impl Requirement {
    fn row(self) -> Row {
        let verdict = match self.kept {
            Some(true) => "PASS",
            Some(false) => "FAIL",
            None => "not judged",
        };
        Row {
            cells: vec![self.on, self.limit, self.found, verdict.to_owned()],
            marked: self.kept == Some(false),
            ..Row::default()
        }
    }
}

/// Requirements on the drop with what was found, those that it fails first.
pub(super) fn requirements(page: &mut Page, study: &DropStudy, bearings: &[Bearing<'_>]) {
    let mut all: Vec<Requirement> = bearings.iter().flat_map(of_bearing).collect();
    let planes = study.record.rotor.planes.iter();
    all.extend(planes.map(of_plane));
    all.sort_by_key(|requirement| requirement.kept != Some(false));
    let head = ["Requirement", "Limit", "Found", "Verdict"].map(str::to_owned);
    let caption = "No standard gives numbers for touch-down bearings: limits are those of the user, in \
                   [[limit]] sections of the case, each with its source.";
    let source = bearings[0].source.clone();
    let mut table = Table::of("Limits", caption, vec![head.to_vec()], Some(source));
    table.rows = all.into_iter().map(Requirement::row).collect();
    page.table(&table);
}

fn of_bearing(bearing: &Bearing<'_>) -> Vec<Requirement> {
    let results = &bearing.record.result.results;
    let mut all = vec![];
    for quantity in PRESSURES.iter().filter_map(|name| quantity(name)) {
        let found = results.value(quantity.name);
        all.push(Requirement {
            on: bearing.label(quantity.label.trim()),
            limit: format!(
                "at most {} (ISO 76)",
                quantity.with_unit(pressure_limit_mpa())
            ),
            found: value(bearing, quantity),
            kept: found.map(|mpa| mpa <= pressure_limit_mpa()),
        });
    }
    let whirl = results.value("backward_whirl_hz");
    all.push(Requirement {
        on: bearing.label("backward whirl at any time"),
        limit: "none".to_owned(),
        found: whirl.map_or("none".to_owned(), |hz| format!("{} Hz", short(hz))),
        kept: results.value("first_contact_ms").map(|_| whirl.is_none()),
    });
    let clearance_m = bearing
        .case
        .rotor
        .as_ref()
        .and_then(|r| r.clearance_limit_m);
    let displaced = quantity("rotor_displacement_max_um");
    if let (Some(clearance_m), Some(displaced)) = (clearance_m, displaced) {
        let limit_um = um(clearance_m);
        let found = results.value(displaced.name);
        all.push(Requirement {
            on: bearing.label(displaced.label.trim()),
            limit: format!(
                "at most {} (rotor.clearance_limit_um)",
                displaced.with_unit(limit_um)
            ),
            found: value(bearing, displaced),
            kept: found.map(|um| um <= limit_um),
        });
    }
    for limit in &bearing.particulars.limits {
        let of_drop = DROP.iter().any(|q| q.name == limit.result);
        let succession = bearing.succession.filter(|_| !of_drop);
        let results = succession.map_or(results, |record| &record.results);
        let judged = judged_limit(limit, results);
        all.extend(judged.map(|(quantity, text, kept)| Requirement {
            on: bearing.label(quantity.label.trim()),
            limit: text,
            found: limited(bearing, quantity),
            kept,
        }));
    }
    all
}

/// The clearance of a plane of the rotor.
fn of_plane(plane: &PlaneDisplacement) -> Requirement {
    let said = |m: f64| format!("{} µm", short(um(m)));
    Requirement {
        on: format!("largest displacement at {}", plane.clearance.name),
        limit: format!(
            "at most {} (clearance of the rotor file)",
            said(plane.clearance.radial_m)
        ),
        found: said(plane.displacement_max_m),
        kept: Some(plane.displacement_max_m <= plane.clearance.radial_m),
    }
}

/// Failure modes with the results that show them.
pub(super) fn failure_modes(page: &mut Page, bearings: &[Bearing<'_>]) {
    let caption = "What can go wrong in a touch-down bearing, with the results that show it. The inner \
                   ring slides on the journal until it has come up to speed. Temperatures are those at \
                   standstill with all heat kept, of drops in succession (--drops).";
    let mut rows = head(bearings, &["Failure mode", "Result"]);
    rows.extend(listed(bearings, &FAILURE_MODES));
    let source = bearings[0].source.clone();
    page.table(&Table::of("Failure modes", caption, rows, Some(source)));
}

/// Table of the measurements of an acceptance test, with the results to compare.
pub(super) fn acceptance_test(page: &mut Page, bearings: &[Bearing<'_>]) {
    let caption = "What to measure in a drop at the conditions of this one, and what this simulation \
                   predicts for it. One drop is one sample: --samples gives the distribution to compare \
                   with.";
    let mut rows = head(bearings, &["Measured by", "Result"]);
    rows.extend(listed(bearings, &MEASUREMENTS));
    let source = bearings[0].source.clone();
    page.table(&Table::of("Acceptance test", caption, rows, Some(source)));
}

/// Rows of groups of results.
fn listed(bearings: &[Bearing<'_>], groups: &[(&str, &[&str])]) -> Vec<Vec<String>> {
    let mut rows = vec![];
    // Results of drops in succession only where there are such drops.
    let computed = |quantity: &&Quantity| {
        let of_drop = DROP.iter().any(|q| q.name == quantity.name);
        of_drop || bearings.iter().any(|b| b.succession.is_some())
    };
    for (group, names) in groups {
        let computed = names
            .iter()
            .filter_map(|name| quantity(name))
            .filter(computed);
        for (row, quantity) in computed.enumerate() {
            let group = if row == 0 { group } else { &"" };
            let values = bearings.iter().map(|bearing| value(bearing, quantity));
            let first = [(*group).to_owned(), quantity.label.trim().to_owned()];
            rows.push(first.into_iter().chain(values).collect());
        }
    }
    rows
}

/// The head of a table with a column for each bearing.
fn head(bearings: &[Bearing<'_>], first: &[&str]) -> Vec<Vec<String>> {
    let first = first.iter().map(|name| (*name).to_owned());
    let columns = bearings.iter().map(|bearing| match bearing.number {
        None => "This drop".to_owned(),
        Some(number) => format!("Bearing {number}"),
    });
    vec![first.chain(columns).collect()]
}

/// A result of the drop or of its succession.
fn quantity(name: &str) -> Option<&'static Quantity> {
    DROP.iter().chain(SUCCESSION).find(|q| q.name == name)
}

/// Value of a result in a bearing, with its unit, in the first drop.
fn value(bearing: &Bearing<'_>, quantity: &Quantity) -> String {
    let found = bearing.record.result.results.value(quantity.name);
    let found = found.or_else(|| bearing.succession?.value(quantity.name));
    found.map_or("–".to_owned(), |value| quantity.with_unit(value))
}

/// The value of a result with a limit, or why there is none.
fn limited(bearing: &Bearing<'_>, quantity: &Quantity) -> String {
    let without = || match (quantity.awaited, quantity.occurs) {
        (true, _) => "not reached".to_owned(),
        (_, true) => "none".to_owned(),
        _ => "no value: not judged".to_owned(),
    };
    match value(bearing, quantity).as_str() {
        "–" => (bearing.record.result.instead(quantity.name)).unwrap_or_else(without),
        value => value.to_owned(),
    }
}
