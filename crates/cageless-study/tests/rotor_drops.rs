//! Studies of drops into several bearings: scattered and verified.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::drops::{judged, studied};
use cageless::IntegrationMethod;
use cageless::simulation::{Ending, RotorDrop};
use cageless::touchdown::Scatter;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseFile;
use cageless_io::rotor_file::{
    RotorBody, RotorClearance, RotorDescription, RotorPlace, RotorUnbalance,
};
use cageless_study::drop::{DropRequest, DropRow, FiledDrop, ensemble, study};
use cageless_study::{Progress, Silent, StudyError, Workload, on_threads};

const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");

/// A bearing that the rotor is about to touch.
fn bearing(name: &str, changes: &[&str]) -> CaseFile {
    let near = ["rotor.y_um=-170", "rotor.vy_m_s=-0.06"];
    let set: Vec<String> = (near.iter().chain(changes))
        .map(|change| (*change).to_owned())
        .collect();
    CaseFile::read(&Path::new(CASES).join(name), &set).unwrap()
}

fn rigid(places_mm: &[f64]) -> RotorDescription {
    RotorDescription {
        body: RotorBody::Rigid {
            mass_kg: 20.0 * places_mm.len() as f64,
            polar_inertia_kg_m2: 0.02,
            transverse_inertia_kg_m2: 0.3,
        },
        bearings: places_mm.iter().map(|z| RotorPlace::AxialMm(*z)).collect(),
        unbalances: vec![],
        clearances: vec![],
    }
}

/// A rotor with an unbalance in two bearings of which one is conventional.
fn two_bearings(changes: &[&str]) -> BearingArrangement {
    let unbalance = RotorUnbalance {
        place: RotorPlace::AxialMm(30.0),
        amount_g_mm: 200.0,
        angle_deg: 0.5_f64.to_degrees(),
    };
    let rotor = RotorDescription {
        unbalances: vec![unbalance],
        ..rigid(&[-100.0, 200.0])
    };
    let cases = ["touchdown-d.toml", "touchdown-conventional.toml"].map(|n| bearing(n, changes));
    BearingArrangement::new("", &rotor, 30000.0, 0.0, &cases).unwrap()
}

fn unbalance_deg(row: &DropRow) -> f64 {
    let of_case = row.eccentricity_phase_deg;
    of_case.or(row.unbalance_turn_deg).unwrap()
}

#[test]
fn a_rigid_rotor_in_one_bearing_scatters_as_the_case_of_one_plane() {
    let case = bearing("touchdown-d.toml", &["solver.duration_s=0.0015"]);
    let cases = std::slice::from_ref(&case);
    let file = BearingArrangement::new("", &rigid(&[0.0]), 30000.0, 0.0, cases).unwrap();
    let scatter = Scatter::default();
    let alone = FiledDrop {
        drop: RotorDrop::of_case(case.case()).unwrap(),
        files: cases,
    };
    let linear = FiledDrop {
        drop: file.drop().unwrap().clone(),
        files: file.cases(),
    };
    let one = ensemble(&alone, 3, &scatter, &Silent).unwrap();
    let several = ensemble(&linear, 3, &scatter, &Silent).unwrap();
    assert_eq!((several.completed, several.bearings.len()), (3, 1));
    for (a, b) in one.drops.iter().zip(&several.drops) {
        assert_eq!(unbalance_deg(a), unbalance_deg(b));
        let (a, b) = (&a.bearings[0], &b.bearings[0]);
        assert_eq!(
            (a.rotor_friction, a.ball_friction, a.radial_clearance_um),
            (b.rotor_friction, b.ball_friction, b.radial_clearance_um)
        );
        assert_eq!(a.support_damping_n_s_m, b.support_damping_n_s_m);
        assert_eq!(a.result.end_state(), b.result.end_state());
        for name in [
            "first_contact_ms",
            "rotor_force_max_n",
            "inner_pressure_max_mpa",
        ] {
            let [a, b] = [a, b].map(|row| row.result.results.number(name));
            assert!((b / a - 1.0).abs() < 1e-6, "{name}: {a} {b}");
        }
    }
    let (a, b) = (&one.bearings[0], &several.bearings[0]);
    assert_eq!(a.end_states, b.end_states);
    for many in [&one, &several] {
        assert_eq!(a.backward_whirl, many.in_any_bearing);
    }
}

