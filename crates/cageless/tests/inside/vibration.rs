//! The measured vibration of a run, against the force on the outer ring at every step.

use crate::common::structure;
use cageless::numerics::vector::PlaneVector;
use cageless::simulation::{Control, Observer, ObserverError, StepView, run};
use cageless::vibration::{AFTER_CONTACT_S, VibrationRecorder};
use cageless::{Case, Gaps, Housing, Start, StartState};

/// Ends of the steps, force on the outer ring there, and whether balls touch.
#[derive(Default)]
struct EveryStep(Vec<(f64, [f64; 2], bool)>);

impl Observer for EveryStep {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let contacts = &view.contacts;
        let force = contacts.outer_ring_force_n();
        self.0.push((view.step.t1_s, force, contacts.balls_touch()));
        Ok(Control::Continue(()))
    }
}

fn case() -> Case {
    let mut case = structure(5.1, 25.2);
    let even = case.bearing.nominal_gap_rad();
    let gaps = (0..14).map(|k| even * [0.2, 1.8][k % 2]).collect();
    case.start = Start::new(StartState::Settled, Gaps::List(gaps), 0.1);
    case.solver.duration_s = 0.012;
    case
}

/// Points of a force over time, linear in between.
type Force = Vec<(f64, f64)>;

/// Mean of the force over each 10 µs, from the first point on.
fn means(force: &Force) -> Vec<f64> {
    const INTERVAL_S: f64 = 1e-5;
    let count = (force[force.len() - 1].0 / INTERVAL_S).round() as usize;
    let mut impulses = vec![0.0; count];
    for pair in force.windows(2) {
        let [(from, a), (to, b)] = [pair[0], pair[1]];
        let at = |time: f64| a + (b - a) * (time - from) / (to - from);
        for (k, impulse) in impulses.iter_mut().enumerate() {
            let (begin, end) = (INTERVAL_S * k as f64, INTERVAL_S * (k + 1) as f64);
            let (begin, end) = (begin.max(from), end.min(to));
            if end > begin {
                *impulse += (end - begin) * at(0.5 * (begin + end));
            }
        }
    }
    impulses
        .iter()
        .map(|impulse| impulse / INTERVAL_S)
        .collect()
}

/// Acceleration of M ẍ + c ẋ + k x = F at the end of each 10 µs, from rest under the first force,
/// by the classical Runge–Kutta method.
fn accelerations(forces: &[f64], housing: &Housing) -> Vec<f64> {
    let (m, c, k) = (
        housing.mass_kg,
        housing.damping_n_s_m,
        housing.stiffness_n_m,
    );
    let (steps, mut x, mut v) = (20, forces[0] / k, 0.0);
    let h = 1e-5 / f64::from(steps);
    let mut found = vec![];
    for force in forces {
        let rate = |x: f64, v: f64| (v, (force - c * v - k * x) / m);
        for _ in 0..steps {
            let a = rate(x, v);
            let b = rate(x + 0.5 * h * a.0, v + 0.5 * h * a.1);
            let c = rate(x + 0.5 * h * b.0, v + 0.5 * h * b.1);
            let d = rate(x + h * c.0, v + h * c.1);
            x += h / 6.0 * (a.0 + 2.0 * b.0 + 2.0 * c.0 + d.0);
            v += h / 6.0 * (a.1 + 2.0 * b.1 + 2.0 * c.1 + d.1);
        }
        found.push(rate(x, v).1);
    }
    found
}

