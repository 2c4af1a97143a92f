//! The page of a drop of a rotor.

mod balls;
mod label;
mod report;
mod rotor;
mod scattered;
mod succession;

use cageless::Case;
use cageless::linear_rotor::LinearRotor;
use cageless::simulation::PlaneDisplacement;
use cageless_io::plan_file::VariantFile;
use cageless_io::results::VERSION;
use cageless_results::{DropResult, Record, plane_records, table_of};
use cageless_study::drop::{BearingRecord, DropStudy};
use cageless_study::{Provenance, parameter, provenance};

use crate::figure::Figure;
use crate::head::Head;
use crate::page::{Note, Page};
use crate::studio_page::studio_section;
use crate::table::Table;
use crate::text::short;
use crate::verification::VerificationTable;

use balls::{balls_in_motion, heat, loads};
use label::label;
use rotor::of_rotor;
use scattered::scattered;
use succession::succession;

/// The self-contained page of a drop of the rotor in `file`.
pub fn drop_page(file: &VariantFile, study: &DropStudy) -> String {
    let cases = study.drop.cases();
    let title = match (file.title(), study.drop.rotor()) {
        ("", None) => "Drop of a rotor",
        ("", Some(_)) => "Drop of a rotor onto several bearings",
        (title, _) => title,
    };
    let source = provenance(&cases[0], String::new());
    let mut page = Page::new(title, "", &format!("Cageless {VERSION}"));
    page.head(&match study.drop.rotor() {
        None => head(&study.record.bearings[0].result),
        Some(rotor) => head_of_rotor(rotor, study),
    });
    page.notes(Note::Warning, &study.warnings);
    page.section("Architecture");
    report::architecture(&mut page, study);
    let keys = |page: &mut Page, sections: &[&str]| report::keys(page, file, study, sections);
    keys(
        &mut page,
        &["bearing", "raceway", "material", "ball_material"],
    );
    page.section("Requirements");
    report::requirements(&mut page, file, study);
    page.section("Dynamic system");
    keys(&mut page, &["rotor", "support", "contact", "solver"]);
    page.section("Environment");
    report::environment(&mut page, study);
    keys(&mut page, &["operation", "thermal", "fit", "lubrication"]);
    page.section("Event");
    page.paragraph(&event(file));
    keys(&mut page, &["start"]);
    page.section("Failure modes");
    report::failure_modes(&mut page, study);
    page.section("Simulation");
    let planes = study.record.rotor.iter().map(|rotor| &rotor.planes);
    for planes in planes.filter(|planes| !planes.is_empty()) {
        page.table(&clearances(planes, &source));
    }
    page.table(&results(study, source));
    for k in 0..cases.len() {
        page.section(&label(study, "Rotor and inner ring", k));
        figures(&mut page, study, k, |case, record, other, source| {
            of_rotor(case, record, other, source).collect()
        });
    }
    page.section("Balls");
    for k in 0..cases.len() {
        figures(&mut page, study, k, |_, record, other, source| {
            vec![loads(record, other, source)]
        });
    }
    page.motion(&balls_in_motion(study));
    page.section("Energy");
    for k in 0..cases.len() {
        figures(&mut page, study, k, |_, record, other, source| {
            vec![heat(record, other, source)]
        });
    }
    if let Some(ensemble) = &study.ensemble {
        scattered(&mut page, study, ensemble);
    }
    if let Some(verification) = &study.verification {
        verification_section(&mut page, study, verification);
    }
    page.section("Acceptance test");
    report::acceptance_test(&mut page, study);
    page.section("Drops in succession");
    succession(&mut page, study);
    if let VariantFile::Case(file) = file {
        let toml = file.document().to_toml().unwrap_or_default();
        studio_section(&mut page, &toml, "");
    }
    page.html()
}

/// What happens at t = 0.
fn event(file: &VariantFile) -> String {
    let speed_rpm = file.cases()[0].document().number("rotor.speed_rpm");
    format!(
        "At t = 0 the magnetic bearing loses power. The rotor turns at {} rpm where the magnets held \
         it, falls through the touch-down clearance and lands on an inner ring at rest.",
        short(speed_rpm.unwrap_or_default())
    )
}

/// Shows figures of bearing `k`: of its case, its record and that with a conventional outer ring.
fn figures(
    page: &mut Page,
    study: &DropStudy,
    k: usize,
    of: impl Fn(&Case, &BearingRecord, Option<&BearingRecord>, &Provenance) -> Vec<Figure>,
) {
    let case = &study.drop.cases()[k];
    let other = study.conventional.as_ref().map(|other| &other.bearings[k]);
    let source = provenance(case, String::new());
    for mut figure in of(case, &study.record.bearings[k], other, &source) {
        figure.label = label(study, &figure.label, k);
        page.figure(&figure);
    }
}

