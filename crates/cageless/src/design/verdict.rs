//! A verdict on a raceway from the motion of the balls (Zhao 2022, Section 4.3).

use std::f64::consts::TAU;

use super::{Eq11, theoretical_gap_rad};
use crate::case::{Case, Gaps, Start};
use crate::kinematics::rolling_orbit_speed_rad_s;
use crate::passage::{PassageRecorder, PassageTally};
use crate::raceway::Raceway;
use crate::simulation::{Control, Ending, Observer, Stop, run};
use crate::spacing::{CriticalGapError, PairTest, critical_gap_rad};

/// What to think of a raceway.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Balls pass without sliding and without being hit from both sides.
    Smooth,
    /// Balls are hit by both neighbours in one passage.
    DoubleCollision,
    /// Balls slide so much that the separation suffers.
    Slips,
    /// The raceway does not work at all.
    Infeasible,
}

impl Verdict {
    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Smooth => "smooth",
            Self::DoubleCollision => "double-collision",
            Self::Slips => "slips",
            Self::Infeasible => "infeasible",
        }
    }
}

/// Numbers behind a verdict, over steady passages.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PassageStatistics {
    /// Passages counted.
    pub passages: usize,
    /// Contacts with either neighbour per passage, mean.
    pub collisions_mean: f64,
    /// Share of passages in which both neighbours hit.
    pub twice_share: f64,
    /// Largest slip at a loaded contact, mean over the passages.
    pub slip_mean_m_s: f64,
    /// Share of the theoretical drop of orbital speed that the balls reach, mean.
    pub speed_drop_share: f64,
    /// Largest gap to the ball ahead on leaving.
    pub gap_leave_max_rad: f64,
    /// Smallest gap to the ball ahead on leaving.
    pub gap_leave_min_rad: f64,
}

/// Judgement of a raceway with what it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// Why, in numbers.
    pub reasons: Vec<String>,
    /// Critical gap, if there is one.
    pub critical_gap_rad: Option<f64>,
    /// Statistics of the run; `None` if it did not get so far.
    pub passages: Option<PassageStatistics>,
    /// How the run of all balls ended, if before its time.
    pub stopped: Option<Stop>,
}

/// A raceway slips when the critical gap falls this share short of β0 (Eq. (11)). In the
/// `paper` profile those of the paper's ten structures that it calls slipping lose 9 %
/// and more, the others 3 % at most; the `physical` profile, where balls slip earlier,
/// adds (f).
pub const SLIP_SHORTFALL: f64 = 0.05;
/// A raceway collides twice per passage when this share of the passages does. In the
/// `paper` profile those of the paper's ten structures that it calls so lie well above,
/// the others well below; in `physical`, (c) falls below.
pub const TWICE_SHARE: f64 = 0.25;
/// Ball orbits discarded before the passages are counted, and counted.
const TURNS: [f64; 2] = [16.0, 16.0];

