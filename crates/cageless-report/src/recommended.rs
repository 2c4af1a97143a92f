//! The raceway that a design page is about: shape, drawing dimensions, text for a case file.

use cageless::Case;
use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_results::{Cell, DryVerdict, Results};
use cageless_study::{DesignResult, parameter, raceway_section, reshaped, turned, with_raceways};
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
    /// Whether it works, with the reason and the margin.
    pub headline: String,
    /// Verdict without oil: whether the raceway passes, and its line; `None` of a dry case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dry: Option<(Option<bool>, String)>,
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

/// The case file with the raceways that are recommended, or the starting point, in the place of its
/// own.
fn recommended(file: &CaseFile, result: &DesignResult) -> Option<(&'static str, CaseDocument)> {
    let rounded = |value: f64| (value * 1e3).round() / 1e3;
    let at = |span: f64, angle: f64, centre: f64| {
        raceway_section(rounded(span), rounded(angle), centre, 0.0)
    };
    if let Some(found) = result.found() {
        let [span, angle] = ["axial_span_mm", "half_angle_deg"].map(|name| found.number(name));
        let centres = found.items("centre_angles_deg").iter();
        let raceways = centres.filter_map(Cell::number).map(|c| {
            let mut values = at(span, angle, c);
            values.extend(reshaped(file, found.text("shape")));
            values.extend(turned(file, found.number("contact_angle_deg")));
            values
        });
        let raceways: Vec<_> = raceways.collect();
        return Some((RECOMMENDED, with_raceways(file, &raceways)));
    }
    let near = result.recommendation()?;
    let centre = file.document().number("raceway.1.centre_angle_deg");
    let name = match near.passes() {
        Some(true) => RECOMMENDED,
        _ => "starting point (fails)",
    };
    let [span, angle] = near.dimensions();
    let raceway = at(span, angle, centre.unwrap_or(0.0));
    Some((name, with_raceways(file, &[raceway])))
}

/// The case file with the recommended raceways in the place of its own; `None` if no raceway passes
/// its verdict.
pub fn recommended_document(file: &CaseFile, result: &DesignResult) -> Option<CaseDocument> {
    let (name, document) = recommended(file, result)?;
    (name == RECOMMENDED).then_some(document)
}

/// The case of a document; `None` if it is impossible.
fn case_of(document: CaseDocument) -> Option<Case> {
    let file = CaseFile::from_document(document, "case").ok()?;
    Some(file.case().clone())
}

/// Values of a key of all raceways.
fn values(document: &CaseDocument, key: &str) -> Vec<f64> {
    let numbers = 1..=document.count("raceway");
    let value = |k: usize| document.number(&format!("raceway.{k}.{key}"));
    numbers.filter_map(value).collect()
}

impl ShownRaceway {
    /// The recommended raceway of `result`; `None` if there is none.
    pub fn new(file: &CaseFile, result: &DesignResult) -> Option<Self> {
        let (name, document) = recommended(file, result)?;
        let case = case_of(document.clone())?;
        let raceway = case.raceways.first()?;
        let label = RacewayLabel::new("", Some(raceway));
        let surface = RacewaySurface::sample(raceway, &case.bearing, label.clone());
        let [depth, _] = surface.depth_and_height_um();
        let (passes, headline) = verdict(result);
        let found = result.found();
        let point = found.and_then(|r| r.parts("points").first());
        let at_point = |name: &str| point.and_then(|numbers| numbers.value(name));
        let critical = match point {
            Some(_) => at_point("critical_gap_deg"),
            None => (result.recommendation()).and_then(|r| r.0.results.value("critical_gap_deg")),
        };
        let steady = found.and_then(|r| r.value("steady_gap_deg"));
        let first = |key: &str| document.number(&format!("raceway.1.{key}"));
        let (span, angle) = (first("axial_span_mm"), first("half_angle_deg"));
        let (reserve, pressure) = (at_point("margin_deg"), at_point("pressure_mpa"));
        let facts = [
            ("axial span lC", span, 3, "mm"),
            ("half angle θ", angle, 3, "°"),
            ("largest depth below the plain groove", Some(depth), 1, "µm"),
            (
                "gap after the raceway, about (critical gap)",
                critical,
                4,
                "°",
            ),
            ("steady-state gap (even spacing)", steady, 4, "°"),
            ("gap reserve", reserve, 4, "°"),
            (
                "peak contact pressure at rest, outer raceway",
                pressure,
                0,
                "MPa",
            ),
        ];
        let facts = facts.into_iter();
        let facts =
            facts.filter_map(|(name, value, digits, unit)| Some(line(name, value?, digits, unit)));
        Some(Self {
            name: name.to_owned(),
            passes,
            headline,
            dry: dry(result),
            facts: facts.collect(),
            drawing: drawing(&case, &document, &surface),
            toml: toml(&document),
            contact_track: ContactTrack::sample(raceway, &case.bearing, label),
            surface,
        })
    }
}

