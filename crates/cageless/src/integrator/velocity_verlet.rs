//! Velocity Verlet, the leapfrog method in its synchronous form, with one evaluation per step.
//!
//! v(½) = v(n) + h/2·a(n);  x(n+1) = x(n) + h·v(½);  v(n+1) = v(½) + h/2·a(n+1), with
//! a(n+1) = a(x(n+1), v(½) + h/2·a(n)): forces that depend on velocities see them
//! extrapolated to the end of the step. (With v(½) itself, as in symplectic Euler, a ball on
//! its circle would seem to fly outwards by h/2·v²/R, and damping would resist that.)
//!
//! A stiff part g of f that acts on velocities ([`System::has_stiff_part`]) enters implicitly
//! instead, once over the whole step: v(n+1) = v(n) + h/2·(a(n) + a(n+1)) + h·g(v(n+1)) with a
//! the rest of f, while x(n+1) = x(n) + h·v(n) + h²/2·(a(n) + g(n)). The part is damped at any
//! stiffness (backward Euler is L-stable) and of order 1; a constant g is integrated exactly.
//!
//! Order 2 otherwise. Where forces depend on places alone it is symplectic and keeps a nearby energy
//! for ever (Hairer, Lubich & Wanner, *Geometric Numerical Integration*, section I.1).
//! Stable on x″ = −ω²x up to ωh = 2, on x″ = −λx′ up to λh = 1.

use super::{FixedSteps, Method, Properties, StepState, System, UnresolvedStep};

/// The method.
#[derive(Debug, Clone)]
pub struct VelocityVerlet {
    steps: FixedSteps,
    /// f without its stiff part at the start and end of the step, for systems that have one.
    nonstiff: [Vec<f64>; 2],
}

/// Components that are positions and the components that are their rates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SecondOrderBlock {
    /// First position.
    pub positions: usize,
    /// First rate.
    pub rates: usize,
    /// Number of positions.
    pub count: usize,
}

impl VelocityVerlet {
    /// Order and stability. Velocities are extrapolated: half of what leapfrog allows on the
    /// real axis.
    pub const PROPERTIES: Properties = Properties {
        order: 2,
        oscillation_limit: 2.0,
        decay_limit: 1.0,
        evaluations: 1,
    };

    /// The method with step `h`.
    pub fn new(h: f64) -> Self {
        Self {
            steps: FixedSteps::new(h),
            nonstiff: [vec![], vec![]],
        }
    }
}

impl Method for VelocityVerlet {
    fn restart<S: System>(&mut self, system: &mut S, step: &StepState) {
        self.steps.restart(step.t1_s);
        if system.has_stiff_part() {
            self.nonstiff = [vec![0.0; step.y1.len()], vec![0.0; step.y1.len()]];
            system.nonstiff_derivative(step.t1_s, &step.y1, &mut self.nonstiff[1]);
        }
    }

    #[inline(always)] // into callers compiled for wider vectors
    fn perform_step<S: System>(
        &mut self,
        system: &mut S,
        step: &mut StepState,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        (step.t1_s, _) = self.steps.next_end(limit_s);
        let h = step.t1_s - step.t0_s;
        let n = step.y1.len();
        let (y0, f0) = (&step.y0[..n], &step.f0[..n]);
        let y1 = &mut step.y1[..n];
        for k in 0..n {
            y1[k] = y0[k] + h * f0[k];
        }
        for block in system.second_order_blocks() {
            let count = block.count;
            let (v0, a0) = (&y0[block.rates..][..count], &f0[block.rates..][..count]);
            let x0 = &y0[block.positions..][..count];
            let x1 = &mut y1[block.positions..][..count];
            for k in 0..count {
                x1[k] = x0[k] + h * (v0[k] + 0.5 * h * a0[k]);
            }
        }
        if system.has_stiff_part() {
            let [e0, e1] = &mut self.nonstiff;
            std::mem::swap(e0, e1);
            system.nonstiff_derivative(step.t1_s, y1, e1);
            trapezoid(system, h, y0, &e0[..n], &e1[..n], y1);
            step.f1.copy_from_slice(e1);
            system.add_stiff_part(h, y0, y1, &mut step.f1);
        } else {
            system.derivative(step.t1_s, y1, &mut step.f1);
            trapezoid(system, h, y0, f0, &step.f1[..n], y1);
        }
        Ok(())
    }
}

/// y1 = y0 + h/2·(f0 + f1) for all but the positions, which stay.
#[inline(always)]
fn trapezoid<S: System>(system: &S, h: f64, y0: &[f64], f0: &[f64], f1: &[f64], y1: &mut [f64]) {
    let mut advance = |from: usize, to: usize| {
        for k in from..to {
            y1[k] = y0[k] + 0.5 * h * (f0[k] + f1[k]);
        }
    };
    let mut from = 0;
    for block in system.second_order_blocks() {
        advance(from, block.positions);
        from = block.positions + block.count;
    }
    advance(from, y0.len());
}
