//! Ratings against the tables of the standards, closed forms, finite differences and the motion.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use crate::common::{conventional, dimensions, steel, structure};
use cageless::equilibrium::space::solve as solve_in_space;
use cageless::equilibrium::{settle, solve};
use cageless::rating::{
    BasicRatings, Conformities, EquivalentLoad, PassingFrequencies, Rating, ReferenceLife,
    SPEED_PARAMETER_MAX_MM_RPM, dynamic_factor, skf_friction_torque_n_m, static_factor,
};
use cageless::recorder::Recorder;
use cageless::simulation::run;
use cageless::{
    Assembly, Bearing, BearingDimensions, Case, InnerRingBore, Motion, Raceway, RacewayDimensions,
    Row, Tilt,
};

/// γ = Dw/Dpw and fc of ISO 281, single-row deep groove ball bearings.
const FC: [(f64, f64); 21] = [
    (0.05, 46.7),
    (0.06, 49.1),
    (0.07, 51.1),
    (0.08, 52.8),
    (0.09, 54.3),
    (0.10, 55.5),
    (0.12, 57.5),
    (0.14, 58.8),
    (0.16, 59.6),
    (0.18, 59.9),
    (0.20, 59.9),
    (0.22, 59.6),
    (0.24, 59.0),
    (0.26, 58.2),
    (0.28, 57.1),
    (0.30, 56.0),
    (0.32, 54.6),
    (0.34, 53.2),
    (0.36, 51.7),
    (0.38, 50.0),
    (0.40, 48.4),
];

/// γ and f0 of ISO 76, radial and angular contact groove ball bearings.
const F0: [(f64, f64); 18] = [
    (0.00, 14.7),
    (0.02, 15.1),
    (0.04, 15.5),
    (0.06, 15.9),
    (0.08, 16.3),
    (0.09, 16.5),
    (0.10, 16.4),
    (0.12, 15.9),
    (0.14, 15.4),
    (0.16, 14.9),
    (0.18, 14.4),
    (0.20, 14.0),
    (0.22, 13.5),
    (0.25, 12.8),
    (0.28, 12.1),
    (0.32, 11.2),
    (0.36, 10.3),
    (0.40, 9.4),
];

/// Bearing without clearance from ball diameter and pitch diameter in mm.
fn bearing(balls: usize, ball_mm: f64, pitch_mm: f64, conformity: f64) -> Bearing {
    let d = dimensions_of(balls, ball_mm, pitch_mm, conformity);
    Bearing::new(d, steel()).unwrap()
}

fn dimensions_of(balls: usize, ball_mm: f64, pitch_mm: f64, conformity: f64) -> BearingDimensions {
    let (ball, pitch) = (0.5e-3 * ball_mm, 0.5e-3 * pitch_mm);
    BearingDimensions {
        balls,
        ball_radius_m: ball,
        inner_groove_bottom_radius_m: pitch - ball,
        outer_groove_bottom_radius_m: pitch + ball,
        outer_shoulder_radius_m: pitch + 0.6 * ball,
        inner_groove_curvature_radius_m: 2.0 * conformity * ball,
        outer_groove_curvature_radius_m: 2.0 * conformity * ball,
        ..dimensions()
    }
}

/// Without weight and centrifugal force.
fn at_rest(mut case: Case) -> Case {
    case.operation.gravity_m_s2 = 0.0;
    case.operation.inner_speed_rad_s = 1e-3;
    case
}

fn turned(mut case: Case, angle_rad: f64) -> Case {
    case.start.lead_ball_angle_rad += angle_rad;
    case
}

fn grooves(inner: f64, outer: f64) -> Conformities {
    Conformities { inner, outer }
}

#[test]
fn dynamic_factor_is_the_table_of_iso_281() {
    for (gamma, table) in FC {
        let fc = dynamic_factor(gamma, grooves(0.52, 0.52));
        assert!((fc - table).abs() < 0.1, "{gamma}: {fc} against {table}");
    }
    // An outer groove wider than the inner one lowers the rating.
    assert!(dynamic_factor(0.2, grooves(0.52, 0.53)) < dynamic_factor(0.2, grooves(0.52, 0.52)));
}

