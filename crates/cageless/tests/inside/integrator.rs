//! The integrators on problems with known solutions.

use std::ops::Range;

use cageless::integrator::runge_kutta::RungeKutta;
use cageless::integrator::{
    Abm4, Adaptive, Integrator, Method, SecondOrderBlock, System, VelocityVerlet, tableau,
};

/// A pendulum-like smooth oscillator with a nonlinear clock: y = (sin s, cos s) with
/// s = t + t²/2, so that f depends on t.
struct Chirp;

impl System for Chirp {
    fn dimension(&self) -> usize {
        2
    }
    fn derivative(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) {
        let rate = 1.0 + t;
        dydt[0] = rate * y[1];
        dydt[1] = -rate * y[0];
    }
}

fn error_of_chirp(steps: u32) -> f64 {
    let h = 2.0 / f64::from(steps);
    let mut method = Integrator::new(Abm4::new(2, h), 2);
    method.restart(&mut Chirp, 0.0, &[0.0, 1.0]);
    for _ in 0..steps {
        method.advance(&mut Chirp, f64::INFINITY).unwrap();
    }
    let s: f64 = 2.0 + 2.0;
    (method.step().y1[0] - s.sin()).hypot(method.step().y1[1] - s.cos())
}

#[test]
fn abm4_has_order_four() {
    for steps in [100, 200, 400] {
        let order = (error_of_chirp(steps) / error_of_chirp(2 * steps)).log2();
        assert!((order - 4.0).abs() < 0.2, "{steps}: {order}");
    }
}

/// dy/dt = ±1 with a jump at t = 1/3, announced or not.
struct Jump {
    announced: bool,
    late: bool,
}

impl System for Jump {
    fn dimension(&self) -> usize {
        1
    }
    fn derivative(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) {
        self.late = t > 1.0 / 3.0;
        // Smooth on both sides; the history of one side says nothing about the other.
        dydt[0] = if self.late {
            10.0 * (5.0 * t).cos() - y[0]
        } else {
            -y[0]
        };
    }
    fn mode(&self) -> u64 {
        u64::from(self.announced && self.late)
    }
}

fn value_after_jump(announced: bool, h: f64) -> f64 {
    let mut system = Jump {
        announced,
        late: false,
    };
    let mut method = Integrator::new(Abm4::new(1, h), 1);
    method.restart(&mut system, 0.0, &[1.0]);
    for _ in 0..(1.0 / h).round() as u32 {
        method.advance(&mut system, f64::INFINITY).unwrap();
    }
    method.step().y1[0]
}

/// y′ = 10 cos 5t − y from t0, in closed form.
fn exact_after_jump() -> f64 {
    let particular = |t: f64| 10.0 * ((5.0 * t).cos() + 5.0 * (5.0 * t).sin()) / 26.0;
    let t0: f64 = 1.0 / 3.0;
    particular(1.0) + ((-t0).exp() - particular(t0)) * (-(1.0 - t0)).exp()
}

/// History that reaches across a jump costs three orders; restarting keeps them.
#[test]
fn a_jump_spoils_the_order_unless_history_restarts() {
    let error = |announced, h| (value_after_jump(announced, h) - exact_after_jump()).abs();
    let (coarse, fine) = (0.02, 0.0025);
    let restarted = (error(true, coarse) / error(true, fine)).log2() / 3.0;
    assert!(restarted > 3.5, "order {restarted}");
    assert!(error(true, fine) < 1e-7, "{}", error(true, fine));
    assert!(
        error(false, fine) > 1e3 * error(true, fine),
        "{} {}",
        error(false, fine),
        error(true, fine)
    );
}

/// An oscillator in the stable range neither grows nor explodes; beyond it, it does:
/// the limit in the documentation is real.
#[test]
fn stability_interval_of_the_documentation() {
    struct Decay(f64);
    impl System for Decay {
        fn dimension(&self) -> usize {
            1
        }
        fn derivative(&mut self, _: f64, y: &[f64], dydt: &mut [f64]) {
            dydt[0] = -self.0 * y[0];
        }
    }
    let after = |rate: f64| {
        let mut system = Decay(rate);
        let mut method = Integrator::new(Abm4::new(1, 1.0), 1);
        method.restart(&mut system, 0.0, &[1.0]);
        for _ in 0..400 {
            method.advance(&mut system, f64::INFINITY).unwrap();
        }
        method.step().y1[0].abs()
    };
    assert!(after(1.2) < 1e-3, "{}", after(1.2));
    assert!(after(1.35) > 1.0, "{}", after(1.35));
}

