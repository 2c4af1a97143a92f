//! Gaps between balls: one pair over time (Fig. 6), three neighbours (Fig. 7).

use serde_json::json;

use super::panels::Panel;
use crate::data::Event;
use crate::figure::Figure;
use crate::plot::{Axes, PALETTE, POINTS, Plot, line_of, plain};
use crate::reproduce_data::{GapHistory, Neighbours};
use crate::sampling::history;

/// Fig. 6: gap of one pair, all of the run and one turn enlarged.
pub fn gap_history(gap: &GapHistory) -> Figure {
    let (start, ms, time_after) = enlarged(&gap.turn_time_s);
    let begin = gap.time_s.first().copied().unwrap_or_default();
    let run = history(&gap.time_s, &gap.gap_deg, POINTS);
    let turn = history(&ms, &gap.turn_gap_deg, POINTS);
    let [whole, enlarged] = [0, 1].map(Panel::new);
    let place = |low: f64, high: f64| [json!({}), json!({ "domain": [low, high] })];
    let mut plot = Plot::new(640)
        .panel(&whole, ["Time t (s)", "Gap (°)"], place(0.6, 1.0))
        .panel(&enlarged, [&time_after, "Gap (°)"], place(0.0, 0.42))
        .discarded("x", "y", begin, gap.settled_after_s)
        .trace(line_of("gap", run, PALETTE[0]))
        .trace(line_of("gap, one turn", turn, PALETTE[0]).on(enlarged.axes()));
    if let Some(&end) = gap.turn_time_s.last() {
        plot = plot.band("x", "y", start, end, "rgba(213,94,0,0.35)");
    }
    for (x, y) in [("x", "y"), ("x2", "y2")] {
        plot = plot
            .horizontal(x, y, gap.uniform_gap_deg, "dot")
            .horizontal(x, y, 0.0, "solid");
    }
    plot = plot.text(
        &plain(&format!("β0 = {:.4}°", gap.uniform_gap_deg)),
        (0.03, gap.uniform_gap_deg),
        ("x2 domain", "y2"),
        json!({ "xanchor": "left", "yanchor": "bottom", "font": { "size": 11 } }),
    );
    let above = Labels {
        x: "x2",
        y: "y2",
        reference: "y2 domain",
        height: 1.0,
    };
    let (plot, meanings) = marked(plot, &gap.stages, start, &above);
    let caption = format!(
        "Gap between ball {} and the ball ahead, {}. Above: the whole run, the transient \
             shaded grey; below: the turn shaded orange, enlarged.{}",
        gap.ball,
        gap.structure.label(),
        meanings
    );
    Figure::of_paper("Figure 6", &caption, &gap.provenance, plot)
}

/// Fig. 7: orbital speeds and gaps of three neighbours through the raceway.
pub fn neighbours(three: &Neighbours) -> Figure {
    let (start, ms, time_after) = enlarged(&three.time_s);
    let mut plot = Plot::new(640)
        .legend_above(1.03)
        .x(&time_after, json!({ "anchor": "y2" }))
        .y("Orbital speed (°/s)", json!({
            "domain": [0.54, 0.96], "anchor": "x", "separatethousands": true, "tickformat": ",.0f",
        }))
        .axis("yaxis2", "Gap (°)", json!({ "domain": [0.0, 0.48], "anchor": "x" }));
    let names = ["i−1", "i", "i+1"];
    let dashes = ["dash", "solid", "dot"];
    for k in 0..3 {
        let name = format!("ball {} (number {})", names[k], three.balls[k]);
        let speed = history(&ms, &three.orbit_speed_deg_s[k], POINTS);
        plot = plot.trace(line_of(&name, speed, PALETTE[k]).dash(dashes[k]).width(1.8));
    }
    for k in 0..2 {
        let name = format!("gap {} to {}", names[k], names[k + 1]);
        let gap = history(&ms, &three.gap_deg[k], POINTS);
        let gap = line_of(&name, gap, [PALETTE[3], "#111111"][k]);
        plot = plot.trace(gap.width(1.8).on(Axes { x: "x", y: "y2" }));
    }
    plot = plot.horizontal("x", "y2", 0.0, "solid");
    let on_paper = Labels {
        x: "x",
        y: "paper",
        reference: "paper",
        height: 0.97,
    };
    let (plot, meanings) = marked(plot, &three.events, start, &on_paper);
    let caption = format!(
        "Three neighbours on their way through the discrete raceway, {}: orbital speeds \
             above, gaps below.{}",
        three.structure.label(),
        meanings
    );
    Figure::of_paper("Figure 7", &caption, &three.provenance, plot)
}

/// Begin of a stretch of time in s, its times from there on in ms, and the title of their axis.
fn enlarged(time_s: &[f64]) -> (f64, Vec<f64>, String) {
    let start = time_s.first().copied().unwrap_or_default();
    let ms = time_s.iter().map(|t| (t - start) * 1e3).collect();
    (start, ms, format!("Time after t = {start:.5} s (ms)"))
}

/// Axes of events, and where their labels stand.
struct Labels<'a> {
    x: &'a str,
    y: &'a str,
    /// Reference of the height.
    reference: &'a str,
    height: f64,
}

/// The plot with a line and a label at each event, and the meanings of the events for its caption.
fn marked(mut plot: Plot, events: &[Event], start_s: f64, labels: &Labels<'_>) -> (Plot, String) {
    let mut meanings = vec![];
    for event in events {
        let at = (event.time_s - start_s) * 1e3;
        let label = format!("<b>{}</b>", plain(&event.label));
        let bottom = json!({ "yanchor": "bottom" });
        plot = plot.vertical(labels.x, labels.y, at, "dash");
        let references = (labels.x, labels.reference);
        plot = plot.text(&label, (at, labels.height), references, bottom);
        if !event.meaning.is_empty() {
            meanings.push(format!(" {}: {}", event.label, event.meaning));
        }
    }
    (plot, meanings.join(";"))
}
