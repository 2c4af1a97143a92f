//! `cageless design`.

use cageless::Case;
use cageless::design::{
    Eq11, Judgement, Recommendation, balls_in_raceway_max, half_angle_for_gap_rad, judge,
    recommend, span_angle_curve, steady_case, steady_gap_rad, theoretical_gap_rad,
};
use cageless::raceway::axial_span_limit_m;
use cageless::spacing::CriticalGapError;
use serde::Serialize;

use super::{deliver, read_case};
use crate::args::CaseArgs;
use crate::failure::Failure;
use crate::format::pairs;
use crate::progress::{Progress, catch_interrupt};

/// `design --json`.
#[derive(Debug, Serialize)]
struct DesignResult {
    epsilon_deg: f64,
    uniform_gap_deg: f64,
    /// Eq. (11) as published.
    beta0_deg: Option<f64>,
    /// Eq. (11) with the true polar angle.
    beta0_polar_deg: Option<f64>,
    axial_span_limit_mm: f64,
    /// θ by Eq. (11) for the case's own span and the uniform gap.
    half_angle_deg_for_span: Option<f64>,
    critical_gap_deg: Option<f64>,
    /// Gap outside the raceway when all balls roll by evenly.
    steady_gap_deg: f64,
    balls_in_raceway_max: Option<usize>,
    verdict: &'static str,
    reasons: Vec<String>,
    passages: Option<PassageNumbers>,
    kink_deg: Option<f64>,
    recommendation: Option<RecommendationNumbers>,
    curve: Curve,
}

#[derive(Debug, Serialize)]
struct PassageNumbers {
    passages: usize,
    collisions_mean: f64,
    twice_share: f64,
    slip_mean_m_s: f64,
    speed_drop_share: f64,
    gap_leave_min_deg: f64,
    gap_leave_max_deg: f64,
}

#[derive(Debug, Serialize)]
struct RecommendationNumbers {
    half_angle_min_deg: f64,
    half_angle_max_deg: f64,
    half_angle_deg: f64,
    axial_span_mm: f64,
}

/// The lC–θ curve, Fig. 5.
#[derive(Debug, Serialize)]
struct Curve {
    axial_span_mm: Vec<f64>,
    half_angle_deg: Vec<Option<f64>>,
    half_angle_polar_deg: Vec<Option<f64>>,
}

/// Points of the curve.
const CURVE_POINTS: usize = 60;

/// Analyses the case's raceway.
pub fn design(args: &CaseArgs) -> Result<(), Failure> {
    let file = read_case(args)?;
    let case = file.case();
    // The run of all balls is most of the work; the recommendation takes about as long.
    let progress = Progress::new("design", 2.0, &catch_interrupt());
    let judgement = judge(
        case,
        &mut progress.run_control(steady_case(case).solver.duration_s, 1.0),
    )?;
    if progress.interrupted() {
        return Err(Failure::Interrupted(
            "interrupted before there was a result".to_owned(),
        ));
    }
    let recommendation = match recommend(case) {
        Ok(found) => found,
        Err(CriticalGapError::Case(error)) => return Err(error.into()),
        // No run of a pair can be judged here; the verdict says why.
        Err(_) => None,
    };
    drop(progress);
    let stopped = judgement.stopped.clone();
    let result = assemble(case, judgement, recommendation);
    deliver(args, "design.json", &result, &text(case, &result))?;
    match stopped {
        Some(stop) => Err(Failure::stopped(&stop, "")),
        None => Ok(()),
    }
}

