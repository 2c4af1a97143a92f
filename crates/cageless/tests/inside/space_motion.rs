//! Motion in space against the plane, closed forms and the lags of an independent prototype.

use std::f64::consts::TAU;

use cageless::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use cageless::dynamics::state::State;
use cageless::dynamics::{Model, RightHandSide};
use cageless::initial_conditions::initial_state;
use cageless::passage::{PassageRecorder, PassageTally};
use cageless::simulation::{Control, Ending, run};
use cageless::summary::SummaryRecorder;
use cageless::{
    Bearing, BearingDimensions, Case, Gaps, IntegrationMethod, Motion, Start, StartState, Tilt,
};

use crate::common::{complete, conventional, dimensions, raceway, run_from, steel, structure};

fn in_space(mut case: Case) -> Case {
    case.motion = Motion::Space;
    case
}

/// Without axial load, tilt and raceway every operation of the plane is one in space with zeros.
#[test]
fn a_plain_ring_moves_in_space_as_in_the_plane() {
    // More balls than a block has lanes.
    let large = BearingDimensions {
        balls: 21,
        inner_groove_bottom_radius_m: 29.7375e-3,
        outer_groove_bottom_radius_m: 39.2625e-3,
        outer_shoulder_radius_m: 37.5e-3,
        ..dimensions()
    };
    // The implicit friction of the two is iterated apart.
    for (method, factor, dimensions) in [
        (IntegrationMethod::VelocityVerlet, 100.0, dimensions()),
        (IntegrationMethod::Abm4, 1e-2, dimensions()),
        (IntegrationMethod::Abm4, 1.0, large.clone()),
        (IntegrationMethod::VelocityVerlet, 1000.0, large),
    ] {
        let mut planar = conventional(dimensions);
        // No key of the contacts has its default, and no two balls are alike.
        planar.contact.outer_friction_factor = 0.6;
        planar.contact.ball_friction_factor = 2.5;
        planar.contact.ball_restitution = 0.8;
        planar.contact.damping_n_s_m1_5 = 3e5;
        planar.operation.gravity_m_s2 = 15.0;
        let deviations = (0..planar.bearing.balls()).map(|k| 1e-7 * ((k * 5 % 7) as f64 - 3.0));
        let deviations = deviations.collect();
        planar.bearing = (planar.bearing.with_ball_radius_deviations(deviations)).unwrap();
        planar.solver.method = method;
        planar.solver.duration_s = 2e-3;
        // Balls bounce, and damping counts.
        planar.start = Start::new(
            StartState::Rolling {
                ring_x_m: 0.0,
                ring_y_m: -15e-6,
            },
            Gaps::Uniform,
            0.0,
        );
        let (flat, spatial) = (complete(&planar), complete(&in_space(planar.clone())));
        for k in 0..planar.bearing.balls() {
            let (a, b) = (flat.state.ball_motion(k), spatial.state.ball_motion(k));
            for (x, y, scale) in [
                (a.x, b.x, 1e-11),
                (a.y, b.y, 1e-11),
                (a.vx, b.vx, 1e-7),
                (a.vy, b.vy, 1e-7),
                (a.spin, b.spin, 1e-4),
            ] {
                assert!((x - y).abs() < factor * scale, "{method:?} {k}: {x} {y}");
            }
            let z = spatial.state.layout().ball(BallCoordinate::Z, k);
            assert_eq!(spatial.state.values()[z], 0.0);
        }
    }
}