#[test]
fn static_factor_is_the_table_of_iso_76() {
    for (gamma, table) in F0 {
        let f0 = static_factor(gamma, grooves(0.52, 0.53));
        assert!((f0 - table).abs() < 0.06, "{gamma}: {f0} against {table}");
    }
}

/// Bearings with filling slots of SKF's catalogue PUB 17000 (2018), C in N: number and diameter of
/// the balls are those that fit C0, so that the factor bm = 1.1 is confirmed by C.
#[test]
fn a_filling_slot_lowers_the_rating_as_in_catalogues() {
    for (name, balls, ball_mm, pitch_mm, catalogue) in [
        ("206", 13, 9.525, 46.0, 20.9e3),
        ("305", 10, 11.1125, 43.5, 22.9e3),
        ("306", 11, 12.303_125, 51.0, 29.7e3),
        ("207", 13, 11.1125, 53.5, 27.5e3),
        ("307", 11, 13.493_75, 57.5, 34.7e3),
    ] {
        let bearing = bearing(balls, ball_mm, pitch_mm, 0.52);
        assert_eq!(bearing.assembly(), Assembly::FillingSlot, "{name}");
        let slotted = BasicRatings::new(&bearing).dynamic_n;
        assert!(
            (slotted / catalogue - 1.0).abs() < 0.015,
            "{name}: {slotted}"
        );
        // Without a slot: the usual factor, and lives by its third power.
        let life = |b: &Bearing| {
            ReferenceLife::new(b)
                .l10r_mrev(&[1e3; 13], &[1e3; 13])
                .unwrap()
        };
        let whole = bearing.clone().with_assembly(Assembly::WithoutSlot);
        let ratio = BasicRatings::new(&whole).dynamic_n / slotted;
        assert!((ratio - 1.3 / 1.1).abs() < 1e-12);
        assert!((life(&whole) / life(&bearing) / ratio.powi(3) - 1.0).abs() < 1e-9);
    }
    // Between eccentric rings go as many as in the caged bearing.
    assert_eq!(
        bearing(9, 9.525, 46.0, 0.52).assembly(),
        Assembly::WithoutSlot
    );
}

/// bm of ISO 281: 1.3 for radial and angular contact ball bearings, 1.1 for those with a filling slot,
/// which only a given `assembly` makes of an angular contact bearing.
#[test]
fn an_angular_contact_bearing_has_no_filling_slot() {
    let radial = bearing(14, 9.525, 46.0, 0.52);
    let angular = radial.clone().with_contact_angle(0.3, 0.0).unwrap();
    let given = |b: &Bearing| b.clone().with_assembly(Assembly::FillingSlot);
    for (bearing, bm) in [(&radial, 1.1), (&angular, 1.3), (&given(&angular), 1.1)] {
        assert_eq!(bearing.assembly().rating_factor(), bm);
        // Cr/bm = fc (cos α0)^0.7 Z^(2/3) Dw^1.8 with fc at Dw cos α0/Dpw.
        let cosine = bearing.contact_angle_rad().cos();
        let fc = dynamic_factor(9.525 * cosine / 46.0, grooves(0.52, 0.52));
        let across = cosine.powf(0.7);
        let rest = fc * across * 14f64.powf(2.0 / 3.0) * 9.525f64.powf(1.8);
        let found = BasicRatings::new(bearing).dynamic_n;
        assert!((found / rest / bm - 1.0).abs() < 1e-9, "{found}");
    }
}

/// Size 209: 9 balls of 12.7 mm on 65 mm, Harris' example.
#[test]
fn dynamic_rating_of_a_209() {
    let rating = BasicRatings::new(&bearing(9, 12.7, 65.0, 0.52));
    assert!((rating.dynamic_n - 32_720.0).abs() < 1.0, "{rating:?}");
}

