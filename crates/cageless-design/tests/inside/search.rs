//! The search for a raceway: what its numbers mean, and that it finds the same again.

use crate::distinct_rows::distinct_rows;
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_4, TAU};

use crate::common::oil;
use crate::common::*;
use cageless::closed_forms::{Eq11, steady_gap_rad, theoretical_gap_rad};
use cageless::raceway::{RacewayDimensions, axial_span_limit_m};
use cageless::simulation::Control;
use cageless::{
    BearingDimensions, Case, Ends, Film, FlankModel, Gaps, Raceway, RacewayForm, RacewayShape,
};
use cageless_design::critical_gap::{PairTest, critical_gap_rad};
use cageless_design::search::{
    Cause, Execute, Found, Interrupted, Job, Motion, Numbers, OperatingPoint, Outcome,
    PairSeparation, RacewayLayout, Rejection, Request, Role, SearchError, SpeedMap, Stage, Task,
    UnevenStart, VALUES, perturbed_runs, run_jobs, search,
};
use cageless_design::{AxialPoint, BOTH_NEIGHBOURS, RacewayVerdict, axial_lag, judge};

fn go_on(_: f64) -> Control {
    Control::Continue(())
}

/// The structure of a case at its own operating point, by the search's own method.
fn as_searched(span_mm: f64, angle_deg: f64) -> Case {
    let case = structure(span_mm, angle_deg);
    OperatingPoint::from_case(&case).case(&case, case.raceways.clone())
}

fn spacing(case: &Case, structure: RacewayLayout) -> PairSeparation {
    let job = Job {
        structure,
        point: OperatingPoint::from_case(case),
        task: Task::PairSeparation,
    };
    match run_jobs(case, &[&job], &mut go_on).swap_remove(0) {
        Some(Ok(Numbers::PairSeparation(spacing))) => spacing,
        other => panic!("{other:?}"),
    }
}

/// In oil critical gaps are resolved up to the multiple of the steady gap that the film has widened: a raceway for oil
/// has its own critical gap and pressure, on rigid and on elastic flanks.
#[test]
fn critical_gaps_in_oil_are_those_of_a_pair() {
    for (flanks, span_mm) in [(FlankModel::Rigid, 5.8), (FlankModel::Elastic, 6.2)] {
        let mut case = as_searched(span_mm, 25.2);
        case.flanks = flanks;
        case.film = Some(Film::flooded(oil(20.0)));
        let found = spacing(&case, RacewayLayout::from_case(&case).unwrap());
        let dry_gap = steady_gap_rad(&case.bearing, &case.raceways);
        let row = distinct_rows(&case)[0];
        let test = PairTest {
            gap_max_rad: None,
            ..PairTest::of_raceways(&case, row, dry_gap)
        };
        let alone = critical_gap_rad(&case, &test, &mut go_on).unwrap();
        assert!(alone > 1.5 * dry_gap, "{flanks:?}: {alone} {dry_gap}");
        // Bisections of other intervals, each to 2e-5 rad.
        let apart_rad = (found.critical_gap_rad - alone).abs();
        assert!(apart_rad < 5e-5, "{flanks:?}: {found:?} {alone}");
        assert!(found.stress_pa > 1e9, "{flanks:?}: {found:?}");
    }
}

/// Balls that come by anyhow are on average as far apart as the steady gap says, which is
/// well above the nominal gap, and no pair arrives much closer than the critical gap.
#[test]
fn steady_and_critical_gap_are_those_of_the_motion() {
    let case = as_searched(4.5, 25.0);
    let steady = steady_gap_rad(&case.bearing, &case.raceways);
    assert!(steady > 1.05 * case.bearing.nominal_gap_rad());
    let critical = spacing(&case, RacewayLayout::from_case(&case).unwrap()).critical_gap_rad;
    for start in 0..2 {
        let motion = perturbed_runs(
            &[(
                &case,
                UnevenStart::Drawn {
                    seed: 0,
                    number: start,
                },
            )],
            &mut go_on,
        )
        .swap_remove(0)
        .unwrap();
        let mean = motion.gap_mean_rad / steady;
        assert!((mean - 1.0).abs() < 0.01, "{start}: {mean}");
        let least = motion.gap_min_rad / critical;
        assert!((0.95..1.6).contains(&least), "{start}: {least}");
        assert!(motion.gap_deviation_rad > 0.0);
    }
}

