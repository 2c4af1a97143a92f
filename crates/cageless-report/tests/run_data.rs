//! Figures of a run against its rows: every number that is converted, from a real short run in which
//! the ring moves to both sides and balls touch.

use cageless::Snapshot;
use cageless::collision::Collision;
use cageless::simulation::ObserverError;
use cageless::{RacewayContact, RacewayPoint};
use cageless_io::case_file::{CaseFile, template};
use cageless_report::figures::{
    RUN, ball, collisions, contact_angles, energy, gap_map, groove, history, ring,
};
use cageless_report::run_report::{motion, run_data};
use cageless_report::{Figure, GrooveContacts, MotionFigure, RunData};
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

/// A run in space under an axial load in which ball 1 passes the raceway after the transient.
fn run_in_space(more: &[&str]) -> (RunData, Kept) {
    let set = [
        "model.motion=space",
        "operation.axial_load_n=150",
        "solver.duration_s=0.005",
        "output.interval_us=20",
        "start.lead_ball_angle_deg=-110",
    ];
    let set: Vec<String> = set.iter().chain(more).map(|s| s.to_string()).collect();
    let file = CaseFile::parse(&template(false), "case", &set).unwrap();
    let mut kept = Kept::default();
    let options = Options {
        rows: Some(&mut kept),
        verify: false,
    };
    let record = run(&file, options, &Silent).unwrap();
    (run_data(&file, &record), kept)
}

/// The points of contact of a page carry the forces of the run: on two flanks each its share.
#[test]
fn contacts_on_the_grooves_carry_the_forces_of_the_run() {
    let (data, kept) = run_in_space(&[]);
    let found = GrooveContacts::of(&data).expect("a run in space");
    let transient = kept.snapshots.len() - found.angle_rad.len();
    let bearing = &found.case.bearing;
    let inside = found.in_raceway();
    assert!(
        inside.iter().filter(|both| **both).count() > 20,
        "{inside:?}"
    );
    let mut plain = 0;
    for (k, row) in kept.snapshots[transient..].iter().enumerate() {
        let force = row.inner_force_n[0];
        assert_eq!(found.inner.angle_rad[k], row.inner_contact_angle_rad[0]);
        // The ellipse changes little with the angle.
        let middle = RacewayPoint {
            force_n: force,
            cosine: 1.0,
        };
        let [_, half] = RacewayContact::inner(bearing, middle).semi_axes_m;
        assert!((found.inner.semi_axes_m[k][1] / half - 1.0).abs() < 0.01);
        // Of the semi-axis across the groove a force per point follows, of both points the resultant.
        let points = found.outer.iter().filter(|c| c.angle_rad[k].is_finite());
        let (mut along, mut across, mut count) = (0.0, 0.0, 0);
        for point in points {
            let angle_rad = point.angle_rad[k];
            let of_one_newton = RacewayPoint {
                force_n: 1.0,
                cosine: angle_rad.cos(),
            };
            let [_, per_newton] = RacewayContact::outer(bearing, of_one_newton).semi_axes_m;
            let force = (point.semi_axes_m[k][1] / per_newton).powi(3);
            let (sin, cos) = angle_rad.sin_cos();
            (along, across, count) = (along + force * cos, across + force * sin, count + 1);
        }
        assert!(
            (across.atan2(along) - row.outer_contact_angle_rad[0]).abs() < 1e-5,
            "{k}"
        );
        assert!(
            // Per newton the curvature along rolling is that of the nominal pitch circle.
            (along.hypot(across) / row.outer_force_n[0] - 1.0).abs() < 2e-4,
            "{k}"
        );
        plain += usize::from(count == 1);
    }
    assert!(plain > 20);
    // In the plane there are none.
    assert!(GrooveContacts::of(&short_run().1).is_none());
}

