//! Test of stationarity on runs that something changes while they are measured.

use cageless::simulation::{Control, Observer, run_batch};
use cageless::steady::{Stationarity, SteadyBlock, SteadyRecorder};
use cageless::{Case, TimeTable};
use cageless_io::case_file::{CaseFile, template};

/// Draws of balls of each condition: two batches.
const DRAWS: u64 = 16;
/// Draws of one judgement.
const JUDGED: usize = 4;
/// Orbits of each run.
const ORBITS: f64 = 24.0;

/// What is changed in a case of so many seconds.
type Change = dyn Fn(&mut Case, f64);
/// Name, whether with the raceway, changes of keys and of the case.
type Condition<'a> = (&'a str, bool, &'a [&'a str], &'a Change);

/// Runs measured from their start, changed by `change`, which has the duration.
fn runs(with_raceway: bool, set: &[&str], change: &Change) -> Vec<Vec<SteadyBlock>> {
    let orbits = format!("steady.measured_orbits={ORBITS}");
    let own = [
        "steady.transient_orbits=0",
        &orbits,
        "solver.method=verlet",
        "solver.step_us=auto",
    ];
    let set: Vec<String> = own.iter().chain(set).map(|s| (*s).to_owned()).collect();
    let file = CaseFile::parse(&template(!with_raceway), "case", &set).unwrap();
    let drawn = |draw| {
        let mut case = file.with_draw(7, draw).unwrap().case().clone();
        let duration_s = case.solver.duration_s;
        change(&mut case, duration_s);
        case
    };
    let cases: Vec<Case> = (0..DRAWS).map(drawn).collect();
    let batches = cases.chunks(8).map(|batch| {
        let mut recorders: Vec<SteadyRecorder> =
            batch.iter().map(|_| SteadyRecorder::new()).collect();
        let mut observers: Vec<Vec<&mut dyn Observer>> = recorders
            .iter_mut()
            .map(|recorder| vec![recorder as &mut dyn Observer])
            .collect();
        let batch: Vec<&Case> = batch.iter().collect();
        let outcomes = run_batch(&batch, &mut observers, &mut |_| Control::Continue(()));
        let errors: Vec<_> = outcomes.iter().filter_map(|o| o.as_ref().err()).collect();
        assert!(errors.is_empty(), "{errors:?}");
        recorders
            .iter()
            .map(|r| r.blocks.to_vec())
            .collect::<Vec<_>>()
    });
    batches.flatten().collect()
}

fn is_stationary(runs: &[&[SteadyBlock]]) -> bool {
    let all = Stationarity::all(runs);
    all.iter()
        .all(|found| found.reason(found.of.limit()).is_none())
}

/// Whether one quantity changes by more than its limit, beyond the error over all draws.
fn changes(runs: &[&[SteadyBlock]]) -> bool {
    let all = Stationarity::all(runs);
    let beyond = |found: &Stationarity| found.change.abs() - found.error > found.of.limit();
    all.iter().any(beyond)
}

/// Part of the judgements by few of the draws that call runs stationary.
fn called_stationary(runs: &[&[SteadyBlock]]) -> f64 {
    let (mut called, mut all) = (0, 0);
    for first in 0..runs.len() {
        for stride in [1, 3, 5, 7] {
            let chosen: Vec<&[SteadyBlock]> = (0..JUDGED)
                .map(|k| runs[(first + stride * k) % runs.len()])
                .collect();
            called += usize::from(is_stationary(&chosen));
            all += 1;
        }
    }
    f64::from(called as u32) / f64::from(all)
}

/// Balls that run into the queue, queues that a raceway spreads, speeds that grow or fall: less than one judgement in
/// twenty calls them stationary. A queue at a steady speed mostly is.
#[test]
fn runs_that_physics_changes_are_rarely_called_stationary() {
    let speed = |from: f64, to: f64| {
        move |case: &mut Case, duration_s: f64| {
            let speeds = [from, to].map(|part| part * case.operation.inner_speed_rad_s);
            let table = TimeTable::new("speed", vec![0.0, duration_s], speeds.to_vec());
            case.operation.inner_speed_rad_s = speeds[0];
            case.operation.inner_speed_table = Some(table.unwrap());
        }
    };
    let none = |_: &mut Case, _: f64| {};
    let settled = ["steady.transient_orbits=24"];
    let random = "steady.start=random";
    let conditions: [Condition; 8] = [
        (
            "plain, random start",
            false,
            &[random, "steady.grade=200"],
            &none,
        ),
        (
            "the same, slower",
            false,
            &[random, "steady.grade=100"],
            &none,
        ),
        ("raceway, queue", true, &[], &none),
        ("raceway, random start", true, &[random], &none),
        ("speed doubles", false, &[], &speed(0.5, 1.0)),
        ("speed grows by an eighth", false, &[], &speed(0.88, 1.0)),
        ("speed falls by a quarter", false, &[], &speed(1.0, 0.75)),
        ("raceway, speed grows", true, &[], &speed(0.8, 1.0)),
    ];
    for (name, with_raceway, set, change) in conditions {
        let runs = runs(with_raceway, set, change);
        let runs: Vec<&[SteadyBlock]> = runs.iter().map(Vec::as_slice).collect();
        assert!(changes(&runs), "{name}: {:?}", Stationarity::all(&runs));
        let wrong = called_stationary(&runs);
        assert!(wrong < 0.05, "{name}: {wrong}");
    }
    let steady = runs(false, &settled, &none);
    let steady: Vec<&[SteadyBlock]> = steady.iter().map(Vec::as_slice).collect();
    assert!(!changes(&steady) && called_stationary(&steady) > 0.5);
}
