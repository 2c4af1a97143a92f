//! Case of a variant by its index.

use cageless::Gaps;
use cageless::numerics::RandomStream;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::{CaseError, CaseFile, CaseValue, Change};
use cageless_io::plan_file::{
    Axis, BALL_DEVIATIONS, GAPS, PlanFile, SampleMethod, ScatterLaw, ScatteredKey, is_per_ball,
    is_whole, key_in_case, twelve_digits, unit,
};
use cageless_io::results::{Column, ColumnKind};
use cageless_results::Cell;

use super::latin_hypercube::LatinHypercube;
use super::random::Purpose;
use super::sobol::{self, Sobol};

/// Most variants of a plan.
pub(crate) const VARIANTS_MAX: u64 = 1_000_000_000;

/// The variants of a plan, each a pure function of its index.
#[derive(Debug, Clone)]
pub(crate) struct Variants {
    pub plan: PlanFile,
    points: Points,
    pub count: u64,
    /// Value of each scattered key in the base case.
    centres: Vec<Option<CaseValue>>,
    /// Columns of the inputs: axes of the grid, of the samples, scattered keys.
    pub columns: Vec<Column>,
}

#[derive(Debug, Clone)]
enum Points {
    None,
    Sobol(Sobol),
    LatinHypercube(LatinHypercube),
    Random,
}

/// A key, its value and where the plan gives it.
struct Setting<'a> {
    key: &'a str,
    value: CaseValue,
    line: usize,
}

impl Variants {
    pub(crate) fn new(plan: PlanFile) -> Result<Self, CaseError> {
        let count = count(&plan)?;
        let points = points(&plan)?;
        let centres = scattered(&plan).map(|key| centre(&plan, key));
        Ok(Self {
            points,
            count,
            centres: centres.collect::<Result<_, _>>()?,
            columns: columns(&plan),
            plan,
        })
    }

    /// The inputs of a variant and its case or rotor, or why there is none.
    pub(crate) fn variant(&self, index: u64) -> (Vec<Cell>, Result<BearingArrangement, CaseError>) {
        let (settings, failed) = self.settings(index);
        let cells = self.cells(&settings);
        let case = match failed {
            Some(error) => Err(error),
            None => self.read(&settings),
        };
        (cells, case)
    }

