//! Distribution of a radial load over the balls.

use crate::common::{conventional, dimensions};
use cageless::equilibrium::solve;
use cageless::rating::rigid_ring_forces_n;
use cageless::{BearingDimensions, Gaps, Start, StartState};

/// Harris, *Rolling Bearing Analysis*: the 209 bearing, nine balls of 12.7 mm, grooves of 6.6 mm,
/// 52.291 and 77.706 mm in diameter, under 8900 N carries 4527, 2840 and 61 N at 0, 40 and 80° from
/// the load; without clearance 4341, 2908 and 312 N.
#[test]
fn the_209_bearing_of_a_textbook() {
    for (clearance_m, textbook_n) in [
        (7.5e-6, [4527.0, 2840.0, 61.0]),
        (0.0, [4341.0, 2908.0, 312.0]),
    ] {
        let mut case = conventional(BearingDimensions {
            balls: 9,
            ball_radius_m: 6.35e-3,
            inner_groove_bottom_radius_m: 52.291e-3 / 2.0,
            outer_groove_bottom_radius_m: 52.291e-3 / 2.0 + 12.7e-3 + clearance_m,
            outer_shoulder_radius_m: 36e-3,
            inner_groove_curvature_radius_m: 6.6e-3,
            outer_groove_curvature_radius_m: 6.6e-3,
            ..dimensions()
        });
        case.operation.radial_load_n = 8900.0;
        case.operation.gravity_m_s2 = 0.0;
        case.operation.inner_speed_rad_s = 1e-3;
        let found = [
            solve(&case).unwrap().inner_force_n,
            rigid_ring_forces_n(&case).unwrap(),
        ];
        for forces in found {
            for (k, textbook_n) in textbook_n.into_iter().enumerate() {
                // Steel of another modulus there: rounded to a newton, within 5 N of ours.
                for ball in [k, (9 - k) % 9] {
                    let off = forces[ball] - textbook_n;
                    assert!(
                        off.abs() < 5.0,
                        "{clearance_m}, ball {ball}: {}",
                        forces[ball]
                    );
                }
            }
            assert_eq!(forces[3..7], [0.0; 4]);
        }
    }
}

/// Rigid rings: balance of the ring, Hertz's law with the clearance and unequal balls.
#[test]
fn rigid_ring_forces_are_in_balance() {
    let mut deviations = vec![0.0; 14];
    (deviations[0], deviations[2], deviations[13]) = (1e-6, -2e-6, 0.5e-6);
    for (play_m, lead, load_n) in [
        (0.0, 0.0, 1500.0),
        (0.0, 0.1, 0.01),
        (10e-6, 0.2, 1500.0),
        (60e-6, 0.0, 100.0),
        (60e-6, 0.15, 10.0),
        (0.0, 0.05, 20_000.0),
    ] {
        let mut d = dimensions();
        d.outer_groove_bottom_radius_m += play_m;
        let mut case = conventional(d);
        case.start = Start::new(StartState::Settled, Gaps::Uniform, lead);
        case.operation.radial_load_n = load_n;
        case.bearing = case
            .bearing
            .with_ball_radius_deviations(deviations.clone())
            .unwrap();
        let forces = rigid_ring_forces_n(&case).unwrap();
        let angles = cageless::equilibrium::start_angles_rad(&case);
        let sum = |of: fn(f64) -> f64| -> f64 {
            forces.iter().zip(&angles).map(|(q, &a)| q * of(a)).sum()
        };
        assert!(
            (sum(f64::cos) / load_n - 1.0).abs() < 1e-9,
            "{play_m} {load_n}"
        );
        assert!(sum(f64::sin).abs() < 1e-9 * load_n, "{play_m} {load_n}");
        // δj + play − 2 deviation = X·e: three loaded balls determine X and check it.
        let rows: Vec<[f64; 3]> = (0..14)
            .filter(|&k| forces[k] > 0.0)
            .map(|k| {
                let [inner, outer, _] = case.ball_stiffness_n_m1_5(k);
                let deflection =
                    (forces[k] / inner).powf(2.0 / 3.0) + (forces[k] / outer).powf(2.0 / 3.0);
                let (sin, cos) = angles[k].sin_cos();
                [sin, -cos, deflection + play_m - 2.0 * deviations[k]]
            })
            .collect();
        for row in rows.windows(3) {
            let minor = |i: usize, j: usize| row[i][0] * row[j][1] - row[i][1] * row[j][0];
            let residual =
                row[0][2] * minor(1, 2) - row[1][2] * minor(0, 2) + row[2][2] * minor(0, 1);
            assert!(residual.abs() < 1e-14, "{residual}");
        }
    }
}
