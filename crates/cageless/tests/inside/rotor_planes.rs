//! Clearances of a rotor to the stator, and rotors and bearings that cannot be.

use super::free_rotor::shaft;
use super::linear_rotor::{SPEED_RAD_S, bearing, dropped, rigid};
use crate::common::drop_case;
use cageless::IntegrationMethod;
use cageless::linear_rotor::{Clearance, ClearancePlane, Reduction, RigidRotor};
use cageless::simulation::{Control, Observer, RotorDrop};
use cageless::touchdown::DropRecorder;

/// Planes of a rigid rotor lie on a straight line: in free fall with a tilt, closed form.
#[test]
fn planes_of_a_rigid_rotor_lie_on_its_axis() {
    let clearance = |name: &str, axial_m: f64, radial_m: f64| ClearancePlane {
        place: axial_m,
        clearance: Clearance {
            name: name.to_owned(),
            radial_m,
        },
    };
    let places = [-0.1, 0.2];
    let rotor = RigidRotor {
        clearances: vec![
            clearance("seal", -0.1, 1e-4),
            clearance("impeller", 0.35, 3e-4),
            clearance("middle", 0.0, 1.0),
        ],
        ..rigid(places)
    };
    let (duration_s, speeds) = (1e-3, [0.02, 0.08]);
    let mut cases = vec![bearing(IntegrationMethod::VelocityVerlet); 2];
    for (case, vx) in cases.iter_mut().zip(speeds) {
        let journal = case.rotor.as_mut().unwrap();
        (journal.x_m, journal.y_m, journal.vx_m_s, journal.vy_m_s) = (0.0, 0.0, vx, 0.0);
        case.solver.duration_s = duration_s;
    }
    let drop = RotorDrop::new(rotor.linear().unwrap(), 0.0, 0.0, cases, None).unwrap();
    let planes = dropped(&drop).rotor.planes;
    let gravity = drop.cases()[0].operation.gravity_m_s2;
    for (plane, (name, z)) in
        planes
            .iter()
            .zip([("seal", -0.1), ("impeller", 0.35), ("middle", 0.0)])
    {
        assert_eq!(plane.clearance.name, name);
        let slope = (speeds[1] - speeds[0]) / (places[1] - places[0]);
        let x = (speeds[0] + slope * (z - places[0])) * duration_s;
        let y = 0.5 * gravity * duration_s * duration_s;
        let exact = x.hypot(y);
        assert!(
            (plane.displacement_max_m / exact - 1.0).abs() < 1e-9,
            "{plane:?} {exact}"
        );
    }
}

/// At a touchdown node a plane of a flexible rotor is displaced as its journal.
#[test]
fn planes_of_a_flexible_rotor_are_at_its_nodes() {
    let clearance = |node: usize| ClearancePlane {
        place: node,
        clearance: Clearance {
            name: format!("node {node}"),
            radial_m: 1e-3,
        },
    };
    let reduction = Reduction {
        bearing_nodes: vec![0, 4],
        clearances: vec![clearance(4), clearance(2)],
        ..Reduction::default()
    };
    let rotor = shaft(4).reduce(&reduction).unwrap();
    let cases = vec![bearing(IntegrationMethod::VelocityVerlet); 2];
    let drop = RotorDrop::new(rotor, SPEED_RAD_S, 0.0, cases, None).unwrap();
    let mut recorders = [DropRecorder::new(), DropRecorder::new()];
    let mut observers: Vec<Vec<&mut dyn Observer>> = (recorders.iter_mut())
        .map(|recorder| vec![recorder as &mut dyn Observer])
        .collect();
    let outcome = drop
        .run(&mut observers, &mut |_| Control::Continue(()))
        .unwrap();
    let [_, second] = recorders;
    let journal = second.summary(&outcome.bearings[1].state);
    let planes = outcome.rotor.planes;
    let found = planes[0].displacement_max_m;
    assert!((found / journal.rotor_displacement_max_m - 1.0).abs() < 1e-9);
    assert!(planes[1].displacement_max_m > 1.9e-4);
    let beyond = Reduction {
        clearances: vec![clearance(9)],
        ..reduction
    };
    let refused = shaft(4).reduce(&beyond).unwrap_err().to_string();
    assert!(refused.contains("node 9 does not exist"), "{refused}");
}

#[test]
fn bodies_that_cannot_be_are_refused() {
    let refused = |rotor: RigidRotor| rotor.linear().unwrap_err().to_string();
    let of = |polar: f64, transverse: f64| RigidRotor {
        polar_inertia_kg_m2: polar,
        transverse_inertia_kg_m2: transverse,
        ..rigid([-0.1, 0.2])
    };
    // A thin disc has Ip = 2·It.
    assert!(of(1.2, 0.6).linear().is_ok());
    let message = refused(of(1.21, 0.6));
    assert!(message.contains("polar_inertia_kg_m2 = 1.21"), "{message}");
    assert!(message.contains("at most 1.2"), "{message}");
    let message = refused(of(0.04, 1e308));
    assert!(
        message.contains("transverse_inertia_kg_m2 = 1"),
        "{message}"
    );
    let message = refused(rigid([-0.1, 2.77e6]));
    assert!(
        message.contains("axial_mm") && message.contains("100000 mm"),
        "{message}"
    );
}

#[test]
fn a_bearing_that_carries_nothing_has_no_weight() {
    let carried = |places: [f64; 2]| {
        let cases = vec![bearing(IntegrationMethod::VelocityVerlet); 2];
        let rotor = rigid(places).linear().unwrap();
        RotorDrop::new(rotor, 0.0, 0.0, cases, None)
            .unwrap()
            .carried_n()
    };
    let weight = 40.0 * drop_case().operation.gravity_m_s2;
    let between = carried([-0.1, 0.2]);
    assert!((between[0].unwrap() / weight - 2.0 / 3.0).abs() < 1e-12);
    assert!((between[1].unwrap() / weight - 1.0 / 3.0).abs() < 1e-12);
    let [first, second] = carried([0.0, 0.2])[..] else {
        panic!("two bearings");
    };
    assert!((first.unwrap() / weight - 1.0).abs() < 1e-9 && second.is_none());
    let [first, second] = carried([0.1, 0.3])[..] else {
        panic!("two bearings");
    };
    assert!((first.unwrap() / weight - 1.5).abs() < 1e-9 && second.is_none());
}
