//! Zhao, Zhou, Wang, *Discrete Dynamics of Balls in Cageless Ball Bearings*, Symmetry 2022:
//! every table and figure computed beside the published numbers, and every claim judged.
//!
//! [`reproduce`] computes all of it; [`structures_of`] names the ten structures of Table 2.

mod cases;
mod claims;
mod comparison;
mod error;
mod experiment;
mod histories;
mod parameters;
mod section5_claims;
mod structures;
mod table2;

use cageless::dynamics::InstructionSet;
use cageless::{FrictionLaw, Profile};
use cageless_io::results::VERSION;
use cageless_report::ReproduceData;
use cageless_study::Progress;

pub use cases::{ODD_ROW, PUBLISHED, Published, experiment, structure, structures_of};
pub use error::PaperError;

/// The two sets of equations, each with the friction law that goes with it: as published,
/// and physically consistent.
const READINGS: [(Profile, FrictionLaw); 2] = [
    (Profile::Paper, FrictionLaw::Coulomb),
    (Profile::Physical, FrictionLaw::Smooth),
];

/// Computes every table and figure, in parallel on the threads of the caller's rayon pool.
///
/// # Errors
/// [`PaperError::Interrupted`] if `progress` ended the work; else the first computation that
/// failed.
pub fn reproduce(progress: &dyn Progress) -> Result<ReproduceData, PaperError> {
    let progress = progress.begin("reproduce", WORK);
    let progress = &*progress;
    let (mut table2, mut structures) = (not_computed(), not_computed());
    let (mut histories, mut experiment, mut extra) =
        (not_computed(), not_computed(), not_computed());
    let mut comparison = not_computed();
    // The threads take up the parts in this order: those that divide worst come first, the
    // many small tasks of Table 2 last, so that no thread waits long for another at the end.
    rayon::scope_fifo(|scope| {
        scope.spawn_fifo(|_| extra = claims::compute(progress));
        scope.spawn_fifo(|_| comparison = comparison::compute(progress));
        scope.spawn_fifo(|_| experiment = experiment::compute(progress));
        scope.spawn_fifo(|_| histories = histories::compute(progress));
        scope.spawn_fifo(|_| structures = structures::compute(progress));
        scope.spawn_fifo(|_| table2 = table2::compute(progress));
    });
    if progress.interrupted() {
        return not_computed();
    }
    let (table2, structures) = (table2?, structures?);
    let (histories, experiment, extra) = (histories?, experiment?, extra?);
    let comparison = comparison?;
    let file_d = cases::structure_file(3, READINGS[1], &[])?;
    let case_d = file_d.case().clone();
    let claims = claims::claims(&claims::Evidence {
        case: &case_d,
        table2: &table2,
        structures: &structures,
        histories: &histories,
        experiment: &experiment,
        comparison: &comparison,
        extra: &extra,
    });
    Ok(ReproduceData {
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
        case_toml: file_d.document().to_toml()?,
    })
}

fn not_computed<T>() -> Result<T, PaperError> {
    Err(PaperError::Interrupted)
}

/// Units of work for the progress bar, about a second each on one core.
const WORK: f64 = table2::WORK
    + structures::WORK
    + histories::WORK
    + experiment::WORK
    + comparison::WORK
    + claims::WORK;
