//! A run that stops advises keys that its case can have.

use cageless::simulation::{Cause, Stop};
use cageless_io::case_file::CaseFile;

const RUN: &str = include_str!("../../../cases/conventional.toml");
const DROP: &str = include_str!("../../../cases/touchdown-d.toml");

/// Two rows, of which the second may have a spring.
const ROWS: &str =
    "\n[[row]]\naxial_position_mm = -10\n\n[[row]]\naxial_position_mm = 10\ncontact_sign = -1\n";

/// Values, of which each key takes one.
const VALUES: [&str; 6] = ["random", "0.5", "14", "20", "-10", "2e7"];

/// Keys in a text: `section.key`.
fn keys(text: &str) -> Vec<&str> {
    let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || "._".contains(c)));
    let keys = words.filter(|word| {
        (word.split_once('.')).is_some_and(|(section, key)| {
            !key.is_empty() && section.starts_with(|c: char| c.is_ascii_lowercase())
        })
    });
    keys.collect()
}

#[test]
fn advice_names_keys_that_the_case_can_have() {
    let flows = Cause::EnergyFromNowhere {
        residual_j: 1.0,
        flows_j: 2.0,
    };
    let meet = |balls_that_hold| Cause::RingsMeet {
        displacement_m: 1e-3,
        balls_that_hold,
    };
    let causes = [
        Cause::NotFinite,
        meet(None),
        meet(Some(9)),
        Cause::ThroughInnerRing(0),
        Cause::ThroughOuterRing(1),
        Cause::ThroughBall(2),
        Cause::RotorThroughInnerRing,
        Cause::OffSupport,
        Cause::OffSpring(1),
        flows,
        Cause::NotResolved,
    ];
    for (text, drop) in [(RUN, false), (DROP, true)] {
        for cause in &causes {
            // Nothing but a drop has a rotor or a support that moves, only rows have springs.
            if !drop && matches!(cause, Cause::RotorThroughInnerRing | Cause::OffSupport) {
                continue;
            }
            let stop = Stop {
                time_s: 1e-3,
                step_s: 1e-6,
                automatic_step_s: if drop { 1e-7 } else { 1e-6 },
                drop,
                cause: cause.clone(),
            };
            let advice = stop.advice_by_key();
            // In Rust the same advice has the names of the crate.
            let (in_rust, by_key) = (stop.advice(), keys(&stop.advice()).len());
            assert!(in_rust.contains("::") && by_key == 0, "{in_rust}");
            assert_eq!(in_rust.contains('('), advice.contains('('), "{in_rust}");
            let rows = match cause {
                Cause::OffSpring(_) => ROWS,
                _ => "",
            };
            let found = keys(&advice);
            assert!(!found.is_empty(), "{advice}");
            for key in found {
                let rolling = key.starts_with("start.ring_");
                let possible = VALUES.iter().any(|value| {
                    let mut sets = vec![format!("{key}={value}")];
                    sets.extend(rolling.then(|| "start.state=rolling".to_owned()));
                    CaseFile::parse(&format!("{text}{rows}"), "case.toml", &sets).is_ok()
                });
                assert!(possible, "{key} in a case with drop = {drop}: {advice}");
            }
        }
    }
}
