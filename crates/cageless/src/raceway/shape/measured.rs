//! Flanks as measured.

use crate::error::InputError;
use crate::raceway::flank_angle::Flanks;
use crate::raceway::outline::Outline;

/// Flanks of a measured ring, with another α0 and θ than measured.
pub(super) fn flanks(outline: &Outline<'_>) -> Result<Flanks, InputError> {
    let Some(measured) = outline.measured else {
        let rule = "given with shape = \"measured\"";
        return Err(InputError::rule("profile", f64::NAN, rule));
    };
    Ok(measured.scaled(outline.middle_rad(), outline.half_angle_rad))
}
