//! Oils at the temperature of the inlet.

use crate::error::InputError;
use crate::limits::{from_to, require};

/// Viscosity of 1 mPa·s, Pa·s.
const MPA_S: f64 = 1e-3;
/// λ of mineral oil, W/(m·K).
pub(super) const CONDUCTIVITY_W_M_K: f64 = 0.14;
/// Temperatures that viscosities are computed for, °C.
pub const TEMPERATURES_C: [f64; 2] = [-40.0, 250.0];
/// Least and greatest viscosity of an oil in a bearing, from petrol to the stiffest gear oil in the cold, Pa·s.
pub const VISCOSITIES_PA_S: [f64; 2] = [1e-4, 10.0];
/// Largest β_T of an oil, 1/K; mineral oils have 0.02 to 0.06.
pub const VISCOSITY_TEMPERATURE_MAX_1_K: f64 = 0.2;
/// Fall of the density with the temperature, kg/(m³·K).
const DENSITY_SLOPE_KG_M3_K: f64 = 0.64;
/// Temperature at which densities of oils are stated, °C.
const DENSITY_TEMPERATURE_C: f64 = 15.0;
/// C of Vogel's equation where two viscosities are given, °C.
const VOGEL_OFFSET_C: f64 = 95.0;

/// Oil at the temperature of the inlet of the contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oil {
    /// η, dynamic viscosity at ambient pressure, Pa·s.
    pub viscosity_pa_s: f64,
    /// β_T = −d ln η/dT, 1/K.
    pub viscosity_temperature_1_k: f64,
    /// α, pressure–viscosity coefficient, 1/Pa; the thickness of the film has it, the rolling force not.
    pub pressure_viscosity_1_pa: f64,
    /// λ, thermal conductivity, W/(m·K).
    pub thermal_conductivity_w_m_k: f64,
    /// Density, kg/m³; kinematic viscosities have it.
    pub density_kg_m3: f64,
}

impl Oil {
    /// Mineral oil of this viscosity and β_T: α by `Oil::mineral_pressure_viscosity_1_pa`, 0.14 W/(m·K), 860 kg/m³.
    pub fn mineral(viscosity_pa_s: f64, viscosity_temperature_1_k: f64) -> Self {
        Self {
            viscosity_pa_s,
            viscosity_temperature_1_k,
            pressure_viscosity_1_pa: Self::mineral_pressure_viscosity_1_pa(viscosity_pa_s),
            thermal_conductivity_w_m_k: CONDUCTIVITY_W_M_K,
            density_kg_m3: 860.0,
        }
    }

    /// Mineral oil at `temperature_c` by two viscosities, at 40 and at 100 °C: Vogel's equation with C = 95 °C.
    pub fn between(viscosities_pa_s: [f64; 2], temperature_c: f64) -> Self {
        let vogel = Vogel::through(viscosities_pa_s);
        Self::mineral(
            vogel.viscosity_pa_s(temperature_c),
            vogel.slope_1_k(temperature_c),
        )
    }

    /// α of mineral oils, 1.237·10⁻⁸ η^0.168 1/Pa with η in mPa·s: fitted to eleven oils at 30, 60 and 100 °C
    /// (Stachowiak & Batchelor, *Engineering Tribology*, Table 2.3) within some 10 %.
    pub(crate) fn mineral_pressure_viscosity_1_pa(viscosity_pa_s: f64) -> f64 {
        1.237e-8 * (viscosity_pa_s / MPA_S).powf(0.168)
    }

    /// ν, kinematic viscosity, m²/s.
    pub fn kinematic_viscosity_m2_s(&self) -> f64 {
        self.viscosity_pa_s / self.density_kg_m3
    }

