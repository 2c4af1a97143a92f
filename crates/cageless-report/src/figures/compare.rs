//! Runs on the same axes.

use cageless_io::estimate::Estimate;
use cageless_study::comparison::{BenefitWord, RingComparison};
use serde_json::json;

use crate::compared_run::{ComparedRun, provenance};
use crate::data::Provenance;
use crate::figure::Figure;
use crate::plot::{PALETTE, POINTS, Plot, Trace, line_of, number, plain};
use crate::sampling::history;

/// Name, abscissa and ordinate of a line.
type Line<'r> = (&'r str, Vec<f64>, Vec<f64>);

/// Standard deviation of the gaps at each time.
pub fn spacing(runs: &[ComparedRun]) -> Option<Figure> {
    let lines = runs.iter().filter_map(|run| {
        let data = &run.data;
        // Rows of extremes over stretches of time belong to no one instant.
        let (time, balls) = match (&data.recent, data.stretch_s) {
            (Some(recent), Some(_)) => (&recent.time_s, &recent.balls),
            _ => (&data.time_s, &data.balls),
        };
        let deviation = |row: usize| {
            let gaps = || balls.iter().filter_map(|ball| ball.gap_deg.get(row));
            let n = gaps().count().max(1) as f64;
            let mean = gaps().sum::<f64>() / n;
            (gaps().map(|g| (g - mean).powi(2)).sum::<f64>() / n).sqrt()
        };
        let values: Vec<f64> = (0..time.len()).map(deviation).collect();
        (!values.is_empty()).then(|| (run.name.as_str(), time.clone(), values))
    });
    figure(
        runs,
        "Scatter of the gaps",
        "Standard deviation of the gaps of all balls at each instant: 0 is even spacing.",
        Plot::new(360).axes("Time t (s)", "Standard deviation of the gaps (°)"),
        lines.collect(),
    )
}

/// Height of the inner ring over time.
pub fn ring(runs: &[ComparedRun]) -> Option<Figure> {
    let lines = runs.iter().map(|run| {
        let ring = &run.data.ring;
        (run.name.as_str(), ring.time_s.clone(), ring.y_um.clone())
    });
    figure(
        runs,
        "Height of the inner ring",
        "Displacement of the centre of the inner ring against gravity and load at the end of each run.",
        Plot::new(360).axes("Time t (s)", "Displacement y (µm)"),
        lines.collect(),
    )
}

/// Largest load at the inner raceway around the bearing.
pub fn loads(runs: &[ComparedRun]) -> Option<Figure> {
    let lines = runs.iter().filter_map(|run| {
        let profile = run.data.load_profile.as_ref()?;
        let (angle, load) = (&profile.angle_deg, &profile.inner_force_max_n);
        Some((run.name.as_str(), angle.clone(), load.clone()))
    });
    figure(
        runs,
        "Largest loads",
        "Largest normal force of a ball on the inner raceway over its place ψ, from the bottom.",
        Plot::new(360).axes("Place ψ (°)", "Largest force Fi (N)"),
        lines.collect(),
    )
}

fn figure(
    runs: &[ComparedRun],
    label: &str,
    caption: &str,
    plot: Plot,
    lines: Vec<Line<'_>>,
) -> Option<Figure> {
    if lines.iter().all(|(_, x, _)| x.is_empty()) {
        return None;
    }
    let mut plot = plot.legend();
    for (k, (name, x, y)) in lines.iter().enumerate() {
        let colour = PALETTE[k % PALETTE.len()];
        plot = plot.trace(line_of(name, history(x, y, POINTS), colour));
    }
    Some(Figure::new(label, caption, &provenance(runs), plot))
}

/// Benefit of each judged ring over the losses that it costs, with standard errors; nothing without one.
pub fn benefit(comparison: &RingComparison, source: &Provenance) -> Option<Figure> {
    /// Score of the ring with which the others are compared.
    const NONE: Estimate = Estimate {
        mean: 0.0,
        standard_error: 0.0,
        starts: 1,
    };
    let losses = comparison
        .results
        .iter()
        .find(|result| result.quantity.name == "power_loss_w")?;
    let judged = comparison.benefits.iter().flatten();
    judged.clone().find_map(|benefit| benefit.score)?;
    let mut plot = Plot::new(400)
        .legend()
        .x("Losses (W)", json!({ "type": "log" }))
        .y("Factor on what is asked", json!({ "type": "log" }));
    for (k, name) in comparison.runs.iter().enumerate() {
        let benefit = comparison.benefits[k].as_ref();
        let score = match benefit {
            Some(benefit) => benefit.score,
            None => Some(NONE),
        };
        let (Some(score), Some(loss)) = (score, losses.values[k]) else {
            continue;
        };
        let factor = score.mean.exp();
        // d(exp s) = exp s · ds.
        let bars =
            |error: f64| json!({ "type": "data", "array": [error], "thickness": 1.2, "width": 3 });
        let symbol = match benefit.map(|b| b.benefit) {
            Some(BenefitWord::Harms) => "x",
            Some(BenefitWord::NoMeasurableBenefit) => "circle-open",
            _ => "circle",
        };
        let word = benefit.map_or(String::new(), |b| format!(": {}", b.benefit.label()));
        plot = plot.trace(Trace::from(json!({
            "type": "scatter", "mode": "markers", "name": plain(&format!("{name}{word}")),
            "x": [number(loss.mean)], "y": [number(factor)],
            "error_x": bars(loss.standard_error), "error_y": bars(factor * score.standard_error),
            "marker": { "color": PALETTE[k % PALETTE.len()], "size": 11, "symbol": symbol },
        })));
    }
    let caption = "Weighted geometric mean of contacts per second, scatter of the gaps and variation of the force on the \
                   outer ring, over those of the first ring: below 1 is better, further left is cheaper. A cross harms.";
    Some(Figure::new("Benefit and cost", caption, source, plot))
}
