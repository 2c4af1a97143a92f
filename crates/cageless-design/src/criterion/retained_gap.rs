//! Gap with which balls come back to a raceway.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, Requirement};

/// Least gap with which balls come back over the critical gap, with about which they leave the raceway. In the
/// load zone it is 0.7 (at low speed) to 1; where a raceway lies so that its way out has no load, a fifth.
pub(in super::super) static RETAINED_GAP: Requirement = Requirement {
    name: "retained-gap",
    least: Some(Bound {
        limit: 0.5,
        verdict: RacewayVerdict::TooShallow,
        cause: CauseKind {
            name: "gap-not-retained",
            meaning: "balls close up again before they are loaded",
            remedy: "places nearer to the load (search.centre_angle_deg)",
        },
    }),
    sentence: |_| "balls come back with {} of the critical gap",
    unknown: "the gap with which balls come back",
    ..Requirement::PERCENT
};
