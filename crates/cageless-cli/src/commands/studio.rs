//! `cageless studio`.

use std::io::IsTerminal;

use cageless_io::case_file::{CaseFile, template};
use cageless_io::io_error_message;
use cageless_io::results::{ResultError, write_atomically};
use cageless_report::{ENGINE_REMEDY, engine, studio_page};

use crate::args::StudioArgs;
use crate::driver::{print, read_case};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::progress::message;
use crate::studio::{Server, Token};

/// Serves the studio on the loopback address until Ctrl-C, or writes its page.
pub fn studio(args: &StudioArgs) -> Result<(), Failure> {
    let toml = match &args.case {
        Some(path) => text(&read_case(path, &args.set)?, &args.set)?,
        None => text(
            &CaseFile::parse(&template(false), "template", &args.set)?,
            &args.set,
        )?,
    };
    let page = studio_page(&toml);
    if let Some(path) = &args.page {
        if engine().is_none() {
            return Err(Failure::Other(anyhow::anyhow!(
                "this build has no engine for pages: {ENGINE_REMEDY}; `cageless studio` without --page \
                 needs none"
            )));
        }
        write_atomically(path, page.as_bytes()).map_err(|error| match error {
            ResultError::Out { path, source } => Failure::Input(format!(
                "--page {}: cannot be written to: {}",
                path.display(),
                io_error_message(&source)
            )),
            other => other.into(),
        })?;
        return print(&format!("{}\n", path.display()));
    }
    let stop = Interrupt::caught();
    let server = Server::bind(page, Token::random()?, &stop)?;
    let address = server.address();
    print(&format!("{address}\n"))?;
    message("the studio runs until Ctrl-C");
    if !args.no_browser && std::io::stdout().is_terminal() {
        // Without a browser the printed address remains.
        let _ = open::that_detached(&address);
    }
    server.serve()
}

/// Text of a case file for the page, which shows TOML: as written; of JSON, and of a file with replaced
/// values, the case as read.
fn text(file: &CaseFile, set: &[String]) -> Result<String, Failure> {
    match file.toml().filter(|_| set.is_empty()) {
        Some(text) => Ok(text.to_owned()),
        None => Ok(file.document().to_toml()?),
    }
}
