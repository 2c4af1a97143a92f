//! Choosing a raceway: constraints, theoretical gap, and a verdict from the motion.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::bearing::Bearing;
use crate::case::{Case, Gaps, Start};
use crate::error::InputError;
use crate::kinematics::rolling_orbit_speed_rad_s;
use crate::numerics::{quadrature, root};
use crate::passage::PassageRecorder;
use crate::raceway::{Raceway, RacewayDimensions, axial_span_limit_m};
use crate::simulation::{Control, Ending, Stop, run};
use crate::spacing::{CriticalGapError, PairTest, critical_gap_rad};

/// What φ means in Zhao 2022, Eq. (11).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Eq11 {
    /// x = Ro·sin φ, as published. It takes φ for the polar angle.
    Published,
    /// φ is the position angle ψ of the ball.
    Polar,
}

/// β0 = ½ ∫ (r + Rw)/r dφ − ε over [−ε/2, ε/2], the gap that a passage without slip
/// closes exactly (Zhao 2022, Eq. (11)), rad.
pub fn theoretical_gap_rad(bearing: &Bearing, raceway: &Raceway, meaning: Eq11) -> f64 {
    let epsilon = bearing.ball_angle_rad();
    let (rw, ro) = (
        bearing.ball_radius_m(),
        bearing.dimensions().outer_groove_bottom_radius_m,
    );
    let theta = raceway.half_angle_rad();
    let centre = raceway.dimensions().centre_angle_rad;
    let integrand = |phi: f64| {
        let r = match meaning {
            Eq11::Published => raceway.effective_radius_at_x_m(ro * phi.sin()),
            Eq11::Polar => raceway.effective_radius_m(centre + phi),
        };
        (r + rw) / r
    };
    // The integrand is even, smooth up to θ and 2 beyond.
    let end = (epsilon / 2.0).min(theta);
    let inside = quadrature::gauss(integrand, 0.0, end, 8);
    inside + 2.0 * (epsilon / 2.0 - end) - epsilon
}

/// θ at which a raceway of span lC has β0 = `gap_rad` (Zhao 2022, Fig. 5), or `None` if
/// no angle that the bearing allows does.
pub fn half_angle_for_gap_rad(
    bearing: &Bearing,
    axial_span_m: f64,
    gap_rad: f64,
    meaning: Eq11,
) -> Option<f64> {
    let gap = |theta: f64| {
        let dimensions = RacewayDimensions {
            axial_span_m,
            half_angle_rad: theta,
            centre_angle_rad: 0.0,
        };
        Raceway::new(dimensions, bearing)
            .map(|raceway| theoretical_gap_rad(bearing, &raceway, meaning))
    };
    // β0 grows with θ; the path exists up to an angle that depends on the span.
    let (mut low, mut high) = (1e-3, FRAC_PI_2 * 0.999);
    if gap(high).is_err() {
        let (mut good, mut bad) = (low, high);
        gap(good).ok()?;
        while bad - good > 1e-9 {
            let middle = 0.5 * (good + bad);
            if gap(middle).is_ok() {
                good = middle
            } else {
                bad = middle
            }
        }
        high = good;
    }
    if gap(low).ok()? > gap_rad {
        low = 1e-6;
    }
    root::try_brent(|theta| gap(theta).map(|g| g - gap_rad), low, high, 1e-12).ok()?
}

/// One point of the lC–θ curve of Zhao 2022, Fig. 5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// lC.
    pub axial_span_m: f64,
    /// θ by Eq. (11) as published.
    pub half_angle_rad: Option<f64>,
    /// θ by Eq. (11) with the true polar angle.
    pub half_angle_polar_rad: Option<f64>,
}

/// θ over lC for the gap of evenly spaced balls, at `points` spans up to the limit of
/// Eq. (8); spans that no angle serves are left out.
pub fn span_angle_curve(bearing: &Bearing, points: usize) -> Vec<CurvePoint> {
    let limit = axial_span_limit_m(bearing);
    let gap = bearing.uniform_gap_rad();
    (1..points)
        .map(|k| {
            let axial_span_m = limit * k as f64 / points as f64;
            let angle = |meaning| half_angle_for_gap_rad(bearing, axial_span_m, gap, meaning);
            CurvePoint {
                axial_span_m,
                half_angle_rad: angle(Eq11::Published),
                half_angle_polar_rad: angle(Eq11::Polar),
            }
        })
        .filter(|p| p.half_angle_rad.is_some() || p.half_angle_polar_rad.is_some())
        .collect()
}

/// Largest number of balls inside a raceway at once, when they touch: ⌊2θ/ε⌋ + 1.
pub fn balls_in_raceway_max(bearing: &Bearing, raceway: &Raceway) -> usize {
    (2.0 * raceway.half_angle_rad() / bearing.ball_angle_rad()).floor() as usize + 1
}

