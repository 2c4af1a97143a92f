//! The outer ring of a case as a file.

use std::io::{self, BufWriter, Write};
use std::ops::RangeInclusive;
use std::path::Path;

use super::format::Format;
use super::numbers::{ExportNumbers, RingFile};
use super::part21::{DateError, now};
use super::{points, step, stl};
use crate::OptionError;
use crate::case_file::{CaseError, CaseFile};
use crate::results::{PartialFile, ResultError};
use cageless::Allowed;
use cageless::surface::OuterRing;
use cageless::{Case, Ends, Formulation, InputError, Raceway};

const TOLERANCE_UM: f64 = 0.01;
/// Finer is below the rounding of coordinates, coarser no longer a STEP of precision.
const TOLERANCE_RANGE_UM: RangeInclusive<f64> = 1e-4..=1.0;
const CHORD_UM: f64 = 5.0;
const SPACING_MM: f64 = 0.5;
const SPACING_RANGE_MM: RangeInclusive<f64> = 0.01..=100.0;

/// Whether a path that is to be written names a file: it has an ending, is no folder that is
/// there and is not marked as one by a separator at its end.
pub fn names_file(path: &Path) -> bool {
    let marked = path.as_os_str().to_string_lossy();
    path.extension().is_some() && !path.is_dir() && !marked.ends_with(std::path::is_separator)
}

/// Options of an export, in the units of drawings; `None`: default.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ExportOptions {
    /// Length of the blend between each end of a discrete raceway and the plain groove, inside
    /// the raceway; 0 leaves the kink. Default: 0.5, or a fifth of the shortest half raceway if
    /// that is shorter.
    pub blend_mm: Option<f64>,
    /// STEP: largest distance of the B-splines from the analytic surface. Default: 0.01.
    pub tolerance_um: Option<f64>,
    /// STL: largest distance of a triangle from the analytic surface. Default: 5.
    pub chord_um: Option<f64>,
    /// CSV: largest distance of neighbouring points. Default: 0.5.
    pub spacing_mm: Option<f64>,
}

/// Error of an export.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The case lacks the outside of the ring, its ring is impossible, or it has several rows.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// An option is not possible.
    #[error(transparent)]
    Option(#[from] OptionError),
    /// An option that goes with a format that was not asked for.
    #[error("{option} = {value} is for the format {} only, not for {}", .format.name(), .given.name())]
    Format {
        /// Name, with underscores.
        option: &'static str,
        /// Value.
        value: f64,
        /// Format to which the option belongs.
        format: Format,
        /// Value requested.
        given: Format,
    },
    /// The date that the environment gives files is not one.
    #[error(transparent)]
    Date(#[from] DateError),
}

/// The outer ring, ready to be written as a file.
#[derive(Debug)]
pub struct Export {
    ring: OuterRing,
    not_simulated: Option<String>,
    format: Format,
    contents: Contents,
}

#[derive(Debug)]
enum Contents {
    /// STEP and STL, whose size follows from the curvature: megabytes.
    Whole(RingFile),
    /// CSV, whose size follows from the spacing: up to gigabytes, computed as they are written.
    Points { spacing_mm: f64 },
}

impl Export {
    /// Writes the ring to the file at `path`, which appears once it is complete, and returns its numbers.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write_file(&self, path: &Path) -> Result<ExportNumbers, ResultError> {
        let (file, numbers) = self.write_partial(path)?;
        file.commit()?;
        Ok(numbers)
    }

    /// Writes the file that is to be at `path`, which lacks only its name then, and returns its numbers.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write_partial(&self, path: &Path) -> Result<(PartialFile, ExportNumbers), ResultError> {
        let mut file = PartialFile::create(path)?;
        let written = self.write(&mut file);
        let mut numbers = written.map_err(|source| ResultError::Out {
            path: path.to_owned(),
            source,
        })?;
        numbers.file = Some(path.display().to_string());
        Ok((file, numbers))
    }

    /// Writes the file and returns its numbers.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<ExportNumbers> {
        let ring = &self.ring;
        let mut counter = Counter { out, bytes: 0 };
        let (deviation_m, counts) = match &self.contents {
            Contents::Whole(file) => {
                counter.write_all(&file.bytes)?;
                (file.deviation_m, file.counts.clone())
            }
            Contents::Points { spacing_mm } => {
                let mut lines = BufWriter::with_capacity(1 << 16, &mut counter);
                let written = points::write(ring, *spacing_mm, &mut lines)?;
                lines.flush()?;
                written
            }
        };
        let (format, size) = (self.format, counter.bytes);
        let mut numbers = ExportNumbers::new(ring, format, size, deviation_m, counts);
        numbers.blend_not_simulated.clone_from(&self.not_simulated);
        Ok(numbers)
    }
}

