//! Inputs with their levels and outputs with their ranges.

use super::result::{Levels, SweepQuantity};
use crate::{Parameter, StudyError};
use cageless_io::results::Column;
use cageless_results::number_text::short;
use cageless_results::{Cell, Computation, of_column};

use super::failed::failed;
use super::sampling::{Drawn, POINTS_MAX, Sampling};
use super::table::Table;

/// Values that an input may have to be shown one by one.
const LEVELS_MAX: usize = 24;
/// Stretches into which others are divided, at most.
const STRETCHES: usize = 12;
/// Fewest points for each level of what is drawn; its square is the fewest points of all.
pub(super) const POINTS_MIN: u64 = 4;
/// Names of a text output that are followed.
const NAMES_MAX: usize = 8;

/// Share of the natural scale of a quantity below which differences are the rounding of its
/// computation: the ring of a symmetric bearing is 5e-12 µm off the middle of its 2e4 µm.
const ROUNDING: f64 = 1e-9;

/// Difference of values between `low` and `high` that says nothing.
fn rounding(unit: &str, low: f64, high: f64) -> f64 {
    let scale: f64 = match unit {
        // The radius of a ring, from which displacements are differences.
        "um" => 1e4,
        "mm" => 10.0,
        "deg" => 360.0,
        // The speed of a raceway.
        "m/s" => 10.0,
        "MPa" => 1e3,
        // A contact, whose stiffness the terms of a coupling that cancel have; at a lever of 1 mm.
        "N/m" => 1e8,
        "N m/rad" => 1e2,
        "N" | "s" | "" => 1.0,
        _ => 0.0,
    };
    ROUNDING * scale.max(low.abs()).max(high.abs())
}

/// Factor and unit of the values of an output for readers: where those of results have another scale, that.
fn printed(column: &Column) -> (f64, String) {
    match of_column(&column.name).map(|(result, _)| result.printed()) {
        Some((factor, unit)) if factor != 1.0 => (factor, unit),
        _ => (1.0, column.unit.to_string()),
    }
}

/// Inputs and outputs that are not the same everywhere.
pub(super) struct Quantities {
    pub inputs: Vec<Input>,
    pub outputs: Vec<Output>,
    pub constants: Vec<Parameter>,
}

/// An input.
pub(super) struct Input {
    pub quantity: SweepQuantity,
    pub column: usize,
    /// Origin of the drawn values; `None` of an axis of the grid.
    pub drawn: Option<Drawn>,
    /// Levels of the input, for figures.
    pub levels: Levels,
    /// Values between the levels, where these stand for stretches of values.
    edges: Option<Vec<f64>>,
}

/// An output, or the share of one of its names.
pub(super) struct Output {
    pub quantity: SweepQuantity,
    pub column: usize,
    pub is_name: Option<String>,
    /// Factor of its values, from the unit of the column.
    factor: f64,
    /// A value of it, to count from: what is large and hardly varies loses no digits.
    pub origin: f64,
    /// Computation of the output; `None` of a column that is no result.
    computation: Option<Computation>,
}

/// The quantity of a column.
fn quantity(column: &Column) -> SweepQuantity {
    SweepQuantity {
        name: column.name.to_string(),
        unit: column.unit.to_string(),
    }
}

impl Input {
    /// Number of levels.
    pub(super) fn count(&self) -> usize {
        match &self.levels {
            Levels::Names(names) => names.len(),
            Levels::Numbers(values) => values.len(),
        }
    }

    /// Level of a value; `None` if there is none.
    pub(super) fn level(&self, cell: &Cell) -> Option<usize> {
        match (&self.levels, cell, &self.edges) {
            (Levels::Names(names), Cell::Text(name), _) => names.iter().position(|n| n == name),
            (Levels::Names(_), ..) => None,
            (Levels::Numbers(values), cell, None) => {
                let value = cell.number()?;
                values.iter().position(|v| *v == value)
            }
            (_, cell, Some(edges)) => {
                let value = cell.number()?;
                Some(edges.partition_point(|edge| *edge <= value))
            }
        }
    }
}

