//! Rolling force of lubricated contacts in space, one at the centre of each.
//!
//! It acts on the motions that its dissipation F_R 2u has, so that momentum, moments and energy close. With ρ and nρ
//! of the axis of the ring, the velocity **w** of the ball and its rotation **ω** relative to that axis, which may tilt,
//! and the distance ρA of the contact from it
//!
//!   2u = g **τ**·**w** − R **l**·**ω** − ωi ρA,   outer: g = −(ρ + 2R nρ)/ρ,   inner: g = (R cos α − ρA)/ρ,
//!
//! the last term of 2u at the inner ring alone. Hysteresis of the steel is a couple about **l**.

use super::bearing::Totals;
use super::block::{INNER, SpaceBlock};
use super::frame::{SIZE, of_lane};
use super::friction::accelerate;
use super::ring::RingMotion;
use crate::ball::{BallLanes, PolarMotionLanes};
use crate::dynamics::layout::Layout;
use crate::film::hysteresis::{power_1_33, sense};
use crate::film::{CurvePolynomial, GrooveCurves, RollingCurve, RollingCurveLanes};
use crate::numerics::lanes::{LANES, Lanes, lane_struct};
use crate::numerics::vector::{cross, dot, plus};

lane_struct! {
    /// Rolling of a contact.
    pub(crate) struct Entrainment per lane EntrainmentLanes {
        /// cos α over the distance of the contact from the axis of the ring, 1/m.
        curvature,
        /// g.
        gear,
        /// 2u along τ, m/s.
        doubled,
        /// Speed of the surface of the ball by its rotation against the ring, about **l**, m/s.
        turning,
    }
}

/// The balls of a block, which roll on a film.
pub(super) struct RollingBlock<'a> {
    pub film: &'a GrooveCurves,
    pub balls: &'a BallLanes,
    /// Motion about the outer ring.
    pub polar: &'a PolarMotionLanes,
    /// Motion of the inner ring.
    pub ring: &'a RingMotion,
    /// ωi, rad/s.
    pub inner_speed: f64,
}

/// Adds the rolling force of the contacts of a block to the rates and the sums.
#[inline(always)]
pub(super) fn add_rolling(
    of: &RollingBlock<'_>,
    b: &mut SpaceBlock,
    layout: Layout,
    block: usize,
    totals: &mut Totals,
    dydt: &mut [f64],
) {
    let (film, balls) = (of.film, of.balls);
    let mut forces = [Lanes::ZERO; SIZE];
    let mut rolling = EntrainmentLanes::ZERO;
    for &place in b.places {
        let frames = &b.frames[place];
        let curves = if place == INNER {
            roll_inner(balls, b, of.ring, of.inner_speed, &mut rolling);
            &film.inner
        } else {
            roll_outer(balls, of.polar, b, place, &mut rolling);
            &film.outer
        };
        let mut curve = curve_at(curves, &rolling.curvature);
        if place != INNER && !film.edges.is_empty() {
            set_at_edges(&film.edges, b, &mut curve);
        }
        let factor = film
            .hysteresis
            .map(|of| if place == INNER { of.inner } else { of.outer });
        let mut force = [Lanes::ZERO; SIZE];
        let mut power = Lanes::ZERO;
        for lane in 0..LANES {
            let (frame, rolling) = (frames.get(lane), rolling.get(lane));
            let size = curve
                .get(lane)
                .force_n(frame.force_n, 0.5 * rolling.doubled);
            // Padding has no place.
            let bears = frame.force_n > 0.0;
            let kept = |value: f64| if bears { value } else { 0.0 };
            let along = -size * rolling.gear;
            let moment = factor.map_or(0.0, |factor| {
                let size = factor * power_1_33(frame.force_n) / balls.radius.0[lane];
                size * sense(rolling.turning)
            });
            let across = size + moment;
            force[0].0[lane] = kept(along * frame.along_x);
            force[1].0[lane] = kept(along * frame.along_y);
            force[2].0[lane] = kept(along * frame.along_z);
            force[3].0[lane] = kept(across * frame.across_x);
            force[4].0[lane] = kept(across * frame.across_y);
            force[5].0[lane] = kept(across * frame.across_z);
            power.0[lane] = kept(size * rolling.doubled + moment * rolling.turning);
        }
        totals.rolling += power.sum();
        for i in 0..SIZE {
            forces[i].add(&force[i], 1.0);
        }
        match place {
            INNER => react(balls, b, &force, totals),
            _ => (0..3).for_each(|i| b.outer_ring_force_n[i].add(&force[i], -1.0)),
        }
    }
    accelerate(layout, balls, block, &forces, dydt);
}

