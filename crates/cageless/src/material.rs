//! Elastic materials of balls and rings.

use crate::error::InputError;
use crate::limits::{positive, require};

/// Elastic material of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Density.
    pub density_kg_m3: f64,
    /// Young's modulus E.
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio ν, 0 to below 0.5.
    pub poisson_ratio: f64,
}

impl Material {
    /// Bearing steel: 7850 kg/m³, 206 GPa, ν = 0.3.
    pub const STEEL: Self = Self {
        density_kg_m3: 7850.0,
        youngs_modulus_pa: 206e9,
        poisson_ratio: 0.3,
    };

    /// Checks that a solid can have these values.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be.
    pub fn check(&self) -> Result<(), InputError> {
        positive("density_kg_m3", self.density_kg_m3)?;
        positive("youngs_modulus_pa", self.youngs_modulus_pa)?;
        check_poisson_ratio("poisson_ratio", self.poisson_ratio)
    }

    /// Whether it is a steel, by modulus and density.
    pub fn is_steel(&self) -> bool {
        (180e9..=225e9).contains(&self.youngs_modulus_pa)
            && (7400.0..=8200.0).contains(&self.density_kg_m3)
    }
}

/// Passes a Poisson's ratio that a solid can have.
pub(crate) fn check_poisson_ratio(field: &'static str, ratio: f64) -> Result<(), InputError> {
    let rule = "at least 0 and less than 0.5";
    require(field, ratio, (0.0..0.5).contains(&ratio), rule)
}

/// Materials of balls and rings: one for both, or ceramic balls in steel rings (a hybrid
/// bearing).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Materials {
    /// Material of the balls; its density decides their mass.
    pub ball: Material,
    /// Material of both rings.
    pub ring: Material,
}

impl From<Material> for Materials {
    fn from(material: Material) -> Self {
        Self {
            ball: material,
            ring: material,
        }
    }
}