/// What is searched has the shape of the case: its critical gap is that of the verdict on the case.
#[test]
fn a_search_keeps_the_shape_of_its_case() {
    let case = as_searched(4.906, 25.2);
    let dimensions = *case.raceways[0].dimensions();
    let mut form = RacewayForm::default();
    (form.shape, form.ends) = (RacewayShape::Steady, Ends::Blended(1e-3));
    let steady = Raceway::formed(dimensions, form, &case.bearing).unwrap();
    let steady = case.with_raceways(vec![steady]);
    let layout = RacewayLayout::from_case(&steady).unwrap();
    assert_eq!(layout.form, form);
    let quartic = RacewayLayout::from_case(&case).unwrap();
    assert_eq!(quartic.form, RacewayForm::default());
    let searched = spacing(&steady, layout).critical_gap_rad;
    let judged = judge(&steady, &mut go_on)
        .unwrap()
        .critical_gap_rad
        .unwrap();
    assert!(
        (searched / judged - 1.0).abs() < 0.01,
        "{searched} {judged}"
    );
    let quartic = spacing(&case, quartic).critical_gap_rad;
    assert!(searched > 1.03 * quartic, "{searched} {quartic}");
    // Raceways of two shapes are no structure.
    let far = RacewayDimensions {
        centre_angle_rad: 2.0,
        ..dimensions
    };
    let far = Raceway::new(far, &case.bearing).unwrap();
    let two = case.with_raceways(vec![steady.raceways[0].clone(), far]);
    assert_eq!(RacewayLayout::from_case(&two), None);
}

/// In a full complement a pair draws together on its way to the raceway, so that it starts with far more than its critical
/// gap: the search has that of the design, at any speed, and finds a shallow raceway neither too deep nor alike all others.
#[test]
fn a_search_has_the_critical_gap_of_the_design() {
    let mut dimensions = BearingDimensions::estimated(15, 4.7625e-3, 23e-3);
    dimensions.outer_groove_bottom_radius_m += 12.5e-6;
    let mut case = conventional(dimensions);
    case.flanks = FlankModel::Elastic;
    case.operation.radial_load_n = 820.0;
    case.operation.inner_speed_rad_s = 3000.0 / 60.0 * TAU;
    let mut form = RacewayForm::default();
    form.ends = Ends::Machined;
    let gaps = [1.4, 1.643].map(|span_mm| {
        let dimensions = RacewayDimensions {
            axial_span_m: span_mm * 1e-3,
            half_angle_rad: 12.36f64.to_radians(),
            centre_angle_rad: 0.0,
        };
        let raceway = Raceway::formed(dimensions, form, &case.bearing).unwrap();
        let case = case.with_raceways(vec![raceway]);
        let searched = spacing(&case, RacewayLayout::from_case(&case).unwrap()).critical_gap_rad;
        let designed = judge(&case, &mut go_on).unwrap().critical_gap_rad.unwrap();
        let steady = steady_gap_rad(&case.bearing, &case.raceways);
        assert!(
            (searched / designed - 1.0).abs() < 0.1 && searched < 1.05 * steady,
            "{searched} {designed} {steady}"
        );
        searched
    });
    assert!(gaps[0] < 0.9 * gaps[1], "{gaps:?}");
}

