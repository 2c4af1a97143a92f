//! Assumptions and limits of the model.

/// Assumptions and omissions of the model, one statement each. Commands and documents quote them,
/// so that a reader of a result knows what it cannot say.
pub const SCOPE: [&str; 6] = [
    "balls move in the plane; with an axial load, a contact angle or several rows in three dimensions; drops take no moments and no tilt",
    "preload by a clearance below zero, by displacement of the outer rings of rows or by soft springs; a spring-loaded outer ring slides freely, without friction or stops, and does not tilt",
    "rings rigid except at the Hertz contacts; the outer ring is fixed (in a drop it may have an elastic support)",
    "speed and load prescribed, constant or as tables over time; a rotor moves along its axis as a rigid body and has no torsional motion",
    "dry friction laws, with `film.traction` that of a sheared film; `[film]` has the rolling resistance of an oil film at the raceways, none between balls; no churning",
    "nothing warms up during a run or a drop; `drop --drops` turns the heat into temperatures and clearances between drops",
];
