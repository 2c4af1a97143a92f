//! Effects of the inputs on the outputs.

use super::result::{HeatMap, MainEffect, SweepOutput};
use cageless_io::results::Row;

use super::quantities::{Output, Quantities};
use super::table::Table;
use crate::StudyError;

/// Inputs that an output is drawn over, at most …
const DRAWN: usize = 6;
/// … and the share that they must explain.
const SHARE_MIN: f64 = 0.01;

/// Count, sums and range of an output at one level.
#[derive(Clone, Copy)]
struct Moments {
    count: f64,
    /// Counted from [`Output::origin`].
    sum: f64,
    squares: f64,
    min: f64,
    max: f64,
}

impl Moments {
    const NONE: Self = Self {
        count: 0.0,
        sum: 0.0,
        squares: 0.0,
        min: f64::INFINITY,
        max: f64::NEG_INFINITY,
    };

    fn add(&mut self, value: f64) {
        self.count += 1.0;
        self.sum += value;
        self.squares += value * value;
        self.min = self.min.min(value);
        self.max = self.max.max(value);
    }

    /// NaN without values.
    fn mean(&self) -> f64 {
        self.sum / self.count
    }
}

/// Moments of each output at each level of each input.
type Levels = Vec<Vec<Vec<Moments>>>;

/// Columns of the inputs, then of the outputs.
fn wanted(quantities: &Quantities) -> Vec<usize> {
    let inputs = quantities.inputs.iter().map(|i| i.column);
    inputs
        .chain(quantities.outputs.iter().map(|o| o.column))
        .collect()
}

/// The outputs with the shares and effects of all inputs.
pub(super) fn gather(
    table: &Table,
    quantities: &Quantities,
) -> Result<Vec<SweepOutput>, StudyError> {
    let (inputs, outputs) = (&quantities.inputs, &quantities.outputs);
    let empty = || inputs.iter().map(|i| vec![Moments::NONE; i.count()]);
    let mut levels: Levels = outputs.iter().map(|_| empty().collect()).collect();
    let mut all = vec![Moments::NONE; outputs.len()];
    table.each(&wanted(quantities), |row| {
        let at: Vec<_> = inputs
            .iter()
            .zip(row)
            .map(|(i, cell)| i.level(cell))
            .collect();
        for (k, output) in outputs.iter().enumerate() {
            let Some(value) = output.value(&row[inputs.len() + k]) else {
                continue;
            };
            let value = value - output.origin;
            all[k].add(value);
            for (moments, level) in levels[k].iter_mut().zip(&at) {
                if let Some(level) = level {
                    moments[*level].add(value);
                }
            }
        }
    })?;
    let of_output = |((output, levels), all): ((&Output, &Vec<Vec<Moments>>), &Moments)| {
        let shares: Vec<_> = levels.iter().map(|l| share(l, all)).collect();
        let effects = most(&shares, DRAWN)
            .into_iter()
            .filter(|k| shares[*k].unwrap_or(0.0) >= SHARE_MIN)
            .map(|k| effect(quantities, output, k, &levels[k]))
            .collect();
        SweepOutput {
            quantity: output.quantity.clone(),
            count: all.count as u64,
            mean: all.mean() + output.origin,
            shares,
            effects,
            map: None,
        }
    };
    Ok(outputs
        .iter()
        .zip(&levels)
        .zip(&all)
        .map(of_output)
        .collect())
}

/// Correlation ratio η²: variance between the levels over the whole variance.
fn share(levels: &[Moments], all: &Moments) -> Option<f64> {
    let mean = all.mean();
    let whole = all.squares - all.count * mean * mean;
    let filled = levels.iter().filter(|l| l.count > 0.0);
    let between: f64 = filled.map(|l| l.count * (l.mean() - mean).powi(2)).sum();
    let share = between / whole;
    share.is_finite().then(|| share.clamp(0.0, 1.0))
}

