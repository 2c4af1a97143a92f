//! `cageless compare`.

use std::path::Path;

use cageless_io::case_file::CaseFile;
use cageless_io::io_error_message;
use cageless_io::results::write_atomically;
use cageless_report::compare::{ComparedRun, RunComparison, compare_page};
use cageless_report::run_report::run_data;
use cageless_report::{RunData, from_json};
use cageless_study::run::{Options, run as study};
use serde_json::{Map, Value};

use super::{make_folder, open_page, print, tell, writable};
use crate::args::CompareArgs;
use crate::failure::Failure;
use crate::format::{columns, page_line, pairs};
use crate::progress::{Bars, catch_interrupt};

const NUMBERS: &str = "compare.json";
const PAGE: &str = "report.html";
/// Files of a finished run.
const SUMMARY: &str = "summary.json";
const PAGE_DATA: &str = "report.json";

/// Sets runs side by side.
pub fn compare(args: &CompareArgs) -> Result<(), Failure> {
    let out = args.out.as_deref();
    if let Some(dir) = out {
        make_folder(dir)?;
        // Better found out now than when the runs are over.
        for name in [NUMBERS, PAGE] {
            writable(&dir.join(name))?;
        }
    }
    // Both are read before anything is computed.
    let mut sides = vec![Side::read(&args.a)?, Side::read(&args.b)?];
    if args.with_conventional {
        sides.push(Side::Case(Box::new(sides[0].conventional(&args.a)?)));
    }
    let names = ["A", "B", "conventional"];
    let stop = catch_interrupt();
    let bars = Bars::new(&stop);
    let runs = (sides.into_iter().zip(names))
        .map(|(side, name)| side.run(name, &bars))
        .collect::<Result<Vec<_>, _>>()?;
    drop(bars);
    let comparison = RunComparison::new(&runs);
    let json = serde_json::to_string_pretty(&comparison)? + "\n";
    if let Some(dir) = out {
        write_atomically(&dir.join(NUMBERS), json.as_bytes())?;
        let page = compare_page(&runs, &comparison);
        write_atomically(&dir.join(PAGE), page.as_bytes())?;
    }
    if args.json {
        print(&json)?;
    } else {
        let titles: Vec<_> = (runs.iter())
            .map(|run| (run.name.as_str(), run.data.title.clone()))
            .collect();
        let mut rows = vec![comparison.headings()];
        rows.extend(comparison.rows());
        tell(&(pairs(&titles) + "\n" + &columns(&rows) + &page_line(out, PAGE)))?;
    }
    if let (true, Some(dir)) = (args.open, out) {
        open_page(&dir.join(PAGE));
    }
    Ok(())
}

/// What is compared.
enum Side {
    /// A case, which has to be run.
    Case(Box<CaseFile>),
    /// A finished run: its page and its numbers.
    Run(Box<RunData>, Map<String, Value>),
}

impl Side {
    /// Reads a case file or the folder of a finished run.
    fn read(path: &Path) -> Result<Self, Failure> {
        if !path.is_dir() {
            return Ok(Self::Case(Box::new(CaseFile::read(path, &[])?)));
        }
        let text = |name: &str| {
            let file = path.join(name);
            let read = std::fs::read_to_string(&file);
            read.map_err(|error| {
                Failure::Input(format!(
                    "{}: {}; the folder of a finished run has it (cageless run CASE --out DIR)",
                    file.display(),
                    io_error_message(&error)
                ))
            })
        };
        let damaged = |name: &str, error: serde_json::Error| {
            let file = path.join(name);
            Failure::Input(format!("{}: is not of a run: {error}", file.display()))
        };
        let data = from_json(&text(PAGE_DATA)?).map_err(|e| damaged(PAGE_DATA, e))?;
        let summary = serde_json::from_str(&text(SUMMARY)?).map_err(|e| damaged(SUMMARY, e))?;
        Ok(Self::Run(Box::new(data), summary))
    }

    /// The same case with a conventional outer ring.
    fn conventional(&self, path: &Path) -> Result<CaseFile, Failure> {
        let summary = path.join(SUMMARY);
        let read;
        let file = match self {
            Self::Case(file) => file,
            Self::Run(..) => {
                read = CaseFile::read(&summary, &[])?;
                &read
            }
        };
        let mut document = file.document_as_run();
        document.raceway.clear();
        let name = path.display().to_string();
        Ok(CaseFile::parse(&document.to_toml()?, &name, &[])?)
    }

    /// The run, computed if need be.
    fn run(self, name: &str, bars: &Bars) -> Result<ComparedRun, Failure> {
        let file = match self {
            Self::Case(file) => file,
            Self::Run(data, summary) => {
                return Ok(ComparedRun {
                    name: name.to_owned(),
                    data: *data,
                    summary,
                });
            }
        };
        let mut rows = ();
        let options = Options {
            rows: Some(&mut rows),
            verify: false,
        };
        let record = study(&file, options, bars)?;
        let data = run_data(&file, &record);
        let summary = serde_json::from_str(&record.summary.to_json()?)?;
        Failure::of_ending(record.outcome.ending, record.outcome.end_s, "")?;
        Ok(ComparedRun {
            name: name.to_owned(),
            data,
            summary,
        })
    }
}