/// Counts the bytes on their way.
struct Counter<'a> {
    out: &'a mut dyn Write,
    bytes: u64,
}

impl Write for Counter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.out.write(bytes)?;
        self.bytes += count as u64;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

impl ExportOptions {
    fn blend_mm(&self, case: &Case) -> f64 {
        self.blend_mm.unwrap_or_else(|| default_blend_mm(case))
    }

    /// Refuses what goes with none of the formats.
    ///
    /// # Errors
    /// [`ExportError::Format`].
    pub fn check(&self, formats: &[Format]) -> Result<(), ExportError> {
        for (option, value, format) in [
            ("tolerance_um", self.tolerance_um, Format::Step),
            ("chord_um", self.chord_um, Format::Stl),
            ("spacing_mm", self.spacing_mm, Format::Csv),
        ] {
            if let (Some(value), Some(&given)) = (value, formats.first())
                && !formats.contains(&format)
            {
                return Err(ExportError::Format {
                    option,
                    value,
                    format,
                    given,
                });
            }
        }
        Ok(())
    }
}

/// The outer ring of a case in one format; options of other formats are left alone.
///
/// # Errors
/// An [`ExportError`] if the case lacks the outside of the ring, or case or options are
/// impossible.
pub fn export(
    file: &CaseFile,
    format: Format,
    options: &ExportOptions,
) -> Result<Export, ExportError> {
    let asked = options.blend_mm.map(|_| file.without_default_blends());
    let asked = asked.transpose()?;
    let file = asked.as_ref().unwrap_or(file);
    let ring = blended_ring(file, options)?;
    let contents = contents(file, &ring, format, options)?;
    Ok(Export {
        not_simulated: not_simulated(file.case(), options.blend_mm(file.case())),
        ring,
        format,
        contents,
    })
}

/// Raceways without a blend of their own that could have one.
fn kinked(case: &Case) -> impl Iterator<Item = &Raceway> {
    let raceways = case.raceways.iter();
    raceways.filter(|raceway| raceway.blend_m() == 0.0 && raceway.slot().is_none())
}

fn default_blend_mm(case: &Case) -> f64 {
    let bottom_m = case.bearing.dimensions().outer_groove_bottom_radius_m;
    let half_spans_m = kinked(case).map(|raceway| raceway.half_angle_rad() * bottom_m);
    let blends_m = half_spans_m
        .chain([f64::INFINITY])
        .map(|half| Ends::Machined.blend_m(half));
    blends_m.fold(f64::INFINITY, f64::min) * 1e3
}

/// A sentence about the blend that an export adds to the raceways of a case unless told otherwise, and that
/// the case does not simulate; `None` if there is no such blend.
pub fn blend_not_simulated(case: &Case) -> Option<String> {
    not_simulated(case, default_blend_mm(case))
}

/// Sentence about a blend of `blend_mm`, mm, not simulated by the case; `None` without such a blend.
fn not_simulated(case: &Case, blend_mm: f64) -> Option<String> {
    let added = blend_mm > 0.0 && kinked(case).next().is_some();
    let mm = plain(blend_mm);
    added.then(|| match case.formulation {
        Formulation::Physical => format!(
            "not simulated: raceway.blend_mm = {mm} simulates the raceway as `export` blends it"
        ),
        Formulation::Paper => {
            format!(
                "not simulated: `export` blends the raceway over {mm} mm, the paper has no blend"
            )
        }
    })
}

/// The outer ring of a case, with the blends of an export.
///
/// # Errors
/// The case lacks the outside of the ring, its ring is impossible, or it has several rows.
pub fn outer_ring(file: &CaseFile) -> Result<OuterRing, ExportError> {
    blended_ring(file, &ExportOptions::default())
}

