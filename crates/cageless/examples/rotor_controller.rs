//! A rotor of 40 kg that two bearings catch, stepped with the controller of its drive in the loop: it brakes while the
//! journals touch.
//!
//! `cargo run --release -p cageless --example rotor_controller`

use cageless::linear_rotor::RigidRotor;
use cageless::prelude::*;

/// Torque of the drive that brakes, N·m.
const BRAKE_N_M: f64 = -20.0;
/// Interval of the controller, s.
const INTERVAL_S: f64 = 1e-4;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = reference::rotor_drop(); // bearing, air gap and contact of each journal
    let rotor = RigidRotor {
        mass_kg: 40.0,
        polar_inertia_kg_m2: 0.04,
        transverse_inertia_kg_m2: 0.6,
        bearing_axial_m: vec![-0.1, 0.2], // from the mass centre
        unbalances: vec![],
        clearances: vec![],
    };
    let drop = RotorDrop::new(rotor.linear()?, 3142.0, 0.0, vec![case.clone(), case], None)?;
    let mut simulation = drop.simulation()?;
    println!("time, ms   rotor, rad/s   of each bearing: journal y, µm; force, N; ring, rad/s");
    for interval in 1..=140 {
        simulation.advance_to(INTERVAL_S * f64::from(interval))?;
        let journals: Vec<RotorView> = simulation.views().filter_map(|view| view.rotor()).collect();
        if interval % 20 == 0 {
            print!(
                "{:8.1} {:14.1}",
                1e3 * simulation.time_s(),
                journals[0].speed_rad_s
            );
            for (journal, view) in journals.iter().zip(simulation.views()) {
                let (y_um, ring_rad_s) = (1e6 * journal.y_m, view.ring().speed_rad_s);
                print!("{y_um:12.1}{:7.0}{ring_rad_s:7.1}", journal.contact_force_n);
            }
            println!();
        }
        let touches = journals.iter().any(|journal| journal.contact_force_n > 0.0);
        simulation.set_drive_torque_n_m(if touches { BRAKE_N_M } else { 0.0 })?;
    }
    let outcome = simulation.drop_outcome();
    let residual = outcome.rotor.energy_residual_relative;
    println!("energy of the rotor that its ledger does not explain: {residual:.0e} of all flows");
    assert!(outcome.stopped_bearing().is_none() && residual.abs() < 1e-3);
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
