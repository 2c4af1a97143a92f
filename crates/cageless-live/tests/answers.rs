//! Answers to requests of pages.

use cageless_io::case_file::{CaseFile, template};
use cageless_live::{Control, REQUEST_BYTES_MAX, answer};
use serde_json::{Value, json};

fn ask(request: &Value) -> Value {
    let text = answer(&request.to_string(), &mut |_| Control::Continue(()));
    serde_json::from_str(&text).expect("JSON")
}

fn good(request: &Value) -> Value {
    let answer = ask(request);
    assert!(answer["error"].is_null(), "{answer}");
    answer["ok"].clone()
}

fn refused(request: &Value) -> Value {
    let answer = ask(request);
    assert!(answer["ok"].is_null(), "{answer}");
    answer["error"].clone()
}

/// The case of `cageless new` with other sizes of its raceway.
fn structure(axial_span_mm: f64, half_angle_deg: f64) -> String {
    let case = template(false);
    let line = |key: &str| {
        let found = case.lines().find(|l| l.starts_with(key));
        found.expect("a key of the template").to_owned()
    };
    case.replace(
        &line("axial_span_mm"),
        &format!("axial_span_mm = {axial_span_mm}"),
    )
    .replace(
        &line("half_angle_deg"),
        &format!("half_angle_deg = {half_angle_deg}"),
    )
}

#[test]
fn geometry_has_the_closed_forms_of_the_paper() {
    let g = good(&json!({ "op": "geometry", "case": structure(5.1, 25.2) }));
    let close = |value: &Value, wanted: f64, within: f64| {
        let value = value.as_f64().expect("a number");
        assert!((value - wanted).abs() < within, "{value} is not {wanted}");
    };
    // Zhao 2022, Table 2, structure (d).
    close(&g["numbers"]["beta0_deg"], 1.8171, 1e-4);
    close(&g["raceways"][0]["axial_span_mm"], 5.1, 1e-12);
    let depths = g["raceways"][0]["depth_um"].as_array().unwrap();
    let at = |row: usize| {
        depths[row]
            .as_array()
            .unwrap()
            .iter()
            .map(|d| d.as_f64().unwrap())
    };
    // The plain groove beyond the ends, material taken away in the middle.
    assert!(at(0).all(|d| d.abs() < 0.01), "{:?}", depths[0]);
    assert!(at(depths.len() / 2).fold(0.0, f64::max) > 10.0);
    let terms = g["estimate"]["terms"].as_array().unwrap();
    let names: Vec<_> = terms.iter().map(|t| t["name"].as_str().unwrap()).collect();
    assert_eq!(
        names,
        [
            "separation",
            "depth",
            "sliding",
            "both-neighbours",
            "stress"
        ]
    );
}

/// The section in the middle goes from the plain groove down the edges to the floor of a slot.
#[test]
fn geometry_has_the_edges_of_a_slot() {
    let case = structure(3.2, 25.2);
    let own = "# shape = \"quartic\"";
    let slot = "shape = \"slot\"\nedge_radius_mm = 0.3\nslot_depth_mm = 0.7 #";
    assert!(case.contains(own));
    let g = good(&json!({ "op": "geometry", "case": case.replace(own, slot) }));
    let raceway = &g["raceways"][0];
    let middle = |key: &str| -> Vec<f64> {
        let rows = raceway[key].as_array().unwrap();
        let row = rows[rows.len() / 2].as_array().unwrap();
        row.iter().map(|v| v.as_f64().unwrap()).collect()
    };
    let (z, depth) = (middle("across_mm"), middle("depth_um"));
    assert!(z.is_sorted(), "{z:?}");
    // ze = (Rw + re) sin αc, and the walls re within it.
    let half_width = (4.7625 + 0.3) * 3.2 / (2.0 * 4.7625) - 0.3;
    for (z, depth) in z.iter().zip(&depth) {
        let beside = z.abs() - half_width;
        if beside > 0.301 {
            assert!(depth.abs() < 0.01, "{z} {depth}");
        } else if beside > 1e-3 {
            assert!((0.0..300.0).contains(depth), "{z} {depth}");
        } else if beside < -1e-3 {
            // Re + D from the centre of the groove along the section.
            let along = (4.953 + depth / 1e3).powi(2) - z * z;
            assert!((along.sqrt() - 4.953 - 0.7).abs() < 1e-4, "{z} {depth}");
        }
    }
    assert!(depth.iter().any(|d| *d > 700.0));
}

