//! The page of `design`: one raceway judged, or the search for a better one.

use serde::{Deserialize, Serialize};

use cageless::design::search::NEIGHBOURS_WIDER;

pub use cageless_study::search::{
    MapData, MotionNumbers, PlacementData, PointData, PointNumbers, PointVerdict, RejectionCount,
    SearchData, StructureData,
};

use crate::data::{Motion, Parameter, Provenance};
use crate::figures::search as figures;
use crate::figures::{design, shape};
use crate::geometry::{ContactTrack, RacewaySurface};
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::reproduce::DesignCurve;
use crate::search_tables as tables;
use crate::tables::parameter_table;

/// Data of the page of `design`. Empty parts are omitted from the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct DesignData {
    /// Title of the case.
    pub title: String,
    /// Name and version of the program, instruction set.
    pub software: String,
    /// First paragraph: what was asked and what came out.
    pub lead: String,
    /// Warnings.
    pub warnings: Vec<String>,
    /// Whether the case's own raceways pass; `None` without one.
    pub passes: Option<bool>,
    /// PASS or FAIL with the reason and the margin.
    pub headline: String,
    /// Numbers of the case's own raceways.
    pub results: Vec<Parameter>,
    /// Reasons of the verdict.
    pub reasons: Vec<String>,
    /// Whether the raceway of the recommendation passes; `None` if there is none.
    pub recommendation_passes: Option<bool>,
    /// The raceway near the curve of Eq. (11) with its verdict; empty if there is none.
    pub recommendation: String,
    /// θ over lC by Eq. (11), with the case's structure and the limits.
    pub curve: Option<DesignCurve>,
    /// Contact track of the case's first raceway.
    pub contact_track: Option<ContactTrack>,
    /// Surface of the case's first raceway.
    pub surface: Option<RacewaySurface>,
    /// The balls of the run that was judged.
    pub motion: Option<Motion>,
    /// Result of a search.
    pub search: Option<SearchData>,
    /// Case as computed, one line per key.
    pub parameters: Vec<Parameter>,
    /// Provenance of the verdict.
    pub provenance: Provenance,
}

/// The page of `design`.
pub fn design_page(data: &DesignData) -> String {
    let mut page = Page::new(&data.title, &data.lead, &data.software);
    for warning in &data.warnings {
        page.note(Note::Warning, warning);
    }
    if let Some(search) = &data.search {
        search_sections(&mut page, search);
    }
    if !data.results.is_empty() {
        page.section("The raceway of the case");
        page.verdict(data.passes, &data.headline);
        if data.search.is_some() && data.passes.is_some() {
            page.note(Note::Remark, &two_critical_gaps());
        }
        page.table(&parameter_table(
            "Verdict",
            "Verdict on the initial design and its geometry.",
            &data.results,
            Some(data.provenance.clone()),
        ));
        data.reasons
            .iter()
            .for_each(|reason| page.note(Note::Remark, reason));
    }
    if !data.recommendation.is_empty() {
        page.section("A raceway near the curve of Eq. (11)");
        page.verdict(data.recommendation_passes, &data.recommendation);
    }
    if let Some(curve) = &data.curve {
        let mut figure = design::curve(curve);
        figure.label = "Axial span and half angle".to_owned();
        page.figure(&figure);
    }
    if let Some(track) = &data.contact_track {
        let mut figure = shape::contact_track(track);
        figure.label = "Contact track".to_owned();
        page.figure(&figure);
    }
    if let Some(surface) = &data.surface {
        let mut figure = shape::surface(surface);
        figure.label = "Surface".to_owned();
        page.figure(&figure);
    }
    if let Some(motion) = &data.motion {
        page.section("Balls in motion");
        page.motion(&MotionFigure {
            label: "Motion".to_owned(),
            caption: "The last orbits of the run that was judged, to scale. The inner ring turns \
                      counter-clockwise, load and gravity point down; the discrete raceway is \
                      shaded orange, balls 1 and 2 blue, touching balls ringed."
                .to_owned(),
            bearings: vec![motion.clone()],
            moments_s: Vec::new(),
        });
    }
    if !data.parameters.is_empty() {
        page.section("The case as computed");
        page.table(&parameter_table(
            "Case",
            "Every key of the case.",
            &data.parameters,
            None,
        ));
    }
    page.html()
}

fn search_sections(page: &mut Page, search: &SearchData) {
    page.section("Recommendation");
    let several = search.points.len() > 1;
    for (point, verdict) in search.points.iter().zip(&search.recommended_verdicts) {
        let at = if several {
            format!("At {}, from even spacing: ", point.label())
        } else {
            String::new()
        };
        page.verdict(verdict.passes, &format!("{at}{}", verdict.headline));
    }
    search
        .findings
        .iter()
        .for_each(|finding| page.note(Note::Remark, finding));
    if search.recommended.is_some() || search.own.is_some() {
        page.table(&tables::comparison(search));
    }
    page.section("Feasible designs");
    page.paragraph(MAPS);
    page.figure(&figures::verdicts(search));
    page.figure(&figures::critical_gaps(search));
    page.table(&tables::rejections(search));
    if search.placements.len() > 1 {
        page.table(&tables::placements(search));
    }
    if !search.front.is_empty() {
        page.section("Trade-offs");
        page.figure(&figures::trade_offs(search));
        page.table(&tables::front(search));
    }
}

/// Remark on the two critical gaps of a raceway on one page.
pub fn two_critical_gaps() -> String {
    format!(
        "The critical gap in this section is measured with all other balls evenly spaced; the \
         critical gaps of the search are measured with the neighbours of the pair {:.0} % further \
         off, so that in a deep raceway they do not push the pair together. The two differ where \
         neighbours interfere, and there may be none here.",
        100.0 * (NEIGHBOURS_WIDER - 1.0)
    )
}

const MAPS: &str = "Each cell is a raceway of span lC and half angle θ. Its critical gap is the \
    largest with which a pair of balls still touches on its way through: the smallest separation that the \
    raceway ensures. Above the mean ball spacing outside the raceway in steady state the raceway is \
    too deep: evenly spaced balls collide. Far below it the raceway is too shallow. Without slip the \
    critical gap is β0 of Eq. (11); the difference is the loss of separation through sliding.";
