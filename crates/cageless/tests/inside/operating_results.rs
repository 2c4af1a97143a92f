//! Friction torque, power loss, contact pressures and frequencies of a run.

use std::f64::consts::TAU;

use cageless::Case;
use cageless::dynamics::energy::EnergyTerm;
use cageless::kinematics::{rolling_orbit_speed_rad_s, rolling_relative_rotation_rad_s};
use cageless::simulation::{Control, Observer, ObserverError, RunOutcome, StepView, run};
use cageless::summary::{Summary, SummaryRecorder, transient_s};

fn simulate(case: &Case, others: &mut [&mut dyn Observer]) -> (RunOutcome, Summary) {
    let mut recorder = SummaryRecorder::new();
    let mut observers: Vec<&mut dyn Observer> = vec![&mut recorder];
    observers.extend(others.iter_mut().map(|o| &mut **o as &mut dyn Observer));
    let outcome = run(case, &mut observers, &mut |_| Control::Continue(())).unwrap();
    (outcome, recorder.summary().unwrap())
}

fn lasting(duration_s: f64) -> Case {
    let mut case = crate::common::structure(5.1, 25.2);
    case.solver.duration_s = duration_s;
    case
}

/// Torque of the balls on the inner ring and largest forces, from every step.
#[derive(Default)]
struct EveryStep {
    torque: Vec<[f64; 2]>,
    inner_n: f64,
    outer_n: f64,
    balls_n: f64,
    after_s: f64,
    radius_m: f64,
}

impl Observer for EveryStep {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let contacts = &view.contacts;
        let all = || 0..contacts.balls();
        let friction: f64 = all().map(|k| contacts.inner_friction_n(k)).sum();
        self.torque.push([view.step.t1_s, friction * self.radius_m]);
        if view.step.t1_s > self.after_s {
            for k in all() {
                self.inner_n = self.inner_n.max(contacts.inner_force_n(k));
                self.outer_n = self.outer_n.max(contacts.outer_force_n(k));
                if contacts.balls_touch() {
                    self.balls_n = self.balls_n.max(contacts.pair_force_n(k));
                }
            }
        }
        Ok(Control::Continue(()))
    }
}

/// Over whole orbits, torque times speed is what the energy ledger of runs that end at the two
/// times has for the drive, and what the friction forces at the inner ring give.
#[test]
fn torque_times_speed_is_the_power_of_the_drive() {
    let case = lasting(0.05);
    let mut steps = EveryStep {
        radius_m: case.bearing.dimensions().inner_groove_bottom_radius_m,
        ..EveryStep::default()
    };
    let (_, summary) = simulate(&case, &mut [&mut steps]);
    let means = summary.means.unwrap();
    assert_eq!(means.orbits, 1);
    let [from, to] = means.interval_s;
    let orbits = means.orbit_speed_rad_s * (to - from) / TAU;
    assert!((orbits - 1.0).abs() < 0.02, "{orbits}");

    let drive_j = |time_s: f64| {
        let (outcome, _) = simulate(&lasting(time_s), &mut []);
        assert_eq!(outcome.end_s, time_s);
        outcome.state.energy_term_j(EnergyTerm::Drive)
    };
    let ledger_w = (drive_j(to) - drive_j(from)) / (to - from);
    let power_w = means.friction_torque_n_m * case.operation.inner_speed_rad_s;
    assert!(
        (power_w / ledger_w - 1.0).abs() < 1e-6,
        "{power_w} {ledger_w}"
    );
    assert!((means.power_w(EnergyTerm::Drive) / power_w - 1.0).abs() < 1e-15);

    let inside = |[a, b]: [[f64; 2]; 2]| a[0] >= from - 1e-12 && b[0] <= to + 1e-12;
    let work: f64 = (steps.torque.windows(2))
        .map(|w| [w[0], w[1]])
        .filter(|w| inside(*w))
        .map(|[a, b]| 0.5 * (a[1] + b[1]) * (b[0] - a[0]))
        .sum();
    let torque = work / (to - from);
    let found = means.friction_torque_n_m;
    assert!((torque / found - 1.0).abs() < 1e-3, "{torque} {found}");

    let heat: f64 = (EnergyTerm::without_rotor().iter())
        .filter(|term| term.is_loss())
        .map(|&term| means.power_w(term))
        .sum();
    assert!(((heat + means.stored_w) / power_w - 1.0).abs() < 1e-12);
    assert!(means.stored_w.abs() < 0.05 * power_w, "{}", means.stored_w);
}

