//! Hertzian point contact of two curved bodies, from complete elliptic integrals.
//!
//! Source: K. L. Johnson, *Contact Mechanics* (1985), sections 4.1 and 4.2.

use std::f64::consts::PI;

use crate::material::Material;
use crate::numerics::taylor::Taylor;
use crate::numerics::{elliptic, root};

/// Largest pressure that a ball bearing is to bear: 4200 MPa leave an indentation of some
/// 1e-4 of the ball's diameter (ISO 76).
pub const STRESS_LIMIT_PA: f64 = 4.2e9;
/// Deflection that no elastic contact survives, as a fraction of the ball radius.
pub(crate) const DEFLECTION_FRACTION_MAX: f64 = 0.05;

/// Elastic energy 2/5 K δ^(5/2) of a contact with stiffness K in N·m^(−3/2), J; 0 for δ < 0.
pub(crate) fn energy_j(stiffness_n_m1_5: f64, deflection_m: f64) -> f64 {
    0.4 * stiffness_n_m1_5 * deflection_m.max(0.0).powf(2.5)
}

/// Constants of a point contact. The load–deflection law is F = K δ^(3/2).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PointContact {
    /// K, N·m^(−3/2).
    pub stiffness_n_m1_5: f64,
    /// Semi-axis along the first principal direction, per N^(1/3).
    first_axis_m_n1_3: f64,
    /// Semi-axis along the second principal direction, per N^(1/3).
    second_axis_m_n1_3: f64,
}

/// E* of two bodies of one material: 1/E* = 2(1 − ν²)/E (Johnson, Eq. (3.28) and
/// (4.24)).
pub(crate) fn contact_modulus_pa(material: &Material) -> f64 {
    material.youngs_modulus_pa / (2.0 * (1.0 - material.poisson_ratio.powi(2)))
}

/// E* of two bodies: 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂ (Johnson, Eq. (4.24)).
pub(crate) fn modulus_of_pair_pa([one, other]: [&Material; 2]) -> f64 {
    // Elastically equal bodies keep the one rounding of the short form.
    let elastic = |m: &Material| (m.youngs_modulus_pa, m.poisson_ratio);
    if elastic(one) == elastic(other) {
        return contact_modulus_pa(one);
    }
    let compliance = |m: &Material| (1.0 - m.poisson_ratio.powi(2)) / m.youngs_modulus_pa;
    1.0 / (compliance(one) + compliance(other))
}

impl PointContact {
    /// Contact of two bodies of one material; see [`PointContact::between`].
    pub(crate) fn new(one: [f64; 2], other: [f64; 2], material: &Material) -> Self {
        Self::between(one, other, [material; 2])
    }

    /// Contact of two bodies whose principal curvatures (1/m, convex positive)
    /// lie in common planes: first the plane of rolling, then the meridian plane.
    /// The sums of curvatures in both planes must be positive.
    pub(crate) fn between(one: [f64; 2], other: [f64; 2], materials: [&Material; 2]) -> Self {
        let (rolling, meridian) = (one[0] + other[0], one[1] + other[1]);
        let (steep, flat) = (rolling.max(meridian), rolling.min(meridian));
        // A and B of z = A x² + B y², with the long axis a along x.
        let (a_curv, b_curv) = (flat / 2.0, steep / 2.0);
        let m = eccentricity_squared(b_curv / a_curv);
        let (k, e) = elliptic::complete(m);
        let modulus = modulus_of_pair_pa(materials);
        // Johnson (4.26): A = p₀/E* · (b/(e²a²)) (K − E), δ = p₀/E* · b K, with
        // p₀ = 3F/(2πab) and b = a √(1 − m):
        // a³ = 3F (K − E)/(2π E* m A);  δ = 3F K/(2π a E*).
        let k_minus_e_over_m = if m < 1e-8 { PI / 4.0 } else { (k - e) / m };
        let long = (3.0 * k_minus_e_over_m / (2.0 * PI * modulus * a_curv)).cbrt();
        let short = long * (1.0 - m).sqrt();
        let deflection = 3.0 * k / (2.0 * PI * long * modulus);
        let (first, second) = if rolling > meridian {
            (short, long)
        } else {
            (long, short)
        };
        Self {
            stiffness_n_m1_5: deflection.powf(-1.5),
            first_axis_m_n1_3: first,
            second_axis_m_n1_3: second,
        }
    }

