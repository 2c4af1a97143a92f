//! A simulation stepped from outside: what its view shows, and what a controller may ask of it.

use std::f64::consts::TAU;

use cageless::linear_rotor::{Clearance, ClearancePlane, LinearRotor, RigidRotor};
use cageless::prelude::*;
use cageless::simulation::Cause;

fn loaded(method: IntegrationMethod) -> CaseBuilder {
    CaseBuilder::of(reference::bearing())
        .inner_speed_rad_s(1257.0)
        .radial_load_n(1500.0)
        .method(method)
        .duration_s(2e-3)
}

/// The loaded bearing in space, under an axial load.
fn thrust(method: IntegrationMethod) -> CaseBuilder {
    loaded(method).change(|case| case.operation.space.axial_load_n = 500.0)
}

/// A method that ends its steps where it likes, at a state of one number.
struct Odd {
    end_s: fn([f64; 2]) -> f64,
    value: Option<f64>,
}

impl Method for Odd {
    fn restart<S: System>(&mut self, _system: &mut S, _step: &StepState) {}

    fn perform_step<S: System>(
        &mut self,
        _system: &mut S,
        step: &mut StepState,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        step.t1_s = (self.end_s)([step.t0_s, limit_s]);
        for (end, (start, _)) in step.y1.iter_mut().zip(step.y0.iter().zip(&step.f0)) {
            *end = self.value.unwrap_or(*start);
        }
        Ok(())
    }
}

/// Asserts that state and snapshot of the view at its time are those of the balls and the ring that it shows.
fn assert_sound(simulation: &Simulation, when: &str) {
    let view = simulation.view();
    let time_s = view.time_s();
    assert_eq!(
        view.state(time_s).values(),
        simulation.state().values(),
        "{when}"
    );
    let (snapshot, ring) = (view.snapshot(time_s), view.ring());
    let of_snapshot = [
        snapshot.ring.x_m,
        snapshot.ring.vy_m_s,
        snapshot.ring.z_m,
        snapshot.ring.vz_m_s,
        snapshot.ring.tilt_x_rad,
        snapshot.ring.tilt_y_rad,
    ];
    let of_view = [
        ring.x_m,
        ring.vy_m_s,
        ring.z_m,
        ring.vz_m_s,
        ring.tilt_x_rad,
        ring.tilt_y_rad,
    ];
    assert_eq!(of_snapshot, of_view, "{when}");
    for ball in view.balls() {
        let k = ball.index();
        assert_eq!(snapshot.x_m[k], ball.x_m(), "{when}");
        let load_n = ball.outer_force_n();
        // The view has the last evaluation of the method, before its last correction.
        let relative = snapshot.outer_force_n[k] / load_n - 1.0;
        assert!(relative.abs() < 1e-3, "{when} {load_n}: {relative:e}");
        assert!(
            (snapshot.angle_rad[k] - ball.angle_rad()).abs() < 1e-12,
            "{when}"
        );
        let spatial = [
            (&snapshot.z_m, ball.z_m()),
            (&snapshot.vz_m_s, ball.vz_m_s()),
            (&snapshot.omega_x_rad_s, ball.omega_x_rad_s()),
            (&snapshot.omega_y_rad_s, ball.omega_y_rad_s()),
        ];
        for (values, shown) in spatial {
            assert_eq!(values.get(k).copied().unwrap_or(0.0), shown, "{when}");
        }
        let angles = [
            (
                &snapshot.inner_contact_angle_rad,
                ball.inner_contact_angle_rad(),
            ),
            (
                &snapshot.outer_contact_angle_rad,
                ball.outer_contact_angle_rad(),
            ),
        ];
        for (values, shown) in angles {
            let expected = values.get(k).copied().unwrap_or(0.0);
            let both_free = expected.is_nan() && shown.is_nan();
            assert!(
                both_free || (expected - shown).abs() < 1e-9,
                "{when} {expected} {shown}"
            );
        }
    }
}

