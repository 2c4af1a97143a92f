//! Running the binary and looking at what it leaves.
#![allow(dead_code, reason = "each test uses its own part")]

pub mod studio;

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use serde_json::Value;

/// The binary under test.
pub fn cageless() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cageless"));
    command.stdin(Stdio::null()).env_remove("RUST_BACKTRACE");
    // The date of files that have one.
    command.env("SOURCE_DATE_EPOCH", "951782400");
    command
}

/// The binary where no file may grow beyond a size, as on a disk that is full.
#[cfg(unix)]
pub fn on_full_disk(kilobytes: u32) -> Command {
    let mut command = Command::new("bash");
    let limited = format!("trap '' XFSZ; ulimit -f {kilobytes}; exec \"$@\"");
    command.args(["-c", &limited, "bash", env!("CARGO_BIN_EXE_cageless")]);
    command.stdin(Stdio::null()).env_remove("RUST_BACKTRACE");
    command
}

/// The binary where no thread can be started, as under a limit of processes; root has no limit.
#[cfg(target_os = "linux")]
pub fn without_threads() -> Command {
    let mut command = Command::new("bash");
    let limited = "user=(); ((EUID)) || user=(setpriv --reuid=65534 --regid=65534 --clear-groups); \
                   exec \"${user[@]}\" bash -c 'ulimit -u 1; exec \"$@\"' bash \"$@\"";
    command.args(["-c", limited, "bash", env!("CARGO_BIN_EXE_cageless")]);
    command.stdin(Stdio::null()).env_remove("RUST_BACKTRACE");
    command
}

/// One of the cases of the repository.
pub fn repository_case(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../cases")
        .join(name)
}

/// Result of one call.
#[derive(Debug)]
pub struct Answer {
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Answer {
    /// stdout as one JSON document: nothing before it, nothing after it.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout)
            .unwrap_or_else(|e| panic!("not one JSON document: {e}\n{}", self.stdout))
    }
}

/// Starts of lines that depend on how busy the machine is.
const BUSY: [&str; 3] = ["progress: ", "estimate: ", "takes about "];

impl From<Output> for Answer {
    fn from(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
        Self {
            code: output.status.code(),
            stdout: text(output.stdout),
            // Whether a time is announced and progress is told depends on how busy the machine is.
            stderr: (text(output.stderr).split_inclusive('\n'))
                .filter(|line| !BUSY.iter().any(|start| line.starts_with(start)))
                .collect(),
        }
    }
}

/// Calls the binary with arguments that are text.
pub fn call(args: &[&str]) -> Answer {
    cageless().args(args).output().expect("starts").into()
}

/// Calls the binary on a case file: `command CASE --set … more`.
pub fn call_on(command: &str, case: &Path, sets: &[&str], more: &[&str]) -> Answer {
    let mut process = cageless();
    process.arg(command).arg(case);
    for set in sets {
        process.args(["--set", set]);
    }
    process.args(more).output().expect("starts").into()
}

/// Keys of a JSON object.
pub fn keys(value: &Value) -> Vec<&str> {
    let object = value.as_object().expect("an object");
    object.keys().map(String::as_str).collect()
}

/// Names of everything in a folder, sorted.
pub fn names(dir: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(dir)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Everything that `run --out` leaves.
pub const RUN_FILES: [&str; 6] = [
    "balls.parquet",
    "collisions.parquet",
    "report.html",
    "report.json",
    "ring.parquet",
    "summary.json",
];

/// A JSON file.
pub fn json_file(path: &Path) -> Value {
    let text = std::fs::read_to_string(path).expect("a readable file");
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// A table read back: the names of its columns and its rows.
pub fn table(path: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let file = File::open(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let reader =
        SerializedFileReader::new(file).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let schema = reader.metadata().file_metadata().schema_descr();
    let columns = schema
        .columns()
        .iter()
        .map(|c| c.name().to_owned())
        .collect();
    let rows = reader
        .get_row_iter(None)
        .expect("rows")
        .map(|row| {
            row.expect("a row")
                .get_column_iter()
                .map(|(name, field)| match field {
                    Field::Double(value) => *value,
                    Field::Int(value) => f64::from(*value),
                    other => panic!("{name}: {other:?}"),
                })
                .collect()
        })
        .collect();
    (columns, rows)
}

/// A row of a table as JSON, by its columns.
pub fn row(path: &Path, index: usize) -> Value {
    let file = File::open(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let reader = SerializedFileReader::new(file).expect("a table");
    let mut rows = reader.get_row_iter(None).expect("rows");
    let row = rows
        .nth(index)
        .expect("a row")
        .expect("a row that can be read");
    let cells = row.get_column_iter().map(|(name, field)| {
        let value = match field {
            Field::Null => Value::Null,
            Field::Double(value) => (*value).into(),
            Field::Long(value) => (*value).into(),
            Field::Str(text) => text.as_str().into(),
            other => other.to_string().into(),
        };
        (name.clone(), value)
    });
    Value::Object(cells.collect())
}

/// A search that is soon done: one span, few angles, few runs, long steps.
pub const SMALL: [&str; 6] = [
    "solver.method=verlet",
    "solver.step_us=auto",
    "search.axial_span_mm=5.1",
    "search.half_angle_deg=[24,26]",
    "search.initial_states=1",
    "search.runs_max=32",
];
