//! The text of files.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::error::CaseError;
use super::{former, json, spanned_toml};
use crate::system::io_error_message;

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

pub(super) fn is_json(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}');
    text.trim_start().starts_with('{')
}

/// No case file comes near this; `/dev/zero` does.
const SIZE_MAX: u64 = 16 << 20;

/// Name and text of a file; `what` it should be, for messages.
pub(crate) fn read_named(path: &Path, what: &str) -> Result<(String, String), CaseError> {
    let name = path.display().to_string();
    let text = read_text(path, what).map_err(|message| CaseError::of_file(&name, message))?;
    Ok((name, text))
}

/// The text of a file; `what` it should be, for messages.
fn read_text(path: &Path, what: &str) -> Result<String, String> {
    // Opening a directory succeeds on Unix; the message of the read that fails
    // later does not help.
    if path.is_dir() {
        return Err(format!("is a directory, not a {what}"));
    }
    let file =
        File::open(path).map_err(|e| format!("cannot be opened: {}", io_error_message(&e)))?;
    let mut bytes = Vec::new();
    file.take(SIZE_MAX + 1)
        .read_to_end(&mut bytes)
        .map_err(|e| format!("cannot be read: {}", io_error_message(&e)))?;
    if bytes.len() as u64 > SIZE_MAX {
        return Err(format!(
            "is larger than {} MiB: not a {what}",
            SIZE_MAX >> 20
        ));
    }
    String::from_utf8(bytes).map_err(|e| {
        let good = e.utf8_error().valid_up_to();
        let line = 1 + e.as_bytes()[..good].iter().filter(|&&b| b == b'\n').count();
        format!("is not UTF-8 text: line {line} has a byte that does not belong there")
    })
}
