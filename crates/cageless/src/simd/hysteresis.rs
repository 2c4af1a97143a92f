//! Elastic hysteresis of rolling contacts, lane by lane: a couple on the spin of the ball and on the ring.

use super::motions::Motions;
use super::parameters::Parameters;
use super::sums::{Addends, Sum};
use super::workspace::BlockResults;
use crate::ball::BallLanes;
use crate::numerics::inverse_root::{binary_logarithm, inverse_cube_root};
use crate::numerics::lanes::{LANES, Lanes};

/// u₀², m²/s²: the moment goes through zero with the speed of rolling.
const LEAST_SPEED_SQUARE: f64 = 1e-6;

/// Adds the moments of the contacts of a block, of outer and inner factors, to loads and addends.
#[inline(always)]
pub(super) fn add(
    (p, [outer, inner]): (&Parameters, &[Lanes; 2]),
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    addends: &mut Addends,
) {
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
        let moment = factor * power_1_33(share * load) * sense(spin, ball);
        results.load.torque.0[lane] -= moment;
        addends[Sum::RollingResistance as usize].0[lane] += moment * spin;
    }
    for lane in 0..LANES {
        let spin = motions.get(lane).spin;
        let driven = p.inner.surface_speed.0[lane] / p.inner.radius.0[lane];
        let relative = spin + driven;
        let load = power_1_33(results.inner.force.0[lane]);
        let moment = inner.0[lane] * load * sense(relative, balls.radius.0[lane]);
        results.load.torque.0[lane] -= moment;
        addends[Sum::RollingDrive as usize].0[lane] += moment * driven;
        addends[Sum::RollingResistance as usize].0[lane] += moment * relative;
    }
}

/// Sense of a rotation at a radius, ±1 above u₀.
#[inline(always)]
fn sense(rotation_rad_s: f64, radius_m: f64) -> f64 {
    let speed = rotation_rad_s * radius_m;
    speed / (speed * speed + LEAST_SPEED_SQUARE).sqrt()
}

/// Q^1.33 = Q^(4/3) Q^(−1/300), relative error below 1e-6 from a micronewton to a meganewton; 0 of 0.
#[inline(always)]
fn power_1_33(load_n: f64) -> f64 {
    let root = inverse_cube_root(load_n);
    let x = -std::f64::consts::LN_2 / 300.0 * binary_logarithm(load_n);
    let small = 1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0))));
    load_n * load_n * (root * root) * small
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_follows_the_standard_library() {
        for k in -120..=120 {
            let load_n = (0.115 * f64::from(k)).exp();
            let relative = power_1_33(load_n) / load_n.powf(1.33) - 1.0;
            assert!(relative.abs() < 1e-6, "{load_n}: {relative:e}");
        }
        assert_eq!(power_1_33(0.0), 0.0);
    }
}
