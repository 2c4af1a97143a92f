//! Assumptions and limits of the model.

/// What the model assumes and leaves out, one statement each. Commands and documents quote it,
/// so that a reader of a result knows what it cannot say.
pub const SCOPE: [&str; 6] = [
    "planar motion: no axial load, no tilt of the rings",
    "no preload: the radial clearance is 0 or more",
    "outer ring fixed and rigid but for its contacts; the inner ring moves in the plane",
    "constant speed of the inner ring and constant load: no starting, no running down",
    "dry laws of friction: no lubricant film, no churning",
    "no heat: dimensions, friction and material do not change with temperature",
];
