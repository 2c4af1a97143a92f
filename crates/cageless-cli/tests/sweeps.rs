//! A sweep yields the same file after any interruption.
#![cfg(unix)]

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

use crate::common::*;

/// A plan that is quickly computed, `grid` apart.
fn write_plan(dir: &Path, grid: &str) -> PathBuf {
    let path = dir.join("plan.toml");
    let case = repository_case("zhao-d.toml");
    let text = format!(
        "case = {case:?}\nseed = 3\ncompute = [\"static\", \"design\"]\n\
         keep = [\"static_ring_y_um\", \"static_inner_force_n\", \"design_half_angle_for_span_deg\"]\n\
         {grid}"
    );
    std::fs::write(&path, text).unwrap();
    path
}

/// 600 variants of several milliseconds, of all kinds of axes; some fail.
const GRID: &str = "\
[grid]
raceway.axial_span_mm = { from = 4.9, to = 5.5, count = 5 }
model.formulation = [\"physical\", \"paper\"]
[samples]
method = \"latin-hypercube\"
count = 20
raceway.half_angle_deg = { from = 12.0, to = 85.0 }
operation.radial_load_n = { from = 100.0, to = 5000.0, scale = \"log\" }
[scatter]
repeats = 3
start.gaps = { uniform = 0.5 }
";

fn sweep(plan: &Path, out: &Path, more: &[&str]) -> Command {
    let mut command = cageless();
    command.arg("sweep").arg(plan).arg("--out").arg(out);
    command
        .args(more)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

fn call_sweep(plan: &Path, out: &Path, more: &[&str]) -> Answer {
    sweep(plan, out, more).output().expect("starts").into()
}

fn result(out: &Path) -> Vec<u8> {
    assert_eq!(names(out), ["sweep.parquet"]);
    std::fs::read(out.join("sweep.parquet")).unwrap()
}

fn whole(plan: &Path, out: &Path, more: &[&str]) -> Vec<u8> {
    let answer = call_sweep(plan, out, more);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    result(out)
}

/// Tables of rows that wait in the work folder.
fn tables(out: &Path) -> usize {
    let parts = out.join("sweep.parquet.parts");
    let is_table = |name: &String| name.starts_with("rows-");
    match parts.exists() {
        true => names(&parts).iter().filter(|n| is_table(n)).count(),
        false => 0,
    }
}

/// Waits until a checkpoint exists.
fn wait_for_rows(child: &mut Child, out: &Path) {
    let begin = Instant::now();
    while tables(out) == 0 {
        assert!(begin.elapsed() < Duration::from_secs(60), "no rows");
        assert_eq!(child.try_wait().unwrap(), None, "ended at once");
        sleep(Duration::from_millis(5));
    }
}

fn finish(child: Child) -> Answer {
    child.wait_with_output().unwrap().into()
}

#[test]
fn ten_kills_leave_the_file_of_an_undisturbed_sweep() {
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), GRID);
    let undisturbed = whole(&plan, &dir.path().join("calm"), &[]);
    let out = dir.path().join("killed");
    let (mut moments, mut unfinished) = (Vec::new(), 0);
    for k in 0..10 {
        let mut child = sweep(&plan, &out, &[]).spawn().expect("starts");
        // Every other one is killed as soon as it has begun, however busy or fast the machine is.
        let begun = k % 2 == 0;
        while begun && tables(&out) == 0 && child.try_wait().unwrap().is_none() {
            sleep(Duration::from_millis(1));
        }
        let now = SystemTime::now()
            .duration_since(SystemTime::UNIX_EPOCH)
            .unwrap();
        let moment = match begun {
            true => Duration::ZERO,
            false => Duration::from_millis(u64::from(now.subsec_nanos()) / 1000 % 200),
        };
        moments.push(moment);
        sleep(moment);
        child.kill().unwrap();
        child.wait().unwrap();
        unfinished += usize::from(tables(&out) > 0);
    }
    assert!(unfinished > 0, "nobody was killed midway: {moments:?}");
    assert!(whole(&plan, &out, &[]) == undisturbed, "{moments:?}");
    // Again: there is nothing to do, and nothing changes.
    assert!(whole(&plan, &out, &[]) == undisturbed);
}

#[test]
fn threads_and_shards_do_not_change_a_byte() {
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), GRID);
    let one = whole(&plan, &dir.path().join("one"), &["--threads", "1"]);
    assert!(whole(&plan, &dir.path().join("three"), &["--threads", "3"]) == one);

    let out = dir.path().join("shards");
    for shard in ["2/3", "1/3", "3/3"] {
        let answer = call_sweep(&plan, &out, &["--shard", shard]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
    }
    let shard = |k: usize| out.join(format!("sweep.shard-{k}-of-3.parquet"));
    let merge = |shards: &[usize], to: &Path| -> Answer {
        let shards: Vec<_> = shards.iter().map(|k| shard(*k)).collect();
        let mut command = cageless();
        command
            .args(["sweep", "merge"])
            .args(shards)
            .arg("--out")
            .arg(to);
        command.output().expect("starts").into()
    };
    let merged = dir.path().join("merged");
    let answer = merge(&[3, 1, 2], &merged);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    assert!(result(&merged) == one);

    // The report of a shard is one of a part, and never replaces that of the whole.
    let report = |more: &[&str]| {
        let one = shard(1);
        call(&[&["report", one.to_str().unwrap(), "--json"][..], more].concat())
    };
    let answer = report(&[]);
    let said = answer.json()["warnings"][0].to_string();
    assert!(said.contains("200 of 600 variants, shard 1/3"), "{said}");
    assert_eq!(merge(&[1, 2, 3], &out).code, Some(0));
    let answer = report(&[]);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    assert!(answer.stderr.contains("is a shard of "), "{answer:?}");
    let elsewhere = dir.path().join("part");
    assert_eq!(
        report(&["--out", elsewhere.to_str().unwrap()]).code,
        Some(0)
    );

    let answer = merge(&[1, 3], &dir.path().join("lacking"));
    assert_eq!(answer.code, Some(2));
    let message = "200 of 600 variants are missing: 200 to 399";
    assert!(answer.stderr.contains(message), "{answer:?}");
    let answer = merge(&[1, 2, 3, 2], &dir.path().join("twice"));
    assert_eq!(answer.code, Some(2));
    assert!(
        answer.stderr.contains("variant 200 is in another shard"),
        "{answer:?}"
    );
    assert_eq!(call_sweep(&plan, &out, &["--shard", "4/3"]).code, Some(2));
    let answer = call_sweep(&plan, &out, &["--threads", "1025"]);
    assert_eq!(answer.code, Some(2));
    assert!(answer.stderr.contains("1 to 1024"), "{}", answer.stderr);
}

