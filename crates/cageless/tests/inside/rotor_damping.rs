//! Steps of a rotor that its own damping would make explode.

use super::linear_rotor::dropped;
use crate::common::drop_case;
use cageless::IntegrationMethod;
use cageless::linear_rotor::{DMatrix, Reduction, RigidRotor, RotorMatrices, Unbalance};
use cageless::simulation::RotorDrop;

/// A disc on a shaft, two springs to the ground; damping as given.
fn disc(damping: &[f64; 4]) -> RotorMatrices {
    let node = [3.0, 3.0, 2e-3, 2e-3];
    let mut mass = DMatrix::zeros(8, 8);
    let mut stiffness = DMatrix::zeros(8, 8);
    let mut rates = DMatrix::zeros(8, 8);
    for k in 0..4 {
        for (place, sign) in [(k, 1.0), (k + 4, -1.0)] {
            mass[(place, place)] = node[k];
            rates[(place, place)] = damping[k];
            stiffness[(place, k)] = 1e6 * sign;
            stiffness[(place, k + 4)] = -1e6 * sign;
        }
    }
    for k in [2, 3] {
        stiffness[(k, k)] += 1e4;
    }
    RotorMatrices {
        mass,
        added_mass: DMatrix::zeros(8, 8),
        housings: 0,
        damping: rates,
        gyroscopic: DMatrix::zeros(8, 8),
        stiffness,
        spin_up: DMatrix::zeros(8, 8),
        polar_inertia_kg_m2: 0.01,
    }
}

/// A rotor that its own damping would make explode: the step is that of the largest eigenvalue
/// of M⁻¹·C, displacements and slopes alike.
#[test]
fn damping_of_a_rotor_by_matrices_limits_the_step() {
    let reduction = Reduction {
        bearing_nodes: vec![0, 1],
        unbalances: vec![Unbalance {
            place: 1,
            moment_kg_m: 0.0,
            phase_rad: 0.0,
        }],
        ..Reduction::default()
    };
    for (damping, decay) in [
        ([0.0; 4], 0.0),
        ([3e7, 6e7, 0.0, 0.0], 2e7),
        ([1e4; 4], 5e6),
    ] {
        let rotor = disc(&damping).reduce(&reduction).unwrap();
        let found = rotor.fastest_decay_1_s();
        assert!((found - decay).abs() <= 1e-9 * decay, "{found} {decay}");
        let mut case = drop_case();
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.duration_s = 2e-4;
        let journal = case.rotor.as_mut().unwrap();
        (journal.y_m, journal.vy_m_s) = (-199e-6, -0.0625);
        let of = |step| RotorDrop::new(rotor.clone(), 100.0, 0.0, vec![case.clone(); 2], step);
        let step = of(None).unwrap().cases()[0].solver.step_s;
        let properties = case.solver.method.properties();
        if decay > 0.0 {
            assert!(
                step * decay <= properties.automatic_decay && step * decay > 0.4,
                "{step}"
            );
            let most = properties.decay_limit / decay;
            assert!(of(Some(0.999 * most)).is_ok());
            let said = of(Some(1.001 * most)).unwrap_err().to_string();
            assert!(
                said.contains(&format!("at up to {decay:.3e} 1/s")),
                "{said}"
            );
            let outcome = dropped(&of(None).unwrap());
            let journal = outcome.bearings[0].state.rotor_motion().unwrap();
            assert!(journal.vy.abs() < 0.0625, "{}", journal.vy);
        } else {
            assert!(step > 5e-7, "{step}");
        }
    }
    let rigid = RigidRotor {
        mass_kg: 40.0,
        polar_inertia_kg_m2: 0.04,
        transverse_inertia_kg_m2: 0.6,
        bearing_axial_m: vec![-0.1, 0.2],
        unbalances: vec![],
        clearances: vec![],
    };
    assert_eq!(rigid.linear().unwrap().fastest_decay_1_s(), 0.0);
}
