//! Maps of a search: verdicts and critical gaps over span and half angle.

use serde_json::{Value, json};

use super::OWN;
use cageless_results::{Cell, Record};
use cageless_study::search::{point_label, structure_label};

use crate::figure::Figure;
use crate::figures::panels::{axis_name, axis_ref, on, panels};
use crate::plot::{PALETTE, Plot, line, markers, number, numbers, plain, with};
use crate::sampling::range;

/// Verdicts of a map, each with its colour and its name in the legend.
const VERDICTS: [(&str, &str, &str); 10] = [
    ("smooth", "#009e73", "works"),
    ("insufficient-separation", "#dcdcdc", "too shallow"),
    ("slips", "#d55e00", "slips"),
    (
        "excessive-separation",
        "#56b4e9",
        "collision at even spacing",
    ),
    ("double-collision", "#f0e442", "double collision"),
    ("stress", "#cc79a7", "contact pressure"),
    ("gross-sliding", "#7f3b08", "gross-sliding"),
    (
        "gap-not-retained",
        "#999999",
        "gap lost before the load zone",
    ),
    ("failed", "#444444", "run failed"),
    ("eq-9", "#ffffff", ""),
];

/// Width of the range of too shallow raceways shown, over that of the others.
const SHALLOW_SHOWN: f64 = 0.4;
/// Panels beside each other at most.
const ACROSS: usize = 3;

/// The maps, slowest first.
fn by_speed(search: &Record) -> Vec<&Record> {
    let mut maps: Vec<&Record> = search.parts("maps").iter().collect();
    maps.sort_by(|a, b| speed_rpm(a).total_cmp(&speed_rpm(b)));
    maps
}

fn speed_rpm(map: &Record) -> f64 {
    map.part("point")
        .map_or(f64::NAN, |p| p.number("inner_speed_rpm"))
}

/// Verdicts of a map, row by row.
fn verdicts_of(map: &Record) -> Vec<Vec<&str>> {
    let rows = map.items("verdict").iter();
    rows.map(|row| row.items().iter().filter_map(Cell::text).collect())
        .collect()
}

/// Panels of maps: place of each, size of the figure.
struct Grid {
    x: Vec<[f64; 2]>,
    y: Vec<[f64; 2]>,
    across: usize,
}

impl Grid {
    fn new(count: usize) -> Self {
        let across = count.clamp(1, ACROSS);
        let down = count.div_ceil(across).max(1);
        let mut y = panels(down, 0.2);
        y.reverse();
        Self {
            x: panels(across, 0.07),
            y,
            across,
        }
    }

    fn height_px(&self) -> u32 {
        110 + 330 * self.y.len() as u32
    }

    fn place(&self, k: usize) -> ([f64; 2], [f64; 2]) {
        (self.x[k % self.across], self.y[k / self.across])
    }
}

/// Lower end of the axis of spans: of the raceways that are too shallow everywhere, some
/// are enough.
fn shown_from_mm(search: &Record) -> f64 {
    let (mut works, mut widest) = (f64::INFINITY, 0.0f64);
    for map in search.parts("maps") {
        for row in verdicts_of(map) {
            for (span, verdict) in map.values("axial_span_mm").iter().zip(row) {
                widest = widest.max(*span);
                if !["insufficient-separation", "eq-8", "eq-9", "overlap"].contains(&verdict) {
                    works = works.min(*span);
                }
            }
        }
    }
    if works.is_finite() {
        works - SHALLOW_SHOWN * (widest - works)
    } else {
        0.0
    }
}

