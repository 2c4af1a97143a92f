//! A rotor falls onto a cageless bearing: spin-up, forces and collisions, printed.
//!
//! cargo run --release -p cageless --example drop -- 0.1

#[path = "../tests/common/mod.rs"]
mod common;

use cageless::IntegrationMethod;
use cageless::collision::CollisionDetector;
use cageless::recorder::Recorder;
use cageless::simulation::{Control, run};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let duration_s: f64 = arguments.next().map_or(Ok(0.1), |text| text.parse())?;
    let mut case = common::drop_case();
    if let Some(friction) = arguments.next() {
        case.contact.friction.coefficient = friction.parse()?;
    }
    let raceway = common::raceway(&case.bearing, 5.1, 25.2, 0.0);
    case = case.with_raceways(vec![raceway]);
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.duration_s = duration_s;
    if let Some(step) = arguments.next() {
        case.solver.step_s = step.parse()?;
    }
    let weight = case.rotor.as_ref().map_or(0.0, |r| r.mass_kg) * case.operation.gravity_m_s2;
    println!("time_ms  x_um  y_um  ring_rad_s  rotor_rad_s  force/weight  sliding_m_s");
    let interval_s = duration_s / 20.0;
    let mut recorder = Recorder::new(interval_s, |snapshot| {
        if let Some(r) = snapshot.rotor {
            println!(
                "{:7.2} {:6.1} {:6.1} {:10.1} {:11.1} {:8.2} {:9.3}",
                1e3 * snapshot.time_s,
                1e6 * r.x_m,
                1e6 * r.y_m,
                r.ring_speed_rad_s,
                r.speed_rad_s,
                r.contact_force_n / weight,
                r.contact_sliding_m_s
            );
        }
        Ok(())
    });
    let mut collisions = 0;
    let mut detector = CollisionDetector::new(|_| {
        collisions += 1;
        Ok(())
    });
    let start = std::time::Instant::now();
    let outcome = run(&case, &mut [&mut recorder, &mut detector], &mut |_| {
        Control::Continue(())
    })?;
    let wall_s = start.elapsed().as_secs_f64();
    println!("{collisions} collisions of balls, {:?}", outcome.ending);
    for &term in outcome.state.layout().energy_terms() {
        println!(
            "{:24} {:12.6} J",
            term.name(),
            outcome.state.energy_term_j(term)
        );
    }
    println!(
        "energy balance residual {:.1e}; step {:e} s; {:.2} s for each simulated second",
        outcome.energy_residual_relative,
        case.solver.step_s,
        wall_s / outcome.end_s
    );
    Ok(())
}
