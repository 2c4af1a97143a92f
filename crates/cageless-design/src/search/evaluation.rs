//! Structures with all that is known of them, and the batches of work that find it out.

use std::ops::RangeInclusive;

use super::axial::AxialSeparation;
use super::job::{Interrupted, Job, Numbers, Outcome, PairSeparation, Task};
use super::measured_separation::MeasuredSeparation;
use super::pareto::OBJECTIVES;
use super::perturbed_run::{Motion, UnevenStart, VALUES};
use super::raceway_layout::{ClosedForms, RacewayLayout};
use super::rejection::{Cause, Rejection};
use super::request::{Execute, Request, Stage};
use cageless::Bearing;
use cageless::raceway::Raceway;

/// A structure with what is known of it; later stages are left empty once it is rejected.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluation {
    /// The raceways.
    pub structure: RacewayLayout,
    /// Index of its placement in [`Request::placements`].
    pub placement: usize,
    /// Closed forms; `None` if the bearing cannot carry the raceways.
    pub forms: Option<ClosedForms>,
    /// Critical gap and stress at each operating point.
    pub spacing: Vec<Option<PairSeparation>>,
    /// Mean over the uneven starts at each operating point.
    pub motion: Vec<Option<Motion>>,
    /// Lag under the largest axial load at each operating point; empty without such a load.
    pub axial: Vec<AxialSeparation>,
    /// Reason of the rejection; `None` if acceptable.
    pub rejection: Option<Rejection>,
    /// Objectives, each at the worst of the operating points: scatter of the spacing (standard
    /// deviation over mean gap), collisions per ball and orbit in steady state, critical over steady
    /// gap, sliding speed (m/s), contact pressure (Pa), deviation of the force (N), friction loss
    /// (W). `None` if it is rejected or was left out by the budget.
    pub objectives: Option<[f64; OBJECTIVES]>,
    /// Whether no other beats it.
    pub on_front: bool,
}

/// Runs from several starts.
#[derive(Debug, Clone, PartialEq)]
pub struct Statistics {
    /// Each run, in the order of the starts.
    pub runs: Vec<Motion>,
    /// Mean over the starts.
    pub mean: Motion,
    /// Standard error of each mean.
    pub error: Motion,
}

impl Statistics {
    /// Statistics of two runs or more.
    pub fn new(runs: Vec<Motion>) -> Self {
        let mean = Motion::mean(&runs);
        let n = runs.len() as f64;
        let mut square = [0.0; VALUES];
        for motion in &runs {
            for ((s, v), m) in square.iter_mut().zip(motion.values()).zip(mean.values()) {
                *s += (v - m).powi(2);
            }
        }
        Self {
            mean,
            error: Motion::from_values(square.map(|s| (s / (n - 1.0) / n).sqrt())),
            runs,
        }
    }

    /// Difference to another structure from the same starts, run by run: what the starts do to
    /// both alike drops out.
    pub fn less(&self, other: &Self) -> Self {
        let pairs = self.runs.iter().zip(&other.runs);
        Self::new(
            pairs
                .map(|(a, b)| {
                    let mut difference = a.values();
                    for (d, v) in difference.iter_mut().zip(b.values()) {
                        *d -= v;
                    }
                    Motion::from_values(difference)
                })
                .collect(),
        )
    }
}

/// Which structure is confirmed from more starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// The recommendation.
    Recommended,
    /// A candidate that more starts reject.
    Unconfirmed,
    /// The structure of the case.
    Own,
}

/// A structure from more starts, whose means decide whether it is acceptable.
#[derive(Debug, Clone, PartialEq)]
pub struct Confirmed {
    /// Which structure it is.
    pub role: Role,
    /// Candidate with the means over the starts common to all designs, for comparison with them.
    pub evaluation: Evaluation,
    /// Statistics over drawn starts at each operating point; empty if a run failed.
    pub statistics: Vec<Statistics>,
    /// Motion from the bunched start, once the bunch had time to come apart, at each operating point; empty if a
    /// run failed.
    pub bunched: Vec<Motion>,
}