/// Judges the case's first raceway by what Zhao 2022, Section 4.3, looks at: does the
/// separation suffer from slip, are balls hit twice per passage, or do they pass
/// smoothly. The balls start evenly spaced in static equilibrium; the first 16 of 32
/// orbits are discarded.
///
/// # Errors
/// The case is impossible.
pub fn judge(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Judgement, CriticalGapError> {
    judge_watched(case, &mut [], control)
}

/// [`judge`], with others watching the run of all balls.
///
/// # Errors
/// The case is impossible.
pub fn judge_watched(
    case: &Case,
    watchers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Judgement, CriticalGapError> {
    let Some(raceway) = case.raceways.first() else {
        return Ok(infeasible(
            "the outer ring has no discrete raceway".to_owned(),
            None,
        ));
    };
    let critical = match critical_gap_rad(case, &PairTest::default()) {
        Ok(gap) => gap,
        Err(CriticalGapError::Case(error)) => return Err(error.into()),
        Err(CriticalGapError::Stopped(stop)) => {
            return Ok(infeasible(
                format!("the run of one pair stopped: {}", stop.cause),
                Some(stop),
            ));
        }
        Err(error) => return Ok(infeasible(error.to_string(), None)),
    };
    let (statistics, stopped) = steady_passages(case, watchers, control)?;
    let Some(statistics) = statistics else {
        let mut judgement = infeasible(
            stopped.as_ref().map_or_else(
                || "the balls do not pass the raceway".to_owned(),
                |stop| format!("the run stopped at {} s: {}", stop.time_s, stop.cause),
            ),
            stopped,
        );
        judgement.critical_gap_rad = Some(critical);
        return Ok(judgement);
    };
    Ok(decide(case, raceway, critical, statistics))
}

fn infeasible(reason: String, stopped: Option<Stop>) -> Judgement {
    Judgement {
        verdict: Verdict::Infeasible,
        reasons: vec![reason],
        critical_gap_rad: None,
        passages: None,
        stopped,
    }
}

fn decide(case: &Case, raceway: &Raceway, critical: f64, s: PassageStatistics) -> Judgement {
    let bearing = &case.bearing;
    let beta0 = theoretical_gap_rad(bearing, raceway, Eq11::Published);
    let shortfall = 1.0 - critical / beta0;
    let three = 2.0 * (bearing.ball_angle_rad() + bearing.uniform_gap_rad());
    let wide = 2.0 * raceway.half_angle_rad();
    let verdict = if shortfall > SLIP_SHORTFALL {
        Verdict::Slips
    } else if s.twice_share > TWICE_SHARE {
        Verdict::DoubleCollision
    } else {
        Verdict::Smooth
    };
    let reasons = vec![
        format!(
            "critical gap {:.4}°, {:.1} % {} β0 = {:.4}° (slips above {:.0} % short)",
            critical.to_degrees(),
            100.0 * shortfall.abs(),
            if shortfall < 0.0 { "above" } else { "short of" },
            beta0.to_degrees(),
            100.0 * SLIP_SHORTFALL
        ),
        format!(
            "{:.0} % of {} passages hit by both neighbours (double-collision above {:.0} %), \
             {:.2} contacts per passage",
            100.0 * s.twice_share,
            s.passages,
            100.0 * TWICE_SHARE,
            s.collisions_mean
        ),
        format!(
            "slip up to {:.3} m/s per passage, {:.0} % of the theoretical drop of orbital speed \
             reached",
            s.slip_mean_m_s,
            100.0 * s.speed_drop_share
        ),
        format!(
            "2θ = {:.2}°: up to {} evenly spaced balls inside at once (three from {:.2}°)",
            wide.to_degrees(),
            (2.0 * wide / three).floor() as usize + 1,
            three.to_degrees(),
        ),
        format!(
            "β0 = {:.0} % of the uniform gap {:.4}°: evenly spaced balls {}",
            100.0 * beta0 / bearing.uniform_gap_rad(),
            bearing.uniform_gap_rad().to_degrees(),
            if beta0 < 0.9 * bearing.uniform_gap_rad() {
                "are hardly spread by so shallow a groove"
            } else if beta0 > 1.1 * bearing.uniform_gap_rad() {
                "collide in so deep a groove"
            } else {
                "just touch, as they should"
            },
        ),
    ];
    Judgement {
        verdict,
        reasons,
        critical_gap_rad: Some(critical),
        passages: Some(s),
        stopped: None,
    }
}

/// The case that [`judge`] runs: evenly spaced, settled, for 32 orbits of the balls.
pub fn steady_case(case: &Case) -> Case {
    let mut steady = Case {
        start: Start::Settled {
            gaps: Gaps::Uniform,
            lead_ball_angle_rad: case.start.lead_ball_angle_rad(),
        },
        ..case.clone()
    };
    steady.solver.duration_s = (TURNS[0] + TURNS[1]) * orbit_s(case);
    steady
}

/// What [`judge`] discards before it counts passages.
pub fn steady_after_s(case: &Case) -> f64 {
    TURNS[0] * orbit_s(case)
}

/// Time of one orbit of a rolling ball on the plain raceway.
fn orbit_s(case: &Case) -> f64 {
    let bearing = &case.bearing;
    TAU / rolling_orbit_speed_rad_s(
        bearing,
        case.operation.inner_speed_rad_s,
        bearing.ball_radius_m(),
    )
}

/// Runs all balls and counts the passages of the second half.
fn steady_passages(
    case: &Case,
    watchers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<(Option<PassageStatistics>, Option<Stop>), CriticalGapError> {
    let bearing = &case.bearing;
    let rw = bearing.ball_radius_m();
    let speed = |r: f64| rolling_orbit_speed_rad_s(bearing, case.operation.inner_speed_rad_s, r);
    let case = steady_case(case);
    let after_s = steady_after_s(&case);
    let mut tally = PassageTally::new();
    let outcome = {
        let mut recorder = PassageRecorder::new(|passage| {
            if passage.raceway == 0 && passage.enter_s > after_s {
                tally.add(&passage);
            }
            Ok(())
        });
        let mut observers: Vec<&mut dyn Observer> = vec![&mut recorder];
        observers.extend(watchers.iter_mut().map(|w| &mut **w as &mut dyn Observer));
        run(&case, &mut observers, control)?
    };
    match outcome.ending {
        Ending::Stopped(stop) => return Ok((None, Some(stop))),
        Ending::Interrupted => return Err(CriticalGapError::Interrupted),
        _ => {}
    }
    if tally.count == 0 {
        return Ok((None, None));
    }
    let raceway = &case.raceways[0];
    let slowest = speed(raceway.effective_radius_m(raceway.dimensions().centre_angle_rad));
    let drop = speed(rw) - slowest;
    let [gap_leave_min_rad, gap_leave_max_rad] = tally.gap_leave_range_rad;
    Ok((
        Some(PassageStatistics {
            passages: tally.count as usize,
            collisions_mean: tally.collisions_mean(),
            twice_share: tally.twice_share(),
            slip_mean_m_s: tally.slip_mean_m_s(),
            speed_drop_share: (speed(rw) - tally.slowest_mean_rad_s()) / drop,
            gap_leave_max_rad,
            gap_leave_min_rad,
        }),
        None,
    ))
}
