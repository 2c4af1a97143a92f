//! Outer rings compared: bars with standard errors.

use cageless_io::estimate::Estimate;
use serde_json::{Value, json};

use super::panels::{Panel, Space};
use crate::comparison::{ComparisonCell, RingComparison};
use crate::figure::Figure;
use crate::plot::{Margin, PALETTE, Plot, Trace, number, plain};

/// A quantity of a cell.
type Quantity = fn(&ComparisonCell) -> Estimate;

/// Panels from the top down.
const ROWS: [(&str, Quantity); 6] = [
    ("RMS<br>(m/s²)", |c| c.numbers.rms_m_s2),
    ("At passing<br>(m/s²)", |c| c.numbers.rms_at_passing_m_s2),
    ("Between<br>(m/s²)", |c| c.numbers.rms_between_m_s2),
    ("Contacts cut<br>out (m/s²)", |c| {
        c.numbers.rms_without_contacts_m_s2
    }),
    ("SD of gaps<br>(°)", |c| c.numbers.gap_deviation_deg),
    ("Contacts<br>(1/s)", |c| c.numbers.contacts_per_s),
];

/// Space between the panels.
const SPACE: Space = Space {
    across: 0.16,
    down: 0.035,
};

/// A panel per quantity and speed, grouped by lot, a bar per ring.
pub fn comparison(comparison: &RingComparison) -> Figure {
    let speeds = comparison.speeds_rpm();
    let panels = Panel::grid(ROWS.len() * speeds.len(), speeds.len(), SPACE);
    // The legend stands above the titles of the columns.
    let mut plot = Plot::new(980)
        .legend_above(1.04)
        .set("barmode", json!("group"))
        .margin(Margin {
            right: 16,
            top: 84,
            bottom: 48,
            ..Margin::default()
        });
    for (column, &speed_rpm) in speeds.iter().enumerate() {
        let cells: Vec<&ComparisonCell> = comparison.at_speed(speed_rpm).collect();
        let mut rings: Vec<&str> = vec![];
        for cell in &cells {
            if !rings.contains(&cell.ring.as_str()) {
                rings.push(&cell.ring);
            }
        }
        for (row, (title, quantity)) in ROWS.iter().enumerate() {
            let panel = &panels[row * speeds.len() + column];
            let across = json!({ "showticklabels": panel.lowest, "type": "category" });
            let font = json!({ "size": 12 });
            let up = json!({ "rangemode": "tozero", "nticks": 5, "title": { "font": font } });
            plot = plot.panel(panel, ["", title], [across, up]);
            if row == 0 {
                plot = plot.title_above(panel, &format!("<b>{speed_rpm} rpm</b>"), json!({}));
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
                    "showlegend": panel.first, "x": lots, "y": means,
                    "error_y": { "type": "data", "array": errors, "thickness": 1.2, "width": 3 },
                    "marker": { "color": PALETTE[k % PALETTE.len()] },
                    "hovertemplate": "%{x}: %{y}<extra>%{fullData.name}</extra>",
                });
                plot = plot.trace(Trace::from(trace).on(panel.axes()));
            }
        }
    }
    let caption = format!(
        "Vertical acceleration of the housing (RMS), its part at the multiples of the orbital \
             frequency and the part between them, the RMS with the contacts between balls cut out \
             of the force, standard deviation (SD) of the gaps at the end, \
             and contacts between balls per second: means over the starts with their standard \
             errors, for equal balls and lots of grades of ISO 3290-1. {}",
        comparison.starts
    );
    Figure::new("Rings compared", &caption, &comparison.provenance, plot)
}
