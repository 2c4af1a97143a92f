//! Simulation, own law, own method and own observer: what they must not change, and what they refuse.

use std::sync::Mutex;

use crate::common::*;
use cageless::Regularisation;
use cageless::integrator::VelocityVerlet;
use cageless::prelude::*;
use cageless::simulation::{Cause, run};

/// Smooth friction through the trait.
struct Constant(f64);

impl FrictionLaw for Constant {
    fn coefficient(&self, _sliding_m_s: f64) -> [f64; 2] {
        [self.0, 0.0]
    }
}

fn loaded() -> CaseBuilder {
    CaseBuilder::of(reference::bearing())
        .raceway(
            reference::Structure::D
                .raceway(&reference::bearing())
                .unwrap(),
        )
        .inner_speed_rad_s(1257.0)
        .radial_load_n(1500.0)
        .duration_s(2e-3)
}

/// State at the end of 2 ms.
fn end(case: &Case) -> Vec<f64> {
    complete(case).state.values().to_vec()
}

/// Largest difference of two states, each coordinate over its size.
fn difference(one: &[f64], other: &[f64]) -> f64 {
    let pairs = one.iter().zip(other);
    pairs.fold(0.0, |most, (a, b)| {
        most.max((a - b).abs() / (1e-9 + a.abs()))
    })
}

/// The built-in smooth law written through the trait moves the bearing as the built-in one, in every kind of motion.
#[test]
fn a_constant_law_of_ones_own_is_the_smooth_law() {
    let in_space = |case: &mut Case| case.motion = Motion::Space;
    let slow_us = [IntegrationMethod::Abm4, IntegrationMethod::VelocityVerlet];
    for method in slow_us {
        for spatial in [false, true] {
            // Explicit steps would have to be shorter with creep.
            let creeps: &[Regularisation] = match method {
                IntegrationMethod::VelocityVerlet => {
                    &[Regularisation::Speed, Regularisation::Kalker]
                }
                _ => &[Regularisation::Speed],
            };
            for &regularisation in creeps {
                let of = |builder: CaseBuilder| {
                    let builder = builder.method(method).duration_s(5e-4);
                    let builder =
                        builder.change(|case| case.contact.regularisation = regularisation);
                    match spatial {
                        true => builder.change(in_space).build().unwrap(),
                        false => builder.build().unwrap(),
                    }
                };
                let built_in = end(&of(loaded().friction_coefficient(0.05)));
                let own = end(&of(loaded().own_friction(Constant(0.05))));
                let apart = difference(&built_in, &own);
                assert!(
                    apart < 1e-6,
                    "{method:?} {spatial} {regularisation:?}: {apart}"
                );
            }
        }
    }
}

/// Steps from a loop of one's own are those of a run, to the bit.
#[test]
fn own_steps_are_those_of_a_run() {
    for method in [IntegrationMethod::Abm4, IntegrationMethod::VelocityVerlet] {
        let case = loaded().method(method).build().unwrap();
        let outcome = complete(&case);
        let mut simulation = Simulation::new(&case).unwrap();
        while simulation.outcome().steps < outcome.steps - 1 {
            simulation.step().unwrap();
        }
        simulation.advance_to(case.solver.duration_s).unwrap();
        assert_eq!(simulation.state().values(), outcome.state.values());
        assert_eq!(simulation.outcome().steps, outcome.steps);
        assert_eq!(simulation.time_s(), outcome.end_s);
    }
}

