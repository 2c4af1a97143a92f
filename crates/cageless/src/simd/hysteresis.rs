//! Elastic hysteresis of rolling contacts, lane by lane: a couple on the spin of the ball and on the ring.

use super::motions::Motions;
use super::parameters::Parameters;
use super::sums::{Addends, Sum};
use super::workspace::BlockResults;
use crate::ball::BallLanes;
use crate::film::hysteresis::{power_1_33, sense};
use crate::numerics::lanes::{LANES, Lanes};

/// Adds the moments of the contacts of a block, of outer and inner factors, to loads and addends.
#[inline(always)]
pub(super) fn add(
    p: &Parameters,
    factors: &[Lanes; 2],
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    addends: &mut Addends,
) {
    let [outer, inner] = factors;
    for lane in 0..LANES {
        let (ball, radius) = (
            balls.radius.0[lane],
            results.geometry.effective_radius.0[lane],
        );
        let spin = motions.get(lane).spin;
        let (contacts, share) = if radius < ball {
            (2.0, 0.5)
        } else {
            (1.0, 1.0)
        };
        let cosine = radius / ball;
        let load = match p.elastic && results.on_flanks.has(lane) {
            true => results.flanks.load.0[lane],
            false => results.outer.force.0[lane] / cosine,
        };
        // Across both flanks the moments cancel.
        let factor = contacts * cosine * outer.0[lane];
        let moment = factor * power_1_33(share * load) * sense(spin * ball);
        results.load.torque.0[lane] -= moment;
        addends[Sum::RollingResistance as usize].0[lane] += moment * spin;
    }
    for lane in 0..LANES {
        let spin = motions.get(lane).spin;
        let driven = p.inner.surface_speed.0[lane] / p.inner.radius.0[lane];
        let relative = spin + driven;
        let load = power_1_33(results.inner.force.0[lane]);
        let moment = inner.0[lane] * load * sense(relative * balls.radius.0[lane]);
        results.load.torque.0[lane] -= moment;
        addends[Sum::RollingDrive as usize].0[lane] += moment * driven;
        addends[Sum::RollingResistance as usize].0[lane] += moment * relative;
    }
}
