//! Passages of the balls through the discrete raceways.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! use cageless::passage::{PassageRecorder, PassageTally};
//! use cageless::simulation::{Control, run};
//!
//! let case = common::structure(5.1, 25.2); // Zhao 2022, Table 2, structure (d)
//!
//! let mut tally = PassageTally::new();
//! let mut recorder = PassageRecorder::new(|passage| {
//!     tally.add(&passage);
//!     Ok(())
//! });
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! assert!(tally.count > 10); // in 20 ms
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::contact_tracker::ContactTracker;
use crate::dynamics::coordinates::BallCoordinate;
use crate::gap::Direction;
use crate::numerics::root;
use crate::raceway::Raceway;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};

/// One ball through one raceway.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    /// Index (from 0) of the ball.
    pub ball: usize,
    /// Index (from 0) of the raceway.
    pub raceway: usize,
    /// Time at which the ball enters; like [`Self::leave_s`] located within the step.
    pub enter_s: f64,
    /// Time at which the ball leaves.
    pub leave_s: f64,
    /// Gap to the ball ahead on coming in.
    pub gap_enter_rad: f64,
    /// Gap of the ball behind on coming in: what the critical gap is to be compared with.
    pub gap_behind_rad: f64,
    /// Smallest gap to the ball ahead while inside.
    pub gap_min_rad: f64,
    /// Gap to the ball ahead on going out.
    pub gap_leave_rad: f64,
    /// Contacts with the ball ahead that began while inside.
    pub collisions_ahead: u32,
    /// Contacts with the ball behind that began while inside.
    pub collisions_behind: u32,
    /// Largest |ΔVi| or |ΔVo| while inside.
    pub sliding_max_m_s: f64,
    /// Largest and smallest orbital speed while inside.
    pub orbit_speed_range_rad_s: [f64; 2],
}

/// Sums over passages, accumulated one by one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassageTally {
    /// Number of samples or passages.
    pub count: u64,
    sums: [f64; 6],
    /// Largest and smallest gap to the ball ahead on going out.
    pub gap_leave_range_rad: [f64; 2],
}

