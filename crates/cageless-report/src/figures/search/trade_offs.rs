//! Trade-offs of a search.

use serde_json::{Value, json};

use super::OWN;
use crate::design::{PointNumbers, SearchData, StructureData};
use crate::figure::Figure;
use crate::figures::{axis_name, axis_ref, on, panels};
use crate::plot::{GREY, PALETTE, Plot, markers, numbers, plain, with};
use crate::sampling::range;
use crate::text::short;

/// A number of a structure, the worst of its operating points.
fn worst(structure: &StructureData, of: fn(&PointNumbers) -> Option<f64>) -> f64 {
    structure
        .points
        .iter()
        .map(|n| of(n).unwrap_or(f64::NAN))
        .fold(f64::NEG_INFINITY, f64::max)
}

type Quantity = (&'static str, fn(&PointNumbers) -> Option<f64>);

/// Pairs of quantities drawn against each other.
const PAIRS: [[Quantity; 2]; 4] = [
    [
        ("Spacing scatter on arrival (% of steady gap)", |n| {
            Some(100.0 * n.motion?.spacing_scatter)
        }),
        ("Collisions in steady state (per ball and orbit)", |n| {
            Some(n.motion?.collisions_late)
        }),
    ],
    [
        ("Spacing scatter on arrival (% of steady gap)", |n| {
            Some(100.0 * n.motion?.spacing_scatter)
        }),
        ("Friction loss (W)", |n| Some(n.motion?.friction_w)),
    ],
    [
        ("Gap reserve (°)", |n| n.margin_deg),
        ("Sliding speed (m/s)", |n| Some(n.motion?.sliding_m_s)),
    ],
    [
        ("Contact pressure (MPa)", |n| n.pressure_mpa),
        ("Vibration (N)", |n| Some(n.motion?.force_deviation_n)),
    ],
];

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
pub fn trade_offs(search: &SearchData) -> Figure {
    let accepted = |front: bool| -> Vec<&StructureData> {
        search
            .band
            .iter()
            .filter(|s| s.status == "accepted" && s.on_front == front)
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
    let groups: [(&str, Vec<&StructureData>, &str, u32, &str); 4] = [
        ("acceptable", accepted(false), GREY, 6, "circle"),
        ("Pareto front", accepted(true), PALETTE[0], 7, "circle"),
        (
            OWN,
            search.own_from_usual_starts.iter().collect(),
            PALETTE[4],
            11,
            "square",
        ),
        (
            "recommended",
            search.recommended_from_usual_starts.iter().collect(),
            "#ffdd00",
            15,
            "star",
        ),
    ];
    for (k, pair) in PAIRS.iter().enumerate() {
        let (x, y) = (axis_ref("x", k), axis_ref("y", k));
        let frames = pair.map(|(_, of)| {
            let shown = groups.iter().filter(|g| g.0 != OWN).flat_map(|g| &g.1);
            frame_of(&shown.map(|s| worst(s, of)).collect::<Vec<_>>())
        });
        let axis = |place: [f64; 2], anchor: &str, frame: Option<[f64; 2]>| match frame {
            Some(frame) => json!({ "domain": place, "anchor": anchor, "range": numbers(&frame) }),
            None => json!({ "domain": place, "anchor": anchor }),
        };
        plot = plot
            .axis(
                &axis_name("x", k),
                pair[0].0,
                axis(x_places[k % 2], &y, frames[0]),
            )
            .axis(
                &axis_name("y", k),
                pair[1].0,
                axis(y_places[1 - k / 2], &x, frames[1]),
            );
        for (name, structures, colour, size, symbol) in &groups {
            if structures.is_empty() {
                continue;
            }
            let values = |of: fn(&PointNumbers) -> Option<f64>| -> Vec<f64> {
                structures.iter().map(|s| worst(s, of)).collect()
            };
            let labels: Vec<String> = structures.iter().map(|s| plain(&s.label())).collect();
            if *name == OWN
                && let Some(mark) = outside(&pair.map(|(_, of)| values(of)[0]), frames)
            {
                let trace = with(
                    mark,
                    json!({
                        "legendgroup": name, "showlegend": k == 0, "name": name,
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
                    markers(name, &values(pair[0].1), &values(pair[1].1), colour),
                    json!({
                        "marker": { "size": size, "symbol": symbol,
                                    "line": { "width": if *size > 8 { 1.2 } else { 0.0 }, "color": "#000" } },
                        "text": labels, "legendgroup": name, "showlegend": k == 0,
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
        provenance: search.provenance.clone(),
        plot,
    }
}