/// Where no load presses balls against the raceway they slide over it, however well the gap of
/// a pair may close there.
#[test]
fn raceways_without_load_are_not_called_smooth() {
    let at = |centre_deg: f64| {
        let case = as_searched(5.121, 29.3);
        let dimensions = RacewayDimensions {
            centre_angle_rad: centre_deg.to_radians(),
            ..*case.raceways[0].dimensions()
        };
        let raceway = Raceway::new(dimensions, &case.bearing).unwrap();
        case.with_raceways(vec![raceway])
    };
    let fraction = |case: &Case| {
        let motion = perturbed_runs(
            &[(case, UnevenStart::Drawn { seed: 0, number: 0 })],
            &mut go_on,
        )
        .swap_remove(0)
        .unwrap();
        (motion.speed_drop_fraction, motion.gap_min_rad)
    };
    let (bottom, top) = (at(0.0), at(170.0));
    assert!(fraction(&bottom).0 > 0.98, "{:?}", fraction(&bottom));
    assert!(fraction(&top).0 < 0.3, "{:?}", fraction(&top));
    assert!(fraction(&top).1 < 0.5 * fraction(&bottom).1);
    assert_eq!(
        judge(&top, &mut go_on).unwrap().verdict,
        RacewayVerdict::Slips
    );

    let request = Request {
        placements: vec![vec![170f64.to_radians()]],
        axial_span_range_m: Some([5.121e-3; 2]),
        half_angle_range_rad: Some([29.3f64.to_radians(); 2]),
        ..small(&top)
    };
    let found = run(&top, &request, &mut |_, jobs| Ok(all(&top, jobs)));
    assert_eq!(found.recommended, None);
    let excluded: Vec<&str> = found.rejections().iter().map(|r| r.kind.name).collect();
    assert!(excluded.contains(&"gross-sliding"), "{excluded:?}");
}

/// A range that reaches beyond what the groove allows is looked at as far as it does.
#[test]
fn ranges_end_where_the_groove_does() {
    let case = structure(5.1, 25.2);
    let all_spans = Request {
        axial_span_range_m: Some([1e-3, 1.0]),
        ..small(&case)
    };
    let mut widest = 0.0f64;
    let mut look = |_, jobs: &[Job]| {
        let spans = jobs.iter().map(|j| j.structure.axial_span_m);
        widest = spans.fold(widest, f64::max);
        Err(Interrupted)
    };
    assert!(search(&case, &all_spans, &mut look).is_err());
    let limit = axial_span_limit_m(&case.bearing);
    assert!((0.9 * limit..=limit).contains(&widest), "{widest} {limit}");
    for (spans, angles) in [(Some([8e-3, 9e-3]), None), (None, Some([1.4, 1.5]))] {
        let request = Request {
            axial_span_range_m: spans,
            half_angle_range_rad: angles,
            ..small(&case)
        };
        let refused = search(&case, &request, &mut |_, _| panic!("nothing to compute"));
        assert!(matches!(refused, Err(SearchError::Impossible(_))));
    }
}

/// Without slip the critical gap is β0 with the true angle; where a raceway is does not matter
/// if nothing pulls downwards.
#[test]
fn critical_gap_without_slip_and_without_a_direction() {
    let case = as_searched(4.5, 25.0);
    let polar = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Polar);
    let found = spacing(&case, RacewayLayout::from_case(&case).unwrap());
    assert!((found.critical_gap_rad / polar - 1.0).abs() < 2e-3);

    let mut weightless = case.clone();
    weightless.operation.radial_load_n = 0.0;
    weightless.operation.gravity_m_s2 = 0.0;
    let outcomes: Vec<Option<Outcome>> = [0.0, 1.1, -2.5]
        .iter()
        .map(|&centre| {
            let job = Job {
                structure: RacewayLayout {
                    axial_span_m: 4.5e-3,
                    half_angle_rad: 25f64.to_radians(),
                    form: Default::default(),
                    section_angle_rad: 0.0,
                    centres_rad: vec![centre],
                },
                point: OperatingPoint::from_case(&weightless),
                task: Task::PairSeparation,
            };
            run_jobs(&weightless, &[&job], &mut go_on).swap_remove(0)
        })
        .collect();
    for other in &outcomes[1..] {
        match (&outcomes[0], other) {
            (Some(Ok(Numbers::PairSeparation(a))), Some(Ok(Numbers::PairSeparation(b)))) => {
                // Turned by 63° or more, rounding differs from the first step on.
                assert!((a.critical_gap_rad / b.critical_gap_rad - 1.0).abs() < 2e-3);
            }
            (Some(Err(a)), Some(Err(b))) => assert_eq!(a, b),
            pair => panic!("{pair:?}"),
        }
    }
}

