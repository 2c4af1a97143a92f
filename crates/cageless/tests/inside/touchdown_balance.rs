//! Balances and symmetries of a drop, in every kind of bearing.

use crate::common::{complete, drop_case, raceway};
use cageless::dynamics::energy::EnergyTerm;
use cageless::dynamics::state::State;
use cageless::dynamics::world::World;
use cageless::dynamics::{Contacts, Model};
use cageless::initial_conditions::initial_state;
use cageless::integrator::System;
use cageless::recorder::Recorder;
use cageless::simulation::{Control, Observer, ObserverError, StepView, run, run_batch};
use cageless::{Case, FrictionModel, IntegrationMethod, Start, StartState, SupportStop};

/// The rotor just above contact with the speed of its fall, over 3 ms, at the automatic step.
fn near_contact(mut case: Case) -> Case {
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s) = (-0.96 * rotor.radial_clearance_m, -0.0625);
    case.solver.duration_s = 3e-3;
    automatic(case)
}

fn automatic(mut case: Case) -> Case {
    case.set_method(IntegrationMethod::VelocityVerlet);
    case
}

fn discrete(case: Case) -> Case {
    let raceway = raceway(&case.bearing, 5.1, 25.2, 0.0);
    case.with_raceways(vec![raceway])
}

/// A drop with everything: unbalance, unequal balls, clearance, a hard stop, drag torque.
fn rough() -> Case {
    let mut case = discrete(drop_case());
    let deviations = (0..14).map(|k| 2e-6 * f64::from(k % 3) - 2e-6).collect();
    case.bearing = case
        .bearing
        .with_ball_radius_deviations(deviations)
        .unwrap();
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.eccentricity_m, rotor.eccentricity_phase_rad) = (5e-6, 0.7);
    rotor.drive_torque_n_m = -2.0;
    rotor.contact_exponent = 1.2;
    rotor.contact_stiffness_n_mp = 1e10;
    case.contact.outer_friction_factor = 0.6;
    case.contact.ball_friction_factor = 0.3;
    case.support.as_mut().unwrap().stop = Some(SupportStop {
        gap_m: 3e-5,
        stiffness_n_m: 1e8,
    });
    case
}

/// The ledgers of bearing and rotor close, whatever the law, the raceway, the
/// balls, the direction of rotation and the mount of the outer ring.
#[test]
fn the_ledger_of_a_drop_closes() {
    let mut cases = vec![];
    for law in [FrictionModel::Smooth, FrictionModel::Coulomb] {
        let mut case = rough();
        case.contact.friction_law = law;
        case.rotor.as_mut().unwrap().friction_law = law;
        cases.push(case);
    }
    let mut backwards = drop_case();
    backwards.rotor.as_mut().unwrap().speed_rad_s *= -1.0;
    backwards.contact.friction.coefficient = 0.3;
    cases.push(backwards);
    let mut fixed = discrete(drop_case());
    fixed.support = None;
    cases.push(fixed);
    for (k, case) in cases.into_iter().enumerate() {
        let case = near_contact(case);
        let outcome = complete(&case);
        let of_rotor = outcome.rotor_energy_residual_relative.unwrap().abs();
        let residual = outcome.energy_residual_relative.abs().max(of_rotor);
        let work = |term| outcome.state.energy_term_j(term);
        println!(
            "case {k}: residual {residual:.1e} at {:e} s",
            case.solver.step_s
        );
        assert!(residual < 1e-4, "case {k}: {residual:e}");
        for loss in [
            EnergyTerm::RotorFriction,
            EnergyTerm::RotorDamping,
            EnergyTerm::InnerFriction,
            EnergyTerm::OuterFriction,
            EnergyTerm::Damping,
        ] {
            assert!(work(loss) > 0.0, "case {k}: {}", loss.name());
        }
        assert_eq!(
            work(EnergyTerm::SupportDamping) > 0.0,
            case.support.is_some()
        );
        let spun = outcome.state.ring_speed_rad_s().unwrap();
        assert!(
            spun * case.rotor.as_ref().unwrap().speed_rad_s > 0.0,
            "{spun}"
        );
    }
}

