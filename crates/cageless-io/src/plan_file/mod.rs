//! The plan of a sweep: a case or a rotor file, what varies in it and what is computed of each
//! variant.
//!
//! ```toml
//! case = "bearing.toml"
//! compute = ["static", "run"]
//!
//! [grid]
//! raceway.half_angle_deg = { from = 20.0, to = 30.0, count = 11 }
//! model.formulation = ["physical", "paper"]
//! ```
//!
//! Every error becomes one [`CaseError`], as in a case file.

mod axis;
mod conflict;
mod key;
mod keys;
mod normal;
mod read;
mod read_axis;

use cageless_results::Computation;

use crate::arrangement::{ArrangementDocument, BearingArrangement};
use crate::case_file::named::named;
use crate::case_file::{CaseError, SectionTable};

pub use axis::{Axis, AxisValues, Range, Scale, twelve_digits};
pub use key::{BALL_DEVIATIONS, GAPS, is_per_ball, is_whole, key_in_case, unit};
pub use normal::{difference, shortened, text_of};

/// Every section of a plan with its keys; the head of the file first, without a name.
pub fn reference() -> impl Iterator<Item = SectionTable> {
    keys::PLAN.reference()
}

/// A plan that was read and checked.
#[derive(Debug, Clone)]
pub struct PlanFile {
    /// Name of the file, for messages.
    pub name: String,
    /// Free text.
    pub title: String,
    /// Seed of whatever is random, at most 2^63 − 1.
    pub seed: u64,
    /// The case or the rotor file, with the changes of `[set]`.
    pub base: ArrangementDocument,
    /// [`PlanFile::base`] as it is read, possible in itself.
    pub base_file: BearingArrangement,
    /// Axes of the grid in the order of the case file's keys; the last varies fastest.
    pub grid: Vec<Axis>,
    /// Points in the space of further axes, taken for each node of the grid.
    pub samples: Option<Samples>,
    /// Random deviations, for each of those points.
    pub scatter: Option<Scatter>,
    /// Computations, without repetition.
    pub compute: Vec<Computation>,
    /// Columns to keep besides the inputs; all if `None`.
    pub keep: Option<Vec<Kept>>,
}

cageless::named_enum! {
    /// Method of sampling the space of the axes of `[samples]`.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum SampleMethod {
        /// Sobol's sequence, shifted by the seed.
        Sobol = "sobol",
        /// One point in each of `count` slices of each axis.
        LatinHypercube = "latin-hypercube",
        /// Independent points.
        Random = "random",
    }
}

named!(SampleMethod);

/// `[samples]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// Method of sampling.
    pub method: SampleMethod,
    /// Number of points.
    pub count: u64,
    /// Axes in the order of the case file's keys.
    pub axes: Vec<Axis>,
}

/// `[scatter]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Scatter {
    /// Draws for each point.
    pub repeats: u64,
    /// Scattered keys, in the order of the case file.
    pub keys: Vec<ScatteredKey>,
}

/// A key with random deviations.
#[derive(Debug, Clone, PartialEq)]
pub struct ScatteredKey {
    /// The key, as [`Axis::key`].
    pub key: String,
    /// Distribution of the deviation; of a list, each item independently.
    pub law: ScatterLaw,
    /// Line of the plan.
    pub line: usize,
}

/// Distribution of a deviation, in the unit of the key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ScatterLaw {
    /// Normal, of this standard deviation.
    Normal(f64),
    /// Uniform, up to this on either side.
    Uniform(f64),
    /// `start.gaps` only: every arrangement of the balls is as likely as any other.
    Random,
}

/// A column that the plan keeps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Kept {
    /// Name of the column.
    pub name: String,
    /// Line of the plan.
    pub line: usize,
}

impl PlanFile {
    /// The message at a line of the plan: file, line, key, what is wrong.
    pub fn error(&self, line: usize, key: &str, message: String) -> CaseError {
        CaseError::on_line(&self.name, line, Some(key.to_owned()), message)
    }
}
