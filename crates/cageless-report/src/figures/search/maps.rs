//! Maps of a search: verdicts and critical gaps over span and half angle.

use serde_json::{Value, json};

use super::OWN;
use cageless_design::search::Cause;
use cageless_results::{Cell, Record};
use cageless_study::search::{point_label, structure_label};

use crate::figure::Figure;
use crate::figures::panels::{Panel, Space};
use crate::plot::{Margin, PALETTE, Plot, Trace, line, markers, number, numbers, plain, with};
use crate::sampling::range;

/// Verdicts of a map, each with its colour and its name in the legend.
const VERDICTS: [(&str, &str, &str); 11] = [
    ("smooth", "#009e73", "works"),
    ("insufficient-separation", "#dcdcdc", "too shallow"),
    ("slips", "#d55e00", "balls slide too much"),
    (
        "excessive-separation",
        "#56b4e9",
        "too deep: three balls meet",
    ),
    ("double-collision", "#f0e442", "double collision"),
    ("stress", "#cc79a7", "contact pressure"),
    ("gross-sliding", "#7f3b08", "balls slide over it"),
    ("loses-lag", "#0072b2", "lag lost"),
    ("gap-not-retained", "#999999", "balls close up again"),
    ("failed", "#444444", "a run stopped"),
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

/// Space between the panels.
const SPACE: Space = Space {
    across: 0.07,
    down: 0.2,
};

/// A panel for each map, slowest first, and the empty plot around them.
fn panels(search: &Record) -> (Plot, Vec<(Panel, &Record)>) {
    let maps = by_speed(search);
    let across = maps.len().clamp(1, ACROSS);
    let down = maps.len().div_ceil(across).max(1);
    let plot = Plot::new(110 + 330 * down as u32)
        .legend_above(1.09)
        .margin(Margin {
            left: 64,
            top: 104,
            ..Margin::default()
        });
    let panels = Panel::grid(maps.len(), across, SPACE).into_iter();
    (plot, panels.zip(maps).collect())
}

/// Lower end of the axis of spans: of the raceways that are too shallow everywhere, some
/// are enough.
fn shown_from_mm(search: &Record) -> f64 {
    let (mut works, mut widest) = (f64::INFINITY, 0.0f64);
    for map in search.parts("maps") {
        for row in verdicts_of(map) {
            for (span, verdict) in map.values("axial_span_mm").iter().zip(row) {
                widest = widest.max(*span);
                if !["insufficient-separation", "eq-8", "eq-9", "slot", "overlap"]
                    .contains(&verdict)
                {
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

/// Adds axes, title, Eq. (11), structures and marks of a panel over its cells.
fn dress(plot: Plot, panel: &Panel, search: &Record, map: &Record) -> Plot {
    let edges = |name: &str| {
        let values = map.values(name);
        let (low, high) = range(values);
        let half = (high - low) / (2.0 * (values.len().max(2) - 1) as f64);
        [low - half, high + half]
    };
    let [narrowest, widest] = edges("axial_span_mm");
    let spans = numbers(&[narrowest.max(shown_from_mm(search)), widest]);
    let angles = numbers(&edges("half_angle_deg"));
    let half_angle = panel.at_left("Half angle θ (°)");
    let more = [
        json!({ "range": spans, "showgrid": false }),
        json!({ "range": angles, "showgrid": false, "showticklabels": panel.leftmost }),
    ];
    let point = map.part("point").map_or_else(String::new, point_label);
    let eq_11 = line(
        "Eq. (11) for the nominal gap",
        search.values("curve_axial_span_mm"),
        search.values("curve_half_angle_deg"),
        "#000000",
    );
    let mut plot = plot
        .panel(panel, ["Axial span lC (mm)", half_angle], more)
        .title_above(panel, &plain(&point), json!({ "size": 13 }))
        .trace(
            eq_11
                .width(2.0)
                .in_group("eq11", panel.first)
                .on(panel.axes()),
        );
    let dots = |name: &str, structures: &[&Record], colour: &str, size: u32| {
        let of = |key: &str| -> Vec<f64> { structures.iter().map(|s| s.number(key)).collect() };
        let outlined = json!({ "size": size, "line": { "width": 1.4, "color": "#000" } });
        markers(name, &of("axial_span_mm"), &of("half_angle_deg"), colour)
            .with(json!({ "marker": outlined }))
            .on(panel.axes())
    };
    let paper: Vec<&Record> = search.parts("paper").iter().collect();
    if !paper.is_empty() {
        let letters: Value = paper.iter().map(|s| plain(s.text("letter"))).collect();
        let structures = dots("structures of the paper", &paper, "#ffffff", 7);
        plot = plot.trace(structures.in_group("paper", panel.first).with(json!({
            "mode": "markers+text", "text": letters, "textposition": "top right",
            "textfont": { "size": 10 }, "hovertemplate": "(%{text}) lC %{x} mm, θ %{y}°<extra></extra>",
        })));
    }
    for (name, structure, symbol, size, colour) in [
        (OWN, search.part("own"), "square", 9, PALETTE[4]),
        (
            "recommended",
            search.part("recommended"),
            "star",
            15,
            "#ffdd00",
        ),
    ] {
        let Some(structure) = structure else { continue };
        let mark = dots(name, &[structure], colour, size).in_group(name, panel.first);
        plot = plot.trace(mark.with(json!({
            "marker": { "symbol": symbol },
            "hovertemplate": format!("{name}: lC %{{x}} mm, θ %{{y}}°<extra></extra>"),
        })));
    }
    plot
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
fn tried(search: &Record) -> Trace {
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
        let label = structure_label(structure);
        let why = match structure.text("why") {
            "" => shown.2,
            why => why,
        };
        texts.push(plain(&format!("{label}: {why}")));
    }
    markers("structures tried", &spans, &angles, "#ffffff").with(json!({
        "showlegend": false,
        "marker": { "size": 6, "color": colours, "line": { "width": 0.8, "color": "#000" } },
        "text": texts, "hovertemplate": "%{text}<extra></extra>",
    }))
}

/// Meaning of a verdict on structures, in words.
fn in_words(verdict: &str) -> &str {
    let kind = Cause::kinds().find(|kind| kind.name == verdict);
    kind.map_or(VERDICTS[0].2, |kind| kind.meaning)
}

/// A trace over the cells of a map.
fn cells(panel: &Panel, map: &Record, more: Value) -> Trace {
    let [spans, angles] = ["axial_span_mm", "half_angle_deg"].map(|name| numbers(map.values(name)));
    let places = json!({ "x": spans, "y": angles });
    Trace::from(with(places, more)).on(panel.axes())
}

/// Verdict of every cell, one panel per speed.
pub fn verdicts(search: &Record) -> Figure {
    let (mut plot, panels) = panels(search);
    let count = VERDICTS.len() as f64;
    // Bands of one colour each.
    let scale = VERDICTS.iter().zip(0..).flat_map(|((_, colour, _), k)| {
        let k = f64::from(k);
        [k, k + 1.0].map(|edge| json!([number(edge / count), colour]))
    });
    let scale: Vec<Value> = scale.collect();
    // Eq. (8), (9) and overlaps stay blank.
    let code = |name: &&str| {
        let code = VERDICTS.iter().position(|v| v.0 == *name);
        code.filter(|&c| c + 1 < VERDICTS.len())
            .map(|c| c as f64 + 0.5)
    };
    for (panel, map) in &panels {
        let verdicts = verdicts_of(map);
        let codes = verdicts.iter().map(|row| row.iter().map(code).collect());
        let codes: Vec<Vec<Option<f64>>> = codes.collect();
        let words = |row: &Vec<&str>| row.iter().map(|name| plain(in_words(name))).collect();
        let texts: Vec<Value> = verdicts.iter().map(words).collect();
        plot = plot.trace(cells(panel, map, json!({
            "type": "heatmap", "z": codes, "text": texts, "zmin": 0, "zmax": count, "colorscale": scale,
            "showscale": false, "name": "verdict",
            "hovertemplate": "lC %{x} mm, θ %{y}°: %{text}<extra></extra>",
        })));
        let (speed, mut points) = (speed_rpm(map), search.parts("points").iter());
        if points.any(|p| p.number("inner_speed_rpm") == speed) {
            plot = plot.trace(tried(search).on(panel.axes()));
        }
        plot = dress(plot, panel, search, map);
    }
    let in_maps = |name: &str| {
        let mut cells = search.parts("maps").iter().flat_map(verdicts_of).flatten();
        cells.any(|verdict| verdict == name)
    };
    let slips = in_maps("slips");
    for (name, colour, label) in &VERDICTS[..VERDICTS.len() - 1] {
        let mut band = search.parts("band").iter();
        if in_maps(name) || band.any(|s| verdict_of(s) == Some(*name)) {
            let square = json!({ "marker": { "symbol": "square", "size": 12 } });
            plot = plot.trace(markers(label, &[f64::NAN], &[f64::NAN], colour).with(square));
        }
    }
    let caption = format!(
        "Raceways that work, and what is wrong with others. Blank: excluded by Eq. (8) or (9), or \
                  raceways that overlap. Cells have the verdict of their middle; circles are structures that \
                  were tried, each at its own place, with all requirements at all operating \
                  points.{} Double-click to see all spans.",
        if slips {
            " Sliding takes over from the right, where raceways are short and deep, and reaches \
                 further at higher speed."
        } else {
            ""
        }
    );
    Figure::of_record("Design map, verdicts", &caption, search, plot)
}

/// Critical gap of every cell, one panel per speed.
pub fn critical_gaps(search: &Record) -> Figure {
    let (plot, panels) = panels(search);
    let least = search.number("critical_gap_min_fraction");
    let mut plot = plot.set(
        "coloraxis",
        json!({
            "cmin": 0, "cmax": 1.5, "colorscale": "Viridis",
            "colorbar": { "title": { "text": "over steady gap", "side": "right" }, "thickness": 14, "tickformat": ".0%" },
        }),
    );
    for (panel, map) in &panels {
        let rows = |name: &str| map.items(name).iter().map(Cell::items);
        let fraction =
            |(gap, steady): (&Cell, &Cell)| Some(number(gap.number()? / steady.number()?));
        let fractions = rows("critical_gap_deg").zip(rows("steady_gap_deg"));
        let fractions =
            fractions.map(|(gaps, steady)| gaps.iter().zip(steady).map(fraction).collect());
        let fractions: Vec<Vec<Option<Value>>> = fractions.collect();
        let text = |gap: &Cell| crate::text::fixed(gap.number(), 3);
        let texts = rows("critical_gap_deg").map(|gaps| gaps.iter().map(text).collect());
        let texts: Vec<Vec<String>> = texts.collect();
        plot = plot
            .trace(cells(panel, map, json!({
                "type": "heatmap", "coloraxis": "coloraxis", "z": fractions, "text": texts, "name": "critical gap",
                "hovertemplate": "lC %{x} mm, θ %{y}°: critical gap %{text}°, %{z:.0%} of the steady gap<extra></extra>",
            })))
            .trace(cells(panel, map, json!({
                "type": "contour", "z": fractions, "showscale": false, "hoverinfo": "skip", "showlegend": false,
                "contours": { "coloring": "none", "start": number(least), "end": 1.0,
                              "size": number(1.0 - least), "showlabels": true,
                              "labelfont": { "size": 10, "color": "#fff" }, "labelformat": ".0%" },
                "line": { "color": "#fff", "width": 1.6 },
            })));
        plot = dress(plot, panel, search, map);
    }
    let caption = format!(
        "Critical gap over steady gap (colour, cut off at 150 %). White lines: {:.0} % and \
             100 %, between which a raceway spreads the balls and leaves room in steady flow.",
        100.0 * least
    );
    Figure::of_record("Design map, critical gap", &caption, search, plot)
}
