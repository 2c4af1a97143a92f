//! The experiment, Fig. 12 to 14, and the comparison with conventional bearings.

use cageless::numerics::two_sided_limit;
use cageless_io::estimate::SIGNIFICANCE;
use cageless_report::{
    Change, Claim, ComparisonCell, Estimate, RecordChange, Requirement, RingComparison, RingNumbers,
};

use super::evidence::Evidence;
use crate::comparison::{CONVENTIONAL, FOUND, STRUCTURE_D, TRANSITION_STARTS};
use crate::experiment::{Bearing, Stretch};
use crate::load_zone::TRANSITIONS;

/// Speed of the experiment, rpm.
const EXPERIMENT_RPM: f64 = 3000.0;

pub fn claims(e: &Evidence) -> Vec<Claim> {
    vec![
        decrease(e),
        cause(e),
        photographs(e),
        spacing(e),
        superiority(e),
        in_steady_operation(e),
        transition(e),
    ]
}

/// Combinations of a ring, at one speed or at all.
fn cells<'a>(
    rings: &'a RingComparison,
    ring: &'a str,
    speed_rpm: Option<f64>,
) -> impl Iterator<Item = &'a ComparisonCell> + Clone {
    let here = move |c: &&ComparisonCell| {
        c.ring == ring && speed_rpm.is_none_or(|speed_rpm| c.speed_rpm == speed_rpm)
    };
    rings.cells.iter().filter(here)
}

/// How many of `estimates` are significantly below 0, and all of them.
fn lower<'a>(estimates: impl Iterator<Item = &'a Estimate>) -> [usize; 2] {
    estimates.fold([0, 0], |[lower, all], e| {
        [lower + usize::from(e.change() == Change::Lower), all + 1]
    })
}

/// The record of Fig. 12 over time.
fn decrease(e: &Evidence) -> Claim {
    let rings = &e.comparison;
    let later = |ring: &'static str, since: usize, of: fn(&RecordChange) -> &Estimate| {
        lower(
            cells(rings, ring, Some(EXPERIMENT_RPM)).map(move |c| of(&c.last_quarter_less[since])),
        )
    };
    let falls = |what: &str, since: usize, of: fn(&RecordChange) -> &Estimate| {
        let [count, all] = later(STRUCTURE_D, since, of);
        let quarter = ["first", "second"][since];
        let quantity =
            format!("lots with significantly {what} in the last quarter than in the {quarter}");
        Requirement::in_all(&quantity, count, all)
    };
    let [conventional_too, all] = later(CONVENTIONAL, 0, |c| &c.contacts_per_s);
    let [conventional, discrete] = &e.bearings;
    let row = |bearing: &Bearing, of: fn(&Stretch) -> f64, decimals: usize| {
        let parts = bearing.stretches.iter().map(of);
        let parts: Vec<String> = parts.map(|v| format!("{v:.decimals$}")).collect();
        parts.join(", ")
    };
    let record = |name: &str, bearing: &Bearing| {
        format!(
            "{name}: RMS {} m/s², contacts per second {}, their impulse per second {} N",
            row(bearing, |s| s.rms_m_s2, 2),
            row(bearing, |s| s.contacts_per_s, 0),
            row(bearing, |s| s.impulse_rate_n, 2)
        )
    };
    Claim::of_the_model(
        "Section 5, Fig. 12",
        "The vibration of the one measured record decreases with time, because balls collide less \
         and less under the action of the discrete raceway.",
        vec![
            falls("lower RMS", 0, |c| &c.rms_m_s2).says(
"From bunches at the start the vibration is lower in the last quarter of a record than in the first.",
"From bunches at the start the vibration is not always lower in the last quarter than in the first."),
            falls("fewer contacts", 0, |c| &c.contacts_per_s)
                .says("Contacts become fewer.", "Contacts do not always become fewer."),
            falls("less impulse of contacts", 0, |c| &c.impulse_rate_n)
                .says("Their impulse becomes less.", "Their impulse does not always become less."),
            falls("fewer contacts", 1, |c| &c.contacts_per_s).says(
"They go on becoming fewer after the first quarter: the decrease is gradual.",
"After the first quarter they do not always become fewer: the transient from the start decays."),
            Requirement::in_all(
                "lots whose contacts do not become significantly fewer in a conventional ring",
                all - conventional_too,
                all,
            )
            .says(
"A conventional ring does not do the same.",
"A conventional ring does the same: it is not the action of the discrete raceway."),
        ],
    )
    .numbers(&format!(
        "quarters of the record of Fig. 12, transient included: {}; {}",
        record("structure (d)", discrete),
        record("conventional", conventional)
    ))
}

fn cause(e: &Evidence) -> Claim {
    let of = |ring: &'static str| {
        let parts = cells(&e.comparison, ring, None)
            .map(|c| (c.numbers.rms_without_contacts_m_s2.mean / c.numbers.rms_m_s2.mean).powi(2));
        let main = parts.clone().filter(|rest| *rest < 0.5).count();
        let quantity =
            format!("{ring}: cases with less than half of the mean square left without contacts");
        Requirement::in_all(&quantity, main, parts.count()).says(
            format!("They are in every case with the ring: {ring}."),
            format!("They are not in every case with the ring: {ring}."),
        )
    };
    Claim::of_the_model(
        "Section 5, Fig. 12",
        "The collisions of the balls are the main cause of the vibration.",
        vec![of(CONVENTIONAL), of(STRUCTURE_D)],
    )
    .remark("The vibration is that of the housing with the contacts cut out of the force.")
}

