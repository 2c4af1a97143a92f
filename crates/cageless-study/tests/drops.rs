//! Studies of drops: as a sweep has them, verified, scattered, refused.

use std::path::Path;

use cageless::Snapshot;
use cageless::collision::Collision;
use cageless::simulation::ObserverError;
use cageless::verification::Convergence;
use cageless_io::case_file::CaseFile;
use cageless_io::plan_file::PlanFile;
use cageless_io::results::Cell;
use cageless_study::drop::{DropRequest, study};
use cageless_study::quantities::Results;
use cageless_study::run::{Options, Rows, run};
use cageless_study::sweep::Sweep;
use cageless_study::{Silent, on_threads};

const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");

/// Checks the numbers of contacts in `results` against the contacts themselves.
fn counted(results: &Results, contacts: &[Collision]) {
    let above = |limit: f64| {
        let fast = contacts.iter().filter(|c| c.approach_speed_m_s > limit);
        Some(Cell::Integer(fast.count() as i64))
    };
    for (name, limit) in [
        ("collisions", f64::NEG_INFINITY),
        ("collisions_above_0_1_m_s", 0.1),
        ("collisions_above_0_5_m_s", 0.5),
        ("collisions_above_1_m_s", 1.0),
    ] {
        assert_eq!(results.get(name).cloned(), above(limit), "{name}");
    }
}

#[test]
fn contacts_between_balls_are_counted_by_their_approach_speed() {
    let file = drop(&["solver.duration_s=0.15", "output.interval_us=1000"]);
    let found = study(&file, DropRequest::default(), None, &Silent).unwrap();
    let drop = &found.drop;
    counted(&drop.result.results, &drop.collisions);
    let number = |name: &str| drop.result.results.number(name);
    assert!(number("collisions") > number("collisions_above_0_1_m_s"));
    assert!(number("collisions_above_0_1_m_s") > number("collisions_above_0_5_m_s"));
    assert!(number("collisions_above_0_5_m_s") > number("collisions_above_1_m_s"));
    assert!(number("collisions_above_1_m_s") > 10.0);
    // The rates at the end are those of the windows of the last fifth.
    let first_s = 1e-3 * number("first_contact_ms");
    let from_s = file.case().solver.duration_s - 0.2 * (file.case().solver.duration_s - first_s);
    let windows = drop.result.windows.iter();
    // Windows of 5 ms, the last shorter.
    let start_s = windows
        .map(|w| 1e-3 * w.time_ms)
        .filter(|middle| middle + 2.5e-3 > from_s)
        .fold(f64::INFINITY, f64::min)
        - 2.5e-3;
    let fast = |limit: f64| {
        let late = drop.collisions.iter().filter(|c| c.start_s > start_s);
        late.filter(|c| c.approach_speed_m_s > limit).count() as f64
            / (file.case().solver.duration_s - start_s)
    };
    for (name, limit) in [
        ("end_collision_rate_hz", f64::NEG_INFINITY),
        ("end_collision_rate_above_0_1_m_s_hz", 0.1),
        ("end_collision_rate_above_0_5_m_s_hz", 0.5),
        ("end_collision_rate_above_1_m_s_hz", 1.0),
    ] {
        let rate = number(name);
        assert!(
            (rate / fast(limit) - 1.0).abs() < 0.02,
            "{name}: {rate} {}",
            fast(limit)
        );
    }
}

#[test]
fn contacts_in_a_run_are_counted_by_their_approach_speed() {
    struct Kept(Vec<Collision>);
    impl Rows for Kept {
        fn snapshot(&mut self, _: &Snapshot) -> Result<(), ObserverError> {
            Ok(())
        }
        fn collision(&mut self, collision: &Collision) -> Result<(), ObserverError> {
            self.0.push(*collision);
            Ok(())
        }
    }
    let changes = [
        "raceway.axial_span_mm=4.95",
        "raceway.half_angle_deg=35",
        "solver.duration_s=0.1",
    ]
    .map(str::to_owned);
    let file = CaseFile::read(&Path::new(CASES).join("zhao-d.toml"), &changes).unwrap();
    let mut kept = Kept(vec![]);
    let options = Options {
        rows: Some(&mut kept),
        verify: false,
    };
    let summary = run(&file, options, &Silent).unwrap().summary;
    let from_s = summary.results.number("settled_after_s");
    kept.0.retain(|c| c.start_s > from_s);
    counted(&summary.results, &kept.0);
    assert!(summary.results.number("collisions_above_0_1_m_s") > 0.0);
}

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
    // The error grows with the square of the step.
    for name in ["rotor_friction_j", "heat_j", "ring_speed_rpm"] {
        let (at_step, at_long_step) = (change(&verification, name), change(&coarse, name));
        println!("{name}: {at_step:.1e}, {at_long_step:.1e}");
        assert!((3e-5..4e-4).contains(&at_step), "{name}: {at_step:e}");
        assert!(
            (3e-4..3e-3).contains(&at_long_step),
            "{name}: {at_long_step:e}"
        );
        assert!(
            at_long_step > 3.0 * at_step,
            "{name}: {at_long_step:e} {at_step:e}"
        );
    }
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