/// Adds axes, title, Eq. (11), structures and marks of panel `k` over its cells.
fn dress(plot: Plot, grid: &Grid, k: usize, search: &Record, map: &Record) -> Plot {
    let (x_name, y_name) = (axis_name("x", k), axis_name("y", k));
    let (x, y) = (axis_ref("x", k), axis_ref("y", k));
    let (x_place, y_place) = grid.place(k);
    let edges = |values: &[f64]| {
        let (low, high) = range(values);
        let half = (high - low) / (2.0 * (values.len().max(2) - 1) as f64);
        (low - half, high + half)
    };
    let (shown, widest) = (shown_from_mm(search), edges(map.values("axial_span_mm")));
    let spans = json!([number(widest.0.max(shown)), number(widest.1)]);
    let (least, most) = edges(map.values("half_angle_deg"));
    let angles = json!([number(least), number(most)]);
    let first = k.is_multiple_of(grid.across);
    let mut plot = plot
        .axis(
            &x_name,
            "Axial span lC (mm)",
            json!({ "domain": x_place, "anchor": y, "range": spans, "showgrid": false }),
        )
        .axis(
            &y_name,
            if first { "Half angle θ (°)" } else { "" },
            json!({
                "domain": y_place, "anchor": x, "range": angles,
                "showgrid": false, "showticklabels": first,
            }),
        )
        .text(
            &plain(&map.part("point").map_or_else(String::new, point_label)),
            (0.5, 1.02),
            (&format!("{x} domain"), &format!("{y} domain")),
            json!({ "yanchor": "bottom", "font": { "size": 13 } }),
        )
        .trace(on(
            with(
                line(
                    "Eq. (11) for the nominal gap",
                    search.values("curve_axial_span_mm"),
                    search.values("curve_half_angle_deg"),
                    "#000000",
                ),
                json!({ "line": { "width": 2 }, "legendgroup": "eq11", "showlegend": k == 0 }),
            ),
            &x,
            &y,
        ));
    let paper = search.parts("paper");
    if !paper.is_empty() {
        let spans: Vec<f64> = paper.iter().map(|s| s.number("axial_span_mm")).collect();
        let angles: Vec<f64> = paper.iter().map(|s| s.number("half_angle_deg")).collect();
        let letters: Value = paper.iter().map(|s| plain(s.text("letter"))).collect();
        plot = plot.trace(on(
            with(
                markers("structures of the paper", &spans, &angles, "#ffffff"),
                json!({
                    "marker": { "size": 7, "line": { "width": 1.4, "color": "#000" } },
                    "mode": "markers+text", "text": letters, "textposition": "top right",
                    "textfont": { "size": 10 }, "legendgroup": "paper", "showlegend": k == 0,
                    "hovertemplate": "(%{text}) lC %{x} mm, θ %{y}°<extra></extra>",
                }),
            ),
            &x,
            &y,
        ));
    }
    for (name, structure, symbol, colour) in [
        (OWN, search.part("own"), "square", PALETTE[4]),
        ("recommended", search.part("recommended"), "star", "#ffdd00"),
    ] {
        let Some(s) = structure else { continue };
        plot = plot.trace(on(
            with(
                markers(
                    name,
                    &[s.number("axial_span_mm")],
                    &[s.number("half_angle_deg")],
                    colour,
                ),
                json!({
                    "marker": { "size": if symbol == "star" { 15 } else { 9 }, "symbol": symbol,
                                "line": { "width": 1.4, "color": "#000" } },
                    "legendgroup": name, "showlegend": k == 0,
                    "hovertemplate": format!("{name}: lC %{{x}} mm, θ %{{y}}°<extra></extra>"),
                }),
            ),
            &x,
            &y,
        ));
    }
    plot
}

fn frame(grid: &Grid) -> Plot {
    Plot::new(grid.height_px())
        .legend()
        .set("margin", json!({ "l": 64, "r": 24, "t": 104, "b": 58 }))
        .set(
            "legend",
            json!({ "orientation": "h", "x": 0, "y": 1.09, "yanchor": "bottom", "font": { "size": 12 } }),
        )
}

/// Verdict of a structure in the words of the maps; `None` if it was not run.
fn verdict_of(structure: &Record) -> Option<&str> {
    match structure.text("status") {
        "accepted" => Some("smooth"),
        "rejected" => Some(structure.text("reason")),
        _ => None,
    }
}

/// The structures of the band, each at its own place: between the cells of a map lies more than
/// the whole band of raceways that work.
fn tried(search: &Record) -> Value {
    let (mut spans, mut angles) = (vec![], vec![]);
    let (mut colours, mut texts) = (vec![], vec![]);
    for structure in search.parts("band") {
        let verdict = verdict_of(structure);
        let Some(shown) = VERDICTS.iter().find(|v| Some(v.0) == verdict) else {
            continue;
        };
        spans.push(structure.number("axial_span_mm"));
        angles.push(structure.number("half_angle_deg"));
        colours.push(shown.1);
        texts.push(plain(&format!(
            "{}: {}",
            structure_label(structure),
            shown.2
        )));
    }
    with(
        markers("structures tried", &spans, &angles, "#ffffff"),
        json!({
            "showlegend": false,
            "marker": { "size": 6, "color": colours, "line": { "width": 0.8, "color": "#000" } },
            "text": texts, "hovertemplate": "%{text}<extra></extra>",
        }),
    )
}

