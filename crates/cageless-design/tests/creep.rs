//! Critical gaps with the creep of rolling contacts.

use cageless::Regularisation;
use cageless::prelude::*;
use cageless::reference::Structure;
use cageless_design::critical_gap::{PairTest, critical_gap_rad};

fn with_creep(mut case: Case) -> Case {
    case.contact.regularisation = Regularisation::Kalker;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.step_s = 1e-6;
    case
}

fn gap_deg(case: &Case, test: &PairTest) -> f64 {
    let found = critical_gap_rad(case, test, &mut |_| Control::Continue(()));
    found.unwrap_or_else(|error| panic!("{error}")).to_degrees()
}

/// Ring of the prototype at the start.
const RING_Y_M: f64 = -22e-6;

fn pair_test() -> PairTest {
    PairTest {
        ring_y_m: Some(RING_Y_M),
        ..PairTest::default()
    }
}

/// Critical gaps of structure (d), in degrees: with creep those of the sign law.
#[test]
fn critical_gaps_with_creep() {
    for (coefficient, given, creep) in [(0.007, 1.7926, 1.7964), (0.1, 1.8328, 1.8327)] {
        let mut case = Structure::D.case();
        case.contact.friction.coefficient = coefficient;
        case.set_method(IntegrationMethod::VelocityVerlet);
        case.solver.step_s = 1e-6;
        let found = [&case, &with_creep(case.clone())].map(|case| gap_deg(case, &pair_test()));
        for (found, expected) in found.into_iter().zip([given, creep]) {
            assert!((found - expected).abs() < 1e-4, "{coefficient}: {found}");
        }
    }
}

/// Table 2 with the stiffness of the prototype, in degrees: the column of its sign law, without a sign.
#[test]
fn table_2_with_creep() {
    let expected = [
        1.8277, 1.8328, 1.8363, 1.7999, 1.7651, 1.7232, 1.6125, 1.5556, 1.4797, 1.3934,
    ];
    for (structure, expected) in Structure::ALL.into_iter().zip(expected) {
        let mut case = with_creep(structure.case());
        case.contact.inner_stiffness_n_m1_5 = Some(1.2e10);
        case.contact.outer_stiffness_n_m1_5 = Some(1.3e10);
        case.contact.ball_stiffness_n_m1_5 = Some(7.4e9);
        let found = gap_deg(&case, &pair_test());
        assert!((found - expected).abs() < 1e-3, "{structure:?}: {found}");
    }
}