#[test]
fn an_interrupt_keeps_what_was_computed() {
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), GRID);
    let undisturbed = whole(&plan, &dir.path().join("calm"), &[]);
    let out = dir.path().join("interrupted");
    let mut child = sweep(&plan, &out, &["--threads", "1"])
        .spawn()
        .expect("starts");
    wait_for_rows(&mut child, &out);
    let status = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(status.unwrap().success());
    let answer = finish(child);
    assert_eq!(answer.code, Some(1), "{answer:?}");
    assert!(
        answer.stderr.contains("the same command resumes"),
        "{answer:?}"
    );
    assert!(!out.join("sweep.parquet").exists());

    // Another plan may not resume it; the message names the difference.
    let changed = GRID.replace("count = 20", "count = 21");
    let plan = write_plan(dir.path(), &changed);
    let answer = call_sweep(&plan, &out, &[]);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    assert!(
        answer.stderr.contains("samples.count was 20, is 21"),
        "{answer:?}"
    );

    let plan = write_plan(dir.path(), GRID);
    assert!(whole(&plan, &out, &[]) == undisturbed);
    let plan = write_plan(dir.path(), &GRID.replace("\"paper\"", "\"physical\""));
    let answer = call_sweep(&plan, &out, &[]);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    assert!(
        answer.stderr.contains("grid.model.formulation was"),
        "{answer:?}"
    );
    assert!(result(&out) == undisturbed);
}

