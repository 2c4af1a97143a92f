//! The page of `design`: one raceway judged, or the search for a better one.

use serde::{Deserialize, Serialize};

use cageless_design::search::NEIGHBOURS_WIDER;

use cageless_results::{DryVerdict, Record};
use cageless_study::benefit_search::BenefitSearch;
use cageless_study::search::point_label;

use crate::compare::benefit_section;
use crate::data::{Motion, Parameter, Provenance};
use crate::figure::Figure;
use crate::figures::axial_load::{AxialLoads, axial_gap, axial_load};
use crate::figures::search as search_figures;
use crate::figures::{compare, design, shape};
use crate::geometry::{ContactTrack, RacewaySurface};
use crate::head::Head;
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::recommended::ShownRaceway;
use crate::reproduce_data::DesignCurve;
use crate::search_tables as tables;
use crate::studio_page::case_sections;
use crate::text::capital;

/// Data of the page of `design`. Empty parts are omitted from the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct DesignData {
    /// The case as TOML, for the studio in the page; without one if empty.
    #[serde(default)]
    pub case_toml: String,
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
    /// Whether it works, with the reason and the margin.
    pub headline: String,
    /// Verdict without oil: whether the raceway passes, and its line; `None` of a dry case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dry: Option<(Option<bool>, String)>,
    /// Numbers of the case's own raceways.
    pub results: Vec<Parameter>,
    /// Limits of the user: whether each is kept (`None`: not judged), in a sentence.
    #[serde(default)]
    pub limits: Vec<(Option<bool>, String)>,
    /// Reasons of the verdict.
    pub reasons: Vec<String>,
    /// Whether the raceway of the recommendation passes; `None` if there is none.
    pub recommendation_passes: Option<bool>,
    /// The raceway near the curve of Eq. (11) with its verdict; empty if there is none.
    pub recommendation: String,
    /// The recommended raceway with its drawing.
    pub shown: Option<ShownRaceway>,
    /// θ over lC by Eq. (11), with the case's structure and the limits.
    pub curve: Option<DesignCurve>,
    /// Contact track of the case's first raceway.
    pub contact_track: Option<ContactTrack>,
    /// Surface of the case's first raceway.
    pub surface: Option<RacewaySurface>,
    /// The balls of the run that was judged.
    pub motion: Option<Motion>,
    /// Lags under axial load, if they were asked for.
    #[serde(default)]
    pub axial: Option<AxialLoads>,
    /// Limits under axial load that are no number, with the reason, and runs that stopped.
    #[serde(default)]
    pub axial_findings: Vec<String>,
    /// Result of a search, which is in `design.json`.
    #[serde(skip)]
    pub search: Option<Record>,
    /// Benefit in steady operation, which is in `design.json`.
    #[serde(skip)]
    pub benefit: Option<BenefitSearch>,
    /// Case as computed, one line per key.
    pub parameters: Vec<Parameter>,
    /// Provenance of the verdict.
    pub provenance: Provenance,
}

/// The page of `design`.
pub fn design_page(data: &DesignData) -> String {
    let mut page = Page::new(&data.title, &data.lead, &data.software);
    page.head(&head(data));
    open(&mut page, data);
    page.notes(Note::Warning, &data.warnings);
    if let Some(benefit) = &data.benefit {
        benefit_section(&mut page, &benefit.comparison, &benefit.provenance);
    }
    if let Some(shown) = &data.shown {
        drawing_section(&mut page, shown);
    } else {
        page.section("The raceway of the case: shape");
        let (track, surface) = (data.contact_track.as_ref(), data.surface.as_ref());
        shape_figures(&mut page, "", track, surface);
    }
    if let Some(search) = &data.search {
        search_sections(&mut page, search, data.benefit.is_some());
    }
    page.section("The curve of Eq. (11)");
    if !data.recommendation.is_empty() {
        page.section("A raceway near the curve of Eq. (11)");
        page.verdict(data.recommendation_passes, &data.recommendation);
    }
    page.figures(data.curve.as_ref().map(curve));
    if !data.results.is_empty() {
        page.section("The raceway of the case");
        page.verdict(data.passes, &data.headline);
        if let Some((passes, line)) = &data.dry {
            page.verdict(*passes, line);
        }
        if data.search.is_some() && data.passes.is_some() {
            page.note(Note::Remark, &two_critical_gaps());
        }
        let caption = "Verdict on the initial design and its geometry.";
        page.parameters("Verdict", caption, &data.results, Some(&data.provenance));
        page.notes(Note::Remark, &data.reasons);
        if data.shown.is_some() {
            let (track, surface) = (data.contact_track.as_ref(), data.surface.as_ref());
            page.fold("Contact track and surface of the initial design", |page| {
                shape_figures(page, ", initial design", track, surface);
            });
        }
    }
    page.section("Axial load");
    page.notes(Note::Remark, &data.axial_findings);
    let axial = data.axial.iter();
    page.figures(axial.flat_map(|axial| [axial_load(axial), axial_gap(axial)]));
    let title = "The case as computed";
    case_sections(&mut page, title, &data.parameters, &data.case_toml);
    page.html()
}

