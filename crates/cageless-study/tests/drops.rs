//! Studies of drops: as a sweep has them, verified, scattered, refused.

use std::path::Path;

use cageless::Snapshot;
use cageless::collision::Collision;
use cageless::rating::BasicRatings;
use cageless::simulation::{
    Cause, Control, Ending, ObserverError, RunOutcome, Stop, run as run_case,
};
use cageless::touchdown::{DropRecorder, DropSummary};
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseFile;
use cageless_io::plan_file::PlanFile;
use cageless_results::Cell;
use cageless_results::DropResult;
use cageless_results::Record;
use cageless_results::Results;
use cageless_study::drop::{DropRequest, DropStudy, foreseen, study};
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
    let found = studied(&file, DropRequest::default());
    let drop = &found.record.bearings[0];
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

/// The study of the drop of a file.
pub fn studied<F: Clone + Into<BearingArrangement>>(file: &F, request: DropRequest) -> DropStudy {
    let file = file.clone().into();
    let drop = request.check(&file, "file").unwrap();
    let rows = drop.cases().iter().map(|_| None).collect();
    study(&file, drop, request, rows, &Silent).unwrap()
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
         [grid]\nrotor.friction_coefficient = [0.1, 0.2]\nrotor.radial_clearance_um = [200.0, 1000.0]\n"
    );
    let plan = PlanFile::parse(&plan, "plan.toml", Path::new("")).unwrap();
    let sweep = Sweep::new(plan).unwrap();
    let rows = sweep
        .evaluate(0..4, &|| std::ops::ControlFlow::Continue(()))
        .unwrap();
    for (row, mu, gap) in [(0, 0.1, 200.0), (1, 0.2, 200.0), (2, 0.1, 1000.0)] {
        let one = drop(&[
            &format!("rotor.friction_coefficient={mu}"),
            &format!("rotor.radial_clearance_um={gap:?}"),
        ]);
        let alone = studied(&one, DropRequest::default());
        let results = alone.record.bearings[0].result.results.iter();
        for (quantity, value) in results.filter(|(quantity, _)| quantity.in_sweeps) {
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
        .check(&case.into(), "zhao-d.toml")
        .unwrap_err();
    let plan = format!("schema = 1\ncase = \"{CASES}/zhao-d.toml\"\ncompute = [\"drop\"]\n");
    let of_plan = PlanFile::parse(&plan, "plan.toml", Path::new("")).unwrap_err();
    assert_eq!(of_plan.line(), Some(3));
    for message in [refused.to_string(), of_plan.to_string()] {
        for key in [
            "[rotor]",
            "mass_kg",
            "speed_rpm",
            "radial_clearance_um",
            "inner_ring_bore_radius_mm",
        ] {
            assert!(message.contains(key), "{message}");
        }
        assert!(!message.contains("rotor_mass_kg"), "{message}");
    }
}

/// The judgement of a result by the verification of a bearing.
pub fn judged<'v>(verification: &'v Record, name: &str) -> &'v Record {
    let mut numbers = verification.parts("numbers").iter();
    numbers.find(|n| n.text("name") == name).unwrap()
}