/// A mirrored pair of raceways has the critical gap that the worse of the two has alone, and widens the
/// steady gap by as much again.
#[test]
fn several_raceways() {
    let case = as_searched(4.5, 25.0);
    let at = |centres: &[f64]| RacewayLayout {
        axial_span_m: 4.5e-3,
        half_angle_rad: 25f64.to_radians(),
        form: Default::default(),
        section_angle_rad: 0.0,
        centres_rad: centres.to_vec(),
    };
    let (left, right) = (-FRAC_PI_4, FRAC_PI_4);
    let alone: Vec<PairSeparation> = [left, right]
        .iter()
        .map(|&c| spacing(&case, at(&[c])))
        .collect();
    let both = spacing(&case, at(&[left, right]));
    let largest = alone[0].critical_gap_rad.max(alone[1].critical_gap_rad);
    assert!((both.critical_gap_rad - largest).abs() < 1e-12);
    let gap =
        |s: &RacewayLayout| steady_gap_rad(&case.bearing, &s.raceways(&case.bearing).unwrap());
    let uniform = case.bearing.nominal_gap_rad();
    let one = gap(&at(&[left])) - uniform;
    assert!(((gap(&at(&[left, right])) - uniform) / one - 2.0).abs() < 1e-9);
}

/// A request that is soon done: one span, few runs.
fn small(case: &Case) -> Request {
    Request {
        axial_span_range_m: Some([5.1e-3, 5.1e-3]),
        half_angle_range_rad: Some([24f64.to_radians(), 26f64.to_radians()]),
        starts: 1,
        budget: 32,
        ..Request::from_case(case)
    }
}

fn run(case: &Case, request: &Request, execute: &mut Execute<'_>) -> Found {
    search(case, request, execute).unwrap()
}

/// The outcomes of jobs that are done together.
fn all(case: &Case, jobs: &[Job]) -> Vec<Outcome> {
    let jobs: Vec<&Job> = jobs.iter().collect();
    let outcomes = run_jobs(case, &jobs, &mut go_on);
    outcomes.into_iter().map(Option::unwrap).collect()
}

/// Whatever the order of the jobs, done together or one by one, and with any part of them known beforehand.
#[test]
fn the_same_again_in_any_order_and_after_a_stop() {
    let case = structure(5.1, 25.2);
    let request = small(&case);
    let mut known: HashMap<String, Outcome> = HashMap::new();
    let first = run(&case, &request, &mut |_, jobs| {
        let done = all(&case, jobs);
        for (job, outcome) in jobs.iter().zip(&done) {
            known.insert(job.key(), outcome.clone());
        }
        Ok(done)
    });
    let best = &first.evaluations[first.recommended.expect("something is acceptable")];
    assert!(best.on_front && best.rejection.is_none());
    assert_eq!(first.confirmed.len(), 2);

    let mut keys: Vec<String> = known.keys().cloned().collect();
    keys.sort();
    for key in keys.iter().step_by(8) {
        known.remove(key);
    }
    let mut computed = 0;
    let again = run(&case, &request, &mut |_, jobs| {
        let mut done: Vec<Outcome> = jobs
            .iter()
            .rev()
            .map(|job| {
                known.get(&job.key()).cloned().unwrap_or_else(|| {
                    computed += 1;
                    all(&case, std::slice::from_ref(job)).swap_remove(0)
                })
            })
            .collect();
        done.reverse();
        Ok(done)
    });
    assert!(computed >= keys.len() / 8);
    assert_eq!(first, again);
}

#[test]
fn a_region_without_a_raceway_says_what_excludes_it() {
    let case = structure(5.1, 25.2);
    let request = Request {
        axial_span_range_m: Some([1e-3, 1e-3]),
        ..small(&case)
    };
    let found = run(&case, &request, &mut |_, jobs| Ok(all(&case, jobs)));
    assert_eq!(found.recommended, None);
    let excluded: Vec<&str> = found.rejections().iter().map(|r| r.kind.name).collect();
    assert!(
        excluded
            .iter()
            .all(|name| ["insufficient-separation", "eq-9"].contains(name))
            && !excluded.is_empty(),
        "{excluded:?}"
    );
    let every = found.maps[0].cells.iter().all(|c| c.cause.is_some());
    assert!(every, "every cell has its reason");
    assert!(matches!(
        found.evaluations[0]
            .rejection
            .as_ref()
            .map(|r| r.cause.name()),
        Some("insufficient-separation" | "eq-9")
    ));
}

