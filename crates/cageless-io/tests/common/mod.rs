//! What the tests share.
#![allow(dead_code, reason = "each test file uses its part")]

use cageless_io::case_file::{CaseError, CaseFile, template};

/// The template with one piece of text replaced.
pub fn edited(from: &str, to: &str) -> String {
    let text = template(false);
    assert!(text.contains(from), "the template has no `{from}`");
    text.replacen(from, to, 1)
}

/// Reads a text that must be refused.
pub fn refused(text: &str, overrides: &[&str]) -> CaseError {
    let overrides: Vec<String> = overrides.iter().map(|s| (*s).to_owned()).collect();
    match CaseFile::parse(text, "case.toml", &overrides) {
        Err(error) => error,
        Ok(file) => panic!("accepted: {:?}", file.document()),
    }
}

/// Line of the text that starts with `start`, counted from 1.
pub fn line_of(text: &str, start: &str) -> usize {
    1 + text
        .lines()
        .position(|l| l.starts_with(start))
        .expect("the line is there")
}
