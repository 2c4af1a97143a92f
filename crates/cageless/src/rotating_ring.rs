//! Expansion of a ring or shaft by its own rotation.

use crate::material::Material;

/// Inside and outside diameter of a ring.
pub(crate) struct RingDiameters {
    /// d, m.
    pub inside_m: f64,
    /// D, m.
    pub outside_m: f64,
}

/// Growth of the diameter `at_m` of a free ring of these diameters that rotates at ω, m:
///
///   Δ = ρ ω² x (3 + ν)(1 − ν)/(32 E) (d² + D² + (1 + ν)/(1 − ν) (d D/x)² − (1 + ν)/(3 + ν) x²)
///
/// at the diameter x, in plane stress (Timoshenko and Goodier, *Theory of Elasticity*, rotating disks); with d = 0 a
/// solid disk.
pub(crate) fn rotating_growth_m(
    material: &Material,
    speed_rad_s: f64,
    diameters: &RingDiameters,
    at_m: f64,
) -> f64 {
    let RingDiameters {
        inside_m,
        outside_m,
    } = diameters;
    let nu = material.poisson_ratio;
    let strain = material.density_kg_m3 * speed_rad_s.powi(2) * (3.0 + nu) * (1.0 - nu)
        / (32.0 * material.youngs_modulus_pa);
    let squares = inside_m.powi(2)
        + outside_m.powi(2)
        + (1.0 + nu) / (1.0 - nu) * (inside_m * outside_m / at_m).powi(2)
        - (1.0 + nu) / (3.0 + nu) * at_m.powi(2);
    strain * at_m * squares
}
