//! `cageless drop` of a rotor above several bearings.

use cageless_io::rotor_file::RotorFile;
use cageless_report::drop::rotor_page;
use cageless_results::number_text::significant;
use cageless_results::{DropResult, plane_records, table_of};
use cageless_study::drop::{RotorEnsemble, RotorStudy, WhirlProbability, rotor_study};

use super::drop::{REST_INTERRUPTED, requested, verdict};
use super::run::verified;
use crate::args::DropArgs;
use crate::driver::{Answer, PAGE, Tables};
use crate::failure::Failure;
use crate::finished_run::SUMMARY;
use crate::format::{columns, pairs, values, warnings};

/// Drops a rotor into its bearings. The tables of each go to a folder of its own.
pub fn drop_several(args: &DropArgs) -> Result<(), Failure> {
    let request = requested(args);
    request.check_samples()?;
    let file = RotorFile::read(&args.case.case, &args.case.set)?;
    let output = &args.case.output;
    output.drive(&[SUMMARY, PAGE], |bars| {
        let out = output.out.as_deref();
        let folders = (1..).map(|k| format!("bearing-{k}"));
        let mut tables = Tables::create(out, folders.zip(file.bearings()))?;
        let study = rotor_study(&file, request, tables.rows(), bars)?;
        tables.finish(output.csv)?;
        let (json, text) = (study.to_json(&file)?, text(&file, &study));
        let files = output.files(|| Ok(vec![(PAGE, Some(rotor_page(&file, &study)))]))?;
        let rest_interrupted = study.interrupted.then_some(REST_INTERRUPTED);
        let place = format!("bearing {}: ", study.drop.last_index() + 1);
        let ending = Failure::of_outcome(study.drop.into_last().outcome, rest_interrupted, out);
        Ok(Answer {
            files,
            ending: ending.map_err(|failure| failure.stopped_at(&place)),
            ..Answer::new(SUMMARY, json, text)
        })
    })
}

/// Numbers of four digits in a row.
pub(super) fn listed(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| significant(*value, 4)).collect();
    texts.join(", ")
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
    let mut text = verdict(&study.drop.judgement()) + &pairs(&head);
    if !study.drop.planes.is_empty() {
        text += &format!(
            "\n{}",
            columns(&table_of(&plane_records(&study.drop.planes)))
        );
    }
    text += &format!("\n{}", columns(&DropResult::side_by_side(&study.columns())));
    if let Some(ensemble) = &study.ensemble {
        text += &ensemble_text(ensemble);
    }
    if let Some(verification) = &study.verification {
        text += &format!("\n{}", pairs(&values(verification)));
        for (k, bearing) in verification.parts("bearings").iter().enumerate() {
            let title = format!("verification, bearing {}", k + 1);
            text += &verified(bearing, bearing.parts("numbers").iter(), &title);
        }
    }
    text + &warnings(&study.warnings)
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
            columns(&of_bearing.rows())
        );
    }
    text
}
