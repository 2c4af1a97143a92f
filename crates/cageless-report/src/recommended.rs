//! The raceway that a design page is about: shape, drawing dimensions, text for a case file.

use cageless::Case;
use cageless_io::case_file::{CaseDocument, CaseFile, RacewayDocument};
use cageless_results::Cell;
use cageless_study::{DesignResult, entered, parameter};
use serde::{Deserialize, Serialize};

use crate::data::{Parameter, RacewayLabel};
use crate::geometry::{ContactTrack, RacewaySurface};

/// A raceway with its drawing.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ShownRaceway {
    /// `recommended raceway`, or what else it is.
    pub name: String,
    /// Whether it passes; `None` if it was not judged.
    pub passes: Option<bool>,
    /// PASS or FAIL with the reason and the margin.
    pub headline: String,
    /// Key numbers.
    pub facts: Vec<Parameter>,
    /// Dimensions for a drawing.
    pub drawing: Vec<Parameter>,
    /// Text for a case file.
    pub toml: String,
    /// Contact track.
    pub contact_track: ContactTrack,
    /// Surface.
    pub surface: RacewaySurface,
}

/// Name of a raceway that passes its verdict.
const RECOMMENDED: &str = "recommended raceway";

/// The raceways that are recommended, or the starting point, as entered in a case file.
pub fn recommended(
    file: &CaseFile,
    result: &DesignResult,
) -> Option<(&'static str, Vec<RacewayDocument>)> {
    let at = |span: f64, angle: f64, centre: f64| RacewayDocument {
        axial_span_mm: (span * 1e3).round() / 1e3,
        half_angle_deg: (angle * 1e3).round() / 1e3,
        centre_angle_deg: centre,
        depth_error_um: 0.0,
    };
    if let Some(found) = result.search.as_ref().and_then(|s| s.part("recommended")) {
        let [span, angle] = ["axial_span_mm", "half_angle_deg"].map(|name| found.number(name));
        let centres = found.items("centre_angles_deg").iter();
        let raceways = centres.filter_map(Cell::number).map(|c| at(span, angle, c));
        return Some((RECOMMENDED, raceways.collect()));
    }
    let near = result.recommendation()?;
    let centre = file
        .document()
        .raceway
        .first()
        .map_or(0.0, |r| r.centre_angle_deg);
    let name = match near.passes() {
        Some(true) => RECOMMENDED,
        _ => "starting point (fails)",
    };
    let [span, angle] = near.dimensions();
    Some((name, vec![at(span, angle, centre)]))
}

/// The case file with the recommended raceways in the place of its own; `None` if no raceway passes
/// its verdict.
pub fn recommended_document(file: &CaseFile, result: &DesignResult) -> Option<CaseDocument> {
    let (name, raceway) = recommended(file, result)?;
    (name == RECOMMENDED).then(|| CaseDocument {
        raceway,
        ..file.document().clone()
    })
}

/// The case with the recommended raceways in the place of its own.
pub fn recommended_case(file: &CaseFile, result: &DesignResult) -> Option<Case> {
    entered(file, recommended(file, result)?.1, None)
}