/// Up to 25.4 mm Cr grows with Dw^1.8, above with Dw^1.4.
#[test]
fn large_balls_have_their_own_exponent() {
    let rating = |ball_mm: f64| BasicRatings::new(&bearing(8, ball_mm, 5.0 * ball_mm, 0.52));
    let ratio = |a: f64, b: f64| rating(b).dynamic_n / rating(a).dynamic_n;
    assert!((ratio(10.0, 20.0) / 2f64.powf(1.8) - 1.0).abs() < 1e-12);
    assert!((ratio(30.0, 60.0) / 2f64.powf(1.4) - 1.0).abs() < 1e-12);
    assert!((ratio(25.4, 25.4 + 1e-9) - 1.0).abs() < 1e-4);
    assert!((rating(20.0).static_n / rating(10.0).static_n / 4.0 - 1.0).abs() < 1e-12);
}

/// Two rows have Cr = 2^0.7 and C0r = 2 times those of one (ISO 281, ISO 76), and under twice the load its life by
/// 2^−0.9: (2^0.7/2)³.
#[test]
fn rows_have_the_rating_of_a_bearing_of_two_rows() {
    let mut one = at_rest(conventional(dimensions()));
    one.motion = Motion::Space;
    let mut two = one.clone();
    two.rows = vec![Row::default(); 2];
    two.operation.radial_load_n *= 2.0;
    let rating = |case: &Case| Rating::in_space(case, &solve_in_space(case).unwrap());
    let (one, two) = (rating(&one), rating(&two));
    let plain = BasicRatings::new(&conventional(dimensions()).bearing);
    assert_eq!(one.basic, plain);
    assert!((two.basic.static_n / plain.static_n - 2.0).abs() < 1e-12);
    assert!((two.basic.dynamic_n / plain.dynamic_n - 1.624_504_8).abs() < 1e-7);
    let lives = two.l10r_mrev.unwrap() / one.l10r_mrev.unwrap();
    assert!((lives - 0.535_886_7).abs() < 1e-5, "{lives}");
}

/// The load of the static rating is Stribeck's 5 Q/Z at 4200 MPa of the more loaded raceway.
#[test]
fn static_rating_is_the_load_of_4200_mpa() {
    let bearing = bearing(9, 12.7, 65.0, 0.52);
    let ball_n = 5.0 * BasicRatings::new(&bearing).static_n / 9.0;
    // Steel of the standard, 207 GPa, against 206 GPa: p ∝ E*^(2/3).
    let pressure =
        bearing.inner_contact().peak_pressure_pa(ball_n) * (207f64 / 206.0).powf(2.0 / 3.0);
    assert!((pressure / 4.2e9 - 1.0).abs() < 1e-9, "{pressure}");
}

/// With Stribeck's half-loaded distribution both rings together have the life (Cr/Fr)³: 0.407 is
/// Jr/J1 and 0.389 is Jr/J2, rounded.
#[test]
fn reference_life_of_stribecks_distribution() {
    for gamma in [0.05, 0.1, 0.15, 0.195, 0.207] {
        let bearing = bearing(9, 12.7, 12.7 / gamma, 0.52);
        // The balls at 3600 positions: sums are the integrals of the distribution.
        let cosines: Vec<f64> = (0..3600)
            .map(|k| (TAU * f64::from(k) / 3600.0).cos().max(0.0))
            .collect();
        let jr = cosines.iter().map(|c| c.powf(2.5)).sum::<f64>() / 3600.0;
        assert!((jr - 0.2288).abs() < 1e-4);
        let load_n = 2000.0;
        let most_n = load_n / (9.0 * jr);
        let forces: Vec<f64> = cosines.iter().map(|c| most_n * c.powf(1.5)).collect();
        let life = ReferenceLife::new(&bearing).l10r_mrev(&forces, &forces);
        let l10 = BasicRatings::new(&bearing).l10_mrev(load_n);
        let ratio = life.unwrap() / l10;
        assert!((ratio - 1.0).abs() < 1e-3, "{gamma}: {ratio}");
    }
}