/// No file may grow beyond a few kilobytes: to the program, a disk that is full.
#[test]
fn a_full_disk_ends_it_and_more_room_goes_on() {
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), GRID);
    let undisturbed = whole(&plan, &dir.path().join("calm"), &[]);
    let out = dir.path().join("full");
    let mut command = Command::new("bash");
    let limited = "trap '' XFSZ; ulimit -f 16; exec \"$@\"";
    command.args([
        "-c",
        limited,
        "bash",
        env!("CARGO_BIN_EXE_cageless"),
        "sweep",
    ]);
    let answer = Answer::from(command.arg(&plan).arg("--out").arg(&out).output().unwrap());
    assert_eq!(answer.code, Some(1), "{answer:?}");
    assert!(answer.stderr.contains("cannot write"), "{answer:?}");
    assert!(!out.join("sweep.parquet").exists());
    assert!(whole(&plan, &out, &[]) == undisturbed);
}

/// The end of a table is what fails when the rows of a short sweep still wait in memory.
#[test]
fn a_disk_that_is_full_at_the_end_is_said_to_be() {
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), "[grid]\noperation.radial_load_n = [500, 900]\n");
    let mut failed = 0;
    for kilobytes in 2..8 {
        let limited = format!("trap '' XFSZ; ulimit -f {kilobytes}; exec \"$@\"");
        let out = dir.path().join(kilobytes.to_string());
        let mut command = Command::new("bash");
        command.args([
            "-c",
            &limited,
            "bash",
            env!("CARGO_BIN_EXE_cageless"),
            "sweep",
        ]);
        let answer = Answer::from(command.arg(&plan).arg("--out").arg(&out).output().unwrap());
        if answer.code != Some(0) {
            assert_eq!(answer.code, Some(1), "{answer:?}");
            assert!(answer.stderr.contains(": file too large\n"), "{answer:?}");
            failed += 1;
        }
    }
    assert!(failed > 0);
}

/// A path that JSON cannot hold is refused before anything is computed.
#[test]
fn a_folder_that_json_cannot_name_is_refused_first() {
    use std::os::unix::ffi::OsStrExt;
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), "[grid]\noperation.radial_load_n = [500, 900]\n");
    let out = dir.path().join(std::ffi::OsStr::from_bytes(b"out-\xff"));
    let answer = call_sweep(&plan, &out, &["--json"]);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    assert!(answer.stderr.contains("not UTF-8"), "{answer:?}");
    assert!(!out.exists());
    assert_eq!(call_sweep(&plan, &out, &[]).code, Some(0));
}

/// The title is the text that the plan holds, whatever TOML wants before quotes.
#[test]
fn titles_are_shown_as_they_are_meant() {
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), "[grid]\noperation.radial_load_n = [500, 900]\n");
    let text = std::fs::read_to_string(&plan).unwrap();
    std::fs::write(&plan, format!("title = \"Ring \\\"A\\\" \\\\ θ\"\n{text}")).unwrap();
    let out = dir.path().join("out");
    whole(&plan, &out, &[]);
    let report = call(&["report", out.to_str().unwrap(), "--json"]);
    assert_eq!(report.json()["title"], "Ring \"A\" \\ θ", "{report:?}");
}

#[test]
fn a_damaged_part_names_its_remedy() {
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), GRID);
    let out = dir.path().join("out");
    let parts = out.join("sweep.parquet.parts");
    std::fs::create_dir_all(&parts).unwrap();
    let part = parts.join("rows-0000000000.parquet");
    std::fs::write(&part, "PAR1 and no more").unwrap();
    let answer = call_sweep(&plan, &out, &[]);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    let remedy = "rows-0000000000.parquet";
    assert!(answer.stderr.contains(remedy), "{answer:?}");
    assert!(
        answer
            .stderr
            .contains("Remove it, and its variants are computed again"),
        "{answer:?}"
    );
    std::fs::remove_file(&part).unwrap();
    whole(&plan, &out, &[]);
}