    /// Checks that an oil can have these values.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be.
    pub(super) fn check(&self) -> Result<(), InputError> {
        let why = "from petrol to the stiffest gear oil in the cold";
        let [least, most] = VISCOSITIES_PA_S;
        from_to("viscosity_pa_s", self.viscosity_pa_s, least..=most, why)?;
        let slope = self.viscosity_temperature_1_k;
        let kept = (0.0..=VISCOSITY_TEMPERATURE_MAX_1_K).contains(&slope);
        let rule = "from 0 to 0.2: mineral oils have 0.02 to 0.06";
        require("viscosity_temperature_1_k", slope, kept, rule)?;
        let alpha = self.pressure_viscosity_1_pa;
        let kept = (1e-9..=1e-7).contains(&alpha);
        let rule = "from 1e-9 to 1e-7: mineral oils have 1e-8 to 4e-8";
        require("pressure_viscosity_1_pa", alpha, kept, rule)?;
        let lambda = self.thermal_conductivity_w_m_k;
        let kept = (0.05..=1.0).contains(&lambda);
        let rule = "from 0.05 to 1: oils have 0.1 to 0.17";
        require("thermal_conductivity_w_m_k", lambda, kept, rule)?;
        let why = "oils have 750 to 1100";
        from_to("oil_density_kg_m3", self.density_kg_m3, 500.0..=2000.0, why)
    }
}

crate::named_enum! {
    /// Oil by name.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum OilGrade {
        /// Mineral oil of class ISO VG 10, VI 95.
        IsoVg10 = "iso-vg-10",
        /// Mineral oil of class ISO VG 22, VI 95.
        IsoVg22 = "iso-vg-22",
        /// Mineral oil of class ISO VG 32, VI 95.
        IsoVg32 = "iso-vg-32",
        /// Mineral oil of class ISO VG 68, VI 95.
        IsoVg68 = "iso-vg-68",
        /// Reference oil FVA 3 of German transmission research.
        Fva3 = "fva-3",
        /// Turbine oil of MIL-PRF-23699.
        MilL23699 = "mil-l-23699",
    }
}

impl OilGrade {
    /// The oil at a temperature, °C.
    ///
    /// Classes: the viscosity of the class at 40 °C (ISO 3448) and that of VI 95 at 100 °C (ASTM D2270). FVA 3:
    /// Wingertszahn et al., Lubricants 11 (2023) 369, Table A1. MIL-L-23699: fitted to published values within 1 %
    /// from 20 to 160 °C.
    pub fn at(self, temperature_c: f64) -> Oil {
        let (vogel, density_kg_m3) = match self {
            Self::IsoVg10 => (Vogel::new(0.0939922, 605.56, 95.0), 850.0),
            Self::IsoVg22 => (Vogel::new(0.0764930, 741.42, 95.0), 860.0),
            Self::IsoVg32 => (Vogel::new(0.0677671, 809.94, 95.0), 870.0),
            Self::IsoVg68 => (Vogel::new(0.0595449, 930.74, 95.0), 880.0),
            Self::Fva3 => (Vogel::new(0.062, 1021.7, 101.5517), 887.6),
            Self::MilL23699 => (Vogel::new(0.055642, 1024.5, 127.34), 1000.0),
        };
        let viscosity_pa_s = vogel.viscosity_pa_s(temperature_c);
        let mineral = Oil::mineral(viscosity_pa_s, vogel.slope_1_k(temperature_c));
        let warmer_k = temperature_c - DENSITY_TEMPERATURE_C;
        let oil = Oil {
            density_kg_m3: density_kg_m3 - DENSITY_SLOPE_KG_M3_K * warmer_k,
            ..mineral
        };
        match self {
            Self::Fva3 => Oil {
                // The fit of Wingertszahn et al. has 1/bar.
                pressure_viscosity_1_pa: 1e-5 / (327.79 + 2.9862 * temperature_c),
                thermal_conductivity_w_m_k: 0.134,
                ..oil
            },
            Self::MilL23699 => Oil {
                pressure_viscosity_1_pa: (1.15607 * viscosity_pa_s.ln() - 17.496).exp()
                    / viscosity_pa_s,
                ..oil
            },
            _ => oil,
        }
    }
}

/// Constants of Vogel's equation, η = K exp(B/(ϑ + C)).
#[derive(Debug, Clone, Copy)]
struct Vogel {
    /// K, mPa·s.
    factor_mpa_s: f64,
    /// B, K.
    slope_k: f64,
    /// C, °C.
    offset_c: f64,
}

