//! Studies of drops: as a sweep has them, verified, scattered, refused.

use std::path::Path;

use cageless::verification::Convergence;
use cageless_io::case_file::CaseFile;
use cageless_io::plan_file::PlanFile;
use cageless_io::results::Cell;
use cageless_study::drop::{DropRequest, study};
use cageless_study::sweep::Sweep;
use cageless_study::{Silent, on_threads};

const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");

/// A drop to 2.6 ms after the first contact.
fn drop(changes: &[&str]) -> CaseFile {
    let mut set = vec!["solver.duration_s=0.009".to_owned()];
    set.extend(changes.iter().map(|change| (*change).to_owned()));
    CaseFile::read(&Path::new(CASES).join("touchdown-d.toml"), &set).unwrap()
}

#[test]
fn a_sweep_has_the_results_of_its_drops() {
    let plan = format!(
        "schema = 1\ncase = \"{CASES}/touchdown-d.toml\"\ncompute = [\"drop\"]\n\
         [set]\nsolver.duration_s = 0.009\n\
         [grid]\nrotor.friction_coefficient = [0.1, 0.2]\nrotor.air_gap_um = [200.0, 1000.0]\n"
    );
    let plan = PlanFile::parse(&plan, "plan.toml", Path::new("")).unwrap();
    let sweep = Sweep::new(plan).unwrap();
    let rows = sweep
        .evaluate(0..4, &|| std::ops::ControlFlow::Continue(()))
        .unwrap();
    for (row, mu, gap) in [(0, 0.1, 200.0), (1, 0.2, 200.0), (2, 0.1, 1000.0)] {
        let one = drop(&[
            &format!("rotor.friction_coefficient={mu}"),
            &format!("rotor.air_gap_um={gap:?}"),
        ]);
        let alone = study(&one, DropRequest::default(), None, &Silent).unwrap();
        for (quantity, value) in alone.drop.result.results.iter() {
            let column = sweep.column(&quantity.column_name()).unwrap();
            assert_eq!(&rows[row][column], value, "{}", quantity.name);
        }
    }
    // From 1 mm the rotor takes 14 ms to fall.
    let state = sweep.column("drop_end_state").unwrap();
    assert_eq!(rows[2][state], Cell::Text("falling".to_owned()));
    assert_eq!(
        rows[2][sweep.column("drop_first_contact_ms").unwrap()],
        Cell::Null
    );
}

#[test]
fn a_drop_without_a_rotor_says_which_keys_it_needs() {
    let case = CaseFile::read(&Path::new(CASES).join("zhao-d.toml"), &[]).unwrap();
    let refused = DropRequest::default()
        .check(&case, "zhao-d.toml")
        .unwrap_err();
    let plan = format!("schema = 1\ncase = \"{CASES}/zhao-d.toml\"\ncompute = [\"drop\"]\n");
    let of_plan = PlanFile::parse(&plan, "plan.toml", Path::new("")).unwrap_err();
    assert_eq!(of_plan.line(), Some(3));
    for message in [refused.to_string(), of_plan.to_string()] {
        for key in [
            "[rotor]",
            "mass_kg",
            "speed_rpm",
            "air_gap_um",
            "inner_ring_bore_radius_mm",
        ] {
            assert!(message.contains(key), "{message}");
        }
        assert!(!message.contains("rotor_mass_kg"), "{message}");
    }
}

#[test]
fn the_first_milliseconds_of_a_drop_are_converged() {
    let request = DropRequest {
        verify: true,
        ..DropRequest::default()
    };
    let file = drop(&["solver.duration_s=0.007"]);
    let found = study(&file, request, None, &Silent).unwrap();
    let verification = found.verification.unwrap();
    assert_eq!(verification.end_states, verification.half_step_end_states);
    let verdict = |name: &str| {
        let mut all = verification.judgements.iter();
        all.find(|j| j.quantity.name == name).unwrap().verdict
    };
    for name in [
        "first_contact_ms",
        "rotor_force_max_n",
        "impacts",
        "ring_speed_rpm",
    ] {
        assert_eq!(verdict(name), Convergence::Converged, "{name}");
    }
    // Too long a step shows.
    let file = drop(&["solver.duration_s=0.007", "solver.step_us=2.7"]);
    let coarse = study(&file, request, None, &Silent).unwrap();
    let coarse = coarse.verification.unwrap();
    let change = |v: &cageless_study::drop::DropVerification, name: &str| {
        let mut all = v.judgements.iter();
        let j = all.find(|j| j.quantity.name == name).unwrap();
        j.step_change / j.value.abs()
    };
    let name = "rotor_friction_j";
    assert!(change(&coarse, name) > change(&verification, name));
}

#[test]
fn scattered_drops_are_the_same_on_any_number_of_threads() {
    let request = DropRequest {
        samples: Some(11),
        ..DropRequest::default()
    };
    let drops = |threads: usize| {
        let threads = std::num::NonZeroUsize::new(threads);
        let done = on_threads(threads, || {
            study(&drop(&["solver.duration_s=0.0075"]), request, None, &Silent)
        });
        done.unwrap().unwrap().ensemble.unwrap()
    };
    let one = drops(1);
    assert_eq!(one.completed, 11);
    assert_eq!(one, drops(2));
}
