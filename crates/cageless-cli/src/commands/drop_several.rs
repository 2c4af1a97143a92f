//! `cageless drop` of a rotor above several bearings.

use std::f64::consts::TAU;
use std::path::Path;

use cageless::dynamics::InstructionSet;
use cageless_io::case_file::CaseDocument;
use cageless_io::results::{Metadata, RunWriter, write_atomically, write_csv};
use cageless_io::rotor_file::RotorFile;
use cageless_report::drop::rotor_page;
use cageless_study::drop::{DropResult, SeveralBearings, drop_into_bearings};
use cageless_study::number_text::significant;
use cageless_study::run::Rows;
use serde::Serialize;

use super::drop::{PAGE, SUMMARY, table};
use super::{deliver, make_folder, print, tell, writable};
use crate::args::{CaseArgs, DropArgs, Reference};
use crate::failure::{Failure, kept_in};
use crate::format::{page_line, pairs};
use crate::progress::{Bars, catch_interrupt};

/// Drops a rotor into its bearings. The tables of each go to a folder of its own.
pub fn drop_several(args: &DropArgs) -> Result<(), Failure> {
    for (given, option) in [
        (args.samples.is_some(), "--samples"),
        (args.verify, "--verify"),
    ] {
        if given {
            return Err(Failure::Input(format!(
                "{option}: not for a rotor above several bearings; it works on the case of one \
                 bearing"
            )));
        }
    }
    let file = RotorFile::read(&args.case.case, &args.case.set)?;
    let out = args.case.out.as_deref();
    let footers: Vec<String> = (file.bearings().iter())
        .map(|bearing| serde_json::to_string(&bearing.document_as_run()))
        .collect::<Result<_, _>>()?;
    let mut writers = vec![];
    if let Some(dir) = out {
        make_folder(dir)?;
        for name in [SUMMARY, PAGE] {
            writable(&dir.join(name))?;
        }
        let isa = InstructionSet::chosen().name();
        for (k, case) in footers.iter().enumerate() {
            let folder = dir.join(folder_of(k));
            make_folder(&folder)?;
            writers.push(RunWriter::create(&folder, &Metadata { isa, case })?);
        }
    }
    let stop = catch_interrupt();
    let bars = Bars::new(&stop);
    let mut rows: Vec<Option<&mut (dyn Rows + Send)>> = (writers.iter_mut())
        .map(|writer| Some(writer as &mut (dyn Rows + Send)))
        .collect();
    rows.resize_with(footers.len(), || None);
    let drop = drop_into_bearings(file.drop(), rows, &bars)?;
    let compare = args.compare == Some(Reference::Conventional) && drop.completed();
    let conventional = match compare {
        true => {
            let none = footers.iter().map(|_| None).collect();
            Some(drop_into_bearings(
                &file.drop().conventional(),
                none,
                &bars,
            )?)
        }
        false => None,
    };
    for (k, writer) in writers.into_iter().enumerate() {
        writer.finish()?;
        if let (true, Some(dir)) = (args.csv, out) {
            write_csv(&dir.join(folder_of(k)))?;
        }
    }
    let json = drop.to_json(&file, conventional.as_ref())?;
    if let Some(dir) = out {
        write_files(dir, &json, &rotor_page(&file, &drop, conventional.as_ref()))?;
    }
    std::mem::drop(bars);
    if args.case.json {
        print(&json)?;
    } else {
        tell(&(text(&file, &drop, conventional.as_ref()) + &page_line(out, PAGE)))?;
    }
    let kept = kept_in(out);
    let interrupted = drop.interrupted() || conventional.is_some_and(|other| other.interrupted());
    let outcome = drop.into_last().outcome;
    Failure::of_ending(outcome.ending, outcome.end_s, &kept)?;
    if interrupted {
        return Err(Failure::Interrupted(format!(
            "interrupted: the drop itself is complete.{kept}"
        )));
    }
    Ok(())
}

/// Checks a rotor file.
pub fn check(args: &CaseArgs) -> Result<(), Failure> {
    /// `check.json`.
    #[derive(Serialize)]
    struct Checked {
        valid: bool,
        cases: Vec<CaseDocument>,
        mass_kg: f64,
        mass_shares_kg: Vec<f64>,
        step_us: f64,
        natural_frequencies_hz: Vec<f64>,
    }
    let file = RotorFile::read(&args.case, &args.set)?;
    let (rotor, cases) = (file.drop().rotor(), file.drop().cases());
    let at_speed = rotor.eigenvalues(file.drop().speed_rad_s());
    let mut frequencies: Vec<f64> = (at_speed.iter())
        .map(|value| value.im / TAU)
        .filter(|frequency| *frequency > LEAST_FREQUENCY_HZ)
        .collect();
    frequencies.sort_by(f64::total_cmp);
    frequencies.truncate(FREQUENCIES);
    let shares = rotor.mass_shares_kg();
    let step_us = 1e6 * cases[0].solver.step_s;
    let lines = [
        ("rotor", format!("{} is valid", args.case.display())),
        ("bearings", cases.len().to_string()),
        ("mass", format!("{} kg", significant(rotor.mass_kg(), 4))),
        ("carried by the bearings", format!("{} kg", listed(&shares))),
        (
            "lowest natural frequencies at speed, without contact",
            format!("{} Hz", listed(&frequencies)),
        ),
        ("step", format!("{} µs", significant(step_us, 4))),
    ];
    let checked = Checked {
        valid: true,
        cases: file
            .bearings()
            .iter()
            .map(|b| b.document_as_run())
            .collect(),
        mass_kg: rotor.mass_kg(),
        mass_shares_kg: shares,
        step_us,
        natural_frequencies_hz: frequencies,
    };
    deliver(args, "check.json", &checked, &pairs(&lines))
}

/// Natural frequencies that a check lists.
const FREQUENCIES: usize = 8;
/// Below, a rotor moves freely.
const LEAST_FREQUENCY_HZ: f64 = 1e-3;

/// Folder of the tables of bearing `k`.
fn folder_of(k: usize) -> String {
    format!("bearing-{}", k + 1)
}

fn listed(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| significant(*value, 4)).collect();
    texts.join(", ")
}

fn write_files(dir: &Path, json: &str, page: &str) -> Result<(), Failure> {
    write_atomically(&dir.join(SUMMARY), json.as_bytes())?;
    Ok(write_atomically(&dir.join(PAGE), page.as_bytes())?)
}

fn text(
    file: &RotorFile,
    drop: &SeveralBearings,
    conventional: Option<&SeveralBearings>,
) -> String {
    let rotor = file.drop().rotor();
    let head = [
        ("rotor", format!("{} kg", significant(rotor.mass_kg(), 4))),
        (
            "carried by the bearings",
            format!("{} kg", listed(&rotor.mass_shares_kg())),
        ),
        (
            "energy ledger of the rotor",
            format!(
                "{:.1e} of all flows missing",
                drop.rotor_energy_residual_relative
            ),
        ),
    ];
    let (names, drops): (Vec<String>, Vec<&DropResult>) =
        drop.columns(conventional).into_iter().unzip();
    format!("{}\n{}", pairs(&head), table(names, &drops))
}