fn photographs(e: &Evidence) -> Claim {
    let [conventional, discrete] = e.bearings.each_ref().map(|b| b.touching);
    let text = |counts: [usize; 4]| counts.map(|n| n.to_string()).join(", ");
    Claim::of_the_model(
        "Section 5, Fig. 13, 14",
        "At 0.05, 0.1, 0.15 and 0.2 s balls touch in the conventional bearing and scarcely in the \
         discrete one.",
        vec![],
    )
    .remark(
        "The photographs show two bearings of different size at four moments each, and their starts are not known: \
         no number of one bearing tests this.",
    )
    .numbers(&format!(
        "here both rings start alike; pairs closer than 0.01° at these moments: conventional {}, discrete {}",
        text(conventional),
        text(discrete)
    ))
}

/// A requirement that a quantity is significantly lower than that of the conventional ring; `what`
/// names that: `fewer contacts`.
fn less(
    rings: &RingComparison,
    speed_rpm: Option<f64>,
    what: &str,
    of: fn(&RingNumbers) -> &Estimate,
) -> Requirement {
    let differences = cells(rings, STRUCTURE_D, speed_rpm).filter_map(|c| c.difference.as_ref());
    let changes: Vec<Change> = differences.map(|d| of(d).change()).collect();
    let count = |change| changes.iter().filter(|c| **c == change).count();
    let (lower, all) = (count(Change::Lower), changes.len());
    let at = speed_rpm.map_or(String::new(), |rpm| format!(" at {rpm} rpm"));
    let sentence = format!(
        "Structure (d) has significantly {what} than a conventional ring with the same balls from \
         the same starts in {lower} of {all} cases{at}, the opposite in {}.",
        count(Change::Higher)
    );
    Requirement::in_all(&format!("cases with significantly {what}{at}"), lower, all)
        .says(&sentence, &sentence)
}

fn spacing(e: &Evidence) -> Claim {
    let rings = &e.comparison;
    let speeds = rings.speeds_rpm().into_iter();
    let criterion = speeds.map(|rpm| {
        less(rings, Some(rpm), "less spread of the gaps", |d| {
            &d.gap_deviation_deg
        })
    });
    let found = cells(rings, FOUND, None).filter_map(|c| c.difference.as_ref());
    let [count, all] = lower(found.map(|d| &d.gap_deviation_deg));
    let [conventional, discrete] = e.bearings.each_ref().map(|b| b.gap_deviation_deg);
    Claim::of_the_model(
        "Sections 5 and 6",
        "The discrete raceway spreads the balls evenly.",
        criterion.collect(),
    )
    .numbers(&format!(
        "{}; significantly less with the raceways found by search: {count} of {all}; the start of \
         Fig. 12: {:.2}° at the start, after 1 s {:.2}° conventional, {:.2}° discrete",
        numbers(rings, "standard deviation of the gaps (°)", |c| c
            .numbers
            .gap_deviation_deg),
        discrete[0],
        conventional[1],
        discrete[1]
    ))
}

fn superiority(e: &Evidence) -> Claim {
    let rings = &e.comparison;
    let [conventional, discrete] = &e.bearings;
    Claim::of_the_model(
        "Section 6",
        "The discrete raceway reduces the collisions between the balls and is superior to \
         conventional bearings.",
        vec![
            less(rings, None, "fewer contacts", |d| &d.contacts_per_s),
            less(rings, None, "less impulse of contacts", |d| {
                &d.impulse_rate_n
            }),
            less(rings, None, "less vibration", |d| &d.rms_m_s2),
        ],
    )
    .remark(&format!(
        "The model leaves out {}.",
        rings.left_out.join(", ")
    ))
    .numbers(&format!(
        "{}; {}; the start of Fig. 12 after the transient: RMS {:.2} m/s² conventional, {:.2} m/s² \
         discrete, {:.0} and {:.0} contacts per second",
        numbers(rings, "contacts per second", |c| c.numbers.contacts_per_s),
        numbers(rings, "RMS (m/s²)", |c| c.numbers.rms_m_s2),
        conventional.rms_m_s2,
        discrete.rms_m_s2,
        conventional.collisions_per_s,
        discrete.collisions_per_s
    ))
}

/// Requirement on one result in steady operation.
struct SteadyRequirement {
    /// Name of the result.
    result: &'static str,
    quantity: &'static str,
    /// Said where it is met.
    met: &'static str,
    /// Said where it is missed.
    missed: &'static str,
}

