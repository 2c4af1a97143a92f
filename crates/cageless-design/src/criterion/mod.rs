//! The criteria of a verdict, each with its value, its limits and the margin between them.

mod both_neighbours;
mod deceleration;
mod film;
mod lag;
mod pressure;
mod requirement;
mod retained_gap;
mod separation;
mod steady_gap;

use super::raceway_verdict::RacewayVerdict;
use requirement::Bound;

pub(crate) use both_neighbours::BOTH_NEIGHBOURS;
pub(crate) use deceleration::DECELERATION;
pub(crate) use film::{FILM_OUTWEIGHS, FILM_QUEUE};
pub(crate) use lag::{AXIAL_LAG, LAG};
pub(crate) use pressure::{PEAK_PRESSURE, PRESSURE_AT_REST};
pub use requirement::{CauseKind, Requirement};
pub(crate) use separation::SEPARATION;
pub use steady_gap::STEADY_GAP;

pub(super) use retained_gap::RETAINED_GAP;
pub(super) use steady_gap::{IN_OIL, STEADY_GAP_MAX, THEORETICAL_GAP};

/// All requirements of a search, in the order in which they are tested.
pub(super) static OF_SEARCH: [&Requirement; 9] = [
    &THEORETICAL_GAP,
    &SEPARATION,
    &STEADY_GAP,
    &PRESSURE_AT_REST,
    &DECELERATION,
    &LAG,
    &RETAINED_GAP,
    &BOTH_NEIGHBOURS,
    &AXIAL_LAG,
];

/// One requirement on the motion of the balls with its value, of verdict and search alike. Values, limits and
/// margins are fractions of 1, pressures those of the 4200 MPa of ISO 76.
///
/// ```
/// use cageless_design::STEADY_GAP;
///
/// let gap = STEADY_GAP.of(0.76);
/// assert!(!gap.is_met());
/// assert_eq!(
///     gap.to_string(),
///     "the critical gap is 76.0 % of the steady-state gap (80 to 100 % needed, missed by 4.0 percentage points)"
/// );
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Criterion {
    requirement: &'static Requirement,
    /// Measured value.
    pub value: f64,
    least: f64,
    most: f64,
}

impl Requirement {
    /// The criterion with this value, a fraction of 1.
    pub fn of(&'static self, value: f64) -> Criterion {
        let limit = |bound: &Option<Bound>, none: f64| bound.as_ref().map_or(none, |b| b.limit);
        Criterion {
            requirement: self,
            value,
            least: limit(&self.least, f64::NEG_INFINITY),
            most: limit(&self.most, f64::INFINITY),
        }
    }
}