impl Vogel {
    const fn new(factor_mpa_s: f64, slope_k: f64, offset_c: f64) -> Self {
        Self {
            factor_mpa_s,
            slope_k,
            offset_c,
        }
    }

    /// Constants by viscosities at 40 and at 100 °C.
    fn through([at_40_pa_s, at_100_pa_s]: [f64; 2]) -> Self {
        let [cold, hot] = [40.0, 100.0].map(|c| 1.0 / (c + VOGEL_OFFSET_C));
        let slope_k = (at_40_pa_s / at_100_pa_s).ln() / (cold - hot);
        let factor_mpa_s = at_40_pa_s / MPA_S * (-slope_k * cold).exp();
        Self::new(factor_mpa_s, slope_k, VOGEL_OFFSET_C)
    }

    fn viscosity_pa_s(&self, temperature_c: f64) -> f64 {
        MPA_S * self.factor_mpa_s * (self.slope_k / (temperature_c + self.offset_c)).exp()
    }

    /// β_T = B/(ϑ + C)².
    fn slope_1_k(&self, temperature_c: f64) -> f64 {
        self.slope_k / (temperature_c + self.offset_c).powi(2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Viscosities at 40 and 100 °C of the table of sources, mPa·s.
    #[test]
    fn viscosities_of_the_grades() {
        for (grade, cold, hot) in [
            (OilGrade::IsoVg10, 8.340, 2.098),
            (OilGrade::IsoVg22, 18.57, 3.427),
            (OilGrade::IsoVg32, 27.33, 4.314),
            (OilGrade::IsoVg68, 58.75, 7.043),
            (OilGrade::Fva3, 84.54, 9.861),
            (OilGrade::MilL23699, 25.37, 5.041),
        ] {
            for (temperature_c, mpa_s) in [(40.0, cold), (100.0, hot)] {
                let oil = grade.at(temperature_c);
                let relative = 1e3 * oil.viscosity_pa_s / mpa_s - 1.0;
                assert!(
                    relative.abs() < 3e-4,
                    "{grade:?} at {temperature_c}: {relative}"
                );
                // The slope is that of the viscosity.
                let warmer = grade.at(temperature_c + 1e-3).viscosity_pa_s;
                let slope = 1e3 * (oil.viscosity_pa_s / warmer).ln();
                assert!((slope / oil.viscosity_temperature_1_k - 1.0).abs() < 1e-4);
                assert!(oil.check().is_ok());
            }
        }
    }

    #[test]
    fn two_viscosities_give_the_oil_between() {
        let given = [18.57e-3, 3.427e-3];
        for (temperature_c, pa_s) in [(40.0, given[0]), (100.0, given[1])] {
            let oil = Oil::between(given, temperature_c);
            assert!((oil.viscosity_pa_s / pa_s - 1.0).abs() < 1e-12);
        }
        let [between, grade] = [Oil::between(given, 70.0), OilGrade::IsoVg22.at(70.0)];
        assert!((between.viscosity_pa_s / grade.viscosity_pa_s - 1.0).abs() < 1e-3);
    }

    /// 1/Pa at 40 and 100 °C (Wingertszahn et al.), and the order of a turbine oil.
    #[test]
    fn pressure_viscosity() {
        let alpha = |grade: OilGrade, c: f64| grade.at(c).pressure_viscosity_1_pa;
        assert!((alpha(OilGrade::Fva3, 40.0) - 2.24e-8).abs() < 5e-11);
        assert!((alpha(OilGrade::Fva3, 100.0) - 1.60e-8).abs() < 5e-11);
        assert!((1.3e-8..1.5e-8).contains(&alpha(OilGrade::MilL23699, 40.0)));
        let mineral = Oil::mineral(5e-3, 0.035).pressure_viscosity_1_pa;
        assert!((mineral / (1.237e-8 * 5f64.powf(0.168)) - 1.0).abs() < 1e-12);
    }
}
