//! Gaps between balls: one pair over time (Fig. 6), three neighbours (Fig. 7).

use serde_json::json;

use super::panels::{labelled, on};
use crate::figure::Figure;
use crate::plot::{PALETTE, POINTS, Plot, line, plain, with};
use crate::reproduce_data::{GapHistory, Neighbours};
use crate::sampling::history;

/// Fig. 6: gap of one pair, all of the run and one turn enlarged.
pub fn gap_history(gap: &GapHistory) -> Figure {
    let (time, value) = history(&gap.time_s, &gap.gap_deg, POINTS);
    let start = gap.turn_time_s.first().copied().unwrap_or_default();
    let ms: Vec<f64> = gap.turn_time_s.iter().map(|t| (t - start) * 1e3).collect();
    let (turn, turn_value) = history(&ms, &gap.turn_gap_deg, POINTS);
    let begin = time.first().copied().unwrap_or_default();
    let mut plot = Plot::new(640)
        .axis("xaxis", "Time t (s)", json!({ "anchor": "y" }))
        .axis(
            "yaxis",
            "Gap (°)",
            json!({ "domain": [0.6, 1.0], "anchor": "x" }),
        )
        .axis(
            "xaxis2",
            &format!("Time after t = {start:.5} s (ms)"),
            json!({ "anchor": "y2" }),
        )
        .axis(
            "yaxis2",
            "Gap (°)",
            json!({ "domain": [0.0, 0.42], "anchor": "x2" }),
        )
        .discarded("x", "y", begin, gap.settled_after_s)
        .trace(line("gap", &time, &value, PALETTE[0]))
        .trace(on(
            line("gap, one turn", &turn, &turn_value, PALETTE[0]),
            "x2",
            "y2",
        ));
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
    let mut meanings = String::new();
    for stage in &gap.stages {
        let at = (stage.time_s - start) * 1e3;
        plot = plot.vertical("x2", "y2", at, "dash").text(
            &format!("<b>{}</b>", plain(&stage.label)),
            (at, 1.0),
            ("x2", "y2 domain"),
            json!({ "yanchor": "bottom" }),
        );
        if !stage.meaning.is_empty() {
            meanings.push_str(&format!(" {}: {};", stage.label, stage.meaning));
        }
    }
    Figure {
        label: labelled("Figure 6", &gap.provenance),
        caption: format!(
            "Gap between ball {} and the ball ahead, {}. Above: the whole run, the transient \
             shaded grey; below: the turn shaded orange, enlarged.{}",
            gap.ball,
            gap.structure.label(),
            meanings.trim_end_matches(';')
        ),
        provenance: gap.provenance.clone(),
        plot,
    }
}

/// Fig. 7: orbital speeds and gaps of three neighbours through the raceway.
pub fn neighbours(three: &Neighbours) -> Figure {
    let start = three.time_s.first().copied().unwrap_or_default();
    let ms: Vec<f64> = three.time_s.iter().map(|t| (t - start) * 1e3).collect();
    let mut plot = Plot::new(640)
        .legend()
        .axis("xaxis", &format!("Time after t = {start:.5} s (ms)"), json!({ "anchor": "y2" }))
        .axis("yaxis", "Orbital speed (°/s)", json!({
            "domain": [0.54, 0.96], "anchor": "x", "separatethousands": true, "tickformat": ",.0f",
        }))
        .axis("yaxis2", "Gap (°)", json!({ "domain": [0.0, 0.48], "anchor": "x" }))
        .set("legend", json!({
            "orientation": "h", "x": 0, "y": 1.03, "yanchor": "bottom", "font": { "size": 12 },
        }));
    let names = ["i−1", "i", "i+1"];
    let dashes = ["dash", "solid", "dot"];
    for k in 0..3 {
        let (x, y) = history(&ms, &three.orbit_speed_deg_s[k], POINTS);
        let name = format!("ball {} (number {})", names[k], three.balls[k]);
        plot = plot.trace(with(
            line(&name, &x, &y, PALETTE[k]),
            json!({ "line": { "dash": dashes[k], "width": 1.8 } }),
        ));
    }
    for k in 0..2 {
        let (x, y) = history(&ms, &three.gap_deg[k], POINTS);
        let name = format!("gap {} to {}", names[k], names[k + 1]);
        plot = plot.trace(on(
            with(
                line(&name, &x, &y, [PALETTE[3], "#111111"][k]),
                json!({ "line": { "width": 1.8 } }),
            ),
            "x",
            "y2",
        ));
    }
    plot = plot.horizontal("x", "y2", 0.0, "solid");
    let mut meanings = String::new();
    for event in &three.events {
        let at = (event.time_s - start) * 1e3;
        plot = plot.vertical("x", "paper", at, "dash").text(
            &format!("<b>{}</b>", plain(&event.label)),
            (at, 0.97),
            ("x", "paper"),
            json!({ "yanchor": "bottom" }),
        );
        if !event.meaning.is_empty() {
            meanings.push_str(&format!(" {}: {};", event.label, event.meaning));
        }
    }
    Figure {
        label: labelled("Figure 7", &three.provenance),
        caption: format!(
            "Three neighbours on their way through the discrete raceway, {}: orbital speeds \
             above, gaps below.{}",
            three.structure.label(),
            meanings.trim_end_matches(';')
        ),
        provenance: three.provenance.clone(),
        plot,
    }
}
