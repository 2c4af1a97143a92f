//! Passing frequencies of the balls in pure rolling.

use std::f64::consts::TAU;

use super::ratios::gamma_at;
use crate::case::Case;
use crate::equilibrium::space::SpatialEquilibrium;
use crate::kinematics::raceway_delay_rad;

/// Frequencies at which balls pass and turn, the outer ring standing still, by the closed
/// forms of bearing diagnostics with γ = Dw cos α/Dpw and the rotational frequency n of the inner
/// ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassingFrequencies {
    /// FTF = n/2 (1 − γ), orbital frequency of the balls ("fundamental train frequency"), Hz.
    pub ftf_hz: f64,
    /// BPFO = Z FTF, balls past a point of the outer ring, Hz.
    pub bpfo_hz: f64,
    /// BPFI = Z n/2 (1 + γ), balls past a point of the inner ring, Hz.
    pub bpfi_hz: f64,
    /// BSF = n/2 · Dpw/Dw (1 − γ²), rotation of a ball in the frame of its orbit, Hz.
    pub bsf_hz: f64,
    /// Orbital frequency of a ball that rolls through the discrete raceways of the case as
    /// well, in which it is slower, Hz; FTF without any.
    pub raceway_ftf_hz: f64,
}

impl PassingFrequencies {
    /// Frequencies at the speed of the case and the free contact angle.
    pub fn new(case: &Case) -> Self {
        Self::at_contact_angle(case, case.bearing.contact_angle_rad())
    }

    /// Frequencies at the speed of the case and a contact angle α.
    pub fn at_contact_angle(case: &Case, contact_angle_rad: f64) -> Self {
        let n = case.operation.inner_speed_rad_s.abs() / TAU;
        let gamma = gamma_at(&case.bearing, contact_angle_rad);
        let balls = case.bearing.balls() as f64;
        let ftf_hz = 0.5 * n * (1.0 - gamma);
        Self {
            ftf_hz,
            bpfo_hz: balls * ftf_hz,
            bpfi_hz: balls * 0.5 * n * (1.0 + gamma),
            bsf_hz: n * (1.0 - gamma * gamma) / (2.0 * gamma_at(&case.bearing, 0.0)),
            raceway_ftf_hz: ftf_hz * TAU / (TAU + raceway_delay_rad(&case.bearing, &case.raceways)),
        }
    }
}

/// Contact angle of the loaded bearing, rad: the mean of both contacts of every ball that carries, without
/// sign; `None` if none does.
pub(crate) fn loaded_contact_angle_rad(space: &SpatialEquilibrium) -> Option<f64> {
    let angles = space
        .inner_contact_angle_rad
        .iter()
        .zip(&space.outer_contact_angle_rad)
        .zip(&space.rest.inner_force_n)
        .filter(|(_, force_n)| **force_n > 0.0)
        .map(|((inner, outer), _)| 0.5 * (inner.abs() + outer.abs()));
    let (sum, count) = angles.fold((0.0, 0), |(sum, count), angle| (sum + angle, count + 1));
    (count > 0).then(|| sum / f64::from(count))
}