/// A run in two parts is that in one, and its ledger closes over both.
#[test]
fn a_run_goes_on_where_it_was() {
    let case = loaded().build().unwrap();
    let whole = complete(&case);
    let mut simulation = Simulation::new(&case).unwrap();
    let half_s = 0.5 * case.solver.duration_s;
    let first = simulation.run(half_s, &mut []);
    assert!(matches!(first.ending, Ending::Complete));
    assert_eq!(first.end_s, half_s);
    let mut angles_rad = vec![];
    let mut turned = each_step(|view| {
        angles_rad = view.balls().map(|ball| ball.angle_rad()).collect();
        Control::Continue(())
    });
    let second = simulation.run(case.solver.duration_s, &mut [&mut turned]);
    assert!(second.energy_residual_relative.abs() < 1e-4);
    // Between the parts a step was cut short: the same motion to the order of the method.
    let apart = second.state.x_m().iter().zip(whole.state.x_m());
    assert!(apart.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) < 1e-7);
    let turns = angles_rad.iter().map(|angle| angle / std::f64::consts::TAU);
    assert!(turns.fold(0.0, f64::max) > 0.1);
}

/// A method of one's own that is the built-in one gives its bits, with guard and observers.
#[test]
fn an_own_method_keeps_bits_and_observers() {
    let case = loaded().build().unwrap();
    let mut steps = 0;
    let mut count = each_step(|_| {
        steps += 1;
        Control::Continue(())
    });
    let method = VelocityVerlet::new(case.solver.step_s);
    let mut own = Simulation::new(&case).unwrap().with_method(method);
    let outcome = own.run(case.solver.duration_s, &mut [&mut count]);
    let built_in = complete(&case);
    assert_eq!(outcome.state.values(), built_in.state.values());
    assert_eq!(steps, outcome.steps);
}

/// Energy balances across a change of speed and load, and balls follow the ring.
#[test]
fn a_controller_changes_speed_and_load_in_the_ledger() {
    let case = loaded().build().unwrap();
    let mut simulation = Simulation::new(&case).unwrap();
    for interval in 1..=20 {
        simulation.advance_to(1e-4 * f64::from(interval)).unwrap();
        let share = f64::from(interval) / 20.0;
        simulation
            .set_inner_speed_rad_s(1257.0 + 100.0 * share)
            .unwrap();
        simulation
            .set_radial_load_n(1500.0 - 500.0 * share)
            .unwrap();
    }
    simulation.advance_to(6e-3).unwrap();
    assert_eq!(simulation.view().ring().speed_rad_s, 1357.0);
    let outcome = simulation.outcome();
    assert!(outcome.energy_residual_relative.abs() < 1e-3, "{outcome:?}");
    let orbit = simulation
        .view()
        .balls()
        .map(|ball| ball.orbit_speed_rad_s());
    let mean_rad_s = orbit.sum::<f64>() / 14.0;
    let rolling_rad_s = simulation.case().rolling_orbit_speed_rad_s();
    assert!(
        (mean_rad_s / rolling_rad_s - 1.0).abs() < 0.05,
        "{mean_rad_s} {rolling_rad_s}"
    );
    let balls = simulation
        .view()
        .balls()
        .map(|ball| ball.gap_rad())
        .sum::<f64>();
    let free_rad = 14.0 * reference::bearing().mean_gap_rad();
    assert!((balls - free_rad).abs() < 1e-9);
    assert!(simulation.set_radial_load_n(f64::NAN).is_err());
    assert!(simulation.set_drive_torque_n_m(1.0).is_err());
}

/// A braking torque slows a rotor by M·t/I before it touches the bearing.
#[test]
fn a_drive_torque_brakes_a_rotor() {
    let case = reference::rotor_drop();
    let rotor = case.rotor.clone().unwrap();
    let mut simulation = Simulation::new(&case).unwrap();
    simulation.set_drive_torque_n_m(-5.0).unwrap();
    simulation.advance_to(1e-3).unwrap();
    let speed_rad_s = simulation.view().rotor().unwrap().speed_rad_s;
    let expected = rotor.speed_rad_s - 5.0 * 1e-3 / rotor.polar_inertia_kg_m2;
    assert!((speed_rad_s - expected).abs() < 1e-9 * expected);
    assert!(simulation.set_inner_speed_rad_s(100.0).is_err());
}

