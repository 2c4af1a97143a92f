//! Drops one after the other, with the heat of those before.

use std::path::{Path, PathBuf};

use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseFile;
use cageless_results::Record;
use cageless_study::Silent;
use cageless_study::drop::{DropRequest, DropStudy, study};

fn file(name: &str, sets: &[&str]) -> BearingArrangement {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../cases")
        .join(name);
    let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
    BearingArrangement::read(&path, &sets).unwrap()
}

fn dropped(file: &BearingArrangement, drops: u64) -> DropStudy {
    let request = DropRequest {
        drops: Some(drops),
        ..DropRequest::default()
    };
    let drop = request.check(file, "case").unwrap();
    let rows = drop.cases().iter().map(|_| None).collect();
    study(file, drop, request, rows, &Silent).unwrap()
}

fn close(found: f64, expected: f64, what: &str) {
    let error = (found - expected).abs();
    assert!(
        error < 1e-9 * expected.abs().max(1.0),
        "{what}: {found} for {expected}"
    );
}

/// A rotor that brings the ring up to speed at once, and is braked.
const BRAKED: [&str; 4] = [
    "solver.duration_s=0.05",
    "rotor.drive_torque_n_m=-4.0",
    "rotor.speed_rpm=3000",
    "bearing.inner_ring_polar_inertia_kg_m2=5e-6",
];

/// ½ μ P d of SKF: μ = 0.0015, 20 kg, a bore of 30 mm.
const ROLLING_N_M: f64 = 0.5 * 0.0015 * (20.0 * 9.81) * 30e-3;

fn number(row: &Record, name: &str) -> f64 {
    let value = row.value(name);
    value.unwrap_or_else(|| panic!("{name}"))
}

/// Every drop begins with the temperatures at the standstill after the one before, and with the
/// clearances of free rings and balls of these temperatures.
#[test]
fn drops_in_succession_keep_their_heat() {
    let done = dropped(&file("touchdown-d.toml", &BRAKED), 3);
    let rows = &done.succession.records;
    assert_eq!(rows.len(), 3, "{:?}", done.warnings);
    let headline = done.judgement.headline();
    assert!(!headline.contains("softens"), "{headline}");
    let per_k = 12.5e-6;
    for pair in rows.windows(2) {
        for part in ["inner_ring", "ball", "outer_ring"] {
            let [before, after] = [(&pair[0], "standstill"), (&pair[1], "start")]
                .map(|(row, when)| number(row, &format!("{part}_{when}_c")));
            close(after, before, part);
            assert!(after > 20.0, "{part}: {after}");
        }
    }
    for row in rows {
        let warm = |part: &str| per_k * (number(row, &format!("{part}_start_c")) - 20.0);
        let [inner, ball, outer] = ["inner_ring", "ball", "outer_ring"].map(warm);
        let gr_um = 2.0 * (27_765.0 * outer - 18_240.0 * inner - 2.0 * 4_762.5 * ball);
        close(number(row, "radial_internal_clearance_um"), gr_um, "Gr");
        let gap_um = 200.0 + 15_000.0 * inner;
        close(number(row, "touchdown_clearance_um"), gap_um, "clearance");
    }

    // The first drop spins down by itself: ½ I Ω² less what the drive takes. Its balls still slide, and
    // brake more than ½ μ P d of SKF, 4.4 N·mm.
    let results = &done.record.bearings[0].result.results;
    let speed = results.number("rotor_speed_rpm") * std::f64::consts::PI / 30.0;
    let contacts = results.number("braking_torque_n_m");
    assert!(contacts > ROLLING_N_M, "{contacts}");
    close(
        number(&rows[0], "spin_down_s"),
        0.02 * speed / (contacts + 4.0),
        "spin-down",
    );
    let heat_j = 0.5 * 0.02 * speed * speed * contacts / (contacts + 4.0);
    close(number(&rows[0], "spin_down_heat_j"), heat_j, "heat");
    let share = results.number("ball_power_w") / results.number("end_power_w");
    let balls_kg = 14.0 * 4.0 / 3.0 * std::f64::consts::PI * 4.7625e-3f64.powi(3) * 7850.0;
    let ball_c = results.number("ball_temperature_c") + share * heat_j / (balls_kg * 460.0);
    close(number(&rows[0], "ball_standstill_c"), ball_c, "balls");
}

