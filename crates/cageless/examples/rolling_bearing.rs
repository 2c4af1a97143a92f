//! A bearing at rest under its load, then rolling for 20 ms: the ring, the load of each ball,
//! the collisions and the energy balance.
//!
//! `cargo run -p cageless --example rolling_bearing`

#[path = "../tests/common/mod.rs"] // the bearing of the paper, Table 1
mod common;

use cageless::collision::CollisionDetector;
use cageless::equilibrium;
use cageless::simulation::{Control, run};
use cageless::summary::SummaryRecorder;

fn main() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    // Structure (d) of the paper: lC = 5.1 mm, θ = 25.2°, 12 000 rpm, 1500 N.
    let case = common::structure(5.1, 25.2);

    let rest = equilibrium::solve(&case)?;
    println!("ring at y = {:.2} µm", rest.ring_y_m * 1e6);
    for (angle, force) in rest.ball_angle_rad.iter().zip(&rest.inner_force_n) {
        println!("  ball at {:6.1}°: {force:6.1} N", angle.to_degrees());
    }

    // Observers watch every step. A detector passes each collision to a closure.
    let mut collisions = vec![];
    let mut detector = CollisionDetector::new(|collision| {
        collisions.push(collision);
        Ok(())
    });
    let mut summary = SummaryRecorder::new();
    // The last argument is asked every thousand steps or so whether to go on.
    let outcome = run(&case, &mut [&mut detector, &mut summary], &mut |_| {
        Control::Continue(())
    })?;
    detector.close(outcome.end_s)?;

    println!("{:?} after {} steps", outcome.ending, outcome.steps);
    println!("{} collisions between balls", collisions.len());
    if let Some(summary) = summary.summary() {
        println!(
            "gaps from {:.3}° to {:.3}°",
            summary.gap_min_rad.to_degrees(),
            summary.gap_max_rad.to_degrees()
        );
    }
    let residual = outcome.energy_residual_relative;
    println!("energy that the energy balance does not explain: {residual:.1e} of all flows");
    assert!(residual.abs() < 1e-3);
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
