//! Shapes of the discrete raceway: closed forms, the model that moves on them, the ring that is made.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use cageless::closed_forms::{Eq11, theoretical_gap_rad};
use cageless::kinematics::{raceway_delay_rad, rolling_orbit_speed_rad_s, speed_change_max};
use cageless::numerics::random::RandomStream;
use cageless::outer_contact_geometry::outer_contact_geometry;
use cageless::raceway::{MeasuredFlanks, SplineFlanks};
use cageless::recorder::Recorder;
use cageless::simulation::{Control, run};
use cageless::snapshot::Snapshot;
use cageless::surface::{OuterRing, OuterRingDimensions};
use cageless::{
    Bearing, Case, Ends, FlankModel, Formulation, Gaps, IntegrationMethod, Motion, Raceway,
    RacewayDimensions, RacewayForm, RacewayShape, Start, StartState,
};

use crate::common::{complete, conventional, dimensions, steel, structure, structures, undamped};

/// Every shape with and without blends.
fn forms() -> [RacewayForm; 12] {
    [
        form(RacewayShape::Quartic, 0.0),
        form(RacewayShape::Quartic, 0.5e-3),
        form(RacewayShape::Ellipse, 0.0),
        form(RacewayShape::Ellipse, 1e-3),
        form(RacewayShape::Shuttle, 0.0),
        form(RacewayShape::Shuttle, 0.5e-3),
        form(RacewayShape::Steady, 0.0),
        form(RacewayShape::Steady, 0.5e-3),
        form(RacewayShape::Measured, 0.0),
        form(RacewayShape::Measured, 0.5e-3),
        form(RacewayShape::Spline, 0.0),
        form(RacewayShape::Spline, 0.5e-3),
    ]
}

/// A form; what is measured is a ring with the quartic path, through points of which a spline leads as well.
fn form(shape: RacewayShape, blend_m: f64) -> RacewayForm {
    let paper = || formed(&bearing(), RacewayForm::default(), 0.0);
    let spline = || SplineFlanks::through(&one_side(&paper(), 10)).unwrap();
    RacewayForm {
        shape,
        measured: (shape == RacewayShape::Measured).then(|| measured(&paper(), 40)),
        spline: (shape == RacewayShape::Spline).then(spline),
        ends: Ends::Blended(blend_m),
        depth_m: 0.0,
        edge_radius_m: 0.0,
        slot_depth_m: None,
    }
}

/// ψ and αc at `intervals` + 1 places from end to end.
fn points(raceway: &Raceway, intervals: i32) -> Vec<[f64; 2]> {
    let theta = raceway.half_angle_rad();
    let at = |k: i32| theta * (f64::from(2 * k) / f64::from(intervals) - 1.0);
    let point = |psi: f64| [psi, raceway.contact_angle_rad(psi)[0]];
    (0..=intervals).map(|k| point(at(k))).collect()
}

/// ψ and αc at `intervals` + 1 places from the middle to an end.
fn one_side(raceway: &Raceway, intervals: i32) -> Vec<[f64; 2]> {
    points(raceway, 2 * intervals).split_off(intervals as usize)
}

fn measured(raceway: &Raceway, intervals: i32) -> MeasuredFlanks {
    MeasuredFlanks::fit(&points(raceway, intervals)).unwrap()
}