#[test]
fn the_first_milliseconds_of_a_drop_are_converged() {
    let request = DropRequest {
        verify: true,
        ..DropRequest::default()
    };
    let file = drop(&["solver.duration_s=0.007"]);
    let found = studied(&file, request);
    let verification = found.verification.unwrap();
    let [verification] = verification.parts("bearings") else {
        panic!("one bearing")
    };
    assert_eq!(
        verification.get("end_states"),
        verification.get("half_step_end_states")
    );
    let verdict = |name: &str| judged(verification, name).text("verdict").to_owned();
    for name in [
        "first_contact_ms",
        "rotor_force_max_n",
        "impacts",
        "ring_speed_rpm",
    ] {
        assert_eq!(verdict(name), "converged", "{name}");
    }
    // Too long a step shows.
    let file = drop(&["solver.duration_s=0.007", "solver.step_us=2.7"]);
    let coarse = studied(&file, request);
    let coarse = coarse.verification.unwrap();
    let coarse = &coarse.parts("bearings")[0];
    let change = |v: &Record, name: &str| {
        let j = judged(v, name);
        j.number("step_change") / j.number("value").abs()
    };
    // The error grows with the square of the step.
    for name in ["rotor_friction_j", "dissipated_j", "ring_speed_rpm"] {
        let (at_step, at_long_step) = (change(verification, name), change(coarse, name));
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
            studied(&drop(&["solver.duration_s=0.0075"]), request)
        });
        done.unwrap().ensemble.unwrap()
    };
    let one = drops(1);
    assert_eq!(one.completed, 11);
    assert_eq!(one, drops(2));
}

/// The draws of a scattered drop, entered in the case, give its results under every law of friction.
#[test]
fn a_scattered_drop_can_be_repeated() {
    let table = "[[0.0,0.25],[0.2,0.2],[2.0,0.12]]";
    let of_table = ["rotor", "contact"].map(|section| format!("{section}.friction_table={table}"));
    let laws: [(&str, Vec<String>); 3] = [
        ("smooth", vec![]),
        (
            "stribeck",
            ["rotor", "contact"]
                .iter()
                .flat_map(|section| {
                    [
                        format!("{section}.static_friction_coefficient=0.3"),
                        format!("{section}.stribeck_speed_m_s=0.5"),
                    ]
                })
                .collect(),
        ),
        ("table", of_table.to_vec()),
    ];
    for (law, given) in laws {
        let mut common = vec![
            format!("rotor.friction_law={law}"),
            format!("contact.friction_law={law}"),
        ];
        if law == "table" {
            // The coefficient is the last of the table.
            common.extend(["rotor", "contact"].map(|s| format!("{s}.friction_coefficient=0.12")));
        }
        // The automatic step is that of the case before it is scattered.
        let short = [
            "solver.duration_s=0.0075",
            "solver.step_us=0.5",
            "rotor.eccentricity_um=5",
        ];
        common.extend(short.map(str::to_owned));
        repeats(law, &common, &given);
    }
}

/// Scattered drop 2 of a case with the keys that are `common` to it and its repetition.
fn repeats(law: &str, common: &[String], given: &[String]) {
    let request = DropRequest {
        samples: Some(2),
        ..DropRequest::default()
    };
    let all: Vec<&str> = common.iter().chain(given).map(String::as_str).collect();
    let ensemble = studied(&drop(&all), request).ensemble.unwrap();
    let row = serde_json::to_value(&ensemble.drops[1]).unwrap();
    let of = |name: &str| row.get(name).unwrap_or(&row["bearings"][0][name]).clone();
    assert_eq!(of("drop"), 2);
    let changes = [
        ("rotor.friction_coefficient", of("rotor_friction")),
        ("contact.friction_coefficient", of("ball_friction")),
        ("rotor.radial_clearance_um", of("radial_clearance_um")),
        ("support.damping_n_s_m", of("support_damping_n_s_m")),
        ("rotor.eccentricity_phase_deg", of("eccentricity_phase_deg")),
        ("rotor.x_um", of("x_um")),
        ("rotor.y_um", of("y_um")),
        ("start.lead_ball_angle_deg", of("lead_ball_angle_deg")),
        ("start.gaps", of("gaps_deg")),
        (
            "rotor.static_friction_coefficient",
            of("rotor_static_friction"),
        ),
        (
            "contact.static_friction_coefficient",
            of("ball_static_friction"),
        ),
        ("rotor.friction_table", of("rotor_friction_table")),
        ("contact.friction_table", of("ball_friction_table")),
        ("rotor.stribeck_speed_m_s", 0.5.into()),
        ("contact.stribeck_speed_m_s", 0.5.into()),
    ];
    let used = changes.iter().filter(|(key, value)| {
        let of_law = law == "stribeck" || !key.ends_with("stribeck_speed_m_s");
        !value.is_null() && of_law
    });
    let changes: Vec<String> = used.map(|(key, v)| format!("{key}={v}")).collect();
    let all: Vec<&str> = common.iter().chain(&changes).map(String::as_str).collect();
    let again = studied(&drop(&all), DropRequest::default());
    for name in ["rotor_force_max_n", "first_contact_ms", "end_power_w"] {
        let [found, expected] = [
            &again.record.bearings[0].result,
            &ensemble.drops[1].bearings[0].result,
        ]
        .map(|result| result.results.number(name));
        assert!(
            (found / expected - 1.0).abs() < 1e-9,
            "{law}: {name}: {found} {expected}"
        );
    }
}