impl ShownRaceway {
    /// The recommended raceway of `result`; `None` if there is none.
    pub fn new(file: &CaseFile, result: &DesignResult) -> Option<Self> {
        let (name, raceways) = recommended(file, result)?;
        let case = entered(file, raceways.clone(), None)?;
        let raceway = case.raceways.first()?;
        let label = RacewayLabel::new("", Some(raceway));
        let surface = RacewaySurface::sample(raceway, &case.bearing, label.clone());
        let [depth, height] = surface.depth_and_height_um();
        let (passes, headline) = verdict(result);
        let found = result.search.as_ref().and_then(|s| s.part("recommended"));
        let point = found.and_then(|r| r.parts("points").first());
        let critical = match point {
            Some(numbers) => numbers.value("critical_gap_deg"),
            None => (result.recommendation()).and_then(|r| r.0.results.value("critical_gap_deg")),
        };
        let steady = found.and_then(|r| r.value("steady_gap_deg"));
        let number = |name: &str, value: Option<f64>, digits: usize, unit: &str| {
            value.map(|v| parameter(name, format!("{v:.digits$}"), unit))
        };
        let first = &raceways[0];
        let facts = [
            number("axial span lC", Some(first.axial_span_mm), 3, "mm"),
            number("half angle θ", Some(first.half_angle_deg), 3, "°"),
            number("largest depth below the plain groove", Some(depth), 1, "µm"),
            number(
                "guaranteed gap after the raceway (critical gap)",
                critical,
                4,
                "°",
            ),
            number("steady-state gap (even spacing)", steady, 4, "°"),
            number(
                "gap reserve",
                point.and_then(|n| n.value("margin_deg")),
                4,
                "°",
            ),
            number(
                "peak contact pressure at rest, outer raceway",
                point.and_then(|n| n.value("pressure_mpa")),
                0,
                "MPa",
            ),
        ];
        Some(Self {
            name: name.to_owned(),
            passes,
            headline,
            facts: facts.into_iter().flatten().collect(),
            drawing: drawing(&case, &raceways, depth, height),
            toml: toml(&raceways),
            contact_track: ContactTrack::sample(raceway, &case.bearing, label),
            surface,
        })
    }
}

fn verdict(result: &DesignResult) -> (Option<bool>, String) {
    let searched = result
        .search
        .as_ref()
        .and_then(|s| s.parts("recommended_verdicts").first());
    match (searched, result.recommendation()) {
        (Some(verdict), _) => (verdict.flag("passes"), verdict.text("headline").to_owned()),
        (None, Some(near)) => (near.passes(), near.0.results.text("headline").to_owned()),
        (None, None) => (None, String::new()),
    }
}

/// Dimensions of the first raceway and of the ring around it.
fn drawing(case: &Case, raceways: &[RacewayDocument], depth: f64, height: f64) -> Vec<Parameter> {
    let d = case.bearing.dimensions();
    let first = &raceways[0];
    let bottom = d.outer_groove_bottom_radius_m * 1e3;
    let line = |name: &str, value: f64, digits: usize, unit: &str| {
        parameter(name, format!("{value:.digits$}"), unit)
    };
    let centres: Vec<String> = raceways
        .iter()
        .map(|r| format!("{:.3}", r.centre_angle_deg))
        .collect();
    let contact = (first.axial_span_mm / 2.0 / (d.ball_radius_m * 1e3)).clamp(0.0, 1.0);
    vec![
        line(
            "axial span lC of the contact track",
            first.axial_span_mm,
            3,
            "mm",
        ),
        line("half angle θ", first.half_angle_deg, 3, "°"),
        line(
            "length along the groove bottom, 2θ·Ro",
            2.0 * first.half_angle_deg.to_radians() * bottom,
            3,
            "mm",
        ),
        parameter(
            "angular position ψ of the middle, 0 at the load",
            centres.join(", "),
            "°",
        ),
        line("largest depth below the plain groove", depth, 1, "µm"),
        line("largest height above the plain groove", height, 1, "µm"),
        line(
            "contact angle in the middle",
            contact.asin().to_degrees(),
            3,
            "°",
        ),
        line(
            "radius of the groove bottom Ro, plain part",
            bottom,
            4,
            "mm",
        ),
        line(
            "groove curvature radius, plain part",
            d.outer_groove_curvature_radius_m * 1e3,
            4,
            "mm",
        ),
        line(
            "shoulder bore radius Ros",
            d.outer_shoulder_radius_m * 1e3,
            3,
            "mm",
        ),
    ]
}

/// The raceways as a case file takes them.
fn toml(raceways: &[RacewayDocument]) -> String {
    let section = if raceways.len() == 1 {
        "[raceway]"
    } else {
        "[[raceway]]"
    };
    raceways
        .iter()
        .map(|r| {
            format!(
                "{section}\naxial_span_mm = {:?}\nhalf_angle_deg = {:?}\ncentre_angle_deg = {:?}\n",
                r.axial_span_mm, r.half_angle_deg, r.centre_angle_deg
            )
        })
        .collect::<Vec<_>>()
        .join("\n")
}