fn lag(raceway: &Raceway) -> f64 {
    raceway_delay_rad(&bearing(), std::slice::from_ref(raceway))
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

/// Machined ends are blended over 0.5 mm, or a fifth of half the raceway; slots and measured raceways have their own.
#[test]
fn machined_ends_are_those_of_the_drawing() {
    let bearing = bearing();
    let of = |shape, angle_deg: f64| {
        let machined = RacewayForm {
            ends: Ends::Machined,
            ..form(shape, 0.0)
        };
        let dimensions = RacewayDimensions {
            axial_span_m: 5.1e-3,
            half_angle_rad: angle_deg.to_radians(),
            centre_angle_rad: 0.0,
        };
        Raceway::formed(dimensions, machined, &bearing)
            .unwrap()
            .blend_m()
    };
    let short = 0.2 * 4f64.to_radians() * 27.765e-3;
    for shape in [
        RacewayShape::Ellipse,
        RacewayShape::Shuttle,
        RacewayShape::Steady,
    ] {
        assert_eq!(of(shape, 25.2), 0.5e-3, "{shape:?}");
        assert!((of(shape, 4.0) - short).abs() < 1e-15, "{shape:?}");
    }
    assert_eq!(of(RacewayShape::Quartic, 25.2), 0.5e-3);
    assert_eq!(of(RacewayShape::Measured, 25.2), 0.0);
    let mut slot = crate::common::slotted().raceways[0].clone();
    slot = slot.with_ends(Ends::Machined).unwrap();
    assert_eq!(slot.blend_m(), 0.0);
}

/// αc of ellipse and shuttle by their formulas, with sin α0 = lC/(2 Rw).
#[test]
fn flank_angles_are_those_of_the_formulas() {
    let bearing = bearing();
    let theta = 25.2f64.to_radians();
    let middle = (2.55e-3 / bearing.ball_radius_m()).asin();
    for (shape, power) in [(RacewayShape::Ellipse, 0.5), (RacewayShape::Shuttle, 1.0)] {
        let raceway = formed(&bearing, form(shape, 0.0), 40.0);
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

/// ln Ω of a ball that rolls over a steady raceway has a slope that grows over the first 35 %, is the
/// same up to 90 % and falls to 0 at the end.
#[test]
fn the_orbital_speed_changes_at_a_constant_rate() {
    let bearing = bearing();
    let raceway = formed(&bearing, form(RacewayShape::Steady, 0.0), 40.0);
    let (theta, centre) = (raceway.half_angle_rad(), 40f64.to_radians());
    let speed = |psi: f64| {
        let r = raceway.effective_radius_m(centre + psi);
        rolling_orbit_speed_rad_s(&bearing, 1.0, r).ln()
    };
    let h = 1e-4;
    let slope = |share: f64| (speed(theta * share + h) - speed(theta * share - h)) / (2.0 * h);
    let rate = slope(0.5);
    // Over the parts the mean slope is 0.775 of the largest, and the whole is what α0 takes off.
    assert!((speed(theta) - speed(0.0) - 0.775 * rate * theta).abs() < 1e-11);
    for (share, part) in [
        (0.035, 0.1),
        (0.175, 0.5),
        (0.343, 0.98),
        (0.36, 1.0),
        (0.7, 1.0),
        (0.89, 1.0),
        (0.92, 0.8),
        (0.98, 0.2),
    ] {
        let found = slope(share) / rate;
        assert!((found - part).abs() < 1e-8, "{share}: {found}");
    }
    // Less is asked of friction than by the path of the paper of the same lag, which the same lC has not.
    let quartic = formed(&bearing, RacewayForm::default(), 40.0);
    let [most, least] = [&quartic, &raceway].map(|raceway| speed_change_max(&bearing, raceway));
    assert!((least - rate).abs() < 1e-6 * rate, "{least} {rate}");
    let scaled = least * lag(&quartic) / lag(&raceway);
    assert!(scaled < 0.82 * most, "{scaled} {most}");
}

/// r = Rw cos αc all along, dαc/dψ is the slope of αc, and αc falls steadily to 0.
#[test]
fn one_function_defines_a_raceway() {
    let bearing = bearing();
    let rw = bearing.ball_radius_m();
    for form in forms() {
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
        RacewayShape::Steady,
        RacewayShape::Measured,
        RacewayShape::Spline,
    ] {
        let blend_m = 1e-3;
        let blended = formed(&bearing, form(shape, blend_m), 0.0);
        let whole = blended.clone().with_ends(Ends::default()).unwrap();
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
    for form in forms() {
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
            RacewayShape::Quartic | RacewayShape::Measured | RacewayShape::Spline => {
                by_angle(0.0, start)
            }
            RacewayShape::Steady => {
                let junctions = [0.0, 0.35 * theta, (0.9 * theta).min(start), start];
                junctions
                    .windows(2)
                    .map(|ends| by_angle(ends[0], ends[1]))
                    .sum()
            }
            RacewayShape::Ellipse | RacewayShape::Slot => half(1, start),
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
    for form in forms() {
        let case = case_of(form);
        let ring = match form.shape {
            RacewayShape::Quartic => outer_ring(
                &[formed(&case.bearing, RacewayForm::default(), 0.0)],
                case.raceways[0].blend_m(),
            ),
            _ => outer_ring(&case.raceways, 0.0),
        };
        assert_eq!(ring.raceways().next().unwrap().form(), form);
        assert_eq!(ring.blend_m(), case.raceways[0].blend_m());
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
        assert_eq!(
            blended > 20,
            case.raceways[0].blend_m() > 0.0,
            "{form:?} {blended}"
        );
    }
}

/// What the ledger misses with a step of the leapfrog method, from balls that slide at the start.
fn residual(case: &Case, step_us: f64) -> f64 {
    let mut case = case.clone();
    case.start = Start::new(
        StartState::Rolling {
            ring_x_m: 1e-6,
            ring_y_m: -15e-6,
        },
        Gaps::Uniform,
        0.3,
    );
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
        ends: Ends::Blended(blend_m),
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
    let shuttle = form(RacewayShape::Shuttle, blend_m);
    let spline = form(RacewayShape::Spline, blend_m);
    for (name, case) in [
        ("rigid", rigid),
        ("elastic", elastic(quartic)),
        ("shuttle", elastic(shuttle)),
        ("spline", elastic(spline)),
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
    for form in forms().into_iter().filter(|form| *form != ellipse) {
        let mut case = case_of(form);
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
    let refused =
        |shape, blend_m| Raceway::formed(dimensions, form(shape, blend_m), &bearing).unwrap_err();
    for blend_m in [-1e-3, f64::NAN, f64::INFINITY, 1e-6, 20e-3] {
        assert_eq!(refused(RacewayShape::Quartic, blend_m).field, "blend_m");
        assert_eq!(refused(RacewayShape::Ellipse, blend_m).field, "blend_m");
    }
    let wide = RacewayDimensions {
        axial_span_m: 7.5e-3,
        ..dimensions
    };
    for form in forms() {
        let error = Raceway::formed(wide, form, &bearing).unwrap_err();
        assert_eq!(error.field, "axial_span_m");
    }
    // Only the physical formulation has them.
    for (form, field) in [
        (form(RacewayShape::Quartic, 0.5e-3), "blend_m"),
        (form(RacewayShape::Ellipse, 0.0), "shape"),
        (form(RacewayShape::Shuttle, 0.5e-3), "shape"),
        (form(RacewayShape::Measured, 0.0), "shape"),
    ] {
        let mut case = case_of(form);
        case.check().unwrap();
        case.formulation = Formulation::Paper;
        assert_eq!(case.check().unwrap_err().field, field);
    }
    let mut case = structure(5.1, 25.2);
    case.formulation = Formulation::Paper;
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
    for form in &forms()[2..] {
        Raceway::formed(dimensions, *form, &bearing).unwrap();
    }
    // Every structure of the paper takes the blend of its exported ring.
    for (span, angle, ..) in structures() {
        let case = structure(span, angle);
        case.raceways[0]
            .clone()
            .with_ends(Ends::Blended(0.5e-3))
            .unwrap();
        assert!(case.start.state == StartState::Settled);
    }
}

/// Points of a formula are fitted to rounding, with the power of the formula, from one side or from
/// both; those of the quartic path by a polynomial.
#[test]
fn points_of_every_shape_are_fitted() {
    let bearing = bearing();
    for form in forms()
        .into_iter()
        .filter(|form| form.ends == Ends::default())
    {
        let raceway = formed(&bearing, form, 0.0);
        let fit = measured(&raceway, 40);
        let allowed = match form.shape {
            RacewayShape::Quartic => 2e-6,
            RacewayShape::Spline => 1e-4,
            RacewayShape::Steady => 1e-2,
            _ => 1e-12,
        };
        let [rms, largest] = fit.deviation_rad;
        assert!(rms <= largest && largest < allowed, "{form:?} {largest:e}");
        assert!((fit.axial_span_m(bearing.ball_radius_m()) - 5.1e-3).abs() < 5e-3 * allowed);
        assert!((fit.half_angle_rad() - raceway.half_angle_rad()).abs() < 1e-15);
        let one_side = points(&raceway, 40).split_off(20);
        let half = MeasuredFlanks::fit(&one_side).unwrap();
        assert!((half.middle_rad() - fit.middle_rad()).abs() < 10.0 * allowed);
    }
    // Between the points as well.
    let kinked = formed(&bearing, RacewayForm::default(), 0.0);
    let fitted = formed(&bearing, form(RacewayShape::Measured, 0.0), 0.0);
    for k in 0..500 {
        let psi = kinked.half_angle_rad() * f64::from(k) / 500.0;
        let miss = kinked.contact_angle_rad(psi)[0] - fitted.contact_angle_rad(psi)[0];
        assert!(miss.abs() < 4e-6, "{psi} {miss:e}");
    }
    assert!((lag(&kinked) - lag(&fitted)).abs() < 1e-7);
}

/// Errors of 0.05° at 41 points of the quartic path, a few micrometres at the flanks, leave the lag
/// within 0.01° and show as the deviation.
#[test]
fn noise_averages_out() {
    let bearing = bearing();
    let kinked = formed(&bearing, RacewayForm::default(), 0.0);
    let sigma = 0.05f64.to_radians();
    for seed in 0..20 {
        let mut random = RandomStream::new(seed, 0, 0, 0);
        let mut rows = points(&kinked, 40);
        rows[1..40]
            .iter_mut()
            .for_each(|row| row[1] += sigma * random.normal());
        let fit = MeasuredFlanks::fit(&rows).unwrap();
        let [rms, largest] = fit.deviation_rad;
        assert!(rms > 0.6 * sigma && rms < 1.4 * sigma, "{seed} {rms}");
        assert!(largest > rms && largest < 4.0 * sigma, "{seed} {largest}");
        let dimensions = RacewayDimensions {
            axial_span_m: fit.axial_span_m(bearing.ball_radius_m()),
            ..*kinked.dimensions()
        };
        let form = RacewayForm {
            measured: Some(fit),
            ..form(RacewayShape::Measured, 0.0)
        };
        let raceway = Raceway::formed(dimensions, form, &bearing).unwrap();
        let miss = (lag(&raceway) - lag(&kinked)).to_degrees();
        assert!(miss.abs() < 0.01, "{seed} {miss}");
    }
}

/// A middle that is flat but for the errors of its points is fitted by a function that falls.
#[test]
fn a_flat_middle_does_not_rise() {
    for seed in 0..20 {
        let mut random = RandomStream::new(seed, 0, 0, 0);
        let angle = |share: f64| 0.3 * (1.0 - share.powi(8));
        let mut row = |k: i32| {
            let share = f64::from(k) / 30.0;
            [
                0.4 * share,
                angle(share) + if k < 30 { 2e-3 * random.normal() } else { 0.0 },
            ]
        };
        let rows: Vec<_> = (0..=30).map(&mut row).collect();
        let fit = MeasuredFlanks::fit(&rows).unwrap();
        let dimensions = RacewayDimensions {
            axial_span_m: fit.axial_span_m(4.7625e-3),
            half_angle_rad: fit.half_angle_rad(),
            centre_angle_rad: 0.0,
        };
        let form = RacewayForm {
            measured: Some(fit),
            ..form(RacewayShape::Measured, 0.0)
        };
        let raceway = Raceway::formed(dimensions, form, &bearing()).unwrap();
        for k in 0..1000 {
            let [angle, slope] = raceway.contact_angle_rad(4e-4 * f64::from(k));
            assert!(angle > 0.0 && slope <= 0.0, "{seed} {k} {angle} {slope}");
        }
    }
}

/// Points of no raceway, and shapes with the points of another.
#[test]
fn points_that_cannot_be_are_refused() {
    let bearing = bearing();
    let good = points(&formed(&bearing, RacewayForm::default(), 0.0), 10);
    let with = |index: usize, row: [f64; 2]| {
        let mut rows = good.clone();
        rows[index] = row;
        rows
    };
    let rising = |[psi, angle]: &[f64; 2]| [*psi, if *angle > 0.0 { 0.3 - angle } else { 0.0 }];
    for rows in [
        good[..4].to_vec(),
        with(3, [f64::NAN, 0.1]),
        with(3, [0.1, 2.0]),
        with(10, [good[10][0], 0.05]),
        good[1..10].to_vec(),
        vec![[0.0, 0.0]; 6],
        good.iter().map(rising).collect(),
    ] {
        let error = MeasuredFlanks::fit(&rows).unwrap_err();
        assert_eq!(error.field, "profile", "{rows:?}");
    }
    let dimensions = *formed(&bearing, RacewayForm::default(), 0.0).dimensions();
    for (shape, measured) in [
        (RacewayShape::Measured, None),
        (
            RacewayShape::Shuttle,
            form(RacewayShape::Measured, 0.0).measured,
        ),
    ] {
        let form = RacewayForm {
            measured,
            ..form(shape, 0.0)
        };
        let error = Raceway::formed(dimensions, form, &bearing).unwrap_err();
        assert_eq!(error.field, "profile");
    }
}

/// A spline meets its rows, is flat in the middle and lags like the path whose points they are, up to the kink
/// at its ends.
#[test]
fn a_spline_leads_through_its_rows() {
    let bearing = bearing();
    let kinked = formed(&bearing, RacewayForm::default(), 0.0);
    let rows = one_side(&kinked, 10);
    let spline = form(RacewayShape::Spline, 0.0);
    let raceway = formed(&bearing, spline, 0.0);
    for [psi, angle] in &rows {
        let [found, slope] = raceway.contact_angle_rad(*psi);
        assert!((found - angle).abs() < 1e-15, "{psi}");
        // No jumps of the slope or its slope.
        let beside = [-1e-7, 1e-7].map(|step| raceway.contact_angle_rad(psi + step)[1]);
        if (1e-6..raceway.half_angle_rad() - 1e-6).contains(psi) {
            let bends = beside.map(|other| (other - slope).abs() * 1e7);
            assert!((bends[0] - bends[1]).abs() < 1e-3, "{psi} {bends:?}");
        }
    }
    assert_eq!(raceway.contact_angle_rad(0.0)[1], 0.0);
    let miss = (lag(&raceway) - lag(&kinked)).to_degrees();
    assert!(miss.abs() < 1e-3, "{miss}");
    let [kink, own] = [&raceway, &kinked].map(|r| r.kink_angle_rad(0.78));
    assert!((kink / own - 1.0).abs() < 0.01, "{kink} {own}");
}

/// What is no spline through rows of one side is refused with what is missing.
#[test]
fn splines_that_cannot_be_are_refused() {
    let good = one_side(&formed(&bearing(), RacewayForm::default(), 0.0), 6);
    let with = |index: usize, row: [f64; 2]| {
        let mut rows = good.clone();
        rows[index] = row;
        rows
    };
    for (rows, rule) in [
        (good[..4].to_vec(), "5 to 30 rows"),
        (good.repeat(5), "5 to 30 rows"),
        (good[..6].to_vec(), "to its end"),
        (good[1..].to_vec(), "from the middle"),
        (with(2, [0.1, 1.6]), "less than 90°"),
        (with(2, [f64::NAN, 0.1]), "less than 90°"),
        (with(2, [-0.1, 0.1]), "of one side"),
        (with(2, good[1]), "less than before"),
        (with(1, [0.07, 0.03]), "less than before"),
        (with(3, [0.22, 0.299]), "falls as well"),
    ] {
        let error = SplineFlanks::through(&rows).unwrap_err();
        assert_eq!(error.field, "profile");
        assert!(error.to_string().contains(rule), "{rule}: {error} {rows:?}");
    }
}

/// A ball in a raceway of some depth sits deeper by that in the middle and as far out as on the plain
/// raceway at the ends, to which it comes without a kink; it rolls on the same radius.
#[test]
fn a_depth_runs_out_at_the_ends() {
    let case = structure(5.1, 25.2);
    let flush = &case.raceways[0];
    let deep = flush.clone().with_depth(20e-6).unwrap();
    let (centre, theta) = (0.0, flush.half_angle_rad());
    assert_eq!(deep.depth_at_m(centre), [20e-6, 0.0]);
    for share in [-1.0, 1.0, 1.5] {
        assert_eq!(deep.depth_at_m(centre + share * theta), [0.0; 2]);
    }
    let place = |raceway: &Raceway, psi: f64| {
        let raceways = std::slice::from_ref(raceway);
        outer_contact_geometry(&case.bearing, raceways, psi, case.bearing.ball_radius_m())
    };
    let ring = |raceway: &Raceway| outer_ring(std::slice::from_ref(raceway), 0.0);
    for psi in [-0.4, -0.1, 0.05, 0.3, 0.43] {
        let [depth, slope] = deep.depth_at_m(psi);
        let [before, after] = [-1e-6, 1e-6].map(|step| deep.depth_at_m(psi + step)[0]);
        assert!((slope - (after - before) / 2e-6).abs() < 1e-9, "{psi}");
        let (one, other) = (place(&deep, psi), place(flush, psi));
        let deeper = one.outer_orbit_radius_m - other.outer_orbit_radius_m;
        assert!((deeper - depth).abs() < 1e-17, "{psi}");
        assert_eq!(one.effective_radius_m, other.effective_radius_m);
        // The surface is that of the flush raceway, moved outwards.
        let [a, b] = [&deep, flush].map(|r| ring(r).point(psi, 0.6).position_m);
        assert!((a[0].hypot(a[1]) - b[0].hypot(b[1]) - depth).abs() < 1e-15);
        assert!((a[2] - b[2]).abs() < 1e-15);
    }
    for depth in [-1e-6, 0.2e-3, f64::NAN] {
        let refused = flush.clone().with_depth(depth).unwrap_err();
        assert_eq!(refused.field, "depth_m");
    }
    let mut paper = case.with_raceways(vec![deep]);
    paper.formulation = Formulation::Paper;
    assert_eq!(paper.check().unwrap_err().field, "depth_m");
}

/// Flanks that end at a right angle: sin αc αc′ has a limit there, α0²/θ of the ellipse and sin² α0 Ro/ρ of a slot
/// with ρ = (Rw + re) sin α0, and Ω changes by half of that per radian. The slope discontinuity is 90°.
#[test]
fn ends_at_a_right_angle_have_their_limits() {
    let bearing = bearing();
    let d = dimensions();
    let of = |span_m: f64, half_angle_deg: f64, form| {
        let dimensions = RacewayDimensions {
            axial_span_m: span_m,
            half_angle_rad: half_angle_deg.to_radians(),
            centre_angle_rad: 0.0,
        };
        Raceway::formed(dimensions, form, &bearing).unwrap()
    };
    let close = |found: f64, expected: f64| {
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    };
    for (span_mm, half_angle_deg) in [(4.585, 25.2), (3.0, 40.0), (5.0, 20.0), (6.5, 25.2)] {
        let span_m = 1e-3 * span_mm;
        let ellipse = of(span_m, half_angle_deg, form(RacewayShape::Ellipse, 0.0));
        let middle = (span_m / (2.0 * d.ball_radius_m)).asin();
        let expected = middle.powi(2) / (2.0 * half_angle_deg.to_radians());
        close(speed_change_max(&bearing, &ellipse), expected);
        // A ring measured from it has the same flanks.
        let like_it = RacewayForm {
            measured: Some(measured(&ellipse, 40)),
            ..form(RacewayShape::Measured, 0.0)
        };
        let like_it = of(span_m, half_angle_deg, like_it);
        close(speed_change_max(&bearing, &like_it), expected);
        for raceway in [ellipse, like_it] {
            assert_eq!(raceway.kink_angle_rad(FRAC_PI_4), FRAC_PI_2);
            let ring = outer_ring(std::slice::from_ref(&raceway), 0.0);
            assert_eq!(ring.kink_rad(), [FRAC_PI_2; 2]);
            let blended = outer_ring(&[raceway], 0.5e-3);
            assert_eq!(
                (blended.kink_rad(), blended.design_kink_rad()),
                ([0.0; 2], [FRAC_PI_2; 2])
            );
        }
    }
    for edge_m in [1.2e-3, 0.3e-3] {
        let form = RacewayForm::default().reshaped(RacewayShape::Slot, edge_m);
        let slot = of(4e-3, 30.0, form);
        let sine = 2e-3 / d.ball_radius_m;
        let end_m = (d.ball_radius_m + edge_m) * sine;
        let expected = sine.powi(2) * d.outer_groove_bottom_radius_m / (2.0 * end_m);
        close(speed_change_max(&bearing, &slot), expected);
    }
}