/// The ledger closes at every instant, also while the outer ring is beyond its stop.
#[test]
fn the_ledger_closes_beyond_the_stop() {
    struct Ledger<'m> {
        model: &'m Model,
        start_energy_j: f64,
        beyond: u32,
        worst: f64,
    }
    impl Observer for Ledger<'_> {
        fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
            let state = view.state(view.step.t1_s);
            let outer = state.outer_ring_motion();
            self.beyond += u32::from(outer.x.hypot(outer.y) > 3.1e-5);
            let balance = self.model.energy_balance(self.start_energy_j, &state);
            // Before the impact hardly any energy flows.
            self.worst = (self.worst).max(balance.residual_j.abs() / balance.flows_j.max(0.01));
            Ok(Control::Continue(()))
        }
    }
    let case = near_contact(rough());
    let model = Model::new(&case).unwrap();
    let (start, _) = initial_state(&case).unwrap();
    let mut ledger = Ledger {
        start_energy_j: model.energy_j(&start),
        model: &model,
        beyond: 0,
        worst: 0.0,
    };
    run(&case, &mut [&mut ledger], &mut |_| Control::Continue(())).unwrap();
    println!(
        "{} steps beyond the stop, {:.1e}",
        ledger.beyond, ledger.worst
    );
    assert!(ledger.beyond > 50, "{}", ledger.beyond);
    assert!(ledger.worst < 1e-4, "{:e}", ledger.worst);
}

/// A flywheel in space: nothing pulls the rotor down, and there is no energy of a fall to compare
/// rounding with. In contact the ledger closes as ever.
#[test]
fn without_gravity_rounding_is_no_energy_from_nowhere() {
    for (vx_m_s, eccentricity_m) in [(0.0, 0.0), (0.0, 5e-6), (0.05, 0.0), (0.3, 5e-6)] {
        let mut case = automatic(drop_case());
        case.operation.gravity_m_s2 = 0.0;
        case.solver.duration_s = 3e-3;
        let rotor = case.rotor.as_mut().unwrap();
        (rotor.vx_m_s, rotor.eccentricity_m) = (vx_m_s, eccentricity_m);
        let outcome = complete(&case);
        let touched = vx_m_s == 0.3;
        let heat = outcome.state.energy_term_j(EnergyTerm::RotorFriction);
        assert_eq!(heat > 0.0, touched, "{vx_m_s}: {heat:e}");
        let residual = outcome.energy_residual_relative.abs();
        assert!(!touched || residual < 1e-4, "{residual:e}");
    }
}

/// Until it touches, the rotor falls freely and everything else stays where it is, but for the
/// weight of balls and ring.
#[test]
fn the_rotor_falls_freely() {
    let mut case = automatic(drop_case());
    case.solver.duration_s = 6e-3;
    let state = complete(&case).state;
    let rotor = state.rotor_motion().unwrap();
    let fallen = 0.5 * 9.81 * case.solver.duration_s.powi(2);
    assert!((rotor.y / -fallen - 1.0).abs() < 1e-9, "{}", rotor.y);
    assert_eq!(rotor.speed, 30_000.0 * std::f64::consts::TAU / 60.0);
    assert!(state.ring_speed_rad_s().unwrap().abs() < 0.1);
}

/// A rotor that turns the other way makes the mirror image.
#[test]
fn mirrored_rotation_mirrors_the_drop() {
    let end = |speed: f64| {
        let mut case = near_contact(drop_case());
        case.rotor.as_mut().unwrap().speed_rad_s *= speed;
        case.solver.duration_s = 1e-3;
        complete(&case).state
    };
    let (one, other) = (end(1.0), end(-1.0));
    let bodies = |s: &State, sign: f64| {
        let (ring, outer, rotor) = (
            s.ring_motion(),
            s.outer_ring_motion(),
            s.rotor_motion().unwrap(),
        );
        [
            sign * ring.x * 1e5,
            ring.y * 1e5,
            sign * outer.x * 1e5,
            outer.y * 1e5,
            sign * rotor.x * 1e5,
            rotor.y * 1e5,
            sign * s.ring_speed_rad_s().unwrap(),
            sign * rotor.speed,
        ]
    };
    for (a, b) in bodies(&one, 1.0).into_iter().zip(bodies(&other, -1.0)) {
        assert!((a - b).abs() < 1e-4, "{a} {b}");
    }
    assert!(one.ring_speed_rad_s().unwrap() > 1.0);
}

/// Drops side by side have the bits of each alone.
#[test]
fn drops_side_by_side_have_their_own_bits() {
    let cases: Vec<Case> = (0..4)
        .map(|k| {
            let mut case = rough();
            let rotor = case.rotor.as_mut().unwrap();
            rotor.friction.coefficient = 0.1 + 0.02 * f64::from(k);
            rotor.eccentricity_phase_rad = f64::from(k);
            let mut case = near_contact(case);
            case.solver.duration_s = 1e-3;
            case.solver.step_s = 1e-6;
            case
        })
        .collect();
    let borrowed: Vec<&Case> = cases.iter().collect();
    let mut observers: Vec<Vec<_>> = cases.iter().map(|_| vec![]).collect();
    let together = run_batch(&borrowed, &mut observers, &mut |_| Control::Continue(()));
    for (case, together) in cases.iter().zip(together) {
        assert_eq!(complete(case).state, together.unwrap().state);
    }
}

