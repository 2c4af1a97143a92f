//! Implicit friction of the production method: a ball that slips and then rolls, in closed
//! form; dry friction against the explicit reference; ledger; side by side.

use crate::common::{conventional, dimensions, run_from, structure, undamped};
use cageless::ball::{BallMotion, Centre};
use cageless::contact::FrictionTable;
use cageless::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use cageless::dynamics::state::State;
use cageless::dynamics::{Model, RightHandSide};
use cageless::initial_conditions::initial_state;
use cageless::integrator::System;
use cageless::simulation::{Control, Ending, Observer, ObserverError, StepView, run};
use cageless::snapshot::Snapshot;
use cageless::step_limits::StepLimits;
use cageless::{Case, FrictionModel, IntegrationMethod};

/// Three balls in an outer ring without gravity; the inner ring is out of reach.
fn free_balls(law: FrictionModel, step_s: f64) -> Case {
    let mut d = dimensions();
    d.balls = 3;
    d.outer_groove_bottom_radius_m += 1e-3;
    let mut case = undamped(conventional(d));
    case.operation.gravity_m_s2 = 0.0;
    case.operation.radial_load_n = 0.0;
    case.contact.friction_law = law;
    case.contact.friction.coefficient = 0.2;
    case.contact.friction.regularisation_speed_m_s = 1e-4;
    case.contact.damping_n_s_m1_5 = 2e5;
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = step_s;
    case
}

/// State after `duration_s` of a ball that starts at `speed` along the outer raceway without
/// spin, pressed against it by its centrifugal force.
fn slide(case: &Case, speed: f64, duration_s: f64) -> State {
    let bearing = &case.bearing;
    let track = bearing.dimensions().outer_groove_bottom_radius_m - bearing.ball_radius_m();
    let [_, outer, _] = case.stiffness_n_m1_5();
    let force = bearing.ball_mass_kg() * speed * speed / track;
    let distance = track + (force / outer).powf(2.0 / 3.0);
    let mut state = State::new(3);
    let mut angles = vec![];
    // The others stand beyond what the ball travels.
    for (k, angle) in [0.0f64, 3.5, 5.0].into_iter().enumerate() {
        let (sin, cos) = angle.sin_cos();
        let speed = if k == 0 { speed } else { 0.0 };
        let distance = if k == 0 { distance } else { track };
        state.set_ball(
            k,
            BallMotion {
                x: distance * sin,
                y: -distance * cos,
                vx: speed * cos,
                vy: speed * sin,
                spin: 0.0,
            },
        );
        angles.push(angle);
    }
    state.set_ring(Centre::default());
    let mut case = case.clone();
    case.solver.duration_s = duration_s;
    let outcome = run_from(&case, &state, &angles, &mut [], &mut |_| {
        Control::Continue(())
    })
    .unwrap();
    assert!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    outcome.state
}

/// Tangential speed and ΔVo of ball 1.
fn speed_and_slip(case: &Case, state: &State) -> [f64; 2] {
    let polar = state.ball_motion(0).about(&Centre::default());
    let spin = state.ball_motion(0).spin;
    [
        polar.tangential,
        polar.tangential - spin * case.bearing.ball_radius_m(),
    ]
}

/// The factors leave the inner raceway as it is and scale the outer one.
#[test]
fn only_the_outer_raceway_has_its_factor() {
    let friction = |factor: f64| {
        let mut case = structure(5.1, 25.2);
        case.contact.outer_friction_factor = factor;
        case.contact.ball_friction_factor = 7.0;
        let (mut state, _) = initial_state(&case).unwrap();
        let rolling = state.ball_motion(0);
        let spin = 1.2 * rolling.spin;
        state.set_ball(0, BallMotion { spin, ..rolling });
        let model = Model::new(&case).unwrap();
        let mut rhs = RightHandSide::new(&model);
        rhs.derivative(0.0, state.values(), &mut vec![0.0; state.values().len()]);
        let contacts = rhs.contacts();
        [contacts.inner_friction_n(0), contacts.outer_friction_n(0)]
    };
    let ([inner, outer], [same, half]) = (friction(1.0), friction(0.5));
    assert!(inner.abs() > 0.1 && outer.abs() > 0.1, "{inner} {outer}");
    assert_eq!([same, half], [inner, 0.5 * outer]);
}

