//! Joints: forces between two bodies; one file is one joint.

pub(crate) mod impact;
pub(crate) mod journal;
pub(crate) mod rotor_seat;
pub(crate) mod rotor_touch;
pub(crate) mod shoulder;
pub(crate) mod support;
mod touch_loads;

pub(crate) use touch_loads::TouchLoads;
