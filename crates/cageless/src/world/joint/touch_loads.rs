//! Loads between rotor and inner ring.

/// Loads of the joints of rotor and inner ring; the ring has the reaction of the force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct TouchLoads {
    /// Force on the rotor, N.
    pub force: [f64; 3],
    /// Moment on the rotor about its mass centre, N·m.
    pub moment: f64,
    /// Torque on the inner ring about its axis, N·m.
    pub ring_torque: f64,
}
