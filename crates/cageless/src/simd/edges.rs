//! Where the right-hand side is not smooth: the edges of contacts.

use super::parameters::Parameters;
use super::workspace::Workspace;
use crate::dynamics::coordinates::BallCoordinate;
use crate::dynamics::layout::LANES;

/// Depth of a contact that is of interest, m.
const DEPTH: f64 = 1e-5;
/// Its power −1/4, m^(−1/4).
const INVERSE_ROOT: f64 = 17.782_794_100_389_23;
/// Direction cosine of [`DEPTH`] along a raceway.
const DIRECTION: f64 = 1e-4;

/// Appends functions of the state of the last evaluation of one bearing alone, zero where f is not
/// smooth: depths of contacts, what damped contacts are clamped by, the ends of raceways and the
/// stop of the support.
pub(crate) fn edges(p: &Parameters, w: &Workspace, y: &[f64], values: &mut Vec<f64>) {
    let layout = p.layout;
    let ring = layout.ring_motion(y);
    for k in 0..layout.balls {
        let (block, lane) = (k / LANES, k % LANES);
        let (results, ball) = (&w.blocks[block], p.balls(block).get(lane));
        let polar = results.polar.get(lane);
        let geometry = results.geometry.get(lane);
        let [inner, outer, pair] = [
            results.inner.deflection.0[lane],
            results.outer.deflection.0[lane],
            results.pair.deflection.0[lane],
        ];
        values.extend([inner, outer, pair].map(|depth| depth / DEPTH));
        if ball.raceway_damping > 0.0 {
            let at = |coordinate| y[layout.ball(coordinate, k)];
            let (ex, ey) = (
                results.inner_polar.ex.0[lane],
                results.inner_polar.ey.0[lane],
            );
            let (vx, vy) = (
                at(BallCoordinate::Vx) - ring.vx,
                at(BallCoordinate::Vy) - ring.vy,
            );
            let rates = [
                -(vx * ex + vy * ey),
                polar.radial - geometry.slope * polar.orbit,
            ];
            let stiffness = [ball.inner_stiffness, ball.outer_stiffness];
            for (depth, (rate, k)) in [inner, outer]
                .into_iter()
                .zip(rates.into_iter().zip(stiffness))
            {
                values.push(clamp(depth, depth + ball.raceway_damping / k * rate));
            }
        }
        if ball.pair_damping > 0.0 {
            let share = ball.pair_damping / ball.pair_stiffness * INVERSE_ROOT;
            let depth = pair.max(0.0);
            let elastic = depth * (depth / DEPTH).sqrt().sqrt();
            values.push(clamp(pair, elastic + share * results.pair.rate.0[lane]));
        }
        for raceway in &p.raceways {
            let raceway = raceway.constants.get(lane);
            let cosine = polar.ex * raceway.sin_centre - polar.ey * raceway.cos_centre;
            if raceway.end > 0.0 {
                values.push((cosine - (1.0 - raceway.end).sqrt()) / DIRECTION);
            }
        }
    }
    if let Some((body, support)) = p.drops.first() {
        let contact = &w.rotors[0].contact;
        values.push(contact.deflection / DEPTH);
        if body.journal.damping > 0.0 {
            let share = 1.0 + 1.5 * body.journal.damping * contact.rate;
            values.push(clamp(contact.deflection, share * DEPTH));
        }
        if support.stop_stiffness > 0.0 {
            let motion = layout.outer_ring_motion(y);
            let distance = motion.x.hypot(motion.y);
            values.push((distance - support.stop_gap) / DEPTH);
        }
    }
}

/// Where a damped force reaches zero while the contact is closed, `share` being a depth that has
/// its sign; on neither side while it is open.
fn clamp(depth: f64, share: f64) -> f64 {
    if depth > 0.0 { share / DEPTH } else { 0.0 }
}
