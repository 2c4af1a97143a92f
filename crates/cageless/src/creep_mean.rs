//! Mean of the regularisation speeds that Kalker's creep gives the contacts with the raceways.
//!
//!   v_s = μ N^(1/3) V/(G ca cb C11)
//!
//! of every contact under load, of two contact points of a ball the more loaded one, V the speed of rolling.
//!
//! ```
//! use cageless::equilibrium::settle;
//! use cageless::{Regularisation, reference};
//!
//! let mut case = reference::conventional(); // Zhao 2022, Table 1
//! case.contact.regularisation = Regularisation::Kalker;
//! let at_rest = settle(&case)?;
//! let speed_m_s = case.regularisation_speed_mean_m_s(&at_rest).unwrap();
//! assert!((1e-4..2e-3).contains(&speed_m_s)); // μ = 0.007
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::case::Case;
use crate::contact::creep::{Creep, rolling_speed_m_s};
use crate::dynamics::Contacts;
use crate::equilibrium::space::SpatialEquilibrium;

/// Sum over the contacts under load of a bearing under Kalker's creep.
#[derive(Debug, Clone)]
pub(crate) struct CreepMean {
    creep: Creep,
    /// u of rolling at the outer raceway at the largest speed, m/s.
    outer_m_s: f64,
    /// u of rolling at the inner raceway at the largest speed, m/s.
    inner_m_s: f64,
    /// v_s times the weights, m/s.
    sum_m_s: f64,
    weight: f64,
}

impl CreepMean {
    /// Sum over no contact yet; `None` of a case without creep.
    pub(crate) fn new(case: &Case) -> Option<Self> {
        let (law, friction) = (case.contact.friction_law, &case.contact.friction);
        let creeps = case.rotor.is_none() && law.coefficient_at_rest(friction) > 0.0;
        let d = case.bearing.dimensions();
        let orbit_rad_s = case.rolling_orbit_speed_rad_s();
        Some(Self {
            creep: case.creep().filter(|_| creeps)?,
            outer_m_s: orbit_rad_s * d.outer_groove_bottom_radius_m,
            inner_m_s: (case.largest_inner_speed_rad_s() - orbit_rad_s)
                * d.inner_groove_bottom_radius_m,
            sum_m_s: 0.0,
            weight: 0.0,
        })
    }

    /// Takes the contacts of a motion at this ωi over the largest, with a weight.
    pub(crate) fn look(&mut self, contacts: &Contacts<'_>, speed_ratio: f64, weight: f64) {
        for ball in 0..contacts.balls() {
            let outer_n = match contacts.outer_force_n(ball) > 0.0 {
                true => contacts.outer_point(ball).force_n,
                false => 0.0,
            };
            self.add_outer(outer_n, speed_ratio, weight);
            self.add_inner(contacts.inner_force_n(ball), speed_ratio, weight);
        }
    }

    fn add_outer(&mut self, force_n: f64, speed_ratio: f64, weight: f64) {
        let rolling_m_s = rolling_speed_m_s(speed_ratio * self.outer_m_s);
        self.add(force_n, rolling_m_s / self.creep.outer, weight);
    }

    fn add_inner(&mut self, force_n: f64, speed_ratio: f64, weight: f64) {
        let rolling_m_s = rolling_speed_m_s(speed_ratio * self.inner_m_s);
        self.add(force_n, rolling_m_s / self.creep.inner, weight);
    }

    /// Takes a contact whose v_s over N^(1/3) this is; nothing without load.
    fn add(&mut self, force_n: f64, slope: f64, weight: f64) {
        if force_n > 0.0 {
            self.sum_m_s += weight * slope * force_n.cbrt();
            self.weight += weight;
        }
    }

    /// Mean of v_s, m/s; `None` without a contact under load.
    pub(crate) fn mean_m_s(&self) -> Option<f64> {
        (self.weight > 0.0).then(|| self.sum_m_s / self.weight)
    }
}

impl Case {
    /// Mean of the regularisation speeds of the contacts under load in an equilibrium at rest, m/s; `None` where the
    /// speed is given, without friction and under a falling rotor.
    pub fn regularisation_speed_mean_m_s(&self, settled: &SpatialEquilibrium) -> Option<f64> {
        let mut mean = CreepMean::new(self)?;
        let speed_ratio = self.operation.inner_speed_rad_s.abs()
            / self.largest_inner_speed_rad_s().max(f64::MIN_POSITIVE);
        for (ball, flanks) in settled.flank_force_n.iter().enumerate() {
            mean.add_outer(flanks[0].max(flanks[1]), speed_ratio, 1.0);
            mean.add_inner(settled.rest.inner_force_n[ball], speed_ratio, 1.0);
        }
        mean.mean_m_s()
    }
}
