//! A free impact of two balls against conservation laws and closed forms.

use crate::common::{conventional, dimensions, run_from, steel, undamped};
use cageless::ball::BallMotion;
use cageless::collision::{Collision, CollisionDetector};
use cageless::contact::hertz;
use cageless::dynamics::coordinates::BallCoordinate;
use cageless::dynamics::state::State;
use cageless::integrator::{Abm4, Integrator};
use cageless::simulation::Control;
use cageless::{Bearing, Case, IntegrationMethod, Motion, dynamics};

/// Rings so far apart, and everything else so quiet, that balls 1 and 2 meet in free
/// flight.
fn free_flight() -> Case {
    let mut d = dimensions();
    d.balls = 3;
    d.outer_groove_bottom_radius_m = d.inner_groove_bottom_radius_m + 3.0 * d.ball_radius_m;
    d.outer_shoulder_radius_m = d.outer_groove_bottom_radius_m - 1e-3;
    let mut case = undamped(conventional(d));
    case.operation.gravity_m_s2 = 0.0;
    case.operation.radial_load_n = 0.0;
    case.contact.friction.coefficient = 0.0;
    case.solver.step_s = 0.1e-6;
    case.solver.duration_s = 200e-6;
    case
}

/// Motion of a ball.
fn ball(x: f64, y: f64, vx: f64, vy: f64, spin: f64) -> BallMotion {
    BallMotion { x, y, vx, vy, spin }
}

/// Balls 1 and 2 approach along x at `speed`, 1 µm apart.
fn approaching(case: &Case, speed: f64) -> (State, Vec<f64>) {
    let rw = case.bearing.ball_radius_m();
    let y = -case.bearing.pitch_radius_m();
    let mut state = State::new(3);
    let x = rw + 0.5e-6;
    state.set_ball(0, ball(-x, y, speed / 2.0, 0.0, 0.0));
    state.set_ball(1, ball(x, y, -speed / 2.0, 0.0, 0.0));
    state.set_ball(2, ball(0.0, -y, 0.0, 0.0, 0.0));
    let angles = vec![-(x / -y).atan(), (x / -y).atan(), std::f64::consts::PI];
    (state, angles)
}

fn impact(case: &Case, speed: f64) -> (Collision, State) {
    let (state, angles) = approaching(case, speed);
    let mut found = vec![];
    let mut detector = CollisionDetector::new(|c| {
        found.push(c);
        Ok(())
    });
    let end = run_from(case, &state, &angles, &mut [&mut detector], &mut |_| {
        Control::Continue(())
    })
    .unwrap()
    .state;
    drop(detector);
    assert_eq!(found.len(), 1);
    (found[0], end)
}

#[test]
fn elastic_impact_follows_hertz() {
    let case = free_flight();
    let speed = 0.1;
    let (collision, end) = impact(&case, speed);
    let k = case.bearing.ball_contact().stiffness_n_m1_5;
    let mass = case.bearing.ball_mass_kg();
    let (_, force, duration) = hertz::impact(k, mass, speed);
    assert!((collision.peak_force_n / force - 1.0).abs() < 1e-4);
    assert!((collision.duration_s / duration - 1.0).abs() < 1e-4);
    assert!((collision.approach_speed_m_s / speed - 1.0).abs() < 1e-9);
    // Equal balls exchange velocities: m·speed of impulse.
    assert!((collision.impulse_n_s / (mass * speed) - 1.0).abs() < 1e-4);
    assert!((end.vx_m_s()[0] + speed / 2.0).abs() < 1e-6 * speed);
    assert!((collision.angle_rad).abs() < 1e-6);
    assert_eq!((collision.ball, collision.next_ball), (0, 1));
    // About the 45 µs that an impact at 0.1 m/s is known to last.
    assert!((40e-6..60e-6).contains(&duration), "{duration}");
}