/// The head of a drop of a linear rotor.
fn head_of_rotor(rotor: &LinearRotor, study: &DropStudy) -> Head {
    let results = || study.record.bearings.iter().map(|bearing| &bearing.result);
    let states = (1..).zip(results());
    let states = states.map(|(k, result)| format!("bearing {k}: {}", result.end_state_text()));
    let states: Vec<String> = states.collect();
    let last = study.record.last_index();
    let end = results()
        .nth(last)
        .map_or(0.0, |r| r.results.number("simulated_s"));
    let judgement = study.record.judgement();
    let facts = [
        parameter("Mass of the rotor", short(rotor.mass_kg()), "kg"),
        parameter(
            "Moment of inertia about the axis",
            short(rotor.polar_inertia_kg_m2()),
            "kg m²",
        ),
    ];
    let carried = (1..).zip(rotor.mass_shares_kg());
    let carried =
        carried.map(|(k, share)| parameter(&format!("Carried by bearing {k}"), short(share), "kg"));
    let state = format!("State after {} s: {}.", short(end), states.join("; "));
    Head::new(judgement.passes, &judgement.headline())
        .verdict(None, &state)
        .facts(facts.into_iter().chain(carried))
}

fn head(drop: &DropResult) -> Head {
    let fact = |name: &str, result: &str, unit: &str| {
        let value = drop.results.value(result)?;
        Some(parameter(name, short(value), unit))
    };
    let limit_mpa = report::pressure_limit_mpa();
    let pressure_mpa = [
        "inner_pressure_max_mpa",
        "outer_pressure_max_mpa",
        "ball_pressure_max_mpa",
    ]
    .into_iter()
    .filter_map(|name| drop.results.value(name))
    .fold(0.0, f64::max);
    let state = at_end(drop);
    let facts = [
        fact("First contact", "first_contact_ms", "ms"),
        fact("Largest force on the rotor", "rotor_force_max_n", "N"),
        fact(
            "Largest force / rotor weight",
            "rotor_force_max_over_weight",
            "",
        ),
        fact(
            "Largest displacement from the stator centre",
            "rotor_displacement_max_um",
            "µm",
        ),
        fact("Spin-up of the inner ring", "spin_up_ms", "ms"),
        Some(parameter(
            &format!("Largest contact pressure (limit {limit_mpa:.0} MPa, ISO 76)"),
            format!("{pressure_mpa:.0}"),
            "MPa",
        )),
        fact("Collisions between balls", "collisions", ""),
        fact("Collisions above 0.5 m/s", "collisions_above_0_5_m_s", ""),
        fact("Heat of all interfaces", "dissipated_j", "J"),
    ];
    Head::new(drop.judgement.passes, &drop.judgement.headline())
        .verdict(None, &state)
        .facts(facts.into_iter().flatten())
}

/// "State after 0.5 s: rest on the bearing."
fn at_end(drop: &DropResult) -> String {
    format!(
        "State after {} s: {}.",
        short(drop.results.number("simulated_s")),
        drop.end_state_text()
    )
}

/// Table of the results of all bearings, one column each.
fn results(study: &DropStudy, source: Provenance) -> Table {
    let caption = "From the start of the drop to the end of the run.";
    let rows = DropResult::side_by_side(&study.results("This drop", "Conventional outer ring"));
    Table::of("Results", caption, rows, Some(source))
}

/// Table of the planes of a rotor against their clearances.
fn clearances(planes: &[PlaneDisplacement], source: &Provenance) -> Table {
    let caption = "Largest displacement of the rotor from the stator centre in each plane. \
                   Negative margin: the rotor touches the stator.";
    let rows = table_of(&plane_records(planes));
    Table::of("Clearances", caption, rows, Some(source.clone()))
}

fn verification_section(page: &mut Page, study: &DropStudy, verification: &Record) {
    page.section("Verification");
    if let [full, half] = verification.values("rotor_energy_residual_relative") {
        page.paragraph(&format!(
            "The energy balance error of the rotor is {full:.1e} of all flows at the step and \
             {half:.1e} at half of it."
        ));
    }
    let bearings = match verification.parts("bearings") {
        [] => std::slice::from_ref(verification),
        several => several,
    };
    for (k, (case, bearing)) in study.drop.cases().iter().zip(bearings).enumerate() {
        let table = VerificationTable::new(bearing, bearing.parts("numbers").iter());
        let source = provenance(case, String::new());
        table.show(page, &label(study, "Verification", k), &source);
    }
}
