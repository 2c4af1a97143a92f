//! The text of files.

use std::path::Path;

use super::error::CaseError;
use super::{former, json, spanned_toml};
use crate::text_file::{SIZE_MAX, read_text};

/// Parses a case in TOML, or in JSON: a document of the same sections, or a result file of
/// `run`, `check` and the like that holds the case as it was run.
pub(crate) fn source(text: &str, name: &str) -> Result<spanned_toml::Section, CaseError> {
    if is_json(text) {
        json::parse(text, name)
    } else {
        let mut root = spanned_toml::parse(text, name)?;
        former::rename(&mut root, name)?;
        Ok(root)
    }
}

pub(crate) fn is_json(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}');
    text.trim_start().starts_with('{')
}

/// Name and text of a file; `what` it should be, for messages.
pub(crate) fn read_named(path: &Path, what: &str) -> Result<(String, String), CaseError> {
    let name = path.display().to_string();
    let text =
        read_text(path, what, SIZE_MAX).map_err(|message| CaseError::of_file(&name, message))?;
    Ok((name, text))
}
