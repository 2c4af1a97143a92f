//! What a search for a raceway holds.

use crate::table::{
    MAP, MOTION, PAPER, PLACEMENT, POINT, REJECTION, SEARCH, STRUCTURE, STRUCTURE_AT, VERDICT,
};
use crate::{Quantity, Shape};

const fn values(values: &'static [Quantity]) -> Shape {
    Shape {
        values,
        sentences: &[],
        parts: &[],
    }
}

const POINTS: Shape = values(POINT);
const MOTIONS: Shape = values(MOTION);
const STRUCTURES: Shape = Shape {
    parts: &[(
        "points",
        &Shape {
            parts: &[("motion", &MOTIONS), ("errors", &MOTIONS)],
            ..values(STRUCTURE_AT)
        },
    )],
    ..values(STRUCTURE)
};

/// What a search holds: `own` and `recommended` structure from more initial states and from the usual
/// ones, the Pareto `front`, every structure of the `band` and `maps`.
pub const SEARCH_SHAPE: Shape = Shape {
    values: SEARCH,
    sentences: &["findings"],
    parts: &[
        ("points", &POINTS),
        ("recommended", &STRUCTURES),
        ("recommended_verdicts", &values(VERDICT)),
        ("own", &STRUCTURES),
        ("recommended_from_usual_starts", &STRUCTURES),
        ("own_from_usual_starts", &STRUCTURES),
        ("front", &STRUCTURES),
        ("band", &STRUCTURES),
        ("rejections", &values(REJECTION)),
        (
            "placements",
            &Shape {
                parts: &[("best", &STRUCTURES)],
                ..values(PLACEMENT)
            },
        ),
        (
            "maps",
            &Shape {
                parts: &[("point", &POINTS)],
                ..values(MAP)
            },
        ),
        ("paper", &values(PAPER)),
    ],
};
