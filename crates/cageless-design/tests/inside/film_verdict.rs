//! The verdict on a raceway in oil, and beside it without.

use crate::common::oil;
use cageless::closed_forms::steady_gap_rad;
use cageless::equilibrium::settle;
use cageless::film::{Film, FilmAtRest};
use cageless::passage::{Passage, PassageRecorder};
use cageless::prelude::*;
use cageless::reference;
use cageless_design::search::{Request, SearchError, run_here, search};
use cageless_design::{
    Judgement, RacewayTallies, RacewayVerdict, RunEvidence, RunVerdict, judge, recommend,
    verdict_steps,
};

fn go_on(_: f64) -> Control {
    Control::Continue(())
}

fn judged(case: &Case) -> Judgement {
    judge(case, &mut go_on).unwrap()
}

/// Structure (d) in flooded contacts.
fn in_oil(mpa_s: f64) -> Case {
    Case {
        film: Some(Film::flooded(oil(mpa_s))),
        ..reference::Structure::D.case()
    }
}

/// The raceway of structure (d) works dry and in thin oil; from 17 mPa·s on oil spaces the balls more, at 40 they
/// queue. Lags of a separate program: 1.952° and 4.93° ± 0.005°.
#[test]
fn oil_outweighs_a_raceway_and_makes_balls_queue() {
    let dry = judged(&reference::Structure::D.case());
    assert_eq!(
        (dry.verdict, &dry.film, &dry.dry),
        (RacewayVerdict::Smooth, &None, &None)
    );
    for (mpa_s, lag_deg, verdict, criterion) in [
        (5.0, Some(1.952), RacewayVerdict::Smooth, "steady-gap"),
        (
            17.0,
            Some(4.93),
            RacewayVerdict::FilmOutweighs,
            "film-outweighs",
        ),
        (40.0, None, RacewayVerdict::FilmQueue, "film-queue"),
    ] {
        let case = in_oil(mpa_s);
        let wet = judged(&case);
        assert_eq!(wet.verdict, verdict, "{mpa_s}: {}", wet.headline());
        assert_eq!(wet.deciding.unwrap().name(), criterion, "{mpa_s}");
        let film = wet.film.unwrap();
        if let Some(lag_deg) = lag_deg {
            let found_deg = film.lag_rad.to_degrees();
            assert!((found_deg - lag_deg).abs() < 0.01, "{mpa_s}: {found_deg}");
        }
        let wider_rad = wet.steady_gap_rad.unwrap() - steady_gap_rad(&case.bearing, &case.raceways);
        assert!(
            (wider_rad - film.lag_rad / 14.0).abs() < 1e-12,
            "{wider_rad}"
        );
        // Without oil to the bit what a dry case has.
        assert_eq!(wet.dry.as_deref(), Some(&dry));
    }
}

/// A deeper raceway serves thick oil and no dry bearing.
#[test]
fn a_raceway_for_oil_is_too_deep_without_it() {
    let case = in_oil(20.0);
    let deeper = crate::common::raceway(&case.bearing, 5.5, 25.2, 0.0);
    let wet = judged(&case.with_raceways(vec![deeper]));
    assert_eq!(wet.verdict, RacewayVerdict::Smooth, "{}", wet.headline());
    assert_eq!(wet.dry.unwrap().verdict, RacewayVerdict::TooDeep);
}

/// Both runs are in the expected work; the curve of Eq. (11) knows no film; a film without supply is judged as without
/// one, and out of no range.
#[test]
fn the_dry_run_is_part_of_the_work() {
    let dry = reference::Structure::D.case();
    let mut case = in_oil(5.0);
    assert!((verdict_steps(&case) / verdict_steps(&dry) - 2.0).abs() < 1e-9);
    let mut fractions = vec![];
    judge(&case, &mut |part| {
        fractions.push(part);
        Control::Continue(())
    })
    .unwrap();
    assert!(fractions.is_sorted() && fractions.last().is_some_and(|&last| last <= 1.0));
    let at_rest = |case: &Case| FilmAtRest::new(case, &settle(case).unwrap()).unwrap();
    assert!(!at_rest(&case).contact_warnings().is_empty());
    let entered = |_| Some(case.clone());
    assert_eq!(recommend(&case, &entered, &mut go_on).unwrap(), None);
    case.film.as_mut().unwrap().supply = 0.0;
    assert_eq!(verdict_steps(&case), verdict_steps(&dry));
    assert_eq!(judged(&case), judged(&dry));
    assert!(at_rest(&case).contact_warnings().is_empty());
}