impl PassageTally {
    /// Tally without passages.
    pub fn new() -> Self {
        Self {
            count: 0,
            sums: [0.0; 6],
            gap_leave_range_rad: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    /// Adds a passage.
    pub fn add(&mut self, p: &Passage) {
        self.count += 1;
        let twice = p.collisions_ahead > 0 && p.collisions_behind > 0;
        let values = [
            p.leave_s - p.enter_s,
            f64::from(p.collisions_ahead + p.collisions_behind),
            f64::from(u8::from(twice)),
            p.sliding_max_m_s,
            p.gap_min_rad,
            p.orbit_speed_range_rad_s[0],
        ];
        for (sum, value) in self.sums.iter_mut().zip(values) {
            *sum += value;
        }
        let [low, high] = self.gap_leave_range_rad;
        self.gap_leave_range_rad = [low.min(p.gap_leave_rad), high.max(p.gap_leave_rad)];
    }

    fn mean(&self, k: usize) -> f64 {
        self.sums[k] / self.count as f64
    }

    /// Mean time inside; like all means NaN without passages.
    pub fn duration_mean_s(&self) -> f64 {
        self.mean(0)
    }

    /// Mean number of contacts with either neighbour that began inside.
    pub fn collisions_mean(&self) -> f64 {
        self.mean(1)
    }

    /// Fraction of the passages in which both neighbours hit.
    pub fn double_collision_fraction(&self) -> f64 {
        self.mean(2)
    }

    /// Mean over the passages of the largest |ΔVi| or |ΔVo| in each.
    pub fn sliding_mean_m_s(&self) -> f64 {
        self.mean(3)
    }

    /// Mean of the smallest gap ahead in each.
    pub fn gap_min_mean_rad(&self) -> f64 {
        self.mean(4)
    }

    /// Mean of the smallest orbital speed in each.
    pub fn lowest_orbit_speed_mean_rad_s(&self) -> f64 {
        self.mean(5)
    }
}

impl Default for PassageTally {
    fn default() -> Self {
        Self::new()
    }
}

/// The part of the turn that a raceway takes up.
#[derive(Debug, Clone, Copy)]
struct RacewaySector {
    sin_centre: f64,
    cos_centre: f64,
    cos_half: f64,
}

impl RacewaySector {
    fn new(raceway: &Raceway) -> Self {
        let d = raceway.dimensions();
        let (sin_centre, cos_centre) = d.centre_angle_rad.sin_cos();
        Self {
            sin_centre,
            cos_centre,
            cos_half: d.half_angle_rad.cos(),
        }
    }

    /// |rb|·(cos(ψ − centre) − cos θ): above zero inside, with ψ from −Y.
    fn inside_by(&self, x: f64, y: f64) -> f64 {
        x * self.sin_centre - y * self.cos_centre - self.cos_half * (x * x + y * y).sqrt()
    }

    /// Whether a ball is inside; without a root for the half turn away from a raceway.
    fn is_inside(&self, x: f64, y: f64) -> bool {
        let along = x * self.sin_centre - y * self.cos_centre;
        (along > 0.0 || self.cos_half < 0.0) && self.inside_by(x, y) > 0.0
    }
}

/// A passage, and where the ball was nearest to the one ahead.
#[derive(Debug, Clone, Copy)]
struct UnderWay {
    passage: Passage,
    nearest: Direction,
}

/// Follows the balls through the raceways and passes each passage on when the ball goes
/// out; one counts when the ball has come in and gone out during the run.
pub struct PassageRecorder<F> {
    sectors: Vec<RacewaySector>,
    pair_angles: Vec<f64>,
    /// The passage under way of each ball through each raceway.
    inside: Vec<Option<UnderWay>>,
    /// Balls that start inside a raceway are let out first.
    seen_outside: Vec<bool>,
    contact_tracker: ContactTracker,
    sink: F,
}

impl<F: FnMut(Passage) -> Result<(), ObserverError>> PassageRecorder<F> {
    /// Passes each passage to `sink` when it ends.
    pub fn new(sink: F) -> Self {
        Self {
            sectors: vec![],
            pair_angles: vec![],
            inside: vec![],
            seen_outside: vec![],
            contact_tracker: ContactTracker::new(0),
            sink,
        }
    }

    /// When ball `k` crosses the end of a raceway within the step, and the angle to the ball
    /// ahead and that from the ball behind there.
    fn end(
        &self,
        view: &StepView<'_, '_>,
        k: usize,
        sector: &RacewaySector,
    ) -> (f64, [Direction; 2]) {
        let layout = view.layout();
        let (from, to) = (view.step.t0_s, view.step.t1_s);
        let inside_by = |time_s: f64| {
            let at = |coordinate| view.step.interpolate(layout.ball(coordinate, k), time_s);
            let [x, y] = view.outer_ring_at_m(time_s);
            sector.inside_by(at(BallCoordinate::X) - x, at(BallCoordinate::Y) - y)
        };
        let time_s = root::brent(inside_by, from, to, 1e-6 * (to - from)).unwrap_or(to);
        let state = view.state(time_s);
        let [x, y] = [BallCoordinate::X, BallCoordinate::Y]
            .map(|c| state.layout().balls_of(state.values(), c));
        let previous = (k + layout.balls - 1) % layout.balls;
        let centre = state.outer_ring_motion();
        let to_next = |k| Direction::to_next(x, y, [centre.x, centre.y], k);
        (time_s, [k, previous].map(to_next))
    }
}

impl<F: FnMut(Passage) -> Result<(), ObserverError>> Observer for PassageRecorder<F> {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        let n = context.model.balls();
        self.sectors = context
            .case
            .raceways
            .iter()
            .map(RacewaySector::new)
            .collect();
        self.pair_angles = (0..n).map(|k| context.model.pair_angle_rad(k)).collect();
        self.inside = vec![None; n * self.sectors.len()];
        self.seen_outside = vec![false; n * self.sectors.len()];
        self.contact_tracker = ContactTracker::new(n);
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        let n = view.layout().balls;
        let [x, y] = view.positions();
        let centre = view.outer_ring_m();
        let c = &view.contacts;
        self.contact_tracker.update(c);
        for (r, sector) in self.sectors.iter().enumerate() {
            for k in 0..n {
                let slot = r * n + k;
                if !sector.is_inside(x[k] - centre[0], y[k] - centre[1]) {
                    self.seen_outside[slot] = true;
                    if let Some(UnderWay {
                        mut passage,
                        nearest,
                    }) = self.inside[slot].take()
                    {
                        let (leave_s, [leave, _]) = self.end(view, k, sector);
                        let pair_angle = self.pair_angles[k];
                        passage.leave_s = leave_s;
                        passage.gap_leave_rad = leave.gap_rad(pair_angle);
                        let least = passage.gap_enter_rad.min(passage.gap_leave_rad);
                        passage.gap_min_rad = least.min(nearest.gap_rad(pair_angle));
                        (self.sink)(passage)?;
                    }
                    continue;
                }
                if !self.seen_outside[slot] {
                    continue;
                }
                let previous = if k == 0 { n - 1 } else { k - 1 };
                let now = Direction::to_next(x, y, centre, k);
                let orbit = c.orbit_speed_rad_s(k);
                // A contact without load may slide as it likes.
                let slip = |slip: f64, force: f64| if force > 0.0 { slip.abs() } else { 0.0 };
                let slip = slip(c.inner_sliding_m_s(k), c.inner_force_n(k))
                    .max(slip(c.outer_sliding_m_s(k), c.outer_force_n(k)));
                if self.inside[slot].is_none() {
                    let (enter_s, [ahead, behind]) = self.end(view, k, sector);
                    let gap = ahead.gap_rad(self.pair_angles[k]);
                    self.inside[slot] = Some(UnderWay {
                        passage: Passage {
                            ball: k,
                            raceway: r,
                            enter_s,
                            leave_s: enter_s,
                            gap_enter_rad: gap,
                            gap_behind_rad: behind.gap_rad(self.pair_angles[previous]),
                            gap_min_rad: gap,
                            gap_leave_rad: gap,
                            collisions_ahead: 0,
                            collisions_behind: 0,
                            sliding_max_m_s: 0.0,
                            orbit_speed_range_rad_s: [orbit, orbit],
                        },
                        nearest: now,
                    });
                }
                let Some(UnderWay { passage, nearest }) = &mut self.inside[slot] else {
                    continue;
                };
                if now.below(*nearest) {
                    *nearest = now;
                }
                passage.collisions_ahead += u32::from(self.contact_tracker.started(k));
                passage.collisions_behind += u32::from(self.contact_tracker.started(previous));
                passage.sliding_max_m_s = passage.sliding_max_m_s.max(slip);
                let [low, high] = passage.orbit_speed_range_rad_s;
                passage.orbit_speed_range_rad_s = [low.min(orbit), high.max(orbit)];
            }
        }
        Ok(Control::Continue(()))
    }
}

#[cfg(test)]
mod tests {
    use super::{Passage, PassageTally};

