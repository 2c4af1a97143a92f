//! Figures of the rotor in the bore of the inner ring.

use std::f64::consts::TAU;

use cageless::simulation::PlaneDisplacement;
use cageless::{Case, RotorSnapshot, Shaft, Snapshot};
use cageless_results::{Provenance, WindowRow};
use cageless_study::drop::BearingRecord;
use serde_json::{Value, json};

use super::bearing::Bearing;
use crate::figure::Figure;
use crate::figures::panels::{Panel, Space};
use crate::length::um;
use crate::plot::{Axes, GREY, PALETTE, Plot, Trace, line, line_of, markers, with};
use crate::sampling::{Points, history, range};
use crate::text::short;

/// Points of a trace over time.
const POINTS: usize = 3000;

/// Figures of the journal in the inner ring; that of the whirl where there are windows to draw a
/// line through. With the drop onto a conventional outer ring, if there
/// is one, dashed.
pub(super) fn of_rotor(bearing: &Bearing<'_>) -> impl Iterator<Item = Figure> {
    let figures = [orbit(bearing), speeds(bearing), forces(bearing)];
    let whirl = (bearing.record.result.windows.len() > 1).then(|| whirl(bearing));
    let along_axis = moves_along_axis(bearing).then(|| along_axis(bearing));
    figures.into_iter().chain(whirl).chain(along_axis)
}

/// Adds a trace of the drop and one of that onto a conventional ring.
fn both(
    bearing: &Bearing<'_>,
    mut plot: Plot,
    name: &str,
    colour: &str,
    rows: impl Fn(&BearingRecord) -> Points,
) -> Plot {
    if let Some(other) = bearing.conventional {
        let name = format!("{name}, conventional ring");
        plot = plot.trace(line_of(&name, rows(other), GREY).dash("dash"));
    }
    plot.trace(line_of(name, rows(bearing.record), colour))
}

/// Path of the centre of the journal from the centre of the inner ring, or from that of the stator,
/// µm.
fn path_um(case: &Case, snapshots: &[Snapshot], in_ring: bool) -> Points {
    let rotor = case.rotor.as_ref();
    let place = |s: &Snapshot| {
        let (rotor, r) = (rotor?, s.rotor?);
        let journal = rotor.journal_m([r.x_m, r.y_m], r.angle_rad);
        let centre = match in_ring {
            true => [s.ring.x_m, s.ring.y_m],
            false => [0.0; 2],
        };
        Some((um(journal[0] - centre[0]), um(journal[1] - centre[1])))
    };
    snapshots.iter().filter_map(place).collect()
}

fn circle(name: &str, radius_um: f64, colour: &str) -> Trace {
    let angles: Vec<f64> = (0..=120).map(|k| TAU * f64::from(k) / 120.0).collect();
    let of = |f: fn(f64) -> f64| -> Vec<f64> { angles.iter().map(|a| radius_um * f(*a)).collect() };
    line(name, &of(f64::cos), &of(f64::sin), colour).dash("dot")
}

/// Ranges of x and y of a square with some room around all paths.
fn square(paths: &[Points]) -> [[f64; 2]; 2] {
    let of = |values: fn(&Points) -> &Vec<f64>| {
        let all: Vec<f64> = paths.iter().flat_map(values).copied().collect();
        range(&all)
    };
    let spans = [of(|points| &points.x), of(|points| &points.y)];
    let widest = spans
        .iter()
        .map(|(low, high)| high - low)
        .fold(1.0, f64::max);
    let half = 0.54 * widest;
    spans.map(|(low, high)| [(low + high) / 2.0 - half, (low + high) / 2.0 + half])
}

