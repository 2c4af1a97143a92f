//! A verdict on a raceway from the motion of the balls (Zhao 2022, Section 4.3).

use super::criterion::{
    BOTH_NEIGHBOURS, Criterion, FILM_OUTWEIGHS, FILM_QUEUE, IN_OIL, PRESSURE_AT_REST, STEADY_GAP,
};
use super::film_evidence::FilmEvidence;
use super::pressure_at_rest::pressure_at_rest_controlled_pa;
use super::raceway_tallies::{RacewayTallies, speed_drop_fraction};
use super::raceway_verdict::RacewayVerdict;
use crate::critical_gap::{CriticalGapError, PairTest, critical_gap_rad, pair_steps};
use crate::distinct_rows::distinct_rows;
use cageless::HalfTurnRecorder;
use cageless::closed_forms::{Eq11, gap_of_delay_rad, steady_gap_rad, theoretical_gap_rad};
use cageless::contact::STRESS_LIMIT_PA;
use cageless::equilibrium::EquilibriumError;
use cageless::kinematics::raceway_delay_rad;
use cageless::passage::PassageRecorder;
use cageless::raceway::Raceway;
use cageless::simulation::{Control, Ending, Observer, Stop, run};
use cageless::{Case, Gaps, Start, StartState};

/// Numbers behind a verdict, over steady passages.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PassageStatistics {
    /// Passages counted.
    pub passages: usize,
    /// Contacts with either neighbour per passage, mean.
    pub collisions_mean: f64,
    /// Fraction of passages in which both neighbours hit.
    pub double_collision_fraction: f64,
    /// Largest slip at a loaded contact, mean over the passages.
    pub sliding_mean_m_s: f64,
    /// Fraction of the theoretical drop of orbital speed that the balls reach, mean.
    pub speed_drop_fraction: f64,
    /// Lag of a ball in the raceway against the mean orbital speed between passages.
    pub lag_mean_rad: f64,
    /// Lag over that of rolling on rigid flanks without a contact angle, of the row with the least; 0 if no ball
    /// of a row passes.
    pub lag_fraction: f64,
    /// Largest gap to the ball ahead on leaving.
    pub gap_leave_max_rad: f64,
    /// Smallest gap to the ball ahead on leaving.
    pub gap_leave_min_rad: f64,
}

/// Judgement of one raceway with what it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct RacewayJudgement {
    /// The verdict.
    pub verdict: RacewayVerdict,
    /// Reasons with their numbers.
    pub reasons: Vec<String>,
    /// The criteria in the order in which they are tested; empty if the motion cannot be judged.
    pub criteria: Vec<Criterion>,
    /// Critical gap of this raceway alone in the ring, if there is one.
    pub critical_gap_rad: Option<f64>,
    /// Statistics of the run of all balls past all raceways; `None` if it did not get so far.
    pub passages: Option<PassageStatistics>,
}

/// Judgement of all raceways of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// The worst verdict.
    pub verdict: RacewayVerdict,
    /// Reasons with their numbers, for every raceway.
    pub reasons: Vec<String>,
    /// The criterion that decides: the first that fails on the first raceway with the worst
    /// verdict, or of all that are met the one nearest to its limit.
    pub deciding: Option<Criterion>,
    /// Largest critical gap: about the gap to which all raceways together separate balls.
    pub critical_gap_rad: Option<f64>,
    /// Largest Hertz pressure of both rings at rest, as `pressure_at_rest_pa` has it; `None` if no ball passes.
    pub pressure_at_rest_pa: Option<f64>,
    /// Gap outside the raceways of balls that come by evenly in time: by rolling on rigid flanks, else by the lag of the run,
    /// with the lag of a film; `None` if that is not known.
    pub steady_gap_rad: Option<f64>,
    /// Statistics of the first raceway with the worst verdict.
    pub passages: Option<PassageStatistics>,
    /// Each raceway, in the order of the case.
    pub raceways: Vec<RacewayJudgement>,
    /// Lag of the balls by the film; `None` of a dry case, and without a run.
    pub film: Option<FilmEvidence>,
    /// Judgement of the same raceways without oil; `None` of a dry case.
    pub dry: Option<Box<Judgement>>,
    /// Cause of a run that stopped early.
    pub stopped: Option<Stop>,
}

