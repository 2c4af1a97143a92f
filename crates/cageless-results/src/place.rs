//! The result that stands at a place of a JSON document.

use crate::record::Shape;
use crate::table::{
    ANYWHERE, DISTANCE, DROP_VERIFICATION, JUDGEMENT, MEASURED, PLANE, ROTOR_VERIFICATION,
    SUCCESSION, VERIFICATION, VERIFIED,
};
use crate::{MEASURED_SHAPE, Quantity, SEARCH_SHAPE, TOLERANCE_SHAPE};

/// The result at `path`, the names from the top of the document `kind` (`tolerance` of `tolerance.json`) to its own;
/// `None` where something else stands there.
pub fn result_at(kind: &str, path: &[&str]) -> Option<&'static Quantity> {
    let own = path.last()?;
    let named = |q: &&Quantity| q.name == *own;
    match (kind, path) {
        ("tolerance", _) => within(&TOLERANCE_SHAPE, path),
        ("measure", ["frame" | "passes" | "headline" | "points", ..] | [.., "dimensions", _]) => {
            within(&MEASURED_SHAPE, path)
        }
        ("design", ["search", rest @ ..]) => within(&SEARCH_SHAPE, rest),
        // What stands there are statistics of results.
        ("compare", _) | (_, ["case", ..] | ["bearings", "case", ..]) => None,
        _ if path.contains(&"planes") => PLANE.iter().find(named),
        _ if path.contains(&"numbers") => JUDGEMENT.iter().find(named),
        _ => {
            let more = [
                MEASURED,
                SUCCESSION,
                VERIFICATION,
                DROP_VERIFICATION,
                ROTOR_VERIFICATION,
                VERIFIED,
                DISTANCE,
            ];
            ANYWHERE.into_iter().chain(more).flatten().find(named)
        }
    }
}

/// The result at a path within a record of this shape.
fn within(shape: &Shape, path: &[&str]) -> Option<&'static Quantity> {
    match path {
        [own] => shape.values.iter().find(|q| q.name == *own),
        [part, rest @ ..] => {
            let (_, shape) = shape.parts.iter().find(|(name, _)| name == part)?;
            within(shape, rest)
        }
        [] => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One name means what its place says.
    #[test]
    fn a_place_tells_results_of_one_name_apart() {
        let label = |kind, path: &[&str]| result_at(kind, path).map(|q| q.label.trim());
        let rows: [(&str, &[&str], Option<&str>); 12] = [
            ("tolerance", &["passes"], Some("passes")),
            ("tolerance", &["influences", "name"], Some("deviates")),
            ("tolerance", &["influences", "passed"], Some("pass")),
            (
                "tolerance",
                &["samples", "passed"],
                Some("bearings that pass"),
            ),
            ("tolerance", &["provenance", "name"], None),
            (
                "design",
                &["search", "own", "points", "motion", "collisions"],
                Some("collisions per ball and orbit"),
            ),
            ("summary", &["collisions"], Some("collisions between balls")),
            (
                "summary",
                &["verification", "numbers", "gap_min_deg", "z"],
                Some("difference of the means over its standard error"),
            ),
            ("summary", &["case", "search", "starts"], None),
            ("summary", &["bearings", "case", "search", "starts"], None),
            ("compare", &["starts"], None),
            (
                "design",
                &["raceways", "critical_gap_deg"],
                Some("critical gap"),
            ),
        ];
        for (kind, path, expected) in rows {
            assert_eq!(label(kind, path), expected, "{kind} {path:?}");
        }
    }
}
