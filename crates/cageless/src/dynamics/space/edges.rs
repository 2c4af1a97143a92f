//! Where the equations in space are not smooth: contacts that open, and the ends of raceways.

use super::model::SpaceModel;
use crate::numerics::lanes::LANES;
use crate::simd::{PER_DEPTH, PER_SINE_SQUARE, Workspace};
use crate::world::joint::shoulder::FaceContact;

/// Appends the depths of contacts, that of the face of a rotor first, and the distances from the ends of
/// raceways as of the last evaluation.
pub(crate) fn edges(
    space: &SpaceModel,
    w: &Workspace,
    face: Option<&FaceContact>,
    values: &mut Vec<f64>,
) {
    values.extend(face.map(|face| face.deflection * PER_DEPTH));
    for k in 0..space.balls.len() {
        let (results, lane) = (&w.blocks[k / LANES], k % LANES);
        for depth in [
            &results.inner.deflection,
            &results.outer.deflection,
            &results.pair.deflection,
        ] {
            values.push(depth.0[lane] * PER_DEPTH);
        }
        let direction = results.polar.get(lane).direction();
        let left = space.flanks.iter().map(|flank| flank.left(direction));
        values.extend(left.map(|left| left * PER_SINE_SQUARE));
    }
}
