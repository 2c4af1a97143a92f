//! A rotor with linear lateral motion in several bearings: against the rotor in one plane, against
//! its own linear equations where nothing touches, and its energy ledger.

use super::free_rotor::shaft;
use crate::common::{drop_case, raceway};
use cageless::linear_rotor::{
    DMatrix, LinearRotor, Reduction, RigidRotor, RotorMatrices, Unbalance,
};
use cageless::recorder::Recorder;
use cageless::simulation::{
    Control, Ending, Observer, RotorDrop, RotorDropOutcome, RunOutcome, run,
};
use cageless::snapshot::Snapshot;
use cageless::touchdown::Scatter;
use cageless::verification::Role;
use cageless::{Case, FrictionModel, IntegrationMethod};

pub const SPEED_RAD_S: f64 = 3141.6;

/// A bearing that the rotor is about to touch.
pub fn bearing(method: IntegrationMethod) -> Case {
    let mut case = drop_case();
    let raceway = raceway(&case.bearing, 5.1, 25.2, 0.0);
    case = case.with_raceways(vec![raceway]);
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s) = (-199e-6, -0.0625);
    rotor.speed_rad_s = SPEED_RAD_S;
    case.solver.method = method;
    case.solver.tolerance = 1e-10;
    case.solver.duration_s = 2e-3;
    case
}

pub fn rigid(places_m: [f64; 2]) -> RigidRotor {
    RigidRotor {
        mass_kg: 40.0,
        polar_inertia_kg_m2: 0.04,
        transverse_inertia_kg_m2: 0.6,
        bearing_axial_m: places_m.to_vec(),
        unbalances: vec![],
        clearances: vec![],
    }
}

pub fn dropped(drop: &RotorDrop) -> RotorDropOutcome {
    let mut observers: Vec<Vec<&mut dyn Observer>> = drop.cases().iter().map(|_| vec![]).collect();
    let outcome = drop
        .run(&mut observers, &mut |_| Control::Continue(()))
        .unwrap();
    for bearing in &outcome.bearings {
        assert!(
            matches!(bearing.ending, Ending::Complete),
            "{:?}",
            bearing.ending
        );
    }
    outcome
}

/// Root mean square of the difference of two states in the scales of their coordinates.
fn difference(a: &RunOutcome, b: &RunOutcome) -> f64 {
    let (a, b) = (&a.state, &b.state);
    let mut scaled = vec![];
    for k in 0..14 {
        let (p, q) = (a.ball_motion(k), b.ball_motion(k));
        scaled.extend([(p.x - q.x) / 1e-5, (p.y - q.y) / 1e-5, p.vx - q.vx]);
        scaled.extend([p.vy - q.vy, (p.spin - q.spin) / 200.0]);
    }
    let (p, q) = (a.rotor_motion().unwrap(), b.rotor_motion().unwrap());
    scaled.extend([(p.speed - q.speed), (p.angle - q.angle) / 1e-3]);
    scaled.push(a.ring_speed_rad_s().unwrap() - b.ring_speed_rad_s().unwrap());
    let (p, q) = (a.ring_motion(), b.ring_motion());
    scaled.extend([(p.x - q.x) / 1e-5, (p.y - q.y) / 1e-5]);
    (scaled.iter().map(|e| e * e).sum::<f64>() / scaled.len() as f64).sqrt()
}

/// Two equal bearings on both sides of the mass centre: each moves as the bearing of a rotor in
/// one plane with half the mass and half the inertia.
#[test]
fn symmetric_bearings_move_as_one_plane() {
    // The slower rotor rolls on the ring after a fraction of a millisecond.
    for (method, law, speed, most) in [
        (
            IntegrationMethod::Adaptive,
            FrictionModel::Smooth,
            SPEED_RAD_S,
            1e-5,
        ),
        (
            IntegrationMethod::VelocityVerlet,
            FrictionModel::Smooth,
            SPEED_RAD_S,
            1e-6,
        ),
        (
            IntegrationMethod::VelocityVerlet,
            FrictionModel::Coulomb,
            SPEED_RAD_S,
            1e-6,
        ),
        (
            IntegrationMethod::VelocityVerlet,
            FrictionModel::Smooth,
            30.0,
            2e-6,
        ),
        (
            IntegrationMethod::VelocityVerlet,
            FrictionModel::Coulomb,
            30.0,
            2e-6,
        ),
    ] {
        let mut case = bearing(method);
        case.contact.friction_law = law;
        let rotor = case.rotor.as_mut().unwrap();
        (rotor.friction_law, rotor.speed_rad_s) = (law, speed);
        case.solver.step_s = if method == IntegrationMethod::Adaptive {
            1e-5
        } else {
            5e-7
        };
        case.solver.tolerance = 1e-12;
        let one = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
        let rotor = rigid([-0.15, 0.15]).linear().unwrap();
        let step = Some(case.solver.step_s);
        let cases = vec![case.clone(), case];
        let drop = RotorDrop::new(rotor, speed, 0.0, cases, step).unwrap();
        let both = dropped(&drop);
        for bearing in &both.bearings {
            let error = difference(bearing, &one);
            println!("{method:?} {law:?} {speed}: {error:.1e}");
            assert!(error < most, "{method:?} {law:?} {speed}: {error:e}");
        }
    }
}

