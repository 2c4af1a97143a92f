//! Results of a search for a raceway.

use crate::Shape;
use crate::table::{
    MAP, MOTION, PAPER, PLACEMENT, POINT, REJECTION, SEARCH, STRUCTURE, STRUCTURE_AT, VERDICT,
};

const POINTS: Shape = Shape::of(POINT);
const MOTIONS: Shape = Shape::of(MOTION);
const STRUCTURES: Shape = Shape {
    parts: &[(
        "points",
        &Shape {
            parts: &[
                ("motion", &MOTIONS),
                ("errors", &MOTIONS),
                ("bunched", &MOTIONS),
            ],
            ..Shape::of(STRUCTURE_AT)
        },
    )],
    ..Shape::of(STRUCTURE)
};

/// Shape of the results of a search. The `own` and `recommended` structures are from more initial states and from
/// the usual ones; the candidates `unconfirmed` are rejected by more initial states. Further parts are the
/// structures rejected by least (`closest`), the Pareto `front`, every structure of the `band` and `maps`.
pub const SEARCH_SHAPE: Shape = Shape {
    values: SEARCH,
    sentences: &["findings"],
    parts: &[
        ("points", &POINTS),
        ("recommended", &STRUCTURES),
        ("recommended_verdicts", &Shape::of(VERDICT)),
        ("unconfirmed", &STRUCTURES),
        ("own", &STRUCTURES),
        ("recommended_from_usual_starts", &STRUCTURES),
        ("own_from_usual_starts", &STRUCTURES),
        ("closest", &STRUCTURES),
        ("front", &STRUCTURES),
        ("band", &STRUCTURES),
        ("rejections", &Shape::of(REJECTION)),
        (
            "placements",
            &Shape {
                parts: &[("best", &STRUCTURES)],
                ..Shape::of(PLACEMENT)
            },
        ),
        (
            "maps",
            &Shape {
                parts: &[("point", &POINTS)],
                ..Shape::of(MAP)
            },
        ),
        ("paper", &Shape::of(PAPER)),
    ],
};
