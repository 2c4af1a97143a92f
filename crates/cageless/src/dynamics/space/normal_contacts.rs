//! Forces normal to the raceways, weight, and the frames in which friction acts.

use super::bearing::{Bearing, Totals};
use super::block::{INNER, SpaceBlock};
use super::frame::{Frame, SIZE, of_lane};
use super::outer_groove::OuterTouchLanes;
use super::ring::RingMotion;
use super::vector::{cross, dot, plus};
use crate::contact::{NormalForce, positive};
use crate::dynamics::coordinates::BallCoordinate;
use crate::numerics::lanes::{LANES, Lanes};
use crate::simd::{BlockResults, Motions, block_at, block_mut};

/// The coordinates of the place of a ball, and those of their rates.
const PLACE: [BallCoordinate; 3] = [BallCoordinate::X, BallCoordinate::Y, BallCoordinate::Z];
const RATES: [BallCoordinate; 3] = [BallCoordinate::Vx, BallCoordinate::Vy, BallCoordinate::Vz];

/// Adds the normal forces on the balls of a block to the rates.
#[inline(always)]
pub(super) fn normal_contacts(
    (p, model, space, _): Bearing<'_>,
    (results, b): (&mut BlockResults, &mut SpaceBlock),
    ring: &RingMotion,
    y: &[f64],
    block: usize,
    totals: &mut Totals,
    dydt: &mut [f64],
) {
    let (layout, balls) = (model.layout, p.balls(block));
    let at = |coordinate| layout.array(coordinate) + block * LANES;
    let place = PLACE.map(|c| Lanes(*block_at(y, at(c))));
    let velocity = RATES.map(|c| Lanes(*block_at(y, at(c))));
    for (coordinate, rates) in PLACE.into_iter().zip(&velocity) {
        *block_mut(dydt, at(coordinate)) = rates.0;
    }
    results.spin = Lanes(*block_at(y, at(BallCoordinate::Spin)));
    b.velocity = b.velocities(layout, y, block);
    let motions = Motions::new(layout, y, block);
    let outer_ring = layout.outer_ring_motion(y);
    for lane in 0..LANES {
        let polar = motions.get(lane).about(&outer_ring);
        results.polar.put(lane, polar);
    }
    let [outer_z, outer_vz] = layout.outer_ring_along_axis(y);
    let mut height = place[2];
    for z in &mut height.0 {
        *z -= outer_z;
    }

    let mut outer = OuterTouchLanes::ZERO;
    for lane in 0..LANES {
        let beyond = results.polar.distance.0[lane] - balls.outer_orbit_radius.0[lane];
        outer.put(lane, b.outer_groove.get(lane).touch(beyond, height.0[lane]));
    }
    for lane in 0..LANES.min(layout.balls - block * LANES) {
        let direction = [results.polar.ex.0[lane], results.polar.ey.0[lane]];
        if let Some(here) = space.flanks_at(block * LANES + lane, direction) {
            let beyond = results.polar.distance.0[lane] - balls.outer_orbit_radius.0[lane];
            let groove = b.outer_groove.get(lane);
            outer.put(lane, groove.touch_flanks(beyond, height.0[lane], &here));
        }
    }
    b.outer = outer;

    let mut frames = b.frames.clone();
    let mut forces = [Lanes::ZERO; 3];
    let mut on_outer_ring = [Lanes::ZERO; 3];
    let (mut damping, mut outer_force) = (Lanes::ZERO, Lanes::ZERO);
    let mut curvature = Lanes::ZERO;
    for lane in 0..LANES {
        let (ball, touch, polar) = (balls.get(lane), b.outer.get(lane), results.polar.get(lane));
        let mut rate = touch.slope * polar.orbit;
        let points = touch.points();
        for k in 0..2 {
            let [radial, axial, share, _] = points[k];
            rate += share * (radial * polar.radial + axial * (velocity[2].0[lane] - outer_vz));
        }
        let approach = positive(touch.approach);
        let contact = NormalForce::at_raceway(
            ball.outer_stiffness_n_m1_5 * touch.stiffness,
            ball.raceway_damping,
            approach,
            rate,
        );
        let root = approach.sqrt();
        let half_length = b.half_length_m1_2[0].0[lane] * touch.half_length * root;
        let [along, across] = touch.resultant();
        // Of ⅖ K δ^(5/2) both K and δ change with ψ.
        let stiffening = ball.outer_stiffness_n_m1_5 * touch.stiffening;
        let stiffening = 0.4 * stiffening * approach * approach * root;
        let turning = (contact.force_n * touch.slope + stiffening) / polar.distance;
        let radial = contact.force_n * along;
        let on_ring = [
            radial * polar.ex - turning * polar.ey,
            radial * polar.ey + turning * polar.ex,
            contact.force_n * across,
        ];
        for k in 0..2 {
            let [radial, axial, share, root] = points[k];
            let force_n = share * contact.force_n;
            frames[k].put(
                lane,
                Frame {
                    normal_x: polar.ex * radial,
                    normal_y: polar.ey * radial,
                    normal_z: axial,
                    across_x: -polar.ex * axial,
                    across_y: -polar.ey * axial,
                    across_z: radial,
                    along_x: polar.ey,
                    along_y: -polar.ex,
                    force_n,
                    friction_normal_n: force_n * model.outer.friction_factor,
                    half_length_m: half_length * root,
                    ..Frame::default()
                },
            );
        }
        let total = touch.share_0 + touch.share_1;
        let resultant = (along * along + across * across).sqrt();
        let in_contact = total > 0.0;
        let effective = if in_contact { resultant / total } else { 1.0 };
        results.geometry.effective_radius.0[lane] = ball.radius * effective;
        curvature.0[lane] = b.groove_curvature.0[lane] + 0.25 * touch.curvature_change;
        results.outer.deflection.0[lane] = touch.approach;
        results.outer.force.0[lane] = contact.force_n * resultant;
        outer_force.0[lane] = contact.force_n;
        for i in 0..3 {
            on_outer_ring[i].0[lane] = on_ring[i];
            forces[i].0[lane] = -on_ring[i];
        }
        forces[space.upward].0[lane] -= ball.mass * model.ring.gravity;
        damping.0[lane] = contact.damping_power_w;
    }
    (b.outer_force_n, b.outer_ring_force_n) = (outer_force, on_outer_ring);
    b.curvature[0] = curvature;

    let axis = ring.axis.into();
    let (centre, tilting) = (ring.centre.into(), ring.tilting.into());
    let ring_velocity = ring.velocity.into();
    let mut inner = b.inner.clone();
    for lane in 0..LANES {
        let ball = plus(of_lane(&place, lane), -1.0, centre);
        inner.put(lane, b.inner_groove.get(lane).touch(ball, axis));
    }
    let mut on_ring = [Lanes::ZERO; SIZE];
    let mut weight = Lanes::ZERO;
    for lane in 0..LANES {
        let (ball, touch) = (balls.get(lane), inner.get(lane));
        let [normal, across, along] = touch.axes(axis);
        let from_ring = touch.ball();
        let surface = plus(ring_velocity, 1.0, cross(tilting, from_ring));
        let moving = of_lane(&velocity, lane);
        let approach = positive(touch.approach);
        let contact = NormalForce::at_raceway(
            ball.inner_stiffness_n_m1_5,
            ball.raceway_damping,
            approach,
            dot(normal, plus(moving, -1.0, surface)),
        );
        let arm = plus(
            from_ring,
            b.inner_groove.curvature.0[lane] - touch.length,
            normal,
        );
        frames[INNER].put(
            lane,
            Frame {
                normal_x: normal[0],
                normal_y: normal[1],
                normal_z: normal[2],
                across_x: across[0],
                across_y: across[1],
                across_z: across[2],
                along_x: along[0],
                along_y: along[1],
                along_z: along[2],
                arm_x: arm[0],
                arm_y: arm[1],
                arm_z: arm[2],
                force_n: contact.force_n,
                friction_normal_n: contact.force_n,
                half_length_m: b.half_length_m1_2[1].0[lane] * approach.sqrt(),
            },
        );
        let moment = cross(from_ring, normal);
        for i in 0..3 {
            let force = contact.force_n * normal[i];
            on_ring[i].0[lane] = force;
            on_ring[3 + i].0[lane] = contact.force_n * moment[i];
            forces[i].0[lane] -= force;
        }
        results.inner.deflection.0[lane] = touch.approach;
        results.inner.force.0[lane] = contact.force_n;
        damping.0[lane] += contact.damping_power_w;
        weight.0[lane] = -ball.mass * model.ring.gravity * moving[space.upward];
    }
    b.inner = inner;
    for (total, lanes) in totals.ring.iter_mut().zip(&on_ring) {
        *total += lanes.sum();
    }
    totals.damping += damping.sum();
    totals.weight += weight.sum();
    for (coordinate, force) in RATES.into_iter().zip(&forces) {
        let rates = block_mut(dydt, at(coordinate));
        for lane in 0..LANES {
            rates[lane] = force.0[lane] * balls.inverse_mass.0[lane];
        }
    }
    (results.outer_friction, results.inner_friction) = (Lanes::ZERO, Lanes::ZERO);
    b.frames = frames;
}
