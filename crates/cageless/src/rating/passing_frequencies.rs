//! Passing frequencies of the balls in pure rolling.

use std::f64::consts::TAU;

use super::ratios::gamma;
use crate::case::Case;
use crate::kinematics::raceway_delay_rad;

/// Frequencies at which balls pass and turn, the outer ring standing still, by the closed
/// forms of bearing diagnostics with γ = Dw/Dpw and the rotational frequency n of the inner
/// ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassingFrequencies {
    /// FTF = n/2 (1 − γ), orbital frequency of the balls ("fundamental train frequency"), Hz.
    pub ftf_hz: f64,
    /// BPFO = Z FTF, balls past a point of the outer ring, Hz.
    pub bpfo_hz: f64,
    /// BPFI = Z n/2 (1 + γ), balls past a point of the inner ring, Hz.
    pub bpfi_hz: f64,
    /// BSF = n (1 − γ²)/(2γ), rotation of a ball in the frame of its orbit, Hz.
    pub bsf_hz: f64,
    /// Orbital frequency of a ball that rolls through the discrete raceways of the case as
    /// well, in which it is slower, Hz; FTF without any.
    pub raceway_ftf_hz: f64,
}

impl PassingFrequencies {
    /// Frequencies at the speed of the case.
    pub fn new(case: &Case) -> Self {
        let n = case.operation.inner_speed_rad_s.abs() / TAU;
        let gamma = gamma(&case.bearing);
        let balls = case.bearing.balls() as f64;
        let ftf_hz = 0.5 * n * (1.0 - gamma);
        Self {
            ftf_hz,
            bpfo_hz: balls * ftf_hz,
            bpfi_hz: balls * 0.5 * n * (1.0 + gamma),
            bsf_hz: n * (1.0 - gamma * gamma) / (2.0 * gamma),
            raceway_ftf_hz: ftf_hz * TAU / (TAU + raceway_delay_rad(&case.bearing, &case.raceways)),
        }
    }
}
