//! Figures of runs and of static equilibria.

use std::path::Path;

use cageless_io::case_file::CaseFile;
use cageless_report::figures::{in_page, polar, ring};
use cageless_report::text::short;
use cageless_report::{LoadProfile, RingHistory, load_distribution, static_page};
use cageless_results::equilibrium_record;
use serde_json::Value;

use super::{CASES, Counter, Drawn, drawn, list, same, spec, traces};
use crate::synthetic;

/// Bars of a static equilibrium: forces to the left, pressures to the right, each raceway its own, row by row.
#[test]
fn the_load_distribution_draws_the_lists_that_it_names() {
    let pair = ["operation.axial_load_n=800"];
    for (name, sets, rows) in [
        (
            "zhao-d.toml",
            &["bearing.outer_groove_curvature_radius_mm=5.1"][..],
            1,
        ),
        ("preloaded-pair.toml", &pair[..], 2),
    ] {
        let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
        let file = CaseFile::read(&Path::new(CASES).join(name), &sets).unwrap();
        let record = equilibrium_record(file.case(), file.particulars()).unwrap();
        let page = static_page(&file, &record);
        let of_page: Value =
            serde_json::from_str(in_page(&page, "static", "loads").unwrap()).unwrap();
        let alone = spec(&load_distribution(&file, &record));
        for spec in [of_page, alone] {
            let bars = spec["data"].as_array().unwrap().iter();
            let bars: Vec<&Value> = bars.filter(|bar| bar["type"] == "barpolar").collect();
            assert_eq!(bars.len(), 4 * rows);
            for row in 0..rows {
                for raceway in ["inner", "outer"] {
                    for (on, list_name) in [
                        ("polar", format!("{raceway}_force_n")),
                        ("polar2", format!("{raceway}_pressure_mpa")),
                    ] {
                        let name = match rows {
                            1 => format!("{raceway} raceway"),
                            _ => format!("row {}, {raceway} raceway", row + 1),
                        };
                        let is = |bar: &&&Value| bar["name"] == name && bar["subplot"] == on;
                        let bar = bars.iter().find(is).unwrap();
                        let all = record.results.values(&list_name);
                        assert_eq!(all.len(), 14 * rows);
                        let own = &all[14 * row..14 * (row + 1)];
                        same(&list(bar, "r"), own, &format!("{name}, {on}"));
                        if rows == 1 {
                            let angles = record.results.values("ball_angle_deg");
                            same(&list(bar, "theta"), angles, "theta");
                        }
                    }
                }
            }
        }
        // Otherwise the bars would not tell raceways apart.
        let [inner, outer] = ["inner_pressure_mpa", "outer_pressure_mpa"]
            .map(|name| record.results.values(name).iter().sum::<f64>());
        assert!((inner / outer - 1.0).abs() > 0.02, "{inner} {outer}");
    }
}

/// Loads and pressures of a run from a profile in which all lists differ, closed round the bearing.
#[test]
fn loads_of_a_run_draw_the_profile_that_they_name() {
    let mut counter = Counter(3.0);
    let mut data = synthetic::run_data();
    let mut four = || counter.several(4);
    data.load_profile = Some(LoadProfile {
        from_s: 0.375,
        to_s: 0.5,
        angle_deg: vec![0.0, 90.0, 180.0, 270.0],
        inner_force_mean_n: four(),
        inner_force_max_n: four(),
        outer_force_mean_n: four(),
        outer_force_max_n: four(),
        inner_pressure_max_mpa: four(),
        outer_pressure_max_mpa: four(),
    });
    let profile = data.load_profile.clone().unwrap();
    let closed = |values: &[f64]| [values, &values[..1]].concat();
    let polar = |name, on, values: &[f64]| Drawn {
        name,
        on,
        keys: ["theta", "r"],
        values: [closed(&profile.angle_deg), closed(values)],
    };
    let figure = polar::loads(&data).unwrap();
    traces(
        &spec(&figure),
        &[
            polar(
                "outer raceway, largest",
                "polar",
                &profile.outer_force_max_n,
            ),
            polar("outer raceway, mean", "polar", &profile.outer_force_mean_n),
            polar(
                "inner raceway, largest",
                "polar",
                &profile.inner_force_max_n,
            ),
            polar("inner raceway, mean", "polar", &profile.inner_force_mean_n),
            polar(
                "outer raceway, largest",
                "polar2",
                &profile.outer_pressure_max_mpa,
            ),
            polar(
                "inner raceway, largest",
                "polar2",
                &profile.inner_pressure_max_mpa,
            ),
        ],
        &[],
    );
    assert!(
        figure.caption.contains("t = 0.375 s to 0.5 s"),
        "{}",
        figure.caption
    );
    let most = |a: &[f64], b: &[f64]| short(a.iter().chain(b).fold(0.0f64, |m, v| m.max(*v)));
    let said = format!(
        "The largest contact force is {} N, the highest contact pressure {} MPa.",
        most(&profile.inner_force_max_n, &profile.outer_force_max_n),
        most(
            &profile.inner_pressure_max_mpa,
            &profile.outer_pressure_max_mpa
        )
    );
    assert_eq!(figure.plot.finding, said);
}

/// Path of the ring: coordinates over time, and its heights in words, largest depth last.
#[test]
fn the_path_of_the_ring_says_how_far_below_it_is() {
    let mut data = synthetic::run_data();
    data.settled_after_s = 0.25;
    data.ring = RingHistory {
        time_s: vec![0.1, 0.2, 0.3, 0.4],
        x_um: vec![1.5, -2.5, 3.5, -4.5],
        y_um: vec![-8.0, -9.5, -12.0, -11.0],
    };
    let figure = ring::ring_orbit(&data).unwrap();
    assert_eq!(
        figure.plot.finding,
        "The ring is between 8 and 12 µm below the centre of the outer ring."
    );
    let RingHistory { time_s, x_um, y_um } = data.ring.clone();
    traces(
        &spec(&figure),
        &[
            drawn("path", "y", [x_um.clone(), y_um.clone()]),
            drawn("Ring x (µm)", "y2", [time_s.clone(), x_um]),
            drawn("Ring y (µm)", "y3", [time_s, y_um]),
        ],
        &[],
    );
    let said = "t = 0.1 s to 0.4 s, sampled every 100000 µs. Part of it belongs to the transient.";
    assert!(figure.caption.contains(said), "{}", figure.caption);
}
