//! A law of friction of one's own, and the heat of 20 ms in a discrete raceway, where balls slide, beside that of the
//! built-in smooth law. The same film on the journal of a rotor that falls spins the inner ring up.
//!
//! `cargo run -p cageless --example own_friction_law`

use cageless::prelude::*;

/// Friction of a dry film that wears thin with the sliding speed: μ falls from 0.12 at rest to 0.06.
struct DryFilm;

impl FrictionLaw for DryFilm {
    /// μ and its slope over the sliding speed; everything else follows.
    fn coefficient(&self, sliding_m_s: f64) -> [f64; 2] {
        let excess = 0.06 * (-sliding_m_s / 0.5).exp();
        [0.06 + excess, -excess / 0.5]
    }
}

/// Energy that friction turns into heat in 20 ms, J.
fn heat_j(case: CaseBuilder) -> Result<f64, Box<dyn std::error::Error>> {
    let mut simulation = Simulation::new(&case.build()?)?;
    simulation.advance_to(0.02)?;
    Ok(simulation.state().friction_j())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let bearing = reference::bearing();
    let raceway = reference::Structure::D.raceway(&bearing)?;
    let case = CaseBuilder::of(bearing)
        .raceway(raceway)
        .inner_speed_rad_s(1257.0)
        .radial_load_n(1500.0);
    let smooth_j = heat_j(case.clone().friction_coefficient(0.06))?;
    let own_j = heat_j(case.own_friction(DryFilm))?;
    println!(
        "μ = 0.06: {:.3} mJ; falling from 0.12: {:.3} mJ",
        1e3 * smooth_j,
        1e3 * own_j
    );
    let bore = InnerRingBore {
        radius_m: 15e-3,
        polar_inertia_kg_m2: 5.5e-5,
    };
    let rotor = Rotor::estimated(20.0, 0.02, 3142.0, 2e-4);
    let drop = CaseBuilder::of(reference::bearing().with_inner_ring_bore(bore)?)
        .rotor(rotor, None)
        .own_journal_friction(DryFilm);
    let mut simulation = Simulation::new(&drop.build()?)?;
    simulation.advance_to(0.012)?;
    let speed_rad_s = simulation.view().ring().speed_rad_s;
    println!("inner ring 12 ms after the fall of a rotor: {speed_rad_s:.1} rad/s");
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
