//! Figures of drops.

use std::f64::consts::TAU;
use std::path::Path;

use cageless_io::arrangement::BearingArrangement;
use cageless_report::drop::drop_page;
use cageless_report::figures::in_page;
use cageless_report::text::short;
use cageless_results::{Cell, DROP, Results, WindowRow};
use cageless_study::Silent;
use cageless_study::drop::{BearingRecord, DropRequest, DropStudy, study};
use serde_json::{Value, json};

use super::{CASES, Counter, drawn, list, same, traces};

fn dropped(file: &BearingArrangement, request: DropRequest) -> DropStudy {
    let drop = request.check(file, "file").unwrap();
    let rows = drop.cases().iter().map(|_| None).collect();
    study(file, drop, request, rows, &Silent).unwrap()
}

/// Gives a bearing rows, windows and results of which every number is another.
fn made_up(record: &mut BearingRecord, counter: &mut Counter) {
    let row = record.snapshots[0].clone();
    let one = |k: usize, counter: &mut Counter| {
        let mut row = row.clone();
        row.time_s = 1e-3 * k as f64;
        let rotor = row.rotor.as_mut().unwrap();
        for (field, unit) in [
            (&mut rotor.x_m, 1e-6),
            (&mut rotor.y_m, -1e-6),
            (&mut rotor.z_m, 1e-6),
            (&mut rotor.vx_m_s, 1.0),
            (&mut rotor.vy_m_s, 1.0),
            (&mut rotor.vz_m_s, 1.0),
            (&mut rotor.angle_rad, 1.0),
            (&mut rotor.speed_rad_s, 10.0),
            (&mut rotor.ring_speed_rad_s, 10.0),
            (&mut rotor.housing_x_m, 1e-6),
            (&mut rotor.housing_y_m, 1e-6),
            (&mut rotor.housing_z_m, 1e-6),
            (&mut rotor.contact_force_n, 100.0),
            (&mut rotor.contact_sliding_m_s, 1.0),
            (&mut rotor.shoulder_force_n, 100.0),
            (&mut row.ring.x_m, 1e-6),
            (&mut row.ring.y_m, 1e-6),
            (&mut row.ring.z_m, 1e-6),
            (&mut row.ring.outer_force_x_n, 100.0),
            (&mut row.ring.outer_force_y_n, 100.0),
        ] {
            *field = unit * counter.next();
        }
        row
    };
    record.snapshots = (0..4).map(|k| one(k, counter)).collect();
    let window = |k: usize, counter: &mut Counter| WindowRow {
        time_ms: 2.5 + 5.0 * k as f64,
        whirl_frequency_hz: -counter.next(),
        contact_fraction: 0.1 * (k + 2) as f64,
        force_mean_n: counter.next(),
        collisions: k as u64,
    };
    record.result.windows = (0..3).map(|k| window(k, counter)).collect();
    let values: Vec<(&str, Cell)> = (record.result.results.iter())
        .map(|(quantity, cell)| {
            let cell = match cell {
                Cell::Number(_) => Cell::Number(counter.next()),
                Cell::Numbers(list) => Cell::Numbers(counter.several(list.len())),
                other => other.clone(),
            };
            (quantity.name, cell)
        })
        .collect();
    record.result.results = Results::only(DROP, &values);
}

/// A drop onto a pair in space and onto the same without raceways, with made-up numbers.
fn made_up_drop() -> (BearingArrangement, DropStudy) {
    let sets = ["solver.duration_s=0.00005", "rotor.clearance_limit_um=431"];
    let path = Path::new(CASES).join("touchdown-pair.toml");
    let file = BearingArrangement::read(&path, &sets.map(str::to_owned)).unwrap();
    let request = DropRequest {
        compare: true,
        ..DropRequest::default()
    };
    let mut study = dropped(&file, request);
    let mut counter = Counter(1.0);
    made_up(&mut study.record.bearings[0], &mut counter);
    let other = study.conventional.as_mut().unwrap();
    made_up(&mut other.bearings[0], &mut counter);
    (file, study)
}

/// Values of the rows of a drop over their time in ms.
fn over_time(
    record: &BearingRecord,
    of: impl Fn(&cageless::RotorSnapshot, &cageless::RingSnapshot) -> f64,
) -> [Vec<f64>; 2] {
    let rows = record.snapshots.iter();
    let time_ms = rows.clone().map(|s| 1e3 * s.time_s).collect();
    [
        time_ms,
        rows.map(|s| of(&s.rotor.unwrap(), &s.ring)).collect(),
    ]
}

