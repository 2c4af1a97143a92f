//! Messages for errors of the file system.

use std::io::{Error, ErrorKind};

/// Message for an error of a file or folder, to be read after its name, without
/// the number of the system's error.
pub fn io_error_message(error: &Error) -> String {
    match error.kind() {
        // Only making a folder finds that something is in its place.
        ErrorKind::AlreadyExists => "is a file, a folder is needed".to_owned(),
        ErrorKind::NotADirectory => "part of the path is a file, not a folder".to_owned(),
        ErrorKind::IsADirectory => "is a directory".to_owned(),
        _ => {
            let text = error.to_string();
            let text = text.split(" (os error ").next().unwrap_or_default();
            let mut rest = text.chars();
            let first = rest.next().map(|c| c.to_ascii_lowercase());
            first.into_iter().chain(rest).collect()
        }
    }
}