/// The nearest to what is asked for is one that was moved before one of which critical gaps alone are known.
#[test]
fn the_nearest_is_one_of_which_most_is_known() {
    let case = structure(5.1, 25.2);
    let request = Request {
        axial_span_range_m: Some([1e-3, 1e-3]),
        ..small(&case)
    };
    let mut found = run(&case, &request, &mut |_, jobs| Ok(all(&case, jobs)));
    let missed = |fraction: f64| {
        Some(Rejection {
            cause: Cause::Missed(BOTH_NEIGHBOURS.of(fraction)),
            point: Some(0),
            bunched: false,
        })
    };
    let one = found.evaluations[0].clone();
    found.evaluations = vec![one; 3];
    let fractions = [0.5, 0.26, 0.4];
    for (e, fraction) in found.evaluations.iter_mut().zip(fractions) {
        e.rejection = missed(fraction);
        e.motion = vec![None];
    }
    let closest = |found: &Found| found.closest().and_then(|e| e.rejection.clone());
    assert_eq!(closest(&found), missed(0.26));
    found.evaluations[0].motion = vec![Some(Motion::default())];
    assert_eq!(closest(&found), missed(0.5));
    found.evaluations[2].motion = vec![Some(Motion::default())];
    assert_eq!(closest(&found), missed(0.4));
}

#[test]
fn an_impossible_load_is_refused() {
    let case = structure(5.1, 25.2);
    let mut request = small(&case);
    request.points[0].radial_load_n = 1e5;
    let error = search(&case, &request, &mut |_, _| panic!("nothing to compute")).unwrap_err();
    let SearchError::Impossible(message) = error else {
        panic!("{error:?}");
    };
    assert!(
        message.contains("100000 N") && message.contains("ISO 76"),
        "{message}"
    );
}

/// Half angle from which [`acceptable`] has three fifths of the lag left under axial load, two fifths below.
const KEEPS_LAG_RAD: f64 = 25.3 * std::f64::consts::PI / 180.0;

/// As if every raceway that the closed forms allow were acceptable without axial load.
fn acceptable(case: &Case, job: &Job) -> Outcome {
    Ok(match job.task {
        Task::PairSeparation => {
            let raceways = job.structure.raceways(&case.bearing).unwrap();
            Numbers::PairSeparation(PairSeparation {
                critical_gap_rad: 0.9 * steady_gap_rad(&case.bearing, &raceways),
                shortfall: 0.0,
                stress_pa: 1e9 * (1.0 + job.structure.half_angle_rad),
            })
        }
        Task::Motion(_) => {
            let mut motion = Motion::from_values([1.0; VALUES]);
            motion.double_collision_fraction = 0.0;
            motion.sliding_m_s = job.structure.axial_span_m;
            Numbers::Motion(motion)
        }
        Task::AxialLag(0.0) => Numbers::AxialLag(0.05),
        Task::AxialLag(_) if job.structure.half_angle_rad < KEEPS_LAG_RAD => {
            Numbers::AxialLag(0.02)
        }
        Task::AxialLag(_) => Numbers::AxialLag(0.03),
    })
}

/// How many simulations a search takes at most.
fn simulations(case: &Case, request: &Request) -> usize {
    let mut motions = 0;
    let found = run(case, request, &mut |_, jobs| {
        let of_all = jobs.iter().filter(|j| matches!(j.task, Task::Motion(_)));
        motions += of_all.count();
        Ok(jobs.iter().map(|job| acceptable(case, job)).collect())
    });
    assert!(found.recommended.is_some() && found.confirmed.len() == 2);
    let cells = |m: &SpeedMap| (m.axial_span_m.len() * m.half_angle_rad.len(), m.cells.len());
    let grids = found.maps.iter().map(cells);
    assert!(
        grids
            .into_iter()
            .all(|(lines, cells)| lines == cells && cells > 0)
    );
    motions
}

