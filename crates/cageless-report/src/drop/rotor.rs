//! Figures of the rotor in the bore of the inner ring.

use std::f64::consts::TAU;

use cageless::{Case, RotorSnapshot, Shaft, Snapshot};
use cageless_results::WindowRow;
use cageless_study::Provenance;
use cageless_study::drop::BearingRecord;
use serde_json::json;

use crate::figure::Figure;
use crate::plot::{GREY, PALETTE, Plot, Trace, line, line_of, markers};
use crate::sampling::history;
use crate::text::short;

/// Points of a trace over time.
const POINTS: usize = 3000;

fn rotors(snapshots: &[Snapshot]) -> Vec<(f64, RotorSnapshot)> {
    (snapshots.iter())
        .filter_map(|s| Some((1e3 * s.time_s, s.rotor?)))
        .collect()
}

/// Figures of the journal in the inner ring; that of the whirl where there are windows to draw a
/// line through. With the drop onto a conventional outer ring, if there
/// is one, dashed.
pub(super) fn of_rotor(
    case: &Case,
    record: &BearingRecord,
    conventional: Option<&BearingRecord>,
    source: &Provenance,
) -> impl Iterator<Item = Figure> {
    let windows = &record.result.windows;
    let drops = Drops {
        case,
        record,
        conventional,
    };
    let figures = [
        orbit(&drops, source),
        displacement(&drops, source),
        speeds(&rotors(&record.snapshots), source),
        forces(&drops, source),
    ];
    let whirl = (windows.len() > 1).then(|| whirl(&drops, source));
    let along_axis = case.moves_in_space().then(|| along_axis(&drops, source));
    figures.into_iter().chain(whirl).chain(along_axis)
}

/// A drop and that of the same rotor onto a conventional outer ring.
struct Drops<'a> {
    case: &'a Case,
    record: &'a BearingRecord,
    conventional: Option<&'a BearingRecord>,
}

impl Drops<'_> {
    /// Adds a trace of the drop onto a conventional ring to those of the drop.
    fn both(
        &self,
        mut plot: Plot,
        name: &str,
        colour: &str,
        rows: impl Fn(&BearingRecord) -> (Vec<f64>, Vec<f64>),
    ) -> Plot {
        if let Some(other) = self.conventional {
            let name = format!("{name}, conventional ring");
            plot = plot.trace(line_of(&name, rows(other), GREY).dash("dash"));
        }
        plot.trace(line_of(name, rows(self.record), colour))
    }
}

/// Path of the centre of the journal from the centre of the inner ring, or from that of the stator,
/// µm.
fn path_um(case: &Case, snapshots: &[Snapshot], in_ring: bool) -> (Vec<f64>, Vec<f64>) {
    let (mut x, mut y) = (Vec::new(), Vec::new());
    let rotor = case.rotor.as_ref();
    for (s, r, rotor) in snapshots.iter().filter_map(|s| Some((s, s.rotor?, rotor?))) {
        let journal = rotor.journal_m([r.x_m, r.y_m], r.angle_rad);
        let centre = match in_ring {
            true => [s.ring.x_m, s.ring.y_m],
            false => [0.0; 2],
        };
        x.push(1e6 * (journal[0] - centre[0]));
        y.push(1e6 * (journal[1] - centre[1]));
    }
    (x, y)
}

fn circle(name: &str, radius_um: f64, colour: &str) -> Trace {
    let angles: Vec<f64> = (0..=120).map(|k| TAU * f64::from(k) / 120.0).collect();
    let of = |f: fn(f64) -> f64| -> Vec<f64> { angles.iter().map(|a| radius_um * f(*a)).collect() };
    line(name, &of(f64::cos), &of(f64::sin), colour).dash("dot")
}

