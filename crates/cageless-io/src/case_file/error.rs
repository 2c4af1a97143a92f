//! The one message that a bad case file ends in.

use crate::terminal::bounded;

/// Error of a case file: place, key, given value and what is
/// allowed, in the unit of the file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}{message}", before(.place))]
pub struct CaseError {
    /// `file:line`, `file` or the text of the `--set` at fault; empty for a text that its user
    /// has not written and whose lines say nothing.
    place: String,
    line: Option<usize>,
    key: Option<String>,
    message: String,
}

/// Prefix of a message before the text of a `--set`.
const OPTION: &str = "--set ";

fn before(place: &str) -> String {
    if place.is_empty() {
        String::new()
    } else {
        format!("{place}: ")
    }
}

impl CaseError {
    /// An error of the file as a whole.
    pub(crate) fn of_file(name: &str, message: String) -> Self {
        Self {
            place: name.to_owned(),
            line: None,
            key: None,
            message: bounded(message),
        }
    }

    /// An error on a line of the file, which counts from 1. Without a name, there is no file
    /// and no line.
    pub(crate) fn on_line(name: &str, line: usize, key: Option<String>, message: String) -> Self {
        let (place, line) = match name {
            "" => (String::new(), None),
            name => (format!("{name}:{line}"), Some(line)),
        };
        Self {
            place,
            line,
            key,
            message: bounded(message),
        }
    }

    /// An error of a `--set`.
    pub(crate) fn of_override(text: &str, key: Option<String>, message: String) -> Self {
        Self {
            key,
            ..Self::of_file(&bounded(format!("{OPTION}{text}")), message)
        }
    }

    /// Whether a `--set` is at fault.
    pub(crate) fn is_of_override(&self) -> bool {
        self.place.starts_with(OPTION)
    }

    /// The error in the case of bearing `k`, from 0, of a rotor.
    pub(crate) fn in_bearing(mut self, k: usize) -> Self {
        self.message = format!("in bearing {}, {}", k + 1, self.message);
        self
    }

    /// The message with more at its end.
    pub(crate) fn with_more(mut self, more: &str) -> Self {
        self.message.push_str(more);
        self
    }

    pub(crate) fn with_key(mut self, key: impl Into<String>) -> Self {
        self.key = Some(key.into());
        self
    }

    /// Dotted key at fault (`raceway.axial_span_mm`), or the section. None if the
    /// file as a whole is at fault.
    pub fn key(&self) -> Option<&str> {
        self.key.as_deref()
    }

    /// Line at fault, counted from 1. None if the value does not stand in a file.
    pub fn line(&self) -> Option<usize> {
        self.line
    }

    /// The message without its place.
    pub fn message(&self) -> &str {
        &self.message
    }
}
