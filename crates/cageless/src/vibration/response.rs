//! The housing under a force that is linear between moments.

use super::measurement::Measurement;
use super::oscillator::Oscillator;
use crate::case::Housing;
use crate::simulation::RunContext;

/// Sampling of the housing's motion; resolves 10 kHz and all housings below it.
pub(crate) const HOUSING_INTERVAL_S: f64 = 1e-5;

/// Acceleration of the housing along x and y under the force on the outer ring.
pub(super) struct Response {
    housing: Housing,
    interval_s: f64,
    /// Impulse gathered since the last sample.
    impulse: [f64; 2],
    since_s: f64,
    last_force: [f64; 2],
    motion: Option<[Oscillator; 2]>,
    pub measurements: [Measurement; 2],
}

impl Response {
    /// Recorder for a housing, sampled at `rate_hz`, without the transient before `after_s`.
    pub(super) fn new(housing: &Housing, rate_hz: f64, after_s: f64) -> Self {
        let measurement = Measurement::new(HOUSING_INTERVAL_S, rate_hz, after_s);
        Self {
            housing: housing.clone(),
            interval_s: HOUSING_INTERVAL_S,
            impulse: [0.0; 2],
            since_s: 0.0,
            last_force: [0.0; 2],
            motion: None,
            measurements: [measurement.clone(), measurement],
        }
    }

    /// Takes the force at the start of a run.
    pub(super) fn begin(&mut self, context: &RunContext<'_>) {
        let mut rhs = crate::dynamics::RightHandSide::new(context.model);
        let snapshot = rhs.snapshot(0.0, context.start, context.start_angle_rad);
        self.last_force = [snapshot.ring.outer_force_x_n, snapshot.ring.outer_force_y_n];
    }

    /// Adds what acted until `to_s`, where the force is `force`, closing samples on the way.
    pub(super) fn add(&mut self, from_s: f64, to_s: f64, force: [f64; 2]) {
        let slope = |k: usize| (force[k] - self.last_force[k]) / (to_s - from_s);
        let slopes = [slope(0), slope(1)];
        let mut at = from_s;
        loop {
            let sample_end = self.since_s + self.interval_s;
            let until = sample_end.min(to_s);
            for (k, slope) in slopes.iter().enumerate() {
                let middle = self.last_force[k] + slope * ((at + until) / 2.0 - from_s);
                self.impulse[k] += middle * (until - at);
            }
            if sample_end > to_s {
                break;
            }
            self.close_sample();
            at = until;
        }
        self.last_force = force;
    }

    fn close_sample(&mut self) {
        let mean = self.impulse.map(|i| i / self.interval_s);
        let motion = self.motion.get_or_insert_with(|| {
            mean.map(|f| Oscillator::new(&self.housing, self.interval_s, f))
        });
        for k in 0..2 {
            self.measurements[k].push(motion[k].push(mean[k]));
        }
        self.impulse = [0.0; 2];
        self.since_s += self.interval_s;
    }
}