/// Maps, candidates, optimiser and confirmation together, whatever is acceptable.
#[test]
fn a_search_keeps_to_its_budget() {
    let case = structure(5.1, 25.2);
    let own = Request::from_case(&case);
    let mut several = own.clone();
    several.points = vec![several.points[0]; 2];
    several.map_speeds_rad_s = vec![300.0, 600.0];
    several.placements = vec![vec![0.0], vec![0.3], vec![-0.4, 0.4]];
    for (request, starts) in [
        (own.clone(), 1),
        (own, 2),
        (several.clone(), 3),
        (several, 15),
    ] {
        let mut request = Request { starts, ..request };
        let least = request.budget_least();
        for budget in [least, 2 * least, 400.max(least)] {
            request.budget = budget;
            let taken = simulations(&case, &request);
            assert!(
                (budget / 3..=budget).contains(&taken),
                "{taken} of {budget}, {starts} starts"
            );
        }
        request.budget = least - 1;
        let error = search(&case, &request, &mut |_, _| panic!("nothing to compute")).unwrap_err();
        assert!(matches!(error, SearchError::Impossible(_)), "{error:?}");
    }
}

/// What is recommended is the acceptable structure that is nearest to the best of every objective on the front, over
/// the ranges of these: neither the first nor the best in one of them.
#[test]
fn the_recommendation_is_the_nearest_to_the_best_of_all() {
    let case = structure(5.1, 25.2);
    let request = Request::from_case(&case);
    let found = run(&case, &request, &mut |_, jobs| {
        Ok(jobs.iter().map(|job| acceptable(&case, job)).collect())
    });
    let objectives = |k: usize| found.evaluations[k].objectives.unwrap();
    let front: Vec<usize> = (0..found.evaluations.len())
        .filter(|k| found.evaluations[*k].on_front)
        .collect();
    let ends = |n: usize| {
        let values = front.iter().map(|k| objectives(*k)[n]);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        [low, values.fold(f64::NEG_INFINITY, f64::max)]
    };
    let distance = |k: usize| {
        let squares = (0..7).map(|n| {
            let [low, high] = ends(n);
            match high > low {
                true => ((objectives(k)[n] - low) / (high - low)).powi(2),
                false => 0.0,
            }
        });
        (squares.sum::<f64>() / 7.0).sqrt()
    };
    let best = found.recommended.unwrap();
    let distances: Vec<f64> = front.iter().map(|k| distance(*k)).collect();
    let farthest = distances.iter().fold(0.0, |most: f64, d| most.max(*d));
    assert!(
        front.len() > 3 && distance(best) < 0.95 * farthest,
        "{distances:?}"
    );
    for (k, other) in front.iter().zip(&distances) {
        assert!(distance(best) <= other + 1e-12, "{best} {k}: {distances:?}");
    }
    // A choice: the best of one objective is another.
    let differs = |n: usize| objectives(best)[n] > ends(n)[0];
    assert!((0..7).any(differs));
}

