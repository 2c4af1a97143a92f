//! Fraction of the kinematic deceleration that balls reach.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, Requirement};

/// Fraction of the theoretical drop of orbital speed that balls reach: with less they slide over the raceway, and
/// its critical gap means nothing.
pub(crate) static DECELERATION: Requirement = Requirement {
    name: "deceleration",
    least: Some(Bound {
        limit: 0.8,
        verdict: RacewayVerdict::Slips,
        cause: CauseKind {
            name: "gross-sliding",
            meaning: "balls slide over the raceway and slow down too little",
            remedy: "a lower speed or a higher load, with which balls slide less",
        },
    }),
    sentence: |_| "balls reach {} of the kinematic deceleration",
    unknown: "the deceleration in the raceway",
    ..Requirement::PERCENT
};
