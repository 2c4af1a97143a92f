//! SKF's model of the friction torque, of bearings with a cage in a lubricant.

use super::basic_ratings::BasicRatings;
use super::friction_torque::is_single_deep_groove;
use super::speed_factor::speed_factor_mm_rpm;
use crate::case::Case;
use crate::lubrication::{Lubricant, Lubrication, SkfConstants, SkfSeries};

/// μbl, sliding friction in boundary lubrication.
const BOUNDARY_FRICTION: f64 = 0.15;
/// KZ of single-row deep groove ball bearings.
const GEOMETRY_FACTOR: f64 = 3.1;
/// Viscosity of 1 mm²/s, m²/s.
const MM2_S: f64 = 1e-6;
/// N·mm in N·m.
const NMM: f64 = 1e-3;

/// Operation of a bearing in SKF's model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SkfOperation {
    /// d, mm.
    pub bore_mm: f64,
    /// D, mm.
    pub outside_mm: f64,
    /// n, rpm.
    pub speed_rpm: f64,
    /// Fr, N.
    pub radial_load_n: f64,
    /// Fa, N, of either direction.
    pub axial_load_n: f64,
    /// C0, N.
    pub static_rating_n: f64,
}

/// Parts of SKF's friction torque of an open deep groove ball bearing, without drag of an oil bath (SKF, *General
/// catalogue* 6000 (2006), pp. 87 to 103; μsl also *Rolling bearings* 10000 EN, p. 105). The constants hold for
/// bearings with a cage and are SKF's own; for a full complement of balls, and for dry ones, SKF publishes none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkfFriction {
    /// φish φrs Mrr, rolling, N·m.
    pub rolling_n_m: f64,
    /// Msl, sliding, N·m.
    pub sliding_n_m: f64,
}

impl SkfFriction {
    /// Torque of a bearing in operation:
    ///
    ///   φish φrs Mrr = φish φrs R1 dm^1.96 (Fr + R2/sin αF Fa)^0.54 (ν n)^0.6 N·mm,
    ///   Msl = μsl S1 dm^(−0.26) Fr^(5/3) N·mm without Fa,
    ///   Msl = μsl S1 dm^(−0.145) (Fr⁵ + S2 dm^1.5/sin αF Fa⁴)^(1/3) N·mm with it, αF = 24.6° (Fa/C0)^0.24,
    ///   φish = 1/(1 + 1.84·10⁻⁹ (n dm)^1.28 ν^0.64),  φrs = exp(−Krs ν n (d + D) √(KZ/(2 (D − d)))),
    ///   μsl = φbl 0.15 + (1 − φbl) μEHL,  φbl = exp(−2.6·10⁻⁸ (n ν)^1.4 dm),
    ///
    /// with dm = (d + D)/2 in mm, n in rpm, ν in mm²/s, loads in N. The two equations of Msl are SKF's and differ
    /// by a factor dm^0.115 at Fa = 0.
    pub(crate) fn new(
        series: SkfSeries,
        lubrication: &Lubrication,
        operation: SkfOperation,
    ) -> Self {
        let SkfConstants { r1, r2, s1, s2 } = series.constants();
        let starvation = match lubrication.lubricant {
            Lubricant::Oil => 3e-8,
            Lubricant::Grease => 6e-8,
        };
        let SkfOperation {
            bore_mm,
            outside_mm,
            speed_rpm,
            ..
        } = operation;
        let [fr, fa] = [operation.radial_load_n, operation.axial_load_n].map(f64::abs);
        let nu = lubrication.viscosity_m2_s / MM2_S;
        let (dm, film) = (0.5 * (bore_mm + outside_mm), nu * speed_rpm);
        let shear = 1.0 / (1.0 + 1.84e-9 * (speed_rpm * dm).powf(1.28) * nu.powf(0.64));
        let section = GEOMETRY_FACTOR / (2.0 * (outside_mm - bore_mm));
        let replenishment = (-starvation * film * 2.0 * dm * section.sqrt()).exp();
        let boundary = (-2.6e-8 * film.powf(1.4) * dm).exp();
        let friction =
            boundary * BOUNDARY_FRICTION + (1.0 - boundary) * lubrication.film_friction_coefficient;
        let [rolling, sliding] = match fa > 0.0 {
            false => [r1 * fr.powf(0.54), s1 * dm.powf(-0.26) * fr.powf(5.0 / 3.0)],
            true => {
                let angle_deg = 24.6 * (fa / operation.static_rating_n).powf(0.24);
                let sin = angle_deg.to_radians().sin();
                let load = fr.powi(5) + s2 * dm.powf(1.5) / sin * fa.powi(4);
                [
                    r1 * (fr + r2 / sin * fa).powf(0.54),
                    s1 * dm.powf(-0.145) * load.cbrt(),
                ]
            }
        };
        Self {
            rolling_n_m: NMM * shear * replenishment * rolling * dm.powf(1.96) * film.powf(0.6),
            sliding_n_m: NMM * friction * sliding,
        }
    }

    /// Torque of a case with a lubricant and a series, with d and D of the case, or d of a bore 0.3 ball diameters
    /// below the groove and D = 2 Dpw − d.
    pub(super) fn of(case: &Case, lubrication: &Lubrication, basic: &BasicRatings) -> Option<Self> {
        let series = lubrication.skf_series?;
        let bearing = &case.bearing;
        if !is_single_deep_groove(case) {
            return None;
        }
        let bore_mm = 2e3 * bearing.bore_radius_or_estimate_m();
        let outside_mm = bearing.outside_radius_m().map_or_else(
            || 4e3 * bearing.pitch_radius_m() - bore_mm,
            |radius_m| 2e3 * radius_m,
        );
        let operation = SkfOperation {
            bore_mm,
            outside_mm,
            speed_rpm: speed_factor_mm_rpm(case) / (2e3 * bearing.pitch_radius_m()),
            radial_load_n: case.operation.radial_load_n,
            axial_load_n: case.operation.space.axial_load_n,
            static_rating_n: basic.static_n,
        };
        Some(Self::new(series, lubrication, operation))
    }

    /// M, the sum, N·m.
    pub fn torque_n_m(&self) -> f64 {
        self.rolling_n_m + self.sliding_n_m
    }
}
