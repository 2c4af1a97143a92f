//! Reason of an early stop.

use std::fmt;

use cageless::Case;
use cageless::simulation::{Ending, RunOutcome};
use serde::Serialize;

use crate::number_text::short;

/// Reason of an early stop of a run or a drop.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stopped {
    /// Simulated time reached.
    pub time_s: f64,
    /// Cause of the stop; [`Stopped::INTERRUPTED`] if the user ended the run.
    pub cause: String,
    /// Advice on what to change.
    pub advice: String,
}

impl Stopped {
    /// Cause of a run that the user ended: nothing is wrong with what it has.
    pub const INTERRUPTED: &str = "interrupted";

    /// The reason why the run of `case` stopped early, if it did.
    pub fn of(case: &Case, outcome: &RunOutcome) -> Option<Self> {
        match &outcome.ending {
            Ending::Stopped(stop) => Some(Self {
                time_s: stop.time_s,
                cause: stop.cause.to_string(),
                advice: stop.advice_by_key(),
            }),
            Ending::Interrupted => Some(Self {
                time_s: outcome.end_s,
                cause: Self::INTERRUPTED.to_owned(),
                advice: format!(
                    "let it run to its end at {} s, or set solver.duration_s to less",
                    case.solver.duration_s
                ),
            }),
            Ending::Complete | Ending::ObserverFailed(_) => None,
        }
    }

    /// Why a run of `case` has no verdict.
    pub fn reason(&self, case: &Case) -> String {
        if !self.is_interrupted() {
            return format!("stopped {self}");
        }
        let [time_s, of_s] = [self.time_s, case.solver.duration_s].map(short);
        format!("interrupted after {time_s} s of {of_s} s")
    }

    /// Time, cause and advice, for a page.
    pub fn with_advice(&self) -> String {
        let Self {
            time_s,
            cause,
            advice,
        } = self;
        format!("stopped at t = {time_s:.6} s: {cause}. To change: {advice}.")
    }

    /// Whether the user ended the run.
    pub fn is_interrupted(&self) -> bool {
        self.cause == Self::INTERRUPTED
    }
}

/// Time and cause.
impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at t = {:.6} s {}", self.time_s, self.cause)
    }
}
