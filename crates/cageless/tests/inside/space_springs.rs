//! Rows whose outer rings slide, pushed by preload springs, in motion.

use std::f64::consts::TAU;

use cageless::ball::AxialMotion;
use cageless::dynamics::coordinates::{
    BallCoordinate, BodyCoordinate, OuterRingCoordinate, RingCoordinate, RotorCoordinate,
    SlidingCoordinate,
};
use cageless::dynamics::state::State;
use cageless::dynamics::world::World;
use cageless::dynamics::{InstructionSet, Model, RightHandSide};
use cageless::equilibrium::space::solve;
use cageless::initial_conditions::initial_state;
use cageless::integrator::{Integrator, System, VelocityVerlet};
use cageless::simulation::{Control, Observer, ObserverError, StepView, run};
use cageless::step_limits::StepLimits;
use cageless::{Bearing, Case, IntegrationMethod, Row, Tilt};

use crate::common::{complete, drop_case, steel, structure};

const FORCE_N: f64 = 300.0;
const MASS_KG: f64 = 0.12;

/// Rows of 15° back to back, the second with a spring, on a plain outer ring.
fn sprung(case: Case) -> Case {
    let mut case = case.conventional();
    case.bearing = case
        .bearing
        .with_contact_angle(15f64.to_radians(), 0.0)
        .unwrap();
    let row = |axial_position_m: f64, contact_sign: f64, preload_n: f64| Row {
        axial_position_m,
        contact_sign,
        preload_n,
        sliding_mass_kg: Some(MASS_KG),
        ..Row::default()
    };
    case.rows = vec![row(-10e-3, 1.0, 0.0), row(10e-3, -1.0, FORCE_N)];
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 1e-6;
    case
}

/// Under a load that leaves no ball without force.
fn running() -> Case {
    let mut case = sprung(structure(5.1, 25.2));
    case.operation.radial_load_n = 200.0;
    case
}

fn sliding(state: &State, coordinate: SlidingCoordinate) -> f64 {
    state.values()[state.layout().sliding(coordinate, 0)]
}

/// Displacement of the ring against its contact sign, its force from the balls, both means over time.
#[derive(Default)]
struct Watch {
    from_s: f64,
    time_s: f64,
    sums: [f64; 3],
    most: [f64; 2],
}

impl Observer for Watch {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        if view.step.t1_s <= self.from_s {
            return Ok(Control::Continue(()));
        }
        let at = view.layout().sliding(SlidingCoordinate::Z, 0);
        let z = view.step.y1[at];
        let h = view.step.size_s();
        let forces = [0, 1].map(|row| view.contacts.row_axial_force_n(row));
        for (sum, value) in self.sums.iter_mut().zip([z, forces[0], forces[1]]) {
            *sum += h * value;
        }
        self.time_s += h;
        self.most = [self.most[0].max(z), self.most[1].max(-z)];
        Ok(Control::Continue(()))
    }
}

fn watched(case: &Case, from_s: f64) -> ([f64; 3], State) {
    let mut watch = Watch {
        from_s,
        ..Watch::default()
    };
    let outcome = run(case, &mut [&mut watch], &mut |_| Control::Continue(())).unwrap();
    (watch.sums.map(|sum| sum / watch.time_s), outcome.state)
}

/// At rest the ring stays where the static equilibrium finds it, and its balls push it with the force of the
/// spring.
#[test]
fn a_sprung_ring_rests_where_the_equilibrium_finds_it() {
    let mut case = running();
    case.operation.inner_speed_rad_s = 10.0;
    case.operation.space.axial_load_n = 80.0;
    case.solver.duration_s = 2e-3;
    let found = solve(&case).unwrap().row_preload_m[1];
    let (start, _) = initial_state(&case).unwrap();
    // Its contact sign is −1: the preload displaces it towards +z.
    assert_eq!(sliding(&start, SlidingCoordinate::Z), found);
    assert!(found > 5e-6, "{found}");
    let ([z, held_n, sprung_n], _) = watched(&case, 0.0);
    assert!((z - found).abs() < 2e-9, "{z:e} {found:e}");
    assert!((sprung_n + FORCE_N).abs() < 0.1, "{sprung_n}");
    assert!((held_n - FORCE_N - 80.0).abs() < 0.1, "{held_n}");
}