/// Path of the journal, with the circle of a clearance, on equal scales of x and y.
fn path(bearing: &Bearing<'_>, x: &str, in_ring: bool, clearance: Option<Trace>) -> Plot {
    let mut axes = [
        json!({ "constrain": "domain" }),
        json!({ "scaleanchor": "x", "scaleratio": 1, "constrain": "domain" }),
    ];
    if clearance.is_none() {
        let records = [Some(bearing.record), bearing.conventional];
        let paths = records.into_iter().flatten();
        let paths = paths.map(|record| path_um(bearing.case, &record.snapshots, in_ring));
        let ranges = square(&paths.collect::<Vec<_>>());
        for (axis, range) in axes.iter_mut().zip(ranges) {
            axis["range"] = json!(range);
        }
    }
    let [across, up] = axes;
    let plot = Plot::new(560).legend().x(x, across).y("y (µm)", up);
    let plot = clearance.into_iter().fold(plot, Plot::trace);
    both(
        bearing,
        plot,
        "centre of the journal",
        PALETTE[0],
        |record| path_um(bearing.case, &record.snapshots, in_ring),
    )
}

/// Paths of a rotor in its planes, each with the circle of its clearance; `None` without planes.
pub(super) fn planes(planes: &[PlaneDisplacement], source: &Provenance) -> Option<Figure> {
    let columns = planes.len().min(2);
    let rows = planes.len().div_ceil(columns.max(1)) as u32;
    let space = Space {
        across: 0.12,
        down: 0.2,
    };
    let panels = Panel::grid(planes.len(), columns, space);
    let mut plot = Plot::new(60 + 400 * rows).legend();
    for (panel, plane) in panels.iter().zip(planes) {
        let name = plane.clearance.name.as_str();
        let Axes { x, y } = panel.axes();
        let scale = json!({ "scaleanchor": y, "constrain": "domain" });
        let titles = [format!("x at {name} (µm)"), "y (µm)".to_owned()];
        let more = [scale, json!({ "constrain": "domain" })];
        plot = plot.panel(panel, titles.each_ref().map(String::as_str), more);
        let of = |k: usize| -> Vec<f64> {
            let points = plane.path_m.iter();
            points.map(|point| um(point[k])).collect()
        };
        let axes =
            |trace: Trace| trace.with(json!({ "xaxis": x, "yaxis": y, "showlegend": panel.first }));
        let clearance = circle("clearance", um(plane.clearance.radial_m), PALETTE[3]);
        let [farthest_x, farthest_y] = plane.farthest_m.map(um);
        let farthest = markers(
            "largest displacement",
            &[farthest_x],
            &[farthest_y],
            PALETTE[1],
        );
        plot = plot
            .trace(axes(clearance))
            .trace(axes(line("axis of the rotor", &of(0), &of(1), PALETTE[0])))
            .trace(axes(farthest));
    }
    let caption = "Axis of the rotor from the centre of the stator in each plane with a clearance. The rotor \
                   touches the stator where its axis crosses the dotted circle.";
    let label = "Displacement at the clearances";
    (!planes.is_empty()).then(|| Figure::new(label, caption, source, plot))
}

/// Whether the case gives a clearance to the stator.
pub(super) fn has_clearance(bearing: &Bearing<'_>) -> bool {
    let rotor = bearing.case.rotor.as_ref();
    rotor.is_some_and(|rotor| rotor.clearance_limit_m.is_some())
}

/// Path of the journal from the centre of the stator, with the circle of its clearance.
pub(super) fn displacement(bearing: &Bearing<'_>) -> Figure {
    let limit_m = (bearing.case.rotor.as_ref()).and_then(|rotor| rotor.clearance_limit_m);
    let clearance = limit_m.map(|m| circle("clearance to the stator", um(m), PALETTE[3]));
    let plot = path(
        bearing,
        "x of the journal in the stator (µm)",
        false,
        clearance,
    );
    let rule = match limit_m {
        Some(_) => {
            " A drop fails where it crosses the dotted circle, the clearance that the case gives \
             (rotor.clearance_limit_um)."
        }
        None => " The case gives no clearance to the stator (rotor.clearance_limit_um).",
    };
    let centre =
        "Centre of the journal from the centre of the stator, that of the housing at rest.";
    bearing.figure("Displacement", &format!("{centre}{rule}"), plot)
}

