//! Cases that a verdict refuses.

use crate::common::{drop_case, structure};
use cageless::simulation::Control;
use cageless::{Case, TimeTable, Unbalance};

/// A verdict is about one constant speed: none on a speed over time, an unbalance or a falling rotor.
#[test]
fn a_verdict_needs_a_constant_speed() {
    let mut over_time = structure(5.1, 25.2);
    let table = TimeTable::new("inner_speed_rad_s", vec![0.0, 1.0], vec![1.0, 2.0]).unwrap();
    over_time.operation.inner_speed_rad_s = 1.0;
    over_time.operation.inner_speed_table = Some(table);
    let mut unbalanced = structure(5.1, 25.2);
    unbalanced.operation.unbalance = Unbalance {
        amount_kg_m: 1e-4,
        phase_rad: 0.0,
    };
    let refused = |case: &Case| {
        let judged = cageless_design::judge(case, &mut |_| Control::Continue(()));
        judged.unwrap_err().to_string()
    };
    for case in [over_time, unbalanced, drop_case()] {
        let message = refused(&case);
        assert!(message.contains("a verdict needs"), "{message}");
    }
}
