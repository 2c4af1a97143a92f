//! Loads and contact pressures over the angular position, from snapshots.

use cageless::Bearing;
use cageless::raceway_contact::{RacewayContact, RacewayPoint};
use cageless::snapshot::Snapshot;

use crate::run_data::LoadProfile;

/// Steps of the angular position.
const STEPS: usize = 120;

/// Force and pressure at one raceway in one step.
#[derive(Clone, Copy, Default)]
struct Bin {
    count: u32,
    sum_n: f64,
    max_n: f64,
    max_pa: f64,
}

impl Bin {
    fn add(&mut self, force_n: f64, pressure_pa: f64) {
        self.count += 1;
        self.sum_n += force_n;
        self.max_n = self.max_n.max(force_n);
        self.max_pa = self.max_pa.max(pressure_pa);
    }

    fn seen(&self, value: f64) -> f64 {
        if self.count > 0 { value } else { f64::NAN }
    }
}

impl LoadProfile {
    /// Profile of all balls in `snapshots`; `None` without any.
    pub fn new(bearing: &Bearing, snapshots: &[Snapshot]) -> Option<Self> {
        let (first, last) = (snapshots.first()?, snapshots.last()?);
        let (mut inner, mut outer) = ([Bin::default(); STEPS], [Bin::default(); STEPS]);
        for snapshot in snapshots {
            for (k, angle) in snapshot.angle_rad.iter().enumerate() {
                let turns = angle / std::f64::consts::TAU;
                let step = ((turns - turns.floor()) * STEPS as f64) as usize % STEPS;
                let force =
                    [snapshot.inner_force_n[k], snapshot.outer_force_n[k]].map(|f| f.max(0.0));
                inner[step].add(force[0], bearing.inner_contact().peak_pressure_pa(force[0]));
                let r = snapshot.effective_radius_m[k];
                let cosine = r / bearing.ball(k % bearing.balls()).radius_m;
                let point = RacewayPoint::of_outer(cosine, force[1]);
                let pressure = RacewayContact::outer(bearing, point).pressure_pa;
                outer[step].add(force[1], pressure);
            }
        }
        let over = |bins: &[Bin], of: fn(&Bin) -> f64| -> Vec<f64> {
            bins.iter().map(|bin| bin.seen(of(bin))).collect()
        };
        let mean = |bin: &Bin| bin.sum_n / f64::from(bin.count.max(1));
        let mpa = |bin: &Bin| bin.max_pa * 1e-6;
        Some(Self {
            from_s: first.time_s,
            to_s: last.time_s,
            angle_deg: (0..STEPS)
                .map(|k| (k as f64 + 0.5) * 360.0 / STEPS as f64)
                .collect(),
            inner_force_mean_n: over(&inner, mean),
            inner_force_max_n: over(&inner, |bin| bin.max_n),
            outer_force_mean_n: over(&outer, mean),
            outer_force_max_n: over(&outer, |bin| bin.max_n),
            inner_pressure_max_mpa: over(&inner, mpa),
            outer_pressure_max_mpa: over(&outer, mpa),
        })
    }
}
