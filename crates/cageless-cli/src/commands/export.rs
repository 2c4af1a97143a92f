//! `cageless export`.

use std::io::IsTerminal;
use std::path::PathBuf;

use cageless_io::cad::{
    Counts, ExportError, ExportNumbers, ExportOptions, Format, SlotNumbers, export as ring,
    names_file,
};
use cageless_io::results::ResultFolder;

use crate::args::ExportArgs;
use crate::driver::{pretty, print, read_case_at_rest, tell};
use crate::failure::Failure;
use crate::format::pairs;
use crate::progress::message;

/// Writes the outer ring of a case.
pub fn export(args: &ExportArgs) -> Result<(), Failure> {
    let file = read_case_at_rest(&args.case, &args.set)?;
    let format = args.format.into();
    let options = ExportOptions {
        blend_mm: args.blend_mm,
        tolerance_um: args.tolerance_um,
        chord_um: args.chord_um,
        spacing_mm: args.spacing_mm,
    };
    options.check(&[format])?;
    let made = ring(&file, format, &options)?;
    // Only now, so that bad input leaves no folder behind.
    let target = target(args, format)?;
    let numbers = match &target {
        Target::File(path) => made.write_file(path)?,
        Target::Folder(dir) => {
            let mut folder = ResultFolder::open(dir)?;
            let path = dir.join(format!("outer_ring.{}", format.name()));
            let (file, numbers) = made.write_partial(&path)?;
            folder.add_file(file)?;
            folder.commit("export.json", &pretty(&numbers)?)?;
            numbers
        }
        Target::Nowhere => made.write(&mut std::io::sink())?,
        Target::Stdout => match made.write(&mut std::io::stdout().lock()) {
            // A closed pipe is not an error.
            Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => return Ok(()),
            other => other?,
        },
    };
    if file
        .case()
        .raceways
        .iter()
        .any(|r| r.depth_error_m() != 0.0)
    {
        message(
            "note: the ring is written as designed, without raceway.depth_error_um, an error of \
             machining; raceway.depth_um is the depth of the drawing",
        );
    }
    match target {
        _ if args.json => print(&pretty(&numbers)?),
        Target::File(_) | Target::Folder(_) => tell(&text(&numbers)),
        Target::Nowhere | Target::Stdout => {
            message(text(&numbers).trim_end());
            Ok(())
        }
    }
}

/// Where the ring goes.
enum Target {
    File(PathBuf),
    /// With the numbers beside it.
    Folder(PathBuf),
    Stdout,
    Nowhere,
}

fn target(args: &ExportArgs, format: Format) -> Result<Target, Failure> {
    let Some(out) = &args.out else {
        let binary = format == Format::Stl && !args.json;
        if binary && std::io::stdout().is_terminal() {
            let message = "--out FILE is needed: an STL is binary, and stdout is a terminal";
            return Err(Failure::Input(message.to_owned()));
        }
        return Ok(match args.json {
            true => Target::Nowhere,
            false => Target::Stdout,
        });
    };
    if names_file(out) {
        let refuse = |why: String| Err(Failure::Input(format!("--out {}: {why}", out.display())));
        return match Format::from_path(out) {
            Some(named) if named == format => Ok(Target::File(out.clone())),
            Some(named) => refuse(format!(
                "is the name of a file of --format {}, not of {}",
                named.name(),
                format.name()
            )),
            None => refuse(format!(
                "a file of --format {0} ends in .{0}; the name of a folder that is to be made \
                 has no ending, or a slash at its end",
                format.name()
            )),
        };
    }
    Ok(Target::Folder(out.clone()))
}

impl From<ExportError> for Failure {
    fn from(error: ExportError) -> Self {
        let flag = |option: &str| format!("--{}", option.replace('_', "-"));
        match error {
            ExportError::Case(error) => error.into(),
            ExportError::Date(error) => Self::Input(error.to_string()),
            ExportError::Option(error) => Self::Input(format!(
                "{} {}: {}",
                flag(error.option),
                error.value,
                error.problem
            )),
            ExportError::Format {
                option,
                value,
                format,
                given,
            } => Self::Input(format!(
                "{} {value}: is for --format {} only, not for {}",
                flag(option),
                format.name(),
                given.name()
            )),
        }
    }
}

