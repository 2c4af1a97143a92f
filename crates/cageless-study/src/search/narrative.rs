//! Narrative of a search: its result in sentences.

use cageless::RacewayShape;
use cageless_design::CauseKind;
use cageless_design::search::{
    BUNCHED_TURNS, CONFIRMING_STARTS, Confirmed, Evaluation, Found, Motion, Rejection, Role,
};
use cageless_results::number_text::signed;
use cageless_results::{Cell, POINT, Record, Results, STRUCTURE, Subject};

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
    let mut all = vec![recommendation(points, best), confirmation(found, best)];
    if let Some(others) = unconfirmed(found) {
        all.push(format!(
            "Better rated, but rejected by the same starts: {others}."
        ));
    }
    for (point, verdict) in points.iter().zip(record.parts("recommended_verdicts")) {
        all.push(format!(
            "At {}, with this raceway in the case: {}.",
            point_label(point),
            verdict.text("headline")
        ));
        if let Some(Cell::Text(dry)) = verdict.results.get("dry_headline") {
            all.push(format!("Without oil it {dry}."));
        }
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
                "From the starts of the search the initial design is not acceptable: {}.",
                own.text("why")
            ));
        }
    }
    let band = record.parts("band");
    let number = |status| band.iter().filter(|s| s.text("status") == status).count();
    all.push(format!(
        "{} meet every requirement from {}; the recommended one is the best compromise.",
        raceways(number("accepted")),
        counted_starts(found.request.starts, false)
    ));
    all.extend(tried(found, 3));
    let left_out = number("left out");
    if left_out > 0 {
        all.push(format!(
            "{} more could be tried with a larger search.runs_max.",
            raceways(left_out)
        ));
    }
    let starts = found.request.confirming_starts();
    if starts < CONFIRMING_STARTS {
        all.push(format!(
            "The confirmation had {starts} random starts; a larger search.runs_max allows {CONFIRMING_STARTS}."
        ));
    }
    all
}

/// `1 raceway`, `3 raceways`.
fn raceways(count: usize) -> String {
    match count {
        1 => "1 raceway".to_owned(),
        count => format!("{count} raceways"),
    }
}

/// `12 random starts and a bunched one`.
fn counted_starts(drawn: u64, bunched: bool) -> String {
    let word = if drawn == 1 { "start" } else { "starts" };
    let bunched = if bunched { " and a bunched one" } else { "" };
    format!("{drawn} random {word}{bunched}")
}

/// Why raceways are excluded, which runs stopped, and that narrow ranges leave few.
fn tried(found: &Found, most: usize) -> Vec<String> {
    let mut all = vec![];
    let rejections = found.rejections();
    let reasons = rejections.iter().filter(|e| e.kind.name != FAILED);
    let reasons = reasons.take(most);
    let reasons = reasons.map(|e| format!("{} ({})", e.kind.meaning, e.count));
    let reasons: Vec<String> = reasons.collect();
    if !reasons.is_empty() {
        all.push(format!(
            "Reasons against other raceways, with their number: {}.",
            reasons.join("; ")
        ));
    }
    let stopped = rejections.iter().find(|e| e.kind.name == FAILED);
    if let (Some(stopped), Some(first)) = (stopped, found.first_failure()) {
        all.push(format!(
            "{} could not be judged, as a run stopped; the first: {first}.",
            raceways(stopped.count)
        ));
    }
    let request = &found.request;
    let ranged = request.axial_span_range_m.is_some() || request.half_angle_range_rad.is_some();
    let candidates = found.evaluations.len();
    if ranged && candidates <= FEW {
        all.push(format!(
            "The ranges search.axial_span_mm and search.half_angle_deg leave {} to be tried; wider ones leave more.",
            raceways(candidates)
        ));
    }
    all
}

/// Name of the kind of runs that stopped.
const FAILED: &str = "failed";
/// So many candidates are few: less than a line of constant θ has.
const FEW: usize = 8;

fn recommendation(points: &[Record], best: &Record) -> String {
    let steady = best.number("steady_gap_deg");
    let numbers = points.iter().zip(best.parts("points")).map(|(point, n)| {
        format!(
            "at {} balls leave about {:.3}° apart; even spacing would give {steady:.3}° (reserve {:.3}°)",
            point_label(point),
            n.number("critical_gap_deg"),
            n.number("margin_deg"),
        )
    });
    let numbers: Vec<String> = numbers.collect();
    format!(
        "Recommended: {}; {}.",
        structure_label(best),
        numbers.join("; ")
    )
}

/// Starts from which the recommendation was confirmed, with the passages in which balls are hit twice.
fn confirmation(found: &Found, best: &Record) -> String {
    let worst = |part: &'static str| {
        let points = best.parts("points").iter();
        let values = points.filter_map(|p| p.part(part)?.value("double_collision_fraction"));
        values.fold(f64::NAN, f64::max)
    };
    format!(
        "Confirmed from {}: double collisions in {:.1} % of the passages in the mean of the random starts, in \
         {:.1} % from the bunch after {:.0} orbits.",
        counted_starts(found.request.confirming_starts(), true),
        100.0 * worst("motion"),
        100.0 * worst("bunched"),
        0.5 * BUNCHED_TURNS
    )
}

