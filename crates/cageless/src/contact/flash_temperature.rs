//! Flash temperature of sliding contacts (Blok 1937).
//!
//! ```
//! use cageless::contact::FLASH_TEMPERATURE_LIMIT_K;
//!
//! assert_eq!(FLASH_TEMPERATURE_LIMIT_K, 150.0);
//! ```

use std::f64::consts::FRAC_PI_2;

/// Thermal effusivity √(kρc) of bearing steel 100Cr6, W·s^½/(m²·K): k = 46 W/(m·K),
/// ρ = 7850 kg/m³, c = 460 J/(kg·K).
pub(crate) const STEEL_EFFUSIVITY: f64 = 12_888.0;

/// Flash temperature from which a bearing surface is expected to fail, K: bearing steel 100Cr6 is
/// tempered at 150 to 200 °C and softens above (ISO 683-17); oil films break down at about the
/// same temperature.
pub const FLASH_TEMPERATURE_LIMIT_K: f64 = 150.0;

/// Blok's flash temperature at the centre of a Hertzian contact, K: the momentary rise of the
/// surface above the bodies,
///
/// T = 1.11·μ·w·|√V₁ − √V₂| / (B·√(2a)), with w = π/2·p₀·a,
///
/// for two bodies of equal thermal effusivity B whose surfaces pass the contact at `speeds_m_s`,
/// with the peak pressure p₀, the semi-axis a in the direction of rolling, and w the load per
/// length across it. Surfaces that move in opposite directions slide at |V₁| + |V₂|; the
/// difference of the roots is then |V₁ − V₂|/(√|V₁| + √|V₂|).
///
/// Source: H. Blok, General Discussion on Lubrication, IMechE 1937; ISO/TS 6336-20.
pub(crate) fn flash_temperature_k(
    friction_coefficient: f64,
    peak_pressure_pa: f64,
    semi_axis_m: f64,
    speeds_m_s: [f64; 2],
    effusivity: f64,
) -> f64 {
    let [one, other] = speeds_m_s;
    let roots = one.abs().sqrt() + other.abs().sqrt();
    if roots == 0.0 || semi_axis_m <= 0.0 {
        return 0.0;
    }
    let line_load = FRAC_PI_2 * peak_pressure_pa * semi_axis_m;
    1.11 * friction_coefficient * line_load * (one - other).abs()
        / (roots * effusivity * (2.0 * semi_axis_m).sqrt())
}
