//! Orbital speed of a ball along the discrete raceway, small multiples (Fig. 9).

use serde_json::json;

use super::panels::{Panel, Space, panel_title};
use crate::figure::Figure;
use crate::plot::{Margin, PALETTE, Plot, SECTOR, line_of, with};
use crate::reproduce_data::OrbitSpeeds;
use crate::sampling::history;

/// Points of one of ten passages.
const PASSAGE_POINTS: usize = 1500;
/// Panels in a row.
const COLUMNS: usize = 5;

/// Space between the panels.
const SPACE: Space = Space {
    across: 0.02,
    down: 0.24,
};

/// Fig. 9: orbital speed against ψ with that of pure rolling.
pub fn speeds(speeds: &OrbitSpeeds) -> Figure {
    let count = speeds.passages.len();
    let rows = count.div_ceil(COLUMNS).max(1);
    let mut plot = Plot::new(260 * rows as u32 + 60)
        .margin(Margin {
            left: 74,
            right: 12,
            top: 84,
            bottom: 54,
        })
        .legend_above(1.115);
    for (panel, passage) in Panel::grid(count, COLUMNS, SPACE)
        .iter()
        .zip(&speeds.passages)
    {
        let (axes, first) = (panel.axes(), panel.first);
        let theta = passage.structure.half_angle_deg;
        let axis = |shown: bool, shared: &str| {
            let matches = (!first).then_some(shared);
            json!({
                "tickfont": { "size": 11 }, "automargin": false, "showticklabels": shown,
                "matches": matches,
            })
        };
        let across = with(axis(panel.lowest, "x"), json!({ "nticks": 5 }));
        let up = with(axis(panel.leftmost, "y"), json!({ "tickformat": ",.0f" }));
        let titles = [
            panel.at_bottom("ψ (°)"),
            panel.at_left("Orbital speed (°/s)"),
        ];
        let title = panel_title(&passage.structure, &passage.verdict);
        plot = plot
            .panel(panel, titles, [across, up])
            .band(axes.x, axes.y, -theta, theta, SECTOR)
            .title_above(panel, &title, json!({ "size": 11.5 }));
        let drawn = |name, speeds: &[f64], colour| {
            line_of(
                name,
                history(&passage.angle_deg, speeds, PASSAGE_POINTS),
                colour,
            )
            .on(axes)
        };
        if !passage.rolling_deg_s.is_empty() {
            let rolling = drawn("pure rolling, Eq. (3)", &passage.rolling_deg_s, PALETTE[1]);
            plot = plot.trace(rolling.dash("dash").in_group("r", first));
        }
        let simulated = drawn("simulated", &passage.speed_deg_s, PALETTE[0]);
        plot = plot.trace(simulated.in_group("s", first));
    }
    let caption = "Orbital speed of a ball against its place ψ on the way through the discrete \
                  raceway (shaded), with the speed of pure rolling at that place. Where the two \
                  part, the ball slides.";
    Figure::of_paper("Figure 9", caption, &speeds.provenance, plot)
}
