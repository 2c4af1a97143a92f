//! Figures of searches, comparisons, designs and of the paper.

use cageless_report::compared_run::ComparedRun;
use cageless_report::figures::search::trade_offs;
use cageless_report::figures::{
    axial_load, ball, compare, comparison, energy, orbit, phase, spacing, vibration,
};
use cageless_report::{Estimate, RingHistory, RingNumbers};
use cageless_results::{Record, SEARCH_SHAPE};
use serde_json::json;

use super::{Counter, drawn, list, place, same, spec, traces};
use crate::synthetic;

/// Panels of the rings of the reproduced paper: each row its field, each bar its lot.
#[test]
fn compared_rings_have_the_numbers_of_their_panels() {
    let mut data = synthetic::reproduce();
    let rings = data.ring_comparison.as_mut().expect("a comparison");
    let mut counter = Counter(2.0);
    let mut estimate = || Estimate {
        mean: counter.next(),
        standard_error: counter.next(),
        starts: 3,
    };
    for cell in &mut rings.cells {
        cell.numbers = RingNumbers {
            rms_m_s2: estimate(),
            rms_at_passing_m_s2: estimate(),
            rms_between_m_s2: estimate(),
            rms_without_contacts_m_s2: estimate(),
            rms_from_contacts_m_s2: estimate(),
            gap_deviation_deg: estimate(),
            contacts_per_s: estimate(),
            impulse_rate_n: estimate(),
        };
    }
    let spec = spec(&comparison::comparison(rings));
    type Number = fn(&RingNumbers) -> Estimate;
    let rows: [(&str, Number); 6] = [
        ("RMS", |n| n.rms_m_s2),
        ("At passing", |n| n.rms_at_passing_m_s2),
        ("Between", |n| n.rms_between_m_s2),
        ("Contacts cut", |n| n.rms_without_contacts_m_s2),
        ("SD of gaps", |n| n.gap_deviation_deg),
        ("Contacts<br>(1/s)", |n| n.contacts_per_s),
    ];
    let speeds = rings.speeds_rpm();
    let mut bars = spec["data"].as_array().unwrap().iter();
    for (column, speed_rpm) in speeds.iter().enumerate() {
        for (row, (title, of)) in rows.iter().enumerate() {
            let cells = rings.at_speed(*speed_rpm);
            let mut names: Vec<&str> = vec![];
            for cell in cells {
                if !names.contains(&cell.ring.as_str()) {
                    names.push(&cell.ring);
                }
            }
            for name in names {
                let bar = bars.next().expect("a bar");
                let panel = row * speeds.len() + column + 1;
                let axis = match panel {
                    1 => String::new(),
                    panel => panel.to_string(),
                };
                assert_eq!(bar["yaxis"], format!("y{axis}"));
                assert_eq!(bar["name"], name);
                let own = rings.at_speed(*speed_rpm).filter(|cell| cell.ring == name);
                let own: Vec<Estimate> = own.map(|cell| of(&cell.numbers)).collect();
                let of = |value: fn(&Estimate) -> f64| own.iter().map(value).collect::<Vec<_>>();
                same(&list(bar, "y"), &of(|e| e.mean), title);
                same(
                    &list(&bar["error_y"], "array"),
                    &of(|e| e.standard_error),
                    title,
                );
                if column == 0 {
                    let shown = &spec["layout"][format!("yaxis{axis}")]["title"]["text"];
                    let shown = shown.as_str().unwrap();
                    assert!(shown.starts_with(title), "{shown} {title}");
                }
            }
        }
    }
    assert!(bars.next().is_none());
}

/// Marks of a structure stand at the worst of its operating points, whichever of them that is.
#[test]
fn trade_offs_are_those_of_the_worst_operating_point() {
    let mut search = synthetic::search_json();
    let names = [
        "spacing_scatter",
        "collisions_late",
        "friction_w",
        "sliding_m_s",
        "force_deviation_n",
    ];
    let mut counter = Counter(1.0);
    let mut worst = vec![];
    for (k, structure) in search["band"]
        .as_array_mut()
        .unwrap()
        .iter_mut()
        .enumerate()
    {
        let point = structure["points"][0].clone();
        let mut points = vec![point.clone(), point.clone(), point];
        let mut most = vec![];
        for (n, name) in names.iter().enumerate() {
            // The worst is the first, the second or the last.
            let [low, middle, high] = [counter.next(), counter.next(), counter.next()];
            let mut values = [high, low, middle];
            values.rotate_right((k + n) % 3);
            for (point, value) in points.iter_mut().zip(values) {
                point["motion"][name] = json!(value);
            }
            most.push(high);
        }
        for name in ["margin_deg", "pressure_mpa"] {
            let [low, middle, high] = [counter.next(), counter.next(), counter.next()];
            for (point, value) in points.iter_mut().zip([middle, high, low]) {
                point[name] = json!(value);
            }
            most.push(high);
        }
        structure["points"] = json!(points);
        structure["on_front"] = json!(k != 1);
        worst.push(most);
    }
    let search = Record::read(&SEARCH_SHAPE, &search).expect("a search");
    let spec = spec(&trade_offs(&search));
    let of = |n: usize| -> Vec<f64> { [0, 2, 3].map(|k| worst[k][n]).to_vec() };
    let [scatter, late, friction, sliding, force, margin, pressure] = [0, 1, 2, 3, 4, 5, 6].map(of);
    for (on, x, y) in [
        ("y", &scatter, &late),
        ("y2", &scatter, &friction),
        ("y3", &margin, &sliding),
        ("y4", &pressure, &force),
    ] {
        let mut all = spec["data"].as_array().unwrap().iter();
        let front = all
            .find(|t| t["name"] == "Pareto front" && place(t) == on)
            .unwrap();
        same(&list(front, "x"), x, on);
        same(&list(front, "y"), y, on);
    }
}