#[test]
fn scattered_drops_into_bearings_are_the_same_on_any_number_of_threads() {
    let file = two_bearings(&["solver.duration_s=0.0012"]);
    let request = DropRequest {
        samples: Some(3),
        ..DropRequest::default()
    };
    let drops = |threads: usize| {
        let threads = std::num::NonZeroUsize::new(threads);
        let done = on_threads(threads, || studied(&file, request).ensemble.unwrap());
        done.unwrap()
    };
    let many = drops(1);
    assert_eq!(many.completed, 3);
    assert_eq!(many, drops(2));
    // Each bearing has draws of its own; drops differ.
    let [a, b] = [0, 1].map(|k| &many.drops[0].bearings[k]);
    assert!(a.rotor_friction / 0.15 != b.rotor_friction / 0.15);
    assert!(a.radial_clearance_um != b.radial_clearance_um);
    let turned = [0, 1].map(|k: usize| unbalance_deg(&many.drops[k]));
    assert!(turned[0] != turned[1]);
    // The distribution of a bearing is that of its drops.
    for (k, of_bearing) in many.bearings.iter().enumerate() {
        let name = "rotor_force_max_n";
        let forces = many
            .drops
            .iter()
            .map(|d| d.bearings[k].result.results.number(name));
        let found = of_bearing
            .quantiles
            .iter()
            .find(|q| q.quantity.name == name);
        assert_eq!(found.unwrap().most, Some(forces.fold(0.0, f64::max)));
    }
}

/// Cancels when the drops are under way.
#[derive(Default)]
struct Cancelled {
    workload: Mutex<Workload>,
    begun: AtomicBool,
}

impl Progress for Cancelled {
    fn interrupted(&self) -> bool {
        self.begun.load(Ordering::Relaxed)
    }

    fn workload(&self) -> Option<&Mutex<Workload>> {
        Some(&self.workload)
    }

    fn show(&self, task: &str, _: f64) {
        self.begun.fetch_or(task == "drops", Ordering::Relaxed);
    }
}

#[test]
fn cancelled_drops_leave_the_drop_itself() {
    let file = two_bearings(&["solver.duration_s=0.0003"]);
    let request = DropRequest {
        samples: Some(50),
        verify: true,
        ..DropRequest::default()
    };
    let drop = file.drop().unwrap().clone();
    let found = study(
        &file,
        drop,
        request,
        vec![None, None],
        &Cancelled::default(),
    )
    .unwrap();
    assert!(found.interrupted && found.ensemble.is_none() && found.verification.is_none());
    assert_eq!(found.warnings, ["the scattered drops: interrupted"]);
    let endings = found.record.bearings.iter().map(|b| &b.outcome.ending);
    assert_eq!(endings.filter(|e| matches!(e, Ending::Complete)).count(), 2);
    let case = bearing("touchdown-d.toml", &["solver.duration_s=0.0003"]);
    let alone = FiledDrop {
        drop: RotorDrop::of_case(case.case()).unwrap(),
        files: &[case],
    };
    let done = ensemble(&alone, 50, &Scatter::default(), &Cancelled::default());
    assert!(matches!(done, Err(StudyError::Interrupted)));
}

/// Cancels once a fraction of the whole is done.
struct Until {
    fraction: f64,
    workload: Mutex<Workload>,
    over: AtomicBool,
}

impl Progress for Until {
    fn interrupted(&self) -> bool {
        self.over.load(Ordering::Relaxed)
    }

    fn workload(&self) -> Option<&Mutex<Workload>> {
        Some(&self.workload)
    }

    fn show(&self, _: &str, fraction: f64) {
        let over = fraction > self.fraction;
        self.over.fetch_or(over, Ordering::Relaxed);
    }
}

/// Whatever follows the drop itself, a study that is cancelled in it says so and keeps the verdict on the drop; of
/// drops one after the other the verdict is on all of them.
#[test]
fn a_study_that_is_cancelled_after_its_drop_says_so() {
    let near = ["solver.duration_s=0.001", "solver.step_us=0.2"];
    let request = DropRequest::default();
    let rests = [
        // The second of two equal drops.
        (
            DropRequest {
                compare: true,
                ..request
            },
            0.6,
        ),
        // A hundred more.
        (
            DropRequest {
                samples: Some(100),
                ..request
            },
            0.1,
        ),
        (
            DropRequest {
                verify: true,
                ..request
            },
            0.5,
        ),
    ];
    let file: BearingArrangement = bearing("touchdown-d.toml", &near).into();
    for (file, cases) in [(file, 1), (two_bearings(&near), 2)] {
        let studied = |request: DropRequest, progress: &dyn Progress| {
            let drop = file.drop().unwrap().clone();
            let rows = (0..cases).map(|_| None).collect();
            study(&file, drop, request, rows, progress).unwrap()
        };
        let alone = studied(request, &Silent);
        // It ends too early to pass.
        assert_eq!(alone.judgement.passes(), None, "{:?}", alone.judgement);
        assert!(!alone.interrupted);
        for (request, fraction) in rests {
            let progress = Until {
                fraction,
                workload: Mutex::default(),
                over: AtomicBool::new(false),
            };
            let found = studied(request, &progress);
            assert!(found.interrupted, "{request:?}");
            assert!(matches!(found.record.ending(), Ending::Complete));
            assert_eq!(found.judgement, alone.judgement, "{request:?}");
        }
    }
}

