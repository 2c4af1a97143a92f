//! Ratings from the lubricant, by ISO 281 and catalogues: viscosity ratio, modified life, minimum load.

use super::Rating;
use super::skf_friction::SkfFriction;
use super::speed_factor::speed_factor_mm_rpm;
use crate::case::Case;
use crate::lubrication::Lubrication;

/// Speed at which the equation of the reference viscosity changes, rpm.
const SLOW_RPM: f64 = 1000.0;
/// Relative difference of two speeds that are the same, in rounded units.
const SPEED_ROUNDING: f64 = 1e-9;
/// κ below which ISO 281 has no life modification factor.
pub const VISCOSITY_RATIO_MIN: f64 = 0.1;
/// κ above which the factor is that at it.
const VISCOSITY_RATIO_MAX: f64 = 4.0;
/// Largest life modification factor.
const FACTOR_MAX: f64 = 50.0;
/// Viscosity of 1 mm²/s, m²/s.
const MM2_S: f64 = 1e-6;

/// ν1, the viscosity for an adequate film at a speed in rpm and a pitch diameter in mm, m²/s:
///
///   ν1 = 45000 n^(−0.83) Dpw^(−1/2) mm²/s below 1000 rpm, 4500 n^(−1/2) Dpw^(−1/2) mm²/s from there on
///
/// (ISO 281:2007; NTN 2203/E, Eq. (3.10), (3.11)).
pub(crate) fn reference_viscosity_m2_s(speed_rpm: f64, pitch_diameter_mm: f64) -> f64 {
    // A speed that went through rad/s is a rounding off; the two equations differ by 2.3 % here.
    let speed = if speed_rpm < SLOW_RPM * (1.0 - SPEED_ROUNDING) {
        45_000.0 * speed_rpm.powf(-0.83)
    } else {
        4500.0 * speed_rpm.powf(-0.5)
    };
    MM2_S * speed * pitch_diameter_mm.powf(-0.5)
}

/// aISO of a radial ball bearing from the viscosity ratio κ and eC Cu/P:
///
///   aISO = 0.1 (1 − (2.5671 − k(κ))^0.83 (eC Cu/P)^(1/3))^(−9.3), at most 50,
///
/// k = 2.2649 κ^(−0.054381) below κ = 0.4, 1.9987 κ^(−0.19087) up to 1, 1.9987 κ^(−0.071739) up to 4,
/// beyond which κ counts as 4 (ISO 281:2007). `None` below κ = 0.1, which the standard does not rate.
pub(crate) fn life_modification_factor(viscosity_ratio: f64, load_ratio: f64) -> Option<f64> {
    let kappa = viscosity_ratio.min(VISCOSITY_RATIO_MAX);
    let k = match kappa {
        _ if !(kappa >= VISCOSITY_RATIO_MIN) => return None,
        _ if kappa < 0.4 => 2.2649 * kappa.powf(-0.054381),
        // Copies of the standard with 0.019087 here are misprints: not continuous at κ = 0.4.
        _ if kappa < 1.0 => 1.9987 * kappa.powf(-0.19087),
        _ => 1.9987 * kappa.powf(-0.071739),
    };
    let rest = 1.0 - (2.5671 - k).powf(0.83) * load_ratio.cbrt();
    Some(if rest > 0.0 {
        (0.1 * rest.powf(-9.3)).min(FACTOR_MAX)
    } else {
        FACTOR_MAX
    })
}

/// Frm, minimum radial load of a deep groove ball bearing by SKF, N:
///
///   Frm = kr (ν n/1000)^(2/3) (dm/100)² kN, ν in mm²/s, n in rpm, dm in mm
///
/// (SKF PUB 17000 (2018), p. 254), with Dpw for dm = (d + D)/2.
pub(crate) fn minimum_radial_load_n(
    factor: f64,
    viscosity_m2_s: f64,
    speed_rpm: f64,
    pitch_diameter_mm: f64,
) -> f64 {
    let film = (viscosity_m2_s / MM2_S * speed_rpm / 1000.0).powf(2.0 / 3.0);
    1000.0 * factor * film * (pitch_diameter_mm / 100.0).powi(2)
}

/// Ratings of a bearing with its lubricant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LubricatedRating {
    /// κ = ν/ν1.
    pub viscosity_ratio: f64,
    /// Cu, N.
    pub fatigue_load_limit_n: f64,
    /// aISO at P; `None` without P, and below κ = 0.1.
    pub life_modification_factor: Option<f64>,
    /// L10m = aISO L10, million revolutions; `None` where there is no aISO.
    pub l10m_mrev: Option<f64>,
    /// L10mr = aISO L10r with aISO at Pref = Cr/L10r^(1/3), million revolutions (ISO/TS 16281); `None` without L10r,
    /// and below κ = 0.1.
    pub l10mr_mrev: Option<f64>,
    /// Frm of SKF, N; `None` unless the factor of the bearing is given.
    pub minimum_radial_load_n: Option<f64>,
    /// Friction by SKF's model; `None` unless the series of the bearing is given, with a contact angle, moments, a
    /// tilt or several rows.
    pub skf_friction: Option<SkfFriction>,
}

impl LubricatedRating {
    /// Ratings of a case with a lubricant from those without regard to it; `None` at standstill.
    pub fn new(case: &Case, rating: &Rating, lubrication: &Lubrication) -> Option<Self> {
        let basic = &rating.basic;
        let pitch_diameter_mm = 2e3 * case.bearing.pitch_radius_m();
        let speed_rpm = speed_factor_mm_rpm(case) / pitch_diameter_mm;
        if speed_rpm == 0.0 {
            return None;
        }
        let viscosity = lubrication.viscosity_m2_s;
        let viscosity_ratio = viscosity / reference_viscosity_m2_s(speed_rpm, pitch_diameter_mm);
        let limit_n = lubrication
            .fatigue_load_limit_n
            .unwrap_or_else(|| basic.fatigue_load_limit_n(pitch_diameter_mm));
        let modified = |load_n: f64| {
            let load_ratio = lubrication.contamination_factor * limit_n / load_n;
            life_modification_factor(viscosity_ratio, load_ratio)
        };
        let factor = rating.equivalent.and_then(|load| modified(load.dynamic_n));
        let reference = |life: f64| Some(modified(basic.dynamic_n / life.cbrt())? * life);
        let minimum = |kr| minimum_radial_load_n(kr, viscosity, speed_rpm, pitch_diameter_mm);
        Some(Self {
            viscosity_ratio,
            fatigue_load_limit_n: limit_n,
            life_modification_factor: factor,
            l10m_mrev: factor
                .zip(rating.l10_mrev)
                .map(|(factor, life)| factor * life),
            l10mr_mrev: rating.l10r_mrev.and_then(reference),
            minimum_radial_load_n: lubrication.minimum_load_factor.map(minimum),
            skf_friction: (rating.equivalent)
                .and_then(|_| SkfFriction::of(case, lubrication, basic)),
        })
    }
}
