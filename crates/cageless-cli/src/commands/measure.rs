//! `cageless measure`.

use cageless_report::measured::measured_page;
use cageless_results::measured_rows;
use cageless_study::measured::{Measured, measured};

use crate::args::MeasureArgs;
use crate::driver::{Answer, PAGE, pretty, read_case};
use crate::failure::Failure;
use crate::format::{columns, judged, pairs, values, warnings};

/// Case with the measured raceways in the folder of `--out`.
const MEASURED: &str = "measured.toml";

/// Fits the ring of a case to points, and judges its dimensions.
pub fn measure(args: &MeasureArgs) -> Result<(), Failure> {
    let file = read_case(&args.case.case, &args.case.set)?;
    let name = args.case.case.display().to_string();
    let limits = args.drawing.limits();
    let measured = measured(&file, &name, &args.points, &limits)?;
    let output = &args.case.output;
    let mut text = text(&measured);
    let files = output.files(|| {
        let case = match measured.missing {
            Some(_) => None,
            None => Some(file.edited(&measured.document)?.into()),
        };
        let page = measured_page(&file.particulars().title, &measured);
        Ok(vec![(MEASURED, case), (PAGE, Some(page.into()))])
    })?;
    if let (Some(dir), None) = (&output.out, &measured.missing) {
        let path = dir.join(MEASURED).display().to_string();
        text += &pairs(&[("case with the measured raceways", path)]);
    }
    let missing = measured.missing.clone();
    output.deliver(Answer {
        files,
        csv: true,
        ending: missing.map_or(Ok(()), |missing| Err(Failure::Unphysical(missing))),
        ..Answer::new("measure.json", pretty(&measured.record)?, text)
    })
}

fn text(measured: &Measured) -> String {
    let record = &measured.record;
    let mut text = String::new();
    if measured.missing.is_none() {
        text += &(judged(record.flag("passes"), record.text("headline")) + "\n\n");
    }
    text += &pairs(&values(record));
    text += &format!("\n{}\n", columns(&measured_rows(record.parts("frame"))));
    let raceways = record.parts("raceways");
    for (raceway, nth) in raceways.iter().zip(1..) {
        if raceway.flag("found") != Some(true) {
            continue;
        }
        if raceways.len() > 1 {
            text += &format!("raceway {nth}\n");
        }
        text += &format!("{}\n", columns(&measured_rows(raceway.parts("dimensions"))));
        text += &pairs(&values(&raceway.results));
    }
    text + &warnings(record.sentences("warnings"))
}
