//! A loop of one's own: a controller that runs the bearing up to 12 000 rpm, and takes speed out whenever a ball bears
//! more than it may. After 10 ms the radial load falls by a tenth.
//!
//! `cargo run -p cageless --example speed_controller`

use cageless::prelude::*;

/// Largest load of a ball that the controller accepts, N.
const LOAD_MAX_N: f64 = 560.0;
/// Speed asked for, rad/s.
const WANTED_RAD_S: f64 = 1257.0;
/// Time between two decisions of the controller, s.
const INTERVAL_S: f64 = 0.5e-3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = CaseBuilder::of(reference::bearing())
        .inner_speed_rad_s(600.0)
        .radial_load_n(1500.0);
    let mut simulation = Simulation::new(&case.build()?)?;
    let mut speed_rad_s: f64 = 600.0;
    for decision in 1..=40 {
        simulation.advance_to(f64::from(decision) * INTERVAL_S)?;
        let view = simulation.view();
        let load_n = view
            .balls()
            .fold(0.0, |most: f64, ball| most.max(ball.outer_force_n()));
        speed_rad_s = match load_n > LOAD_MAX_N {
            true => speed_rad_s - 20.0,
            false => (speed_rad_s + 40.0).min(WANTED_RAD_S),
        };
        if decision % 8 == 0 {
            println!(
                "{:4.1} ms: {load_n:5.0} N, {speed_rad_s:6.0} rad/s",
                1e3 * view.time_s()
            );
        }
        simulation.set_inner_speed_rad_s(speed_rad_s)?;
        if decision == 20 {
            simulation.set_radial_load_n(1350.0)?;
        }
    }
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
