//! Drive of the inner ring of a case.

use super::Case;
use crate::rotor::Rotor;
use crate::time_table::TimeTable;

/// Drive of the inner ring of a case: what its speed follows from.
#[derive(Debug, Clone, Copy)]
pub(crate) enum InnerRingDrive<'a> {
    /// A constant speed, rad/s.
    Constant(f64),
    /// A speed over time, rad/s.
    OverTime(&'a TimeTable),
    /// Contact with a rotor that falls onto the ring.
    Rotor(&'a Rotor),
}

impl Case {
    /// Drive of the inner ring.
    pub(crate) fn inner_ring_drive(&self) -> InnerRingDrive<'_> {
        let operation = &self.operation;
        match (&self.rotor, &operation.inner_speed_table) {
            (Some(rotor), _) => InnerRingDrive::Rotor(rotor),
            (None, Some(table)) => InnerRingDrive::OverTime(table),
            (None, None) => InnerRingDrive::Constant(operation.inner_speed_rad_s),
        }
    }
}