/// Verdict of every cell, one panel per speed.
pub fn verdicts(search: &Record) -> Figure {
    let grid = Grid::new(search.parts("maps").len());
    let mut plot = frame(&grid);
    let count = VERDICTS.len() as f64;
    // Bands of one colour each.
    let scale: Vec<Value> = VERDICTS
        .iter()
        .enumerate()
        .flat_map(|(k, (_, colour, _))| {
            let k = k as f64;
            [
                json!([number(k / count), colour]),
                json!([number((k + 1.0) / count), colour]),
            ]
        })
        .collect();
    for (k, map) in by_speed(search).into_iter().enumerate() {
        let verdicts = verdicts_of(map);
        let codes: Vec<Vec<Value>> = verdicts
            .iter()
            .map(|row| {
                row.iter()
                    .map(|name| {
                        let code = VERDICTS.iter().position(|v| v.0 == *name);
                        // Eq. (8), (9) and overlaps stay blank.
                        code.filter(|&c| c + 1 < VERDICTS.len())
                            .map_or(Value::Null, |c| json!(c as f64 + 0.5))
                    })
                    .collect()
            })
            .collect();
        plot = plot.trace(on(
            json!({
                "type": "heatmap", "x": numbers(map.values("axial_span_mm")), "y": numbers(map.values("half_angle_deg")),
                "z": codes, "text": verdicts, "zmin": 0, "zmax": count, "colorscale": scale,
                "showscale": false, "name": "verdict",
                "hovertemplate": "lC %{x} mm, θ %{y}°: %{text}<extra></extra>",
            }),
            &axis_ref("x", k),
            &axis_ref("y", k),
        ));
        let speed = speed_rpm(map);
        if search
            .parts("points")
            .iter()
            .any(|p| p.number("inner_speed_rpm") == speed)
        {
            let (x, y) = (axis_ref("x", k), axis_ref("y", k));
            plot = plot.trace(on(tried(search), &x, &y));
        }
        plot = dress(plot, &grid, k, search, map);
    }
    let in_maps = |name: &str| {
        let mut cells = search.parts("maps").iter().flat_map(verdicts_of).flatten();
        cells.any(|verdict| verdict == name)
    };
    let slips = in_maps("slips");
    for (name, colour, label) in &VERDICTS[..VERDICTS.len() - 1] {
        if in_maps(name)
            || search
                .parts("band")
                .iter()
                .any(|s| verdict_of(s) == Some(*name))
        {
            plot = plot.trace(with(
                markers(label, &[f64::NAN], &[f64::NAN], colour),
                json!({ "marker": { "symbol": "square", "size": 12 } }),
            ));
        }
    }
    Figure {
        label: "Design map, verdicts".to_owned(),
        caption: format!(
            "Feasible designs and reasons for exclusion: too shallow to spread \
                  the balls, sliding balls, a critical gap above the steady gap, or double \
                  collisions. Blank: excluded by Eq. (8) or (9), or \
                  raceways that overlap. Cells have the verdict of their middle; circles are structures that \
                  were tried, each at its own place, with all requirements at all operating \
                  points.{} Double-click to see all spans.",
            if slips {
                " Sliding takes over from the right, where raceways are short and deep, and reaches \
                 further at higher speed."
            } else {
                ""
            }
        ),
        provenance: search.provenance.clone().unwrap_or_default(),
        plot,
    }
}

/// Critical gap of every cell, one panel per speed.
pub fn critical_gaps(search: &Record) -> Figure {
    let grid = Grid::new(search.parts("maps").len());
    let least = search.number("critical_gap_min_fraction");
    let mut plot = frame(&grid).set(
        "coloraxis",
        json!({
            "cmin": 0, "cmax": 1.5, "colorscale": "Viridis",
            "colorbar": { "title": { "text": "over steady gap", "side": "right" }, "thickness": 14, "tickformat": ".0%" },
        }),
    );
    for (k, map) in by_speed(search).into_iter().enumerate() {
        let mut fractions: Vec<Vec<Value>> = vec![];
        let mut texts: Vec<Vec<String>> = vec![];
        let steady = map.items("steady_gap_deg").iter().map(Cell::items);
        for (gaps, steady) in map
            .items("critical_gap_deg")
            .iter()
            .map(Cell::items)
            .zip(steady)
        {
            fractions.push(
                gaps.iter()
                    .zip(steady)
                    .map(|(gap, steady)| match (gap.number(), steady.number()) {
                        (Some(gap), Some(steady)) => number(gap / steady),
                        _ => Value::Null,
                    })
                    .collect(),
            );
            texts.push(
                gaps.iter()
                    .map(|g| crate::text::fixed(g.number(), 3))
                    .collect(),
            );
        }
        let (x, y) = (axis_ref("x", k), axis_ref("y", k));
        let cells = json!({ "x": numbers(map.values("axial_span_mm")), "y": numbers(map.values("half_angle_deg")), "z": fractions });
        plot = plot
            .trace(on(
                with(
                    cells.clone(),
                    json!({
                        "type": "heatmap", "coloraxis": "coloraxis", "text": texts, "name": "critical gap",
                        "hovertemplate": "lC %{x} mm, θ %{y}°: critical gap %{text}°, %{z:.0%} of the steady gap<extra></extra>",
                    }),
                ),
                &x,
                &y,
            ))
            .trace(on(
                with(
                    cells,
                    json!({
                        "type": "contour", "showscale": false, "hoverinfo": "skip", "showlegend": false,
                        "contours": { "coloring": "none", "start": number(least), "end": 1.0,
                                      "size": number(1.0 - least), "showlabels": true,
                                      "labelfont": { "size": 10, "color": "#fff" }, "labelformat": ".0%" },
                        "line": { "color": "#fff", "width": 1.6 },
                    }),
                ),
                &x,
                &y,
            ));
        plot = dress(plot, &grid, k, search, map);
    }
    Figure {
        label: "Design map, critical gap".to_owned(),
        caption: format!(
            "Critical gap over steady gap (colour, cut off at 150 %). White lines: {:.0} % and \
             100 %, between which a raceway spreads the balls and leaves room in steady flow.",
            100.0 * least
        ),
        provenance: search.provenance.clone().unwrap_or_default(),
        plot,
    }
}
