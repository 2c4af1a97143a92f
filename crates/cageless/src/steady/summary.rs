//! Means of steady operation.

use super::recorder::SteadyBlock;
use crate::bearing::Bearing;
use crate::numerics::moments::Moments;

/// Contacts and forces of one run after its transient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadySummary {
    /// Contacts between balls that began, 1/s: all, and those above 0.1 and 0.5 m/s.
    pub contact_rates_hz: [f64; 3],
    /// Impulse between balls per second, N.
    pub impulse_rate_n: f64,
    /// Normal force times sliding speed between balls, to which Archard's wear volume per time is proportional, W.
    pub wear_w: f64,
    /// Largest pressure between balls in the transient, Pa.
    pub transient_pressure_pa: f64,
    /// Force on the outer ring that turns with the balls, N.
    pub turning_force_n: f64,
    /// Amplitude of the vertical force on the outer ring at the frequency at which balls pass a point of it, N.
    pub passing_force_n: f64,
}

impl SteadySummary {
    /// Means over the blocks of a run of a bearing.
    pub fn new(bearing: &Bearing, blocks: &[SteadyBlock], transient_force_n: f64) -> Self {
        let time_s: f64 = blocks.iter().map(|block| block.time_s).sum();
        let rate = |of: &dyn Fn(&SteadyBlock) -> f64| blocks.iter().map(of).sum::<f64>() / time_s;
        let amplitude = |of: &dyn Fn(&SteadyBlock) -> [Moments; 2]| {
            let mean = |k: usize| rate(&|block| block.time_s * of(block)[k].mean);
            let [cosine, sine] = [0, 1].map(mean);
            cosine.hypot(sine)
        };
        Self {
            contact_rates_hz: [
                rate(&|block| block.contacts.all as f64),
                rate(&|block| block.contacts.above[0] as f64),
                rate(&|block| block.contacts.above[1] as f64),
            ],
            impulse_rate_n: rate(&|block| block.impulse_n_s),
            wear_w: rate(&|block| block.force_distance_n_m),
            transient_pressure_pa: bearing.ball_contact().peak_pressure_pa(transient_force_n),
            turning_force_n: amplitude(&|block| block.turning_force_n),
            passing_force_n: 2.0 * amplitude(&|block| block.passing_force_n),
        }
    }
}
