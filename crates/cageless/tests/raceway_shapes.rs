//! Shapes of the discrete raceway: closed forms, the model that moves on them, the ring that is made.

use cageless::design::{Eq11, theoretical_gap_rad};
use cageless::kinematics::raceway_delay_rad;
use cageless::recorder::Recorder;
use cageless::simulation::{Control, run};
use cageless::snapshot::Snapshot;
use cageless::surface::{OuterRing, OuterRingDimensions};
use cageless::{
    Bearing, Case, FlankModel, Gaps, IntegrationMethod, Motion, Profile, Raceway,
    RacewayDimensions, RacewayForm, RacewayShape, Start,
};

use crate::common::{STRUCTURES, complete, conventional, dimensions, steel, structure, undamped};

const FORMS: [RacewayForm; 6] = [
    form(RacewayShape::Quartic, 0.0),
    form(RacewayShape::Quartic, 0.5e-3),
    form(RacewayShape::Ellipse, 0.0),
    form(RacewayShape::Ellipse, 1e-3),
    form(RacewayShape::Shuttle, 0.0),
    form(RacewayShape::Shuttle, 0.5e-3),
];

const fn form(shape: RacewayShape, blend_m: f64) -> RacewayForm {
    RacewayForm { shape, blend_m }
}

fn bearing() -> Bearing {
    Bearing::new(dimensions(), steel()).unwrap()
}

fn formed(bearing: &Bearing, form: RacewayForm, centre_deg: f64) -> Raceway {
    let dimensions = RacewayDimensions {
        axial_span_m: 5.1e-3,
        half_angle_rad: 25.2f64.to_radians(),
        centre_angle_rad: centre_deg.to_radians(),
    };
    Raceway::formed(dimensions, form, bearing).unwrap()
}

fn case_of(form: RacewayForm) -> Case {
    let case = conventional(dimensions());
    let raceway = formed(&case.bearing, form, 0.0);
    case.with_raceways(vec![raceway])
}

fn outer_ring(raceways: &[Raceway], blend_m: f64) -> OuterRing {
    let dimensions = OuterRingDimensions {
        outer_ring_outer_radius_m: 31e-3,
        outer_ring_width_m: 16e-3,
        blend_m,
    };
    OuterRing::new(&bearing(), raceways, dimensions).unwrap()
}

/// αc of ellipse and shuttle by their formulas, with sin α0 = lC/(2 Rw).
#[test]
fn flank_angles_are_those_of_the_formulas() {
    let bearing = bearing();
    let theta = 25.2f64.to_radians();
    let middle = (2.55e-3 / bearing.ball_radius_m()).asin();
    for (shape, power) in [(RacewayShape::Ellipse, 0.5), (RacewayShape::Shuttle, 1.0)] {
        let form = RacewayForm {
            shape,
            blend_m: 0.0,
        };
        let raceway = formed(&bearing, form, 40.0);
        for k in -99..100 {
            let share = f64::from(k) / 100.0;
            let expected = middle * (1.0 - share * share).powf(power);
            let [angle, slope] = raceway.contact_angle_rad(theta * share);
            assert!((angle - expected).abs() < 1e-15, "{shape:?} {share}");
            let fall = -2.0 * power * middle * share / theta;
            let fall = fall * (1.0 - share * share).powf(power - 1.0);
            assert!((slope - fall).abs() < 1e-12, "{shape:?} {share}");
        }
        assert_eq!(raceway.contact_angle_rad(theta)[0], 0.0);
    }
}