fn texts(study: &DropStudy, file: &CaseFile) -> serde_json::Value {
    serde_json::from_str(&study.to_json(&file.clone().into()).unwrap()).unwrap()
}

#[test]
fn a_drop_is_warned_of_and_judged_as_a_run_is() {
    let request = DropRequest {
        samples: Some(2),
        ..DropRequest::default()
    };
    let file = drop(&["solver.duration_s=0.15", "output.interval_us=1000"]);
    let found = studied(&file, request);
    let result = &found.record.bearings[0].result;
    let pressure_mpa = result.results.number("ball_pressure_max_mpa");
    assert!(pressure_mpa > 4200.0);
    // Once: in the verdict.
    let text = format!("contact pressure between balls {pressure_mpa:.0} MPa, above 4200 MPa");
    let headline = found.judgement.headline();
    assert!(headline.contains(&text), "{headline}");
    assert!(
        !found
            .warnings
            .iter()
            .any(|w| w.contains(&format!("{pressure_mpa:.0} MPa")))
    );
    // The worst of the scattered drops, by its number.
    let rows = &found.ensemble.as_ref().unwrap().drops;
    let of = |k: usize| {
        rows[k].bearings[0]
            .result
            .results
            .number("ball_pressure_max_mpa")
    };
    let (number, worst) = if of(0) > of(1) {
        (1, of(0))
    } else {
        (2, of(1))
    };
    let text = format!(
        "in scattered drop {number}, the worst: the contact pressure between balls reaches {:.0} MPa",
        worst
    );
    assert!(
        found.warnings.iter().any(|w| w.contains(&text)),
        "{:?}",
        found.warnings
    );
    // Nothing of continuous running.
    for word in ["n·Dpw", "continuous", "70 °C"] {
        assert!(
            !found.warnings.iter().any(|w| w.contains(word)),
            "{:?}",
            found.warnings
        );
    }
    assert_eq!(result.judgement.passes(), Some(false));
    let reason =
        format!("contact pressure between balls {pressure_mpa:.0} MPa, above 4200 MPa (ISO 76)");
    let json = texts(&found, &file);
    assert_eq!(
        (&json["verdict"], &json["passes"]),
        (&"fail".into(), &false.into())
    );
    let reasons = json["reasons"].as_array().unwrap();
    assert!(reasons.contains(&reason.clone().into()), "{reasons:?}");
    let headline = json["headline"].as_str().unwrap();
    assert!(
        headline.starts_with("FAIL: ") && headline.contains(&reason),
        "{headline}"
    );
}

/// A slow rotor whose ring comes up to speed before the balls collide.
const PASSES: [&str; 3] = [
    "solver.duration_s=0.06",
    "rotor.speed_rpm=600",
    "output.interval_us=1000",
];

