//! Results of a drop.

use cageless::simulation::{Ending, RunOutcome};
use cageless::touchdown::{DropSummary, WhirlWindow};
use cageless_io::results::Cell;
use serde::Serialize;

use crate::quantities::{FinishedDrop, Kind, Results, value_text};

/// Results of one drop.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DropResult {
    /// Scalar results.
    #[serde(flatten)]
    pub results: Results,
    /// Why the run stopped before its end, if it did.
    pub stopped: Option<String>,
    /// Motion of the rotor and collisions between balls over time.
    pub windows: Vec<WindowRow>,
}

/// Motion of the rotor round the bore, and collisions between balls, in one interval.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WindowRow {
    /// Middle of the interval, ms.
    pub time_ms: f64,
    /// Whirl frequency, Hz, counter-clockwise positive.
    pub whirl_frequency_hz: f64,
    /// Fraction of the interval in contact.
    pub contact_fraction: f64,
    /// Mean contact force, N.
    pub force_mean_n: f64,
    /// Contacts between balls that began.
    pub collisions: u64,
}

impl WindowRow {
    fn new(w: &WhirlWindow) -> Self {
        Self {
            time_ms: 500.0 * (w.start_s + w.end_s),
            whirl_frequency_hz: w.frequency_hz(),
            contact_fraction: w.contact_fraction,
            force_mean_n: w.force_mean_n,
            collisions: w.collisions.all,
        }
    }
}

impl DropResult {
    /// Results `summary` of the drop that ended as `outcome`.
    pub fn new(summary: &DropSummary, outcome: &RunOutcome) -> Self {
        let stopped = match &outcome.ending {
            Ending::Stopped(stop) => Some(stop.reason()),
            _ => None,
        };
        Self {
            results: Results::of_drop(&FinishedDrop { summary, outcome }),
            stopped,
            windows: summary.whirl.iter().map(WindowRow::new).collect(),
        }
    }

    /// What the rotor does at the end: `falling`, `at-rest`, `pendulum`, `bouncing`,
    /// `forward-whirl` or `backward-whirl`.
    pub fn end_state(&self) -> &str {
        match self.results.get("end_state") {
            Some(Cell::Text(state)) => state,
            _ => "",
        }
    }

    /// Results of drops side by side: label, value of each drop (a dash where it has none), unit.
    pub fn table(drops: &[&Self]) -> Vec<(&'static str, Vec<String>, String)> {
        let states = drops.iter().map(|drop| drop.end_state().replace('-', " "));
        let mut rows = vec![("state at the end", states.collect(), String::new())];
        let quantities = drops.iter().take(1).flat_map(|drop| drop.results.iter());
        for (quantity, _) in quantities.filter(|(q, _)| q.in_tables && q.kind != Kind::Numbers) {
            let value = |drop: &&Self| {
                let cell = drop.results.get(quantity.name)?;
                value_text(quantity, cell)
            };
            let values = drops.iter().map(|d| value(d).unwrap_or("–".to_owned()));
            rows.push((quantity.label, values.collect(), quantity.printed_unit()));
        }
        rows
    }

    /// Values of a result of every ball.
    pub fn values(&self, name: &str) -> &[f64] {
        match self.results.get(name) {
            Some(Cell::Numbers(values)) => values,
            _ => &[],
        }
    }

    /// Value of a numeric result, if it has one.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.results.get(name).and_then(Cell::number)
    }
}