/// A part of an orbit has its means, too, and says that it is none.
#[test]
fn a_short_run_has_means_of_less_than_an_orbit() {
    let (_, summary) = simulate(&lasting(0.01), &mut []);
    let means = summary.means.unwrap();
    assert_eq!(means.orbits, 0);
    assert!(means.interval_s[0] >= summary.settled_after_s);
    assert!(means.interval_s[1] > 0.0099);
    assert!(means.power_w(EnergyTerm::Drive) > 0.0);
}

/// Two orbits of rolling balls, at most half of the run, are its transient.
#[test]
fn the_transient_is_two_orbits() {
    // Half the speed of the inner raceway, 200 1/s, over the pitch circle.
    let orbit_s = 2.0 * 23.0025 / (200.0 * 18.24);
    for (duration_s, expected) in [(1.0, 2.0 * orbit_s), (0.02, 0.01)] {
        let found = transient_s(&lasting(duration_s));
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
}

/// Pressures by Hertz from the largest forces of all steps.
#[test]
fn peak_pressures_are_those_of_the_largest_forces() {
    let mut case = lasting(0.05);
    // Pairs that are closer than the critical gap touch in the raceway.
    let even = case.bearing.nominal_gap_rad();
    let gaps = (0..case.bearing.balls()).map(|k| even * [0.2, 1.8][k % 2]);
    case.start = cageless::Start::new(
        cageless::StartState::Settled,
        cageless::Gaps::List(gaps.collect()),
        0.1,
    );
    let mut steps = EveryStep {
        after_s: cageless::summary::transient_s(&case),
        ..EveryStep::default()
    };
    let (_, summary) = simulate(&case, &mut [&mut steps]);
    let peaks = &summary.peaks;
    assert!(summary.collisions.all > 0);
    for (found, largest, contact) in [
        (&peaks.inner, steps.inner_n, case.bearing.inner_contact()),
        (&peaks.balls, steps.balls_n, case.bearing.ball_contact()),
    ] {
        let pressure = contact.peak_pressure_pa(largest);
        let ratio = found.pressure_pa / pressure;
        assert!((0.99..=1.0).contains(&ratio), "{ratio}");
        assert!(found.force_n <= largest);
    }
    assert_eq!(peaks.balls.force_n, steps.balls_n);
    // Largest in the plain groove; at two points of the discrete raceway less.
    let plain = case.bearing.outer_contact().peak_pressure_pa(steps.outer_n);
    assert!(peaks.outer.pressure_pa <= plain && peaks.outer.pressure_pa > 0.8 * plain);
    // Balls that touch slide at twice the speed of their surfaces.
    let sliding = peaks.balls.pressure_velocity_pa_m_s / peaks.balls.pressure_pa;
    assert!((10.0..40.0).contains(&sliding), "{sliding}");
    assert!(peaks.inner.pressure_velocity_pa_m_s < peaks.balls.pressure_velocity_pa_m_s);
}

/// On a plain outer ring the balls roll: frequencies and speeds are the kinematic ones but for
/// the slip.
#[test]
fn frequencies_are_those_of_rolling_but_for_the_slip() {
    let mut case = lasting(0.05).with_raceways(vec![]);
    case.solver.duration_s = 0.05;
    let (_, summary) = simulate(&case, &mut []);
    let means = summary.means.unwrap();
    let bearing = &case.bearing;
    let speed = case.operation.inner_speed_rad_s;
    let radius = bearing.ball_radius_m();
    let orbit = rolling_orbit_speed_rad_s(bearing, speed, radius);
    let balls = bearing.balls() as f64;
    for (found, rolling) in [
        (means.ftf_hz, orbit / TAU),
        (means.bpfo_hz, balls * orbit / TAU),
        (means.bpfi_hz, balls * (speed - orbit) / TAU),
        (
            means.bsf_hz,
            rolling_relative_rotation_rad_s(bearing, orbit, radius) / TAU,
        ),
    ] {
        assert!((found / rolling - 1.0).abs() < 0.01, "{found} {rolling}");
    }
    let rolling = speed * balls / TAU;
    assert!((means.bpfo_hz + means.bpfi_hz - rolling).abs() < 1e-9 * rolling);
}

/// Under thrust at a contact angle the axis of a ball leans: it turns about it as the closed forms say,
/// n/2·Dpw/Dw·(1 − γ²) with γ = Dw cos α/Dpw, and about that of the bearing by cos α of it.
#[test]
fn balls_that_roll_at_a_contact_angle_turn_as_the_closed_forms_say() {
    let mut case = lasting(0.02).with_raceways(vec![]);
    case.set_method(cageless::IntegrationMethod::VelocityVerlet);
    case.bearing = (case.bearing)
        .with_contact_angle(40f64.to_radians(), 0.0)
        .unwrap();
    case.operation.space.axial_load_n = 2000.0;
    case.operation.radial_load_n = 0.0;
    case.contact.friction.coefficient = 0.1;
    let (_, summary) = simulate(&case, &mut []);
    let (means, angles) = (summary.means.unwrap(), summary.space.unwrap());
    let angle = 0.5 * (angles.inner_contact_angle_mean_rad + angles.outer_contact_angle_mean_rad);
    let (dw, dpw) = (9.525, 46.005);
    let gamma = dw * angle.abs().cos() / dpw;
    let n = case.operation.inner_speed_rad_s / TAU;
    let turning = 0.5 * n * dpw / dw * (1.0 - gamma * gamma);
    let passing = cageless::rating::PassingFrequencies::at_contact_angle(&case, angle);
    for (name, found, expected) in [
        ("BSF of the closed form", passing.bsf_hz, turning),
        ("BSF of the motion", means.bsf_hz, turning),
        ("FTF of the motion", means.ftf_hz, 0.5 * n * (1.0 - gamma)),
    ] {
        println!("{name}: {found} {expected}");
        assert!(
            (found / expected - 1.0).abs() < 0.02,
            "{name}: {found} {expected}"
        );
    }
}

/// A ring that moments tilt stands on the average as the equilibrium says.
#[test]
fn the_mean_tilt_is_that_of_the_equilibrium() {
    let mut case = lasting(0.02).with_raceways(vec![]);
    case.set_method(cageless::IntegrationMethod::VelocityVerlet);
    case.operation.space.tilt = cageless::Tilt::Free {
        moment_x_n_m: 1.5,
        moment_y_n_m: -1.0,
    };
    case.operation.space.inertias_kg_m2 = Some([1e-3, 1.5e-3]);
    let (_, summary) = simulate(&case, &mut []);
    let rest = cageless::equilibrium::space::solve(&case).unwrap();
    let tilts = summary.space.unwrap().tilt_mean_rad;
    println!("{tilts:?} {} {}", rest.tilt_x_rad, rest.tilt_y_rad);
    let size = rest.tilt_x_rad.hypot(rest.tilt_y_rad);
    for (found, expected) in tilts.iter().zip([rest.tilt_x_rad, rest.tilt_y_rad]) {
        assert!((found - expected).abs() < 0.03 * size, "{found} {expected}");
    }
}

/// An angular-contact row is warned of where it carries, but not towards its contact sign.
#[test]
fn rows_without_thrust_are_warned_of() {
    let mut case = lasting(0.02).with_raceways(vec![]);
    case.bearing = (case.bearing)
        .with_contact_angle(25f64.to_radians(), 0.0)
        .unwrap();
    let warned = |axial_load_n: f64| {
        let mut case = case.clone();
        case.operation.space.axial_load_n = axial_load_n;
        let rest = cageless::equilibrium::space::solve(&case).unwrap();
        rest.warnings(&case)
            .iter()
            .any(|warning| warning.contains("towards its contact sign"))
    };
    assert_eq!([1000.0, 0.0, -1000.0].map(warned), [false, true, true]);
}
