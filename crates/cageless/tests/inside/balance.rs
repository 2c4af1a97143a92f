//! The energy ledger, symmetries and determinism of whole runs.

use crate::common::{complete, conventional, dimensions, raceway, structure, undamped};
use cageless::ball::{BallMotion, Centre};
use cageless::dynamics::coordinates::BallCoordinate;
use cageless::dynamics::energy::EnergyTerm;
use cageless::dynamics::state::State;
use cageless::dynamics::{InstructionSet, Model, RightHandSide};
use cageless::equilibrium::EquilibriumError;
use cageless::film::{Film, Oil};
use cageless::initial_conditions::initial_state;
use cageless::integrator::System;
use cageless::simulation::{Cause, Control, Ending, run};
use cageless::{Case, Formulation, FrictionModel, Gaps, Start, StartState};

fn rough_start(case: &mut Case) {
    // One pair close together, so that there are collisions.
    let n = case.bearing.balls();
    let room = n as f64 * case.bearing.nominal_gap_rad();
    let mut gaps = vec![(room - 0.002) / (n - 1) as f64; n];
    gaps[2] = 0.002;
    case.start = Start::new(
        StartState::Rolling {
            ring_x_m: 1e-6,
            ring_y_m: -15e-6,
        },
        Gaps::List(gaps),
        0.3,
    );
}

/// drive + radial load + weight = friction + damping + drag + change of energy.
#[test]
fn the_ledger_closes_in_both_formulations_and_laws() {
    for formulation in [Formulation::Physical, Formulation::Paper] {
        for law in [FrictionModel::Smooth, FrictionModel::Coulomb] {
            let mut case = structure(5.1, 25.2);
            case.formulation = formulation;
            case.contact.friction_law = law;
            let physical = formulation == Formulation::Physical;
            case.film = physical.then(|| Film::flooded(Oil::mineral(5e-3, 0.035)));
            rough_start(&mut case);
            let outcome = complete(&case);
            let residual = outcome.energy_residual_relative.abs();
            assert!(residual < 1e-4, "{formulation:?} {law:?}: {residual:e}");
            let work = |w| outcome.state.energy_term_j(w);
            assert!(work(EnergyTerm::Drive) > 0.0);
            for &loss in EnergyTerm::without_rotor().iter().filter(|w| w.is_loss()) {
                if !physical && loss == EnergyTerm::RollingResistance {
                    continue;
                }
                assert!(
                    work(loss) > 0.0,
                    "{formulation:?}: {} {}",
                    loss.name(),
                    work(loss)
                );
            }
            let extra = [
                EnergyTerm::Centrifugal,
                EnergyTerm::FrictionDirection,
                EnergyTerm::RelativeSpin,
            ]
            .map(work);
            match formulation {
                Formulation::Physical => assert_eq!(extra, [0.0; 3]),
                Formulation::Paper => assert!(extra.iter().all(|w| *w != 0.0), "{extra:?}"),
            }
        }
    }
}

/// Without friction, damping, drag and drive nothing is lost: the energy itself stays.
#[test]
fn a_lossless_bearing_keeps_its_energy() {
    let mut d = dimensions();
    d.inner_ring_damping_n_s_m = 0.0;
    let mut case = undamped(conventional(d));
    case.contact.friction.coefficient = 0.0;
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    rough_start(&mut case);
    case.solver.step_s = 0.1e-6;
    case.solver.duration_s = 0.005;
    let outcome = complete(&case);
    let change = outcome.end_energy_j / outcome.start_energy_j - 1.0;
    assert!(change.abs() < 1e-7, "{change:e}");
}

/// Nothing distinguishes a direction when there is neither load nor weight: turning the
/// start and the raceway turns the motion.
#[test]
fn turning_the_bearing_turns_the_motion() {
    for formulation in [Formulation::Physical, Formulation::Paper] {
        let states = [0.0f64, 77.0].map(|turn| {
            let mut case = undamped(structure(5.4, 18.167));
            case.formulation = formulation;
            case.operation.radial_load_n = 0.0;
            case.operation.gravity_m_s2 = 0.0;
            let raceway = raceway(&case.bearing, 5.4, 18.167, turn);
            case = case.with_raceways(vec![raceway]);
            case.start = Start::new(
                StartState::Rolling {
                    ring_x_m: 0.0,
                    ring_y_m: 0.0,
                },
                Gaps::Uniform,
                0.2 + turn.to_radians(),
            );
            case.solver.duration_s = 0.001;
            (complete(&case).state, turn.to_radians())
        });
        let (plain, turned) = (&states[0].0, &states[1].0);
        let (sin, cos) = states[1].1.sin_cos();
        for k in 0..14 {
            let (x, y) = (plain.x_m()[k], plain.y_m()[k]);
            assert!(
                (turned.x_m()[k] - (x * cos - y * sin)).abs() < 1e-12,
                "{formulation:?} {k}"
            );
            let (vx, vy) = (plain.vx_m_s()[k], plain.vy_m_s()[k]);
            assert!((turned.vy_m_s()[k] - (vx * sin + vy * cos)).abs() < 1e-8);
            let spin = turned.spin_state_rad_s()[k] - plain.spin_state_rad_s()[k];
            assert!(spin.abs() < 1e-6, "{spin:e}");
        }
    }
}