/// Gap outside the raceways when N balls roll by evenly in time, without slip: each
/// takes T = (1/N) ∮ dψ/Ω(r(ψ)), and the balls outside are Ω·T apart. It is wider than
/// 2π/N − ε, because the balls inside are closer.
pub fn steady_gap_rad(bearing: &Bearing, raceways: &[Raceway]) -> f64 {
    let rw = bearing.ball_radius_m();
    let speed = |r: f64| rolling_orbit_speed_rad_s(bearing, 1.0, r);
    let outside = speed(rw);
    let delay: f64 = raceways
        .iter()
        .map(|raceway| {
            let centre = raceway.dimensions().centre_angle_rad;
            let excess = |psi: f64| outside / speed(raceway.effective_radius_m(centre + psi)) - 1.0;
            2.0 * quadrature::gauss(excess, 0.0, raceway.half_angle_rad() * (1.0 - 1e-12), 8)
        })
        .sum();
    (TAU + delay) / bearing.balls() as f64 - bearing.ball_angle_rad()
}

/// What to think of a raceway.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    /// Contacts with a neighbour per passage, mean.
    pub collisions_mean: f64,
    /// Share of passages with two contacts or more.
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

/// A raceway slips when the critical gap falls this share short of β0 (Eq. (11)): of the
/// paper's ten structures those that it calls slipping lose 9 % and more, the others
/// 3 % at most.
pub const SLIP_SHORTFALL: f64 = 0.05;
/// A raceway collides twice per passage when this share of the passages does: of the
/// paper's ten structures those that it calls so reach 40 %, the others 17 % at most.
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
    let (statistics, stopped) = steady_passages(case, control)?;
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
            "{:.0} % of {} passages with two contacts or more (double-collision above {:.0} %), \
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
            "2θ = {:.2}° {} 2(ε + uniform gap) = {:.2}°: {} evenly spaced balls inside at once",
            wide.to_degrees(),
            if wide > three { "above" } else { "below" },
            three.to_degrees(),
            if wide > three { "three" } else { "at most two" },
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

/// Runs all balls and counts the passages of the second half.
fn steady_passages(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<(Option<PassageStatistics>, Option<Stop>), CriticalGapError> {
    let bearing = &case.bearing;
    let rw = bearing.ball_radius_m();
    let speed = |r: f64| rolling_orbit_speed_rad_s(bearing, case.operation.inner_speed_rad_s, r);
    let turn = TAU / speed(rw);
    let mut case = Case {
        start: Start::Settled {
            gaps: Gaps::Uniform,
            lead_ball_angle_rad: case.start.lead_ball_angle_rad(),
        },
        ..case.clone()
    };
    case.solver.duration_s = (TURNS[0] + TURNS[1]) * turn;
    let mut recorder = PassageRecorder::new();
    let outcome = run(&case, &mut [&mut recorder], control)?;
    if let Ending::Stopped(stop) = outcome.ending {
        return Ok((None, Some(stop)));
    }
    let steady: Vec<_> = recorder
        .passages
        .iter()
        .filter(|p| p.raceway == 0 && p.enter_s > TURNS[0] * turn)
        .collect();
    if steady.is_empty() {
        return Ok((None, None));
    }
    let n = steady.len() as f64;
    let raceway = &case.raceways[0];
    let slowest = speed(raceway.effective_radius_m(raceway.dimensions().centre_angle_rad));
    let drop = speed(rw) - slowest;
    let mean =
        |f: &dyn Fn(&crate::passage::Passage) -> f64| steady.iter().map(|p| f(p)).sum::<f64>() / n;
    let leave =
        |f: fn(f64, f64) -> f64, from: f64| steady.iter().map(|p| p.gap_leave_rad).fold(from, f);
    Ok((
        Some(PassageStatistics {
            passages: steady.len(),
            collisions_mean: mean(&|p| f64::from(p.collisions)),
            twice_share: mean(&|p| f64::from(u8::from(p.collisions >= 2))),
            slip_mean_m_s: mean(&|p| p.slip_max_m_s),
            speed_drop_share: mean(&|p| (speed(rw) - p.orbit_speed_range_rad_s[0]) / drop),
            gap_leave_max_rad: leave(f64::max, f64::NEG_INFINITY),
            gap_leave_min_rad: leave(f64::min, f64::INFINITY),
        }),
        None,
    ))
}

/// A raceway that the bearing allows, or why not; for searching.
///
/// # Errors
/// As [`Raceway::new`].
pub fn raceway(
    bearing: &Bearing,
    axial_span_m: f64,
    half_angle_rad: f64,
) -> Result<Raceway, InputError> {
    Raceway::new(
        RacewayDimensions {
            axial_span_m,
            half_angle_rad,
            centre_angle_rad: 0.0,
        },
        bearing,
    )
}