/// Path from a centre, µm.
fn path(
    record: &BearingRecord,
    of: impl Fn(&cageless::RotorSnapshot, &cageless::RingSnapshot) -> [f64; 2],
) -> [Vec<f64>; 2] {
    let rows = record.snapshots.iter();
    let at = |k: usize| {
        let rows = rows.clone();
        rows.map(|s| 1e6 * of(&s.rotor.unwrap(), &s.ring)[k])
            .collect()
    };
    [at(0), at(1)]
}

#[test]
fn figures_of_a_drop_draw_the_rows_that_they_name() {
    let (file, study) = made_up_drop();
    let page = drop_page(&file, &study);
    let of = |name: &str| -> Value {
        let text = in_page(&page, "drop", name).unwrap_or_else(|| panic!("{name}"));
        serde_json::from_str(text).unwrap()
    };
    let own = &study.record.bearings[0];
    let other = &study.conventional.as_ref().unwrap().bearings[0];
    let rpm = 60.0 / TAU;
    traces(
        &of("spin_up"),
        &[
            drawn("rotor", "y", over_time(own, |r, _| rpm * r.speed_rad_s)),
            drawn(
                "inner ring",
                "y",
                over_time(own, |r, _| rpm * r.ring_speed_rad_s),
            ),
        ],
        &[],
    );
    let on_ring = |record| {
        over_time(record, |r, _| {
            (r.contact_force_n.powi(2) + r.shoulder_force_n.powi(2)).sqrt()
        })
    };
    let on_housing = |record| {
        over_time(record, |_, ring| {
            (ring.outer_force_x_n.powi(2) + ring.outer_force_y_n.powi(2)).sqrt()
        })
    };
    traces(
        &of("forces"),
        &[
            drawn("rotor on the inner ring", "y", on_ring(own)),
            drawn(
                "rotor on the inner ring, conventional ring",
                "y",
                on_ring(other),
            ),
            drawn("balls on the outer ring", "y", on_housing(own)),
            drawn(
                "balls on the outer ring, conventional ring",
                "y",
                on_housing(other),
            ),
        ],
        &[],
    );
    traces(
        &of("along_axis"),
        &[
            drawn("rotor", "y", over_time(own, |r, _| 1e6 * r.z_m)),
            drawn("inner ring", "y", over_time(own, |_, ring| 1e6 * ring.z_m)),
            drawn("shoulder", "y2", over_time(own, |r, _| r.shoulder_force_n)),
        ],
        &[],
    );
    let in_bore = |record| path(record, |r, ring| [r.x_m - ring.x_m, r.y_m - ring.y_m]);
    let in_stator = |record| path(record, |r, _| [r.x_m, r.y_m]);
    let end = in_bore(own).map(|values| vec![values[3]]);
    let (orbit, displacement) = (of("orbit"), of("displacement"));
    traces(
        &orbit,
        &[
            drawn("centre of the journal", "y", in_bore(own)),
            drawn(
                "centre of the journal, conventional ring",
                "y",
                in_bore(other),
            ),
            drawn("end", "y", end),
        ],
        &["touch-down clearance"],
    );
    traces(
        &displacement,
        &[
            drawn("centre of the journal", "y", in_stator(own)),
            drawn(
                "centre of the journal, conventional ring",
                "y",
                in_stator(other),
            ),
        ],
        &["clearance to the stator"],
    );
    for (spec, name, radius_um) in [
        (&orbit, "touch-down clearance", 200.0),
        (&displacement, "clearance to the stator", 431.0),
    ] {
        let mut all = spec["data"].as_array().unwrap().iter();
        let circle = all.find(|trace| trace["name"] == name).unwrap();
        for (x, y) in list(circle, "x").iter().zip(list(circle, "y")) {
            assert!((x.hypot(y) / radius_um - 1.0).abs() < 1e-5, "{name}");
        }
    }
    let windows = |record: &BearingRecord, of: fn(&WindowRow) -> f64| -> [Vec<f64>; 2] {
        let windows = record.result.windows.iter();
        let time_ms = windows.clone().map(|w| w.time_ms).collect();
        [time_ms, windows.map(of).collect()]
    };
    traces(
        &of("whirl"),
        &[
            drawn(
                "whirl frequency",
                "y",
                windows(own, |w| w.whirl_frequency_hz),
            ),
            drawn(
                "whirl frequency, conventional ring",
                "y",
                windows(other, |w| w.whirl_frequency_hz),
            ),
            drawn(
                "contact",
                "y2",
                windows(own, |w| 100.0 * w.contact_fraction),
            ),
        ],
        &[],
    );
}

