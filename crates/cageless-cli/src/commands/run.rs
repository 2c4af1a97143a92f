//! `cageless run`.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::atomic::Ordering;
use std::time::Instant;

use cageless::collision::CollisionDetector;
use cageless::dynamics::InstructionSet;
use cageless::passage::PassageRecorder;
use cageless::recorder::Recorder;
use cageless::simulation::{Ending, Observer, RunOutcome, run as simulate};
use cageless::start::initial_state;
use cageless::state::Work;
use cageless::step::StepLimits;
use cageless::summary::{Summary, SummaryRecorder, transient_s};
use cageless::vibration::VibrationRecorder;
use cageless::{Case, Method};
use cageless_io::case_file::CaseFile;
use cageless_io::results::{
    Metadata, RunWriter, SCHEMA, Stopped, SummaryFile, VERSION, write_atomically,
};
use cageless_report::{run_page, to_json};

use super::{make_folder, print, read_case, writable};
use crate::args::RunArgs;
use crate::failure::Failure;
use crate::format::{pairs, shown};
use crate::progress::{Progress, catch_interrupt};
use crate::run_report::{Histories, SAMPLING_HZ, run_data};
use crate::verification::{self, Verification};

/// Files beside the tables.
const SUMMARY: &str = "summary.json";
const PAGE: &str = "report.html";
const PAGE_DATA: &str = "report.json";

/// Simulates a case.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    let verify = args.verify;
    let args = &args.case;
    let file = read_case(args)?;
    let case = file.case();
    // A case that cannot start must not touch the folder.
    initial_state(case)?;
    let document = file.document_as_run();
    let isa = InstructionSet::chosen().name();
    let writer = match &args.out {
        Some(dir) => {
            make_folder(dir)?;
            // Better found out now than when the run is over.
            for name in [SUMMARY, PAGE, PAGE_DATA] {
                writable(&dir.join(name))?;
            }
            let metadata = Metadata {
                isa,
                case: &document,
            };
            Some(RefCell::new(RunWriter::create(dir, &metadata)?))
        }
        None => None,
    };

    let stop = catch_interrupt();
    let mut summary = SummaryRecorder::new();
    let mut verification = verify.then(|| Verification::new(case));
    let settled_s = transient_s(case);
    let mut vibration = (case.housing.as_ref())
        .map(|housing| VibrationRecorder::new(housing, SAMPLING_HZ, settled_s));
    let histories = RefCell::new(Histories::new(case));
    let started = Instant::now();
    let outcome = {
        let mut recorder = Recorder::new(case.output.interval_s, |snapshot| {
            if let Some(writer) = &writer {
                writer.borrow_mut().snapshot(&snapshot)?;
            }
            histories.borrow_mut().push(snapshot);
            Ok(())
        });
        let mut collisions = CollisionDetector::new(|collision| {
            if let Some(writer) = &writer {
                writer.borrow_mut().collision(&collision)?;
            }
            histories.borrow_mut().collide(&collision);
            Ok(())
        });
        let mut passages = PassageRecorder::new(|passage| {
            if passage.enter_s > settled_s {
                histories.borrow_mut().pass(&passage);
            }
            Ok(())
        });
        let progress = Progress::new("run", 1.0, &stop);
        let mut observers: Vec<&mut dyn Observer> = vec![&mut summary, &mut collisions];
        if args.out.is_some() {
            observers.push(&mut recorder);
            observers.push(&mut passages);
            if let Some(vibration) = &mut vibration {
                observers.push(vibration);
            }
        }
        if let Some(verification) = &mut verification {
            observers.push(verification.watch());
        }
        let outcome = simulate(
            case,
            &mut observers,
            &mut progress.run_control(case.solver.duration_s, 1.0),
        )?;
        collisions
            .close(outcome.end_s)
            .map_err(|error| Failure::Other(anyhow::anyhow!(error)))?;
        outcome
    };
    let wall_s = started.elapsed().as_secs_f64();

    if let Some(writer) = writer {
        writer.into_inner().finish()?;
    }
    let mut summary_file = summarise(&file, &outcome, summary.summary(), isa, wall_s);
    if let Some(verification) = verification {
        verification.finish(case, &outcome, &mut summary_file, &stop);
    }
    if let Some(dir) = &args.out {
        summary_file.write(dir)?;
        let data = run_data(
            &file,
            &outcome,
            &summary_file,
            histories.into_inner(),
            vibration
                .as_ref()
                .map(|recorder| &recorder.measurements()[1])
                .filter(|measured| measured.samples() > 0),
        );
        write_atomically(&dir.join(PAGE), run_page(&data).as_bytes())?;
        write_atomically(&dir.join(PAGE_DATA), to_json(&data)?.as_bytes())?;
    }
    print(&if args.json {
        summary_file.to_json()?
    } else {
        text(case, &outcome, &summary_file)
    })?;
    let kept = match &args.out {
        Some(dir) => format!(" What was computed until then is in {}.", dir.display()),
        None => String::new(),
    };
    match outcome.ending {
        Ending::Complete if verify && stop.load(Ordering::Relaxed) => Err(Failure::Interrupted(
            format!("interrupted while verifying: the run itself is complete.{kept}"),
        )),
        Ending::Complete => Ok(()),
        Ending::Interrupted => Err(Failure::Interrupted(format!(
            "interrupted at t = {:.6} s.{kept}",
            outcome.end_s
        ))),
        Ending::Stopped(stop) => Err(Failure::stopped(&stop, &kept)),
        Ending::ObserverFailed(error) => Err(Failure::Other(anyhow::anyhow!(error))),
    }
}

