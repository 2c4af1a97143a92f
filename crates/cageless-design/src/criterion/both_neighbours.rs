//! Fraction of the passages in which both neighbours hit.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, Requirement};

/// Fraction of the passages in which both neighbours hit. In the `paper` formulation those of the paper's ten
/// structures with two collisions lie well above the limit, the others well below; in `physical`, (c) falls
/// below.
pub(crate) static BOTH_NEIGHBOURS: Requirement = Requirement {
    name: "both-neighbours",
    most: Some(Bound {
        limit: 0.25,
        verdict: RacewayVerdict::DoubleCollision,
        cause: CauseKind {
            name: "double-collision",
            meaning: "double collisions in too many passages",
            remedy: "a lower speed, or balls with more room (bearing.balls)",
        },
    }),
    sentence: |_| "{} of the passages have a double collision",
    unknown: "the fraction of double collisions",
    ..Requirement::PERCENT
};
