//! Claims of a paper.

use super::*;

pub fn claims() -> Vec<Claim> {
    let place = "Section 4.3, Fig. 8";
    let criterion = |values: &[f64]| -> Vec<Requirement> {
        let requirement = |value: &f64| {
            let quantity = "critical gap of `paper` less 1.8190°";
            Requirement::at_most(quantity, *value, 0.02, "°").says(
                "The computation finds it, in a sentence that states how far.",
                "The computation does not find it.",
            )
        };
        values.iter().map(requirement).collect()
    };
    let numbers = "critical gap 1.8264° against 1.8190°; Δ = +0.0074°";
    let claims = vec![
        Claim::of_the_model(
            place,
            "“Each ball may collide twice in the discrete raceway” when three balls fit into it.",
            criterion(&[0.0074]),
        ),
        Claim::of_the_model(
            place,
            "The critical gap of structure (h) is 1.6594°.",
            criterion(&[0.074]),
        ),
        Claim::of_the_model(
            place,
            "Below θ = 22° the ball slides & does not reach the theoretical speed <rolling>.",
            criterion(&[0.0074, 0.074]),
        ),
        Claim::as_printed(place, "2(ε + β0) = 51.17°.", criterion(&[0.26])),
        Claim::of_the_model(place, "Vibration falls in the test rig.", criterion(&[])),
    ];
    claims.into_iter().map(|c| c.numbers(numbers)).collect()
}
