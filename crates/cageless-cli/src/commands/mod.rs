//! The commands.

mod compare;
pub mod design;
mod drop;
mod drop_several;
mod export;
mod manual;
mod report;
mod reproduce;
mod run;
mod static_equilibrium;
mod studio;
mod sweep;
mod tolerance;

use std::path::Path;

use cageless::dynamics::InstructionSet;
use cageless::{Case, Material, SCOPE};
use cageless_io::case_file::{Assumption, CaseFile, template};
use cageless_io::designation;
use cageless_io::results::write_atomically;
use cageless_io::rotor_file::RotorFile;
use cageless_io::touchdown_template::touchdown_case;
use cageless_io::{io_error_message, on_terminal};
use cageless_study::check_environment;
use cageless_study::number_text::significant;
use serde::Serialize;

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

/// Prints text to stdout, without control sequences. A closed pipe (`cageless new | head`) is not an error.
pub fn print(text: &str) -> Result<(), Failure> {
    use std::io::Write;
    let mut out = std::io::stdout().lock();
    let text = on_terminal(text);
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        other => Ok(other?),
    }
}

/// Reads the case of a command.
pub fn read_case(args: &CaseArgs) -> Result<CaseFile, Failure> {
    CaseFile::read(&args.case, &args.set).map_err(|error| {
        if !RotorFile::is_at(&args.case) {
            return error.into();
        }
        Failure::Input(format!(
            "{}: is the file of a rotor above several bearings, which `cageless drop`, `cageless \
             check` and the plans of `cageless sweep` take; each of its bearings is a case of its own",
            args.case.display()
        ))
    })
}

/// Prints a result as JSON or text, and leaves the JSON as `NAME.json` in the folder.
pub fn deliver<T: Serialize>(
    args: &CaseArgs,
    name: &str,
    result: &T,
    text: &str,
) -> Result<(), Failure> {
    let json = serde_json::to_string_pretty(result)? + "\n";
    if let Some(dir) = &args.out {
        make_folder(dir)?;
        write_atomically(&dir.join(name), json.as_bytes())?;
    }
    if args.json { print(&json) } else { tell(text) }
}

/// Prints a result as text, unless the user wants none.
pub fn tell(text: &str) -> Result<(), Failure> {
    if is_quiet() { Ok(()) } else { print(text) }
}

/// Opens a page in the browser. Without one the page is there nevertheless.
pub fn open_page(page: &Path) {
    if let Err(error) = open::that_detached(page) {
        eprintln!(
            "warning: {} was written but could not be opened: {error}",
            page.display()
        );
    }
}

/// Makes the folder of `--out`.
pub fn make_folder(dir: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(dir).map_err(|error| {
        Failure::Input(format!(
            "--out {}: {}",
            dir.display(),
            io_error_message(&error)
        ))
    })
}

/// Refuses a folder where a file is to be.
pub fn writable(path: &Path) -> Result<(), Failure> {
    if path.is_dir() {
        return Err(Failure::Input(format!(
            "--out {}: is a directory where a file is to be",
            path.display()
        )));
    }
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

/// Number and size of the steps of a run or drop.
fn steps_text(case: &Case) -> String {
    let solver = &case.solver;
    let steps = significant((solver.duration_s / solver.step_s).ceil(), 3);
    format!("{steps} of {} µs", significant(1e6 * solver.step_s, 4))
}

/// Number of steps above which `check` warns: hours of computing.
const MANY_STEPS: f64 = 1e9;

/// Warnings about what a case, or the bearings of a rotor, will come to.
fn check_warnings<'c>(cases: impl IntoIterator<Item = &'c Case>) -> Vec<String> {
    let mut warnings = vec![];
    for case in cases {
        warnings.extend(case.bearing.fall_warning());
        if case.solver.duration_s > MANY_STEPS * case.solver.step_s {
            warnings.push(format!(
                "the run takes {}, hours of computing: shorten it (solver.duration_s), or \
                 change what makes the step small (contact.damping, \
                 bearing.inner_ring_drag_n_s_m, stiff contacts of light bodies)",
                steps_text(case).replacen(" of", " steps of", 1)
            ));
        }
    }
    warnings.dedup();
    warnings
}