impl Output {
    /// Value of the output in a row; `None` if there is none.
    pub(super) fn value(&self, cell: &Cell) -> Option<f64> {
        match (&self.is_name, cell) {
            (Some(name), Cell::Text(text)) => Some(f64::from(u8::from(name == text))),
            (Some(_), _) => None,
            (None, cell) => cell.number().map(|value| self.factor * value),
        }
    }

    /// Whether a row without its value would have one, had the computation not failed.
    pub(super) fn is_missing(&self, reason: &Cell) -> bool {
        let Cell::Text(reason) = reason else {
            return false;
        };
        self.computation.is_some_and(|c| failed(reason, c))
    }
}

/// Values of one column.
#[derive(Default)]
struct Seen {
    names: Vec<String>,
    values: Vec<f64>,
    many: bool,
    range: Option<[f64; 2]>,
    /// Values of some rows, drawn.
    drawn: Vec<f64>,
}

impl Seen {
    fn see(&mut self, cell: &Cell) {
        if let Cell::Text(name) = cell
            && !self.names.contains(name)
        {
            self.many |= self.names.len() == LEVELS_MAX;
            if !self.many {
                self.names.push(name.clone());
            }
        }
        let Some(value) = cell.number() else {
            return;
        };
        let [low, high] = self.range.unwrap_or([value; 2]);
        self.range = Some([low.min(value), high.max(value)]);
        if !self.many && !self.values.contains(&value) {
            self.many = self.values.len() == LEVELS_MAX;
            self.values.push(value);
        }
    }

    /// Levels of an input, of which `points` are drawn, and what lies between these if they stand for stretches.
    fn levels(mut self, points: Option<u64>) -> Option<(Levels, Option<Vec<f64>>)> {
        if !self.names.is_empty() {
            return (self.names.len() > 1).then_some((Levels::Names(self.names), None));
        }
        self.range.filter(|[from, to]| from < to)?;
        match points {
            Some(points) if self.many || POINTS_MIN * self.values.len() as u64 > points => {
                let (middles, edges) = stretches_of_equal_count(self.drawn, points);
                return Some((Levels::Numbers(middles), Some(edges)));
            }
            None if self.many => {
                // Each value of an axis has as many rows.
                self.drawn.sort_unstable_by(f64::total_cmp);
                self.drawn.dedup();
                let most = (STRETCHES * STRETCHES) as u64;
                let (middles, edges) = stretches_of_equal_count(self.drawn, most);
                return Some((Levels::Numbers(middles), Some(edges)));
            }
            _ => {}
        }
        self.values.sort_unstable_by(f64::total_cmp);
        Some((Levels::Numbers(self.values), None))
    }
}

/// Means of and values between stretches that hold equal numbers of `values`, as many as there are points in
/// each of `points`.
pub(super) fn stretches_of_equal_count(mut values: Vec<f64>, points: u64) -> (Vec<f64>, Vec<f64>) {
    values.sort_unstable_by(f64::total_cmp);
    let count = (points.isqrt() as usize).clamp(1, STRETCHES);
    let at = |k: usize| values.get(k * values.len() / count).copied();
    let mut edges: Vec<f64> = (1..count).filter_map(at).collect();
    edges.dedup();
    edges.retain(|edge| values.first().is_some_and(|least| edge > least));
    let mut sums = vec![[0.0; 2]; edges.len() + 1];
    for value in values {
        let [sum, count] = &mut sums[edges.partition_point(|edge| *edge <= value)];
        *sum += value;
        *count += 1.0;
    }
    (sums.iter().map(|[sum, count]| sum / count).collect(), edges)
}

