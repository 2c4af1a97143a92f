//! Outer rings of one bearing beside each other: a short run of each from the same starts.

use std::ops::ControlFlow;

use cageless::Case;
use cageless::collision::CollisionDetector;
use cageless::design::pressure_at_rest_pa;
use cageless::design::search::{UnevenStart, from_uneven_start};
use cageless::recorder::{Recorder, keeping};
use cageless::simulation::{Ending, Observer, run};
use cageless::snapshot::Snapshot;
use serde::{Deserialize, Serialize};

use crate::error::StudyError;
use crate::progress::Progress;
use crate::task::Task;

/// Orbits of the balls in each run; the second half counts.
const ORBITS: f64 = 20.0;
/// Uneven starts of each ring.
const STARTS: u64 = 2;
/// Snapshots per orbit.
const SNAPSHOTS: f64 = 40.0;

/// An outer ring in motion, means over its starts. A number that could not be had is `None`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RingNumbers {
    /// Name: `recommended`, `initial design`, `conventional`.
    pub name: String,
    /// Why a run stopped, so that there are no numbers of the motion.
    #[serde(default)]
    pub stopped: Option<String>,
    /// Contacts between balls per ball and orbit.
    pub contacts: Option<f64>,
    /// Smallest gap, degrees.
    pub gap_min_deg: Option<f64>,
    /// Standard deviation of all gaps over their mean.
    pub spacing_scatter: Option<f64>,
    /// Power lost to friction, W.
    pub friction_w: Option<f64>,
    /// Standard deviation of the displacement of the inner ring, both directions together, µm.
    pub ring_deviation_um: Option<f64>,
    /// Peak contact pressure at rest, inner raceway, largest over the places of the balls, MPa.
    pub inner_pressure_mpa: Option<f64>,
    /// Peak contact pressure at rest, outer raceway, largest over the places of the balls, MPa.
    pub outer_pressure_mpa: Option<f64>,
}

/// Numbers of one run.
struct Motion {
    contacts: f64,
    gap_min: f64,
    scatter: f64,
    friction: f64,
    ring: f64,
}

/// Name of the task of [`rings`].
const TASK: &str = "rings";
/// Rings that there are at most: the recommended, the case's own and a conventional one.
const RINGS_MAX: f64 = 3.0;

/// Steps of one start of a ring.
fn start_steps(case: &Case) -> f64 {
    ORBITS * case.rolling_orbit_s() / case.solver.step_s
}

/// The task of [`rings`] like one of a case.
pub(crate) fn task(case: &Case) -> Task {
    let steps = RINGS_MAX * STARTS as f64 * start_steps(case);
    Task::new(TASK).with(case, steps, 1)
}

/// Each ring, run from the same uneven starts.
///
/// # Errors
/// [`StudyError::Interrupted`] if the progress ended the work.
pub fn rings(
    cases: &[(&str, Case)],
    progress: &dyn Progress,
) -> Result<Vec<RingNumbers>, StudyError> {
    let steps = |case: &Case| STARTS as f64 * start_steps(case);
    let task = progress.begin(TASK, cases.iter().map(|(_, case)| steps(case)).sum());
    let mut found = vec![];
    for (name, case) in cases {
        let (mut motions, mut stopped) = (vec![], None);
        for start in 0..STARTS {
            let duration_s = ORBITS * case.rolling_orbit_s();
            let mut control = task.run_control(duration_s, start_steps(case));
            let case = from_uneven_start(case, UnevenStart::Drawn(start), ORBITS);
            match motion(&case, &mut *control) {
                Ok(motion) => motions.push(motion),
                Err(reason) => stopped = stopped.or(Some(reason)),
            }
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
        }
        let mean = |of: fn(&Motion) -> f64| {
            let sum: f64 = motions.iter().map(of).sum();
            // One start that fails would make the means incomparable.
            (motions.len() as u64 == STARTS).then(|| sum / STARTS as f64)
        };
        let at_rest = pressure_at_rest_pa(case).ok();
        found.push(RingNumbers {
            name: (*name).to_owned(),
            stopped,
            contacts: mean(|m| m.contacts),
            gap_min_deg: mean(|m| m.gap_min.to_degrees()),
            spacing_scatter: mean(|m| m.scatter),
            friction_w: mean(|m| m.friction),
            ring_deviation_um: mean(|m| m.ring * 1e6),
            inner_pressure_mpa: at_rest.map(|[inner, _]| inner * 1e-6),
            outer_pressure_mpa: at_rest.map(|[_, outer]| outer * 1e-6),
        });
    }
    Ok(found)
}

/// Runs a case.
///
/// # Errors
/// The reason for which it stops, or cannot start.
fn motion(case: &Case, control: &mut dyn FnMut(f64) -> ControlFlow<()>) -> Result<Motion, String> {
    let half_s = case.solver.duration_s / 2.0;
    let (mut contacts, mut snapshots) = (0u32, Vec::<Snapshot>::new());
    let outcome = {
        let mut collisions = CollisionDetector::new(|collision| {
            contacts += u32::from(collision.start_s > half_s);
            Ok(())
        });
        let interval_s = case.rolling_orbit_s() / SNAPSHOTS;
        let mut recorder =
            Recorder::new(interval_s, keeping(&mut snapshots, |s| s.time_s > half_s));
        let mut observers: Vec<&mut dyn Observer> = vec![&mut collisions, &mut recorder];
        run(case, &mut observers, control).map_err(|error| error.to_string())?
    };
    match outcome.ending {
        Ending::Complete if !snapshots.is_empty() => {}
        Ending::Stopped(stop) => return Err(stop.reason()),
        _ => return Err("it did not come to its end".to_owned()),
    }
    let gaps: Vec<f64> = snapshots.iter().flat_map(|s| s.gap_rad.clone()).collect();
    let (gap_mean, gap_deviation) = moments(&gaps);
    let over = |of: fn(&Snapshot) -> f64| moments(&snapshots.iter().map(of).collect::<Vec<_>>()).1;
    Ok(Motion {
        contacts: f64::from(contacts) / (case.bearing.balls() as f64 * ORBITS / 2.0),
        gap_min: gaps.iter().copied().fold(f64::INFINITY, f64::min),
        scatter: gap_deviation / gap_mean,
        friction: outcome.state.friction_j() / case.solver.duration_s,
        ring: over(|s| s.ring.x_m).hypot(over(|s| s.ring.y_m)),
    })
}

/// Mean and standard deviation.
fn moments(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / count;
    (mean, variance.sqrt())
}
