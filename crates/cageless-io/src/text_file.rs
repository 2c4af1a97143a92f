//! Text of files that others have written, and excerpts of it for messages.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::system::io_error_message;
use crate::terminal::on_terminal;

/// No file of settings comes near this; `/dev/zero` does.
pub(crate) const SIZE_MAX: u64 = 16 << 20;
/// Remedy for text in another encoding.
const AS_UTF_8: &str = "save it as UTF-8";

/// The text of a file of at most `size_max` bytes, without the byte order mark that editors of Windows put before
/// it; `what` it should be, for messages.
pub(crate) fn read_text(path: &Path, what: &str, size_max: u64) -> Result<String, String> {
    // Opening a directory succeeds on Unix; the message of the read that fails
    // later does not help.
    if path.is_dir() {
        return Err(format!("is a directory, not a {what}"));
    }
    let file =
        File::open(path).map_err(|e| format!("cannot be opened: {}", io_error_message(&e)))?;
    let mut bytes = Vec::new();
    file.take(size_max + 1)
        .read_to_end(&mut bytes)
        .map_err(|e| format!("cannot be read: {}", io_error_message(&e)))?;
    if bytes.len() as u64 > size_max {
        return Err(format!(
            "is larger than {} MiB: not a {what}",
            size_max >> 20
        ));
    }
    decoded(bytes)
}

fn decoded(bytes: Vec<u8>) -> Result<String, String> {
    if let Some(encoding) = wide_encoding(&bytes) {
        return Err(format!("is {encoding} text: {AS_UTF_8}"));
    }
    let mut text = String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let bytes = error.as_bytes();
        let line = 1 + bytes[..good].iter().filter(|&&b| b == b'\n').count();
        let byte = bytes[good];
        // The two differ in what Latin-1 has no characters for.
        let character = match char::from(byte) {
            c if c.is_control() => String::new(),
            c => format!(", \"{c}\" of Latin-1 and Windows-1252"),
        };
        format!("is not UTF-8 text: line {line} has the byte 0x{byte:02X}{character}: {AS_UTF_8}")
    })?;
    if text.starts_with('\u{feff}') {
        text.drain(..'\u{feff}'.len_utf8());
    }
    Ok(text)
}

/// UTF-16 or UTF-32, told by the byte order mark or by the zeros beside the letters of a first word.
fn wide_encoding(bytes: &[u8]) -> Option<&'static str> {
    match bytes {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => Some("UTF-32"),
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => Some("UTF-16"),
        &[a, 0, b, 0, ..] | &[0, a, 0, b, ..] if a != 0 && b != 0 => Some("UTF-16"),
        _ => None,
    }
}

/// Longest excerpt of a file in a message, in characters.
const EXCERPT_MAX: usize = 60;

/// Text as it is written, on one line, of at most [`EXCERPT_MAX`] characters and without commands to a terminal.
pub(crate) fn excerpt(text: &str) -> String {
    let mut written = String::new();
    let mut characters = 0;
    // Only the words that are shown are read: a value may be as long as the file.
    for word in text.split_whitespace() {
        let space = (characters > 0).then_some(' ');
        for c in space.into_iter().chain(word.chars()) {
            if characters == EXCERPT_MAX {
                return on_terminal(&written).into_owned() + "…";
            }
            written.push(c);
            characters += 1;
        }
    }
    on_terminal(&written).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encodings_are_told_apart() {
        let utf_16 = |text: &str| text.encode_utf16().collect::<Vec<u16>>();
        let little = |text| utf_16(text).into_iter().flat_map(u16::to_le_bytes);
        let big = |text| utf_16(text).into_iter().flat_map(u16::to_be_bytes);
        for (bytes, found) in [
            (b"a\n".to_vec(), Ok("a\n")),
            (b"\xef\xbb\xbf\xc3\xa4".to_vec(), Ok("ä")),
            (
                little("\u{feff}a = 1").collect(),
                Err("is UTF-16 text: save it as UTF-8"),
            ),
            (
                big("\u{feff}a = 1").collect(),
                Err("is UTF-16 text: save it as UTF-8"),
            ),
            (
                little("a = 1").collect(),
                Err("is UTF-16 text: save it as UTF-8"),
            ),
            (
                big("a = 1").collect(),
                Err("is UTF-16 text: save it as UTF-8"),
            ),
            (
                b"\xff\xfe\0\0a\0\0\0".to_vec(),
                Err("is UTF-32 text: save it as UTF-8"),
            ),
            (
                b"one\ntwo \xe4".to_vec(),
                Err(
                    "is not UTF-8 text: line 2 has the byte 0xE4, \"ä\" of Latin-1 and Windows-1252: \
                     save it as UTF-8",
                ),
            ),
        ] {
            let found = found.map(str::to_owned).map_err(str::to_owned);
            assert_eq!(decoded(bytes), found);
        }
    }

    #[test]
    fn excerpts_are_short_and_command_nothing() {
        assert_eq!(excerpt(" a \t\n b\u{1b}[2J"), "a b\\u001b[2J");
        let zeros = "\0".repeat(1 << 20);
        assert_eq!(excerpt(&zeros), "\\u0000".repeat(EXCERPT_MAX) + "…");
    }
}
