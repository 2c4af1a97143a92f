//! Where the right-hand side is not smooth: the edges of contacts.

use super::parameters::Parameters;
use super::workspace::{BlockResults, Workspace};
use crate::ball::{Ball, BallMotion, Centre};
use crate::contact::{Law, LawLanes, ball_deflection, with_law};
use crate::dynamics::coordinates::BallCoordinate;
use crate::numerics::lanes::LANES;

/// 1 over the depth of a contact that is of interest, 1/m.
pub(crate) const PER_DEPTH: f64 = 1e5;
/// Fourth root of `PER_DEPTH`, m^(−1/4).
const ROOT: f64 = 17.782_794_100_389_23;
/// 1 over the change of sin²ψ along a raceway over such a depth.
pub(crate) const PER_SINE_SQUARE: f64 = 1e4;

/// Appends functions of the state of the last evaluation of one bearing alone, zero where f is not
/// smooth: depths of contacts, what damped contacts are clamped by, the rows of friction tables, the
/// ends of raceways and the stop of the support.
pub(crate) fn edges(p: &Parameters, w: &Workspace, y: &[f64], values: &mut Vec<f64>) {
    let layout = p.layout;
    let ring = layout.ring_motion(y);
    for k in 0..layout.balls {
        let (block, lane) = (k / LANES, k % LANES);
        let (results, ball) = (&w.blocks[block], p.balls(block).get(lane));
        let polar = results.polar.get(lane);
        let at = |coordinate, k| y[layout.ball(coordinate, k)];
        let ahead = |coordinate| at(coordinate, (k + 1) % layout.balls) - at(coordinate, k);
        let [inner, outer, pair] = [
            results.inner.deflection.0[lane],
            results.outer.deflection.0[lane],
            ball_deflection(&ball, ahead(BallCoordinate::X), ahead(BallCoordinate::Y)),
        ];
        values.extend([inner, outer, pair].map(|depth| depth * PER_DEPTH));
        if ball.raceway_damping > 0.0 {
            let motion = layout.ball_motion(y, k);
            values.extend(raceway_edges(&ball, results, lane, &motion, &ring));
        }
        if ball.pair_damping > 0.0 {
            // Kδ^(5/4) + α √(m K) dδ/dt.
            values.push(while_closed(pair, || {
                let elastic = pair * pair.sqrt().sqrt();
                let damping = ball.pair_damping / ball.pair_stiffness * results.pair.rate.0[lane];
                (elastic + damping) * (ROOT * PER_DEPTH)
            }));
        }
        for (force, slip) in [
            (&results.inner.force, &results.inner.slip),
            (&results.outer.force, &results.outer.slip),
            (&results.pair.force, &results.pair.slip),
        ] {
            let edge = with_law!(&p.friction, law => law.lane(lane).edge(slip.0[lane]));
            values.extend(edge.map(|edge| while_closed(force.0[lane], || edge)));
        }
        for raceway in &p.raceways {
            let raceway = raceway.constants.get(lane);
            if raceway.end > 0.0 {
                let sine = polar.ex * raceway.cos_centre + polar.ey * raceway.sin_centre;
                let cosine = polar.ex * raceway.sin_centre - polar.ey * raceway.cos_centre;
                let square = if cosine > 0.0 { sine * sine } else { 1.0 };
                values.push((raceway.end - square) * PER_SINE_SQUARE);
            }
        }
    }
    rotor_edges(p, w, y, values);
}

/// Edges of the clamps of a ball's damped contacts with the inner and the outer raceway, Kδ + c dδ/dt.
fn raceway_edges(
    ball: &Ball,
    results: &BlockResults,
    lane: usize,
    motion: &BallMotion,
    ring: &Centre,
) -> [f64; 2] {
    let (inner, outer) = (
        results.inner.deflection.0[lane],
        results.outer.deflection.0[lane],
    );
    let unclamped = |stiffness: f64, depth: f64, rate: f64| {
        (depth + ball.raceway_damping / stiffness * rate) * PER_DEPTH
    };
    let of_inner = while_closed(inner, || {
        let direction = &results.inner_polar;
        let (vx, vy) = (motion.vx - ring.vx, motion.vy - ring.vy);
        let rate = -(vx * direction.ex.0[lane] + vy * direction.ey.0[lane]);
        unclamped(ball.inner_stiffness_n_m1_5, inner, rate)
    });
    let of_outer = while_closed(outer, || {
        let polar = results.polar.get(lane);
        let slope = results.geometry.slope.0[lane];
        let rate = polar.radial - slope * polar.orbit;
        let flanks = results.flanks.get(lane);
        if results.on_flanks.has(lane) {
            let rate = flanks.lever * rate;
            return unclamped(ball.outer_stiffness_n_m1_5, flanks.deflection, rate);
        }
        unclamped(ball.outer_stiffness_n_m1_5, outer, rate)
    });
    [of_inner, of_outer]
}

/// Edges of the contact of a rotor and of the stop of its support.
pub(crate) fn rotor_edges(p: &Parameters, w: &Workspace, y: &[f64], values: &mut Vec<f64>) {
    if let Some(under) = p.drops.first() {
        let (joint, support) = (&under.joint, &under.outer_ring.support);
        let contact = &w.rotors[0].contact;
        values.push(contact.deflection * PER_DEPTH);
        if joint.journal.damping > 0.0 {
            let damping = 1.5 * joint.journal.damping;
            values.push(while_closed(contact.deflection, || {
                1.0 + damping * contact.rate
            }));
        }
        let edge = joint.friction.edge(contact.slip);
        values.extend(edge.map(|edge| while_closed(contact.force, || edge)));
        if support.stop_stiffness > 0.0 {
            let motion = p.layout.outer_ring_motion(y);
            let distance = motion.x.hypot(motion.y);
            values.push((distance - support.stop_gap) * PER_DEPTH);
        }
    }
}

/// An edge that only a closed contact has, by its depth or force; on neither side while it is open.
#[inline(always)]
fn while_closed(closed: f64, edge: impl Fn() -> f64) -> f64 {
    if closed > 0.0 { edge() } else { 0.0 }
}
