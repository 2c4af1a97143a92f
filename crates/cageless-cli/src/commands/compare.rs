//! `cageless compare`.

use std::path::PathBuf;

use cageless_io::case_file::CaseFile;
use cageless_report::compare::compare_page;
use cageless_report::compared_run::{ComparedRun, compared_runs};
use cageless_report::run_report::run_data;
use cageless_study::Progress;
use cageless_study::comparison::{RingComparison, RingResults, STARTS, Starts, compare as study};
use cageless_study::run::{Options, run};

use crate::args::CompareArgs;
use crate::driver::{Answer, PAGE, pretty, read_case};
use crate::failure::Failure;
use crate::finished_run::{FinishedRun, SUMMARY};
use crate::format::{columns, judged, pairs};

const NUMBERS: &str = "compare.json";

/// Compares rings.
pub fn compare(args: &CompareArgs) -> Result<(), Failure> {
    // All are read before anything is computed; bad input leaves no folder behind.
    let sides = sides(args)?;
    let cases = sides.iter().map(|(name, side)| match side {
        Side::Case(file) => Some((*name, CaseFile::clone(file))),
        Side::Run(_) => None,
    });
    let cases: Option<Vec<_>> = cases.collect();
    args.output.drive(&[NUMBERS, PAGE], |bars| {
        let (runs, comparison) = match cases {
            Some(cases) => {
                let (rings, comparison) = study(&cases, args.starts.unwrap_or(STARTS), bars)?;
                (compared_runs(&rings, &comparison), comparison)
            }
            None => finished(sides, bars)?,
        };
        Ok(Answer {
            files: (args.output)
                .files(|| Ok(vec![(PAGE, Some(compare_page(&runs, &comparison)))]))?,
            ..Answer::new(NUMBERS, pretty(&comparison)?, text(&runs, &comparison))
        })
    })
}

fn text(runs: &[ComparedRun], comparison: &RingComparison) -> String {
    let titles: Vec<_> = (runs.iter())
        .map(|run| (run.name.as_str(), run.data.title.clone()))
        .collect();
    let verdicts: Vec<_> = (comparison.runs.iter().zip(&comparison.verdicts))
        .map(|(name, verdict)| (name, judged(verdict.passes, &verdict.headline)))
        .collect();
    let mut text = format!("{}\n{}\n", pairs(&titles), pairs(&verdicts));
    if comparison.starts.seed.is_some() {
        text += &format!("{}\n\n", comparison.statement);
    }
    let mut rows = vec![comparison.headings()];
    rows.extend(comparison.rows(comparison.results.iter()));
    text + &format!("{}\n{}\n", columns(&rows), comparison.starts_text())
}

/// A side of a comparison: a case, to be run beside a finished run once and beside others from the same
/// uneven starts, or a finished run.
enum Side {
    Case(Box<CaseFile>),
    Run(Box<FinishedRun>),
}

/// What is compared, the ring that the others are compared with first.
fn sides(args: &CompareArgs) -> Result<Vec<(&'static str, Side)>, Failure> {
    let given: Vec<(&'static str, &PathBuf)> = std::iter::once(("A", &args.a))
        .chain(args.b.iter().map(|b| ("B", b)))
        .collect();
    let for_cases = [
        ("--set", !args.set.is_empty()),
        ("--starts", args.starts.is_some()),
    ];
    let folder = given.iter().find(|(_, path)| path.is_dir());
    let option = for_cases.iter().find(|(_, given)| *given);
    if let (Some((_, folder)), Some((option, _))) = (folder, option) {
        return Err(Failure::Input(format!(
            "{option}: {} is a finished run, which cannot be run again; give the case file, or its \
             {SUMMARY}",
            folder.display()
        )));
    }
    let mut sides = vec![];
    for (name, path) in given {
        let side = if path.is_dir() {
            Side::Run(Box::new(FinishedRun::read(path)?))
        } else {
            let file = read_case(path, &args.set)?;
            file.checked(cageless::Case::check_motion)?;
            Side::Case(Box::new(file))
        };
        sides.push((name, side));
    }
    if args.with_conventional {
        let a = match &sides[0].1 {
            Side::Case(file) => CaseFile::clone(file),
            Side::Run(_) => CaseFile::read(&args.a.join(SUMMARY), &[])?,
        };
        if a.case().raceways.is_empty() {
            return Err(Failure::Input(format!(
                "--with-conventional: the outer ring of {} is conventional itself; leave the option out, or \
                 give a case with a [raceway]",
                args.a.display()
            )));
        }
        let conventional = a.with_conventional_ring()?;
        sides.insert(0, ("conventional", Side::Case(Box::new(conventional))));
    }
    Ok(sides)
}

/// Takes finished runs, and runs the cases beside them once.
fn finished(
    sides: Vec<(&'static str, Side)>,
    bars: &dyn Progress,
) -> Result<(Vec<ComparedRun>, RingComparison), Failure> {
    let (mut runs, mut results) = (vec![], vec![]);
    for (name, side) in sides {
        let FinishedRun { data, summary } = match side {
            Side::Run(run) => *run,
            Side::Case(file) => once(&file, bars)?,
        };
        results.push(RingResults::of_summary(name, &summary));
        runs.push(ComparedRun {
            name: name.to_owned(),
            data,
        });
    }
    let starts = Starts {
        count: 1,
        seed: None,
    };
    Ok((runs, RingComparison::new(&results, starts)))
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