/// The first component is a position, the second its rate.
const POSITION_AND_RATE: [SecondOrderBlock; 1] = [SecondOrderBlock {
    positions: 0,
    rates: 1,
    count: 1,
}];

/// x″ = −ω²x with ω = 1, as position and rate.
struct Spring;

impl System for Spring {
    fn dimension(&self) -> usize {
        2
    }
    fn derivative(&mut self, _: f64, y: &[f64], dydt: &mut [f64]) {
        dydt[0] = y[1];
        dydt[1] = -y[0];
    }
    fn second_order_blocks(&self) -> &[SecondOrderBlock] {
        &POSITION_AND_RATE
    }
}

fn swing(h: f64, until: f64) -> [f64; 2] {
    let mut method = Integrator::new(VelocityVerlet::new(h), 2);
    method.restart(&mut Spring, 0.0, &[1.0, 0.0]);
    while method.step().t1_s < until {
        method.advance(&mut Spring, until).unwrap();
    }
    [method.step().y1[0], method.step().y1[1]]
}

#[test]
fn leapfrog_has_order_two() {
    let error = |h: f64| {
        let [x, v] = swing(h, 3.0);
        (x - 3f64.cos()).hypot(v + 3f64.sin())
    };
    for h in [0.05, 0.025] {
        let order = (error(h) / error(h / 2.0)).log2();
        assert!((order - 2.0).abs() < 0.05, "{h}: {order}");
    }
}

/// A unit mass on a springy circle of radius 1, driven along it towards the speed 1.
struct DrivenOnCircle;

impl System for DrivenOnCircle {
    fn dimension(&self) -> usize {
        4
    }
    fn derivative(&mut self, _time_s: f64, y: &[f64], dydt: &mut [f64]) {
        let distance = y[0].hypot(y[1]);
        let [ex, ey] = [y[0] / distance, y[1] / distance];
        let spring = -SPRING * (distance - 1.0);
        let drive = 2.0 * (1.0 - (y[3] * ex - y[2] * ey));
        dydt.copy_from_slice(&[
            y[2],
            y[3],
            spring * ex - drive * ey,
            spring * ey + drive * ex,
        ]);
    }
    fn second_order_blocks(&self) -> &[SecondOrderBlock] {
        &[SecondOrderBlock {
            positions: 0,
            rates: 2,
            count: 2,
        }]
    }
    fn planar_velocities(&self) -> Option<[Range<usize>; 2]> {
        Some([2..3, 3..4])
    }
}

const SPRING: f64 = 16.0;

/// The speed extrapolated along the acceleration at the start of the step would be too large by
/// (ωh)²/2, and the drive would leave the mass too slow by as much.
#[test]
fn leapfrog_keeps_the_speed_on_a_circle() {
    let h = 0.05;
    // r(r − 1)·k = v².
    let radius = 0.5 + (0.25 + 1.0 / SPRING).sqrt();
    let mut method = Integrator::new(VelocityVerlet::new(h), 4);
    method.restart(&mut DrivenOnCircle, 0.0, &[radius, 0.0, 0.0, 1.0]);
    while method.step().t1_s < 20.0 {
        method.advance(&mut DrivenOnCircle, 20.0).unwrap();
    }
    let y = &method.step().y1;
    let speed = (y[0] * y[3] - y[1] * y[2]) / y[0].hypot(y[1]);
    assert!((speed - 1.0).abs() < 0.05 * 0.5 * h * h, "{}", speed - 1.0);
}

/// A hundred thousand periods at ωh = 0.6, where the energy of ABM4 would long have
/// left the range of numbers.
#[test]
fn leapfrog_keeps_its_energy() {
    let [x, v] = swing(0.6, 6.0e5);
    let energy = x * x + v * v;
    assert!((energy - 1.0).abs() < 0.1, "{energy}");
    let mut method = Integrator::new(Abm4::new(2, 0.6), 2);
    method.restart(&mut Spring, 0.0, &[1.0, 0.0]);
    for _ in 0..1000 {
        method.advance(&mut Spring, f64::INFINITY).unwrap();
    }
    let grown = method.step().y1[0].hypot(method.step().y1[1]);
    assert!(grown > 1.2, "{grown}");
}

