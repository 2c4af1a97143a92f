//! `cageless measure`.

use cageless_study::measured::measured;

use crate::args::MeasureArgs;
use crate::driver::{Answer, pretty, read_case};
use crate::failure::Failure;
use crate::format::{pairs, values};

/// Case with the measured raceways in the folder of `--out`.
const MEASURED: &str = "measured.toml";

/// Fits the raceways of a case to points of a measured ring.
pub fn measure(args: &MeasureArgs) -> Result<(), Failure> {
    let file = read_case(&args.case.case, &args.case.set)?;
    let name = args.case.case.display().to_string();
    let measured = measured(&file, &name, &args.points)?;
    let raceways = measured.record.parts("raceways");
    let mut text = String::new();
    for (raceway, nth) in raceways.iter().zip(1..) {
        if raceways.len() > 1 {
            text += &format!("raceway {nth}\n");
        }
        text += &pairs(&values(&raceway.results));
    }
    let files = args.case.output.files(|| {
        let measured = file.edited(&measured.document)?;
        Ok(vec![(MEASURED, Some(measured))])
    })?;
    if let Some(dir) = &args.case.output.out {
        let path = dir.join(MEASURED).display().to_string();
        text += &pairs(&[("case with the measured raceways", path)]);
    }
    args.case.output.deliver_numbers(Answer {
        files,
        ..Answer::new("measure.json", pretty(&measured.record)?, text)
    })
}