#[test]
fn a_case_is_refused_with_the_message_of_the_command() {
    let error = refused(&json!({ "op": "geometry", "case": structure(9.0, 25.2) }));
    assert_eq!(error["key"], "raceway.axial_span_mm");
    assert!(
        error["line"].as_u64().is_some_and(|line| line > 1),
        "{error}"
    );
    let message = error["message"].as_str().unwrap();
    assert!(
        message.starts_with("case:") && message.contains("Eq. (8)"),
        "{message}"
    );
}

/// The case of `cageless new` with further keys, each in its section.
fn with(keys: &[(&str, &str)]) -> String {
    let mut case = template(false);
    for (section, line) in keys {
        let head = case.find(&format!("\n[{section}]")).expect("a section") + 1;
        let end = head + case[head..].find('\n').expect("further lines");
        case.insert_str(end, &format!("\n{line}"));
    }
    case
}

#[test]
fn a_case_in_space_is_settled_and_estimated_there() {
    let turned = with(&[
        ("bearing", "contact_angle_deg = 15.0"),
        ("raceway", "contact_angle_deg = 15.0"),
        ("operation", "axial_load_n = 1000.0"),
    ]);
    let symmetric = with(&[
        ("bearing", "contact_angle_deg = 15.0"),
        ("operation", "axial_load_n = 1000.0"),
    ]);
    let answers = [turned, symmetric].map(|case| good(&json!({ "op": "geometry", "case": case })));
    let lags = answers.each_ref().map(|g| {
        assert_eq!(g["space"]["signs"], json!([1.0]));
        assert!(g["static"]["ring_z_um"].as_f64().unwrap() > 1.0);
        let terms = g["estimate"]["terms"].as_array().unwrap();
        let names: Vec<_> = terms.iter().map(|t| t["name"].as_str().unwrap()).collect();
        assert_eq!(
            names,
            ["separation", "depth", "lag", "both-neighbours", "stress"]
        );
        terms[2]["value"].as_f64().unwrap()
    });
    // A section turned by the contact angle keeps its effect, a symmetric one does not.
    assert!(lags[0] > 0.7 && lags[1] < 0.3, "{lags:?}");
    let raceway = &answers[0]["raceways"][0];
    let of = |name: &str, k: usize| raceway[name][k][40].as_f64().unwrap();
    // In the middle the flanks stand at 15° ± asin(lC/2Rw), symmetric about the seat of the ball.
    let flank = (5.1f64 / 9.525).asin().to_degrees();
    assert!((of("flank_deg", 0) - 15.0 - flank).abs() < 1e-5);
    assert!((of("flank_deg", 1) - 15.0 + flank).abs() < 1e-5);
    let apart = of("track_mm", 0) - of("track_mm", 1);
    assert!(
        (apart - 5.1 * 15f64.to_radians().cos()).abs() < 1e-5,
        "{apart}"
    );
    // In the plane there is no third dimension.
    let plane = good(&json!({ "op": "geometry", "case": template(false) }));
    assert_eq!(plane["space"], Value::Null);
}

#[test]
fn a_motion_in_space_has_its_contacts_and_goes_on() {
    let case = shipped("preloaded-pair");
    let stretch = |duration_s: f64, frames: usize, resume: &Value| {
        let mut request =
            json!({ "op": "motion", "case": case, "duration_s": duration_s, "frames": frames });
        if !resume.is_null() {
            request["resume"] = resume.clone();
        }
        good(&request)
    };
    let first = stretch(2e-4, 2, &Value::Null);
    let second = stretch(2e-4, 2, &first["resume"]);
    let whole = stretch(4e-4, 4, &Value::Null);
    let last = |part: &Value| part["frames"].as_array().unwrap().last().unwrap().clone();
    let (a, b) = (last(&second), last(&whole));
    let numbers = |v: &Value| -> Vec<f64> {
        v.as_array()
            .unwrap()
            .iter()
            .map(|x| x.as_f64().unwrap())
            .collect()
    };
    assert_eq!(numbers(&a["angle_deg"]).len(), 28);
    for (found, wanted) in numbers(&a["angle_deg"])
        .iter()
        .zip(numbers(&b["angle_deg"]))
    {
        assert!((found - wanted).abs() < 1e-4, "{found} {wanted}");
    }
    // The rows press to opposite sides; at each contact the ellipse has a length.
    for (contact, name) in [
        (&b["space"]["inner"], "inner"),
        (&b["space"]["outer"][0], "outer"),
    ] {
        let (angle, reach) = (numbers(&contact[0]), numbers(&contact[1]));
        for k in 0..14 {
            assert!(
                angle[k] > 5.0 || name == "outer" && reach[k] == 0.0,
                "{name} {k}"
            );
        }
        // Of the second row the contact that bears outside may be that of the other flank.
        let other = numbers(&b["space"]["outer"][1][0]);
        for k in 14..28 {
            let leans = angle[k] < -5.0 || name == "outer" && other[k] < -5.0;
            assert!(leans, "{name} {k}");
        }
        assert!(
            reach[..14].iter().all(|r| *r > 2.0 && *r < 20.0),
            "{name} {reach:?}"
        );
    }
    // Ball 1, in the middle of the raceway at first, is on both flanks, 5.1 mm apart but for the turn.
    let start = &whole["frames"][0]["space"]["outer"];
    let z = [0, 1].map(|flank| start[flank][2][0].as_f64().unwrap());
    assert!(
        (z[0] - z[1] - 5.1 * 15f64.to_radians().cos()).abs() < 0.2,
        "{z:?}"
    );
    assert!(
        last(&good(&json!({
            "op": "motion", "case": template(false), "duration_s": 1e-4, "frames": 1,
        })))["space"]
            .is_null()
    );
}