const IN_STEADY_OPERATION: [SteadyRequirement; 6] = [
    SteadyRequirement {
        result: "contact_rate_hz",
        quantity: "contacts",
        met: "Once the transient has died out, contacts are fewer.",
        missed: "Once the transient has died out, contacts are not fewer.",
    },
    SteadyRequirement {
        result: "gap_deviation_deg",
        quantity: "scatter of the gaps",
        met: "Balls are spread more evenly.",
        missed: "Balls are not spread more evenly.",
    },
    SteadyRequirement {
        result: "outer_ring_force_deviation_n",
        quantity: "variation of the force",
        met: "The force on the outer ring varies less.",
        missed: "The force on the outer ring varies no less.",
    },
    SteadyRequirement {
        result: "vibration_rms_m_s2",
        quantity: "vibration of the housing",
        met: "The housing vibrates less.",
        missed: "The housing vibrates no less.",
    },
    SteadyRequirement {
        result: "ball_pressure_max_mpa",
        quantity: "largest pressure between balls",
        met: "Contacts are softer.",
        missed: "Contacts are harder.",
    },
    SteadyRequirement {
        result: "power_loss_w",
        quantity: "losses",
        met: "The bearing loses less.",
        missed: "The bearing loses more.",
    },
];

/// Superiority in steady operation: draws of real balls, the transient left out.
fn in_steady_operation(e: &Evidence) -> Claim {
    let requirement = |asked: SteadyRequirement| {
        let found = (e.steady.results.iter()).find(|result| result.quantity.name == asked.result);
        let pair = found.and_then(|result| result.values[0].zip(result.values[1]));
        let [ratio, error] = pair.map_or([f64::NAN; 2], |(plain, discrete)| {
            let ratio = plain.mean / discrete.mean;
            let relative = [plain, discrete].map(|of| of.standard_error / of.mean);
            let limit = two_sided_limit(SIGNIFICANCE, discrete.starts.max(2) - 1);
            [ratio, limit * ratio * relative[0].hypot(relative[1])]
        });
        let quantity = format!("{}, conventional over structure (d)", asked.quantity);
        Requirement::above(&quantity, ratio, error, 1.0).says(asked.met, asked.missed)
    };
    Claim::of_the_model(
        "Section 6",
        "In steady operation, the discrete raceway reduces the collisions between the balls and is superior to \
         conventional bearings.",
        IN_STEADY_OPERATION.map(requirement).into(),
    )
    .remark("The runs of half a second above hold the transient from the start.")
    .numbers(&e.steady.statement)
}

/// Contacts in the conventional ring near the ends of the load zone, against chance.
fn transition(e: &Evidence) -> Claim {
    let shares = e.bearings[0].transition_shares;
    let (mut criterion, mut found) = (vec![], vec![]);
    for rpm in e.comparison.speeds_rpm() {
        let equal = cells(&e.comparison, CONVENTIONAL, Some(rpm)).next();
        for (k, part) in TRANSITIONS.into_iter().enumerate() {
            let Some(density) = equal.and_then(|c| c.transition_density[k]) else {
                continue;
            };
            let limit = two_sided_limit(SIGNIFICANCE, density.starts.max(2) - 1);
            let quantity = format!("{rpm} rpm: density of contacts {part} over chance");
            let requirement =
                Requirement::above(&quantity, density.mean, limit * density.standard_error, 1.0);
            criterion.push(requirement.says(
                format!("At {rpm} rpm contacts are more frequent than by chance {part}."),
                format!(
                    "At {rpm} rpm contacts are not clearly more frequent than by chance {part}."
                ),
            ));
            let chance = 100.0 * shares[k][1];
            found.push(format!(
                "{rpm} rpm, {part}: {} × chance, {:.0} % of the contacts where chance gives \
                 {chance:.0} %",
                density.text(),
                density.mean * chance,
            ));
        }
    }
    Claim::of_the_model(
        "Section 4.3, citing [39]",
        "In a conventional bearing balls are more likely to collide in the transition between the \
         loaded and the unloaded zone.",
        criterion,
    )
    .remark(&format!(
        "Equal balls, {TRANSITION_STARTS} starts, the second half of the runs; errors are those of 95 % confidence, and \
         what is within its error of chance is undecided."
    ))
    .numbers(&format!(
        "{}; the start of Fig. 12, transient included: {:.0} % {}, half of the circumference",
        found.join("; "),
        100.0 * shares[0][0],
        TRANSITIONS[0]
    ))
}

/// A quantity of every ring with the first and the last lot of every speed.
fn numbers(rings: &RingComparison, what: &str, of: fn(&ComparisonCell) -> Estimate) -> String {
    let mut parts = vec![];
    for speed_rpm in rings.speeds_rpm() {
        let mut lots: Vec<&str> = rings.at_speed(speed_rpm).map(|c| c.lot.as_str()).collect();
        lots.dedup();
        let ends = [lots.first(), lots.last()];
        for lot in ends.into_iter().flatten() {
            let values: Vec<String> = rings
                .at_speed(speed_rpm)
                .filter(|c| c.lot == **lot)
                .map(|c| format!("{} {}", c.ring, of(c).text()))
                .collect();
            parts.push(format!("{speed_rpm} rpm, {lot}: {}", values.join(", ")));
        }
    }
    format!("{what}: {}", parts.join("; "))
}
