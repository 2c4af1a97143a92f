//! Temperatures of a touch-down bearing, drop after drop.
//!
//! ```
//! use cageless::touchdown::Thermal;
//!
//! let cooling = Thermal { pause_s: 600.0, cooling_time_s: Some(600.0), ..Thermal::default() };
//! assert!((cooling.after_pause_c([120.0; 3], [20.0; 3])[0] - (20.0 + 100.0 / 1f64.exp())).abs() < 1e-9);
//! ```

use crate::bearing::Bearing;
use crate::error::{Allowed, InputError};
use crate::limits::{not_negative, positive};
use crate::material::Material;

/// Specific heat of bearing steel 100Cr6, J/(kg K): that of
/// `STEEL_EFFUSIVITY`.
pub const STEEL_SPECIFIC_HEAT_J_KG_K: f64 = 460.0;

/// Parts of a bearing that warm, each with one temperature: inner ring, balls, outer ring.
pub const PARTS: usize = 3;

/// Heat capacities warmed by a drop, and cooling between drops.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Thermal {
    /// Mass of the outer ring; that of a ring of the density of the rings, 0.3 ball diameters thick
    /// behind its groove and 1.6 wide, unless given.
    pub outer_ring_mass_kg: Option<f64>,
    /// Specific heat of the rings, J/(kg K); that of bearing steel for steel unless given.
    pub ring_specific_heat_j_kg_k: Option<f64>,
    /// Specific heat of the balls, J/(kg K); that of bearing steel for steel unless given.
    pub ball_specific_heat_j_kg_k: Option<f64>,
    /// Time from the standstill of the rotor to the next drop.
    pub pause_s: f64,
    /// Time constant with which the bearing cools in the pause; without one it keeps all heat.
    pub cooling_time_s: Option<f64>,
}

impl Thermal {
    /// Checks the values.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be.
    pub fn check(&self) -> Result<(), InputError> {
        for (field, value) in [
            ("outer_ring_mass_kg", self.outer_ring_mass_kg),
            ("ring_specific_heat_j_kg_k", self.ring_specific_heat_j_kg_k),
            ("ball_specific_heat_j_kg_k", self.ball_specific_heat_j_kg_k),
            ("cooling_time_s", self.cooling_time_s),
        ] {
            value.map_or(Ok(()), |value| positive(field, value))?;
        }
        not_negative("pause_s", self.pause_s)
    }

    /// Heat capacity of each part of a bearing with `rows` alike, J/K; the inner ring is that of all rows.
    ///
    /// # Errors
    /// An [`InputError`] with a value of NaN naming the specific heat that is needed of a part that is
    /// not of steel.
    pub fn capacities_j_k(
        &self,
        bearing: &Bearing,
        rows: usize,
    ) -> Result<[f64; PARTS], InputError> {
        let rows = rows.max(1) as f64;
        let of = |field, given: Option<f64>, material: &Material| match given {
            Some(value) => Ok(value),
            None if material.is_steel() => Ok(STEEL_SPECIFIC_HEAT_J_KG_K),
            None => Err(InputError::new(field, f64::NAN, Allowed::Above(0.0, ""))),
        };
        let materials = bearing.materials();
        let (ring, ball) = (&materials.ring, &materials.ball);
        let ring_j_kg_k = of(
            "ring_specific_heat_j_kg_k",
            self.ring_specific_heat_j_kg_k,
            ring,
        )?;
        let ball_j_kg_k = of(
            "ball_specific_heat_j_kg_k",
            self.ball_specific_heat_j_kg_k,
            ball,
        )?;
        let outer_kg = self
            .outer_ring_mass_kg
            .unwrap_or_else(|| rows * bearing.outer_ring_mass_kg());
        let inner_kg = bearing.dimensions().inner_ring_mass_kg;
        Ok([
            inner_kg * ring_j_kg_k,
            rows * bearing.balls() as f64 * bearing.ball_mass_kg() * ball_j_kg_k,
            outer_kg * ring_j_kg_k,
        ])
    }

    /// Temperatures after the pause, °C, of parts that cool towards `start_c`.
    pub fn after_pause_c(&self, warm_c: [f64; PARTS], start_c: [f64; PARTS]) -> [f64; PARTS] {
        let kept = self
            .cooling_time_s
            .map_or(1.0, |time_s| (-self.pause_s / time_s).exp());
        std::array::from_fn(|k| start_c[k] + kept * (warm_c[k] - start_c[k]))
    }
}
