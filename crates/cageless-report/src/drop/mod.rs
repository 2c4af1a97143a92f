//! The page of a drop of a rotor.

mod balls;
mod bearing;
mod facts;
mod report;
mod rotor;
mod scattered;
mod succession;

use cageless::simulation::PlaneDisplacement;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::results::VERSION;
use cageless_results::{DropResult, Record, Stopped, on_bearing, plane_records, table_of};
use cageless_study::drop::DropStudy;
use cageless_study::{Parameter, Provenance, parameter};

use crate::head::Head;
use crate::page::{Note, Page};
use crate::studio_page::studio_section;
use crate::table::{Row, Table};
use crate::text::short;
use crate::verification::VerificationTable;

use balls::{balls_in_motion, heat, loads};
use bearing::Bearing;
use facts::facts;
use rotor::of_rotor;
use scattered::scattered;
use succession::succession;

/// The self-contained page of a drop of the rotor in `file`.
pub fn drop_page(file: &BearingArrangement, study: &DropStudy) -> String {
    let bearings = Bearing::all(file, study);
    let source = &bearings[0].source;
    let title = match (file.title(), bearings.len()) {
        ("", 1) => "Drop of a rotor",
        ("", _) => "Drop of a rotor onto several bearings",
        (title, _) => title,
    };
    let mut page = Page::new(title, "", &format!("Cageless {VERSION}"));
    let planes = &study.record.rotor.planes[..];
    let facts = facts(&bearings, planes);
    page.head(&head(study, facts));
    // Without any clearance the place of the journal is that of the first figure all the same.
    let first = |bearing: &&Bearing<'_>| planes.is_empty() || rotor::has_clearance(bearing);
    let displacements = bearings.iter().filter(first).map(rotor::displacement);
    let displacements: Vec<_> = rotor::planes(planes, source)
        .into_iter()
        .chain(displacements)
        .collect();
    // Beside one bearing in motion there is room for one figure, above several for two.
    let shown = bearings.len().min(2);
    page.open_with(displacements.iter().take(shown).cloned());
    page.open_with_motion(Some(balls_in_motion(&bearings, study)));
    let stops = study
        .record
        .bearings
        .iter()
        .filter_map(|of| of.result.stopped.as_ref());
    let stops: Vec<String> = stops
        .filter(|stop| !stop.is_interrupted())
        .map(Stopped::with_advice)
        .collect();
    page.notes(Note::Warning, &stops);
    page.notes(Note::Warning, &study.warnings);
    page.section("Requirements");
    report::requirements(&mut page, study, &bearings);
    page.figures(displacements);
    conditions(&mut page, file, &bearings);
    page.section("Failure modes");
    report::failure_modes(&mut page, &bearings);
    page.section("Simulation");
    if !planes.is_empty() {
        page.table(&clearances(planes, source));
    }
    page.table(&results(study, source.clone()));
    for bearing in &bearings {
        page.section(&bearing.label("Rotor and inner ring"));
        let later = (!first(&bearing)).then(|| rotor::displacement(bearing));
        page.figures(later.into_iter().chain(of_rotor(bearing)));
    }
    page.section("Balls");
    page.figures(bearings.iter().map(loads));
    page.section("Energy");
    page.figures(bearings.iter().map(heat));
    judged(&mut page, study, &bearings);
    if let Some(file) = file.case() {
        let toml = file.document().to_toml().unwrap_or_default();
        studio_section(&mut page, &toml, "");
    }
    page.html()
}

