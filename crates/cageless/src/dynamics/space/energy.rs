//! Energy stored in space.

use super::evaluation::ball_motion;
use super::model::SpaceModel;
use super::ring::RingMotion;
use super::sliding::{outer_z_m, sliding_energy_j};
use crate::contact::hertz;
use crate::dynamics::model::Model;
use crate::dynamics::state::State;
use crate::numerics::vector::PlaneVector;

/// Kinetic and elastic energy, J; a ring whose speed is given has none of its rotation.
pub(crate) fn energy_j(model: &Model, space: &SpaceModel, state: &State) -> f64 {
    let (layout, y) = (state.layout(), state.values());
    let ring = RingMotion::new(layout, y, 0.0);
    let mut sum = 0.5 * model.ring.mass * ring.velocity.norm_squared();
    if let Some(free) = &space.free_tilt {
        sum += 0.5 * free.transverse * ring.axis_rate.norm_squared();
    }
    let outer_ring = layout.outer_ring_motion(y);
    sum += model.energy_under_rotor_j(state);
    sum += sliding_energy_j(space, layout, y);
    for (k, (ball, grooves)) in model.balls.iter().zip(&space.balls).enumerate() {
        let [place, velocity, rotation] = ball_motion(layout, y, k);
        let off = PlaneVector {
            x: place.x - outer_ring.x,
            y: place.y - outer_ring.y,
        };
        let height = place.z - outer_z_m(space, layout, y, k);
        let distance = off.x.hypot(off.y);
        let direction = PlaneVector {
            x: off.x / distance,
            y: off.y / distance,
        };
        let beyond = distance - ball.outer_orbit_radius;
        let outer = match space.flanks_at(k, direction) {
            Some(here) => grooves.outer.touch_flanks(beyond, height, &here),
            None => grooves.outer.touch(beyond, height),
        };
        let from_ring = (place - ring.centre).into();
        let inner = grooves.inner.touch(from_ring, ring.axis.into());
        sum += 0.5 * ball.mass * velocity.norm_squared()
            + 0.5 * model.inertia[k] * rotation.norm_squared()
            + hertz::energy_j(
                ball.outer_stiffness_n_m1_5 * outer.stiffness,
                outer.approach,
            )
            + hertz::energy_j(ball.inner_stiffness_n_m1_5, inner.approach);
        if model.balls.len() > 1 {
            let [next, ..] = ball_motion(layout, y, layout.next(k));
            let pair = ball.pair_distance - (next - place).norm();
            sum += hertz::energy_j(ball.pair_stiffness, pair);
        }
    }
    sum
}