/// r = Rw cos αc all along, dαc/dψ is the slope of αc, and αc falls steadily to 0.
#[test]
fn one_function_defines_a_raceway() {
    let bearing = bearing();
    let rw = bearing.ball_radius_m();
    for form in FORMS {
        let raceway = formed(&bearing, form, 40.0);
        let (theta, centre) = (raceway.half_angle_rad(), 40f64.to_radians());
        let angle = |psi: f64| raceway.contact_angle_rad(psi)[0];
        assert!((angle(0.0).sin() - 2.55e-3 / rw).abs() < 1e-12, "{form:?}");
        let mut last = f64::INFINITY;
        for k in 0..4000 {
            let psi = theta * (f64::from(k) + 0.5) / 4000.0;
            let [here, slope] = raceway.contact_angle_rad(psi);
            assert!(here <= last && here >= 0.0, "{form:?} {psi}");
            last = here;
            assert_eq!(raceway.contact_angle_rad(-psi), [here, -slope]);
            for side in [1.0, -1.0] {
                let r = raceway.effective_radius_m(centre + side * psi);
                assert!((r - rw * here.cos()).abs() < 1e-15, "{form:?} {psi}");
            }
            let h = 2e-5 * (theta - psi);
            if h > 1e-8 {
                let rise = (angle(psi + h) - angle(psi - h)) / (2.0 * h);
                let scale = 1.0 + slope.abs();
                assert!((slope - rise).abs() < 1e-5 * scale, "{form:?} {psi}");
            }
        }
        assert_eq!(raceway.effective_radius_m(centre + theta), rw);
    }
}

/// A blend leaves the rest of the raceway alone and continues it with slope and second derivative,
/// and so it does with the plain raceway.
#[test]
fn blends_are_smooth_at_both_ends() {
    let bearing = bearing();
    for shape in [
        RacewayShape::Quartic,
        RacewayShape::Ellipse,
        RacewayShape::Shuttle,
    ] {
        let blend_m = 1e-3;
        let blended = formed(&bearing, RacewayForm { shape, blend_m }, 0.0);
        let whole = blended.clone().with_blend(0.0).unwrap();
        let start = blended.blend_start_rad().unwrap();
        let theta = blended.half_angle_rad();
        let ro = bearing.dimensions().outer_groove_bottom_radius_m;
        assert!((start - theta + blend_m / ro).abs() < 1e-15);
        for psi in [0.0, 0.1, 0.3, start * (1.0 - 1e-9)] {
            assert_eq!(
                blended.effective_radius_m(psi),
                whole.effective_radius_m(psi)
            );
            assert_eq!(blended.contact_angle_rad(psi), whole.contact_angle_rad(psi));
        }
        let at = |psi: f64| blended.contact_angle_rad(psi);
        let [before, after] = [at(start), at(start * (1.0 + 1e-15))];
        assert!((before[0] - after[0]).abs() < 1e-14);
        assert!((before[1] - after[1]).abs() < 1e-12 * before[1].abs());
        let h = 1e-3 * (theta - start);
        // One-sided, of second order.
        let bend = |h: f64| {
            (4.0 * at(start + h)[1] - at(start + 2.0 * h)[1] - 3.0 * at(start)[1]) / (2.0 * h)
        };
        let scale = at(start)[0] / (theta - start).powi(2);
        let [within, beyond] = [bend(-h), bend(h)];
        assert!(
            (within - beyond).abs() < 1e-3 * scale,
            "{shape:?} {within} {beyond} {scale}"
        );
        assert_eq!(at(theta), [0.0, 0.0]);
        assert!(at(theta - h)[0] < 1e-7 * at(start)[0]);
        assert!(blended.kink_angle_rad(std::f64::consts::FRAC_PI_4) < 1e-12);
        assert!(whole.kink_angle_rad(std::f64::consts::FRAC_PI_4) > 1e-2);
    }
}

