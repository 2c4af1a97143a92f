//! Figures of a search.

mod maps;
mod trade_offs;

pub use maps::{critical_gaps, verdicts};
pub use trade_offs::trade_offs;

/// Name of the case's own structure in legends.
const OWN: &str = "initial design";