/// Receiver of jobs and their stage.
pub(super) struct Batch<'r, 'e> {
    pub request: &'r Request,
    /// Ranges of lC and θ: the requested part of what Eq. (8) and (9) allow.
    pub ranges: [[f64; 2]; 2],
    pub execute: &'r mut Execute<'e>,
    pub bearing: &'r Bearing,
    /// Contact angle and deflection under the largest axial load at each operating point; empty without one.
    pub seats: Vec<[f64; 2]>,
    /// Contact angle, rad, and deflection, m, of every row at every operating point of a case in space; empty in the
    /// plane.
    pub row_seats: Vec<[f64; 2]>,
    /// Lag of a free ball by the film, rad; 0 without one.
    pub film_lag_rad: f64,
    /// Critical gaps of the maps of a case in space over β0; `None` in the plane and before there are maps.
    pub measured: Option<MeasuredSeparation>,
    /// Simulations of all balls so far.
    pub simulations: usize,
}

impl Evaluation {
    /// Results of the closed forms.
    pub(super) fn new(batch: &Batch<'_, '_>, structure: RacewayLayout, placement: usize) -> Self {
        let points = batch.request.points.len();
        let mut axial = vec![];
        let (forms, cause) = match structure.raceways(batch.bearing) {
            Ok(raceways) => {
                axial = AxialSeparation::by_rolling(batch.bearing, &raceways[0], &batch.seats);
                let forms = batch.closed_forms(&raceways);
                let cause = Cause::of_closed_forms(&forms, *batch.gap_range().start());
                (Some(forms), cause)
            }
            Err(error) => (None, Some(Cause::of_geometry(structure.form.shape, &error))),
        };
        let mut evaluation = Self {
            structure,
            placement,
            forms,
            spacing: vec![None; points],
            motion: vec![None; points],
            axial,
            rejection: cause.map(|cause| Rejection {
                cause,
                point: None,
                bunched: false,
            }),
            objectives: None,
            on_front: false,
        };
        evaluation.reject(|e, point| Cause::of_axial(e.axial.get(point)?));
        evaluation
    }

    /// The first cause found at any point.
    pub(super) fn reject(&mut self, found: impl Fn(&Self, usize) -> Option<Cause>) {
        if self.rejection.is_some() {
            return;
        }
        self.rejection = (0..self.spacing.len()).find_map(|point| {
            found(self, point).map(|cause| Rejection {
                cause,
                point: Some(point),
                bunched: false,
            })
        });
    }

    /// Whether the motion of all balls is known at some operating point.
    pub fn has_moved(&self) -> bool {
        self.motion.iter().any(Option::is_some)
    }

    /// Rejected for this reason, it is on no front.
    pub(super) fn reject_with(&mut self, rejection: &Rejection) {
        self.rejection = Some(rejection.clone());
        (self.objectives, self.on_front) = (None, false);
    }

    /// The first cause found at any point in the motion from the bunched start.
    fn reject_bunched(&mut self, found: impl Fn(&Self, usize) -> Option<Cause>) {
        if self.rejection.is_none() {
            self.reject(found);
            if let Some(rejection) = &mut self.rejection {
                rejection.bunched = true;
            }
        }
    }

    fn rate(&mut self) {
        let Some(forms) = self.forms else { return };
        if self.rejection.is_some() {
            return;
        }
        let mut worst = [f64::NEG_INFINITY; OBJECTIVES];
        for (spacing, motion) in self.spacing.iter().zip(&self.motion) {
            let (Some(s), Some(m)) = (spacing, motion) else {
                return;
            };
            let here = [
                m.gap_deviation_rad / forms.steady_gap_rad,
                m.collisions_late,
                s.critical_gap_rad / forms.steady_gap_rad,
                m.sliding_m_s,
                s.stress_pa,
                m.force_deviation_n,
                m.friction_w,
            ];
            for (w, h) in worst.iter_mut().zip(here) {
                *w = w.max(h);
            }
        }
        self.objectives = Some(worst);
    }
}

impl Batch<'_, '_> {
    /// Whether the flanks are elastic.
    pub(super) fn elastic(&self) -> bool {
        !self.row_seats.is_empty()
    }

    /// Closed forms of equal raceways.
    pub(super) fn closed_forms(&self, raceways: &[Raceway]) -> ClosedForms {
        let forms = match self.elastic() {
            true => ClosedForms::elastic(self.bearing, raceways, &self.row_seats),
            false => ClosedForms::new(self.bearing, raceways),
        };
        forms.lagging(self.bearing, self.film_lag_rad)
    }

    /// Critical gap over the steady gap that is asked for: with a film that of the least scatter.
    pub(super) fn gap_range(&self) -> RangeInclusive<f64> {
        self.request.gap_range(self.film_lag_rad > 0.0)
    }

