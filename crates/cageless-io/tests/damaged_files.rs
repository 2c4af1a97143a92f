//! Case files, rotor files, plans, journals and tables with random damage are read or refused, never more:
//! a short run, always the same, of what the targets of `fuzz/` look at for as long as they are left.

use std::fs;

use cageless::linear_rotor::{DMatrix, RotorMatrices};
use cageless_io::case_file::template;
use cageless_io::journal::Journal;
use cageless_io::results::{Column, ColumnKind, TableWriter};
use cageless_io::rotor_file::{read_matrices, write_matrices};
use cageless_results::Cell;

/// xorshift64*.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % limit.max(1)
    }
}

/// What TOML and JSON and numbers are made of.
const TOKENS: [&str; 16] = [
    "=", "[", "]", "[[", "\"", "\n", "#", "nan", "-1", "0", "1e308", "inf", "true", "{}", ".", "é",
];

/// `bytes` with one to four changes.
fn damaged(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        let end = (at + 1 + random.below(40)).min(bytes.len());
        match random.below(7) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..end)),
            2 => {
                let copy = bytes[at..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, copy);
            }
            3 => {
                let token = TOKENS[random.below(TOKENS.len())];
                bytes.splice(at..end.min(at + random.below(8)), token.bytes());
            }
            4 => {
                if let Some(digit) = bytes[at..].iter_mut().find(|b| b.is_ascii_digit()) {
                    *digit = b'0' + random.below(10) as u8;
                }
            }
            5 => {
                // A line leaves its place.
                let mut lines: Vec<&[u8]> = bytes.split_inclusive(|&b| b == b'\n').collect();
                let line = lines.remove(random.below(lines.len()));
                lines.insert(random.below(lines.len() + 1), line);
                bytes = lines.concat();
            }
            _ => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
        }
        if bytes.is_empty() {
            break;
        }
    }
    bytes
}

/// Reads `count` damaged copies; a panic leaves the copy that caused it in the message.
fn try_damage(original: &[u8], count: u64, read: impl Fn(&[u8])) {
    struct Report<'a>(&'a [u8]);
    impl Drop for Report<'_> {
        fn drop(&mut self) {
            if std::thread::panicking() {
                eprintln!("while reading:\n{}", String::from_utf8_lossy(self.0));
            }
        }
    }
    read(original);
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    for _ in 0..count {
        let copy = damaged(original, &mut random);
        let _report = Report(&copy);
        read(&copy);
    }
}

/// The template with its comments opened: every key is there.
fn every_key() -> String {
    let text = template(false);
    let lines = text.lines().map(|line| {
        line.strip_prefix("# ")
            .filter(|rest| rest.starts_with('[') || rest.contains(" = "))
            .unwrap_or(line)
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn case_files() {
    try_damage(template(false).as_bytes(), 1500, crate::fuzz_entries::case);
    try_damage(every_key().as_bytes(), 500, crate::fuzz_entries::case);
}

#[test]
fn rotor_files() {
    let dir = tempfile::tempdir().unwrap();
    crate::fuzz_entries::prepare_rotor(dir.path());
    let rotor = include_str!("../../../cases/rotors/two-bearings.toml")
        .replace("../touchdown-d.toml", "base.toml")
        .replace("../touchdown-conventional.toml", "base.toml");
    try_damage(rotor.as_bytes(), 500, |bytes| {
        crate::fuzz_entries::rotor(bytes, dir.path());
    });
}

#[test]
fn matrices_of_rotors() {
    let dir = tempfile::tempdir().unwrap();
    crate::fuzz_entries::prepare_rotor(dir.path());
    // Two masses on a shaft, every node x, y, α, β, one of them on a housing, x, y, with some fluid.
    let matrix = |value: fn(usize, usize) -> f64| DMatrix::from_fn(10, 10, value);
    let rotor = RotorMatrices {
        mass: matrix(|i, j| {
            if i == j {
                [5.0, 5.0, 0.1, 0.1][i % 4]
            } else {
                0.0
            }
        }),
        added_mass: matrix(|i, j| if i == j && i < 2 { 0.5 } else { 0.0 }),
        damping: matrix(|_, _| 0.0),
        gyroscopic: matrix(|i, j| match (i, j) {
            (2, 3) | (6, 7) => 0.01,
            (3, 2) | (7, 6) => -0.01,
            _ => 0.0,
        }),
        stiffness: matrix(|i, j| {
            if i == j {
                1e6
            } else if i % 4 == j % 4 {
                -4e5
            } else {
                0.0
            }
        }),
        spin_up: matrix(|_, _| 0.0),
        housings: 1,
        polar_inertia_kg_m2: 0.02,
    };
    let path = dir.path().join("whole.json");
    write_matrices(&path, &rotor).unwrap();
    assert_eq!(read_matrices(&path).unwrap(), rotor);
    try_damage(&fs::read(&path).unwrap(), 500, |bytes| {
        crate::fuzz_entries::matrices(bytes, dir.path());
    });
}

#[test]
fn plans() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("base.toml"), template(false)).unwrap();
    let plan = r#"
schema = 1
title = "a plan"
seed = 1
case = "base.toml"
compute = ["static", "design", "run"]

[set]
solver.duration_s = 0.05

[grid]
raceway.axial_span_mm = { from = 4.95, to = 5.35, count = 5 }
operation.radial_load_n = [500.0, 1500.0]

[scatter]
repeats = 10
start.gaps = "random"
"#;
    try_damage(plan.as_bytes(), 500, |bytes| {
        crate::fuzz_entries::plan(bytes, dir.path());
    });
}

#[test]
fn journals() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("whole.journal");
    let owner = "a search\n[bearing]\nballs = 14";
    let (mut journal, _) = Journal::open(&path, owner).unwrap();
    for k in 0..20 {
        let outcome = match k % 5 {
            0 => Err(format!("failure {k}")),
            _ => Ok(vec![f64::from(k), f64::NAN, -0.0]),
        };
        journal.add(&format!("piece {k}"), &outcome).unwrap();
    }
    drop(journal);
    let bytes = fs::read(&path).unwrap();
    try_damage(&bytes, 500, |bytes| {
        crate::fuzz_entries::journal(bytes, owner, dir.path());
    });
}

#[test]
fn tables() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("whole.parquet");
    let column = |name: &str, kind| Column {
        name: name.to_owned().into(),
        unit: "".into(),
        kind,
    };
    let columns = [
        column("variant", ColumnKind::Index),
        column("load_n", ColumnKind::Number),
        column("name", ColumnKind::Text),
        column("gaps_deg", ColumnKind::Numbers),
    ];
    let mut writer = TableWriter::create(&path, &columns, &[]).unwrap();
    for k in 0..50 {
        let numbers = (0..k % 4).map(|j| j as f64).collect();
        let row = vec![
            Cell::Integer(k),
            Cell::Number(k as f64 / 7.0),
            Cell::Text(format!("row {k}")),
            Cell::Numbers(numbers),
        ];
        writer.push(row).unwrap();
    }
    writer.finish().unwrap();
    let bytes = fs::read(&path).unwrap();
    try_damage(&bytes, 500, |bytes| {
        crate::fuzz_entries::table(bytes, dir.path());
    });
}
