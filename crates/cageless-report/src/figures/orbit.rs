//! Orbital speed of a ball along the discrete raceway, small multiples (Fig. 9).

use serde_json::json;

use super::panels::{axis_name, axis_ref, labelled, on, panel_title, panels};
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, SECTOR, line, with};
use crate::reproduce_data::OrbitSpeeds;
use crate::sampling::history;

/// Points of one of ten passages.
const PASSAGE_POINTS: usize = 1500;
/// Panels in a row.
const COLUMNS: usize = 5;

/// Fig. 9: orbital speed against ψ with that of pure rolling.
pub fn speeds(speeds: &OrbitSpeeds) -> Figure {
    let count = speeds.passages.len();
    let rows = count.div_ceil(COLUMNS).max(1);
    let (across, down) = (panels(COLUMNS, 0.02), panels(rows, 0.24));
    let mut plot = Plot::new(260 * rows as u32 + 60)
        .set("margin", json!({ "l": 74, "r": 12, "t": 84, "b": 54 }))
        .set("showlegend", true.into())
        .set(
            "legend",
            json!({
                "orientation": "h", "x": 0, "y": 1.115, "yanchor": "bottom", "font": { "size": 12 },
            }),
        );
    for (k, passage) in speeds.passages.iter().enumerate() {
        let (row, column) = (k / COLUMNS, k % COLUMNS);
        let (x, y) = (axis_ref("x", k), axis_ref("y", k));
        let lowest = k + COLUMNS >= count;
        let theta = passage.structure.half_angle_deg;
        let small = json!({ "tickfont": { "size": 11 }, "automargin": false });
        let first = k == 0;
        plot = plot
            .axis(
                &axis_name("x", k),
                if lowest { "ψ (°)" } else { "" },
                with(
                    small.clone(),
                    json!({
                        "domain": across[column], "anchor": y, "showticklabels": lowest,
                        "matches": if first { None } else { Some("x") }, "nticks": 5,
                    }),
                ),
            )
            .axis(
                &axis_name("y", k),
                if column == 0 {
                    "Orbital speed (°/s)"
                } else {
                    ""
                },
                with(
                    small,
                    json!({
                        "domain": down[rows - 1 - row], "anchor": x, "showticklabels": column == 0,
                        "matches": if first { None } else { Some("y") }, "tickformat": ",.0f",
                    }),
                ),
            )
            .band(&x, &y, -theta, theta, SECTOR)
            .text(
                &panel_title(&passage.structure, &passage.verdict),
                (0.5, 1.02),
                (&format!("{x} domain"), &format!("{y} domain")),
                json!({ "yanchor": "bottom", "font": { "size": 11.5 } }),
            );
        if !passage.rolling_deg_s.is_empty() {
            let (px, py) = history(&passage.angle_deg, &passage.rolling_deg_s, PASSAGE_POINTS);
            plot = plot.trace(on(
                with(
                    line("pure rolling, Eq. (3)", &px, &py, PALETTE[1]),
                    json!({ "line": { "dash": "dash" }, "legendgroup": "r", "showlegend": first }),
                ),
                &x,
                &y,
            ));
        }
        let (px, py) = history(&passage.angle_deg, &passage.speed_deg_s, PASSAGE_POINTS);
        plot = plot.trace(on(
            with(
                line("simulated", &px, &py, PALETTE[0]),
                json!({ "legendgroup": "s", "showlegend": first }),
            ),
            &x,
            &y,
        ));
    }
    Figure {
        label: labelled("Figure 9", &speeds.provenance),
        caption: "Orbital speed of a ball against its place ψ on the way through the discrete \
                  raceway (shaded), with the speed of pure rolling at that place. Where the two \
                  part, the ball slides."
            .to_owned(),
        provenance: speeds.provenance.clone(),
        plot,
    }
}