/// Snapshot and state of a view are sound before the first step, after a time, after a change and after a step.
#[test]
fn a_view_is_sound_whenever_it_is_looked_at() {
    for method in [IntegrationMethod::Abm4, IntegrationMethod::VelocityVerlet] {
        for builder in [loaded(method), thrust(method)] {
            let mut simulation = Simulation::new(&builder.build().unwrap()).unwrap();
            assert_sound(&simulation, "at the start");
            simulation.advance_to(2e-4).unwrap();
            assert_sound(&simulation, "after a time");
            simulation.set_radial_load_n(1400.0).unwrap();
            assert_sound(&simulation, "after a load");
            simulation.step().unwrap();
            assert_sound(&simulation, "after a step");
        }
    }
}

/// An axial load moves the ring along the axis and turns the contacts; in the plane both are 0.
#[test]
fn the_view_shows_motion_in_space() {
    let shown = |builder: CaseBuilder| {
        let mut simulation = Simulation::new(&builder.build().unwrap()).unwrap();
        simulation.advance_to(1e-4).unwrap();
        let view = simulation.view();
        let most_n = view
            .balls()
            .max_by(|a, b| a.outer_force_n().total_cmp(&b.outer_force_n()));
        let ball = most_n.unwrap();
        let angles = [
            ball.inner_contact_angle_rad(),
            ball.outer_contact_angle_rad(),
        ];
        (view.ring().z_m, angles)
    };
    let method = IntegrationMethod::VelocityVerlet;
    assert_eq!(shown(loaded(method)), (0.0, [0.0, 0.0]));
    let (z_m, angles) = shown(thrust(method));
    assert!(z_m > 1e-6, "{z_m}");
    assert!(
        angles.iter().all(|angle| (0.01..0.6).contains(angle)),
        "{angles:?}"
    );
}

/// What the builder refuses, a controller is refused in the same words, and the motion goes on as before.
#[test]
fn a_controller_keeps_to_the_limits_of_the_builder() {
    let builder = || loaded(IntegrationMethod::VelocityVerlet);
    let mut simulation = Simulation::new(&builder().build().unwrap()).unwrap();
    let refused = |builder: CaseBuilder| builder.build().unwrap_err().to_string();
    for speed_rad_s in [1e6, 1e9] {
        let error = simulation.set_inner_speed_rad_s(speed_rad_s).unwrap_err();
        assert_eq!(
            error.to_string(),
            refused(builder().inner_speed_rad_s(speed_rad_s))
        );
    }
    for load_n in [1e6, 1e9, -1.0, f64::NAN] {
        let error = simulation.set_radial_load_n(load_n).unwrap_err();
        assert_eq!(error.to_string(), refused(builder().radial_load_n(load_n)));
    }
    for speed_rad_s in [-628.3, f64::NAN] {
        let error = simulation.set_inner_speed_rad_s(speed_rad_s).unwrap_err();
        assert_eq!(error.field, "inner_speed_rad_s");
    }
    let operation = &simulation.case().operation;
    assert_eq!(
        (operation.inner_speed_rad_s, operation.radial_load_n),
        (1257.0, 1500.0)
    );
    simulation.advance_to(1e-4).unwrap();
    let mut drop = Simulation::new(&reference::rotor_drop()).unwrap();
    for torque_n_m in [1e9, f64::NAN] {
        let error = drop.set_drive_torque_n_m(torque_n_m).unwrap_err();
        assert_eq!(error.field, "drive_torque_n_m");
    }
    drop.set_drive_torque_n_m(-1.0).unwrap();
}