/// The direction of the unbalances is drawn once, for all of them together; the rest for each
/// bearing on its own, that of the first as for its case alone. A replica turns the balls of all
/// bearings.
#[test]
fn scatter_belongs_to_the_rotor_or_to_a_bearing() {
    let unbalanced = |turn: f64| {
        let plane = |axial_m: f64, phase_rad: f64| Unbalance {
            place: axial_m,
            moment_kg_m: 1e-4,
            phase_rad: phase_rad + turn,
        };
        let rotor = RigidRotor {
            unbalances: vec![plane(-0.1, 0.4), plane(0.2, 2.0)],
            ..rigid([-0.1, 0.2])
        };
        rotor.linear().unwrap()
    };
    const SEED: u64 = 5;
    let case = bearing(IntegrationMethod::VelocityVerlet);
    let cases = vec![case.clone(), case.clone()];
    let drop = RotorDrop::new(unbalanced(0.0), SPEED_RAD_S, 0.0, cases, None).unwrap();
    let scatter = Scatter::default();
    let (scattered, drawn) = scatter.draw(&drop, SEED, 7);
    let (alone, of_case) = scatter.draw(&RotorDrop::of_case(&case).unwrap(), SEED, 7);
    let turn_rad = drawn.unbalance_rad.unwrap();
    assert_eq!(scattered.rotor(), Some(&unbalanced(turn_rad)));
    let rotor = alone.cases()[0].rotor.as_ref().unwrap();
    assert_eq!(rotor.eccentricity_phase_rad, turn_rad);
    assert_eq!(drawn.unbalance_rad, of_case.unbalance_rad);
    assert_eq!(drawn.bearings[..1], of_case.bearings);
    assert_eq!(scattered.cases()[0].start, alone.cases()[0].start);
    // Equal cases, no draw in common.
    let [a, b] = [&drawn.bearings[0], &drawn.bearings[1]];
    for (a, b) in [
        (a.rotor_friction.coefficient, b.rotor_friction.coefficient),
        (a.ball_friction.coefficient, b.ball_friction.coefficient),
        (a.radial_clearance_m, b.radial_clearance_m),
    ] {
        assert!(a != b);
    }
    assert!(scattered.cases()[0].start != scattered.cases()[1].start);
    assert!(scattered != scatter.draw(&drop, SEED, 8).0);
    assert_eq!(scattered, scatter.draw(&drop, SEED, 7).0);

    let turned = |case: &Case| case.start.lead_ball_angle_rad;
    for role in Role::all(SEED, 2) {
        let replica = role.drop(&drop);
        for (a, b) in replica.cases().iter().zip(drop.cases()) {
            assert_eq!(turned(a), turned(b) + role.perturbation_rad);
            let halves = if role.half_step { 0.5 } else { 1.0 };
            assert_eq!(a.solver.step_s, halves * b.solver.step_s);
        }
    }
}

/// Two equal bearings under a rotor with an unbalance in the middle move as the bearing of a rotor
/// in one plane with an eccentric mass centre. A journal held at the centre has its mass centre at
/// ε·e^(iφ), with the velocity iΩ·ε·e^(iφ).
#[test]
fn unbalance_moves_as_an_eccentric_mass_centre() {
    let (eccentricity, phase) = (2e-5, 0.7_f64);
    let mut case = bearing(IntegrationMethod::Adaptive);
    case.solver.step_s = 1e-5;
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s) = (-150e-6, -0.0625);
    let cases = vec![case.clone(), case.clone()];
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.eccentricity_m, rotor.eccentricity_phase_rad) = (eccentricity, phase);
    rotor.x_m += eccentricity * phase.cos();
    rotor.y_m += eccentricity * phase.sin();
    rotor.vx_m_s -= SPEED_RAD_S * eccentricity * phase.sin();
    rotor.vy_m_s += SPEED_RAD_S * eccentricity * phase.cos();
    let one = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
    let rotor = RigidRotor {
        // About the axis.
        polar_inertia_kg_m2: 0.04 + 40.0 * eccentricity * eccentricity,
        unbalances: vec![Unbalance {
            place: 0.0,
            moment_kg_m: 40.0 * eccentricity,
            phase_rad: phase,
        }],
        ..rigid([-0.15, 0.15])
    };
    let rotor = rotor.linear().unwrap();
    let drop = RotorDrop::new(rotor, SPEED_RAD_S, 0.0, cases, Some(1e-5)).unwrap();
    let both = dropped(&drop);
    assert!(both.rotor.energy_residual_relative.abs() < 1e-8);
    for bearing in &both.bearings {
        let error = difference(bearing, &one);
        println!("eccentric: {error:.1e}");
        assert!(error < 1e-5, "{error:e}");
    }
}

