//! Friction and sliding of contacts, lane by lane.

use super::parameters::Parameters;
use super::workspace::BlockResults;
use crate::contact::{EvaluatedLaws, Law, LawLanes, with_law};
use crate::numerics::lanes::{LANES, Lanes, larger};

/// Friction of one contact of each lane by the law of the case.
#[inline(always)]
pub(super) fn friction(p: &Parameters, slip: &Lanes, normal: &Lanes, force: &mut Lanes) {
    with_law!(&p.friction, law => friction_by(law, slip, normal, force));
}

/// Friction of the balls of a block at both raceways, from their sliding speeds.
#[inline(always)]
pub(super) fn both_raceways(p: &Parameters, results: &mut BlockResults) {
    let (outer, inner) = (&results.outer, &results.inner);
    let normal = &outer.friction_normal;
    friction(p, &outer.slip, normal, &mut results.outer_friction);
    friction(p, &inner.slip, &inner.force, &mut results.inner_friction);
}

#[inline(always)]
fn friction_by(law: &impl LawLanes, slip: &Lanes, normal: &Lanes, force: &mut Lanes) {
    let law = law.evaluated([slip, slip]);
    for lane in 0..LANES {
        [force.0[lane], _] = law.lane(lane).force(slip.0[lane], normal.0[lane]);
    }
}

/// Largest |ΔV| at contacts that carry load.
#[inline(always)]
pub(super) fn loaded_slips(results: &BlockResults, largest: &mut Lanes) {
    for lane in 0..LANES {
        let loaded = |slip: f64, force: f64| if force > 0.0 { slip.abs() } else { 0.0 };
        let inner = loaded(results.inner.slip.0[lane], results.inner.force.0[lane]);
        let outer = loaded(results.outer.slip.0[lane], results.outer.force.0[lane]);
        largest.0[lane] = larger(largest.0[lane], larger(inner, outer));
    }
}