impl Criterion {
    /// Name in files.
    pub fn name(self) -> &'static str {
        self.requirement.name
    }

    /// The criterion with another value.
    pub(super) fn with_value(self, value: f64) -> Self {
        Self { value, ..self }
    }

    /// The criterion with another largest value.
    pub(super) fn with_most(self, most: f64) -> Self {
        Self { most, ..self }
    }

    /// The criterion with another least value.
    pub(super) fn with_least(self, least: f64) -> Self {
        Self { least, ..self }
    }

    /// Whether the largest value of several runs counts, else their mean.
    pub(super) fn largest_counts(self) -> bool {
        self.requirement.largest_counts
    }

    /// Limit of the value; of one with two the nearer.
    pub fn limit(self) -> f64 {
        match self.at_least() {
            true => self.least,
            false => self.most,
        }
    }

    /// Whether the limit is the least value, else it is the largest.
    pub fn at_least(self) -> bool {
        let middle = 0.5 * (self.least + self.most);
        self.most.is_infinite() || (self.least.is_finite() && self.value < middle)
    }

    /// Distance of the value from its limit, negative beyond it.
    pub fn margin(self) -> f64 {
        match self.at_least() {
            true => self.value - self.least,
            false => self.most - self.value,
        }
    }

    /// Whether the limit is kept. A value that is not a number keeps none.
    pub fn is_met(self) -> bool {
        self.margin() >= 0.0
    }

    /// Whether the value is a number: without one nothing is judged.
    pub(crate) fn is_known(self) -> bool {
        !self.value.is_nan()
    }

    /// Loss of critical gap by sliding as a criterion; `None` on elastic flanks. There spin on the flanks takes a
    /// part of it in every raceway, which a deeper one makes up for.
    pub(super) fn separation(elastic: bool, shortfall: f64) -> Option<Self> {
        (!elastic).then(|| SEPARATION.of(shortfall))
    }

    /// How far a raceway slows the balls: on elastic flanks by the lag that is left, on rigid ones by the
    /// deceleration that is reached.
    pub(super) fn slowing(elastic: bool, speed_drop_fraction: f64, lag_fraction: f64) -> Self {
        match elastic {
            true => LAG.of(lag_fraction),
            false => DECELERATION.of(speed_drop_fraction),
        }
    }

    /// The nearer end of the range.
    fn bound(self) -> Option<&'static Bound> {
        match self.at_least() {
            true => self.requirement.least.as_ref(),
            false => self.requirement.most.as_ref(),
        }
    }

    /// The verdict on a raceway that this criterion decides.
    pub(crate) fn verdict(self) -> RacewayVerdict {
        match self.bound() {
            Some(bound) if self.is_known() && !self.is_met() => bound.verdict,
            _ if self.is_met() => RacewayVerdict::Smooth,
            _ => RacewayVerdict::NotJudged,
        }
    }

    /// Kind of the cause for which a search rejects a raceway that misses the limit.
    pub(super) fn cause(self) -> Option<&'static CauseKind> {
        self.bound().map(|bound| &bound.cause)
    }

    /// Margin over that of a raceway without load, sliding and collisions: 1 there, 0 at the limit.
    pub(crate) fn relative_margin(self) -> f64 {
        match [self.least, self.most] {
            [least, most] if least.is_infinite() => {
                1.0 - (self.value / most).powi(self.requirement.power)
            }
            [least, most] if most.is_infinite() => (self.value - least) / (1.0 - least),
            [least, most] => self.margin() / (0.5 * (most - least)),
        }
    }

    /// The criterion that decides: the first that fails, else the one nearest to its limit; `None` without any, and
    /// where one that is not known might fail.
    pub(crate) fn deciding(all: &[Self]) -> Option<Self> {
        let failed = all.iter().find(|c| c.is_known() && !c.is_met());
        let known = || all.iter().all(|c| c.is_known());
        let nearest = || {
            let all = all.iter();
            all.min_by(|a, b| a.relative_margin().total_cmp(&b.relative_margin()))
        };
        let deciding = failed.or_else(|| nearest().filter(|_| known()));
        deciding.copied()
    }

    /// The criterion that is missed by most of all, in words behind the one that decides; empty where that is it.
    pub(super) fn missed_by_most(all: &[Self], deciding: Self) -> String {
        let failed = all.iter().filter(|c| c.is_known() && !c.is_met());
        let most = failed.min_by(|a, b| a.margin().total_cmp(&b.margin()));
        match most {
            Some(most) if most.margin() < deciding.margin() => format!("; missed by most: {most}"),
            _ => String::new(),
        }
    }

    /// The verdict of all criteria of a raceway.
    pub(super) fn verdict_of(all: &[Self]) -> RacewayVerdict {
        Self::deciding(all).map_or(RacewayVerdict::NotJudged, Self::verdict)
    }

    /// Reason of a missing verdict, as a sentence on the first unknown value; `None` if all values are known.
    pub(super) fn missing(all: &[Self]) -> Option<String> {
        let unknown = all.iter().find(|c| !c.is_known())?;
        let what = unknown.requirement.unknown;
        Some(format!("{what} is not known: no number came out"))
    }
}

/// Decimals that keep a value from being printed as equal to the limit that it misses: `least` at
/// least, six at most.
fn decimals(value: f64, limit: f64, least: usize) -> usize {
    let shown = |x: f64, digits: usize| format!("{x:.digits$}");
    (least..6)
        .find(|&digits| value == limit || shown(value, digits) != shown(limit, digits))
        .unwrap_or(6)
}

/// A number with as many decimals, `least` at least, as tell it from its limit.
fn beside(value: f64, limit: f64, least: usize) -> String {
    format!("{value:.*}", decimals(value, limit, least))
}

/// A fraction in percentage points: `0.03`.
pub(super) fn percentage_points(fraction: f64) -> String {
    let unit = &requirement::PERCENT;
    beside(unit.per_one * fraction, 0.0, unit.decimals)
}

impl std::fmt::Display for Criterion {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let required = self.requirement;
        let unit = required.unit;
        let [value, limit, margin] =
            [self.value, self.limit(), self.margin().abs()].map(|x| unit.per_one * x);
        let shown = format!("{} {}", beside(value, limit, unit.decimals), unit.name);
        let sentence = (required.sentence)(self.value).replace("{}", &shown);
        let [least, most] = [self.least, self.most].map(|x| unit.per_one * x);
        write!(f, "{sentence} (")?;
        match (least.is_finite(), most.is_finite()) {
            (true, true) => write!(f, "{least:.0} to {most:.0} {} needed", unit.name),
            (true, false) => write!(f, "{least:.0} {} needed", unit.name),
            _ => write!(f, "limit {most:.0} {}{}", unit.name, required.limit_of),
        }?;
        let word = match self.is_met() {
            true => "margin",
            false => "missed by",
        };
        let margin = beside(margin, 0.0, unit.decimals);
        write!(f, ", {word} {margin} {})", unit.of_margin)
    }
}

#[cfg(test)]
mod tests;