/// The lag, with (Rw + r)/(2 r) − 1 of Eq. (11) integrated over αc of the formulas: substitution and
/// rule differ from those of the library.
#[test]
fn lags_are_integrals_of_the_flank_angle() {
    let bearing = bearing();
    let theta = 25.2f64.to_radians();
    let middle = (2.55e-3 / bearing.ball_radius_m()).asin();
    let excess = |angle: f64| 0.5 * (1.0 / angle.cos() - 1.0);
    let simpson = |f: &dyn Fn(f64) -> f64, a: f64, b: f64| {
        let n = 4000;
        let h = (b - a) / f64::from(n);
        let weight = |k: i32| {
            if k == 0 || k == n {
                1.0
            } else {
                f64::from(2 + 2 * (k % 2))
            }
        };
        let terms = (0..=n).map(|k| weight(k) * f(a + f64::from(k) * h));
        terms.sum::<f64>() * h / 3.0
    };
    for form in FORMS {
        let raceway = formed(&bearing, form, 40.0);
        // ψ = θ sin u has no root at the ends.
        let half = |power: i32, to: f64| {
            let f = |u: f64| theta * u.cos() * excess(middle * u.cos().powi(power));
            simpson(&f, 0.0, (to / theta).asin())
        };
        let by_angle = |from: f64, to: f64| {
            simpson(&|psi| excess(raceway.contact_angle_rad(psi)[0]), from, to)
        };
        let start = raceway.blend_start_rad().unwrap_or(theta);
        let inner = match form.shape {
            RacewayShape::Quartic => by_angle(0.0, start),
            RacewayShape::Ellipse => half(1, start),
            RacewayShape::Shuttle => half(2, start),
        };
        let expected = 2.0 * (inner + by_angle(start, theta));
        let lag = raceway_delay_rad(&bearing, std::slice::from_ref(&raceway));
        assert!((lag - expected).abs() < 1e-12, "{form:?}: {lag} {expected}");
        // β0 over the polar angle is the same integral within ±ε/2.
        let end = 0.5 * bearing.ball_angle_rad();
        assert!(end < start);
        let polar = theoretical_gap_rad(&bearing, &raceway, Eq11::Polar);
        let gap = 2.0 * by_angle(0.0, end);
        assert!((polar - gap).abs() < 1e-12, "{form:?}: {polar} {gap}");
        let published = theoretical_gap_rad(&bearing, &raceway, Eq11::Published);
        assert!((published - polar).abs() < 0.05 * polar, "{form:?}");
    }
}

/// What balls feel in a run is r = Rw cos αc of the ring that is exported, from the case with the
/// blend or from the kinked one blended by the exporter.
#[test]
fn what_is_simulated_is_what_is_machined() {
    for form in FORMS {
        let case = case_of(form);
        let ring = match form.shape {
            RacewayShape::Quartic => outer_ring(
                &[formed(&case.bearing, RacewayForm::default(), 0.0)],
                form.blend_m,
            ),
            _ => outer_ring(&case.raceways, 0.0),
        };
        assert_eq!(ring.raceways().next().unwrap().form(), form);
        assert_eq!(ring.blend_m(), form.blend_m);
        let rw = case.bearing.ball_radius_m();
        let (mut inside, mut blended) = (0, 0);
        let start = case.raceways[0].blend_start_rad().unwrap_or(f64::INFINITY);
        let mut recorder = Recorder::new(2e-6, |s: Snapshot| {
            for (psi, r) in s.angle_rad.iter().zip(&s.effective_radius_m) {
                let meridian = ring.meridian(*psi);
                let angle = meridian.arcs[0].contact_angle_rad;
                assert!((r - rw * angle.cos()).abs() < 1e-12, "{form:?} {psi}");
                inside += i32::from(angle > 0.0);
                let local = case.raceways[0].local_angle_rad(*psi).abs();
                blended += i32::from(angle > 0.0 && local > start);
            }
            Ok(())
        });
        let mut case = case.clone();
        case.solver.duration_s = 2e-3;
        run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
        assert!(inside > 1000);
        assert_eq!(blended > 20, form.blend_m > 0.0, "{form:?} {blended}");
    }
}

/// What the ledger misses with a step of the leapfrog method, from balls that slide at the start.
fn residual(case: &Case, step_us: f64) -> f64 {
    let mut case = case.clone();
    case.start = Start::Rolling {
        gaps: Gaps::Uniform,
        lead_ball_angle_rad: 0.3,
        ring_x_m: 1e-6,
        ring_y_m: -15e-6,
    };
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = step_us * 1e-6;
    case.solver.duration_s = 0.004;
    complete(&case).energy_residual_relative.abs()
}

