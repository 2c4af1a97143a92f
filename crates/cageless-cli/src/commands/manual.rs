//! `cageless completions` and `cageless man`.

use cageless_io::results::{ResultFolder, VERSION};
use clap::{Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;

use crate::args::{Args, ManArgs};
use crate::driver::{print, tell};
use crate::failure::Failure;
use crate::format::pairs;

/// Prints the completions of a shell.
pub fn completions(shell: Shell) -> Result<(), Failure> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Args::command(), "cageless", &mut text);
    print(&String::from_utf8_lossy(&text))
}

/// Prints a man page, or writes all of them.
pub fn man(args: &ManArgs) -> Result<(), Failure> {
    let mut root = Args::command().disable_help_subcommand(true);
    root.build();
    let pages = pages(&root);
    if let Some(dir) = &args.out {
        let mut folder = ResultFolder::open(dir)?;
        for page in &pages {
            folder.add(&format!("{}.1", name(page)), &rendered(page)?)?;
        }
        folder.commit_files()?;
        let written = format!("{} in {}", pages.len(), dir.display());
        return tell(&pairs(&[("man pages", written)]));
    }
    let wanted = match &args.command {
        None => "cageless".to_owned(),
        Some(command) => format!("cageless-{command}"),
    };
    let Some(page) = pages.iter().find(|page| name(page) == wanted) else {
        let names = pages
            .iter()
            .filter_map(|p| name(p).strip_prefix("cageless-"));
        return Err(Failure::Input(format!(
            "COMMAND {:?}: there is no such command; there are {}",
            args.command.as_deref().unwrap_or_default(),
            names.collect::<Vec<_>>().join(", ")
        )));
    };
    print(&String::from_utf8_lossy(&rendered(page)?))
}

/// The command and those below it.
fn pages(command: &Command) -> Vec<&Command> {
    let below = command.get_subcommands().flat_map(pages);
    std::iter::once(command).chain(below).collect()
}

/// Full name with hyphens: `cageless-sweep-merge`.
fn name(command: &Command) -> &str {
    command
        .get_display_name()
        .unwrap_or_else(|| command.get_name())
}

fn rendered(page: &Command) -> Result<Vec<u8>, Failure> {
    let mut text = Vec::new();
    let man = Man::new(page.clone()).source(format!("cageless {VERSION}"));
    man.render(&mut text)?;
    Ok(text)
}
