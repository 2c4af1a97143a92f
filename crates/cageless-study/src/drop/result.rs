//! Results of a drop in the units in which they are shown.

use std::f64::consts::TAU;

use cageless::simulation::{Ending, RunOutcome};
use cageless::touchdown::{DropSummary, WhirlWindow};
use serde::{Deserialize, Serialize};

/// Results of one drop.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DropResult {
    /// What the rotor does at the end: `falling`, `at-rest`, `pendulum`, `bouncing`,
    /// `forward-whirl` or `backward-whirl`.
    pub end_state: String,
    /// Simulated time, s.
    pub end_s: f64,
    /// Why the run stopped before its end, if it did.
    pub stopped: Option<String>,
    /// First contact of the rotor with the inner ring, ms.
    pub first_contact_ms: Option<f64>,
    /// Contacts of the rotor with the inner ring that began.
    pub impacts: u64,
    /// Fraction of the time after the first contact in contact.
    pub contact_fraction: f64,
    /// Largest normal force between rotor and inner ring, N.
    pub rotor_force_max_n: f64,
    /// The same as a multiple of the rotor's weight; `None` without gravity.
    pub rotor_force_max_weights: Option<f64>,
    /// Largest force of the support on the housing, N; `None` without a support.
    pub housing_force_max_n: Option<f64>,
    /// The same as a multiple of the rotor's weight.
    pub housing_force_max_weights: Option<f64>,
    /// Largest displacement of the outer ring, µm.
    pub housing_displacement_max_um: f64,
    /// Largest sliding speed between rotor and inner ring, m/s.
    pub rotor_slip_max_m_s: f64,
    /// Time at which rotor and inner ring first slide at less than 1 % of their first sliding
    /// speed, ms; `None` if they do not.
    pub spin_up_ms: Option<f64>,
    /// Speed of the inner ring at the end, rpm.
    pub ring_speed_rpm: f64,
    /// Speed of the rotor at the end, rpm.
    pub rotor_speed_rpm: f64,
    /// Largest whirl frequency against the direction of rotation, Hz.
    pub backward_whirl_max_hz: f64,
    /// Contacts between balls that began.
    pub collisions: u64,
    /// Largest force between balls, N.
    pub ball_force_max_n: f64,
    /// Largest contact pressure between balls, MPa.
    pub ball_stress_max_mpa: f64,
    /// Largest contact pressure at the inner raceway, MPa.
    pub inner_stress_max_mpa: f64,
    /// Largest contact pressure at the outer raceway, MPa.
    pub outer_stress_max_mpa: f64,
    /// Largest sliding speed of a loaded ball, m/s.
    pub ball_slip_max_m_s: f64,
    /// Heat of friction between rotor and inner ring, J.
    pub rotor_friction_j: f64,
    /// Heat of the damping between rotor and inner ring, J.
    pub rotor_damping_j: f64,
    /// Heat of friction at the inner raceway, J.
    pub inner_friction_j: f64,
    /// Heat of friction at the outer raceway, J.
    pub outer_friction_j: f64,
    /// Heat of friction between balls, J.
    pub ball_friction_j: f64,
    /// Heat of the damping of the contacts of the balls, J.
    pub contact_damping_j: f64,
    /// Heat of the damping of the support, J.
    pub support_damping_j: f64,
    /// Energy balance error, relative to the sum of all terms.
    pub energy_residual_relative: f64,
    /// Largest normal force of each ball at the inner raceway, N.
    pub inner_force_max_n: Vec<f64>,
    /// Largest normal force of each ball at the outer raceway, N.
    pub outer_force_max_n: Vec<f64>,
    /// Whirl of the rotor over time.
    pub whirl: Vec<WhirlRow>,
}

/// Motion of the rotor round the bore in one interval.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WhirlRow {
    /// Middle of the interval, ms.
    pub time_ms: f64,
    /// Whirl frequency, Hz, counter-clockwise positive.
    pub frequency_hz: f64,
    /// Fraction of the interval in contact.
    pub contact_fraction: f64,
    /// Mean contact force, N.
    pub force_mean_n: f64,
}

impl WhirlRow {
    fn new(w: &WhirlWindow) -> Self {
        Self {
            time_ms: 500.0 * (w.start_s + w.end_s),
            frequency_hz: w.frequency_hz(),
            contact_fraction: w.contact_fraction,
            force_mean_n: w.force_mean_n,
        }
    }
}

