//! Table and figure of scattered drops.

use cageless_study::Provenance;
use cageless_study::drop::EnsembleResult;
use serde_json::json;

use super::{figure, words};
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, markers};
use crate::table::{Cell, Row, Table};
use crate::text::short;

pub(super) fn distribution(ensemble: &EnsembleResult, source: &Provenance) -> Table {
    let ends: Vec<String> = (ensemble.end_states.iter())
        .map(|entry| format!("{} {}", entry.count, words(&entry.end_state)))
        .collect();
    let whirl = match (
        ensemble.backward_whirl_probability,
        ensemble.backward_whirl_interval,
    ) {
        (Some(p), Some([low, high])) => format!(
            " Probability of backward whirl: {:.1} % (95 %: {:.1} to {:.1} %).",
            1e2 * p,
            1e2 * low,
            1e2 * high
        ),
        _ => String::new(),
    };
    Table {
        label: "Distribution".to_owned(),
        caption: format!(
            "{} drops with scattered friction (±30 %), air gap (±10 %), support damping (factor 2), \
             direction of the unbalance and arrangement of the balls (seed {}): {}.{whirl}",
            ensemble.completed,
            ensemble.seed,
            ends.join(", ")
        ),
        columns: [
            ("Result", false),
            ("Least", true),
            ("Median", true),
            ("95 %", true),
            ("Largest", true),
            ("Unit", false),
        ]
        .map(|(text, numeric)| (text.to_owned(), numeric))
        .to_vec(),
        rows: (ensemble.quantiles.iter())
            .map(|q| Row {
                cells: vec![
                    Cell::text(q.quantity.label),
                    Cell::number(short(q.least)),
                    Cell::number(short(q.median)),
                    Cell::number(short(q.high)),
                    Cell::number(short(q.most)),
                    Cell::text(q.quantity.unit_text()),
                ],
                ..Row::default()
            })
            .collect(),
        provenance: Some(source.clone()),
        ..Table::default()
    }
}

/// State at the end over friction and support damping.
pub(super) fn scatter(ensemble: &EnsembleResult, source: &Provenance) -> Figure {
    let damped = ensemble
        .drops
        .iter()
        .any(|d| d.support_damping_n_s_m.is_some());
    let title = if damped {
        "Damping of the support (N·s/m)"
    } else {
        "Radial air gap (µm)"
    };
    let mut plot = Plot::new(420)
        .legend()
        .axis(
            "xaxis",
            "Friction coefficient between rotor and inner ring",
            json!({}),
        )
        .axis("yaxis", title, json!({}));
    for (k, entry) in ensemble.end_states.iter().enumerate() {
        let of_state = || {
            let rows = ensemble.drops.iter();
            rows.filter(|d| d.result.end_state() == entry.end_state)
        };
        let x: Vec<f64> = of_state().map(|d| d.rotor_friction).collect();
        let y: Vec<f64> = of_state()
            .map(|d| d.support_damping_n_s_m.unwrap_or(d.air_gap_um))
            .collect();
        let name = words(&entry.end_state);
        plot = plot.trace(markers(&name, &x, &y, PALETTE[k % PALETTE.len()]));
    }
    figure(
        "State at the end",
        "State of each drop at its end over what was drawn for it.",
        source,
        plot,
    )
}