fn assemble(
    case: &Case,
    judgement: Judgement,
    recommendation: Option<Recommendation>,
) -> DesignResult {
    let bearing = &case.bearing;
    let raceway = case.raceways.first();
    let gap = bearing.uniform_gap_rad();
    let curve = span_angle_curve(bearing, CURVE_POINTS);
    let degrees = |angle: Option<f64>| angle.map(f64::to_degrees);
    DesignResult {
        epsilon_deg: bearing.ball_angle_rad().to_degrees(),
        uniform_gap_deg: gap.to_degrees(),
        beta0_deg: degrees(raceway.map(|r| theoretical_gap_rad(bearing, r, Eq11::Published))),
        beta0_polar_deg: degrees(raceway.map(|r| theoretical_gap_rad(bearing, r, Eq11::Polar))),
        axial_span_limit_mm: axial_span_limit_m(bearing) * 1e3,
        half_angle_deg_for_span: degrees(raceway.and_then(|r| {
            half_angle_for_gap_rad(bearing, r.dimensions().axial_span_m, gap, Eq11::Published)
        })),
        critical_gap_deg: degrees(judgement.critical_gap_rad),
        steady_gap_deg: steady_gap_rad(bearing, &case.raceways).to_degrees(),
        balls_in_raceway_max: raceway.map(|r| balls_in_raceway_max(bearing, r)),
        verdict: judgement.verdict.name(),
        reasons: judgement.reasons,
        passages: judgement.passages.map(|p| PassageNumbers {
            passages: p.passages,
            collisions_mean: p.collisions_mean,
            twice_share: p.twice_share,
            slip_mean_m_s: p.slip_mean_m_s,
            speed_drop_share: p.speed_drop_share,
            gap_leave_min_deg: p.gap_leave_min_rad.to_degrees(),
            gap_leave_max_deg: p.gap_leave_max_rad.to_degrees(),
        }),
        kink_deg: degrees(raceway.map(|r| r.kink_angle_rad(std::f64::consts::FRAC_PI_4))),
        recommendation: recommendation.map(|r| RecommendationNumbers {
            half_angle_min_deg: r.half_angle_min_rad.to_degrees(),
            half_angle_max_deg: r.half_angle_max_rad.to_degrees(),
            half_angle_deg: r.half_angle_rad.to_degrees(),
            axial_span_mm: r.axial_span_m * 1e3,
        }),
        curve: Curve {
            axial_span_mm: curve.iter().map(|p| p.axial_span_m * 1e3).collect(),
            half_angle_deg: curve.iter().map(|p| degrees(p.half_angle_rad)).collect(),
            half_angle_polar_deg: curve
                .iter()
                .map(|p| degrees(p.half_angle_polar_rad))
                .collect(),
        },
    }
}

fn text(case: &Case, r: &DesignResult) -> String {
    let degrees = |value: Option<f64>| value.map_or("-".to_owned(), |v| format!("{v:.4}°"));
    let mut lines = vec![];
    if let Some(raceway) = case.raceways.first() {
        let d = raceway.dimensions();
        lines.push((
            "raceway",
            format!(
                "lC {:.4} mm, θ {:.4}°",
                d.axial_span_m * 1e3,
                d.half_angle_rad.to_degrees()
            ),
        ));
    }
    lines.extend([
        ("ε", format!("{:.4}°", r.epsilon_deg)),
        (
            "uniform gap 360°/N − ε",
            format!("{:.4}°", r.uniform_gap_deg),
        ),
        (
            "limit of lC, Eq. (8)",
            format!("{:.4} mm", r.axial_span_limit_mm),
        ),
        ("β0, Eq. (11)", degrees(r.beta0_deg)),
        ("β0 with the polar angle", degrees(r.beta0_polar_deg)),
        (
            "θ of Eq. (11) for this lC",
            degrees(r.half_angle_deg_for_span),
        ),
        (
            "gap outside in steady flow",
            format!("{:.4}°", r.steady_gap_deg),
        ),
        ("critical gap", degrees(r.critical_gap_deg)),
        (
            "balls inside at most",
            r.balls_in_raceway_max
                .map_or("-".to_owned(), |n| n.to_string()),
        ),
        ("kink at the ends, 45° up", degrees(r.kink_deg)),
        ("verdict", r.verdict.to_owned()),
    ]);
    let mut text = pairs(&lines);
    for reason in &r.reasons {
        text += &format!("  - {reason}\n");
    }
    text += &match &r.recommendation {
        Some(n) => format!(
            "recommended: lC {:.3} mm, θ {:.3}° (on the curve of Eq. (11), in the middle of the \
             range of θ from {:.2}° (slip) to {:.2}° (three balls inside))\n",
            n.axial_span_mm, n.half_angle_deg, n.half_angle_min_deg, n.half_angle_max_deg
        ),
        None => "recommended: none; on the curve of Eq. (11) balls slip too much wherever three \
                 do not fit inside at once\n"
            .to_owned(),
    };
    text
}
