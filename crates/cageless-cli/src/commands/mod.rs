//! The commands.

mod check;
mod compare;
pub mod design;
mod drop;
mod export;
mod manual;
mod measure;
mod report;
mod reproduce;
mod run;
mod sheet;
mod static_equilibrium;
mod steps;
mod studio;
mod sweep;
mod tolerance;

use cageless::dynamics::InstructionSet;
use cageless_io::case_file::{on_former_name, template};
use cageless_io::designation;
use cageless_io::own_bearing::{BallSet, NewOperation, OwnBearing};
use cageless_io::results::write_atomically;
use cageless_io::touchdown_template::touchdown_case;
use cageless_study::check_environment;

use crate::args::{Args, Command, Isa, New};
use crate::driver::{print, writable};
use crate::failure::Failure;
use crate::progress::{be_quiet, is_quiet, message};

/// The bearing of the options, if it is given by its dimensions.
fn own_bearing(args: &New) -> Option<OwnBearing> {
    Some(OwnBearing {
        ball_set: BallSet {
            balls: args.balls?,
            ball_diameter_mm: args.ball_diameter_mm?,
            pitch_diameter_mm: args.pitch_diameter_mm?,
        },
        clearance_um: args.clearance_um.unwrap_or(0.0),
    })
}

/// Does what was asked.
pub fn dispatch(args: Args) -> Result<(), Failure> {
    if let Some(isa) = args.isa {
        limit_instructions(isa)?;
    }
    if args.quiet {
        be_quiet();
    }
    on_former_name(|note| {
        if !is_quiet() {
            message(&format!("note: {note}"));
        }
    });
    check_environment()?;
    match args.command {
        Command::Reproduce(args) => reproduce::reproduce(&args),
        Command::New(args) => new(&args),
        Command::Check(args) => check::check(&args),
        Command::Static(args) => static_equilibrium::static_equilibrium(&args),
        Command::Sheet(args) => sheet::sheet(&args),
        Command::Design(args) => design::design(&args),
        Command::Tolerance(args) => tolerance::tolerance(&args),
        Command::Run(args) => run::run(&args),
        Command::Drop(args) => drop::touchdown(&args),
        Command::Compare(args) => compare::compare(&args),
        Command::Export(args) => export::export(&args),
        Command::Measure(args) => measure::measure(&args),
        Command::Sweep(args) => sweep::sweep(&args),
        Command::Report(args) => report::report(&args),
        Command::Studio(args) => studio::studio(&args),
        Command::Completions(args) => manual::completions(args.shell),
        Command::Man(args) => manual::man(&args),
    }
}

fn new(args: &New) -> Result<(), Failure> {
    let found = args.bearing.as_ref().map(|name| {
        designation::find(name).map_err(|message| Failure::Input(format!("--bearing: {message}")))
    });
    let found = found.transpose()?;
    let operation = NewOperation {
        speed_rpm: args.speed_rpm,
        radial_load_n: args.radial_load_n,
        axial_load_n: args.axial_load_n,
    };
    let text = match (&found, own_bearing(args)) {
        (None, Some(own)) => own
            .checked(&operation)
            .map_err(|error| Failure::Input(error.to_string()))?,
        (None, None) if operation != NewOperation::default() => {
            return Err(Failure::Input(
                "--speed-rpm, --radial-load-n, --axial-load-n: give --bearing or --balls, too"
                    .to_owned(),
            ));
        }
        (None, None) => template(args.conventional),
        (Some(bearing), _) => {
            let full = args.full_complement;
            let text = bearing.case_file(full);
            match args.touchdown {
                true if operation != NewOperation::default() => {
                    return Err(Failure::Input(
                        "--touchdown: speed and loads are those of the rotor, [rotor] in the case; leave --speed-rpm, \
                         --radial-load-n and --axial-load-n out"
                            .to_owned(),
                    ));
                }
                true => touchdown_case(bearing, full, &text),
                false => operation.entered(&text),
            }
        }
    };
    let Some(path) = &args.out else {
        return print(&text);
    };
    writable(path)?;
    if path.exists() {
        return Err(Failure::Input(format!(
            "--out {}: this file exists, and may be a case that was edited: give another name or remove it",
            path.display()
        )));
    }
    write_atomically(path, text.as_bytes())?;
    if let Some(found) = found.filter(|_| !is_quiet()) {
        let note = found.source_of_balls(args.full_complement);
        message(&format!("note: {note}"));
    }
    print(&format!("{}\n", path.display()))
}

fn limit_instructions(isa: Isa) -> Result<(), Failure> {
    let set = match isa {
        Isa::Baseline => InstructionSet::Baseline,
        Isa::Avx2 => InstructionSet::Avx2,
        Isa::Avx512 => InstructionSet::Avx512,
    };
    if !set.available() {
        let allowed: Vec<&str> = InstructionSet::ALL
            .into_iter()
            .filter(|set| set.available())
            .map(InstructionSet::name)
            .collect();
        return Err(Failure::Input(format!(
            "--isa {}: this processor does not have it; allowed here: {}",
            set.name(),
            allowed.join(", ")
        )));
    }
    set.limit_to();
    Ok(())
}