/// Bearings at different distances, one of them conventional: every ledger closes.
#[test]
fn ledgers_of_rotor_and_bearings_close() {
    for (method, law, most) in [
        (IntegrationMethod::Adaptive, FrictionModel::Smooth, 1e-8),
        (
            IntegrationMethod::VelocityVerlet,
            FrictionModel::Smooth,
            1e-3,
        ),
        (
            IntegrationMethod::VelocityVerlet,
            FrictionModel::Coulomb,
            1e-3,
        ),
    ] {
        let rotor = RigidRotor {
            unbalances: vec![Unbalance {
                place: 0.05,
                moment_kg_m: 2e-4,
                phase_rad: 1.0,
            }],
            ..rigid([-0.1, 0.2])
        };
        let mut cases = vec![bearing(method), bearing(method).conventional()];
        for case in &mut cases {
            case.contact.friction_law = law;
            case.rotor.as_mut().unwrap().friction_law = law;
            case.solver.duration_s = 4e-3;
        }
        let step = (method == IntegrationMethod::Adaptive).then_some(1e-5);
        let rotor = rotor.linear().unwrap();
        let drop = RotorDrop::new(rotor, SPEED_RAD_S, 0.0, cases, step).unwrap();
        let outcome = dropped(&drop);
        let residual = outcome.rotor.energy_residual_relative;
        println!("{method:?} rotor {residual:.1e}");
        assert!(residual.abs() < most);
        for bearing in &outcome.bearings {
            println!(
                "{method:?} bearing {:.1e}",
                bearing.energy_residual_relative
            );
            assert!(bearing.energy_residual_relative.abs() < most);
        }
        let [near, far] = [0, 1].map(|k| outcome.bearings[k].state.rotor_motion().unwrap());
        assert_eq!((near.speed, near.angle), (far.speed, far.angle));
        assert!(near.speed < SPEED_RAD_S - 0.05);
    }
}

/// A flexible rotor dropped into its bearings by the production method: at rest it weighs what it
/// weighs, and its vibrations die out in its own damping.
#[test]
fn a_flexible_rotor_falls_into_its_bearings() {
    let reduction = Reduction {
        bearing_nodes: vec![0, 4],
        kept_nodes: vec![2],
        unbalances: vec![Unbalance {
            place: 1,
            moment_kg_m: 2e-5,
            phase_rad: 0.3,
        }],
        frequency_max_hz: Some(5000.0),
        ..Reduction::default()
    };
    let rotor: LinearRotor = shaft(4).reduce(&reduction).unwrap();
    let weight: f64 = rotor.mass_shares_kg().iter().sum();
    assert!((weight - rotor.mass_kg).abs() < 1e-9 * weight);
    let mut cases = vec![bearing(IntegrationMethod::VelocityVerlet); 2];
    for case in &mut cases {
        case.solver.duration_s = 5e-3;
    }
    let drop = RotorDrop::new(rotor, 500.0, 0.0, cases, None).unwrap();
    let mut touched = [0.0_f64; 2];
    let [mut first, mut second] = [0, 1].map(|_| vec![]);
    {
        let mut recorders = [&mut first, &mut second].map(|rows: &mut Vec<Snapshot>| {
            Recorder::new(1e-4, |s| {
                rows.push(s);
                Ok(())
            })
        });
        let mut observers: Vec<Vec<&mut dyn Observer>> = (recorders.iter_mut())
            .map(|r| vec![r as &mut dyn Observer])
            .collect();
        let outcome = drop
            .run(&mut observers, &mut |_| Control::Continue(()))
            .unwrap();
        assert!(outcome.rotor.energy_residual_relative.abs() < 1e-3);
        assert!(
            outcome
                .bearings
                .iter()
                .all(|b| b.energy_residual_relative.abs() < 1e-3)
        );
    }
    for (most, rows) in touched.iter_mut().zip([first, second]) {
        for row in rows {
            *most = most.max(row.rotor.unwrap().contact_force_n);
        }
    }
    assert!(
        touched.iter().all(|force| *force > 9.81 * weight),
        "{touched:?}"
    );
}

