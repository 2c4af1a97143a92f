//! Static equilibrium against closed forms and an independent balance.

use crate::common::{conventional, dimensions, steel, structure};
use cageless::equilibrium::{Equilibrium, EquilibriumError, overload, solve};
use cageless::initial_conditions::initial_state;
use cageless::raceway_contact::{RacewayContact, RacewayPoint};
use cageless::{Bearing, BearingDimensions, Case, Formulation, Gaps, Start, StartState};

/// Forces on every ball and on the ring, put together again from the result alone.
fn check_balance(case: &Case, e: &Equilibrium) {
    let bearing = &case.bearing;
    let (mut ring_x, mut ring_y) = (0.0, 0.0);
    for k in 0..bearing.balls() {
        let (sin, cos) = e.ball_angle_rad[k].sin_cos();
        let (x, y) = (e.ball_distance_m[k] * sin, -e.ball_distance_m[k] * cos);
        let (dx, dy) = (x - e.ring_x_m, y - e.ring_y_m);
        let distance = dx.hypot(dy);
        let inner_deflection =
            bearing.dimensions().inner_groove_bottom_radius_m + bearing.ball_radius_m() - distance;
        let outer_deflection = e.ball_distance_m[k] - bearing.outer_orbit_radius_m();
        let hertz = |k: f64, d: f64| k * d.max(0.0).powf(1.5);
        let inner = hertz(e.inner_stiffness_n_m1_5, inner_deflection);
        let outer = hertz(e.outer_stiffness_n_m1_5, outer_deflection);
        assert!(
            (inner - e.inner_force_n[k]).abs() < 1e-6 * (1.0 + inner),
            "{k}"
        );
        assert!(
            (outer - e.outer_force_n[k]).abs() < 1e-6 * (1.0 + outer),
            "{k}"
        );
        let r = e.effective_radius_m[k];
        let speed = case.operation.inner_speed_rad_s
            * bearing.dimensions().inner_groove_bottom_radius_m
            * r
            / (r + bearing.ball_radius_m());
        let mass = bearing.ball_mass_kg();
        let mut push =
            mass * speed * speed / e.ball_distance_m[k] + mass * case.operation.gravity_m_s2 * cos;
        if case.formulation == Formulation::Paper {
            push += mass * speed * speed / bearing.pitch_radius_m();
        }
        let cosine = (dx * sin - dy * cos) / distance;
        assert!(
            (inner * cosine + push - outer).abs() < 1e-6 * (1.0 + outer),
            "{k}"
        );
        ring_x -= inner * dx / distance;
        ring_y -= inner * dy / distance;
    }
    let down = case.operation.radial_load_n
        + bearing.dimensions().inner_ring_mass_kg * case.operation.gravity_m_s2;
    assert!(
        ring_x.abs() < 1e-5 && (ring_y - down).abs() < 1e-5,
        "{ring_x} {ring_y}"
    );
}

#[test]
fn every_part_is_in_balance() {
    for formulation in [Formulation::Physical, Formulation::Paper] {
        for (lead, clearance) in [(0.0, 0.0), (0.1, 0.0), (0.0, 6e-6), (0.2, 20e-6)] {
            let mut case = structure(5.1, 25.2);
            if clearance > 0.0 {
                let mut d = dimensions();
                d.outer_groove_bottom_radius_m += clearance;
                case = conventional(d);
            }
            case.formulation = formulation;
            case.start.lead_ball_angle_rad = lead;
            check_balance(&case, &solve(&case).unwrap());
        }
    }
}

/// Stribeck's number: Qmax = 4.37 Fr/N for many balls without clearance (Harris,
/// *Rolling Bearing Analysis*, chapter on load distribution).
#[test]
fn stribecks_number() {
    for balls in [50, 100, 200] {
        let mut d = dimensions();
        d.balls = balls;
        let pitch =
            d.ball_radius_m / (std::f64::consts::PI / (f64::from(balls as u32) + 0.5)).sin();
        d.inner_groove_bottom_radius_m = pitch - d.ball_radius_m;
        d.outer_groove_bottom_radius_m = pitch + d.ball_radius_m;
        d.outer_shoulder_radius_m = d.outer_groove_bottom_radius_m - 1e-3;
        let mut case = conventional(d);
        case.operation.inner_speed_rad_s = 1.0;
        case.operation.gravity_m_s2 = 0.0;
        let e = solve(&case).unwrap();
        let most = e.inner_force_n.iter().copied().fold(0.0, f64::max);
        let number = most * f64::from(balls as u32) / case.operation.radial_load_n;
        assert!((number - 4.37).abs() < 0.015, "{balls}: {number}");
    }
}

/// With the same load the raceway's two contact points are less loaded each, but the
/// ring is flatter there.
#[test]
fn stress_on_the_discrete_raceway() {
    let case = structure(5.1, 25.2);
    let pressure = |cosine: f64| {
        let point = RacewayPoint::of_outer(cosine, 500.0);
        RacewayContact::outer(&case.bearing, point).pressure_pa
    };
    let (plain, limit) = (pressure(1.0), pressure(1.0 - 1e-12));
    // Two points share the load: p₀ goes with its cube root.
    assert!((limit / plain - 0.5f64.cbrt()).abs() < 1e-6);
    let inside = pressure(0.85);
    assert!(inside > limit && inside < plain);
}

