//! Where balls sit in the outer ring.

use crate::common::{dimensions, raceway, steel};
use cageless::error::Allowed;
use cageless::outer_contact_geometry::{OuterContactGeometry, check, outer_contact_geometry};
use cageless::{Bearing, Raceway};

fn paper() -> (Bearing, Raceway) {
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    let raceway = raceway(&bearing, 5.1, 25.2, 0.0);
    (bearing, raceway)
}

/// The distance of the ball's centre from Oe, taken from the surface itself, is Re − R.
#[test]
fn the_ball_touches_both_flanks() {
    let (bearing, raceway) = paper();
    let re = bearing.dimensions().outer_groove_curvature_radius_m;
    for angle in [0.0, 0.1, -0.3, 0.43] {
        for deviation in [-20e-6, -1e-6, 0.0, 1e-6, 20e-6] {
            let radius = bearing.ball_radius_m() + deviation;
            let OuterContactGeometry {
                outer_orbit_radius_m,
                effective_radius_m,
            } = outer_contact_geometry(&bearing, std::slice::from_ref(&raceway), angle, radius);
            let path = raceway.contact_path().unwrap();
            let centre = path.groove_centre_m(path.x_m(angle));
            let radial = centre[0].hypot(centre[1]);
            let distance = (outer_orbit_radius_m - radial).hypot(centre[2]);
            assert!(
                (distance - (re - radius)).abs() < 1e-12,
                "{angle} {deviation}"
            );
            // The contact points lie on the line from Oe through the centre.
            let arm = radius * (outer_orbit_radius_m - radial) / distance;
            assert!((effective_radius_m - arm).abs() < 1e-12);
        }
    }
}

/// A ball too large for the raceway is refused before its geometry is no number.
#[test]
fn a_ball_that_reaches_no_flank_is_refused() {
    let mut d = dimensions();
    d.outer_groove_curvature_radius_m = 4.81e-3;
    let bearing = Bearing::new(d, steel()).unwrap();
    let raceways = [raceway(&bearing, 5.1, 25.2, 0.0)];
    let with = |deviation_m: f64| {
        let mut deviations = vec![0.0; 14];
        deviations[3] = deviation_m;
        let bearing = bearing.clone().with_ball_radius_deviations(deviations);
        check(&bearing.unwrap(), &raceways)
    };
    assert_eq!(with(0.0), Ok(()));
    let error = with(40e-6).unwrap_err();
    assert_eq!(error.field, "ball_radius_deviation_m");
    let Allowed::Below(most, _) = error.allowed else {
        panic!("{error}")
    };
    // What is allowed has a geometry, what is not has none.
    assert_eq!(with(0.999 * most), Ok(()));
    let sits = |deviation_m: f64| {
        let radius = bearing.ball_radius_m() + deviation_m;
        let s = outer_contact_geometry(&bearing, &raceways, 0.0, radius);
        s.outer_orbit_radius_m.is_finite()
    };
    assert!(sits(0.999 * most) && !sits(1.001 * most));
}

/// In the middle, too deep by e is what a ball smaller by e sees, but for its arm.
#[test]
fn depth_lets_the_ball_out() {
    let (bearing, raceway) = paper();
    let radius = bearing.ball_radius_m();
    let deep = [raceway.clone().with_depth_error(2e-6).unwrap()];
    let smaller = outer_contact_geometry(&bearing, &[raceway], 0.0, radius - 2e-6);
    let deeper = outer_contact_geometry(&bearing, &deep, 0.0, radius);
    assert!((deeper.outer_orbit_radius_m - smaller.outer_orbit_radius_m).abs() < 1e-15);
    // It sits 2 µm over cos α further out.
    let out = deeper.outer_orbit_radius_m - bearing.outer_orbit_radius_m();
    let cosine = deep[0].effective_radius_m(0.0) / radius;
    assert!((out / (2e-6 / cosine) - 1.0).abs() < 0.02, "{out}");
    let end = outer_contact_geometry(&bearing, &deep, 25.199f64.to_radians(), radius);
    assert!((end.outer_orbit_radius_m - bearing.outer_orbit_radius_m()).abs() < 1e-9);
}

#[test]
fn the_plain_raceway_holds_any_ball_at_its_bottom() {
    let (bearing, _) = paper();
    let geometry = outer_contact_geometry(&bearing, &[], 1.0, 4.77e-3);
    assert!((geometry.outer_orbit_radius_m - (27.765e-3 - 4.77e-3)).abs() < 1e-15);
    assert_eq!(geometry.effective_radius_m, 4.77e-3);
}
