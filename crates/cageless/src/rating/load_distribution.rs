//! Load distribution of ISO/TS 16281: rigid rings under the radial load alone.

use crate::case::{Case, series_stiffness_n_m1_5};
use crate::equilibrium::start_angles_rad;

/// Force left on the ring over the load.
const FORCE_TOLERANCE: f64 = 1e-12;
const ITERATIONS: usize = 200;
const HALVINGS: usize = 50;

/// A ball between the rings as one spring: its direction, the deflection it has with the ring in
/// the middle, its K.
struct Spring {
    e: [f64; 2],
    middle_m: f64,
    stiffness_n_m1_5: f64,
}

/// Force of every ball, N, at both raceways alike. With the ring displaced by **X** ball j takes
///
///   Qj = cp δj^(3/2), δj = **X**·**e**j − Gr/2 + 2(R − Rw), cp = (Ki^(−2/3) + Ko^(−2/3))^(−3/2),
///
/// and Σ Qj **e**j balances the radial load, without weight and centrifugal force. The balls
/// stand where the case starts them, the outer raceway is plain. Displacements are small against
/// the bearing, unlike in [`crate::equilibrium`]. `None` without load, or if the balls leave
/// a gap through which the ring falls.
pub fn rigid_ring_forces_n(case: &Case) -> Option<Vec<f64>> {
    let bearing = &case.bearing;
    let load_n = case.operation.radial_load_n;
    let springs: Vec<Spring> = start_angles_rad(case)
        .into_iter()
        .enumerate()
        .map(|(k, angle)| {
            let (sin, cos) = angle.sin_cos();
            let [inner, outer, _] = case.ball_stiffness_n_m1_5(k);
            let larger = bearing.ball(k).radius_m - bearing.ball_radius_m();
            Spring {
                e: [sin, -cos],
                middle_m: 2.0 * larger - 0.5 * bearing.radial_internal_clearance_m(),
                stiffness_n_m1_5: series_stiffness_n_m1_5(inner, outer),
            }
        })
        .collect();
    (load_n > 0.0).then(|| settle(&springs, load_n, bearing.ball_radius_m()))?
}

/// Energy of springs and load, its gradient, and the Hessian (xx, xy, yy).
struct Local {
    energy_j: f64,
    gradient: [f64; 2],
    hessian: [f64; 3],
}

fn deflection_m(spring: &Spring, ring: [f64; 2]) -> f64 {
    let along = ring[0] * spring.e[0] + ring[1] * spring.e[1];
    (along + spring.middle_m).max(0.0)
}

fn force_n(spring: &Spring, ring: [f64; 2]) -> f64 {
    spring.stiffness_n_m1_5 * deflection_m(spring, ring).powf(1.5)
}

fn at(springs: &[Spring], load_n: f64, ring: [f64; 2]) -> Local {
    let mut local = Local {
        energy_j: load_n * ring[1],
        gradient: [0.0, load_n],
        hessian: [0.0; 3],
    };
    for spring in springs {
        let (deflection, force) = (deflection_m(spring, ring), force_n(spring, ring));
        let slope = 1.5 * spring.stiffness_n_m1_5 * deflection.sqrt();
        let [x, y] = spring.e;
        local.energy_j += 0.4 * force * deflection;
        local.gradient[0] += force * x;
        local.gradient[1] += force * y;
        for (entry, part) in local.hessian.iter_mut().zip([x * x, x * y, y * y]) {
            *entry += slope * part;
        }
    }
    local
}

/// Newton's method on the convex energy, with steps of at most a twentieth of the ball's radius.
fn settle(springs: &[Spring], load_n: f64, ball_radius_m: f64) -> Option<Vec<f64>> {
    let longest = 0.05 * ball_radius_m;
    let mut ring = [0.0, -longest];
    let mut here = at(springs, load_n, ring);
    for _ in 0..ITERATIONS {
        let [gx, gy] = here.gradient;
        if gx.hypot(gy) <= FORCE_TOLERANCE * load_n {
            break;
        }
        // Where one ball carries, the ring is free across its direction; a little stiffness
        // keeps the step finite.
        let soft = 1e-9 * (here.hessian[0] + here.hessian[2]) + 1e-3 * load_n / longest;
        let soft = soft.min(gx.hypot(gy) / longest);
        let [xx, xy, yy] = [
            here.hessian[0] + soft,
            here.hessian[1],
            here.hessian[2] + soft,
        ];
        let determinant = xx * yy - xy * xy;
        let mut step = [
            (xy * gy - yy * gx) / determinant,
            (xy * gx - xx * gy) / determinant,
        ];
        let length = step[0].hypot(step[1]);
        if length > longest {
            step = step.map(|s| s * longest / length);
        }
        let better = (0..HALVINGS).find_map(|_| {
            let next = [ring[0] + step[0], ring[1] + step[1]];
            let there = at(springs, load_n, next);
            step = step.map(|s| 0.5 * s);
            let smaller = there.gradient[0].hypot(there.gradient[1]) < gx.hypot(gy);
            (there.energy_j < here.energy_j || smaller).then_some((next, there))
        });
        let Some(next) = better else { break };
        (ring, here) = next;
    }
    let [gx, gy] = here.gradient;
    (gx.hypot(gy) <= 1e-6 * load_n)
        .then(|| springs.iter().map(|spring| force_n(spring, ring)).collect())
}
