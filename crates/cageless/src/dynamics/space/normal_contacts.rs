//! Forces normal to the raceways, weight, and the frames in which friction acts.

use super::bearing::{Bearing, Totals};
use super::block::{ALL_PLACES, INNER, SpaceBlock, WITHOUT_SECOND};
use super::frame::{Frame, FrameLanes, of_lane};
use super::inner_groove::{InnerGrooveLanes, InnerTouchLanes};
use super::outer_groove::{OuterGrooveLanes, OuterPointLanes, OuterTouchLanes};
use super::ring::RingMotion;
use crate::ball::{BallLanes, PolarMotionLanes};
use crate::contact::{NormalForce, positive};
use crate::dynamics::coordinates::BallCoordinate;
use crate::dynamics::layout::Layout;
use crate::numerics::lanes::{LANES, Lanes, lane_struct};
use crate::numerics::vector::{SectionVector, cross, dot, plus};
use crate::simd::{BlockResults, Motions, block_at, block_mut};

/// The coordinates of the place of a ball, and those of their rates.
pub(super) const PLACE: [BallCoordinate; 3] =
    [BallCoordinate::X, BallCoordinate::Y, BallCoordinate::Z];
const RATES: [BallCoordinate; 3] = [BallCoordinate::Vx, BallCoordinate::Vy, BallCoordinate::Vz];

/// The balls of a block in a vector.
struct Moving {
    /// m.
    place: [Lanes; 3],
    /// m/s.
    velocity: [Lanes; 3],
    /// Height above the outer ring along the axis, m.
    height: Lanes,
    /// Rate of that, with the rings that slide, m/s.
    rise: Lanes,
}

/// A block of balls and its work arrays.
pub(super) struct BlockWork<'w> {
    /// Number of the block.
    pub number: usize,
    /// Results that plane and space share.
    pub results: &'w mut BlockResults,
    /// Work arrays of space.
    pub space: &'w mut SpaceBlock,
}

/// Adds the normal forces on the balls of a block to the rates.
#[inline(always)]
pub(super) fn normal_contacts(
    bearing: Bearing<'_>,
    work: BlockWork<'_>,
    ring: &RingMotion,
    y: &[f64],
    totals: &mut Totals,
    dydt: &mut [f64],
) {
    let BlockWork {
        number: block,
        results,
        space: b,
    } = work;
    let Bearing { model, space, .. } = bearing;
    let (layout, balls) = (bearing.parameters.layout, bearing.parameters.balls(block));
    let at = |coordinate| layout.array(coordinate) + block * LANES;
    let moving = moving(layout, results, b, y, block);
    for (coordinate, rates) in PLACE.into_iter().zip(&moving.velocity) {
        *block_mut(dydt, at(coordinate)) = rates.0;
    }
    touch_outer(bearing, results, b, balls, &moving.height, block);
    let mut outer = OuterForceLanes::ZERO;
    press_outer(balls, &b.outer, &results.polar, &moving.rise, &mut outer);
    frame_outer_points(model.outer.friction_factor, &results.polar, &outer, b);
    b.outer_ring_force_n = [outer.x, outer.y, outer.z];
    results.geometry.effective_radius = outer.effective_radius;
    (results.outer.deflection, results.outer.force) = (b.outer.approach, outer.resultant);

    let mut inner = InnerForceLanes::ZERO;
    let at_inner = AtInner {
        balls,
        groove: &b.inner_groove,
        half_length: &b.half_length_m1_2[1],
        ring,
        moving: &moving,
    };
    press_inner(&at_inner, &mut b.inner, &mut b.frames[INNER], &mut inner);
    (results.inner.deflection, results.inner.force) = (b.inner.approach, b.frames[INNER].force_n);
    add_to_totals(&outer, &inner, totals);
    let weight = weight(balls, model.ring.gravity);
    let pressed = [
        (&outer.x, &inner.x),
        (&outer.y, &inner.y),
        (&outer.z, &inner.z),
    ];
    for (axis, (outer, inner)) in pressed.into_iter().enumerate() {
        let upward = f64::from(u8::from(axis == space.upward));
        let rates = block_mut(dydt, at(RATES[axis]));
        for lane in 0..LANES {
            let force = (upward * weight.0[lane] - outer.0[lane]) - inner.0[lane];
            rates[lane] = force * balls.inverse_mass.0[lane];
        }
    }
    let mut sinking = Lanes::ZERO;
    for lane in 0..LANES {
        sinking.0[lane] = weight.0[lane] * moving.velocity[space.upward].0[lane];
    }
    totals.weight += sinking.sum();
    (results.outer_friction, results.inner_friction) = (Lanes::ZERO, Lanes::ZERO);
}