fn summarise(
    file: &CaseFile,
    outcome: &RunOutcome,
    summary: Option<Summary>,
    isa: &str,
    wall_s: f64,
) -> SummaryFile {
    let mut energy: BTreeMap<String, f64> = Work::ALL
        .into_iter()
        .map(|work| (work.name().to_owned(), outcome.state.work_j(work)))
        .collect();
    energy.insert(
        "change".to_owned(),
        outcome.end_energy_j - outcome.start_energy_j,
    );
    let mut warnings = warnings(file.case());
    if matches!(outcome.ending, Ending::Interrupted) {
        warnings.push(format!(
            "interrupted at t = {:.6} s of {} s",
            outcome.end_s,
            file.case().solver.duration_s
        ));
    }
    // A run that stopped says so itself.
    let residual = outcome.energy_residual_relative;
    if residual.abs() > RESIDUAL_SHARE && !matches!(outcome.ending, Ending::Stopped(_)) {
        warnings.push(format!(
            "{:.1} % of all energy flows are unaccounted for: do not trust these numbers, set \
             solver.step_us to less than the {} µs of this run",
            100.0 * residual,
            file.case().solver.step_s * 1e6
        ));
    }
    if summary.is_none() {
        warnings.push("the run ended within its transient: no statistics".to_owned());
    }
    let number = |f: fn(&Summary) -> f64| summary.as_ref().map_or(f64::NAN, f);
    SummaryFile {
        schema: SCHEMA,
        version: VERSION.to_owned(),
        isa: isa.to_owned(),
        case: file.document_as_run(),
        defaults: file.defaults().to_vec(),
        collisions: summary.map_or(0, |s| s.collisions),
        gap_min_deg: number(|s| s.gap_min_rad).to_degrees(),
        gap_max_deg: number(|s| s.gap_max_rad).to_degrees(),
        ring_x_um_mean: number(|s| s.ring_x_mean_m * 1e6),
        ring_y_um_mean: number(|s| s.ring_y_mean_m * 1e6),
        slip_max_m_s: number(|s| s.slip_max_m_s),
        energy_residual_relative: outcome.energy_residual_relative,
        energy,
        steps: outcome.steps,
        rhs_evaluations: outcome.rhs_evaluations,
        wall_s,
        settled_after_s: number(|s| s.settled_after_s),
        warnings,
        certificate: None,
        stopped: match &outcome.ending {
            Ending::Stopped(stop) => Some(Stopped {
                time_s: stop.time_s,
                cause: stop.cause.to_string(),
                advice: stop.advice(),
            }),
            _ => None,
        },
    }
}

/// Largest step at which ABM4 stays unbiased without contact damping.
const UNDAMPED_STEP_S: f64 = 0.5e-6;

/// Share of all energy flows that may be unaccounted for without a warning.
const RESIDUAL_SHARE: f64 = 0.01;

fn warnings(case: &Case) -> Vec<String> {
    let mut warnings = vec![];
    let method = case.solver.method;
    let resolved = StepLimits::of(case).friction_resolved_to_s(method);
    if case.solver.step_s > resolved {
        warnings.push(format!(
            "friction of the smooth law decays faster than the step follows: slip near zero is \
             wrong above {:.2} µs (solver.step_us, contact.slip_scale_m_s)",
            resolved * 1e6
        ));
    }
    let undamped = case.contact.damping_n_s_m1_5 == 0.0;
    if method == Method::Abm4 && undamped && case.solver.step_s > UNDAMPED_STEP_S {
        warnings.push(
            "without contact damping ABM4 gains energy at steps above 0.5 µs: statistics are \
             biased (solver.step_us, or solver.method = \"symplectic\")"
                .to_owned(),
        );
    }
    warnings
}

fn text(case: &Case, outcome: &RunOutcome, s: &SummaryFile) -> String {
    let mut lines = vec![
        (
            "simulated",
            format!("{:.6} s in {} steps", outcome.end_s, outcome.steps),
        ),
        ("statistics after", shown(s.settled_after_s, 6, " s")),
        ("collisions between balls", format!("{}", s.collisions)),
        (
            "gap",
            format!(
                "{} to {}",
                shown(s.gap_min_deg, 4, "°"),
                shown(s.gap_max_deg, 4, "°")
            ),
        ),
        (
            "ring, mean",
            format!(
                "x {}, y {}",
                shown(s.ring_x_um_mean, 4, " µm"),
                shown(s.ring_y_um_mean, 4, " µm")
            ),
        ),
        ("largest slip under load", shown(s.slip_max_m_s, 4, " m/s")),
        (
            "energy residual",
            format!("{:.2e} of all flows", s.energy_residual_relative),
        ),
        (
            "speed",
            format!(
                "{:.2} s per simulated second",
                s.wall_s / outcome.end_s.max(1e-12)
            ),
        ),
    ];
    if !case.title.is_empty() {
        lines.insert(0, ("case", case.title.clone()));
    }
    let mut text = pairs(&lines);
    if let Some(certificate) = &s.certificate {
        text += &verification::text(certificate);
    }
    for warning in &s.warnings {
        text += &format!("warning: {warning}\n");
    }
    text
}
