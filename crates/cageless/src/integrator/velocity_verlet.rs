//! Velocity Verlet, the leapfrog method in its synchronous form, with one evaluation per step.
//!
//! v(½) = v(n) + h/2·a(n);  x(n+1) = x(n) + h·v(½);  v(n+1) = v(½) + h/2·a(n+1), with
//! a(n+1) = a(x(n+1), v(½) + h/2·a(n)): forces that depend on velocities see them
//! extrapolated to the end of the step. (With v(½) itself, as in symplectic Euler, a ball on
//! its circle would seem to fly outwards by h/2·v²/R, and damping would resist that.)
//!
//! On a circle that extrapolation is too fast along the path by (ωh)²/2, for the acceleration
//! turns; the change of a along the path over the step before takes that away
//! ([`System::planar_velocities`]), and leaves the damping across it as it is.
//!
//! A stiff part g of f that acts on velocities ([`System::has_stiff_part`]) enters implicitly
//! instead, once over the whole step: v(n+1) = v(n) + h/2·(a(n) + a(n+1)) + h·g with a the rest of
//! f and g as [`System::add_stiff_part`] solves for it, while
//! x(n+1) = x(n) + h·v(n) + h²/2·(a(n) + g(n)). With g = g(v(n+1)), backward Euler, the part is damped
//! at any stiffness and of order 1.
//!
//! Order 2 otherwise. Where forces depend on places alone it is symplectic and keeps a nearby energy
//! for ever (Hairer, Lubich & Wanner, *Geometric Numerical Integration*, section I.1).
//! Stable on x″ = −ω²x up to ωh = 2, on x″ = −λx′ up to λh = 1.

use super::method::{Method, NamedMethod, Properties};
use super::runge_kutta::UnresolvedStep;
use super::step_state::{FixedSteps, StepState};
use super::system::{SecondOrderBlock, System};
use crate::numerics::aligned::Aligned;
use crate::numerics::vector::PlaneVector;

/// The method.
#[derive(Debug, Clone)]
pub struct VelocityVerlet {
    steps: FixedSteps,
    /// f without its stiff part at the start and end of the step, for systems that have one.
    nonstiff: [Aligned; 2],
}

impl VelocityVerlet {
    /// The method with step `h`.
    pub fn new(h: f64) -> Self {
        Self {
            steps: FixedSteps::new(h),
            nonstiff: [Aligned::default(), Aligned::default()],
        }
    }
}

impl NamedMethod for VelocityVerlet {
    // Order and stability. Velocities are extrapolated: half of what leapfrog allows on the
    // real axis.
    const PROPERTIES: Properties = Properties {
        name: "verlet",
        label: "velocity Verlet",
        order: 2,
        oscillation_limit: 2.0,
        decay_limit: 1.0,
        solves_stiff_part: true,
        side_by_side: true,
        automatic_oscillation: [0.65, 0.65],
        automatic_decay: 0.7,
    };

    fn of_case(_dimension: usize, step_s: f64, _tolerance: f64) -> Self {
        Self::new(step_s)
    }
}

impl Method for VelocityVerlet {
    fn restart<S: System>(&mut self, system: &mut S, step: &StepState) {
        self.steps.restart(step.t1_s);
        if system.has_stiff_part() {
            self.nonstiff = [0, 1].map(|_| Aligned::zeros(step.y1.len()));
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
        let blocks = system.second_order_blocks();
        positions(blocks, h, y0, f0, y1);
        if system.has_stiff_part() {
            let [e0, e1] = &mut self.nonstiff;
            std::mem::swap(e0, e1);
            system.nonstiff_derivative(step.t1_s, y1, e1);
            trapezoid(system, h, [y0, f0], [&e0[..n], &e1[..n]], y1);
            step.f1.copy_from_slice(e1);
            system.add_stiff_part(h, y0, y1, &mut step.f1);
        } else {
            bend_along_paths(system, h, [y0, f0, &step.f1[..n]], y1);
            system.derivative(step.t1_s, y1, &mut step.f1);
            trapezoid(system, h, [y0, f0], [f0, &step.f1[..n]], y1);
        }
        Ok(())
    }
}

/// Adds h/2·(a0 − a₋) along the direction of v0 to the velocities of planar paths, a₋ the
/// acceleration a step earlier.
#[inline(always)]
fn bend_along_paths<'v, S: System>(
    system: &S,
    h: f64,
    [y0, f0, before]: [&'v [f64]; 3],
    y1: &mut [f64],
) {
    let Some([x, y]) = system.planar_velocities() else {
        return;
    };
    let of = |values: &'v [f64]| PlaneVector {
        x: &values[x.clone()],
        y: &values[y.clone()],
    };
    let (v, a, b) = (of(y0), of(f0), of(before));
    let (front, back) = y1.split_at_mut(y.start);
    bend(h, v, a, b, &mut front[x], &mut back[..y.len()]);
}

/// [`bend_along_paths`] of velocities along x and y.
#[inline(always)]
fn bend(
    h: f64,
    v: PlaneVector<&[f64]>,
    a: PlaneVector<&[f64]>,
    before: PlaneVector<&[f64]>,
    vx1: &mut [f64],
    vy1: &mut [f64],
) {
    for k in 0..vx1.len() {
        let square = (v.x[k] * v.x[k] + v.y[k] * v.y[k]).max(f64::MIN_POSITIVE);
        let change = v.x[k] * (a.x[k] - before.x[k]) + v.y[k] * (a.y[k] - before.y[k]);
        let along = 0.5 * h * change / square;
        vx1[k] += along * v.x[k];
        vy1[k] += along * v.y[k];
    }
}

/// x1 = x0 + h·v0 + h²/2·a0.
#[inline(always)]
fn positions(blocks: &[SecondOrderBlock], h: f64, y0: &[f64], f0: &[f64], y1: &mut [f64]) {
    for block in blocks {
        let count = block.count;
        let (v0, a0) = (&y0[block.rates..][..count], &f0[block.rates..][..count]);
        let x0 = &y0[block.positions..][..count];
        let x1 = &mut y1[block.positions..][..count];
        for k in 0..count {
            x1[k] = x0[k] + h * (v0[k] + 0.5 * h * a0[k]);
        }
    }
}

/// y1 = y0 + h/2·(e0 + e1) for all but the positions, which have their values by f0.
#[inline(always)]
fn trapezoid<S: System>(
    system: &S,
    h: f64,
    [y0, f0]: [&[f64]; 2],
    [e0, e1]: [&[f64]; 2],
    y1: &mut [f64],
) {
    let blocks = system.second_order_blocks();
    // Few positions between others are sooner computed again than passed over.
    let first = blocks.first().filter(|b| b.positions == 0);
    let from = first.map_or(0, |b| b.count);
    for k in from..y1.len() {
        y1[k] = y0[k] + 0.5 * h * (e0[k] + e1[k]);
    }
    positions(&blocks[usize::from(first.is_some())..], h, y0, f0, y1);
}