/// Weights of the balls of a block, N upward.
#[inline(always)]
fn weight(balls: &BallLanes, gravity: f64) -> Lanes {
    let mut weight = Lanes::ZERO;
    for lane in 0..LANES {
        weight.0[lane] = -balls.mass.0[lane] * gravity;
    }
    weight
}

/// Reads the motion of the balls of a block.
#[inline(always)]
fn moving(
    layout: Layout,
    results: &mut BlockResults,
    b: &mut SpaceBlock,
    y: &[f64],
    block: usize,
) -> Moving {
    let at = |coordinate| layout.array(coordinate) + block * LANES;
    let mut place = [Lanes::ZERO; 3];
    let mut velocity = [Lanes::ZERO; 3];
    for axis in 0..3 {
        place[axis].0 = *block_at(y, at(PLACE[axis]));
        velocity[axis].0 = *block_at(y, at(RATES[axis]));
    }
    results.spin = Lanes(*block_at(y, at(BallCoordinate::Spin)));
    b.velocity = b.velocities(layout, y, block);
    let motions = Motions::new(layout, y, block);
    let outer_ring = layout.outer_ring_motion(y);
    for lane in 0..LANES {
        let polar = motions.get(lane).about(&outer_ring);
        results.polar.put(lane, polar);
    }
    let along_axis = layout.outer_ring_along_axis(y);
    let (mut height, mut rise) = (place[2], velocity[2]);
    for lane in 0..LANES {
        height.0[lane] -= along_axis.z;
        rise.0[lane] -= along_axis.vz + b.sliding_speed.0[lane];
    }
    Moving {
        place,
        velocity,
        height,
        rise,
    }
}

/// Contacts of the balls of a block with the outer ring, and the places at which they bear.
#[inline(always)]
fn touch_outer(
    bearing: Bearing<'_>,
    results: &BlockResults,
    b: &mut SpaceBlock,
    balls: &BallLanes,
    height: &Lanes,
    block: usize,
) {
    let polar = &results.polar;
    let mut beyond = Lanes::ZERO;
    for lane in 0..LANES {
        beyond.0[lane] = polar.distance.0[lane] - balls.outer_orbit_radius.0[lane];
    }
    touch_plain(&b.outer_groove, &beyond, height, &mut b.outer);
    for lane in 0..LANES.min(bearing.model.layout.balls - block * LANES) {
        let direction = polar.get(lane).direction();
        if let Some(here) = bearing.space.flanks_at(block * LANES + lane, direction) {
            let groove = b.outer_groove.get(lane);
            let touch = groove.touch_flanks(beyond.0[lane], height.0[lane], &here);
            b.outer.put(lane, touch);
        }
    }
    let both = b.outer.share_1.0.iter().any(|share| *share > 0.0);
    b.places = if both { &ALL_PLACES } else { &WITHOUT_SECOND };
}

