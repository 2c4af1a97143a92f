//! Verdict on a sample.

use cageless::numerics::wilson_interval;

/// Fraction of all that has to pass.
const PASS_FRACTION: f64 = 0.95;

/// Number of a sample that pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SampleCount {
    /// Number of samples that pass.
    pub passed: usize,
    /// All.
    pub count: usize,
    /// Number of samples that were not judged.
    pub open: usize,
}

impl SampleCount {
    /// Probability of passing; `None` if some are open, or without any.
    pub fn probability(&self) -> Option<f64> {
        (self.open == 0 && self.count > 0).then(|| self.passed as f64 / self.count as f64)
    }

    /// 95 % interval of that probability (Wilson 1927), whatever those that are open would do.
    ///
    /// # Panics
    /// Without any.
    pub fn interval(&self) -> [f64; 2] {
        let [least, most] = [self.passed, self.passed + self.open]
            .map(|passed| wilson_interval(passed, self.count));
        [least[0], most[1]]
    }

    /// Whether 95 % of all pass; `None` where the interval leaves it open.
    ///
    /// # Panics
    /// Without any.
    pub fn passes(&self) -> Option<bool> {
        match self.interval() {
            [low, _] if low >= PASS_FRACTION => Some(true),
            [_, high] if high < PASS_FRACTION => Some(false),
            _ => None,
        }
    }

    /// Smallest sample that [passes](Self::passes), if all of it do.
    fn least() -> usize {
        let enough = |count: &usize| wilson_interval(*count, *count)[0] >= PASS_FRACTION;
        (1..).find(enough).unwrap_or(usize::MAX)
    }

    /// How many of them, `what` in the plural, pass, with the probability.
    ///
    /// # Panics
    /// Without any.
    pub fn text(&self, what: &str) -> String {
        let [low, high] = self.interval().map(|p| 100.0 * p);
        let needed = 100.0 * PASS_FRACTION;
        let probability = self.probability();
        let probability = probability.map_or(String::new(), |p| format!(" {:.1} %", 100.0 * p));
        let open = match self.open {
            0 => String::new(),
            1 => ", 1 is not judged".to_owned(),
            count => format!(", {count} are not judged"),
        };
        format!(
            "{} of {} {what} pass{open}, probability of passing{probability} (95 % interval {low:.1} to \
             {high:.1} %, {needed:.0} % needed)",
            self.passed, self.count,
        )
    }

    /// Why they leave open whether 95 % pass, and what to change; `None` where they decide it, or where those that
    /// were not judged leave it open.
    ///
    /// # Panics
    /// Without any.
    pub fn why_open(&self, what: &str) -> Option<String> {
        let needed = 100.0 * PASS_FRACTION;
        let undecided = self.passes().is_none();
        match self.count < Self::least() {
            _ if !undecided => None,
            true => Some(format!(
                "at least {} {what} are needed to show {needed:.0} %",
                Self::least()
            )),
            false if self.open > 0 => None,
            false => Some(format!(
                "the interval includes {needed:.0} %, more {what} narrow it"
            )),
        }
    }
}
