//! Preload by radial interference against closed forms: equal stiffness at both raceways, the
//! interference shared between them.

use std::f64::consts::TAU;

use crate::common::{conventional, dimensions, drop_case, steel, undamped};
use cageless::equilibrium::solve;
use cageless::initial_conditions::initial_state;
use cageless::simulation::{Control, Ending, Observer, ObserverError, StepView, run};
use cageless::step_limits::StepLimits;
use cageless::{
    Bearing, BearingDimensions, Case, Gaps, InputError, IntegrationMethod, Start, StartState,
};

/// K at both raceways, N·m^(−3/2).
const STIFFNESS: f64 = 2.8e10;
const INTERFERENCE_M: f64 = 4e-6;

fn pressed(interference_m: f64) -> BearingDimensions {
    let free = dimensions();
    BearingDimensions {
        inner_groove_bottom_radius_m: free.inner_groove_bottom_radius_m + interference_m,
        ..free
    }
}

/// Unloaded, weightless, with equal stiffness at both raceways.
fn preloaded(rpm: f64) -> Case {
    let mut case = conventional(pressed(INTERFERENCE_M));
    case.contact.inner_stiffness_n_m1_5 = Some(STIFFNESS);
    case.contact.outer_stiffness_n_m1_5 = Some(STIFFNESS);
    case.operation.inner_speed_rad_s = rpm * TAU / 60.0;
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    case
}

/// Force of a ball that shares the interference equally: K (i/2)^(3/2).
fn force_n() -> f64 {
    STIFFNESS * (0.5 * INTERFERENCE_M).powf(1.5)
}

/// Stiffness of the ring on N springs of K in series with K: N/2 · ½ · 3/2 K √(i/2).
fn ring_stiffness_n_m(balls: usize) -> f64 {
    0.5 * balls as f64 * 0.75 * STIFFNESS * (0.5 * INTERFERENCE_M).sqrt()
}

#[test]
fn unloaded_balls_share_the_interference() {
    let case = preloaded(1e-3);
    assert!((case.preload_n() / force_n() - 1.0).abs() < 1e-12);
    let rest = solve(&case).unwrap();
    assert!(rest.ring_x_m.hypot(rest.ring_y_m) < 1e-15);
    for force in rest.inner_force_n.iter().chain(&rest.outer_force_n) {
        assert!((force / force_n() - 1.0).abs() < 1e-9, "{force}");
    }
}

/// K δo^(3/2) − K δi^(3/2) = m v²/|rb| with δi + δo = i, solved by bisection.
#[test]
fn centrifugal_force_moves_the_interference_to_the_outer_raceway() {
    let case = preloaded(12_000.0);
    let (b, rest) = (&case.bearing, solve(&case).unwrap());
    let d = b.dimensions();
    let speed = case.operation.inner_speed_rad_s * d.inner_groove_bottom_radius_m / 2.0;
    let centrifugal = b.ball_mass_kg() * speed * speed / b.pitch_radius_m();
    let (mut low, mut high) = (0.0, INTERFERENCE_M);
    for _ in 0..80 {
        let outer = 0.5 * (low + high);
        let net = STIFFNESS * (outer.powf(1.5) - (INTERFERENCE_M - outer).powf(1.5));
        if net > centrifugal {
            high = outer
        } else {
            low = outer
        }
    }
    let [inner, outer] = [INTERFERENCE_M - low, low].map(|depth| STIFFNESS * depth.powf(1.5));
    assert!(outer - inner > 15.0, "{outer} {inner}");
    for k in 0..b.balls() {
        assert!(
            (rest.outer_force_n[k] / outer - 1.0).abs() < 1e-5,
            "{}",
            rest.outer_force_n[k]
        );
        assert!(
            (rest.inner_force_n[k] / inner - 1.0).abs() < 1e-5,
            "{}",
            rest.inner_force_n[k]
        );
    }
}

