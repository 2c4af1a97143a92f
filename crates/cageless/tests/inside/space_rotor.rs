//! A rotor with an axial coordinate above several bearings in space.

use cageless::Case;
use cageless::dynamics::coordinates::{
    BodyCoordinate, OuterRingCoordinate, RingCoordinate, RotorCoordinate,
};
use cageless::dynamics::energy::EnergyTerm;
use cageless::simulation::{Control, RotorDrop, RunOutcome, run};

use super::linear_rotor::{bearing, dropped, rigid};
use super::space_drop::{horizontal, rotor, vertical};

const STEP_S: f64 = 5e-7;

/// Places of rotor and rings along and across the axis in the scales of a drop.
fn bodies(outcome: &RunOutcome) -> Vec<f64> {
    let (state, layout) = (&outcome.state, outcome.state.layout());
    let of_drop = [
        (BodyCoordinate::from(RotorCoordinate::X), 1e-5),
        (RotorCoordinate::Y.into(), 1e-5),
        (RotorCoordinate::Z.into(), 1e-5),
        (RotorCoordinate::Vz.into(), 1e-2),
        (RotorCoordinate::Speed.into(), 1.0),
        (RingCoordinate::Speed.into(), 1.0),
        (OuterRingCoordinate::Z.into(), 1e-5),
    ];
    let of_ring = [(RingCoordinate::X, 1e-5), (RingCoordinate::Z, 1e-5)];
    let value = |place: usize, scale: f64| state.values()[place] / scale;
    let drop = of_drop.map(|(c, scale)| value(layout.body(c), scale));
    drop.into_iter()
        .chain(of_ring.map(|(c, scale)| value(layout.ring(c), scale)))
        .collect()
}

/// Two equal pairs on both sides of the mass centre: each moves as that of a rotor of half the mass, half
/// the inertia and its own share of the thrust.
#[test]
fn symmetric_pairs_move_as_one() {
    for (name, mut case) in [("vertical", vertical()), ("horizontal", horizontal())] {
        rotor(&mut case).eccentricity_m = 0.0;
        case.solver.step_s = STEP_S;
        let speed = rotor(&mut case).speed_rad_s;
        let one = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
        let cases = vec![case.clone(), case];
        let linear = rigid([-0.15, 0.15]).linear().unwrap();
        let drop = RotorDrop::new(linear, speed, 0.0, cases, Some(STEP_S)).unwrap();
        for pair in &dropped(&drop).bearings {
            let apart = bodies(pair).into_iter().zip(bodies(&one));
            let most = apart.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            println!("{name}: {most:.1e}");
            assert!(most < 1e-5, "{name}: {most:e}");
        }
    }
}

/// A pair with shoulders that catches the weight, and a bearing in the plane or free along the axis.
fn on_one_shoulder(mut free: Case, mut pair: Case, step_s: f64) -> RotorDrop {
    for case in [&mut free, &mut pair] {
        case.solver.duration_s = 2e-3;
        case.set_method(cageless::IntegrationMethod::VelocityVerlet);
    }
    let speed = rotor(&mut pair).speed_rad_s;
    let linear = rigid([-0.1, 0.2]).linear().unwrap();
    RotorDrop::new(linear, speed, 0.0, vec![free, pair], Some(step_s)).unwrap()
}

/// The ledgers of rotor and bearings close with the square of the step, and thrust is work.
#[test]
fn ledgers_close_along_the_axis() {
    let mut far = vertical();
    rotor(&mut far).axial_clearance_m = Some(1e-2);
    let mut flat = bearing(cageless::IntegrationMethod::VelocityVerlet);
    flat.solver.tolerance = far.solver.tolerance;
    for (name, free, pair) in [
        ("vertical", far, vertical()),
        ("horizontal", flat, horizontal()),
    ] {
        let residuals = |step_s: f64| {
            let outcome = dropped(&on_one_shoulder(free.clone(), pair.clone(), step_s));
            let pair = &outcome.bearings[1].state;
            assert!(pair.energy_term_j(EnergyTerm::RotorFriction) > 0.0);
            let layout = pair.layout();
            let moved = pair.values()[layout.body(RotorCoordinate::Z)];
            let bearings = outcome.bearings.iter().map(|b| b.energy_residual_relative);
            let rotor = outcome.rotor.energy_residual_relative;
            let all: Vec<f64> = bearings.chain([rotor]).map(f64::abs).collect();
            (all, moved)
        };
        let ((coarse, _), (fine, moved)) = (residuals(1e-6), residuals(2.5e-7));
        println!("{name}: {coarse:?} {fine:?} {moved:e}");
        for (coarse, fine) in coarse.iter().zip(&fine) {
            assert!(*coarse < 1e-6 && *fine < 0.3 * coarse + 1e-10, "{name}");
        }
    }
}

/// Between its shoulders a vertical rotor falls freely: ½ g t² along −Z, in every bearing.
#[test]
fn a_vertical_rotor_falls_freely_between_its_shoulders() {
    let mut case = vertical();
    let r = rotor(&mut case);
    (r.z_m, r.vz_m_s, r.x_m, r.vx_m_s) = (5e-5, 0.01, 0.0, 0.0);
    let speed = r.speed_rad_s;
    case.solver.duration_s = 1e-3;
    let g = case.operation.gravity_m_s2;
    let linear = rigid([-0.1, 0.2]).linear().unwrap();
    let cases = vec![case.clone(), case.clone()];
    let drop = RotorDrop::new(linear, speed, 0.0, cases, Some(1e-6)).unwrap();
    assert_eq!(drop.carried_n(), [Some(40.0 * g); 2]);
    let starts = RotorDrop::cases(&drop).iter().map(|case| {
        let (state, _) = cageless::initial_conditions::initial_state(case).unwrap();
        state.values()[state.layout().body(RotorCoordinate::Z)]
    });
    for (outcome, start) in dropped(&drop).bearings.iter().zip(starts) {
        let layout = outcome.state.layout();
        let at = |c| outcome.state.values()[layout.body(c)];
        let fallen = at(RotorCoordinate::Z) - start;
        assert!(
            (fallen - (1e-5 - 0.5 * g * 1e-6)).abs() < 1e-15,
            "{fallen:e}"
        );
        assert!((at(RotorCoordinate::Vz) - (0.01 - 1e-3 * g)).abs() < 1e-14);
    }
}
