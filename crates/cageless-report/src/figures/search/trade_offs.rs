//! Trade-offs of a search.

use serde_json::{Value, json};

use super::OWN;
use cageless_results::{MOTION, Record, STRUCTURE_AT, heading};
use cageless_study::search::structure_label;

use crate::figure::Figure;
use crate::figures::panels::{axis_name, axis_ref, on, panels};
use crate::plot::{GREY, PALETTE, Plot, markers, numbers, plain, with};
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
fn outside(point: &[f64; 2], frames: [Option<[f64; 2]>; 2]) -> Option<Value> {
    let [Some(x), Some(y)] = frames else {
        return None;
    };
    let at = [point[0].clamp(x[0], x[1]), point[1].clamp(y[0], y[1])];
    if !point.iter().all(|v| v.is_finite()) || at == *point {
        return None;
    }
    let text = format!("{}, {}", short(point[0]), short(point[1]));
    let side = if at[0] > 0.5 * (x[0] + x[1]) {
        "left"
    } else {
        "right"
    };
    let height = if at[1] > 0.5 * (y[0] + y[1]) {
        "bottom"
    } else {
        "top"
    };
    Some(with(
        markers(OWN, &[at[0]], &[at[1]], ""),
        json!({
            "mode": "markers+text", "text": [text], "cliponaxis": false,
            "textposition": format!("{height} {side}"), "textfont": { "size": 11 },
        }),
    ))
}

/// Trade-offs of the acceptable structures.
pub fn trade_offs(search: &Record) -> Figure {
    let accepted = |front: bool| -> Vec<&Record> {
        let band = search.parts("band").iter();
        band.filter(|s| s.text("status") == "accepted" && s.flag("on_front") == Some(front))
            .collect()
    };
    let (x_places, y_places) = (panels(2, 0.12), panels(2, 0.2));
    let mut plot = Plot::new(720)
        .legend()
        .set("margin", json!({ "l": 72, "r": 24, "t": 60, "b": 58 }))
        .set(
            "legend",
            json!({ "orientation": "h", "x": 0, "y": 1.03, "yanchor": "bottom", "font": { "size": 12 } }),
        );
    let groups: [(&str, Vec<&Record>, &str, u32, &str); 4] = [
        ("acceptable", accepted(false), GREY, 6, "circle"),
        ("Pareto front", accepted(true), PALETTE[0], 7, "circle"),
        (
            OWN,
            search.part("own_from_usual_starts").into_iter().collect(),
            PALETTE[4],
            11,
            "square",
        ),
        (
            "recommended",
            search
                .part("recommended_from_usual_starts")
                .into_iter()
                .collect(),
            "#ffdd00",
            15,
            "star",
        ),
    ];
    for (k, pair) in PAIRS.iter().enumerate() {
        let (x, y) = (axis_ref("x", k), axis_ref("y", k));
        let frames = pair.map(|name| {
            let shown = groups.iter().filter(|g| g.0 != OWN).flat_map(|g| &g.1);
            frame_of(&shown.map(|s| worst(s, name)).collect::<Vec<_>>())
        });
        let axis = |place: [f64; 2], anchor: &str, frame: Option<[f64; 2]>| match frame {
            Some(frame) => json!({ "domain": place, "anchor": anchor, "range": numbers(&frame) }),
            None => json!({ "domain": place, "anchor": anchor }),
        };
        plot = plot
            .axis(
                &axis_name("x", k),
                &title(pair[0]),
                axis(x_places[k % 2], &y, frames[0]),
            )
            .axis(
                &axis_name("y", k),
                &title(pair[1]),
                axis(y_places[1 - k / 2], &x, frames[1]),
            );
        for (group, structures, colour, size, symbol) in &groups {
            if structures.is_empty() {
                continue;
            }
            let values =
                |name: &str| -> Vec<f64> { structures.iter().map(|s| worst(s, name)).collect() };
            let labels: Vec<String> = structures
                .iter()
                .map(|s| plain(&structure_label(s)))
                .collect();
            if *group == OWN
                && let Some(mark) = outside(&pair.map(|name| values(name)[0]), frames)
            {
                let trace = with(
                    mark,
                    json!({
                        "legendgroup": group, "showlegend": k == 0, "name": group,
                        "marker": { "size": size, "symbol": symbol, "color": colour,
                                    "line": { "width": 1.2, "color": "#000" } },
                        "hovertext": labels,
                        "hovertemplate": "%{hovertext}<br>outside: %{text}<extra></extra>",
                    }),
                );
                plot = plot.trace(on(trace, &x, &y));
                continue;
            }
            plot = plot.trace(on(
                with(
                    markers(group, &values(pair[0]), &values(pair[1]), colour),
                    json!({
                        "marker": { "size": size, "symbol": symbol,
                                    "line": { "width": if *size > 8 { 1.2 } else { 0.0 }, "color": "#000" } },
                        "text": labels, "legendgroup": group, "showlegend": k == 0,
                        "hovertemplate": "%{text}<br>%{x:.4g}, %{y:.4g}<extra></extra>",
                    }),
                ),
                &x,
                &y,
            ));
        }
    }
    Figure {
        label: "Trade-offs".to_owned(),
        caption: "Acceptable structures, each at the worst of its operating points. What spreads \
                  the balls more evenly costs friction. The axes show the acceptable structures; \
                  the initial design, where it lies outside, is drawn at the edge with its \
                  values (horizontal, vertical)."
            .to_owned(),
        provenance: search.provenance.clone().unwrap_or_default(),
        plot,
    }
}