/// The ledger of a blended raceway closes to second order in the step, in the plane on flanks of
/// both models and in space; of the other shapes on flanks that push along ψ as well.
#[test]
fn ledgers_close_to_second_order() {
    let blend_m = 0.5e-3;
    let quartic = RacewayForm {
        blend_m,
        ..RacewayForm::default()
    };
    let rigid = undamped(case_of(quartic));
    let elastic = |form| {
        let mut case = undamped(case_of(form));
        case.flanks = FlankModel::Elastic;
        case
    };
    let mut space = rigid.clone();
    space.motion = Motion::Space;
    space.operation.space.axial_load_n = 100.0;
    let shuttle = RacewayForm {
        shape: RacewayShape::Shuttle,
        blend_m,
    };
    for (name, case) in [
        ("rigid", rigid),
        ("elastic", elastic(quartic)),
        ("shuttle", elastic(shuttle)),
        ("space", space),
    ] {
        let residuals = [1.0, 0.5, 0.25].map(|step_us| residual(&case, step_us));
        assert!(residuals[0] < 1e-2, "{name} {residuals:?}");
        assert!(
            (1..3).all(|k| residuals[k - 1] > 3.0 * residuals[k]),
            "{name} {residuals:?}"
        );
    }
}

/// Over a blended raceway the spin of the balls converges to that of a method of high order, to second
/// order.
#[test]
fn motion_through_a_blend_converges_to_second_order() {
    // Of an ellipse without blends dr/dψ jumps at the ends.
    let ellipse = form(RacewayShape::Ellipse, 0.0);
    for form in FORMS.iter().filter(|form| **form != ellipse) {
        let mut case = case_of(*form);
        case.solver.method = IntegrationMethod::Abm4;
        case.solver.step_s = 0.05e-6;
        case.solver.duration_s = 0.001;
        let truth = complete(&case).state;
        let miss = |step_us: f64| {
            let mut case = case.clone();
            case.solver.method = IntegrationMethod::VelocityVerlet;
            case.solver.step_s = step_us * 1e-6;
            let state = complete(&case).state;
            let spins = (0..14).map(|k| state.ball_motion(k).spin - truth.ball_motion(k).spin);
            spins.map(f64::abs).fold(0.0, f64::max)
        };
        let misses = [2.0, 1.0, 0.5].map(miss);
        assert!(
            (1..3).all(|k| misses[k - 1] > 3.0 * misses[k]),
            "{form:?} {misses:?}"
        );
    }
}

/// Each is refused by the name of its field.
#[test]
fn forms_that_cannot_be_are_refused() {
    let bearing = bearing();
    let dimensions = *formed(&bearing, RacewayForm::default(), 0.0).dimensions();
    let refused = |shape, blend_m| {
        let form = RacewayForm { shape, blend_m };
        Raceway::formed(dimensions, form, &bearing).unwrap_err()
    };
    for blend_m in [-1e-3, f64::NAN, f64::INFINITY, 1e-6, 20e-3] {
        assert_eq!(refused(RacewayShape::Quartic, blend_m).field, "blend_m");
        assert_eq!(refused(RacewayShape::Ellipse, blend_m).field, "blend_m");
    }
    let wide = RacewayDimensions {
        axial_span_m: 7.5e-3,
        ..dimensions
    };
    for form in FORMS {
        let error = Raceway::formed(wide, form, &bearing).unwrap_err();
        assert_eq!(error.field, "axial_span_m");
    }
    // Only the physical profile has them.
    for (form, field) in [
        (FORMS[1], "blend_m"),
        (FORMS[2], "shape"),
        (FORMS[5], "shape"),
    ] {
        let mut case = case_of(form);
        case.check().unwrap();
        case.profile = Profile::Paper;
        assert_eq!(case.check().unwrap_err().field, field);
    }
    let mut case = structure(5.1, 25.2);
    case.profile = Profile::Paper;
    case.check().unwrap();
}

/// A shape needs no path of the paper: an angle that Eq. (9) refuses is one of the others.
#[test]
fn shapes_are_not_bound_to_the_path_of_the_paper() {
    let bearing = bearing();
    let dimensions = RacewayDimensions {
        axial_span_m: 2e-3,
        half_angle_rad: 50f64.to_radians(),
        centre_angle_rad: 0.0,
    };
    assert_eq!(
        Raceway::new(dimensions, &bearing).unwrap_err().field,
        "half_angle_rad"
    );
    for form in &FORMS[2..] {
        Raceway::formed(dimensions, *form, &bearing).unwrap();
    }
    // Every structure of the paper takes the blend of its exported ring.
    for (span, angle, ..) in STRUCTURES {
        let case = structure(span, angle);
        case.raceways[0].clone().with_blend(0.5e-3).unwrap();
        assert!(matches!(case.start, Start::Settled { .. }));
    }
}