/// Balls coast on below a ring that stands, and their angles are followed.
#[test]
fn a_ring_brakes_to_a_stand() {
    let case = loaded(IntegrationMethod::VelocityVerlet).radial_load_n(50.0);
    let mut simulation = Simulation::new(&case.build().unwrap()).unwrap();
    simulation.set_inner_speed_rad_s(0.0).unwrap();
    let angles = |simulation: &Simulation| -> Vec<f64> {
        let view = simulation.view();
        view.balls().map(|ball| ball.angle_rad()).collect()
    };
    let start = angles(&simulation);
    let mut before = start.clone();
    for ms in 1..=15 {
        simulation.advance_to(1e-3 * f64::from(ms)).unwrap();
        let now = angles(&simulation);
        for (now, before) in now.iter().zip(&before) {
            assert!((-0.1..1.0).contains(&(now - before)), "{ms} {now} {before}");
        }
        before = now;
    }
    let turned = before.iter().zip(&start).map(|(end, start)| end - start);
    assert!(turned.fold(0.0, f64::max) > 0.5 * TAU);
}

/// A time that does not lie ahead is refused at once, and the simulation goes on.
#[test]
fn a_time_that_does_not_lie_ahead_is_refused() {
    let case = loaded(IntegrationMethod::Abm4).build().unwrap();
    let mut simulation = Simulation::new(&case).unwrap();
    simulation.advance_to(1e-5).unwrap();
    for time_s in [f64::NAN, 0.5e-5, -1.0, f64::NEG_INFINITY] {
        let stop = simulation.advance_to(time_s).unwrap_err();
        assert!(matches!(stop.cause, Cause::TimeNotAhead(_)), "{stop}");
        assert!(stop.to_string().contains("0.00001 s or later"), "{stop}");
        let outcome = simulation.run(time_s, &mut []);
        assert!(
            matches!(&outcome.ending, Ending::Stopped(again) if again.to_string() == stop.to_string()),
            "{:?}",
            outcome.ending
        );
    }
    let steps = simulation.outcome().steps;
    simulation.advance_to(1e-5).unwrap();
    let here = simulation.run(1e-5, &mut []);
    assert!(matches!(here.ending, Ending::Complete) && here.steps == steps);
    simulation.advance_to(2e-5).unwrap();
}

/// A method that stands still, goes back or passes its limit ends the run by name.
#[test]
fn a_method_goes_on_and_keeps_its_limit() {
    let ends: [fn([f64; 2]) -> f64; 4] = [
        |[start, _]| start,
        |[start, _]| start - 1e-7,
        |[_, limit]| limit + 1e-6,
        |_| f64::NAN,
    ];
    for end_s in ends {
        let case = loaded(IntegrationMethod::Abm4).build().unwrap();
        let odd = || Odd { end_s, value: None };
        let begun = || Simulation::new(&case).unwrap().with_method(odd());
        let stop = begun().advance_to(1e-4).unwrap_err();
        assert!(matches!(stop.cause, Cause::NotForward { .. }), "{stop}");
        let outcome = begun().run(1e-4, &mut []);
        assert!(
            matches!(&outcome.ending, Ending::Stopped(stop) if matches!(stop.cause, Cause::NotForward { .. })),
            "{:?}",
            outcome.ending
        );
    }
}

/// The advice is half the step that a method of one's own made, not half that of the case.
#[test]
fn advice_never_lengthens_the_step() {
    let mut case = loaded(IntegrationMethod::Abm4).build().unwrap();
    case.solver.step_s = 1e-6;
    let odd = Odd {
        end_s: |[start, limit]| (start + 0.2e-6).min(limit),
        value: Some(f64::NAN),
    };
    let mut simulation = Simulation::new(&case).unwrap().with_method(odd);
    let stop = simulation.advance_to(1e-4).unwrap_err();
    assert_eq!(stop.cause, Cause::NotFinite);
    let half = "give CaseBuilder::step_s 0.1 µs, half the step";
    assert!(stop.advice().contains(half), "{stop}");
}

/// A rotor that two bearings catch, with a plane between them.
fn in_two_bearings() -> LinearRotor {
    let rotor = RigidRotor {
        mass_kg: 40.0,
        polar_inertia_kg_m2: 0.04,
        transverse_inertia_kg_m2: 0.6,
        bearing_axial_m: vec![-0.1, 0.2],
        unbalances: vec![],
        clearances: vec![ClearancePlane {
            place: 0.0,
            clearance: Clearance {
                name: "magnet".to_owned(),
                radial_m: 3e-4,
            },
        }],
    };
    rotor.linear().unwrap()
}