/// A label and its text.
type Line = (&'static str, String);

/// Text for the terminal.
fn text(r: &ExportNumbers) -> String {
    let mut lines = vec![
        (
            "file",
            format!(
                "{}, {} bytes",
                r.file.as_deref().unwrap_or("stdout"),
                r.bytes
            ),
        ),
        ("volume of the ring", format!("{:.6} mm³", r.volume_mm3)),
        (
            "deviation from the surface",
            format!("{:.6} µm", r.deviation_um),
        ),
    ];
    lines.push(counts_line(&r.counts));
    if r.raceways > 0 {
        lines.push(("discrete raceways", r.raceways.to_string()));
    }
    if r.raceways > r.slots.len() {
        lines.extend(raceway_ends(r));
    }
    lines.extend(r.slots.iter().map(|slot| ("slot", slot_text(slot))));
    if r.raceways > 0 {
        lines.push((
            "deviation from the plain groove",
            format!(
                "max. material above plain groove {:.3} µm, below {:.3} µm",
                r.above_plain_um, r.below_plain_um
            ),
        ));
    }
    if let Some(sentence) = &r.blend_not_simulated {
        lines.push(("blend", sentence.clone()));
    }
    if r.contact_angle_deg.or(r.groove_centre_z_mm).is_some() {
        let numbers = [r.contact_angle_deg, r.groove_centre_z_mm].map(Option::unwrap_or_default);
        let [angle, height] = numbers;
        lines.extend([
            (
                "contact angle",
                format!(
                    "{angle:.4}°; centre of the groove at z = {height:.6} mm from the middle of the ring"
                ),
            ),
            (
                "shoulders",
                "both full: the case has no dimension of a counterbored one".to_owned(),
            ),
        ]);
    }
    pairs(&lines)
}

/// Content of the file, in a line.
fn counts_line(counts: &Counts) -> Line {
    match *counts {
        Counts::Step {
            tolerance_um,
            faces,
            bspline_faces,
            edges,
            control_points,
        } => (
            "solid",
            format!(
                "{faces} faces, {bspline_faces} of them B-splines with {control_points} control \
                 points; {edges} edges; tolerance {tolerance_um} µm"
            ),
        ),
        Counts::Stl {
            chord_um,
            triangles,
            vertices,
            mesh_volume_mm3,
        } => (
            "mesh",
            format!(
                "{triangles} triangles, {vertices} corners, {mesh_volume_mm3:.6} mm³; chord error \
                 at most {chord_um} µm"
            ),
        ),
        Counts::Csv {
            spacing_mm,
            row_distance_mm,
            surface_points,
            contact_points,
        } => (
            "points",
            format!(
                "{surface_points} of the surface, {contact_points} of the contact track; sections \
                 {row_distance_mm:.4} mm apart, spacing at most {spacing_mm} mm"
            ),
        ),
    }
}

/// Lines on the ends of raceways that have a kink by their design.
fn raceway_ends(r: &ExportNumbers) -> [Line; 2] {
    let kink = format!(
        "{:.4}° at 45° groove angle, {:.4}° at the shoulder",
        r.design_slope_discontinuity_45_deg, r.design_slope_discontinuity_shoulder_deg
    );
    let blend = match r.blend_mm > 0.0 {
        true => format!(
            "blended over {} mm (was {kink}); max. deviation from nominal {:.4} µm",
            (r.blend_mm * 1e6).round() / 1e6,
            r.blend_deviation_um
        ),
        false => format!("not blended: {kink}"),
    };
    [
        ("slope discontinuity at raceway ends", blend),
        (
            "angle of the apex between the contact points",
            format!("{:.4}°", r.apex_angle_deg),
        ),
    ]
}

fn slot_text(slot: &SlotNumbers) -> String {
    format!(
        "{:.6} mm wide, floor {:.6} mm below the plain groove, edges of radius {:.4} mm; from ψ = \
         {:.4}° to {:.4}°",
        slot.width_mm,
        slot.depth_mm,
        slot.edge_radius_mm,
        slot.centre_angle_deg - slot.half_angle_deg,
        slot.centre_angle_deg + slot.half_angle_deg,
    )
}