#[test]
fn the_unrolled_grooves_have_their_shoulders_and_flanks() {
    let (data, _) = run_in_space(&[]);
    let found = GrooveContacts::of(&data).unwrap();
    let spec = spec(contact_angles::contact_angles(&data));
    let [inner, outer] = found
        .case
        .bearing
        .shoulder_angles_rad()
        .map(f64::to_degrees);
    let lines = spec["layout"]["shapes"].as_array().unwrap();
    for (axis, shoulder) in [("y", outer), ("y2", inner)] {
        for edge in [shoulder, -shoulder] {
            let drawn =
                |l: &Value| l["yref"] == axis && (l["y0"].as_f64().unwrap() - edge).abs() < 1e-3;
            assert!(
                lines.iter().any(|l| l["type"] == "line" && drawn(l)),
                "{axis} {edge}"
            );
        }
    }
    let flanks = named(&spec, "flanks")["y"].as_array().unwrap();
    let steepest = flanks.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    // sin α = lC/(2 Rw).
    let wanted = (5.1f64 / (2.0 * 4.7625)).asin().to_degrees();
    assert!((steepest - wanted).abs() < 1e-3, "{steepest} {wanted}");
    // The band reaches from end to end of the ellipse.
    let centre = named(&spec, "inner contact")["y"][0].as_f64().unwrap();
    let mut traces = spec["data"].as_array().unwrap().iter();
    let band = traces.rfind(|t| t["fill"] == "toself").unwrap();
    let top = band["y"][0].as_f64().unwrap();
    let radius_m = found.case.bearing.ball_radius_m();
    let reach = (found.inner.semi_axes_m[0][1] / radius_m).to_degrees();
    assert!((top - centre - reach).abs() < 1e-3, "{top} {centre}");
    let said = figures(&data)
        .into_iter()
        .find(|f| f.label == "Contact angles")
        .unwrap()
        .caption;
    let contact = &found.outer[0];
    let ends = contact.angle_rad.iter().zip(&contact.semi_axes_m);
    let far = ends
        .map(|(angle, [_, a])| angle.abs() + a / radius_m)
        .fold(0.0, f64::max);
    let room = outer - far.to_degrees();
    assert!(
        said.contains(&format!(
            "stays {room:.1}° inside the shoulder of the outer ring"
        )),
        "{said}"
    );
}

/// Two rows are two drawings with the numbers of their own balls; no pair has a ball of each.
#[test]
fn rows_of_balls_move_side_by_side() {
    let pair = include_str!("../../../cases/preloaded-pair.toml");
    let set = ["solver.duration_s=0.001", "output.interval_us=50"];
    let file = CaseFile::parse(pair, "case", &set.map(str::to_owned)).unwrap();
    let mut kept = Kept::default();
    let options = Options {
        rows: Some(&mut kept),
        verify: false,
    };
    let record = run(&file, options, &Silent).unwrap();
    let data = run_data(&file, &record);
    let motion = motion(file.case(), "", &kept.snapshots, data.provenance.clone());
    let figure = MotionFigure::new("Motion", "", vec![motion.clone()]);
    let [first, second] = &figure.bearings[..] else {
        panic!("{}", figure.bearings.len());
    };
    assert_eq!(
        (first.title.as_str(), second.title.as_str()),
        ("row 1", "row 2")
    );
    assert_eq!((first.angle_deg.len(), second.balls_before), (14, 14));
    assert_eq!(second.angle_deg[..], motion.angle_deg[14..]);
    assert_eq!(second.gap_deg[..], motion.gap_deg[14..]);
    let html = figure.html("motion", &[]);
    assert_eq!(html.matches(">15</text>").count(), 1);
    assert!(html.contains("\"before\":14"));
    let map = spec(gap_map::gap_map(&data));
    let pairs = map["data"][0]["y"].as_array().unwrap();
    assert_eq!(
        (&pairs[13], &pairs[14], &pairs[27]),
        (&"14–1".into(), &"15–16".into(), &"28–15".into())
    );
    // One bearing stays as it is.
    assert_eq!(short_run().1.motion.unwrap().rows()[0].title, "");
}

/// Tracks lie on the surface that is drawn, of a section that is turned as well.
#[test]
fn the_ball_stands_on_its_groove() {
    let turned = [
        "bearing.contact_angle_deg=15",
        "raceway.contact_angle_deg=15",
        "operation.axial_load_n=1500",
        "operation.radial_load_n=500",
    ];
    for more in [&[][..], &turned] {
        let (data, _) = run_in_space(more);
        let spec = spec(groove::groove(&data));
        let grid = |name: &str| -> Vec<f64> {
            let rows = spec["data"][0][name].as_array().unwrap().iter();
            rows.flat_map(|row| row.as_array().unwrap())
                .map(|v| v.as_f64().unwrap())
                .collect()
        };
        let (x, y, z) = (grid("x"), grid("y"), grid("z"));
        let tracks: Vec<&Value> = (spec["data"].as_array().unwrap().iter())
            .filter(|trace| trace["name"] == "track")
            .collect();
        assert_eq!(tracks.len(), 2);
        for track in tracks {
            let of = |axis: &str, k: usize| track[axis][k].as_f64();
            for k in (0..track["x"].as_array().unwrap().len()).step_by(5) {
                let (Some(a), Some(b), Some(c)) = (of("x", k), of("y", k), of("z", k)) else {
                    continue;
                };
                let far = |n: usize| (x[n] - a).hypot(y[n] - b).hypot(z[n] - c);
                let nearest = (0..x.len()).map(far).fold(f64::INFINITY, f64::min);
                assert!(nearest < 0.2, "{nearest} mm from ({a}, {b}, {c})");
            }
        }
    }
}

/// All figures of a page.
fn figures(data: &RunData) -> Vec<Figure> {
    let all = RUN.iter().flat_map(|(_, figures)| *figures);
    all.filter_map(|figure| (figure.draw)(data)).collect()
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