/// A candidate whose further starts have too many double collisions gives way to the next of the front; after
/// three, or where the budget has no more, nothing is recommended.
#[test]
fn more_starts_confirm_what_is_recommended() {
    let case = structure(5.1, 25.2);
    let own = RacewayLayout::from_case(&case).unwrap();
    // The first candidates that are confirmed collide from their later starts: 10 in 12 of 0.5.
    let found = |request: &Request, colliding: usize| {
        let mut confirmed: Vec<RacewayLayout> = vec![];
        let mut simulations = 0;
        let found = run(&case, request, &mut |stage, jobs| {
            let mut done = vec![];
            for job in jobs {
                let mut outcome = acceptable(&case, job);
                if let (Task::Motion(start), Ok(Numbers::Motion(motion))) =
                    (&job.task, &mut outcome)
                {
                    simulations += 1;
                    if stage == Stage::Confirm && job.structure != own {
                        if !confirmed.contains(&job.structure) {
                            confirmed.push(job.structure.clone());
                        }
                        let later = match start {
                            UnevenStart::Drawn { number, .. } => *number >= request.starts,
                            UnevenStart::Bunched => false,
                        };
                        let fails = confirmed.len() <= colliding && later;
                        motion.double_collision_fraction = if fails { 0.5 } else { 0.0 };
                    }
                }
                done.push(outcome);
            }
            Ok(done)
        });
        assert!(
            simulations <= request.budget,
            "{simulations} of {}",
            request.budget
        );
        (found, confirmed)
    };
    let request = Request::from_case(&case);
    let (first, confirmed) = found(&request, 0);
    let best = &first.evaluations[first.recommended.unwrap()].structure;
    assert_eq!(confirmed, std::slice::from_ref(best));
    assert_eq!(first.of_role(Role::Unconfirmed).count(), 0);

    let (second, confirmed) = found(&request, 2);
    assert_eq!(confirmed.len(), 3);
    assert_eq!(&confirmed[0], best);
    let recommended = &second.evaluations[second.recommended.unwrap()];
    assert_eq!(recommended.structure, confirmed[2]);
    assert!(recommended.on_front && recommended.rejection.is_none());
    let roles: Vec<Role> = second.confirmed.iter().map(|c| c.role).collect();
    let failed = Role::Unconfirmed;
    assert_eq!(roles, [failed, failed, Role::Recommended, Role::Own]);
    for (one, structure) in second.of_role(failed).zip(&confirmed) {
        assert_eq!(&one.evaluation.structure, structure);
        let Some(Cause::Missed(twice)) = one.evaluation.rejection.as_ref().map(|r| &r.cause) else {
            panic!("{:?}", one.evaluation.rejection);
        };
        assert_eq!(twice.name(), "both-neighbours");
        assert!((twice.value - 5.0 / 12.0).abs() < 1e-12, "{twice}");
        let listed = second
            .evaluations
            .iter()
            .find(|e| e.structure == *structure);
        let listed = listed.unwrap();
        assert!(!listed.on_front && listed.objectives.is_none());
        assert_eq!(listed.rejection, one.evaluation.rejection);
    }

    let (none, confirmed) = found(&request, 100);
    assert_eq!((none.recommended, confirmed.len()), (None, 3));
    assert!(none.front().all(|e| e.rejection.is_none()));
    assert_eq!(none.confirmed.len(), 4);
    // Neighbours of what fails are likely to fail, too.
    for (k, one) in confirmed.iter().enumerate() {
        for other in &confirmed[..k] {
            let [span, angle] = [
                one.axial_span_m / other.axial_span_m - 1.0,
                one.half_angle_rad / other.half_angle_rad - 1.0,
            ];
            assert!(span.abs() > 0.02 || angle.abs() > 0.1, "{span} {angle}");
        }
    }
    // Six starts; what is left of a small budget confirms no more than it pays for.
    let few = Request {
        budget: 96,
        ..request
    };
    let (none, confirmed) = found(&few, 100);
    assert_eq!(none.recommended, None);
    assert!((1..=3).contains(&confirmed.len()), "{}", confirmed.len());
}

/// A candidate whose balls collide twice from a bunch alone is rejected for it, however few do from the drawn starts:
/// the mean of all would hide it.
#[test]
fn a_bunched_start_confirms_what_is_recommended() {
    let case = structure(5.1, 25.2);
    let own = RacewayLayout::from_case(&case).unwrap();
    let request = Request::from_case(&case);
    let mut confirmed: Vec<RacewayLayout> = vec![];
    let found = run(&case, &request, &mut |stage, jobs| {
        let mut done = vec![];
        for job in jobs {
            let mut outcome = acceptable(&case, job);
            if let (Task::Motion(UnevenStart::Bunched), Ok(Numbers::Motion(motion))) =
                (&job.task, &mut outcome)
            {
                assert_eq!(stage, Stage::Confirm);
                if job.structure != own {
                    confirmed.push(job.structure.clone());
                }
                // One run in thirteen: 0.04 in the mean.
                motion.double_collision_fraction = if confirmed.len() < 2 { 0.527 } else { 0.1 };
            }
            done.push(outcome);
        }
        Ok(done)
    });
    assert_eq!(confirmed.len(), 2);
    let failed = found.of_role(Role::Unconfirmed).next().unwrap();
    assert_eq!(failed.evaluation.structure, confirmed[0]);
    let rejection = failed.evaluation.rejection.as_ref().unwrap();
    assert_eq!(rejection.cause, Cause::Missed(BOTH_NEIGHBOURS.of(0.527)));
    assert!(rejection.bunched && rejection.point == Some(0));
    assert_eq!(failed.statistics[0].mean.double_collision_fraction, 0.0);
    let best = found.of_role(Role::Recommended).next().unwrap();
    assert_eq!(best.evaluation.structure, confirmed[1]);
    assert_eq!(best.bunched[0].double_collision_fraction, 0.1);
}