#[test]
fn figures_of_a_drop_draw_the_results_that_they_name() {
    let (file, study) = made_up_drop();
    let page = drop_page(&file, &study);
    let of = |name: &str| -> Value {
        serde_json::from_str(in_page(&page, "drop", name).unwrap()).unwrap()
    };
    let own = &study.record.bearings[0].result.results;
    let other = &study.conventional.as_ref().unwrap().bearings[0]
        .result
        .results;
    let of_balls = |results: &Results, name: &str| {
        let values = results.values(name).to_vec();
        let balls = (1..=values.len()).map(|ball| ball as f64).collect();
        [balls, values]
    };
    let (inner, outer) = ("inner_force_max_of_ball_n", "outer_force_max_of_ball_n");
    assert_eq!(own.values(inner).len(), 28);
    traces(
        &of("loads"),
        &[
            drawn("inner raceway", "y", of_balls(own, inner)),
            drawn("outer raceway", "y", of_balls(own, outer)),
            drawn(
                "inner raceway, conventional ring",
                "y",
                of_balls(other, inner),
            ),
        ],
        &[],
    );
    let [at_inner, at_outer, between] = ["inner", "outer", "ball"]
        .map(|place| short(own.number(&format!("{place}_pressure_max_mpa"))));
    let said = format!(
        "The largest pressures are {at_inner} MPa at the inner and {at_outer} MPa at the outer raceway and \
         {between} MPa between balls"
    );
    assert!(page.contains(&said), "{said}");
    let heat = of("heat");
    let bars = heat["data"].as_array().unwrap();
    assert_eq!(bars.len(), 2);
    for (name, results) in [("this drop", own), ("conventional outer ring", other)] {
        let bar = bars.iter().find(|bar| bar["name"] == name).unwrap();
        let names = [
            "rotor on ring, friction",
            "rotor on ring, damping",
            "inner raceway",
            "outer raceway",
        ];
        let more = ["between balls", "damping of the balls' contacts", "support"];
        assert_eq!(bar["y"], json!([&names[..], &more].concat()));
        let heats = [
            "rotor_friction_j",
            "rotor_damping_j",
            "inner_friction_j",
            "outer_friction_j",
            "ball_friction_j",
            "contact_damping_j",
            "support_damping_j",
        ];
        same(
            &list(bar, "x"),
            &heats.map(|name| results.number(name)),
            name,
        );
    }
}

/// Points of scattered drops stand at what was drawn for them, those of drops in succession at their temperatures.
#[test]
fn scattered_and_successive_drops_stand_where_they_were() {
    let path = Path::new(CASES).join("touchdown-d.toml");
    let read = |sets: &[&str]| {
        let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
        BearingArrangement::read(&path, &sets).unwrap()
    };
    let file = read(&["solver.duration_s=0.0002"]);
    let scattered = dropped(
        &file,
        DropRequest {
            samples: Some(3),
            ..DropRequest::default()
        },
    );
    let page = drop_page(&file, &scattered);
    let spec = serde_json::from_str(in_page(&page, "drop", "end_states").unwrap()).unwrap();
    let rows = &scattered.ensemble.as_ref().unwrap().drops;
    let of = |value: fn(&cageless_study::drop::BearingRow) -> f64| -> Vec<f64> {
        rows.iter().map(|row| value(&row.bearings[0])).collect()
    };
    let at = [
        of(|row| row.rotor_friction),
        of(|row| row.support_damping_n_s_m.unwrap()),
    ];
    traces(&spec, &[drawn("falling (no contact yet)", "y", at)], &[]);

    let file = read(&[
        "solver.duration_s=0.05",
        "rotor.drive_torque_n_m=-4.0",
        "rotor.speed_rpm=3000",
        "bearing.inner_ring_polar_inertia_kg_m2=5e-6",
    ]);
    let succession = dropped(
        &file,
        DropRequest {
            drops: Some(2),
            ..DropRequest::default()
        },
    );
    let page = drop_page(&file, &succession);
    let spec = serde_json::from_str(in_page(&page, "drop", "temperatures").unwrap()).unwrap();
    let rows = &succession.succession.records;
    assert_eq!(rows.len(), 2, "{:?}", succession.warnings);
    let of = |part: &str| {
        let at = |k: usize, when: &str| rows[k].number(&format!("{part}_{when}_c"));
        let parts = [
            at(0, "start"),
            at(0, "standstill"),
            at(1, "start"),
            at(1, "standstill"),
        ];
        [vec![0.0, 1.0, 1.0, 2.0], parts.to_vec()]
    };
    traces(
        &spec,
        &[
            drawn("inner ring", "y", of("inner_ring")),
            drawn("balls", "y", of("ball")),
            drawn("outer ring", "y", of("outer_ring")),
        ],
        &[],
    );
}
