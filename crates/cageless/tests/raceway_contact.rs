//! Pressures and ellipses of the contacts with the raceways.

use std::f64::consts::PI;

use crate::common::structure;
use cageless::FlankModel;
use cageless::equilibrium::{Equilibrium, settle, solve};
use cageless::{RacewayContact, RacewayPoint};

/// Pressure of every ball from its force, semi-axes with p = 3F/(2πab); on the raceway half of
/// the force over the cosine of the contact angle at each point.
#[test]
fn pressures_belong_to_forces_and_ellipses() {
    // Balls that differ by micrometres touch the plain raceway at one point all the same.
    let deviations: Vec<f64> = (0..14).map(|k| 1e-6 * f64::from(k % 3 - 1)).collect();
    let mut case = structure(5.1, 25.2);
    case.bearing = case
        .bearing
        .with_ball_radius_deviations(deviations)
        .unwrap();
    let Equilibrium {
        inner_contact,
        outer_contact,
        inner_force_n,
        outer_force_n,
        effective_radius_m,
        inner_pressure_max_pa,
        outer_pressure_max_pa,
        ..
    } = solve(&case).unwrap();
    let largest = |all: &[RacewayContact]| all.iter().map(|c| c.pressure_pa).fold(0.0, f64::max);
    assert_eq!(largest(&inner_contact), inner_pressure_max_pa);
    assert_eq!(largest(&outer_contact), outer_pressure_max_pa);
    for k in 0..14 {
        let cosine = effective_radius_m[k] / case.bearing.ball(k).radius_m;
        let points = if cosine < 1.0 { 2.0 * cosine } else { 1.0 };
        for (contact, force) in [
            (inner_contact[k], inner_force_n[k]),
            (outer_contact[k], outer_force_n[k] / points),
        ] {
            let [along, across] = contact.semi_axes_m;
            let carried = 2.0 / 3.0 * PI * along * across * contact.pressure_pa;
            assert!(
                (carried - force).abs() <= 1e-9 * force,
                "{k}: {carried} {force}"
            );
            assert!(force == 0.0 || across > along);
        }
    }
}

/// Pressure and ellipse of one of the two points of a ball in the raceway, and of the plain groove,
/// by complete elliptic integrals in another program: Rw 4.7625, Ro 27.765, Re 4.953 mm, 206 GPa,
/// ν 0.3, 500 N; the raceway curves by (r/Rw)/(Ro − Rw + r) along the direction of rolling.
#[test]
fn pressures_on_the_raceway_are_those_of_another_hertz_solver() {
    let bearing = structure(5.1, 25.2).bearing;
    for (r_mm, pressure_pa, along_m, across_m) in [
        (
            4.7625,
            1.490_277_424_5e9,
            1.486_275_000_7e-4,
            1.077_817_163_5e-3,
        ),
        (4.0, 1.269_509_061_9e9, 1.231_909_779_6e-4, 9.087_442_674e-4),
        (3.5, 1.338_536_216_9e9, 1.275_236_285_5e-4, 9.515_410_995e-4),
    ] {
        let contact = RacewayContact::outer(&bearing, RacewayPoint::of_outer(r_mm / 4.7625, 500.0));
        let found = [
            contact.pressure_pa,
            contact.semi_axes_m[0],
            contact.semi_axes_m[1],
        ];
        for (found, expected) in found.into_iter().zip([pressure_pa, along_m, across_m]) {
            assert!(
                (found / expected - 1.0).abs() < 1e-6,
                "{r_mm}: {found} {expected}"
            );
        }
    }
}

/// How far the ellipse of the most loaded ball reaches in the middle of the raceway under 12 kN, by an independent
/// computation with elliptic integrals: 50.08° on elastic flanks, which is what is warned of on rigid ones as well; at
/// 1.5 kN far less than to the shoulder.
#[test]
fn ellipses_reach_beyond_the_shoulder_in_the_plane_too() {
    let mut case = structure(5.1, 25.2);
    let warnings = |case: &_| settle(case).unwrap().warnings(case);
    assert_eq!(warnings(&case), [""; 0]);
    case.operation.radial_load_n = 12e3;
    for flanks in [FlankModel::Rigid, FlankModel::Elastic] {
        case.flanks = flanks;
        let outer = "the shoulder of the outer ring cuts off contact ellipses: ";
        let said = format!("{outer}they reach to 50.1°, the groove to 49.9°");
        assert!(
            warnings(&case).iter().any(|text| text.contains(&said)),
            "{:?}",
            warnings(&case)
        );
    }
}
