//! Observables of a run in space against the step.

use cageless::dynamics::energy::EnergyTerm;
use cageless::passage::SettledPassages;
use cageless::simulation::run;
use cageless::summary::{Summary, SummaryRecorder};
use cageless::{
    Bearing, BearingDimensions, Case, Gaps, IntegrationMethod, Motion, Raceway, RacewayDimensions,
    RacewayForm, RacewayShape, Start, StartState, Tilt,
};

use crate::common::{conventional, dimensions, slotted, steel};

use cageless::simulation::{Control, Ending};

/// What a user reads of a run.
struct Read {
    summary: Summary,
    heat_w: [f64; 2],
    lag_rad: f64,
}

fn read(case: &Case) -> Read {
    let mut summary = SummaryRecorder::new();
    let mut passages = SettledPassages::default();
    let outcome = run(case, &mut [&mut summary, &mut passages], &mut |_| {
        Control::Continue(())
    })
    .unwrap();
    assert!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    let ledger = |term| outcome.state.energy_term_j(term) / outcome.end_s;
    Read {
        summary: summary.summary().unwrap(),
        heat_w: [EnergyTerm::InnerFriction, EnergyTerm::OuterFriction].map(ledger),
        lag_rad: passages.tally.means().lag_rad,
    }
}

/// Six large balls on steep contacts that turn slowly and rub hard: what turns them about the normal of a contact
/// is the moment of the friction within it.
fn spinning() -> Case {
    let d = BearingDimensions {
        balls: 6,
        ball_radius_m: 10e-3,
        inner_groove_bottom_radius_m: 15.9e-3,
        outer_groove_bottom_radius_m: 35.91e-3,
        outer_shoulder_radius_m: 32e-3,
        inner_groove_curvature_radius_m: 10.4e-3,
        outer_groove_curvature_radius_m: 10.4e-3,
        inner_ring_mass_kg: 0.5,
        ..dimensions()
    };
    let mut case = conventional(dimensions());
    case.bearing = Bearing::new(d, steel()).unwrap();
    case.operation.inner_speed_rad_s = 21.0;
    case.operation.radial_load_n = 4000.0;
    case.operation.space.axial_load_n = 22_000.0;
    case.contact.friction.coefficient = 0.2;
    case.contact.friction.regularisation_speed_m_s = 0.1;
    case.solver.duration_s = 1.5e-3;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case
}

fn near(a: f64, b: f64, within: f64, what: &str) {
    assert!((a / b - 1.0).abs() < within, "{what}: {a} {b}");
}

/// The heat of spinning contacts is that of an explicit method at a hundredth of the step, for which no friction is
/// stiff, with one strip and with three.
#[test]
fn the_heat_of_spin_is_that_of_an_explicit_method() {
    for strips in [1, 3] {
        let mut case = spinning();
        case.contact.friction_strips = strips;
        let implicit = read(&case);
        assert!(case.solver.step_s > 2e-6);
        case.solver.method = IntegrationMethod::Abm4;
        case.solver.step_s = 2e-8;
        let explicit = read(&case);
        for ring in 0..2 {
            let what = format!("{strips} strips, ring {ring}");
            near(implicit.heat_w[ring], explicit.heat_w[ring], 3e-3, &what);
        }
    }
}

/// Structure (d) of Zhao 2022 with another shape, under axial load.
fn shaped(shape: RacewayShape) -> Case {
    let mut case = match shape {
        RacewayShape::Slot => slotted(),
        _ => {
            let case = conventional(dimensions());
            let form = RacewayForm {
                shape,
                ..RacewayForm::default()
            };
            let dimensions = RacewayDimensions {
                axial_span_m: 5.1e-3,
                half_angle_rad: 25.2f64.to_radians(),
                centre_angle_rad: 0.0,
            };
            let raceway = Raceway::formed(dimensions, form, &case.bearing).unwrap();
            case.with_raceways(vec![raceway])
        }
    };
    case.operation.space.axial_load_n = 300.0;
    case.solver.duration_s = 0.03;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case
}

/// Balls pass ends at a right angle, also beside their middle, with forces and a lag that do not depend on the step.
#[test]
fn ends_at_a_right_angle_are_passed_at_any_step() {
    for shape in [
        RacewayShape::Ellipse,
        RacewayShape::Slot,
        RacewayShape::Quartic,
    ] {
        let mut case = shaped(shape);
        let coarse = read(&case);
        case.solver.step_s /= 4.0;
        let fine = read(&case);
        let what = format!("{shape:?}");
        near(coarse.lag_rad, fine.lag_rad, 5e-3, &what);
        let peaks = [&coarse, &fine].map(|r| r.summary.peaks.outer.force_n);
        // Impacts are looked at every 4 µs.
        near(peaks[0], peaks[1], 0.05, &what);
        near(coarse.heat_w[1], fine.heat_w[1], 0.01, &what);
    }
}

/// A light shaft that tilts freely and one that is held, with dry and with lubricated balls: powers, forces and
/// places at the automatic step and at a quarter of it.
#[test]
fn results_do_not_depend_on_the_automatic_step() {
    let held = Tilt::Held {
        x_rad: 0.8e-3,
        y_rad: -0.5e-3,
    };
    let free = Tilt::Free {
        moment_x_n_m: 2.0,
        moment_y_n_m: -1.5,
    };
    for (tilt, coefficient, strips) in [
        (held, 0.2, 1),
        (free, 0.2, 1),
        (free, 0.007, 3),
        (held, 0.007, 1),
    ] {
        let mut case = conventional(dimensions());
        case.motion = Motion::Space;
        case.operation.space.axial_load_n = 700.0;
        case.operation.space.tilt = tilt;
        case.operation.space.inertias_kg_m2 = Some([4e-5, 6e-5]);
        case.contact.friction.coefficient = coefficient;
        case.contact.friction_strips = strips;
        case.start = Start::new(StartState::Settled, Gaps::Uniform, 0.3);
        case.solver.duration_s = 6e-3;
        case.set_method(IntegrationMethod::VelocityVerlet);
        let coarse = read(&case);
        case.solver.step_s /= 4.0;
        let fine = read(&case);
        let what = format!("{tilt:?} {coefficient} {strips}");
        for ring in 0..2 {
            near(coarse.heat_w[ring], fine.heat_w[ring], 5e-3, &what);
        }
        let both =
            |of: fn(&Summary) -> f64| near(of(&coarse.summary), of(&fine.summary), 5e-3, &what);
        both(|s| s.peaks.inner.force_n);
        both(|s| s.peaks.outer.force_n);
        both(|s| s.ring_y_mean_m);
    }
}
