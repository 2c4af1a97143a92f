//! Equations of motion and what the paper leaves out.

use cageless_report::{Claim, Requirement};

use super::evidence::{Evidence, largest};

/// Disagreement of a law of mechanics that is one of rounding.
const EXACT: f64 = 0.01;

pub fn claims(e: &Evidence) -> Vec<Claim> {
    vec![centrifugal(e), spin(e), reaction(e), not_given()]
}

fn centrifugal(e: &Evidence) -> Claim {
    let [with, without] = e.mechanics.top_force_n;
    let quantity = "outer force on the topmost ball with Fw over that without, less 1";
    let criterion = Requirement::at_most(quantity, (with / without - 1.0).abs(), EXACT, "").says(
"It changes nothing.",
"The frame is inertial: the motion has the force already, and with Fw the outer raceway carries it again.");
    Claim::as_printed(
        "Eq. (12), (15)",
        "The centrifugal force Fw is added to the equations of motion.",
        vec![criterion],
    )
    .numbers(&format!(
        "outer force on the topmost ball {without:.1} N without, {with:.1} N with Fw"
    ))
}

fn spin(e: &Evidence) -> Claim {
    let t = &e.table2;
    let changes = (0..10).map(|k| (t.gap_deg(0, k) - t.gap_deg(2, k)).abs());
    let changed = largest(changes.filter(|c| !c.is_nan()));
    Claim::as_printed(
        "Eq. (13), (22)",
        "The spin relative to the orbit enters Eq. (13) as if its frame did not turn; friction on \
         the discrete raceway acts along the contact path.",
        vec![
            Requirement::at_most(
                "rate of the relative spin over that of the absolute one, less 1",
                (e.mechanics.spin_rate - 1.0).abs(),
                EXACT,
                "",
            )
            .says(
                "The rates of the two spins are the same.",
                "Angular momentum needs the absolute spin, whose rate is another.",
            ),
            Requirement::at_most(
                "largest change of a critical gap (Coulomb) with these two and Fw put right",
                changed,
                e.printed.neglected_deg,
                "°",
            )
            .says(
                "For the critical gaps that matters little.",
                "It matters for the critical gaps.",
            ),
        ],
    )
    .numbers(&format!(
        "rates of the spins 1 : {:.2}; friction opposes the sliding velocity, which is \
         circumferential",
        1.0 / e.mechanics.spin_rate
    ))
}

fn reaction(e: &Evidence) -> Claim {
    let [printed, reacting] = e.mechanics.ring_residual;
    let quantity = "sum of the forces on the ring at rest over its load";
    let criterion = Requirement::at_most(quantity, printed, EXACT, "").says(
        "The ring is in equilibrium with it.",
        "The ring at rest would not be in equilibrium: action and reaction have opposite signs.",
    );
    Claim::as_printed(
        "Eq. (12), (14)",
        "Fi and Ffi act on the ball, Eq. (12), and with the same sign on the ring, Eq. (14).",
        vec![criterion],
    )
    .numbers(&format!(
        "over the load {printed:.1} as printed, {reacting:.1e} with the reaction"
    ))
}

fn not_given() -> Claim {
    Claim::of_the_model("throughout", "Results of one bearing.", vec![]).remark(
        "Groove radii, elastic constants, mass and drag of the ring, damping, restitution, step \
         and initial ring position are not given; the table of parameters marks what was chosen, \
         the spread next to Table 2 shows how much depends on it.",
    )
}