/// The paper's bearing at 1500 N, without filling slot, rigid rings, without weight and centrifugal
/// force: from 5265 to 5288 million revolutions as the balls are placed.
#[test]
fn reference_life_of_the_papers_bearing() {
    let (mut least, mut most) = (f64::INFINITY, 0.0f64);
    for k in 0..=20 {
        let mut case = turned(
            at_rest(conventional(dimensions())),
            f64::from(k) / 20.0 * TAU / 14.0,
        );
        case.bearing = case.bearing.with_assembly(Assembly::WithoutSlot);
        let life = Rating::new(&case, &solve(&case).unwrap())
            .l10r_mrev
            .unwrap();
        least = least.min(life);
        most = most.max(life);
    }
    assert!(least > 5265.0 && most < 5288.0, "{least} to {most}");
    assert!(most - least > 15.0, "{least} to {most}");
}

/// Ten times the load, a thousandth of the lives.
#[test]
fn lives_fall_with_the_cube_of_the_load() {
    let life = |load_n: f64| {
        let mut case = at_rest(conventional(dimensions()));
        case.operation.radial_load_n = load_n;
        Rating::new(&case, &solve(&case).unwrap())
    };
    let (light, heavy) = (life(200.0), life(2000.0));
    let ratio = light.l10_mrev.unwrap() / heavy.l10_mrev.unwrap();
    assert!((ratio / 1000.0 - 1.0).abs() < 1e-12, "{ratio}");
    let ratio = light.l10r_mrev.unwrap() / heavy.l10r_mrev.unwrap();
    assert!((ratio / 1000.0 - 1.0).abs() < 1e-9, "{ratio}");
    let mut unloaded = at_rest(conventional(dimensions()));
    unloaded.operation.radial_load_n = 0.0;
    let rating = Rating::new(&unloaded, &solve(&unloaded).unwrap());
    assert_eq!((rating.l10_mrev, rating.static_safety_factor), (None, None));
}

/// Turns balls and raceways; without weight that is a load turned the other way.
fn under_turned_load(case: &Case, angle_rad: f64) -> [f64; 2] {
    let raceways = case
        .raceways
        .iter()
        .map(|r| {
            let d = r.dimensions();
            let turned = RacewayDimensions {
                centre_angle_rad: d.centre_angle_rad + angle_rad,
                ..*d
            };
            Raceway::new(turned, &case.bearing).unwrap()
        })
        .collect();
    let e = solve(&turned(case.with_raceways(raceways), angle_rad)).unwrap();
    let (sin, cos) = angle_rad.sin_cos();
    // Back into the frame of the balls.
    [
        cos * e.ring_x_m + sin * e.ring_y_m,
        cos * e.ring_y_m - sin * e.ring_x_m,
    ]
}

/// K times the displacement by a small change of the load, along and across, is that change.
#[test]
fn stiffness_is_the_derivative_of_the_equilibrium() {
    let mut with_play = dimensions();
    with_play.outer_groove_bottom_radius_m += 8e-6;
    for base in [
        structure(5.1, 25.2),
        turned(structure(5.1, 25.2), 0.11),
        turned(conventional(with_play), 0.07),
    ] {
        let mut case = base;
        case.operation.gravity_m_s2 = 0.0;
        let load_n = case.operation.radial_load_n;
        let k = solve(&case).unwrap().stiffness_n_m.unwrap();
        assert_eq!(k[0][1], k[1][0]);
        let h = 1e-4;
        let difference = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
        let along = {
            let at = |scale: f64| {
                let mut other = case.clone();
                other.operation.radial_load_n = load_n * scale;
                let e = solve(&other).unwrap();
                [e.ring_x_m, e.ring_y_m]
            };
            difference(at(1.0 + h), at(1.0 - h))
        };
        // Load turned by ∓h: (−sin, −cos)·F.
        let across = difference(under_turned_load(&case, h), under_turned_load(&case, -h));
        let force = |d: [f64; 2]| k.map(|row| row[0] * d[0] + row[1] * d[1]);
        let expected = [[0.0, -2.0 * h * load_n], [-2.0 * h.sin() * load_n, 0.0]];
        for (found, expected) in [along, across].map(force).into_iter().zip(expected) {
            for axis in 0..2 {
                let error = (found[axis] - expected[axis]).abs() / (2.0 * h * load_n);
                assert!(error < 1e-6, "{found:?} {expected:?}: {error}");
            }
        }
    }
}

