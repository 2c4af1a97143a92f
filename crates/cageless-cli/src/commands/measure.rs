//! `cageless measure`.

use cageless::surface::MeasuredGroove;
use cageless_io::case_file::CaseFile;
use cageless_io::point_file::read_points;
use cageless_results::{GROOVE, PROFILE, Part, Record, Results, Subject};

use crate::args::MeasureArgs;
use crate::driver::{Answer, pretty, read_case};
use crate::failure::Failure;
use crate::format::{pairs, values};

/// Case with the measured raceways in the folder of `--out`.
const MEASURED: &str = "measured.toml";
/// Intervals of a profile between the middle of a raceway and its end.
const INTERVALS: usize = 24;

/// Fits the raceways of a case to points of a measured ring.
pub fn measure(args: &MeasureArgs) -> Result<(), Failure> {
    let file = read_case(&args.case.case, &args.case.set)?;
    let case = file.case();
    let refused = |why: String| Failure::Input(format!("{}: {why}", args.points.display()));
    if case.raceways.is_empty() {
        let path = args.case.case.display();
        let why = "has no [raceway], whose half angle and centre say where the points of one lie";
        return Err(Failure::Input(format!("{path}: {why}")));
    }
    let points = read_points(&args.points).map_err(Failure::Input)?;
    let mut document = file.document().clone();
    let mut grooves = vec![];
    for index in 0..case.raceways.len() {
        let groove = MeasuredGroove::fit(case, index, &points).map_err(|e| {
            let (count, nth) = (e.value, index + 1);
            refused(format!(
                "{count} points of raceway {nth} are not possible: they must be {}; coordinates are in mm",
                e.allowed
            ))
        })?;
        document.enter_profile(index, &groove.rows(INTERVALS));
        grooves.push(groove);
    }
    let measured =
        CaseFile::from_document(document.clone(), &args.case.case.display().to_string())?;
    let (mut text, mut records) = (String::new(), vec![]);
    for (index, (groove, raceway)) in grooves.iter().zip(&measured.case().raceways).enumerate() {
        let mut results = Results::of(GROOVE, Subject::Groove(groove));
        if let Some(profile) = &raceway.form().measured {
            results = results.and(Results::of(PROFILE, Subject::Profile(profile)));
        }
        if grooves.len() > 1 {
            text += &format!("raceway {}\n", index + 1);
        }
        text += &pairs(&values(&results));
        records.push(Record::from(results));
    }
    let record = Record::default().with_part("raceways", Part::Many(records));
    let files = args.case.output.files(|| {
        let measured = file.edited(&document)?;
        Ok(vec![(MEASURED, Some(measured))])
    })?;
    if let Some(dir) = &args.case.output.out {
        let path = dir.join(MEASURED).display().to_string();
        text += &pairs(&[("case with the measured raceways", path)]);
    }
    args.case.output.deliver_numbers(Answer {
        files,
        ..Answer::new("measure.json", pretty(&record)?, text)
    })
}
