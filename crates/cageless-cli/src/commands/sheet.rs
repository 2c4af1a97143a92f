//! `cageless sheet`.

use cageless_report::sheet::{SheetFiles, failing};
use cageless_study::sheet::{Sheet, SheetResult};
use cageless_study::tolerance::interruption;

use crate::args::SheetArgs;
use crate::driver::{Answer, pretty, read_case_at_rest};
use crate::failure::Failure;
use crate::format::{compared, grouped, headlines, notes, pairs, warnings};

const NUMBERS: &str = "sheet.json";

/// Computes and prints what a decision rests on.
pub fn sheet(args: &SheetArgs) -> Result<(), Failure> {
    let file = read_case_at_rest(&args.case.case, &args.case.set)?;
    let name = args.case.case.display().to_string();
    let limits = args.drawing.limits();
    // Bad input leaves no folder behind.
    let sheet = Sheet::new(&file, &name, &limits, !args.without_benefit)?;
    let output = &args.case.output;
    let [page, svg, pdf] = SheetFiles::NAMES;
    output.drive(&[page, svg, pdf, NUMBERS], |bars| {
        let result = sheet.compute(bars)?;
        let made = SheetFiles::new(&file, &result, &limits);
        let text = text(&result) + &notes(made.undrawn.as_slice());
        let judged = result.tolerance.as_ref();
        let interrupted = judged.and_then(|judged| interruption(&judged.record));
        let ending = interrupted.map_or(Ok(()), |why| Err(Failure::Interrupted(why.to_owned())));
        Ok(Answer {
            files: output.files(|| Ok(made.files.into()))?,
            ending,
            ..Answer::new(NUMBERS, pretty(&result)?, text)
        })
    })
}

fn text(result: &SheetResult) -> String {
    let record = &result.equilibrium;
    let mut text = String::new();
    if let Some(found) = &result.tolerance {
        if let Some(benefit) = &found.benefit {
            text += &compared(&benefit.answer, &benefit.comparison);
        }
        text += &headlines(&found.record);
        let failing = failing(&found.record).map(|text| text + "\n");
        text += &failing.unwrap_or_default();
        text += &warnings(found.record.sentences("warnings"));
    }
    let limits = record.limits().lines();
    if !limits.is_empty() {
        text += &(pairs(&limits) + "\n");
    }
    text + &grouped(&record.results)
        + &warnings(record.sentences("warnings"))
        + &notes(record.sentences("notes"))
}