/// Touch, parting and peak lie between steps, and are found there wherever the steps fall.
#[test]
fn an_impact_of_a_few_steps_is_located() {
    let mut case = free_flight();
    let speed = 0.1;
    let k = case.bearing.ball_contact().stiffness_n_m1_5;
    let (_, force, duration) = hertz::impact(k, case.bearing.ball_mass_kg(), speed);
    for step_s in [2.6e-6, 2.8e-6, 3e-6, 3.2e-6] {
        case.solver.step_s = step_s;
        let (collision, _) = impact(&case, speed);
        let peak = collision.peak_force_n / force - 1.0;
        let lasted = collision.duration_s / duration - 1.0;
        let impulse = collision.impulse_n_s / (case.bearing.ball_mass_kg() * speed) - 1.0;
        println!("{step_s}: peak {peak:.1e}, duration {lasted:.1e}, impulse {impulse:.1e}");
        assert!(peak.abs() < 1e-3, "{step_s}: {peak}");
        assert!(lasted.abs() < 1e-3, "{step_s}: {lasted}");
        assert!((collision.start_s - 1e-6 / speed).abs() < 1e-9);
        // The trapezoidal rule over 15 steps.
        assert!(impulse.abs() < 2e-3, "{step_s}: {impulse}");
    }
}

/// Balls that meet anywhere and at an angle: what counts is the line of centres at first touch.
#[test]
fn an_oblique_impact_anywhere_is_described_along_its_line_of_centres() {
    let mut case = free_flight();
    case.solver.duration_s = 100e-6;
    let (rw, middle) = (case.bearing.ball_radius_m(), case.bearing.pitch_radius_m());
    let mass = case.bearing.ball_mass_kg();
    for turn in [0.4, 2.5, -3.1] {
        // From the bottom to ψ = `turn`, counter-clockwise.
        let turned = |x: f64, y: f64| {
            let (sin, cos) = f64::sin_cos(turn);
            [cos * x - sin * y, sin * x + cos * y]
        };
        let at = |x: f64, y: f64, vx: f64, vy: f64| {
            let ([x, y], [vx, vy]) = (turned(x, y), turned(vx, vy));
            ball(x, y, vx, vy, 0.0)
        };
        let half = rw + 1e-6;
        let (faster, aside) = (0.2, 0.15);
        let mut state = State::new(3);
        state.set_ball(0, at(-half, -middle, faster, aside));
        state.set_ball(1, at(half, -middle, 0.0, 0.0));
        state.set_ball(2, at(0.0, middle, 0.0, 0.0));
        let angles = [-half, half, 0.0].map(|x| turn + (x / middle).atan());
        let mut found = vec![];
        let mut detector = CollisionDetector::new(|c| {
            found.push(c);
            Ok(())
        });
        let angles = [angles[0], angles[1], turn + std::f64::consts::PI];
        let end = run_from(&case, &state, &angles, &mut [&mut detector], &mut |_| {
            Control::Continue(())
        })
        .unwrap()
        .state;
        drop(detector);
        let [c] = found.as_slice() else {
            panic!("{found:?}")
        };
        // The first time at which the centres are 2Rw apart.
        let (speed2, along) = (faster * faster + aside * aside, 2.0 * half * faster);
        let root = (along * along - speed2 * (4.0 * half * half - 4.0 * rw * rw)).sqrt();
        let touch_s = (along - root) / speed2;
        assert!((c.start_s - touch_s).abs() < 1e-11, "{c:?} {touch_s}");
        let line = [2.0 * half - faster * touch_s, -aside * touch_s].map(|d| d / (2.0 * rw));
        let approach = faster * line[0] + aside * line[1];
        assert!(
            (c.approach_speed_m_s / approach - 1.0).abs() < 1e-9,
            "{c:?} {approach}"
        );
        assert!(
            approach < 0.81 * speed2.sqrt(),
            "not the whole relative speed"
        );
        let between = turn + (0.5 * faster * touch_s).atan2(middle - 0.5 * aside * touch_s);
        assert!((c.angle_rad - between).abs() < 1e-9, "{c:?} {between}");
        // Equal balls without friction exchange what they have along the line.
        // The line turns by 0.7 mrad during the contact.
        assert!((c.impulse_n_s / (mass * approach) - 1.0).abs() < 1e-3);
        let got = end.vx_m_s()[1].hypot(end.vy_m_s()[1]);
        assert!((got / approach - 1.0).abs() < 1e-3, "{got} {approach}");
        assert_eq!((c.ball, c.next_ball), (0, 1));
    }
}