/// Over many orbits the mean force of the balls on the ring is that of the spring.
#[test]
fn balls_push_a_sprung_ring_with_the_force_of_its_spring() {
    let mut case = running();
    case.solver.step_s = 2e-6;
    case.solver.duration_s = 0.06;
    let ([z, _, sprung_n], _) = watched(&case, 0.02);
    assert!((sprung_n / FORCE_N + 1.0).abs() < 1e-3, "{sprung_n}");
    let found = solve(&case).unwrap().row_preload_m[1];
    assert!((z / found - 1.0).abs() < 0.05, "{z:e} {found:e}");
}

/// F of a row under an axial displacement δ from where its balls touch: Z K (A (cos α0/cos α − 1))^(3/2) sin α,
/// tan α = tan α0 + δ/(A cos α0) (Harris, Rolling Bearing Analysis).
fn axial_force_n(case: &Case, displacement_m: f64) -> f64 {
    let [inner, outer, _] = case.stiffness_n_m1_5();
    let series = (inner.powf(-2.0 / 3.0) + outer.powf(-2.0 / 3.0)).powf(-1.5);
    let d = case.bearing.dimensions();
    let room = d.inner_groove_curvature_radius_m + d.outer_groove_curvature_radius_m
        - 2.0 * d.ball_radius_m;
    let free = case.bearing.contact_angle_rad();
    let angle = (free.tan() + displacement_m / (room * free.cos())).atan();
    let approach = room * (free.cos() / angle.cos() - 1.0);
    14.0 * series * approach.powf(1.5) * angle.sin()
}

/// Displacement at which a row pushes back with the force of the spring.
fn rest_m(case: &Case) -> f64 {
    let (mut low, mut high) = (0.0, 1e-4);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match axial_force_n(case, middle) < FORCE_N {
            true => low = middle,
            false => high = middle,
        }
    }
    low
}

fn stiffness_n_m(case: &Case, displacement_m: f64) -> f64 {
    let h = 1e-9;
    let [more, less] = [h, -h].map(|by| axial_force_n(case, displacement_m + by));
    (more - less) / (2.0 * h)
}

/// A ring that is pushed off its place oscillates on the axial stiffness of its row.
#[test]
fn a_sprung_ring_oscillates_on_the_stiffness_of_its_row() {
    let mut case = running();
    // Balls without weight beside their ring, an inner ring that stays.
    case.rows[1].sliding_mass_kg = Some(40.0);
    case.rows[1].sliding_damping_n_s_m = Some(0.0);
    let mut d = case.bearing.dimensions().clone();
    (d.inner_ring_mass_kg, d.inner_ring_damping_n_s_m) = (1e6, 0.0);
    case.bearing = Bearing::new(d, steel())
        .and_then(|bearing| bearing.with_contact_angle(15f64.to_radians(), 0.0))
        .unwrap();
    (case.operation.gravity_m_s2, case.operation.radial_load_n) = (0.0, 0.0);
    case.operation.inner_speed_rad_s = 1e-3;
    case.contact.damping_n_s_m1_5 = 0.0;
    case.contact.friction.coefficient = 0.0;
    case.solver.duration_s = 0.02;
    let rest_m = rest_m(&case);
    let expected = (stiffness_n_m(&case, rest_m) / 40.0).sqrt();
    // Both rows are displaced alike by the spring: the ring by twice as much.
    let (start, _) = initial_state(&case).unwrap();
    let at_rest = sliding(&start, SlidingCoordinate::Z);
    assert!(
        (at_rest / (2.0 * rest_m) - 1.0).abs() < 1e-4,
        "{at_rest:e} {rest_m:e}"
    );
    let model = Model::new(&case).unwrap();
    let mut rhs = RightHandSide::new(&model);
    let layout = start.layout();
    let (mut y, at) = (
        start.values().to_vec(),
        layout.sliding(SlidingCoordinate::Z, 0),
    );
    y[at] -= 2e-8;
    let mut integrator = Integrator::new(VelocityVerlet::new(1e-6), y.len());
    integrator.restart(&mut rhs, 0.0, &y);
    let mut crossings = vec![];
    while crossings.len() < 5 {
        integrator.advance(&mut rhs, 0.1).unwrap();
        let step = integrator.step();
        let [before, now] = [step.y0[at], step.y1[at]].map(|z| z - at_rest);
        if before.signum() != now.signum() {
            crossings.push(step.t0_s + step.size_s() * before / (before - now));
        }
        assert!(step.t1_s < 0.1);
    }
    let found = TAU / (0.5 * (crossings[4] - crossings[0]));
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
}