#[test]
fn impossible_rotors_are_refused_by_name() {
    let said = |error: cageless::linear_rotor::RotorError| error.to_string();
    let of = |reduction: &Reduction| said(shaft(4).reduce(reduction).unwrap_err());
    let at = |nodes: &[usize]| Reduction {
        bearing_nodes: nodes.to_vec(),
        ..Reduction::default()
    };
    assert_eq!(
        of(&at(&[0, 9])),
        "node 9 does not exist: the rotor has the nodes 0 to 4"
    );
    assert!(of(&at(&[2])).contains("move freely with the 1 kept nodes held"));
    assert!(of(&at(&[2, 2])).contains("two touch-down bearings are at node 2"));
    assert!(of(&at(&[])).contains("at least one touch-down bearing"));
    let broken = |change: fn(&mut RotorMatrices)| {
        let mut matrices = shaft(4);
        change(&mut matrices);
        said(matrices.reduce(&at(&[0, 4])).unwrap_err())
    };
    assert!(broken(|m| m.gyroscopic[(2, 3)] = 1.0).contains("matrix G must be antisymmetric"));
    assert!(broken(|m| m.mass[(0, 1)] = 1.0).contains("matrix M must be symmetric"));
    assert!(broken(|m| m.mass[(0, 0)] = -1.0).contains("matrix M must be positive definite"));
    assert_eq!(
        broken(|m| m.damping = DMatrix::zeros(3, 4)),
        "matrix C is 3 × 4: must be 20 × 20, as M"
    );
    assert!(broken(|m| m.stiffness[(1, 1)] = f64::NAN).contains("matrix K must be of finite"));
    assert!(broken(|m| m.polar_inertia_kg_m2 = 0.0).contains("polar_inertia_kg_m2 = 0"));
    assert!(broken(|m| m.gyroscopic.neg_mut()).contains("G must be +Ip in row α and column β"));
    assert!(
        broken(|m| m.polar_inertia_kg_m2 = 0.1).contains("by G, polar_inertia_kg_m2 is 1.000e-1")
    );
    assert!(
        broken(|m| m.polar_inertia_kg_m2 = 0.01).contains("by G, polar_inertia_kg_m2 is 1.000e-2")
    );
    let slopes = broken(|m| {
        for matrix in [&mut m.mass, &mut m.stiffness, &mut m.gyroscopic] {
            for alpha in (2..20).step_by(4) {
                matrix.row_mut(alpha).neg_mut();
                matrix.column_mut(alpha).neg_mut();
            }
        }
    });
    assert!(slopes.contains("K must be of rotations about X and Y, dx/dz = β and dy/dz = −α"));
    let apart = broken(|m| m.stiffness.fill(0.0));
    assert!(
        apart.contains("with the 2 kept nodes held: K connects its nodes, and the coordinates")
    );
    let mut without = shaft(4);
    without.gyroscopic.fill(0.0);
    assert!(without.reduce(&at(&[0, 4])).is_ok());
    let rotor = || rigid([-0.1, 0.2]).linear().unwrap();
    let drop = |cases: Vec<Case>, step| {
        said(RotorDrop::new(rotor(), 100.0, 0.0, cases, step).unwrap_err())
    };
    let case = || bearing(IntegrationMethod::VelocityVerlet);
    assert!(drop(vec![case()], None).contains("1 cases for 2 touch-down bearings"));
    assert!(drop(vec![case(); 2], Some(1e-3)).contains("beyond what rotor and bearings bear"));
    let longer = Case {
        solver: cageless::Solver {
            duration_s: 1.0,
            ..case().solver
        },
        ..case()
    };
    assert!(drop(vec![case(), longer], None).contains("solver.duration_s is 0.002 in the case"));
    let message = said(rigid([0.1, 0.1]).linear().unwrap_err());
    assert!(
        message.contains("two bearings are at the same axial place, 0.1 m"),
        "{message}"
    );
}

/// In zero gravity neither a rotor that turns nor one that drifts ends by rounding.
#[test]
fn without_gravity_a_rotor_in_two_bearings_drifts_on() {
    for vx_m_s in [0.0, 0.02] {
        let mut case = drop_case();
        case.operation.gravity_m_s2 = 0.0;
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.duration_s = 2e-3;
        case.rotor.as_mut().unwrap().vx_m_s = vx_m_s;
        let rotor = rigid([-0.2, 0.2]).linear().unwrap();
        let drop = RotorDrop::new(rotor, SPEED_RAD_S, 0.0, vec![case; 2], None).unwrap();
        for bearing in dropped(&drop).bearings {
            let moved = bearing.state.rotor_motion().unwrap();
            assert!((moved.x - vx_m_s * 2e-3).abs() < 1e-12, "{moved:?}");
        }
    }
}
