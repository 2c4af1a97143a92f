//! A ring that has been measured: frame, raceways and dimensions from points of its surface.

use std::path::Path;

use cageless::numerics::wrap_angle_rad;
use cageless::surface::{
    Conformity, MeasuredFlank, MeasuredRaceway, MeasuredRing, MeasuredSlot, MeasuredValue,
    PointDeviation, PointOff, PointsError,
};
use cageless::{Case, Raceway};
use cageless_io::OptionError;
use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_io::point_file::read_points;
use cageless_results::{
    DIMENSION, Dimension, FRAME, FittedRaceway, FittedRing, GROOVE, MEASURED, PROFILE, Part,
    Record, Results, SLOT, Subject,
};

use crate::error::StudyError;
use crate::tolerance::Request;

/// Intervals of a profile between the middle of a raceway and its end.
const INTERVALS: usize = 24;
/// Lines of outliers that a warning names.
const LINES: usize = 5;

/// A case with the raceways that were measured.
#[derive(Debug, Clone)]
pub struct Measured {
    /// The case with their profiles, or the dimensions of slots, in the place of its raceways.
    pub file: CaseFile,
    /// Document of the case.
    pub document: CaseDocument,
    /// Frame, points, dimensions and deviations, `frame` and `raceways`.
    pub record: Record,
    /// Deviations of the points from the surface of the drawing.
    pub deviations: Vec<PointOff>,
    /// Why there is no raceway, if one of the case is missing.
    pub missing: Option<String>,
}

/// Tolerances of the drawing, to either side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Depth of the raceways, µm.
    pub groove_depth_um: f64,
    /// Axial span lC, µm.
    pub axial_span_um: f64,
    /// Half angle θ, degrees.
    pub half_angle_deg: f64,
    /// Angular position ψ, degrees; `None` where the drawing has none.
    pub centre_angle_deg: Option<f64>,
}

impl Default for Limits {
    /// Default tolerances of a tolerance analysis, without one for the angular position.
    fn default() -> Self {
        let request = Request::default();
        Self {
            groove_depth_um: request.groove_depth_um,
            axial_span_um: request.axial_span_um,
            half_angle_deg: request.half_angle_deg,
            centre_angle_deg: None,
        }
    }
}

impl Limits {
    /// Checks that they are tolerances.
    ///
    /// # Errors
    /// [`StudyError::Option`].
    pub fn check(&self) -> Result<(), StudyError> {
        let all = [
            ("groove_depth_um", Some(self.groove_depth_um)),
            ("axial_span_um", Some(self.axial_span_um)),
            ("half_angle_deg", Some(self.half_angle_deg)),
            ("centre_angle_deg", self.centre_angle_deg),
        ];
        let wrong = all.into_iter().find_map(|(option, value)| {
            let value = value?;
            let kept = value >= 0.0 && value.is_finite();
            (!kept).then(|| OptionError::not_possible(option, value, "0 or more"))
        });
        wrong.map_or(Ok(()), |error| Err(error.into()))
    }

    fn of_flanks(&self, drawn: &Raceway, made: &MeasuredFlank) -> Vec<Dimension> {
        self.dimensions(
            drawn,
            [
                made.axial_span_m,
                made.half_angle_rad,
                made.centre_angle_rad,
                made.depth_error_m,
            ],
        )
    }

    fn of_slot(&self, drawn: &Raceway, made: &MeasuredSlot) -> Vec<Dimension> {
        let mut dimensions = self.dimensions(
            drawn,
            [
                made.axial_span_m,
                made.half_angle_rad,
                made.centre_angle_rad,
                made.depth_error_m,
            ],
        );
        dimensions.push(Dimension {
            name: "edge radius",
            unit: "mm",
            measured: made.edge_radius_m.times(1e3),
            drawn: digits(drawn.form().edge_radius_m * 1e3),
            tolerance: None,
        });
        dimensions
    }

    fn dimensions(&self, drawn: &Raceway, measured: [MeasuredValue; 4]) -> Vec<Dimension> {
        let [span, angle, centre, depth] = measured;
        let d = drawn.dimensions();
        let degrees = 1f64.to_degrees();
        // The drawing's place, give or take a turn.
        let turn = wrap_angle_rad(centre.value - d.centre_angle_rad);
        let centre = MeasuredValue {
            value: d.centre_angle_rad + turn,
            ..centre
        };
        vec![
            Dimension {
                name: "axial span lC",
                unit: "mm",
                measured: span.times(1e3),
                drawn: digits(d.axial_span_m * 1e3),
                tolerance: Some(self.axial_span_um * 1e-3),
            },
            Dimension {
                name: "half angle θ",
                unit: "°",
                measured: angle.times(degrees),
                drawn: digits(d.half_angle_rad.to_degrees()),
                tolerance: Some(self.half_angle_deg),
            },
            Dimension {
                name: "angular position ψ",
                unit: "°",
                measured: centre.times(degrees),
                drawn: digits(d.centre_angle_rad.to_degrees()),
                tolerance: self.centre_angle_deg,
            },
            Dimension {
                name: "depth error",
                unit: "µm",
                measured: depth.times(1e6),
                drawn: 0.0,
                tolerance: Some(self.groove_depth_um),
            },
        ]
    }
}

