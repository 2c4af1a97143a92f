//! What `cageless studio` computes beyond the engine in the page: search, tolerance, export.
#![cfg(unix)]

use std::io::Read;
use std::time::{Duration, Instant};

use crate::common::repository_case;
use crate::common::studio::Studio;
use base64::Engine as _;
use serde_json::{Value, json};

fn case(name: &str) -> String {
    std::fs::read_to_string(repository_case(name)).expect("a case")
}

/// The last line of an answer, which is the result.
fn result(studio: &Studio, request: &Value) -> Value {
    let answer = studio.ask(&request.to_string());
    let last = answer
        .lines()
        .rfind(|line| line.starts_with('{') && !line.contains("progress"));
    serde_json::from_str(last.unwrap_or_else(|| panic!("{answer}"))).expect("JSON")
}

fn good(studio: &Studio, request: &Value) -> Value {
    let answer = result(studio, request);
    assert!(answer["error"].is_null(), "{answer}");
    answer["ok"].clone()
}

/// A search that is soon done: one span, few angles, few runs.
fn search() -> Value {
    let small = "\n[search]\naxial_span_mm = 5.1\nhalf_angle_deg = [24.0, 26.0]\nstarts = 1\n";
    let case = case("zhao-d.toml").replace("step_us = 1.0 ", "step_us = 2.5 ");
    json!({ "op": "search", "case": case + small, "budget": 32 })
}

#[test]
fn the_server_names_what_it_can_do_beyond_the_page() {
    let studio = Studio::start();
    let about = good(&studio, &json!({ "op": "about" }));
    let operations = about["operations"].as_array().unwrap();
    for name in ["geometry", "motion", "search", "tolerance", "export"] {
        assert!(operations.contains(&name.into()), "{name}: {about}");
    }
    assert_eq!(about["tolerances"]["samples"], 200);
    assert_eq!(about["runs_max"], 400);
}

#[test]
fn a_search_answers_with_a_front_and_progress() {
    let studio = Studio::start();
    let answer = studio.ask(&search().to_string());
    assert!(answer.contains("{\"progress\":0."), "{answer}");
    let last = answer.lines().rfind(|line| line.starts_with("{\"ok\""));
    let last = last.unwrap_or_else(|| panic!("{answer}"));
    let found: Value = serde_json::from_str(last).expect("JSON");
    let found = &found["ok"];
    let front = found["front"].as_array().unwrap();
    assert!(!front.is_empty(), "{found}");
    for structure in front {
        let [span, angle] = ["axial_span_mm", "half_angle_deg"]
            .map(|name| structure[name].as_f64().expect("a number"));
        assert!((span - 5.1).abs() < 1e-9 && (24.0..=26.0).contains(&angle));
        assert!(structure["points"][0]["motion"]["collisions"].is_number());
    }
    assert!(found["recommended"]["axial_span_mm"].is_number(), "{found}");
    assert!(found["none"].is_null());
    assert_eq!(found["verdicts"][0]["passes"], true);
}

#[test]
fn tolerances_are_judged() {
    let studio = Studio::start();
    let tolerances = json!({
        "samples": 2, "axial_span_um": 0.0, "half_angle_deg": 0.0, "friction": 0.0,
        "clearance_um": 0.0, "speed_percent": 0.0, "load_percent": 0.0,
    });
    // A step as long as the contacts allow.
    let case = case("zhao-d.toml")
        .replace("method = \"abm4\"", "method = \"verlet\"")
        .replace("step_us = 1.0", "step_us = \"auto\"");
    let request = json!({ "op": "tolerance", "case": case, "tolerances": tolerances });
    let judged = good(&studio, &request);
    let names: Vec<_> = (judged["influences"].as_array().unwrap().iter())
        .map(|row| row["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["groove depth", "ball radii"]);
    assert_eq!(judged["samples"]["count"], 2);
    assert_eq!(judged["nominal_passes"], true);
}

#[test]
fn the_ring_is_exported_as_the_command_does() {
    let studio = Studio::start();
    let case = case("full-6205.toml");
    let export = |format: &str| {
        good(
            &studio,
            &json!({ "op": "export", "case": case, "format": format }),
        )
    };
    let step = export("step");
    assert_eq!(step["name"], "outer_ring.step");
    assert!(step["text"].as_str().unwrap().starts_with("ISO-10303-21;"));
    let csv = export("csv");
    assert!(csv["text"].as_str().unwrap().lines().count() > 1000);
    let stl = export("stl");
    let bytes = base64::engine::general_purpose::STANDARD
        .decode(stl["base64"].as_str().unwrap())
        .expect("base64");
    let triangles = u32::from_le_bytes(bytes[80..84].try_into().unwrap());
    assert_eq!(bytes.len(), 84 + 50 * triangles as usize);
    let volume = |answer: &Value| answer["numbers"]["volume_mm3"].as_f64().unwrap();
    assert!(volume(&step) > 1000.0 && (volume(&step) - volume(&stl)).abs() < 1e-3);
}

#[test]
fn bad_requests_are_refused_by_name() {
    let studio = Studio::start();
    let (d, drop) = (case("zhao-d.toml"), case("touchdown-d.toml"));
    for (request, part) in [
        (
            json!({ "op": "search", "case": d, "budget": 0 }),
            "search.runs_max",
        ),
        (
            json!({ "op": "search", "case": d, "budget": -1 }),
            "cannot be read",
        ),
        (
            json!({ "op": "search", "case": d, "folder": "/tmp" }),
            "folder",
        ),
        (json!({ "op": "search", "case": drop }), "rotor"),
        (json!({ "op": "search", "case": "balls = 3" }), "balls"),
        (json!({ "op": "tolerance", "case": drop }), "rotor"),
        (
            json!({ "op": "tolerance", "case": d, "tolerances": { "samples": 1_000_000 } }),
            "samples 1000000",
        ),
        (
            json!({ "op": "tolerance", "case": d, "tolerances": { "ball_grade": 4 } }),
            "ball_grade 4",
        ),
        (
            json!({ "op": "tolerance", "case": d, "tolerances": { "sample": 4 } }),
            "sample",
        ),
        (
            json!({ "op": "tolerance", "case": case("conventional.toml") }),
            "[raceway]",
        ),
        (json!({ "op": "export", "case": d, "format": "obj" }), "obj"),
        (
            json!({ "op": "export", "case": d, "format": "step" }),
            "outer_ring_",
        ),
    ] {
        let error = result(&studio, &request)["error"].clone();
        let message = error["message"].as_str().unwrap_or_default();
        assert!(message.contains(part), "{request} says {error}");
    }
    studio.lives();
}

/// Nobody waits for them any longer: they make room for others.
#[test]
fn searches_of_pages_that_are_closed_end() {
    let studio = Studio::start();
    let request = json!({ "op": "search", "case": case("zhao-d.toml") }).to_string();
    let mut open: Vec<_> = (0..8).map(|_| studio.begin(&request)).collect();
    for stream in &mut open {
        let mut status = [0; 12];
        stream.read_exact(&mut status).expect("an answer begins");
        assert_eq!(&status, b"HTTP/1.1 200");
    }
    let about = r#"{"op":"about"}"#;
    let until = |status: &str| {
        let patience = Instant::now();
        loop {
            let answer = studio.ask(about);
            if answer.starts_with(&format!("HTTP/1.1 {status}")) {
                break;
            }
            let waited = patience.elapsed();
            assert!(waited < Duration::from_secs(60), "never {status}: {answer}");
            std::thread::sleep(Duration::from_millis(50));
        }
    };
    until("503");
    drop(open);
    until("200");
}