impl Quantities {
    /// Looks at every value once.
    pub(super) fn scan(table: &Table, sampling: &Sampling) -> Result<Self, StudyError> {
        let (inputs, outputs) = (table.inputs(), table.outputs());
        let wanted: Vec<usize> = inputs.iter().chain(&outputs).copied().collect();
        let mut seen: Vec<Seen> = wanted.iter().map(|_| Seen::default()).collect();
        let rows = table.reader.rows();
        let (mut number, most) = (0_u64, (u64::MAX / rows.max(1)).saturating_mul(POINTS_MAX));
        table.each(&wanted, |row| {
            row.iter()
                .zip(&mut seen)
                .for_each(|(cell, seen)| seen.see(cell));
            // Rows from anywhere, about POINTS_MAX of them: their numbers times the golden ratio.
            if number.wrapping_mul(0x9E37_79B9_7F4A_7C15) <= most {
                let cells = row.iter().zip(&mut seen).take(inputs.len());
                cells.for_each(|(cell, seen)| seen.drawn.extend(cell.number()));
            }
            number += 1;
        })?;
        let mut quantities = Self {
            inputs: Vec::new(),
            outputs: Vec::new(),
            constants: Vec::new(),
        };
        for (k, (column, seen)) in wanted.into_iter().zip(seen).enumerate() {
            let spec = &table.columns()[column];
            if k < inputs.len() {
                let drawn = sampling.drawn(&spec.name);
                let points = drawn.map(|drawn| sampling.points(drawn, rows));
                let levels = seen.levels(points);
                quantities
                    .inputs
                    .extend(levels.map(|(levels, edges)| Input {
                        quantity: quantity(spec),
                        column,
                        drawn,
                        levels,
                        edges,
                    }));
            } else {
                quantities.output(spec, column, seen);
            }
        }
        Ok(quantities)
    }

    fn output(&mut self, spec: &Column, column: usize, mut seen: Seen) {
        let computation = of_column(&spec.name).map(|(result, _)| result.computation());
        seen.names.truncate(NAMES_MAX);
        if seen.names.len() > 1 {
            let of_name = |name: &String| Output {
                quantity: SweepQuantity {
                    name: format!("{} = {name}", spec.name),
                    unit: String::new(),
                },
                column,
                is_name: Some(name.clone()),
                factor: 1.0,
                origin: 0.0,
                computation,
            };
            self.outputs.extend(seen.names.iter().map(of_name));
            return;
        }
        let (factor, unit) = printed(spec);
        match seen.range {
            Some([low, high]) if high - low > rounding(&spec.unit, low, high) => {
                self.outputs.push(Output {
                    quantity: SweepQuantity {
                        name: spec.name.to_string(),
                        unit,
                    },
                    column,
                    is_name: None,
                    factor,
                    origin: factor * low,
                    computation,
                })
            }
            range => {
                let number = range.map(|[low, high]| {
                    let rounding = rounding(&spec.unit, low, high);
                    let is_zero = low.abs().max(high.abs()) <= rounding;
                    short(if is_zero { 0.0 } else { factor * low })
                });
                let value = number.or(seen.names.pop());
                self.constants.extend(value.map(|value| Parameter {
                    name: spec.name.to_string(),
                    value,
                    unit,
                    ..Parameter::default()
                }));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An axis over three decades is divided into stretches that all have values, none of them more than
    /// one more than another.
    #[test]
    fn stretches_of_an_axis_have_equal_numbers_of_values() {
        let mut seen = Seen::default();
        let axis: Vec<f64> = (0..30).map(|k| 10f64.powf(f64::from(k) / 10.0)).collect();
        for value in axis.iter().chain(&axis) {
            seen.see(&Cell::Number(*value));
            seen.drawn.push(*value);
        }
        let (levels, edges) = seen.levels(None).expect("levels");
        let (Levels::Numbers(middles), Some(edges)) = (levels, edges) else {
            panic!("stretches of numbers");
        };
        assert_eq!(middles.len(), STRETCHES);
        for (k, middle) in middles.iter().enumerate() {
            let within = |v: &&f64| edges.partition_point(|e| e <= *v) == k;
            let values: Vec<f64> = axis.iter().filter(within).copied().collect();
            assert!((2..=3).contains(&values.len()), "{k}: {values:?}");
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            assert!((middle - mean).abs() < 1e-9 * mean);
        }
    }
}