fn blended_ring(file: &CaseFile, options: &ExportOptions) -> Result<OuterRing, ExportError> {
    let case = file.case();
    if let Some(mm) = options.blend_mm
        && case.raceways.iter().any(|r| r.blend_m() > 0.0)
    {
        let allowed = "left out, the case has its own, raceway.blend_mm";
        return Err(OptionError::not_possible("blend_mm", plain(mm), allowed).into());
    }
    let blend_m = options.blend_mm(case) * 1e-3;
    let dimensions = file.outer_ring_dimensions(blend_m)?;
    OuterRing::of(case, dimensions).map_err(|error| {
        if error.field == "blend_m" {
            refused("blend_mm", &error, 1e3, "mm").into()
        } else {
            file.refused(&error).into()
        }
    })
}

fn contents(
    file: &CaseFile,
    ring: &OuterRing,
    format: Format,
    options: &ExportOptions,
) -> Result<Contents, ExportError> {
    match format {
        Format::Step => {
            let tolerance_um = options.tolerance_um.unwrap_or(TOLERANCE_UM);
            within("tolerance_um", tolerance_um, TOLERANCE_RANGE_UM, "µm")?;
            if options.blend_mm == Some(0.0) {
                blend_where_needed(file.case())?;
            }
            let title = match file.particulars().title.as_str() {
                "" => "outer ring",
                title => title,
            };
            let step =
                step::write(ring, title, tolerance_um, &now()?).map_err(|error| OptionError {
                    option: "tolerance_um",
                    value: tolerance_um.to_string(),
                    problem: format!(
                        "is out of reach: the finest B-spline is still {:.3e} µm off the surface",
                        error.reached_m * 1e6
                    ),
                })?;
            Ok(Contents::Whole(step))
        }
        Format::Stl => {
            let chord_um = options.chord_um.unwrap_or(CHORD_UM);
            let stl = stl::write(ring, chord_um)
                .map_err(|error| refused("chord_um", &error, 1e6, "µm"))?;
            Ok(Contents::Whole(stl))
        }
        Format::Csv => {
            let spacing_mm = options.spacing_mm.unwrap_or(SPACING_MM);
            within("spacing_mm", spacing_mm, SPACING_RANGE_MM, "mm")?;
            Ok(Contents::Points { spacing_mm })
        }
    }
}

/// Refuses raceways without a blend whose ends no smooth surface follows.
fn blend_where_needed(case: &Case) -> Result<(), OptionError> {
    if !kinked(case).any(Raceway::is_designed_at_right_angle) {
        return Ok(());
    }
    let allowed = format!(
        "more than 0 mm for STEP, such as {}: raceways of this shape end at a right angle, which a B-spline \
         does not follow",
        plain(default_blend_mm(case))
    );
    Err(OptionError::not_possible("blend_mm", plain(0.0), &allowed))
}

fn within(
    option: &'static str,
    value: f64,
    allowed: RangeInclusive<f64>,
    unit: &str,
) -> Result<(), OptionError> {
    if allowed.contains(&value) {
        return Ok(());
    }
    let (least, most) = allowed.into_inner();
    let allowed = format!("between {least} and {most} {unit}");
    Err(OptionError::not_possible(option, plain(value), &allowed))
}

/// To six decimals, or with an exponent where these would say nothing.
fn plain(value: f64) -> String {
    if value == 0.0 || (1e-6..1e9).contains(&value.abs()) {
        ((value * 1e6).round() / 1e6).to_string()
    } else {
        // Rounding away what the conversion from SI leaves.
        format!("{:e}", format!("{value:.5e}").parse().unwrap_or(value))
    }
}

/// An error of [`cageless`] in terms of an option, `scale` of its units to the SI unit.
fn refused(option: &'static str, error: &InputError, scale: f64, unit: &str) -> OptionError {
    let shown = |si: f64| format!("{} {unit}", plain(si * scale));
    let allowed = match &error.allowed {
        Allowed::Between(least, most, why) => {
            format!("between {} and {} ({why})", shown(*least), shown(*most))
        }
        Allowed::AtLeast(least, _) => format!("at least {}", shown(*least)),
        other => other.to_string(),
    };
    OptionError::not_possible(option, shown(error.value), &allowed)
}