    fn read(&self, settings: &[Setting<'_>]) -> Result<BearingArrangement, CaseError> {
        let changes = settings.iter();
        let changes: Vec<_> = changes
            .map(|s| Change::new(s.key, &s.value, (&self.plan.name, s.line)))
            .collect();
        self.plan.base.with(&changes)
    }

    /// In the order of `columns`; null for what could not be drawn.
    fn cells(&self, settings: &[Setting<'_>]) -> Vec<Cell> {
        let columns = self.columns.iter().enumerate();
        columns
            .map(|(k, column)| match settings.get(k).map(|s| &s.value) {
                Some(value) => cell(value, column.kind),
                None => Cell::Null,
            })
            .collect()
    }

    /// Changes of the variant, axes first, and the reason if the rest could not be drawn.
    fn settings(&self, index: u64) -> (Vec<Setting<'_>>, Option<CaseError>) {
        let repeats = self.plan.scatter.as_ref().map_or(1, |s| s.repeats);
        let samples = self.plan.samples.as_ref().map_or(1, |s| s.count);
        let (rest, repeat) = (index / repeats, index % repeats);
        let (mut node, sample) = (rest / samples, rest % samples);
        let mut settings: Vec<Setting<'_>> = Vec::new();
        for axis in self.plan.grid.iter().rev() {
            let length = axis.len().unwrap_or(1).max(1);
            settings.push(setting(axis, axis.value(node % length)));
            node /= length;
        }
        settings.reverse();
        for (k, axis) in self.plan.samples.iter().flat_map(|s| &s.axes).enumerate() {
            settings.push(setting(axis, axis.value_at(self.place(sample, k))));
        }
        // The same deviations at every node of the grid: what differs is the node.
        let draw = sample * repeats + repeat;
        for (k, (key, centre)) in scattered(&self.plan).zip(&self.centres).enumerate() {
            let stream = Purpose::Scatter.stream(self.plan.seed, k, draw);
            let drawn = self.deviated(key, centre.as_ref(), &settings, stream);
            match (drawn, settings.iter_mut().find(|s| s.key == key.key)) {
                (Ok(value), Some(varied)) => varied.value = value,
                (Ok(value), None) => settings.push(Setting {
                    key: &key.key,
                    value,
                    line: key.line,
                }),
                (Err(error), _) => return (settings, Some(error)),
            }
        }
        (settings, None)
    }

    /// Place of a sample on an axis, 0 to 1.
    fn place(&self, sample: u64, axis: usize) -> f64 {
        match &self.points {
            Points::None => 0.0,
            Points::Sobol(sobol) => sobol.at(sample, axis),
            Points::LatinHypercube(hypercube) => hypercube.at(sample, axis),
            Points::Random => Purpose::Position
                .stream(self.plan.seed, axis, sample)
                .uniform(),
        }
    }

    fn deviated(
        &self,
        key: &ScatteredKey,
        centre: Option<&CaseValue>,
        settings: &[Setting<'_>],
        mut stream: RandomStream,
    ) -> Result<CaseValue, CaseError> {
        let mut deviation = || match key.law {
            ScatterLaw::Normal(width) => width * stream.normal(),
            ScatterLaw::Uniform(width) => width * (2.0 * stream.uniform() - 1.0),
            ScatterLaw::Random => stream.exponential(),
        };
        let varied = settings.iter().find(|s| s.key == key.key);
        match key_in_case(&key.key) {
            BALL_DEVIATIONS => {
                let file = self.read(settings)?;
                let balls = file
                    .cases_of(&key.key)
                    .iter()
                    .map(|f| f.case().bearing.balls());
                let balls = common(balls).ok_or_else(|| differs(&self.plan, key))?;
                let centres = match centre {
                    Some(CaseValue::Numbers(list)) if list.len() == balls => list.clone(),
                    _ => vec![0.0; balls],
                };
                let list = centres.iter().map(|c| twelve_digits(c + deviation()));
                Ok(CaseValue::Numbers(list.collect()))
            }
            GAPS => {
                let file = self.read(settings)?;
                let centres = common(file.cases_of(&key.key).iter().map(gaps_deg));
                let centres = centres.ok_or_else(|| differs(&self.plan, key))?;
                let list = centres.iter().map(|_| deviation()).collect();
                Ok(CaseValue::Numbers(match key.law {
                    ScatterLaw::Random => arranged(&centres, list),
                    _ => shifted(&centres, list),
                }))
            }
            _ => {
                let value = varied.map(|s| &s.value).or(centre);
                let value = match value {
                    Some(CaseValue::Number(value)) => *value,
                    Some(CaseValue::Integer(value)) => *value as f64,
                    _ => return Err(no_centre(&self.plan, key)),
                };
                Ok(CaseValue::Number(twelve_digits(value + deviation())))
            }
        }
    }
}

/// Gaps that make a whole turn, as likely one way as any other: the spacings of points
/// thrown at random on what the balls leave free.
fn arranged(centres: &[f64], list: Vec<f64>) -> Vec<f64> {
    let (room, sum) = (centres.iter().sum::<f64>(), list.iter().sum::<f64>());
    let share = |x: f64| twelve_digits(room * x / sum);
    list.into_iter().map(share).collect()
}

/// Gaps with deviations whose mean is taken off, so that they still make a whole turn.
fn shifted(centres: &[f64], list: Vec<f64>) -> Vec<f64> {
    let mean = list.iter().sum::<f64>() / list.len() as f64;
    let gap = |(centre, x): (&f64, f64)| twelve_digits(centre + x - mean);
    centres.iter().zip(list).map(gap).collect()
}

/// The gaps of a case, in degrees.
fn gaps_deg(file: &CaseFile) -> Vec<f64> {
    let bearing = &file.case().bearing;
    match &file.case().start.gaps {
        Gaps::Uniform => vec![bearing.mean_gap_rad().to_degrees(); bearing.balls()],
        Gaps::List(list) => list.iter().map(|gap| gap.to_degrees()).collect(),
    }
}

fn setting(axis: &Axis, value: CaseValue) -> Setting<'_> {
    Setting {
        key: &axis.key,
        value,
        line: axis.line,
    }
}

/// The name of an input: its key with underscores, and the unit if the key has none.
pub(super) fn column_name(key: &str) -> String {
    let name = key.replace('.', "_");
    match key_in_case(key) {
        GAPS => name + "_deg",
        _ => name,
    }
}

fn cell(value: &CaseValue, kind: ColumnKind) -> Cell {
    match (value, kind) {
        (CaseValue::Text(text), _) => Cell::Text(text.clone()),
        (value, ColumnKind::Text) => Cell::Text(value.written()),
        (CaseValue::Numbers(list), _) => Cell::Numbers(list.clone()),
        (CaseValue::Table(_), _) => Cell::Text(value.written()),
        (CaseValue::Integer(value), ColumnKind::Integer) => Cell::Integer(*value),
        // Of a range; what is not whole is refused by the case and has no cell.
        (CaseValue::Number(value), ColumnKind::Integer) if value.fract() == 0.0 => {
            Cell::Integer(*value as i64)
        }
        (CaseValue::Number(_), ColumnKind::Integer) => Cell::Null,
        (CaseValue::Integer(value), _) => Cell::Number(*value as f64),
        (CaseValue::Number(value), _) => Cell::Number(*value),
    }
}

fn scattered(plan: &PlanFile) -> impl Iterator<Item = &ScatteredKey> {
    plan.scatter.iter().flat_map(|s| &s.keys)
}

/// Axes of the grid, then of the samples.
fn axes(plan: &PlanFile) -> impl Iterator<Item = &Axis> {
    let samples = plan.samples.iter().flat_map(|s| &s.axes);
    plan.grid.iter().chain(samples)
}

fn columns(plan: &PlanFile) -> Vec<Column> {
    let of_axes = axes(plan).map(|axis| Column {
        name: column_name(&axis.key).into(),
        unit: axis.unit().into(),
        kind: match axis {
            axis if axis.is_text() => ColumnKind::Text,
            axis if is_whole(&axis.key) => ColumnKind::Integer,
            _ => ColumnKind::Number,
        },
    });
    // What varies and is scattered has one column.
    let scattered = scattered(plan).filter(|key| !axes(plan).any(|axis| axis.key == key.key));
    let of_scattered = scattered.map(|key| Column {
        name: column_name(&key.key).into(),
        unit: unit(&key.key).into(),
        kind: if is_per_ball(&key.key) {
            ColumnKind::Numbers
        } else {
            ColumnKind::Number
        },
    });
    of_axes.chain(of_scattered).collect()
}

fn count(plan: &PlanFile) -> Result<u64, CaseError> {
    let axes = plan.grid.iter().map(|a| (a.line, a.len().unwrap_or(1)));
    let samples = plan.samples.iter().map(|s| (s.axes[0].line, s.count));
    let scatter = plan.scatter.iter().map(|s| (s.keys[0].line, s.repeats));
    let mut total = 1_u128;
    let mut largest = (0, 0);
    for (line, length) in axes.chain(samples).chain(scatter) {
        total = total.saturating_mul(u128::from(length));
        largest = largest.max((length, line));
    }
    match u64::try_from(total) {
        Ok(total) if total <= VARIANTS_MAX => Ok(total),
        _ => {
            let message = format!(
                "the plan has {} variants: at most {VARIANTS_MAX} are possible; take fewer values \
                 here, or samples in place of a grid",
                in_words(total)
            );
            Err(plan.error(largest.1, "grid", message))
        }
    }
}

fn in_words(count: u128) -> String {
    match count {
        u128::MAX => "more than 10^38".to_owned(),
        count if count >= 1_000_000_000_000_000 => format!("{:.1e}", count as f64),
        count => count.to_string(),
    }
}

fn points(plan: &PlanFile) -> Result<Points, CaseError> {
    let Some(samples) = &plan.samples else {
        return Ok(Points::None);
    };
    let (axes, count) = (samples.axes.len(), samples.count);
    match samples.method {
        SampleMethod::Random => Ok(Points::Random),
        SampleMethod::LatinHypercube => Ok(Points::LatinHypercube(LatinHypercube::new(
            axes, count, plan.seed,
        ))),
        SampleMethod::Sobol if axes <= sobol::DIMENSIONS && count <= sobol::POINTS => {
            Ok(Points::Sobol(Sobol::new(axes, plan.seed)))
        }
        SampleMethod::Sobol => {
            let message = format!(
                "Sobol's sequence is there for {} axes and 2^32 points, not for {axes} axes and \
                 {count} points: \"latin-hypercube\" takes any number",
                sobol::DIMENSIONS
            );
            Err(plan.error(samples.axes[0].line, "samples.method", message))
        }
    }
}

/// Centre value of a scattered key. An axis of the same key takes precedence.
fn centre(plan: &PlanFile, key: &ScatteredKey) -> Result<Option<CaseValue>, CaseError> {
    if is_whole(&key.key) {
        let message = format!("{} is a whole number: it cannot be scattered", key.key);
        return Err(plan.error(key.line, &key.key, message));
    }
    let axis = axes(plan).find(|axis| axis.key == key.key);
    let centre = match common(plan.base_file.values(&key.key)) {
        Some(centre) => centre,
        None if axis.is_some() => None,
        None => return Err(differs(plan, key)),
    };
    let numeric = match axis {
        Some(axis) => !axis.is_text(),
        None => matches!(centre, Some(CaseValue::Number(_) | CaseValue::Integer(_))),
    };
    if numeric || is_per_ball(&key.key) {
        Ok(centre)
    } else {
        Err(no_centre(plan, key))
    }
}

fn no_centre(plan: &PlanFile, key: &ScatteredKey) -> CaseError {
    let message = format!(
        "{} has no number in the case that it could deviate from",
        key.key
    );
    plan.error(key.line, &key.key, message)
}

/// Value common to all bearings; `None` if they differ.
fn common<T: PartialEq>(values: impl IntoIterator<Item = T>) -> Option<T> {
    let mut values = values.into_iter();
    let first = values.next()?;
    values.all(|value| value == first).then_some(first)
}

fn differs(plan: &PlanFile, key: &ScatteredKey) -> CaseError {
    let message = format!(
        "{} differs from bearing to bearing: scatter bearing.1.{} and so on, each about its own",
        key.key, key.key
    );
    plan.error(key.line, &key.key, message)
}
