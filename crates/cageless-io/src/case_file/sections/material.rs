//! `[material]`, `[ball_material]` and `[ring_material]`: a name, or the three numbers.

use cageless::STEEL_EXPANSION_PER_K;
use cageless::touchdown::STEEL_SPECIFIC_HEAT_J_KG_K;

use crate::case_file::declaration::prelude::*;

cageless::named_enum! {
    /// A bearing material by name. The numbers are typical ones at room temperature, rounded; those
    /// of the supplier are better.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum MaterialPreset {
        /// 100Cr6 (ISO 683-17; AISI 52100), the usual bearing steel. Specific heat of the flash
        /// temperature, expansion of NTN 2203/E, Eq. (8.5).
        Steel100Cr6 = "100Cr6",
        /// M50 (80MoCrV42-16 of ISO 683-17; AMS 6491), high-temperature steel. Specific heat of
        /// makeitfrom.com, expansion from 20 to 200 °C of the data sheet of BTI Metals.
        SteelM50 = "M50",
        /// 440C (X108CrMo17 of ISO 683-17; AMS 5618), stainless. Specific heat and expansion from 0 to
        /// 100 °C of the ASM Handbook, volume 1.
        Steel440C = "440C",
        /// X30CrMoN15-1 (AMS 5898; Cronidur 30), nitrogen-alloyed stainless. Specific heat and
        /// expansion of the martensitic chromium steels of EN 10088-1.
        SteelX30CrMoN15_1 = "X30CrMoN15-1",
        /// Silicon nitride (ISO 26602; ASTM F2094). Specific heat of dense silicon nitride, C 935 of
        /// IEC 60672-3; expansion of AZoM 2263 and makeitfrom.com, 2.5e-6 to 3.3e-6 1/K.
        SiliconNitride = "Si3N4",
    }
}

named!(MaterialPreset);

/// Names of the three numbers.
pub(in crate::case_file) const NUMBERS: [&str; 3] =
    ["density_kg_m3", "youngs_modulus_gpa", "poisson_ratio"];

impl MaterialPreset {
    /// Every material with its name in case files.
    pub fn all() -> impl Iterator<Item = (&'static str, Self)> {
        Self::NAMES.iter().copied()
    }

    /// Density in kg/m³, E in GPa, ν.
    pub fn numbers(self) -> [f64; 3] {
        match self {
            Self::Steel100Cr6 => [7810.0, 210.0, 0.3],
            Self::SteelM50 => [7870.0, 203.0, 0.29],
            Self::Steel440C => [7700.0, 200.0, 0.28],
            Self::SteelX30CrMoN15_1 => [7720.0, 213.0, 0.28],
            Self::SiliconNitride => [3240.0, 310.0, 0.27],
        }
    }
}

/// Thermal numbers of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaterialHeat {
    /// Specific heat, J/(kg K).
    pub specific_heat_j_kg_k: f64,
    /// Coefficient of thermal expansion, 1/K.
    pub expansion_per_k: f64,
    /// Temperature above which it softens, °C; `None` of a ceramic.
    pub softening_c: Option<f64>,
}

/// Temperature above which bearing steel softens, °C: 100Cr6 is tempered at 150 to 200 °C
/// (ISO 683-17).
pub(crate) const STEEL_SOFTENING_C: f64 = 200.0;
/// Temperature above which M50 softens, °C (600 °F: Zaretsky, NASA TM-102529).
const M50_SOFTENING_C: f64 = 316.0;

impl MaterialPreset {
    /// Thermal numbers.
    pub fn heat(self) -> MaterialHeat {
        let heat = |specific_heat_j_kg_k, expansion_per_k, softening_c| MaterialHeat {
            specific_heat_j_kg_k,
            expansion_per_k,
            softening_c,
        };
        let steel = Some(STEEL_SOFTENING_C);
        match self {
            Self::Steel100Cr6 => heat(STEEL_SPECIFIC_HEAT_J_KG_K, STEEL_EXPANSION_PER_K, steel),
            Self::SteelM50 => heat(470.0, 11.8e-6, Some(M50_SOFTENING_C)),
            Self::Steel440C => heat(460.0, 10.2e-6, steel),
            Self::SteelX30CrMoN15_1 => heat(460.0, 10.5e-6, steel),
            Self::SiliconNitride => heat(800.0, 3.2e-6, None),
        }
    }
}

/// Declares a section of a material: its presences of density, E and ν, and a comment.
macro_rules! material {
    ($(#[$doc:meta])* $Name:ident, $density:expr, $modulus:expr, $ratio:expr, $comment:literal) => {
        section! {
            $(#[$doc])*
            struct $Name {
                preset => preset: Option<MaterialPreset> = Optional, Plain,
                    "typical numbers of a bearing material, in place of the three; its specific heat and thermal expansion as well", Absent;
                density_kg_m3 => density_kg_m3: Option<f64> = $density, Si("kg/m^3"); Above(0.0),
                    "density; that of the balls decides", Shown("7850.0", $comment);
                youngs_modulus_gpa => youngs_modulus_pa: Option<f64> = $modulus, Gigapascal; Above(0.0),
                    "E, Young's modulus", Shown("206.0", "");
                poisson_ratio => poisson_ratio: Option<f64> = $ratio, Plain,
                    "ν, Poisson's ratio", Shown("0.3", "0 to below 0.5");
            }
        }

        impl $Name {
            /// Density in kg/m³, E in Pa and ν as given.
            pub(crate) fn numbers(&self) -> [Option<f64>; 3] {
                [self.density_kg_m3, self.youngs_modulus_pa, self.poisson_ratio]
            }
        }
    };
}

material! {
    /// `[material]`: of balls and rings where nothing else is said; bearing steel by default.
    MaterialSection, default(7850.0), default(206.0), default(0.3),
    "or preset = \"100Cr6\", \"M50\", \"440C\", \"X30CrMoN15-1\",\n\"Si3N4\" in place of the three numbers"
}

material! {
    /// `[ball_material]` or `[ring_material]`, where it is not that of `[material]`.
    PartMaterialSection, Optional, Optional, Optional,
    "or preset = \"Si3N4\", say, in place of the three numbers"
}