/// Frames of both points at the outer ring, and the curvature there.
#[inline(always)]
fn frame_outer_points(
    friction_factor: f64,
    polar: &PolarMotionLanes,
    outer: &OuterForceLanes,
    b: &mut SpaceBlock,
) {
    let touch = &b.outer;
    let [first, second, _] = &mut b.frames;
    let points = touch.points().into_iter().zip([first, second]);
    for (at, (point, frames)) in points.enumerate() {
        if !b.places.contains(&at) {
            (frames.force_n, frames.friction_normal_n) = (Lanes::ZERO, Lanes::ZERO);
            continue;
        }
        let half_length = &b.half_length_m1_2[0];
        frame_outer(
            &point,
            outer,
            touch,
            polar,
            half_length,
            friction_factor,
            frames,
        );
    }
    let mut curvature = b.groove_curvature;
    curvature.add(&touch.curvature_change, 0.25);
    b.curvature[0] = curvature;
}

/// Adds the forces on the inner ring and the powers of damping to the sums.
#[inline(always)]
fn add_to_totals(outer: &OuterForceLanes, inner: &InnerForceLanes, totals: &mut Totals) {
    let on_ring = [
        &inner.x,
        &inner.y,
        &inner.z,
        &inner.moment_x,
        &inner.moment_y,
        &inner.moment_z,
    ];
    for (total, lanes) in totals.ring.iter_mut().zip(on_ring) {
        *total += lanes.sum();
    }
    let mut damping = outer.damping_power_w;
    damping.add(&inner.damping_power_w, 1.0);
    totals.damping += damping.sum();
}

// Each function takes what it reads and what it writes as separate arguments: the compiler does not
// vectorise a loop that reads and writes one struct.

lane_struct! {
    /// Normal force of a ball on the outer ring.
    pub(super) struct OuterForce per lane OuterForceLanes {
        /// Along X, N.
        x,
        /// Along Y, N.
        y,
        /// Along Z, N.
        z,
        /// K δe^(3/2) with its damping, of which each point bears its share, N.
        force_n,
        /// Magnitude of the sum of the normal forces of both points, N.
        resultant,
        /// √δ, m^½.
        root,
        /// r, m.
        effective_radius,
        /// W.
        damping_power_w,
    }
}

/// Contacts with the plain groove.
#[inline(always)]
fn touch_plain(
    groove: &OuterGrooveLanes,
    beyond: &Lanes,
    height: &Lanes,
    touch: &mut OuterTouchLanes,
) {
    for lane in 0..LANES {
        let plain = groove.get(lane).touch(beyond.0[lane], height.0[lane]);
        touch.put(lane, plain);
    }
}

/// Forces of the balls, which rise with `rise` along the axis, on the outer ring.
#[inline(always)]
fn press_outer(
    balls: &BallLanes,
    touches: &OuterTouchLanes,
    polar: &PolarMotionLanes,
    rise: &Lanes,
    forces: &mut OuterForceLanes,
) {
    for lane in 0..LANES {
        let (ball, touch, polar) = (balls.get(lane), touches.get(lane), polar.get(lane));
        let mut rate = touch.slope * polar.orbit;
        let velocity = SectionVector {
            radial: polar.radial,
            axial: rise.0[lane],
        };
        for point in touch.points() {
            rate += point.share * point.normal.dot(velocity);
        }
        let approach = positive(touch.approach);
        let contact = NormalForce::at_raceway(
            ball.outer_stiffness_n_m1_5 * touch.stiffness,
            ball.raceway_damping,
            approach,
            rate,
        );
        let root = approach.sqrt();
        let pressed = touch.resultant();
        // Of ⅖ K δ^(5/2) both K and δ change with ψ.
        let stiffening = ball.outer_stiffness_n_m1_5 * touch.stiffening;
        let stiffening = 0.4 * stiffening * approach * approach * root;
        let turning = (contact.force_n * touch.slope + stiffening) / polar.distance;
        let radial = contact.force_n * pressed.radial;
        let total = touch.share_0 + touch.share_1;
        let resultant = pressed.length();
        let in_contact = total > 0.0;
        let effective = if in_contact { resultant / total } else { 1.0 };
        forces.put(
            lane,
            OuterForce {
                x: radial * polar.ex - turning * polar.ey,
                y: radial * polar.ey + turning * polar.ex,
                z: contact.force_n * pressed.axial,
                force_n: contact.force_n,
                resultant: contact.force_n * resultant,
                root,
                effective_radius: ball.radius * effective,
                damping_power_w: contact.damping_power_w,
            },
        );
    }
}

