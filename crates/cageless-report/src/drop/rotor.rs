//! Figures of the rotor in the bore of the inner ring.

use std::f64::consts::TAU;

use cageless::{Case, RotorSnapshot, Snapshot};
use cageless_study::Provenance;
use cageless_study::drop::{DropRecord, WindowRow};
use serde_json::json;

use super::figure;
use crate::figure::Figure;
use crate::plot::{GREY, PALETTE, Plot, line, markers, with};
use crate::sampling::history;

/// Points of a trace over time.
const POINTS: usize = 3000;

fn rotors(snapshots: &[Snapshot]) -> Vec<(f64, RotorSnapshot)> {
    (snapshots.iter())
        .filter_map(|s| Some((1e3 * s.time_s, s.rotor?)))
        .collect()
}

/// Figures of the journal in the inner ring; that of the whirl where there are windows to draw a
/// line through.
pub(super) fn of_rotor(
    case: &Case,
    record: &DropRecord,
    source: &Provenance,
) -> impl Iterator<Item = Figure> {
    let (snapshots, windows) = (&record.snapshots, &record.result.windows);
    let figures = [
        orbit(case, snapshots, source),
        speeds(&rotors(snapshots), source),
        forces(case, snapshots, source),
    ];
    let whirl = (windows.len() > 1).then(|| whirl(windows, source));
    figures.into_iter().chain(whirl)
}

/// Path of the journal in the bore, with the circle of the air gap.
fn orbit(case: &Case, snapshots: &[Snapshot], source: &Provenance) -> Figure {
    let Some(rotor) = &case.rotor else {
        return figure("Orbit", "", source, Plot::new(200));
    };
    let (mut x, mut y) = (Vec::new(), Vec::new());
    for s in snapshots {
        let Some(r) = s.rotor else { continue };
        let (sin, cos) = (r.angle_rad + rotor.eccentricity_phase_rad).sin_cos();
        x.push(1e6 * (r.x_m - rotor.eccentricity_m * cos - s.ring.x_m));
        y.push(1e6 * (r.y_m - rotor.eccentricity_m * sin - s.ring.y_m));
    }
    let gap = 1e6 * rotor.air_gap_m;
    let circle: Vec<f64> = (0..=120).map(|k| TAU * f64::from(k) / 120.0).collect();
    let of = |f: fn(f64) -> f64| -> Vec<f64> { circle.iter().map(|a| gap * f(*a)).collect() };
    let last = x.len().saturating_sub(1);
    let mut plot = Plot::new(560)
        .legend()
        .axis(
            "xaxis",
            "x of the journal in the bore (µm)",
            json!({ "constrain": "domain" }),
        )
        .axis(
            "yaxis",
            "y (µm)",
            json!({ "scaleanchor": "x", "scaleratio": 1, "constrain": "domain" }),
        )
        .trace(with(
            line("air gap", &of(f64::cos), &of(f64::sin), GREY),
            json!({ "line": { "dash": "dot" } }),
        ))
        .trace(line("centre of the journal", &x, &y, PALETTE[0]));
    if let (Some(x), Some(y)) = (x.get(last), y.get(last)) {
        plot = plot.trace(markers("end", &[*x], &[*y], PALETTE[1]));
    }
    figure(
        "Orbit",
        "Centre of the journal relative to the centre of the inner ring. Beyond the dotted circle, \
         the air gap, it is in contact.",
        source,
        plot,
    )
}

/// Time axis in ms.
fn over_time(height: u32, title: &str) -> Plot {
    Plot::new(height)
        .legend()
        .axis("xaxis", "Time since the magnets let go (ms)", json!({}))
        .axis("yaxis", title, json!({}))
}

fn trace(name: &str, rows: &[(f64, f64)], colour: &str) -> serde_json::Value {
    let (x, y): (Vec<f64>, Vec<f64>) = rows.iter().copied().unzip();
    let (x, y) = history(&x, &y, POINTS);
    line(name, &x, &y, colour)
}

/// Speeds of rotor and inner ring.
fn speeds(rotors: &[(f64, RotorSnapshot)], source: &Provenance) -> Figure {
    let of = |f: fn(&RotorSnapshot) -> f64| -> Vec<(f64, f64)> {
        rotors
            .iter()
            .map(|(t, r)| (*t, 60.0 / TAU * f(r)))
            .collect()
    };
    let plot = over_time(380, "Speed (rpm)")
        .trace(trace("rotor", &of(|r| r.speed_rad_s), PALETTE[1]))
        .trace(trace("inner ring", &of(|r| r.ring_speed_rad_s), PALETTE[0]));
    figure(
        "Spin-up",
        "Speed of the rotor and of the inner ring that it drives by friction, counter-clockwise \
         positive.",
        source,
        plot,
    )
}

/// Forces as multiples of the weight of the rotor.
fn forces(case: &Case, snapshots: &[Snapshot], source: &Provenance) -> Figure {
    let weight = case.rotor.as_ref().map_or(0.0, |r| r.mass_kg) * case.operation.gravity_m_s2;
    let (scale, unit) = if weight > 0.0 {
        (1.0 / weight, "Force / weight of the rotor")
    } else {
        (1.0, "Force (N)")
    };
    let contact: Vec<(f64, f64)> = (snapshots.iter())
        .filter_map(|s| Some((1e3 * s.time_s, scale * s.rotor?.contact_force_n)))
        .collect();
    let outer: Vec<(f64, f64)> = (snapshots.iter())
        .map(|s| {
            let force = s.ring.outer_force_x_n.hypot(s.ring.outer_force_y_n);
            (1e3 * s.time_s, scale * force)
        })
        .collect();
    let plot = over_time(400, unit)
        .trace(trace("balls on the outer ring", &outer, PALETTE[2]))
        .trace(trace("rotor on the inner ring", &contact, PALETTE[0]));
    figure(
        "Forces",
        "Normal force between rotor and inner ring and the force of the balls on the outer ring, \
         at the output interval: peaks between two rows are in the table only.",
        source,
        plot,
    )
}

/// Whirl frequency over time.
fn whirl(windows: &[WindowRow], source: &Provenance) -> Figure {
    let over = |of: fn(&WindowRow) -> f64| -> Vec<f64> { windows.iter().map(of).collect() };
    let time = over(|w| w.time_ms);
    let frequency = over(|w| w.whirl_frequency_hz);
    let contact = over(|w| 100.0 * w.contact_fraction);
    let plot = over_time(420, "Whirl frequency (Hz)")
        .axis(
            "yaxis",
            "Whirl frequency (Hz)",
            json!({ "domain": [0.42, 1.0] }),
        )
        .axis(
            "yaxis2",
            "Contact (%)",
            json!({ "domain": [0.0, 0.3], "range": [0, 105] }),
        )
        .axis(
            "xaxis",
            "Time since the magnets let go (ms)",
            json!({ "anchor": "y2" }),
        )
        .set("showlegend", json!(false))
        .horizontal("x", "y", 0.0, "dot")
        .trace(line("whirl frequency", &time, &frequency, PALETTE[3]))
        .trace(with(
            line("contact", &time, &contact, PALETTE[2]),
            json!({ "yaxis": "y2" }),
        ));
    figure(
        "Whirl",
        "Mean frequency at which the journal goes round the bore, window by window, and the part \
         of each window in contact. Negative: against the rotation of a rotor that turns \
         counter-clockwise.",
        source,
        plot,
    )
}
