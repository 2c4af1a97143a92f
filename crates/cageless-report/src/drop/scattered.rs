//! Tables and figures of scattered drops.

use cageless_results::end_state_text;
use cageless_study::Provenance;
use cageless_study::drop::{
    BearingRow, Distribution, EnsembleResult, RotorEnsemble, WhirlProbability,
};
use serde_json::json;

use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, markers};
use crate::table::Table;

/// What scatters in each bearing but the arrangement of its balls, with its width.
const SCATTERED: &str =
    "friction (±30 %), touch-down clearance (±10 %), support damping (factor 2)";

/// Label of a table or figure of the only bearing, or of bearing `k` of several.
pub(super) fn label(name: &str, k: Option<usize>) -> String {
    match k {
        None => name.to_owned(),
        Some(k) => format!("{name}, bearing {}", k + 1),
    }
}

/// Table of the scattered drops onto one bearing.
pub(super) fn distribution(ensemble: &EnsembleResult, source: &Provenance) -> Table {
    let whirl = match ensemble.distribution.backward_whirl.percent() {
        Some(percent) => format!(" Probability of backward whirl: {percent}."),
        None => String::new(),
    };
    let caption = format!(
        "{} drops with scattered {SCATTERED}, direction of the unbalance and arrangement of the \
         balls (seed {}): {}.{whirl}",
        ensemble.completed,
        ensemble.seed,
        ensemble.distribution.end_states_text()
    );
    quantiles(
        &ensemble.distribution,
        label("Distribution", None),
        caption,
        source,
    )
}

/// Table of the states at the end of scattered drops into several bearings.
pub(super) fn end_states(ensemble: &RotorEnsemble, source: &Provenance) -> Table {
    let row = |name: String, whirl: &WhirlProbability, states: String| {
        vec![name, whirl.percent().unwrap_or("–".to_owned()), states]
    };
    let head = ["Bearing", "Backward whirl", "State at the end"].map(str::to_owned);
    let any = row(
        "Any bearing".to_owned(),
        &ensemble.backward_whirl,
        String::new(),
    );
    let mut rows = vec![head.to_vec(), any];
    rows.extend((1..).zip(&ensemble.bearings).map(|(k, of_bearing)| {
        let states = of_bearing.end_states_text();
        row(format!("Bearing {k}"), &of_bearing.backward_whirl, states)
    }));
    let caption = format!(
        "{} drops with the direction of the unbalances and, in each bearing on its own, \
         {SCATTERED} and arrangement of the balls scattered (seed {}).",
        ensemble.completed, ensemble.seed
    );
    let label = "Probability of backward whirl";
    Table::of(label, &caption, rows, Some(source.clone()))
}

/// Table of the distribution of each result of a bearing.
pub(super) fn quantiles(
    distribution: &Distribution,
    label: String,
    caption: String,
    source: &Provenance,
) -> Table {
    Table::of(&label, &caption, distribution.rows(), Some(source.clone()))
}

/// State at the end of drops over friction and support damping, by the rows of a bearing.
pub(super) fn scatter<'a>(
    distribution: &Distribution,
    rows: impl Iterator<Item = &'a BearingRow> + Clone,
    label: &str,
    source: &Provenance,
) -> Figure {
    let damped = rows.clone().any(|row| row.support_damping_n_s_m.is_some());
    let title = if damped {
        "Damping of the support (N·s/m)"
    } else {
        "Touch-down clearance (radial, µm)"
    };
    let mut plot = Plot::new(420)
        .legend()
        .axis(
            "xaxis",
            "Friction coefficient between rotor and inner ring",
            json!({}),
        )
        .axis("yaxis", title, json!({}));
    for (k, entry) in distribution.end_states.iter().enumerate() {
        let (x, y): (Vec<f64>, Vec<f64>) = (rows.clone())
            .filter(|row| row.result.end_state() == entry.end_state)
            .map(|row| {
                let height = row.support_damping_n_s_m.unwrap_or(row.radial_clearance_um);
                (row.rotor_friction, height)
            })
            .unzip();
        let name = end_state_text(&entry.end_state);
        plot = plot.trace(markers(&name, &x, &y, PALETTE[k % PALETTE.len()]));
    }
    Figure::new(
        label,
        "State of each drop at its end over what was drawn for it.",
        source,
        plot,
    )
}
