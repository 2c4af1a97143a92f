//! Lubricant of a bearing, for its ratings.

use crate::bearing::Bearing;
use crate::error::{Allowed, InputError};
use crate::limits::{not_negative, positive, require};
use crate::rating::BasicRatings;

/// Largest ratio of the fatigue load limit of a catalogue and that of a contact pressure of 1500 MPa.
const FATIGUE_LIMIT_SPREAD: f64 = 30.0;

crate::named_enum! {
    /// How the lubricant comes to the contacts, for its replenishment in SKF's friction model.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Lubricant {
        /// Oil bath of a low level, or oil jet.
        Oil = "oil",
        /// Grease, or oil with air.
        Grease = "grease",
    }
}

crate::named_enum! {
    /// Series of deep groove ball bearings that SKF's friction model has constants for.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum SkfSeries {
        /// 2 and 3, with a filling slot.
        FillingSlot = "filling-slot",
        /// 42 and 43.
        S42 = "42",
        /// 60 and 630.
        S60 = "60",
        /// 62 and 622.
        S62 = "62",
        /// 63 and 623.
        S63 = "63",
        /// 64.
        S64 = "64",
        /// 160 and 161.
        S160 = "160",
        /// 617, 618, 628, 637 and 638.
        S618 = "618",
        /// 619 and 639.
        S619 = "619",
    }
}

impl SkfSeries {
    /// Constants of SKF (*General catalogue* 6000 (2006), table of deep groove ball bearings).
    pub(crate) fn constants(self) -> SkfConstants {
        let [r1, r2, s1, s2] = match self {
            Self::FillingSlot => [4.4e-7, 1.7, 2.00e-3, 100.0],
            Self::S42 => [5.4e-7, 0.96, 3.00e-3, 40.0],
            Self::S60 => [4.1e-7, 1.7, 3.73e-3, 14.6],
            Self::S62 => [3.9e-7, 1.7, 3.23e-3, 36.5],
            Self::S63 => [3.7e-7, 1.7, 2.84e-3, 92.8],
            Self::S64 => [3.6e-7, 1.7, 2.43e-3, 198.0],
            Self::S160 => [4.3e-7, 1.7, 4.63e-3, 4.25],
            Self::S618 => [4.7e-7, 1.7, 6.50e-3, 0.78],
            Self::S619 => [4.3e-7, 1.7, 4.75e-3, 3.6],
        };
        SkfConstants { r1, r2, s1, s2 }
    }
}

/// Constants of SKF's friction model, of loads in N, diameters in mm and torques in N·mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SkfConstants {
    /// R1.
    pub r1: f64,
    /// R2.
    pub r2: f64,
    /// S1.
    pub s1: f64,
    /// S2.
    pub s2: f64,
}

/// Lubricant at the temperature of operation.
#[derive(Debug, Clone, PartialEq)]
pub struct Lubrication {
    /// ν, kinematic viscosity (of the base oil of a grease) at the temperature of operation, m²/s.
    pub viscosity_m2_s: f64,
    /// eC, contamination factor, 0 (very severe) to 1 (extreme cleanliness).
    pub contamination_factor: f64,
    /// Cu, fatigue load limit as the maker states it, N; by
    /// `BasicRatings::fatigue_load_limit_n`
    /// unless given.
    pub fatigue_load_limit_n: Option<f64>,
    /// kr, minimum load factor of SKF's catalogue, 0.015 to 0.03 for deep groove ball bearings.
    pub minimum_load_factor: Option<f64>,
    /// Series of the bearing, for SKF's friction model; without one it is not computed.
    pub skf_series: Option<SkfSeries>,
    /// Oil or grease, for SKF's friction model.
    pub lubricant: Lubricant,
    /// μEHL, sliding friction in a full film: 0.05 mineral oil, 0.04 synthetic oil, 0.1 transmission fluid (SKF).
    pub film_friction_coefficient: f64,
}

impl Lubrication {
    /// Refuses values that no lubricant has.
    ///
    /// # Errors
    /// An [`InputError`] if viscosity, fatigue load limit or minimum load factor are not above zero,
    /// or the contamination factor is not from 0 to 1; a fatigue load limit that is none of the bearing.
    pub fn check(&self, bearing: &Bearing) -> Result<(), InputError> {
        positive("viscosity_m2_s", self.viscosity_m2_s)?;
        not_negative("film_friction_coefficient", self.film_friction_coefficient)?;
        let factor = self.contamination_factor;
        let kept = (0.0..=1.0).contains(&factor);
        require("contamination_factor", factor, kept, "from 0 to 1")?;
        for (field, value) in [
            ("fatigue_load_limit_n", self.fatigue_load_limit_n),
            ("minimum_load_factor", self.minimum_load_factor),
        ] {
            value.map_or(Ok(()), |value| positive(field, value))?;
        }
        if let Some(value) = self.fatigue_load_limit_n {
            let usual =
                BasicRatings::new(bearing).fatigue_load_limit_n(2e3 * bearing.pitch_radius_m());
            let (least, most) = (usual / FATIGUE_LIMIT_SPREAD, usual * FATIGUE_LIMIT_SPREAD);
            let why = "30 times below or above that of a contact pressure of 1500 MPa; catalogues have it in kN";
            Allowed::Between(least, most, why).check("fatigue_load_limit_n", value)?;
        }
        Ok(())
    }
}
