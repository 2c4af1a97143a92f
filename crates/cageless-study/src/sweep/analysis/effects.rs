//! Effects of the inputs on the outputs.

use super::result::{HeatMap, MainEffect, SHARE_MIN, SweepOutput};
use cageless_io::results::Row;
use cageless_results::Cell;

use super::quantities::{Input, Output, POINTS_MIN, Quantities};
use super::sampling::{Drawn, Sampling};
use super::table::Table;
use crate::StudyError;

/// Inputs that an output is drawn over, at most.
const DRAWN: usize = 6;
/// Standard deviations by which the share of what is drawn must exceed that of chance.
const DEVIATIONS: f64 = 2.0;

/// Count, sums and range of an output at one level.
#[derive(Clone, Copy)]
struct Moments {
    count: f64,
    /// Counted from [`Output::origin`].
    sum: f64,
    squares: f64,
    min: f64,
    max: f64,
    /// Rows that lack their value, as the computation failed.
    missing: f64,
}

impl Moments {
    const NONE: Self = Self {
        missing: 0.0,
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

    /// Takes the value of a row, if it has one.
    fn take(&mut self, value: Option<f64>) {
        match value {
            Some(value) => self.add(value),
            None => self.missing += 1.0,
        }
    }

    /// NaN without values, or if one is missing.
    fn mean(&self) -> f64 {
        self.of_all(self.sum / self.count)
    }

    /// NaN if a value is missing: that of the rest is none.
    fn of_all(&self, value: f64) -> f64 {
        match self.missing {
            0.0 => value,
            _ => f64::NAN,
        }
    }
}

/// Independent points among the values of an output.
#[derive(Clone, Copy)]
struct Points {
    count: f64,
    /// Sum over the points of the square of their sum over their number of values.
    squares: f64,
}

impl Points {
    /// Rows that share a point, by it; each row by itself if there are none.
    fn of(points: &[Moments], all: &Moments) -> Self {
        let filled = || points.iter().filter(|m| m.count > 0.0);
        match points {
            [] => Self {
                count: all.count,
                squares: all.squares,
            },
            _ => Self {
                count: filled().count() as f64,
                squares: filled().map(|m| m.sum * m.sum / m.count).sum(),
            },
        }
    }
}

/// Moments of each output at each level of each input.
type Levels = Vec<Vec<Vec<Moments>>>;

/// Columns of the inputs, then of the outputs, then the reason of a failure and the number of the variant.
fn wanted(table: &Table, quantities: &Quantities) -> Vec<usize> {
    let inputs = quantities.inputs.iter().map(|i| i.column);
    let outputs = quantities.outputs.iter().map(|o| o.column);
    inputs.chain(outputs).chain([table.reason, 0]).collect()
}

/// Value of an output in a row of [`wanted`] columns, `Some(None)` if the computation failed; `None` if it has none.
fn value(row: &Row, output: &Output, column: usize) -> Option<Option<f64>> {
    match output.value(&row[column]) {
        Some(value) => Some(Some(value - output.origin)),
        None => output.is_missing(&row[row.len() - 2]).then_some(None),
    }
}

/// Kinds of drawing whose points several variants share.
const SHARED: [Drawn; 2] = [Drawn::Sample, Drawn::Draw];

/// Moments of one output.
struct Gathered<'a> {
    /// At each level of each input.
    levels: &'a [Vec<Moments>],
    all: &'a Moments,
    /// At each point of each kind of [`SHARED`].
    points: &'a [Vec<Moments>; 2],
}

impl Gathered<'_> {
    /// The output with the shares and effects of all inputs.
    fn output(&self, quantities: &Quantities, output: &Output) -> SweepOutput {
        let &Self {
            levels,
            all,
            points,
        } = self;
        let inputs = &quantities.inputs;
        let share = |(input, levels): (&Input, &Vec<Moments>)| match input.drawn {
            _ if all.missing > 0.0 => None,
            None => share(levels, all),
            Some(drawn) => {
                let shared = SHARED.iter().position(|d| *d == drawn);
                let points = shared.map_or(&[][..], |at| &points[at]);
                share_of_drawn(levels, all, Points::of(points, all))
            }
        };
        let shares: Vec<_> = inputs.iter().zip(levels).map(share).collect();
        // Without shares any input may matter.
        let least = |k: &usize| all.missing > 0.0 || shares[*k].unwrap_or(0.0) >= SHARE_MIN;
        let effects = most(&shares, DRAWN)
            .into_iter()
            .filter(least)
            .map(|k| effect(quantities, output, k, &levels[k]))
            .collect();
        SweepOutput {
            quantity: output.quantity.clone(),
            count: all.count as u64,
            mean: all.mean() + output.origin,
            missing: all.missing as u64,
            shares,
            effects,
            map: None,
        }
    }
}

