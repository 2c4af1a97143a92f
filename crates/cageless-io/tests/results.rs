//! The files of a run, read back.

use std::collections::BTreeMap;
use std::fs::File;
use std::path::Path;

use cageless::{Collision, RingSnapshot, Snapshot};
use cageless_io::case_file::{CaseFile, template};
use cageless_io::results::{
    Metadata, ResultError, ResultFolder, RunWriter, summary_of_tables, write_atomically,
};
use parquet::basic::{Compression, Type};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

const BALL_COLUMNS: &[&str] = &[
    "time_s",
    "ball",
    "angle_rad",
    "x_m",
    "y_m",
    "vx_m_s",
    "vy_m_s",
    "rotation_rad_s",
    "orbit_speed_rad_s",
    "gap_rad",
    "effective_radius_m",
    "inner_force_n",
    "outer_force_n",
    "inner_sliding_m_s",
    "outer_sliding_m_s",
];
const RING_COLUMNS: &[&str] = &[
    "time_s",
    "x_m",
    "y_m",
    "vx_m_s",
    "vy_m_s",
    "ax_m_s2",
    "ay_m_s2",
    "outer_force_x_n",
    "outer_force_y_n",
];
const COLLISION_COLUMNS: &[&str] = &[
    "start_s",
    "duration_s",
    "ball",
    "next_ball",
    "angle_rad",
    "approach_speed_m_s",
    "peak_force_n",
    "impulse_n_s",
];

/// Every number of the snapshot is its own, so that no two columns can be swapped.
fn snapshot(time_s: f64, balls: usize) -> Snapshot {
    let array = |column: usize| -> Vec<f64> {
        (0..balls)
            .map(|k| time_s + column as f64 + k as f64 / 1024.0)
            .collect()
    };
    Snapshot {
        time_s,
        angle_rad: array(2),
        x_m: array(3),
        y_m: array(4),
        vx_m_s: array(5),
        vy_m_s: array(6),
        rotation_rad_s: array(7),
        orbit_speed_rad_s: array(8),
        gap_rad: array(9),
        effective_radius_m: array(10),
        inner_force_n: array(11),
        outer_force_n: array(12),
        inner_sliding_m_s: array(13),
        outer_sliding_m_s: array(14),
        rotor: None,
        ring: RingSnapshot {
            x_m: time_s + 1.0,
            y_m: time_s + 2.0,
            vx_m_s: time_s + 3.0,
            vy_m_s: time_s + 4.0,
            ax_m_s2: time_s + 5.0,
            ay_m_s2: time_s + 6.0,
            outer_force_x_n: time_s + 7.0,
            outer_force_y_n: time_s + 8.0,
            ..RingSnapshot::default()
        },
        ..Snapshot::default()
    }
}

fn case() -> CaseFile {
    CaseFile::parse(&template(false), "template", &[]).unwrap()
}

/// A run that is written into a folder.
#[derive(Debug)]
struct Writing {
    folder: ResultFolder,
    tables: RunWriter,
}

impl Writing {
    /// Completes the run with its summary.
    fn finish(mut self) -> Result<(), ResultError> {
        self.folder.add_tables(self.tables, false)?;
        self.folder
            .commit("summary.json", "{\n  \"schema\": 1\n}\n")
    }
}

fn writer(dir: &Path) -> Result<Writing, ResultError> {
    let folder = ResultFolder::open(dir)?;
    let tables = folder.tables(
        "",
        &Metadata {
            isa: "avx2+fma",
            case: &serde_json::to_string(case().document()).unwrap(),
            in_space: false,
        },
    )?;
    Ok(Writing { folder, tables })
}

/// What a run leaves.
const FILES: [&str; 4] = [
    "balls.parquet",
    "collisions.parquet",
    "ring.parquet",
    "summary.json",
];

fn open(path: &Path) -> SerializedFileReader<File> {
    SerializedFileReader::new(File::open(path).unwrap()).unwrap()
}

