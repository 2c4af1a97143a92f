//! Claims of a paper.

use super::*;

pub fn claims() -> Vec<Claim> {
    let claim = |claim: &str, verdict| Claim {
        claim: claim.into(),
        place: "Section 4.3, Fig. 8".into(),
        finding: "What the computation finds, in a sentence or two that say how far it goes."
            .into(),
        numbers: "critical gap 1.8264° against 1.8190°; Δ = +0.0074°".into(),
        verdict,
    };
    vec![
        claim(
            "“Each ball may collide twice in the discrete raceway” when three balls fit into it.",
            ClaimStatus::Confirmed,
        ),
        claim(
            "The critical gap of structure (h) is 1.6594°.",
            ClaimStatus::NotConfirmed,
        ),
        claim(
            "Below θ = 22° the ball slips & does not reach the theoretical speed <rolling>.",
            ClaimStatus::Partly,
        ),
        claim("2(ε + β0) = 51.17°.", ClaimStatus::Erratum),
        claim("Vibration falls in the test rig.", ClaimStatus::NotTested),
    ]
}
