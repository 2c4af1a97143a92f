//! Spin-down of a rotor after a drop.
//!
//! ```
//! use cageless::touchdown::{Brake, SpinDown};
//!
//! // A rotor of 0.02 kg m² at 1000 rad/s, braked by 0.1 and 0.2 N m of two bearings and 0.1 N m of a drive.
//! let brakes = [0.1, 0.2].map(|torque_n_m| Brake { torque_n_m, shares: [0.25, 0.5, 0.25] });
//! let end = SpinDown::new(0.02, 1000.0, &brakes, 0.1).unwrap();
//! assert!((end.time_s - 50.0).abs() < 1e-9);
//! assert!((end.heat_j[1] - 0.5 * 10_000.0).abs() < 1e-9); // the first bearing and the drive take a quarter each
//! ```

use super::heat::EndPower;
use super::thermal::PARTS;

/// Shares of the heat of rolling at both raceways that warm inner ring, balls and outer ring.
const ROLLING_SHARES: [f64; PARTS] = [0.25, 0.5, 0.25];

/// A bearing that brakes the rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Brake {
    /// Torque on the rotor, N m.
    pub torque_n_m: f64,
    /// Shares of its heat that warm inner ring, balls and outer ring; the rest warms rotor and support.
    pub shares: [f64; PARTS],
}

impl Brake {
    /// A bearing that brakes as at the end of a drop, and by `rolling_n_m` at least: balls that roll
    /// lose little in a model without hysteresis. `None` of a slow rotor, which nothing brakes.
    pub fn new(end: &EndPower, rolling_n_m: f64) -> Option<Self> {
        let own_n_m = end.torque_n_m?;
        let torque_n_m = own_n_m.max(rolling_n_m);
        let own = own_n_m / torque_n_m;
        let shares = std::array::from_fn(|k| {
            own * end.parts_w[k] / end.total_w + (1.0 - own) * ROLLING_SHARES[k]
        });
        (torque_n_m > 0.0).then_some(Self { torque_n_m, shares })
    }
}

/// Spin-down of a rotor to standstill under torques that stay as they are.
#[derive(Debug, Clone, PartialEq)]
pub struct SpinDown {
    /// Time from the end of the drop to standstill.
    pub time_s: f64,
    /// Heat of each bearing meanwhile, J.
    pub heat_j: Vec<f64>,
}

impl SpinDown {
    /// Spin-down of a rotor of polar moment `inertia_kg_m2` from `speed_rad_s`, braked by its bearings
    /// and by `drive_n_m` of its drive, which may drive it on; `None` where it does not come to rest.
    pub fn new(
        inertia_kg_m2: f64,
        speed_rad_s: f64,
        bearings: &[Brake],
        drive_n_m: f64,
    ) -> Option<Self> {
        let contacts_n_m: f64 = bearings.iter().map(|brake| brake.torque_n_m).sum();
        let torque = contacts_n_m + drive_n_m;
        let time_s = inertia_kg_m2 * speed_rad_s.abs() / torque;
        // I dΩ/dt = −T: the angle to standstill is Ω t/2.
        let angle_rad = 0.5 * speed_rad_s.abs() * time_s;
        let heat_j = bearings.iter().map(|brake| brake.torque_n_m * angle_rad);
        (torque > 0.0 && angle_rad.is_finite()).then(|| Self {
            time_s,
            heat_j: heat_j.collect(),
        })
    }
}