/// Rolling of balls at a point of the outer ring.
#[inline(always)]
fn roll_outer(
    balls: &BallLanes,
    polar: &PolarMotionLanes,
    b: &SpaceBlock,
    place: usize,
    rolling: &mut EntrainmentLanes,
) {
    let radial = [&b.outer.radial_0, &b.outer.radial_1][place];
    for lane in 0..LANES {
        let (frame, v) = (b.frames[place].get(lane), of_lane(&b.velocity, lane));
        let (distance, normal) = (polar.distance.0[lane], radial.0[lane]);
        let reach = balls.radius.0[lane] * normal;
        let gear = -(distance + 2.0 * reach) / distance;
        let across = [frame.across_x, frame.across_y, frame.across_z];
        let turning = dot(across, [v[3], v[4], v[5]]);
        rolling.put(
            lane,
            Entrainment {
                curvature: normal / (distance + reach),
                gear,
                // τ points against the orbit.
                doubled: -gear * polar.tangential.0[lane] - turning,
                turning: -turning,
            },
        );
    }
}

/// Place of a ball from the centre of the inner ring, m.
#[inline(always)]
fn from_ring(b: &SpaceBlock, lane: usize) -> [f64; 3] {
    let frame = b.frames[INNER].get(lane);
    let reach = b.inner_groove.curvature.0[lane] - b.inner.length.0[lane];
    let arm = [frame.arm_x, frame.arm_y, frame.arm_z];
    plus(
        arm,
        -reach,
        [frame.normal_x, frame.normal_y, frame.normal_z],
    )
}

/// Rolling of balls at the inner ring.
#[inline(always)]
fn roll_inner(
    balls: &BallLanes,
    b: &SpaceBlock,
    ring: &RingMotion,
    inner_speed: f64,
    rolling: &mut EntrainmentLanes,
) {
    let (groove, touch) = (&b.inner_groove, &b.inner);
    let (centre, tilting) = (ring.velocity.into(), ring.tilting.into());
    for lane in 0..LANES {
        let (frame, v) = (b.frames[INNER].get(lane), of_lane(&b.velocity, lane));
        let (radius, cosine) = (balls.radius.0[lane], touch.cosine.0[lane]);
        let (middle, curvature) = (groove.centre.0[lane], groove.curvature.0[lane]);
        let distance = middle - cosine * touch.length.0[lane];
        let contact = middle - cosine * curvature;
        let gear = (radius * cosine - contact) / distance;
        let carried = cross(tilting, from_ring(b, lane));
        let orbit = plus(plus([v[0], v[1], v[2]], -1.0, centre), -1.0, carried);
        let turning = plus([v[3], v[4], v[5]], -radius, tilting);
        let along = [frame.along_x, frame.along_y, frame.along_z];
        let across = [frame.across_x, frame.across_y, frame.across_z];
        rolling.put(
            lane,
            Entrainment {
                curvature: cosine / contact,
                gear,
                doubled: gear * dot(along, orbit) - dot(across, turning) - inner_speed * contact,
                turning: -dot(across, turning) - inner_speed * radius * cosine,
            },
        );
    }
}

/// Constants of contacts with these curvatures.
#[inline(always)]
fn curve_at(curves: &CurvePolynomial, curvature: &Lanes) -> RollingCurveLanes {
    let mut curve = RollingCurveLanes::ZERO;
    for more in curves.coefficients.iter().rev() {
        for lane in 0..LANES {
            let place = curvature.0[lane] * curves.scale + curves.shift;
            let sum = curve.get(lane);
            let next = RollingCurve {
                rigid: sum.rigid * place + more.rigid,
                elastic: sum.elastic * place + more.elastic,
                load: sum.load * place + more.load,
                heat: more.heat,
            };
            curve.put(lane, next);
        }
    }
    curve
}

