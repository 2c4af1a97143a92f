//! The record of a search.

use cageless::RacewayForm;
use cageless::closed_forms::span_angle_curve;
use cageless_design::search::{
    Confirmed, Evaluation, Found, Motion, ObjectiveScale, OperatingPoint, Role, SpeedMap,
};
use cageless_io::case_file::CaseFile;
use cageless_results::{
    AtPoint, MAP, MOTION, PAPER, PLACEMENT, POINT, Part, REJECTION, Record, SEARCH, STRUCTURE,
    STRUCTURE_AT, Searched, SearchedPlacement, Subject, provenance,
};

use super::narrative;
use crate::RacewayLabel;

/// Points of the curve of Eq. (11).
const CURVE_POINTS: usize = 120;

/// Results of a search with the verdicts of `design` on the recommended structure at every operating
/// point and the structures of the paper for this bearing.
pub fn search_record(
    file: &CaseFile,
    found: &Found,
    verdicts: Vec<Record>,
    paper: &[RacewayLabel],
) -> Record {
    let (case, request) = (file.case(), &found.request);
    let title = &file.particulars().title;
    let form = case.raceway_form();
    let confirmed = |role: Role| found.of_role(role).next();
    let curve = span_angle_curve(&case.bearing, form, CURVE_POINTS).into_iter();
    let curve = curve.filter_map(|p| Some((p.axial_span_m, p.half_angle_rad?)));
    let searched = Searched {
        case,
        seed: request.seed,
        found,
        curve: curve.collect(),
    };
    let own_usual = confirmed(Role::Own).map(|c| structure(&c.evaluation, None));
    let usual = found.recommended.map(|k| &found.evaluations[k]);
    let rejections = found.rejections();
    let rejections = rejections
        .iter()
        .map(|r| Record::of(REJECTION, Subject::Rejection(r)));
    let each = found.evaluations.iter().map(|e| structure(e, None));
    let point = request.points[0].case(case, case.raceways.clone());
    let discarded = "the first 16 of 32 orbits, except collisions and friction";
    let record = Record::of(SEARCH, Subject::Search(&searched))
        .with_part("points", many(request.points.iter().map(point_record)))
        .with_part(
            "recommended",
            confirmed(Role::Recommended).map(confirmed_record),
        )
        .with_part("recommended_verdicts", Part::Many(verdicts))
        .with_part(
            "unconfirmed",
            many(found.of_role(Role::Unconfirmed).map(confirmed_record)),
        )
        .with_part("own", confirmed(Role::Own).map(confirmed_record))
        .with_part(
            "recommended_from_usual_starts",
            usual.map(|e| structure(e, None)),
        )
        .with_part("own_from_usual_starts", own_usual)
        .with_part("closest", found.closest().map(|e| structure(e, None)))
        .with_part("front", front(found))
        .with_part("band", many(each))
        .with_part("rejections", many(rejections))
        .with_part("placements", placements(found))
        .with_part("maps", many(found.maps.iter().map(map)))
        .with_part("paper", of_paper(paper, form))
        .with_provenance(provenance(title, &point, discarded.to_owned()));
    let findings = narrative::narrative(found, &record);
    record.with_sentences("findings", findings)
}

/// Structures of the paper, where their shape is that of the case.
fn of_paper(paper: &[RacewayLabel], form: RacewayForm) -> Part {
    let paper = paper.iter().filter(|_| form == RacewayForm::default());
    many(paper.map(|label| {
        let size = [label.axial_span_mm, label.half_angle_deg];
        Record::of(PAPER, Subject::Paper(&(label.letter.clone(), size)))
    }))
}

fn many(records: impl Iterator<Item = Record>) -> Part {
    Part::Many(records.collect())
}

fn point_record(point: &OperatingPoint) -> Record {
    Record::of(POINT, Subject::Point(point))
}

fn motion(motion: &Motion, steady_gap_rad: f64) -> Record {
    Record::of(MOTION, Subject::Motion(&(*motion, steady_gap_rad)))
}

/// A structure with its numbers; means and errors of its motion are those of `confirmed`, if it was.
pub(super) fn structure(evaluation: &Evaluation, confirmed: Option<&Confirmed>) -> Record {
    let steady = evaluation.forms.map(|f| f.steady_gap_rad);
    let points = (0..evaluation.spacing.len()).map(|point| {
        let statistics = confirmed.and_then(|c| c.statistics.get(point));
        let steady_or_nan = steady.unwrap_or(f64::NAN);
        let own = evaluation.motion[point]
            .zip(steady)
            .map(|(m, s)| motion(&m, s));
        let mean = statistics.map(|s| motion(&s.mean, steady_or_nan)).or(own);
        let errors = statistics.map(|s| motion(&s.error, steady_or_nan));
        let bunched = confirmed.and_then(|c| c.bunched.get(point));
        let bunched = bunched.map(|m| motion(m, steady_or_nan));
        Record::of(
            STRUCTURE_AT,
            Subject::StructureAt(&AtPoint { evaluation, point }),
        )
        .with_part("motion", mean)
        .with_part("errors", errors)
        .with_part("bunched", bunched)
    });
    Record::of(STRUCTURE, Subject::Structure(evaluation)).with_part("points", many(points))
}

fn confirmed_record(confirmed: &Confirmed) -> Record {
    structure(&confirmed.evaluation, Some(confirmed))
}

/// The scale of the front.
fn scale(found: &Found) -> Option<ObjectiveScale> {
    ObjectiveScale::new(found.front().filter_map(|e| e.objectives.as_ref()))
}

/// Distance from the best in everything.
fn distance(scale: &Option<ObjectiveScale>, e: &Evaluation) -> f64 {
    match (scale, &e.objectives) {
        (Some(scale), Some(objectives)) => scale.distance(objectives),
        _ => f64::INFINITY,
    }
}

fn front(found: &Found) -> Part {
    let scale = scale(found);
    let mut front: Vec<&Evaluation> = found.front().collect();
    front.sort_by(|a, b| distance(&scale, a).total_cmp(&distance(&scale, b)));
    many(front.into_iter().map(|e| structure(e, None)))
}

fn placements(found: &Found) -> Part {
    let scale = scale(found);
    many(
        (0..)
            .zip(&found.request.placements)
            .flat_map(|(k, centres_rad)| {
                let sections = found.request.sections();
                sections.map(move |section| (k, section, centres_rad))
            })
            .map(|(k, section, centres_rad)| {
                let own = |e: &&Evaluation| {
                    let of = (e.structure.form, e.structure.section_angle_rad);
                    (e.placement, of) == (k, section)
                };
                let (form, section_angle_rad) = section;
                let here = found.evaluations.iter().filter(own);
                let evaluations: Vec<&Evaluation> = here.collect();
                let accepted = evaluations.iter().filter(|e| e.objectives.is_some());
                let best =
                    accepted.min_by(|a, b| distance(&scale, a).total_cmp(&distance(&scale, b)));
                let best = best.map(|e| structure(e, None));
                let placement = SearchedPlacement {
                    centres_rad,
                    form: &form,
                    section_angle_rad,
                    evaluations,
                };
                Record::of(PLACEMENT, Subject::Placement(&placement)).with_part("best", best)
            }),
    )
}

fn map(map: &SpeedMap) -> Record {
    Record::of(MAP, Subject::Map(map)).with_part("point", Some(point_record(&map.point)))
}

#[cfg(test)]
mod tests;
