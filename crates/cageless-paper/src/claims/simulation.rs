//! Table 2, Fig. 6 and 7.

use cageless_report::{Claim, Requirement};

use super::evidence::{Evidence, of_both, rms};
use super::theory::ROUNDING_DEG;
use crate::PUBLISHED;
use crate::cases::ODD_ROW;

/// Difference from a simulated value of Table 2 that the step, the start and the other things which
/// the paper leaves open explain, degrees.
const SIMULATED_DEG: f64 = 0.02;

pub fn claims(e: &Evidence) -> Vec<Claim> {
    vec![
        simulated(e),
        odd_row(e),
        differences(e),
        growth(e),
        unloaded(e),
        loaded(e),
        raceway(e),
        first(e),
        both_neighbours(e),
    ]
}

/// Root mean squares of the residuals of two models against the printed gaps, degrees.
struct Residuals {
    model: f64,
    /// Root mean square of the gap of evenly spaced balls.
    constant: f64,
}

impl Residuals {
    fn ratio(&self) -> f64 {
        self.model / self.constant
    }
}

fn simulated(e: &Evidence) -> Claim {
    let t = &e.table2;
    let residuals = |rows: std::ops::Range<usize>| {
        let rows = || rows.clone().filter(|k| *k != ODD_ROW);
        let printed = |k: usize| t.table.rows[k].paper_simulated_deg;
        Residuals {
            model: rms(rows().map(|k| t.gap_deg(0, k) - printed(k))),
            constant: rms(rows().map(|k| e.printed.nominal_gap_deg - printed(k))),
        }
    };
    let [short, long] = [residuals(4..10), residuals(0..4)];
    let ratio = |name: &str, of: &Residuals, limit: f64| {
        let quantity = format!("{name}: RMS residual over that of the constant β0");
        Requirement::at_most(&quantity, of.ratio(), limit, "")
    };
    Claim::of_the_model(
        "Table 2, simulated values",
        "Simulated gaps of the ten structures.",
        vec![
            Requirement::at_most(
                "largest difference without 5.60 mm",
                t.largest_difference_deg(0),
                SIMULATED_DEG,
                "°",
            )
            .says(
                "The model as published with sign(ΔV) gives nine of the ten.",
                "The model as published with sign(ΔV) does not give nine of the ten.",
            ),
            ratio("(e) to (j)", &short, 0.2).says(
                "(e) to (j) tell it from a constant gap.",
                "(e) to (j) do not tell it from a constant gap.",
            ),
            ratio("(a) to (d)", &long, 0.5).says(
                "(a) to (d) do, too.",
                "(a) to (d) do not tell it from a constant gap: they confirm nothing.",
            ),
        ],
    )
    .remark(
        "The simulated value is read as the critical gap, the largest gap at the entrance that \
         closes inside. The paper does not define it; everything here depends on this reading.",
    )
    .numbers(&format!(
        "RMS residuals without 5.60 mm, model and constant {}°: (a) to (d) {:.3}° and {:.3}°, (e) \
         to (j) {:.3}° and {:.3}°; the step moves the rows by up to {:.3}°, the start by {:.3}°, \
         reading touch as δb > 0 by {:.3}°, wider neighbours by {:.3}°",
        e.printed.nominal_gap_deg,
        long.model,
        long.constant,
        short.model,
        short.constant,
        t.spread_deg("step", 0),
        t.spread_deg("start", 0),
        t.spread_deg("touch", 0),
        t.spread_deg("neighbours", 0)
    ))
}

fn odd_row(e: &Evidence) -> Claim {
    let t = &e.table2;
    let printed = |k: usize| t.table.rows[k].paper_simulated_deg;
    let fall = |of: &dyn Fn(usize) -> f64| of(ODD_ROW - 1) - of(ODD_ROW);
    let computed = |k: usize| t.gap_deg(0, k);
    Claim::of_the_model(
        "Table 2, lC = 5.60 mm",
        "Simulated gap of structure (h).",
        vec![
            Requirement::at_most(
                "difference of the computed gap",
                t.odd_difference_deg(0),
                SIMULATED_DEG,
                "°",
            )
            .says("It comes out.", "It does not come out."),
            Requirement::at_least(
                "fall of the printed value from 5.40 mm over that of the computed gap",
                fall(&printed) / fall(&computed),
                0.5,
                "",
            )
            .says(
                "It follows its neighbours.",
                "It does not follow its neighbours: it differs little from that of 5.40 mm.",
            ),
        ],
    )
    .numbers(&format!(
        "printed {:.4}°, computed {:.4}° (`paper`, Coulomb) and {:.4}° (`physical`, smooth); at \
         5.40 mm {:.4}° and {:.4}°",
        printed(ODD_ROW),
        t.gap_deg(0, ODD_ROW),
        t.gap_deg(3, ODD_ROW),
        printed(ODD_ROW - 1),
        t.gap_deg(0, ODD_ROW - 1)
    ))
}

