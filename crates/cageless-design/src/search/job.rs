//! The pieces of work of a search: pure functions of the case, to be run in any order on any
//! thread.

use super::axial;
use super::film_lag::film_lag_at_rest_rad;
use super::perturbed_run::{Motion, PerturbedRunError, UnevenStart, perturbed_runs};
use super::raceway_layout::{OperatingPoint, RacewayLayout};
use crate::critical_gap::{CROWDED_MAX, CriticalGapError, PairTest, critical_gap_rad};
use crate::distinct_rows::distinct_rows;
use crate::pressure_at_rest_pa;
use cageless::Case;
use cageless::closed_forms::{Eq11, kinematic_gap_rad, steady_gap_rad, theoretical_gap_rad};
use cageless::raceway::Raceway;
use cageless::simulation::Control;

/// Task of a job.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Task {
    /// Critical gap and contact stress.
    PairSeparation,
    /// A run of all balls from this uneven start.
    Motion(UnevenStart),
    /// Lag of evenly spaced balls in space under this axial load, N.
    AxialLag(f64),
}

/// One piece of work.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// The raceways.
    pub structure: RacewayLayout,
    /// Speed and load.
    pub point: OperatingPoint,
    /// Task of the job.
    pub(crate) task: Task,
}

/// Critical gap and contact stress of a structure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairSeparation {
    /// Largest critical gap of the raceways, each alone in the ring: about the gap to which all of them
    /// together separate balls, in space in the row with the least. No more than `CROWDED_MAX` steady gaps are
    /// looked at.
    pub critical_gap_rad: f64,
    /// Largest fraction of β0 that slip takes from a critical gap; 0 where that is beyond
    /// `CROWDED_MAX`. On elastic flanks β0 is that of rolling at the contact angle and the deflection of the row.
    pub shortfall: f64,
    /// Largest Hertz pressure at the outer raceway while the balls go by; on elastic flanks NaN where the critical gap
    /// excludes the structure whatever the pressure.
    pub stress_pa: f64,
}

/// Outcome of a job.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Numbers {
    /// Numbers of `Task::PairSeparation`.
    PairSeparation(PairSeparation),
    /// Numbers of `Task::Motion`.
    Motion(Motion),
    /// Lag of `Task::AxialLag`, rad.
    AxialLag(f64),
}

/// Numbers, or why there are none.
pub type Outcome = Result<Numbers, String>;

/// The caller wants the search to end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("interrupted")]
pub struct Interrupted;

impl Job {
    /// A name that no other job of the same case has.
    pub fn key(&self) -> String {
        let mut key = match self.task {
            Task::PairSeparation => "spacing".to_owned(),
            Task::Motion(start) => format!("motion {start}"),
            Task::AxialLag(axial_load_n) => format!("axial {axial_load_n:?}"),
        };
        let (s, p) = (&self.structure, &self.point);
        for value in [
            s.axial_span_m,
            s.half_angle_rad,
            p.inner_speed_rad_s,
            p.radial_load_n,
            p.axial_load_n,
            s.section_angle_rad,
        ]
        .iter()
        .chain(&s.centres_rad)
        {
            // Decimal digits that lead back to the same bits.
            key += &format!(" {value:?}");
        }
        // The rest of the form is that of the case.
        key + " " + s.form.shape.name()
    }

    /// Whether jobs of this kind are quicker done several at once ([`run_jobs`]).
    pub fn is_shared(&self) -> bool {
        matches!(self.task, Task::Motion(_))
    }
}

/// Does the work of jobs on the calling thread, without interruption: the `execute` of a
/// [`search`](super::search) that needs no other.
///
/// # Errors
/// None; the type is that of `Execute`.
pub fn run_here(case: &Case, jobs: &[Job]) -> Result<Vec<Outcome>, Interrupted> {
    let jobs: Vec<&Job> = jobs.iter().collect();
    let outcomes = run_jobs(case, &jobs, &mut |_| Control::Continue(()));
    outcomes
        .into_iter()
        .map(|one| one.ok_or(Interrupted))
        .collect()
}

