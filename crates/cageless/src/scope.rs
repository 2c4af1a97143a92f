//! Assumptions and limits of the model.

/// What the model assumes and leaves out, one statement each. Commands and documents quote it,
/// so that a reader of a result knows what it cannot say.
pub const SCOPE: [&str; 6] = [
    "planar motion, but in `cageless run`, `compare`, `design`, `tolerance`, the studio and drops also in space: contact angles, several rows, axial load, in all but drops moments and tilt",
    "preload by radial interference, a clearance below zero, by displacement of the outer rings of rows or by soft springs: an outer ring under a spring slides along the axis without tilt, dry friction in its seat or an end of its travel",
    "rings rigid except at the Hertz contacts; the outer ring is fixed (in a drop it may have an elastic support)",
    "speed and load prescribed, constant or as tables over time; a rotor that moves along its axis does so as a rigid body, and has no torsional motion",
    "dry friction laws: no lubricant film, no churning",
    "frictional heat is summed; temperatures follow from it after a drop alone, and change the clearance of the next: within a run or a drop dimensions, friction and material stay constant",
];
