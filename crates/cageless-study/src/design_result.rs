//! The numbers of a design, in the units in which they are shown.

use cageless::Case;
use cageless::design::{
    Criterion, Eq11, Judgement, PassageStatistics, Recommendation, balls_in_raceway_max,
    half_angle_for_gap_rad, span_angle_curve, steady_gap_rad, theoretical_gap_rad,
};
use cageless::equilibrium;
use cageless::raceway::axial_span_limit_m;
use serde::Serialize;

use crate::search::SearchData;

/// `design --json`. Numbers of one raceway are those of the first; the critical gap is the
/// largest, the verdict the worst of all.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DesignResult {
    /// ε of Zhao 2022, Eq. (10), degrees.
    pub epsilon_deg: f64,
    /// 360°/N − ε, degrees.
    pub uniform_gap_deg: f64,
    /// Eq. (11) as published.
    pub beta0_deg: Option<f64>,
    /// Eq. (11) with the true polar angle.
    pub beta0_polar_deg: Option<f64>,
    /// Largest lC, Zhao 2022, Eq. (8), mm.
    pub axial_span_limit_mm: f64,
    /// θ by Eq. (11) for the case's own span and the nominal gap.
    pub half_angle_deg_for_span: Option<f64>,
    /// Gap below which neighbours touch in the raceway, degrees.
    pub critical_gap_deg: Option<f64>,
    /// Gap outside the raceways when all balls roll by evenly.
    pub steady_gap_deg: f64,
    /// Most balls inside at once.
    pub balls_in_raceway_max: Option<usize>,
    /// `smooth`, `double-collision`, `slips` or `infeasible`; `not-judged` without a discrete
    /// raceway.
    pub verdict: &'static str,
    /// Whether the raceways pass; null without one.
    pub passes: Option<bool>,
    /// PASS or FAIL with the verdict, the criterion that decides, and its margin.
    pub headline: String,
    /// The criterion that decides: `separation`, `deceleration` or `both-neighbours`.
    pub criterion: Option<&'static str>,
    /// Distance from the limit of that criterion, a fraction of 1, negative if it fails.
    pub margin: Option<f64>,
    /// Reasons as sentences.
    pub reasons: Vec<String>,
    /// Warnings.
    pub warnings: Vec<String>,
    /// Statistics of the passages of the balls.
    pub passages: Option<PassageNumbers>,
    /// Kink of the groove at the ends of the raceway, 45° up, degrees.
    pub kink_deg: Option<f64>,
    /// Each raceway.
    pub raceways: Vec<RacewayNumbers>,
    /// A raceway near the curve of Eq. (11) with its verdict.
    pub recommendation: Option<RecommendationNumbers>,
    /// The lC–θ curve, Fig. 5.
    pub curve: Curve,
    /// Result of `--search`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search: Option<SearchData>,
}

/// One raceway.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RacewayNumbers {
    /// lC, mm.
    pub axial_span_mm: f64,
    /// θ, degrees.
    pub half_angle_deg: f64,
    /// ψ of its middle, degrees.
    pub centre_angle_deg: f64,
    /// Eq. (11) as published, degrees.
    pub beta0_deg: f64,
    /// Gap below which neighbours touch in the raceway, degrees.
    pub critical_gap_deg: Option<f64>,
    /// `smooth`, `double-collision`, `slips` or `infeasible`.
    pub verdict: &'static str,
    /// Whether the raceway passes.
    pub passes: Option<bool>,
    /// Statistics of the passages of the balls.
    pub passages: Option<PassageNumbers>,
}

/// Passages of balls through a raceway.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PassageNumbers {
    /// Number of samples or passages.
    pub passages: usize,
    /// Contacts with neighbours per passage.
    pub collisions_mean: f64,
    /// Fraction of the passages hit by both neighbours.
    pub double_collision_fraction: f64,
    /// Largest slip in a passage, mean, m/s.
    pub slip_mean_m_s: f64,
    /// Fraction of its speed that a ball loses.
    pub speed_drop_fraction: f64,
    /// Smallest gap on leaving, degrees.
    pub gap_leave_min_deg: f64,
    /// Largest gap on leaving, degrees.
    pub gap_leave_max_deg: f64,
}

/// A raceway near the curve of Eq. (11), in the place of the case's own: recommended if it passes
/// its verdict, else only a starting point.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RecommendationNumbers {
    /// Least usable θ, degrees.
    pub half_angle_min_deg: f64,
    /// Largest usable θ, degrees.
    pub half_angle_max_deg: f64,
    /// θ as judged, degrees.
    pub half_angle_deg: f64,
    /// lC as judged, mm.
    pub axial_span_mm: f64,
    /// Whether the raceway passes its verdict at the load and speed of the case.
    pub passes: Option<bool>,
    /// `smooth`, `double-collision`, `slips` or `infeasible`.
    pub verdict: &'static str,
    /// PASS or FAIL with the verdict, the criterion that decides, and its margin.
    pub headline: String,
    /// Reasons as sentences.
    pub reasons: Vec<String>,
    /// Gap below which neighbours touch in the raceway, degrees.
    pub critical_gap_deg: Option<f64>,
    /// Raceways that were judged.
    pub judged: usize,
    /// θ of the closed-form starting point: the middle of the usable range on the curve, degrees.
    pub starting_half_angle_deg: f64,
    /// lC of the closed-form starting point, mm.
    pub starting_axial_span_mm: f64,
}