    fn passage(number: f64, [collisions_ahead, collisions_behind]: [u32; 2]) -> Passage {
        Passage {
            ball: 0,
            raceway: 0,
            enter_s: 1.0,
            leave_s: 1.0 + 2.0 * number,
            gap_enter_rad: 3.0 * number,
            gap_behind_rad: 4.0 * number,
            gap_min_rad: 5.0 * number,
            gap_leave_rad: 6.0 * number,
            collisions_ahead,
            collisions_behind,
            sliding_max_m_s: 7.0 * number,
            orbit_speed_range_rad_s: [8.0 * number, 9.0 * number],
        }
    }

    /// Two contacts with the same neighbour are no hits from both sides.
    #[test]
    fn hits_from_both_sides_need_both_neighbours() {
        let fraction = |hits: [[u32; 2]; 2]| {
            let mut tally = PassageTally::new();
            for hits in hits {
                tally.add(&passage(1.0, hits));
            }
            tally.double_collision_fraction()
        };
        assert_eq!(fraction([[2, 0], [0, 3]]), 0.0);
        assert_eq!(fraction([[1, 1], [2, 0]]), 0.5);
    }

    #[test]
    fn every_mean_is_that_of_its_number() {
        let mut tally = PassageTally::new();
        assert!(tally.duration_mean_s().is_nan());
        tally.add(&passage(1.0, [3, 0]));
        tally.add(&passage(3.0, [1, 4]));
        assert_eq!(tally.count, 2);
        assert_eq!(tally.duration_mean_s(), 4.0);
        assert_eq!(tally.collisions_mean(), 4.0);
        assert_eq!(tally.double_collision_fraction(), 0.5);
        assert_eq!(tally.gap_min_mean_rad(), 10.0);
        assert_eq!(tally.sliding_mean_m_s(), 14.0);
        assert_eq!(tally.lowest_orbit_speed_mean_rad_s(), 16.0);
        assert_eq!(tally.gap_leave_range_rad, [6.0, 18.0]);
    }
}
