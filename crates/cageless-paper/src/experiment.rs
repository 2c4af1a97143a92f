//! Vibration (Fig. 12) and the two bearings side by side (Fig. 13, 14).

use cageless::Snapshot;
use cageless::collision::{Collision, CollisionDetector};
use cageless::numerics::Moments;
use cageless::recorder::{Recorder, keeping};
use cageless::simulation::run;
use cageless::vibration::VibrationRecorder;
use cageless_io::case_file::CaseFile;
use cageless_report::{Motion, Provenance, Vibration, VibrationSignal};

use crate::cases;
use crate::error::housing;
use crate::load_zone::{load_zone_rad, transition_shares};
use cageless_report::run_report::{ball_pass_mark, filter_note, motion, vibration_signal};
use cageless_study::threads;
use cageless_study::{SAMPLING_HZ, StudyError, Work, provenance};

/// Steps, about.
pub const WORK: f64 = 2.0e6;

/// Motion is shown so far: the paper's last photograph is at 0.2 s.
const SHOWN_S: f64 = 0.25;
/// Sampling of the motion.
const INTERVAL_S: f64 = 1e-4;
/// End of the transient, which the spectrum leaves out.
const SETTLED_AFTER_S: f64 = 0.5;
/// Stretches of equal length into which records are divided to find their change over time.
pub const STRETCHES: usize = 4;

/// A stretch of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// RMS of the vertical acceleration of the housing, m/s².
    pub rms_m_s2: f64,
    /// Contacts between balls per second.
    pub contacts_per_s: f64,
    /// Sum of the impulses of the contacts per second, N.
    pub impulse_rate_n: f64,
}

/// The [`STRETCHES`] of a record from its start to `end_s`.
pub fn stretches(trace: &[[f64; 2]], contacts: &[Collision], end_s: f64) -> [Stretch; STRETCHES] {
    let length_s = end_s / STRETCHES as f64;
    std::array::from_fn(|k| {
        let within = |time_s: f64| ((time_s / length_s) as usize).min(STRETCHES - 1) == k;
        let mut acceleration = Moments::default();
        let values = trace.iter().filter(|[time_s, _]| within(*time_s));
        values.for_each(|[_, a]| acceleration.add(*a, 1.0));
        let here = || contacts.iter().filter(|c| within(c.start_s));
        Stretch {
            rms_m_s2: acceleration.deviation(),
            contacts_per_s: here().count() as f64 / length_s,
            impulse_rate_n: here().map(|c| c.impulse_n_s).sum::<f64>() / length_s,
        }
    })
}

/// Motion of one bearing.
#[derive(Debug, Clone)]
pub struct Bearing {
    /// Contacts between balls after [`SETTLED_AFTER_S`], per second.
    pub collisions_per_s: f64,
    /// RMS of the vibration after [`SETTLED_AFTER_S`], m/s².
    pub rms_m_s2: f64,
    /// Shares of all contacts at the ends of the load zone, and by chance, as in
    /// [`TRANSITIONS`](crate::comparison::TRANSITIONS).
    pub transition_shares: [[f64; 2]; 3],
    /// The whole record, transient included.
    pub stretches: [Stretch; STRETCHES],
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
    pub bearings: [Bearing; 2],
}

struct One {
    signal: VibrationSignal,
    motion: Motion,
    bearing: Bearing,
}

/// Runs both bearings.
pub fn compute(progress: &Work<'_>) -> Result<Experiment, StudyError> {
    let both = cases::experiment()?;
    let names = ["conventional", "discrete raceway"];
    let ones = threads::both(
        || one(&both[0], names[0], progress),
        || one(&both[1], names[1], progress),
    );
    let ones = [ones.0?, ones.1?];
    let case = both[1].case();
    let source = Provenance {
        case: "Zhao 2022, experiment: 3000 rpm, 1.5 kN, four bunches of balls at the start"
            .to_owned(),
        ..provenance(
            "",
            case,
            format!(
                "nothing of the record, t < {SETTLED_AFTER_S} s of spectrum and RMS; {}",
                filter_note(case)
            ),
        )
    };
    let bearings = ones.each_ref().map(|one| one.bearing.clone());
    let (signals, motions) = ones.into_iter().map(|one| (one.signal, one.motion)).unzip();
    Ok(Experiment {
        vibration: Vibration {
            signals,
            marks: vec![ball_pass_mark(case)],
            provenance: source,
        },
        motions,
        bearings,
    })
}

fn one(file: &CaseFile, name: &str, progress: &Work<'_>) -> Result<One, StudyError> {
    let case = file.case();
    let housing = housing(case)?;
    let mut settled = VibrationRecorder::new(housing, SAMPLING_HZ, SETTLED_AFTER_S);
    let mut whole = VibrationRecorder::new(housing, SAMPLING_HZ, 0.0);
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
    let mut detector = CollisionDetector::new(keeping(&mut collisions, |_| true));
    let duration_s = case.solver.duration_s;
    let outcome = run(
        case,
        &mut [&mut settled, &mut whole, &mut recorder, &mut detector],
        &mut progress.run_control(duration_s, WORK / 2.0),
    )?;
    drop((recorder, detector));
    StudyError::unless_complete(&outcome.ending)?;
    let record = whole.measurements()[1].trace();
    let signal = VibrationSignal {
        time_s: record.iter().map(|point| point[0]).collect(),
        acceleration_m_s2: record.iter().map(|point| point[1]).collect(),
        ..vibration_signal(name, &settled.measurements()[1])
    };
    let late = collisions
        .iter()
        .filter(|c| c.start_s > SETTLED_AFTER_S)
        .count();
    let deviation = |s: Option<&Snapshot>| s.map_or(f64::NAN, |s| deviation_deg(&s.gap_rad));
    let bearing = Bearing {
        collisions_per_s: late as f64 / (duration_s - SETTLED_AFTER_S),
        transition_shares: transition_shares(&collisions, load_zone_rad(case)?),
        stretches: stretches(&record, &collisions, duration_s),
        rms_m_s2: signal.rms_m_s2.unwrap_or(f64::NAN),
        gap_deviation_deg: [deviation(snapshots.first()), deviation(last.as_ref())],
        touching: [0.05, 0.1, 0.15, 0.2].map(|moment| touching_at(&snapshots, moment)),
    };
    let source = provenance(&file.particulars().title, case, "nothing".to_owned());
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
