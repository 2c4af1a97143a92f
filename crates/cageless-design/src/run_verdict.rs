//! Verdict on the passages of a run, or of runs from several starts.

use std::f64::consts::FRAC_PI_2;

use super::RacewayVerdict;
use super::criterion::{BOTH_NEIGHBOURS, Criterion, FILM_QUEUE, PEAK_PRESSURE, percentage_points};
use super::raceway_tallies::RacewayTallies;
use cageless::contact::STRESS_LIMIT_PA;
use cageless::equilibrium::settle;
use cageless::film::{FilmAtRest, WEIGHT_MAX};
use cageless::numerics::Moments;
use cageless::summary::{TRANSIENT_TURNS, transient_s};
use cageless::{Case, Gaps};

/// Passages of every ball through every raceway after the transient that a verdict on a run takes: a lag is read
/// between two.
pub(crate) const PASSAGES_MIN: u64 = 2;

/// Evidence for the verdict on a run: passages, contact pressure, Pa, and lag by the film, rad.
#[derive(Debug, Clone, Copy)]
pub struct RunEvidence<'a> {
    /// Passages after the transient.
    pub passages: &'a RacewayTallies,
    /// Largest Hertz pressure of its contacts, Pa; `None` of a run within its transient.
    pub pressure_max_pa: Option<f64>,
    /// Lag of the balls over the half orbit away from the load, rad; `None` without a film.
    pub half_turn_lag_rad: Option<f64>,
}

/// Whether the balls passed the raceways of a run as they should. It rests on deceleration or lag, on contacts and on
/// pressures alone: the critical gap takes runs of its own, see [`super::judge`].
#[derive(Debug, Clone, PartialEq)]
pub struct RunVerdict {
    /// The worst of the raceways.
    pub verdict: RacewayVerdict,
    /// The criterion that decides; `None` if nothing was judged.
    pub deciding: Option<Criterion>,
    /// Standard error of its value over several starts; `None` of one run.
    pub standard_error: Option<f64>,
    /// Whether it works, with the verdict, the criterion that decides, and its margin; or why it is not judged.
    pub headline: String,
    /// Slowing and double collisions in each raceway, and the largest pressure; empty if the run is not judged.
    criteria: Vec<Criterion>,
    /// Reason of a missing verdict.
    missing: Option<String>,
}

impl RunVerdict {
    /// Verdict on a run of the case that has come to its end.
    pub fn new(case: &Case, run: &RunEvidence<'_>) -> Self {
        let pressure = run
            .pressure_max_pa
            .map(|pa| PEAK_PRESSURE.of(pa / STRESS_LIMIT_PA));
        let missing = too_few(case, run.passages);
        let mut criteria = vec![];
        if missing.is_none() && nothing_to_judge(case).is_none() {
            criteria.extend(film_queue(case, run.half_turn_lag_rad));
            for k in 0..case.raceways.len() {
                let twice = run.passages.of_raceway(k).means().double_collision_fraction;
                criteria.push(run.passages.slowing(case, k));
                criteria.push(BOTH_NEIGHBOURS.of(twice));
            }
        }
        criteria.extend(pressure);
        let all: Vec<_> = criteria
            .iter()
            .map(|criterion| (*criterion, None))
            .collect();
        let over = format!("this run{}", evenly(case));
        Self {
            criteria,
            ..Self::of(case, &all, &over, missing)
        }
    }

    /// Verdict from the mean of each criterion over runs of the case from several starts, of a pressure the largest.
    /// One that passes from some starts and fails from others is judged by what it does on average; nothing is
    /// judged where one of the starts is not.
    pub fn of_starts(case: &Case, runs: &[Self]) -> Self {
        let missing = (1..).zip(runs).find_map(|(number, run)| {
            let reason = run.missing.as_ref()?;
            Some(format!("draw {number} of {}: {reason}", runs.len()))
        });
        let most = runs.iter().map(|run| run.criteria.len()).max().unwrap_or(0);
        let of_start = |index: usize| {
            let found = runs.iter().filter_map(|run| run.criteria.get(index));
            let found: Vec<Criterion> = found.copied().collect();
            let first = *found.first()?;
            let values = || found.iter().map(|c| c.value);
            if first.largest_counts() {
                return Some((first.with_value(values().fold(0.0, f64::max)), None));
            }
            let mut moments = Moments::default();
            values().for_each(|value| moments.add(value, 1.0));
            let error = moments.deviation() / (moments.weight - 1.0).sqrt();
            let error = (found.len() > 1).then_some(error);
            Some((first.with_value(moments.mean), error))
        };
        let all: Vec<_> = match missing {
            None => (0..most).filter_map(of_start).collect(),
            Some(_) => vec![],
        };
        let over = format!("the mean of {} runs{}", runs.len(), evenly(case));
        Self::of(case, &all, &over, missing)
    }

