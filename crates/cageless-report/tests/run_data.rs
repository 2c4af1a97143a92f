//! Figures of a run against its rows: every number that is converted, from a real short run in which
//! the ring moves to both sides and balls touch.

use cageless::collision::Collision;
use cageless::simulation::ObserverError;
use cageless::snapshot::Snapshot;
use cageless_io::case_file::{CaseFile, template};
use cageless_report::figures::{ball, collisions, energy, history, ring};
use cageless_report::run_report::run_data;
use cageless_report::{Figure, RunData};
use cageless_study::Silent;
use cageless_study::run::{Options, Rows, RunRecord, run};
use serde_json::Value;

#[derive(Default)]
struct Kept {
    snapshots: Vec<Snapshot>,
    collisions: Vec<Collision>,
}

impl Rows for Kept {
    fn snapshot(&mut self, snapshot: &Snapshot) -> Result<(), ObserverError> {
        self.snapshots.push(snapshot.clone());
        Ok(())
    }

    fn collision(&mut self, collision: &Collision) -> Result<(), ObserverError> {
        self.collisions.push(*collision);
        Ok(())
    }
}

/// Two milliseconds from bunched balls, beside the middle of the load zone.
fn short_run() -> (RunRecord, RunData, Kept) {
    let set = [
        "solver.duration_s=0.002",
        "output.interval_us=20",
        "start.gaps=bunched",
        "start.state=rolling",
        "start.lead_ball_angle_deg=40",
    ];
    let file = CaseFile::parse(&template(false), "case", &set.map(str::to_owned)).unwrap();
    let mut kept = Kept::default();
    let options = Options {
        rows: Some(&mut kept),
        verify: false,
    };
    let record = run(&file, options, &Silent).unwrap();
    let data = run_data(&file, &record);
    (record, data, kept)
}

fn spec(figure: Option<Figure>) -> Value {
    serde_json::from_str(&figure.expect("a figure").json()).unwrap()
}

/// The traces of a plot that have a name.
fn named<'s>(spec: &'s Value, name: &str) -> &'s Value {
    let mut traces = spec["data"].as_array().unwrap().iter();
    let found = traces.find(|trace| trace["name"] == name);
    found.unwrap_or_else(|| panic!("no {name} in {spec}"))
}

fn title<'s>(spec: &'s Value, axis: &str) -> &'s str {
    spec["layout"][axis]["title"]["text"].as_str().unwrap()
}

/// Whether all numbers are those, to the digits that figures keep.
fn assert_same(found: &Value, wanted: &[f64], what: &str) {
    let found: Vec<f64> = (found.as_array().unwrap_or_else(|| panic!("{what}")).iter())
        .map(|v| v.as_f64().unwrap())
        .collect();
    assert_eq!(found.len(), wanted.len(), "{what}");
    let scale = wanted.iter().fold(1e-300f64, |m, v| m.max(v.abs()));
    for (found, wanted) in found.iter().zip(wanted) {
        assert!(
            (found - wanted).abs() <= 1e-4 * scale,
            "{what}: {found} {wanted}"
        );
    }
}

#[test]
fn histories_are_the_rows_in_the_units_of_their_axes() {
    let (_, data, kept) = short_run();
    let of = |value: &dyn Fn(&Snapshot) -> f64| -> Vec<f64> {
        kept.snapshots.iter().map(value).collect()
    };
    let degrees = 180.0 / std::f64::consts::PI;
    assert!(kept.snapshots.len() > 90);
    for k in [0, 5] {
        let ball = &data.balls[k];
        for (found, wanted, what) in [
            (&ball.angle_deg, of(&|s| s.angle_rad[k] * degrees), "angle"),
            (&ball.gap_deg, of(&|s| s.gap_rad[k] * degrees), "gap"),
            (
                &ball.orbit_speed_deg_s,
                of(&|s| s.orbit_speed_rad_s[k] * degrees),
                "orbit speed",
            ),
            (
                &ball.inner_sliding_m_s,
                of(&|s| s.inner_sliding_m_s[k]),
                "inner slip",
            ),
            (
                &ball.outer_sliding_m_s,
                of(&|s| s.outer_sliding_m_s[k]),
                "outer slip",
            ),
            (
                &ball.inner_force_n,
                of(&|s| s.inner_force_n[k]),
                "inner force",
            ),
            (
                &ball.outer_force_n,
                of(&|s| s.outer_force_n[k]),
                "outer force",
            ),
            (&ball.x_mm, of(&|s| s.x_m[k] * 1e3), "x"),
            (&ball.vx_m_s, of(&|s| s.vx_m_s[k]), "vx"),
            (&ball.vy_m_s, of(&|s| s.vy_m_s[k]), "vy"),
        ] {
            assert_same(&serde_json::json!(found), &wanted, what);
        }
    }
    // The axes, and the first ball of each figure.
    let gaps = spec(history::gaps(&data));
    assert_eq!(title(&gaps, "yaxis"), "Gap to the ball ahead (°)");
    let speeds = spec(history::orbit_speed(&data));
    assert_eq!(title(&speeds, "yaxis"), "Orbital speed (°/s)");
    let slip = spec(history::slip(&data));
    assert!(
        title(&slip, "yaxis").ends_with("ΔVi (m/s)")
            && title(&slip, "yaxis2").ends_with("ΔVo (m/s)")
    );
    assert!(ball::phase(&data).is_some());
    for (spec, wanted) in [
        (&gaps, of(&|s| s.gap_rad[0] * degrees)),
        (&speeds, of(&|s| s.orbit_speed_rad_s[0] * degrees)),
    ] {
        assert_same(&named(spec, "ball 1")["y"], &wanted, "ball 1");
    }
}