fn columns(reader: &SerializedFileReader<File>) -> Vec<(String, Type)> {
    let schema = reader.metadata().file_metadata().schema_descr_ptr();
    schema
        .columns()
        .iter()
        .map(|c| (c.name().to_owned(), c.physical_type()))
        .collect()
}

fn footer(reader: &SerializedFileReader<File>) -> BTreeMap<String, String> {
    let pairs = reader
        .metadata()
        .file_metadata()
        .key_value_metadata()
        .unwrap();
    pairs
        .iter()
        .map(|p| (p.key.clone(), p.value.clone().unwrap()))
        .collect()
}

fn rows(reader: &SerializedFileReader<File>) -> Vec<Vec<f64>> {
    let value = |field: &Field| match *field {
        Field::Double(v) => v,
        Field::Int(v) => f64::from(v),
        ref other => panic!("{other:?}"),
    };
    let row = |row: parquet::record::Row| row.get_column_iter().map(|(_, f)| value(f)).collect();
    reader
        .get_row_iter(None)
        .unwrap()
        .map(|r| row(r.unwrap()))
        .collect()
}

fn files(dir: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(dir).unwrap();
    let mut names: Vec<_> = entries
        .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// CRC-32 of a file with these digits of it as zeros.
fn checksum(path: &Path, digits: &str) -> String {
    let mut bytes = std::fs::read(path).unwrap();
    let places = bytes.windows(8).filter(|w| *w == digits.as_bytes());
    assert_eq!(places.count(), 1);
    let place = bytes
        .windows(8)
        .position(|w| w == digits.as_bytes())
        .unwrap();
    bytes[place..place + 8].fill(b'0');
    format!("{:08x}", crc32fast::hash(&bytes))
}

#[test]
fn tables_read_back_as_they_were_written() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("deep/out");
    let mut run = writer(&out).unwrap();
    for k in 0..3 {
        run.tables
            .snapshot(&snapshot(f64::from(k) * 100.0, 14))
            .unwrap();
    }
    run.tables
        .collision(&Collision {
            start_s: 0.5,
            duration_s: 45e-6,
            ball: 13,
            next_ball: 0,
            angle_rad: -1.25,
            approach_speed_m_s: 0.1,
            peak_force_n: 77.0,
            impulse_n_s: 3e-3,
        })
        .unwrap();
    run.finish().unwrap();
    assert_eq!(files(&out), FILES);

    for (file, names) in [
        ("balls", BALL_COLUMNS),
        ("ring", RING_COLUMNS),
        ("collisions", COLLISION_COLUMNS),
    ] {
        let path = out.join(format!("{file}.parquet"));
        let reader = open(&path);
        let columns = columns(&reader);
        assert_eq!(
            columns.iter().map(|(n, _)| n.as_str()).collect::<Vec<_>>(),
            names
        );
        let footer = footer(&reader);
        for (name, physical) in &columns {
            let integer = name == "ball" || name == "next_ball";
            assert_eq!(
                *physical,
                if integer { Type::INT32 } else { Type::DOUBLE },
                "{name}"
            );
            let unit = match name.as_str() {
                n if integer => {
                    assert!(n.ends_with("ball"));
                    "1"
                }
                "impulse_n_s" => "N s",
                n if n.ends_with("_m_s2") => "m/s^2",
                n if n.ends_with("_rad_s") => "rad/s",
                n if n.ends_with("_m_s") => "m/s",
                n if n.ends_with("_rad") => "rad",
                n if n.ends_with("_n") => "N",
                n if n.ends_with("_m") => "m",
                n if n.ends_with("_s") => "s",
                n => panic!("{n}"),
            };
            assert_eq!(footer[&format!("unit:{name}")], unit);
        }
        assert_eq!(footer.len(), 5 + names.len());
        assert_eq!(footer["file_crc32"], checksum(&path, &footer["file_crc32"]));
        assert_eq!(
            (footer["schema"].as_str(), footer["isa"].as_str()),
            ("1", "avx2+fma")
        );
        assert_eq!(footer["version"], env!("CARGO_PKG_VERSION"));
        let json: serde_json::Value = serde_json::from_str(&footer["case"]).unwrap();
        assert_eq!(json, serde_json::to_value(case().document()).unwrap());
        let compression = reader.metadata().row_group(0).column(0).compression();
        assert_eq!(compression, Compression::SNAPPY);
    }

    let balls = rows(&open(&out.join("balls.parquet")));
    assert_eq!(balls.len(), 3 * 14);
    for (row, values) in balls.iter().enumerate() {
        let (time, ball) = ((row / 14) as f64 * 100.0, row % 14);
        assert_eq!(values[0], time);
        assert_eq!(values[1], ball as f64 + 1.0);
        for (column, &value) in values.iter().enumerate().skip(2) {
            assert_eq!(value, time + column as f64 + ball as f64 / 1024.0);
        }
    }
    let ring = rows(&open(&out.join("ring.parquet")));
    assert_eq!(ring.len(), 3);
    assert_eq!(
        ring[1],
        [100., 101., 102., 103., 104., 105., 106., 107., 108.]
    );
    let collisions = rows(&open(&out.join("collisions.parquet")));
    assert_eq!(
        collisions,
        [[0.5, 45e-6, 14.0, 1.0, -1.25, 0.1, 77.0, 3e-3]]
    );
}