/// A ball slides at v = v0/(1 + μ·v0·t/ρ), for N = m·v²/ρ, until it rolls at 5/7 of v0 at
/// t = 2ρ/(5μ·v0) (the circular track's counterpart of a sphere on a plane, whose speed falls
/// linearly); from there on it rolls, with Coulomb's law without creep.
#[test]
fn a_ball_slips_then_rolls_at_five_sevenths() {
    let (speed, coefficient) = (2.0, 0.2);
    for (law, factor) in [
        (FrictionModel::Coulomb, 1.0),
        (FrictionModel::Smooth, 1.0),
        (FrictionModel::Coulomb, 0.4),
        (FrictionModel::Smooth, 0.4),
    ] {
        let mut case = free_balls(law, 1e-6);
        case.contact.friction.coefficient = coefficient / factor;
        case.contact.outer_friction_factor = factor;
        let d = case.bearing.dimensions();
        let track = d.outer_groove_bottom_radius_m - case.bearing.ball_radius_m();
        let rolls_s = 0.4 * track / (coefficient * speed);
        let half_s = 0.5 * rolls_s;
        let [v, slip] = speed_and_slip(&case, &slide(&case, speed, half_s));
        let expected = speed / (1.0 + coefficient * speed * half_s / track);
        assert!((v / expected - 1.0).abs() < 2e-4, "{law:?}: {v} {expected}");
        assert!(slip > 0.1);
        let [v, slip] = speed_and_slip(&case, &slide(&case, speed, 1.2 * rolls_s));
        assert!((v / (5.0 / 7.0 * speed) - 1.0).abs() < 2e-4, "{law:?}: {v}");
        let creep = if law == FrictionModel::Coulomb {
            1e-9
        } else {
            1e-6
        };
        assert!(slip.abs() < creep, "{law:?}: creep {slip:e} m/s");
    }
}

/// Means over the time after `from_s`: y of the ring, speed of the balls, their absolute spin.
#[derive(Default)]
struct MeanMotion {
    from_s: f64,
    time_s: f64,
    sums: [f64; 3],
}

impl Observer for MeanMotion {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        if view.step.t0_s >= self.from_s {
            let h = view.step.size_s();
            let balls = view.layout().balls;
            let mean = |of: &dyn Fn(usize) -> f64| (0..balls).map(of).sum::<f64>() / balls as f64;
            let [vx, vy, spin] = [BallCoordinate::Vx, BallCoordinate::Vy, BallCoordinate::Spin]
                .map(|coordinate| view.after(coordinate));
            let values = [
                view.layout().ring_motion(&view.step.y1).y,
                mean(&|k| vx[k].hypot(vy[k])),
                mean(&|k| spin[k]),
            ];
            self.time_s += h;
            for (sum, value) in self.sums.iter_mut().zip(values) {
                *sum += h * value;
            }
        }
        Ok(Control::Continue(()))
    }
}

/// Means over the second half of a run and the relative residual of its energy ledger.
fn means(case: &Case) -> ([f64; 3], f64) {
    let mut motion = MeanMotion {
        from_s: 0.5 * case.solver.duration_s,
        ..MeanMotion::default()
    };
    let outcome = run(case, &mut [&mut motion], &mut |_| Control::Continue(())).unwrap();
    assert!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    let means = motion.sums.map(|sum| sum / motion.time_s);
    (means, outcome.energy_residual_relative)
}

/// Dry friction takes the step of lubricated friction and closes its ledger; the ring stands
/// where the explicit method at a tenth of its stable step puts it.
#[test]
fn dry_friction_takes_the_step_of_the_contacts() {
    let mut case = structure(5.1, 25.2);
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.duration_s = 0.01;
    case.contact.damping_n_s_m1_5 = 2e5;
    let automatic = StepLimits::new(&case).automatic_s(IntegrationMethod::VelocityVerlet);
    for coefficient in [0.1, 0.3] {
        let mut dry = case.clone();
        dry.contact.friction.coefficient = coefficient;
        dry.solver.step_s = StepLimits::new(&dry).automatic_s(IntegrationMethod::VelocityVerlet);
        assert_eq!(dry.solver.step_s, automatic);
        let (implicit, residual) = means(&dry);
        assert!(residual.abs() < 1e-3, "{coefficient}: {residual:e}");
        let mut explicit = dry.clone();
        explicit.solver.method = IntegrationMethod::Adaptive;
        explicit.solver.tolerance = 1e-6;
        let (reference, _) = means(&explicit);
        // The first 10 ms are the same trajectory: 1e-3 µm, 1e-5 of the speeds.
        let tolerances = [1e-9, 1e-4, 0.03];
        for ((a, b), tolerance) in implicit.iter().zip(&reference).zip(tolerances) {
            assert!(
                (a - b).abs() < tolerance,
                "{coefficient}: {implicit:?} {reference:?}"
            );
        }
    }
}

