//! Trade-offs of a search.

use serde_json::json;

use super::OWN;
use cageless_results::{MOTION, Record, STRUCTURE_AT, heading};
use cageless_study::search::structure_label;

use crate::figure::Figure;
use crate::figures::panels::{Panel, Space};
use crate::plot::{GREY, Margin, PALETTE, Plot, Trace, markers, numbers, plain};
use crate::sampling::range;
use crate::text::short;

/// A result of a structure, the worst of its operating points.
fn worst(structure: &Record, name: &str) -> f64 {
    let points = structure.parts("points").iter();
    let at = points.map(|point| match point.part("motion") {
        Some(motion) if motion.get(name).is_some() => motion.number(name),
        _ => point.number(name),
    });
    at.fold(f64::NEG_INFINITY, f64::max)
}

/// Pairs of results drawn against each other.
const PAIRS: [[&str; 2]; 4] = [
    ["spacing_scatter", "collisions_late"],
    ["spacing_scatter", "friction_w"],
    ["margin_deg", "sliding_m_s"],
    ["pressure_mpa", "force_deviation_n"],
];

/// Label and unit of a result, a dash where it has none.
fn title(name: &str) -> String {
    let mut all = STRUCTURE_AT.iter().chain(MOTION);
    let quantity = all.find(|q| q.name == name);
    match quantity.map_or_else(String::new, heading) {
        heading if heading.ends_with(')') => heading,
        heading => format!("{heading} (–)"),
    }
}

/// Range of an axis that shows all `values` with room around them; `None` without values.
fn frame_of(values: &[f64]) -> Option<[f64; 2]> {
    let finite: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    if finite.is_empty() {
        return None;
    }
    let (low, high) = range(&finite);
    let room = match (high - low, high.abs()) {
        (0.0, 0.0) => 1.0,
        (0.0, size) => 0.1 * size,
        (span, _) => 0.08 * span,
    };
    Some([low - room, high + room])
}

/// A mark at the edge of the frames with its values, for a point outside of them.
fn outside(point: &[f64; 2], frames: [Option<[f64; 2]>; 2]) -> Option<Trace> {
    let [Some(x), Some(y)] = frames else {
        return None;
    };
    let at = [point[0].clamp(x[0], x[1]), point[1].clamp(y[0], y[1])];
    if !point.iter().all(|v| v.is_finite()) || at == *point {
        return None;
    }
    let text = format!("{}, {}", short(point[0]), short(point[1]));
    let side = if at[0] > f64::midpoint(x[0], x[1]) {
        "left"
    } else {
        "right"
    };
    let height = if at[1] > f64::midpoint(y[0], y[1]) {
        "bottom"
    } else {
        "top"
    };
    Some(markers(OWN, &[at[0]], &[at[1]], "").with(json!({
        "mode": "markers+text", "text": [text], "cliponaxis": false,
        "textposition": format!("{height} {side}"), "textfont": { "size": 11 },
    })))
}

/// Space between the panels.
const SPACE: Space = Space {
    across: 0.12,
    down: 0.2,
};

/// Trade-offs of the acceptable structures.
pub fn trade_offs(search: &Record) -> Figure {
    let accepted = |front: bool| -> Vec<&Record> {
        let band = search.parts("band").iter();
        band.filter(|s| s.text("status") == "accepted" && s.flag("on_front") == Some(front))
            .collect()
    };
    let mut plot = Plot::new(720).legend_above(1.03).margin(Margin::above(60));
    let one = |name: &str| search.part(name).into_iter().collect();
    let [own, found] = ["own_from_usual_starts", "recommended_from_usual_starts"].map(one);
    let groups: [(&str, Vec<&Record>, &str, u32, &str); 4] = [
        ("acceptable", accepted(false), GREY, 6, "circle"),
        ("Pareto front", accepted(true), PALETTE[0], 7, "circle"),
        (OWN, own, PALETTE[4], 11, "square"),
        ("recommended", found, "#ffdd00", 15, "star"),
    ];
    for (panel, pair) in Panel::grid(PAIRS.len(), 2, SPACE).iter().zip(&PAIRS) {
        let frames = pair.map(|name| {
            let shown = groups.iter().filter(|g| g.0 != OWN).flat_map(|g| &g.1);
            frame_of(&shown.map(|s| worst(s, name)).collect::<Vec<_>>())
        });
        let shown = |frame: Option<[f64; 2]>| {
            frame.map_or(json!({}), |frame| json!({ "range": numbers(&frame) }))
        };
        let titles = pair.map(title);
        plot = plot.panel(
            panel,
            titles.each_ref().map(String::as_str),
            frames.map(shown),
        );
        for (group, structures, colour, size, symbol) in &groups {
            if structures.is_empty() {
                continue;
            }
            let values =
                |name: &str| -> Vec<f64> { structures.iter().map(|s| worst(s, name)).collect() };
            let labels = structures.iter().map(|s| plain(&structure_label(s)));
            let labels: Vec<String> = labels.collect();
            let mark = match *group {
                OWN => outside(&pair.map(|name| values(name)[0]), frames),
                _ => None,
            };
            let drawn = match mark {
                Some(mark) => mark.with(json!({
                    "marker": { "color": colour }, "hovertext": labels,
                    "hovertemplate": "%{hovertext}<br>outside: %{text}<extra></extra>",
                })),
                None => markers(group, &values(pair[0]), &values(pair[1]), colour).with(json!({
                    "text": labels, "hovertemplate": "%{text}<br>%{x:.4g}, %{y:.4g}<extra></extra>",
                })),
            };
            let outline = json!({ "width": if *size > 8 { 1.2 } else { 0.0 }, "color": "#000" });
            let marker = json!({ "size": size, "symbol": symbol, "line": outline });
            let drawn = drawn.with(json!({ "marker": marker }));
            plot = plot.trace(drawn.in_group(group, panel.first).on(panel.axes()));
        }
    }
    let caption = "Acceptable structures, each at the worst of its operating points. What spreads \
                  the balls more evenly costs friction. The axes show the acceptable structures; \
                  the initial design, where it lies outside, is drawn at the edge with its \
                  values (horizontal, vertical).";
    Figure::of_record("Trade-offs", caption, search, plot)
}