/// Mean lag per pass between 60 and 120 ms of structure (d) at 12 000 rpm under 1500 N, degrees.
fn lag_deg(case: &mut Case) -> f64 {
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 2e-6;
    case.solver.duration_s = 0.12;
    let mut tally = PassageTally::new();
    let mut recorder = PassageRecorder::new(|passage| {
        if passage.enter_s > 0.06 {
            tally.add(&passage);
        }
        Ok(())
    });
    let outcome = run(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    assert!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    tally.means().lag_rad.to_degrees()
}

/// Lags that a program written apart from this one found: in the plane, and in space under
/// an axial load with one strip and with nine.
#[test]
fn lags_are_those_of_an_independent_program() {
    let mut planar = structure(5.1, 25.2);
    assert!((lag_deg(&mut planar) - 2.290).abs() < 2e-3);
    for (axial_n, strips, friction, expected) in [
        (0.0, 1, 0.007, 1.935),
        (750.0, 1, 0.007, 0.451),
        (150.0, 9, 0.007, 1.763),
        (0.0, 1, 0.1, 2.12),
    ] {
        let mut case = in_space(structure(5.1, 25.2));
        case.operation.space.axial_load_n = axial_n;
        case.contact.friction_strips = strips;
        case.contact.friction.coefficient = friction;
        let lag = lag_deg(&mut case);
        assert!((lag - expected).abs() < 5e-3, "{axial_n} {strips}: {lag}");
    }
}

/// Structure (d) under an axial load of a tenth of the radial one.
fn loaded(method: IntegrationMethod, step_s: f64) -> Case {
    let mut case = structure(5.1, 25.2);
    case.operation.space.axial_load_n = 150.0;
    case.solver.method = method;
    case.solver.step_s = step_s;
    case.solver.tolerance = 1e-10;
    case
}

/// Values of all coordinates of the motion, each with its sign under z → −z.
fn mirrored(state: &State) -> Vec<[f64; 2]> {
    let (layout, y) = (state.layout(), state.values());
    let of_balls = BallCoordinate::IN_SPACE.into_iter().flat_map(|coordinate| {
        let sign = match coordinate {
            BallCoordinate::Z
            | BallCoordinate::Vz
            | BallCoordinate::OmegaX
            | BallCoordinate::OmegaY => -1.0,
            _ => 1.0,
        };
        (0..layout.balls).map(move |k| [sign, y[layout.ball(coordinate, k)]])
    });
    let ring = [
        (RingCoordinate::X, 1.0),
        (RingCoordinate::Y, 1.0),
        (RingCoordinate::Z, -1.0),
        (RingCoordinate::Vx, 1.0),
        (RingCoordinate::Vy, 1.0),
        (RingCoordinate::Vz, -1.0),
    ];
    let of_ring = ring.map(|(coordinate, sign)| [sign, y[layout.ring(coordinate)]]);
    of_balls.chain(of_ring).collect()
}

/// An axial load and a tilt the other way mirror the motion.
#[test]
fn the_other_way_is_the_mirror_image() {
    let after = |sign: f64| {
        let mut case = loaded(IntegrationMethod::VelocityVerlet, 2e-6);
        case.solver.duration_s = 4e-3;
        case.operation.space.axial_load_n *= sign;
        case.operation.space.tilt = Tilt::Held {
            x_rad: 5e-4 * sign,
            y_rad: -3e-4 * sign,
        };
        mirrored(&complete(&case).state)
    };
    let largest = after(1.0)
        .iter()
        .zip(after(-1.0))
        .fold(0.0, |most: f64, (a, b)| {
            assert!(a[1] == 0.0 || (a[1] - a[0] * b[1]).abs() < 1e-7 * (1.0 + a[1].abs()));
            most.max(if a[0] < 0.0 { a[1].abs() } else { 0.0 })
        });
    assert!(largest > 1.0);
}

/// Without load along Y everything turns with the raceway and the balls.
#[test]
fn a_turned_ring_moves_as_before() {
    let turn = 0.7;
    let after = |angle: f64| {
        let mut case = loaded(IntegrationMethod::VelocityVerlet, 2e-6);
        case.operation.radial_load_n = 0.0;
        case.operation.gravity_m_s2 = 0.0;
        case.operation.space.axial_load_n = 800.0;
        case.raceways = vec![raceway(&case.bearing, 5.1, 25.2, angle.to_degrees())];
        case.start = Start::new(StartState::Settled, Gaps::Uniform, angle);
        case.solver.duration_s = 2e-3;
        complete(&case).state
    };
    let (still, turned) = (after(0.0), after(turn));
    let (sin, cos) = turn.sin_cos();
    for k in 0..14 {
        let (a, b) = (still.ball_motion(k), turned.ball_motion(k));
        let z = |state: &State| state.values()[state.layout().ball(BallCoordinate::Z, k)];
        assert!((a.x * cos - a.y * sin - b.x).abs() < 1e-9);
        assert!((a.x * sin + a.y * cos - b.y).abs() < 1e-9);
        assert!((z(&still) - z(&turned)).abs() < 1e-9 && z(&still) > 1e-6);
    }
}

/// Largest residual of the ledger over the flows, of a ring whose tilt is held or free.
fn residual(step_s: f64, tilt: Tilt) -> f64 {
    let mut case = loaded(IntegrationMethod::VelocityVerlet, step_s);
    case.raceways = vec![];
    case.contact.friction_strips = 3;
    case.contact.damping_n_s_m1_5 = 0.0;
    case.operation.space.tilt = tilt;
    case.operation.space.inertias_kg_m2 = Some([3e-5, 5.5e-5]);
    case.solver.duration_s = 5e-3;
    complete(&case).energy_residual_relative.abs()
}

/// Damping acts along the approach, which changes as a ball moves through a raceway, flush or deep.
#[test]
fn the_ledger_closes_in_a_damped_raceway() {
    let residual = |depth_m, step_s| {
        let mut case = in_space(loaded(IntegrationMethod::VelocityVerlet, step_s));
        case.raceways = vec![case.raceways[0].clone().with_depth(depth_m).unwrap()];
        case.operation.space.axial_load_n = 0.0;
        case.contact.damping_n_s_m1_5 = 2e6;
        case.contact.friction.coefficient = 0.0;
        case.solver.duration_s = 5e-3;
        complete(&case).energy_residual_relative.abs()
    };
    for depth_m in [0.0, 5e-6] {
        let order = (residual(depth_m, 0.28e-6) / residual(depth_m, 0.07e-6)).log2() / 2.0;
        assert!((order - 2.0).abs() < 0.1, "{depth_m:e}: {order}");
    }
}

/// What the ledger misses shrinks with the square of the step, with spin, tilt and gyroscopic moments.
#[test]
fn the_ledger_closes_to_second_order() {
    let free = Tilt::Free {
        moment_x_n_m: 0.2,
        moment_y_n_m: -0.1,
    };
    let held = Tilt::Held {
        x_rad: 1e-3,
        y_rad: 0.0,
    };
    for tilt in [held, free] {
        let order = (residual(4e-6, tilt) / residual(0.25e-6, tilt)).log2() / 4.0;
        assert!(order > 1.6, "{tilt:?}: {order}");
    }
}

/// Verlet approaches the adaptive method to second order.
#[test]
fn the_production_method_is_of_second_order() {
    let after = |method, step_s| {
        let mut case = loaded(method, step_s);
        case.solver.duration_s = 1e-3;
        let state = complete(&case).state;
        mirrored(&state)
            .into_iter()
            .map(|[_, value]| value)
            .collect::<Vec<f64>>()
    };
    let reference = after(IntegrationMethod::Adaptive, 1e-6);
    let error = |step_s| {
        let values = after(IntegrationMethod::VelocityVerlet, step_s);
        // Places of the balls.
        let pairs = values.iter().zip(&reference).take(28);
        pairs.map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    let order = (error(2e-6) / error(0.5e-6)).log2() / 2.0;
    assert!((1.6..2.6).contains(&order), "{order}");
}

/// Force on all bodies: loads, weights, drag and the reaction of the outer ring.
#[test]
fn linear_momentum_changes_by_outer_forces() {
    let mut case = loaded(IntegrationMethod::Abm4, 1e-6);
    case.solver.duration_s = 3e-3;
    let state = complete(&case).state;
    let model = Model::new(&case).unwrap();
    let mut rhs = RightHandSide::new(&model);
    let mut rate = vec![0.0; state.layout().len()];
    cageless::integrator::System::derivative(&mut rhs, 0.0, state.values(), &mut rate);
    let layout = state.layout();
    let (ball, ring) = (
        case.bearing.ball_mass_kg(),
        case.bearing.dimensions().inner_ring_mass_kg,
    );
    let sum = |of_ball: BallCoordinate, of_ring: RingCoordinate| {
        let balls: f64 = (0..14).map(|k| rate[layout.ball(of_ball, k)]).sum();
        ball * balls + ring * rate[layout.ring(of_ring)]
    };
    let drag = |coordinate| 2000.0 * state.values()[layout.ring(coordinate)];
    let [x, y] = rhs.contacts().outer_ring_force_n();
    let weight = 9.81 * (14.0 * ball + ring);
    let along_x = sum(BallCoordinate::Vx, RingCoordinate::Vx) + x + drag(RingCoordinate::Vx);
    let along_y = sum(BallCoordinate::Vy, RingCoordinate::Vy) + y + drag(RingCoordinate::Vy);
    assert!(along_x.abs() < 1e-9, "{along_x}");
    assert!((along_y + 1500.0 + weight).abs() < 1e-9, "{along_y}");
}

/// A ring that nothing touches is a symmetric top: its axis turns about L = It a × ȧ + Ip ωi a at |L|/It.
#[test]
fn a_free_ring_is_a_symmetric_top() {
    let d = BearingDimensions {
        inner_groove_bottom_radius_m: 18e-3,
        inner_ring_damping_n_s_m: 0.0,
        ..dimensions()
    };
    let mut case = conventional(dimensions());
    case.bearing = Bearing::new(d, steel()).unwrap();
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    case.operation.space.tilt = Tilt::Free {
        moment_x_n_m: 0.0,
        moment_y_n_m: 0.0,
    };
    let [transverse, polar] = [3e-5, 5.5e-5];
    case.operation.space.inertias_kg_m2 = Some([transverse, polar]);
    case.start = Start::new(
        StartState::Rolling {
            ring_x_m: 0.0,
            ring_y_m: 0.0,
        },
        Gaps::Uniform,
        0.0,
    );
    case.solver.method = IntegrationMethod::Adaptive;
    case.solver.tolerance = 1e-11;
    let (mut state, angles) = initial_state(&case).unwrap();
    let (p, rate) = (4e-3, 8.0);
    let layout = state.layout();
    state.values_mut()[layout.ring(RingCoordinate::TiltP)] = p;
    state.values_mut()[layout.ring(RingCoordinate::TiltQRate)] = rate;
    // a × ȧ and a, in the frame of L.
    let speed = case.operation.inner_speed_rad_s;
    let height = (1.0 - p * p).sqrt();
    let axis = nalgebra::Vector3::new(p, 0.0, height);
    let moving = nalgebra::Vector3::new(0.0, rate, 0.0);
    let spin = axis.cross(&moving) * transverse + axis * (polar * speed);
    let turning = spin.norm() / transverse;
    let steady = spin.normalize();
    case.solver.duration_s = 0.77 * TAU / turning;
    let mut control = |_| Control::Continue(());
    let outcome = run_from(&case, &state, &angles, &mut [], &mut control).unwrap();
    let angle = turning * case.solver.duration_s;
    let along = steady * steady.dot(&axis);
    let expected = along + (axis - along) * angle.cos() + steady.cross(&axis) * angle.sin();
    let end = outcome.state.values();
    for (coordinate, expected) in [
        (RingCoordinate::TiltP, expected.x),
        (RingCoordinate::TiltQ, expected.y),
    ] {
        let found = end[layout.ring(coordinate)];
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
    assert!(expected.x.hypot(expected.y) > 1e-3);
}

/// A settled start under load and tilt stays: the ring's centre does not move.
#[test]
fn a_settled_start_in_space_stays() {
    let mut case = loaded(IntegrationMethod::VelocityVerlet, 1e-6);
    case.raceways = vec![];
    case.operation.space.tilt = Tilt::Held {
        x_rad: 5e-4,
        y_rad: 5e-4,
    };
    // Slow balls hardly bounce as they orbit.
    case.operation.inner_speed_rad_s = 10.0;
    case.solver.duration_s = 1e-3;
    let (start, _) = initial_state(&case).unwrap();
    let end = complete(&case).state;
    for coordinate in [RingCoordinate::X, RingCoordinate::Y, RingCoordinate::Z] {
        let at = start.layout().ring(coordinate);
        let moved = end.values()[at] - start.values()[at];
        assert!(moved.abs() < 5e-9, "{coordinate:?}: {moved:e}");
    }
}

/// A run from a settled start has the pressures, forces and edges of ellipses of the equilibrium: at
/// the outer raceway those of the more loaded flank, which bears far more than half.
#[test]
fn peaks_are_those_of_the_more_loaded_flank() {
    let mut case = structure(5.1, 25.2);
    case.operation.space.axial_load_n = 0.5 * case.operation.radial_load_n;
    case.operation.inner_speed_rad_s = 10.0;
    case.solver.duration_s = 1e-4;
    let solved = cageless::equilibrium::space::solve(&case).unwrap();
    let lowest = solved.flank_force_n[0];
    assert!(lowest[0] > 2.0 * lowest[1] && lowest[1] > 0.0, "{lowest:?}");
    let mut recorder = SummaryRecorder::new();
    run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    let summary = recorder.summary().unwrap();
    let most = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
    let (peaks, rest) = (&summary.peaks, &solved.rest);
    for (found, expected) in [
        (peaks.outer.pressure_pa, rest.outer_pressure_max_pa),
        (peaks.inner.pressure_pa, rest.inner_pressure_max_pa),
        (peaks.outer.force_n, most(&rest.outer_force_n)),
        (peaks.inner.force_n, most(&rest.inner_force_n)),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    }
    let edges = summary.space.unwrap().ellipse_edge_max_rad;
    for (found, expected) in edges.into_iter().zip(solved.ellipse_edge_max_rad) {
        assert!((found / expected - 1.0).abs() < 5e-3, "{found} {expected}");
    }
}