/// Path of the journal in the bore, with the circle of the touch-down clearance.
fn orbit(bearing: &Bearing<'_>) -> Figure {
    let clearance_m = bearing
        .case
        .rotor
        .as_ref()
        .map(|rotor| rotor.radial_clearance_m);
    let clearance = clearance_m.map(|m| circle("touch-down clearance", um(m), GREY));
    let mut plot = path(
        bearing,
        "x of the journal in the bore (µm)",
        true,
        clearance,
    );
    let Points { x, y } = path_um(bearing.case, &bearing.record.snapshots, true);
    if let (Some(x), Some(y)) = (x.last(), y.last()) {
        plot = plot.trace(markers("end", &[*x], &[*y], PALETTE[1]));
    }
    let caption = "Centre of the journal relative to the centre of the inner ring. Beyond the dotted circle, \
         the touch-down clearance, it is in contact.";
    bearing.figure("Orbit", caption, plot)
}

/// Time axis in ms.
fn over_time(height: u32, title: &str) -> Plot {
    Plot::new(height)
        .legend()
        .axes("Time since the start of the drop (ms)", title)
}

/// Two panels over time, titled `above` and `below`, with further keys of the lower axis.
fn two_over_time(height: u32, above: &str, below: &str, more: Value) -> Plot {
    let along = json!({ "anchor": "y2" });
    Plot::new(height)
        .x("Time since the start of the drop (ms)", along)
        .y(above, json!({ "domain": [0.42, 1.0] }))
        .axis("yaxis2", below, with(json!({ "domain": [0.0, 0.3] }), more))
}

/// Time in ms and a value of the snapshots that have it, thinned.
fn thinned(record: &BearingRecord, value: impl Fn(&Snapshot) -> Option<f64>) -> Points {
    let rows = (record.snapshots.iter()).filter_map(|s| Some((1e3 * s.time_s, value(s)?)));
    let Points { x, y } = rows.collect();
    history(&x, &y, POINTS)
}

/// Speeds of rotor and inner ring.
fn speeds(bearing: &Bearing<'_>) -> Figure {
    let rpm = |f: fn(&RotorSnapshot) -> f64| {
        thinned(bearing.record, |s| Some(60.0 / TAU * f(s.rotor.as_ref()?)))
    };
    let plot = over_time(380, "Speed (rpm)")
        .trace(line_of("rotor", rpm(|r| r.speed_rad_s), PALETTE[1]))
        .trace(line_of(
            "inner ring",
            rpm(|r| r.ring_speed_rad_s),
            PALETTE[0],
        ));
    let caption = "Speed of the rotor and of the inner ring that it drives by friction, counter-clockwise \
         positive.";
    bearing.figure("Spin-up", caption, plot)
}

/// Forces of rotor and balls.
fn forces(bearing: &Bearing<'_>) -> Figure {
    let contact = |record: &BearingRecord| {
        thinned(record, |s| {
            s.rotor.map(|r| r.contact_force_n.hypot(r.shoulder_force_n))
        })
    };
    let outer = |record: &BearingRecord| {
        let force = |s: &Snapshot| s.ring.outer_force_x_n.hypot(s.ring.outer_force_y_n);
        thinned(record, |s| Some(force(s)))
    };
    let plot = over_time(400, "Force (N)");
    let plot = both(bearing, plot, "balls on the outer ring", PALETTE[2], outer);
    let plot = both(
        bearing,
        plot,
        "rotor on the inner ring",
        PALETTE[0],
        contact,
    );
    let rotor = bearing.case.rotor.as_ref();
    let weight_n = rotor.map_or(0.0, |r| r.mass_kg) * bearing.case.operation.gravity_m_s2;
    let caption = format!(
        "Normal force between rotor and inner ring and the force of the balls on the outer \
             ring, at the output interval: peaks between two rows are in the table only. The \
             weight on this bearing is {} N.",
        short(weight_n)
    );
    bearing.figure("Forces", &caption, plot)
}

