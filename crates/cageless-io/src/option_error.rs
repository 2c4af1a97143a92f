//! Options that are not possible.

/// An option that is not possible, named with underscores: callers write it as their users do.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{option} = {value} {problem}")]
pub struct OptionError {
    /// Name.
    pub option: &'static str,
    /// Value as it was given.
    pub value: String,
    /// Description of the error, to be read after name and value.
    pub problem: String,
}

impl OptionError {
    /// "OPTION = VALUE is not possible: it must be ALLOWED".
    pub fn not_possible(option: &'static str, value: impl ToString, allowed: &str) -> Self {
        Self {
            option,
            value: value.to_string(),
            problem: format!("is not possible: it must be {allowed}"),
        }
    }
}
