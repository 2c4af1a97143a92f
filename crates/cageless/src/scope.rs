//! Assumptions and limits of the model.

/// What the model assumes and leaves out, one statement each. Commands and documents quote it,
/// so that a reader of a result knows what it cannot say.
pub const SCOPE: [&str; 6] = [
    "planar motion: no axial load, no tilt of the rings",
    "no preload: the radial clearance is 0 or more",
    "rings rigid but for their contacts; the outer ring is fixed, or on a support under a falling rotor",
    "speed and load as given, constant or over time; a falling rotor, rigid or flexible, does not move along its axis or twist",
    "dry laws of friction: no lubricant film, no churning",
    "no heat: dimensions, friction and material do not change with temperature",
];
