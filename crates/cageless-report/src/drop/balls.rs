//! Figures of the balls and of the heat of a drop.

use cageless::Case;
use cageless_study::Provenance;
use cageless_study::drop::{DropRecord, DropStudy};
use serde_json::json;

use crate::data::Motion;
use crate::figure::Figure;
use crate::motion::MotionFigure;
use crate::plot::{GREY, PALETTE, Plot, numbers};
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

/// Peak load of every ball.
pub(super) fn loads(study: &DropStudy, source: &Provenance) -> Figure {
    let mut plot = Plot::new(380)
        .legend()
        .set("barmode", json!("group"))
        .axis("xaxis", "Ball", json!({ "dtick": 1 }))
        .axis(
            "yaxis",
            "Largest normal force (N)",
            json!({ "rangemode": "tozero" }),
        );
    let mut bars = |name: &str, forces: &[f64], colour: &str| {
        let balls: Vec<usize> = (1..=forces.len()).collect();
        plot = plot.clone().trace(json!({
            "type": "bar", "name": name, "x": balls, "y": numbers(forces),
            "marker": { "color": colour },
        }));
    };
    let own = &study.drop.result;
    bars("inner raceway", own.results.values(INNER), PALETTE[0]);
    bars(
        "outer raceway",
        own.results.values("outer_force_max_of_ball_n"),
        PALETTE[5],
    );
    if let Some(other) = &study.conventional {
        let forces = other.result.results.values(INNER);
        bars("inner raceway, conventional ring", forces, GREY);
    }
    Figure::new(
        "Loads of the balls",
        &format!(
            "Largest normal force of each ball in the whole drop. The largest pressures are {} MPa \
             at the inner and {} MPa at the outer raceway and {} MPa between balls; 4200 MPa is the \
             limit of ISO 76.",
            short(own.results.number("inner_pressure_max_mpa")),
            short(own.results.number("outer_pressure_max_mpa")),
            short(own.results.number("ball_pressure_max_mpa"))
        ),
        source,
        plot,
    )
}

pub(super) fn balls_in_motion(case: &Case, study: &DropStudy, source: &Provenance) -> MotionFigure {
    let mut bearings = vec![motion(
        case,
        "this drop",
        &study.drop.snapshots,
        source.clone(),
    )];
    if let Some(other) = &study.conventional {
        let plain = case.conventional();
        let title = "conventional outer ring";
        bearings.push(motion(&plain, title, &other.snapshots, source.clone()));
    }
    around_first_impact(bearings, &study.drop)
}

/// Bearings in motion, from shortly before the first impact in `drop` on.
pub(super) fn around_first_impact(bearings: Vec<Motion>, drop: &DropRecord) -> MotionFigure {
    let end = drop.outcome.end_s;
    let mut stretches = vec![];
    if let Some(ms) = drop.result.results.value("first_contact_ms") {
        let first = 1e-3 * ms;
        let [before, after] = FIRST_IMPACT_S;
        let around = [(first - before).max(0.0), (first + after).min(end)];
        stretches.push(("first impact".to_owned(), around));
    }
    stretches.push(("whole drop".to_owned(), [0.0, end]));
    MotionFigure {
        label: "Motion of the balls".to_owned(),
        caption: "Rotor, inner ring and balls from the start of the drop, with a \
                  mark on what turns; red: balls that touch. To scale except for the touch-down clearance and the \
                  place of the rotor in it, which are enlarged."
            .to_owned(),
        bearings,
        moments_s: vec![],
        stretches,
    }
}

/// Heat of each interface.
pub(super) fn heat(study: &DropStudy, source: &Provenance) -> Figure {
    let mut plot = Plot::new(420)
        .legend()
        .set("barmode", json!("group"))
        .set("margin", json!({ "l": 190, "r": 24, "t": 44, "b": 58 }))
        .axis("xaxis", "Heat (J)", json!({ "rangemode": "tozero" }))
        .axis("yaxis", "", json!({ "autorange": "reversed" }));
    let drops = [
        ("this drop", Some(&study.drop), PALETTE[1]),
        ("conventional outer ring", study.conventional.as_ref(), GREY),
    ];
    for (name, record, colour) in drops {
        let Some(record) = record else { continue };
        let heat = HEAT.map(|(name, result)| (name, record.result.results.number(result)));
        let (names, values): (Vec<&str>, Vec<f64>) = heat.into_iter().unzip();
        plot = plot.trace(json!({
            "type": "bar", "orientation": "h", "name": name, "y": names, "x": numbers(&values),
            "marker": { "color": colour },
        }));
    }
    Figure::new(
        "Heat of the interfaces",
        &format!(
            "Heat of each interface since the start of the drop. The energy balance closes to {:.1e} of \
             all terms.",
            study.drop.outcome.energy_residual_relative
        ),
        source,
        plot,
    )
}