/// In the pause the bearing cools with its time constant towards the temperatures before the first
/// drop.
#[test]
fn a_bearing_cools_between_drops() {
    let sets = [
        "thermal.pause_s=100",
        "thermal.cooling_time_s=200",
        "fit.inner_ring_temperature_c=50",
        "fit.outer_ring_temperature_c=40",
    ];
    let done = dropped(&file("touchdown-d.toml", &[&BRAKED[..], &sets].concat()), 2);
    let rows = &done.succession.records;
    for (part, before_c) in [("inner_ring", 50.0), ("ball", 45.0), ("outer_ring", 40.0)] {
        let warm_c = number(&rows[0], &format!("{part}_standstill_c"));
        let expected = before_c + (warm_c - before_c) * (-0.5f64).exp();
        close(number(&rows[0], &format!("{part}_start_c")), before_c, part);
        close(number(&rows[1], &format!("{part}_start_c")), expected, part);
    }
}

/// A rotor in two bearings spins down once, and heats each bearing by its share; each bearing has its
/// own temperatures in the next drop.
#[test]
fn a_rotor_in_two_bearings_heats_both() {
    let sets = [
        "solver.duration_s=0.2",
        "rotor.drive_torque_n_m=-2",
        "rotor.speed_rpm=1000",
        "contact.friction_coefficient=0.01",
        "bearing.inner_ring_polar_inertia_kg_m2=5e-6",
    ];
    let rotor = file("rotors/two-bearings.toml", &sets);
    let done = dropped(&rotor, 2);
    let rows = &done.succession.records;
    assert_eq!(rows.len(), 4, "{:?}", done.warnings);
    assert_eq!(
        number(&rows[0], "spin_down_s"),
        number(&rows[1], "spin_down_s")
    );
    // The table has a row of both bearings after each drop, with the heat of both.
    let table = done.succession.table();
    let heat = table[0]
        .iter()
        .position(|head| head == "heat of the spin-down (J)")
        .unwrap();
    let of: Vec<&str> = table.iter().map(|row| row[1].as_str()).collect();
    assert_eq!(of, ["bearing", "1", "2", "all", "1", "2", "all"]);
    let sum: f64 = rows[2..]
        .iter()
        .map(|row| number(row, "spin_down_heat_j"))
        .sum();
    let shown: f64 = table[6][heat].parse().unwrap();
    assert!((shown / sum - 1.0).abs() < 1e-3, "{shown} {sum}");
    // The first drop that fails is named for a plane, too, that no row is about.
    let cases = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");
    let text = std::fs::read_to_string(Path::new(cases).join("rotors/two-bearings.toml")).unwrap();
    let seal = "\n[[clearance]]\nname = \"seal\"\naxial_mm = 0.0\nradial_um = 1.0\n";
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("rotor.toml");
    std::fs::write(&path, text.replace("../", &format!("{cases}/")) + seal).unwrap();
    let short = sets.map(|set| set.replace("duration_s=0.2", "duration_s=0.02"));
    let sealed = dropped(&BearingArrangement::read(&path, &short).unwrap(), 2);
    let (drop, reasons) = sealed.succession.first("fail").unwrap();
    assert!(
        drop == 1 && reasons.contains("seal displaced by"),
        "{reasons}"
    );
    let parts = ["inner_ring", "ball", "outer_ring"];
    // Each bearing brakes by its own losses, or by the rolling friction of the part that it carries.
    let brakes = [80.0 / 3.0, 40.0 / 3.0].iter().zip(&done.record.bearings);
    let brakes = brakes.map(|(share_kg, bearing)| {
        let own = bearing.result.results.number("braking_torque_n_m");
        let rolling = ROLLING_N_M * share_kg / 20.0;
        assert!((own / rolling - 1.0).abs() < 1e-9, "{own} {rolling}");
        (own, rolling)
    });
    let brakes: Vec<(f64, f64)> = brakes.collect();
    let contacts: f64 = brakes.iter().map(|(_, rolling)| rolling).sum();
    let results = |k: usize| &done.record.bearings[k].result.results;
    let speed = results(0).number("rotor_speed_rpm") * std::f64::consts::PI / 30.0;
    let energy_j = 0.5 * done.drop.rotor().unwrap().polar_inertia_kg_m2 * speed * speed;
    for (k, (_, rolling)) in brakes.into_iter().enumerate() {
        let (case, results) = (&done.drop.cases()[k], results(k));
        let thermal = &rotor.cases()[k].particulars().thermal;
        let capacities = thermal.capacities_j_k(&case.bearing, 1).unwrap();
        let mut warmed_j = 0.0;
        let mut power_w = 0.0;
        for (part, capacity) in parts.iter().zip(capacities) {
            let rise_k = number(&rows[k], &format!("{part}_standstill_c"))
                - results.number(&format!("{part}_temperature_c"));
            warmed_j += capacity * rise_k;
            power_w += results.number(&format!("{part}_power_w"));
            let start_c = number(&rows[2 + k], &format!("{part}_start_c"));
            close(
                start_c,
                number(&rows[k], &format!("{part}_standstill_c")),
                part,
            );
        }
        let heat_j = energy_j * rolling / (contacts + 2.0);
        close(number(&rows[k], "spin_down_heat_j"), heat_j, "its own heat");
        // What rotor and supports take is no heat of the bearings; SKF's is beyond their measured torque.
        let own = results.number("end_power_w") / speed;
        let kept = own / rolling * power_w / results.number("end_power_w") + 1.0 - own / rolling;
        // The speed is that at the end, the power a mean.
        assert!(
            (warmed_j / (heat_j * kept) - 1.0).abs() < 1e-4,
            "{warmed_j}"
        );
    }
}

