//! SKF's model of the friction torque, of bearings with a cage in a lubricant.

use crate::case::Case;
use crate::lubrication::{Lubricant, Lubrication, SkfSeries};

/// μbl, sliding friction in boundary lubrication.
const BOUNDARY_FRICTION: f64 = 0.15;
/// KZ of single-row deep groove ball bearings.
const GEOMETRY_FACTOR: f64 = 3.1;
/// Viscosity of 1 mm²/s, m²/s.
const MM2_S: f64 = 1e-6;
/// N·mm in N·m.
const NMM: f64 = 1e-3;

/// Parts of SKF's friction torque of an open deep groove ball bearing under radial load, without drag of an
/// oil bath (SKF, *General catalogue* 6000 (2006), pp. 87 to 103; μsl also *Rolling bearings* 10000 EN,
/// p. 105). The constants hold for bearings with a cage and are SKF's own; for a full complement of balls,
/// and for dry ones, SKF publishes none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkfFriction {
    /// φish φrs Mrr, rolling, N·m.
    pub rolling_n_m: f64,
    /// Msl, sliding, N·m.
    pub sliding_n_m: f64,
}

impl SkfFriction {
    /// Torque of a bearing with bore and outside diameter `[d, D]` in mm under Fr at n:
    ///
    ///   φish φrs Mrr = φish φrs R1 dm^1.96 Fr^0.54 (ν n)^0.6,  Msl = μsl S1 dm^(−0.26) Fr^(5/3) N·mm,
    ///   φish = 1/(1 + 1.84·10⁻⁹ (n dm)^1.28 ν^0.64),  φrs = exp(−Krs ν n (d + D) √(KZ/(2 (D − d)))),
    ///   μsl = φbl 0.15 + (1 − φbl) μEHL,  φbl = exp(−2.6·10⁻⁸ (n ν)^1.4 dm),
    ///
    /// with dm = (d + D)/2 in mm, n in rpm, ν in mm²/s, Fr in N.
    pub fn new(
        series: SkfSeries,
        lubrication: &Lubrication,
        [bore_mm, outside_mm]: [f64; 2],
        speed_rpm: f64,
        radial_load_n: f64,
    ) -> Self {
        let [rolling, sliding] = series.constants();
        let starvation = match lubrication.lubricant {
            Lubricant::Oil => 3e-8,
            Lubricant::Grease => 6e-8,
        };
        let nu = lubrication.viscosity_m2_s / MM2_S;
        let (dm, film) = (0.5 * (bore_mm + outside_mm), nu * speed_rpm);
        let shear = 1.0 / (1.0 + 1.84e-9 * (speed_rpm * dm).powf(1.28) * nu.powf(0.64));
        let section = GEOMETRY_FACTOR / (2.0 * (outside_mm - bore_mm));
        let replenishment = (-starvation * film * 2.0 * dm * section.sqrt()).exp();
        let boundary = (-2.6e-8 * film.powf(1.4) * dm).exp();
        let friction =
            boundary * BOUNDARY_FRICTION + (1.0 - boundary) * lubrication.film_friction_coefficient;
        let rolling_nmm = rolling * dm.powf(1.96) * radial_load_n.powf(0.54) * film.powf(0.6);
        let sliding_nmm = sliding * dm.powf(-0.26) * radial_load_n.powf(5.0 / 3.0);
        Self {
            rolling_n_m: NMM * shear * replenishment * rolling_nmm,
            sliding_n_m: NMM * friction * sliding_nmm,
        }
    }

    /// Torque of a case with a lubricant and a series, with d and D of the case, or d of a bore 0.3 ball diameters
    /// below the groove and D = 2 Dpw − d.
    pub(super) fn of(case: &Case, lubrication: &Lubrication, speed_rpm: f64) -> Option<Self> {
        let series = lubrication.skf_series?;
        let bore_mm = 2e3 * case.bearing.bore_radius_or_estimate_m();
        let outside_mm = case.bearing.outside_radius_m().map_or_else(
            || 4e3 * case.bearing.pitch_radius_m() - bore_mm,
            |radius_m| 2e3 * radius_m,
        );
        let load_n = case.operation.radial_load_n;
        let diameters = [bore_mm, outside_mm];
        Some(Self::new(series, lubrication, diameters, speed_rpm, load_n))
    }

    /// M, the sum, N·m.
    pub fn torque_n_m(&self) -> f64 {
        self.rolling_n_m + self.sliding_n_m
    }
}
