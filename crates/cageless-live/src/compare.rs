//! A case compared with another from the same uneven starts.

use cageless::Case;
use cageless::passage::PassageTally;
use cageless::simulation::{Control, Ending, Observer, batches, run_batch};
use cageless::summary::SummaryRecorder;
use cageless_design::RunVerdict;
use cageless_io::case_file::CaseFile;
use cageless_io::estimate::{Change, Estimate};
use cageless_results::{Finished, RUN, Results, Subject};
use serde_json::{Value, json};

use crate::refusal::{Refusal, read};

/// Orbits of the balls in each run; the first two are its transient.
const ORBITS: f64 = 18.0;
/// Starts of each case: as many as run side by side.
const STARTS: u64 = 8;

/// Results of a run that are compared; for each but the change of the gaps less is better.
const RESULTS: [&str; 5] = [
    "gap_deviation_deg",
    "gap_deviation_change_deg",
    "outer_ring_force_deviation_n",
    "collisions",
    "power_loss_w",
];

/// Runs both cases from the same starts: mean and standard error of each result for the reference
/// and the case, and of their difference.
pub(crate) fn compare(
    case: &str,
    reference: &str,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Value, Refusal> {
    let files = [read(reference)?, read(case)?];
    for file in &files {
        file.checked(|case| case.check_constant_operation("a comparison in the studio"))?;
    }
    let seed = files[0].particulars().seed;
    let [a, b] = [0usize, 1].map(|k| {
        let share = 0.5 * k as f64;
        results(&files[k], seed, &mut |done| control(share + 0.5 * done))
    });
    let (a, b) = (a?, b?);
    let compared = RESULTS.iter().map(|name| {
        let of = |all: &[Results]| all.iter().map(|r| r.number(name)).collect::<Vec<f64>>();
        let (a, b) = (of(&a), of(&b));
        let difference = Estimate::of_differences(&b, &a);
        let change = difference.map_or(Change::Undecided, |d| d.change());
        let result = json!({
            "values": [Estimate::new(&a), Estimate::new(&b)],
            "difference": difference,
            "change": change,
        });
        ((*name).to_owned(), result)
    });
    let alike = files[0].apart_from_remedies() == files[1].apart_from_remedies();
    Ok(json!({
        "starts": STARTS,
        "seed": seed,
        "orbits": ORBITS,
        "only_the_raceway_differs": alike,
        "results": compared.collect::<serde_json::Map<_, _>>(),
    }))
}

/// Results of the runs of a case from its uneven starts, side by side.
fn results(
    file: &CaseFile,
    seed: u64,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Vec<Results>, Refusal> {
    let duration_s = ORBITS * file.case().rolling_orbit_s();
    let mut cases = vec![];
    for start in 0..STARTS {
        let mut case = file.with_uneven_start(seed, start)?.case().clone();
        case.solver.duration_s = duration_s;
        cases.push(case);
    }
    let mut found = vec![];
    for members in batches(&cases) {
        let together: Vec<&Case> = members.iter().map(|k| &cases[*k]).collect();
        let mut recorders: Vec<SummaryRecorder> =
            members.iter().map(|_| SummaryRecorder::new()).collect();
        let mut observers: Vec<Vec<&mut dyn Observer>> = (recorders.iter_mut())
            .map(|recorder| vec![recorder as &mut dyn Observer])
            .collect();
        let (before, share) = (found.len(), members.len());
        let outcomes = run_batch(&together, &mut observers, &mut |time_s| {
            let done = before as f64 + share as f64 * (time_s / duration_s).min(1.0);
            control(done / STARTS as f64)
        });
        let recorded = recorders.iter().zip(together);
        for (outcome, (recorder, case)) in outcomes.into_iter().zip(recorded) {
            let outcome = outcome?;
            match &outcome.ending {
                Ending::Complete => {}
                Ending::Stopped(stop) => return Err(Refusal::new(stop.by_key())),
                _ => return Err(Refusal::new("cancelled")),
            }
            let summary = recorder.summary();
            let finished = Finished {
                case,
                outcome: &outcome,
                summary: Some(&summary.ok_or_else(|| Refusal::new("the run is too short"))?),
                passages: &PassageTally::new(),
                verdict: &RunVerdict::unfinished(case, "it is compared"),
                wall_s: f64::NAN,
            };
            found.push(Results::of(RUN, Subject::Run(&finished)));
        }
    }
    Ok(found)
}