    /// Semi-axes of the contact ellipse under `load_n`: along the rolling
    /// direction, then across it.
    pub(crate) fn semi_axes_m(&self, load_n: f64) -> [f64; 2] {
        let scale = load_n.max(0.0).cbrt();
        [
            self.first_axis_m_n1_3 * scale,
            self.second_axis_m_n1_3 * scale,
        ]
    }

    /// Largest pressure p₀ = 3F/(2πab) under `load_n`; 0 without load.
    pub(crate) fn peak_pressure_pa(&self, load_n: f64) -> f64 {
        if load_n <= 0.0 {
            return 0.0;
        }
        let [a, b] = self.semi_axes_m(load_n);
        1.5 * load_n / (PI * a * b)
    }
}

/// m = e² of the contact ellipse whose ratio of relative curvatures is
/// B/A = ratio ≥ 1: B/A = (E/(1 − m) − K)/(K − E) (Johnson, Eq. (4.28)).
fn eccentricity_squared(ratio: f64) -> f64 {
    // The relation starts as 1 + 3m/4, too flat for the root finder below this.
    if ratio < 1.0 + 1e-7 {
        return 4.0 / 3.0 * (ratio - 1.0).max(0.0);
    }
    let residual = |log_q: f64| {
        let q = log_q.exp();
        let (k, e) = elliptic::complete(1.0 - q);
        ((e / q - k) / (k - e)).ln() - ratio.ln()
    };
    // q = (b/a)²; thinner ellipses than 1e-8 : 1 are lines.
    let log_q = root::brent(residual, (1e-16f64).ln(), (1.0f64 - 1e-8).ln(), 1e-15);
    1.0 - log_q.map_or(1e-16, f64::exp)
}

/// Closed form of the elastic impact of two equal spheres under F = K δ^(3/2)
/// (Johnson, *Contact Mechanics*, section 11.4): largest deflection, largest force and
/// duration at approach speed `speed_m_s`, with m the mass of one sphere.
pub(crate) fn impact(stiffness_n_m1_5: f64, mass_kg: f64, speed_m_s: f64) -> (f64, f64, f64) {
    let reduced = mass_kg / 2.0;
    let deflection = (1.25 * reduced * speed_m_s.powi(2) / stiffness_n_m1_5).powf(0.4);
    // 2 ∫₀¹ dx/√(1 − x^(5/2)) = 2 √π Γ(2/5)/(5/2 · Γ(9/10)).
    const SHAPE: f64 = 2.943_275_064_2;
    (
        deflection,
        stiffness_n_m1_5 * deflection.powf(1.5),
        SHAPE * deflection / speed_m_s,
    )
}