/// Fits a ring of a case, which messages call `name`, to the points in a file, and judges it by the tolerances.
///
/// # Errors
/// The case has no raceway, a tolerance is impossible, the file cannot be read, or its points do not give a ring.
pub fn measured(
    file: &CaseFile,
    name: &str,
    points: &Path,
    limits: &Limits,
) -> Result<Measured, StudyError> {
    let case = file.case();
    if case.raceways.is_empty() {
        let why = "has no [raceway], whose half angle and centre say where the points of one lie";
        return Err(StudyError::Input(format!("{name}: {why}")));
    }
    limits.check()?;
    let found = read_points(points).map_err(StudyError::Input)?;
    let ring = MeasuredRing::fit(case, &found.places_m).map_err(|e| refused(points, &e))?;
    let mut document = file.document().clone();
    for (index, (drawn, made)) in case.raceways.iter().zip(&ring.raceways).enumerate() {
        enter(&mut document, index, drawn, made);
    }
    let file = CaseFile::from_document(document.clone(), name)?;
    let dimensions: Vec<Vec<Dimension>> = (case.raceways.iter().zip(&ring.raceways))
        .map(|(drawn, made)| match made {
            MeasuredRaceway::None { .. } => vec![],
            MeasuredRaceway::Flanks(made) => limits.of_flanks(drawn, made),
            MeasuredRaceway::Slot(made) => limits.of_slot(drawn, made),
        })
        .collect();
    let missing = missing(&ring, case);
    let (passes, headline) = match &missing {
        Some(missing) => (None, missing.clone()),
        None => judged(&dimensions),
    };
    let fitted = FittedRing {
        ring: &ring,
        points: found.places_m.len(),
        outlier_lines: ring.outliers.iter().map(|k| found.lines[*k]).collect(),
        passes,
        headline,
    };
    let frame = frame(&ring);
    let frame = frame
        .iter()
        .map(|d| Record::of(FRAME, Subject::Dimension(d)));
    let record = Record::of(MEASURED, Subject::Ring(&fitted))
        .with_sentences("warnings", warnings(&fitted))
        .with_part("frame", Part::Many(frame.collect()))
        .with_part("raceways", raceway_records(&ring, &file, &dimensions));
    Ok(Measured {
        file,
        document,
        record,
        deviations: ring.deviations,
        missing,
    })
}

/// Records of the raceways of a ring, which the case of `file` has as measured.
fn raceway_records(ring: &MeasuredRing, file: &CaseFile, dimensions: &[Vec<Dimension>]) -> Part {
    let raceways = ring.raceways.iter().zip(file.case().raceways.iter());
    let raceways = raceways
        .zip(dimensions)
        .map(|((made, raceway), dimensions)| {
            let mut results = results(made);
            let flanks = matches!(made, MeasuredRaceway::Flanks(_));
            if let Some(profile) = raceway.form().measured.as_ref().filter(|_| flanks) {
                results = results.and(Results::of(PROFILE, Subject::Profile(profile)));
            }
            let rows = dimensions.iter();
            let rows = rows.map(|d| Record::of(DIMENSION, Subject::Dimension(d)));
            Record::from(results).with_part("dimensions", Part::Many(rows.collect()))
        });
    Part::Many(raceways.collect())
}

/// A dimension of the drawing without the rounding of its unit.
fn digits(value: f64) -> f64 {
    (value * 1e9).round() / 1e9
}

/// That points of a file give no ring.
fn refused(points: &Path, problem: &PointsError) -> StudyError {
    let of = problem
        .raceway
        .map_or_else(String::new, |k| format!(" of raceway {}", k + 1));
    StudyError::Input(format!(
        "{}: {} points{of} are not possible: they must be {}; coordinates are in mm",
        points.display(),
        problem.error.value,
        problem.error.allowed
    ))
}

/// Enters a raceway as it was made in the place of that drawn.
fn enter(document: &mut CaseDocument, index: usize, drawn: &Raceway, made: &MeasuredRaceway) {
    match made {
        MeasuredRaceway::None { .. } => {}
        MeasuredRaceway::Flanks(made) => {
            let profile = made.profile(INTERVALS);
            document.enter_profile(index, &profile, made.profile_depth_error_m);
            let centre = made.centre_angle_rad;
            let turn = wrap_angle_rad(centre.value - drawn.dimensions().centre_angle_rad);
            // Below its uncertainty it is where it was drawn.
            if turn.abs() > centre.expanded() {
                document.enter_centre(index, centre.value);
            }
        }
        MeasuredRaceway::Slot(slot) => document.enter_slot(index, slot),
    }
}