/// Rotors that are too heavy for their bearing stop each drop.
#[test]
fn a_sweep_of_failures_is_none() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("touchdown-conventional.toml");
    let plan = dir.path().join("plan.toml");
    let text =
        format!("case = {case:?}\ncompute = [\"drop\"]\n[grid]\nrotor.mass_kg = [20000, 30000]\n");
    std::fs::write(&plan, text).unwrap();
    let out = dir.path().join("out");
    let answer = call_sweep(&plan, &out, &["--json"]);
    assert_eq!(answer.code, Some(3), "{answer:?}");
    assert_eq!(answer.json()["failed"], 2);
    assert!(
        answer.stderr.contains("all 2 variants failed; the first: "),
        "{answer:?}"
    );
    let report = call(&["report", out.to_str().unwrap(), "--json"]);
    let said = report.json()["warnings"][0].to_string();
    assert!(
        said.contains(
            "2 of 2 variants lack results, as a computation failed, the most frequent reason: "
        ),
        "{said}"
    );
}

/// What varies by the rounding of its computation alone is constant.
#[test]
fn rounding_is_not_explained() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let plan = dir.path().join("plan.toml");
    let text = format!(
        "case = {case:?}\ncompute = [\"static\", \"design\"]\n[grid]\n\
         raceway.axial_span_mm = [4.9, 5.0, 5.1, 5.2]\nmodel.formulation = [\"physical\", \"paper\"]\n"
    );
    std::fs::write(&plan, text).unwrap();
    let out = dir.path().join("out");
    whole(&plan, &out, &[]);
    let written = (0..8).map(|k| row(&out.join("sweep.parquet"), k)["static_ring_x_um"].as_f64());
    let largest = written.flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    assert!(largest > 0.0 && largest < 1e-6, "{largest}");
    let report = call(&["report", out.to_str().unwrap(), "--json"]).json();
    let list = |key: &str| report[key].as_array().unwrap().clone();
    let outputs = list("outputs");
    let is_named = |q: &serde_json::Value| q["quantity"]["name"] == "static_ring_x_um";
    assert!(!outputs.is_empty() && !outputs.iter().any(is_named));
    let constants = list("constants");
    let constant = constants.iter().find(|c| c["name"] == "static_ring_x_um");
    assert_eq!(constant.unwrap()["value"], "0");
}

#[test]
fn two_at_once_on_one_result_are_one_too_many() {
    let dir = tempfile::tempdir().unwrap();
    let plan = write_plan(dir.path(), &GRID.replace("count = 20", "count = 20000"));
    let out = dir.path().join("out");
    let mut child = sweep(&plan, &out, &["--threads", "1"])
        .spawn()
        .expect("starts");
    wait_for_rows(&mut child, &out);
    let answer = call_sweep(&plan, &out, &[]);
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(answer.code, Some(2), "{answer:?}");
    assert!(answer.stderr.contains("another process"), "{answer:?}");
}

#[test]
fn rows_are_those_of_the_single_commands() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let plan = dir.path().join("plan.toml");
    let text = format!(
        "case = {case:?}\ncompute = [\"static\", \"run\"]\n[set]\nsolver.duration_s = 0.004\n\
         [grid]\nraceway.half_angle_deg = [24.0, 89.0]\noperation.radial_load_n = [400, 900]\n"
    );
    std::fs::write(&plan, text).unwrap();
    let out = dir.path().join("out");
    let answer = call_sweep(&plan, &out, &["--json"]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let summary = answer.json();
    assert_eq!(
        (&summary["variants"], &summary["failed"]),
        (&4.into(), &2.into())
    );
    let reason = summary["first_reason"].as_str().unwrap();
    assert!(
        reason.starts_with("raceway.half_angle_deg = 89 is not possible"),
        "{reason}"
    );

    let sets = [
        "solver.duration_s=0.004",
        "raceway.half_angle_deg=24",
        "operation.radial_load_n=900",
    ];
    let run = call_on("run", &case, &sets, &["--json"]).json();
    let statics = call_on("static", &case, &sets, &["--json"]).json();
    let row = row(&out.join("sweep.parquet"), 1);
    assert_eq!(row["operation_radial_load_n"], 900.0);
    assert_eq!(row["static_ring_y_um"], statics["ring_y_um"]);
    assert_eq!(row["run_collisions"], run["collisions"]);
    assert_eq!(row["run_sliding_max_m_s"], run["sliding_max_m_s"]);
    assert_eq!(row["run_gap_min_deg"], run["gap_min_deg"]);
    assert!(row["reason"].is_null());
}
