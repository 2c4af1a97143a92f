//! `cageless export`.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use cageless::InputError;
use cageless::error::Allowed;
use cageless::surface::OuterRing;
use cageless_io::cad::{points, step, stl};
use cageless_io::case_file::CaseFile;
use cageless_io::results::write_atomically;

use super::export_result::{Counts, ExportResult};
use super::{make_folder, print, print_bytes};
use crate::args::{CadFormat, ExportArgs};
use crate::failure::Failure;

/// The paper's structure (d) stays within its machining error of 2 µm (docs/theory/cad.md).
const BLEND_MM: f64 = 0.5;
/// Share of half a raceway that the default blend takes at most.
const BLEND_SHARE: f64 = 0.2;
const TOLERANCE_UM: f64 = 0.01;
/// Finer is below the rounding of coordinates, coarser no longer a STEP of precision.
const TOLERANCE_RANGE_UM: [f64; 2] = [1e-4, 1.0];
const CHORD_UM: f64 = 5.0;
const SPACING_MM: f64 = 0.5;
const SPACING_RANGE_MM: [f64; 2] = [0.01, 100.0];

/// Writes the outer ring of a case.
pub fn export(args: &ExportArgs) -> Result<(), Failure> {
    let file = CaseFile::read(&args.case, &args.set)?;
    check_flags(args)?;
    let ring = outer_ring(&file, args)?;
    let (bytes, deviation_m, counts) = contents(&file, &ring, args)?;
    // Only now, so that bad input leaves no folder behind.
    let path = target(args)?;
    let written = match &path {
        Some(path) => {
            write_atomically(path, &bytes)?;
            Some(path.display().to_string())
        }
        None => None,
    };
    let result = ExportResult::new(
        &ring,
        args.format,
        written,
        bytes.len(),
        deviation_m,
        counts,
    );
    let json = serde_json::to_string_pretty(&result)? + "\n";
    if let (Some(dir), Some(path)) = (&args.out, &path)
        && dir != path
    {
        write_atomically(&dir.join("export.json"), json.as_bytes())?;
    }
    match (path, args.json) {
        (_, true) => print(&json),
        (Some(_), false) => print(&result.text()),
        (None, false) => {
            eprint!("{}", result.text());
            print_bytes(&bytes)
        }
    }
}

/// Refuses what does not go with the format.
fn check_flags(args: &ExportArgs) -> Result<(), Failure> {
    for (flag, value, format) in [
        ("--tolerance-um", args.tolerance_um, CadFormat::Step),
        ("--chord-um", args.chord_um, CadFormat::Stl),
        ("--spacing-mm", args.spacing_mm, CadFormat::Csv),
    ] {
        if let Some(value) = value
            && format != args.format
        {
            return Err(Failure::Input(format!(
                "{flag} {value}: goes with --format {} only, not with {}",
                format.name(),
                args.format.name()
            )));
        }
    }
    Ok(())
}

/// The file to write; `None` for stdout or, with `--json`, nowhere.
fn target(args: &ExportArgs) -> Result<Option<PathBuf>, Failure> {
    let Some(out) = &args.out else {
        let binary = args.format == CadFormat::Stl && !args.json;
        if binary && std::io::stdout().is_terminal() {
            let message = "--out FILE is needed: an STL is binary, and stdout is a terminal";
            return Err(Failure::Input(message.to_owned()));
        }
        return Ok(None);
    };
    let ending = |path: &Path| {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "step" | "stp" => Some(CadFormat::Step),
            "stl" => Some(CadFormat::Stl),
            "csv" => Some(CadFormat::Csv),
            _ => None,
        }
    };
    match ending(out) {
        _ if out.is_dir() => {}
        Some(format) if format == args.format => return Ok(Some(out.clone())),
        Some(format) => {
            return Err(Failure::Input(format!(
                "--out {}: is the name of a file of --format {}, not of {}",
                out.display(),
                format.name(),
                args.format.name()
            )));
        }
        None => make_folder(out)?,
    }
    Ok(Some(out.join(format!("outer_ring.{}", args.format.name()))))
}

