//! Share of its lag that a raceway keeps.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, Requirement};

/// Lag in a raceway on elastic flanks over that of rolling on rigid ones without a contact angle: with less than
/// half it hardly spaces the balls. Load, contact angle and sliding take the rest; β0 of rigid flanks is out of
/// reach there.
pub(crate) static LAG: Requirement = Requirement {
    name: "lag",
    least: Some(Bound {
        limit: 0.5,
        verdict: RacewayVerdict::LosesLag,
        cause: CauseKind {
            name: "loses-lag",
            meaning: "load, contact angle and sliding leave too little of the lag",
            remedy: "another speed, or less of an axial load",
        },
    }),
    sentence: |_| "balls keep {} of the lag of rolling on rigid flanks",
    unknown: "the lag of a ball",
    ..Requirement::PERCENT
};

/// Lag under the largest axial load over that without it.
pub(crate) static AXIAL_LAG: Requirement = Requirement {
    name: "axial-lag",
    least: Some(Bound {
        limit: 0.5,
        verdict: RacewayVerdict::LosesLag,
        cause: CauseKind {
            name: "axial-load",
            meaning: "too little of the lag is left under the largest axial load",
            remedy: "a smaller search.axial_load_max_n",
        },
    }),
    sentence: |_| "{} of the lag is left under the largest axial load",
    unknown: "the lag under the largest axial load",
    ..Requirement::PERCENT
};
