//! The ten structures in motion, Fig. 8 and 9.

use cageless_design::PassageStatistics;
use cageless_report::{Claim, Requirement};

use super::evidence::{Evidence, NAMES, largest, least, of_both};
use crate::PUBLISHED;
use crate::structures::Found;

/// Fraction of the theoretical drop of orbital speed from which on it is called reached.
const REACHED: f64 = 0.95;
/// Scatter of the orbital speed over its theoretical drop up to which passages are said to repeat.
const REPEATS: f64 = 0.02;
/// Contacts per passage up to which balls are said not to collide.
const NO_CONTACTS: f64 = 0.05;

pub fn claims(e: &Evidence) -> Vec<Claim> {
    vec![
        low_frequency(e),
        twice(e),
        smooth(e),
        slide(e),
        repeats(e),
        plain_raceway(e),
        speed_drop(e),
    ]
}

fn passages(found: &[Found], of: fn(&PassageStatistics) -> f64) -> Vec<f64> {
    let value = |f: &Found| f.judgement.passages.as_ref().map_or(f64::NAN, of);
    found.iter().map(value).collect()
}

/// Fraction of β0 that sliding takes from the critical gap.
fn losses(found: &[Found]) -> Vec<f64> {
    let published = found.iter().zip(&PUBLISHED);
    published
        .map(|(f, p)| {
            1.0 - f
                .judgement
                .critical_gap_rad
                .unwrap_or(f64::NAN)
                .to_degrees()
                / p.theory_deg
        })
        .collect()
}

fn range(values: &[f64], decimals: usize) -> String {
    let [low, high] = [least(values.to_vec()), largest(values.to_vec())];
    format!("{low:.decimals$} to {high:.decimals$}")
}

/// `label` with a text of both readings.
fn both(e: &Evidence, label: &str, text: impl Fn(&[Found]) -> String) -> String {
    let parts = NAMES.iter().zip(&e.structures);
    let parts: Vec<String> = parts
        .map(|(name, found)| format!("{name} {}", text(found)))
        .collect();
    format!("{label}: {}", parts.join(", "))
}

fn low_frequency(e: &Evidence) -> Claim {
    let contacts = |found: &[Found]| largest(found.iter().map(|f| f.steady.contacts));
    let impact_hz = |found: &[Found]| {
        let durations = found.iter().map(|f| f.steady.contact_duration_s);
        0.5 / largest(durations.filter(|d| !d.is_nan()))
    };
    let mut criterion = of_both(&e.structures, |name, found| {
        let quantity = "contacts per ball and orbit, largest of the ten";
        Requirement::at_most(quantity, contacts(found), 1.0, "").says(
            format!("Contacts are rarer than passages in {name}."),
            format!("Contacts are not rarer than passages in {name}."),
        )
    });
    criterion.extend(of_both(&e.structures, |name, found| {
        let quantity = "frequency 1/(2 T) of contacts of mean duration T over that of ball passing";
        Requirement::at_most(quantity, impact_hz(found) / e.ball_pass_hz, 1.0, "").says(
            format!("A contact is as slow as the passing of balls in {name}."),
            format!("A contact is faster than the passing of balls in {name}: a stiff impact."),
        )
    }));
    Claim::of_the_model(
        "Section 4",
        "The contact between the balls is a low-frequency phenomenon.",
        criterion,
    )
    .remark("Low frequency may mean seldom or slow; both are tested.")
    .numbers(&format!(
        "{}; ball passing {:.0} Hz",
        both(e, "frequency of the longest mean contact", |f| format!(
            "{:.1} kHz ({:.0} µs)",
            1e-3 * impact_hz(f),
            0.5e6 / impact_hz(f)
        )),
        e.ball_pass_hz
    ))
}

fn twice(e: &Evidence) -> Claim {
    let share = |found: &[Found]| passages(&found[0..3], |p| p.double_collision_fraction);
    let mut criterion = of_both(&e.structures, |name, found| {
        let some = share(found).iter().filter(|s| **s > 0.0).count();
        Requirement::in_all("structures with such passages", some, 3).says(
            format!("Such passages occur in each of the three in {name}."),
            format!("Such passages do not occur in each of the three in {name}."),
        )
    });
    criterion.extend(of_both(&e.structures, |name, found| {
        let quantity = "share of passages with both contacts, least of the three";
        Requirement::at_least(quantity, 100.0 * least(share(found)), 50.0, " %").says(
            format!("They are most passages in {name}."),
            format!("They are not the rule in {name}."),
        )
    }));
    Claim::of_the_model(
        "Section 4.3, Fig. 8a–c",
        "In structures (a) to (c) each ball has a double collision per passage.",
        criterion,
    )
    .numbers(&both(e, "share of passages with both contacts", |f| {
        range(&share(f), 2)
    }))
}

fn smooth(e: &Evidence) -> Claim {
    let mean = |found: &[Found]| passages(&found[3..6], |p| p.collisions_mean);
    let double = |found: &[Found]| passages(found, |p| p.double_collision_fraction);
    let mut criterion = of_both(&e.structures, |name, found| {
        let share = double(found);
        let most = largest(share[3..6].to_vec()) / least(share[0..3].to_vec());
        let quantity = "passages with both contacts, most of (d) to (f) over least of (a) to (c)";
        Requirement::at_most(quantity, most, 0.5, "").says(
            format!("Double collisions are at most half as frequent as in (a) to (c) in {name}."),
            format!("Double collisions are more than half as frequent as in (a) to (c) in {name}."),
        )
    });
    criterion.extend(of_both(&e.structures, |name, found| {
        let quantity = "contacts per passage, most of the three";
        Requirement::at_most(quantity, largest(mean(found)), NO_CONTACTS, "").says(
            format!("They do not collide in {name}."),
            format!("Neighbours do touch in {name}."),
        )
    }));
    Claim::of_the_model(
        "Section 4.3, Fig. 8d–f",
        "In structures (d) to (f) the balls pass smoothly and do not collide.",
        criterion,
    )
    .numbers(&both(e, "contacts per passage", |f| range(&mean(f), 2)))
}