/// Snapshots hold the rotor, and a row leads back to its snapshot.
#[test]
fn snapshots_hold_the_rotor() {
    let mut case = near_contact(drop_case());
    case.solver.duration_s = 2e-3;
    let mut rows = vec![];
    let mut recorder = Recorder::new(2e-4, |snapshot| {
        rows.push(snapshot);
        Ok(())
    });
    run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    let weight = 20.0 * 9.81;
    let force = |k: usize| rows[k].rotor.unwrap().contact_force_n;
    assert_eq!((rows.len(), force(0)), (11, 0.0));
    assert!((1..11).any(|k| force(k) > weight), "no impact");
    let last = rows[10].rotor.unwrap();
    assert!(last.ring_speed_rad_s > 1.0 && last.housing_y_m < 0.0);
    for row in &rows {
        assert_eq!(*row, cageless::Snapshot::from_row(&row.to_row()));
    }
}

/// d/dt of the angular momentum of balls, inner ring and rotor about the origin is the moment of
/// the outer raceway and of the weights less Σ depth × friction of the other contacts, whose forces
/// act at the undeformed surfaces.
#[test]
fn angular_momentum_closes() {
    let mut case = near_contact(rough());
    case.contact.friction_law = FrictionModel::Smooth;
    let model = Model::new(&case).unwrap();
    let mut states = vec![];
    let mut recorder = Recorder::new(1.5e-4, |_| Ok(()));
    for duration_s in [3e-4, 8e-4, 1.5e-3, 2.7e-3] {
        case.solver.duration_s = duration_s;
        let outcome = run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
        states.push(outcome.state);
    }
    let (start, _) = initial_state(&case).unwrap();
    states.push(start);
    for state in states {
        let mut world = World::of_bearing(&model);
        let y = world.vector([&state]);
        let mut rate = vec![0.0; y.len()];
        world.derivative(0.0, &y, &mut rate);
        let rates = State::from_vector(world.layout(0), &rate);
        let (change, scale) = angular_momentum_rate(&case, &state, &rates);
        let expected = moments(&case, &state, &world.contacts_of(0));
        println!("dL/dt {change:.9} for {expected:.9} N·m, scale {scale:.1}");
        assert!(
            (change - expected).abs() < 1e-9 * scale,
            "{change} {expected}"
        );
    }
}

/// d/dt of Σ m r × v + spins, and the sum of the absolute parts, N·m. Spins of balls are clockwise.
fn angular_momentum_rate(case: &Case, state: &State, rates: &State) -> (f64, f64) {
    let mut parts = vec![];
    for k in 0..case.bearing.balls() {
        let (ball, at, rate) = (
            case.bearing.ball(k),
            state.ball_motion(k),
            rates.ball_motion(k),
        );
        parts.push(ball.mass_kg * (at.x * rate.vy - at.y * rate.vx));
        parts.push(-ball.inertia_kg_m2 * rate.spin);
    }
    let (ring, rate) = (state.ring_motion(), rates.ring_motion());
    let mass = case.bearing.dimensions().inner_ring_mass_kg;
    parts.push(mass * (ring.x * rate.vy - ring.y * rate.vx));
    let inertia = case.bearing.inner_ring_bore().unwrap().polar_inertia_kg_m2;
    parts.push(inertia * rates.ring_speed_rad_s().unwrap());
    let (rotor, rate) = (state.rotor_motion().unwrap(), rates.rotor_motion().unwrap());
    let body = case.rotor.as_ref().unwrap();
    parts.push(body.mass_kg * (rotor.x * rate.vy - rotor.y * rate.vx));
    parts.push(body.polar_inertia_kg_m2 * rate.speed);
    (parts.iter().sum(), parts.iter().map(|p| p.abs()).sum())
}

