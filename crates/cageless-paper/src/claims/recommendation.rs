//! The classes of the ten structures and the recommended range of 2θ.

use cageless_design::{Judgement, RacewayVerdict, StartingPoint};
use cageless_report::{Claim, Requirement};

use super::evidence::{Evidence, NAMES, largest, of_both};
use super::theory::ROUNDING_DEG;
use crate::PUBLISHED;
use crate::structures::{Between, Found, Steady};

pub fn claims(e: &Evidence) -> Vec<Claim> {
    vec![
        classes(e),
        three_balls(e),
        recommended(e),
        least_angle(e),
        spread_outside(e),
    ]
}

fn letters(found: &[Found]) -> String {
    let names = found.iter().zip(&PUBLISHED);
    let names: Vec<String> = names
        .map(|(f, p)| format!("({}) {}", p.letter, f.judgement.verdict.label()))
        .collect();
    names.join(", ")
}

/// Verdict by the paper's limits of 2θ: two contacts from 2(ε + β0) on, sliding below the least.
pub fn by_span(
    half_of_three_balls_deg: f64,
    span_min_deg: f64,
    half_angle_deg: f64,
) -> RacewayVerdict {
    if half_angle_deg >= half_of_three_balls_deg {
        RacewayVerdict::DoubleCollision
    } else if 2.0 * half_angle_deg >= span_min_deg {
        RacewayVerdict::Smooth
    } else {
        RacewayVerdict::Slips
    }
}

fn classes(e: &Evidence) -> Claim {
    let as_published = |found: &[Found]| {
        let pairs = found.iter().zip(&PUBLISHED);
        pairs
            .filter(|(f, p)| f.judgement.verdict.name() == p.verdict)
            .count()
    };
    let [paper, physical] = &e.structures;
    let prediction = |b: &Between| {
        by_span(
            e.mechanics.spacing_deg,
            e.printed.span_min_deg,
            b.half_angle_deg,
        )
    };
    let predicted = |b: &&Between| b.judgement.verdict == prediction(b);
    let between: Vec<String> = e.between.iter().map(|b| midway(b, prediction(b))).collect();
    Claim::of_the_model(
        "Section 4.3",
        "(a)–(c) have double collisions, (d)–(f) are reasonable, (g)–(j) slide: by 2θ from 2(ε + β0) on, \
         down to 44°, below.",
        vec![
            Requirement::in_all(
                "`paper`: structures midway between the ten with the verdict that their 2θ predicts",
                e.between.iter().filter(predicted).count(),
                e.between.len(),
            )
            .says(
"The limits of 2θ predict the verdicts on structures to which nothing was fitted.",
"The limits of 2θ do not predict all verdicts on structures to which nothing was fitted."),
            Requirement::in_all(
                "`physical`: the ten structures with the paper's verdict",
                as_published(physical),
                physical.len(),
            )
            .says(
"The same thresholds give the paper's classes in `physical`, too.",
"The same thresholds do not give all of the paper's classes in `physical`."),
        ],
    )
    .remark(
        "The thresholds of a verdict (double collisions in a quarter of the passages, 5 % of the \
         critical gap lost to sliding) were fitted to the ten structures in `paper`; their \
         agreement there confirms nothing.",
    )
    .numbers(&format!(
        "midway, `paper`: {}; fitted, `paper`: {} of {}; `physical`: {}",
        between.join("; "),
        as_published(paper),
        paper.len(),
        letters(physical)
    ))
}

/// Verdict on a structure midway between two of the ten, with the prediction where that is another.
fn midway(b: &Between, prediction: RacewayVerdict) -> String {
    let Judgement { verdict, .. } = b.judgement;
    let other = if verdict == prediction {
        String::new()
    } else {
        format!(" (2θ predicts {})", prediction.label())
    };
    format!(
        "lC {:.2} mm, 2θ {:.1}°: {}{other}",
        b.axial_span_mm,
        2.0 * b.half_angle_deg,
        verdict.label()
    )
}

fn three_balls(e: &Evidence) -> Claim {
    let m = &e.mechanics;
    let printed = e.printed.three_balls_deg;
    let quantity = "difference from twice 360°/N, which ε + β0 is";
    let value = (2.0 * m.spacing_deg - printed).abs();
    let criterion = Requirement::at_most(quantity, value, 100.0 * ROUNDING_DEG, "°")
        .says("It is.", "The paper's own ε and β0 give another value.");
    Claim::as_printed(
        "Section 4.3",
        &format!("2(ε + β0) = {printed:.2}°."),
        vec![criterion],
    )
    .numbers(&format!(
        "2 × ({:.2}° + {:.4}°) = {:.2}°",
        m.epsilon_deg,
        m.spacing_deg - m.epsilon_deg,
        2.0 * m.spacing_deg
    ))
}