/// Contacts that are closed at the start or at the end of a run have the time in it.
#[test]
fn contacts_closed_at_the_ends_of_a_run_are_passed_on() {
    let mut case = free_flight();
    let speed = 0.1;
    let (_, _, duration) = hertz::impact(
        case.bearing.ball_contact().stiffness_n_m1_5,
        case.bearing.ball_mass_kg(),
        speed,
    );
    // Balls touch 10 µs after the start.
    case.solver.duration_s = 10e-6 + duration / 2.0;
    let collide = |case: &Case, state: &State, angles: &[f64]| {
        let mut found = vec![];
        let mut detector = CollisionDetector::new(|c| {
            found.push(c);
            Ok(())
        });
        let outcome = run_from(case, state, angles, &mut [&mut detector], &mut |_| {
            Control::Continue(())
        })
        .unwrap();
        let during = outcome.end_s;
        detector.close(during).unwrap();
        drop(detector);
        let [collision] = found.as_slice() else {
            panic!("{found:?}")
        };
        (*collision, outcome.state)
    };
    let (state, angles) = approaching(&case, speed);
    let (first, middle) = collide(&case, &state, &angles);
    assert!(
        (first.duration_s / (duration / 2.0) - 1.0).abs() < 1e-4,
        "{first:?}"
    );
    // Half of what an impact exchanges.
    let half = 0.5 * case.bearing.ball_mass_kg() * speed;
    assert!((first.impulse_n_s / half - 1.0).abs() < 1e-3, "{first:?}");
    case.solver.duration_s = 100e-6;
    let (second, _) = collide(&case, &middle, &angles);
    assert_eq!((second.start_s, second.approach_speed_m_s), (0.0, 0.0));
    assert_eq!((second.ball, second.next_ball), (0, 1));
    assert!(
        (second.duration_s / (duration / 2.0) - 1.0).abs() < 1e-3,
        "{second:?}"
    );
    assert!(second.angle_rad.abs() < 1e-6);
}

/// Under the production method an impact returns a little too much or too little energy,
/// depending on where the steps fall; on average nothing. Prints what
/// `docs/theory/integration.md` quotes.
#[test]
fn leapfrog_impacts_keep_their_energy_on_average() {
    let mut case = free_flight();
    case.solver.method = IntegrationMethod::VelocityVerlet;
    let (speed, phases) = (0.1, 64);
    for (step_s, rms_most) in [(2e-6, 7e-4), (1e-6, 1.3e-4)] {
        case.solver.step_s = step_s;
        let errors: Vec<f64> = (0..phases)
            .map(|k| {
                let (mut state, angles) = approaching(&case, speed);
                // A part of a step's way further off.
                let off = 0.5 * speed * step_s * f64::from(k) / f64::from(phases);
                for (k, side) in [(0, -off), (1, off)] {
                    let motion = state.ball_motion(k);
                    let x = motion.x + side;
                    state.set_ball(k, BallMotion { x, ..motion });
                }
                let end = run_from(&case, &state, &angles, &mut [], &mut |_| {
                    Control::Continue(())
                })
                .unwrap()
                .state;
                ((end.vx_m_s()[1] - end.vx_m_s()[0]) / speed).powi(2) - 1.0
            })
            .collect();
        let mean = errors.iter().sum::<f64>() / f64::from(phases);
        let rms = (errors.iter().map(|e| e * e).sum::<f64>() / f64::from(phases)).sqrt();
        println!(
            "{step_s:e} s: energy of the approach returned too much: mean {mean:.1e}, rms {rms:.1e}"
        );
        assert!(rms < rms_most && rms > 1e-6, "{rms:e}");
        assert!(mean.abs() < 0.02 * rms, "{mean:e} {rms:e}");
    }
}

