//! Losses beyond the heat that a bearing gives off.

use std::f64::consts::TAU;

use cageless::Bearing;

use crate::number_text::short;

/// Heat flow per surface that a radial ball bearing gives off at 70 °C in surroundings of 20 °C,
/// W/m² (reference conditions of ISO 15312 for a surface up to 50,000 mm²).
const REFERENCE_HEAT_FLOW_W_M2: f64 = 16e3;
/// Assumed width of the bearing over the diameter of its balls; ISO 15 has 1.3 to 1.9 in the
/// series 60, 62 and 63.
const WIDTH_OVER_BALL_DIAMETER: f64 = 1.9;

/// Warning about a power loss, W, beyond the heat that a bearing gives off.
pub fn overheating(bearing: &Bearing, heat_w: f64) -> Option<String> {
    let diameter_mm = 2e3 * bearing.pitch_radius_m();
    let width_mm = WIDTH_OVER_BALL_DIAMETER * 2e3 * bearing.ball_radius_m();
    // ISO 15312: π·B·(D + d), with D + d = 2·dm.
    let surface_mm2 = TAU * width_mm * diameter_mm;
    let reference_w = REFERENCE_HEAT_FLOW_W_M2 * 1e-6 * surface_mm2;
    (heat_w > reference_w).then(|| {
        format!(
            "the power loss of {} W is {} times the {reference_w:.0} W that a bearing of this \
             size gives off at 70 °C (reference conditions of ISO 15312, width taken as \
             {width_mm:.0} mm): it overheats in continuous running without cooling",
            short(heat_w),
            short(heat_w / reference_w)
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use cageless::reference;

    /// 16 kW/m² of the surface π·B·(D + d): of the bearing of Zhao 2022 84 W, 9.5 mm balls on 46 mm.
    #[test]
    fn a_bearing_gives_off_what_iso_15312_has() {
        let bearing = reference::bearing();
        let reference_w = 16e3 * std::f64::consts::PI * 1.9 * 9.525e-3 * 2.0 * 46.005e-3;
        assert_eq!(overheating(&bearing, 0.999 * reference_w), None);
        let text = overheating(&bearing, 2.0 * reference_w).unwrap();
        assert!(text.contains("is 2 times the 84 W"), "{text}");
    }
}
