//! Narrative of a search: its result in sentences.

use super::result::{SearchData, StructureData};
use cageless::design::search::{CONFIRMING_STARTS, Evaluation, Found, Motion};

use super::rejections::rejections;

/// Differences beyond this many standard errors count.
const SIGNIFICANT: f64 = 2.0;

/// The sentences for the terminal and the page.
pub fn narrative(found: &Found, data: &SearchData) -> Vec<String> {
    let Some(best) = &data.recommended else {
        return vec![why_none(found)];
    };
    let mut all = vec![recommendation(data, best)];
    for (point, verdict) in data.points.iter().zip(&data.recommended_verdicts) {
        all.push(format!(
            "At {}, with this raceway in the case: {}.",
            point.label(),
            verdict.headline
        ));
    }
    if let Some(own) = &data.own {
        for (k, point) in data.points.iter().enumerate() {
            all.push(format!(
                "At {}, against the initial design {}: {}.",
                point.label(),
                own.label(),
                comparison(found, best, own, k)
            ));
        }
        if !own.why.is_empty() {
            all.push(format!(
                "The initial design is not acceptable: {}.",
                own.why
            ));
        }
    }
    let accepted = data.band.iter().filter(|s| s.status == "accepted").count();
    all.push(format!(
        "{} designs are feasible, {} of them on the Pareto front; most frequent reasons for exclusion: {}.",
        accepted,
        data.front.len(),
        data.rejections
            .iter()
            .take(3)
            .map(|r| format!("{} ({})", r.meaning, r.count))
            .collect::<Vec<_>>()
            .join("; ")
    ));
    let left_out = data.band.iter().filter(|s| s.status == "left out").count();
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

fn recommendation(data: &SearchData, best: &StructureData) -> String {
    let steady = best.steady_gap_deg.unwrap_or(f64::NAN);
    let numbers: Vec<String> = data
        .points
        .iter()
        .zip(&best.points)
        .map(|(point, n)| {
            let critical = n.critical_gap_deg.unwrap_or(f64::NAN);
            let shortfall = n.slip_shortfall.unwrap_or(f64::NAN);
            format!(
                "at {} it separates balls to at least {critical:.3}°; available {steady:.3}°; reserve {:.3}°; \
                 {:.1} % {} β0",
                point.label(),
                n.margin_deg.unwrap_or(f64::NAN),
                100.0 * shortfall.abs(),
                if shortfall < 0.0 { "above" } else { "below" },
            )
        })
        .collect();
    let failing = data
        .recommended_verdicts
        .iter()
        .any(|v| v.passes != Some(true));
    format!(
        "{}: {}; {}.{}",
        if failing {
            "Nothing recommended; starting point, which fails its verdict from even spacing"
        } else {
            "Recommended"
        },
        best.label(),
        numbers.join("; "),
        if best.why.is_empty() {
            String::new()
        } else {
            format!(" From more starts, however: {}.", best.why)
        }
    )
}

/// Fewer, more or as many collisions, and so on: differences from the same starts, run by run.
fn comparison(found: &Found, best: &StructureData, own: &StructureData, point: usize) -> String {
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
    let of = |role: &str| {
        let confirmed = found.confirmed.iter().find(|c| c.role == role)?;
        confirmed.statistics.get(point)
    };
    let mut parts = vec![];
    if let (Some(a), Some(b)) = (of("recommended"), of("own")) {
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
                "{name} {:.digits$} against {:.digits$}, difference {change:+.digits$} ± \
                 {error:.digits$} ({word})",
                of(&a.mean),
                of(&b.mean),
            ));
        }
    }
    if let (Some(a), Some(b)) = (best.points[point].margin_deg, own.points[point].margin_deg) {
        parts.push(format!(
            "reserve {a:.3}° against {b:.3}° ({})",
            if a > b { "larger" } else { "smaller" }
        ));
    }
    parts.join("; ")
}

/// Requirement that excludes all designs, as a sentence.
pub fn why_none(found: &Found) -> String {
    let counts: Vec<String> = rejections(found)
        .iter()
        .map(|r| format!("{} ({})", r.meaning, r.count))
        .collect();
    let closest = found.closest().map_or(
        "; the geometry (Zhao 2022, Eq. (8), (9)) or search.critical_gap_min_fraction excludes all of them"
            .to_owned(),
        |e: &Evaluation| {
            let at = e.rejection.as_ref().map_or(String::new(), |r| {
                let place = r.point.map_or(String::new(), |p| {
                    let point = found.request.points[p];
                    format!(
                        " at {:.0} rpm and {} N",
                        point.inner_speed_rad_s * 60.0 / std::f64::consts::TAU,
                        point.radial_load_n
                    )
                });
                format!("{}{place}", r.cause)
            });
            format!(
                "; the closest, lC {:.3} mm and θ {:.2}°, fails because {at}",
                e.structure.axial_span_m * 1e3,
                e.structure.half_angle_rad.to_degrees()
            )
        },
    );
    format!(
        "no raceway meets every requirement; structures that each excludes: {}{closest}",
        counts.join("; ")
    )
}
