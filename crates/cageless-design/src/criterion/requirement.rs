//! Requirement of a criterion, and the meaning of missing it.

use super::super::raceway_verdict::RacewayVerdict;
use cageless::contact::STRESS_LIMIT_PA;

/// Unit in which a value is shown.
#[derive(Debug)]
pub(super) struct Unit {
    /// Symbol of the unit.
    pub(super) name: &'static str,
    /// How many of it a value of 1 is.
    pub(super) per_one: f64,
    /// Decimals at least.
    pub(super) decimals: usize,
    /// Unit of a margin.
    pub(super) of_margin: &'static str,
}

/// Fractions in per cent.
pub(super) static PERCENT: Unit = Unit {
    name: "%",
    per_one: 100.0,
    decimals: 1,
    of_margin: "percentage points",
};

/// Fractions of the limit of ISO 76 in MPa.
pub(super) static MEGAPASCAL: Unit = Unit {
    name: "MPa",
    per_one: 1e-6 * STRESS_LIMIT_PA,
    decimals: 0,
    of_margin: "MPa",
};

/// Kind of a cause for which a search rejects a raceway.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CauseKind {
    /// Name in files.
    pub name: &'static str,
    /// Defect of the raceway, in words.
    pub meaning: &'static str,
    /// Change of the search to try where this cause decides.
    pub remedy: &'static str,
}

/// An end of the range of a value.
#[derive(Debug)]
pub(super) struct Bound {
    /// The last value within.
    pub(super) limit: f64,
    /// Verdict beyond it.
    pub(super) verdict: RacewayVerdict,
    /// Cause of a rejection beyond it.
    pub(super) cause: CauseKind,
}

/// Requirement of a criterion: range of its value, unit and texts. One file has one of them, all that is said of it.
#[derive(Debug)]
pub struct Requirement {
    /// Name in files.
    pub(super) name: &'static str,
    /// Least value.
    pub(super) least: Option<Bound>,
    /// Largest value.
    pub(super) most: Option<Bound>,
    /// Unit in which it is shown.
    pub(super) unit: &'static Unit,
    /// Origin of the limit, as a suffix to its text, such as ISO 76; empty where that is plain.
    pub(super) limit_of: &'static str,
    /// Sentence on a value, `{}` for the value itself.
    pub(super) sentence: fn(f64) -> &'static str,
    /// Name of the value in the reason of a missing verdict, where the value is no number.
    pub(super) unknown: &'static str,
    /// Power of the value in what brings it about: the load that makes a pressure grows as its cube.
    pub(super) power: i32,
    /// Whether the largest value of several runs counts, else their mean.
    pub(super) largest_counts: bool,
}

/// Two of one name are the same.
impl PartialEq for Requirement {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Requirement {
    /// A requirement in per cent without limits, whose mean over several runs counts.
    pub(super) const PERCENT: Self = Self {
        name: "",
        least: None,
        most: None,
        unit: &PERCENT,
        limit_of: "",
        sentence: |_| "",
        unknown: "",
        power: 1,
        largest_counts: false,
    };

    /// Least value, else the largest.
    pub fn limit(&self) -> f64 {
        let bound = self.least.as_ref().or(self.most.as_ref());
        bound.map_or(f64::NAN, |bound| bound.limit)
    }

    /// Kinds of causes of a rejection, at the least value first.
    pub(in super::super) fn causes(&'static self) -> impl Iterator<Item = &'static CauseKind> {
        [&self.least, &self.most]
            .into_iter()
            .flatten()
            .map(|bound| &bound.cause)
    }
}
