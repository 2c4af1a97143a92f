//! Tables and figures of scattered drops.

use cageless_results::end_state_text;
use cageless_study::drop::{BearingRow, Distribution, Ensemble, WhirlProbability};

use super::bearing::Bearing;
use crate::figure::Figure;
use crate::page::{Note, Page};
use crate::plot::{PALETTE, Plot, markers};
use crate::table::Table;

/// Scattered properties of each bearing and their widths, besides the arrangement of the balls.
const SCATTERED: &str =
    "friction (±30 %), touch-down clearance (±10 %), support damping (factor 2)";

/// Tables and figures of scattered drops.
pub(super) fn scattered(page: &mut Page, bearings: &[Bearing<'_>], ensemble: &Ensemble) {
    page.section("Scattered drops");
    if let Some(percent) = ensemble.passing.percent() {
        page.note(Note::Remark, &format!("Probability of passing: {percent}."));
    }
    if let Some(stopped) = ensemble.stopped_text() {
        page.note(Note::Warning, &stopped);
    }
    if bearings.len() > 1 {
        page.table(&end_states(&bearings[0], ensemble));
    }
    for (k, (bearing, distribution)) in bearings.iter().zip(&ensemble.bearings).enumerate() {
        let caption = match bearings.len() {
            1 => of_only_bearing(ensemble, distribution),
            _ => format!(
                "{} completed drops: {}.",
                ensemble.completed,
                distribution.end_states_text()
            ),
        };
        let (label, source) = (bearing.label("Distribution"), bearing.source.clone());
        let rows = distribution.rows();
        if !rows.is_empty() {
            page.table(&Table::of(&label, &caption, rows, Some(source)));
        }
        let rows = ensemble.drops.iter().map(|drop| &drop.bearings[k]);
        page.figure(&scatter(bearing, distribution, rows));
    }
}

/// Caption of the distribution of the results of an only bearing.
fn of_only_bearing(ensemble: &Ensemble, distribution: &Distribution) -> String {
    let whirl = match distribution.backward_whirl.percent() {
        Some(percent) => format!(" Probability of backward whirl: {percent}."),
        None => String::new(),
    };
    format!(
        "{} drops with scattered {SCATTERED}, direction of the unbalance and arrangement of the \
         balls (seed {}): {}.{whirl}",
        ensemble.completed,
        ensemble.seed,
        distribution.end_states_text()
    )
}

/// Table of the states at the end of scattered drops onto several bearings.
fn end_states(first: &Bearing<'_>, ensemble: &Ensemble) -> Table {
    let row = |name: String, whirl: &WhirlProbability, states: String| {
        vec![name, whirl.percent().unwrap_or("–".to_owned()), states]
    };
    let head = ["Bearing", "Backward whirl", "State at the end"].map(str::to_owned);
    let any = &ensemble.in_any_bearing;
    let any = row("Any bearing".to_owned(), any, String::new());
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
    Table::of(label, &caption, rows, Some(first.source.clone()))
}

/// State at the end of drops over friction and support damping, by the rows of a bearing.
fn scatter<'a>(
    bearing: &Bearing<'_>,
    distribution: &Distribution,
    rows: impl Iterator<Item = &'a BearingRow> + Clone,
) -> Figure {
    let damped = rows.clone().any(|row| row.support_damping_n_s_m.is_some());
    let title = if damped {
        "Damping of the support (N·s/m)"
    } else {
        "Touch-down clearance (radial, µm)"
    };
    let mut plot = Plot::new(420)
        .legend()
        .axes("Friction coefficient between rotor and inner ring", title);
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
    let caption = "State of each drop at its end over what was drawn for it.";
    bearing.figure("State at the end", caption, plot)
}