/// Figures of one ball, of two runs side by side, of the axial load and of the paper, each against its fields.
#[test]
fn other_figures_draw_the_fields_that_they_name() {
    let mut counter = Counter(1.0);
    let mut data = synthetic::run_data();
    let keep = |values: &mut Vec<f64>, counter: &mut Counter| *values = counter.several(5);
    data.time_s = vec![0.0, 0.1, 0.2, 0.3, 0.4];
    (data.settled_after_s, data.view_s) = (0.0, None);
    for ball in &mut data.balls {
        for values in [
            &mut ball.gap_deg,
            &mut ball.orbit_speed_deg_s,
            &mut ball.inner_sliding_m_s,
            &mut ball.outer_sliding_m_s,
            &mut ball.inner_force_n,
            &mut ball.outer_force_n,
            &mut ball.x_mm,
            &mut ball.vx_m_s,
            &mut ball.vy_m_s,
        ] {
            keep(values, &mut counter);
        }
        ball.angle_deg = vec![-50.0, -20.0, 10.0, 40.0, 70.0];
    }
    let one = &data.balls[0];
    traces(
        &spec(&ball::loads(&data).unwrap()),
        &[
            drawn(
                "outer raceway Fo",
                "y",
                [one.angle_deg.clone(), one.outer_force_n.clone()],
            ),
            drawn(
                "inner raceway Fi",
                "y",
                [one.angle_deg.clone(), one.inner_force_n.clone()],
            ),
        ],
        &[],
    );
    traces(
        &spec(&ball::phase(&data).unwrap()),
        &[drawn(
            "ball 1",
            "y",
            [one.vx_m_s.clone(), one.vy_m_s.clone()],
        )],
        &[],
    );
    let bars = spec(&energy::energy(&data).unwrap());
    let energies: Vec<f64> = data.energy.iter().map(|item| item.energy_j).collect();
    same(&list(&bars["data"][0], "x"), &energies, "energy");

    let measured = data.vibration.as_mut().unwrap();
    for signal in &mut measured.signals {
        (signal.time_s, signal.frequency_hz) = (vec![0.0, 0.1, 0.2], vec![0.0, 100.0, 200.0]);
        signal.acceleration_m_s2 = counter.several(3);
        signal.amplitude_m_s2 = counter.several(3);
    }
    let [x, y] = &measured.signals[..] else {
        panic!("two signals");
    };
    let of_time =
        |s: &cageless_report::VibrationSignal| [s.time_s.clone(), s.acceleration_m_s2.clone()];
    let of_frequency =
        |s: &cageless_report::VibrationSignal| [s.frequency_hz.clone(), s.amplitude_m_s2.clone()];
    traces(
        &spec(&vibration::vibration("Vibration", measured)),
        &[
            drawn("outer ring, x", "y", of_time(x)),
            drawn("outer ring, y", "y2", of_time(y)),
            drawn("outer ring, x", "y3", of_frequency(x)),
            drawn("outer ring, y", "y3", of_frequency(y)),
        ],
        &[],
    );

    let paper = synthetic::reproduce();
    let mut speeds = paper.orbit_speeds[0].clone();
    speeds.passages.truncate(2);
    let mut expected = vec![];
    for (passage, on) in speeds.passages.iter_mut().zip(["y", "y2"]) {
        passage.angle_deg = vec![-30.0, 0.0, 30.0];
        passage.speed_deg_s = counter.several(3);
        passage.rolling_deg_s = counter.several(3);
        let over = |values: &[f64]| [passage.angle_deg.clone(), values.to_vec()];
        expected.push(drawn("simulated", on, over(&passage.speed_deg_s)));
        expected.push(drawn(
            "pure rolling, Eq. (3)",
            on,
            over(&passage.rolling_deg_s),
        ));
    }
    traces(&spec(&orbit::speeds(&speeds)), &expected, &[]);
    let mut portraits = paper.phase_portraits[0].clone();
    portraits.portraits.truncate(1);
    let portrait = &mut portraits.portraits[0];
    portrait.x_mm = counter.several(4);
    portrait.vx_m_s = counter.several(4);
    portrait.vy_m_s = counter.several(4);
    let (x, vx, vy) = (
        portrait.x_mm.clone(),
        portrait.vx_m_s.clone(),
        portrait.vy_m_s.clone(),
    );
    for (figure, across, up) in [
        (phase::velocities(&portraits), &vx, &vy),
        (phase::positions(&portraits), &x, &vx),
    ] {
        let spec = spec(&figure);
        same(&list(&spec["data"][0], "x"), across, &figure.label);
        same(&list(&spec["data"][0], "y"), up, &figure.label);
    }
    let mut three = paper.neighbours[0].clone();
    three.time_s = vec![0.2, 0.201, 0.203];
    three.orbit_speed_deg_s = std::array::from_fn(|_| counter.several(3));
    three.gap_deg = std::array::from_fn(|_| counter.several(3));
    let ms = vec![0.0, 1.0, 3.0];
    let of = |values: &Vec<f64>| [ms.clone(), values.clone()];
    let [before, itself, ahead] = &three.orbit_speed_deg_s;
    traces(
        &spec(&spacing::neighbours(&three)),
        &[
            drawn("ball i−1 (number 1)", "y", of(before)),
            drawn("ball i (number 2)", "y", of(itself)),
            drawn("ball i+1 (number 3)", "y", of(ahead)),
            drawn("gap i−1 to i", "y2", of(&three.gap_deg[0])),
            drawn("gap i to i+1", "y2", of(&three.gap_deg[1])),
        ],
        &[],
    );
}