#[test]
fn the_balls_in_motion_are_those_of_the_rows() {
    let (_, data, kept) = short_run();
    let motion = data.motion.as_ref().unwrap();
    assert!(motion.time_s.len() > 50);
    let degrees = 180.0 / std::f64::consts::PI;
    for (n, time_s) in motion.time_s.iter().enumerate() {
        let row = kept.snapshots.iter().find(|s| s.time_s == *time_s).unwrap();
        for k in 0..14 {
            let off = motion.gap_deg[k][n] - row.gap_rad[k] * degrees;
            assert!(off.abs() < 1e-9, "gap {k}: {off}");
            let off = motion.angle_deg[k][n] - row.angle_rad[k] * degrees;
            assert!(off.abs() < 1e-9, "angle {k}: {off}");
        }
    }
    assert!((data.uniform_gap_deg - 1.816_078_291).abs() < 1e-8);
    // Half the speed of the inner raceway over the radius of the pitch circle.
    let orbit_deg_s = 12_000.0 * 6.0 * 18.24 / (18.24 + 27.765);
    assert!((data.rolling_orbit_speed_deg_s.unwrap() / orbit_deg_s - 1.0).abs() < 1e-12);
}

#[test]
fn the_path_of_the_ring_has_its_own_coordinates() {
    let (record, data, _) = short_run();
    let of = |value: fn(&cageless_study::ring_path::RingPosition) -> f64| -> Vec<f64> {
        record.ring_path.iter().map(value).collect()
    };
    let (x, y) = (of(|p| p.x_m * 1e6), of(|p| p.y_m * 1e6));
    let spec = spec(ring::ring_orbit(&data));
    assert_same(&named(&spec, "Ring x (µm)")["y"], &x, "x");
    assert_same(&named(&spec, "Ring y (µm)")["y"], &y, "y");
    let path = named(&spec, "path");
    assert!(path["x"].as_array().unwrap().len() > 50);
    let most = |values: &[f64]| values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    assert!(
        most(&x) > 0.01 && (most(&x) - most(&y)).abs() > 0.1 * most(&y),
        "{x:?} {y:?}"
    );
    assert_eq!(title(&spec, "xaxis"), "Ring x (µm)");
    assert_eq!(title(&spec, "yaxis"), "Ring y (µm)");
}

#[test]
fn collisions_have_the_numbers_of_both_balls() {
    let (_, data, kept) = short_run();
    assert!(kept.collisions.len() > 3, "{}", kept.collisions.len());
    assert_eq!(data.collisions_total, kept.collisions.len());
    for (found, wanted) in data.collisions.iter().zip(&kept.collisions) {
        assert_eq!(found.ball, wanted.ball + 1);
        assert_eq!(found.next_ball, wanted.next_ball + 1);
        assert_eq!(found.angle_deg, wanted.angle_rad.to_degrees());
        assert_eq!(found.time_s, wanted.start_s);
        assert_eq!(found.approach_speed_m_s, wanted.approach_speed_m_s);
        assert_eq!(found.peak_force_n, wanted.peak_force_n);
        assert_eq!(found.impulse_n_s, wanted.impulse_n_s);
    }
    let spec = spec(collisions::collisions(&data));
    let texts = named(&spec, "collisions")["text"].as_array().unwrap();
    let strongest = (kept.collisions.iter()).max_by(|a, b| a.impulse_n_s.total_cmp(&b.impulse_n_s));
    let strongest = strongest.unwrap();
    let said = format!(
        "balls {} and {}<br>",
        strongest.ball + 1,
        strongest.next_ball + 1
    );
    assert!(texts[0].as_str().unwrap().starts_with(&said), "{texts:?}");
}

#[test]
fn energies_are_in_joules() {
    let (record, data, _) = short_run();
    let spec = spec(energy::energy(&data));
    assert_eq!(
        title(&spec, "xaxis"),
        "Energy, positive into the bearing (J)"
    );
    let outcome = &record.outcome;
    let terms = outcome.state.layout().energy_terms().to_vec();
    let mut wanted: Vec<f64> = (terms.iter())
        .map(|&term| {
            let value = outcome.state.energy_term_j(term);
            if term.is_loss() { -value } else { value }
        })
        .filter(|value| *value != 0.0)
        .collect();
    wanted.push(outcome.start_energy_j - outcome.end_energy_j);
    assert_same(&spec["data"][0]["x"], &wanted, "energy");
}