/// Moments about the origin of the outer raceway, the weights and the drive, less depth × friction
/// at inner raceway, between balls and at the journal, N·m.
fn moments(case: &Case, state: &State, c: &Contacts<'_>) -> f64 {
    let g = case.operation.gravity_m_s2;
    let model = Model::new(case).unwrap();
    let friction = |slip: f64, normal: f64| {
        normal
            * case.contact.friction.coefficient
            * (slip / case.contact.friction.regularisation_speed_m_s).tanh()
    };
    let outer_ring = state.outer_ring_motion();
    let mut sum = 0.0;
    for k in 0..case.bearing.balls() {
        let (ball, at) = (case.bearing.ball(k), state.ball_motion(k));
        let (x, y) = (at.x - outer_ring.x, at.y - outer_ring.y);
        let distance = x.hypot(y);
        let (ex, ey) = (x / distance, y / distance);
        let radius = c.effective_radius_m(k);
        let outer = c.outer_force_n(k);
        let normal = case.contact.outer_friction_factor * outer * ball.radius_m / radius;
        let rubbing = friction(c.outer_sliding_m_s(k), normal);
        // Force of the raceway: normal, friction, and the tangential part where it rises along ψ.
        let tangential = c.outer_slope_force_n(k) - rubbing;
        let (fx, fy) = (-outer * ex - tangential * ey, -outer * ey + tangential * ex);
        sum += at.x * fy - at.y * fx - radius * rubbing;
        sum -= ball.mass_kg * g * at.x;
        sum -= c.inner_deflection_m(k) * friction(c.inner_sliding_m_s(k), c.inner_force_n(k));
        let next = state.ball_motion((k + 1) % case.bearing.balls());
        let (dx, dy) = (next.x - at.x, next.y - at.y);
        let apart = dx.hypot(dy);
        let (ux, uy) = (dx / apart, dy / apart);
        let slip = (at.vy - next.vy) * ux
            - (at.vx - next.vx) * uy
            - at.spin * ball.radius_m
            - next.spin * case.bearing.ball((k + 1) % case.bearing.balls()).radius_m;
        let depth = model.pair_distance_m(k) - apart;
        if depth > 0.0 {
            let normal = case.contact.ball_friction_factor * c.pair_force_n(k);
            sum -= depth * friction(slip, normal);
        }
    }
    let rotor = case.rotor.as_ref().unwrap();
    sum -= case.bearing.dimensions().inner_ring_mass_kg * g * state.ring_motion().x;
    sum -= rotor.mass_kg * g * state.rotor_motion().unwrap().x;
    let contact = c.rotor().unwrap();
    let depth = contact.contact.deflection.max(0.0);
    sum - depth * contact.friction + rotor.drive_torque_n_m
}

/// What a drop must have and must not have is named.
#[test]
fn impossible_drops_are_named() {
    let refused = |change: &dyn Fn(&mut Case)| {
        let mut case = drop_case();
        change(&mut case);
        cageless::step_limits::check(&case).unwrap_err()
    };
    let field = |change: &dyn Fn(&mut Case)| refused(change).field;
    assert_eq!(
        field(&|c| c.rotor.as_mut().unwrap().radial_clearance_m = 0.0),
        "radial_clearance_m"
    );
    assert_eq!(
        field(&|c| c.rotor.as_mut().unwrap().radial_clearance_m = -1e-4),
        "radial_clearance_m"
    );
    assert_eq!(
        field(&|c| c.rotor.as_mut().unwrap().y_m = -3e-4),
        "rotor_y_m"
    );
    assert_eq!(
        field(&|c| c.rotor.as_mut().unwrap().mass_kg = -1.0),
        "rotor_mass_kg"
    );
    assert_eq!(
        field(&|c| c.rotor.as_mut().unwrap().contact_exponent = 2.0),
        "contact_exponent"
    );
    assert_eq!(
        field(&|c| c.support.as_mut().unwrap().stiffness_n_m = 0.0),
        "support_stiffness_n_m"
    );
    assert_eq!(
        field(&|c| c.operation.inner_speed_rad_s = 100.0),
        "inner_speed_rad_s"
    );
    assert_eq!(
        field(&|c| c.operation.radial_load_n = 100.0),
        "radial_load_n"
    );
    assert_eq!(field(&|c| c.rotor = None), "inner_speed_rad_s");
    assert_eq!(
        field(&|c| c.formulation = cageless::Formulation::Paper),
        "formulation"
    );
    assert_eq!(
        field(&|c| c.start = Start::new(StartState::Settled, cageless::Gaps::Uniform, 0.0)),
        "start_state"
    );
    let without_bore = |c: &mut Case| {
        let d = c.bearing.dimensions().clone();
        c.bearing = cageless::Bearing::new(d, crate::common::steel()).unwrap();
    };
    assert_eq!(field(&without_bore), "inner_ring_polar_inertia_kg_m2");
    assert_eq!(field(&|c| c.solver.step_s = 1e-4), "step_s");
}
