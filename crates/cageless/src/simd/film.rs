//! Rolling force of lubricated contacts with the raceways, lane by lane.
//!
//! It acts on the motions that its dissipation F_R 2u has, so that momentum, moments and energy close: with q the
//! distance from the centre of the inner ring
//!
//!   outer: 2u = vt (ρ + 2r)/ρ + ω r,   inner: 2u = ωi Ri + ω R − vt (Ri − R)/q.

use super::film_block::FilmBlock;
use super::motions::Motions;
use super::parameters::Parameters;
use super::sums::{Addends, Sum};
use super::workspace::BlockResults;
use crate::dynamics::ball::BallLanes;
use crate::film::RollingCurve;
use crate::numerics::lanes::{LANES, Lanes};

/// Adds the rolling force of the contacts of a block to loads and addends.
#[inline(always)]
pub(super) fn add(
    (p, film): (&Parameters, &FilmBlock),
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    addends: &mut Addends,
) {
    if !(p.unequal || p.elastic) {
        results.slope_force = Lanes::ZERO;
    }
    let mut loads = Lanes::ZERO;
    for lane in 0..LANES {
        loads.0[lane] = results.outer.force.0[lane] * balls.radius.0[lane]
            / results.geometry.effective_radius.0[lane];
    }
    if p.elastic {
        for lane in results.on_flanks {
            loads.0[lane] = results.flanks.load.0[lane];
        }
    }
    for lane in 0..LANES {
        outer(film, balls, results, &loads, motions, addends, lane);
    }
    for lane in 0..LANES {
        inner(p, film, balls, results, motions, addends, lane);
    }
}

#[inline(always)]
fn outer(
    film: &FilmBlock,
    balls: &BallLanes,
    results: &mut BlockResults,
    loads: &Lanes,
    motions: Motions<'_>,
    addends: &mut Addends,
    lane: usize,
) {
    let (polar, radius) = (
        results.polar.get(lane),
        results.geometry.effective_radius.0[lane],
    );
    let mut curve = RollingCurve::default();
    let cosine = radius / balls.radius.0[lane];
    let place = cosine * film.scale.0[lane] + film.shift.0[lane];
    for coefficients in film.outer.iter().rev() {
        let coefficients = coefficients.get(lane);
        curve = RollingCurve {
            rigid: curve.rigid * place + coefficients.rigid,
            elastic: curve.elastic * place + coefficients.elastic,
            load: curve.load * place + coefficients.load,
            heat: coefficients.heat,
        };
    }
    let [contacts, share] = if cosine < 1.0 { [2.0, 0.5] } else { [1.0, 1.0] };
    let arm = (polar.distance + 2.0 * radius) / polar.distance;
    let doubled = polar.tangential * arm + motions.get(lane).spin * radius;
    let force = contacts * curve.force_n(share * loads.0[lane], 0.5 * doubled);
    let along = -force * arm;
    results.slope_force.0[lane] += along;
    results.load.fx.0[lane] -= along * polar.ey;
    results.load.fy.0[lane] += along * polar.ex;
    results.load.torque.0[lane] -= force * radius;
    addends[Sum::RollingResistance as usize].0[lane] = force * doubled;
}

#[inline(always)]
fn inner(
    p: &Parameters,
    film: &FilmBlock,
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    addends: &mut Addends,
    lane: usize,
) {
    let (ball, contact) = (balls.get(lane), results.inner.get(lane));
    let (ex, ey) = (
        results.inner_polar.ex.0[lane],
        results.inner_polar.ey.0[lane],
    );
    let (spin, surface) = (motions.get(lane).spin, p.inner.surface_speed.0[lane]);
    // ΔVi = ωi Ri − (vt + ω R) and δi = Ri + R − q.
    let tangential = surface - contact.slip - spin * ball.radius;
    let distance = ball.inner_contact_distance - contact.deflection;
    let arm = (p.inner.radius.0[lane] - ball.radius) / distance;
    let doubled = surface + spin * ball.radius - tangential * arm;
    let force = film.inner.get(lane).force_n(contact.force, 0.5 * doubled);
    let along = force * arm;
    results.load.fx.0[lane] -= along * ey;
    results.load.fy.0[lane] += along * ex;
    results.load.torque.0[lane] -= force * ball.radius;
    addends[Sum::RingX as usize].0[lane] += along * ey;
    addends[Sum::RingY as usize].0[lane] -= along * ex;
    addends[Sum::RollingDrive as usize].0[lane] = force * surface;
    addends[Sum::RollingResistance as usize].0[lane] += force * doubled;
}