/// Sections on what drops, under what conditions and how.
fn conditions(page: &mut Page, file: &BearingArrangement, bearings: &[Bearing<'_>]) {
    page.section("Architecture");
    report::architecture(page, bearings);
    let keys = |page: &mut Page, sections: &[&str]| report::keys(page, file, bearings, sections);
    keys(
        page,
        &[
            "bearing",
            "row",
            "raceway",
            "material",
            "ball_material",
            "ring_material",
        ],
    );
    page.section("Dynamic system");
    keys(
        page,
        &["rotor", "support", "contact", "model", "solver", "output"],
    );
    page.section("Environment");
    report::environment(page, bearings);
    keys(
        page,
        &["operation", "housing", "thermal", "fit", "lubrication"],
    );
    page.section("Event");
    page.paragraph(&event(file));
    keys(page, &["start"]);
}

/// Sections on the scatter, the verification, the acceptance test and drops in succession.
fn judged(page: &mut Page, study: &DropStudy, bearings: &[Bearing<'_>]) {
    if let Some(ensemble) = &study.ensemble {
        scattered(page, bearings, ensemble);
        if let Some(benefit) = &study.benefit {
            page.note(Note::Remark, &format!("{}.", benefit.headline));
        }
    }
    if let Some(verification) = &study.verification {
        verification_section(page, bearings, verification);
    }
    page.section("Acceptance test");
    report::acceptance_test(page, bearings);
    if !study.succession.records.is_empty() {
        page.section("Drops in succession");
        succession(page, bearings, &study.succession);
    }
}

/// Account of the drop from t = 0 to the landing.
fn event(file: &BearingArrangement) -> String {
    let speed_rpm = file.cases()[0].document().number("rotor.speed_rpm");
    format!(
        "At t = 0 the magnetic bearing loses power. The rotor turns at {} rpm where the magnets held \
         it, falls through the touch-down clearance and lands on an inner ring at rest.",
        short(speed_rpm.unwrap_or_default())
    )
}

/// The head of the page.
fn head(study: &DropStudy, facts: Vec<Parameter>) -> Head {
    let bearings = &study.record.bearings;
    let states = bearings.iter().enumerate().map(|(k, bearing)| {
        let state = bearing.result.end_state_text();
        on_bearing(k, bearings.len(), &state)
    });
    let states: Vec<String> = states.collect();
    let last = &bearings[study.record.last_index()].result;
    let end = short(last.results.number("simulated_s"));
    let judgement = &study.judgement;
    let state = format!("State after {end} s: {}.", states.join("; "));
    let rotor = study.drop.rotor();
    let mass = rotor.map(|rotor| parameter("mass of the rotor", short(rotor.mass_kg), "kg"));
    Head::new(judgement.passes(), &judgement.headline())
        .verdict(None, &state)
        .facts(facts)
        .facts(mass)
}

/// Table of the results of all bearings, one column each, under the headings of their groups.
fn results(study: &DropStudy, source: Provenance) -> Table {
    let caption = "From the start of the drop to the end of the run.";
    let named = study.results("This drop", "Conventional outer ring");
    let (names, drops): (Vec<String>, Vec<&DropResult>) = named.into_iter().unzip();
    let line = |first: &str, middle: Vec<String>, last: String| {
        let (first, last) = (std::iter::once(first.to_owned()), std::iter::once(last));
        first.chain(middle).chain(last).collect::<Vec<_>>()
    };
    let columns = names.len() + 2;
    let head = line("Result", names, "Unit".to_owned());
    let mut table = Table::of("Results", caption, vec![head], Some(source));
    for (heading, rows) in DropResult::groups(&drops) {
        table.rows.push(Row {
            cells: vec![heading.to_owned()],
            summary: Some(columns),
            ..Row::default()
        });
        let rows = rows.into_iter();
        let rows = rows.map(|(label, values, unit)| Row::from(line(label, values, unit)));
        table.rows.extend(rows);
    }
    table
}

/// Table of the planes of a rotor against their clearances.
fn clearances(planes: &[PlaneDisplacement], source: &Provenance) -> Table {
    let caption = "Largest displacement of the rotor from the stator centre in each plane. \
                   Negative margin: the rotor touches the stator.";
    let rows = table_of(&plane_records(planes));
    Table::of("Clearances", caption, rows, Some(source.clone()))
}

fn verification_section(page: &mut Page, bearings: &[Bearing<'_>], verification: &Record) {
    page.section("Verification");
    if let [full, half] = verification.values("rotor_energy_residual_relative") {
        page.paragraph(&format!(
            "The energy balance error of the rotor is {full:.1e} of all flows at the step and \
             {half:.1e} at half of it."
        ));
    }
    for (bearing, verified) in bearings.iter().zip(verification.parts("bearings")) {
        let table = VerificationTable::new(verified, verified.parts("numbers").iter());
        table.show(page, &bearing.label("Verification"), &bearing.source);
    }
}
