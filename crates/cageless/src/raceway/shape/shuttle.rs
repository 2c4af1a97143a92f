//! A shuttle of two parabolas.

use std::sync::Arc;

use crate::error::InputError;
use crate::raceway::flank_angle::Flanks;
use crate::raceway::outline::Outline;
use crate::raceway::power_angle::PowerAngle;

/// αc = α0 (1 − (ψ/θ)²).
#[allow(clippy::unnecessary_wraps)] // as every shape
pub(super) fn flanks(outline: &Outline<'_>) -> Result<Flanks, InputError> {
    let (middle, theta) = (outline.middle_rad(), outline.half_angle_rad);
    Ok(Arc::new(PowerAngle::new(middle, theta, 1.0)))
}
