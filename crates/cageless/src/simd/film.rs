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
use crate::ball::BallLanes;
use crate::numerics::lanes::{LANES, Lanes};

/// Adds the rolling force of the contacts of a block to loads and addends.
#[inline(always)]
pub(super) fn add(
    p: &Parameters,
    film: &FilmBlock,
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    addends: &mut Addends,
) {
    if !(p.unequal || p.elastic) {
        results.slope_force = Lanes::ZERO;
    }
    outer(p, film, balls, results, motions, addends);
    inner(p, film, balls, results, motions, addends);
}

/// In loops of their own: a loop within that over the lanes would keep it from becoming vector code.
#[inline(always)]
fn outer(
    p: &Parameters,
    film: &FilmBlock,
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    addends: &mut Addends,
) {
    let (mut cosines, mut loads, mut inverses) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    for lane in 0..LANES {
        let (ball, radius) = (
            balls.radius.0[lane],
            results.geometry.effective_radius.0[lane],
        );
        let distance = results.polar.distance.0[lane];
        // One division for all.
        let inverse = 1.0 / (ball * radius * distance);
        cosines.0[lane] = inverse * (radius * radius * distance);
        loads.0[lane] = results.outer.force.0[lane] * (inverse * (ball * ball * distance));
        inverses.0[lane] = inverse * (ball * radius);
    }
    if p.elastic {
        for lane in results.on_flanks {
            loads.0[lane] = results.flanks.load.0[lane];
        }
    }
    let mut curve = film.highest.clone();
    for coefficients in film.lower.iter().rev() {
        for lane in 0..LANES {
            let place = cosines.0[lane] * film.scale.0[lane] + film.shift.0[lane];
            let (sum, more) = (curve.get(lane), coefficients.get(lane));
            curve.rigid.0[lane] = sum.rigid * place + more.rigid;
            curve.elastic.0[lane] = sum.elastic * place + more.elastic;
            curve.load.0[lane] = sum.load * place + more.load;
        }
    }
    let (mut forces, mut arms, mut doubles) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    for lane in 0..LANES {
        let radius = results.geometry.effective_radius.0[lane];
        let on_flanks = radius < balls.radius.0[lane];
        let contacts = if on_flanks { 2.0 } else { 1.0 };
        let share = if on_flanks { 0.5 } else { 1.0 };
        let arm = (results.polar.distance.0[lane] + 2.0 * radius) * inverses.0[lane];
        let doubled = results.polar.tangential.0[lane] * arm + motions.get(lane).spin * radius;
        let of_one = (curve.get(lane)).force_n(share * loads.0[lane], 0.5 * doubled);
        forces.0[lane] = contacts * of_one;
        arms.0[lane] = arm;
        doubles.0[lane] = doubled;
    }
    for lane in 0..LANES {
        let along = -forces.0[lane] * arms.0[lane];
        results.slope_force.0[lane] += along;
        results.load.fx.0[lane] -= along * results.polar.ey.0[lane];
        results.load.fy.0[lane] += along * results.polar.ex.0[lane];
        results.load.torque.0[lane] -= forces.0[lane] * results.geometry.effective_radius.0[lane];
        addends[Sum::RollingResistance as usize].0[lane] = forces.0[lane] * doubles.0[lane];
    }
}

#[inline(always)]
fn inner(
    p: &Parameters,
    film: &FilmBlock,
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    addends: &mut Addends,
) {
    let (mut forces, mut arms, mut doubles) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
    for lane in 0..LANES {
        let radius = balls.radius.0[lane];
        let (spin, surface) = (motions.get(lane).spin, p.inner.surface_speed.0[lane]);
        // ΔVi = ωi Ri − (vt + ω R) and δi = Ri + R − q.
        let tangential = surface - results.inner.slip.0[lane] - spin * radius;
        let distance = balls.inner_contact_distance.0[lane] - results.inner.deflection.0[lane];
        let arm = (p.inner.radius.0[lane] - radius) / distance;
        let doubled = surface + spin * radius - tangential * arm;
        let curve = film.inner.get(lane);
        forces.0[lane] = curve.force_n(results.inner.force.0[lane], 0.5 * doubled);
        arms.0[lane] = arm;
        doubles.0[lane] = doubled;
    }
    for lane in 0..LANES {
        let (ex, ey) = (
            results.inner_polar.ex.0[lane],
            results.inner_polar.ey.0[lane],
        );
        let force = forces.0[lane];
        let along = force * arms.0[lane];
        results.load.fx.0[lane] -= along * ey;
        results.load.fy.0[lane] += along * ex;
        results.load.torque.0[lane] -= force * balls.radius.0[lane];
        addends[Sum::RingX as usize].0[lane] += along * ey;
        addends[Sum::RingY as usize].0[lane] -= along * ex;
        addends[Sum::RollingDrive as usize].0[lane] = force * p.inner.surface_speed.0[lane];
        addends[Sum::RollingResistance as usize].0[lane] += force * doubles.0[lane];
    }
}
