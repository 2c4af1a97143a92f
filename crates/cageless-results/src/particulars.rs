//! Particulars of a case for files and commands, beside its physics.

use cageless::Allowed;
use cageless::REFERENCE_TEMPERATURE_C;
use cageless::touchdown::{Limit, PARTS, Thermal};
use cageless::{Bearing, InputError, Lubrication, OperatingClearance};

/// Particulars of a case: name, seed, rows, mounting, lubricant, heat and limits, none of which changes the motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Particulars {
    /// Free text.
    pub title: String,
    /// Seed of whatever is random.
    pub seed: u64,
    /// Time between the rows of a run, s.
    pub interval_s: f64,
    /// Clearance as fits and temperatures leave it, which the bearing of the case has.
    pub fit: Option<OperatingClearance>,
    /// Lubricant, for ratings.
    pub lubrication: Option<Lubrication>,
    /// Heat capacities of rings and balls, with pause and cooling between drops.
    pub thermal: Thermal,
    /// Limits on results.
    pub limits: Vec<Limit>,
}

impl Particulars {
    /// Shortest time between rows, s.
    pub const INTERVAL_MIN_S: f64 = 1e-9;

    /// Checks the values for a bearing.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be.
    pub fn check(&self, bearing: &Bearing) -> Result<(), InputError> {
        let lubrication = self.lubrication.as_ref();
        lubrication.map_or(Ok(()), |lubrication| lubrication.check(bearing))?;
        self.thermal.check()?;
        let value = self.interval_s;
        match value.is_finite() && value >= Self::INTERVAL_MIN_S {
            true => Ok(()),
            false => Err(InputError {
                field: "interval_s",
                value,
                allowed: Allowed::AtLeast(Self::INTERVAL_MIN_S, "nothing moves in less"),
            }),
        }
    }

    /// Temperatures of inner ring, balls and outer ring, °C: those of the fit, else that at which
    /// clearances are stated.
    pub fn parts_c(&self) -> [f64; PARTS] {
        let cold = [REFERENCE_TEMPERATURE_C; PARTS];
        self.fit.map_or(cold, |fit| fit.parts_c)
    }
}