fn outer_ring(file: &CaseFile, args: &ExportArgs) -> Result<OuterRing, Failure> {
    let case = file.case();
    let bottom_m = case.bearing.dimensions().outer_groove_bottom_radius_m;
    let share = (case.raceways.iter())
        .map(|r| BLEND_SHARE * r.half_angle_rad() * bottom_m)
        .fold(BLEND_MM * 1e-3, f64::min);
    let blend_m = args.blend_mm.map_or(share, |mm| mm * 1e-3);
    let dimensions = file.outer_ring_dimensions(blend_m)?;
    OuterRing::new(&case.bearing, &case.raceways, dimensions).map_err(|error| {
        if error.field == "blend_m" {
            refused_flag("--blend-mm", &error, 1e3, "mm")
        } else {
            file.refused(&error).into()
        }
    })
}

/// The file, its deviation from the surface, and what it holds.
fn contents(
    file: &CaseFile,
    ring: &OuterRing,
    args: &ExportArgs,
) -> Result<(Vec<u8>, f64, Counts), Failure> {
    match args.format {
        CadFormat::Step => {
            let tolerance_um = args.tolerance_um.unwrap_or(TOLERANCE_UM);
            within("--tolerance-um", tolerance_um, TOLERANCE_RANGE_UM, "µm")?;
            let title = match file.case().title.as_str() {
                "" => "outer ring",
                title => title,
            };
            let step = step::write(ring, title, tolerance_um * 1e-6).map_err(|error| {
                Failure::Input(format!(
                    "--tolerance-um {tolerance_um}: is out of reach: the finest B-spline is still \
                     {:.3e} µm off the surface",
                    error.reached_m * 1e6
                ))
            })?;
            let counts = Counts::Step {
                tolerance_um,
                faces: step.faces,
                bspline_faces: step.spline_faces,
                edges: step.edges,
                control_points: step.control_points,
            };
            Ok((step.text.into_bytes(), step.deviation_m, counts))
        }
        CadFormat::Stl => {
            let chord_um = args.chord_um.unwrap_or(CHORD_UM);
            let stl = stl::write(ring, chord_um * 1e-6).map_err(|error| match error {
                stl::StlError::Chord(error) => refused_flag("--chord-um", &error, 1e6, "µm"),
                stl::StlError::Write(error) => error.into(),
            })?;
            let counts = Counts::Stl {
                chord_um,
                triangles: stl.triangles,
                vertices: stl.vertices,
                mesh_volume_mm3: stl.volume_m3 * 1e9,
            };
            Ok((stl.bytes, stl.deviation_m, counts))
        }
        CadFormat::Csv => {
            let spacing_mm = args.spacing_mm.unwrap_or(SPACING_MM);
            within("--spacing-mm", spacing_mm, SPACING_RANGE_MM, "mm")?;
            let table = points::write(ring, spacing_mm * 1e-3);
            let counts = Counts::Csv {
                spacing_mm,
                row_distance_mm: table.row_distance_m * 1e3,
                surface_points: table.surface_points,
                contact_points: table.contact_points,
            };
            Ok((table.text.into_bytes(), table.deviation_m, counts))
        }
    }
}

fn within(flag: &str, value: f64, [least, most]: [f64; 2], unit: &str) -> Result<(), Failure> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "{flag} {value}: is not possible: it must be between {least} and {most} {unit}"
    )))
}

/// An error of [`cageless`] in terms of a flag, `scale` of its units to the SI unit.
fn refused_flag(flag: &str, error: &InputError, scale: f64, unit: &str) -> Failure {
    let shown = |si: f64| format!("{} {unit}", (si * scale * 1e6).round() / 1e6);
    let allowed = match &error.allowed {
        Allowed::Between(least, most, why) => {
            format!("between {} and {} ({why})", shown(*least), shown(*most))
        }
        Allowed::AtLeast(least, _) => format!("at least {}", shown(*least)),
        other => other.to_string(),
    };
    Failure::Input(format!(
        "{flag} {}: is not possible: it must be {allowed}",
        shown(error.value)
    ))
}
