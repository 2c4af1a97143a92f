//! Gap to which a raceway separates balls over the steady-state gap.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, Requirement};

const LEAST: Bound = Bound {
    limit: 0.8,
    verdict: RacewayVerdict::TooShallow,
    cause: CauseKind {
        name: "insufficient-separation",
        meaning: "too shallow: balls leave too close together",
        remedy: "a smaller search.critical_gap_min_fraction, or wider ranges of search.axial_span_mm and \
                 search.half_angle_deg",
    },
};

/// Critical gap over the steady-state gap beyond which evenly spaced balls collide.
pub(in super::super) const STEADY_GAP_MAX: f64 = 1.0;

/// Critical gap over the steady-state gap: at least what spreads the balls, and at most 1, beyond which evenly
/// spaced balls collide.
pub static STEADY_GAP: Requirement = Requirement {
    name: "steady-gap",
    least: Some(LEAST),
    most: Some(Bound {
        limit: STEADY_GAP_MAX,
        verdict: RacewayVerdict::TooDeep,
        cause: CauseKind {
            name: "excessive-separation",
            meaning: "too deep: balls are spaced too far, so that three meet",
            remedy: "shallower raceways (smaller search.axial_span_mm); where these slide too much, a higher load",
        },
    }),
    sentence: |_| "the critical gap is {} of the steady-state gap",
    unknown: "the critical gap or the steady-state gap",
    ..Requirement::PERCENT
};

/// Critical gap over the steady-state gap with an oil film that scatters the gaps least: 1 to 1.3 in prototypes, where
/// every pass is a collision from 1.4 on, without oil from 1.26.
pub(in super::super) const IN_OIL: [f64; 2] = [1.0, 1.1];

/// β0, the critical gap without sliding, over the steady-state gap: whether it can spread the balls.
pub(in super::super) static THEORETICAL_GAP: Requirement = Requirement {
    name: "theoretical-gap",
    least: Some(LEAST),
    sentence: |_| "β0 is {} of the steady-state gap",
    unknown: "β0",
    ..Requirement::PERCENT
};