/// A run whose balls queue in oil does not work, however smooth their passages are; one in thin oil does.
#[test]
fn a_run_of_queueing_balls_does_not_work() {
    for (mpa_s, expected) in [
        (5.0, RacewayVerdict::Smooth),
        (45.0, RacewayVerdict::FilmQueue),
    ] {
        let mut case = in_oil(mpa_s);
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.step_s = 2e-6;
        case.solver.duration_s = 0.3;
        let mut tallies = RacewayTallies::new(&case);
        let mut passages = PassageRecorder::new(|passage: Passage| {
            tallies.add(&Passage {
                collisions_ahead: 0,
                ..passage
            });
            Ok(())
        });
        let mut summary = SummaryRecorder::new();
        cageless::simulation::run(&case, &mut [&mut passages, &mut summary], &mut go_on).unwrap();
        let half_turn_lag_rad = summary.summary().unwrap().half_turn_lag_rad;
        let run = RunEvidence {
            passages: &tallies,
            pressure_max_pa: Some(1e9),
            half_turn_lag_rad,
        };
        let found = RunVerdict::new(&case, &run);
        assert_eq!(found.verdict, expected, "{mpa_s}: {}", found.headline);
        // At rest a free ball loses less than queueing balls do.
        let at_rest = FilmAtRest::new(&case, &settle(&case).unwrap()).unwrap();
        assert!(at_rest.speed_deficit < at_rest.queue_deficits[1]);
        let of_rest = RunVerdict::new(
            &case,
            &RunEvidence {
                half_turn_lag_rad: None,
                ..run
            },
        );
        assert_eq!(of_rest.verdict, RacewayVerdict::Smooth);
    }
}

/// Asperities that carry load are warned of.
#[test]
fn asperities_are_warned_of() {
    let warned = |mpa_s: f64| {
        let case = in_oil(mpa_s);
        let film = FilmAtRest::new(&case, &settle(&case).unwrap()).unwrap();
        let warnings = film.contact_warnings();
        (
            film.asperity_share_max,
            warnings
                .iter()
                .any(|w| w.contains("film: asperities carry")),
        )
    };
    let (share, is_warned) = warned(0.5);
    assert!(share > 0.1 && is_warned, "{share}");
    let (share, is_warned) = warned(20.0);
    assert!(share < 0.1 && !is_warned, "{share}");
}

/// The raceway that a search finds in oil has a critical gap of 1.0 to 1.1 times the steady gap with the film: more than
/// a dry search allows.
#[test]
fn a_search_in_oil_aims_at_the_steady_gap_with_the_film() {
    let case = in_oil(10.0);
    let angle_rad = 30.75f64.to_radians();
    let mut request = Request {
        axial_span_range_m: Some([5.4e-3, 5.56e-3]),
        half_angle_range_rad: Some([angle_rad; 2]),
        ..Request::from_case(&case)
    };
    request.budget = request.budget_least();
    let found = search(&case, &request, &mut |_, jobs| run_here(&case, jobs)).unwrap();
    let best = &found.evaluations[found.recommended.unwrap()];
    let gap_rad = best.spacing[0].unwrap().critical_gap_rad;
    let wet_rad = best.forms.unwrap().steady_gap_rad;
    let fraction = gap_rad / wet_rad;
    assert!((1.0..=1.1).contains(&fraction), "{fraction}");
    let raceways = best.structure.raceways(&case.bearing).unwrap();
    let dry_rad = steady_gap_rad(&case.bearing, &raceways);
    // A lag of 3.2°, over 14 balls.
    let wider_deg = (wet_rad - dry_rad).to_degrees();
    assert!((0.2..0.24).contains(&wider_deg), "{wider_deg}");
    let judged = judged(&case.with_raceways(raceways));
    assert_eq!(
        judged.verdict,
        RacewayVerdict::Smooth,
        "{}",
        judged.headline()
    );
    request.points.push(request.points[0]);
    let refused = search(&case, &request, &mut |_, jobs| run_here(&case, jobs));
    assert!(matches!(refused, Err(SearchError::Case(_))));
}
