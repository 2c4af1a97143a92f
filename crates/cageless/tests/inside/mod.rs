//! Tests of what is not public. The library compiles them with its unit tests, so that they reach the items of the
//! crate: `cargo test -p cageless --lib inside`. The tests beside this folder see what a user sees.

mod accepted_raceways;
mod adaptive;
mod balance;
mod ball_advance;
mod batch;
mod computations;
mod contact_tally;
mod creep;
mod elastic_flanks;
mod equilibrium;
mod equivalent_load;
mod film;
mod film_motion;
mod film_space;
mod film_traction;
mod film_traction_space;
mod fit_by_tolerance;
mod free_rotor;
mod friction;
mod geometry;
mod given_over_time;
mod guard;
mod impact;
mod integrator;
mod linear_rotor;
mod load_distribution;
mod lubrication;
mod measured_frame;
mod measured_ring;
mod measured_slot;
mod observed;
mod operating_results;
mod outer_contact_geometry;
mod outer_ring;
mod passage;
mod preload;
mod raceway_shapes;
mod rating;
mod rotor_damping;
mod rotor_planes;
mod second_disc;
mod slot;
mod slot_curve;
mod slot_ring;
mod space;
mod space_drop;
mod space_motion;
mod space_rotor;
mod space_rows;
mod space_springs;
mod space_step;
mod step_limits;
mod touchdown_balance;
mod touchdown_heat;
mod touchdown_reference;
mod touchdown_results;
mod turned_ring;
mod unbalance;
mod unequal_balls;
mod uneven_gaps;
mod verification;
mod vibration;

use proptest::test_runner::{Config, FileFailurePersistence};

/// Trials of a property; seeds that failed stay beside the file.
fn trials(cases: u32) -> Config {
    let seeds = FileFailurePersistence::WithSource("proptest-regressions");
    Config {
        cases,
        failure_persistence: Some(Box::new(seeds)),
        ..Config::default()
    }
}
