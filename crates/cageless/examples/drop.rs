//! A rotor of 20 kg at 30 000 rpm falls through its air gap of 0.2 mm onto a cageless bearing: its spin-up and forces.
//! From 10 ms on the drive brakes.
//!
//! `cargo run --release -p cageless --example drop`

use cageless::prelude::*;

/// Torque of the drive that brakes, N·m.
const BRAKE_N_M: f64 = -20.0;

fn print_row(time_s: f64, rotor: &RotorView, ring: &RingView, load_n: f64) {
    println!(
        "{:8.1} {:13.1} {:13.1} {:13.1} {:10.0} {load_n:21.0}",
        1e3 * time_s,
        1e6 * rotor.y_m,
        rotor.speed_rad_s,
        ring.speed_rad_s,
        rotor.contact_force_n
    );
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = reference::rotor_drop(); // one of one's own: `Rotor::estimated`, `CaseBuilder::rotor`
    let mut simulation = Simulation::new(&case)?;
    println!(
        "time, ms   rotor y, µm   rotor, rad/s   ring, rad/s   force, N   most loaded ball, N"
    );
    for row in 3..=10 {
        simulation.advance_to(2e-3 * f64::from(row))?;
        let view = simulation.view();
        let rotor = view.rotor().ok_or("no rotor")?;
        let load_n = view
            .balls()
            .fold(0.0, |most: f64, ball| most.max(ball.outer_force_n()));
        print_row(view.time_s(), &rotor, &view.ring(), load_n);
        if row == 5 {
            simulation.set_drive_torque_n_m(BRAKE_N_M)?;
        }
    }
    let residual = simulation.outcome().energy_residual_relative;
    println!("energy that the ledger does not explain: {residual:.0e} of all flows");
    assert!(residual.abs() < 1e-3);
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
