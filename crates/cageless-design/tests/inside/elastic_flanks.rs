//! Verdicts on elastic flanks of a discrete raceway.

use crate::common::structure;
use crate::search::{Job, Numbers, OperatingPoint, RacewayLayout, Task, run_jobs};
use crate::{RacewayTallies, RacewayVerdict, RunEvidence, RunVerdict, judge_watched};
use cageless::passage::PassageRecorder;
use cageless::simulation::Control;
use cageless::{Case, FlankModel, Motion};

fn elastic(mut case: Case) -> Case {
    case.flanks = FlankModel::Elastic;
    case
}

/// Verdict, lag that is left, critical gap and what a search finds on elastic flanks in the plane are those in space, of a raceway that
/// keeps its lag but not its critical gap, and of a short one on which little friction leaves the balls less than half of it; so is a run's own verdict.
#[test]
fn verdicts_on_elastic_flanks_are_those_in_space() {
    let mut steep = structure(6.3, 9.0);
    steep.contact.friction.coefficient = 0.002;
    for (case, expected, expected_of_run) in [
        (
            structure(5.1, 25.2),
            RacewayVerdict::TooShallow,
            RacewayVerdict::Smooth,
        ),
        (steep, RacewayVerdict::LosesLag, RacewayVerdict::LosesLag),
    ] {
        let space = Case {
            motion: Motion::Space,
            ..case.clone()
        };
        let [plane, space] = [elastic(case), space].map(|case| {
            let mut tallies = RacewayTallies::new(&case);
            let mut recorder = PassageRecorder::new(|passage| {
                tallies.add(&passage);
                Ok(())
            });
            let judgement =
                judge_watched(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
            let run = RunEvidence {
                passages: &tallies,
                pressure_max_pa: judgement.pressure_at_rest_pa,
                half_turn_lag_rad: None,
            };
            let own = RunVerdict::new(&case, &run).verdict;
            let found = [judgement.verdict, own];
            assert_eq!(found, [expected, expected_of_run], "{judgement:?}");
            let job = Job {
                structure: RacewayLayout::from_case(&case).unwrap(),
                point: OperatingPoint::from_case(&case),
                task: Task::PairSeparation,
            };
            let searched = run_jobs(&case, &[&job], &mut |_| Control::Continue(())).swap_remove(0);
            let Some(Ok(Numbers::PairSeparation(searched))) = searched else {
                panic!("{searched:?}");
            };
            [
                judgement.critical_gap_rad.unwrap(),
                judgement.steady_gap_rad.unwrap(),
                judgement.passages.unwrap().lag_fraction,
                searched.critical_gap_rad,
                1.0 - searched.shortfall,
                searched.stress_pa,
            ]
        });
        for (plane, space) in plane.into_iter().zip(space) {
            assert!((plane / space - 1.0).abs() < 1e-3, "{plane} {space}");
        }
    }
}