/// A rotor that stands and a slow one drop again: nothing brakes them, and the heat of the spin-down is
/// their rotational energy.
#[test]
fn a_slow_rotor_has_no_torque_and_drops_again() {
    for speed_rpm in [0.0, 10.0] {
        let speed = format!("rotor.speed_rpm={speed_rpm}");
        let sets = ["solver.duration_s=0.02", &speed];
        let done = dropped(&file("touchdown-conventional.toml", &sets), 2);
        let rows = &done.succession.records;
        assert_eq!(rows.len(), 2, "{:?}", done.warnings);
        let results = &done.record.bearings[0].result.results;
        assert_eq!(results.value("braking_torque_n_m"), None);
        assert!(results.number("end_power_w") > 0.0);
        assert_eq!(number(&rows[0], "spin_down_s"), 0.0);
        let speed_rad_s = results.number("rotor_speed_rpm") * std::f64::consts::PI / 30.0;
        let energy_j = 0.5 * 0.02 * speed_rad_s * speed_rad_s;
        close(number(&rows[0], "spin_down_heat_j"), energy_j, "heat");
        let first_contact = results.value("first_contact_ms");
        if speed_rpm == 0.0 {
            assert_eq!(results.value("spin_up_ms"), first_contact, "nothing slides");
        }
    }
}

/// The verdict is that on all drops that were asked for.
#[test]
fn a_later_drop_beyond_a_limit_fails() {
    let limit = |path: &str, most_c: f64| {
        let text = std::fs::read_to_string(path).unwrap();
        let limit = "\n[[limit]]\nresult = \"ball_standstill_c\"\nsource = \"the plant\"\nvalue = ";
        let text = format!("{text}{limit}{most_c:?}\n");
        let sets = [&BRAKED[..], &["rotor.speed_rpm=600"]].concat();
        let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
        BearingArrangement::from(CaseFile::parse(&text, "case.toml", &sets).unwrap())
    };
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/touchdown-d.toml");
    let free = dropped(&limit(path, 1e3), 3);
    let of = |k: usize| number(&free.succession.records[k], "ball_standstill_c");
    assert_eq!(free.judgement.passes(), Some(true));
    let headline = free.judgement.headline();
    assert!(
        headline.ends_with("all 3 drops within these limits"),
        "{headline}"
    );
    let limited = limit(path, 0.5 * (of(0) + of(1)));
    let found = dropped(&limited, 3);
    let json: serde_json::Value = serde_json::from_str(&found.to_json(&limited).unwrap()).unwrap();
    assert_eq!(
        (&json["verdict"], &json["passes"]),
        (&"fail".into(), &false.into())
    );
    let reasons = json["reasons"].as_array().unwrap();
    assert_eq!(reasons.len(), 1, "{json}");
    let reason = reasons[0].as_str().unwrap();
    assert!(
        reason.starts_with("drop 2: balls at standstill"),
        "{reason}"
    );
    assert_eq!(found.succession.records[0].text("verdict"), "pass");
    assert_eq!(dropped(&limited, 1).judgement.passes(), Some(true));
    // A rotor that is driven on never drops again.
    let driven = ["rotor.speed_rpm=600", "rotor.drive_torque_n_m=4"];
    let sets = [&BRAKED[..], &driven].concat();
    let judgement = dropped(&file("touchdown-d.toml", &sets), 2).judgement;
    assert_eq!(judgement.passes(), None, "{judgement:?}");
}