/// Rows add up as they must, and the global error falls with the order of the pair.
#[test]
fn pairs_have_their_order() {
    // As fine as rounding lets the differences be seen.
    for (pair, order, steps) in [
        (&tableau::DORMAND_PRINCE_5, 5.0, 24),
        (&tableau::TSITOURAS_5, 5.0, 160),
        (&tableau::DORMAND_PRINCE_8, 8.0, 16),
    ] {
        for (node, row) in pair.c.iter().zip(pair.a) {
            assert!((row.iter().sum::<f64>() - node).abs() < 1e-14, "{node}");
        }
        assert!((pair.b.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        assert!(pair.error.iter().sum::<f64>().abs() < 1e-14);
        let error = |steps: u32| {
            let mut method = RungeKutta::with_tableau(pair, 2);
            let (mut y, mut rate) = ([0.0, 1.0], [0.0; 2]);
            Chirp.derivative(0.0, &y, &mut rate);
            let h = 2.0 / f64::from(steps);
            for k in 0..steps {
                let from = f64::from(k) * h;
                let made = method.step(&mut Chirp, from, h, 1e9, 0.0, &mut y, &mut rate);
                assert_eq!(made.unwrap().size, h);
            }
            (y[0] - 4f64.sin()).hypot(y[1] - 4f64.cos())
        };
        let measured = (error(steps) / error(2 * steps)).log2();
        assert!((measured - order).abs() < 0.2, "{order}: {measured}");
    }
}

/// The error follows the tolerance down to rounding, with few steps: order 5, then 8.
#[test]
fn adaptive_meets_its_tolerance() {
    for tolerance in [1e-4, 1e-6, 1e-9, 1e-12] {
        let mut method = Integrator::new(Adaptive::new(2, 1.0, tolerance), 2);
        method.restart(&mut Chirp, 0.0, &[0.0, 1.0]);
        let mut steps = 0;
        while method.step().t1_s < 2.0 {
            method.advance(&mut Chirp, 2.0).unwrap();
            steps += 1;
        }
        let end = method.step();
        let error = (end.y1[0] - 4f64.sin()).hypot(end.y1[1] - 4f64.cos());
        assert!(error < 20.0 * tolerance, "{tolerance:e}: {error:e}");
        assert!(steps < 60, "{tolerance:e}: {steps} steps");
        assert_eq!(end.t1_s, 2.0);
    }
}

#[test]
fn adaptive_crosses_a_jump() {
    let mut system = Jump {
        announced: false,
        late: false,
    };
    let mut method = Integrator::new(Adaptive::new(1, 0.1, 1e-10), 1);
    method.restart(&mut system, 0.0, &[1.0]);
    while method.step().t1_s < 1.0 {
        method.advance(&mut system, 1.0).unwrap();
    }
    let error = (method.step().y1[0] - exact_after_jump()).abs();
    assert!(error < 1e-8, "{error:e}");
}

/// Momentum from a contact whose depth is d² − (t − ½)², while that is positive.
struct Touch {
    named: bool,
    evaluations: u32,
}

impl System for Touch {
    fn dimension(&self) -> usize {
        2
    }
    fn derivative(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) {
        self.evaluations += 1;
        dydt[0] = -2.0 * (t - 0.5);
        dydt[1] = if y[0] > 0.0 { y[0].sqrt() } else { 0.0 };
    }
    fn edges(&self, y: &[f64], values: &mut Vec<f64>) {
        if self.named {
            values.extend([1.0, y[0]]);
        }
    }
}

/// ∫√(d² − τ²) dτ = ½πd², however short the contact and however long the steps, also where it
/// opens and closes between two stages.
#[test]
fn adaptive_sees_contacts_within_a_step() {
    let miss = |half_length: f64, named: bool, tolerance: f64| {
        let depth = half_length * half_length;
        let mut system = Touch {
            named,
            evaluations: 0,
        };
        let mut method = Integrator::new(Adaptive::new(2, 1.0, tolerance), 2);
        method.restart(&mut system, 0.0, &[depth - 0.25, 0.0]);
        while method.step().t1_s < 1.0 {
            method.advance(&mut system, 1.0).unwrap();
        }
        assert!(system.evaluations < 5000, "{}", system.evaluations);
        let impulse = 0.5 * std::f64::consts::PI * depth;
        (method.step().y1[1] - impulse).abs() / impulse.max(tolerance)
    };
    for half_length in [0.4, 0.2, 0.1, 0.05, 0.03, 0.01, 1e-3] {
        for tolerance in [1e-4, 1e-8, 1e-11] {
            let relative = miss(half_length, true, tolerance);
            let allowed = 100.0 * tolerance / (half_length * half_length).max(tolerance);
            assert!(
                relative < allowed,
                "{half_length} {tolerance:e}: {relative:e}"
            );
        }
    }
    // Without its edge the shortest is not seen at all.
    assert!(miss(0.05, false, 1e-8) > 0.99);
}

/// A jump that is named is found in a few steps and leaves no error.
#[test]
fn adaptive_ends_its_steps_at_edges() {
    struct Named(Jump, f64);
    impl System for Named {
        fn dimension(&self) -> usize {
            1
        }
        fn derivative(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) {
            self.1 = t;
            self.0.derivative(t, y, dydt);
        }
        fn edges(&self, _y: &[f64], values: &mut Vec<f64>) {
            values.push((self.1 - 1.0 / 3.0).tanh());
        }
    }
    let jump = Jump {
        announced: false,
        late: false,
    };
    let mut system = Named(jump, 0.0);
    let mut method = Integrator::new(Adaptive::new(1, 0.1, 1e-10), 1);
    method.restart(&mut system, 0.0, &[1.0]);
    let mut ends = vec![];
    while method.step().t1_s < 1.0 {
        method.advance(&mut system, 1.0).unwrap();
        ends.push(method.step().t1_s);
    }
    let nearest = ends
        .iter()
        .fold(1.0, |m: f64, t| m.min((t - 1.0 / 3.0).abs()));
    assert!(nearest < 1e-8, "{nearest:e}");
    let error = (method.step().y1[0] - exact_after_jump()).abs();
    assert!(error < 1e-9, "{error:e}");
}

/// Every method ends exactly at the limit, also where that is no multiple of the step.
#[test]
fn steps_end_at_the_limit() {
    fn reaches_the_limit(name: &str, method: impl Method, tolerance: f64) {
        let limit = 1.037;
        let mut integrator = Integrator::new(method, 2);
        integrator.restart(&mut Chirp, 0.0, &[0.0, 1.0]);
        while integrator.step().t1_s < limit {
            integrator.advance(&mut Chirp, limit).unwrap();
        }
        assert_eq!(integrator.step().t1_s, limit, "{name}");
        let s: f64 = limit + limit * limit / 2.0;
        let error = (integrator.step().y1[0] - s.sin()).abs();
        assert!(error < tolerance, "{name}: {error:e}");
    }
    reaches_the_limit("ABM4", Abm4::new(2, 0.1), 1e-3);
    reaches_the_limit("velocity Verlet", VelocityVerlet::new(0.01), 1e-3);
    reaches_the_limit("adaptive", Adaptive::new(2, 0.1, 1e-9), 1e-7);
}

/// x″ = cos t − λx′, its drag declared stiff; from rest.
struct Drag(f64);

impl System for Drag {
    fn dimension(&self) -> usize {
        2
    }
    fn derivative(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) {
        self.nonstiff_derivative(t, y, dydt);
        dydt[1] -= self.0 * y[1];
    }
    fn second_order_blocks(&self) -> &[SecondOrderBlock] {
        &POSITION_AND_RATE
    }
    fn has_stiff_part(&self) -> bool {
        true
    }
    fn nonstiff_derivative(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) {
        (dydt[0], dydt[1]) = (y[1], t.cos());
    }
    fn add_stiff_part(&mut self, h: f64, _y0: &[f64], y: &mut [f64], dydt: &mut [f64]) {
        // v = v_free − hλv.
        let v = y[1] / (1.0 + h * self.0);
        dydt[1] -= self.0 * v;
        y[1] = v;
    }
}

/// The stiff part is of order one and damped at any stiffness, without ringing.
#[test]
fn a_stiff_part_is_of_first_order_and_damped() {
    let speed = |rate: f64, h: f64| {
        let mut system = Drag(rate);
        let mut method = Integrator::new(VelocityVerlet::new(h), 2);
        method.restart(&mut system, 0.0, &[0.0, 0.0]);
        while method.step().t1_s < 2.0 {
            method.advance(&mut system, 2.0).unwrap();
        }
        method.step().y1[1]
    };
    let exact = |rate: f64| {
        let particular = |t: f64| (rate * t.cos() + t.sin()) / (rate * rate + 1.0);
        particular(2.0) - particular(0.0) * (-rate * 2.0f64).exp()
    };
    for h in [0.02, 0.01] {
        let error = |h: f64| (speed(3.0, h) - exact(3.0)).abs();
        let order = (error(h) / error(h / 2.0)).log2();
        assert!((order - 1.0).abs() < 0.1, "{order}");
    }
    for rate in [1e3, 1e6, 1e9] {
        let miss = speed(rate, 0.01) - exact(rate);
        assert!(miss.abs() < 0.02 / rate, "{rate:e}: {miss:e}");
    }
}
