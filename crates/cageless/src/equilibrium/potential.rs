//! The potential energy of ring and balls, with every ball where it is least.
//!
//! With friction left out all forces are conservative. For a ball at ψ, a distance ρ = T + u
//! from the axis (T where it just touches the outer raceway), and the ring at **R**, with
//! L = |ρ**e** − **R**| and the approach δ = Ri + R − L,
//!
//!   U = ⅖ Ki δ₊^(5/2) + ⅖ Ko u₊^(5/2) − S u − C ln(1 + u/T),
//!
//! S the steady push outwards and C/ρ the centrifugal one. U is convex in u; its minimum
//! over u, φ(**R**), leaves the two unknowns of the ring in
//!
//!   V(**R**) = (load + weight) Y + Σ φ.

use super::minimum::Local;
use super::outer_force::OuterForce;
use crate::bearing::Bearing;
use crate::contact::FlankSection;

/// One ball at its angle, with the outward force on it that does not come from a contact, S + C/ρ.
#[derive(Debug, Clone)]
pub(super) struct Ball {
    pub angle: f64,
    pub radius: f64,
    /// Unit vector **e** from the axis to the ball.
    pub e: [f64; 2],
    /// T, distance from the axis at which the ball just touches the outer raceway.
    pub outer_orbit_radius: f64,
    /// Ri + R − T, approach to the centred ring there.
    pub slack: f64,
    pub inner_stiffness_n_m1_5: f64,
    pub outer_stiffness_n_m1_5: f64,
    /// Elastic flanks under the ball; their δe stands for u in the energy.
    pub flanks: Option<FlankSection>,
    /// S, N.
    pub steady: f64,
    /// C, N·m, which is centrifugal.
    pub turning: f64,
}

/// One ball where its energy is least, for a given ring.
struct Rest {
    /// u.
    beyond: f64,
    /// Force at the inner raceway.
    inner: f64,
    /// Slope of the force at the inner raceway.
    inner_slope: f64,
    outer: OuterForce,
    approach: f64,
    /// L.
    length: f64,
    /// cos and sin of the angle between **ei** and **e**.
    cosine: f64,
    sine: f64,
}

/// Ring and balls, each ball at its angle.
#[derive(Debug, Clone)]
pub(super) struct Problem<'c> {
    pub bearing: &'c Bearing,
    pub balls: Vec<Ball>,
    /// Load and weight on the ring, −Y.
    pub down: f64,
    /// Sum of the forces with which interference presses the balls without load, N.
    pub preload: f64,
}

impl Ball {
    /// u at which the ball touches no more than it must for its push, to start from.
    fn guess(&self, ring: [f64; 2]) -> f64 {
        let fraction = |k: f64| k.cbrt().powi(2);
        let (inner, outer) = (
            fraction(self.inner_stiffness_n_m1_5),
            fraction(self.outer_stiffness_n_m1_5),
        );
        let approach = self.at(ring, 0.0).approach;
        let push = self.steady + self.turning / self.outer_orbit_radius;
        if push >= 0.0 {
            let thrown = fraction(push) / outer;
            thrown + (approach - thrown).max(0.0) * inner / (inner + outer)
        } else {
            let sunk = approach - fraction(-push) / inner;
            sunk.min(0.0) + sunk.max(0.0) * inner / (inner + outer)
        }
    }

    /// The forces at u.
    fn at(&self, ring: [f64; 2], beyond: f64) -> Rest {
        let along = self.e[0] * ring[0] + self.e[1] * ring[1];
        // Component of R across e; L² = (ρ − along)² + across².
        let across = self.e[0] * ring[1] - self.e[1] * ring[0];
        let distance = self.outer_orbit_radius + beyond;
        let length = (distance - along).hypot(across);
        // L − (ρ − along), without the cancellation of a difference of lengths.
        let longer = across * across / (length + (distance - along));
        let approach = self.slack - beyond + along - longer;
        let inner_root = approach.max(0.0).sqrt();
        Rest {
            beyond,
            inner: self.inner_stiffness_n_m1_5 * inner_root.powi(3),
            inner_slope: 1.5 * self.inner_stiffness_n_m1_5 * inner_root,
            outer: OuterForce::new(self.outer_stiffness_n_m1_5, self.flanks.as_ref(), beyond),
            approach,
            length,
            cosine: (distance - along) / length,
            sine: across / length,
        }
    }

