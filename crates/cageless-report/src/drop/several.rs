//! The page of a drop of a rotor into several touchdown bearings.

use cageless::Case;
use cageless::simulation::PlaneDisplacement;
use cageless_io::results::VERSION;
use cageless_io::rotor_file::RotorFile;
use cageless_results::{Record, plane_records, table_of};
use cageless_study::drop::{RotorEnsemble, RotorStudy};
use cageless_study::{Provenance, parameter, provenance};

use super::balls::around_first_impact;
use super::rotor::of_rotor;
use super::scattered::{end_states, label, quantiles, scatter};
use super::{side_by_side, warned};
use crate::head::Head;
use crate::page::Page;
use crate::run_report::motion;
use crate::table::Table;
use crate::text::short;
use crate::verification::VerificationTable;

/// The self-contained page of a drop of the rotor of `file`.
pub fn rotor_page(file: &RotorFile, study: &RotorStudy) -> String {
    let drop = &study.drop;
    let title = match file.title() {
        "" => "Drop of a rotor onto several bearings",
        title => title,
    };
    let (rotor, cases) = (file.drop().rotor(), file.drop().cases());
    let source = provenance(&cases[0], String::new());
    let mut page = Page::new(title, "", &format!("Cageless {VERSION}"));
    let records = &drop.bearings;
    let states: Vec<String> = (records.iter().enumerate())
        .map(|(k, record)| format!("bearing {}: {}", k + 1, record.result.end_state_text()))
        .collect();
    let end = short(drop.last().result.results.number("simulated_s"));
    let judgement = drop.judgement();
    let head = Head::new(judgement.passes, &judgement.headline()).verdict(
        None,
        &format!("State after {end} s: {}.", states.join("; ")),
    );
    let shares = rotor.mass_shares_kg().into_iter().enumerate();
    let facts = [
        parameter("Mass of the rotor", short(rotor.mass_kg()), "kg"),
        parameter(
            "Moment of inertia about the axis",
            short(rotor.polar_inertia_kg_m2()),
            "kg m²",
        ),
    ];
    let carried = shares.map(|(k, share)| {
        let name = format!("Carried by bearing {}", k + 1);
        parameter(&name, short(share), "kg")
    });
    page.head(&head.facts(facts.into_iter().chain(carried)));
    warned(&mut page, &study.warnings);
    page.section("Results");
    if !drop.planes.is_empty() {
        page.table(&planes(&drop.planes, &source));
    }
    page.table(&side_by_side(&study.columns(), &source));
    page.section("Balls");
    let bearings = cases.iter().zip(records).enumerate();
    let moving = bearings.map(|(k, (case, record))| {
        let name = format!("bearing {}", k + 1);
        motion(
            case,
            &name,
            &record.snapshots,
            provenance(case, String::new()),
        )
    });
    page.motion(&around_first_impact(moving.collect(), &records[0]));
    for (k, (case, record)) in cases.iter().zip(records).enumerate() {
        let name = format!("bearing {}", k + 1);
        page.section(&format!("Journal and inner ring, {name}"));
        let source = provenance(case, String::new());
        let other = study.conventional.as_ref().map(|other| &other.bearings[k]);
        for mut figure in of_rotor(case, record, other, &source) {
            figure.label = label(&figure.label, Some(k));
            page.figure(&figure);
        }
    }
    if let Some(ensemble) = &study.ensemble {
        scattered(&mut page, cases, ensemble);
    }
    if let Some(verification) = &study.verification {
        verification_section(&mut page, cases, verification);
    }
    page.html()
}

/// Table of the planes of a rotor against their clearances.
fn planes(planes: &[PlaneDisplacement], source: &Provenance) -> Table {
    let caption = "Largest displacement of the rotor from the stator centre in each plane. \
                   Negative margin: the rotor touches the stator.";
    let rows = table_of(&plane_records(planes));
    Table::of("Clearances", caption, rows, Some(source.clone()))
}

fn scattered(page: &mut Page, cases: &[Case], ensemble: &RotorEnsemble) {
    page.section("Scattered drops");
    page.table(&end_states(ensemble, &provenance(&cases[0], String::new())));
    for (k, (case, distribution)) in cases.iter().zip(&ensemble.bearings).enumerate() {
        let source = provenance(case, String::new());
        let caption = format!(
            "{} completed drops: {}.",
            ensemble.completed,
            distribution.end_states_text()
        );
        let of_bearing = |name: &str| label(name, Some(k));
        page.table(&quantiles(
            distribution,
            of_bearing("Distribution"),
            caption,
            &source,
        ));
        let rows = ensemble.drops.iter().map(|drop| &drop.bearings[k]);
        page.figure(&scatter(
            distribution,
            rows,
            &of_bearing("State at the end"),
            &source,
        ));
    }
}

fn verification_section(page: &mut Page, cases: &[Case], verification: &Record) {
    page.section("Verification");
    let [full, half] = verification.values("rotor_energy_residual_relative") else {
        return;
    };
    page.paragraph(&format!(
        "The energy balance error of the rotor is {full:.1e} of all flows at the step and \
         {half:.1e} at half of it."
    ));
    for (k, (case, bearing)) in cases.iter().zip(verification.parts("bearings")).enumerate() {
        let table = VerificationTable::new(bearing, bearing.parts("numbers").iter());
        let source = provenance(case, String::new());
        table.show(page, &label("Verification", Some(k)), &source);
    }
}