/// A pair under every load whose ring slides in oil, on flat time.
fn loaded(step_s: f64) -> Case {
    let mut case = running();
    case.operation.space.axial_load_n = 100.0;
    case.operation.space.tilt = Tilt::Free {
        moment_x_n_m: 1.0,
        moment_y_n_m: -0.5,
    };
    case.operation.space.inertias_kg_m2 = Some([3e-5, 5.5e-5]);
    case.rows[1].sliding_damping_n_s_m = Some(400.0);
    case.contact.damping_n_s_m1_5 = 0.0;
    case.solver.step_s = step_s;
    case.solver.duration_s = 2e-3;
    case
}

#[test]
fn the_ledger_with_a_sprung_ring_closes_to_second_order() {
    let residual = |step_s: f64| complete(&loaded(step_s)).energy_residual_relative.abs();
    let (coarse, fine) = (residual(2e-6), residual(0.25e-6));
    let order = (coarse / fine).log2() / 3.0;
    assert!(order > 1.6 && fine < 1e-4, "{order} {coarse:e} {fine:e}");
}

#[test]
fn a_sprung_ring_converges_to_second_order() {
    let end = |step_s: f64| sliding(&complete(&loaded(step_s)).state, SlidingCoordinate::Z);
    let [coarse, middle, fine] = [1e-6, 0.5e-6, 0.25e-6].map(end);
    let order = ((coarse - middle) / (middle - fine)).abs().log2();
    assert!(
        (order - 2.0).abs() < 0.4,
        "{order} {coarse:e} {middle:e} {fine:e}"
    );
}

/// A rotor with shoulders that falls on the pair, its outer rings in a housing on a support.
fn dropped(step_s: f64) -> Case {
    let mut case = sprung(drop_case());
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s) = (-0.96 * rotor.radial_clearance_m, -0.05);
    (rotor.axial_clearance_m, rotor.z_m, rotor.vz_m_s) = (Some(1e-4), 0.9e-4, 0.05);
    rotor.axial_load_n = 100.0;
    case.rows[1].sliding_damping_n_s_m = Some(200.0);
    case.solver.step_s = step_s;
    case.solver.duration_s = 1.5e-3;
    case
}

#[test]
fn axial_momentum_of_a_drop_on_springs_changes_by_the_support() {
    let case = dropped(1e-6);
    let state = complete(&case).state;
    let model = Model::new(&case).unwrap();
    let layout = state.layout();
    let mut world = World::of_bearing(&model);
    let y = world.vector([&state]);
    let mut rate = vec![0.0; y.len()];
    world.derivative(0.0, &y, &mut rate);
    let balls: f64 = (0..28)
        .map(|k| rate[layout.ball(BallCoordinate::Vz, k)])
        .sum();
    let [housing, rotor] = [
        BodyCoordinate::from(OuterRingCoordinate::Vz),
        RotorCoordinate::Vz.into(),
    ]
    .map(|c| rate[layout.body(c)]);
    let support = case.support.as_ref().unwrap();
    let d = case.bearing.dimensions();
    let sum = case.bearing.ball_mass_kg() * balls
        + d.inner_ring_mass_kg * rate[layout.ring(RingCoordinate::Vz)]
        + case.rotor.as_ref().unwrap().mass_kg * rotor
        + MASS_KG * rate[layout.sliding(SlidingCoordinate::Vz, 0)]
        + (support.mass_kg - MASS_KG) * housing;
    let AxialMotion { z, vz } = layout.outer_ring_along_axis(state.values());
    let outside = 100.0 - support.stiffness_n_m * z - support.damping_n_s_m * vz;
    assert!(z.abs() > 1e-7 && vz.abs() > 1e-4, "{z:e} {vz:e}");
    assert!((sum - outside).abs() < 1e-8, "{sum} {outside}");
}