/// The run of all balls past all raceways.
#[derive(Default)]
struct SteadyRun {
    /// Statistics of each raceway; `None` where no ball passed.
    statistics: Vec<Option<PassageStatistics>>,
    /// Lag of the balls over the half orbit away from the load, rad.
    half_turn_lag_rad: Option<f64>,
    /// Cause of an early stop.
    stopped: Option<Stop>,
}

/// Ball orbits discarded before the passages are counted, and counted.
const TURNS: [f64; 2] = [16.0, 16.0];

/// Work of one critical gap over that of one orbit of all balls, roughly.
const GAP_ORBITS: f64 = 1.5;

/// Steps that [`judge`] takes as a rule.
pub fn verdict_steps(case: &Case) -> f64 {
    if case.raceways.is_empty() {
        return 0.0;
    }
    let pairs = case.raceways.iter().map(|raceway| {
        let alone = case.with_raceways(vec![raceway.clone()]);
        pair_steps(&alone, &PairTest::default())
    });
    let steps = distinct_rows(case).len() as f64 * pairs.sum::<f64>();
    let has_oil = case.film.is_some_and(|film| film.has_oil());
    let verdicts = if has_oil { 2.0 } else { 1.0 };
    verdicts * (steps + steady_case(case).solver.steps())
}