/// The outputs with the shares and effects of all inputs.
pub(super) fn gather(
    table: &Table,
    quantities: &Quantities,
    sampling: &Sampling,
) -> Result<Vec<SweepOutput>, StudyError> {
    let (inputs, outputs) = (&quantities.inputs, &quantities.outputs);
    let empty = || inputs.iter().map(|i| vec![Moments::NONE; i.count()]);
    let mut levels: Levels = outputs.iter().map(|_| empty().collect()).collect();
    let mut all = vec![Moments::NONE; outputs.len()];
    // By the point of the samples, and by the draw of the scatter.
    let mut points = vec![[const { vec![] }; 2]; outputs.len()];
    table.each(&wanted(table, quantities), |row| {
        let at: Vec<_> = inputs
            .iter()
            .zip(row)
            .map(|(i, cell)| i.level(cell))
            .collect();
        let variant = row.last().and_then(Cell::number).unwrap_or(0.0) as u64;
        let shared = SHARED.map(|drawn| sampling.point(drawn, variant));
        for (k, output) in outputs.iter().enumerate() {
            let Some(value) = value(row, output, inputs.len() + k) else {
                continue;
            };
            all[k].take(value);
            for (points, at) in points[k].iter_mut().zip(shared) {
                let Some(at) = at else { continue };
                points.resize(points.len().max(at + 1), Moments::NONE);
                points[at].take(value);
            }
            for (moments, level) in levels[k].iter_mut().zip(&at) {
                if let Some(level) = level {
                    moments[*level].take(value);
                }
            }
        }
    })?;
    let of_output = |(k, output): (usize, &Output)| {
        let values = Gathered {
            levels: &levels[k],
            all: &all[k],
            points: &points[k],
        };
        values.output(quantities, output)
    };
    Ok(outputs.iter().enumerate().map(of_output).collect())
}

/// Sum of the squares of the means of the levels about the mean, over their values.
fn between(levels: &[Moments], all: &Moments) -> f64 {
    let filled = levels.iter().filter(|l| l.count > 0.0);
    filled
        .map(|l| l.count * (l.mean() - all.mean()).powi(2))
        .sum()
}

/// Correlation ratio η²: variance between the levels over the whole variance.
fn share(levels: &[Moments], all: &Moments) -> Option<f64> {
    let share = between(levels, all) / (all.squares - all.sum * all.mean());
    share.is_finite().then(|| share.clamp(0.0, 1.0))
}