/// In space the verdict is what the load leaves of the lag.
#[test]
fn a_verdict_in_space_is_about_the_lag() {
    for (axial_n, keeps) in [("100.0", true), ("1500.0", false)] {
        let case = with(&[("operation", &format!("axial_load_n = {axial_n}"))]);
        let found = good(&json!({ "op": "verdict", "case": case }));
        // Rigid flanks in the plane would lag more.
        assert_eq!(found["passes"], false, "{found}");
        let [pressure, criterion, gap, double] = &found["criteria"].as_array().unwrap()[..] else {
            panic!("{found}");
        };
        assert_eq!(gap["name"], "steady-gap");
        assert_eq!(double["name"], "both-neighbours");
        let pressed = found["pressure_at_rest_mpa"].as_f64().unwrap() / 4200.0;
        assert!((pressure["value"].as_f64().unwrap() / pressed - 1.0).abs() < 1e-12);
        assert!(found["critical_gap_deg"].as_f64().unwrap() < 1.5, "{found}");
        let share = criterion["value"].as_f64().unwrap();
        let lag = found["passages"]["lag_per_pass_deg"].as_f64().unwrap();
        // Rolling in the plane lags by 2.29°.
        assert!((share - lag / 2.29).abs() < 0.01, "{share} {lag}");
        assert_eq!(share > 0.5, keeps);
        let decides = if keeps { "steady-gap" } else { "lag" };
        assert_eq!(found["criterion"], decides);
    }
}

