//! `cageless drop` of a rotor above several bearings.

use std::f64::consts::TAU;
use std::path::Path;

use cageless::dynamics::InstructionSet;
use cageless::simulation::PlaneDisplacement;
use cageless_io::case_file::CaseDocument;
use cageless_io::results::{Metadata, RunWriter, write_atomically, write_csv};
use cageless_io::rotor_file::RotorFile;
use cageless_report::drop::rotor_page;
use cageless_results::DropResult;
use cageless_results::number_text::significant;
use cageless_study::drop::{RotorEnsemble, RotorStudy, WhirlProbability, rotor_study, unloaded};
use cageless_study::run::Rows;
use serde::Serialize;

use super::drop::{PAGE, SUMMARY, quantiles, requested, show_page, table, verdict, verified};
use super::files::{deliver, make_folder, print, tell, writable};
use super::steps::{check_warnings, steps_text};
use crate::args::{CaseArgs, DropArgs};
use crate::failure::{Failure, kept_in};
use crate::format::{columns, page_line, pairs, warnings};
use crate::progress::{Bars, catch_interrupt};

/// Drops a rotor into its bearings. The tables of each go to a folder of its own.
pub fn drop_several(args: &DropArgs) -> Result<(), Failure> {
    let request = requested(args);
    request.check_samples()?;
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
    let study = rotor_study(&file, request, rows, &bars)?;
    for (k, writer) in writers.into_iter().enumerate() {
        writer.finish()?;
        if let (true, Some(dir)) = (args.csv, out) {
            write_csv(&dir.join(folder_of(k)))?;
        }
    }
    let json = study.to_json(&file)?;
    if let Some(dir) = out {
        write_files(dir, &json, &rotor_page(&file, &study))?;
    }
    drop(bars);
    if args.case.json {
        print(&json)?;
    } else {
        tell(&(text(&file, &study) + &page_line(out, PAGE)))?;
    }
    show_page(args);
    let kept = kept_in(out);
    let place = format!("bearing {}: ", study.drop.last_index() + 1);
    let outcome = study.drop.into_last().outcome;
    Failure::of_ending(outcome.ending, outcome.end_s, &kept).map_err(|f| f.stopped_at(&place))?;
    if study.interrupted {
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
        warnings: Vec<String>,
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
            match frequencies.is_empty() {
                true => "–".to_owned(),
                false => format!("{} Hz", listed(&frequencies)),
            },
        ),
        ("steps of a drop", steps_text(&cases[0])),
    ];
    let mut notes = check_warnings(cases);
    notes.extend(unloaded(file.drop()));
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
        warnings: notes,
    };
    let text = pairs(&lines) + &warnings(&checked.warnings);
    deliver(args, "check.json", &checked, &text)
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

fn text(file: &RotorFile, study: &RotorStudy) -> String {
    let rotor = file.drop().rotor();
    let head = [
        ("rotor", format!("{} kg", significant(rotor.mass_kg(), 4))),
        (
            "carried by the bearings",
            format!("{} kg", listed(&rotor.mass_shares_kg())),
        ),
        (
            "energy balance error of the rotor (relative)",
            format!("{:.1e}", study.drop.rotor_energy_residual_relative),
        ),
    ];
    let (names, drops): (Vec<String>, Vec<&DropResult>) = study.columns().into_iter().unzip();
    let mut text = verdict(&study.drop.judgement()) + &pairs(&head);
    if !study.drop.planes.is_empty() {
        text += &format!("\n{}", planes(&study.drop.planes));
    }
    text += &format!("\n{}", table(names, &drops));
    if let Some(ensemble) = &study.ensemble {
        text += &ensemble_text(ensemble);
    }
    if let Some(verification) = &study.verification {
        let [full, half] = verification.rotor_energy_residual_relative;
        let errors = format!("{full:.1e} at the step, {half:.1e} at half of it");
        let label = "energy balance error of the rotor (relative)";
        text += &format!("\n{}", pairs(&[(label, errors)]));
        for (k, of_bearing) in verification.bearings.iter().enumerate() {
            text += &verified(of_bearing, &format!("verification, bearing {}", k + 1));
        }
    }
    text + &warnings(&study.warnings)
}

/// Largest displacements of the planes of the rotor against their clearances.
fn planes(planes: &[PlaneDisplacement]) -> String {
    let head = [
        "plane",
        "largest displacement",
        "clearance",
        "margin",
        "unit",
    ];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for plane in planes {
        let (most, limit) = (plane.displacement_max_m, plane.clearance.radial_m);
        let mut row = vec![plane.clearance.name.clone()];
        row.extend([most, limit, limit - most].map(|value| significant(1e6 * value, 5)));
        row.push("µm".to_owned());
        rows.push(row);
    }
    columns(&rows)
}

fn ensemble_text(many: &RotorEnsemble) -> String {
    let mut lines = vec![("drops".to_owned(), format!("{} completed", many.completed))];
    for reason in &many.stopped {
        lines.push(("stopped".to_owned(), reason.clone()));
    }
    let mut whirl = |name: String, probability: &WhirlProbability| {
        let percent = probability.percent();
        lines.extend(percent.map(|percent| (name, percent)));
    };
    whirl(
        "probability of backward whirl in any bearing".to_owned(),
        &many.backward_whirl,
    );
    for (k, of_bearing) in many.bearings.iter().enumerate() {
        whirl(format!("in bearing {}", k + 1), &of_bearing.backward_whirl);
    }
    let lines: Vec<(&str, String)> = (lines.iter())
        .map(|(name, value)| (name.as_str(), value.clone()))
        .collect();
    let mut text = format!("\n{}", pairs(&lines));
    for (k, of_bearing) in many.bearings.iter().enumerate() {
        let states = of_bearing.end_states_text();
        text += &format!(
            "\n{}\n{}",
            pairs(&[(&format!("bearing {}", k + 1), states)]),
            quantiles(of_bearing)
        );
    }
    text
}
