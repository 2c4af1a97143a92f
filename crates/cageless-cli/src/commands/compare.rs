//! `cageless compare`.

use std::path::Path;

use cageless_io::case_file::CaseFile;
use cageless_io::results::SUMMARY;
use cageless_report::compare::compare_page;
use cageless_report::compared_run::{ComparedRun, compared_runs, films};
use cageless_report::run_report::run_data;
use cageless_study::Progress;
use cageless_study::comparison::{
    DRAWS, Draws, Remedies, RingComparison, RingResults, Sampling, compare as study,
    compare_remedies,
};
use cageless_study::run::{Options, run};

use crate::args::CompareArgs;
use crate::driver::{Answer, PAGE, pretty, read_case};
use crate::failure::Failure;
use crate::finished_run::FinishedRun;
use crate::format::{judged, pairs, rings, warnings};

const NUMBERS: &str = "compare.json";

/// Compares rings.
pub fn compare(args: &CompareArgs) -> Result<(), Failure> {
    // All are read before anything is computed; bad input leaves no folder behind.
    let sides = sides(args)?;
    let cases = sides.iter().map(|(name, side)| match side {
        Side::Case(file) => Some((name.clone(), CaseFile::clone(file))),
        Side::Run(_) => None,
    });
    let cases: Option<Vec<_>> = cases.collect();
    let own = cases.as_deref().and_then(<[_]>::first);
    let remedies = own.filter(|_| args.remedies);
    let remedies = remedies.map(|(_, file)| Remedies::new(file)).transpose()?;
    args.output.drive(&[NUMBERS, PAGE], |bars| {
        let (runs, comparison) = match cases {
            Some(cases) => {
                let sampling = match args.starts {
                    Some(starts) => Sampling::UnevenStarts(starts),
                    None => Sampling::Draws(args.draws.unwrap_or(DRAWS)),
                };
                let (rings, comparison) = match &remedies {
                    Some(remedies) => compare_remedies(remedies, sampling, bars)?,
                    None => study(&cases, sampling, bars)?,
                };
                (compared_runs(&rings, &comparison), comparison)
            }
            None => finished(sides, bars)?,
        };
        Ok(Answer {
            files: (args.output)
                .files(|| Ok(vec![(PAGE, Some(compare_page(&runs, &comparison).into()))]))?,
            ..Answer::new(NUMBERS, pretty(&comparison)?, text(&runs, &comparison))
        })
    })
}

fn text(runs: &[ComparedRun], comparison: &RingComparison) -> String {
    let titles: Vec<_> = (runs.iter().zip(films(runs)))
        .map(|(run, film)| (run.name.as_str(), run.data.title.clone() + &film))
        .collect();
    let verdicts: Vec<_> = (comparison.runs.iter().zip(&comparison.verdicts))
        .map(|(name, verdict)| (name, judged(verdict.passes, &verdict.headline)))
        .collect();
    let mut text = format!("{}\n", pairs(&titles));
    text += &differing(comparison);
    let subject: Vec<_> = match comparison.draws.grade {
        // Whether single balls are slowed as intended is a step on the way.
        Some(_) => {
            let headlines = comparison.benefits.iter().flatten();
            headlines.for_each(|benefit| text += &format!("{}\n", benefit.headline));
            comparison.subject()
        }
        None => {
            text += &format!("{}\n", pairs(&verdicts));
            comparison.results.iter().collect()
        }
    };
    for left_out in &comparison.left_out {
        text += &format!("{}: left out, {}\n", left_out.name, left_out.why);
    }
    for (name, limits) in comparison.runs.iter().zip(&comparison.limits) {
        let lines = limits.lines().into_iter();
        text += &lines
            .map(|(word, limit)| format!("{name}: {word}: {limit}\n"))
            .collect::<String>();
    }
    text + "\n" + &rings(comparison, subject.into_iter()) + &warnings(&of_runs(runs))
}

/// Keys in which the cases differ, in lines; of many the last ones by name alone.
fn differing(comparison: &RingComparison) -> String {
    let keys = &comparison.differing_keys;
    if keys.is_empty() {
        return String::new();
    }
    let shown = keys.len().min(KEYS_SHOWN);
    let lines: Vec<_> = keys[..shown]
        .iter()
        .map(|key| {
            let values = key.values.iter();
            let values = values.map(|value| value.as_deref().unwrap_or("–"));
            (key.key.as_str(), values.collect::<Vec<_>>().join(" | "))
        })
        .collect();
    let more: Vec<_> = keys[shown..].iter().map(|key| key.key.as_str()).collect();
    let more = match more.is_empty() {
        true => String::new(),
        false => format!("and {} more: {}\n", more.len(), more.join(", ")),
    };
    let runs = comparison.runs.join(" | ");
    format!("Keys that differ: {runs}\n{}{more}\n", pairs(&lines))
}

