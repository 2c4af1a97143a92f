//! `cageless drop`.

use cageless_io::arrangement::BearingArrangement;
use cageless_io::results::{ROTOR, SUMMARY, bearing_folder};
use cageless_report::drop::drop_page;
use cageless_results::number_text::significant;
use cageless_results::{
    DropJudgement, Record, bearing_number, on_bearing, plane_records, table_of,
};
use cageless_study::drop::{
    Distribution, DropRequest, DropStudy, Ensemble, Succession, WhirlProbability, study,
};

use super::run::verified;
use crate::args::{DropArgs, Reference};
use crate::driver::{Answer, PAGE, Tables};
use crate::failure::Failure;
use crate::format::{columns, drops, judged, pairs, values, warnings};

/// Failure of a drop whose samples or verification were interrupted.
const REST_INTERRUPTED: &str = "interrupted: the drop itself is complete.";

/// Drops a rotor into its bearings; the tables of each go to a folder of its own.
pub fn touchdown(args: &DropArgs) -> Result<(), Failure> {
    let path = &args.case.case;
    let file = BearingArrangement::read(path, &args.case.set)?;
    let request = DropRequest {
        compare: args.compare == Some(Reference::Conventional),
        samples: args.samples,
        verify: args.verify,
        drops: args.drops,
    };
    let drop = request.check(&file, &path.display().to_string())?;
    let output = &args.case.output;
    output.drive_into(&[SUMMARY, PAGE, ROTOR], |folder, bars| {
        let out = output.out.as_deref();
        let places = (1..).map(bearing_folder);
        let mut tables = Tables::create(folder.as_ref(), places.zip(file.cases()))?;
        let study = study(&file, drop, request, tables.rows(), bars)?;
        tables.finish(folder, output.csv)?;
        let (json, text) = (study.to_json(&file)?, text(&study));
        let files = output.files(|| {
            Ok(vec![
                (PAGE, Some(drop_page(&file, &study).into())),
                (ROTOR, file.rotor_toml()?.map(Into::into)),
            ])
        })?;
        let rest_interrupted = study.interrupted.then_some(REST_INTERRUPTED);
        let bearings = study.record.bearings.len();
        let place = on_bearing(study.record.last_index(), bearings, "");
        let cut_short = study.succession.cut_short;
        let ending = Failure::of_outcome(study.record.into_last_outcome(), rest_interrupted, out);
        let ending = ending.map_err(|failure| failure.stopped_at(&place));
        Ok(Answer {
            files,
            ending: ending.and_then(|()| cut_short.map(Failure::Unphysical).map_or(Ok(()), Err)),
            ..Answer::new(SUMMARY, json, text)
        })
    })
}

/// Numbers of four digits in a row.
pub(super) fn listed(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| significant(*value, 4)).collect();
    texts.join(", ")
}

fn text(study: &DropStudy) -> String {
    let mut text = verdict(&study.judgement);
    if let Some(benefit) = &study.benefit {
        text += &format!("{}\n", pairs(&[("benefit", benefit.headline.clone())]));
    }
    text += &rotor_text(study);
    text += &drops(&study.results("this drop", "conventional"));
    text += &succession_text(&study.succession);
    if let Some(ensemble) = &study.ensemble {
        text += &ensemble_text(ensemble);
    }
    if let Some(verification) = &study.verification {
        text += &verification_text(verification);
    }
    text + &warnings(&study.warnings)
}

/// Spin-down of the rotor, and drops after it.
fn succession_text(succession: &Succession) -> String {
    // The reasons stand below.
    let mut rows = succession.table();
    rows.iter_mut().for_each(|row| {
        row.pop();
    });
    let table = columns(&rows);
    let firsts = [
        ("fail", "first drop beyond a limit"),
        ("not-judged", "first drop that is not judged"),
    ];
    let firsts = firsts.into_iter().filter_map(|(verdict, label)| {
        let (drop, reasons) = succession.first(verdict)?;
        Some((label, format!("drop {drop}: {reasons}")))
    });
    let firsts: Vec<_> = firsts.collect();
    match succession.records.is_empty() {
        true => String::new(),
        false => format!("\ndrops in succession\n{table}{}", pairs(&firsts)),
    }
}

/// PASS or FAIL with its reasons.
fn verdict(judgement: &DropJudgement) -> String {
    let headline = judged(judgement.passes(), &judgement.headline());
    pairs(&[("verdict", headline)]) + "\n"
}

/// Numbers of a linear rotor and its planes.
fn rotor_text(study: &DropStudy) -> String {
    let Some(rotor) = study.drop.rotor() else {
        return String::new();
    };
    let mut lines = vec![("rotor", format!("{} kg", significant(rotor.mass_kg, 4)))];
    // A vertical rotor rests on a shoulder.
    if !study.drop.is_vertical() {
        lines.push((
            "shares of the mass at the bearings",
            format!("{} kg", listed(&rotor.mass_shares_kg())),
        ));
    }
    lines.push((
        "energy balance error of the rotor (relative)",
        format!("{:.1e}", study.record.rotor.energy_residual_relative),
    ));
    let mut text = pairs(&lines);
    if !study.record.rotor.planes.is_empty() {
        text += &format!(
            "\n{}",
            columns(&table_of(&plane_records(&study.record.rotor.planes)))
        );
    }
    text + "\n"
}

fn verification_text(verification: &Record) -> String {
    let bearings = verification.parts("bearings");
    let of_bearing = |(k, bearing): (usize, &Record)| {
        let title = match bearing_number(k, bearings.len()) {
            None => "verification".to_owned(),
            Some(number) => format!("verification, bearing {number}"),
        };
        verified(bearing, bearing.parts("numbers").iter(), &title)
    };
    let of_rotor = match &values(verification)[..] {
        [] => String::new(),
        shown => format!("\n{}", pairs(shown)),
    };
    of_rotor
        + &bearings
            .iter()
            .enumerate()
            .map(of_bearing)
            .collect::<String>()
}

fn ensemble_text(many: &Ensemble) -> String {
    let mut completed = format!("{} completed", many.completed);
    if let [only] = &many.bearings[..] {
        completed += &format!(": {}", only.end_states_text());
    }
    let mut lines = vec![("drops".to_owned(), completed)];
    let passing = many.passing.percent();
    lines.extend(passing.map(|percent| ("probability of passing".to_owned(), percent)));
    let stopped = || many.stopped_text().map(|text| ("stopped".to_owned(), text));
    let whirl = |name: String, probability: &WhirlProbability| {
        probability.percent().map(|percent| (name, percent))
    };
    let rows = |of_bearing: &Distribution| columns(&of_bearing.rows());
    if let [only] = &many.bearings[..] {
        lines.extend(whirl(
            "probability of backward whirl".to_owned(),
            &only.backward_whirl,
        ));
        lines.extend(stopped());
        return format!("\n{}\n{}", pairs(&lines), rows(only));
    }
    lines.extend(stopped());
    lines.extend(whirl(
        "probability of backward whirl in any bearing".to_owned(),
        &many.in_any_bearing,
    ));
    for (k, of_bearing) in (1..).zip(many.bearings.iter()) {
        lines.extend(whirl(format!("in bearing {k}"), &of_bearing.backward_whirl));
    }
    let mut text = format!("\n{}", pairs(&lines));
    for (k, of_bearing) in (1..).zip(many.bearings.iter()) {
        let states = [(format!("bearing {k}"), of_bearing.end_states_text())];
        text += &format!("\n{}\n{}", pairs(&states), rows(of_bearing));
    }
    text
}