/// A conventional bearing without load rolls on as it was started: no slip, no torque.
#[test]
fn pure_rolling_stays_pure_rolling() {
    let mut case = conventional(dimensions());
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    let (state, _) = initial_state(&case).unwrap();
    let model = Model::new(&case).unwrap();
    let mut rhs = RightHandSide::new(&model);
    let mut rate = vec![0.0; model.layout().len()];
    rhs.derivative(0.0, state.values(), &mut rate);
    let contacts = rhs.contacts();
    for k in 0..14 {
        assert!(contacts.inner_sliding_m_s(k).abs() < 1e-12);
        assert!(contacts.outer_sliding_m_s(k).abs() < 1e-12);
    }
    let end = complete(&case).state;
    for (before, after) in state.spin_state_rad_s().iter().zip(end.spin_state_rad_s()) {
        assert!((before - after).abs() < 1e-6 * before);
    }
}

/// Every instruction set and every amount of padding gives the same bits.
#[test]
fn instruction_sets_agree_to_the_bit() {
    for balls in [3, 8, 14] {
        for formulation in [Formulation::Physical, Formulation::Paper] {
            for law in [FrictionModel::Smooth, FrictionModel::Coulomb] {
                let mut d = dimensions();
                d.balls = balls;
                let mut case = conventional(d);
                let raceway = raceway(&case.bearing, 5.1, 25.2, 10.0);
                case = case.with_raceways(vec![raceway]);
                case.formulation = formulation;
                case.contact.friction_law = law;
                rough_start(&mut case);
                // Three balls carry more each, and friction holds them harder.
                case.solver.step_s = 0.1e-6;
                let (mut state, _) = initial_state(&case).unwrap();
                // Pressed together, so that every contact has something to compute.
                state.set_ring(Centre {
                    vx: 0.1,
                    vy: -0.2,
                    ..state.ring_motion()
                });
                let model = Model::new(&case).unwrap();
                let evaluate = |isa| {
                    let mut rate = vec![0.0; model.layout().len()];
                    RightHandSide::with_instruction_set(&model, isa).derivative(
                        0.0,
                        state.values(),
                        &mut rate,
                    );
                    rate
                };
                let scalar = evaluate(InstructionSet::Baseline);
                assert!(scalar.iter().all(|v| v.is_finite()));
                for isa in [InstructionSet::Avx2, InstructionSet::Avx512] {
                    if isa <= InstructionSet::detect() {
                        assert_eq!(scalar, evaluate(isa), "{isa:?}");
                    } else {
                        println!("{isa:?} skipped: this processor lacks it");
                    }
                }
                // Padding balls stay where they are.
                let layout = model.layout();
                for k in balls..layout.stride {
                    for coordinate in BallCoordinate::ALL {
                        assert_eq!(scalar[layout.array(coordinate) + k], 0.0);
                    }
                }
            }
        }
    }
}

/// Large bearings work, too.
#[test]
fn two_hundred_balls() {
    let mut d = dimensions();
    d.balls = 200;
    let pitch = d.ball_radius_m / (std::f64::consts::PI / 201.0).sin();
    d.inner_groove_bottom_radius_m = pitch - d.ball_radius_m;
    d.outer_groove_bottom_radius_m = pitch + d.ball_radius_m;
    d.outer_shoulder_radius_m = d.outer_groove_bottom_radius_m - 1e-3;
    let mut case = conventional(d);
    case.operation.inner_speed_rad_s = 100.0;
    case.solver.duration_s = 0.002;
    let outcome = complete(&case);
    assert!(outcome.energy_residual_relative.abs() < 1e-3);
}