/// The drop of that rotor for 8 ms, long enough that both bearings touch.
fn two_bearings(speed_rad_s: f64) -> RotorDrop {
    let mut case = reference::rotor_drop();
    case.solver.duration_s = 8e-3;
    let cases = vec![case.clone(), case];
    RotorDrop::new(in_two_bearings(), speed_rad_s, 0.0, cases, None).unwrap()
}

/// Steps of a rotor in two bearings from a loop of one's own are those of its drop, to the bit.
#[test]
fn a_drop_stepped_is_the_drop() {
    let drop = two_bearings(3142.0);
    let mut go_on = |_| Control::Continue(());
    let whole = drop.run(&mut [vec![], vec![]], &mut go_on).unwrap();
    let mut simulation = drop.simulation().unwrap();
    for _ in 1..whole.bearings[0].steps {
        simulation.step().unwrap();
    }
    simulation.advance_to(8e-3).unwrap();
    let forces_n = simulation
        .views()
        .map(|view| view.rotor().unwrap().contact_force_n);
    assert_eq!(forces_n.filter(|force_n| *force_n > 1.0).count(), 2);
    let stepped = simulation.drop_outcome();
    assert_eq!(stepped.rotor, whole.rotor);
    assert!(stepped.rotor.planes[0].displacement_max_m > 1e-4);
    assert_eq!(stepped.bearings.len(), 2);
    for (one, other) in stepped.bearings.iter().zip(&whole.bearings) {
        assert_eq!(one.state.values(), other.state.values());
        assert_eq!((one.steps, one.end_s), (other.steps, other.end_s));
        assert_eq!(one.energy_residual_relative, other.energy_residual_relative);
    }
    let of_case = RotorDrop::of_case(&reference::rotor_drop()).unwrap();
    assert_eq!(of_case.simulation().unwrap().views().count(), 1);
}

/// A torque brakes the rotor by M·t/I, as each bearing sees it, and both journals fall freely.
#[test]
fn a_controller_brakes_a_rotor_in_two_bearings() {
    let mut simulation = two_bearings(3142.0).simulation().unwrap();
    simulation.set_drive_torque_n_m(-5.0).unwrap();
    simulation.advance_to(1e-3).unwrap();
    let rotors: Vec<RotorView> = simulation.views().filter_map(|v| v.rotor()).collect();
    let expected_rad_s = 3142.0 - 5.0 * 1e-3 / 0.04;
    let fallen_m = -0.5 * simulation.case().operation.gravity_m_s2 * 1e-6;
    assert_eq!(rotors.len(), 2);
    for rotor in rotors {
        assert!((rotor.speed_rad_s / expected_rad_s - 1.0).abs() < 1e-9);
        assert!((rotor.y_m / fallen_m - 1.0).abs() < 1e-3, "{}", rotor.y_m);
    }
    assert!(simulation.set_radial_load_n(100.0).is_err());
    let run = simulation.run(2e-3, &mut []);
    assert!(matches!(run.ending, Ending::Complete));
    assert_eq!(simulation.drop_outcome().bearings[1].end_s, 2e-3);
}

/// What one bearing stops for ends the motion of all, and that bearing is the one that has stopped.
#[test]
fn one_bearing_stops_all() {
    let mut cases = vec![reference::rotor_drop(); 2];
    // Far too soft for the impact.
    let journal = cases[1].rotor.as_mut().unwrap();
    journal.contact_stiffness_n_mp *= 1e-6;
    let drop = RotorDrop::new(in_two_bearings(), 3142.0, 0.0, cases, None).unwrap();
    let mut simulation = drop.simulation().unwrap();
    let stop = simulation.advance_to(0.02).unwrap_err();
    assert_eq!(stop.cause, Cause::RotorThroughInnerRing);
    assert_eq!(simulation.step().unwrap_err(), stop);
    assert_eq!(simulation.drop_outcome().stopped_bearing(), Some(1));
}
