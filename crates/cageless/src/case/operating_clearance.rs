//! A case with another clearance in operation.

use super::Case;
use crate::error::InputError;
use crate::limits::not_negative;
use crate::raceway::Raceway;

impl Case {
    /// The case with another radial internal clearance in operation, at the bottom of the inner groove. Opposed rows
    /// without springs have the preload that the clearance leaves them.
    ///
    /// # Errors
    /// An [`InputError`] if the bearing, its contact angle or a preload is impossible.
    pub fn with_operating_clearance(&self, clearance_m: f64) -> Result<Self, InputError> {
        let deviation_m = clearance_m - self.bearing.radial_internal_clearance_m();
        let radii = self.bearing.ball_radius_deviations_m().to_vec();
        let bearing = (self.bearing.with_clearance_deviation(deviation_m)?)
            .with_ball_radius_deviations(radii)?;
        let raceways = self.raceways.iter().map(|raceway| {
            Raceway::formed(*raceway.dimensions(), raceway.form(), &bearing)?
                .with_depth_error(raceway.depth_error_m())?
                .with_section_angle(raceway.section_angle_rad(), &bearing)
        });
        let raceways = raceways.collect::<Result<_, _>>()?;
        let mut rows = self.rows.clone();
        let pressed_m = self.bearing.groove_offset_m() - bearing.groove_offset_m();
        let has = |sign| {
            let mut held = self.rows.iter().filter(|row| row.preload_n == 0.0);
            held.any(|row| row.contact_sign == sign)
        };
        if has(1.0) && has(-1.0) {
            for row in rows.iter_mut().filter(|row| row.preload_n == 0.0) {
                row.preload_m += 2.0 * pressed_m;
                not_negative("preload_m", row.preload_m)?;
            }
        }
        Ok(Self {
            bearing,
            raceways,
            rows,
            ..self.clone()
        })
    }
}
