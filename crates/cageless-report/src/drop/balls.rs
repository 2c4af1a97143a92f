//! Figures of the balls and of the heat of a drop.

use cageless_study::drop::DropStudy;
use serde_json::json;

use super::bearing::Bearing;
use crate::figure::Figure;
use crate::motion::MotionFigure;
use crate::plot::{GREY, Margin, PALETTE, Plot, numbers};
use crate::run_report::motion;
use crate::text::short;

/// Time before and after the first contact that the animation starts with, s.
const FIRST_IMPACT_S: [f64; 2] = [1e-3, 6e-3];
/// Largest force of each ball at the inner raceway.
const INNER: &str = "inner_force_max_of_ball_n";
/// Heat of each interface.
const HEAT: [(&str, &str); 7] = [
    ("rotor on ring, friction", "rotor_friction_j"),
    ("rotor on ring, damping", "rotor_damping_j"),
    ("inner raceway", "inner_friction_j"),
    ("outer raceway", "outer_friction_j"),
    ("between balls", "ball_friction_j"),
    ("damping of the balls' contacts", "contact_damping_j"),
    ("support", "support_damping_j"),
];

/// Peak load of every ball; with the drop onto a conventional outer ring, if there is one.
pub(super) fn loads(bearing: &Bearing<'_>) -> Figure {
    let mut plot = Plot::new(380)
        .legend()
        .set("barmode", json!("group"))
        .x("Ball", json!({ "dtick": 1 }))
        .y("Largest normal force (N)", json!({ "rangemode": "tozero" }));
    let mut bars = |name: &str, forces: &[f64], colour: &str| {
        let balls: Vec<usize> = (1..=forces.len()).collect();
        plot = plot.clone().trace(json!({
            "type": "bar", "name": name, "x": balls, "y": numbers(forces),
            "marker": { "color": colour },
        }));
    };
    let own = &bearing.record.result.results;
    bars("inner raceway", own.values(INNER), PALETTE[0]);
    let outer = own.values("outer_force_max_of_ball_n");
    bars("outer raceway", outer, PALETTE[5]);
    if let Some(other) = bearing.conventional {
        let forces = other.result.results.values(INNER);
        bars("inner raceway, conventional ring", forces, GREY);
    }
    let caption = format!(
        "Largest normal force of each ball in the whole drop. The largest pressures are {} MPa \
             at the inner and {} MPa at the outer raceway and {} MPa between balls; 4200 MPa is the \
             limit of ISO 76.",
        short(own.number("inner_pressure_max_mpa")),
        short(own.number("outer_pressure_max_mpa")),
        short(own.number("ball_pressure_max_mpa"))
    );
    bearing.figure("Loads of the balls", &caption, plot)
}

/// All bearings in motion, those with conventional outer rings beside them, from shortly before the
/// first impact in the first bearing on.
pub(super) fn balls_in_motion(bearings: &[Bearing<'_>], study: &DropStudy) -> MotionFigure {
    let columns = study.columns("this drop", "conventional outer ring");
    // A conventional outer ring has the provenance of the other.
    let sources = bearings.iter().map(|bearing| &bearing.source).cycle();
    let bearings = (columns.iter().zip(sources)).map(|((name, case, record), source)| {
        motion(case, name, &record.snapshots, source.clone())
    });
    let first = &study.record.bearings[0];
    let end = first.outcome.end_s;
    let mut stretches = vec![];
    if let Some(ms) = first.result.results.value("first_contact_ms") {
        let impact = 1e-3 * ms;
        let [before, after] = FIRST_IMPACT_S;
        let around = [(impact - before).max(0.0), (impact + after).min(end)];
        stretches.push(("first impact".to_owned(), around));
    }
    stretches.push(("whole drop".to_owned(), [0.0, end]));
    let caption = "Rotor, inner ring and balls from the start of the drop, with a mark on what turns; \
                   red: balls that touch. To scale except for the touch-down clearance and the \
                   place of the rotor in it, which are enlarged.";
    MotionFigure {
        stretches,
        ..MotionFigure::new("Motion of the balls", caption, bearings.collect())
    }
}

/// Heat of each interface; with that of the drop onto a conventional outer ring, if there is one.
pub(super) fn heat(bearing: &Bearing<'_>) -> Figure {
    let mut plot = Plot::new(420)
        .legend()
        .set("barmode", json!("group"))
        .margin(Margin {
            left: 190,
            ..Margin::default()
        })
        .x("Heat (J)", json!({ "rangemode": "tozero" }))
        .y("", json!({ "autorange": "reversed" }));
    let drops = [
        ("this drop", Some(bearing.record), PALETTE[1]),
        ("conventional outer ring", bearing.conventional, GREY),
    ];
    for (name, drop, colour) in drops {
        let Some(drop) = drop else { continue };
        let heat = HEAT.map(|(name, result)| (name, drop.result.results.number(result)));
        let (names, values): (Vec<&str>, Vec<f64>) = heat.into_iter().unzip();
        plot = plot.trace(json!({
            "type": "bar", "orientation": "h", "name": name, "y": names, "x": numbers(&values),
            "marker": { "color": colour },
        }));
    }
    let caption = format!(
        "Heat of each interface since the start of the drop. The energy balance closes to {:.1e} of \
             all terms.",
        bearing.record.outcome.energy_residual_relative
    );
    bearing.figure("Heat of the interfaces", &caption, plot)
}
