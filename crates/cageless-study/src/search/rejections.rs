//! Causes of the rejected structures of a search, counted.

use cageless::design::search::Found;

use super::result::RejectionCount;

pub(super) fn rejections(found: &Found) -> Vec<RejectionCount> {
    let meaning = |name: &str| match name {
        "eq-8" => "the contact points leave the groove (Zhao 2022, Eq. (8))",
        "eq-9" => "the contact path leaves the groove or turns back (Zhao 2022, Eq. (9))",
        "overlap" => "two raceways overlap",
        "insufficient-separation" => {
            "critical gap too small a fraction of the steady-state gap: raceway too shallow"
        }
        "slips" => "critical gap too far below β0: excessive sliding",
        "excessive-separation" => "raceway too deep: evenly spaced balls collide",
        "stress" => "contact pressure above 4200 MPa (ISO 76)",
        "gross-sliding" => "gross sliding over the raceway",
        "gap-not-retained" => "gap lost before the load zone",
        "double-collision" => "double collisions in too many passages",
        _ => "a run failed",
    };
    found
        .rejections()
        .into_iter()
        .map(|(name, count)| RejectionCount {
            reason: name.to_owned(),
            meaning: meaning(name).to_owned(),
            count,
        })
        .collect()
}
