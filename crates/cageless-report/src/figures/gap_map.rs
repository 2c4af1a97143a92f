//! Gaps of all pairs over the whole run as a map of colours.

use serde_json::{Value, json};

use super::history::{figure, smallest_gap, with_time};
use crate::figure::Figure;
use crate::plot::{Margin, Plot, number, numbers};
use crate::run_data::RunData;
use crate::sampling::range;

/// Columns of the map.
const COLUMNS: usize = 500;
/// From contact over the nominal gap, in the middle, to twice that and more.
const SCALE: [(f64, &str); 5] = [
    (0.0, "#67001f"),
    (0.02, "#b2182b"),
    (0.5, "#f2f2f2"),
    (0.75, "#92c5de"),
    (1.0, "#2166ac"),
];

/// Smallest gap of each pair in each of many stretches of the run.
pub fn gap_map(run: &RunData) -> Option<Figure> {
    let rows = run.time_s.len();
    let (begin, end) = range(&run.time_s);
    if rows < 2 || run.balls.iter().all(|ball| ball.gap_deg.is_empty()) {
        return None;
    }
    let columns = COLUMNS.min(rows);
    let width = (end - begin) / columns as f64;
    let column = |time: f64| (((time - begin) / width) as usize).min(columns - 1);
    let z: Value = run
        .balls
        .iter()
        .map(|ball| {
            let mut least = vec![f64::NAN; columns];
            for (time, gap) in run.time_s.iter().zip(&ball.gap_deg) {
                // `min` leaves out what is not a number.
                let cell = &mut least[column(*time)];
                *cell = cell.min(*gap);
            }
            numbers(&least)
        })
        .collect();
    let (count, row) = (run.balls.len(), run.outline.balls.max(1));
    let pairs: Value = (0..count)
        .map(|k| format!("{}–{}", k + 1, k - k % row + (k + 1) % row + 1))
        .collect();
    let middles: Vec<f64> = (0..columns)
        .map(|k| begin + (k as f64 + 0.5) * width)
        .collect();
    let plot = with_time(run, Plot::new(130 + 22 * count.clamp(8, 30) as u32), "y")
        .margin(Margin::above(24))
        .y(
            "Pair of balls (numbers)",
            json!({ "type": "category", "showgrid": false, "ticks": "" }),
        )
        .trace(json!({
            "type": "heatmap", "x": numbers(&middles), "y": pairs, "z": z, "name": "gap",
            "zmin": 0, "zmax": number(2.0 * run.uniform_gap_deg), "colorscale": SCALE,
            "colorbar": { "title": { "text": "Gap (°)", "side": "right" }, "thickness": 14 },
            "hovertemplate": "balls %{y}<br>t %{x:.4f} s<br>smallest gap %{z:.4f}°<extra></extra>",
        }))
        .finding(&smallest_gap(run))
        // The whole run is what this figure is for.
        .last_view_first();
    let caption = "Smallest gap of each pair in each of many stretches of the run: red is contact, grey the \
         nominal gap, blue twice that and more.";
    Some(figure(run, "Gaps of all pairs", caption, plot))
}
