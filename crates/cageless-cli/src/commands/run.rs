//! `cageless run`.

use std::sync::atomic::Ordering;

use cageless::Case;
use cageless::dynamics::InstructionSet;
use cageless::initial_conditions::initial_state;
use cageless::simulation::{Ending, RunOutcome};
use cageless_io::results::{Metadata, RunWriter, VerificationFile, write_atomically, write_csv};
use cageless_report::run_report::run_data;
use cageless_report::verification::{facts, value};
use cageless_report::{run_json, run_page};
use cageless_study::RunSummary;
use cageless_study::run::{Options, Rows, RunRecord, run as study};

use super::files::{make_folder, open_page, print, read_case, tell, writable};
use crate::args::RunArgs;
use crate::failure::{Failure, kept_in};
use crate::finished_run::{PAGE_DATA, SUMMARY};
use crate::format::{columns, judged, page_line, pairs, values, warnings};
use crate::progress::{Bars, catch_interrupt};

/// The page beside the tables.
const PAGE: &str = "report.html";

/// Simulates a case.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    let (verify, csv, open) = (args.verify, args.csv, args.open);
    let args = &args.case;
    let file = read_case(args)?;
    let case = file.case();
    // A case that cannot start must not touch the folder.
    initial_state(case)?;
    let document = serde_json::to_string(&file.document_as_run())?;
    let isa = InstructionSet::chosen().name();
    let mut writer = match &args.out {
        Some(dir) => {
            make_folder(dir)?;
            // Better found out now than when the run is over.
            for name in [SUMMARY, PAGE, PAGE_DATA] {
                writable(&dir.join(name))?;
            }
            let metadata = Metadata {
                isa,
                case: &document,
            };
            Some(RunWriter::create(dir, &metadata)?)
        }
        None => None,
    };

    let stop = catch_interrupt();
    let options = Options {
        rows: writer
            .as_mut()
            .map(|writer| writer as &mut (dyn Rows + Send)),
        verify,
    };
    let bars = Bars::new(&stop);
    let mut record = study(&file, options, &bars)?;

    if let (Ending::ObserverFailed(error), Some(dir)) = (&record.outcome.ending, &args.out) {
        return Err(Failure::Other(anyhow::anyhow!(
            "{error}; {} is as it was",
            dir.display()
        )));
    }
    if let Some(writer) = writer {
        writer.finish()?;
    }
    if let (true, Some(dir)) = (csv, &args.out) {
        write_csv(dir)?;
    }
    record.verify(&file, &bars);
    drop(bars);
    if let Some(dir) = &args.out {
        record.summary.write(dir)?;
        let data = run_data(&file, &record);
        write_atomically(&dir.join(PAGE), run_page(&data).as_bytes())?;
        let page_data = run_json(&data, &record.summary.to_json()?)?;
        write_atomically(&dir.join(PAGE_DATA), page_data.as_bytes())?;
    }
    let RunRecord {
        outcome, summary, ..
    } = record;
    if args.json {
        print(&summary.to_json()?)?;
    } else {
        let text = text(case, &outcome, &summary);
        tell(&(text + &page_line(args.out.as_deref(), PAGE)))?;
    }
    if let (true, Some(dir)) = (open, &args.out) {
        open_page(&dir.join(PAGE));
    }
    let kept = kept_in(args.out.as_deref());
    let complete = matches!(outcome.ending, Ending::Complete);
    if complete && verify && stop.load(Ordering::Relaxed) {
        return Err(Failure::Interrupted(format!(
            "interrupted while verifying: the run itself is complete.{kept}"
        )));
    }
    Failure::of_ending(outcome.ending, outcome.end_s, &kept)
}

/// The verdict, then every result of the table.
fn text(case: &Case, outcome: &RunOutcome, summary: &RunSummary) -> String {
    let mut lines = vec![];
    if !case.title.is_empty() {
        lines.push(("case", case.title.clone()));
    }
    lines.push(("verdict", judged(summary.passes(), summary.headline())));
    lines.extend(values(&summary.results));
    let speed = summary.results.number("wall_s") / outcome.end_s.max(1e-12);
    lines.push(("speed", format!("{speed:.2} s per simulated second")));
    let mut text = pairs(&lines);
    if let Some(verification) = &summary.verification {
        text += &verified(verification);
    }
    text + &warnings(&summary.warnings)
}

/// Verification as text for the terminal.
fn verified(c: &VerificationFile) -> String {
    let head = ["result", "value", "unit", "verdict", "reason"].map(str::to_owned);
    let mut rows = vec![head.to_vec()];
    for (name, number) in c.ranked() {
        rows.push(vec![
            name.to_owned(),
            value(number),
            number.unit.clone(),
            number.verdict.clone(),
            number.reason.clone(),
        ]);
    }
    format!("\n{}\n{}", pairs(&facts(c)), columns(&rows))
}
