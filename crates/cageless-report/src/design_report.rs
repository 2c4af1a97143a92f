//! Data of the report of a design.

use crate::recommended::{ShownRaceway, recommended_case};
use crate::run_report::motion;
use crate::text::pass_word;
use crate::{
    ContactTrack, DesignCurve, DesignData, DesignLimit, LimitedQuantity, Parameter, Provenance,
    RacewayLabel, RacewaySurface,
};
use cageless::Case;
use cageless::design::{span_angle_curve, steady_after_s, steady_case};
use cageless::dynamics::InstructionSet;
use cageless::raceway::axial_span_limit_m;
use cageless::snapshot::Snapshot;
use cageless_io::case_file::CaseFile;
use cageless_io::results::VERSION;
use cageless_study::{DesignResult, entered, parameter, parameters, provenance};

/// Points of the curve of Eq. (11).
const CURVE_POINTS: usize = 240;

/// The outer rings that a design page sets side by side: recommended, the case's own,
/// conventional.
pub fn rings_of(file: &CaseFile, result: &DesignResult) -> Vec<(&'static str, Case)> {
    let own = file.case();
    let conventional = entered(file, vec![], None);
    let rings = [
        (
            "recommended",
            recommended_case(file, result).filter(|_| recommends(result)),
        ),
        (
            "initial design",
            (!own.raceways.is_empty()).then(|| own.clone()),
        ),
        ("conventional", conventional),
    ];
    rings
        .into_iter()
        .filter_map(|(name, case)| Some((name, case?)))
        .collect()
}

/// Whether a raceway is recommended, by the search or near the curve of Eq. (11).
fn recommends(result: &DesignResult) -> bool {
    let searched = result
        .search
        .as_ref()
        .is_some_and(|s| s.recommended.is_some());
    let near = result.recommendation.as_ref();
    searched || near.is_some_and(|r| r.passes == Some(true))
}

/// Data of the page of a design.
pub fn design_data(file: &CaseFile, result: &DesignResult, snapshots: &[Snapshot]) -> DesignData {
    let case = file.case();
    let steady = steady_case(case);
    let discarded = format!("t < {:.4} s", steady_after_s(case));
    let source = provenance(&steady, discarded);
    let own = RacewayLabel::new("", case.raceways.first());
    let title = match result.passes {
        Some(_) => format!("{}: {}", pass_word(result.passes), result.verdict),
        None => String::new(),
    };
    DesignData {
        // A seed beyond the whole numbers of TOML leaves the page without a studio.
        case_toml: file.document().to_toml().unwrap_or_default(),
        title: if case.title.is_empty() {
            "Design".to_owned()
        } else {
            format!("Design: {}", case.title)
        },
        software: format!("Cageless {VERSION}, {}", InstructionSet::detect().name()),
        lead: lead(case),
        warnings: result.warnings.clone(),
        passes: result.passes,
        headline: result.headline.clone(),
        results: results(result),
        recommendation_passes: result.recommendation.as_ref().and_then(|r| r.passes),
        recommendation: (result.recommendation.as_ref()).map_or(String::new(), |r| {
            format!("{}. Its verdict: {}", r.sentence(), r.headline)
        }),
        reasons: result.reasons.clone(),
        curve: Some(curve(case, result, &own)),
        contact_track: case
            .raceways
            .first()
            .map(|r| ContactTrack::sample(r, &case.bearing, own.clone())),
        surface: case
            .raceways
            .first()
            .map(|r| RacewaySurface::sample(r, &case.bearing, own.clone())),
        motion: (!snapshots.is_empty()).then(|| motion(case, &title, snapshots, source.clone())),
        shown: ShownRaceway::new(file, result),
        rings: Vec::new(),
        search: result.search.clone(),
        parameters: parameters(file),
        provenance: source,
    }
}

fn lead(case: &Case) -> String {
    let ring = match case.raceways.len() {
        0 => "conventional outer ring".to_owned(),
        1 => "one discrete raceway".to_owned(),
        n => format!("{n} discrete raceways"),
    };
    format!(
        "{} balls, {:.0} rpm, {:.0} N; initial design: {ring}.",
        case.bearing.balls(),
        case.operation.inner_speed_rad_s * 60.0 / std::f64::consts::TAU,
        case.operation.radial_load_n,
    )
}

fn results(r: &DesignResult) -> Vec<Parameter> {
    let angle = |name: &str, value: Option<f64>| {
        parameter(
            name,
            value.map_or("–".to_owned(), |v| format!("{v:.4}")),
            "°",
        )
    };
    let mut lines = vec![
        parameter("pass or fail", pass_word(r.passes).to_owned(), ""),
        parameter("verdict", r.verdict.to_owned(), ""),
        angle("ε, angular ball pitch at contact", Some(r.epsilon_deg)),
        angle("nominal gap 360°/N − ε", Some(r.uniform_gap_deg)),
        angle("β0, Eq. (11)", r.beta0_deg),
        angle("β0 with the polar angle", r.beta0_polar_deg),
        angle(
            "mean ball spacing outside the raceway (steady state)",
            Some(r.steady_gap_deg),
        ),
        angle("critical gap", r.critical_gap_deg),
        angle(
            "separation reserve: mean spacing less critical gap",
            r.critical_gap_deg.map(|c| r.steady_gap_deg - c),
        ),
        parameter(
            "upper limit of lC, Eq. (8)",
            format!("{:.4}", r.axial_span_limit_mm),
            "mm",
        ),
        angle("θ of Eq. (11) for this lC", r.half_angle_deg_for_span),
        parameter(
            "largest number of balls in the raceway",
            r.balls_in_raceway_max
                .map_or("–".to_owned(), |n| n.to_string()),
            "",
        ),
        angle(
            "slope discontinuity at raceway ends (at 45° groove angle)",
            r.kink_deg,
        ),
    ];
    if r.raceways.len() > 1 {
        for one in &r.raceways {
            lines.push(angle(
                &format!(
                    "critical gap of the raceway at ψ = {:.1}° ({})",
                    one.centre_angle_deg, one.verdict
                ),
                one.critical_gap_deg,
            ));
        }
    }
    lines
}

fn curve(case: &Case, result: &DesignResult, own: &RacewayLabel) -> DesignCurve {
    let bearing = &case.bearing;
    let points = span_angle_curve(bearing, CURVE_POINTS);
    let limit = |quantity, value, label: &str| DesignLimit {
        quantity,
        value,
        label: label.to_owned(),
    };
    let mut limits = vec![
        limit(
            LimitedQuantity::AxialSpan,
            axial_span_limit_m(bearing) * 1e3,
            "Eq. (8)",
        ),
        limit(
            LimitedQuantity::HalfAngle,
            result.epsilon_deg + result.uniform_gap_deg,
            "three balls inside",
        ),
    ];
    if let Some(n) = &result.recommendation {
        limits.push(limit(
            LimitedQuantity::HalfAngle,
            n.half_angle_min_deg,
            "slip",
        ));
    }
    DesignCurve {
        paper: if own.axial_span_mm.is_finite() {
            vec![own.clone()]
        } else {
            vec![]
        },
        limits,
        provenance: Provenance {
            case: case.title.clone(),
            ..Provenance::default()
        },
        ..DesignCurve::new(&points, result.uniform_gap_deg)
    }
}
