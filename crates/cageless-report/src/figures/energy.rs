//! Energy balance.

use serde_json::{Value, json};

use super::history::figure;
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, numbers, plain};
use crate::run_data::RunData;
use crate::text::short;

/// Energy balance of a run.
pub fn energy(run: &RunData) -> Option<Figure> {
    if run.energy.is_empty() {
        return None;
    }
    // The value stands below its name: beside a bar there is no room on a narrow screen.
    let names: Value = run
        .energy
        .iter()
        .map(|item| format!("{}<br>{} J", plain(&item.name), short(item.energy_j)))
        .collect();
    let values: Vec<f64> = run.energy.iter().map(|item| item.energy_j).collect();
    let colours: Value = values
        .iter()
        .map(|v| if *v < 0.0 { PALETTE[1] } else { PALETTE[0] })
        .collect();
    let plot = Plot::new(44 * run.energy.len() as u32 + 130)
        .x(
            "Energy, positive into the bearing (J)",
            json!({ "zeroline": true, "zerolinecolor": "#555" }),
        )
        .y("", json!({ "type": "category", "autorange": "reversed" }))
        .trace(json!({
            "type": "bar", "orientation": "h", "y": names, "x": numbers(&values),
            "marker": { "color": colours }, "hovertemplate": "%{y}<extra></extra>",
        }));
    let rest = run.energy_residual_relative.map_or(String::new(), |r| {
        format!(" Residual: {} of the sum of all energy flows.", short(r))
    });
    let caption = format!("Work and energy over the run.{rest}");
    Some(figure(run, "Energy balance", &caption, plot))
}
