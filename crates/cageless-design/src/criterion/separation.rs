//! Fraction of β0 by which sliding lowers the critical gap.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, Requirement};

/// Fraction of β0 (Zhao 2022, Eq. (11)) by which a critical gap falls short of it. In the `paper` formulation
/// those of the paper's ten structures that it calls slipping lose 9 % and more, the others 3 % at most; the
/// `physical` formulation, where balls slip earlier, adds (f).
pub(crate) static SEPARATION: Requirement = Requirement {
    name: "separation",
    most: Some(Bound {
        limit: 0.05,
        verdict: RacewayVerdict::Slips,
        cause: CauseKind {
            name: "slips",
            meaning: "balls slide too much to leave at the full distance",
            remedy: "a lower speed or a higher load, with which balls slide less",
        },
    }),
    sentence: |value| match value < 0.0 {
        true => "sliding does not lower the critical gap",
        false => "sliding lowers the critical gap by {} of β0",
    },
    unknown: "the critical gap",
    ..Requirement::PERCENT
};
