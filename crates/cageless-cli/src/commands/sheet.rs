//! `cageless sheet`.

use cageless_report::drawing::ring_drawing;
use cageless_report::sheet::{failing, sheet_page};
use cageless_study::sheet::{Sheet, SheetResult};
use cageless_study::tolerance::interruption;

use crate::args::SheetArgs;
use crate::driver::{Answer, PAGE, pretty, read_case_at_rest};
use crate::failure::Failure;
use crate::format::{compared, grouped, judged, notes, pairs, warnings};

const NUMBERS: &str = "sheet.json";
const SVG: &str = "drawing.svg";
const PDF: &str = "drawing.pdf";

/// Computes and prints what a decision rests on.
pub fn sheet(args: &SheetArgs) -> Result<(), Failure> {
    let file = read_case_at_rest(&args.case.case, &args.case.set)?;
    let name = args.case.case.display().to_string();
    let limits = args.raceway.limits(args.centre_angle_deg);
    // Bad input leaves no folder behind.
    let sheet = Sheet::new(&file, &name, &limits, !args.without_benefit)?;
    let drawing = ring_drawing(&file, &limits);
    let output = &args.case.output;
    output.drive(&[PAGE, NUMBERS, SVG, PDF], |bars| {
        let result = sheet.compute(bars)?;
        let why = drawing
            .as_ref()
            .err()
            .map(|error| format!("no drawing: {error}"));
        let text = text(&result) + &notes(why.as_slice());
        let files = output.files(|| {
            let paper = drawing
                .as_ref()
                .map_err(|_| why.as_deref().unwrap_or_default());
            let page = sheet_page(&file, &result, paper);
            let paper = paper.ok();
            Ok(vec![
                (PAGE, Some(page.into())),
                (SVG, paper.map(|paper| paper.svg().into())),
                (PDF, paper.map(|paper| paper.pdf())),
            ])
        })?;
        let interrupted = result
            .tolerance
            .as_ref()
            .and_then(|t| interruption(&t.record));
        let ending = interrupted.map_or(Ok(()), |why| Err(Failure::Interrupted(why.to_owned())));
        Ok(Answer {
            files,
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
        text += &(judged(found.record.flag("passes"), found.record.text("headline")) + "\n");
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
