//! Distribution of one result over drops whose conditions scatter.

use cageless::numerics::quantile;
use cageless_results::{DropResult, Quantity};
use serde::{Serialize, Serializer};

/// Distribution of one result. An event that some drops have not seen within their time is later than that; any other
/// result has the quantiles of the drops that have it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantiles {
    /// The result; its name in files.
    #[serde(rename = "name", serialize_with = "name")]
    pub quantity: &'static Quantity,
    /// Drops that have it.
    pub count: usize,
    /// Drops in all.
    #[serde(skip)]
    pub of: usize,
    /// Time within which the event has not come in the other drops, in the unit of the result; `None` if it has in
    /// all, and of a result that is no such time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub not_within: Option<f64>,
    /// Least; `None` beyond that time.
    pub least: Option<f64>,
    /// Median; `None` beyond that time.
    pub median: Option<f64>,
    /// 95 % quantile; `None` beyond that time.
    pub high: Option<f64>,
    /// Largest; `None` beyond that time.
    pub most: Option<f64>,
}

fn name<S: Serializer>(quantity: &&Quantity, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(quantity.name)
}

impl Quantiles {
    /// Distribution over the results of drops; `None` where none of them has the result.
    pub(super) fn new(quantity: &'static Quantity, drops: &[&DropResult]) -> Option<Self> {
        let values = drops.iter();
        let mut values: Vec<f64> = values
            .filter_map(|drop| drop.results.value(quantity.name))
            .collect();
        let count = values.len();
        let times_s = drops
            .iter()
            .filter_map(|drop| drop.results.value("simulated_s"));
        let not_within = times_s
            .map(|time_s| 1e3 * time_s)
            .reduce(f64::max)
            .filter(|_| quantity.awaited && count < drops.len());
        if not_within.is_some() {
            values.resize(drops.len(), f64::INFINITY);
        }
        values.sort_by(f64::total_cmp);
        let last = *values.last()?;
        let finite = |value: f64| value.is_finite().then_some(value);
        let of = |p: f64| finite(quantile(&values, p));
        Some(Self {
            quantity,
            count,
            of: drops.len(),
            not_within,
            least: finite(values[0]),
            median: of(0.5),
            high: of(0.95),
            most: finite(last),
        })
    }

    /// The row of a table for readers.
    pub(super) fn row(&self) -> Vec<String> {
        let label = match self.count < self.of {
            true => format!("{} ({} of {})", self.quantity.label, self.count, self.of),
            false => self.quantity.label.to_owned(),
        };
        let beyond = || {
            let within = self.not_within.map(|time| self.quantity.number_text(time));
            within.map_or("–".to_owned(), |time| format!("> {time}"))
        };
        let text = |value: Option<f64>| {
            value.map_or_else(beyond, |value| self.quantity.number_text(value))
        };
        let values = [self.least, self.median, self.high, self.most].map(text);
        let (label, unit) = ([label], [self.quantity.printed_unit()]);
        label.into_iter().chain(values).chain(unit).collect()
    }
}
