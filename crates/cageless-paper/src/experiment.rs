//! Vibration (Fig. 12) and the two bearings side by side (Fig. 13, 14).

use cageless::Case;
use cageless::collision::{Collision, CollisionDetector};
use cageless::recorder::Recorder;
use cageless::simulation::{Ending, run};
use cageless::snapshot::Snapshot;
use cageless::vibration::VibrationRecorder;
use cageless_report::{Motion, Provenance, Vibration, VibrationSignal};
use rayon::prelude::*;

use crate::cases;
use crate::error::PaperError;
use cageless_report::run_report::{ball_pass_mark, filter_note, motion, vibration_signal};
use cageless_study::{SAMPLING_HZ, Work, provenance};

/// Seconds on one core, roughly.
pub const WORK: f64 = 3.0;

/// Motion is shown so far: the paper's last photograph is at 0.2 s.
const SHOWN_S: f64 = 0.25;
/// Sampling of the motion.
const INTERVAL_S: f64 = 1e-4;
/// Part of the run that counts as settled.
const SETTLED_AFTER_S: f64 = 0.5;

/// What one bearing did.
pub struct Bearing {
    /// Contacts between balls after [`SETTLED_AFTER_S`], per second.
    pub collisions_per_s: f64,
    /// Share of all contacts at 60° < |ψ| < 150°, where the load lets go or takes hold.
    pub transition_fraction: f64,
    /// RMS of the vibration, m/s².
    pub rms_m_s2: f64,
    /// Standard deviation of the gaps at the start and the end, degrees.
    pub gap_deviation_deg: [f64; 2],
    /// Pairs in contact or within 0.01° at the paper's four moments.
    pub touching: [usize; 4],
}

/// Fig. 12 to 14.
pub struct Experiment {
    /// Fig. 12.
    pub vibration: Vibration,
    /// Fig. 13, 14.
    pub motions: Vec<Motion>,
    /// Numbers: conventional, discrete.
    pub bearings: Vec<Bearing>,
}

struct One {
    signal: VibrationSignal,
    motion: Motion,
    bearing: Bearing,
}

/// Runs both bearings.
pub fn compute(progress: &dyn Work) -> Result<Experiment, PaperError> {
    let both = cases::experiment()?;
    let names = ["conventional", "discrete raceway"];
    let ones: Vec<One> = both
        .par_iter()
        .zip(names)
        .map(|(case, name)| one(case, name, progress))
        .collect::<Result<_, PaperError>>()?;
    let case = &both[1];
    let source = Provenance {
        case: "Zhao 2022, experiment: 3000 rpm, 1.5 kN, four bunches of balls at the start"
            .to_owned(),
        ..provenance(
            case,
            format!("t < {SETTLED_AFTER_S} s; {}", filter_note(case)),
        )
    };
    let mut experiment = Experiment {
        vibration: Vibration {
            signals: vec![],
            marks: vec![ball_pass_mark(case)],
            provenance: source,
        },
        motions: vec![],
        bearings: vec![],
    };
    for one in ones {
        experiment.vibration.signals.push(one.signal);
        experiment.motions.push(one.motion);
        experiment.bearings.push(one.bearing);
    }
    Ok(experiment)
}

fn one(case: &Case, name: &str, progress: &dyn Work) -> Result<One, PaperError> {
    let Some(housing) = &case.housing else {
        return Err(PaperError::NoResult(
            "the case of the experiment needs a [housing]".to_owned(),
        ));
    };
    let mut vibration = VibrationRecorder::new(housing, SAMPLING_HZ, SETTLED_AFTER_S);
    let mut snapshots: Vec<Snapshot> = vec![];
    let mut last: Option<Snapshot> = None;
    let mut collisions: Vec<Collision> = vec![];
    let mut recorder = Recorder::new(INTERVAL_S, |snapshot| {
        if snapshot.time_s <= SHOWN_S {
            snapshots.push(snapshot);
        } else {
            last = Some(snapshot);
        }
        Ok(())
    });
    let mut detector = CollisionDetector::new(|collision| {
        collisions.push(collision);
        Ok(())
    });
    let duration_s = case.solver.duration_s;
    let outcome = run(
        case,
        &mut [&mut vibration, &mut recorder, &mut detector],
        &mut progress.run_control(duration_s, WORK / 2.0),
    )?;
    drop((recorder, detector));
    if let Ending::Stopped(stop) = &outcome.ending {
        return Err(PaperError::Stopped(stop.clone()));
    }
    let signal = vibration_signal(name, &vibration.measurements()[1]);
    let late = collisions
        .iter()
        .filter(|c| c.start_s > SETTLED_AFTER_S)
        .count();
    let deviation = |s: Option<&Snapshot>| s.map_or(f64::NAN, |s| deviation_deg(&s.gap_rad));
    let bearing = Bearing {
        collisions_per_s: late as f64 / (duration_s - SETTLED_AFTER_S),
        transition_fraction: {
            let between = |c: &&Collision| (60.0..150.0).contains(&c.angle_rad.to_degrees().abs());
            collisions.iter().filter(between).count() as f64 / collisions.len().max(1) as f64
        },
        rms_m_s2: signal.rms_m_s2.unwrap_or(f64::NAN),
        gap_deviation_deg: [deviation(snapshots.first()), deviation(last.as_ref())],
        touching: [0.05, 0.1, 0.15, 0.2].map(|moment| touching_at(&snapshots, moment)),
    };
    let source = provenance(case, "nothing".to_owned());
    Ok(One {
        signal,
        motion: motion(case, name, &snapshots, source),
        bearing,
    })
}

/// Standard deviation of `gaps`, radians, in degrees.
pub fn deviation_deg(gaps: &[f64]) -> f64 {
    let n = gaps.len() as f64;
    let mean = gaps.iter().sum::<f64>() / n;
    (gaps.iter().map(|g| (g - mean).powi(2)).sum::<f64>() / n)
        .sqrt()
        .to_degrees()
}

fn touching_at(snapshots: &[Snapshot], moment_s: f64) -> usize {
    snapshots
        .iter()
        .min_by(|a, b| {
            (a.time_s - moment_s)
                .abs()
                .total_cmp(&(b.time_s - moment_s).abs())
        })
        .map_or(0, |s| {
            s.gap_rad.iter().filter(|g| g.to_degrees() <= 0.01).count()
        })
}
