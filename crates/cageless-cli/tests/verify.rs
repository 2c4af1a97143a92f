//! `cageless run --verify`.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn verify(case: &str, more: &[&str]) -> Output {
    let case = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../cases")
        .join(case);
    Command::new(env!("CARGO_BIN_EXE_cageless"))
        .arg("run")
        .arg(case)
        .arg("--verify")
        .args(more)
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// A verdict and a reason for each number, in the table, `summary.json` and on the page.
#[test]
fn a_verified_run_says_what_it_is_worth() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().to_str().unwrap();
    let output = verify(
        "zhao-d.toml",
        &["--set", "solver.duration_s=0.02", "--out", out],
    );
    assert!(output.status.success(), "{output:?}");
    let printed = text(&output.stdout);
    assert!(printed.contains("converged results"), "{printed}");
    // The run is shorter than an orbit after its transient.
    assert_eq!(printed.matches("warning").count(), 1, "{printed}");
    assert!(printed.contains("warning: the run ends within an orbit"));
    let json: Value =
        serde_json::from_slice(&std::fs::read(dir.path().join("summary.json")).unwrap()).unwrap();
    let verification = &json["verification"];
    for key in [
        "collisions",
        "gap_min_deg",
        "gap_max_deg",
        "ring_x_mean_um",
        "ring_y_mean_um",
        "sliding_max_m_s",
    ] {
        let number = &verification["numbers"][key];
        assert_eq!(number["value"].as_f64(), json[key].as_f64(), "{key}");
        assert_eq!(number["verdict"], "converged", "{key}");
        assert!(number["reason"].as_str().unwrap().contains("changes by"));
    }
    // The table has the unit of the results above it, the file its own.
    let line = |text: &&str| {
        text.trim_start()
            .starts_with("orbital speed of the balls, mean")
    };
    let speeds: Vec<&str> = printed.lines().filter(line).collect();
    let value = |line: &str| line.split_whitespace().nth(5).map(str::to_owned);
    assert_eq!(speeds.len(), 2, "{printed}");
    assert_eq!(value(speeds[0]), value(speeds[1]));
    assert!(
        speeds.iter().all(|line| line.contains(" rpm")),
        "{speeds:?}"
    );
    let speed = &verification["numbers"]["orbit_speed_rad_s_mean"];
    assert_eq!(speed["unit"], "rad/s");
    assert!(verification["predictability_time_s"].is_null());
    let page = std::fs::read_to_string(dir.path().join("report.html")).unwrap();
    assert!(page.contains("angular position ψ of ball 1 at the end"));
    assert!(page.contains("the run does not diverge"));
}

/// A biased number is no failure, but it is said.
#[test]
fn a_biased_run_ends_well_with_a_warning() {
    let set = [
        "--json",
        "--set",
        "solver.step_us=1.0",
        "--set",
        "solver.duration_s=0.2",
        "--set",
        "start.ring_y_um=-10.0",
    ];
    let output = verify("cb74.toml", &set);
    assert!(output.status.success(), "{output:?}");
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    let warnings = json["warnings"].to_string();
    assert!(warnings.contains("ring_y_mean_um"), "{warnings}");
    let y = &json["verification"]["numbers"]["ring_y_mean_um"];
    assert_eq!(y["verdict"], "step-biased", "{y}");
}

/// Without `--verify` nothing is repeated and nothing claimed.
#[test]
fn only_on_request() {
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/zhao-d.toml");
    let output = Command::new(env!("CARGO_BIN_EXE_cageless"))
        .args(["run", "--json", "--set", "solver.duration_s=0.001"])
        .arg(case)
        .output()
        .unwrap();
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(json.get("verification").is_none());
}