#[test]
fn malformed_requests_are_refused() {
    let case = template(false);
    for request in [
        "",
        "[",
        "null",
        r#"{"op": "delete"}"#,
        r#"{"op": "geometry"}"#,
        r#"{"op": "geometry", "case": 3}"#,
        r#"{"op": "geometry", "case": "", "path": "/etc/passwd"}"#,
    ] {
        let answer = answer(request, &mut |_| Control::Continue(()));
        assert!(answer.starts_with(r#"{"error":"#), "{request}: {answer}");
    }
    // Neither JSON nor TOML is read to any depth.
    let deep = "[".repeat(100_000);
    refused(&json!({ "op": "geometry", "case": format!("a = {deep}") }));
    refused(&json!({ "op": "geometry", "case": format!("[{}]", "a.".repeat(50_000) + "a") }));
    let text = answer(&deep, &mut |_| Control::Continue(()));
    assert!(text.starts_with(r#"{"error":"#), "{text}");
    let long = format!("{}{}", " ".repeat(REQUEST_BYTES_MAX), r#"{"op": "about"}"#);
    let text = answer(&long, &mut |_| Control::Continue(()));
    assert!(text.contains("bytes"), "{text}");
    for (duration_s, frames) in [
        (0.0, 10),
        (-1.0, 10),
        (1e9, 10),
        (1e-4, 0),
        (1e-4, 1_000_000),
        // Frames that are no time apart would never end.
        (5e-324, 4000),
        (1e-12, 4000),
    ] {
        refused(
            &json!({ "op": "motion", "case": case, "duration_s": duration_s, "frames": frames }),
        );
    }
    let whole = good(&json!({
        "op": "motion", "case": case, "duration_s": 1e-4, "frames": 2,
    }));
    let whole = whole["resume"].as_str().unwrap();
    let (short, long) = (&whole[16..], format!("{whole}00"));
    let (foreign, infinite) = (format!("zz{}", &whole[2..]), format!("7ff{}", &whole[3..]));
    for resume in ["", "00", short, &long, &foreign, &infinite] {
        let request = json!({
            "op": "motion", "case": case, "duration_s": 1e-4, "frames": 2, "resume": resume,
        });
        let error = refused(&request);
        assert!(
            error["message"]
                .as_str()
                .unwrap()
                .starts_with("resume is not"),
            "{error}"
        );
    }
}

#[test]
fn ranges_end_where_the_case_becomes_impossible() {
    let control = |name: &str, key: &str, low: f64, high: f64, whole: bool| {
        json!({
            "name": name, "low": low, "high": high, "whole": whole,
            "keys": [{ "key": key, "low": low, "high": high }],
        })
    };
    let ranges = good(&json!({
        "op": "ranges", "case": structure(5.1, 25.2),
        "controls": [
            control("span", "raceway.axial_span_mm", 0.0, 9.0, false),
            control("balls", "bearing.balls", 3.0, 20.0, true),
            control("friction", "contact.friction_coefficient", -1.0, -0.5, false),
        ],
    }));
    let limit = ranges["span"][0][1].as_f64().unwrap();
    assert!(
        (7.39..7.4018).contains(&limit),
        "Eq. (8) allows 7.4017 mm: {limit}"
    );
    assert_eq!(ranges["balls"], json!([[3.0, 15.0]]));
    assert_eq!(ranges["friction"], json!([]));
}

/// What stretches reach, and what one run of the whole time does.
#[test]
fn stretches_go_on_where_the_last_one_ended() {
    let case = structure(5.1, 25.2);
    let stretch = |duration_s: f64, resume: Option<&Value>| {
        let mut request =
            json!({ "op": "motion", "case": case, "duration_s": duration_s, "frames": 8 });
        if let Some(resume) = resume {
            request["resume"] = resume.clone();
        }
        good(&request)
    };
    let first = stretch(2e-4, None);
    let second = stretch(2e-4, Some(&first["resume"]));
    let whole = stretch(4e-4, None);
    assert_eq!(first["frames"].as_array().unwrap().len(), 9);
    assert_eq!(second["frames"].as_array().unwrap().len(), 8);
    assert_eq!(second["from_s"], first["to_s"]);
    let last = |part: &Value, name: &str| -> Vec<f64> {
        let frame = part["frames"].as_array().unwrap().last().unwrap()[name].clone();
        serde_json::from_value(frame).unwrap()
    };
    // A multistep method starts anew after a stretch: equal to its error, not to the bit.
    for (a, b) in last(&second, "angle_deg")
        .iter()
        .zip(last(&whole, "angle_deg"))
    {
        assert!((a - b).abs() < 2e-5, "{a} and {b}");
    }
    for (a, b) in last(&second, "inner_force_n")
        .iter()
        .zip(last(&whole, "inner_force_n"))
    {
        assert!((a - b).abs() < 0.5, "{a} and {b}");
    }
}

/// The energy ledger of a stretch is its own: it closes whatever those before it have lost to a film.
#[test]
fn stretches_in_oil_keep_their_energy() {
    let oil =
        "[film]\nviscosity_mpa_s = 30.0\nviscosity_temperature_1_k = 0.035\nsupply = \"flooded\"\n";
    let case = format!("{}\n{oil}", structure(5.1, 25.2));
    let mut resume = Value::Null;
    for k in 0..8 {
        let mut request = json!({ "op": "motion", "case": case, "duration_s": 1e-3, "frames": 2 });
        if k > 0 {
            request["resume"] = resume;
        }
        let stretch = good(&request);
        assert_eq!(stretch["stopped"], Value::Null, "{k}");
        let residual = stretch["energy_residual_relative"].as_f64().unwrap();
        assert!(residual.abs() < 1e-3, "{k}: {residual:e}");
        resume = stretch["resume"].clone();
    }
}

#[test]
fn work_can_be_cancelled() {
    let case = structure(5.1, 25.2);
    for request in [
        json!({ "op": "verdict", "case": case }),
        json!({ "op": "motion", "case": case, "duration_s": 0.1, "frames": 2 }),
        over_structures(&case, &[5.0, 5.1], &[25.2]),
    ] {
        let mut asked = 0;
        let text = answer(&request.to_string(), &mut |_| {
            asked += 1;
            Control::Break(())
        });
        assert_eq!(asked, 1);
        assert!(
            text.contains("cancelled") || text.contains("interrupted"),
            "{text}"
        );
    }
}

/// The search for an equilibrium ends at the place of the ring at which it is told to, wherever a request needs one.
#[test]
fn an_equilibrium_that_is_sought_is_cancelled() {
    let plane = structure(5.1, 25.2);
    let space = plane.replace("# motion = \"auto\"", "motion = \"space\"");
    let settled = space.clone() + "\n[start]\nstate = \"settled\"\n";
    let axis = |key: &str, values: &[f64]| json!({ "key": key, "values": values });
    let load = axis("operation.radial_load_n", &[1000.0, 1100.0]);
    let span = axis("raceway.axial_span_mm", &[5.0, 5.1]);
    let moment = axis("operation.axial_load_n", &[500.0]);
    for request in [
        json!({ "op": "static", "case": plane }),
        json!({ "op": "geometry", "case": plane }),
        json!({ "op": "static", "case": space }),
        json!({ "op": "geometry", "case": space }),
        json!({ "op": "map", "case": plane, "across": load, "up": moment }),
        json!({ "op": "map", "case": space, "across": load, "up": moment }),
        json!({ "op": "map", "case": space, "across": span,
            "up": axis("raceway.half_angle_deg", &[25.2]) }),
        json!({ "op": "motion", "case": settled, "duration_s": 1e-3, "frames": 2 }),
        json!({ "op": "compare", "case": settled, "reference": settled }),
        json!({ "op": "verdict", "case": space }),
    ] {
        // The third time that it is asked it looks for an equilibrium.
        let mut asked = 0;
        let text = answer(&request.to_string(), &mut |_| {
            asked += 1;
            match asked {
                1 | 2 => Control::Continue(()),
                _ => Control::Break(()),
            }
        });
        // Of runs side by side each asks for itself.
        assert!((3..=10).contains(&asked), "{asked}: {request}: {text}");
        assert!(
            text.contains(r#"{"message":"cancelled"}"#) || text.contains("interrupted"),
            "{request}: {text}"
        );
    }
}

/// A map of one row is cancelled within it, and no single equilibrium takes minutes.
#[test]
fn work_in_space_can_be_cancelled_or_is_short() {
    let case = structure(5.1, 25.2).replace("# motion = \"auto\"", "motion = \"space\"");
    let loads: Vec<f64> = (1..=50).map(|k| 100.0 * f64::from(k)).collect();
    let request = json!({
        "op": "map", "case": case,
        "across": { "key": "operation.radial_load_n", "values": loads },
        "up": { "key": "operation.axial_load_n", "values": [500.0] },
    });
    let mut asked = 0;
    let text = answer(&request.to_string(), &mut |_| {
        asked += 1;
        if asked < 3 {
            Control::Continue(())
        } else {
            Control::Break(())
        }
    });
    assert_eq!(asked, 3, "{text}");
    assert!(text.contains("cancelled"), "{text}");
    let row = |k: usize| format!("[[row]]\naxial_position_mm = {}\n", 20 * k);
    let rows: String = (0..200).map(row).collect();
    let request = json!({ "op": "static", "case": case + &rows });
    let text = answer(&request.to_string(), &mut |_| Control::Continue(()));
    assert!(
        text.contains("the case has 2800 balls; the studio computes up to 2000"),
        "{text}"
    );
}

/// Verdicts of `cageless design` on the structures of Zhao 2022, Table 2.
#[test]
fn the_estimate_agrees_with_the_verdicts_on_the_structures_of_the_paper() {
    for (letter, passes, failing) in [
        ("a", false, "both-neighbours"),
        ("b", false, "both-neighbours"),
        ("c", true, ""),
        ("d", true, ""),
        ("e", true, ""),
        ("f", false, "sliding"),
        ("g", false, "sliding"),
        ("h", false, "sliding"),
        ("i", false, "sliding"),
        ("j", false, "sliding"),
    ] {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");
        let case = std::fs::read_to_string(format!("{folder}/zhao-{letter}.toml")).expect("a case");
        let estimate = good(&json!({ "op": "geometry", "case": case }))["estimate"].clone();
        assert_eq!(estimate["passes"], passes, "{letter}: {estimate}");
        let terms = estimate["terms"].as_array().unwrap();
        let missed = terms.iter().find(|t| t["margin"].as_f64().unwrap() < 0.0);
        let missed = missed.map_or("", |t| t["name"].as_str().unwrap());
        assert_eq!(missed, failing, "{letter}: {estimate}");
    }
}

/// The request for a map over two keys.
fn over(case: &str, across: (&str, &[f64]), up: (&str, &[f64])) -> Value {
    let axis = |(key, values): (&str, &[f64])| json!({ "key": key, "values": values });
    json!({ "op": "map", "case": case, "across": axis(across), "up": axis(up) })
}

/// The request for a map over lC and θ.
fn over_structures(case: &str, spans: &[f64], angles: &[f64]) -> Value {
    let [across, up] = ["raceway.axial_span_mm", "raceway.half_angle_deg"];
    over(case, (across, spans), (up, angles))
}

/// A point of a map is the case with its two keys set as `--set` sets them, or the message of that.
#[test]
fn a_map_has_any_two_keys() {
    let case = structure(5.1, 25.2);
    let (blends, depths) = ([0.0, 0.5, 90.0], [0.0, 12.5, -1.0]);
    let map = good(&over(
        &case,
        ("raceway.blend_mm", &blends),
        ("raceway.depth_um", &depths),
    ));
    let mut refusals = 0;
    for (j, depth) in depths.into_iter().enumerate() {
        for (k, blend) in blends.into_iter().enumerate() {
            let sets = [
                format!("raceway.depth_um={depth}"),
                format!("raceway.blend_mm={blend}"),
            ];
            let message = map["refused"][j][k].as_str();
            match CaseFile::parse(&case, "case", &sets) {
                Ok(file) => {
                    assert_eq!(message, None, "{sets:?}");
                    let text = file.document().to_toml().expect("TOML");
                    let own = good(&json!({ "op": "geometry", "case": text }));
                    assert_eq!(map["beta0_deg"][j][k], own["numbers"]["beta0_deg"]);
                    for term in own["estimate"]["terms"].as_array().unwrap() {
                        let rows = &map["margins"][term["name"].as_str().unwrap()];
                        assert_eq!(rows[j][k], term["margin"], "{sets:?} {term}");
                    }
                }
                Err(error) => {
                    refusals += 1;
                    let rule = |text: &str| text.split_once(" = ").map(|(_, r)| r.to_owned());
                    let own = rule(&error.to_string());
                    assert_eq!(message.and_then(rule), own, "{sets:?}");
                    assert!(map["beta0_deg"][j][k].is_null(), "{sets:?}");
                }
            }
        }
    }
    assert_eq!(refusals, 5);
    let turned = good(&over(
        &case,
        ("raceway.contact_angle_deg", &[0.0, 15.0]),
        ("raceway.half_angle_deg", &[25.2]),
    ));
    assert_eq!(turned["refused"][0], json!([null, null]));
    // Under a radial load a section turned by 15° keeps less of the lag than one that is not.
    let lag = turned["margins"]["lag"][0][1].as_f64().unwrap();
    assert!(lag < -0.5, "{lag}");
    assert_eq!(turned["margins"]["stress"][0][1], Value::Null);
    let unknown = good(&over(
        &case,
        ("raceway.width_mm", &[1.0, 2.0]),
        ("raceway.depth_um", &[0.0]),
    ));
    let said = unknown["refused"][0][0].as_str().unwrap();
    assert!(said.contains("raceway.width_mm"), "{said}");
}

/// The estimate of each raceway is that of the request for its own case.
#[test]
fn a_map_has_the_estimates_of_its_points() {
    let (spans, angles) = ([3.0, 5.1, 9.0], [20.0, 25.2, 89.5]);
    let conventional = template(true);
    let oil = "\n[film]\nviscosity_mpa_s = 20\nviscosity_temperature_1_k = 0.035\nsupply = 1\n";
    for (case, film) in [
        (structure(5.1, 25.2), ""),
        (conventional, ""),
        (structure(5.1, 25.2), oil),
    ] {
        let (case, structure) = (case + film, |mm, deg| structure(mm, deg) + film);
        let map = good(&over_structures(&case, &spans, &angles));
        for (j, angle) in angles.into_iter().enumerate() {
            for (k, span) in spans.into_iter().enumerate() {
                let own = ask(&json!({ "op": "geometry", "case": structure(span, angle) }));
                if own["ok"].is_null() {
                    assert!(map["beta0_deg"][j][k].is_null(), "{span} {angle}");
                    assert!(map["margins"]["stress"][j][k].is_null(), "{span} {angle}");
                    continue;
                }
                assert_eq!(map["beta0_deg"][j][k], own["ok"]["numbers"]["beta0_deg"]);
                for term in own["ok"]["estimate"]["terms"].as_array().unwrap() {
                    let rows = &map["margins"][term["name"].as_str().unwrap()];
                    assert_eq!(rows[j][k], term["margin"], "{span} {angle} {term}");
                }
            }
        }
        let outweighs = map["margins"]["film-outweighs"][1][1].as_f64();
        assert_eq!(
            outweighs.is_some_and(|margin| margin < 0.1),
            !film.is_empty()
        );
        assert!(map["beta0_deg"][1][2].is_null(), "9 mm is beyond Eq. (8)");
        let limit = map["possible"][1][0][1].as_f64().unwrap();
        assert!((7.39..7.4018).contains(&limit), "{limit}");
        assert_eq!(
            map["possible"][2],
            json!([]),
            "89.5° takes up half of the ring"
        );
    }
    let case = template(false);
    let many = (0..1000).map(f64::from).collect::<Vec<_>>();
    for (spans, angles) in [
        (&many[..], &many[..]),
        (&many[..1], &many[..]),
        (&[2.0, 1.0], &[1.0]),
    ] {
        refused(&over_structures(&case, spans, angles));
    }
}

#[test]
fn every_material_with_a_name_makes_a_case() {
    let about = good(&json!({ "op": "about" }));
    let materials = about["materials"].as_array().unwrap();
    assert!(materials.len() >= 5);
    for material in materials {
        let name = material["name"].as_str().unwrap();
        let case = format!("{}\n[ball_material]\npreset = {name:?}\n", template(false));
        let document = good(&json!({ "op": "geometry", "case": case }))["document"].clone();
        assert_eq!(document["ball_material"]["preset"], name);
    }
}

/// A case of `cases/`.
fn shipped(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases");
    std::fs::read_to_string(format!("{folder}/{name}.toml")).expect("a case")
}

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn a_rotor_falls_freely_and_then_spins_the_ring_up() {
    let case = shipped("touchdown-d");
    let g = good(&json!({ "op": "geometry", "case": case }));
    assert!((number(&g["rotor"]["radial_clearance_um"]) - 200.0).abs() < 1e-9);
    assert!((number(&g["rotor"]["weight_n"]) - 20.0 * 9.81).abs() < 1.0);
    assert_eq!(g["static"], json!({}), "no equilibrium at rest");
    let stretch = |duration_s: f64, frames: usize, resume: &Value| {
        let mut request = json!({
            "op": "motion", "case": case, "duration_s": duration_s, "frames": frames,
        });
        if !resume.is_null() {
            request["resume"] = resume.clone();
        }
        good(&request)
    };
    let last = |part: &Value| part["frames"].as_array().unwrap().last().unwrap()["rotor"].clone();
    let fall = stretch(6e-3, 3, &Value::Null);
    for frame in fall["frames"].as_array().unwrap() {
        let t = number(&frame["t"]);
        let (y, free) = (
            number(&frame["rotor"]["journal_um"][1]),
            -0.5e6 * 9.81 * t * t,
        );
        // The inner ring sags onto its balls by less than a micrometre meanwhile.
        assert!(
            (y - free).abs() < 2.0,
            "{y} µm after {t} s, {free} in free fall"
        );
        assert_eq!(number(&frame["rotor"]["force_n"][0]), 0.0);
    }
    let first = stretch(5e-4, 5, &fall["resume"]);
    let second = stretch(5e-4, 5, &first["resume"]);
    let rotor = last(&second);
    assert!(number(&rotor["force_n"][0]) > 100.0, "{rotor}");
    assert!(
        number(&rotor["speed_rpm"][1]) > 1.0,
        "the ring turns: {rotor}"
    );
    assert!(number(&rotor["speed_rpm"][0]) < 30_000.0, "{rotor}");
    assert!(number(&rotor["housing_um"][1]) < 0.0, "{rotor}");
    // As one run of the whole time, but for the multistep method that starts anew.
    let whole = last(&stretch(7e-3, 7, &Value::Null));
    for name in ["journal_um", "speed_rpm", "housing_um"] {
        for k in 0..2 {
            let (a, b) = (number(&rotor[name][k]), number(&whole[name][k]));
            assert!(
                (a - b).abs() < 1e-3 * b.abs().max(1.0),
                "{name}: {a} and {b}"
            );
        }
    }
    // Where a motion without a rotor ended no drop goes on.
    let other = good(&json!({
        "op": "motion", "case": structure(5.1, 25.2), "duration_s": 1e-4, "frames": 1,
    }));
    let error = refused(&json!({
        "op": "motion", "case": case, "duration_s": 1e-4, "frames": 1, "resume": other["resume"],
    }));
    let message = error["message"].as_str().unwrap();
    assert!(message.starts_with("resume is not"), "{message}");
}

#[test]
fn the_rotor_that_a_page_adds_is_that_of_the_shipped_case() {
    let about = good(&json!({ "op": "about" }));
    let shipped = shipped("touchdown-d");
    let (head, rest) = shipped.split_once("[rotor]").expect("a rotor");
    let (_, solver) = rest.split_once("[solver]").expect("a solver");
    let own = format!(
        "{head}{}\n[solver]{solver}",
        about["drop"].as_str().unwrap()
    );
    let document = |case: &str| {
        let g = good(&json!({ "op": "geometry", "case": case }));
        [
            &g["document"]["rotor"],
            &g["document"]["support"],
            &g["rotor"],
        ]
        .map(Clone::clone)
    };
    assert_eq!(document(&own), document(&shipped));
    let operations = about["operations"].as_array().unwrap();
    assert!(operations.contains(&"motion".into()) && !operations.contains(&"search".into()));
}

#[test]
fn a_drop_has_no_verdict_and_says_why() {
    let error = refused(&json!({ "op": "verdict", "case": shipped("touchdown-d") }));
    let message = error["message"].as_str().unwrap();
    assert!(message.contains("rotor"), "{message}");
}

#[test]
fn a_rotor_that_cannot_fall_is_refused_with_its_key() {
    let case =
        shipped("touchdown-d").replace("radial_clearance_um = 200.0", "radial_clearance_um = -1.0");
    for op in ["geometry", "motion"] {
        let mut request = json!({ "op": op, "case": case });
        if op == "motion" {
            request["duration_s"] = json!(1e-4);
            request["frames"] = json!(1);
        }
        let error = refused(&request);
        assert_eq!(error["key"], "rotor.radial_clearance_um", "{error}");
    }
}

/// The speed of a table goes on over the stretches.
#[test]
fn a_run_up_goes_on_in_the_next_stretch() {
    let case = structure(5.1, 25.2);
    let speed = case
        .lines()
        .find(|l| l.starts_with("inner_speed_rpm"))
        .expect("a speed");
    let table = "inner_speed_rpm = [[0.0, 6000.0], [4e-4, 12000.0]]";
    let case = case.replace(speed, table);
    let stretch = |duration_s: f64, resume: &Value| {
        let mut request =
            json!({ "op": "motion", "case": case, "duration_s": duration_s, "frames": 2 });
        if !resume.is_null() {
            request["resume"] = resume.clone();
        }
        good(&request)
    };
    let first = stretch(2e-4, &Value::Null);
    let parts = stretch(2e-4, &first["resume"]);
    let whole = stretch(4e-4, &Value::Null);
    for k in 0..14 {
        let angle = |part: &Value| {
            number(&part["frames"].as_array().unwrap().last().unwrap()["angle_deg"][k])
        };
        let (a, b) = (angle(&parts), angle(&whole));
        assert!((a - b).abs() < 2e-5, "{a} and {b}");
    }
}

/// From the same uneven starts the raceway of the paper evens out the gaps: the numbers are those
/// of the starts run one by one.
#[test]
fn a_case_is_compared_from_the_same_uneven_starts() {
    use cageless::simulation::run;
    use cageless::summary::SummaryRecorder;
    use cageless_io::case_file::CaseFile;

    let case = structure(5.1, 25.2);
    let conventional = template(true);
    let found = good(&json!({ "op": "compare", "case": case, "reference": conventional }));
    let scatter = &found["results"]["gap_deviation_deg"];
    assert_eq!(scatter["change"], "lower", "{found}");
    assert_eq!(found["only_the_raceway_differs"], true);
    let file = CaseFile::parse(&case, "case", &[]).unwrap();
    let mut sum = 0.0;
    for start in 0..8 {
        let started = file
            .with_uneven_start(file.particulars().seed, start)
            .unwrap();
        let mut case = started.case().clone();
        case.solver.duration_s = 18.0 * case.rolling_orbit_s();
        let mut recorder = SummaryRecorder::new();
        run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
        sum += recorder.summary().unwrap().gap_deviation_rad.to_degrees();
    }
    let mean = scatter["values"][1]["mean"].as_f64().unwrap();
    assert!((mean - sum / 8.0).abs() < 1e-12, "{mean} {}", sum / 8.0);
    let refused =
        refused(&json!({ "op": "compare", "case": case, "reference": shipped("touchdown-d") }));
    assert!(refused["message"].as_str().unwrap().contains("rotor"));
}
