//! A bearing of one's own with a discrete raceway, 20 ms of its motion, and the gaps between its balls.
//!
//! `cargo run -p cageless --example first_bearing`

use cageless::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let dimensions = BearingDimensions::estimated(14, 4.7625e-3, 23.0e-3); // balls, ball radius, pitch radius: m
    let bearing = Bearing::new(dimensions, Material::STEEL)?;
    println!("a ball: {:.2} g", 1e3 * bearing.ball_mass_kg());
    let raceway = reference::Structure::D.raceway(&bearing)?;
    let case = CaseBuilder::of(bearing)
        .raceway(raceway)
        .inner_speed_rad_s(1257.0)
        .radial_load_n(1500.0)
        .build()?;
    let mut simulation = Simulation::new(&case)?;
    simulation.advance_to(0.02)?;
    for ball in simulation.view().balls() {
        let gap_deg = ball.gap_rad().to_degrees();
        println!(
            "ball {:2}: {gap_deg:.3}°, {:6.1} N",
            ball.index() + 1,
            ball.outer_force_n()
        );
    }
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