    /// Verdict on a run of the case that ended early, which has none.
    pub fn unfinished(case: &Case, reason: &str) -> Self {
        Self::of(case, &[], "", Some(reason.to_owned()))
    }

    /// Verdict from criteria with their standard errors, `over` what they were read from; `missing` is what keeps it
    /// from being a pass.
    fn of(
        case: &Case,
        all: &[(Criterion, Option<f64>)],
        over: &str,
        missing: Option<String>,
    ) -> Self {
        let criteria: Vec<Criterion> = all.iter().map(|(criterion, _)| *criterion).collect();
        let missing = nothing_to_judge(case)
            .or(missing)
            .or_else(|| Criterion::missing(&criteria));
        let deciding = Criterion::deciding(&criteria)
            .filter(|c| nothing_to_judge(case).is_none() && !(missing.is_some() && c.is_met()));
        let standard_error = deciding.and_then(|criterion| {
            let place = criteria.iter().position(|c| *c == criterion)?;
            all[place].1
        });
        let verdict = deciding.map_or(RacewayVerdict::NotJudged, Criterion::verdict);
        let headline = match deciding {
            None => {
                let reason = missing.as_deref().unwrap_or("nothing was observed");
                format!("not judged: {reason}")
            }
            Some(criterion) => {
                let word = RacewayVerdict::works(Some(criterion.is_met()));
                let nearest = match criterion.is_met() {
                    true => "nearest to its limit: ",
                    false => "",
                };
                let error = standard_error.map_or(String::new(), |error| {
                    let points = percentage_points(error);
                    format!(", standard error {points} percentage points")
                });
                let most = Criterion::missed_by_most(&criteria, criterion);
                let also = match case.film {
                    Some(_) => {
                        "for the critical gap, beside that of the film, and the run without oil"
                    }
                    None => "for the critical gap",
                };
                format!(
                    "{word} in {over}: {}; {nearest}{criterion}{error}{most}; {also} run `cageless design`",
                    verdict.label()
                )
            }
        };
        Self {
            verdict,
            deciding,
            standard_error,
            headline,
            criteria: vec![],
            missing,
        }
    }
}

/// Criterion of balls that queue in the film of a case: the speed that they lose in a run, or that a free ball loses at
/// rest if it is more. `None` without oil, where the speed varies, and where weight moves the balls as much.
fn film_queue(case: &Case, half_turn_lag_rad: Option<f64>) -> Option<Criterion> {
    let supplied = case.film.is_some_and(|film| film.has_oil()) && case.has_constant_operation();
    let film = FilmAtRest::new(case, &supplied.then(|| settle(case).ok())??)?;
    if film.weight_share > WEIGHT_MAX {
        return None;
    }
    // By its weight a ball that rolls over the top lags by 2gρ/(1.4 v²), to first order.
    let weight_rad = 2.0 / 1.4 * film.weight_share;
    let lost = half_turn_lag_rad.map_or(0.0, |lag_rad| (lag_rad - weight_rad) / FRAC_PI_2);
    Some(FILM_QUEUE.of(lost.max(film.speed_deficit) / film.free_share))
}

/// How the balls of a case were started where they were evenly spaced, which is the least test of a raceway.
fn evenly(case: &Case) -> &'static str {
    match case.start.gaps {
        Gaps::Uniform => " from evenly spaced balls",
        Gaps::List(_) => "",
    }
}

/// Why a case has nothing that a run could be judged by.
fn nothing_to_judge(case: &Case) -> Option<String> {
    if case.rotor.is_some() {
        let reason = "the inner ring has no constant speed under a falling rotor; `cageless drop` judges the drop";
        return Some(reason.to_owned());
    }
    let plain = case.raceways.is_empty();
    plain.then(|| "the outer ring has no discrete raceway".to_owned())
}

/// Why so few passages are no evidence.
fn too_few(case: &Case, passages: &RacewayTallies) -> Option<String> {
    let least = passages.least_of_a_ball();
    (least < PASSAGES_MIN).then(|| {
        let enough = match case.has_constant_operation() {
            // The transient, the way to the raceway, the way round to the last passage, and that itself.
            true => {
                let orbits = TRANSIENT_TURNS + PASSAGES_MIN as f64 + 1.0;
                let milliseconds = (1e3 * orbits * case.rolling_orbit_s()).ceil();
                format!("solver.duration_s of {} or more", milliseconds / 1e3)
            }
            false => "a longer solver.duration_s".to_owned(),
        };
        format!(
            "every ball has to pass every discrete raceway {PASSAGES_MIN} times after the transient (t > {:.4} s), and \
             one has passed {} ({enough})",
            transient_s(case),
            match least {
                0 => "none".to_owned(),
                times => format!("{times}"),
            }
        )
    })
}