#[test]
fn a_long_run_goes_to_disk_in_groups_of_rows() {
    let dir = tempfile::tempdir().unwrap();
    let mut run = writer(dir.path()).unwrap();
    let snapshots = 16_000;
    for k in 0..snapshots {
        run.tables.snapshot(&snapshot(f64::from(k), 14)).unwrap();
    }
    let partial = dir.path().join(".balls.parquet.partial");
    assert!(std::fs::metadata(partial).unwrap().len() > 1_000_000);
    run.finish().unwrap();
    let reader = open(&dir.path().join("balls.parquet"));
    let groups: Vec<_> = reader
        .metadata()
        .row_groups()
        .iter()
        .map(|g| g.num_rows())
        .collect();
    assert_eq!(groups, [100_002, 100_002, 23_996]);
    assert_eq!(
        reader.metadata().file_metadata().num_rows(),
        14 * i64::from(snapshots)
    );
    let last = reader.get_row_iter(None).unwrap().last().unwrap().unwrap();
    assert_eq!(
        last.get_column_iter().next().unwrap().1,
        &Field::Double(15_999.0)
    );
}

#[test]
fn a_run_without_rows_leaves_tables_that_can_be_read() {
    let dir = tempfile::tempdir().unwrap();
    writer(dir.path()).unwrap().finish().unwrap();
    let reader = open(&dir.path().join("collisions.parquet"));
    assert_eq!(rows(&reader).len(), 0);
    assert_eq!(columns(&reader).len(), COLLISION_COLUMNS.len());
}

#[test]
fn an_unfinished_run_leaves_the_earlier_one_alone() {
    let dir = tempfile::tempdir().unwrap();
    let mut run = writer(dir.path()).unwrap();
    run.tables.snapshot(&snapshot(1.0, 3)).unwrap();
    run.finish().unwrap();

    let mut run = writer(dir.path()).unwrap();
    run.tables.snapshot(&snapshot(2.0, 3)).unwrap();
    assert!(files(dir.path()).contains(&".ring.parquet.partial".to_owned()));
    // A second run in the same folder would mix its rows with ours.
    let error = writer(dir.path()).unwrap_err();
    assert!(matches!(error, ResultError::Busy { .. }), "{error}");
    drop(run);
    assert_eq!(files(dir.path()), FILES);
    assert_eq!(rows(&open(&dir.path().join("ring.parquet")))[0][0], 1.0);

    // What a killed run left is taken over.
    std::fs::write(dir.path().join(".ring.parquet.partial"), vec![b'x'; 5000]).unwrap();
    let mut run = writer(dir.path()).unwrap();
    run.tables.snapshot(&snapshot(3.0, 3)).unwrap();
    run.finish().unwrap();
    assert_eq!(rows(&open(&dir.path().join("ring.parquet")))[0][0], 3.0);
}