/// Sustained rolling under Coulomb friction: the force lies within the cone and is
/// steady, and the creep that replaces stick is proportional to the step.
#[test]
fn coulomb_friction_sticks() {
    let spread = |step: f64| {
        let mut case = conventional(dimensions());
        case.contact.friction_law = FrictionModel::Coulomb;
        case.solver.step_s = step;
        case.solver.duration_s = 0.01;
        let end = complete(&case).state;
        let model = Model::new(&case).unwrap();
        let mut rhs = RightHandSide::new(&model);
        let snapshot = rhs.snapshot(0.0, &end, &[0.0; 14]);
        // The most loaded ball rolls.
        let k = (0..14)
            .max_by(|a, b| snapshot.inner_force_n[*a].total_cmp(&snapshot.inner_force_n[*b]))
            .unwrap();
        (
            snapshot.inner_sliding_m_s[k].abs(),
            snapshot.outer_sliding_m_s[k].abs(),
        )
    };
    let (coarse, fine) = (spread(1e-6), spread(0.25e-6));
    assert!(coarse.0 < 2e-3 && coarse.1 < 2e-3, "{coarse:?}");
    assert!(
        fine.0 < 0.5 * coarse.0 || fine.0 < 1e-6,
        "{coarse:?} {fine:?}"
    );
}

/// The undamped bearing at too large a step gains energy; the run says so and stops.
#[test]
fn a_run_that_explodes_is_stopped() {
    let mut case = undamped(structure(5.1, 25.2));
    case.solver.step_s = 2e-6;
    case.solver.duration_s = 2.0;
    let outcome = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
    let Ending::Stopped(stop) = outcome.ending else {
        panic!("{:?}", outcome.ending)
    };
    assert!(stop.time_s < 1.5, "{stop:?}");
    assert!(
        matches!(stop.cause, Cause::EnergyFromNowhere { .. }),
        "{stop:?}"
    );
    assert!(stop.advice().contains("CaseBuilder::step_s"));
    assert!((outcome.end_s - stop.time_s).abs() < 1e-9);
    assert!(outcome.state.values().iter().all(|v| v.is_finite()));
}

/// A ring put where it presses the balls through the outer ring.
#[test]
fn parts_pressed_through_each_other_stop_the_run() {
    let mut case = structure(5.1, 25.2);
    rough_start(&mut case);
    if let StartState::Rolling { ring_y_m, .. } = &mut case.start.state {
        *ring_y_m = -0.45e-3;
    }
    // The overlap counts among the forces that limit the step.
    case.solver.step_s = 0.5e-6;
    let outcome = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
    assert!(
        matches!(&outcome.ending, Ending::Stopped(stop) if stop.time_s < 1e-4),
        "{:?}",
        outcome.ending
    );
}

/// The last step is as short as it takes; a whole number of steps has no rest.
#[test]
fn a_duration_that_is_no_multiple_of_the_step_is_met_exactly() {
    let mut case = structure(5.1, 25.2);
    case.solver.duration_s = 0.001_000_37;
    let outcome = complete(&case);
    assert!((outcome.end_s - case.solver.duration_s).abs() < 1e-15);
    case.solver.duration_s = 0.3e-3;
    assert_eq!(complete(&case).steps, 300);
}

#[test]
fn the_caller_can_interrupt() {
    let case = structure(5.1, 25.2);
    let outcome = run(&case, &mut [], &mut |time_s| match time_s > 0.0 {
        true => Control::Break(()),
        false => Control::Continue(()),
    });
    let outcome = outcome.unwrap();
    assert!(matches!(outcome.ending, Ending::Interrupted));
    assert!(outcome.end_s < 0.002 && outcome.end_s > 0.0);
    // While the start is sought there is no outcome yet.
    let start = run(&case, &mut [], &mut |_| Control::Break(()));
    assert_eq!(start.unwrap_err(), EquilibriumError::Interrupted);
}

/// `State` round-trips what it was given.
#[test]
fn state_keeps_what_it_is_given() {
    let mut state = State::new(5);
    let ball = BallMotion {
        x: 1.0,
        y: 2.0,
        vx: 3.0,
        vy: 4.0,
        spin: 5.0,
    };
    let ring = Centre {
        x: 6.0,
        y: 7.0,
        vx: 8.0,
        vy: 9.0,
    };
    state.set_ball(3, ball);
    state.set_ring(ring);
    assert_eq!((state.x_m()[3], state.vy_m_s()[3]), (1.0, 4.0));
    assert_eq!(state.spin_state_rad_s()[3], 5.0);
    assert_eq!((state.ball_motion(3), state.ring_motion()), (ball, ring));
}
