//! Headline numbers of a run.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::{Control, run};
//! use cageless::summary::SummaryRecorder;
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let mut recorder = SummaryRecorder::new();
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! let summary = recorder.summary().unwrap();
//! assert!(summary.gap_min_rad < summary.gap_max_rad);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::case::Case;
use crate::contact_peaks::ContactPeakTracker;
use crate::contact_tracker::{ContactCounter, ContactCounts};
use crate::creep_mean::CreepMean;
use crate::dynamics::coordinates::RingCoordinate;
use crate::gap::GapRange;
use crate::gap_scatter::GapScatter;
use crate::half_turn::HalfTurnTracker;
use crate::numerics::lanes::larger;
use crate::numerics::moments::Moments;
use crate::orbit_means::{OrbitMeans, OrbitMeansTracker};
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};
use crate::spatial_summary::{SpatialSummary, SpatialSummaryTracker};

pub use crate::contact_peaks::{ContactPeak, ContactPeaks};

/// Headline numbers over the part of a run after [`Self::settled_after_s`].
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// End of the discarded transient, s.
    pub settled_after_s: f64,
    /// Contacts between balls that began.
    pub collisions: ContactCounts,
    /// Smallest gap.
    pub gap_min_rad: f64,
    /// Largest gap.
    pub gap_max_rad: f64,
    /// Standard deviation of the gaps of all balls, over the whole part.
    pub gap_deviation_rad: f64,
    /// Standard deviation of the gaps in the second half of the part less that in the first; NaN
    /// of a part that ended before its second half.
    pub gap_deviation_change_rad: f64,
    /// Standard deviation of the force of the balls on the outer ring, both directions together.
    pub outer_ring_force_deviation_n: f64,
    /// Mean of the ring's centre.
    pub ring_x_mean_m: f64,
    /// Mean of the ring's centre.
    pub ring_y_mean_m: f64,
    /// Largest |ΔVi| or |ΔVo| at a raceway contact that carries load.
    pub sliding_max_m_s: f64,
    /// Peak loads of the contacts.
    pub peaks: ContactPeaks,
    /// Mean powers and speeds; `None` for a part of a few steps.
    pub means: Option<OrbitMeans>,
    /// Lag of the balls against rolling over the half of their orbit away from the load, with a film.
    pub half_turn_lag_rad: Option<f64>,
    /// Mean of the regularisation speeds of the contacts under load, over time; `None` where the speed is given.
    pub regularisation_speed_mean_m_s: Option<f64>,
    /// Numbers of a run in space.
    pub space: Option<SpatialSummary>,
}

/// Ball orbits that are left out at the start.
pub const TRANSIENT_TURNS: f64 = 2.0;
/// Gaps are looked at this often, steps: below 0.5 m/s between neighbours they change by
/// less than 0.01° in 8 steps of 1 µs.
const GAPS_EVERY: u64 = 8;
/// The scatter of the gaps, which changes over orbits, is looked at this often, steps.
const SCATTER_EVERY: u64 = 64;
/// Contacts with the raceways are looked at this often, s, whatever the step, at each where it is longer: the forces
/// of impacts, which last 30 µs and more, change by less than 3 % within half of it from their peak,
/// pressures by less than 1 %.
const LOADS_EVERY_S: f64 = 4e-6;

/// The part of a run that is left out as transient: that of the case, or two orbits of the balls, at most half
/// the run. Nothing is left out where speed or load change: all of it is transient.
pub fn transient_s(case: &Case) -> f64 {
    case.solver.transient_s.unwrap_or_else(|| {
        if !case.has_constant_operation() {
            return 0.0;
        }
        (TRANSIENT_TURNS * case.rolling_orbit_s()).min(case.solver.duration_s / 2.0)
    })
}

/// Gathers a [`Summary`].
#[derive(Default)]
pub struct SummaryRecorder {
    case: Option<Case>,
    settled_after_s: f64,
    gaps: GapRange,
    scatter: GapScatter,
    outer_ring_force: [Moments; 2],
    /// Time since contacts with the raceways were looked at, s.
    since_loads_s: f64,
    steps: u64,
    collisions: ContactCounts,
    ring_sum: [f64; 2],
    time: f64,
    slip_max: f64,
    contact_counter: Option<ContactCounter>,
    peaks: Option<ContactPeakTracker>,
    means: OrbitMeansTracker,
    half_turn: Option<HalfTurnTracker>,
    creep: Option<CreepMean>,
    space: Option<SpatialSummaryTracker>,
    /// σ of the row of every ball.
    contact_signs: Vec<f64>,
}

impl SummaryRecorder {
    /// Leaves out [`transient_s`].
    pub fn new() -> Self {
        Self::default()
    }

