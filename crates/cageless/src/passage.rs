//! How each ball passes each discrete raceway.

use crate::raceway::Raceway;
use crate::simulation::{Control, Observer, ObserverError, Scene, View};
use crate::spacing::gap_rad;

/// One ball through one raceway.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    /// Index (from 0) of the ball.
    pub ball: usize,
    /// Index (from 0) of the raceway.
    pub raceway: usize,
    /// When it came in.
    pub enter_s: f64,
    /// When it went out.
    pub leave_s: f64,
    /// Gap to the ball ahead on coming in.
    pub gap_enter_rad: f64,
    /// Smallest gap to the ball ahead while inside.
    pub gap_min_rad: f64,
    /// Gap to the ball ahead on going out.
    pub gap_leave_rad: f64,
    /// Contacts with the ball ahead that began while inside.
    pub collisions_ahead: u32,
    /// Contacts with the ball behind that began while inside.
    pub collisions_behind: u32,
    /// Largest |ΔVi| or |ΔVo| while inside.
    pub slip_max_m_s: f64,
    /// Largest and smallest orbital speed while inside.
    pub orbit_speed_range_rad_s: [f64; 2],
}

/// Follows the balls through the raceways; a passage counts when the ball has come in
/// and gone out during the run.
pub struct PassageRecorder {
    raceways: Vec<Raceway>,
    pair_angles: Vec<f64>,
    /// The passage under way of each ball through each raceway.
    inside: Vec<Option<Passage>>,
    /// Balls that start inside a raceway are let out first.
    seen_outside: Vec<bool>,
    touching: Vec<bool>,
    /// What was found.
    pub passages: Vec<Passage>,
}

impl PassageRecorder {
    /// An empty record.
    pub fn new() -> Self {
        Self {
            raceways: vec![],
            pair_angles: vec![],
            inside: vec![],
            seen_outside: vec![],
            touching: vec![],
            passages: vec![],
        }
    }
}

impl Default for PassageRecorder {
    fn default() -> Self {
        Self::new()
    }
}

impl Observer for PassageRecorder {
    fn begin(&mut self, scene: &Scene<'_>) -> Result<(), ObserverError> {
        let n = scene.model.balls();
        self.raceways = scene.case.raceways.clone();
        self.pair_angles = (0..n).map(|k| scene.model.pair_angle_rad(k)).collect();
        self.inside = vec![None; n * self.raceways.len()];
        self.seen_outside = vec![false; n * self.raceways.len()];
        self.touching = vec![false; n];
        Ok(())
    }

    fn step(&mut self, view: &View<'_, '_>) -> Result<Control, ObserverError> {
        let n = view.layout().balls;
        let (x, y) = (view.after(0), view.after(1));
        let c = &view.contacts;
        for k in 0..n {
            let previous = (k + n - 1) % n;
            let begun =
                |pair: usize| u32::from(c.pair_deflection_m(pair) > 0.0 && !self.touching[pair]);
            let (ahead, behind) = (begun(k), begun(previous));
            let angle = x[k].atan2(-y[k]);
            for (r, raceway) in self.raceways.iter().enumerate() {
                let slot = k * self.raceways.len() + r;
                if !raceway.contains(angle) {
                    self.seen_outside[slot] = true;
                    if let Some(mut passage) = self.inside[slot].take() {
                        passage.leave_s = view.step.to_s;
                        self.passages.push(passage);
                    }
                    continue;
                }
                if !self.seen_outside[slot] {
                    continue;
                }
                let gap = gap_rad(x, y, k, self.pair_angles[k]);
                let orbit = c.orbit_speed_rad_s(k);
                // A contact without load may slide as it likes.
                let slip = |slip: f64, force: f64| if force > 0.0 { slip.abs() } else { 0.0 };
                let slip = slip(c.inner_slip_m_s(k), c.inner_force_n(k))
                    .max(slip(c.outer_slip_m_s(k), c.outer_force_n(k)));
                let passage = self.inside[slot].get_or_insert(Passage {
                    ball: k,
                    raceway: r,
                    enter_s: view.step.to_s,
                    leave_s: view.step.to_s,
                    gap_enter_rad: gap,
                    gap_min_rad: gap,
                    gap_leave_rad: gap,
                    collisions_ahead: 0,
                    collisions_behind: 0,
                    slip_max_m_s: 0.0,
                    orbit_speed_range_rad_s: [orbit, orbit],
                });
                passage.gap_min_rad = passage.gap_min_rad.min(gap);
                passage.gap_leave_rad = gap;
                passage.collisions_ahead += ahead;
                passage.collisions_behind += behind;
                passage.slip_max_m_s = passage.slip_max_m_s.max(slip);
                let [low, high] = passage.orbit_speed_range_rad_s;
                passage.orbit_speed_range_rad_s = [low.min(orbit), high.max(orbit)];
            }
        }
        for (k, touching) in self.touching.iter_mut().enumerate() {
            *touching = c.pair_deflection_m(k) > 0.0;
        }
        Ok(Control::Continue)
    }
}
