//! Contacts, spacing and force of steady operation in blocks of time.

use crate::contact_tracker::{ContactCounter, ContactCounts};
use crate::gap_scatter::GapVariance;
use crate::numerics::moments::Moments;
use crate::numerics::vector::PlaneVector;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};
use crate::summary::transient_s;

/// Blocks of the measured time.
const BLOCKS: usize = 16;
/// Forces are looked at this often, steps.
const FORCE_EVERY: u64 = 8;
/// Gaps are looked at this often, steps.
const GAPS_EVERY: u64 = 64;

/// Sums over one block of time.
#[derive(Debug, Clone, Copy, Default)]
pub struct SteadyBlock {
    /// Length, s.
    pub time_s: f64,
    /// Contacts between balls that began.
    pub contacts: ContactCounts,
    /// Impulse between balls, N·s.
    pub impulse_n_s: f64,
    /// Normal force times sliding distance between balls, N·m.
    pub force_distance_n_m: f64,
    /// Square of the gaps less their mean, rad².
    pub gap_variance: Moments,
    /// Force on the outer ring in x and y, N.
    pub force_n: [Moments; 2],
    /// Force on the outer ring along and across the direction of ball 1, N.
    pub turning_force_n: [Moments; 2],
    /// Force on the outer ring in y times cosine and sine of N times the angle of ball 1, N.
    pub passing_force_n: [Moments; 2],
}

/// Records the blocks after the transient, and the largest deflection between balls within it.
#[derive(Default)]
pub struct SteadyRecorder {
    counter: Option<ContactCounter>,
    gaps: GapVariance,
    /// The blocks.
    pub blocks: Vec<SteadyBlock>,
    from_s: f64,
    block_s: f64,
    steps: u64,
    /// Largest force between balls in the transient, N.
    pub transient_force_max_n: f64,
}

impl SteadyRecorder {
    /// Recorder of a run from its start to its end.
    pub fn new() -> Self {
        Self::default()
    }
}

impl Observer for SteadyRecorder {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.counter = Some(ContactCounter::new(context.model));
        self.gaps = GapVariance::new(context.model);
        self.blocks = vec![SteadyBlock::default(); BLOCKS];
        self.from_s = transient_s(context.case);
        self.block_s = (context.case.solver.duration_s - self.from_s) / BLOCKS as f64;
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let begun = self.counter.as_mut().and_then(|c| c.step(view));
        let (h_s, time_s) = (view.step.size_s(), view.step.t1_s);
        let touch = view.contacts.balls_touch();
        let pairs = if touch { view.contacts.balls() } else { 0 };
        let forces = (0..pairs).map(|k| (k, view.contacts.pair_force_n(k)));
        if time_s <= self.from_s {
            let forces = forces.map(|(_, force_n)| force_n);
            self.transient_force_max_n = forces.fold(self.transient_force_max_n, f64::max);
            return Ok(Control::Continue(()));
        }
        let number = (((time_s - self.from_s) / self.block_s) as usize).min(BLOCKS - 1);
        let block = &mut self.blocks[number];
        block.time_s += h_s;
        for (k, force_n) in forces.filter(|(_, force_n)| *force_n > 0.0) {
            let distance_m = h_s * view.contacts.pair_sliding_m_s(k).abs();
            block.impulse_n_s += h_s * force_n;
            block.force_distance_n_m += force_n * distance_m;
        }
        if let Some(begun) = begun {
            block.contacts += begun;
        }
        self.steps += 1;
        if self.steps.is_multiple_of(FORCE_EVERY) {
            block.look_at_force(view);
        }
        if self.steps.is_multiple_of(GAPS_EVERY) {
            let variance = self.gaps.of(view.positions(), view.outer_ring_m());
            block.gap_variance.add(variance, 1.0);
        }
        Ok(Control::Continue(()))
    }
}

impl SteadyBlock {
    #[inline(never)]
    fn look_at_force(&mut self, view: &StepView<'_>) {
        let [fx, fy] = view.contacts.outer_ring_force_n();
        let PlaneVector { x, y } = view.about_outer_ring_m(0);
        let distance = x.hypot(y);
        let (ex, ey) = (x / distance, y / distance);
        let (mut cosine, mut sine) = (1.0, 0.0);
        for _ in 0..view.layout().row {
            (cosine, sine) = (cosine * ex - sine * ey, sine * ex + cosine * ey);
        }
        for (moments, [one, other]) in [
            (&mut self.force_n, [fx, fy]),
            (
                &mut self.turning_force_n,
                [fx * ex + fy * ey, fy * ex - fx * ey],
            ),
            (&mut self.passing_force_n, [fy * cosine, fy * sine]),
        ] {
            moments[0].add(one, 1.0);
            moments[1].add(other, 1.0);
        }
    }
}