/// ε² of an input that is drawn (Kelley 1935): what the means of k levels would differ by without an effect,
/// (k − 1) times the mean square of the n points within the levels, is taken off. 0 where η² is within chance,
/// whose η² has the mean (k − 1)/(n − 1) and the variance 2(k − 1)(n − k)/((n − 1)²(n + 1)); `None` if
/// the points are too few.
fn share_of_drawn(levels: &[Moments], all: &Moments, points: Points) -> Option<f64> {
    let offset = all.sum * all.mean();
    let (whole, among) = (all.squares - offset, points.squares - offset);
    let k = levels.iter().filter(|l| l.count > 0.0).count() as f64;
    let n = points.count;
    let fewest = POINTS_MIN as f64;
    if n < fewest * k.max(fewest) {
        return None;
    }
    let between = between(levels, all);
    let chance = (k - 1.0) / (n - 1.0);
    let deviation = (2.0 * (k - 1.0) * (n - k) / (n + 1.0)).sqrt() / (n - 1.0);
    let share = (between - (k - 1.0) * (among - between) / (n - k)) / whole;
    let significant = between > (chance + DEVIATIONS * deviation) * among;
    let share = share.is_finite().then(|| share.clamp(0.0, 1.0));
    share.map(|share| if significant { share } else { 0.0 })
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
        min: of(|m| m.of_all(m.min)),
        max: of(|m| m.of_all(m.max)),
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
        // Two inputs make a map, of which only cells lack values.
        [x, y] if output.missing > 0 && inputs.len() == 2 => Some((x, y)),
        [x, y] if output.shares[x].unwrap_or(0.0) >= SHARE_MIN => Some((x, y)),
        _ => None,
    };
    let pairs: Vec<_> = outputs.iter().map(pair).collect();
    let grid = |pair: &Option<(usize, usize)>| match *pair {
        Some((x, y)) => vec![vec![Moments::NONE; inputs[x].count()]; inputs[y].count()],
        None => Vec::new(),
    };
    let mut grids: Vec<Vec<Vec<Moments>>> = pairs.iter().map(grid).collect();
    table.each(&wanted(table, quantities), |row: &Row| {
        for (k, output) in quantities.outputs.iter().enumerate() {
            let (Some((x, y)), Some(value)) = (pairs[k], value(row, output, inputs.len() + k))
            else {
                continue;
            };
            if let (Some(column), Some(line)) = (inputs[x].level(&row[x]), inputs[y].level(&row[y]))
            {
                grids[k][line][column].take(value);
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
    use std::f64::consts::PI;

    use cageless::numerics::RandomStream;

    use super::super::quantities::stretches_of_equal_count;
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

    /// Shares of each column of points, in [0, 1), of the values of a function, all counted `rows` times.
    fn of_function<const D: usize>(
        points: &[[f64; D]],
        rows: usize,
        f: impl Fn(&[f64; D], usize) -> f64,
    ) -> [Option<f64>; D] {
        let count = points.len() as u64;
        let columns: [Vec<f64>; D] = std::array::from_fn(|d| points.iter().map(|p| p[d]).collect());
        let edges = columns.map(|column| stretches_of_equal_count(column, count).1);
        let (mut all, mut shared) = (Moments::NONE, vec![Moments::NONE; points.len()]);
        let mut levels = edges.each_ref().map(|e| vec![Moments::NONE; e.len() + 1]);
        for (k, point) in points.iter().enumerate() {
            for row in 0..rows {
                let y = f(point, row);
                all.add(y);
                shared[k].add(y);
                for d in 0..D {
                    levels[d][edges[d].partition_point(|e| *e <= point[d])].add(y);
                }
            }
        }
        levels.map(|levels| share_of_drawn(&levels, &all, Points::of(&shared, &all)))
    }

    fn random<const D: usize>(count: u64, seed: u64) -> Vec<[f64; D]> {
        let point = |k| {
            let mut stream = RandomStream::new(seed, 0, 0, k);
            std::array::from_fn(|_| stream.uniform())
        };
        (0..count).map(point).collect()
    }

    /// Ishigami's function of angles from −π to π, and an input without any effect.
    fn ishigami(p: &[f64; 4], _: usize) -> f64 {
        let [a, b, c] = [p[0], p[1], p[2]].map(|u| PI * (2.0 * u - 1.0));
        a.sin() + 7.0 * b.sin().powi(2) + 0.1 * c.powi(4) * a.sin()
    }

    /// First-order indices of Ishigami's function, in closed form (Saltelli 2008): 0.3139, 0.4424 and 0.
    #[test]
    fn shares_of_drawn_inputs_are_sobol_indices() {
        let shares = of_function(&random(4096, 1), 1, ishigami).map(Option::unwrap);
        for (share, index) in shares.into_iter().zip([0.3139, 0.4424, 0.0, 0.0]) {
            // Twelve stretches lose a tenth of two whole waves.
            assert!((share - index).abs() < 0.06, "{shares:?}");
        }
        // What an input without any effect explains in small samples counts as nothing, but for one in twenty.
        for count in [16, 24, 64] {
            let runs = 400;
            let linear = |p: &[f64; 3], _: usize| 3.0 * p[0] + p[1];
            let shares = (0..runs).map(|seed| of_function(&random(count, seed), 1, linear));
            let shares: Vec<_> = shares.map(|s| s.map(Option::unwrap)).collect();
            let mean = |of: fn(&[f64; 3]) -> f64| shares.iter().map(of).sum::<f64>() / runs as f64;
            let [linear, without_effect] = [mean(|[first, ..]| *first), mean(|[.., last]| *last)];
            let stretches = count.isqrt() as f64;
            let expected = 0.9 * (1.0 - stretches.powi(-2));
            assert!((linear - expected).abs() < 0.06, "{count}: {linear}");
            let wrong = shares.iter().filter(|s| s[2] > 0.0).count();
            assert!(
                wrong < runs as usize / 10 && without_effect < 0.03,
                "{count}: {wrong}"
            );
        }
    }

    /// Too few points say nothing, also if each has many rows; what the rows of a point do is no effect of it.
    #[test]
    fn points_count_and_not_rows() {
        let linear = |p: &[f64; 2], row: usize| p[0] + row as f64;
        assert_eq!(of_function(&random::<2>(12, 1), 20, linear), [None; 2]);
        // Half of the variance is that of the rows, 1/12 each.
        let of_rows = |p: &[f64; 2], row: usize| p[0] + 12f64.sqrt() * (row as f64 - 0.5) / 6.0;
        let mut wrong = 0;
        for seed in 0..100 {
            let [first, second] = of_function(&random(64, seed), 2, of_rows).map(Option::unwrap);
            assert!((first - 0.5).abs() < 0.15, "{first}");
            wrong += usize::from(second > 0.0);
        }
        assert!(wrong < 10, "{wrong}");
    }
}
