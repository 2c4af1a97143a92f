//! Narrative of a search: its result in sentences.

use cageless::RacewayShape;
use cageless::design::search::{
    CONFIRMING_STARTS, Confirmed, Evaluation, Found, Motion, Rejection, Role,
};
use cageless_results::number_text::signed;
use cageless_results::{Cell, POINT, REJECTION, Record, Results, STRUCTURE, Subject};

/// Differences beyond this many standard errors count.
const SIGNIFICANT: f64 = 2.0;

/// An operating point: `12000 rpm, 1500 N`.
pub fn point_label(point: &Record) -> String {
    let (speed, load) = (
        point.number("inner_speed_rpm"),
        point.number("radial_load_n"),
    );
    match point.value("axial_load_n") {
        None | Some(0.0) => format!("{speed:.0} rpm, {load} N"),
        Some(axial) => format!("{speed:.0} rpm, {load} N, {axial} N along the axis"),
    }
}

/// A structure: `lC 5.1 mm, θ 25.2°`, with the shape unless it is that of the paper and the places
/// unless there is one at the bottom.
pub fn structure_label(structure: &Record) -> String {
    let (span, angle) = (
        structure.number("axial_span_mm"),
        structure.number("half_angle_deg"),
    );
    let mut size = format!("lC {span:.3} mm, θ {angle:.2}°");
    let shape = structure.text("shape");
    if shape != RacewayShape::default().name() {
        size = format!("{shape}, {size}");
    }
    let turned = structure.number("contact_angle_deg");
    if turned != 0.0 {
        size += &format!(", turned by {turned}°");
    }
    match structure.items("centre_angles_deg") {
        [] | [Cell::Number(0.0)] => size,
        places => {
            let places = places.iter().filter_map(Cell::number);
            let places: Vec<String> = places.map(|p| format!("{p:.0}°")).collect();
            format!("{size} at ψ = {}", places.join(", "))
        }
    }
}

/// The sentences for the terminal and the page.
pub fn narrative(found: &Found, record: &Record) -> Vec<String> {
    let Some(best) = record.part("recommended") else {
        return vec![why_none(found)];
    };
    let points = record.parts("points");
    let verdicts = record.parts("recommended_verdicts");
    let mut all = vec![recommendation(points, verdicts, best)];
    if let Some(others) = unconfirmed(found) {
        all.push(format!("Rated better and not confirmed: {others}."));
    }
    for (point, verdict) in points.iter().zip(verdicts) {
        all.push(format!(
            "At {}, with this raceway in the case: {}.",
            point_label(point),
            verdict.text("headline")
        ));
    }
    if let Some(own) = record.part("own") {
        for (k, point) in points.iter().enumerate() {
            all.push(format!(
                "At {}, against the initial design {}: {}.",
                point_label(point),
                structure_label(own),
                comparison(found, best, own, k)
            ));
        }
        if !own.text("why").is_empty() {
            all.push(format!(
                "The initial design is not acceptable: {}.",
                own.text("why")
            ));
        }
    }
    let band = record.parts("band");
    let number = |status| band.iter().filter(|s| s.text("status") == status).count();
    all.push(format!(
        "{} designs are feasible, {} of them on the Pareto front; most frequent reasons for exclusion: {}.",
        number("accepted"),
        record.parts("front").len(),
        counted(found, 3)
    ));
    let left_out = number("left out");
    if left_out > 0 {
        all.push(format!(
            "{left_out} designs were left out by search.runs_max."
        ));
    }
    let starts = found.request.confirming_starts();
    if starts < CONFIRMING_STARTS {
        all.push(format!(
            "Means and standard errors are those of {starts} starts; a larger search.runs_max allows \
             {CONFIRMING_STARTS}."
        ));
    }
    all
}

/// The most frequent reasons of rejections with their numbers of structures.
fn counted(found: &Found, most: usize) -> String {
    let rejections = found.rejections();
    let texts = rejections.iter().take(most).map(|rejection| {
        let results = Results::of(REJECTION, Subject::Rejection(rejection));
        format!("{} ({})", results.text("meaning"), rejection.1)
    });
    texts.collect::<Vec<_>>().join("; ")
}