fn slide(e: &Evidence) -> Claim {
    let slip = |found: &[Found]| passages(found, |p| p.sliding_mean_m_s);
    let apart = |values: &[f64]| least(values[6..].to_vec()) / largest(values[3..6].to_vec());
    let mut criterion = of_both(&e.structures, |name, found| {
        let quantity = "sliding speed, least of (g) to (j) over most of (d) to (f)";
        Requirement::at_least(quantity, apart(&slip(found)), 1.0, "").says(
            format!("Each slides more than any of (d) to (f) in {name}."),
            format!("Not each slides more than any of (d) to (f) in {name}."),
        )
    });
    criterion.extend(of_both(&e.structures, |name, found| {
        let quantity = "loss of critical gap, least of (g) to (j) over most of (d) to (f)";
        Requirement::at_least(quantity, apart(&losses(found)), 1.0, "").says(
            format!("Each loses more of the critical gap in {name}."),
            format!("Not each loses more of the critical gap in {name}."),
        )
    }));
    Claim::of_the_model(
        "Section 4.3, Fig. 8g–j",
        "In structures (g) to (j) the balls slide, and are separated less.",
        criterion,
    )
    .numbers(&format!(
        "{}; {}",
        both(
            e,
            "largest sliding speed in a passage (m/s), (g) to (j)",
            |f| range(&slip(&f[6..]), 2)
        ),
        both(e, "loss of critical gap, (g) to (j)", |f| range(
            &losses(f)[6..],
            2
        ))
    ))
}

fn repeats(e: &Evidence) -> Claim {
    let scatter =
        |found: &[Found]| -> Vec<f64> { found.iter().map(|f| f.steady.speed_scatter).collect() };
    let mut criterion = of_both(&e.structures, |name, found| {
        let quantity = "scatter of the orbital speed over its drop, least of (g) and (h)";
        Requirement::at_least(quantity, least(scatter(&found[6..8])), REPEATS, "").says(
            format!("In (g) and (h) passages differ in {name}."),
            format!("In (g) and (h) passages repeat as well in {name}."),
        )
    });
    criterion.extend(of_both(&e.structures, |name, found| {
        let quantity = "scatter of the orbital speed over its drop, most of (i) and (j)";
        Requirement::at_most(quantity, largest(scatter(&found[8..])), REPEATS, "").says(
            format!("In (i) and (j) they repeat in {name}."),
            format!("In (i) and (j) they differ in {name}."),
        )
    }));
    Claim::of_the_model(
        "Section 4.3, Fig. 8g–j",
        "The speed of a ball in the raceway is chaotic in (g) and (h) and periodic in (i) and (j).",
        criterion,
    )
    .remark("All balls at every place in the raceway over six orbits, balls evenly spaced at the start.")
    .numbers(&both(e, "scatter over the drop, (a) to (j)", |found| {
        let each: Vec<String> = scatter(found).iter().map(|s| format!("{s:.3}")).collect();
        each.join(" ")
    }))
}

fn plain_raceway(e: &Evidence) -> Claim {
    let outside = |f: &Found| f.steady.contacts_outside;
    Claim::of_the_model(
        "Section 4.3, Fig. 8",
        "In the conventional part of the raceway the tracks are smooth: balls do not collide there.",
        of_both(&e.structures, |name, found| {
            let none = found.iter().filter(|f| outside(f) == 0.0).count();
            let quantity = "structures without a contact of two balls outside the raceway";
            Requirement::in_all(quantity, none, found.len())
            .says(
format!("No contact occurs there in {name}."),
format!("Contacts occur there in {name}."))
        }),
    )
    .remark("Balls are evenly spaced at the start, 16 of 32 orbits are counted.")
    .numbers(&both(e, "contacts there per ball and orbit", |found| {
        range(&found.iter().map(outside).collect::<Vec<f64>>(), 2)
    }))
}

fn speed_drop(e: &Evidence) -> Claim {
    let drop = |found: &[Found]| passages(found, |p| p.speed_drop_fraction);
    let mut criterion = of_both(&e.structures, |name, found| {
        let short = drop(&found[6..]).iter().filter(|d| **d < REACHED).count();
        let quantity = format!("structures (g) to (j) that reach less than {REACHED} of the drop");
        Requirement::in_all(&quantity, short, 4).says(
            format!("All of (g) to (j) fall short in {name}."),
            format!("Not all of (g) to (j) fall short in {name}."),
        )
    });
    criterion.extend(of_both(&e.structures, |name, found| {
        let full = drop(&found[..6]).iter().filter(|d| **d >= REACHED).count();
        let quantity = format!("structures (a) to (f) that reach {REACHED} of it");
        Requirement::in_all(&quantity, full, 6).says(
            format!("All of (a) to (f) reach it in {name}."),
            format!("Not all of (a) to (f) reach it in {name}."),
        )
    }));
    Claim::of_the_model(
        "Section 4.3, Fig. 9",
        "Below θ = 22° the orbital speed does not reach its theoretical value in the raceway.",
        criterion,
    )
    .numbers(&both(
        e,
        "fraction of the theoretical drop reached, (g) to (j)",
        |f| {
            let each = drop(&f[6..]);
            let each: Vec<String> = each.iter().map(|d| format!("{d:.2}")).collect();
            each.join(" ")
        },
    ))
}
