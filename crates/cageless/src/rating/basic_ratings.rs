//! Basic dynamic radial load rating (ISO 281) and basic static radial load rating (ISO 76) of
//! a single-row deep groove ball bearing.

use super::ratios::{Conformities, gamma, raceway_ratio};
use crate::bearing::Bearing;
use crate::contact::hertz::{PointContact, STRESS_LIMIT_PA};
use crate::material::Material;

/// λ, reduction for the deviation of the contacts of a single-row radial bearing (ISO/TR 1281-1).
const REDUCTION: f64 = 0.95;
/// 0.41 A1 with A1 = 98.0665, the material constant in N and mm (ISO/TR 1281-1).
const MATERIAL_CONSTANT: f64 = 0.41 * 98.0665;
/// Ball diameter up to which the rating grows with Dw^1.8, mm.
const SMALL_BALL_MM: f64 = 25.4;
/// 25.4^0.4 as ISO 281 rounds it.
const LARGE_BALL_FACTOR: f64 = 3.647;
/// Stribeck's number in ISO 76: the most loaded ball carries 5 Fr/Z.
const STRIBECK: f64 = 5.0;
/// Peak pressure at the fatigue load limit, Pa (ISO 281:2007).
const FATIGUE_PRESSURE_PA: f64 = 1.5e9;
/// Pitch diameter above which the fatigue load limit falls, mm (ISO 281:2007, Annex B).
const FATIGUE_PITCH_MM: f64 = 100.0;
/// Jr of Stribeck's half-loaded distribution: Fr = Jr Z Q of a bearing without clearance.
const RADIAL_INTEGRAL: f64 = 0.2288;
/// Steel of the tables of ISO 76 (ISO/TR 10657).
const STEEL: Material = Material {
    density_kg_m3: 7850.0,
    youngs_modulus_pa: 207e9,
    poisson_ratio: 0.3,
};

/// Basic load ratings of a bearing with plain grooves and steel balls; the dynamic one holds for
/// silicon nitride balls in steel rings, too (ISO 20056-1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BasicRatings {
    /// Cr of ISO 281, N.
    pub dynamic_n: f64,
    /// C0r of ISO 76, N.
    pub static_n: f64,
}

impl BasicRatings {
    /// Ratings from ball set and grooves:
    ///
    ///   Cr = bm fc (i cos α0)^0.7 Z^(2/3) Dw^1.8, Dw in mm (3.647 Dw^1.4 above 25.4 mm),
    ///   C0r = f0 i Z Dw² cos α0,
    ///
    /// with bm of the [way of assembly](crate::Assembly::rating_factor), for one row, i = 1.
    pub fn new(bearing: &Bearing) -> Self {
        Self::of_rows(bearing, 1)
    }

    /// Ratings of i equal rows.
    pub fn of_rows(bearing: &Bearing, rows: usize) -> Self {
        let across = rows as f64 * bearing.contact_angle_rad().cos();
        let z = bearing.balls() as f64;
        let diameter_mm = 2e3 * bearing.ball_radius_m();
        let (gamma, grooves) = (gamma(bearing), Conformities::of(bearing));
        let size = if diameter_mm <= SMALL_BALL_MM {
            diameter_mm.powf(1.8)
        } else {
            LARGE_BALL_FACTOR * diameter_mm.powf(1.4)
        };
        Self {
            dynamic_n: bearing.assembly().rating_factor()
                * dynamic_factor(gamma, Conformities::rated(bearing))
                * z.powf(2.0 / 3.0)
                * size
                * across.powf(0.7),
            static_n: static_factor(gamma, grooves) * z * diameter_mm.powi(2) * across,
        }
    }

    /// Cu of ISO 281:2007, Annex B, N: the radial load under which the peak pressure of the most loaded contact is
    /// 1500 MPa, and less in large bearings. From Q ∝ p³ and Fr = 0.2288 Z Q of a bearing without clearance, against
    /// 4200 MPa and Z Q/5 in C0r:
    ///
    ///   Cu = 5 · 0.2288 (1500/4200)³ C0r, times (100 mm/Dpw)^(1/2) above Dpw = 100 mm.
    pub(crate) fn fatigue_load_limit_n(&self, pitch_diameter_mm: f64) -> f64 {
        let pressure = (FATIGUE_PRESSURE_PA / STRESS_LIMIT_PA).powi(3);
        let size = (FATIGUE_PITCH_MM / pitch_diameter_mm).sqrt().min(1.0);
        STRIBECK * RADIAL_INTEGRAL * pressure * size * self.static_n
    }

    /// L10 = (Cr/P)³, million revolutions, of an equivalent dynamic load P above 0.
    pub(crate) fn l10_mrev(&self, dynamic_load_n: f64) -> f64 {
        (self.dynamic_n / dynamic_load_n).powi(3)
    }

    /// s0 = C0r/P0 of an equivalent static load P0 above 0.
    pub(crate) fn static_safety_factor(&self, static_load_n: f64) -> f64 {
        self.static_n / static_load_n
    }
}

/// fc of ISO 281 at γ = Dw/Dpw for grooves of radius `inner` and `outer` × Dw:
///
///   fc = 0.41 A1 λ (1 + a^(10/3))^(−3/10) γ^0.3 (1 − γ)^1.39/(1 + γ)^(1/3) (2ri/(2ri − Dw))^0.41,
///   a = 1.04 ((1 − γ)/(1 + γ))^1.72 (ri/re · (2re − Dw)/(2ri − Dw))^0.41
///
/// (ISO/TR 1281-1). The table of ISO 281 is this at 0.52 for both; ratings take no less
/// ([`Conformities::rated`]).
pub(crate) fn dynamic_factor(gamma: f64, grooves: Conformities) -> f64 {
    let ratio = raceway_ratio(1.04, gamma, grooves);
    let inner = grooves.inner;
    MATERIAL_CONSTANT
        * REDUCTION
        * (1.0 + ratio.powf(10.0 / 3.0)).powf(-0.3)
        * gamma.powf(0.3)
        * (1.0 - gamma).powf(1.39)
        / (1.0 + gamma).cbrt()
        * (2.0 * inner / (2.0 * inner - 1.0)).powf(0.41)
}

/// f0 of ISO 76 at γ = Dw/Dpw for grooves of radius `inner` and `outer` × Dw, N/mm²: Q/(5 Dw²)
/// with the load Q under which the peak pressure at the more stressed raceway is 4200 MPa, by
/// Hertz with the steel of the standard (207 GPa, ν = 0.3). The table of ISO 76 is this at
/// 0.52 inside and 0.53 outside.
pub(crate) fn static_factor(gamma: f64, grooves: Conformities) -> f64 {
    // Dw = 1: the ball has the curvature 2, the rings ±2γ/(1 ∓ γ) in the plane of rolling.
    let ball = [2.0; 2];
    let raceways = [
        [2.0 * gamma / (1.0 - gamma), -1.0 / grooves.inner],
        [-2.0 * gamma / (1.0 + gamma), -1.0 / grooves.outer],
    ];
    raceways
        .map(|ring| {
            // The pressure grows with the cube root of the load; Q is in Pa times Dw².
            let unit = PointContact::new(ball, ring, &STEEL).peak_pressure_pa(1.0);
            (STRESS_LIMIT_PA / unit).powi(3) * 1e-6 / STRIBECK
        })
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}