/// Inputs with the largest shares, those first.
fn most(shares: &[Option<f64>], count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..shares.len()).collect();
    let share = |k: usize| shares[k].unwrap_or(-1.0);
    order.sort_by(|a, b| share(*b).total_cmp(&share(*a)));
    order.truncate(count);
    order
}

fn effect(
    quantities: &Quantities,
    output: &Output,
    input: usize,
    levels: &[Moments],
) -> MainEffect {
    let input = &quantities.inputs[input];
    let of = |value: fn(&Moments) -> f64| {
        let value = |m: &Moments| value(m) + output.origin;
        levels.iter().map(value).collect()
    };
    MainEffect {
        input: input.quantity.clone(),
        levels: input.levels.clone(),
        mean: of(Moments::mean),
        min: of(|m| m.min),
        max: of(|m| m.max),
    }
}

/// For each output its mean over the two inputs that explain most.
pub(super) fn maps(
    table: &Table,
    quantities: &Quantities,
    outputs: &[SweepOutput],
) -> Result<Vec<Option<HeatMap>>, StudyError> {
    let inputs = &quantities.inputs;
    let pair = |output: &SweepOutput| match *most(&output.shares, 2) {
        [x, y] if output.shares[x].unwrap_or(0.0) >= SHARE_MIN => Some((x, y)),
        _ => None,
    };
    let pairs: Vec<_> = outputs.iter().map(pair).collect();
    let grid = |pair: &Option<(usize, usize)>| match *pair {
        Some((x, y)) => vec![vec![Moments::NONE; inputs[x].count()]; inputs[y].count()],
        None => Vec::new(),
    };
    let mut grids: Vec<Vec<Vec<Moments>>> = pairs.iter().map(grid).collect();
    table.each(&wanted(quantities), |row: &Row| {
        for (k, output) in quantities.outputs.iter().enumerate() {
            let (Some((x, y)), Some(value)) = (pairs[k], output.value(&row[inputs.len() + k]))
            else {
                continue;
            };
            if let (Some(column), Some(line)) = (inputs[x].level(&row[x]), inputs[y].level(&row[y]))
            {
                grids[k][line][column].add(value - output.origin);
            }
        }
    })?;
    let map = |(k, output): (usize, &Output)| {
        let (x, y) = pairs[k]?;
        let mean = |m: &Moments| m.mean() + output.origin;
        Some(HeatMap {
            x_input: inputs[x].quantity.clone(),
            x: inputs[x].levels.clone(),
            y_input: inputs[y].quantity.clone(),
            y: inputs[y].levels.clone(),
            mean: grids[k]
                .iter()
                .map(|line| line.iter().map(mean).collect())
                .collect(),
        })
    };
    Ok(quantities.outputs.iter().enumerate().map(map).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y = 3 x1 + x2 on the grid x1 = 0, 1, 2, x2 = 0, 1: variances 9 · 2/3 and 1/4, so that the
    /// shares are 6/6.25 and 0.25/6.25, wherever y is counted from.
    #[test]
    fn shares_are_those_of_a_linear_function() {
        for offset in [0.0, 40.0] {
            let (mut first, mut second) = ([Moments::NONE; 3], [Moments::NONE; 2]);
            let mut all = Moments::NONE;
            for (x1, x2) in (0..3u8).flat_map(|x1| (0..2u8).map(move |x2| (x1, x2))) {
                let y = offset + 3.0 * f64::from(x1) + f64::from(x2);
                for moments in [
                    &mut first[usize::from(x1)],
                    &mut second[usize::from(x2)],
                    &mut all,
                ] {
                    moments.add(y);
                }
            }
            assert!((share(&first, &all).unwrap() - 0.96).abs() < 1e-12);
            assert!((share(&second, &all).unwrap() - 0.04).abs() < 1e-12);
            assert!((all.mean() - offset - 3.5).abs() < 1e-12);
        }
        // Without variance there is no share.
        let mut flat = Moments::NONE;
        flat.add(1.0);
        assert_eq!(share(&[flat], &flat), None);
    }
}
