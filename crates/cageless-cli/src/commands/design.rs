//! `cageless design`.

use cageless::Case;
use cageless::design::{
    Eq11, Judgement, PassageStatistics, Recommendation, balls_in_raceway_max,
    half_angle_for_gap_rad, judge_watched, recommend, span_angle_curve, steady_case,
    steady_gap_rad, theoretical_gap_rad,
};
use cageless::raceway::axial_span_limit_m;
use cageless::recorder::Recorder;
use cageless::snapshot::Snapshot;
use cageless::spacing::CriticalGapError;
use cageless_io::case_file::CaseFile;
use cageless_io::results::write_atomically;
use cageless_report::{SearchData, design_page, to_json};
use serde::Serialize;

use super::{deliver, make_folder, read_case, writable};
use crate::args::DesignArgs;
use crate::design_report::{PORTRAIT_ORBITS, design_data};
use crate::failure::Failure;
use crate::format::pairs;
use crate::progress::{Progress, StopFlag, catch_interrupt};
use crate::search;

/// `design --json`. Numbers of one raceway are those of the first; the critical gap is the
/// largest, the verdict the worst of all.
#[derive(Debug, Serialize)]
pub struct DesignResult {
    pub epsilon_deg: f64,
    pub uniform_gap_deg: f64,
    /// Eq. (11) as published.
    pub beta0_deg: Option<f64>,
    /// Eq. (11) with the true polar angle.
    pub beta0_polar_deg: Option<f64>,
    pub axial_span_limit_mm: f64,
    /// θ by Eq. (11) for the case's own span and the uniform gap.
    pub half_angle_deg_for_span: Option<f64>,
    pub critical_gap_deg: Option<f64>,
    /// Gap outside the raceways when all balls roll by evenly.
    pub steady_gap_deg: f64,
    pub balls_in_raceway_max: Option<usize>,
    pub verdict: &'static str,
    pub reasons: Vec<String>,
    passages: Option<PassageNumbers>,
    pub kink_deg: Option<f64>,
    /// Each raceway.
    pub raceways: Vec<RacewayNumbers>,
    pub recommendation: Option<RecommendationNumbers>,
    curve: Curve,
    /// What `--search` found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search: Option<SearchData>,
}

