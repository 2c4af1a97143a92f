//! Seats of a mounted bearing: thick-walled cylinders that are pushed together.

use super::warmth::Warmth;
use crate::material::Material;
use crate::rotating_ring::{RingDiameters, rotating_growth_m};

/// Elastic constants of a cylinder.
#[derive(Debug, Clone, Copy)]
pub(super) struct Solid {
    pub youngs_modulus_pa: f64,
    pub poisson_ratio: f64,
}

/// Fit of a ring on its seat, in operation.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Seat {
    pub interference_m: f64,
    pub pressure_pa: f64,
    /// Loss of clearance by the pressure.
    pub reduction_m: f64,
}

/// Rings, shaft and housing of a mounted bearing, with diameters in m.
pub(super) struct Mounting<'a> {
    pub ring_material: &'a Material,
    pub ring: Solid,
    pub shaft: Solid,
    pub housing: Solid,
    /// Bottom of the inner groove.
    pub inner_m: f64,
    /// Bottom of the outer groove.
    pub outer_m: f64,
    /// Bore of the inner ring, if the fit has one.
    pub bore_m: Option<f64>,
    /// Bore diameter of the inner ring, or its estimate, m.
    pub ring_bore_m: f64,
    pub shaft_bore_m: f64,
    pub outside_m: Option<f64>,
    pub housing_outside_m: f64,
    pub inner_speed_rad_s: f64,
    pub warmth: Warmth,
}

impl Mounting<'_> {
    /// Growth of a diameter of the free inner ring by its rotation, m.
    pub(super) fn ring_growth_m(&self, at_m: f64) -> f64 {
        let diameters = RingDiameters {
            inside_m: self.ring_bore_m,
            outside_m: self.inner_m,
        };
        rotating_growth_m(self.ring_material, self.inner_speed_rad_s, &diameters, at_m)
    }

    /// Growth of the free shaft by its rotation, m.
    fn shaft_growth_m(&self, bore_m: f64) -> f64 {
        // Steel, aluminium and titanium have the same E/ρ within a third.
        let turning = Material {
            poisson_ratio: self.shaft.poisson_ratio,
            ..*self.ring_material
        };
        let diameters = RingDiameters {
            inside_m: self.shaft_bore_m,
            outside_m: bore_m,
        };
        rotating_growth_m(&turning, self.inner_speed_rad_s, &diameters, bore_m)
    }

    /// Seat of the inner ring on a shaft with this interference at 20 °C and at rest.
    pub(super) fn on_shaft(&self, mounted_m: f64) -> Seat {
        let Some(bore) = self.bore_m else {
            return Seat::default();
        };
        let warmth = &self.warmth;
        let interference_m = mounted_m
            + bore * (warmth.shaft_per_k * warmth.shaft_k - warmth.ring_per_k * warmth.inner_k)
            + self.shaft_growth_m(bore)
            - self.ring_growth_m(bore);
        let shaft = Cylinder {
            free_m: self.shaft_bore_m,
            solid: self.shaft,
        };
        let ring = Cylinder {
            free_m: self.inner_m,
            solid: self.ring,
        };
        let pressure_pa = pressure_pa(interference_m, bore, &shaft, &ring);
        Seat {
            interference_m,
            pressure_pa,
            reduction_m: free_side_m(pressure_pa, bore, self.inner_m, self.ring.youngs_modulus_pa),
        }
    }

    /// Seat of the outer ring in a housing with this interference at 20 °C.
    pub(super) fn in_housing(&self, mounted_m: f64) -> Seat {
        let Some(outside) = self.outside_m else {
            return Seat::default();
        };
        let warmth = &self.warmth;
        let expansion =
            warmth.ring_per_k * warmth.outer_k - warmth.housing_per_k * warmth.housing_k;
        let interference_m = mounted_m + outside * expansion;
        let ring = Cylinder {
            free_m: self.outer_m,
            solid: self.ring,
        };
        let housing = Cylinder {
            free_m: self.housing_outside_m,
            solid: self.housing,
        };
        let pressure_pa = pressure_pa(interference_m, outside, &ring, &housing);
        let modulus_pa = self.ring.youngs_modulus_pa;
        Seat {
            interference_m,
            pressure_pa,
            reduction_m: free_side_m(pressure_pa, outside, self.outer_m, modulus_pa),
        }
    }
}

/// A part of a fit.
struct Cylinder {
    /// Diameter of its other side, m.
    free_m: f64,
    solid: Solid,
}

/// Pressure between two cylinders that meet at the diameter d2, pushed together with an interference on the
/// diameter:
///
///   p = δ/d2 / ([(d1² + d2²)/(d1² − d2²) + ν1]/E1 + [(d2² + d3²)/(d2² − d3²) − ν2]/E2)
///
/// (Lamé; NTN 2203/E, table 8.6), 1 outside, 2 inside. 0 without interference: the two do not touch.
fn pressure_pa(interference_m: f64, d2: f64, inside: &Cylinder, outside: &Cylinder) -> f64 {
    // (1 + q²)/(1 − q²) with q of the smaller over the larger diameter; 1 of a solid shaft or a thick housing.
    let wall = |small: f64, large: f64| {
        let q = (small / large).powi(2);
        (1.0 + q) / (1.0 - q)
    };
    let outer =
        (wall(d2, outside.free_m) + outside.solid.poisson_ratio) / outside.solid.youngs_modulus_pa;
    let inner =
        (wall(inside.free_m, d2) - inside.solid.poisson_ratio) / inside.solid.youngs_modulus_pa;
    (interference_m / d2).max(0.0) / (outer + inner)
}

/// Change of the diameter of a ring at `far` under pressure on its diameter `near`, its other side free:
/// 2 p far/E / |(far/near)² − 1| at its outside, of the same form at its inside.
fn free_side_m(pressure_pa: f64, near: f64, far: f64, youngs_modulus_pa: f64) -> f64 {
    let [small, large] = [near.min(far), near.max(far)];
    let near_share = near * near / (large * large - small * small);
    2.0 * pressure_pa * far * near_share / youngs_modulus_pa
}