#[test]
fn momentum_is_conserved_to_rounding() {
    let mut case = free_flight();
    case.contact.ball_restitution = 0.7;
    case.contact.friction.coefficient = 0.1;
    let (mut state, angles) = approaching(&case, 0.3);
    // An oblique impact of spinning balls.
    let (rw, y) = (case.bearing.ball_radius_m(), -case.bearing.pitch_radius_m());
    state.set_ball(0, ball(-(rw + 0.5e-6), y, 0.2, 0.05, 900.0));
    let before = state.clone();
    let end = run_from(&case, &state, &angles, &mut [], &mut |_| {
        Control::Continue(())
    })
    .unwrap()
    .state;
    let mass = case.bearing.ball_mass_kg();
    let inertia = case.bearing.ball_inertia_kg_m2();
    let momentum = |s: &State| {
        let sum = |v: &[f64]| v[0] + v[1];
        // Angular momentum about the origin, spins clockwise.
        let angular: f64 = (0..2)
            .map(|k| {
                mass * (s.x_m()[k] * s.vy_m_s()[k] - s.y_m()[k] * s.vx_m_s()[k])
                    - inertia * s.spin_state_rad_s()[k]
            })
            .sum();
        [mass * sum(s.vx_m_s()), mass * sum(s.vy_m_s()), angular]
    };
    let (m0, m1) = (momentum(&before), momentum(&end));
    assert!(
        end.spin_state_rad_s()[0] < 899.0,
        "friction must have acted"
    );
    assert!((m1[0] - m0[0]).abs() < 1e-14 * mass, "{m0:?} {m1:?}");
    assert!((m1[1] - m0[1]).abs() < 1e-14 * mass, "{m0:?} {m1:?}");
    // The lever arm is Rw, not half the distance of the squeezed balls: 1 µm in 5 mm.
    assert!((m1[2] - m0[2]).abs() < 2e-3 * (m0[2] + inertia * 900.0).abs());
}

/// While they slide, friction takes μ·J·R/I from the spins of both balls, J the normal impulse.
#[test]
fn friction_between_balls_has_its_factor() {
    for factor in [0.0, 0.5, 1.0, 3.0] {
        let mut case = free_flight();
        case.contact.friction.coefficient = 0.1;
        case.contact.ball_friction_factor = factor;
        let (mut state, angles) = approaching(&case, 0.3);
        let motion = state.ball_motion(0);
        let spin = 900.0;
        state.set_ball(0, BallMotion { spin, ..motion });
        let end = run_from(&case, &state, &angles, &mut [], &mut |_| {
            Control::Continue(())
        })
        .unwrap()
        .state;
        let impulse = case.bearing.ball_mass_kg() * (motion.vx - end.vx_m_s()[0]);
        let per_impulse = case.bearing.ball_radius_m() / case.bearing.ball_inertia_kg_m2();
        let expected = 0.1 * factor * impulse * per_impulse;
        for (k, before) in [(0, spin), (1, 0.0)] {
            let lost = before - end.spin_state_rad_s()[k];
            assert!(
                (lost - expected).abs() <= 2e-3 * expected,
                "{factor}: ball {k} lost {lost}, not {expected} rad/s"
            );
        }
    }
}

