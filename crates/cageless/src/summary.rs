//! Headline numbers of a run.

use std::f64::consts::TAU;

use crate::case::Case;
use crate::kinematics::rolling_orbit_speed_rad_s;
use crate::simulation::{Control, Observer, ObserverError, Scene, View};
use crate::spacing::gap_rad;

/// Headline numbers over the part of a run after [`Self::settled_after_s`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// What came before is left out as transient.
    pub settled_after_s: f64,
    /// Contacts between balls that began.
    pub collisions: u64,
    /// Smallest gap.
    pub gap_min_rad: f64,
    /// Largest gap.
    pub gap_max_rad: f64,
    /// Mean of the ring's centre.
    pub ring_x_mean_m: f64,
    /// Mean of the ring's centre.
    pub ring_y_mean_m: f64,
    /// Largest |ΔVi| or |ΔVo| at a raceway contact that carries load.
    pub slip_max_m_s: f64,
}

/// Ball orbits that are left out at the start.
const TRANSIENT_TURNS: f64 = 2.0;
/// Gaps are looked at this often, steps: below 0.5 m/s between neighbours they change by
/// less than 0.01° in 8 steps of 1 µs.
const GAPS_EVERY: u64 = 8;

/// The part of a run that is left out as transient: two orbits of the balls, at most half
/// the run.
pub fn transient_s(case: &Case) -> f64 {
    let orbit = rolling_orbit_speed_rad_s(
        &case.bearing,
        case.operation.inner_speed_rad_s,
        case.bearing.ball_radius_m(),
    );
    (TRANSIENT_TURNS * TAU / orbit).min(case.solver.duration_s / 2.0)
}

/// Gathers a [`Summary`].
pub struct SummaryRecorder {
    settled_after_s: f64,
    ball_angle: f64,
    steps: u64,
    collisions: u64,
    gap_range: [f64; 2],
    ring_sum: [f64; 2],
    time: f64,
    slip_max: f64,
    touching: Vec<bool>,
}

impl SummaryRecorder {
    /// Leaves out [`transient_s`].
    pub fn new() -> Self {
        Self {
            settled_after_s: 0.0,
            ball_angle: 0.0,
            steps: 0,
            collisions: 0,
            gap_range: [f64::INFINITY, f64::NEG_INFINITY],
            ring_sum: [0.0; 2],
            time: 0.0,
            slip_max: 0.0,
            touching: vec![],
        }
    }

    /// The numbers so far; `None` before the end of the transient.
    pub fn summary(&self) -> Option<Summary> {
        (self.time > 0.0).then(|| Summary {
            settled_after_s: self.settled_after_s,
            collisions: self.collisions,
            gap_min_rad: self.gap_range[0],
            gap_max_rad: self.gap_range[1],
            ring_x_mean_m: self.ring_sum[0] / self.time,
            ring_y_mean_m: self.ring_sum[1] / self.time,
            slip_max_m_s: self.slip_max,
        })
    }
}

impl Default for SummaryRecorder {
    fn default() -> Self {
        Self::new()
    }
}

impl Observer for SummaryRecorder {
    fn begin(&mut self, scene: &Scene<'_>) -> Result<(), ObserverError> {
        let case = scene.case;
        self.settled_after_s = transient_s(case);
        self.ball_angle = case.bearing.ball_angle_rad();
        self.touching = vec![false; scene.model.balls()];
        Ok(())
    }

    fn step(&mut self, view: &View<'_, '_>) -> Result<Control, ObserverError> {
        let (_, deflections, _) = view.rhs.pairs();
        let counted = view.step.to_s > self.settled_after_s;
        for (touching, deflection) in self.touching.iter_mut().zip(deflections) {
            let now = *deflection > 0.0;
            self.collisions += u64::from(counted && now && !*touching);
            *touching = now;
        }
        if !counted {
            return Ok(Control::Continue);
        }
        let layout = view.layout();
        let n = layout.balls;
        let h = view.step.to_s - view.step.from_s;
        let at = layout.ring();
        for k in 0..2 {
            self.ring_sum[k] += 0.5 * h * (view.step.before[at + k] + view.step.after[at + k]);
        }
        self.time += h;
        let (inner, outer) = view.rhs.slips();
        let (inner_force, outer_force) = view.rhs.normal_forces();
        for (slips, forces) in [(inner, inner_force), (outer, outer_force)] {
            for (slip, force) in slips.iter().zip(forces) {
                if *force > 0.0 {
                    self.slip_max = self.slip_max.max(slip.abs());
                }
            }
        }
        if self.steps.is_multiple_of(GAPS_EVERY) {
            let (x, y) = (
                &view.step.after[..n],
                &view.step.after[layout.group(1)..][..n],
            );
            for k in 0..n {
                let gap = gap_rad(x, y, k, self.ball_angle);
                self.gap_range = [self.gap_range[0].min(gap), self.gap_range[1].max(gap)];
            }
        }
        self.steps += 1;
        Ok(Control::Continue)
    }
}