/// Motion along the axis that is none, m.
const STILL_M: f64 = 1e-9;

/// Whether rotor or inner ring move along the axis by more than what rounding leaves.
fn moves_along_axis(bearing: &Bearing<'_>) -> bool {
    let ways = |of: fn(&RotorSnapshot, &Snapshot) -> f64| {
        let rows = bearing.record.snapshots.iter();
        let places = rows.filter_map(|s| Some(of(s.rotor.as_ref()?, s)));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| {
            (low.min(z), high.max(z))
        });
        high - low > STILL_M
    };
    bearing.case.moves_in_space() && (ways(|r, _| r.z_m) || ways(|_, s| s.ring.z_m))
}

/// Motion of rotor and inner ring along the axis, and the force between them.
fn along_axis(bearing: &Bearing<'_>) -> Figure {
    let over_time = |of: fn(&RotorSnapshot, &Snapshot) -> f64| {
        thinned(bearing.record, |s| Some(of(&s.rotor?, s)))
    };
    let force = over_time(|r, _| r.shoulder_force_n);
    let plot = two_over_time(440, "z (µm)", "Force (N)", json!({}))
        .legend()
        .trace(line_of("rotor", over_time(|r, _| um(r.z_m)), PALETTE[1]))
        .trace(line_of(
            "inner ring",
            over_time(|_, s| um(s.ring.z_m)),
            PALETTE[0],
        ))
        .trace(line_of("shoulder", force, PALETTE[2]).with(json!({ "yaxis": "y2" })));
    let shaft = match bearing.case.rotor.as_ref().map(|rotor| rotor.shaft) {
        Some(Shaft::Vertical) => "The shaft is vertical, z upwards.",
        _ => "The shaft is horizontal.",
    };
    let caption = format!(
        "Rotor and inner ring along the axis, and below it the force of the inner ring on a shoulder of the \
         rotor, positive along +z. {shaft}"
    );
    bearing.figure("Along the axis", &caption, plot)
}

/// Whirl frequency over time.
fn whirl(bearing: &Bearing<'_>) -> Figure {
    let over_windows = |record: &BearingRecord, of: fn(&WindowRow) -> f64| -> Points {
        let windows = record.result.windows.iter();
        windows.map(|w| (w.time_ms, of(w))).collect()
    };
    let contact = over_windows(bearing.record, |w| 100.0 * w.contact_fraction);
    let contact = line_of("contact", contact, PALETTE[2]);
    let percent = json!({ "range": [0, 105] });
    let plot = two_over_time(420, "Whirl frequency (Hz)", "Contact (%)", percent)
        .set("showlegend", json!(bearing.conventional.is_some()))
        .horizontal("x", "y", 0.0, "dot");
    let plot = both(bearing, plot, "whirl frequency", PALETTE[3], |record| {
        over_windows(record, |w| w.whirl_frequency_hz)
    });
    let plot = plot.trace(contact.with(json!({ "yaxis": "y2" })));
    let caption = "Mean frequency at which the journal moves round the bore, in windows of 5 ms, and the \
         part of each window in contact. A swing at the bottom has alternating signs. Negative: \
         against the rotation of a rotor that turns counter-clockwise.";
    bearing.figure("Whirl", caption, plot)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_has_a_square_with_room_around_it() {
        let paths = [
            Points {
                x: vec![-180.0, 25.0],
                y: vec![-290.0, 10.0],
            },
            Points {
                x: vec![0.0, 40.0],
                y: vec![-100.0, -50.0],
            },
        ];
        let [[left, right], [bottom, top]] = square(&paths);
        assert!((right - left - (top - bottom)).abs() < 1e-9);
        assert!(left < -180.0 && right > 40.0 && bottom < -290.0 && top > 10.0);
    }
}