/// Path of the journal from the centre of the stator, with the circle of its clearance.
fn displacement(drops: &Drops<'_>, source: &Provenance) -> Figure {
    let mut plot = square("x of the journal in the stator (µm)");
    let limit_m = (drops.case.rotor.as_ref()).and_then(|rotor| rotor.clearance_limit_m);
    if let Some(limit_m) = limit_m {
        plot = plot.trace(circle("clearance to the stator", 1e6 * limit_m, PALETTE[3]));
    }
    let plot = drops.both(plot, "centre of the journal", PALETTE[0], |record| {
        path_um(drops.case, &record.snapshots, false)
    });
    let caption = "Centre of the journal from the centre of the stator, that of the housing at rest. A drop \
         fails where it crosses the dotted circle, the clearance that the case gives \
         (rotor.clearance_limit_um).";
    Figure::new("Displacement", caption, source, plot)
}

/// A plot with equal scales of x and y.
fn square(x: &str) -> Plot {
    Plot::new(560)
        .legend()
        .x(x, json!({ "constrain": "domain" }))
        .y(
            "y (µm)",
            json!({ "scaleanchor": "x", "scaleratio": 1, "constrain": "domain" }),
        )
}

/// Path of the journal in the bore, with the circle of the touch-down clearance.
fn orbit(drops: &Drops<'_>, source: &Provenance) -> Figure {
    let case = drops.case;
    let Some(rotor) = &case.rotor else {
        return Figure::new("Orbit", "", source, Plot::new(200));
    };
    let (x, y) = path_um(case, &drops.record.snapshots, true);
    let plot = square("x of the journal in the bore (µm)").trace(circle(
        "touch-down clearance",
        1e6 * rotor.radial_clearance_m,
        GREY,
    ));
    let mut plot = drops.both(plot, "centre of the journal", PALETTE[0], |record| {
        path_um(case, &record.snapshots, true)
    });
    if let (Some(x), Some(y)) = (x.last(), y.last()) {
        plot = plot.trace(markers("end", &[*x], &[*y], PALETTE[1]));
    }
    let caption = "Centre of the journal relative to the centre of the inner ring. Beyond the dotted circle, \
         the touch-down clearance, it is in contact.";
    Figure::new("Orbit", caption, source, plot)
}

/// Time axis in ms.
fn over_time(height: u32, title: &str) -> Plot {
    Plot::new(height)
        .legend()
        .axes("Time since the start of the drop (ms)", title)
}

/// Rows of time and value, thinned.
fn thinned(rows: impl Iterator<Item = (f64, f64)>) -> (Vec<f64>, Vec<f64>) {
    let (x, y): (Vec<f64>, Vec<f64>) = rows.unzip();
    history(&x, &y, POINTS)
}

/// Speeds of rotor and inner ring.
fn speeds(rotors: &[(f64, RotorSnapshot)], source: &Provenance) -> Figure {
    let rpm =
        |f: fn(&RotorSnapshot) -> f64| thinned(rotors.iter().map(|(t, r)| (*t, 60.0 / TAU * f(r))));
    let plot = over_time(380, "Speed (rpm)")
        .trace(line_of("rotor", rpm(|r| r.speed_rad_s), PALETTE[1]))
        .trace(line_of(
            "inner ring",
            rpm(|r| r.ring_speed_rad_s),
            PALETTE[0],
        ));
    let caption = "Speed of the rotor and of the inner ring that it drives by friction, counter-clockwise \
         positive.";
    Figure::new("Spin-up", caption, source, plot)
}