/// Warnings of the runs, each with the names of its runs unless it is that of all.
fn of_runs(runs: &[ComparedRun]) -> Vec<String> {
    let mut found: Vec<(&String, Vec<&str>)> = vec![];
    for run in runs {
        for warning in &run.data.warnings {
            match found.iter_mut().find(|(other, _)| *other == warning) {
                Some((_, names)) => names.push(&run.name),
                None => found.push((warning, vec![&run.name])),
            }
        }
    }
    let named = found
        .into_iter()
        .map(|(warning, names)| match names.len() == runs.len() {
            true => warning.clone(),
            false => format!("{}: {warning}", names.join(", ")),
        });
    named.collect()
}

/// Differing keys that are shown with their values.
const KEYS_SHOWN: usize = 12;

/// A side of a comparison: a case, to be run beside a finished run once and beside others from the same
/// uneven starts, or a finished run.
enum Side {
    Case(Box<CaseFile>),
    Run(Box<FinishedRun>),
}

/// Refuses options that do not go with what is compared.
fn check(args: &CompareArgs) -> Result<(), Failure> {
    let for_cases = [
        ("--set", !args.set.is_empty()),
        ("--draws", args.draws.is_some()),
        ("--starts", args.starts.is_some()),
        ("--remedies", args.remedies),
    ];
    let folder = args.cases.iter().find(|path| path.is_dir());
    let option = for_cases.iter().find(|(_, given)| *given);
    if let (Some(folder), Some((option, _))) = (folder, option) {
        return Err(Failure::Input(format!(
            "{option}: {} is a finished run, which cannot be run again; give the case file, or its \
             {SUMMARY}",
            folder.display()
        )));
    }
    if args.cases.len() == 1 && !args.with_conventional && !args.remedies {
        return Err(Failure::Input(
            "one case alone is compared with --with-conventional or --remedies".to_owned(),
        ));
    }
    if args.cases.len() > 1 && args.remedies {
        return Err(Failure::Input("--remedies: give one case".to_owned()));
    }
    Ok(())
}

/// The case of a side, at a path, with the conventional ring.
fn conventional(side: &Side, path: &Path) -> Result<CaseFile, Failure> {
    let a = match side {
        Side::Case(file) => CaseFile::clone(file),
        Side::Run(_) => CaseFile::read(&path.join(SUMMARY), &[])?,
    };
    if a.case().raceways.is_empty() {
        return Err(Failure::Input(format!(
            "--with-conventional: the outer ring of {} is conventional itself; leave the option out, or \
             give a case with a [raceway]",
            path.display()
        )));
    }
    Ok(a.with_conventional_ring()?)
}

/// Sides of a comparison, first the ring with which the others are compared.
fn sides(args: &CompareArgs) -> Result<Vec<(String, Side)>, Failure> {
    check(args)?;
    let has_run = args.cases.iter().any(|path| path.is_dir());
    let mut sides = vec![];
    for (k, path) in args.cases.iter().enumerate() {
        let side = if path.is_dir() {
            Side::Run(Box::new(FinishedRun::read(path)?))
        } else {
            let file = read_case(path, &args.set)?;
            file.checked(cageless::Case::check_run)?;
            if !has_run && file.case().rotor.is_some() {
                return Err(Failure::Input(of_a_drop(path)));
            }
            Side::Case(Box::new(file))
        };
        sides.push((lettered(k), side));
    }
    if args.with_conventional {
        let conventional = conventional(&sides[0].1, &args.cases[0])?;
        sides.insert(
            0,
            (
                "conventional".to_owned(),
                Side::Case(Box::new(conventional)),
            ),
        );
    }
    Ok(sides)
}

/// Why steady operation under the falling rotor of a case is not compared.
fn of_a_drop(path: &Path) -> String {
    format!(
        "{}: [rotor] must be left out: rings are compared in steady operation. `cageless drop --compare conventional \
         --samples N` judges a raceway in a drop",
        path.display()
    )
}

/// Name of ring `k` from 0: A to Z, then numbers.
fn lettered(k: usize) -> String {
    match u8::try_from(k) {
        Ok(k) if k < 26 => char::from(b'A' + k).to_string(),
        _ => (k + 1).to_string(),
    }
}

/// Takes finished runs, and runs the cases beside them once.
fn finished(
    sides: Vec<(String, Side)>,
    bars: &dyn Progress,
) -> Result<(Vec<ComparedRun>, RingComparison), Failure> {
    let (mut runs, mut results, mut documents) = (vec![], vec![], vec![]);
    for (name, side) in sides {
        let FinishedRun { data, summary } = match side {
            Side::Run(run) => *run,
            Side::Case(file) => once(&file, bars)?,
        };
        results.push(RingResults::of_summary(&name, &summary));
        documents.push(summary.get("case").cloned().unwrap_or_default());
        runs.push(ComparedRun { name, data });
    }
    let comparison = RingComparison::new(&results, Draws::finished());
    Ok((runs, comparison.of_cases(&documents)))
}

fn once(file: &CaseFile, bars: &dyn Progress) -> Result<FinishedRun, Failure> {
    let mut rows = ();
    let options = Options {
        rows: Some(&mut rows),
        verify: false,
    };
    let record = run(file, options, bars)?;
    let run = FinishedRun {
        data: run_data(file, &record),
        summary: serde_json::from_str(&record.summary.to_json()?)?,
    };
    Failure::of_outcome(record.outcome, None, None)?;
    Ok(run)
}
