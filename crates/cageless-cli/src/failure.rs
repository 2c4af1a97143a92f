//! Failures of commands and their exit codes.

use std::fmt;
use std::path::Path;

use cageless::equilibrium::EquilibriumError;
use cageless::simulation::{Ending, RunOutcome, Stop};
use cageless_design::critical_gap::CriticalGapError;
use cageless_io::case_file::CaseError;
use cageless_io::io_error_message;
use cageless_io::results::ResultError;
use cageless_study::StudyError;

/// A failed command.
#[derive(Debug)]
pub enum Failure {
    /// Bad input, exit code 2.
    Input(String),
    /// No valid result, as of a run that left the physical range, exit code 3.
    Unphysical(String),
    /// Ended by the user, exit code 1.
    Interrupted(String),
    /// Anything else, exit code 1.
    Other(anyhow::Error),
}

impl Failure {
    /// Exit code of the contract.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Input(_) => 2,
            Self::Unphysical(_) => 3,
            Self::Interrupted(_) | Self::Other(_) => 1,
        }
    }

    /// Ending of a command after a run or drop: its failure if it did not complete, or that the rest was
    /// interrupted, with a sentence on the folder of the results.
    pub fn of_outcome(
        outcome: RunOutcome,
        rest_interrupted: Option<&str>,
        out: Option<&Path>,
    ) -> Result<(), Self> {
        let kept = out.map_or_else(String::new, |dir| {
            format!(" What was computed until then is in {}.", dir.display())
        });
        match (outcome.ending, rest_interrupted) {
            (Ending::Complete, None) => Ok(()),
            (Ending::Complete, Some(rest)) => Err(Self::Interrupted(format!("{rest}{kept}"))),
            (Ending::Interrupted, _) => Err(Self::Interrupted(format!(
                "interrupted at t = {:.6} s.{kept}",
                outcome.end_s
            ))),
            (Ending::Stopped(stop), _) => Err(Self::stopped(&stop, &kept)),
            (Ending::ObserverFailed(error), _) => Err(Self::Other(anyhow::anyhow!(error))),
        }
    }

    /// The failure with the place of a stop, "bearing 2: ", before it.
    pub fn stopped_at(self, place: &str) -> Self {
        match self {
            Self::Unphysical(message) => Self::Unphysical(format!("{place}{message}")),
            other => other,
        }
    }

    /// A run that stopped.
    pub fn stopped(stop: &Stop, kept: &str) -> Self {
        Self::Unphysical(format!("{}{kept}", stop.by_key()))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(message) | Self::Unphysical(message) | Self::Interrupted(message) => {
                f.write_str(message)
            }
            Self::Other(error) => write!(f, "{error:#}"),
        }
    }
}

/// Errors that are always of one kind.
macro_rules! always {
    ($($Error:ty, $error:ident => $failure:expr;)*) => {
        $(impl From<$Error> for Failure {
            fn from($error: $Error) -> Self {
                $failure
            }
        })*
    };
}

always! {
    CaseError, error => Self::Input(error.to_string());
    cageless::InputError, error => Self::Input(error.to_string());
    serde_json::Error, error => Self::Other(error.into());
    std::io::Error, error => Self::Other(error.into());
}

impl From<EquilibriumError> for Failure {
    fn from(error: EquilibriumError) -> Self {
        match error {
            EquilibriumError::Input(error) => error.into(),
            error => Self::Unphysical(error.to_string()),
        }
    }
}

impl From<CriticalGapError> for Failure {
    fn from(error: CriticalGapError) -> Self {
        match error {
            CriticalGapError::Case(error) => error.into(),
            CriticalGapError::Stopped(stop) => Self::stopped(&stop, ""),
            CriticalGapError::Interrupted => Self::Interrupted("interrupted".to_owned()),
            error => Self::Unphysical(error.to_string()),
        }
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::File(error) | StudyError::Plan(error) => error.into(),
            StudyError::Files(error) => error.into(),
            StudyError::Case(error) => error.into(),
            StudyError::Option(error) => Self::Input(format!(
                "--{} {} {}",
                error.option.replace('_', "-"),
                error.value,
                error.problem
            )),
            StudyError::Run(error) => error.into(),
            error @ StudyError::Stopped { .. } => Self::Unphysical(error.to_string()),
            StudyError::Rows(error) => Self::Other(anyhow::anyhow!(error)),
            StudyError::Input(message) | StudyError::Foreign(message) => Self::Input(message),
            StudyError::Interrupted => {
                Self::Interrupted("interrupted before there was a result".to_owned())
            }
            error @ StudyError::Threads(_) => Self::Other(anyhow::Error::msg(error.to_string())),
            StudyError::Folder { path, source } => Self::Input(format!(
                "--out {}: {}",
                path.display(),
                io_error_message(&source)
            )),
            StudyError::Journal { path, source } => Self::Other(anyhow::anyhow!(
                "cannot write {}: {}",
                path.display(),
                io_error_message(&source)
            )),
        }
    }
}

impl From<ResultError> for Failure {
    fn from(error: ResultError) -> Self {
        if error.is_input() {
            return Self::Input(error.to_string());
        }
        // The message has its cause in it.
        Self::Other(anyhow::Error::msg(error.to_string()))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use cageless::simulation::{Cause, Control, Ending, RunOutcome, Stop, run};
    use cageless_io::case_file::{CaseFile, template};

    use super::Failure;

    fn not_finite() -> Stop {
        Stop {
            time_s: 0.5,
            step_s: 1e-6,
            automatic_step_s: 1e-6,
            drop: false,
            cause: Cause::NotFinite,
        }
    }

    /// Exit code and message of each ending, alone and with more that was interrupted.
    #[test]
    fn each_ending_has_its_exit_code() {
        let short = ["solver.duration_s=0.0001".to_owned()];
        let file = CaseFile::parse(&template(false), "case", &short).unwrap();
        let done = || run(file.case(), &mut [], &mut |_| Control::Continue(())).unwrap();
        assert!(matches!(done().ending, Ending::Complete));
        let rest = "interrupted: the drop itself is complete.";
        let folder = Path::new("out/folder");
        let endings: [(&dyn Fn() -> Ending, _, _, _); 4] = [
            (
                &|| Ending::Complete,
                None,
                Some(1),
                "the drop itself is complete.",
            ),
            (
                &|| Ending::Interrupted,
                Some(1),
                Some(1),
                "interrupted at t = 0.000100 s.",
            ),
            (
                &|| Ending::Stopped(not_finite()),
                Some(3),
                Some(3),
                "at t = 0.500000 s a state",
            ),
            (
                &|| Ending::ObserverFailed("no space".into()),
                Some(1),
                Some(1),
                "no space",
            ),
        ];
        for (ending, alone, with_rest, says) in endings {
            for (rest, code) in [(None, alone), (Some(rest), with_rest)] {
                for out in [None, Some(folder)] {
                    let outcome = RunOutcome {
                        ending: ending(),
                        ..done()
                    };
                    let failure = Failure::of_outcome(outcome, rest, out).err();
                    let found = failure.as_ref().map(Failure::exit_code);
                    assert_eq!(found, code, "{failure:?}");
                    let Some(failure) = failure else { continue };
                    let (text, kept) = (failure.to_string(), "is in out/folder.");
                    assert!(text.contains(says), "{text}");
                    // What could not be written is nowhere.
                    let has = out.is_some() && !text.contains("no space");
                    assert_eq!(text.contains(kept), has, "{text}");
                }
            }
        }
        assert_eq!(Failure::Input(String::new()).exit_code(), 2);
    }
}
