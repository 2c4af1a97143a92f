//! The integrators on problems with known solutions.

use cageless::integrator::{Abm4, Integrator, System};

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
    let mut method = Abm4::new(2, h);
    method.restart(&mut Chirp, 0.0, &[0.0, 1.0]);
    for _ in 0..steps {
        method.advance(&mut Chirp).unwrap();
    }
    let s: f64 = 2.0 + 2.0;
    (method.step().after[0] - s.sin()).hypot(method.step().after[1] - s.cos())
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
    fn regime(&self) -> u64 {
        u64::from(self.announced && self.late)
    }
}

fn value_after_jump(announced: bool, h: f64) -> f64 {
    let mut system = Jump {
        announced,
        late: false,
    };
    let mut method = Abm4::new(1, h);
    method.restart(&mut system, 0.0, &[1.0]);
    for _ in 0..(1.0 / h).round() as u32 {
        method.advance(&mut system).unwrap();
    }
    method.step().after[0]
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
        let mut method = Abm4::new(1, 1.0);
        method.restart(&mut system, 0.0, &[1.0]);
        for _ in 0..400 {
            method.advance(&mut system).unwrap();
        }
        method.step().after[0].abs()
    };
    assert!(after(1.2) < 1e-3, "{}", after(1.2));
    assert!(after(1.35) > 1.0, "{}", after(1.35));
}