impl RecommendationNumbers {
    /// Whether this is the starting point itself.
    pub fn is_starting_point(&self) -> bool {
        self.axial_span_mm == self.starting_axial_span_mm
            && self.half_angle_deg == self.starting_half_angle_deg
    }

    /// Kind, size and origin of the recommendation as a sentence.
    pub fn sentence(&self) -> String {
        let size = format!(
            "lC {:.3} mm, θ {:.3}°",
            self.axial_span_mm, self.half_angle_deg
        );
        let range = format!(
            "the usable range of θ on the curve of Eq. (11), {:.2}° (sliding) to {:.2}° (three \
             balls inside)",
            self.half_angle_min_deg, self.half_angle_max_deg
        );
        let start = format!(
            "lC {:.3} mm, θ {:.3}°",
            self.starting_axial_span_mm, self.starting_half_angle_deg
        );
        match (self.passes, self.is_starting_point()) {
            (Some(true), true) => format!("recommended: {size}, in the middle of {range}"),
            (Some(true), false) => format!(
                "recommended: {size}, near the starting point {start} in the middle of {range}, \
                 which fails; {} raceways judged",
                self.judged
            ),
            _ => format!(
                "nothing recommended; starting point, which fails: {size}, in the middle of \
                 {range}; {} raceways near it were judged and none passes; design --search looks \
                 further",
                self.judged
            ),
        }
    }
}

/// The lC–θ curve, Fig. 5.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curve {
    /// lC, mm.
    pub axial_span_mm: Vec<f64>,
    /// θ, degrees.
    pub half_angle_deg: Vec<Option<f64>>,
    /// θ with the true polar angle, degrees.
    pub half_angle_polar_deg: Vec<Option<f64>>,
}

/// Points of the curve.
const CURVE_POINTS: usize = 60;

impl DesignResult {
    /// Result for the judgement of `case`.
    pub fn new(case: &Case, judgement: Judgement, recommendation: Option<Recommendation>) -> Self {
        let bearing = &case.bearing;
        let raceway = case.raceways.first();
        let gap = bearing.nominal_gap_rad();
        let curve = span_angle_curve(bearing, CURVE_POINTS);
        let degrees = |angle: Option<f64>| angle.map(f64::to_degrees);
        Self {
            warnings: equilibrium::overload(case).into_iter().collect(),
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
            passes: judgement.passes(),
            headline: judgement.headline(),
            criterion: judgement.deciding.map(Criterion::name),
            margin: judgement.deciding.map(Criterion::margin),
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
                    passes: judged.verdict.passes(),
                    passages: judged.passages.map(passage_numbers),
                })
                .collect(),
            kink_deg: degrees(raceway.map(|r| r.kink_angle_rad(std::f64::consts::FRAC_PI_4))),
            recommendation: recommendation.map(recommendation_numbers),
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
}

fn recommendation_numbers(r: Recommendation) -> RecommendationNumbers {
    // As judged and printed; the conversion to SI leaves rounding.
    let millimetres = |length_m: f64| (length_m * 1e6).round() / 1e3;
    let degrees = |angle_rad: f64| (angle_rad.to_degrees() * 1e3).round() / 1e3;
    let start = &r.starting_point;
    RecommendationNumbers {
        half_angle_min_deg: start.half_angle_min_rad.to_degrees(),
        half_angle_max_deg: start.half_angle_max_rad.to_degrees(),
        half_angle_deg: degrees(r.dimensions.half_angle_rad),
        axial_span_mm: millimetres(r.dimensions.axial_span_m),
        passes: r.judgement.passes(),
        verdict: r.judgement.verdict.name(),
        headline: r.judgement.headline(),
        critical_gap_deg: r.judgement.critical_gap_rad.map(f64::to_degrees),
        reasons: r.judgement.reasons,
        judged: r.judged,
        starting_half_angle_deg: degrees(start.half_angle_rad),
        starting_axial_span_mm: millimetres(start.axial_span_m),
    }
}

fn passage_numbers(p: PassageStatistics) -> PassageNumbers {
    PassageNumbers {
        passages: p.passages,
        collisions_mean: p.collisions_mean,
        double_collision_fraction: p.double_collision_fraction,
        slip_mean_m_s: p.slip_mean_m_s,
        speed_drop_fraction: p.speed_drop_fraction,
        gap_leave_min_deg: p.gap_leave_min_rad.to_degrees(),
        gap_leave_max_deg: p.gap_leave_max_rad.to_degrees(),
    }
}