/// Does the work of several jobs, their runs side by side; outcomes come in the order of the
/// jobs, `None` where `control` ended a run. Which jobs are done together changes no outcome.
pub fn run_jobs(
    case: &Case,
    jobs: &[&Job],
    control: &mut dyn FnMut(f64) -> Control,
) -> Vec<Option<Outcome>> {
    let mut outcomes: Vec<Option<Outcome>> = vec![None; jobs.len()];
    let mut runs: Vec<(usize, Case, UnevenStart)> = vec![];
    for (k, job) in jobs.iter().enumerate() {
        match (job.structure.raceways(&case.bearing), job.task) {
            (Err(error), _) => outcomes[k] = Some(Err(error.to_string())),
            (Ok(raceways), Task::PairSeparation) => {
                outcomes[k] = match spacing(case, &job.point, &raceways, control) {
                    Ok(spacing) => Some(Ok(Numbers::PairSeparation(spacing))),
                    Err(CriticalGapError::Interrupted) => None,
                    Err(error) => Some(Err(error.to_string())),
                };
            }
            (Ok(raceways), Task::AxialLag(axial_load_n)) => {
                let lag = axial::lag(case, &job.point, &raceways, axial_load_n, control);
                outcomes[k] = lag.map(|lag| lag.map(Numbers::AxialLag));
            }
            (Ok(raceways), Task::Motion(start)) => {
                runs.push((k, job.point.case(case, raceways), start));
            }
        }
    }
    let cases: Vec<(&Case, UnevenStart)> =
        runs.iter().map(|(_, case, start)| (case, *start)).collect();
    for ((k, ..), motion) in runs.iter().zip(perturbed_runs(&cases, control)) {
        outcomes[*k] = match motion {
            Ok(motion) => Some(Ok(Numbers::Motion(motion))),
            Err(PerturbedRunError::Interrupted) => None,
            Err(error) => Some(Err(error.to_string())),
        };
    }
    outcomes
}

/// Critical gaps, each raceway alone, and stress of all.
fn spacing(
    case: &Case,
    point: &OperatingPoint,
    raceways: &[Raceway],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<PairSeparation, CriticalGapError> {
    let loaded = point.case(case, raceways.to_vec());
    let elastic = loaded.has_elastic_flanks();
    let seats = match elastic {
        true => point.row_seats(case)?,
        false => vec![],
    };
    let beta0 = |raceway: &Raceway, row: usize| match seats.get(row) {
        Some(&[angle_rad, pressed_in_m]) => {
            kinematic_gap_rad(&case.bearing, raceway, angle_rad, pressed_in_m)
        }
        None => theoretical_gap_rad(&case.bearing, raceway, Eq11::Published),
    };
    // Gaps are asked for beside that in steady flow, which a film widens.
    let widening = film_lag_at_rest_rad(case, point) / case.balls() as f64;
    let steady_gap = steady_gap_rad(&case.bearing, raceways) + widening;
    let most = CROWDED_MAX * steady_gap;
    let mut spacing = PairSeparation {
        critical_gap_rad: f64::INFINITY,
        shortfall: f64::NEG_INFINITY,
        stress_pa: f64::NAN,
    };
    for row in distinct_rows(&loaded) {
        let test = PairTest::of_raceways(&loaded, row, steady_gap);
        let mut of_row = 0.0f64;
        for raceway in raceways {
            let alone = point.case(case, vec![raceway.clone()]);
            let (gap, shortfall) = match critical_gap_rad(&alone, &test, control) {
                Ok(gap) => (gap, 1.0 - gap / beta0(raceway, row)),
                // Nothing closes on a raceway that does not slow the balls.
                Err(CriticalGapError::NeverCloses) => (0.0, 1.0),
                // What slip takes is not known then, and does not matter.
                Err(CriticalGapError::AlwaysCloses) => (most, 0.0),
                Err(error) => return Err(error),
            };
            of_row = of_row.max(gap);
            spacing.shortfall = spacing.shortfall.max(shortfall);
        }
        spacing.critical_gap_rad = spacing.critical_gap_rad.min(of_row);
    }
    let separates = spacing.critical_gap_rad > 0.0 && spacing.critical_gap_rad < most;
    if !elastic || separates {
        let [_, outer] = pressure_at_rest_pa(&loaded)?;
        spacing.stress_pa = outer;
    }
    Ok(spacing)
}