/// Opens the page with benefit and search, or with the balls of the run that was judged and the curve.
fn open(page: &mut Page, data: &DesignData) {
    if let Some(benefit) = &data.benefit {
        page.open_with(compare::benefit(&benefit.comparison, &benefit.provenance));
    }
    page.open_with(data.search.as_ref().map(search_figures::verdicts));
    let caption = "The last orbits of the run in which the initial design was judged, to scale. \
                   The inner ring turns counter-clockwise, load and gravity point down; the \
                   discrete raceway is shaded orange, balls 1 and 2 blue, touching balls ringed.";
    let motion = data.motion.clone().filter(|_| data.benefit.is_none());
    page.open_with_motion(motion.map(|of| MotionFigure::new("Motion", caption, vec![of])));
    if data.search.is_none() {
        page.open_with(data.curve.as_ref().map(curve));
    }
}

fn curve(of: &DesignCurve) -> Figure {
    design::curve(of).labelled("Axial span and half angle")
}

/// Verdict and key numbers of the recommended raceway, then the verdict on the case's own.
fn head(data: &DesignData) -> Head {
    let mut head = Head::default();
    let best = data
        .shown
        .as_ref()
        .map_or(data.passes, |shown| shown.passes);
    head = match &data.benefit {
        Some(benefit) => head.verdict(benefit.helps(), &benefit.answer),
        None => head.open_benefit(best),
    };
    if let Some(shown) = &data.shown {
        head = head
            .verdict(
                shown.passes,
                &format!("{}: {}", capital(&shown.name), shown.headline),
            )
            .facts(shown.facts.clone());
        if let Some((passes, line)) = &shown.dry {
            head = head.verdict(*passes, &format!("{} {line}", capital(&shown.name)));
        }
    }
    let searched = data.search.as_ref().filter(|_| data.shown.is_none());
    let none_found = searched.and_then(|search| search.sentences("findings").first());
    if let Some(why) = none_found {
        let line = why
            .split_once(". ")
            .map_or(why.as_str(), |(first, _)| first);
        head = head.verdict(Some(false), &capital(line.trim_end_matches('.')));
    }
    let own = match (
        data.shown.is_some() || none_found.is_some(),
        data.headline.as_str(),
    ) {
        (_, "") => String::new(),
        (true, headline) => format!("Initial design: {headline}"),
        (false, headline) => headline.to_owned(),
    };
    head = head.verdict(data.passes, &own);
    if let Some((passes, line)) = &data.dry {
        let about = data.shown.as_ref().map_or("", |_| "Initial design ");
        head = head.verdict(*passes, &format!("{about}{line}"));
    }
    head.limits(&data.limits)
}

/// The recommended raceway as it is to be made.
fn drawing_section(page: &mut Page, shown: &ShownRaceway) {
    page.section(&capital(&shown.name));
    let caption = "Dimensions for the drawing of the outer ring. `cageless export` writes the ring as STEP \
                   or STL.";
    page.parameters("Drawing", caption, &shown.drawing, None);
    page.heading("For the case file");
    page.paste("raceway for the case file", &shown.toml);
    let (track, surface) = (Some(&shown.contact_track), Some(&shown.surface));
    shape_figures(page, "", track, surface);
}

fn shape_figures(
    page: &mut Page,
    whose: &str,
    track: Option<&ContactTrack>,
    surface: Option<&RacewaySurface>,
) {
    let track = track.map(shape::contact_track);
    page.figures(track.map(|figure| figure.labelled(&format!("Contact track{whose}"))));
    let surface = surface.map(shape::surface);
    page.figures(surface.map(|figure| figure.labelled(&format!("Surface{whose}"))));
}

fn search_sections(page: &mut Page, search: &Record, with_benefit: bool) {
    page.section("Search");
    if with_benefit {
        let text = "The search ranks by short runs of equal balls; of the raceways that it accepts the long runs of \
                    real balls choose.";
        page.paragraph(text);
    }
    let points = search.parts("points");
    let several = points.len() > 1;
    for (point, verdict) in points.iter().zip(search.parts("recommended_verdicts")) {
        let at = if several {
            format!("At {}, from even spacing: ", point_label(point))
        } else {
            String::new()
        };
        let headline = format!("{at}{}", verdict.text("headline"));
        page.verdict(verdict.flag("passes"), &headline);
        if let Some(dry) = DryVerdict::of(verdict) {
            page.verdict(dry.passes, &dry.line());
        }
    }
    page.notes(Note::Remark, search.sentences("findings"));
    if search.part("recommended").or(search.part("own")).is_some() {
        page.table(&tables::comparison(search));
    }
    page.section("Feasible designs");
    page.paragraph(MAPS);
    page.figure(&search_figures::verdicts(search));
    page.figure(&search_figures::critical_gaps(search));
    page.table(&tables::rejections(search));
    if search.parts("placements").len() > 1 {
        page.table(&tables::placements(search));
    }
    page.section("Trade-offs");
    if !search.parts("front").is_empty() {
        page.figure(&search_figures::trade_offs(search));
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
    largest with which a pair of balls still touches on its way through: about the gap to which the \
    raceway separates balls. Above the steady-state gap outside the raceway the raceway is \
    too deep: evenly spaced balls collide. Far below it the raceway is too shallow. Without sliding the \
    critical gap is β0 of Eq. (11); the difference is what sliding takes off it.";
