//! The case of a bearing with every default.

use super::{Case, Contact, Gaps, Motion, Operation, Solver, SpatialLoad, Start, StartState};
use crate::bearing::Bearing;
use crate::contact::FrictionParameters;
use crate::flank_model::FlankModel;
use crate::formulation::Formulation;
use crate::integrator::IntegrationMethod;
use crate::unbalance::Unbalance;

/// Method of a case unless one is given.
const METHOD: IntegrationMethod = IntegrationMethod::VelocityVerlet;
/// Step until the automatic one is known, s.
const PROVISIONAL_STEP_S: f64 = 1e-6;

impl Case {
    /// The case of a bearing that nothing loads or turns.
    ///
    /// No raceway, elastic flanks, μ = 0.007 (lubricated) with the smooth law, contact damping 2·10⁵ N·s·m^(−3/2),
    /// restitution 0.95 between balls, balls evenly spaced in static equilibrium, g = 9.81 m/s², velocity Verlet over
    /// 0.5 s with a step of 1 µs.
    pub fn of(bearing: Bearing) -> Self {
        Self {
            bearing,
            raceways: vec![],
            operation: Operation {
                clockwise: false,
                inner_speed_rad_s: 0.0,
                radial_load_n: 0.0,
                gravity_m_s2: 9.81,
                inner_speed_table: None,
                radial_load_table: None,
                unbalance: Unbalance::default(),
                space: SpatialLoad::default(),
            },
            contact: Contact::default(),
            formulation: Formulation::Physical,
            motion: Motion::BySymmetry,
            flanks: FlankModel::Elastic,
            start: Start::new(StartState::Settled, Gaps::Uniform, 0.0),
            solver: Solver {
                method: METHOD,
                step_s: PROVISIONAL_STEP_S,
                tolerance: 1e-8,
                duration_s: 0.5,
                transient_s: None,
            },
            housing: None,
            rotor: None,
            support: None,
            rows: vec![],
            film: None,
        }
    }

    /// Regularisation speed that goes with the speed of the bearing, m/s; with a rotor the largest one.
    pub fn automatic_regularisation_m_s(&self) -> f64 {
        match self.rotor {
            Some(_) => FrictionParameters::REGULARISATION_MAX_M_S,
            None => {
                let orbit_rad_s = self.rolling_orbit_speed_rad_s().abs();
                let rolling_m_s = orbit_rad_s * self.bearing.pitch_radius_m();
                FrictionParameters::regularisation_of_rolling_m_s(rolling_m_s)
            }
        }
    }
}