fn results(made: &MeasuredRaceway) -> Results {
    let (deviation, depth_error_m) = match made {
        MeasuredRaceway::None { .. } => {
            let none = PointDeviation {
                points: 0,
                mean_m: f64::NAN,
                largest_m: f64::NAN,
            };
            (none, f64::NAN)
        }
        MeasuredRaceway::Flanks(made) => (made.deviation, made.profile_depth_error_m),
        MeasuredRaceway::Slot(slot) => (slot.deviation, slot.depth_error_m.value),
    };
    let fitted = FittedRaceway {
        deviation,
        depth_error_m,
    };
    let results = Results::of(GROOVE, Subject::Points(&fitted));
    match made {
        MeasuredRaceway::Slot(slot) => results.and(Results::of(SLOT, Subject::Slot(slot))),
        _ => results,
    }
}

/// Where the ring lies, and its radii against the drawing.
fn frame(ring: &MeasuredRing) -> Vec<Dimension> {
    let row = |name, unit, measured: MeasuredValue, factor: f64| Dimension {
        name,
        unit,
        measured: measured.times(factor),
        drawn: 0.0,
        tolerance: None,
    };
    let [x, y, z] = ring.shift_m;
    let [tilt_x, tilt_y] = ring.tilt_rad;
    let turn = ring
        .turn_rad
        .map(|turn| row("turn about z", "°", turn, 1f64.to_degrees()));
    let rows = [
        row("shift x", "µm", x, 1e6),
        row("shift y", "µm", y, 1e6),
        row("shift z", "µm", z, 1e6),
        row("tilt about x", "mrad", tilt_x, 1e3),
        row("tilt about y", "mrad", tilt_y, 1e3),
    ];
    let radii = [
        row(
            "error of the groove bottom radius",
            "µm",
            ring.bottom_radius_error_m,
            1e6,
        ),
        row(
            "error of the groove curvature radius",
            "µm",
            ring.curvature_radius_error_m,
            1e6,
        ),
    ];
    rows.into_iter().chain(turn).chain(radii).collect()
}

/// That the groove is plain where the case has raceways.
fn missing(ring: &MeasuredRing, case: &Case) -> Option<String> {
    let absent = |(k, made): (usize, &MeasuredRaceway)| match made {
        MeasuredRaceway::None { .. } => Some((k + 1).to_string()),
        _ => None,
    };
    let absent: Vec<String> = ring
        .raceways
        .iter()
        .enumerate()
        .filter_map(absent)
        .collect();
    match (absent.as_slice(), case.raceways.len()) {
        ([], _) => None,
        (_, 1) => Some("no raceway: the groove is plain all around".to_owned()),
        (absent, _) => Some(format!(
            "no raceway {}: the groove is plain there",
            absent.join(", ")
        )),
    }
}

/// Verdict on all dimensions by their tolerances, and a sentence on it.
fn judged(raceways: &[Vec<Dimension>]) -> (Option<bool>, String) {
    let several = raceways.len() > 1;
    let of = |asked: Conformity| -> Vec<String> {
        let all = raceways.iter().zip(1..);
        let named = all.flat_map(|(dimensions, nth)| {
            let those = dimensions
                .iter()
                .filter(move |d| d.conformity() == Some(asked));
            those.map(move |d| match several {
                true => format!("{} of raceway {nth}", d.name),
                false => d.name.to_owned(),
            })
        });
        named.collect()
    };
    match (of(Conformity::Out), of(Conformity::NotDecided)) {
        (out, _) if !out.is_empty() => (
            Some(false),
            format!("FAIL: out of tolerance: {}", out.join(", ")),
        ),
        (_, open) if !open.is_empty() => {
            let why = "the limit lies within the uncertainty of";
            (None, format!("not decided: {why} {}", open.join(", ")))
        }
        _ => (
            Some(true),
            "PASS: all dimensions are within tolerance".to_owned(),
        ),
    }
}

/// Warning on points left out as outliers.
fn warnings(fitted: &FittedRing<'_>) -> Vec<String> {
    let lines = &fitted.outlier_lines;
    if lines.is_empty() {
        return vec![];
    }
    let named: Vec<String> = lines.iter().take(LINES).map(usize::to_string).collect();
    let more = if lines.len() > LINES { ", …" } else { "" };
    let (points, line) = match lines.len() {
        1 => ("1 outlier is".to_owned(), "line"),
        count => (format!("{count} outliers are"), "lines"),
    };
    vec![format!(
        "{points} left out, farther than five robust standard deviations from the groove: {line} {}{more}",
        named.join(", ")
    )]
}