/// One raceway.
#[derive(Debug, Serialize)]
pub struct RacewayNumbers {
    axial_span_mm: f64,
    half_angle_deg: f64,
    pub centre_angle_deg: f64,
    beta0_deg: f64,
    pub critical_gap_deg: Option<f64>,
    pub verdict: &'static str,
    passages: Option<PassageNumbers>,
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

/// The middle of the usable part of the curve of Eq. (11).
#[derive(Debug, Serialize)]
pub struct RecommendationNumbers {
    pub half_angle_min_deg: f64,
    pub half_angle_max_deg: f64,
    pub half_angle_deg: f64,
    pub axial_span_mm: f64,
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

/// Files in the folder of `--out`.
const NUMBERS: &str = "design.json";
const PAGE: &str = "report.html";
const PAGE_DATA: &str = "report.json";

/// Analyses the case's raceways; searches for a better one if asked to.
pub fn design(args: &DesignArgs) -> Result<(), Failure> {
    let searching = args.search;
    let args = &args.case;
    let file = read_case(args)?;
    if let Some(dir) = &args.out {
        make_folder(dir)?;
        // Better found out now than when the work is done.
        for name in [NUMBERS, PAGE, PAGE_DATA] {
            writable(&dir.join(name))?;
        }
    }
    let stop = catch_interrupt();
    let Judged {
        judgement,
        recommendation,
        snapshots,
    } = judged(file.case(), &stop)?;
    let stopped = judgement.stopped.clone();
    let mut result = assemble(file.case(), judgement, recommendation);
    let mut none_found = None;
    if searching {
        let (found, data) = search::run(&file, args.out.as_deref(), &stop)?;
        none_found = found
            .recommended
            .is_none()
            .then(|| search::why_none(&found));
        result.search = Some(data);
    }
    if let Some(dir) = &args.out {
        let data = design_data(&file, &result, &snapshots);
        write_atomically(&dir.join(PAGE), design_page(&data).as_bytes())?;
        write_atomically(&dir.join(PAGE_DATA), to_json(&data)?.as_bytes())?;
    }
    if let Some(message) = none_found {
        return Err(Failure::Input(place(&file, &message)));
    }
    deliver(args, NUMBERS, &result, &text(file.case(), &result))?;
    match stopped {
        // A search does not need the case's own raceway.
        Some(stop) if !searching => Err(Failure::stopped(&stop, "")),
        _ => Ok(()),
    }
}

/// A message about the case as a whole.
fn place(file: &CaseFile, message: &str) -> String {
    let title = &file.case().title;
    if title.is_empty() {
        message.to_owned()
    } else {
        format!("{title}: {message}")
    }
}

/// What is known of the case's own raceways.
struct Judged {
    judgement: Judgement,
    recommendation: Option<Recommendation>,
    /// The end of the run that was judged.
    snapshots: Vec<Snapshot>,
}

fn judged(case: &Case, stop: &StopFlag) -> Result<Judged, Failure> {
    let steady = steady_case(case);
    let end_s = steady.solver.duration_s;
    let from_s = end_s * (1.0 - PORTRAIT_ORBITS / 32.0);
    // The run of all balls is most of the work; the recommendation takes about as long.
    let progress = Progress::new("design", 2.0, stop);
    let mut snapshots = vec![];
    let judgement = {
        let interval_s = (end_s - from_s) / SNAPSHOTS;
        let mut recorder = Recorder::new(interval_s, |snapshot: Snapshot| {
            if snapshot.time_s >= from_s {
                snapshots.push(snapshot);
            }
            Ok(())
        });
        judge_watched(
            case,
            &mut [&mut recorder],
            &mut progress.run_control(end_s, 1.0),
        )
    };
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
    Ok(Judged {
        judgement: judgement?,
        recommendation,
        snapshots,
    })
}

/// Moments of the motion that are shown.
const SNAPSHOTS: f64 = 400.0;

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
        passages: judgement.passages.map(passage_numbers),
        raceways: case
            .raceways
            .iter()
            .zip(&judgement.raceways)
            .map(|(raceway, judged)| RacewayNumbers {
                axial_span_mm: raceway.dimensions().axial_span_m * 1e3,
                half_angle_deg: raceway.half_angle_rad().to_degrees(),
                centre_angle_deg: raceway.dimensions().centre_angle_rad.to_degrees(),
                beta0_deg: theoretical_gap_rad(bearing, raceway, Eq11::Published).to_degrees(),
                critical_gap_deg: degrees(judged.critical_gap_rad),
                verdict: judged.verdict.name(),
                passages: judged.passages.map(passage_numbers),
            })
            .collect(),
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
        search: None,
    }
}

fn passage_numbers(p: PassageStatistics) -> PassageNumbers {
    PassageNumbers {
        passages: p.passages,
        collisions_mean: p.collisions_mean,
        twice_share: p.twice_share,
        slip_mean_m_s: p.slip_mean_m_s,
        speed_drop_share: p.speed_drop_share,
        gap_leave_min_deg: p.gap_leave_min_rad.to_degrees(),
        gap_leave_max_deg: p.gap_leave_max_rad.to_degrees(),
    }
}

fn text(case: &Case, r: &DesignResult) -> String {
    let degrees = |value: Option<f64>| value.map_or("-".to_owned(), |v| format!("{v:.4}°"));
    let mut lines = vec![];
    for raceway in &case.raceways {
        let d = raceway.dimensions();
        lines.push((
            "raceway",
            format!(
                "lC {:.4} mm, θ {:.4}°{}",
                d.axial_span_m * 1e3,
                d.half_angle_rad.to_degrees(),
                if case.raceways.len() > 1 {
                    format!(" at ψ = {:.2}°", d.centre_angle_rad.to_degrees())
                } else {
                    String::new()
                }
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
    if let Some(search) = &r.search {
        text += "search:\n";
        for finding in &search.findings {
            text += &format!("  - {finding}\n");
        }
    }
    text
}