/// The geometric stiffness −F/L of the contacts is 2e-4 of it.
#[test]
fn a_small_load_moves_the_ring_as_linear_springs_do() {
    let mut case = preloaded(1e-3);
    let stiffness = ring_stiffness_n_m(case.bearing.balls());
    let unloaded = solve(&case).unwrap().stiffness_n_m.unwrap();
    for (axis, row) in unloaded.iter().enumerate() {
        let ratio = row[axis] / stiffness;
        assert!((ratio - 1.0).abs() < 1e-3, "{unloaded:?}");
    }
    case.operation.radial_load_n = 20.0;
    let rest = solve(&case).unwrap();
    assert!(
        (rest.ring_y_m * stiffness / -20.0 - 1.0).abs() < 2e-3,
        "{:e}",
        rest.ring_y_m
    );
    assert!(
        rest.inner_force_n
            .iter()
            .all(|force| *force > 0.9 * force_n())
    );
}

/// Without load, in any gravity, the middle is found; with less load than a thousandth of the
/// preload the balance is as exact as with more.
#[test]
fn loads_from_nothing_to_far_beyond_the_preload_have_an_equilibrium() {
    for interference in [1e-7, 1e-6, 1e-5, 5e-5] {
        for load in [0.0, 1e-3, 1.0, 100.0, 4000.0] {
            let mut case = conventional(pressed(interference));
            case.operation.radial_load_n = load;
            let e = solve(&case).unwrap_or_else(|error| panic!("{interference} {load}: {error}"));
            let down = load + 0.2 * 9.81;
            let mut held = [0.0; 2];
            for k in 0..14 {
                let (sin, cos) = e.ball_angle_rad[k].sin_cos();
                let [dx, dy] = [
                    e.ball_distance_m[k] * sin - e.ring_x_m,
                    -e.ball_distance_m[k] * cos - e.ring_y_m,
                ];
                held[0] -= e.inner_force_n[k] * dx / dx.hypot(dy);
                held[1] -= e.inner_force_n[k] * dy / dx.hypot(dy);
            }
            let lacks = held[0].hypot(held[1] - down);
            assert!(
                lacks < 1e-6 * (down + 14.0 * case.preload_n()),
                "{interference} {load}: {lacks}"
            );
        }
    }
}

/// Forces at both raceways over a run.
struct Forces {
    least: f64,
    most: f64,
    balls_touch: bool,
}

impl Observer for Forces {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        for k in 0..view.contacts.balls() {
            for force in [
                view.contacts.inner_force_n(k),
                view.contacts.outer_force_n(k),
            ] {
                (self.least, self.most) = (self.least.min(force), self.most.max(force));
            }
        }
        self.balls_touch |= view.contacts.balls_touch();
        Ok(Control::Continue(()))
    }
}

/// Runs the case at its automatic step; the smallest and the largest force of any ball.
fn forces(mut case: Case, duration_s: f64) -> Forces {
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.duration_s = duration_s;
    let mut forces = Forces {
        least: f64::INFINITY,
        most: 0.0,
        balls_touch: false,
    };
    let outcome = run(&case, &mut [&mut forces], &mut |_| Control::Continue(())).unwrap();
    assert!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    let residual = outcome.energy_residual_relative.abs();
    assert!(
        residual < 1e-4,
        "{residual:e} at {:e} s",
        case.solver.step_s
    );
    forces
}

