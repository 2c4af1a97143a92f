//! Outer rings compared: bars with standard errors.

use cageless_io::estimate::Estimate;
use serde_json::{Value, json};

use super::panels::{axis_name, axis_ref, on, panels};
use crate::comparison::{ComparisonCell, RingComparison};
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, number, plain};

/// A quantity of a cell.
type Quantity = fn(&ComparisonCell) -> Estimate;

/// Panels from the top down.
const ROWS: [(&str, Quantity); 6] = [
    ("RMS<br>(m/s²)", |c| c.rms_m_s2),
    ("At passing<br>(m/s²)", |c| c.rms_at_passing_m_s2),
    ("Between<br>(m/s²)", |c| c.rms_between_m_s2),
    ("Contacts cut<br>out (m/s²)", |c| {
        c.rms_without_contacts_m_s2
    }),
    ("SD of gaps<br>(°)", |c| c.gap_deviation_deg),
    ("Contacts<br>(1/s)", |c| c.contacts_per_s),
];

/// A panel per quantity and speed, grouped by lot, a bar per ring.
pub fn comparison(comparison: &RingComparison) -> Figure {
    let speeds = comparison.speeds_rpm();
    let across = panels(speeds.len(), 0.16);
    let down = panels(ROWS.len(), 0.035);
    let mut plot = Plot::new(980)
        .legend()
        .set("barmode", json!("group"))
        .set("margin", json!({ "l": 72, "r": 16, "t": 84, "b": 48 }));
    // Above the titles of the columns.
    plot = plot.set(
        "legend",
        json!({ "orientation": "h", "x": 0, "y": 1.04, "yanchor": "bottom", "font": { "size": 12 } }),
    );
    for (column, &speed_rpm) in speeds.iter().enumerate() {
        let cells: Vec<&ComparisonCell> = comparison.at_speed(speed_rpm).collect();
        let mut rings: Vec<&str> = vec![];
        for cell in &cells {
            if !rings.contains(&cell.ring.as_str()) {
                rings.push(&cell.ring);
            }
        }
        for (row, (title, quantity)) in ROWS.iter().enumerate() {
            let panel = row * speeds.len() + column;
            let (x, y) = (axis_ref("x", panel), axis_ref("y", panel));
            let [low, high] = down[ROWS.len() - 1 - row];
            let last = row + 1 == ROWS.len();
            plot = plot
                .axis(
                    &axis_name("x", panel),
                    "",
                    json!({ "anchor": y, "domain": across[column], "showticklabels": last, "type": "category" }),
                )
                .axis(
                    &axis_name("y", panel),
                    title,
                    json!({ "anchor": x, "domain": [low, high], "rangemode": "tozero", "nticks": 5, "title": { "font": { "size": 12 } } }),
                );
            if row == 0 {
                plot = plot.text(
                    &format!("<b>{} rpm</b>", speed_rpm),
                    (0.5, 1.02),
                    (&format!("{x} domain"), &format!("{y} domain")),
                    json!({ "yanchor": "bottom" }),
                );
            }
            for (k, ring) in rings.iter().enumerate() {
                let bars: Vec<&&ComparisonCell> =
                    cells.iter().filter(|c| c.ring == **ring).collect();
                let lots: Value = bars.iter().map(|c| plain(&c.lot)).collect();
                let estimates: Vec<Estimate> = bars.iter().map(|c| quantity(c)).collect();
                let means: Value = estimates.iter().map(|e| number(e.mean)).collect();
                let errors: Value = estimates.iter().map(|e| number(e.standard_error)).collect();
                let trace = json!({
                    "type": "bar", "name": plain(ring), "legendgroup": plain(ring),
                    "showlegend": panel == 0, "x": lots, "y": means,
                    "error_y": { "type": "data", "array": errors, "thickness": 1.2, "width": 3 },
                    "marker": { "color": PALETTE[k % PALETTE.len()] },
                    "hovertemplate": "%{x}: %{y}<extra>%{fullData.name}</extra>",
                });
                plot = plot.trace(on(trace, &x, &y));
            }
        }
    }
    Figure {
        label: "Rings compared".to_owned(),
        caption: format!(
            "Vertical acceleration of the housing (RMS), its part at the multiples of the orbital \
             frequency and the part between them, the RMS with the contacts between balls cut out \
             of the force, standard deviation (SD) of the gaps at the end, \
             and contacts between balls per second: means over the starts with their standard \
             errors, for equal balls and lots of grades of ISO 3290-1. {}",
            comparison.starts
        ),
        provenance: comparison.provenance.clone(),
        plot,
    }
}
