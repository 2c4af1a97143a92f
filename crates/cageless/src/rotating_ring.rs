//! Expansion of a ring or shaft by its own rotation.
//!
//! ```
//! use cageless::Material;
//! use cageless::rotating_ring::rotating_growth_m;
//!
//! // The inner ring of Zhao 2022 on a bore of 30 mm at 30,000 rpm: its raceway grows by 3.3 µm.
//! let speed_rad_s = 30e3 / 60.0 * std::f64::consts::TAU;
//! let growth_m = rotating_growth_m(&Material::STEEL, speed_rad_s, [30e-3, 36.48e-3], 36.48e-3);
//! assert!((growth_m - 3.35e-6).abs() < 1e-8);
//! ```

use crate::material::Material;

/// Growth of the diameter `at_m` of a free ring of diameters `[d, D]` that rotates at ω, m:
///
///   Δ = ρ ω² x (3 + ν)(1 − ν)/(32 E) (d² + D² + (1 + ν)/(1 − ν) (d D/x)² − (1 + ν)/(3 + ν) x²)
///
/// at the diameter x, in plane stress (Timoshenko and Goodier, *Theory of Elasticity*, rotating disks); with d = 0 a
/// solid disk.
pub(crate) fn rotating_growth_m(
    material: &Material,
    speed_rad_s: f64,
    [inside_m, outside_m]: [f64; 2],
    at_m: f64,
) -> f64 {
    let nu = material.poisson_ratio;
    let strain = material.density_kg_m3 * speed_rad_s.powi(2) * (3.0 + nu) * (1.0 - nu)
        / (32.0 * material.youngs_modulus_pa);
    let squares = inside_m.powi(2)
        + outside_m.powi(2)
        + (1.0 + nu) / (1.0 - nu) * (inside_m * outside_m / at_m).powi(2)
        - (1.0 + nu) / (3.0 + nu) * at_m.powi(2);
    strain * at_m * squares
}