/// Replaces the constants of contacts with the edges of slots by theirs.
#[inline(always)]
fn set_at_edges(edges: &[Option<CurvePolynomial>], b: &SpaceBlock, curve: &mut RollingCurveLanes) {
    for lane in 0..LANES {
        let slot = (b.outer.slot.0[lane] as usize).checked_sub(1);
        if let Some(edge) = slot.and_then(|slot| edges[slot].as_ref()) {
            curve.put(lane, edge.at(b.outer.merged.0[lane]));
        }
    }
}

/// Adds what holds the balance of momentum and moment of momentum of these forces on balls to those on the inner ring.
#[inline(always)]
fn react(balls: &BallLanes, b: &SpaceBlock, force: &[Lanes; SIZE], totals: &mut Totals) {
    let mut on_ring = [Lanes::ZERO; SIZE];
    for lane in 0..LANES {
        let [x, y, z, mx, my, mz] = of_lane(force, lane);
        let turning = cross(from_ring(b, lane), [x, y, z]);
        let bears = b.frames[INNER].force_n.0[lane] > 0.0;
        let moment = plus(turning, balls.radius.0[lane], [mx, my, mz]);
        for i in 0..3 {
            on_ring[i].0[lane] = -force[i].0[lane];
            on_ring[3 + i].0[lane] = if bears { -moment[i] } else { 0.0 };
        }
    }
    for (total, lanes) in totals.ring.iter_mut().zip(&on_ring) {
        *total += lanes.sum();
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use crate::case::{Case, Motion, Tilt};
    use crate::common::slotted;
    use crate::dynamics::coordinates::{BallCoordinate, RingCoordinate};
    use crate::dynamics::energy::EnergyTerm;
    use crate::dynamics::layout::Layout;
    use crate::dynamics::model::Model;
    use crate::dynamics::right_hand_side::RightHandSide;
    use crate::film::{Film, GrooveCurves, Oil};
    use crate::initial_conditions::initial_state;
    use crate::integrator::System;
    use crate::reference::{self, Structure};

    fn film() -> Film {
        Film {
            hysteresis: true,
            ..Film::flooded(Oil::mineral(20e-3, 0.035))
        }
    }

    /// Change of the rates of a state in space, and of the force on the outer ring, by the film.
    fn change(case: &Case, values: &[f64]) -> (Vec<f64>, [f64; 2]) {
        let dry = Model::of_case(case).unwrap();
        let mut wet = dry.clone();
        wet.space.as_mut().unwrap().film =
            Some(GrooveCurves::new(&case.bearing, &film(), &case.raceways));
        let [(a, outer_a), (b, outer_b)] = [dry, wet].map(|model| {
            let mut equations = RightHandSide::new(&Arc::new(model));
            let mut rates = vec![0.0; values.len()];
            equations.derivative(0.0, values, &mut rates);
            (rates, equations.contacts().outer_ring_force_n())
        });
        let rates = a.iter().zip(&b).map(|(a, b)| b - a).collect();
        (rates, [outer_b[0] - outer_a[0], outer_b[1] - outer_a[1]])
    }

    /// Power of the balls by what the film adds, W, and the sum of the forces on them along X and Y, N.
    fn of_balls(case: &Case, layout: Layout, values: &[f64], rates: &[f64]) -> (f64, [f64; 2]) {
        use BallCoordinate::{OmegaX, OmegaY, Spin, Vx, Vy, Vz};
        let ball = case.bearing.ball(0);
        let (mut power_w, mut force_n) = (0.0, [0.0; 2]);
        for k in 0..case.balls() {
            for coordinate in [Vx, Vy, Vz, OmegaX, OmegaY, Spin] {
                let at = layout.ball(coordinate, k);
                let mass = match coordinate {
                    Vx | Vy | Vz => ball.mass_kg,
                    _ => ball.inertia_kg_m2,
                };
                power_w += mass * rates[at] * values[at];
            }
            force_n[0] += ball.mass_kg * rates[layout.ball(Vx, k)];
            force_n[1] += ball.mass_kg * rates[layout.ball(Vy, k)];
        }
        (power_w, force_n)
    }

    /// Balls under a contact angle, on flanks or the edges of a slot, a ring that moves and tilts: what the film takes
    /// from balls and ring is its loss less what it takes from the drive, and its forces sum to zero.
    #[test]
    fn power_and_momentum_close() {
        for case in [Structure::D.case(), slotted()] {
            power_and_momentum_of(case);
        }
    }

    fn power_and_momentum_of(mut case: Case) {
        let inertia = [2e-4, 3e-4];
        case.operation.space.axial_load_n = 500.0;
        case.operation.space.tilt = Tilt::Free {
            moment_x_n_m: 0.0,
            moment_y_n_m: 0.0,
        };
        case.operation.space.inertias_kg_m2 = Some(inertia);
        let (state, _) = initial_state(&case).unwrap();
        let (layout, mut values) = (state.layout(), state.values().to_vec());
        for (coordinate, value) in [
            (RingCoordinate::Vx, 0.3),
            (RingCoordinate::Vy, -0.2),
            (RingCoordinate::Vz, 0.1),
            (RingCoordinate::TiltP, 2e-3),
            (RingCoordinate::TiltQ, -1e-3),
            (RingCoordinate::TiltPRate, 20.0),
            (RingCoordinate::TiltQRate, 30.0),
        ] {
            values[layout.ring(coordinate)] = value;
        }
        let (rates, outer_n) = change(&case, &values);
        let (mut power_w, mut force_n) = of_balls(&case, layout, &values, &rates);
        let at = |of: &[f64], coordinate| of[layout.ring(coordinate)];
        let ring_kg = case.bearing.dimensions().inner_ring_mass_kg;
        for coordinate in [RingCoordinate::Vx, RingCoordinate::Vy, RingCoordinate::Vz] {
            power_w += ring_kg * at(&rates, coordinate) * at(&values, coordinate);
        }
        let tilt = [RingCoordinate::TiltP, RingCoordinate::TiltQ].map(|c| at(&values, c));
        let turn = [RingCoordinate::TiltPRate, RingCoordinate::TiltQRate];
        let [speeds, turned] = [&values, &rates].map(|of| turn.map(|c| at(of, c)));
        let height = (1.0 - tilt[0] * tilt[0] - tilt[1] * tilt[1]).sqrt();
        let third = |of: [f64; 2]| -(tilt[0] * of[0] + tilt[1] * of[1]) / height;
        let turning = speeds[0] * turned[0] + speeds[1] * turned[1] + third(speeds) * third(turned);
        power_w += inertia[0] * turning;
        force_n[0] += ring_kg * at(&rates, RingCoordinate::Vx) + outer_n[0];
        force_n[1] += ring_kg * at(&rates, RingCoordinate::Vy) + outer_n[1];
        let term = |term| rates[layout.energy_term(term)];
        let loss_w = term(EnergyTerm::RollingResistance);
        let closing_w = power_w - (term(EnergyTerm::Drive) - loss_w);
        assert!(loss_w > 50.0, "{loss_w}");
        assert!((inertia[0] * turning).abs() > 1e-3, "{turning}");
        assert!(closing_w.abs() < 1e-9 * loss_w, "{closing_w} of {loss_w}");
        assert!(force_n.iter().all(|f| f.abs() < 1e-8), "{force_n:?}");
    }

    /// A bearing without axial load has in space the heat of the film that it has in the plane.
    #[test]
    fn even_balls_roll_as_in_the_plane() {
        let plane = Case {
            film: Some(film()),
            ..reference::conventional()
        };
        let (state, _) = initial_state(&plane).unwrap();
        let mut rates = vec![0.0; state.values().len()];
        let model = Model::new(&plane).unwrap();
        RightHandSide::new(&model).derivative(0.0, state.values(), &mut rates);
        let expected_w = rates[state.layout().energy_term(EnergyTerm::RollingResistance)];
        let case = Case {
            motion: Motion::Space,
            ..reference::conventional()
        };
        let (state, _) = initial_state(&case).unwrap();
        let (rates, _) = change(&case, state.values());
        let loss_w = rates[state.layout().energy_term(EnergyTerm::RollingResistance)];
        assert!(
            (loss_w / expected_w - 1.0).abs() < 1e-4,
            "{loss_w} {expected_w}"
        );
    }
}