fn recommendation(points: &[Record], verdicts: &[Record], best: &Record) -> String {
    let steady = best.number("steady_gap_deg");
    let numbers = points.iter().zip(best.parts("points")).map(|(point, n)| {
        let shortfall = n.number("slip_shortfall");
        format!(
            "at {} it separates balls to about {:.3}°; available {steady:.3}°; reserve {:.3}°; \
             {:.1} % {} β0",
            point_label(point),
            n.number("critical_gap_deg"),
            n.number("margin_deg"),
            100.0 * shortfall.abs(),
            if shortfall < 0.0 { "above" } else { "below" },
        )
    });
    let numbers: Vec<String> = numbers.collect();
    let failing = verdicts.iter().any(|v| v.flag("passes") != Some(true));
    format!(
        "{}: {}; {}.",
        if failing {
            "Nothing recommended; starting point, which fails its verdict from even spacing"
        } else {
            "Recommended"
        },
        structure_label(best),
        numbers.join("; "),
    )
}

/// Fewer, more or as many collisions, and so on: differences from the same starts, run by run.
fn comparison(found: &Found, best: &Record, own: &Record, point: usize) -> String {
    type Of = fn(&Motion) -> f64;
    let statistical: [(&str, Of, usize); 4] = [
        ("collisions per ball and orbit", |n| n.collisions, 3),
        ("of these in steady state", |n| n.collisions_late, 3),
        (
            "gap deviation in degrees",
            |n| n.gap_deviation_rad.to_degrees(),
            3,
        ),
        ("friction loss in W", |n| n.friction_w, 2),
    ];
    let of = |role| found.of_role(role).next()?.statistics.get(point);
    let mut parts = vec![];
    if let (Some(a), Some(b)) = (of(Role::Recommended), of(Role::Own)) {
        let difference = a.less(b);
        for (name, of, digits) in statistical {
            let (change, error) = (of(&difference.mean), of(&difference.error));
            let word = if change.abs() <= SIGNIFICANT * error {
                "no different within the scatter"
            } else if change < 0.0 {
                "less"
            } else {
                "more"
            };
            parts.push(format!(
                "{name} {:.digits$} against {:.digits$}, difference {} ± {error:.digits$} ({word})",
                of(&a.mean),
                of(&b.mean),
                signed(Some(change), digits),
            ));
        }
    }
    let margin = |structure: &Record| structure.parts("points")[point].value("margin_deg");
    if let (Some(a), Some(b)) = (margin(best), margin(own)) {
        parts.push(format!(
            "reserve {a:.3}° against {b:.3}° ({})",
            if a > b { "larger" } else { "smaller" }
        ));
    }
    parts.join("; ")
}

/// Candidates that are rejected from more starts, each with the reason; `None` without any.
fn unconfirmed(found: &Found) -> Option<String> {
    let text = |c: &Confirmed| {
        let structure = Results::of(STRUCTURE, Subject::Structure(&c.evaluation));
        let rejection = c.evaluation.rejection.as_ref();
        let why = rejection.map_or(String::new(), |r| format!(", {}", at_point(found, r)));
        format!("{}{why}", structure_label(&structure.into()))
    };
    let texts: Vec<String> = found.of_role(Role::Unconfirmed).map(text).collect();
    let starts = found.request.confirming_starts();
    (!texts.is_empty()).then(|| format!("from {starts} starts {}", texts.join("; ")))
}

/// Cause of a rejection with the operating point.
fn at_point(found: &Found, rejection: &Rejection) -> String {
    let place = rejection.point.map_or(String::new(), |p| {
        let point = Results::of(POINT, Subject::Point(&found.request.points[p]));
        format!(" at {}", point_label(&point.into()))
    });
    format!("{}{place}", rejection.cause)
}

/// Requirement that excludes all designs, as a sentence.
pub fn why_none(found: &Found) -> String {
    if let Some(others) = unconfirmed(found) {
        let own = found.of_role(Role::Own).next();
        let own = own.filter(|c| c.evaluation.rejection.is_none());
        return format!(
            "no raceway is recommended: what is acceptable from the {} initial states of the search fails in \
             its confirmation, the best first: {others}; set search.initial_states to more{}",
            found.request.starts,
            own.map_or("", |_| "; the initial design is acceptable")
        );
    }
    let closest = found.closest().map_or(
        "; the geometry (Zhao 2022, Eq. (8), (9)) or search.critical_gap_min_fraction excludes all of them"
            .to_owned(),
        |e: &Evaluation| {
            let at = e.rejection.as_ref().map_or(String::new(), |r| at_point(found, r));
            let size = Results::of(STRUCTURE, Subject::Structure(e));
            let (span, angle) = (size.number("axial_span_mm"), size.number("half_angle_deg"));
            let shape = size.text("shape");
            format!("; the closest, {shape}, lC {span:.3} mm and θ {angle:.2}°, fails because {at}")
        },
    );
    format!(
        "no raceway meets every requirement; structures that each excludes: {}{closest}",
        counted(found, usize::MAX)
    )
}