/// The results that have the verdict on the recommended raceway.
fn verdict_of(result: &DesignResult) -> Option<&Results> {
    let searched = result.search.as_ref();
    let searched = searched.and_then(|s| s.parts("recommended_verdicts").first());
    let near = || result.recommendation().map(|near| near.0);
    searched.or_else(near).map(|record| &record.results)
}

fn verdict(result: &DesignResult) -> (Option<bool>, String) {
    // One that helps works at every operating point; the head says how it helps.
    if let (Some(_), Some(benefit)) = (&result.search, &result.benefit) {
        return (benefit.helps(), "helps in steady operation".to_owned());
    }
    match verdict_of(result) {
        Some(verdict) => (verdict.flag("passes"), verdict.text("headline").to_owned()),
        None => (None, String::new()),
    }
}

/// Whether the recommended raceway passes without oil, and a line; `None` of a dry case, and where benefit chose.
fn dry(result: &DesignResult) -> Option<(Option<bool>, String)> {
    if result.search.is_some() && result.benefit.is_some() {
        return None;
    }
    DryVerdict::of(verdict_of(result)?).map(|dry| (dry.passes, dry.line()))
}

/// A number with so many decimals.
fn line(name: &str, value: f64, digits: usize, unit: &str) -> Parameter {
    parameter(name, format!("{value:.digits$}"), unit)
}

/// Dimensions of the first raceway and of the ring around it.
fn drawing(case: &Case, document: &CaseDocument, surface: &RacewaySurface) -> Vec<Parameter> {
    let [depth, height] = surface.depth_and_height_um();
    let d = case.bearing.dimensions();
    let [span, angle] = ["axial_span_mm", "half_angle_deg"].map(|key| values(document, key)[0]);
    let bottom = d.outer_groove_bottom_radius_m * 1e3;
    let length = 2.0 * angle.to_radians() * bottom;
    let curvature = d.outer_groove_curvature_radius_m * 1e3;
    let shoulder = d.outer_shoulder_radius_m * 1e3;
    let centres: Vec<String> = (values(document, "centre_angle_deg").iter())
        .map(|centre| format!("{centre:.3}"))
        .collect();
    let contact = (span / 2.0 / (d.ball_radius_m * 1e3)).clamp(0.0, 1.0);
    let contact = contact.asin().to_degrees();
    let of_slot = surface
        .slot_mm
        .into_iter()
        .flat_map(|[width, depth, radius]| {
            [
                line("width of the slot between its walls", width, 3, "mm"),
                line("depth of its floor below the plain groove", depth, 3, "mm"),
                line("radius of its edges", radius, 3, "mm"),
            ]
        });
    let all = [
        line("axial span lC of the contact track", span, 3, "mm"),
        line("half angle θ", angle, 3, "°"),
        line("length along the groove bottom, 2θ·Ro", length, 3, "mm"),
        parameter(
            "angular position ψ of the middle, 0 at the load",
            centres.join(", "),
            "°",
        ),
        line("largest depth below the plain groove", depth, 1, "µm"),
        line("largest height above the plain groove", height, 1, "µm"),
        line("contact angle in the middle", contact, 3, "°"),
        line(
            "radius of the groove bottom Ro, plain part",
            bottom,
            4,
            "mm",
        ),
        line("groove curvature radius, plain part", curvature, 4, "mm"),
        line("shoulder bore radius Ros", shoulder, 3, "mm"),
    ];
    all.into_iter().chain(of_slot).collect()
}

/// The raceways as a case file takes them.
fn toml(document: &CaseDocument) -> String {
    let section = match document.count("raceway") {
        1 => "[raceway]",
        _ => "[[raceway]]",
    };
    let keys = [
        "axial_span_mm",
        "half_angle_deg",
        "centre_angle_deg",
        "shape",
        "profile",
        "blend_mm",
        "depth_um",
        "edge_radius_mm",
        "slot_depth_mm",
        "contact_angle_deg",
    ];
    let line = |nth: usize, key: &str| {
        let value = document.value(&format!("raceway.{nth}.{key}"))?;
        Some(format!("{key} = {}\n", value.written()))
    };
    let raceways = (1..=document.count("raceway")).map(|nth| {
        let lines: String = keys.iter().filter_map(|key| line(nth, key)).collect();
        format!("{section}\n{lines}")
    });
    raceways.collect::<Vec<_>>().join("\n")
}