#[test]
fn the_ledger_of_a_drop_on_springs_closes_to_second_order() {
    let residual = |step_s: f64| {
        let mut case = dropped(step_s);
        case.contact.damping_n_s_m1_5 = 0.0;
        case.rotor.as_mut().unwrap().contact_damping_s_m = 0.0;
        case.contact.friction.coefficient = 0.01;
        complete(&case).energy_residual_relative.abs()
    };
    let (coarse, fine) = (residual(1e-6), residual(0.25e-6));
    println!("{coarse:e} {fine:e}");
    assert!(
        (coarse / fine).log2() / 2.0 > 1.5 && fine < 1e-4,
        "{coarse:e} {fine:e}"
    );
}

/// Friction across the grooves takes the ring along: explicit and implicit friction agree.
#[test]
fn a_sprung_ring_moves_alike_by_explicit_and_implicit_friction() {
    let end = |method: IntegrationMethod, step_s: f64| {
        let mut case = dropped(step_s);
        case.solver.method = method;
        let state = complete(&case).state;
        let housing = state.layout().outer_ring_along_axis(state.values()).z;
        [sliding(&state, SlidingCoordinate::Z), housing]
    };
    let explicit = end(IntegrationMethod::Abm4, 0.1e-6);
    let [coarse, fine] = [1e-6, 0.25e-6].map(|h| end(IntegrationMethod::VelocityVerlet, h));
    for k in 0..2 {
        let [off, less] = [coarse, fine].map(|end| (end[k] - explicit[k]).abs());
        println!("{off:e} {less:e} {:e}", explicit[k]);
        assert!(less < 0.3 * off && less < 1e-8, "{off:e} {less:e}");
    }
}

/// A sprung pair waits at rest for its rotor.
#[test]
fn a_sprung_pair_waits_at_rest() {
    let mut case = sprung(drop_case());
    case.rotor.as_mut().unwrap().axial_clearance_m = Some(1e-4);
    case.operation.gravity_m_s2 = 1e-3;
    case.solver.duration_s = 1e-3;
    let (start, _) = initial_state(&case).unwrap();
    let end = complete(&case).state;
    let [before, after] = [&start, &end].map(|state| sliding(state, SlidingCoordinate::Z));
    assert!(
        before > 5e-6 && (after - before).abs() < 1e-8,
        "{before:e} {after:e}"
    );
}

#[test]
fn a_housing_lighter_than_its_sprung_rings_is_named() {
    let mut case = dropped(1e-6);
    case.rows[1].sliding_mass_kg = Some(case.support.as_ref().unwrap().mass_kg);
    assert_eq!(case.check().unwrap_err().field, "support_mass_kg");
    for (field, mass, damping) in [
        ("sliding_mass_kg", 0.0, 1.0),
        ("sliding_damping_n_s_m", 0.1, -1.0),
    ] {
        let mut case = dropped(1e-6);
        case.rows[1].sliding_mass_kg = Some(mass);
        case.rows[1].sliding_damping_n_s_m = Some(damping);
        assert_eq!(case.check().unwrap_err().field, field);
    }
}

/// Every instruction set leads to the same bits.
#[test]
fn a_sprung_ring_has_the_same_bits_with_all_instructions() {
    for case in [loaded(1e-6), dropped(1e-6)] {
        let model = Model::new(&case).unwrap();
        let (start, _) = initial_state(&case).unwrap();
        let end = |isa: InstructionSet| {
            let mut rhs = RightHandSide::with_instruction_set(&model, isa);
            let mut integrator = Integrator::new(VelocityVerlet::new(1e-6), start.values().len());
            integrator.restart(&mut rhs, 0.0, start.values());
            for _ in 0..300 {
                integrator.advance(&mut rhs, 1.0).unwrap();
            }
            integrator.step().y1.to_vec()
        };
        let scalar = end(InstructionSet::Baseline);
        let at = start.layout().sliding(SlidingCoordinate::Z, 0);
        assert!(scalar[at] != start.values()[at]);
        for isa in InstructionSet::ALL
            .into_iter()
            .filter(|isa| isa.available())
        {
            assert_eq!(scalar, end(isa), "{isa:?}");
        }
    }
}