/// Fewer, more or as many collisions, and so on: differences from the same starts, run by run.
fn comparison(found: &Found, best: &Record, own: &Record, point: usize) -> String {
    type Of = fn(&Motion) -> f64;
    let statistical: [(&str, Of, usize); 5] = [
        ("collisions per ball and orbit", |n| n.collisions, 3),
        ("of these in steady state", |n| n.collisions_late, 3),
        (
            "gap deviation in degrees",
            |n| n.gap_deviation_rad.to_degrees(),
            3,
        ),
        ("loss by sliding friction in W", |n| n.friction_w, 2),
        ("loss by the film in W", |n| n.rolling_resistance_w, 2),
    ];
    let of = |role| found.of_role(role).next()?.statistics.get(point);
    let mut parts = vec![];
    if let (Some(a), Some(b)) = (of(Role::Recommended), of(Role::Own)) {
        let difference = a.less(b);
        let is_dry = [a, b].iter().all(|of| of.mean.rolling_resistance_w == 0.0);
        let shown = statistical.len() - usize::from(is_dry);
        for (name, of, digits) in statistical.into_iter().take(shown) {
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

/// Candidates that the starts of the confirmation reject, each with the reason; `None` without any.
fn unconfirmed(found: &Found) -> Option<String> {
    let text = |c: &Confirmed| {
        let structure = Results::of(STRUCTURE, Subject::Structure(&c.evaluation));
        let rejection = c.evaluation.rejection.as_ref();
        let why = rejection.map_or(String::new(), |r| format!(", {}", at_point(found, r)));
        format!("{}{why}", structure_label(&structure.into()))
    };
    let texts: Vec<String> = found.of_role(Role::Unconfirmed).map(text).collect();
    (!texts.is_empty()).then(|| texts.join("; "))
}

/// Cause of a rejection with the operating point.
fn at_point(found: &Found, rejection: &Rejection) -> String {
    let place = rejection.point.map_or(String::new(), |p| {
        let point = Results::of(POINT, Subject::Point(&found.request.points[p]));
        format!(" at {}", point_label(&point.into()))
    });
    format!("{rejection}{place}")
}

/// Whether the structure of the case is acceptable to a search that recommends nothing.
fn of_own(found: &Found, own: &Confirmed) -> String {
    let Some(rejection) = &own.evaluation.rejection else {
        return "The initial design is acceptable.".to_owned();
    };
    let evenly = match rejection.cause.name() {
        "gap-not-retained" => "; `cageless design` judges evenly spaced balls alone",
        _ => "",
    };
    let fails = match is_in_oil(found) && rejection.cause.kind().name.ends_with("-separation") {
        true => "is not what the search looks for in oil",
        false => "fails as well",
    };
    format!(
        "The initial design {fails}: {}{evenly}.",
        at_point(found, rejection)
    )
}

/// Whether balls lag by a film.
fn is_in_oil(found: &Found) -> bool {
    let mut forms = found.evaluations.iter().filter_map(|e| e.forms);
    forms.any(|forms| forms.film_lag_rad > 0.0)
}

/// Kind of the cause that decides where no raceway meets every requirement: that against the nearest to it, else the
/// most frequent.
fn deciding(found: &Found) -> Option<&'static CauseKind> {
    let nearest = found.closest().and_then(|e| e.rejection.as_ref());
    let against = nearest.map(|rejection| rejection.cause.kind());
    against.or_else(|| Some(found.rejections().first()?.kind))
}

/// Why nothing is recommended, and what to change.
pub fn why_none(found: &Found) -> String {
    let first = found.of_role(Role::Unconfirmed).next();
    let (mut sentences, remedy) = match (first, unconfirmed(found)) {
        (Some(first), Some(others)) => {
            let accepted = found.evaluations.iter().filter(|e| e.objectives.is_some());
            let passed = accepted.count() + found.of_role(Role::Unconfirmed).count();
            let sentence = format!(
                "no raceway is recommended: {} every requirement from {}, but {} from {}: {others}.",
                match passed {
                    1 => "1 raceway meets".to_owned(),
                    passed => format!("{passed} raceways meet"),
                },
                counted_starts(found.request.starts, false),
                match found.of_role(Role::Unconfirmed).count() {
                    1 if passed == 1 => "it fails".to_owned(),
                    1 => "the best fails".to_owned(),
                    count => format!("the best {count} fail"),
                },
                counted_starts(found.request.confirming_starts(), true),
            );
            let cause = first.evaluation.rejection.as_ref().map(|r| r.cause.kind());
            let remedy = cause.map_or("", |kind| kind.remedy);
            let more = format!("{remedy}; or more starts for each raceway (search.initial_states)");
            (vec![sentence], more)
        }
        _ => {
            let closest = found.closest();
            let mut sentences = vec!["no raceway meets every requirement.".to_owned()];
            sentences.extend(closest.map(|e: &Evaluation| {
                let why = (e.rejection.as_ref()).map_or(String::new(), |r| at_point(found, r));
                let size = Results::of(STRUCTURE, Subject::Structure(e)).into();
                let untried = match e.has_moved() {
                    true => "",
                    false => "; its motion was not tried",
                };
                format!(
                    "The nearest to it, {}, fails: {why}{untried}.",
                    structure_label(&size)
                )
            }));
            sentences.extend(tried(found, usize::MAX));
            let kind = deciding(found);
            let remedy = kind.map_or("wider ranges in [search]", |kind| kind.remedy);
            let of_gap = kind.is_some_and(|kind| kind.name.ends_with("-separation"));
            let remedy = match of_gap && is_in_oil(found) {
                true => {
                    "thinner oil or less of it ([film]), fewer balls (bearing.balls), or wider ranges in [search]"
                }
                false => remedy,
            };
            (sentences, remedy.to_owned())
        }
    };
    let own = found.of_role(Role::Own).next();
    sentences.extend(own.map(|own| of_own(found, own)));
    sentences.push(format!("To change: {remedy}."));
    sentences.join(" ")
}
