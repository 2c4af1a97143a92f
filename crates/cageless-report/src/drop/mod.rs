//! The page of a drop of a rotor.

mod balls;
mod rotor;
mod scattered;
mod several;

use cageless::contact::hertz::STRESS_LIMIT_PA;
use cageless_io::case_file::CaseFile;
use cageless_io::results::VERSION;
use cageless_results::DropResult;
use cageless_study::drop::DropStudy;
use cageless_study::{Provenance, parameter, provenance};

use crate::head::Head;
use crate::page::{Note, Page};
use crate::studio_page::studio_section;
use crate::table::Table;
use crate::text::short;
use crate::verification::VerificationTable;
pub use several::rotor_page;

use balls::{balls_in_motion, heat, loads};
use rotor::of_rotor;
use scattered::{distribution, scatter};

/// The self-contained page of a drop of the case in `file`.
pub fn drop_page(file: &CaseFile, study: &DropStudy) -> String {
    let case = file.case();
    let record = &study.drop;
    let title = match case.title.as_str() {
        "" => "Drop of a rotor",
        title => title,
    };
    let source = provenance(case, String::new());
    let mut page = Page::new(title, "", &format!("Cageless {VERSION}"));
    page.head(&head(&record.result));
    warned(&mut page, &study.warnings);
    page.section("Results");
    page.table(&results(study, &source));
    page.section("Rotor and inner ring");
    for figure in of_rotor(case, record, study.conventional.as_ref(), &source) {
        page.figure(&figure);
    }
    page.section("Balls");
    page.figure(&loads(study, &source));
    page.motion(&balls_in_motion(case, study, &source));
    page.section("Energy");
    page.figure(&heat(study, &source));
    if let Some(ensemble) = &study.ensemble {
        page.section("Scattered drops");
        page.table(&distribution(ensemble, &source));
        let rows = ensemble.drops.iter().map(|drop| &drop.bearing);
        let label = "State at the end";
        page.figure(&scatter(&ensemble.distribution, rows, label, &source));
    }
    if let Some(verification) = &study.verification {
        page.section("Verification");
        let numbers = verification.parts("numbers").iter();
        let table = VerificationTable::new(verification, numbers);
        table.show(&mut page, "Verification", &source);
    }
    let toml = file.document().to_toml().unwrap_or_default();
    studio_section(&mut page, &toml, "");
    page.html()
}

fn head(drop: &DropResult) -> Head {
    let fact = |name: &str, result: &str, unit: &str| {
        let value = drop.results.value(result)?;
        Some(parameter(name, short(value), unit))
    };
    let limit_mpa = 1e-6 * STRESS_LIMIT_PA;
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

/// "State after 0.5 s: rest at the bottom."
fn at_end(drop: &DropResult) -> String {
    format!(
        "State after {} s: {}.",
        short(drop.results.number("simulated_s")),
        drop.end_state_text()
    )
}

/// A box for each warning.
fn warned(page: &mut Page, warnings: &[String]) {
    for warning in warnings {
        page.note(Note::Warning, warning);
    }
}

fn results(study: &DropStudy, source: &Provenance) -> Table {
    let mut drops = vec![("This drop".to_owned(), &study.drop.result)];
    if let Some(other) = &study.conventional {
        drops.push(("Conventional outer ring".to_owned(), &other.result));
    }
    side_by_side(&drops, source)
}

/// Table of the results of drops, one column each.
fn side_by_side(drops: &[(String, &DropResult)], source: &Provenance) -> Table {
    let caption = "From the start of the drop to the end of the run.";
    let rows = DropResult::side_by_side(drops);
    Table::of("Results", caption, rows, Some(source.clone()))
}