/// A rotor that has reached one of two bearings that carry it is not judged.
#[test]
fn a_bearing_that_is_not_reached_is_not_judged() {
    let file = two_bearings(&["solver.duration_s=0.001"]);
    let apart = ["bearing.2.rotor.y_um=0", "bearing.2.rotor.vy_m_s=0"].map(str::to_owned);
    let file = file.changed(&apart).unwrap();
    let found = studied(&file, DropRequest::default());
    let touched = |k: usize| {
        let results = &found.record.bearings[k].result.results;
        results.value("first_contact_ms").is_some()
    };
    assert!(touched(0) && !touched(1));
    assert_eq!(found.judgement.passes(), None, "{:?}", found.judgement);
    let reasons = found.judgement.reasons();
    let text =
        "bearing 2: the rotor has not touched the inner ring: simulate longer (solver.duration_s)";
    assert!(reasons.iter().any(|reason| reason == text), "{reasons:?}");
}

/// A later drop that is cancelled leaves all of them without a verdict, and nothing else is begun.
#[test]
fn drops_in_succession_that_are_cancelled_are_not_judged() {
    let sets = [
        "rotor.y_um=0",
        "rotor.vy_m_s=0",
        "solver.duration_s=0.05",
        "rotor.drive_torque_n_m=-4.0",
        "rotor.speed_rpm=300",
        "bearing.inner_ring_polar_inertia_kg_m2=5e-6",
    ];
    let file: BearingArrangement = bearing("touchdown-d.toml", &sets).into();
    let request = DropRequest {
        drops: Some(2),
        compare: true,
        ..DropRequest::default()
    };
    let progress = Until {
        // In the second of three equal drops.
        fraction: 0.4,
        workload: Mutex::default(),
        over: AtomicBool::new(false),
    };
    let drop = file.drop().unwrap().clone();
    let found = study(&file, drop, request, vec![None], &progress).unwrap();
    assert_eq!(found.succession.later.len(), 1);
    assert!(found.interrupted && found.conventional.is_none());
    assert_eq!(found.judgement.passes(), None, "{:?}", found.judgement);
    let reasons = found.judgement.reasons();
    assert!(
        reasons.len() == 1 && reasons[0].starts_with("drop 2: interrupted after "),
        "{reasons:?}"
    );
}

/// Cancels at once.
struct Ended;

impl Progress for Ended {
    fn interrupted(&self) -> bool {
        true
    }
}

/// A drop that was interrupted says so, and passes no verdict by the part that it has.
#[test]
fn an_interrupted_drop_is_not_judged() {
    let near = ["rotor.y_um=-199", "rotor.vy_m_s=-0.06"];
    let file: BearingArrangement = bearing("touchdown-d.toml", &near).into();
    for (file, cases) in [(file, 1), (two_bearings(&near), 2)] {
        let drop = file.drop().unwrap().clone();
        let rows = drop.cases().iter().map(|_| None).collect();
        let found = study(&file, drop, DropRequest::default(), rows, &Ended).unwrap();
        let json: serde_json::Value = serde_json::from_str(&found.to_json(&file).unwrap()).unwrap();
        let bearings = json["bearings"].as_array().unwrap();
        assert_eq!(bearings.len(), cases);
        for bearing in bearings {
            assert!(bearing["impacts"].as_u64() > Some(0), "{bearing}");
            let stopped = &bearing["stopped"];
            assert_eq!(stopped["cause"], "interrupted", "{bearing}");
            assert_eq!(stopped["time_s"], bearing["simulated_s"]);
            assert!(stopped["advice"].as_str().unwrap().contains("its end at"));
            assert_eq!(bearing["verdict"], "not-judged");
        }
        assert_eq!(
            (&json["verdict"], &json["passes"]),
            (&"not-judged".into(), &serde_json::Value::Null)
        );
        let headline = json["headline"].as_str().unwrap();
        assert!(headline.contains("interrupted after"), "{headline}");
    }
}