/// Without load the ring is free in the play that the thrown balls leave.
#[test]
fn stiffness_of_a_free_ring_is_not_defined() {
    let mut case = conventional(dimensions());
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    assert_eq!(solve(&case).unwrap().stiffness_n_m, None);
    case.operation.radial_load_n = 1.0;
    assert!(solve(&case).unwrap().stiffness_n_m.is_some());
}

/// Closed forms with n, Dw, Dpw and Z of Zhao 2022, Table 1.
#[test]
fn passing_frequencies_are_the_closed_forms() {
    let case = conventional(dimensions());
    let passing = Rating::new(&case, &solve(&case).unwrap()).passing;
    let (n, ratio) = (200.0, 9.525 / 46.005);
    for (found, expected) in [
        (passing.ftf_hz, n / 2.0 * (1.0 - ratio)),
        (passing.bpfo_hz, 14.0 * n / 2.0 * (1.0 - ratio)),
        (passing.bpfi_hz, 14.0 * n / 2.0 * (1.0 + ratio)),
        (passing.bsf_hz, n / (2.0 * ratio) * (1.0 - ratio * ratio)),
        (passing.raceway_ftf_hz, n / 2.0 * (1.0 - ratio)),
        (passing.ftf_hz, case.rolling_orbit_speed_rad_s() / TAU),
        (passing.bpfi_hz + passing.bpfo_hz, 14.0 * n),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
    let case = structure(5.1, 25.2);
    let slowed = Rating::new(&case, &solve(&case).unwrap()).passing;
    assert!(slowed.raceway_ftf_hz < 0.999 * slowed.ftf_hz);
    assert_eq!(slowed.ftf_hz, passing.ftf_hz);
}

/// Multiples of the shaft frequency that Case Western Reserve University publishes of its 6205-2RS at the
/// drive end (9 balls of 7.94 mm on 39.04 mm), the last of them 2·BSF; the dimensions are
/// rounded to 0.01 mm.
#[test]
fn passing_frequencies_are_those_of_the_cwru_bearing() {
    let mut d = dimensions();
    d.balls = 9;
    d.ball_radius_m = 3.97e-3;
    d.inner_groove_bottom_radius_m = 0.5 * 39.04e-3 - 3.97e-3;
    d.outer_groove_bottom_radius_m = 0.5 * 39.04e-3 + 3.97e-3;
    d.outer_shoulder_radius_m = 22.5e-3;
    d.inner_groove_curvature_radius_m = 4.13e-3;
    d.outer_groove_curvature_radius_m = 4.13e-3;
    let case = conventional(d);
    let passing = PassingFrequencies::new(&case);
    let n = case.operation.inner_speed_rad_s / TAU;
    for (found, published) in [
        (passing.bpfi_hz, 5.4152),
        (passing.bpfo_hz, 3.5848),
        (passing.ftf_hz, 0.39828),
        (2.0 * passing.bsf_hz, 4.7135),
    ] {
        let error = found / n / published - 1.0;
        assert!(error.abs() < 1e-4, "{published}: {error}");
    }
}

/// Without a load there is no life, neither in the plane nor in space, whatever the search for the equilibrium
/// leaves of forces.
#[test]
fn no_load_has_no_life() {
    let mut case = conventional(dimensions());
    case.operation.radial_load_n = 0.0;
    let plane = Rating::new(&case, &solve(&case).unwrap());
    assert_eq!(plane.l10r_mrev, None);
    let space = cageless::equilibrium::space::solve(&case).unwrap();
    assert_eq!(Rating::in_space(&case, &space).l10r_mrev, None);
    case.operation.radial_load_n = 1.0;
    let space = cageless::equilibrium::space::solve(&case).unwrap();
    assert!(Rating::in_space(&case, &space).l10r_mrev.is_some());
}

/// An axial load alone: the balls orbit as the closed form has it at the contact angle of the loaded
/// bearing, not at the free one.
#[test]
fn passing_frequencies_of_the_loaded_bearing() {
    let mut case = conventional(dimensions());
    case.operation.radial_load_n = 0.0;
    case.operation.gravity_m_s2 = 0.0;
    case.operation.space.axial_load_n = 2000.0;
    let space = cageless::equilibrium::space::solve(&case).unwrap();
    let rating = Rating::in_space(&case, &space);
    let angle = rating.loaded_contact_angle_rad.unwrap();
    let at = PassingFrequencies::at_contact_angle(&case, angle);
    let orbit_hz = space.orbit_speed_rad_s[0] / TAU;
    assert!(angle > 0.1, "{angle}");
    assert!(
        (at.ftf_hz / orbit_hz - 1.0).abs() < 0.1 * (rating.passing.ftf_hz / orbit_hz - 1.0).abs(),
        "{angle}: {} {} {orbit_hz}",
        at.ftf_hz,
        rating.passing.ftf_hz
    );
    let n = case.operation.inner_speed_rad_s / TAU;
    let gamma = 9.525 / 46.005 * angle.cos();
    for (found, expected) in [
        (at.bpfo_hz, 7.0 * n * (1.0 - gamma)),
        (at.bpfi_hz, 7.0 * n * (1.0 + gamma)),
        (at.bsf_hz, 0.5 * n * 46.005 / 9.525 * (1.0 - gamma * gamma)),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
}

/// Orbits and rotations of a run: what they miss of FTF and BSF is the sliding in the contacts,
/// vt = (ωi Ri − ΔVi + ΔVo)/2 and ω Rw = (ωi Ri − ΔVi − ΔVo)/2.
#[test]
fn passing_frequencies_are_those_of_the_motion() {
    let mut case = conventional(dimensions());
    case.solver.duration_s = 0.02;
    let (mut rows, mut orbit, mut rotation, mut inner, mut outer) = (0.0, 0.0, 0.0, 0.0, 0.0);
    {
        let mut recorder = Recorder::new(5e-5, |s| {
            let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
            rows += 1.0;
            orbit += mean(&s.orbit_speed_rad_s) / TAU;
            rotation += mean(&s.rotation_rad_s) / TAU;
            inner += mean(&s.inner_sliding_m_s);
            outer += mean(&s.outer_sliding_m_s);
            Ok(())
        });
        run(&case, &mut [&mut recorder], &mut |_| {
            ControlFlow::Continue(())
        })
        .unwrap();
    }
    let [orbit, rotation, inner, outer] = [orbit, rotation, inner, outer].map(|sum| sum / rows);
    let bearing = &case.bearing;
    let passing = Rating::new(&case, &solve(&case).unwrap()).passing;
    let orbit_slip = (outer - inner) / (2.0 * TAU * bearing.pitch_radius_m());
    let rotation_slip = -(outer + inner) / (2.0 * TAU * bearing.ball_radius_m());
    let orbit_error = orbit / (passing.ftf_hz + orbit_slip) - 1.0;
    let bsf = passing.bsf_hz + orbit_slip + rotation_slip;
    let rotation_error = (orbit + rotation) / bsf - 1.0;
    assert!(
        orbit_error.abs() < 1e-3 && rotation_error.abs() < 1e-3,
        "{orbit_error} {rotation_error}"
    );
    // The slip itself is small: the closed forms are those of the motion within a few per cent.
    assert!(
        (orbit / passing.ftf_hz - 1.0).abs() < 0.03,
        "{orbit} {passing:?}"
    );
}

#[test]
fn what_no_bearing_stands_is_a_warning() {
    let warnings = |case: &Case| Rating::new(case, &solve(case).unwrap()).warnings();
    let mut case = conventional(dimensions());
    assert!(warnings(&case).is_empty());
    case.operation.radial_load_n = 20_000.0;
    assert!(warnings(&case)[0].contains("static safety"));
    case = conventional(dimensions());
    case.operation.inner_speed_rad_s = 1.01 * SPEED_PARAMETER_MAX_MM_RPM / 46.005 * TAU / 60.0;
    case.solver.step_s = 1e-7;
    assert!(
        warnings(&case)[0].contains("n·Dpw is 3.03 million"),
        "{:?}",
        warnings(&case)
    );
}

/// Largest pressure over 4200 MPa with all loads times a factor, by another way than the rating: a case of its own.
fn pressure_at(case: &Case, factor: f64) -> f64 {
    let mut case = case.clone();
    case.operation.radial_load_n *= factor;
    case.operation.space.axial_load_n *= factor;
    if let Tilt::Free { moment_x_n_m, .. } = case.operation.space.tilt {
        case.operation.space.tilt = Tilt::Free {
            moment_x_n_m: factor * moment_x_n_m,
            moment_y_n_m: 0.0,
        };
    }
    // What no contact or groove bears has no equilibrium.
    settle(&case).map_or(f64::INFINITY, |settled| {
        let rest = settled.rest;
        rest.inner_pressure_max_pa.max(rest.outer_pressure_max_pa) / 4.2e9
    })
}

/// The plain bearing of the paper under a radial load at a multiple of its speed.
fn loaded(load_n: f64, speed: f64) -> Case {
    let mut case = conventional(dimensions());
    case.operation.radial_load_n = load_n;
    case.operation.inner_speed_rad_s *= speed;
    case.solver.step_s = 1e-7;
    case
}

/// The factor on the loads by bisection of the pressure in equilibrium; in the plane, thrown out by the speed, beyond
/// the limit, and in space with a preload and with a moment. s0 = C0r/Fr.
#[test]
fn safeties_are_those_of_load_and_pressure() {
    let mut moment = loaded(600.0, 1.0);
    moment.operation.space.axial_load_n = 200.0;
    moment.operation.space.tilt = Tilt::Free {
        moment_x_n_m: 2.0,
        moment_y_n_m: 0.0,
    };
    let mut pair = loaded(300.0, 1.0);
    pair.bearing = bearing(14, 9.525, 46.0, 0.52)
        .with_contact_angle(0.26, 0.0)
        .unwrap();
    pair.rows = [-1.0, 1.0]
        .map(|side| Row {
            axial_position_m: 8e-3 * side,
            contact_sign: side,
            preload_m: 8e-6,
            ..Row::default()
        })
        .to_vec();
    for (case, solved) in [
        (loaded(500.0, 1.0), false),
        (loaded(10.0, 1.0), false),
        (loaded(170.0, 2.5), false),
        (loaded(30_000.0, 1.0), false),
        (moment, true),
        (pair, true),
    ] {
        let rating = match solved {
            true => Rating::in_space(&case, &solve_in_space(&case).unwrap()),
            false => Rating::new(&case, &solve(&case).unwrap()),
        };
        let found = rating.pressure_safety.unwrap();
        let [mut low, mut high] = [0.0, 1e4f64];
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match pressure_at(&case, middle) < 1.0 {
                true => low = middle,
                false => high = middle,
            }
        }
        assert!((found / low - 1.0).abs() < 1e-6, "{found} {low}");
        if let Some(s0) = rating.static_safety_factor {
            let load_n = rating.equivalent.unwrap().static_n;
            assert!((s0 * load_n / rating.basic.static_n - 1.0).abs() < 1e-12);
        }
    }
}

/// A ball takes less than its part of what is added, as more of them carry; no load has no factor, and what leaves its
/// groove before the limit neither.
#[test]
fn a_load_factor_is_not_that_of_one_ball() {
    let case = loaded(500.0, 1.0);
    let of_ball = pressure_at(&case, 1.0).powi(-3);
    let found = Rating::new(&case, &solve(&case).unwrap())
        .pressure_safety
        .unwrap();
    assert!((found / of_ball - 1.0).abs() > 0.01, "{found} {of_ball}");
    let none = loaded(0.0, 1.0);
    assert_eq!(
        Rating::new(&none, &solve(&none).unwrap()).pressure_safety,
        None
    );
    let mut shallow = dimensions();
    let pitch_m =
        0.5 * (shallow.inner_groove_bottom_radius_m + shallow.outer_groove_bottom_radius_m);
    shallow.outer_shoulder_radius_m = pitch_m + 0.93 * shallow.ball_radius_m;
    let mut axial = conventional(shallow);
    axial.operation.radial_load_n = 0.0;
    axial.operation.space.axial_load_n = 300.0;
    let rating = Rating::in_space(&axial, &solve_in_space(&axial).unwrap());
    assert_eq!(rating.pressure_safety, None);
}

/// Preload that neither ISO 281 nor ISO 76 knows leaves L10 and s0 as they are and takes most of L10r.
#[test]
fn a_life_that_preload_shortens_is_a_warning() {
    let warning = |interference_m: f64| {
        let mut tight = dimensions();
        tight.outer_groove_bottom_radius_m -= 0.5 * interference_m;
        let case = conventional(tight);
        let rating = Rating::new(&case, &solve(&case).unwrap());
        let ratio = rating.l10_mrev.unwrap() / rating.l10r_mrev.unwrap();
        let said = rating
            .warnings()
            .into_iter()
            .find(|w| w.starts_with("L10 is"));
        (ratio, said)
    };
    assert_eq!(warning(0.0).1, None);
    let (ratio, said) = warning(60e-6);
    assert!(ratio > 10.0, "{ratio}");
    assert!(
        said.unwrap()
            .starts_with(&format!("L10 is {ratio:.1} times L10r"))
    );
}

/// A closer groove than 0.52 Dw raises no dynamic rating, a wider one lowers it (ISO 281:2007, 5.1).
#[test]
fn closer_grooves_raise_no_rating() {
    let rating = |conformity: f64| {
        let bearing = bearing(9, 9.525, 46.0, conformity);
        let life = ReferenceLife::new(&bearing);
        (BasicRatings::new(&bearing).dynamic_n, life.inner_rating_n)
    };
    assert_eq!(rating(0.505), rating(0.52));
    assert!(rating(0.53).0 < 0.95 * rating(0.52).0);
    let notes = |conformity: f64| {
        let case = conventional(dimensions_of(9, 9.525, 46.0, conformity));
        Rating::new(&case, &solve(&case).unwrap()).has_close_grooves
    };
    assert_eq!([0.505, 0.52, 0.53].map(notes), [true, false, false]);
}

/// SKF's rule of a bearing of 6008 size under 2 kN: 0.5 · 0.0015 · 2000 N · 40 mm = 60 N·mm, from a
/// given bore; without one within 5 % of it.
#[test]
fn friction_torque_of_a_catalogue() {
    let mut case = conventional(dimensions_of(12, 7.9375, 54.0, 0.52));
    case.operation.radial_load_n = 2000.0;
    let estimated = skf_friction_torque_n_m(&case).unwrap();
    assert!((estimated / 0.06 - 1.0).abs() < 0.05, "{estimated}");
    let bore = InnerRingBore {
        polar_inertia_kg_m2: 1e-4,
        radius_m: 0.02,
    };
    case.bearing = case.bearing.with_inner_ring_bore(bore).unwrap();
    assert!((skf_friction_torque_n_m(&case).unwrap() - 0.06).abs() < 1e-15);
    // Under an axial load P is more than Fr.
    case.operation.space.axial_load_n = 2000.0;
    let load_n = EquivalentLoad::new(&case).unwrap().dynamic_n;
    let torque = skf_friction_torque_n_m(&case).unwrap();
    assert!((torque / (0.5 * 0.0015 * load_n * 0.04) - 1.0).abs() < 1e-12 && load_n > 3000.0);
    case.operation.space.axial_load_n = 0.0;
    case.bearing = case.bearing.with_contact_angle(0.4, 0.0).unwrap();
    assert_eq!(skf_friction_torque_n_m(&case), None);
}
