//! Vibration of the outer ring: signals and spectra (Fig. 12).

use serde_json::json;

use super::panels::Panel;
use crate::data::{Vibration, VibrationSignal};
use crate::figure::Figure;
use crate::plot::{Axes, Margin, PALETTE, POINTS, Plot, line_of, number, plain};
use crate::sampling::{history, range};
use crate::text::short;

/// Highest frequency of the spectrum, Hz: half the paper's sampling rate.
pub const HIGHEST_HZ: f64 = 2500.0;

/// Room around the panels.
const MARGIN: Margin = Margin {
    left: 72,
    right: 24,
    top: 46,
    bottom: 64,
};

/// Signals one above the other on one scale, spectra below.
pub fn vibration(label: &str, vibration: &Vibration) -> Figure {
    let count = vibration.signals.len().max(1);
    let most = vibration
        .signals
        .iter()
        .map(|s| range(&s.acceleration_m_s2))
        .fold(1e-12, |most: f64, (low, high)| most.max(-low).max(high))
        * 1.08;
    // Pixels from the top down: signals, then the spectrum.
    let (panel, between, room, spectrum) = (170.0, 34.0, 72.0, 250.0);
    let inner = panel * count as f64 + between * (count - 1) as f64 + room + spectrum;
    let mut plot = Plot::new(inner as u32 + 110).margin(MARGIN);
    let mut sizes = Vec::new();
    for (k, signal) in vibration.signals.iter().enumerate() {
        let axes = Panel::new(k);
        let Axes { x, y } = axes.axes();
        let high = 1.0 - (panel + between) * k as f64 / inner;
        let last = k + 1 == count;
        let colour = PALETTE[k % PALETTE.len()];
        let matches = |axis| (k > 0).then_some(axis);
        let over_time = json!({ "showticklabels": last, "matches": matches("x") });
        let up = json!({
            "domain": [high - panel / inner, high], "range": [number(-most), number(most)],
            "matches": matches("y"),
        });
        let titles = [if last { "Time t (s)" } else { "" }, "Acceleration (m/s²)"];
        let drawn = history(&signal.time_s, &signal.acceleration_m_s2, POINTS);
        plot = plot
            .panel(&axes, titles, [over_time, up])
            .trace(
                line_of(&signal.name, drawn, colour)
                    .width(1.0)
                    .on(axes.axes()),
            )
            .text(
                &format!(
                    "<span style=\"color:{colour}\">▬</span> {}",
                    plain(&signal.name)
                ),
                (0.0, 1.01),
                (&format!("{x} domain"), &format!("{y} domain")),
                json!({ "xanchor": "left", "yanchor": "bottom" }),
            );
        sizes.extend(size(signal));
    }
    let plot = spectra(plot, vibration, spectrum / inner);
    let caption = format!(
        "Acceleration of the outer ring over time, on one scale, and below its single-sided \
             amplitude spectrum up to {HIGHEST_HZ} Hz{}.{}{}{}",
        resolution(vibration),
        stretches(vibration),
        if sizes.is_empty() { "" } else { " " },
        if sizes.is_empty() {
            String::new()
        } else {
            format!("Root mean square of {}.", sizes.join("; "))
        }
    );
    Figure::new(label, &caption, &vibration.provenance, plot)
}

/// Root mean square of a signal, with its largest value.
fn size(signal: &VibrationSignal) -> Option<String> {
    let rms = signal.rms_m_s2?;
    let peak = signal.peak_m_s2.map_or(String::new(), |peak| {
        format!(" (largest {} m/s²)", short(peak))
    });
    Some(format!("{}: {} m/s²{peak}", signal.name, short(rms)))
}

/// Spectra of all signals over the lowest part of a plot, up to `height` of it.
fn spectra(mut plot: Plot, vibration: &Vibration, height: f64) -> Plot {
    let axes = Panel::new(vibration.signals.len().max(1));
    let on = axes.axes();
    let up = json!({
        "domain": [0.0, height], "type": "log", "exponentformat": "power", "dtick": 1,
    });
    let more = [json!({ "range": [0, HIGHEST_HZ] }), up];
    plot = plot.panel(&axes, ["Frequency f (Hz)", "Amplitude (m/s²)"], more);
    for (k, signal) in vibration.signals.iter().enumerate() {
        let (frequency, amplitude) = (&signal.frequency_hz, &signal.amplitude_m_s2);
        let low = frequency.iter().take_while(|f| **f <= HIGHEST_HZ);
        let upto = low.count().min(amplitude.len());
        let drawn = history(&frequency[..upto], &amplitude[..upto], POINTS);
        let drawn = line_of(&signal.name, drawn, PALETTE[k % PALETTE.len()]);
        plot = plot.trace(drawn.width(1.1).on(on));
    }
    for mark in &vibration.marks {
        plot = plot.marked(on, mark.frequency_hz, &plain(&mark.label), "dot");
    }
    plot
}

/// Remark on the resolution of the spectrum.
fn resolution(vibration: &Vibration) -> String {
    let Some(signal) = vibration.signals.first() else {
        return String::new();
    };
    let Some(resolution) = signal.resolution_hz else {
        return String::new();
    };
    let averaged = if signal.averages > 1 {
        format!(
            ", root mean square over {} stretches of {} s that overlap by half",
            signal.averages,
            short(1.0 / resolution)
        )
    } else {
        String::new()
    };
    format!(
        ", a value every {} Hz (Hann window){averaged}",
        short(resolution)
    )
}

/// Remark on the decimation of the trace over time.
fn stretches(vibration: &Vibration) -> String {
    let longest = vibration
        .signals
        .iter()
        .filter_map(|signal| signal.stretch_s)
        .fold(0.0, f64::max);
    if longest > 0.0 {
        format!(
            " Over time, every {} ms are shown by their lowest and highest value.",
            short(longest * 1e3)
        )
    } else {
        String::new()
    }
}
