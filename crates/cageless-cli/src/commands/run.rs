//! `cageless run`.

use std::cell::RefCell;
use std::sync::atomic::Ordering;
use std::time::Instant;

use cageless::Case;
use cageless::collision::CollisionDetector;
use cageless::design::RunVerdict;
use cageless::dynamics::InstructionSet;
use cageless::initial_conditions::initial_state;
use cageless::passage::PassageRecorder;
use cageless::recorder::Recorder;
use cageless::simulation::{Ending, Observer, RunOutcome, run as simulate};
use cageless::summary::{SummaryRecorder, transient_s};
use cageless::vibration::VibrationRecorder;
use cageless_io::results::{Metadata, RunWriter, SummaryFile, VerificationFile, write_atomically};
use cageless_report::run_report::run_data;
use cageless_report::verification::{facts, value};
use cageless_report::{run_page, to_json};
use cageless_study::Work;
use cageless_study::verification::VerificationRuns;
use cageless_study::{Histories, SAMPLING_HZ};

use super::{make_folder, print, read_case, writable};
use crate::args::RunArgs;
use crate::failure::Failure;
use crate::format::{columns, judged, pairs, shown, warnings};
use crate::progress::{Bar, Bars, catch_interrupt};

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
    let mut verification = verify.then(|| VerificationRuns::new(case));
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
            histories.borrow_mut().push(&snapshot);
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
        let progress = Bar::new("run", 1.0, &stop);
        let mut observers: Vec<&mut dyn Observer> = vec![&mut summary, &mut collisions];
        if args.out.is_some() {
            observers.push(&mut recorder);
            observers.push(&mut passages);
            if let Some(vibration) = &mut vibration {
                observers.push(vibration);
            }
        }
        if let Some(verification) = &mut verification {
            observers.push(verification.observer());
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

    if let (Ending::ObserverFailed(error), Some(dir)) = (&outcome.ending, &args.out) {
        return Err(Failure::Other(anyhow::anyhow!(
            "{error}; {} is as it was",
            dir.display()
        )));
    }
    if let Some(writer) = writer {
        writer.into_inner().finish()?;
    }
    let mut summary_file = SummaryFile::new(&file, &outcome, summary.summary(), wall_s);
    if let Some(verification) = verification {
        verification.finish(case, &outcome, &mut summary_file, &Bars(&stop));
    }
    let verdict = histories.borrow().verdict(case);
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
        // Passages are followed only for the page.
        let verdict = args.out.is_some().then_some(&verdict);
        text(case, &outcome, &summary_file, verdict)
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

fn text(
    case: &Case,
    outcome: &RunOutcome,
    s: &SummaryFile,
    verdict: Option<&RunVerdict>,
) -> String {
    let mut lines = vec![
        (
            "simulated",
            format!("{:.6} s in {} steps", outcome.end_s, outcome.steps),
        ),
        (
            "transient discarded until",
            shown(s.settled_after_s, 6, " s"),
        ),
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
            "inner ring, mean displacement",
            format!(
                "x {}, y {}",
                shown(s.ring_x_um_mean, 4, " µm"),
                shown(s.ring_y_um_mean, 4, " µm")
            ),
        ),
        (
            "largest sliding speed under load",
            shown(s.slip_max_m_s, 4, " m/s"),
        ),
        (
            "energy balance error",
            format!("{:.2e} (relative)", s.energy_residual_relative),
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
    if let Some(verdict) = verdict {
        lines.push((
            "verdict",
            judged(verdict.verdict.passes(), &verdict.headline),
        ));
    }
    let mut text = pairs(&lines);
    if let Some(verification) = &s.verification {
        text += &verified(verification);
    }
    text + &warnings(&s.warnings)
}

/// Verification as text for the terminal.
fn verified(c: &VerificationFile) -> String {
    let head = ["result", "value", "unit", "verdict", "reason"].map(str::to_owned);
    let mut rows = vec![head.to_vec()];
    for (name, number) in c.ranked() {
        rows.push(vec![
            name.to_owned(),
            value(number),
            number.unit.clone(),
            number.verdict.clone(),
            number.reason.clone(),
        ]);
    }
    format!("\n{}\n{}", pairs(&facts(c)), columns(&rows))
}