/// Frames of a point at the outer ring.
#[inline(always)]
fn frame_outer(
    point: &OuterPointLanes<'_>,
    forces: &OuterForceLanes,
    touches: &OuterTouchLanes,
    polar: &PolarMotionLanes,
    half_length: &Lanes,
    friction_factor: f64,
    frames: &mut FrameLanes,
) {
    for lane in 0..LANES {
        let (radial, axial) = (point.radial.0[lane], point.axial.0[lane]);
        let polar = polar.get(lane);
        let force_n = point.share.0[lane] * forces.force_n.0[lane];
        let half_length = half_length.0[lane] * touches.half_length.0[lane];
        frames.put(
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
                friction_normal_n: force_n * friction_factor,
                half_length_m: half_length * forces.root.0[lane] * point.root.0[lane],
                ..Frame::default()
            },
        );
    }
}

lane_struct! {
    /// Normal force of a ball on the inner ring, and its moment about the centre of the ring.
    pub(super) struct InnerForce per lane InnerForceLanes {
        /// Along X, N.
        x,
        /// Along Y, N.
        y,
        /// Along Z, N.
        z,
        /// About X, N·m.
        moment_x,
        /// About Y, N·m.
        moment_y,
        /// About Z, N·m.
        moment_z,
        /// W.
        damping_power_w,
    }
}

/// Balls at the inner ring.
struct AtInner<'a> {
    balls: &'a BallLanes,
    groove: &'a InnerGrooveLanes,
    /// a over √δ, m^½.
    half_length: &'a Lanes,
    ring: &'a RingMotion,
    moving: &'a Moving,
}

/// Contacts, frames and forces at the inner ring.
#[inline(always)]
fn press_inner(
    at: &AtInner<'_>,
    touches: &mut InnerTouchLanes,
    frames: &mut FrameLanes,
    forces: &mut InnerForceLanes,
) {
    let AtInner {
        balls,
        groove,
        half_length,
        ring,
        moving,
    } = *at;
    let axis = ring.axis.into();
    let (centre, tilting) = (ring.centre.into(), ring.tilting.into());
    let ring_velocity = ring.velocity.into();
    for lane in 0..LANES {
        let from_ring = plus(of_lane(&moving.place, lane), -1.0, centre);
        let (ball, touch) = (balls.get(lane), groove.get(lane).touch(from_ring, axis));
        touches.put(lane, touch);
        let [normal, across, along] = touch.axes(axis);
        let surface = plus(ring_velocity, 1.0, cross(tilting, from_ring));
        let velocity = of_lane(&moving.velocity, lane);
        let approach = positive(touch.approach);
        let contact = NormalForce::at_raceway(
            ball.inner_stiffness_n_m1_5,
            ball.raceway_damping,
            approach,
            dot(normal, plus(velocity, -1.0, surface)),
        );
        let reach = groove.curvature.0[lane] - touch.length;
        let arm = plus(from_ring, reach, normal);
        let force_n = contact.force_n;
        frames.put(
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
                force_n,
                friction_normal_n: force_n,
                half_length_m: half_length.0[lane] * approach.sqrt(),
            },
        );
        let moment = cross(from_ring, normal);
        forces.put(
            lane,
            InnerForce {
                x: force_n * normal[0],
                y: force_n * normal[1],
                z: force_n * normal[2],
                moment_x: force_n * moment[0],
                moment_y: force_n * moment[1],
                moment_z: force_n * moment[2],
                damping_power_w: contact.damping_power_w,
            },
        );
    }
}