/// However small the slip scale, the step is that of the contacts, and the motion goes over into that
/// of Coulomb's law: the nearer the smaller the scale.
#[test]
fn small_regularisation_speeds_go_over_into_coulombs_law() {
    let mut case = structure(5.1, 25.2);
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.duration_s = 0.01;
    case.contact.friction.coefficient = 0.3;
    case.contact.damping_n_s_m1_5 = 2e5;
    case.contact.friction_law = FrictionModel::Coulomb;
    case.solver.step_s = StepLimits::new(&case).automatic_s(IntegrationMethod::VelocityVerlet);
    let (coulomb, _) = means(&case);
    case.contact.friction_law = FrictionModel::Smooth;
    for (scale, distance_m) in [(0.02, 1e-9), (2e-4, 5e-11), (1e-6, 5e-12)] {
        case.contact.friction.regularisation_speed_m_s = scale;
        let automatic = StepLimits::new(&case).automatic_s(IntegrationMethod::VelocityVerlet);
        assert_eq!(case.solver.step_s, automatic);
        let (smooth, residual) = means(&case);
        assert!(residual.abs() < 1e-4, "{scale}: {residual:e}");
        let distance = (smooth[0] - coulomb[0]).abs();
        assert!(distance < distance_m, "{scale}: {distance:e}");
    }
    case.contact.friction.regularisation_speed_m_s = 0.9e-6;
    assert_eq!(case.check().unwrap_err().field, "regularisation_speed_m_s");
}

/// From 0.2 at rest to 0.1.
fn falling_table() -> FrictionTable {
    FrictionTable::new(vec![[0.0, 0.2], [0.1, 0.14], [0.4, 0.1]]).unwrap()
}

/// A table of the same μ everywhere is the smooth law.
#[test]
fn a_level_table_is_the_smooth_law() {
    let mut case = structure(5.1, 25.2);
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.duration_s = 0.003;
    case.contact.friction.coefficient = 0.1;
    case.solver.step_s = StepLimits::new(&case).automatic_s(IntegrationMethod::VelocityVerlet);
    let end = |case: &Case| run(case, &mut [], &mut |_| Control::Continue(())).unwrap();
    let smooth = end(&case);
    case.contact.friction_law = FrictionModel::Table;
    let level = FrictionTable::new(vec![[0.0, 0.1], [0.2, 0.1], [1.0, 0.1]]);
    case.contact.friction.table = Some(level.unwrap());
    let table = end(&case);
    for ball in 0..14 {
        let (a, b) = (
            smooth.state.ball_motion(ball),
            table.state.ball_motion(ball),
        );
        assert!((a.x - b.x).abs() < 1e-12 && (a.spin - b.spin).abs() < 1e-6);
    }
    case.contact.friction.table = Some(falling_table());
    let falling = end(&case);
    assert!(smooth.state != falling.state);
}

/// μ is that of fast sliding, and what only one law has comes with no other.
#[test]
fn tables_come_with_their_law() {
    let mut case = structure(5.1, 25.2);
    case.contact.friction.coefficient = 0.1;
    case.contact.friction.table = Some(falling_table());
    let field = |case: &Case| case.check().unwrap_err().field;
    assert_eq!(field(&case), "friction_table");
    case.contact.friction_law = FrictionModel::Table;
    assert!(case.check().is_ok());
    case.contact.friction.scale(1.3);
    assert!(case.check().is_ok());
    case.contact.shift_friction(-0.01);
    assert!(case.check().is_ok());
    assert!(
        (case
            .contact
            .friction_law
            .coefficient_max(&case.contact.friction)
            - 0.24)
            .abs()
            < 1e-12
    );
    case.contact.friction.coefficient = 0.007;
    assert_eq!(field(&case), "friction_coefficient");
    case.contact.friction.table = None;
    assert_eq!(field(&case), "friction_table");
}

