//! Lubricant of a bearing, for its ratings.

use crate::error::InputError;
use crate::limits::positive;

/// Lubricant at the temperature of operation.
#[derive(Debug, Clone, PartialEq)]
pub struct Lubrication {
    /// ν, kinematic viscosity (of the base oil of a grease) at the temperature of operation, m²/s.
    pub viscosity_m2_s: f64,
    /// eC, contamination factor, 0 (very severe) to 1 (extreme cleanliness).
    pub contamination_factor: f64,
    /// Cu, fatigue load limit as the maker states it, N; by
    /// [`BasicRatings::fatigue_load_limit_n`](crate::rating::BasicRatings::fatigue_load_limit_n)
    /// unless given.
    pub fatigue_load_limit_n: Option<f64>,
    /// kr, minimum load factor of SKF's catalogue, 0.015 to 0.03 for deep groove ball bearings.
    pub minimum_load_factor: Option<f64>,
}

impl Lubrication {
    /// Refuses values that no lubricant has.
    ///
    /// # Errors
    /// An [`InputError`] if viscosity, fatigue load limit or minimum load factor are not above zero,
    /// or the contamination factor is not from 0 to 1.
    pub fn check(&self) -> Result<(), InputError> {
        positive("viscosity_m2_s", self.viscosity_m2_s)?;
        let factor = self.contamination_factor;
        if !(0.0..=1.0).contains(&factor) {
            return Err(InputError::rule(
                "contamination_factor",
                factor,
                "from 0 to 1",
            ));
        }
        for (field, value) in [
            ("fatigue_load_limit_n", self.fatigue_load_limit_n),
            ("minimum_load_factor", self.minimum_load_factor),
        ] {
            value.map_or(Ok(()), |value| positive(field, value))?;
        }
        Ok(())
    }
}