/// The same in space, for sliding in a direction that is neither of the rings' plane nor along the axis: each ball
/// loses 3/5 of the impulse about Z and 4/5 about Y.
#[test]
fn friction_between_balls_has_its_factor_in_space() {
    for factor in [0.0, 0.5, 1.0, 3.0] {
        let mut case = free_flight();
        case.motion = Motion::Space;
        // Grooves so wide that the balls are free in them.
        let mut d = case.bearing.dimensions().clone();
        d.inner_groove_curvature_radius_m = 1.6 * d.ball_radius_m;
        d.outer_groove_curvature_radius_m = 1.6 * d.ball_radius_m;
        case.bearing = Bearing::new(d, steel()).unwrap();
        case.contact.friction.coefficient = 0.1;
        case.contact.ball_friction_factor = factor;
        let (planar, angles) = approaching(&case, 0.3);
        let model = dynamics::Model::new(&case).unwrap();
        let layout = model.layout();
        let mut state = State::zero(layout);
        for k in 0..3 {
            state.set_ball(k, planar.ball_motion(k));
        }
        let motion = planar.ball_motion(0);
        let [spin, omega_y] = [900.0, 1200.0];
        state.set_ball(0, BallMotion { spin, ..motion });
        state.set_ball_in_space(0, 0.0, [0.0, omega_y]);
        let end = run_from(&case, &state, &angles, &mut [], &mut |_| {
            Control::Continue(())
        })
        .unwrap()
        .state;
        let at = |coordinate, k| end.values()[layout.ball(coordinate, k)];
        let mass = case.bearing.ball_mass_kg();
        let impulse = mass * (motion.vx - at(BallCoordinate::Vx, 0));
        assert!(impulse > 0.9 * mass * 0.3, "{impulse:e}");
        let tangential = 0.1 * factor * impulse;
        let turning = tangential * case.bearing.ball_radius_m() / case.bearing.ball_inertia_kg_m2();
        for (what, found, expected) in [
            (
                "spin of the first",
                spin - at(BallCoordinate::Spin, 0),
                0.6 * turning,
            ),
            (
                "spin of the second",
                -at(BallCoordinate::Spin, 1),
                0.6 * turning,
            ),
            (
                "ωy of the first",
                omega_y - at(BallCoordinate::OmegaY, 0),
                0.8 * turning,
            ),
            (
                "ωy of the second",
                -at(BallCoordinate::OmegaY, 1),
                0.8 * turning,
            ),
            (
                "vz of the first",
                mass * at(BallCoordinate::Vz, 0),
                0.8 * tangential,
            ),
            (
                "vz of the second",
                -mass * at(BallCoordinate::Vz, 1),
                0.8 * tangential,
            ),
        ] {
            assert!(
                (found - expected).abs() <= 3e-3 * expected,
                "{factor}: {what}: {found}, not {expected}"
            );
        }
    }
}

/// e is what comes out; the clamp at zero force lets a little more back.
#[test]
fn restitution_is_what_was_asked_for() {
    for (wanted, out) in [(0.95, 0.9505), (0.8, 0.81), (0.5, 0.55)] {
        let mut case = free_flight();
        case.contact.ball_restitution = wanted;
        let speed = 0.1;
        let (_, end) = impact(&case, speed);
        let got = (end.vx_m_s()[1] - end.vx_m_s()[0]) / speed;
        assert!((got - out).abs() < 0.006, "{wanted}: {got}");
        assert!(got >= wanted - 1e-6);
    }
    let mut gentle = free_flight();
    gentle.contact.ball_restitution = 0.95;
    let (_, end) = impact(&gentle, 0.1);
    let got = (end.vx_m_s()[1] - end.vx_m_s()[0]) / 0.1;
    assert!((got - 0.9505).abs() < 1e-4, "{got}");
}

/// A damped contact opens at a force of zero with δ still positive and starts with the
/// infinite slope of δ^(1/4): crossing it by error control keeps the accuracy at large steps.
#[test]
fn damped_impact_converges() {
    let result = |step: f64| {
        let mut case = free_flight();
        case.contact.ball_restitution = 0.8;
        case.solver.step_s = step;
        let (state, _) = approaching(&case, 0.1);
        let model = dynamics::Model::new(&case).unwrap();
        let mut rhs = dynamics::RightHandSide::new(&model);
        let dimension = model.layout().len();
        let mut method = Integrator::new(Abm4::new(dimension, step), dimension);
        method.restart(&mut rhs, 0.0, state.values());
        for _ in 0..(100e-6 / step).round() as u32 {
            method.advance(&mut rhs, f64::INFINITY).unwrap();
        }
        method.step().y1[model.layout().ball(BallCoordinate::Vx, 0)]
    };
    let reference = result(0.0125e-6);
    let (coarse, fine) = (
        (result(1e-6) - reference).abs(),
        (result(0.25e-6) - reference).abs(),
    );
    assert!(coarse < 1e-5, "{coarse:e}");
    // Beside the infinite slope of δ^(1/4) no order holds; the floor is low.
    assert!(fine < 2e-7, "{coarse:e} {fine:e}");
}
