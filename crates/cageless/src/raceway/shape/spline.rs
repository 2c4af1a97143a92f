//! Flanks by a spline.

use crate::error::InputError;
use crate::raceway::flank_angle::Flanks;
use crate::raceway::outline::Outline;

/// Flanks by the spline through the rows of a profile, with another α0 and θ than theirs.
pub(super) fn flanks(outline: &Outline<'_>) -> Result<Flanks, InputError> {
    let Some(spline) = outline.spline else {
        let rule = "given with shape = \"spline\"";
        return Err(InputError::rule("profile", f64::NAN, rule));
    };
    Ok(spline.scaled(outline.middle_rad(), outline.half_angle_rad))
}
