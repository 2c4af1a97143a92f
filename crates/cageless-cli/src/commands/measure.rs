//! `cageless measure`.

use cageless::Case;
use cageless::raceway::MeasuredFlanks;
use cageless::surface::MeasuredGroove;
use cageless_io::case_file::{CaseDocument, CaseValue};
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
    let (mut text, mut records) = (String::new(), vec![]);
    for index in 0..case.raceways.len() {
        let groove = MeasuredGroove::fit(case, index, &points);
        let groove = groove.map_err(|e| {
            let (count, nth) = (e.value, index + 1);
            refused(format!(
                "{count} points of raceway {nth} are not possible: they must be {}; coordinates are in mm",
                e.allowed
            ))
        })?;
        let rows = profile(case, index, &groove);
        let radians: Vec<_> = rows.iter().map(|row| row.map(f64::to_radians)).collect();
        let flanks = MeasuredFlanks::fit(&radians).map_err(|e| refused(e.to_string()))?;
        let section = match case.raceways.len() {
            1 => "raceway".to_owned(),
            _ => format!("raceway.{}", index + 1),
        };
        enter(&mut document, &section, rows);
        let results = Results::of(GROOVE, Subject::Groove(&groove))
            .and(Results::of(PROFILE, Subject::Profile(&flanks)));
        if case.raceways.len() > 1 {
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

/// Rows of ψ and flank angle in °, from the middle of a raceway to its end and denser there.
fn profile(case: &Case, index: usize, groove: &MeasuredGroove) -> Vec<[f64; 2]> {
    let theta = case.raceways[index].half_angle_rad();
    let rounded = |angle: f64| (angle.to_degrees() * 1e6).round() / 1e6;
    let row = |k: usize| {
        let share = k as f64 / INTERVALS as f64;
        let local = theta * (share * std::f64::consts::FRAC_PI_2).sin();
        [rounded(local), rounded(groove.flank_angle_rad(local))]
    };
    (0..=INTERVALS).map(row).collect()
}

/// Enters a profile in the place of what was designed.
fn enter(document: &mut CaseDocument, section: &str, rows: Vec<[f64; 2]>) {
    let key = |name: &str| format!("{section}.{name}");
    for designed in [
        "axial_span_mm",
        "half_angle_deg",
        "blend_mm",
        "depth_error_um",
    ] {
        document.remove(&key(designed));
    }
    document.set(&key("shape"), "measured");
    document.set(&key("profile"), CaseValue::Table(rows));
}