/// Two runs side by side, and the axial load of a design: each curve its run or tilt.
#[test]
fn curves_of_several_runs_are_those_of_their_names() {
    let mut counter = Counter(1.0);
    let mut run = |name: &str| {
        let mut data = synthetic::run_data();
        data.recent = None;
        data.time_s = counter.several(3);
        for ball in &mut data.balls {
            ball.gap_deg = counter.several(3);
        }
        data.ring = RingHistory {
            time_s: counter.several(4),
            x_um: counter.several(4),
            y_um: counter.several(4),
        };
        let profile = data.load_profile.as_mut().unwrap();
        profile.inner_force_max_n = counter.several(4);
        profile.outer_force_max_n = counter.several(4);
        ComparedRun {
            name: name.to_owned(),
            data,
        }
    };
    let runs = [run("one"), run("two")];
    let [one, two] = &runs;
    let scatter = |run: &ComparedRun| {
        let of = |row: usize| {
            let gaps: Vec<f64> = run.data.balls.iter().map(|b| b.gap_deg[row]).collect();
            let mean = gaps.iter().sum::<f64>() / 14.0;
            (gaps.iter().map(|gap| (gap - mean).powi(2)).sum::<f64>() / 14.0).sqrt()
        };
        [run.data.time_s.clone(), (0..3).map(of).collect()]
    };
    let height = |run: &ComparedRun| [run.data.ring.time_s.clone(), run.data.ring.y_um.clone()];
    let load = |run: &ComparedRun| {
        let profile = run.data.load_profile.as_ref().unwrap();
        [profile.angle_deg.clone(), profile.inner_force_max_n.clone()]
    };
    for (figure, of) in [
        (
            compare::spacing(&runs),
            &scatter as &dyn Fn(&ComparedRun) -> [Vec<f64>; 2],
        ),
        (compare::ring(&runs), &height),
        (compare::loads(&runs), &load),
    ] {
        let expected = [drawn("one", "y", of(one)), drawn("two", "y", of(two))];
        traces(&spec(&figure.unwrap()), &expected, &[]);
    }

    let mut curve = |tilt_x_mrad: f64| axial_load::AxialCurve {
        tilt_x_mrad,
        axial_load_n: counter.several(3),
        lag_per_pass_deg: counter.several(3),
        inner_contact_angle_mean_deg: counter.several(3),
        critical_gap_deg: counter.several(3),
    };
    let tilts = vec![curve(0.0), curve(0.5)];
    let axial = axial_load::AxialLoads {
        radial_load_n: 1500.0,
        tilts: tilts.clone(),
        provenance: synthetic::run_data().provenance,
    };
    let [level, tilted] = &tilts[..] else {
        unreachable!()
    };
    let lag = |c: &axial_load::AxialCurve| [c.axial_load_n.clone(), c.lag_per_pass_deg.clone()];
    let gap = |c: &axial_load::AxialCurve| [c.axial_load_n.clone(), c.critical_gap_deg.clone()];
    for (figure, of) in [
        (
            axial_load::axial_load(&axial),
            &lag as &dyn Fn(&axial_load::AxialCurve) -> [Vec<f64>; 2],
        ),
        (axial_load::axial_gap(&axial), &gap),
    ] {
        let expected = [
            drawn("tilt 0 mrad", "y", of(level)),
            drawn("tilt 0.5 mrad", "y", of(tilted)),
        ];
        let spec = spec(&figure);
        traces(&spec, &expected, &[]);
        for (trace, curve) in spec["data"].as_array().unwrap().iter().zip(&tilts) {
            let angles = list(trace, "customdata");
            same(
                &angles,
                &curve.inner_contact_angle_mean_deg,
                "contact angle",
            );
        }
    }
}