fn differences(e: &Evidence) -> Claim {
    let rows = e.table2.table.rows.iter().zip(e.printed.differences_deg);
    let wrong: Vec<String> = rows
        .map(|(r, printed)| (r, r.paper_simulated_deg - r.paper_theory_deg, printed))
        // Three numbers are rounded.
        .filter(|(_, difference, printed)| {
            let off = (difference - printed).abs();
            off.is_nan() || off > 3.0 * ROUNDING_DEG
        })
        .map(|(r, difference, printed)| {
            format!(
                "lC = {:.2} mm: {:.4} − {:.4} = {difference:.4}, printed {printed:.4}",
                r.structure.axial_span_mm, r.paper_simulated_deg, r.paper_theory_deg
            )
            .replace('-', "−")
        })
        .collect();
    let quantity = "rows whose difference is that of their two numbers";
    let criterion = Requirement::in_all(quantity, PUBLISHED.len() - wrong.len(), PUBLISHED.len())
        .says(
            "Each is that of the two numbers next to it.",
            "Not each is that of the two numbers next to it.",
        );
    Claim::as_printed(
        "Table 2, differences",
        "Differences of the simulated from the theoretical gaps.",
        vec![criterion],
    )
    .numbers(&wrong.join("; "))
}

/// Differences from the theory as θ falls, from structure to structure.
fn growth(e: &Evidence) -> Claim {
    let t = &e.table2;
    let rows = || t.table.rows.iter().enumerate();
    let grows = |name: &str, difference: &dyn Fn(usize) -> f64| {
        let off: Vec<f64> = rows()
            .map(|(k, row)| (difference(k) - row.paper_theory_deg).abs())
            .collect();
        let growing = off.windows(2).filter(|pair| pair[1] > pair[0]).count();
        let quantity = "steps from one structure to the next at which it grows";
        let numbers: usize = off.iter().filter(|off| off.is_finite()).count();
        Requirement::in_all(quantity, growing, numbers.saturating_sub(1))
            .says(
                format!("It grows at every step in {name}."),
                format!("It does not grow at every step in {name}."),
            )
            .on(name)
    };
    let computed = |column: usize| move |k: usize| t.gap_deg(column, k);
    Claim::of_the_model(
        "Section 4.3, Table 2",
        "The difference between simulated and theoretical gap grows as lC rises and θ falls.",
        vec![
            grows("the printed values", &|k| t.table.rows[k].paper_simulated_deg),
            grows("`paper`", &computed(0)),
            grows("`physical`", &computed(3)),
        ],
    )
    .numbers(&format!(
        "from (a) to (j): printed {:.4}° to {:.4}°, `paper` {:.3}° to {:.3}°, `physical` {:.3}° to {:.3}°",
        (t.table.rows[0].paper_simulated_deg - t.table.rows[0].paper_theory_deg).abs(),
        (t.table.rows[9].paper_simulated_deg - t.table.rows[9].paper_theory_deg).abs(),
        (t.gap_deg(0, 0) - t.table.rows[0].paper_theory_deg).abs(),
        (t.gap_deg(0, 9) - t.table.rows[9].paper_theory_deg).abs(),
        (t.gap_deg(3, 0) - t.table.rows[0].paper_theory_deg).abs(),
        (t.gap_deg(3, 9) - t.table.rows[9].paper_theory_deg).abs(),
    ))
}