/// Undamped, so that whatever springs at t = 0 goes on.
#[test]
fn no_ball_of_a_lightly_loaded_preloaded_bearing_is_ever_unloaded() {
    let (gaps, lead_ball_angle_rad) = (Gaps::Uniform, 0.1);
    let starts = [
        Start::new(StartState::Settled, gaps.clone(), lead_ball_angle_rad),
        Start::new(
            StartState::Rolling {
                ring_x_m: 0.0,
                ring_y_m: 0.0,
            },
            gaps,
            lead_ball_angle_rad,
        ),
    ];
    for start in starts {
        let mut case = undamped(preloaded(3000.0));
        case.operation.radial_load_n = 20.0;
        case.operation.gravity_m_s2 = 9.81;
        case.start = start;
        let rest = solve(&case).unwrap();
        let both = || rest.inner_force_n.iter().chain(&rest.outer_force_n);
        let least = both().fold(f64::INFINITY, |least, f| f.min(least));
        let most = both().fold(0.0, |most: f64, f| f.max(most));
        let forces = forces(case, 0.05);
        // A ring that starts in the middle swings to twice its displacement.
        assert!(
            forces.least > 0.85 * least && forces.most < 1.15 * most,
            "{} {}",
            forces.least,
            forces.most
        );
    }
}

/// Both raceways press a ball at rest alike, but for its weight.
#[test]
fn a_bearing_at_rest_under_a_rotor_starts_balanced() {
    let mut case = drop_case();
    let bore = case.bearing.inner_ring_bore().unwrap();
    case.bearing = Bearing::new(pressed(INTERFERENCE_M), steel())
        .and_then(|bearing| bearing.with_inner_ring_bore(bore))
        .unwrap();
    let [inner, outer, _] = case.stiffness_n_m1_5();
    let (state, _) = initial_state(&case).unwrap();
    let d = case.bearing.dimensions().clone();
    let weight = case.bearing.ball_mass_kg() * 9.81;
    for k in 0..14 {
        let ball = state.ball_motion(k);
        let distance = ball.x.hypot(ball.y);
        let hertz = |k: f64, depth: f64| k * depth.powf(1.5);
        let at_inner = hertz(
            inner,
            d.inner_groove_bottom_radius_m + d.ball_radius_m - distance,
        );
        let at_outer = hertz(
            outer,
            distance + d.ball_radius_m - d.outer_groove_bottom_radius_m,
        );
        assert!(
            (at_inner - at_outer).abs() < 1.001 * weight,
            "{k}: {at_inner} {at_outer}"
        );
        assert!(
            (at_inner - case.preload_n()).abs() < weight,
            "{k}: {at_inner}"
        );
    }
    // The rotor lands, and the balls stay apart.
    case.rotor.as_mut().unwrap().y_m = -1.9e-4;
    let forces = forces(case, 3e-3);
    assert!(!forces.balls_touch);
}

/// ω² ≥ (ki + ko)/m + N/2 · ki/M with k = 3/2 K √(i/2).
#[test]
fn the_step_follows_the_stiffness_of_the_preload() {
    let case = preloaded(100.0);
    let d = case.bearing.dimensions();
    let slope = 1.5 * STIFFNESS * (0.5 * INTERFERENCE_M).sqrt();
    let least = 2.0 * slope / case.bearing.ball_mass_kg()
        + 0.5 * d.balls as f64 * slope / d.inner_ring_mass_kg;
    let rate = StepLimits::new(&case).contact_rad_s;
    assert!(
        rate > least.sqrt() && rate < 2.0 * least.sqrt(),
        "{rate} {}",
        least.sqrt()
    );
}

/// The limit itself is allowed, and presses the balls with 4200 MPa.
#[test]
fn interference_ends_at_the_pressure_limit_of_iso_76() {
    let most = dimensions().interference_max_m(&steel().into());
    assert!((most - 73.16e-6).abs() < 0.02e-6, "{most:e}"); // Hertz's integrals in another code
    let allowed = Bearing::new(pressed(0.999 * most), steel()).unwrap();
    let force = 6314.5 * 0.999f64.powf(1.5);
    let pressure = allowed.inner_contact().peak_pressure_pa(force);
    assert!((pressure * 1e-6 - 4200.0).abs() < 10.0, "{pressure:e}");
    let InputError { field, allowed, .. } =
        Bearing::new(pressed(1.01 * most), steel()).unwrap_err();
    assert_eq!(field, "ball_radius_m");
    assert!(allowed.to_string().contains("4200 MPa"), "{allowed}");
}