/// Balls in one group leave all of their room behind it.
#[test]
fn a_bunch_has_one_wide_gap() {
    let case = structure(5.1, 25.2);
    let Gaps::List(gaps) = Gaps::bunched(&case.bearing) else {
        panic!("a list of gaps");
    };
    let mean = case.bearing.nominal_gap_rad();
    let (wide, within) = gaps.split_last().unwrap();
    assert!(within.iter().all(|gap| (gap / mean - 0.05).abs() < 1e-12));
    assert!((gaps.iter().sum::<f64>() / (14.0 * mean) - 1.0).abs() < 1e-12);
    assert!((wide / mean - (14.0 - 13.0 * 0.05)).abs() < 1e-12);
}

/// Raceways that lose too much of their lag under the largest axial load leave the front to others, and the
/// optimiser does not bring them back; under a load that leaves none of them enough by rolling only that of the case is simulated.
#[test]
fn a_search_demands_lag_under_axial_load() {
    let case = structure(5.1, 25.2);
    let own = RacewayLayout::from_case(&case).unwrap();
    let under = |ratio: f64| {
        let request = Request {
            axial_load_max_n: ratio * case.operation.radial_load_n,
            ..small(&case)
        };
        run(&case, &request, &mut |stage, jobs| {
            let of_case = jobs.iter().all(|job| job.structure == own);
            assert!(ratio == 0.1 || stage != Stage::Axial || of_case);
            Ok(jobs.iter().map(|job| acceptable(&case, job)).collect())
        })
    };
    let counted = |found: &Found| {
        let mut of = found.rejections().into_iter();
        of.find(|excluded| excluded.kind.name == "axial-load")
            .map_or(0, |excluded| excluded.count)
    };
    let free = under(0.0);
    let best = &free.evaluations[free.recommended.unwrap()];
    assert!(best.structure.half_angle_rad < KEEPS_LAG_RAD && best.axial.is_empty());
    assert_eq!(counted(&free), 0);

    let loaded = under(0.1);
    let best = &loaded.evaluations[loaded.recommended.unwrap()];
    assert!(best.structure.half_angle_rad >= KEEPS_LAG_RAD);
    assert_eq!(best.axial[0].lags_rad, Some([0.05, 0.03]));
    assert!((0.6..1.0).contains(&best.axial[0].rolling_fraction));
    assert!(counted(&loaded) > 0);
    let front = loaded.evaluations.iter().filter(|e| e.on_front);
    assert!(front.into_iter().all(|e| e.axial[0].fraction() > Some(0.5)));

    let heavy = under(0.6);
    assert_eq!(heavy.recommended, None);
    assert!(counted(&heavy) > 0);
}

/// The lag under axial load is that of `design --axial` with the integrator of the case.
#[test]
fn the_lag_under_axial_load_is_that_of_the_design() {
    let case = structure(5.1, 25.2);
    let axial_load_n = 0.2 * case.operation.radial_load_n;
    let job = Job {
        structure: RacewayLayout::from_case(&case).unwrap(),
        point: OperatingPoint::from_case(&case),
        task: Task::AxialLag(axial_load_n),
    };
    let Numbers::AxialLag(searched) = all(&case, &[job]).swap_remove(0).unwrap() else {
        panic!("outcome of another task");
    };
    let designed = axial_lag(&case, AxialPoint::untilted(axial_load_n), &mut go_on).unwrap();
    let designed = designed.lag.unwrap().lag_rad;
    assert!(
        (searched / designed - 1.0).abs() < 0.01,
        "{searched} {designed}"
    );
}