/// Every law runs in lanes with the bits that it has alone, on every instruction set.
#[test]
fn every_law_is_finite_and_closes_its_ledger() {
    for law in [
        FrictionModel::Smooth,
        FrictionModel::Coulomb,
        FrictionModel::Stribeck,
        FrictionModel::Table,
    ] {
        let mut case = structure(5.1, 25.2);
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.duration_s = 0.005;
        case.contact.friction.coefficient = 0.1;
        case.contact.friction_law = law;
        if law == FrictionModel::Stribeck {
            case.contact.friction.static_coefficient = Some(0.2);
            case.contact.friction.stribeck_speed_m_s = Some(0.1);
        }
        if law == FrictionModel::Table {
            case.contact.friction.table = Some(falling_table());
        }
        case.solver.step_s = StepLimits::new(&case).automatic_s(IntegrationMethod::VelocityVerlet);
        let outcome = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
        assert!(matches!(outcome.ending, Ending::Complete), "{law:?}");
        let residual = outcome.energy_residual_relative;
        assert!(residual.abs() < 1e-3, "{law:?}: {residual:e}");
        let model = Model::new(&case).unwrap();
        let mut rhs = RightHandSide::new(&model);
        let seen = rhs.snapshot(0.0, &outcome.state, &[0.0; 14]);
        assert!(
            seen.inner_sliding_m_s.iter().all(|s| s.is_finite()),
            "{law:?}"
        );
    }
}

/// Rows of a dry run beside the rates that the method steps with.
#[derive(Default)]
struct Rows {
    steps: u64,
    /// Sum of squares of the difference of the ring's acceleration from that of the method, and
    /// of the part that friction has in it, m²/s⁴.
    difference: f64,
    friction: f64,
    /// Contacts under load that stick, and all of them.
    sticking: usize,
    loaded: usize,
}

impl Observer for Rows {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        self.steps += 1;
        if self.steps.is_multiple_of(40) {
            let row = view.snapshot(view.step.t1_s);
            let rate = |c| view.step.f1[view.layout().ring(c)];
            let (x, y) = (rate(RingCoordinate::Vx), rate(RingCoordinate::Vy));
            self.difference += (row.ring.ax_m_s2 - x).powi(2) + (row.ring.ay_m_s2 - y).powi(2);
            let [normal_x, normal_y] = without_friction(&row);
            self.friction +=
                (row.ring.ax_m_s2 - normal_x).powi(2) + (row.ring.ay_m_s2 - normal_y).powi(2);
            let within = view.snapshot(0.5 * (view.step.t0_s + view.step.t1_s));
            for row in [row, within] {
                for (slip, force) in row.inner_sliding_m_s.iter().zip(&row.inner_force_n) {
                    self.loaded += usize::from(*force > 20.0);
                    self.sticking += usize::from(*force > 20.0 && slip.abs() < 1e-10);
                }
            }
        }
        Ok(Control::Continue(()))
    }
}

/// Acceleration of the inner ring of [`conventional`] under all forces but friction, m/s².
fn without_friction(row: &Snapshot) -> [f64; 2] {
    let d = dimensions();
    let (mass, ring) = (d.inner_ring_mass_kg, &row.ring);
    let drag = d.inner_ring_damping_n_s_m / mass;
    let mut sum = [
        -drag * ring.vx_m_s,
        -drag * ring.vy_m_s - 9.81 - 1500.0 / mass,
    ];
    for (k, force) in row.inner_force_n.iter().enumerate() {
        let (x, y) = (row.x_m[k] - ring.x_m, row.y_m[k] - ring.y_m);
        let distance = x.hypot(y);
        sum[0] -= force * x / distance / mass;
        sum[1] -= force * y / distance / mass;
    }
    sum
}

/// Under Coulomb's law rows at the end of a step and within it show what rolls as sticking, with
/// the friction that keeps it so: the ring accelerates as the method has it.
#[test]
fn rows_hold_the_exact_cone() {
    let mut case = structure(5.1, 25.2);
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.duration_s = 0.004;
    case.solver.step_s = 2e-6;
    case.contact.friction.coefficient = 0.1;
    case.contact.friction_law = FrictionModel::Coulomb;
    let mut rows = Rows::default();
    run(&case, &mut [&mut rows], &mut |_| Control::Continue(())).unwrap();
    assert!(rows.loaded > 100, "{}", rows.loaded);
    let (sticking, loaded) = (rows.sticking, rows.loaded);
    assert!(
        sticking as f64 > 0.8 * loaded as f64,
        "{sticking} of {loaded}"
    );
    let share = (rows.difference / rows.friction).sqrt();
    assert!(share < 0.05, "{share} of {}", rows.friction);
}
