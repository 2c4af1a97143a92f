//! The analysis of a finished sweep.

use serde::{Deserialize, Serialize};

use crate::{Parameter, Provenance};
use cageless_results::{bearing_in_column, unit_text};

/// Smallest share of the variance by which an input explains an output.
pub(super) const SHARE_MIN: f64 = 0.01;

/// Data of the page of a sweep. Empty parts are omitted from the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SweepData {
    /// Title of the plan.
    pub title: String,
    /// Name and version of the program, instruction set.
    pub software: String,
    /// First paragraph: what was computed.
    pub lead: String,
    /// Warnings on the numbers.
    #[serde(default)]
    pub warnings: Vec<String>,
    /// Number of variants.
    pub variants: u64,
    /// Number of failed variants.
    pub failed: u64,
    /// Number of variants with passing raceways and number of judged variants; `None` without verdicts.
    pub passed: Option<[u64; 2]>,
    /// Inputs with more than one value.
    pub inputs: Vec<SweepQuantity>,
    /// Outputs with more than one value, with what they depend on: the verdict, those by which
    /// the best are sought, other results, and last what only the computation is about.
    pub outputs: Vec<SweepOutput>,
    /// Number of leading outputs that the page shows at once.
    pub chosen: usize,
    /// Outputs that are the same in all variants.
    pub constants: Vec<Parameter>,
    /// The best variants.
    pub best: Vec<BestVariants>,
    /// Reasons of failed variants.
    pub failures: Vec<FailureGroup>,
    /// The plan, one line per key.
    pub plan: Vec<Parameter>,
    /// Provenance of every figure.
    pub provenance: Provenance,
}

/// An input or an output.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SweepQuantity {
    /// Name of the column.
    pub name: String,
    /// Unit; may be empty.
    pub unit: String,
}

impl SweepQuantity {
    /// `name (unit)`.
    pub fn label(&self) -> String {
        match self.sign().as_str() {
            "" => self.name.clone(),
            unit => format!("{} ({unit})", self.name),
        }
    }

    /// Whether an input is a condition of operation or computation, which a designer meets, and
    /// not a choice, which a designer makes.
    pub fn is_condition(&self) -> bool {
        const CONDITIONS: [&str; 6] = [
            "operation_",
            "start_",
            "contact_",
            "model_",
            "solver_",
            "output_",
        ];
        let key = bearing_in_column(&self.name).map_or(self.name.as_str(), |(_, key)| key);
        key == "repeat" || CONDITIONS.iter().any(|section| key.starts_with(section))
    }

    /// The unit as people write it.
    pub fn sign(&self) -> String {
        unit_text(&self.unit)
    }
}

/// Sensitivity of an output.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SweepOutput {
    /// The output.
    pub quantity: SweepQuantity,
    /// Number of its values.
    pub count: u64,
    /// Number of variants that lack its value, as the computation failed.
    #[serde(default)]
    pub missing: u64,
    /// Mean of its values; NaN if one is missing.
    pub mean: f64,
    /// Share of its variance that each of [`SweepData::inputs`] explains alone, 0 to 1, `None` if a value is missing: η² of an axis of the
    /// grid; ε² of what is drawn, 0 within chance, `None` of fewer than 16 points.
    pub shares: Vec<Option<f64>>,
    /// Effects of the inputs that explain most, largest first.
    pub effects: Vec<MainEffect>,
    /// Mean of the output over the two inputs that explain most.
    pub map: Option<HeatMap>,
}

impl SweepOutput {
    /// The input of `inputs` that explains most, and its share; `None` if none explains anything, or one whose
    /// share is not given may explain more.
    pub fn strongest<'i>(&self, inputs: &'i [SweepQuantity]) -> Option<(&'i SweepQuantity, f64)> {
        let shares = inputs.iter().zip(&self.shares);
        let shares = shares.filter_map(|(input, share)| Some((input, (*share)?)));
        let most = shares.reduce(|a, b| if b.1 > a.1 { b } else { a });
        let rest = match self.shares.contains(&None) {
            true => 1.0 - self.shares.iter().flatten().sum::<f64>(),
            false => 0.0,
        };
        most.filter(|(_, share)| *share >= SHARE_MIN.max(rest))
    }
}

/// An output over one input.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct MainEffect {
    /// The input.
    pub input: SweepQuantity,
    /// Levels of the input.
    pub levels: Levels,
    /// Mean of the output at each level.
    pub mean: Vec<f64>,
    /// Least.
    pub min: Vec<f64>,
    /// Most.
    pub max: Vec<f64>,
}

/// Values of an input: those that it takes, or the middles of equal stretches.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Levels {
    /// Numbers.
    Numbers(Vec<f64>),
    /// Names.
    Names(Vec<String>),
}

impl Default for Levels {
    fn default() -> Self {
        Self::Numbers(Vec::new())
    }
}

/// Mean of an output over two inputs.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct HeatMap {
    /// Input along x.
    pub x_input: SweepQuantity,
    /// Levels of the input along x.
    pub x: Levels,
    /// Input along y.
    pub y_input: SweepQuantity,
    /// Levels of the input along y.
    pub y: Levels,
    /// Mean at each y, at each x; NaN where there is no variant.
    pub mean: Vec<Vec<f64>>,
}

/// The best variants by one output.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct BestVariants {
    /// The output.
    pub quantity: SweepQuantity,
    /// Whether more is better.
    pub high: bool,
    /// Whether the best are sought at each combination of conditions by itself.
    pub per_condition: bool,
    /// The best first, of one condition after the other.
    pub variants: Vec<BestVariant>,
}

/// One of the best variants.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct BestVariant {
    /// Index of the variant.
    pub variant: u64,
    /// The output.
    pub value: f64,
    /// [`SweepData::inputs`] as they are to be printed.
    pub inputs: Vec<String>,
}

/// Variants that failed for one reason, numbers apart.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FailureGroup {
    /// Number of samples or passages.
    pub count: u64,
    /// The first.
    pub variant: u64,
    /// Reason of the failure.
    pub reason: String,
}
