//! The page of a drop of a rotor into several touchdown bearings.

use cageless_io::results::VERSION;
use cageless_io::rotor_file::RotorFile;
use cageless_study::drop::SeveralBearings;
use cageless_study::{parameter, provenance};

use super::balls::around_first_impact;
use super::rotor::{forces, orbit, rotors, speeds, whirl};
use super::{side_by_side, words};
use crate::head::Head;
use crate::page::Page;
use crate::run_report::motion;
use crate::text::short;

/// The self-contained page of a drop of the rotor of `file`, beside that onto conventional outer
/// rings.
pub fn rotor_page(
    file: &RotorFile,
    drop: &SeveralBearings,
    conventional: Option<&SeveralBearings>,
) -> String {
    let title = match file.title() {
        "" => "Drop of a rotor into several bearings",
        title => title,
    };
    let (rotor, cases) = (file.drop().rotor(), file.drop().cases());
    let source = provenance(&cases[0], String::new());
    let mut page = Page::new(title, "", &format!("Cageless {VERSION}"));
    let records = &drop.bearings;
    let states: Vec<String> = (records.iter().enumerate())
        .map(|(k, record)| format!("bearing {}: {}", k + 1, words(record.result.end_state())))
        .collect();
    let failed = records
        .iter()
        .any(|record| record.result.end_state() == "backward-whirl");
    let end = short(drop.last().result.results.number("end_s"));
    let head = Head::new(
        failed.then_some(false),
        &format!("At the end of {end} s: {}", states.join("; ")),
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
    page.section("Results");
    page.table(&side_by_side(drop.columns(conventional), &source));
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
        for mut figure in [
            orbit(case, &record.snapshots, &source),
            speeds(&rotors(&record.snapshots), &source),
            forces(case, &record.snapshots, &source),
            whirl(&record.result, &source),
        ] {
            figure.label = format!("{}, {name}", figure.label);
            page.figure(&figure);
        }
    }
    page.html()
}