    /// Whether a structure lies within what was asked for.
    pub(super) fn within(&self, structure: &RacewayLayout) -> bool {
        let inside = |range: Option<[f64; 2]>, value: f64| {
            // Snapping to whole micrometres may step over an end by rounding.
            range.is_none_or(|[low, high]| {
                value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9)
            })
        };
        inside(self.request.axial_span_range_m, structure.axial_span_m)
            && inside(self.request.half_angle_range_rad, structure.half_angle_rad)
    }

    pub(super) fn execute(
        &mut self,
        stage: Stage,
        jobs: &[Job],
    ) -> Result<Vec<Outcome>, Interrupted> {
        if jobs.is_empty() {
            return Ok(vec![]);
        }
        let of_all = jobs.iter().filter(|j| matches!(j.task, Task::Motion(_)));
        self.simulations += of_all.count();
        let outcomes = (self.execute)(stage, jobs)?;
        assert_eq!(outcomes.len(), jobs.len(), "one outcome per job");
        Ok(outcomes)
    }

    /// Critical gap and stress of all that are not rejected.
    pub(super) fn spacing(
        &mut self,
        stage: Stage,
        evaluations: &mut [Evaluation],
    ) -> Result<(), Interrupted> {
        let mut jobs = vec![];
        let mut places = vec![];
        for (k, e) in evaluations.iter().enumerate() {
            if e.rejection.is_some() {
                continue;
            }
            for (p, &point) in self.request.points.iter().enumerate() {
                places.push((k, p));
                jobs.push(Job {
                    structure: e.structure.clone(),
                    point,
                    task: Task::PairSeparation,
                });
            }
        }
        let outcomes = self.execute(stage, &jobs)?;
        let gap_range = self.gap_range();
        for ((k, p), outcome) in places.into_iter().zip(outcomes) {
            let e = &mut evaluations[k];
            match outcome {
                Ok(Numbers::PairSeparation(spacing)) => e.spacing[p] = Some(spacing),
                Ok(_) => unreachable!("outcome of another task"),
                Err(reason) => fail(e, reason, p),
            }
        }
        let elastic = self.elastic();
        for e in evaluations {
            e.reject(|e, p| {
                let (forms, spacing) = (e.forms?, e.spacing[p]?);
                Cause::of_spacing(&forms, &spacing, &gap_range, elastic)
            });
        }
        Ok(())
    }

    /// Motion of at most `limit` of those that are not rejected, spread evenly over them.
    pub(super) fn motion(
        &mut self,
        stage: Stage,
        evaluations: &mut [Evaluation],
        limit: usize,
    ) -> Result<(), Interrupted> {
        let mut left: Vec<usize> = (0..evaluations.len())
            .filter(|&k| evaluations[k].rejection.is_none())
            .collect();
        if left.len() > limit {
            let count = left.len();
            left = (0..limit).map(|k| left[k * count / limit]).collect();
        }
        let starts = self.request.starts;
        let jobs: Vec<Job> = left
            .iter()
            .flat_map(|&k| self.motion_jobs(&evaluations[k].structure, starts))
            .collect();
        let outcomes = self.execute(stage, &jobs)?;
        let points = self.request.points.len();
        let mut runs = outcomes.chunks(starts as usize);
        for k in left {
            for p in 0..points {
                let of_point = runs.next().unwrap_or_default();
                match motions(of_point) {
                    Ok(all) => evaluations[k].motion[p] = Some(Motion::mean(&all)),
                    Err(reason) => fail(&mut evaluations[k], reason, p),
                }
            }
            let elastic = self.elastic();
            evaluations[k].reject(|e, p| Cause::of_motion(&e.motion[p]?, &e.spacing[p]?, elastic));
            evaluations[k].rate();
        }
        Ok(())
    }

    /// Runs of a structure at one point.
    pub(super) fn motion_jobs_at(
        &self,
        structure: &RacewayLayout,
        point: super::OperatingPoint,
        starts: u64,
    ) -> impl Iterator<Item = Job> {
        let seed = self.request.seed;
        (0..starts).map(move |number| Job {
            structure: structure.clone(),
            point,
            task: Task::Motion(UnevenStart::Drawn { seed, number }),
        })
    }

    fn motion_jobs(&self, structure: &RacewayLayout, starts: u64) -> Vec<Job> {
        let points = self.request.points.iter();
        points
            .flat_map(|&point| self.motion_jobs_at(structure, point, starts))
            .collect()
    }

    /// Simulations of all balls that the confirmation of one structure takes.
    pub(super) fn of_confirmation(&self) -> usize {
        self.request.points.len() * (self.request.confirming_starts() as usize + 1)
    }

    /// Numbers of one structure from [`Request::confirming_starts`] and a bunched start, whether it is
    /// acceptable or not. What is read from the motion is required of the means over the drawn starts, and
    /// of the bunched one by itself, which a mean would hide.
    pub(super) fn confirm(
        &mut self,
        role: Role,
        structure: &RacewayLayout,
    ) -> Result<Confirmed, Interrupted> {
        let mut one = [Evaluation::new(self, structure.clone(), 0)];
        let from_geometry = one[0].rejection.take();
        if one[0].forms.is_some() {
            self.spacing(Stage::Confirm, &mut one)?;
        }
        self.axial_lags(&mut [&mut one[0]])?;
        let usual = self.request.starts as usize;
        let starts = self.request.confirming_starts();
        let points = self.request.points.len();
        let mut jobs = self.motion_jobs(structure, starts);
        jobs.extend(self.request.points.iter().map(|&point| Job {
            structure: structure.clone(),
            point,
            task: Task::Motion(UnevenStart::Bunched),
        }));
        let outcomes = self.execute(Stage::Confirm, &jobs)?;
        let (drawn, bunched) = outcomes.split_at(jobs.len() - points);
        let [mut evaluation] = one;
        let (mut statistics, mut from_bunch) = (vec![], vec![]);
        for (p, (runs, bunched)) in drawn.chunks(starts as usize).zip(bunched).enumerate() {
            let both =
                motions(runs).and_then(|all| Ok((all, motions(std::slice::from_ref(bunched))?)));
            match both {
                Ok((all, bunched)) => {
                    evaluation.motion[p] = Some(Motion::mean(&all[..usual]));
                    statistics.push(Statistics::new(all));
                    from_bunch.extend(bunched);
                }
                Err(reason) => fail(&mut evaluation, reason, p),
            }
        }
        if statistics.len() < points {
            statistics.clear();
            from_bunch.clear();
        }
        let elastic = self.elastic();
        evaluation
            .reject(|e, p| Cause::of_motion(&statistics.get(p)?.mean, &e.spacing[p]?, elastic));
        evaluation
            .reject_bunched(|e, p| Cause::of_motion(from_bunch.get(p)?, &e.spacing[p]?, elastic));
        if from_geometry.is_some() {
            evaluation.rejection = from_geometry;
        }
        evaluation.rate();
        Ok(Confirmed {
            role,
            evaluation,
            statistics,
            bunched: from_bunch,
        })
    }
}