/// Both directions with their times, root mean squares and peaks, with and without the contacts
/// between balls, once the transient is left out.
#[test]
fn a_measurement_is_the_motion_of_the_housing_under_the_force() {
    let case = case();
    let housing = Housing {
        mass_kg: 3.0,
        stiffness_n_m: 4e8,
        damping_n_s_m: 5e3,
    };
    let after_s = 0.002_005;
    let mut every = EveryStep::default();
    // As fast as the housing is sampled: nothing is filtered.
    let mut with = VibrationRecorder::new(&housing, 1e5, after_s);
    let mut without = VibrationRecorder::without_contacts(&housing, 1e5, after_s);
    run(
        &case,
        &mut [&mut every, &mut with, &mut without],
        &mut |_| Control::Continue(()),
    )
    .unwrap();
    let rows = every.0;
    assert!(rows.iter().any(|row| row.2), "balls touch");
    for axis in 0..2 {
        // The force at the start is that of the equilibrium: the first step begins with it.
        let mut force: Force = vec![(0.0, rows[0].1[axis])];
        force.extend(rows.iter().map(|(time, force, _)| (*time, force[axis])));
        let mut cut = vec![force[0]];
        let mut touched_s = f64::NEG_INFINITY;
        for (time, force, touch) in &rows {
            if *touch {
                touched_s = *time;
            }
            if time - touched_s >= AFTER_CONTACT_S {
                cut.push((*time, force[axis]));
            }
        }
        assert!(cut.len() < force.len());
        for (name, force, measurement) in [
            ("with", &force, &with.measurements()[axis]),
            ("without", &cut, &without.measurements()[axis]),
        ] {
            let all = accelerations(&means(force), &housing);
            let largest = all.iter().fold(0.0f64, |m, a| m.max(a.abs()));
            let trace = measurement.trace();
            // The first sample from 2.005 ms on is the 201st: at its end, 2.01 ms.
            assert!(
                (trace[0][0] - 2.01e-3).abs() < 1e-12,
                "{name}: {:?}",
                trace[0]
            );
            let expected = &all[200..];
            assert!(
                trace.len().abs_diff(expected.len()) <= 1,
                "{name}: {}",
                trace.len()
            );
            for (k, ([time, found], expected)) in trace.iter().zip(expected).enumerate() {
                assert!((time - 1e-5 * (k + 201) as f64).abs() < 1e-9);
                let error = (found - expected).abs();
                assert!(
                    error < 1e-3 * largest,
                    "{name} {axis} {k}: {found} {expected}"
                );
            }
            let count = trace.len() as f64;
            assert_eq!(measurement.samples() as usize, trace.len());
            let mean = trace.iter().map(|row| row[1]).sum::<f64>() / count;
            let square = trace.iter().map(|row| (row[1] - mean).powi(2)).sum::<f64>() / count;
            assert!((measurement.rms() / square.sqrt() - 1.0).abs() < 1e-9);
            let peak = trace.iter().fold(0.0f64, |m, row| m.max(row[1].abs()));
            assert_eq!(measurement.peak, peak);
            assert_eq!(measurement.trace_stretch_s(), None);
            assert_eq!(measurement.interval_s(), 1e-5);
        }
        let [with, without] = [&with.measurements()[axis], &without.measurements()[axis]];
        assert!(without.rms() < with.rms());
    }
}

/// The balls of unequal size also push the outer ring along the circumference where their contacts rise.
#[test]
fn the_force_on_the_outer_ring_is_the_sum_over_its_contacts() {
    let mut case = structure(5.1, 25.2);
    let deviations = (0..14).map(|k| -1e-6 * f64::from(k % 3)).collect();
    case.bearing = (case.bearing)
        .with_ball_radius_deviations(deviations)
        .unwrap();
    case.solver.duration_s = 2e-4;
    let mut rising_n: f64 = 0.0;
    struct Sum<'a>(&'a mut f64);
    impl Observer for Sum<'_> {
        fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
            let (c, PlaneVector { x, y }) = (&view.contacts, view.positions());
            let mut sum = [0.0; 2];
            for k in 0..c.balls() {
                let [ex, ey] = [x[k], y[k]].map(|part| part / x[k].hypot(y[k]));
                let along = c.outer_friction_n(k) - c.outer_slope_force_n(k);
                sum[0] += c.outer_force_n(k) * ex - along * ey;
                sum[1] += c.outer_force_n(k) * ey + along * ex;
                *self.0 = self.0.max(c.outer_slope_force_n(k).abs());
            }
            for (found, expected) in c.outer_ring_force_n().into_iter().zip(sum) {
                assert!((found - expected).abs() < 1e-9, "{found} {expected}");
            }
            Ok(Control::Continue(()))
        }
    }
    let ended = run(&case, &mut [&mut Sum(&mut rising_n)], &mut |_| {
        Control::Continue(())
    });
    assert!(
        ended.unwrap().end_s > 1.9e-4 && rising_n > 1e-3,
        "{rising_n}"
    );
}