/// Where the heat leaves no clearance, or a part is as hot as softens steel, the drop fails and the drops
/// end with what there is.
#[test]
fn a_bearing_without_clearance_for_another_drop_fails() {
    let heavy = [
        "rotor.polar_inertia_kg_m2=2000",
        "rotor.drive_torque_n_m=0",
        "rotor.speed_rpm=600",
    ];
    let stopped = |sets: &[&str]| {
        let sets = [&BRAKED[..], &heavy, sets].concat();
        dropped(&file("touchdown-d.toml", &sets), 3)
    };
    let done = stopped(&[]);
    let rows = &done.succession.records;
    assert_eq!(rows.len(), 1, "{:?}", done.warnings);
    let reasons = done.judgement.reasons().join("\n");
    for said in [
        "balls at",
        "at standstill with all heat kept, above the 200 °C at which the steel softens",
        "thermal runaway, drop 2 is not possible at the temperatures after drop 1: fit.inner_ring_temperature_c",
    ] {
        assert!(reasons.contains(said), "{reasons}");
    }
    assert_eq!(done.judgement.passes(), Some(false));
    assert_eq!(rows[0].text("verdict"), "fail");
    // Silicon nitride does not soften.
    let hybrid = stopped(&["ball_material.preset=\"Si3N4\""]);
    let reasons = hybrid.judgement.reasons().join("\n");
    assert!(!reasons.contains("balls at"), "{reasons}");
}

/// Without a torque that stays there are no temperatures at standstill, and no further drop, but the
/// reason.
#[test]
fn a_ring_that_slides_at_the_end_has_no_spin_down() {
    let without = |sets: &[&str], drops: u64| {
        let sets = [&BRAKED[..], sets].concat();
        let done = dropped(&file("touchdown-d.toml", &sets), drops);
        let row = &done.succession.records[0];
        for name in ["spin_down_s", "spin_down_heat_j", "ball_standstill_c"] {
            assert_eq!(row.value(name), None, "{name}");
        }
        (done.warnings.join("\n"), done)
    };
    let (said, done) = without(&["rotor.speed_rpm=30000"], 3);
    assert!(said.contains("has not come up to speed"), "{said}");
    assert_ne!(done.judgement.passes(), Some(true));
    let spin_up = dropped(&file("touchdown-d.toml", &BRAKED), 1);
    let spin_up_ms = spin_up.record.bearings[0]
        .result
        .results
        .number("spin_up_ms");
    let just_after = format!("solver.duration_s={}", 1e-3 * (spin_up_ms + 0.1));
    let (said, _) = without(&[&just_after], 1);
    assert!(said.contains("within the last fifth"), "{said}");
}

/// Balls of a material by name have its specific heat and expansion; of any other material all numbers that
/// are needed are asked for in one message, before anything is computed.
#[test]
fn drops_in_succession_ask_for_all_numbers_of_a_material() {
    let hybrid = "ball_material.preset=\"Si3N4\"";
    let warm = file("touchdown-d.toml", &[&BRAKED[..], &[hybrid]].concat());
    let done = dropped(&warm, 2);
    assert_eq!(done.succession.records.len(), 2, "{:?}", done.warnings);
    let capacities = &warm.cases()[0].particulars().thermal;
    assert_eq!(capacities.ball_specific_heat_j_kg_k, Some(800.0));

    let refused = |name: &str, sets: &[&str], drops: u64| {
        let request = DropRequest {
            drops: Some(drops),
            ..DropRequest::default()
        };
        let error = request.check(&file(name, sets), "case.toml").err();
        error.map(|error| error.to_string())
    };
    let numbers = [
        "ball_material.density_kg_m3=3200",
        "ball_material.youngs_modulus_gpa=310",
        "ball_material.poisson_ratio=0.27",
    ];
    let said = refused("touchdown-d.toml", &numbers, 2).unwrap();
    for key in [
        "thermal.ball_specific_heat_j_kg_k",
        "fit.ball_expansion_per_k",
    ] {
        assert!(said.contains(key) && !said.contains("ring_"), "{said}");
    }
    let said = refused("touchdown-d.toml", &numbers, 1).unwrap();
    assert!(!said.contains("fit."), "{said}");
    let of_one = numbers.map(|set| format!("bearing.2.{set}"));
    let of_one: Vec<&str> = of_one.iter().map(String::as_str).collect();
    let said = refused("rotors/two-bearings.toml", &of_one, 2).unwrap();
    assert!(
        said.contains("bearing.2.thermal.ball") && !said.contains("bearing.1"),
        "{said}"
    );
    let given = [
        "thermal.ball_specific_heat_j_kg_k=700",
        "fit.ball_expansion_per_k=3e-6",
    ];
    let sets = [&numbers[..], &given].concat();
    assert_eq!(refused("touchdown-d.toml", &sets, 2), None);
}