#[test]
fn a_drop_passes_within_its_clearance_and_fails_beyond() {
    let of = |limit_um: f64| {
        let limit = format!("rotor.clearance_limit_um={limit_um}");
        let file = drop(&[&PASSES[..], &[limit.as_str()]].concat());
        let found = studied(&file, DropRequest::default());
        (
            found.record.bearings[0].result.clone(),
            texts(&found, &file),
        )
    };
    let (free, _) = of(1e6);
    assert_eq!(free.judgement.passes(), Some(true), "{:?}", free.judgement);
    let most = free.results.value("rotor_displacement_max_um").unwrap();
    assert!(most > 200.0 && most < 400.0, "{most}");
    let (passes, json) = of(most + 10.0);
    assert_eq!(
        (passes.judgement.passes(), &json["verdict"]),
        (Some(true), &"pass".into())
    );
    assert!((passes.results.value("clearance_margin_um").unwrap() - 10.0).abs() < 1e-9);
    assert!(
        json["headline"]
            .as_str()
            .unwrap()
            .contains("(margin 10 µm)"),
        "{}",
        json["headline"]
    );
    let (fails, json) = of(most - 10.0);
    assert_eq!(fails.judgement.passes(), Some(false));
    assert!((fails.results.value("clearance_margin_um").unwrap() + 10.0).abs() < 1e-9);
    let reason = json["reasons"][0].as_str().unwrap();
    assert!(
        reason.contains("beyond its clearance") && reason.contains("exceeded by 10 µm"),
        "{reason}"
    );
}

#[test]
fn a_rotor_in_the_air_is_not_judged() {
    let file = drop(&["solver.duration_s=0.001"]);
    let found = studied(&file, DropRequest::default());
    let json = texts(&found, &file);
    assert_eq!(
        (&json["verdict"], &json["passes"]),
        (&"not-judged".into(), &serde_json::Value::Null)
    );
    assert_eq!(
        json["reasons"][0],
        "the rotor has not touched the inner ring: simulate longer (solver.duration_s)"
    );
}

#[test]
fn a_rotor_that_its_bearing_cannot_carry_is_not_at_rest() {
    let file = drop(&["rotor.mass_kg=20000", "solver.duration_s=0.03"]);
    let found = studied(&file, DropRequest::default());
    let result = &found.record.bearings[0].result;
    assert_eq!(result.end_state(), "settling");
    assert_eq!(result.judgement.passes(), Some(false));
    let reasons = result.judgement.reasons().join("; ");
    // 196 kN on 2e7 N/m; the balls have a radius of 4.76 mm.
    assert!(
        reasons.contains("the support cannot carry the rotor: it yields by 9.81 mm"),
        "{reasons}"
    );
    assert!(
        reasons.contains("exceeds the basic static load rating C0r"),
        "{reasons}"
    );
    // A hard stop holds it.
    let stopped = drop(&[
        "rotor.mass_kg=20000",
        "solver.duration_s=0.0066",
        "support.stop_gap_um=500",
        "support.stop_stiffness_n_m=1e9",
    ]);
    let found = studied(&stopped, DropRequest::default());
    let reasons = found.record.bearings[0]
        .result
        .judgement
        .reasons()
        .join("; ");
    assert!(!reasons.contains("the support cannot carry"), "{reasons}");
}

/// Both rows of a pair carry the rotor: C0r of one is 17.5 kN or less.
#[test]
fn a_pair_carries_a_rotor_with_both_rows() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/touchdown-pair.toml");
    let reasons = |mass_kg: f64| {
        let set = [
            format!("rotor.mass_kg={mass_kg}"),
            "solver.duration_s=0.0066".to_owned(),
        ];
        let file = BearingArrangement::read(&path, &set).unwrap();
        let found = studied(&file, DropRequest::default());
        let result = &found.record.bearings[0].result;
        result.judgement.reasons().join("; ")
    };
    let file = CaseFile::read(&path, &[]).unwrap();
    let one_row_n = BasicRatings::new(&file.case().bearing).static_n;
    let carried = reasons(1.9 * one_row_n / 9.81);
    assert!(!carried.contains("basic static load rating"), "{carried}");
    let too_heavy = reasons(2.1 * one_row_n / 9.81);
    assert!(
        too_heavy.contains("basic static load rating"),
        "{too_heavy}"
    );
}

