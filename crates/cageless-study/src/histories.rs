//! The histories of a run, decimated as they grow.

use std::collections::VecDeque;
use std::sync::Arc;

use cageless::Case;
use cageless::Snapshot;
use cageless::collision::Collision;
use cageless::min_max_decimator::MinMaxDecimator;
use serde::{Deserialize, Serialize};

/// One contact of two neighbouring balls.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct CollisionPoint {
    /// Start, s.
    pub time_s: f64,
    /// Number of the ball behind, from 1.
    pub ball: usize,
    /// Number of the ball ahead, from 1.
    pub next_ball: usize,
    /// ψ halfway between the two, degrees, −180 to 180.
    pub angle_deg: f64,
    /// Speed of approach, m/s.
    pub approach_speed_m_s: f64,
    /// Largest normal force, N.
    pub peak_force_n: f64,
    /// Impulse, N·s.
    pub impulse_n_s: f64,
}

/// Sampling of vibration signals, as in the paper's experiment.
pub const SAMPLING_HZ: f64 = 5000.0;

/// Most rows of the histories, for up to 14 balls; fewer for more.
const ROWS: usize = 8000;
/// Most of the last snapshots that are kept one by one.
const RECENT: usize = 2500;
/// Collisions that are kept at least, the strongest.
const COLLISIONS: usize = 4000;

/// Histories for the figures of a run, decimated as it grows: memory does not depend on
/// the length of the run.
#[derive(Clone)]
pub struct Histories {
    interval_s: f64,
    rows: MinMaxDecimator<Arc<[f64]>>,
    recent: VecDeque<Arc<[f64]>>,
    collisions: Vec<CollisionPoint>,
    collisions_seen: usize,
}

impl Histories {
    /// Empty histories of a run of `case` with a row each `interval_s`.
    pub fn new(case: &Case, interval_s: f64) -> Self {
        let balls = case.balls();
        Self {
            interval_s,
            rows: MinMaxDecimator::new((ROWS * 14 / balls).min(ROWS)),
            recent: VecDeque::new(),
            collisions: vec![],
            collisions_seen: 0,
        }
    }

    /// Takes a snapshot.
    pub fn push(&mut self, snapshot: &Snapshot) {
        let row = snapshot.to_row();
        if self.recent.len() == RECENT {
            self.recent.pop_front();
        }
        self.recent.push_back(Arc::clone(&row));
        self.rows.push(row);
    }

    /// Takes a collision.
    pub fn collide(&mut self, c: &Collision) {
        self.collisions_seen += 1;
        self.collisions.push(CollisionPoint {
            time_s: c.start_s,
            ball: c.ball + 1,
            next_ball: c.next_ball + 1,
            angle_deg: c.angle_rad.to_degrees(),
            approach_speed_m_s: c.approach_speed_m_s,
            peak_force_n: c.peak_force_n,
            impulse_n_s: c.impulse_n_s,
        });
        if self.collisions.len() == 2 * COLLISIONS {
            let weaker =
                |a: &CollisionPoint, b: &CollisionPoint| b.impulse_n_s.total_cmp(&a.impulse_n_s);
            self.collisions.select_nth_unstable_by(COLLISIONS, weaker);
            self.collisions.truncate(COLLISIONS);
        }
    }

    /// The histories once the run has ended.
    pub fn finish(self) -> RunHistories {
        let stretch = self.rows.stretch();
        let of_row = |row: &Arc<[f64]>| Snapshot::from_row(row);
        RunHistories {
            stretch_s: (stretch > 1).then_some(stretch as f64 * self.interval_s),
            snapshots: self.rows.into_rows().iter().map(of_row).collect(),
            recent: self.recent.iter().map(of_row).collect(),
            collisions: self.collisions,
            collisions_total: self.collisions_seen,
        }
    }
}

/// The histories of a run that has ended.
#[derive(Debug, Clone)]
pub struct RunHistories {
    /// Snapshots of the whole run; of a long run, those with the lowest and the highest values
    /// of each stretch.
    pub snapshots: Vec<Snapshot>,
    /// Length of a stretch of a decimated history, s; `None` if every snapshot was kept.
    pub stretch_s: Option<f64>,
    /// The last snapshots, undecimated.
    pub recent: Vec<Snapshot>,
    /// Contacts between balls, of too many the strongest.
    pub collisions: Vec<CollisionPoint>,
    /// Number of contacts between balls.
    pub collisions_total: usize,
}

#[cfg(test)]
mod tests {
    use super::*;
    use cageless_io::case_file::{CaseFile, template};

    fn histories() -> Histories {
        let file = CaseFile::parse(&template(false), "case.toml", &[]).unwrap();
        Histories::new(file.case(), file.particulars().interval_s)
    }

    fn collision(impulse_n_s: f64) -> Collision {
        Collision {
            start_s: 2.0 * impulse_n_s,
            duration_s: 3.0,
            ball: 12,
            next_ball: 13,
            angle_rad: 0.5,
            approach_speed_m_s: 4.0,
            peak_force_n: 5.0,
            impulse_n_s,
        }
    }

    /// Beyond the limit the strongest collisions are kept, and all are counted.
    #[test]
    fn the_strongest_collisions_stay() {
        let mut all = histories();
        let count = 3 * COLLISIONS + 17;
        // 0 to count − 1 in another order: 7919 is prime.
        for k in 0..count {
            all.collide(&collision((7919 * k % count) as f64));
        }
        let found = all.finish();
        assert_eq!(found.collisions_total, count);
        assert!((COLLISIONS..2 * COLLISIONS).contains(&found.collisions.len()));
        let kept: std::collections::HashSet<u64> = (found.collisions.iter())
            .map(|c| c.impulse_n_s as u64)
            .collect();
        assert!((count - COLLISIONS..count).all(|k| kept.contains(&(k as u64))));
        let expected = CollisionPoint {
            time_s: 2.0 * (count - 1) as f64,
            ball: 13,
            next_ball: 14,
            angle_deg: 28.647_889_756_541_16,
            approach_speed_m_s: 4.0,
            peak_force_n: 5.0,
            impulse_n_s: (count - 1) as f64,
        };
        assert!(
            found.collisions.contains(&expected),
            "{:?}",
            found.collisions[0]
        );
    }
}