/// A ring with hardly any load hangs on the balls that are thrown outwards.
#[test]
fn a_light_load_at_speed_finds_its_equilibrium() {
    for load in [0.0, 1.0, 2.0, 10.0] {
        for speed in [100.0, 1257.0, 5000.0] {
            let mut case = structure(5.1, 25.2);
            case.operation.radial_load_n = load;
            case.solver.step_s = 1e-7;
            case.operation.inner_speed_rad_s = speed;
            check_balance(&case, &solve(&case).unwrap());
        }
    }
}

#[test]
fn an_unloaded_ring_floats() {
    let mut case = conventional(dimensions());
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    let e = solve(&case).unwrap();
    assert!(
        e.inner_force_n.iter().all(|f| *f < 1e-3),
        "{:?}",
        e.inner_force_n
    );
}

/// The short cut for cases that are far from it misses no overload.
#[test]
fn overload_is_told_whenever_there_is_one() {
    let mut told = 0;
    for load in [0.0, 1500.0, 5e3, 1e4, 1.5e4, 2e4, 2.5e4, 3e4, 1e5] {
        let mut case = structure(5.1, 25.2);
        case.operation.radial_load_n = load;
        case.solver.step_s = 1e-7;
        let found = overload(&case);
        assert_eq!(found, solve(&case).unwrap().overload(), "{load}");
        told += i32::from(found.is_some_and(|text| text.contains("4200 MPa")));
    }
    assert!((1..9).contains(&told), "{told}");
}

/// Five balls in one row in a small bearing, under a load that drives the ring far off its centre.
fn bunched_in_a_row() -> Case {
    let [ball, pitch, clearance] = [2.4e-3, 5.35e-3, 20e-6];
    let [inner, outer] = [
        pitch - ball - clearance / 2.0,
        pitch + ball + clearance / 2.0,
    ];
    let bearing = BearingDimensions {
        balls: 5,
        ball_radius_m: ball,
        inner_groove_bottom_radius_m: inner,
        outer_groove_bottom_radius_m: outer,
        outer_shoulder_radius_m: outer - 0.4 * ball,
        inner_shoulder_radius_m: None,
        inner_groove_curvature_radius_m: 1.032 * ball,
        outer_groove_curvature_radius_m: 1.076 * ball,
        inner_ring_mass_kg: 0.01,
        inner_ring_damping_n_s_m: 2000.0,
    };
    let mut case = conventional(dimensions());
    case.bearing = Bearing::new(bearing, steel()).unwrap();
    case.solver.step_s = 1e-8;
    case.operation.inner_speed_rad_s = 26.0;
    case.operation.radial_load_n = 660.0;
    let mut gaps = vec![0.0; 5];
    gaps[4] = 5.0 * case.bearing.mean_gap_rad();
    case.start = Start::new(StartState::Settled, Gaps::List(gaps), 0.37);
    case
}

/// Seated, two balls may lie at different distances from the axis, the one near it between the
/// balls: on the pitch circle they would touch.
#[test]
fn settled_balls_that_overlap_are_refused_with_the_gap_that_they_need() {
    let mut case = bunched_in_a_row();
    let Err(EquilibriumError::BallsOverlap {
        ball,
        overlap_m,
        gap_rad,
    }) = initial_state(&case)
    else {
        panic!("{:?}", initial_state(&case));
    };
    assert!(overlap_m > 1e-6 && gap_rad > 0.0, "{overlap_m:e} {gap_rad}");
    let message = initial_state(&case).unwrap_err().to_string();
    assert!(
        message.contains("overlap by") && message.contains("start.gaps"),
        "{message}"
    );
    // With that gap, and a little more, these two no longer do.
    let Gaps::List(gaps) = &mut case.start.gaps else {
        unreachable!()
    };
    gaps[ball] = gap_rad + 1e-3;
    gaps[4] -= gap_rad + 1e-3;
    let again = initial_state(&case);
    let same = matches!(&again, Err(EquilibriumError::BallsOverlap { ball: k, .. }) if *k == ball);
    assert!(!same, "{again:?}");
}

/// A ring beyond the shoulders of the outer one is no equilibrium.
#[test]
fn a_ring_that_settles_beyond_the_shoulders_has_fallen() {
    let mut case = bunched_in_a_row();
    case.operation.radial_load_n = 0.1;
    for lead in 0..36 {
        case.start.lead_ball_angle_rad = f64::from(lead) * 10f64.to_radians();
        if let Ok(rest) = solve(&case) {
            let off = rest.ring_x_m.hypot(rest.ring_y_m);
            assert!(
                off <= case.bearing.shoulder_clearance_m(),
                "{lead}: {off:e}"
            );
        }
    }
}
