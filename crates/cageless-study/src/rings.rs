//! Outer rings of one bearing beside each other: a short run of each from the same starts.

use std::ops::ControlFlow;

use cageless::Case;
use cageless::collision::CollisionDetector;
use cageless::design::pressure_at_rest_pa;
use cageless::design::search::from_uneven_start;
use cageless::recorder::{Recorder, keeping};
use cageless::simulation::{Ending, Observer, run};
use cageless::snapshot::Snapshot;
use serde::{Deserialize, Serialize};

use crate::error::StudyError;
use crate::progress::Progress;

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

/// Each ring, run from the same uneven starts.
///
/// # Errors
/// [`StudyError::Interrupted`] if the progress ended the work.
pub fn rings(
    cases: &[(&str, Case)],
    progress: &dyn Progress,
) -> Result<Vec<RingNumbers>, StudyError> {
    let task = progress.begin("rings", cases.len() as f64);
    let mut found = vec![];
    for (name, case) in cases {
        let mut motions = vec![];
        for start in 0..STARTS {
            let mut control =
                task.run_control(ORBITS * case.rolling_orbit_s(), 1.0 / STARTS as f64);
            let case = from_uneven_start(case, start, ORBITS);
            motions.extend(motion(&case, &mut *control));
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

/// Runs a case; `None` if it stops.
fn motion(case: &Case, control: &mut dyn FnMut(f64) -> ControlFlow<()>) -> Option<Motion> {
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
        run(case, &mut observers, control).ok()?
    };
    if !matches!(outcome.ending, Ending::Complete) || snapshots.is_empty() {
        return None;
    }
    let gaps: Vec<f64> = snapshots.iter().flat_map(|s| s.gap_rad.clone()).collect();
    let (gap_mean, gap_deviation) = moments(&gaps);
    let over = |of: fn(&Snapshot) -> f64| moments(&snapshots.iter().map(of).collect::<Vec<_>>()).1;
    Some(Motion {
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
