//! Newton's method for the forces on the ring, the place of each ball from a bracketed root.

use super::outer_force::OuterForce;
use super::potential::{Ball, Problem};
use crate::numerics::root;

/// Solution of one ball for a given ring.
pub(super) struct BallSolution {
    pub distance: f64,
    pub inner: f64,
    pub outer: f64,
    /// Direction from the ring's centre to the ball.
    pub ei: [f64; 2],
    /// d(inner)/d(approach of the ring).
    pub stiffness: f64,
}

impl Problem<'_> {
    /// Place and forces of a ball for a given ring.
    pub fn ball(&self, ball: &Ball, ring: [f64; 2]) -> BallSolution {
        let outer_orbit_radius = ball.outer_orbit_radius;
        let inner_contact_distance =
            self.bearing.dimensions().inner_groove_bottom_radius_m + ball.radius;
        let outer_force = |distance: f64| {
            let beyond = distance - outer_orbit_radius;
            OuterForce::new(ball.outer_stiffness_n_m1_5, ball.flanks.as_ref(), beyond)
        };
        let forces = |distance: f64| {
            let offset = [
                distance * ball.e[0] - ring[0],
                distance * ball.e[1] - ring[1],
            ];
            let length = offset[0].hypot(offset[1]);
            let ei = offset.map(|c| c / length);
            let inner =
                ball.inner_stiffness_n_m1_5 * (inner_contact_distance - length).max(0.0).powf(1.5);
            let outer = outer_force(distance).force_n;
            let cosine = ei[0] * ball.e[0] + ei[1] * ball.e[1];
            let net = inner * cosine + ball.steady + ball.turning / distance - outer;
            (net, inner, outer, ei, inner_contact_distance - length)
        };
        // Outward push falls with the distance; all the room there is brackets it.
        let width = self.bearing.ball_radius_m() + 0.5 * self.bearing.radial_internal_clearance_m();
        let distance = root::brent(
            |d| forces(d).0,
            outer_orbit_radius - width,
            outer_orbit_radius + width,
            0.0,
        )
        .unwrap_or(outer_orbit_radius);
        let (_, inner, outer, ei, approach) = forces(distance);
        let slope = |k: f64, deflection: f64| 1.5 * k * deflection.max(0.0).sqrt();
        let ki = slope(ball.inner_stiffness_n_m1_5, approach);
        let ko = outer_force(distance).slope_n_m;
        let stiffness = if ki > 0.0 { ki * ko / (ki + ko) } else { 0.0 };
        BallSolution {
            distance,
            inner,
            outer,
            ei,
            stiffness,
        }
    }

    /// Force left on the ring and its stiffness against displacement.
    fn ring(&self, ring: [f64; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
        let mut force = [0.0, -self.down];
        let mut stiffness = [[0.0; 2]; 2];
        for ball in &self.balls {
            let s = self.ball(ball, ring);
            for a in 0..2 {
                force[a] -= s.inner * s.ei[a];
                for b in 0..2 {
                    stiffness[a][b] += s.stiffness * s.ei[a] * s.ei[b];
                }
            }
        }
        (force, stiffness)
    }

    /// Whether nothing pulls a ring in the middle.
    pub fn at_rest_in_the_middle(&self) -> bool {
        norm(self.ring([0.0; 2]).0) <= 1e-12 * self.scale()
    }

    /// Depth of the ring below the middle at which the balls there carry it.
    pub fn contact_depth_m(&self) -> f64 {
        let first = &self.balls[0];
        let series = (first.inner_stiffness_n_m1_5.powf(-2.0 / 3.0)
            + first.outer_stiffness_n_m1_5.powf(-2.0 / 3.0))
            * (4.37 * self.down / self.balls.len() as f64).powf(2.0 / 3.0);
        // Balls thrown against the outer raceway leave the ring that much more room.
        let thrown = self
            .balls
            .iter()
            .map(|b| {
                let push = b.steady + b.turning / self.bearing.outer_orbit_radius_m();
                (push.max(0.0) / b.outer_stiffness_n_m1_5).powf(2.0 / 3.0)
            })
            .fold(0.0, f64::max);
        0.5 * self.bearing.radial_internal_clearance_m().max(0.0) + thrown + series
    }

    /// Equilibrium reached from `depth` below the middle, where the Hertz law is convex, by
    /// Newton's method with step halving.
    pub fn newton_from_below(&self, depth: f64) -> Option<[f64; 2]> {
        let scale = self.scale();
        let mut ring = [0.0, -depth];
        let (mut force, mut stiffness) = self.ring(ring);
        for _ in 0..ITERATIONS {
            if norm(force) <= 1e-12 * scale {
                return Some(ring);
            }
            // Where few balls carry, the ring is free sideways; a little stiffness keeps
            // the step finite.
            let soft = 1e-9 * (stiffness[0][0] + stiffness[1][1]).max(1.0);
            let (a, b, d) = (
                stiffness[0][0] + soft,
                stiffness[0][1],
                stiffness[1][1] + soft,
            );
            let determinant = a * d - b * b;
            let mut step = [
                (d * force[0] - b * force[1]) / determinant,
                (a * force[1] - b * force[0]) / determinant,
            ];
            let most = 0.05 * self.bearing.ball_radius_m();
            let length = norm(step);
            if length > most {
                step = step.map(|s| s * most / length);
            }
            let better = (0..HALVINGS).find_map(|_| {
                let trial = [ring[0] + step[0], ring[1] + step[1]];
                let (f, k) = self.ring(trial);
                step = step.map(|s| s / 2.0);
                (norm(f) < norm(force)).then_some((trial, f, k))
            });
            let Some(next) = better else { break };
            (ring, force, stiffness) = next;
        }
        // Rounding of 1e-18 m in a deflection is this much force.
        (norm(force) <= 1e-7 * scale).then_some(ring)
    }

    fn scale(&self) -> f64 {
        self.down.max(1e-6) + self.preload
    }
}

const ITERATIONS: usize = 30;
/// A step that is halved more often leads nowhere.
const HALVINGS: usize = 10;

fn norm(force: [f64; 2]) -> f64 {
    force[0].hypot(force[1])
}
