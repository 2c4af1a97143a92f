//! Energy balance.

use serde_json::{Value, json};

use super::history::figure;
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, number, numbers, plain};
use crate::run::RunData;
use crate::sampling::range;
use crate::text::short;

/// Energy balance of a run.
pub fn energy(run: &RunData) -> Option<Figure> {
    if run.energy.is_empty() {
        return None;
    }
    let names: Value = run.energy.iter().map(|item| plain(&item.name)).collect();
    let values: Vec<f64> = run.energy.iter().map(|item| item.energy_j).collect();
    let colours: Value = values
        .iter()
        .map(|v| if *v < 0.0 { PALETTE[1] } else { PALETTE[0] })
        .collect();
    let labels: Value = values.iter().map(|v| format!("{} J", short(*v))).collect();
    let (low, high) = range(&values);
    let room = (high.max(0.0) - low.min(0.0)).max(1e-12) * 0.3;
    let bounds = json!([
        number(low.min(0.0) - if low < 0.0 { room } else { 0.0 }),
        number(high.max(0.0) + if high > 0.0 { room } else { 0.0 }),
    ]);
    let plot = Plot::new(36 * run.energy.len() as u32 + 130)
        .axis("xaxis", "Energy, positive into the bearing (J)", json!({ "range": bounds, "zeroline": true, "zerolinecolor": "#555" }))
        .axis("yaxis", "", json!({ "type": "category", "autorange": "reversed" }))
        .trace(json!({
            "type": "bar", "orientation": "h", "y": names, "x": numbers(&values),
            "marker": { "color": colours }, "text": labels, "textposition": "outside", "cliponaxis": false,
        }));
    let rest = run.energy_residual_relative.map_or(String::new(), |r| {
        format!(" Residual: {} of the sum of all energy flows.", short(r))
    });
    Some(figure(
        run,
        "Energy balance",
        &format!("Work and energy over the run.{rest}"),
        plot,
    ))
}