    /// The numbers so far; `None` before the end of the transient.
    pub fn summary(&self) -> Option<Summary> {
        let (case, peaks) = (self.case.as_ref()?, self.peaks.as_ref()?);
        (self.time > 0.0).then(|| Summary {
            settled_after_s: self.settled_after_s,
            collisions: self.collisions,
            gap_min_rad: self.gaps.range_rad()[0],
            gap_max_rad: self.gaps.range_rad()[1],
            gap_deviation_rad: self.scatter.deviation_rad(),
            gap_deviation_change_rad: self.scatter.change_rad(),
            outer_ring_force_deviation_n: {
                let [x, y] = self.outer_ring_force.map(|force| force.deviation());
                x.hypot(y)
            },
            ring_x_mean_m: self.ring_sum[0] / self.time,
            ring_y_mean_m: self.ring_sum[1] / self.time,
            sliding_max_m_s: self.slip_max,
            peaks: peaks.peaks(case),
            means: self.means.means(case),
            half_turn_lag_rad: self.half_turn.as_ref().and_then(HalfTurnTracker::lag_rad),
            regularisation_speed_mean_m_s: self.creep.as_ref().and_then(CreepMean::mean_m_s),
            space: (self.space.as_ref())
                .and_then(|space| space.summary(peaks.ellipse_edge_max_rad())),
        })
    }
}

impl Observer for SummaryRecorder {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        let case = context.case;
        self.settled_after_s = transient_s(case);
        self.gaps = GapRange::new(context.model);
        self.contact_counter = Some(ContactCounter::new(context.model));
        let end_s = case.solver.duration_s;
        self.scatter = GapScatter::new(context.model, self.settled_after_s, end_s);
        self.peaks = Some(ContactPeakTracker::new(case));
        self.space = SpatialSummaryTracker::new(case, context.start);
        self.half_turn = HalfTurnTracker::new(case);
        self.creep = CreepMean::new(case);
        let rows = case.all_rows();
        self.contact_signs = (0..case.balls())
            .map(|k| rows[k / case.bearing.balls()].contact_sign)
            .collect();
        self.case = Some(case.clone());
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let contacts = &view.contacts;
        let counted = view.step.t1_s > self.settled_after_s;
        let counter = self.contact_counter.as_mut();
        let begun = counter.and_then(|counter| counter.step(view));
        if !counted {
            return Ok(Control::Continue(()));
        }
        if let Some(begun) = begun {
            self.collisions += begun;
        }
        let (layout, step) = (view.layout(), view.step);
        let h = step.size_s();
        for (sum, coordinate) in
            (self.ring_sum.iter_mut()).zip([RingCoordinate::X, RingCoordinate::Y])
        {
            let at = layout.ring(coordinate);
            *sum += 0.5 * h * (step.y0[at] + step.y1[at]);
        }
        self.time += h;
        if let Some(space) = &mut self.space {
            space.step(view);
        }
        self.slip_max = larger(self.slip_max, contacts.sliding_max_m_s());
        self.since_loads_s += h;
        // Half a step early rather than late, and no matter how the sum has been rounded.
        if self.since_loads_s + 0.5 * h > LOADS_EVERY_S {
            let since_s = std::mem::take(&mut self.since_loads_s);
            self.look_at_loads(view, since_s);
        }
        if contacts.balls_touch()
            && let (Some(peaks), Some(case)) = (&mut self.peaks, &self.case)
        {
            peaks.look_between_balls(contacts, view.inner_speed_ratio(case));
        }
        let sampled = self.steps.is_multiple_of(GAPS_EVERY);
        self.means.step(view, sampled);
        if sampled {
            self.look_at_gaps(view);
        }
        if let Some(half_turn) = &mut self.half_turn {
            half_turn.step(view);
        }
        self.steps += 1;
        Ok(Control::Continue(()))
    }
}

impl SummaryRecorder {
    /// Takes the contacts with the raceways, this long after the last time.
    #[inline(never)] // most steps do without, as without the next
    fn look_at_loads(&mut self, view: &StepView<'_>, since_s: f64) {
        let contacts = &view.contacts;
        if let Some(space) = &mut self.space {
            space.look(contacts, &self.contact_signs);
        }
        let force_n = contacts.outer_ring_force_n();
        for (moments, force_n) in self.outer_ring_force.iter_mut().zip(force_n) {
            moments.add(force_n, since_s);
        }
        if let (Some(peaks), Some(case)) = (&mut self.peaks, &self.case) {
            let speed_ratio = view.inner_speed_ratio(case);
            peaks.look(contacts, speed_ratio);
            if let Some(creep) = &mut self.creep {
                creep.look(contacts, speed_ratio, since_s);
            }
        }
    }

    /// Takes the places of the balls at the end of a step.
    #[inline(never)]
    fn look_at_gaps(&mut self, view: &StepView<'_>) {
        let (balls_m, centre_m) = (view.positions(), view.outer_ring_m());
        self.gaps.look(balls_m, centre_m);
        if self.steps.is_multiple_of(SCATTER_EVERY) {
            self.scatter.look(view.step.t1_s, balls_m, centre_m);
        }
    }
}
