//! `cageless run`.

use cageless::initial_state;
use cageless::simulation::{Ending, RunOutcome};
use cageless_io::case_file::CaseFile;
use cageless_io::results::SUMMARY;
use cageless_report::run_report::run_data;
use cageless_report::{run_json, run_page};
use cageless_results::open_benefit;
use cageless_results::{Record, table_of_judgements};
use cageless_study::RunSummary;
use cageless_study::run::{Options, run as study};

use crate::args::RunArgs;
use crate::driver::{Answer, PAGE, PAGE_DATA, Tables};
use crate::failure::Failure;
use crate::format::{columns, grouped, judged, pairs, values, warnings};

/// Simulates a case.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    let (verify, output) = (args.verify, &args.case.output);
    let file = args.case.read(cageless::Case::check_run)?;
    // A case that cannot start must not touch the folder.
    initial_state(file.case())?;
    output.drive_into(&[SUMMARY, PAGE, PAGE_DATA], |folder, bars| {
        let out = output.out.as_deref();
        let mut tables = Tables::create(folder.as_ref(), [(String::new(), &file)])?;
        let rows = tables.rows().remove(0);
        let mut record = study(&file, Options { rows, verify }, bars)?;
        if let (Ending::ObserverFailed(error), Some(dir)) = (&record.outcome.ending, out) {
            let dir = dir.display();
            return Err(Failure::Other(anyhow::anyhow!(
                "{error}; {dir} is as it was"
            )));
        }
        tables.finish(folder, output.csv)?;
        record.verify(&file, bars);
        let json = record.summary.to_json()?;
        let files = output.files(|| {
            let data = run_data(&file, &record);
            let page_data = run_json(&data, &json)?;
            Ok(vec![
                (PAGE, Some(run_page(&data).into())),
                (PAGE_DATA, Some(page_data.into())),
            ])
        })?;
        let text = text(&file, &record.outcome, &record.summary);
        let rest = "interrupted while verifying: the run itself is complete.";
        let rest_interrupted = (verify && bars.interrupted()).then_some(rest);
        Ok(Answer {
            files,
            ending: Failure::of_outcome(record.outcome, rest_interrupted, out),
            ..Answer::new(SUMMARY, json, text)
        })
    })
}

/// The verdict, then every result of the table.
fn text(file: &CaseFile, outcome: &RunOutcome, summary: &RunSummary) -> String {
    let mut lines = vec![];
    let title = &file.particulars().title;
    if !title.is_empty() {
        lines.push(("case", title.clone()));
    }
    let passes = summary.passes();
    lines.push(("verdict", judged(passes, summary.headline())));
    lines.extend(open_benefit(passes).map(|open| ("benefit", open.to_owned())));
    lines.extend(summary.limits.lines());
    let speed = summary.results.number("wall_s") / outcome.end_s.max(1e-12);
    let mut text = pairs(&lines) + "\n" + &grouped(&summary.results);
    text += &format!("\nspeed  {speed:.2} s per simulated second\n");
    if let Some(verification) = &summary.verification {
        let numbers = verification.part("numbers").into_iter();
        text += &verified(
            verification,
            numbers.flat_map(Record::members),
            "verification",
        );
    }
    text + &warnings(&summary.warnings)
}

/// Verification as text for the terminal: its results, then the judgement of each of `numbers`.
pub(super) fn verified<'r>(
    verification: &Record,
    numbers: impl Iterator<Item = &'r Record>,
    title: &str,
) -> String {
    let (head, rows) = (
        pairs(&values(verification)),
        columns(&table_of_judgements(numbers)),
    );
    format!("\n{title}\n{head}\n{rows}")
}
