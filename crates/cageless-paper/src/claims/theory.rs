//! Section 2 and Fig. 5.

use cageless_report::{Claim, Requirement};

use super::evidence::{Evidence, largest, least, of_both};
use crate::structures::Found;

/// Half of the last of four printed decimals, degrees.
pub const ROUNDING_DEG: f64 = 5e-5;

pub fn claims(e: &Evidence) -> Vec<Claim> {
    vec![
        eq_10(e),
        eq_11(e),
        angle_of_eq_11(e),
        pairs(e),
        speed(e),
        inverse(e),
    ]
}

fn eq_10(e: &Evidence) -> Claim {
    let m = &e.mechanics;
    let printed = m.spacing_deg - m.printed_epsilon_deg;
    let gap = e.printed.nominal_gap_deg;
    let quantity = "nominal gap with this ε, from the paper's own";
    let criterion = Requirement::at_most(quantity, (printed - gap).abs(), ROUNDING_DEG, "°").says(
"It gives the paper's own nominal gap.",
"It does not give the paper's own nominal gap: its chord is Rw, that of two balls in contact 2 Rw.");
    Claim::as_printed(
        "Eq. (10)",
        "ε = 2 arccos((2Rm² − Rw²)/(2Rm²)).",
        vec![criterion],
    )
    .numbers(&format!(
        "as printed ε = {:.2}° and a gap of {printed:.3}°; 2 arcsin(Rw/Rm) = {:.2}° and {:.4}°; \
         the paper's gap {gap:.4}°",
        m.printed_epsilon_deg,
        m.epsilon_deg,
        m.spacing_deg - m.epsilon_deg
    ))
}

fn eq_11(e: &Evidence) -> Claim {
    let rows = e.table2.table.rows.iter();
    let worst = largest(rows.map(|r| (r.theory_deg - r.paper_theory_deg).abs()));
    let criterion = Requirement::at_most("largest difference of a row", worst, ROUNDING_DEG, "°")
        .says(
            "All ten come out as printed.",
            "Not all come out as printed.",
        );
    Claim::of_the_model(
        "Eq. (11), Table 2",
        "Theoretical gaps β0 of the ten structures.",
        vec![criterion],
    )
}

fn angle_of_eq_11(e: &Evidence) -> Claim {
    let rows = || e.table2.table.rows.iter();
    let larger = |of: fn(Vec<f64>) -> f64| {
        let polar = |r: &cageless_report::Table2Row| r.theory_polar_deg.unwrap_or(f64::NAN);
        of(rows().map(|r| polar(r) - r.theory_deg).collect())
    };
    let (low, high) = (larger(least), larger(largest));
    let quantity = "largest change of β0 with the ball's own ψ (tan ψ = x/(−y))";
    let criterion = Requirement::at_most(quantity, high.max(-low), ROUNDING_DEG, "°").says(
        "φ is then the angular position ψ of the ball.",
        "φ is then not the angular position ψ of the ball.",
    );
    Claim::as_printed(
        "Eq. (11)",
        "x = Ro sin φ with φ the angle of integration.",
        vec![criterion],
    )
    .numbers(&format!(
        "β0 with ψ less β0 with φ: {low:.3}° to {high:.3}°"
    ))
}

/// Share of the pairs of which a rule is said to hold, %.
const RULE_PERCENT: f64 = 95.0;

/// The rule of pairs of Section 2.3, of a pair alone and of all balls.
fn pairs(e: &Evidence) -> Claim {
    let (t, neglected) = (&e.table2, e.printed.neglected_deg);
    // The critical gap is the largest with which a pair alone touches.
    let alone = |column: usize, name: &str| {
        let off = |k: usize| (t.gap_deg(column, k) - e.printed.nominal_gap_deg).abs();
        let kept = (0..t.table.rows.len())
            .filter(|k| off(*k) <= neglected)
            .count();
        let quantity =
            format!("structures in which a pair alone touches up to β0 within {neglected}°");
        Requirement::in_all(&quantity, kept, t.table.rows.len())
            .says(
                format!("A pair alone keeps the rule in all structures in {name}."),
                format!("A pair alone does not keep the rule in all structures in {name}."),
            )
            .on(name)
    };
    // Balls slide in (g) to (j).
    let kept_percent = |found: &Vec<Found>| {
        let share = |f: &Found| f.steady.pairs[1] as f64 / f.steady.pairs[0] as f64;
        100.0 * least(found[..6].iter().map(share))
    };
    let mut criterion = vec![alone(0, "`paper`"), alone(3, "`physical`")];
    criterion.extend(of_both(&e.structures, |name, found| {
        let quantity = "pairs of the running bearing that keep it, least of (a) to (f)";
        Requirement::at_least(quantity, kept_percent(found), RULE_PERCENT, " %").says(
format!("Among all balls nearly every pair keeps it in {name}."),
format!("Among all balls many pairs break it in {name}: neighbours hit them and change their gaps."))
    }));
    Claim::of_the_model(
        "Section 2.3",
        "Two balls whose gap is below β0 before the raceway collide in it; with a larger gap they do not.",
        criterion,
    )
    .remark(&format!("Of all balls, pairs count whose gap differs from β0 by more than {neglected}°."))
}

fn speed(e: &Evidence) -> Claim {
    let neglected = e.printed.neglected_deg;
    let gaps = &e.extra.at_speeds_deg;
    let polar_deg = e.table2.table.rows[3].theory_polar_deg;
    let changed = |name: &str, at_speeds_deg: [f64; 2]| {
        let [slow, fast] = at_speeds_deg;
        let quantity = format!("{name}: change of the critical gap from 3000 to 12 000 rpm");
        Requirement::at_most(&quantity, (fast - slow).abs(), neglected, "°").says(
            format!("The gap of {name} does not depend on it."),
            format!("With sliding the gap of {name} depends on it."),
        )
    };
    Claim::of_the_model(
        "Section 2.3",
        "The discrete gap does not depend on the speed of the inner ring.",
        vec![
            Requirement::at_most(
                "(d) at 3000 rpm: critical gap less β0 of Eq. (11) with ψ",
                (gaps[0][0] - polar_deg.unwrap_or(f64::NAN)).abs(),
                neglected,
                "°",
            )
            .says(
"Where balls scarcely slide, the gap is that of Eq. (11), which has no speed in it.",
"At 3000 rpm already the gap is not that of Eq. (11)."),
            changed("(d)", gaps[0]),
            changed("(h)", gaps[1]),
        ],
    )
    .numbers(&format!(
        "critical gaps in `physical` with smooth friction at 3000 and 12 000 rpm: (d) {:.3}° and \
         {:.3}°, (h) {:.3}° and {:.3}°; {neglected}° is what the paper neglects in Fig. 6",
        gaps[0][0], gaps[0][1], gaps[1][0], gaps[1][1]
    ))
}

fn inverse(e: &Evidence) -> Claim {
    let angles = &e.half_angles_deg;
    let falls = angles.windows(2).filter(|pair| pair[1] < pair[0]).count();
    let steps = angles.len().saturating_sub(1);
    let criterion =
        Requirement::in_all("steps of lC along Eq. (11) at which θ falls", falls, steps).says(
            "The larger lC, the smaller θ, along the whole curve.",
            "θ does not fall along the whole curve.",
        );
    Claim::of_the_model(
        "Section 4.2, Fig. 5; Section 6",
        "For a given gap lC and θ are inversely related.",
        vec![criterion],
    )
    .numbers(&format!(
        "θ from {:.1}° to {:.1}°",
        largest(angles.iter().copied()),
        least(angles.iter().copied())
    ))
}
