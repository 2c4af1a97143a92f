//! Positions of the balls of a block and the geometry of their outer contacts.

use super::motions::{CentreLanes, Motions};
use super::parameters::{Parameters, Polynomial, RacewayBlock};
use super::workspace::BlockResults;
use crate::ball::BallLanes;
use crate::contact::{
    OuterGeometry, RacewayPosition, RacewayPositionLanes, RacewayValues, RacewayValuesLanes,
    nominal_geometry, unequal_geometry,
};
use crate::numerics::lanes::LANES;
use crate::numerics::lanes::Lanes;

/// Polar coordinates of every ball about the outer ring and the geometry of its contact on the plain raceway.
#[inline(always)]
pub(super) fn plain_positions(
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    outer_ring: &CentreLanes,
) {
    for lane in 0..LANES {
        let motion = motions.get(lane);
        let polar = motion.about(&outer_ring.get(lane));
        results.polar.put(lane, polar);
        results.spin.0[lane] = motion.spin;
        let plain = OuterGeometry::plain(&balls.get(lane));
        // Fields that the other cases never change stay as they are.
        let geometry = &mut results.geometry;
        geometry.orbit_radius.0[lane] = plain.orbit_radius;
        geometry.effective_radius.0[lane] = plain.effective_radius;
    }
}

/// Geometry of the outer contact of the balls in one discrete raceway.
#[inline(always)]
pub(super) fn raceway_geometry(
    p: &Parameters,
    balls: &BallLanes,
    raceway: &RacewayBlock,
    results: &mut BlockResults,
) {
    let mut position = RacewayPositionLanes::ZERO;
    let mut values = RacewayValuesLanes::ZERO;
    for lane in 0..LANES {
        let polar = results.polar.get(lane);
        position.put(
            lane,
            RacewayPosition::new(&raceway.constants.get(lane), &polar),
        );
    }
    if !p.unequal {
        // The radius does not go through memory: a choice between two numbers there becomes one
        // between their addresses, lane by lane.
        let [even, odd] = halves(&raceway.radius, &position.u);
        for lane in 0..LANES {
            let values = RacewayValues {
                radius: even[lane] + odd[lane] * position.u.0[lane],
                ..RacewayValues::default()
            };
            let plain = results.geometry.get(lane);
            let geometry = nominal_geometry(&position.get(lane), &values, plain);
            results.geometry.effective_radius.0[lane] = geometry.effective_radius;
        }
        return;
    }
    polynomial(&raceway.radius, &position.u, &mut values.radius);
    polynomial(&raceway.radius_slope, &position.u, &mut values.radius_slope);
    let geometries = &mut results.geometry;
    for lane in 0..LANES {
        let geometry = unequal_geometry(
            &raceway.constants.get(lane),
            &p.outer.get(lane),
            &balls.get(lane),
            &position.get(lane),
            &values.get(lane),
            geometries.get(lane),
        );
        geometries.put(lane, geometry);
    }
}

/// Σ c_k u^k from the sums of its even and its odd powers, which do not wait for each other.
#[inline(always)]
pub(super) fn polynomial(coefficients: &Polynomial, u: &Lanes, value: &mut Lanes) {
    let [even, odd] = halves(coefficients, u);
    for lane in 0..LANES {
        value.0[lane] = even[lane] + odd[lane] * u.0[lane];
    }
}

/// Sums of the even powers of a polynomial, and of the odd powers over u.
#[inline(always)]
fn halves(coefficients: &Polynomial, u: &Lanes) -> [[f64; LANES]; 2] {
    let (mut even, mut odd) = ([0.0; LANES], [0.0; LANES]);
    for [c0, c1] in coefficients.iter().rev() {
        for lane in 0..LANES {
            let square = u.0[lane] * u.0[lane];
            even[lane] = even[lane] * square + c0.0[lane];
            odd[lane] = odd[lane] * square + c1.0[lane];
        }
    }
    [even, odd]
}
