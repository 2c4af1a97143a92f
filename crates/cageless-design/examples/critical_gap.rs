//! Theoretical gap of a raceway (Zhao 2022, Eq. (11)) beside the critical gap that the motion of
//! a pair of balls gives: the gap at the entrance that just closes in the raceway. Real balls that a raceway holds there
//! touch now and then.
//!
//! `cargo run -p cageless-design --example critical_gap`

use cageless::ball_grade;
use cageless::closed_forms::{Eq11, steady_gap_rad, theoretical_gap_rad};
use cageless::prelude::*;
use cageless::reference::Structure;
use cageless::steady::HeldPair;
use cageless_design::critical_gap::{PairTest, critical_gap_rad};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // 1e-5 rad is enough to print three digits.
    let test = PairTest {
        tolerance_rad: 1e-5,
        ..PairTest::default()
    };
    let grade = ball_grade(10).ok_or("G10 is no grade of balls")?;
    println!("lC, mm    θ, °    Eq. (11), °    critical gap, °    contacts of a pair per orbit");
    for structure in [Structure::D, Structure::J] {
        let (row, case) = (structure.row(), structure.case());
        let theory = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Published);
        let critical = critical_gap_rad(&case, &test, &mut |_| Control::Continue(()))?;
        let pair = HeldPair {
            critical_gap_rad: critical,
            steady_gap_rad: steady_gap_rad(&case.bearing, &case.raceways),
        };
        println!(
            "{:6.2} {:7.2} {:14.3} {:18.3} {:31.2}",
            row.axial_span_mm,
            row.half_angle_deg,
            theory.to_degrees(),
            critical.to_degrees(),
            pair.contacts_per_orbit(&case.bearing, grade)
        );
        // A ball that slips loses less speed in the raceway: the gap that closes is smaller.
        assert!(critical < 1.05 * theory);
    }
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