/// A table cannot take its name: it is named, and the result before stays.
#[test]
fn a_name_that_is_taken_leaves_the_folder_as_it_was() {
    let dir = tempfile::tempdir().unwrap();
    let mut run = writer(dir.path()).unwrap();
    run.tables.snapshot(&snapshot(1.0, 3)).unwrap();
    run.finish().unwrap();
    let mut run = writer(dir.path()).unwrap();
    run.tables.snapshot(&snapshot(2.0, 3)).unwrap();
    let ring = dir.path().join("ring.parquet");
    std::fs::remove_file(&ring).unwrap();
    std::fs::create_dir_all(ring.join("full")).unwrap();
    let message = run.finish().unwrap_err().to_string();
    assert!(message.contains("ring.parquet: "), "{message}");
    assert!(!message.contains("balls.parquet"), "{message}");
    assert!(message.contains("is as it was"), "{message}");
    assert_eq!(files(dir.path()), FILES);
    assert_eq!(rows(&open(&dir.path().join("balls.parquet")))[0][0], 1.0);
}

/// The summary lists the checksums of its tables, and is refused beside others.
#[test]
fn tables_belong_to_their_summary() {
    let dir = tempfile::tempdir().unwrap();
    let [one, other] = ["one", "other"].map(|name| dir.path().join(name));
    for (out, time) in [(&one, 1.0), (&other, 2.0)] {
        let mut run = writer(out).unwrap();
        run.tables.snapshot(&snapshot(time, 3)).unwrap();
        run.finish().unwrap();
    }
    let read = |dir: &Path| {
        let text = std::fs::read_to_string(dir.join("summary.json")).unwrap();
        summary_of_tables(dir, &text, &[String::new()])
    };
    assert_eq!(read(&one).unwrap(), "{\n  \"schema\": 1\n}\n");
    let balls = footer(&open(&one.join("balls.parquet")))["file_crc32"].clone();
    let summary = std::fs::read_to_string(one.join("summary.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(json["tables"]["balls.parquet"], balls.as_str());
    for name in ["balls.parquet", "ring.parquet", "rotor.parquet"] {
        let path = one.join(name);
        let before = std::fs::read(&path).ok();
        std::fs::copy(other.join("ring.parquet"), &path).unwrap();
        let message = read(&one).unwrap_err().to_string();
        for said in [
            &*path.to_string_lossy(),
            "summary.json",
            "is of another computation",
        ] {
            assert!(message.contains(said), "{message}");
        }
        match before {
            Some(bytes) => std::fs::write(&path, bytes).unwrap(),
            None => std::fs::remove_file(&path).unwrap(),
        }
    }
    read(&one).unwrap();
    std::fs::remove_file(one.join("collisions.parquet")).unwrap();
    let message = read(&one).unwrap_err().to_string();
    assert!(
        message.contains("collisions.parquet: cannot be read"),
        "{message}"
    );
    std::fs::write(one.join("summary.json"), "{}").unwrap();
    let message = read(&one).unwrap_err().to_string();
    assert!(message.contains("lacks `tables`"), "{message}");
}

/// Results of more bearings, and of a run, go with what is said about them; what is a result of its own stays.
#[test]
fn tables_of_an_earlier_result_go() {
    let dir = tempfile::tempdir().unwrap();
    let metadata = Metadata {
        isa: "avx2+fma",
        case: "{}",
        in_space: false,
    };
    let write = |places: &[&str]| {
        let mut folder = ResultFolder::open(dir.path()).unwrap();
        for place in places {
            let tables = folder.tables(place, &metadata).unwrap();
            folder.add_tables(tables, true).unwrap();
        }
        folder
            .commit("summary.json", "{\n  \"schema\": 1\n}\n")
            .unwrap();
    };
    write(&[""]);
    let left = files(dir.path());
    assert!(left.contains(&"balls.csv".to_owned()), "{left:?}");
    std::fs::write(dir.path().join("report.json"), "").unwrap();
    write(&["bearing-1", "bearing-2", "bearing-3"]);
    let bearings = ["bearing-1", "bearing-2", "bearing-3", "summary.json"];
    assert_eq!(files(dir.path()), bearings);
    std::fs::write(dir.path().join("bearing-2/mine.txt"), "").unwrap();
    std::fs::write(dir.path().join("bearing-3/summary.json"), "of its own").unwrap();
    std::fs::write(dir.path().join("bearing-1/.ring.csv.partial"), "half").unwrap();
    write(&["bearing-1"]);
    assert_eq!(files(dir.path()), bearings);
    assert_eq!(files(&dir.path().join("bearing-1")).len(), 6);
    assert_eq!(files(&dir.path().join("bearing-2")), ["mine.txt"]);
    assert_eq!(files(&dir.path().join("bearing-3")).len(), 7);
}

/// What killed processes left goes with the next result; what is in use or nobody's stays.
#[test]
fn half_written_files_of_killed_processes_go() {
    let dir = tempfile::tempdir().unwrap();
    for name in [
        ".balls.parquet.partial",
        ".report.html.partial",
        ".film.mkv.partial",
    ] {
        std::fs::write(dir.path().join(name), "half").unwrap();
    }
    let used = dir.path().join(".a.csv.partial");
    let file = cageless_io::open_locked(&used).unwrap().unwrap();
    let mut folder = ResultFolder::open(dir.path()).unwrap();
    let busy = ResultFolder::open(dir.path()).unwrap_err();
    assert!(matches!(busy, ResultError::Busy { .. }), "{busy}");
    folder.add("b.csv", b"x").unwrap();
    folder.commit_files().unwrap();
    drop((folder, file));
    assert_eq!(
        files(dir.path()),
        [".a.csv.partial", ".film.mkv.partial", "b.csv"]
    );
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("taken");
    std::fs::write(&file, "").unwrap();
    for out in [file.clone(), file.join("below")] {
        let message = writer(&out).unwrap_err().to_string();
        assert!(
            message.starts_with(&format!("--out {}: ", out.display())),
            "{message}"
        );
    }
    // A folder where a table should go.
    std::fs::create_dir_all(dir.path().join("out/.ring.parquet.partial")).unwrap();
    let message = writer(&dir.path().join("out")).unwrap_err().to_string();
    assert!(
        message.starts_with("--out ") && message.contains("ring.parquet"),
        "{message}"
    );
}

#[test]
fn a_ragged_snapshot_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let mut run = writer(dir.path()).unwrap();
    let mut s = snapshot(1.0, 3);
    s.gap_rad.pop();
    let message = run.tables.snapshot(&s).unwrap_err().to_string();
    assert!(message.contains("1 s"), "{message}");
}

#[test]
fn a_file_is_replaced_as_a_whole() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.json");
    write_atomically(&path, b"a long first version").unwrap();
    write_atomically(&path, b"short").unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), b"short");
    let error = write_atomically(&dir.path().join("none/a.json"), b"").unwrap_err();
    assert!(error.to_string().contains("none/a.json"), "{error}");
    assert!(write_atomically(Path::new("/"), b"").is_err());
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let plain = dir.path().join("plain");
        std::fs::write(&plain, "").unwrap();
        let mode = |p: &Path| std::fs::metadata(p).unwrap().permissions().mode();
        assert_eq!(mode(&path), mode(&plain), "as readable as any other file");
    }
}
