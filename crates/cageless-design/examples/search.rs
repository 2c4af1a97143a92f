//! A search for the raceway of a bearing: the span and half angle that it recommends.
//!
//! `cargo run --release -p cageless-design --example search`

use cageless::prelude::*;
use cageless_design::search::{Request, run_here, search};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = reference::conventional();
    let mut request = Request::from_case(&case);
    request.half_angle_range_rad = Some([20.0, 30.0].map(f64::to_radians));
    request.starts = 1;
    request.budget = 60; // simulations of all balls at most; closed forms and pairs of balls sort out the rest
    // The search hands out its simulations in batches: here they run on this thread.
    let found = search(&case, &request, &mut |_stage, jobs| run_here(&case, jobs))?;
    match found
        .recommended
        .map(|best| &found.evaluations[best].structure)
    {
        Some(best) => println!(
            "lC = {:.2} mm, θ = {:.1}°, of {} raceways",
            1e3 * best.axial_span_m,
            best.half_angle_rad.to_degrees(),
            found.evaluations.len()
        ),
        None => println!(
            "none of {} raceways spreads the balls",
            found.evaluations.len()
        ),
    }
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