    /// ∂U/∂u and ∂²U/∂u².
    fn slopes(&self, rest: &Rest) -> [f64; 2] {
        let distance = self.outer_orbit_radius + rest.beyond;
        // Of one contact this has the last bits of all earlier results.
        let outer = match self.flanks {
            None => rest.outer.slope_n_m * rest.beyond.max(0.0) / 1.5,
            Some(_) => rest.outer.force_n,
        };
        let turning = self.turning / distance;
        [
            outer - rest.inner * rest.cosine - self.steady - turning,
            rest.outer.slope_n_m + rest.inner_slope * rest.cosine.powi(2)
                - rest.inner * rest.sine.powi(2) / rest.length
                + turning / distance,
        ]
    }

    /// Newton's method for ∂U/∂u = 0, bisection where it leaves the bracket or halves
    /// nothing.
    fn rest(&self, ring: [f64; 2], deepest: f64) -> Rest {
        let away = ring[0].hypot(ring[1]);
        let (mut low, mut high) = (-0.9 * (self.outer_orbit_radius - away), deepest);
        let mut rest = self.at(ring, self.guess(ring).clamp(low, high));
        let mut last = high - low;
        for _ in 0..200 {
            let [slope, curvature] = self.slopes(&rest);
            if slope > 0.0 {
                high = rest.beyond;
            } else {
                low = rest.beyond;
            }
            let step = -slope / curvature;
            if step.abs() <= f64::EPSILON * (rest.beyond.abs() + rest.approach.abs()) {
                break;
            }
            let newton = rest.beyond + step;
            let next = if newton > low && newton < high && step.abs() <= 0.5 * last {
                newton
            } else {
                0.5 * (low + high)
            };
            last = (next - rest.beyond).abs();
            rest = self.at(ring, next);
        }
        rest
    }
}

impl Problem<'_> {
    /// V and its derivatives at a place of the ring.
    pub fn at(&self, ring: [f64; 2]) -> Local<2> {
        let load = self.down * ring[1];
        let mut local = Local {
            energy: load,
            magnitude: load.abs(),
            gradient: [0.0, self.down],
            ..Local::nothing(ring)
        };
        let deepest = self.bearing.ball_radius_m();
        for ball in &self.balls {
            let rest = ball.rest(ring, deepest);
            let elastic =
                |k: f64, depth: f64| 0.4 * k * depth.max(0.0).powi(2) * depth.max(0.0).sqrt();
            for term in [
                elastic(ball.inner_stiffness_n_m1_5, rest.approach),
                elastic(ball.outer_stiffness_n_m1_5, rest.outer.deflection_m),
                -ball.steady * rest.beyond,
                -ball.turning * (rest.beyond / ball.outer_orbit_radius).ln_1p(),
            ] {
                local.energy += term;
                local.magnitude += term.abs();
            }
            if rest.inner == 0.0 {
                continue;
            }
            // Along ei and across it: V_RR = k eieiᵀ − F/L (1 − eieiᵀ), less bbᵀ/U_uu with
            // b = V_Ru = −k cos ei + F/L (e − cos ei).
            let [_, curvature] = ball.slopes(&rest);
            let (c, s) = (rest.cosine, rest.sine);
            let ei = [c * ball.e[0] + s * ball.e[1], c * ball.e[1] - s * ball.e[0]];
            let normal = [-ei[1], ei[0]];
            let bend = rest.inner / rest.length;
            let mixed = [-rest.inner_slope * c, bend * s];
            // k − (k cos)²/U_uu, in series with what else holds the ball.
            let others = curvature - rest.inner_slope * c * c;
            let aa = rest.inner_slope * others / curvature;
            let an = -mixed[0] * mixed[1] / curvature;
            let nn = -bend - mixed[1] * mixed[1] / curvature;
            for k in 0..2 {
                local.gradient[k] += rest.inner * ei[k];
            }
            for (i, j) in [(0, 0), (0, 1), (1, 1)] {
                local.hessian[i][j] += aa * ei[i] * ei[j]
                    + an * (ei[i] * normal[j] + normal[i] * ei[j])
                    + nn * normal[i] * normal[j];
            }
        }
        local.hessian[1][0] = local.hessian[0][1];
        local
    }

    /// Sum of the absolute forces that act from outside: load and weights, centrifugal, and those
    /// of an interference.
    pub fn forces(&self) -> f64 {
        self.balls
            .iter()
            .fold(self.down + self.preload, |sum, ball| {
                sum + (ball.steady + ball.turning / ball.outer_orbit_radius).abs()
            })
    }
}