/// Forces of rotor and balls.
fn forces(drops: &Drops<'_>, source: &Provenance) -> Figure {
    let contact = |record: &BearingRecord| {
        let row = |s: &Snapshot| Some((1e3 * s.time_s, s.rotor?.contact_force_n));
        thinned(record.snapshots.iter().filter_map(row))
    };
    let outer = |record: &BearingRecord| {
        let force = |s: &Snapshot| s.ring.outer_force_x_n.hypot(s.ring.outer_force_y_n);
        thinned(record.snapshots.iter().map(|s| (1e3 * s.time_s, force(s))))
    };
    let plot = over_time(400, "Force (N)");
    let plot = drops.both(plot, "balls on the outer ring", PALETTE[2], outer);
    let plot = drops.both(plot, "rotor on the inner ring", PALETTE[0], contact);
    let rotor = drops.case.rotor.as_ref();
    let weight_n = rotor.map_or(0.0, |r| r.mass_kg) * drops.case.operation.gravity_m_s2;
    let caption = format!(
        "Normal force between rotor and inner ring and the force of the balls on the outer \
             ring, at the output interval: peaks between two rows are in the table only. The \
             weight on this bearing is {} N.",
        short(weight_n)
    );
    Figure::new("Forces", &caption, source, plot)
}

/// Motion of rotor and inner ring along the axis, and the force between them.
fn along_axis(drops: &Drops<'_>, source: &Provenance) -> Figure {
    let over_time = |of: fn(&RotorSnapshot, &Snapshot) -> f64| {
        let snapshots = drops.record.snapshots.iter();
        thinned(snapshots.filter_map(|s| Some((1e3 * s.time_s, of(&s.rotor?, s)))))
    };
    let force = over_time(|r, _| r.shoulder_force_n);
    let plot = Plot::new(440)
        .legend()
        .x(
            "Time since the start of the drop (ms)",
            json!({ "anchor": "y2" }),
        )
        .y("z (µm)", json!({ "domain": [0.42, 1.0] }))
        .axis("yaxis2", "Force (N)", json!({ "domain": [0.0, 0.3] }))
        .trace(line_of("rotor", over_time(|r, _| 1e6 * r.z_m), PALETTE[1]))
        .trace(line_of(
            "inner ring",
            over_time(|_, s| 1e6 * s.ring.z_m),
            PALETTE[0],
        ))
        .trace(line_of("shoulder", force, PALETTE[2]).with(json!({ "yaxis": "y2" })));
    let shaft = match drops.case.rotor.as_ref().map(|rotor| rotor.shaft) {
        Some(Shaft::Vertical) => "The shaft is vertical, z upwards.",
        _ => "The shaft is horizontal.",
    };
    let caption = format!(
        "Rotor and inner ring along the axis, and below it the force of the inner ring on a shoulder of the \
         rotor, positive along +z. {shaft}"
    );
    Figure::new("Along the axis", &caption, source, plot)
}

/// Whirl frequency over time.
fn whirl(drops: &Drops<'_>, source: &Provenance) -> Figure {
    let over_windows = |record: &BearingRecord, of: fn(&WindowRow) -> f64| {
        let windows = record.result.windows.iter();
        windows.map(|w| (w.time_ms, of(w))).unzip()
    };
    let contact = over_windows(drops.record, |w| 100.0 * w.contact_fraction);
    let contact = line_of("contact", contact, PALETTE[2]);
    let plot = Plot::new(420)
        .set("showlegend", json!(drops.conventional.is_some()))
        .x(
            "Time since the start of the drop (ms)",
            json!({ "anchor": "y2" }),
        )
        .y("Whirl frequency (Hz)", json!({ "domain": [0.42, 1.0] }))
        .axis(
            "yaxis2",
            "Contact (%)",
            json!({ "domain": [0.0, 0.3], "range": [0, 105] }),
        )
        .horizontal("x", "y", 0.0, "dot");
    let plot = drops.both(plot, "whirl frequency", PALETTE[3], |record| {
        over_windows(record, |w| w.whirl_frequency_hz)
    });
    let plot = plot.trace(contact.with(json!({ "yaxis": "y2" })));
    let caption = "Mean frequency at which the journal moves round the bore, in windows of 5 ms, and the \
         part of each window in contact. A swing at the bottom has alternating signs. Negative: \
         against the rotation of a rotor that turns counter-clockwise.";
    Figure::new("Whirl", caption, source, plot)
}