impl DropResult {
    /// The results `s` of the drop that ended as `outcome`.
    pub fn new(s: &DropSummary, outcome: &RunOutcome) -> Self {
        let weights = |force_n: f64| (s.rotor_weight_n > 0.0).then(|| force_n / s.rotor_weight_n);
        let rpm = 60.0 / TAU;
        Self {
            end_state: s.end_state.name().to_owned(),
            end_s: outcome.end_s,
            stopped: match &outcome.ending {
                Ending::Stopped(stop) => {
                    Some(format!("at t = {:.6} s {}", stop.time_s, stop.cause))
                }
                _ => None,
            },
            first_contact_ms: s.first_contact_s.map(|t| 1e3 * t),
            impacts: s.impacts,
            contact_fraction: s.contact_fraction,
            rotor_force_max_n: s.rotor_force_max_n,
            rotor_force_max_weights: weights(s.rotor_force_max_n),
            housing_force_max_n: s.housing_force_max_n,
            housing_force_max_weights: s.housing_force_max_n.and_then(weights),
            housing_displacement_max_um: 1e6 * s.housing_displacement_max_m,
            rotor_slip_max_m_s: s.rotor_slip_max_m_s,
            spin_up_ms: s.spin_up_s.map(|t| 1e3 * t),
            ring_speed_rpm: rpm * s.ring_speed_rad_s,
            rotor_speed_rpm: rpm * s.rotor_speed_rad_s,
            backward_whirl_max_hz: s.backward_whirl_max_hz,
            collisions: s.collisions,
            ball_force_max_n: s.ball_force_max_n,
            ball_stress_max_mpa: 1e-6 * s.ball_stress_max_pa,
            inner_stress_max_mpa: 1e-6 * s.inner_stress_max_pa,
            outer_stress_max_mpa: 1e-6 * s.outer_stress_max_pa,
            ball_slip_max_m_s: s.ball_slip_max_m_s,
            rotor_friction_j: s.heat.rotor_friction_j,
            rotor_damping_j: s.heat.rotor_damping_j,
            inner_friction_j: s.heat.inner_friction_j,
            outer_friction_j: s.heat.outer_friction_j,
            ball_friction_j: s.heat.ball_friction_j,
            contact_damping_j: s.heat.contact_damping_j,
            support_damping_j: s.heat.support_damping_j,
            energy_residual_relative: outcome.energy_residual_relative,
            inner_force_max_n: s.inner_force_max_n.clone(),
            outer_force_max_n: s.outer_force_max_n.clone(),
            whirl: s.whirl.iter().map(WhirlRow::new).collect(),
        }
    }

    /// Heat of all interfaces, J.
    pub fn heat_j(&self) -> f64 {
        self.rotor_friction_j
            + self.rotor_damping_j
            + self.inner_friction_j
            + self.outer_friction_j
            + self.ball_friction_j
            + self.contact_damping_j
            + self.support_damping_j
    }

    /// Name, unit and value of the numbers that tables show, most wanted first.
    pub fn quantities(&self) -> Vec<(&'static str, &'static str, Option<f64>)> {
        vec![
            ("first contact", "ms", self.first_contact_ms),
            ("impacts of the rotor", "", Some(self.impacts as f64)),
            ("time in contact", "%", Some(100.0 * self.contact_fraction)),
            (
                "largest force on the rotor",
                "N",
                Some(self.rotor_force_max_n),
            ),
            (
                "as a multiple of its weight",
                "",
                self.rotor_force_max_weights,
            ),
            (
                "largest force on the housing",
                "N",
                self.housing_force_max_n,
            ),
            (
                "as a multiple of the weight",
                "",
                self.housing_force_max_weights,
            ),
            (
                "largest displacement of the outer ring",
                "µm",
                Some(self.housing_displacement_max_um),
            ),
            ("spin-up of the inner ring", "ms", self.spin_up_ms),
            ("inner ring at the end", "rpm", Some(self.ring_speed_rpm)),
            ("rotor at the end", "rpm", Some(self.rotor_speed_rpm)),
            (
                "fastest backward whirl",
                "Hz",
                Some(self.backward_whirl_max_hz),
            ),
            (
                "largest pressure, inner raceway",
                "MPa",
                Some(self.inner_stress_max_mpa),
            ),
            (
                "largest pressure, outer raceway",
                "MPa",
                Some(self.outer_stress_max_mpa),
            ),
            (
                "largest pressure between balls",
                "MPa",
                Some(self.ball_stress_max_mpa),
            ),
            ("collisions between balls", "", Some(self.collisions as f64)),
            (
                "largest force between balls",
                "N",
                Some(self.ball_force_max_n),
            ),
            (
                "largest sliding speed of a ball",
                "m/s",
                Some(self.ball_slip_max_m_s),
            ),
            (
                "heat between rotor and ring",
                "J",
                Some(self.rotor_friction_j + self.rotor_damping_j),
            ),
            (
                "friction heat at the inner raceway",
                "J",
                Some(self.inner_friction_j),
            ),
            (
                "friction heat at the outer raceway",
                "J",
                Some(self.outer_friction_j),
            ),
            (
                "friction heat between balls",
                "J",
                Some(self.ball_friction_j),
            ),
            (
                "damping heat of the balls' contacts",
                "J",
                Some(self.contact_damping_j),
            ),
            (
                "damping heat of the support",
                "J",
                Some(self.support_damping_j),
            ),
            (
                "energy balance error",
                "",
                Some(self.energy_residual_relative),
            ),
        ]
    }
}
