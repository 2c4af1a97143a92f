//! What every command reads and writes: its case, text, JSON, folder and page.

use std::path::Path;

use cageless_io::case_file::CaseFile;
use cageless_io::results::write_atomically;
use cageless_io::rotor_file::RotorFile;
use cageless_io::{io_error_message, on_terminal};
use cageless_results::csv;
use serde::Serialize;

use crate::args::CaseArgs;
use crate::failure::Failure;
use crate::progress::is_quiet;

/// Prints text to stdout, without control sequences. A closed pipe (`cageless new | head`) is not an error.
pub fn print(text: &str) -> Result<(), Failure> {
    use std::io::Write;
    let mut out = std::io::stdout().lock();
    let text = on_terminal(text);
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        other => Ok(other?),
    }
}

/// Reads the case of a command.
pub fn read_case(args: &CaseArgs) -> Result<CaseFile, Failure> {
    CaseFile::read(&args.case, &args.set).map_err(|error| {
        if !RotorFile::is_at(&args.case) {
            return error.into();
        }
        Failure::Input(format!(
            "{}: is the file of a rotor above several bearings, which `cageless drop`, `cageless \
             check` and the plans of `cageless sweep` take; each of its bearings is a case of its own",
            args.case.display()
        ))
    })
}

/// Prints a result as JSON or text, and leaves the JSON as `NAME.json` and its values as `NAME.csv` in
/// the folder.
pub fn deliver<T: Serialize>(
    args: &CaseArgs,
    name: &str,
    result: &T,
    text: &str,
) -> Result<(), Failure> {
    let json = serde_json::to_string_pretty(result)? + "\n";
    if let Some(dir) = &args.out {
        make_folder(dir)?;
        let path = dir.join(name);
        write_atomically(&path, json.as_bytes())?;
        let values = csv(&serde_json::to_value(result)?);
        write_atomically(&path.with_extension("csv"), values.as_bytes())?;
    }
    if args.json { print(&json) } else { tell(text) }
}

/// Prints a result as text, unless the user wants none.
pub fn tell(text: &str) -> Result<(), Failure> {
    if is_quiet() { Ok(()) } else { print(text) }
}

/// Opens a page in the browser. Without one the page is there nevertheless.
pub fn open_page(page: &Path) {
    if let Err(error) = open::that_detached(page) {
        eprintln!(
            "warning: {} was written but could not be opened: {error}",
            page.display()
        );
    }
}

/// Makes the folder of `--out`.
pub fn make_folder(dir: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(dir).map_err(|error| {
        Failure::Input(format!(
            "--out {}: {}",
            dir.display(),
            io_error_message(&error)
        ))
    })
}

/// Refuses a folder where a file is to be.
pub fn writable(path: &Path) -> Result<(), Failure> {
    if path.is_dir() {
        return Err(Failure::Input(format!(
            "--out {}: is a directory where a file is to be",
            path.display()
        )));
    }
    Ok(())
}
