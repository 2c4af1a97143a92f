//! Loads and contact pressures over the angular position, from snapshots.

use cageless::Case;
use cageless::Snapshot;
use cageless::equilibrium::space::{GroovePoint, inner_point, outer_points};
use cageless::{RacewayContact, RacewayPoint};

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

/// Largest pressure of ball `k` at inner and outer raceway, Pa.
fn pressures_pa(case: &Case, snapshot: &Snapshot, k: usize) -> [f64; 2] {
    let bearing = &case.bearing;
    let (inner_n, outer_n) = (snapshot.inner_force_n[k], snapshot.outer_force_n[k]);
    if !snapshot.is_in_space() {
        let cosine = snapshot.effective_radius_m[k] / bearing.ball(k).radius_m;
        let point = RacewayPoint::of_outer(cosine, outer_n.max(0.0));
        let inner = RacewayPoint {
            force_n: inner_n.max(0.0),
            cosine: 1.0,
        };
        return [
            RacewayContact::inner(bearing, inner).pressure_pa,
            RacewayContact::outer(bearing, point).pressure_pa,
        ];
    }
    let place = snapshot.place_in_outer_ring_m(k);
    let inner = inner_point(case, snapshot.inner_contact_angle_rad[k], inner_n);
    let outer = outer_points(case, k, snapshot.angle_rad[k], place, outer_n);
    let pressure = |point: Option<_>| point.map_or(0.0, |p: GroovePoint| p.contact.pressure_pa);
    let [one, other] = outer.map(pressure);
    [pressure(inner), one.max(other)]
}

impl LoadProfile {
    /// Profile of all balls in `snapshots`; `None` without any.
    pub fn new(case: &Case, snapshots: &[Snapshot]) -> Option<Self> {
        let (first, last) = (snapshots.first()?, snapshots.last()?);
        let (mut inner, mut outer) = ([Bin::default(); STEPS], [Bin::default(); STEPS]);
        for snapshot in snapshots {
            for (k, angle) in snapshot.angle_rad.iter().enumerate() {
                let turns = angle / std::f64::consts::TAU;
                let step = ((turns - turns.floor()) * STEPS as f64) as usize % STEPS;
                let force =
                    [snapshot.inner_force_n[k], snapshot.outer_force_n[k]].map(|f| f.max(0.0));
                let pressures = pressures_pa(case, snapshot, k);
                inner[step].add(force[0], pressures[0]);
                outer[step].add(force[1], pressures[1]);
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

#[cfg(test)]
mod tests {
    use cageless::recorder::Recorder;
    use cageless::simulation::{Control, run};
    use cageless::summary::SummaryRecorder;
    use cageless_io::case_file::{CaseFile, template};

    use super::*;

    /// The largest pressures of the profile are those of the run, which looks more often; where one flank
    /// bears nearly all as well.
    #[test]
    fn pressures_are_those_of_the_run() {
        for axial_load in ["0", "750"] {
            let sets = [
                "solver.duration_s=0.01".to_owned(),
                "solver.method=verlet".to_owned(),
                "operation.gravity_m_s2=0".to_owned(),
                format!("operation.axial_load_n={axial_load}"),
            ];
            let file = CaseFile::parse(&template(false), "case.toml", &sets).unwrap();
            let mut snapshots = vec![];
            let mut recorder = Recorder::new(1e-5, |snapshot: Snapshot| {
                snapshots.push(snapshot);
                Ok(())
            });
            let mut summary = SummaryRecorder::new();
            let control = &mut |_| Control::Continue(());
            run(file.case(), &mut [&mut recorder, &mut summary], control).unwrap();
            let summary = summary.summary().unwrap();
            let settled = snapshots.partition_point(|s| s.time_s < summary.settled_after_s);
            let profile = LoadProfile::new(file.case(), &snapshots[settled..]).unwrap();
            let peaks = summary.peaks;
            for (found, expected) in [
                (profile.inner_pressure_max_mpa, peaks.inner.pressure_pa),
                (profile.outer_pressure_max_mpa, peaks.outer.pressure_pa),
            ] {
                let found = 1e6 * found.into_iter().fold(0.0, f64::max);
                let ratio = found / expected;
                assert!((0.99..1.002).contains(&ratio), "{axial_load}: {ratio}");
            }
        }
    }
}