/// A drop whose energy does not balance at its end is not judged: the bearing did not fail, the computation did.
#[test]
fn a_drop_out_of_balance_is_not_judged() {
    let file = drop(&PASSES);
    let case = file.case();
    let mut recorder = DropRecorder::new();
    let mut outcome = run_case(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    let summary = recorder.summary(&outcome.state);
    let judged = |outcome: &RunOutcome| {
        DropResult::new(case, file.particulars(), &summary, outcome).judgement
    };
    assert_eq!(judged(&outcome).passes(), Some(true));
    outcome.ending = Ending::Stopped(Stop {
        time_s: 0.007,
        step_s: 1e-6,
        automatic_step_s: 1e-6,
        drop: true,
        cause: Cause::Unbalanced {
            residual_fraction: -0.0129,
        },
    });
    let found = judged(&outcome);
    assert_eq!(found.passes(), None);
    assert!(
        found.reasons()[0].contains("1.3 % of all energy flows are unaccounted for"),
        "{found:?}"
    );
}

/// A drop passes with scattered ones beside it where these show that it does.
#[test]
fn the_verdict_with_samples_is_that_on_the_sample() {
    let request = DropRequest {
        samples: Some(2),
        ..DropRequest::default()
    };
    let file = drop(&PASSES);
    let alone = studied(&file, DropRequest::default());
    assert_eq!(alone.judgement.passes(), Some(true));
    let found = studied(&file, request);
    let passing = &found.ensemble.as_ref().unwrap().passing;
    assert_eq!(found.judgement.passes(), passing.count.passes());
    assert_ne!(
        found.judgement.passes(),
        Some(true),
        "two drops show nothing"
    );
    let headline = texts(&found, &file)["headline"]
        .as_str()
        .unwrap()
        .to_owned();
    assert!(headline.contains("of 2 scattered drops pass"), "{headline}");
    assert!(headline.contains("nominal drop PASS: "), "{headline}");
}

/// What cannot be compared, and a drive that would turn the rotor backwards, are refused before anything is computed.
#[test]
fn impossible_drops_are_refused_with_what_is_allowed() {
    let refused = |name: &str, sets: &[&str], compare: bool| {
        let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
        let file = BearingArrangement::read(&Path::new(CASES).join(name), &sets).unwrap();
        let request = DropRequest {
            compare,
            ..DropRequest::default()
        };
        request
            .check(&file, name)
            .err()
            .map(|error| error.to_string())
    };
    let plain = refused("touchdown-conventional.toml", &[], true).unwrap();
    assert!(
        plain.contains("--compare conventional: the outer rings are conventional themselves"),
        "{plain}"
    );
    assert_eq!(refused("touchdown-d.toml", &[], true), None);
    let file = CaseFile::read(&Path::new(CASES).join("touchdown-d.toml"), &[]).unwrap();
    let rotor = file.case().rotor.as_ref().unwrap();
    let least = rotor.polar_inertia_kg_m2 * rotor.speed_rad_s / file.case().solver.duration_s;
    let braked = |share: f64| {
        let set = format!("rotor.drive_torque_n_m={:?}", -share * least);
        refused("touchdown-d.toml", &[&set], false)
    };
    assert_eq!(braked(0.99), None);
    let said = braked(1.01).unwrap();
    assert!(said.contains("and then turns it backwards: "), "{said}");
    assert!(
        said.contains("N·m at least within solver.duration_s = 1,"),
        "{said}"
    );
}

/// A rotor that meets the stator first is warned of.
#[test]
fn a_clearance_below_that_of_the_bearing_is_warned_of() {
    let warned = |limit_um: f64| {
        let limit = format!("rotor.clearance_limit_um={limit_um:?}");
        let warnings = foreseen(BearingArrangement::from(drop(&[&limit])).drop().unwrap());
        warnings
            .iter()
            .any(|w| w.starts_with("the rotor meets the stator before its bearing"))
    };
    assert!(warned(200.0) && !warned(201.0));
}

/// A ring that has not come up to speed: how far it came.
#[test]
fn a_spin_up_that_was_not_reached_says_so() {
    let file = drop(&["solver.duration_s=0.0002"]);
    let case = file.case();
    let mut recorder = DropRecorder::new();
    let outcome = run_case(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    let summary = DropSummary {
        first_contact_s: Some(0.0001),
        ring_speed_rad_s: 790.0,
        rotor_speed_rad_s: 830.0,
        spin_up_s: None,
        ..recorder.summary(&outcome.state)
    };
    let groups = DropResult::groups(&[&DropResult::new(
        case,
        file.particulars(),
        &summary,
        &outcome,
    )]);
    let mut rows = groups.iter().flat_map(|(_, rows)| rows);
    let (_, values, unit) = (rows.find(|row| row.0 == "spin-up of the inner ring")).unwrap();
    assert_eq!(*values, ["not reached (7544 of 7926 rpm)"]);
    assert_eq!(unit, "", "no unit behind words");
}

#[test]
fn a_run_of_a_falling_rotor_has_no_verdict_and_nothing_of_continuous_running() {
    let file = drop(&["solver.duration_s=0.06", "output.interval_us=1000"]);
    let options = Options {
        rows: None,
        verify: false,
    };
    let summary = run(&file, options, &Silent).unwrap().summary;
    assert_eq!(summary.passes(), None);
    assert!(
        summary.headline().starts_with("not judged: "),
        "{}",
        summary.headline()
    );
    for name in ["ftf_hz", "bpfo_hz", "bpfi_hz", "bsf_hz", "margin"] {
        assert_eq!(summary.results.get(name), Some(&Cell::Null), "{name}");
    }
    for (label, value, _) in summary.results.rows() {
        assert!(
            !value.contains("inf") && !value.contains("NaN"),
            "{label}: {value}"
        );
    }
    for word in ["n·Dpw", "70 °C", "inf", "NaN"] {
        assert!(
            !summary.warnings.iter().any(|w| w.contains(word)),
            "{:?}",
            summary.warnings
        );
    }
}

/// With a comparison the scattered drops go onto the plain ring as well, with the same draws.
#[test]
fn a_raceway_is_judged_by_the_same_scattered_drops() {
    let both = DropRequest {
        compare: true,
        samples: Some(3),
        ..DropRequest::default()
    };
    let alone = DropRequest {
        compare: false,
        ..both
    };
    let file = drop(&["solver.duration_s=0.02", "start.gaps=bunched"]);
    let plain = file.with_conventional_ring().unwrap();
    let found = studied(&file, both);
    let other = studied(&plain, alone).ensemble.unwrap();
    let benefit = found.benefit.as_ref().unwrap();
    let mean = |ensemble: &cageless_study::drop::Ensemble, name: &str| {
        let of = |row: &cageless_study::drop::DropRow| row.bearings[0].result.results.number(name);
        ensemble.drops.iter().map(of).sum::<f64>() / 3.0
    };
    assert_eq!(benefit.criteria.len(), 4);
    for criterion in &benefit.criteria {
        let expected = [found.ensemble.as_ref().unwrap(), &other].map(|e| mean(e, criterion.name));
        for (mean, expected) in [criterion.raceway.mean, criterion.conventional.mean]
            .iter()
            .zip(expected)
        {
            assert!((mean / expected - 1.0).abs() < 1e-12, "{}", criterion.name);
        }
    }
    let heat = &benefit.criteria[3];
    assert!(heat.raceway.mean != heat.conventional.mean);
    let json = texts(&found, &file);
    assert_eq!(
        json["benefit"]["headline"].as_str(),
        Some(&*benefit.headline)
    );
    assert!(studied(&file, alone).benefit.is_none());
}
