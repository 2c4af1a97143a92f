//! Sensitivity of the outputs of a sweep.

use serde_json::{Value, json};

use super::{axis_name, axis_ref, on, panels};
use crate::data::Provenance;
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, numbers, plain};
use crate::sweep::{HeatMap, Levels, MainEffect, SweepData, SweepOutput};
use crate::text::short;

/// Panels side by side.
const ACROSS: usize = 3;
/// From nothing to everything. In so many colours: plotly.py reads the names the other way
/// round than plotly.js.
const BLUES: [(f64, &str); 4] = [
    (0.0, "#f7fbff"),
    (0.35, "#9ecae1"),
    (0.7, "#3182bd"),
    (1.0, "#08306b"),
];
/// Height of a row of panels, pixels.
const ROW_PX: u32 = 300;

/// Share of the variance of each output that each input explains.
pub fn shares(data: &SweepData) -> Figure {
    let names: Value = data.inputs.iter().map(|i| plain(&i.name)).collect();
    // plotly draws from below.
    let outputs: Vec<&SweepOutput> = data.outputs.iter().rev().collect();
    let labels: Value = outputs.iter().map(|o| plain(&o.quantity.name)).collect();
    let percent = |share: &Option<f64>| share.map_or(f64::NAN, |s| 100.0 * s);
    let z: Value = outputs
        .iter()
        .map(|o| numbers(&o.shares.iter().map(percent).collect::<Vec<_>>()))
        .collect();
    let text: Value = outputs
        .iter()
        .map(|o| {
            let shown = |s: &Option<f64>| s.map_or(String::new(), |s| format!("{:.0}", 100.0 * s));
            o.shares.iter().map(shown).collect::<Value>()
        })
        .collect();
    let height = 130 + 26 * outputs.len() as u32;
    let plot = Plot::new(height.max(240))
        .axis(
            "xaxis",
            "Input",
            json!({ "side": "top", "showgrid": false, "type": "category" }),
        )
        .axis(
            "yaxis",
            "Output",
            json!({ "showgrid": false, "type": "category" }),
        )
        .trace(json!({
            "type": "heatmap", "x": names, "y": labels, "z": z, "text": text,
            "texttemplate": "%{text}", "zmin": 0, "zmax": 100, "colorscale": BLUES,
            "xgap": 1, "ygap": 1,
            "colorbar": { "title": { "text": "%" }, "thickness": 12 },
            "hovertemplate": "%{y} by %{x}: %{z:.1f} %<extra></extra>",
        }));
    Figure {
        label: "Sensitivity (main effects)".to_owned(),
        caption: "Fraction of the variance of each output, in percent, that each input explains \
                  alone (correlation ratio η²). The remainder to 100 in a row is \
                  interaction of the inputs and scatter; with few variants at a level, scatter \
                  alone gives a few percent."
            .to_owned(),
        provenance: data.provenance.clone(),
        plot,
    }
}

/// An output over each of the inputs that explain most.
pub fn effects(output: &SweepOutput, provenance: &Provenance) -> Figure {
    let count = output.effects.len();
    let rows = count.div_ceil(ACROSS);
    let across = panels(count.min(ACROSS), 0.07);
    let up = panels(rows, 0.28 / rows.max(1) as f64 + 0.06);
    let mut plot = Plot::new(ROW_PX * rows as u32 + 40).at_least(760);
    for (k, effect) in output.effects.iter().enumerate() {
        let (column, row) = (k % ACROSS, k / ACROSS);
        // One y-axis for a row of panels.
        let (x, y) = (axis_ref("x", k), axis_ref("y", row));
        let mut along = json!({ "domain": across[column], "anchor": y });
        if matches!(effect.levels, Levels::Names(_)) {
            along["type"] = "category".into();
        }
        plot = plot.axis(&axis_name("x", k), &effect.input.label(), along);
        if column == 0 {
            // The first row is the uppermost.
            let mut upwards = json!({ "domain": up[rows - 1 - row], "anchor": x });
            if row > 0 {
                upwards["matches"] = "y".into();
            }
            plot = plot.axis(&axis_name("y", row), &output.quantity.label(), upwards);
        }
        for trace in effect_traces(effect) {
            plot = plot.trace(on(trace, &x, &y));
        }
    }
    Figure {
        label: format!("Effects on {}", output.quantity.name),
        caption: format!(
            "Mean of {} at each level of an input, over all others; band: min–max.",
            output.quantity.name
        ),
        provenance: provenance.clone(),
        plot,
    }
}

fn effect_traces(effect: &MainEffect) -> [Value; 3] {
    let edge = |values: &[f64]| {
        json!({
            "type": "scatter", "mode": "lines", "x": levels(&effect.levels), "y": numbers(values),
            "line": { "width": 0, "color": PALETTE[0] }, "hoverinfo": "skip",
        })
    };
    let mut above = edge(&effect.max);
    above["fill"] = "tonexty".into();
    above["fillcolor"] = "rgba(0,114,178,0.14)".into();
    let mean = json!({
        "type": "scatter", "mode": "lines+markers", "x": levels(&effect.levels),
        "y": numbers(&effect.mean), "line": { "color": PALETTE[0], "width": 1.6 },
        "marker": { "color": PALETTE[0], "size": 6 },
    });
    [edge(&effect.min), above, mean]
}

/// The mean of an output over two inputs.
pub fn map(output: &SweepOutput, map: &HeatMap, provenance: &Provenance) -> Figure {
    // Levels, not a scale: cells of one size, whatever the distances.
    let axis = || json!({ "type": "category", "showgrid": false });
    let z: Value = map.mean.iter().map(|row| numbers(row)).collect();
    let plot = Plot::new(440)
        .axis("xaxis", &map.x_input.label(), axis())
        .axis("yaxis", &map.y_input.label(), axis())
        .trace(json!({
            "type": "heatmap", "x": names(&map.x), "y": names(&map.y), "z": z,
            "colorscale": "Viridis",
            "colorbar": { "title": { "text": plain(output.quantity.sign()) }, "thickness": 14 },
        }));
    Figure {
        label: format!("Map of {}", output.quantity.name),
        caption: format!(
            "Mean of {} over the two inputs that explain most of it.",
            output.quantity.label()
        ),
        provenance: provenance.clone(),
        plot,
    }
}

fn levels(levels: &Levels) -> Value {
    match levels {
        Levels::Numbers(values) => numbers(values),
        Levels::Names(names) => names.iter().map(|n| plain(n)).collect(),
    }
}

fn names(levels: &Levels) -> Value {
    match levels {
        Levels::Numbers(values) => values.iter().map(|v| short(*v)).collect(),
        Levels::Names(names) => names.iter().map(|n| plain(n)).collect(),
    }
}
