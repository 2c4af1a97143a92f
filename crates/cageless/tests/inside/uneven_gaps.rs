//! Uneven gaps between the balls at the start.

use crate::common::structure;
use cageless::Gaps;

#[test]
fn uneven_gaps_fill_the_free_angle_and_follow_the_seed() {
    let bearing = structure(5.1, 25.2).bearing;
    let free_rad = 14.0 * bearing.nominal_gap_rad();
    let draws: Vec<Vec<f64>> = (0..4)
        .map(|k| Gaps::uneven_rad(&bearing, k / 2, k % 2))
        .collect();
    for gaps in &draws {
        assert_eq!(gaps.len(), 14);
        assert!((gaps.iter().sum::<f64>() - free_rad).abs() < 1e-12);
        assert!(gaps.iter().all(|g| *g > 0.0));
    }
    assert_eq!(draws[0], Gaps::uneven_rad(&bearing, 0, 0));
    for k in 1..4 {
        assert_ne!(draws[0], draws[k]);
    }
}
