//! Sensitivity of the outputs of a sweep.

use serde_json::{Value, json};

use super::panels::{Panel, Space};
use crate::data::Provenance;
use crate::figure::Figure;
use crate::names;
use crate::plot::{Margin, PALETTE, Plot, Trace, numbers, plain};
use crate::sweep::{HeatMap, Levels, MainEffect, SweepData, SweepOutput};
use crate::text::{broken, capital, short};

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
/// Inputs of an output that are drawn.
const SHOWN: usize = 3;
/// Height of a row of panels, pixels.
const ROW_PX: u32 = 290;

/// Share of the variance of each chosen output that each input explains.
pub fn shares(data: &SweepData) -> Figure {
    // Choices first, conditions of operation behind them.
    let mut order: Vec<usize> = (0..data.inputs.len()).collect();
    order.sort_by_key(|k| data.inputs[*k].is_condition());
    let choices = data.inputs.iter().filter(|i| !i.is_condition()).count();
    let inputs: Value = (order.iter())
        .map(|k| plain(&names::name(&data.inputs[*k])))
        .collect();
    // plotly draws from below.
    let shown = data.chosen.clamp(1, data.outputs.len().max(1));
    let outputs: Vec<&SweepOutput> = data.outputs.iter().take(shown).rev().collect();
    let labels: Value = (outputs.iter())
        .map(|o| plain(&names::name(&o.quantity)))
        .collect();
    let cells = percents(&outputs, &order);
    let height = 150 + 30 * outputs.len() as u32;
    let mut plot = Plot::new(height.max(240))
        .x(
            "",
            json!({ "side": "top", "showgrid": false, "type": "category" }),
        )
        .y("", json!({ "showgrid": false, "type": "category" }))
        .trace(json!({
            "type": "heatmap", "x": inputs, "y": labels, "z": cells.value, "text": cells.text,
            "texttemplate": "%{text}", "zmin": 0, "zmax": 100, "colorscale": BLUES,
            "xgap": 1, "ygap": 1,
            "colorbar": { "title": { "text": "%", "side": "right" }, "thickness": 12 },
            "hovertemplate": "%{y} by %{x}: %{z:.1f} %<extra></extra>",
        }))
        .finding(&strongest(data, shown));
    if choices > 0 && choices < data.inputs.len() {
        plot = plot.vertical("x", "y", choices as f64 - 0.5, "solid");
    }
    let conditions = match data.inputs.len() - choices {
        0 => "",
        _ if choices == 0 => " All inputs are conditions of operation.",
        _ => " Right of the line: conditions of operation and of the computation.",
    };
    let caption = format!(
        "Fraction of the variance of each output, in percent, that each input explains \
             alone: η² of an axis of the grid, ε² of what is drawn by [samples] or [scatter], 0 within \
             chance.{conditions} The remainder to 100 in a row is \
             interaction of the inputs and scatter; with few variants at a level of the grid, scatter \
             alone gives a few percent."
    );
    Figure::new(
        "Sensitivity (main effects)",
        &caption,
        &data.provenance,
        plot,
    )
}

/// Rows of a map of shares: its values, percent, and what stands in its cells.
struct Percents {
    value: Value,
    text: Value,
}

/// Share of each input, in an order, in the variance of each output.
fn percents(outputs: &[&SweepOutput], order: &[usize]) -> Percents {
    let percent = |output: &SweepOutput, k: usize| {
        let share = output.shares.get(k).copied().flatten();
        share.map_or(f64::NAN, |s| 100.0 * s)
    };
    let value = outputs
        .iter()
        .map(|o| numbers(&order.iter().map(|k| percent(o, *k)).collect::<Vec<_>>()))
        .collect();
    let text = outputs
        .iter()
        .map(|o| {
            let shown = |k: &usize| match percent(o, *k) {
                share if share.is_finite() => format!("{share:.0}"),
                _ => String::new(),
            };
            order.iter().map(shown).collect::<Value>()
        })
        .collect();
    Percents { value, text }
}

/// The input that explains most of each of the first outputs, in sentences.
fn strongest(data: &SweepData, shown: usize) -> String {
    let said = data.outputs.iter().take(shown.min(3)).filter_map(|output| {
        let (input, share) = output.strongest(&data.inputs)?;
        Some(format!(
            "{}: {:.0} % by {}.",
            names::name(&output.quantity),
            100.0 * share,
            names::name(input)
        ))
    });
    said.collect::<Vec<_>>().join(" ")
}

/// An output over each of the inputs that explain most.
pub fn effects(output: &SweepOutput, provenance: &Provenance) -> Figure {
    let mut drawn: Vec<&MainEffect> = output.effects.iter().take(SHOWN).collect();
    drawn.sort_by_key(|effect| effect.input.is_condition());
    let count = drawn.len();
    let rows = count.div_ceil(ACROSS);
    let space = Space {
        across: 0.06,
        down: 0.28 / rows.max(1) as f64 + 0.06,
    };
    let mut plot = Plot::new(ROW_PX * rows as u32 + 20).margin(Margin::above(16));
    let panels = Panel::grid(count, count.min(ACROSS), space);
    let title = broken(&capital(&names::label(&output.quantity)));
    for (panel, effect) in panels.iter().zip(drawn) {
        let mut along = json!({});
        if matches!(effect.levels, Levels::Names(_)) {
            along["type"] = "category".into();
        }
        // The first row is the uppermost; all panels have one scale.
        let mut upwards = json!({ "showticklabels": panel.leftmost });
        if !panel.first {
            upwards["matches"] = "y".into();
        }
        let up = panel.at_left(&title);
        let across = capital(&names::label(&effect.input));
        plot = plot.panel(panel, [&across, up], [along, upwards]);
        for trace in effect_traces(effect) {
            plot = plot.trace(Trace::from(trace).on(panel.axes()));
        }
    }
    let name = names::name(&output.quantity);
    let caption = format!(
        "Mean of {name} (`{}`) at each level of an input, over all others; band: min–max. \
             Choices come first, conditions of operation behind them.",
        output.quantity.name
    );
    Figure::new(&format!("Effects on {name}"), &caption, provenance, plot)
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
    let plot = Plot::new(340)
        .margin(Margin::above(16))
        .x(&capital(&names::label(&map.x_input)), axis())
        .y(&capital(&names::label(&map.y_input)), axis())
        .trace(json!({
            "type": "heatmap", "x": names(&map.x), "y": names(&map.y), "z": z,
            "colorscale": "Viridis",
            "colorbar": { "title": { "text": plain(&colour_title(output)), "side": "right" }, "thickness": 14 },
        }));
    let caption = format!(
        "Mean of {} over the two inputs that explain most of it.",
        names::label(&output.quantity)
    );
    Figure::new(
        &format!("Map of {}", names::name(&output.quantity)),
        &caption,
        provenance,
        plot,
    )
}

/// Title of the scale of colours: the unit; `mean` for an output without one.
fn colour_title(output: &SweepOutput) -> String {
    match output.quantity.sign() {
        unit if unit.is_empty() => "mean".to_owned(),
        unit => unit,
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
