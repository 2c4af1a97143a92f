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
