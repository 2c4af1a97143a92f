//! The critical gap of a raceway in a bearing with clearance.

use crate::common::{conventional, dimensions, raceway};
use cageless::Case;
use cageless::critical_gap::{PairTest, critical_gap_rad};
use cageless::simulation::Control;

fn with_clearance(clearance_m: f64) -> Case {
    let mut d = dimensions();
    d.outer_groove_bottom_radius_m += clearance_m;
    let case = conventional(d);
    let raceway = raceway(&case.bearing, 5.1, 25.2, 0.0);
    case.with_raceways(vec![raceway])
}

/// Balls that started on Rm were pressed into the settled ring by half of the clearance and
/// more, with ten times the force that they carry.
#[test]
fn clearance_does_not_press_the_balls_into_the_ring() {
    let gap = |clearance_m: f64| {
        let found = critical_gap_rad(
            &with_clearance(clearance_m),
            &PairTest::default(),
            &mut |_| Control::Continue(()),
        );
        found.map(f64::to_degrees)
    };
    let without = gap(0.0).unwrap();
    for clearance_um in [50.0, 200.0] {
        let found = gap(clearance_um * 1e-6);
        let degrees = found.unwrap_or_else(|e| panic!("{clearance_um} um: {e}"));
        // Pressed in, they came out at 0.044° and −0.010° more than without clearance.
        assert!(degrees > without + 0.05, "{clearance_um}: {degrees}");
    }
}