/// Judges the case's raceways by what Zhao 2022, Section 4.3, looks at: does the
/// separation suffer from slip, are balls hit twice per passage, or do they pass
/// smoothly. The critical gap is that of each raceway alone; then all balls, evenly spaced
/// at the start and in static equilibrium, pass all raceways for 32 orbits of which the first
/// 16 are discarded. On elastic flanks and in space it looks at the share of the lag that load, contact angle and
/// sliding leave, and at double collisions; the critical gap is that of the row with the least. It has to lie between
/// the least value of [`STEADY_GAP`] and all of the steady-state gap. What stopped early or lacks a number is not judged.
///
/// A case with a film is judged with it and, beside, without. The lag of the balls by the film, over the half orbit away
/// from the load, is that of the run less that of the dry one. It widens the steady-state gap, of which the critical gap
/// may be 1.1 times as much, and has limits of its own, `FILM_QUEUE` and `FILM_OUTWEIGHS`.
///
/// `control` is called every thousand steps or so with the estimated fraction of the work that is
/// done, 0 to 1.
///
/// # Errors
/// The case is impossible, or `control` ended the work.
pub fn judge(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Judgement, CriticalGapError> {
    judge_watched(case, &mut [], control)
}

/// [`judge`], with others watching the run of all balls.
///
/// # Errors
/// The case is impossible, or `control` ended the work.
pub fn judge_watched(
    case: &Case,
    watchers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Judgement, CriticalGapError> {
    case.check_constant_operation("a verdict")
        .map_err(EquilibriumError::from)?;
    case.check_balanced("a verdict")
        .map_err(EquilibriumError::from)?;
    if case.raceways.is_empty() {
        return Ok(Judgement {
            verdict: RacewayVerdict::NotJudged,
            reasons: vec!["the outer ring has no discrete raceway".to_owned()],
            ..summary(vec![], None)
        });
    }
    if !case.film.is_some_and(|film| film.has_oil()) {
        let (judgement, _) = judge_one(case, Beside::Nothing, watchers, control)?;
        return Ok(judgement);
    }
    let without = Case {
        film: None,
        ..case.clone()
    };
    let mut half = |part: f64| control(0.5 * part);
    let (dry, lag_rad) = judge_one(&without, Beside::Wet, &mut [], &mut half)?;
    let mut half = |part: f64| control(0.5 + 0.5 * part);
    let (wet, _) = judge_one(case, Beside::Dry(lag_rad), watchers, &mut half)?;
    Ok(Judgement {
        dry: Some(Box::new(dry)),
        ..wet
    })
}

/// Counterpart of a case in its judgement: none, the case with oil, or the case without oil.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Beside {
    /// Nothing: it is dry.
    Nothing,
    /// Itself with oil.
    Wet,
    /// Itself without oil, in which the balls lag by this over the half orbit away from the load, rad.
    Dry(Option<f64>),
}

impl Beside {
    /// Evidence of the film in a case whose balls lag by this over the half orbit away from the load, rad.
    fn film_evidence(self, case: &Case, lag_rad: Option<f64>) -> Option<FilmEvidence> {
        match self {
            Self::Dry(dry) => {
                let lags_rad = [lag_rad, dry];
                Some(FilmEvidence::new(&case.bearing, lags_rad))
            }
            Self::Nothing | Self::Wet => None,
        }
    }
}

/// Gap of the balls in steady flow behind the raceways, rad; `None` where no ball has passed them.
fn measured_steady_gap_rad(
    case: &Case,
    run: &SteadyRun,
    film: Option<FilmEvidence>,
) -> Option<f64> {
    let delay_rad = match case.has_elastic_flanks() {
        false => Some(raceway_delay_rad(&case.bearing, &case.raceways)),
        true => measured_delay_rad(&run.statistics),
    };
    let film_delay_rad = film.map_or(0.0, |film| film.lag_rad);
    delay_rad.map(|delay_rad| gap_of_delay_rad(&case.bearing, delay_rad + film_delay_rad))
}

/// Judgement of a case with raceways; beside another also the lag of the balls over the half orbit away from the load.
fn judge_one(
    case: &Case,
    beside: Beside,
    watchers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<(Judgement, Option<f64>), CriticalGapError> {
    let gap_orbits = GAP_ORBITS * case.raceways.len() as f64;
    let orbits = gap_orbits + TURNS[0] + TURNS[1];
    let criticals = match critical_gaps(case, &mut |part| control(part * gap_orbits / orbits))? {
        CriticalGaps::Found(criticals) => criticals,
        CriticalGaps::Stopped(stop) => {
            let reason = format!("the run of one pair stopped: {}", stop.cause);
            return Ok((summary(vec![not_judged(reason, None)], Some(stop)), None));
        }
    };
    if let [Err(reason)] = criticals.as_slice() {
        return Ok((summary(vec![infeasible(reason.clone(), None)], None), None));
    }
    let orbit_s = case.rolling_orbit_s();
    let run = steady_passages(case, beside, watchers, &mut |time_s| {
        control(((gap_orbits + time_s / orbit_s) / orbits).min(1.0))
    })?;
    let film = beside.film_evidence(case, run.half_turn_lag_rad);
    let steady_gap_rad = measured_steady_gap_rad(case, &run, film);
    let any_passed = run.statistics.iter().any(Option::is_some);
    let pressure = match any_passed {
        true => Some(pressure_at_rest_controlled_pa(case, &mut || control(1.0))?),
        false => None,
    };
    let pressure_pa = pressure.map(|[inner, outer]| inner.max(outer));
    // All raceways together separate balls to about the largest.
    let largest = criticals.iter().flatten().copied().fold(f64::NAN, f64::max);
    let measured = |critical| Measured {
        critical,
        largest,
        steady: steady_gap_rad.unwrap_or(f64::NAN),
        pressure_pa: pressure_pa.unwrap_or(f64::NAN),
        film,
    };
    let judged = (criticals.into_iter().enumerate())
        .map(|(k, critical)| judge_raceway(case, k, critical.map(measured), &run))
        .collect();
    let judgement = Judgement {
        steady_gap_rad,
        pressure_at_rest_pa: pressure_pa,
        film,
        ..summary(judged, run.stopped)
    };
    Ok((judgement, run.half_turn_lag_rad))
}

/// Judgement of raceway `k` by what was measured, or the reason why it has no critical gap, and by a run.
fn judge_raceway(
    case: &Case,
    k: usize,
    measured: Result<Measured, String>,
    run: &SteadyRun,
) -> RacewayJudgement {
    let measured = match measured {
        Ok(measured) => measured,
        Err(reason) => return infeasible(reason, None),
    };
    let critical = measured.critical;
    if let Some(stop) = &run.stopped {
        let reason = format!("the run stopped at {:.6} s: {}", stop.time_s, stop.cause);
        return not_judged(reason, Some(critical));
    }
    match run.statistics.get(k).copied().flatten() {
        Some(statistics) => decide(case, &case.raceways[k], measured, statistics),
        None => {
            let reason = "the balls do not pass the raceway".to_owned();
            infeasible(reason, Some(critical))
        }
    }
}

/// Critical gaps of the raceways of a case.
enum CriticalGaps {
    /// Critical gap of each raceway alone, rad, or the reason why it has none.
    Found(Vec<Result<f64, String>>),
    /// A run of a pair stopped.
    Stopped(Stop),
}

/// Critical gaps of the raceways of a case, each alone; `control` is called with the part that is done.
fn critical_gaps(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<CriticalGaps, CriticalGapError> {
    let raceways = case.raceways.len() as f64;
    let mut criticals = vec![];
    for (k, raceway) in case.raceways.iter().enumerate() {
        let alone = case.with_raceways(vec![raceway.clone()]);
        let mut fraction = |part: f64| control((k as f64 + part) / raceways);
        match least_critical_gap_rad(&alone, &mut fraction) {
            Ok(gap) => criticals.push(Ok(gap)),
            Err(error @ (CriticalGapError::Case(_) | CriticalGapError::Interrupted)) => {
                return Err(error);
            }
            Err(CriticalGapError::Stopped(stop)) => return Ok(CriticalGaps::Stopped(stop)),
            Err(error) => criticals.push(Err(error.to_string())),
        }
    }
    Ok(CriticalGaps::Found(criticals))
}

/// Critical gap of the only raceway of a case, in space that of the row with the least; on elastic flanks 0 where
/// the gap of a pair never closes.
fn least_critical_gap_rad(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<f64, CriticalGapError> {
    let rows = distinct_rows(case);
    let mut least = f64::INFINITY;
    for (k, &row) in rows.iter().enumerate() {
        let test = PairTest::of_raceways(case, row, steady_gap_rad(&case.bearing, &case.raceways));
        let mut fraction = |part: f64| control((k as f64 + part) / rows.len() as f64);
        let gap = match critical_gap_rad(case, &test, &mut fraction) {
            Err(CriticalGapError::NeverCloses) if case.has_elastic_flanks() => 0.0,
            // Too deep in any case: by how much.
            Err(CriticalGapError::AlwaysCloses) => {
                let all = PairTest {
                    gap_max_rad: None,
                    ..test
                };
                critical_gap_rad(case, &all, &mut fraction)?
            }
            gap => gap?,
        };
        least = least.min(gap);
    }
    Ok(least)
}

/// Σ lag, of every raceway.
fn measured_delay_rad(statistics: &[Option<PassageStatistics>]) -> Option<f64> {
    let lags: Option<Vec<f64>> = statistics
        .iter()
        .map(|s| Some((*s)?.lag_mean_rad))
        .collect();
    Some(lags.filter(|lags| !lags.is_empty())?.iter().sum())
}

/// A raceway of which too little is known.
fn not_judged(reason: String, critical_gap_rad: Option<f64>) -> RacewayJudgement {
    RacewayJudgement {
        verdict: RacewayVerdict::NotJudged,
        ..infeasible(reason, critical_gap_rad)
    }
}

fn infeasible(reason: String, critical_gap_rad: Option<f64>) -> RacewayJudgement {
    RacewayJudgement {
        verdict: RacewayVerdict::Infeasible,
        reasons: vec![reason],
        criteria: vec![],
        critical_gap_rad,
        passages: None,
    }
}

/// The judgement of all from that of each.
fn summary(raceways: Vec<RacewayJudgement>, stopped: Option<Stop>) -> Judgement {
    let verdict = raceways
        .iter()
        .map(|r| r.verdict)
        .max()
        .unwrap_or(RacewayVerdict::Infeasible);
    let several = raceways.len() > 1;
    let reasons = raceways
        .iter()
        .enumerate()
        .flat_map(|(k, r)| {
            r.reasons.iter().map(move |reason| {
                if several {
                    format!("raceway {}: {reason}", k + 1)
                } else {
                    reason.clone()
                }
            })
        })
        .collect();
    let worst = || raceways.iter().filter(|r| r.verdict == verdict);
    let deciding = if verdict == RacewayVerdict::Smooth {
        let all: Vec<Criterion> = worst().flat_map(|r| r.criteria.iter().copied()).collect();
        Criterion::deciding(&all)
    } else {
        worst().find_map(|r| Criterion::deciding(&r.criteria))
    };
    Judgement {
        verdict,
        reasons,
        deciding,
        critical_gap_rad: raceways
            .iter()
            .filter_map(|r| r.critical_gap_rad)
            .reduce(f64::max),
        pressure_at_rest_pa: None,
        steady_gap_rad: None,
        passages: raceways
            .iter()
            .find(|r| r.verdict == verdict)
            .and_then(|r| r.passages),
        raceways,
        film: None,
        dry: None,
        stopped,
    }
}

impl Judgement {
    /// Verdict on all raceways as pass or fail; `None` where there is none to judge.
    pub fn passes(&self) -> Option<bool> {
        self.verdict.passes()
    }

    /// Whether it works, with the verdict, the criterion that decides, and its margin; or what is missing for a verdict.
    pub fn headline(&self) -> String {
        let name = self.verdict.label();
        let reason = match &self.deciding {
            Some(criterion) => criterion.to_string(),
            None => self.missing().unwrap_or_else(|| self.reasons.join("; ")),
        };
        let word = RacewayVerdict::works(self.passes());
        match self.passes() {
            None => format!("{word}: {reason}"),
            Some(true) => {
                format!("{word} from evenly spaced balls: {name}; nearest to its limit: {reason}")
            }
            Some(false) => {
                let most = self.missed_by_most();
                format!("{word} from evenly spaced balls: {name}; {reason}{most}")
            }
        }
    }

    /// The criterion that is missed by most on the first raceway with the worst verdict, where another decides.
    fn missed_by_most(&self) -> String {
        let worst = self.raceways.iter().find(|r| r.verdict == self.verdict);
        match (self.deciding, worst) {
            (Some(deciding), Some(worst)) => Criterion::missed_by_most(&worst.criteria, deciding),
            _ => String::new(),
        }
    }

    /// Reasons of a missing verdict on the raceways that are not judged.
    fn missing(&self) -> Option<String> {
        let unjudged = self.raceways.iter();
        let unjudged = unjudged.filter(|r| r.verdict == RacewayVerdict::NotJudged);
        let of_each = unjudged
            .map(|r| Criterion::missing(&r.criteria).unwrap_or_else(|| r.reasons.join("; ")));
        let all: Vec<String> = of_each.collect();
        (!all.is_empty() && self.passes().is_none()).then(|| all.join("; "))
    }
}

/// Evidence on a raceway beside its passages: gaps, rad, contact pressure, Pa, and lag by the film.
struct Measured {
    /// Critical gap of the raceway alone.
    critical: f64,
    /// Largest critical gap of all raceways.
    largest: f64,
    /// Steady-state gap of all of them.
    steady: f64,
    /// Largest Hertz pressure at rest.
    pressure_pa: f64,
    /// Lag by the film.
    film: Option<FilmEvidence>,
}

fn decide(
    case: &Case,
    raceway: &Raceway,
    Measured {
        critical,
        largest,
        steady,
        pressure_pa,
        film,
    }: Measured,
    s: PassageStatistics,
) -> RacewayJudgement {
    let bearing = &case.bearing;
    let beta0 = theoretical_gap_rad(bearing, raceway, Eq11::Published);
    let shortfall = 1.0 - critical / beta0;
    let three = 2.0 * (bearing.ball_angle_rad() + bearing.nominal_gap_rad());
    let wide = 2.0 * raceway.half_angle_rad();
    let elastic = case.has_elastic_flanks();
    let mut criteria = vec![PRESSURE_AT_REST.of(pressure_pa / STRESS_LIMIT_PA)];
    criteria.extend(film.map(|film| FILM_QUEUE.of(film.speed_deficit / film.free_share)));
    criteria.extend(Criterion::separation(elastic, shortfall));
    criteria.push(Criterion::slowing(
        elastic,
        s.speed_drop_fraction,
        s.lag_fraction,
    ));
    // A raceway in which no gap closes has no gap that a film could outweigh.
    let outweighed = film.filter(|_| largest != 0.0);
    criteria.extend(outweighed.map(|film| FILM_OUTWEIGHS.of(film.opening_gap_rad / largest)));
    let gap = STEADY_GAP.of(largest / steady);
    criteria.extend([
        film.map_or(gap, |_| gap.with_most(IN_OIL[1])),
        BOTH_NEIGHBOURS.of(s.double_collision_fraction),
    ]);
    let verdict = Criterion::verdict_of(&criteria);
    let mut reasons: Vec<String> = criteria.iter().map(Criterion::to_string).collect();
    if !elastic {
        reasons.push(format!(
            "2θ = {:.2}°: up to {} evenly spaced balls inside at once (three from {:.2}°)",
            wide.to_degrees(),
            (2.0 * wide / three).floor() as usize + 1,
            three.to_degrees(),
        ));
    }
    RacewayJudgement {
        verdict,
        reasons,
        criteria,
        critical_gap_rad: Some(critical),
        passages: Some(s),
    }
}

/// The case that [`judge`] runs: evenly spaced, settled, for 32 orbits of the balls.
pub fn steady_case(case: &Case) -> Case {
    let mut steady = Case {
        start: Start::new(
            StartState::Settled,
            Gaps::Uniform,
            case.start.lead_ball_angle_rad,
        ),
        ..case.clone()
    };
    steady.solver.duration_s = (TURNS[0] + TURNS[1]) * case.rolling_orbit_s();
    steady
}

/// Transient that [`judge`] discards before it counts passages, s.
pub fn steady_after_s(case: &Case) -> f64 {
    TURNS[0] * case.rolling_orbit_s()
}

/// Runs all balls and counts the passages of the second half, raceway by raceway.
fn steady_passages(
    case: &Case,
    beside: Beside,
    watchers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<SteadyRun, CriticalGapError> {
    let case = steady_case(case);
    let after_s = steady_after_s(&case);
    let mut tallies = RacewayTallies::new(&case);
    let mut half_turns = (beside != Beside::Nothing).then(|| HalfTurnRecorder::new(&case, after_s));
    let outcome = {
        let mut recorder = PassageRecorder::new(|passage| {
            if passage.enter_s > after_s {
                tallies.add(&passage);
            }
            Ok(())
        });
        let mut observers: Vec<&mut dyn Observer> = vec![&mut recorder];
        observers.extend(half_turns.iter_mut().map(|h| h as &mut dyn Observer));
        observers.extend(watchers.iter_mut().map(|w| &mut **w as &mut dyn Observer));
        run(&case, &mut observers, control)?
    };
    match outcome.ending {
        Ending::Stopped(stop) => {
            return Ok(SteadyRun {
                stopped: Some(stop),
                ..SteadyRun::default()
            });
        }
        Ending::Interrupted => return Err(CriticalGapError::Interrupted),
        _ => {}
    }
    let raceways = 0..case.raceways.len();
    Ok(SteadyRun {
        half_turn_lag_rad: half_turns.and_then(|half_turns| half_turns.lag_rad()),
        statistics: raceways.map(|k| statistics(&case, k, &tallies)).collect(),
        stopped: None,
    })
}

/// Lag of the balls of a case, evenly spaced at the start, over the half orbit away from the load, rad; `None` where the
/// run stops.
pub(super) fn half_turn_lag_rad(case: &Case) -> Option<f64> {
    let mut go_on = |_: f64| Control::Continue(());
    let run = steady_passages(case, Beside::Wet, &mut [], &mut go_on).ok()?;
    run.half_turn_lag_rad
}

fn statistics(case: &Case, k: usize, tallies: &RacewayTallies) -> Option<PassageStatistics> {
    let (raceway, tally) = (&case.raceways[k], tallies.of_raceway(k));
    if tally.count == 0 {
        return None;
    }
    let [gap_leave_min_rad, gap_leave_max_rad] = tally.gap_leave_range_rad;
    Some(PassageStatistics {
        passages: tally.count as usize,
        collisions_mean: tally.means().collisions,
        double_collision_fraction: tally.means().double_collision_fraction,
        sliding_mean_m_s: tally.means().sliding_m_s,
        speed_drop_fraction: speed_drop_fraction(
            case,
            raceway,
            tally.means().lowest_orbit_speed_rad_s,
        ),
        lag_mean_rad: tally.means().lag_rad,
        lag_fraction: tallies.lag_fraction(case, k),
        gap_leave_max_rad,
        gap_leave_min_rad,
    })
}

#[cfg(test)]
mod tests;