fn recommended(e: &Evidence) -> Claim {
    let (low, sample) = (e.printed.span_min_deg, e.printed.sample_span_deg);
    let high = 2.0 * e.mechanics.epsilon_deg;
    let outside = (sample - high).max(low - sample);
    let quantity = "distance of the sample's 2θ from the range";
    let criterion = Requirement::at_most(quantity, outside.max(0.0), 0.0, "°").says(
        "The sample lies in the range.",
        "The paper's own sample lies outside the range.",
    );
    Claim::as_printed(
        "Sections 4.3, 5, 6",
        &format!("2θ should lie in [{low}°, 2ε]."),
        vec![criterion],
    )
    .remark("Three touching balls fit in from 2ε on, three evenly spaced ones from 2(ε + β0) on.")
    .numbers(&format!(
        "sample 2θ = {sample}°, 2ε = {high:.1}°, 2(ε + β0) = {:.2}°",
        2.0 * e.mechanics.spacing_deg
    ))
}

fn least_angle(e: &Evidence) -> Claim {
    let printed = e.printed.span_min_deg;
    let text = |r: &Option<StartingPoint>| {
        r.map_or("none".to_owned(), |r| {
            format!(
                "2θ in [{:.1}°, {:.1}°], middle lC {:.2} mm, θ {:.1}°",
                2.0 * r.half_angle_min_rad.to_degrees(),
                2.0 * r.half_angle_max_rad.to_degrees(),
                r.axial_span_m * 1e3,
                r.half_angle_rad.to_degrees()
            )
        })
    };
    let pairs = NAMES.iter().zip(&e.extra.starting_points);
    let criterion = pairs
        .map(|(name, found)| {
            let least = found.map_or(f64::NAN, |f| 2.0 * f.half_angle_min_rad.to_degrees());
            let size = if least < printed { "smaller" } else { "larger" };
            let quantity =
                format!("{name}: difference of the 2θ at which sliding takes 5 % of the gap");
            Requirement::at_most(&quantity, (least - printed).abs(), 1.0, "°").says(
                format!("They do in {name}."),
                format!("In {name} they slide from another angle on, a {size} one."),
            )
        })
        .collect();
    Claim::of_the_model(
        "Section 4.3",
        &format!("Balls slide below 2θ = {printed}°."),
        criterion,
    )
    .remark("The 5 % were fitted to the ten structures in `paper`.")
    .numbers(&format!(
        "usable: `paper` {}; `physical` {}",
        text(&e.extra.starting_points[0]),
        text(&e.extra.starting_points[1])
    ))
}

fn spread_outside(e: &Evidence) -> Claim {
    // Of the ten, those with 2θ in the range: (e) and (f).
    let inside_range = |found: &[Found]| -> Vec<Steady> {
        let pairs = found.iter().zip(&PUBLISHED);
        let span = |p: &crate::Published| 2.0 * p.half_angle_deg;
        let range = e.printed.span_min_deg..=2.0 * e.mechanics.epsilon_deg;
        pairs
            .filter(|(_, p)| range.contains(&span(p)))
            .map(|(f, _)| f.steady)
            .collect()
    };
    let beta0 = e.printed.nominal_gap_deg;
    let inside =
        |found: &[Found]| largest(inside_range(found).iter().map(|s| s.gap_inside_mean_deg));
    let outside = |found: &[Found]| {
        largest(
            inside_range(found)
                .iter()
                .map(|s| s.gap_outside_deviation_deg),
        )
    };
    let mut criterion = of_both(&e.structures, |name, found| {
        let quantity = "mean gap of balls inside the raceway";
        Requirement::at_most(quantity, inside(found), beta0, "°").says(
            format!("The gap inside is smaller than β0 in {name}."),
            format!("The gap inside is not smaller than β0 in {name}."),
        )
    });
    criterion.extend(of_both(&e.structures, |name, found| {
        let quantity = "standard deviation of the gaps outside";
        Requirement::at_most(quantity, outside(found), e.printed.neglected_deg, "°").says(
            format!("Balls outside are evenly spaced in {name}."),
            format!(
                "Balls outside are not evenly spaced in {name}, though they were at the start."
            ),
        )
    }));
    Claim::of_the_model(
        "Section 6",
        "With 2θ in [44°, 2ε] a few balls inside the raceway have gaps below β0, while all balls \
         outside are uniformly distributed.",
        criterion,
    )
    .remark("Structures (e) and (f), balls evenly spaced at the start.")
}
