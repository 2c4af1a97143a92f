//! `report.json` of a run, with a checksum of itself and of the `summary.json` beside it: numbers
//! that were damaged are not taken for others.

use serde_json::Error;

use crate::from_json::{from_json, to_json};
use crate::run_data::RunData;

/// End of the text, after the numbers.
const OPEN: &str = ",\"crc32\":\"";
const CLOSE: &str = "\"}";
const DIGITS: usize = 8;

/// Why there are no data.
#[derive(Debug, thiserror::Error)]
pub enum RunJsonError {
    /// The text is not JSON, or not of a run.
    #[error("is not of a run: {0}")]
    Foreign(#[from] Error),
    /// It has no checksum.
    #[error("has no checksum: it is cut off, or of an earlier version; run the case again")]
    NoChecksum,
    /// The bytes are not those that were written.
    #[error("is damaged, or not of the run of the summary.json next to it: run the case again")]
    Damaged,
}

/// `report.json` of a run whose `summary.json` is `summary`.
///
/// # Errors
/// None that the data can cause; those of the JSON writer are passed on.
pub fn run_json(data: &RunData, summary: &str) -> Result<String, Error> {
    let mut text = to_json(data)?;
    text.truncate(text.len() - 1);
    let crc = checksum(&text, summary);
    Ok(format!("{text}{OPEN}{crc:0DIGITS$x}{CLOSE}"))
}

/// The inverse of [`run_json`].
///
/// # Errors
/// [`RunJsonError`]
pub fn run_from_json(text: &str, summary: &str) -> Result<RunData, RunJsonError> {
    let sealed = text.trim_end().strip_suffix(CLOSE);
    let parts = sealed.and_then(|text| text.rsplit_once(OPEN));
    let Some((numbers, digits)) = parts.filter(|(_, digits)| digits.len() == DIGITS) else {
        // What is no report of a run at all has a message of its own.
        from_json::<RunData>(text)?;
        return Err(RunJsonError::NoChecksum);
    };
    if u32::from_str_radix(digits, 16) != Ok(checksum(numbers, summary)) {
        return Err(RunJsonError::Damaged);
    }
    Ok(from_json(text)?)
}

fn checksum(numbers: &str, summary: &str) -> u32 {
    let mut crc = crc32fast::Hasher::new();
    crc.update(numbers.as_bytes());
    crc.update(summary.as_bytes());
    crc.finalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_changed_byte_is_noticed() {
        let data = RunData {
            title: "β".to_owned(),
            time_s: vec![0.5, 1.25],
            ..RunData::default()
        };
        let summary = "{\"power_loss_w\": 1.5}\n";
        let text = run_json(&data, summary).unwrap();
        assert_eq!(run_from_json(&text, summary).unwrap(), data);
        for (at, _) in text.char_indices().filter(|(_, c)| c.is_ascii()) {
            let mut bytes = text.clone().into_bytes();
            bytes[at] = if bytes[at] == b'7' { b'8' } else { b'7' };
            let changed = String::from_utf8(bytes).unwrap();
            assert!(run_from_json(&changed, summary).is_err(), "{changed}");
        }
        for (text, summary) in [
            (text.as_str(), "{\"power_loss_w\": 1.6}\n"),
            (&text[..text.len() / 2], summary),
            (&to_json(&data).unwrap(), summary),
        ] {
            assert!(run_from_json(text, summary).is_err(), "{text}");
        }
    }
}