/// The rates of a ring under a spring: no slower than it oscillates on its row, as 1/m, and the decay by the
/// damping in its seat.
#[test]
fn the_step_follows_a_light_sprung_ring() {
    let rates = |mass_kg: f64, damping_n_s_m: f64| {
        let mut case = running();
        case.rows[1].sliding_mass_kg = Some(mass_kg);
        case.rows[1].sliding_damping_n_s_m = Some(damping_n_s_m);
        let limits = StepLimits::new(&case);
        (limits.contact_rad_s.powi(2), limits.damping_1_s)
    };
    let (held, held_1_s) = rates(1e9, 0.0);
    let [light, heavy] = [1e-3, 1e-1].map(|mass| rates(mass, 0.0).0 - held);
    assert!(
        (light / heavy / 100.0 - 1.0).abs() < 1e-3,
        "{light} {heavy}"
    );
    let case = running();
    let rest_m = rest_m(&case);
    let ratio = light * 1e-3 / stiffness_n_m(&case, rest_m);
    assert!((1.0..6.0).contains(&ratio), "{ratio}");
    let (_, damped_1_s) = rates(1e9, 1e9);
    assert!(
        (damped_1_s - held_1_s - 1.0).abs() < 1e-6,
        "{damped_1_s} {held_1_s}"
    );
    let automatic = |mass_kg: f64| {
        let mut case = running();
        case.rows[1].sliding_mass_kg = Some(mass_kg);
        StepLimits::new(&case).automatic_s(case.solver.method)
    };
    assert!(automatic(1e-3) < 0.5 * automatic(0.1));
}

/// What moves with its row is at rest to it: contacts are damped and slide by the speed from the ring.
#[test]
fn a_row_that_moves_with_its_ring_is_pressed_as_at_rest() {
    let case = loaded(1e-6);
    let model = Model::new(&Case {
        contact: cageless::Contact {
            damping_n_s_m1_5: 2e5,
            ..case.contact.clone()
        },
        ..case.clone()
    })
    .unwrap();
    let (start, _) = initial_state(&case).unwrap();
    let layout = start.layout();
    let rates = |speed_m_s: f64| {
        let mut y = start.values().to_vec();
        for k in 14..28 {
            y[layout.ball(BallCoordinate::Vz, k)] += speed_m_s;
        }
        y[layout.ring(RingCoordinate::Vz)] += speed_m_s;
        y[layout.sliding(SlidingCoordinate::Vz, 0)] += speed_m_s;
        let mut rates = vec![0.0; y.len()];
        RightHandSide::new(&model).derivative(0.0, &y, &mut rates);
        rates
    };
    let (still, moving) = (rates(0.0), rates(0.05));
    for k in 14..28 {
        for coordinate in [
            BallCoordinate::Vx,
            BallCoordinate::Vy,
            BallCoordinate::Vz,
            BallCoordinate::Spin,
            BallCoordinate::OmegaX,
            BallCoordinate::OmegaY,
        ] {
            let [a, b] = [&still, &moving].map(|rates| rates[layout.ball(coordinate, k)]);
            assert!(
                (a - b).abs() < 1e-6 * (a.abs() + 1.0),
                "{coordinate:?} {k}: {a} {b}"
            );
        }
    }
    // The damping in the seat alone tells them apart.
    let at = layout.sliding(SlidingCoordinate::Vz, 0);
    let braked = (still[at] - moving[at]) * MASS_KG;
    assert!((braked / (400.0 * 0.05) - 1.0).abs() < 1e-6, "{braked}");
}