/// Laws that return nonsense are refused before anything is computed, with what they returned.
#[test]
fn nonsense_is_refused_before_a_run() {
    type Answer = fn(f64) -> [f64; 2];
    struct Law(Answer);
    impl FrictionLaw for Law {
        fn coefficient(&self, sliding_m_s: f64) -> [f64; 2] {
            self.0(sliding_m_s)
        }
    }
    let tried: [(Answer, &str); 4] = [
        (|_| [f64::NAN, 0.0], "NaN"),
        (|_| [-0.1, 0.0], "-0.1"),
        (|_| [3.0, 0.0], "3"),
        // The slope has the wrong sign.
        (|v| [0.1 + 0.1 * (-v).exp(), 0.1 * (-v).exp()], "slope"),
    ];
    for (law, said) in tried {
        let error = loaded()
            .own_friction(Law(law))
            .build()
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("own_friction") && error.contains("Law"),
            "{error}"
        );
        assert!(error.contains(said) && error.contains("m/s"), "{error}");
    }
}

/// A law that turns to nonsense in a run ends it with its name, the sliding speed and what it returned.
#[test]
fn nonsense_in_a_run_stops_it() {
    struct Fickle(Mutex<u32>);
    impl FrictionLaw for Fickle {
        fn coefficient(&self, _sliding_m_s: f64) -> [f64; 2] {
            let mut calls = self.0.lock().unwrap();
            *calls += 1;
            [if *calls > 5000 { -1.0 } else { 0.05 }, 0.0]
        }
    }
    let case = loaded()
        .own_friction(Fickle(Mutex::new(0)))
        .build()
        .unwrap();
    let outcome = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
    let Ending::Stopped(stop) = outcome.ending else {
        panic!("{:?}", outcome.ending);
    };
    assert!(
        matches!(
            &stop.cause,
            Cause::Friction { law, coefficient: -1.0, slope_s_m: 0.0, .. } if law == "Fickle"
        ),
        "{stop}"
    );
    assert!(
        stop.to_string().contains("Fickle returned μ = -1"),
        "{stop}"
    );
    assert!(outcome.end_s > 0.0 && outcome.end_s < case.solver.duration_s);
}

/// A simulation that stopped stays stopped.
#[test]
fn a_stop_is_told_at_every_further_step() {
    let mut case = loaded().build().unwrap();
    case.start.state = cageless::StartState::Rolling {
        ring_x_m: 0.0,
        ring_y_m: -1.5e-3,
    };
    case.solver.step_s = 1e-7;
    let Ok(mut simulation) = Simulation::new(&case) else {
        return; // refused at once is as well
    };
    let first = simulation.advance_to(1e-3).unwrap_err();
    assert_eq!(simulation.step().unwrap_err(), first);
    assert!(matches!(simulation.outcome().ending, Ending::Stopped(_)));
}

/// The builder says which value it refuses and what is allowed.
#[test]
fn a_builder_refuses_by_name() {
    for (builder, field) in [
        (loaded().radial_load_n(-1.0), "radial_load_n"),
        (
            loaded().friction_coefficient(f64::NAN),
            "friction_coefficient",
        ),
        (loaded().duration_s(0.0), "duration_s"),
        (loaded().step_s(1.0), "step_s"),
        (
            loaded().regularisation_speed_m_s(0.0),
            "regularisation_speed_m_s",
        ),
    ] {
        let error = builder.build().unwrap_err();
        assert_eq!(error.field, field);
    }
}

/// The prelude is a promise of at most 60 names.
#[test]
fn the_prelude_has_at_most_60_names() {
    let text = include_str!("../src/prelude.rs");
    let code: String = text
        .lines()
        .filter(|line| !line.starts_with("//"))
        .collect();
    let names = code.split("pub use crate::").skip(1).map(|one| {
        let list = one.split_once('{').map_or("one", |(_, list)| list);
        list.split(',')
            .filter(|name| !name.trim_matches([' ', '}', ';']).is_empty())
            .count()
    });
    let count: usize = names.sum();
    assert!((30..=60).contains(&count), "{count}");
}