fn unloaded(e: &Evidence) -> Claim {
    let printed = e.printed.neglected_deg;
    Claim::of_the_model(
        "Section 4.3, Fig. 6, a–b",
        &format!(
            "In the unloaded zone the gap falls by {printed}° by sliding; that can be neglected."
        ),
        of_both(&e.stages, |name, s| {
            let quantity = format!("change of the gap, from {printed}°");
            let value = (s.unloaded_change_deg - printed).abs();
            Requirement::at_most(&quantity, value, 0.01, "°").says(
                format!("It does in {name}."),
                format!("It changes by another amount in {name}."),
            )
        }),
    )
    .numbers(&format!(
        "{:.3}° in `paper`, {:.3}° in `physical`: {:.1} % and {:.1} % of β0",
        e.stages[0].unloaded_change_deg,
        e.stages[1].unloaded_change_deg,
        100.0 * e.stages[0].unloaded_change_deg / e.printed.nominal_gap_deg,
        100.0 * e.stages[1].unloaded_change_deg / e.printed.nominal_gap_deg
    ))
}

fn loaded(e: &Evidence) -> Claim {
    let mut criterion = of_both(&e.stages, |name, s| {
        let quantity = "largest departure of the gap from β0";
        Requirement::at_most(quantity, s.loaded_change_deg, e.printed.neglected_deg, "°").says(
            format!("The gap keeps to β0 in {name}."),
            format!("The gap does not keep to β0 in {name}."),
        )
    });
    criterion.extend(of_both(&e.stages, |name, s| {
        let quantity = "largest sliding speed over the speed of the inner raceway";
        Requirement::at_most(quantity, 100.0 * s.loaded_slip, 1.0, " %").says(
            format!("The ball scarcely slides in {name}."),
            format!("The ball slides in {name}."),
        )
    }));
    Claim::of_the_model(
        "Section 4.3, Fig. 6, b–c and d–e",
        "In the load zone outside the discrete raceway balls scarcely slide, and the gap is stable at \
         β0.",
        criterion,
    )
}

fn raceway(e: &Evidence) -> Claim {
    let beta0 = e.printed.nominal_gap_deg;
    Claim::of_the_model(
        "Section 4.3, Fig. 6, c–d",
        "In the discrete raceway the gap falls and rises again by about β0.",
        of_both(&e.stages, |name, s| {
            let quantity = "change of the gap, from β0";
            let value = (s.raceway_change_deg - beta0).abs();
            Requirement::at_most(quantity, value, 0.05 * beta0, "°").says(
                format!("It does in {name}."),
                format!("It changes by another amount in {name}."),
            )
        }),
    )
    .numbers(&format!(
        "{:.3}° in `paper`, {:.3}° in `physical`",
        e.stages[0].raceway_change_deg, e.stages[1].raceway_change_deg
    ))
}

fn first(e: &Evidence) -> Claim {
    let least = e.printed.neglected_deg;
    let mut criterion = of_both(&e.stages, |name, s| {
        let quantity = "largest fall of the gap of a pair in the raceway in the first millisecond";
        Requirement::at_least(quantity, s.first_fall_deg[0], least, "°").says(
            format!("The gaps of pairs in the raceway fall in {name}."),
            format!("No gap in the raceway falls in {name}."),
        )
    });
    criterion.extend(of_both(&e.stages, |name, s| {
        let quantity = "largest fall of the gap of a pair outside it in the first millisecond";
        Requirement::at_least(quantity, s.first_fall_deg[1], least, "°").says(
            format!("Others fall as well in {name}."),
            format!("Others do not in {name}: the raceway acts, not the iteration."),
        )
    }));
    Claim::of_the_model(
        "Section 4.3, Fig. 6",
        "The gap falls rapidly at first, because the iteration of the solution is perturbed by the \
         initial values.",
        criterion,
    )
    .remark("The multistep method starts here with an error-controlled Runge–Kutta pair.")
}

fn both_neighbours(e: &Evidence) -> Claim {
    Claim::of_the_model(
        "Section 4.3, Fig. 7",
        "Ball i of structure (a) is hit by ball i+1 and then by ball i−1 in one passage.",
        of_both(&e.stages, |name, s| {
            let quantity = "such passages in 0.2 s";
            Requirement::at_least(quantity, s.double_passages as f64, 1.0, "").says(
                format!("Such passages occur in {name}."),
                format!("No such passage occurs in {name}."),
            )
        }),
    )
}
