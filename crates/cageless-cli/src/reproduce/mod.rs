//! `cageless reproduce`: every table and figure of Zhao 2022 beside the paper's numbers.

mod cases;
mod claims;
mod comparison;
mod experiment;
mod histories;
mod parameters;
mod section5_claims;
mod structures;
mod table2;

use std::time::Instant;

use cageless::dynamics::InstructionSet;
use cageless::{FrictionLaw, Profile};
use cageless_io::results::{VERSION, write_atomically};
use cageless_report::{ReproduceData, reproduce_page, to_json};
use cageless_study::Work;

use crate::args::Reproduce;
use crate::commands::{make_folder, print};
use crate::failure::Failure;
use crate::progress::{Bar, StopFlag};

/// The two sets of equations, each with the friction law that goes with it: as published,
/// and as they should be.
const READINGS: [(Profile, FrictionLaw); 2] = [
    (Profile::Paper, FrictionLaw::Coulomb),
    (Profile::Physical, FrictionLaw::Smooth),
];

/// Regenerates the paper.
pub fn reproduce(args: &Reproduce, stop: &StopFlag) -> Result<(), Failure> {
    // An output folder that cannot be made must not cost the user the computation.
    make_folder(&args.out)?;
    let started = Instant::now();
    let progress = Bar::new("reproduce", WORK, stop);
    let (mut table2, mut structures) = (not_computed(), not_computed());
    let (mut histories, mut experiment, mut extra) =
        (not_computed(), not_computed(), not_computed());
    let mut comparison = not_computed();
    // The threads take up the parts in this order: those that divide worst come first, the
    // many small tasks of Table 2 last, so that no thread waits long for another at the end.
    rayon::scope_fifo(|scope| {
        scope.spawn_fifo(|_| extra = claims::compute(&progress));
        scope.spawn_fifo(|_| comparison = comparison::compute(&progress));
        scope.spawn_fifo(|_| experiment = experiment::compute(&progress));
        scope.spawn_fifo(|_| histories = histories::compute(&progress));
        scope.spawn_fifo(|_| structures = structures::compute(&progress));
        scope.spawn_fifo(|_| table2 = table2::compute(&progress));
    });
    if progress.interrupted() {
        return not_computed();
    }
    let (table2, structures) = (table2?, structures?);
    let (histories, experiment, extra) = (histories?, experiment?, extra?);
    let comparison = comparison?;
    drop(progress);
    let case_d = cases::structure(3, READINGS[1], &[])?;
    let claims = claims::claims(&claims::Evidence {
        case: &case_d,
        table2: &table2,
        structures: &structures,
        histories: &histories,
        experiment: &experiment,
        comparison: &comparison,
        extra: &extra,
    });
    let data = ReproduceData {
        software: format!("Cageless {VERSION}, {}", InstructionSet::chosen().name()),
        lead: claims::lead(&table2),
        table1: parameters::table1(&case_d),
        contact_track: Some(parameters::contact_track(&case_d)),
        surface: Some(parameters::surface(&case_d)),
        design_curve: Some(parameters::design_curve(&case_d)),
        claims,
        table2: Some(table2.table),
        gap_histories: histories.iter().map(|h| h.gap.clone()).collect(),
        neighbours: histories.into_iter().map(|h| h.neighbours).collect(),
        phase_portraits: structures.iter().map(|s| s.portraits.clone()).collect(),
        orbit_speeds: structures.into_iter().map(|s| s.speeds).collect(),
        vibrations: vec![experiment.vibration],
        ring_comparison: Some(comparison),
        motions: experiment.motions,
    };
    let json = to_json(&data)?;
    let page = args.out.join("report.html");
    write_atomically(&page, reproduce_page(&data).as_bytes())?;
    write_atomically(&args.out.join("report.json"), json.as_bytes())?;
    if args.json {
        return print(&(json + "\n"));
    }
    print(&format!(
        "{}\n{}\nThe report is {}, its numbers report.json beside it ({:.1} s).\n",
        data.lead,
        table2::text(&data),
        page.display(),
        started.elapsed().as_secs_f64()
    ))
}

fn not_computed<T>() -> Result<T, Failure> {
    Err(Failure::Interrupted(
        "interrupted: no report was written".to_owned(),
    ))
}

/// Units of work for the progress bar, about a second each on one core.
const WORK: f64 = table2::WORK
    + structures::WORK
    + histories::WORK
    + experiment::WORK
    + comparison::WORK
    + claims::WORK;
