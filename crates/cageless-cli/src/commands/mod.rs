//! The commands.

mod compare;
pub mod design;
mod drop;
mod drop_several;
mod export;
mod files;
mod manual;
mod report;
mod reproduce;
mod run;
mod static_equilibrium;
mod steps;
mod studio;
mod sweep;
mod tolerance;

use cageless::dynamics::InstructionSet;
use cageless::{Case, Material, SCOPE};
use cageless_io::case_file::{Assumption, template};
use cageless_io::designation;
use cageless_io::results::write_atomically;
use cageless_io::rotor_file::RotorFile;
use cageless_io::touchdown_template::touchdown_case;
use cageless_results::number_text::significant;
use cageless_study::check_environment;
use serde::Serialize;

use files::{deliver, print, read_case, writable};
use steps::{check_warnings, steps_text};

use crate::args::{Args, CaseArgs, Command, Isa, New};
use crate::failure::Failure;
use crate::format::{pairs, warnings};
use crate::progress::{be_quiet, is_quiet};

/// Does what was asked.
pub fn dispatch(args: Args) -> Result<(), Failure> {
    if let Some(isa) = args.isa {
        limit_instructions(isa)?;
    }
    if args.quiet {
        be_quiet();
    }
    check_environment()?;
    match args.command {
        Command::Reproduce(args) => reproduce::reproduce(&args),
        Command::New(args) => new(&args),
        Command::Check(args) => check(&args),
        Command::Static(args) => static_equilibrium::static_equilibrium(&args),
        Command::Design(args) => design::design(&args),
        Command::Tolerance(args) => tolerance::tolerance(&args),
        Command::Run(args) => run::run(&args),
        Command::Drop(args) if RotorFile::is_at(&args.case.case) => {
            drop_several::drop_several(&args)
        }
        Command::Drop(args) => drop::touchdown(&args),
        Command::Compare(args) => compare::compare(&args),
        Command::Export(args) => export::export(&args),
        Command::Sweep(args) => sweep::sweep(&args),
        Command::Report(args) => report::report(&args),
        Command::Studio(args) => studio::studio(&args),
        Command::Completions(args) => manual::completions(args.shell),
        Command::Man(args) => manual::man(&args),
    }
}

fn new(args: &New) -> Result<(), Failure> {
    let found = args.bearing.as_ref().map(|name| {
        designation::find(name).map_err(|message| Failure::Input(format!("--bearing: {message}")))
    });
    let found = found.transpose()?;
    let text = match &found {
        None => template(args.conventional),
        Some(bearing) => {
            let full = args.full_complement;
            let text = bearing.case_file(full);
            match args.touchdown {
                true => touchdown_case(bearing, full, &text),
                false => text,
            }
        }
    };
    let Some(path) = &args.out else {
        return print(&text);
    };
    writable(path)?;
    write_atomically(path, text.as_bytes())?;
    if let Some(found) = found.filter(|_| !is_quiet()) {
        eprintln!("note: {}", found.source_of_balls());
    }
    print(&format!("{}\n", path.display()))
}

fn limit_instructions(isa: Isa) -> Result<(), Failure> {
    let set = match isa {
        Isa::Baseline => InstructionSet::Baseline,
        Isa::Avx2 => InstructionSet::Avx2,
        Isa::Avx512 => InstructionSet::Avx512,
    };
    if !set.available() {
        let allowed: Vec<&str> = InstructionSet::ALL
            .into_iter()
            .filter(|set| set.available())
            .map(InstructionSet::name)
            .collect();
        return Err(Failure::Input(format!(
            "--isa {}: this processor does not have it; allowed here: {}",
            set.name(),
            allowed.join(", ")
        )));
    }
    set.limit_to();
    Ok(())
}

