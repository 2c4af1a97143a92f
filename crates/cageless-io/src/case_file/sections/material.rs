//! `[material]`, `[ball_material]` and `[ring_material]`: a name, or the three numbers.

use crate::case_file::declaration::prelude::*;

cageless::named_enum! {
    /// A bearing material by name. The numbers are typical ones at room temperature, rounded; those
    /// of the supplier are better.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum MaterialPreset {
        /// 100Cr6 (ISO 683-17; AISI 52100), the usual bearing steel.
        Steel100Cr6 = "100Cr6",
        /// M50 (80MoCrV42-16 of ISO 683-17; AMS 6491), high-temperature steel.
        SteelM50 = "M50",
        /// 440C (X108CrMo17 of ISO 683-17; AMS 5618), stainless.
        Steel440C = "440C",
        /// X30CrMoN15-1 (AMS 5898; Cronidur 30), nitrogen-alloyed stainless.
        SteelX30CrMoN15_1 = "X30CrMoN15-1",
        /// Silicon nitride (ISO 26602; ASTM F2094).
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

/// Declares a section of a material: its presences of density, E and ν, and a comment.
macro_rules! material {
    ($(#[$doc:meta])* $Name:ident, $density:expr, $modulus:expr, $ratio:expr, $comment:literal) => {
        section! {
            $(#[$doc])*
            struct $Name {
                preset => preset: Option<MaterialPreset> = Optional, Plain,
                    "typical numbers of a bearing material, in place of the three", Absent;
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
