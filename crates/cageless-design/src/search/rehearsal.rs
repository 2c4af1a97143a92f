//! The work of a search before it starts: the search itself, with closed forms in the place of its runs.

use super::film_lag::film_lag_at_rest_rad;
use super::job::{Job, Numbers, Outcome, PairSeparation, Task};
use super::perturbed_run::{Motion, VALUES, from_uneven_start};
use super::raceway_layout::ClosedForms;
use super::rejection::Cause;
use super::request::{Request, Stage};
use super::{Interrupted, SearchError, axial, search};
use crate::AXIAL_ORBITS;
use crate::critical_gap::{PairTest, pair_steps};
use crate::distinct_rows::distinct_rows;
use cageless::Case;

/// Runs of one kind that a stage of a search takes.
#[derive(Debug, Clone, PartialEq)]
pub struct ExpectedRuns {
    /// The stage.
    pub stage: Stage,
    /// One of them.
    pub case: Case,
    /// Jobs.
    pub jobs: Vec<Job>,
    /// Steps of all of them.
    pub steps: f64,
    /// Whether they are quicker done several at once.
    pub shared: bool,
}

impl Job {
    /// The case that the job simulates, and the steps that this takes, a rough number for a pair; `None` if the raceways
    /// are impossible.
    pub fn expected(&self, case: &Case) -> Option<(Case, f64)> {
        let raceways = self.structure.raceways(&case.bearing).ok()?;
        Some(match self.task {
            Task::PairSeparation => {
                let case = self.point.case(case, raceways);
                let rows = distinct_rows(&case).len() as f64;
                let pairs = case.raceways.iter().map(|raceway| {
                    let alone = case.with_raceways(vec![raceway.clone()]);
                    pair_steps(&alone, &PairTest::default())
                });
                let steps = rows * pairs.sum::<f64>();
                (case, steps)
            }
            Task::Motion(start) => {
                let case = self.point.case(case, raceways);
                let case = from_uneven_start(&case, start, start.turns());
                let steps = case.solver.steps();
                (case, steps)
            }
            Task::AxialLag(axial_load_n) => {
                let case = axial::in_space(case, &self.point, raceways, axial_load_n);
                let orbits = AXIAL_ORBITS.iter().sum::<f64>();
                let steps = orbits * case.rolling_orbit_s() / case.solver.step_s;
                (case, steps)
            }
        })
    }

    /// Whether the critical gap and the pressure that a job has found leave its raceways acceptable; `None` of other tasks
    /// and without an outcome.
    pub fn is_acceptable(&self, case: &Case, request: &Request, outcome: &Outcome) -> Option<bool> {
        let Ok(Numbers::PairSeparation(spacing)) = outcome else {
            return None;
        };
        let forms = self.closed_forms(case).ok()?;
        let gap_range = request.gap_range(case.film.is_some());
        let cause = Cause::of_spacing(&forms, spacing, &gap_range, case.has_elastic_flanks());
        Some(cause.is_none())
    }

    /// Closed forms of its raceways at its operating point.
    fn closed_forms(&self, case: &Case) -> Result<ClosedForms, String> {
        let raceways = self.structure.raceways(&case.bearing);
        let raceways = raceways.map_err(|error| error.to_string())?;
        let forms = match case.has_elastic_flanks() {
            true => {
                let seats = self.point.row_seats(case);
                let seats = seats.map_err(|error| error.to_string())?;
                ClosedForms::elastic(&case.bearing, &raceways, &seats)
            }
            false => ClosedForms::new(&case.bearing, &raceways),
        };
        Ok(forms.lagging(&case.bearing, film_lag_at_rest_rad(case, &self.point)))
    }

    /// Outcome of the job for rolling balls, with nothing wrong with its raceways.
    fn rehearsed(&self, case: &Case) -> Outcome {
        Ok(match self.task {
            Task::PairSeparation => Numbers::PairSeparation(PairSeparation {
                critical_gap_rad: self.closed_forms(case)?.theoretical_gap_rad,
                shortfall: 0.0,
                // Any order makes a front.
                stress_pa: 1e9 * (1.0 + self.structure.half_angle_rad),
            }),
            Task::Motion(_) => Numbers::Motion(Motion {
                double_collision_fraction: 0.0,
                sliding_m_s: self.structure.axial_span_m,
                ..Motion::from_values([1.0; VALUES])
            }),
            Task::AxialLag(0.0) => Numbers::AxialLag(1.0),
            Task::AxialLag(_) => Numbers::AxialLag(0.9),
        })
    }
}

/// The runs that a search takes where closed forms and the budget decide, stage by stage. Where sliding leaves fewer
/// raceways than they do, it takes less.
///
/// # Errors
/// Those of [`search`].
pub fn expected_runs(case: &Case, request: &Request) -> Result<Vec<ExpectedRuns>, SearchError> {
    let mut all: Vec<ExpectedRuns> = vec![];
    let mut known = std::collections::HashSet::new();
    search(case, request, &mut |stage, jobs| {
        for job in jobs {
            let new = known.insert(job.key());
            let Some((sample, steps)) = job.expected(case).filter(|_| new) else {
                continue;
            };
            let shared = job.is_shared();
            match all
                .iter_mut()
                .find(|r| (r.stage, r.shared) == (stage, shared))
            {
                Some(runs) => {
                    runs.jobs.push(job.clone());
                    runs.steps += steps;
                }
                None => all.push(ExpectedRuns {
                    stage,
                    case: sample,
                    jobs: vec![job.clone()],
                    steps,
                    shared,
                }),
            }
        }
        Ok::<_, Interrupted>(jobs.iter().map(|job| job.rehearsed(case)).collect())
    })?;
    Ok(all)
}