fn check(args: &CaseArgs) -> Result<(), Failure> {
    if RotorFile::is_at(&args.case) {
        return drop_several::check(args);
    }
    let file = read_case(args)?;
    let bearing = &file.case().bearing;
    let d = bearing.dimensions();
    let mm = |m: f64| format!("{:.4}", m * 1e3);
    let conformity = |radius_m: f64| format!("{:.4}", radius_m / (2.0 * d.ball_radius_m));
    let material = |m: &Material| {
        let gpa = m.youngs_modulus_pa / 1e9;
        format!(
            "{} kg/m³, E {gpa} GPa, ν {}",
            m.density_kg_m3, m.poisson_ratio
        )
    };
    let mut lines = vec![
        ("case", format!("{} is valid", args.case.display())),
        ("balls", format!("{}", bearing.balls())),
        (
            "ball diameter Dw, pitch diameter Dpw",
            format!(
                "{} mm, {} mm",
                mm(2.0 * d.ball_radius_m),
                mm(2.0 * bearing.pitch_radius_m())
            ),
        ),
        (
            "groove bottom radii Ri, Ro",
            format!(
                "{} mm, {} mm",
                mm(d.inner_groove_bottom_radius_m),
                mm(d.outer_groove_bottom_radius_m)
            ),
        ),
        (
            "conformities fi, fo",
            format!(
                "{}, {}",
                conformity(d.inner_groove_curvature_radius_m),
                conformity(d.outer_groove_curvature_radius_m)
            ),
        ),
        (
            "radial internal clearance Gr",
            format!(
                "{} µm (ISO 5753-1)",
                crate::format::fixed(2e6 * bearing.radial_clearance_m(), 3)
            ) + &preload_text(file.case()),
        ),
        ("balls of", material(&bearing.materials().ball)),
        ("rings of", material(&bearing.materials().ring)),
        (
            "ε, angular ball pitch at contact",
            format!("{:.4}°", bearing.ball_angle_rad().to_degrees()),
        ),
        (
            "nominal gap 360°/N − ε",
            format!("{:.4}°", bearing.nominal_gap_rad().to_degrees()),
        ),
    ];
    lines.push(("steps of a run", steps_text(file.case())));
    let notes = check_warnings([file.case()]);
    let assumptions = file.assumptions();
    for assumption in &assumptions {
        let (value, basis) = (assumption.value, assumption.basis);
        lines.push(("assumed", format!("{} = {value} ({basis})", assumption.key)));
    }
    if !file.defaults().is_empty() {
        let defaults = file.defaults().iter().map(|key| match file.value(key) {
            Some(value) => format!("{key} = {}", value.written()),
            None => key.clone(),
        });
        let defaults: Vec<_> = defaults.collect();
        lines.push(("defaults taken", defaults.join(", ")));
    }
    for (k, statement) in SCOPE.into_iter().enumerate() {
        lines.push((if k == 0 { "scope" } else { "" }, statement.to_owned()));
    }
    /// `check.json`.
    #[derive(Serialize)]
    struct Checked<'a> {
        valid: bool,
        case: cageless_io::case_file::CaseDocument,
        defaults: &'a [String],
        assumptions: &'a [Assumption],
        scope: [&'static str; SCOPE.len()],
        warnings: &'a [String],
    }
    let result = Checked {
        valid: true,
        case: file.document_as_run(),
        defaults: file.defaults(),
        assumptions: &assumptions,
        scope: SCOPE,
        warnings: &notes,
    };
    let text = pairs(&lines) + &warnings(&notes);
    deliver(args, "check.json", &result, &text)
}

/// Preload of a bearing with interference, after its clearance; empty for any other.
fn preload_text(case: &Case) -> String {
    let force = case.preload_n();
    if force == 0.0 {
        return String::new();
    }
    let contact = case.bearing.inner_contact();
    format!(
        ": preload, unloaded balls are pressed with {} N, {:.0} MPa at the inner raceway",
        significant(force, 3),
        1e-6 * contact.peak_stress_pa(force)
    )
}