/// Names of all values of a document, and of elements of lists, but of cases.
fn places(value: &serde_json::Value, at: &str, found: &mut BTreeSet<String>) {
    match value {
        serde_json::Value::Object(map) => {
            for (key, value) in map.iter().filter(|(key, _)| *key != "case") {
                places(value, &format!("{at}.{key}"), found);
            }
        }
        serde_json::Value::Array(list) if list.iter().any(serde_json::Value::is_object) => {
            (list.iter()).for_each(|value| places(value, &format!("{at}[]"), found));
        }
        _ => drop(found.insert(at.to_owned())),
    }
}

/// What belongs to the rotor of a rotor file alone has no value in a case; every other result has one place.
#[test]
fn a_case_and_a_rotor_file_have_results_of_one_shape() {
    let case = bearing("touchdown-d.toml", &["solver.duration_s=0.0015"]);
    let own = std::slice::from_ref(&case);
    let rotor = BearingArrangement::new("", &rigid(&[0.0]), 30000.0, 0.0, own);
    let several = two_bearings(&["solver.duration_s=0.0015"]);
    let request = DropRequest {
        compare: true,
        samples: Some(2),
        verify: true,
        drops: None,
    };
    let [of_case, of_one, of_several] =
        [case.into(), rotor.unwrap(), several].map(|file: BearingArrangement| {
            let mut found = BTreeSet::new();
            let json = studied(&file, request).to_json(&file).unwrap();
            places(&serde_json::from_str(&json).unwrap(), "", &mut found);
            found
        });
    assert_eq!(of_case, of_one);
    assert_eq!(of_one, of_several);
}

/// The shoulder that meets its face first carries all of a vertical rotor, and one that does as the
/// support yields; a free bearing carries nothing.
#[test]
fn a_free_bearing_has_no_weight_of_a_vertical_rotor() {
    let path = Path::new(CASES).join("rotors/vertical.toml");
    let file = BearingArrangement::read(&path, &["solver.duration_s=0.0001".to_owned()]).unwrap();
    let drop = file.drop().unwrap();
    let gravity_m_s2 = drop.cases()[0].operation.gravity_m_s2;
    let weight_n = drop.rotor().unwrap().mass_kg * gravity_m_s2;
    assert_eq!(drop.carried_n(), [Some(weight_n), None]);
    // 392 N on 2e7 N/m: 19.6 µm.
    let clearance = |um: f64| {
        let set = format!("bearing.2.rotor.axial_clearance_um={um:?}");
        let own = ["bearing.1.rotor.axial_clearance_um=400".to_owned(), set];
        let file = BearingArrangement::read(&path, &own).unwrap();
        file.drop().unwrap().carried_n()
    };
    assert_eq!(clearance(419.0), [Some(weight_n), Some(weight_n)]);
    assert_eq!(clearance(420.0), [Some(weight_n), None]);
    assert_eq!(clearance(300.0), [None, Some(weight_n)]);
    let found = studied(&file, DropRequest::default());
    let weights = |k: usize| {
        let results = &found.record.bearings[k].result.results;
        results.value("rotor_force_max_over_weight")
    };
    assert!(weights(0).is_some() && weights(1).is_none());
    assert_eq!(found.warnings, Vec::<String>::new());
}

/// The results of a rotor on several bearings are no case, and say what to give.
#[test]
fn results_of_a_rotor_are_no_case() {
    let file = two_bearings(&["solver.duration_s=0.0001"]);
    let found = studied(&file, DropRequest::default());
    let json = found.to_json(&file).unwrap();
    let error = CaseFile::parse(&json, "summary.json", &[]).unwrap_err();
    let message = error.to_string();
    assert!(message.contains("give the rotor file"), "{message}");
}

