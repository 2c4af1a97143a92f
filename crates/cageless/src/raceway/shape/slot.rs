//! Edges of a slot with the ends of an end mill.

use std::sync::Arc;

use crate::error::InputError;
use crate::raceway::flank_angle::Flanks;
use crate::raceway::outline::Outline;
use crate::raceway::slot::SlotPlan;

/// The angle at which a ball rests on both edges.
pub(super) fn flanks(outline: &Outline<'_>) -> Result<Flanks, InputError> {
    Ok(Arc::new(SlotPlan::new(outline)?))
}