/// Energy ⅖ K δ^(5/2), J, of a contact pressed in by δ > 0, m.
pub(crate) fn elastic_energy<const N: usize>(stiffness: f64, approach: Taylor<N>) -> Taylor<N> {
    let (depth, root) = (approach.value, approach.value.sqrt());
    let force = stiffness * depth * root;
    approach.map([0.4 * force * depth, force, 1.5 * stiffness * root])
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: Material = Material {
        density_kg_m3: 7850.0,
        youngs_modulus_pa: 206e9,
        poisson_ratio: 0.3,
    };

    /// Johnson, Eq. (4.22) to (4.24): two spheres.
    #[test]
    fn spheres() {
        let radius = 4.7625e-3;
        let c = PointContact::new([1.0 / radius; 2], [1.0 / radius; 2], &STEEL);
        let modulus = contact_modulus_pa(&STEEL);
        let expected = 4.0 / 3.0 * modulus * (radius / 2.0).sqrt();
        assert!((c.stiffness_n_m1_5 / expected - 1.0).abs() < 1e-12);
        let load = 100.0;
        let a = (3.0 * load * radius / 2.0 / (4.0 * modulus)).cbrt();
        assert!((c.semi_axes_m(load)[0] / a - 1.0).abs() < 1e-12);
        assert!((c.semi_axes_m(load)[1] / a - 1.0).abs() < 1e-12);
        let p0 = (6.0 * load * modulus.powi(2) / (PI.powi(3) * (radius / 2.0).powi(2))).cbrt();
        assert!((c.peak_pressure_pa(load) / p0 - 1.0).abs() < 1e-12);
    }

    /// Two spheres of two materials: K = 4/3 E* √R with
    /// 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, whichever comes first.
    #[test]
    fn spheres_of_two_materials() {
        let ceramic = Material {
            density_kg_m3: 3250.0,
            youngs_modulus_pa: 310e9,
            poisson_ratio: 0.26,
        };
        let (one, other) = ([1.0 / 5e-3; 2], [1.0 / 3e-3; 2]);
        let radius = 1.0 / (1.0 / 5e-3 + 1.0 / 3e-3);
        let modulus = 1.0 / ((1.0 - 0.26 * 0.26) / 310e9 + (1.0 - 0.09) / 206e9);
        let expected = 4.0 / 3.0 * modulus * f64::sqrt(radius);
        let pressure =
            |load: f64| (6.0 * load * modulus.powi(2) / (PI.powi(3) * radius.powi(2))).cbrt();
        for materials in [[&ceramic, &STEEL], [&STEEL, &ceramic]] {
            let contact = PointContact::between(one, other, materials);
            assert!((contact.stiffness_n_m1_5 / expected - 1.0).abs() < 1e-9);
            assert!((contact.peak_pressure_pa(100.0) / pressure(100.0) - 1.0).abs() < 1e-9);
        }
        let same = PointContact::between(one, other, [&STEEL, &{ STEEL }]);
        assert_eq!(same, PointContact::new(one, other, &STEEL));
    }

    /// Crossed equal cylinders touch in a circle, like a sphere on a plane.
    #[test]
    fn crossed_cylinders() {
        let c = PointContact::new([100.0, 0.0], [0.0, 100.0], &STEEL);
        let s = PointContact::new([100.0, 100.0], [0.0, 0.0], &STEEL);
        assert!((c.stiffness_n_m1_5 / s.stiffness_n_m1_5 - 1.0).abs() < 1e-12);
    }

    /// Continuous where the round-contact shortcut takes over.
    #[test]
    fn nearly_round() {
        let k = |x: f64| PointContact::new([100.0, 100.0 * x], [0.0; 2], &STEEL).stiffness_n_m1_5;
        assert!((k(1.0 + 2e-7) / k(1.0 + 0.5e-7) - 1.0).abs() < 1e-6);
        assert!((k(1.0 + 1.01e-7) / k(1.0 + 0.99e-7) - 1.0).abs() < 1e-8);
    }

    /// The defining relation of the ellipse holds for slender contacts, too, and the
    /// long axis lies across the plane of larger curvature.
    #[test]
    fn slender_ellipse() {
        let c = PointContact::new([210.0, 210.0], [55.0, -202.0], &STEEL);
        let [rolling, across] = c.semi_axes_m(1.0);
        assert!(across > 5.0 * rolling);
        let m = 1.0 - (rolling / across).powi(2);
        let (k, e) = elliptic::complete(m);
        let ratio = (e / (1.0 - m) - k) / (k - e);
        assert!((ratio / (265.0 / 8.0) - 1.0).abs() < 1e-9, "{ratio}");
    }
}