#[test]
fn the_first_contacts_of_all_bearings_are_converged() {
    let request = DropRequest {
        verify: true,
        ..DropRequest::default()
    };
    let file = two_bearings(&["solver.duration_s=0.0012"]);
    let found = studied(&file, request);
    let verification = found.verification.unwrap();
    let bearings = verification.parts("bearings");
    assert_eq!(bearings.len(), 2);
    let residuals = verification.values("rotor_energy_residual_relative");
    let (full, half) = (residuals[0], residuals[1]);
    assert!(
        half.abs() < full.abs() && full.abs() < 1e-5,
        "{full:e} {half:e}"
    );
    let of_drop = found.record.bearings.iter();
    for (of_bearing, record) in bearings.iter().zip(of_drop) {
        assert_eq!(
            of_bearing.get("end_states"),
            of_bearing.get("half_step_end_states")
        );
        for name in ["housing_force_max_n", "impacts", "ring_speed_rpm"] {
            let judgement = judged(of_bearing, name);
            assert_eq!(
                judgement.number("value"),
                record.result.results.number(name)
            );
            assert_eq!(judgement.text("verdict"), "converged", "{name}");
        }
    }
    // Too long a step shows in both.
    let coarse = two_bearings(&["solver.duration_s=0.0012", "solver.step_us=2.5"]);
    assert_eq!(
        coarse.drop().unwrap().cases()[0].solver.method,
        IntegrationMethod::VelocityVerlet
    );
    let coarse = studied(&coarse, request).verification.unwrap();
    for (coarse, fine) in coarse.parts("bearings").iter().zip(bearings) {
        let change = |v| judged(v, "rotor_friction_j").number("step_change");
        assert!(change(coarse).abs() > change(fine).abs());
    }
}

#[test]
fn a_rotor_is_judged_by_its_bearings_and_its_planes() {
    let changes = ["solver.duration_s=0.002"];
    let cases = ["touchdown-d.toml", "touchdown-conventional.toml"].map(|n| bearing(n, &changes));
    let plane = |name: &str, axial_mm: f64, radial_um: f64| RotorClearance {
        name: name.to_owned(),
        place: RotorPlace::AxialMm(axial_mm),
        radial_um,
    };
    let rotor = RotorDescription {
        clearances: vec![plane("seal", 150.0, 150.0), plane("impeller", 250.0, 900.0)],
        ..rigid(&[-100.0, 200.0])
    };
    let file = BearingArrangement::new("", &rotor, 30000.0, 0.0, &cases).unwrap();
    // What is written reads the same.
    let text = file.to_toml().unwrap();
    let again = BearingArrangement::parse(&text, "again", Path::new(""), &[]).unwrap();
    assert_eq!(again.rotor_file().unwrap().rotor, rotor);
    let found = studied(&file, DropRequest::default());
    let judgement = found.record.judgement();
    assert_eq!(judgement.passes(), Some(false));
    assert_eq!(judgement.reasons().len(), 1, "{judgement:?}");
    assert!(
        judgement.reasons()[0].starts_with("seal displaced by"),
        "{judgement:?}"
    );
    let json: serde_json::Value = serde_json::from_str(&found.to_json(&file).unwrap()).unwrap();
    assert_eq!(
        (&json["verdict"], &json["passes"]),
        (&"fail".into(), &false.into())
    );
    let of = |k: usize, key: &str| json["clearances"][k][key].as_f64().unwrap();
    assert_eq!(json["clearances"][1]["name"], "impeller");
    for (k, limit) in [150.0, 900.0].into_iter().enumerate() {
        assert_eq!(of(k, "clearance_um"), limit);
        assert!((of(k, "margin_um") + of(k, "displacement_max_um") - limit).abs() < 1e-9);
    }
    assert!(of(0, "margin_um") < 0.0 && of(1, "margin_um") > 0.0);
}

#[test]
fn a_bearing_without_load_is_warned_of_and_has_no_weights() {
    let changes = ["solver.duration_s=0.002"];
    let cases = ["touchdown-d.toml", "touchdown-conventional.toml"].map(|n| bearing(n, &changes));
    let of = |places: &[f64]| {
        let file = BearingArrangement::new("", &rigid(places), 30000.0, 0.0, &cases).unwrap();
        studied(&file, DropRequest::default())
    };
    let found = of(&[0.0, 200.0]);
    let warning = "bearing 2: it carries nothing of the rotor";
    assert!(
        found.warnings.iter().any(|w| w.starts_with(warning)),
        "{:?}",
        found.warnings
    );
    let weights = |k: usize| {
        found.record.bearings[k]
            .result
            .results
            .value("rotor_force_max_over_weight")
    };
    assert!(weights(0).is_some() && weights(1).is_none());
    let found = of(&[100.0, 300.0]);
    let warning = "bearing 2: the rotor pulls it upwards, with 20 kg";
    assert!(
        found.warnings.iter().any(|w| w.starts_with(warning)),
        "{:?}",
        found.warnings
    );
}