/// The motions of several runs, or why one has none.
pub(super) fn motions(outcomes: &[Outcome]) -> Result<Vec<Motion>, String> {
    outcomes
        .iter()
        .map(|outcome| match outcome {
            Ok(Numbers::Motion(motion)) => Ok(*motion),
            Ok(_) => unreachable!("outcome of another task"),
            Err(reason) => Err(reason.clone()),
        })
        .collect()
}

pub(super) fn fail(evaluation: &mut Evaluation, reason: String, point: usize) {
    evaluation.rejection.get_or_insert(Rejection {
        cause: Cause::Failed(reason),
        point: Some(point),
        bunched: false,
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(factor: f64) -> Motion {
        Motion::from_values(std::array::from_fn(|k| factor * (k + 1) as f64))
    }

    fn evaluation(spacing: Vec<PairSeparation>, motion: Vec<Motion>) -> Evaluation {
        Evaluation {
            structure: RacewayLayout {
                axial_span_m: 5e-3,
                half_angle_rad: 0.4,
                form: Default::default(),
                section_angle_rad: 0.0,
                centres_rad: vec![0.0],
            },
            placement: 0,
            forms: Some(ClosedForms {
                theoretical_gap_rad: 0.03,
                steady_gap_rad: 0.04,
                film_lag_rad: 0.0,
            }),
            spacing: spacing.into_iter().map(Some).collect(),
            motion: motion.into_iter().map(Some).collect(),
            axial: vec![],
            rejection: None,
            objectives: None,
            on_front: false,
        }
    }

    fn spacing(critical_gap_rad: f64, shortfall: f64, stress_pa: f64) -> PairSeparation {
        PairSeparation {
            critical_gap_rad,
            shortfall,
            stress_pa,
        }
    }

    /// Every number of a motion has its place in files.
    #[test]
    fn motions_are_their_values() {
        let m = motion(1.0);
        let named = [
            m.collisions,
            m.collisions_late,
            m.impulse_n_s,
            m.double_collision_fraction,
            m.gap_deviation_rad,
            m.gap_min_rad,
            m.gap_mean_rad,
            m.sliding_m_s,
            m.speed_drop_fraction,
            m.lag_fraction,
            m.force_deviation_n,
            m.friction_w,
            m.rolling_resistance_w,
        ];
        assert_eq!(named, std::array::from_fn(|k| (k + 1) as f64));
        assert_eq!(m.values(), named);
    }

    /// Mean, standard error and difference of the starts, run by run.
    #[test]
    fn statistics_of_the_starts() {
        let runs = Statistics::new(vec![motion(1.0), motion(2.0), motion(6.0)]);
        // Deviations −2, −1, 3: 14/2 of variance, over three runs.
        let error = (7.0f64 / 3.0).sqrt();
        for k in 0..VALUES {
            let number = (k + 1) as f64;
            assert!((runs.mean.values()[k] - 3.0 * number).abs() < 1e-12);
            assert!((runs.error.values()[k] - error * number).abs() < 1e-12);
        }
        let other = Statistics::new(vec![motion(0.5), motion(1.5), motion(2.5)]);
        let less = runs.less(&other);
        let differences = [0.5, 0.5, 3.5].map(motion);
        assert_eq!(less, Statistics::new(differences.to_vec()));
        assert_eq!(Motion::mean(&[]), Motion::default());
    }

    /// Each objective is that of the worst operating point.
    #[test]
    fn objectives_are_the_worst_of_the_points() {
        let spacings = [spacing(0.030, 0.0, 1e9), spacing(0.036, 0.0, 2e9)];
        let mut motions = vec![motion(1.0), motion(2.0)];
        (motions[0].sliding_m_s, motions[0].friction_w) = (17.0, 25.0);
        let mut e = evaluation(spacings.to_vec(), motions.clone());
        e.rate();
        let objectives = e.objectives.unwrap();
        let expected = [
            ("spacing_scatter", 10.0 / 0.04),
            ("collisions_late", 4.0),
            ("used_fraction", 0.9),
            ("sliding_m_s", 17.0),
            ("stress_pa", 2e9),
            ("force_deviation_n", 22.0),
            ("friction_w", 25.0),
        ];
        for (found, (key, value)) in objectives.into_iter().zip(expected) {
            assert!((found / value - 1.0).abs() < 1e-12, "{key}: {found}");
        }
        // Unknown at a point, or rejected: not rated.
        e.motion[1] = None;
        e.objectives = None;
        e.rate();
        assert_eq!(e.objectives, None);
        e.motion[1] = Some(motions[1]);
        fail(&mut e, "stopped".to_owned(), 1);
        e.rate();
        assert_eq!(e.objectives, None);
        assert_eq!(e.rejection.as_ref().and_then(|r| r.point), Some(1));
    }

    /// Slack is that of the worst point, 0 at each limit and below zero beyond it.
    #[test]
    fn slack_is_what_is_left_of_each_limit() {
        let mut double = [Motion::default(); 2];
        (
            double[0].double_collision_fraction,
            double[1].double_collision_fraction,
        ) = (0.05, 0.2);
        let spacings = vec![spacing(0.038, 0.01, 1e9), spacing(0.034, 0.03, 1e9)];
        let e = evaluation(spacings, double.to_vec());
        let found = e.slack(&(0.8..=1.0), false);
        for (found, expected) in found.into_iter().zip([0.02, 0.05, 0.05, 0.05]) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        let beyond = evaluation(vec![spacing(0.044, 0.07, 1e9); 2], double.to_vec());
        for (found, expected) in beyond
            .slack(&(0.8..=1.0), false)
            .into_iter()
            .zip([-0.02, -0.1, 0.3, 0.05])
        {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        let mut unknown = e.clone();
        unknown.spacing[1] = None;
        assert!(unknown.slack(&(0.8..=1.0), false).iter().all(|s| *s < 0.0));
        unknown.forms = None;
        assert!(unknown.slack(&(0.8..=1.0), false).iter().all(|s| *s < 0.0));
        let mut not_run = e;
        not_run.motion = vec![None; 2];
        assert_eq!(not_run.slack(&(0.8..=1.0), false)[3], 0.0);
    }
}
