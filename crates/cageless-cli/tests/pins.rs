//! What every command prints and writes, in `snapshots/`, to the last digit: text, JSON, help, the outline of
//! each page and the bits of each table. RECIPES.md says how a wanted change is taken over.

use std::ffi::OsStr;
use std::fs::File;
use std::path::Path;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

use crate::common::*;

/// Declares a test for each line: its name, and commands that share a folder `OUT`. `+section.key=value`
/// is short for `--set section.key=value`.
macro_rules! pins {
    ($($name:ident: $commands:literal;)*) => {
        $(#[test] fn $name() { pin(stringify!($name), $commands); })*
    };
}

#[rustfmt::skip]
pins! {
    help: "--help; new --help; check --help; static --help; design --help; tolerance --help; run --help; drop --help; compare --help";
    help_files: "export --help; sweep --help; sweep merge --help; report --help; reproduce --help; studio --help; completions --help; man --help";
    new: "new; new --bearing 6205; new --bearing 6008 --full-complement --touchdown";
    new_conventional: "new --conventional --out OUT/case.toml; check OUT/case.toml";
    check: "check cases/zhao-d.toml --out OUT; check cases/touchdown-6205.toml +bearing.inner_groove_bottom_radius_mm=15.556";
    check_rotor: "check cases/rotors/two-bearings.toml --out OUT";
    static_loaded: "static cases/zhao-d.toml --out OUT";
    static_unloaded: "static cases/conventional.toml +operation.radial_load_n=0 +operation.gravity_m_s2=0; static cases/full-6205.toml +material.preset=Si3N4 --json";
    static_space: "static cases/zhao-d.toml +operation.axial_load_n=300 +operation.moment_x_n_m=0.5 --out OUT; static cases/full-6205.toml +operation.axial_load_n=400 +operation.tilt_y_mrad=0.5 --json";
    design: "design cases/zhao-d.toml +solver.step_us=2.5 --out OUT";
    design_conventional: "design cases/conventional.toml +solver.step_us=2.5 --out OUT";
    design_search: "design cases/zhao-d.toml --search +search.runs_max=32 +search.initial_states=1 +search.half_angle_deg=24.5 +search.axial_span_mm=[5,5.2] +solver.step_us=2.5 --out OUT";
    tolerance: "tolerance cases/zhao-d.toml --samples 2 --speed-percent 0 --load-percent 0 --friction 0 +solver.step_us=2.5 --out OUT";
    run: "run cases/zhao-d.toml +solver.duration_s=0.02 --csv --out OUT";
    run_json: "run cases/conventional.toml +solver.duration_s=0.02 +start.gaps=bunched --json";
    run_verify: "run cases/zhao-a.toml +solver.duration_s=0.002 --verify --out OUT";
    run_stopped: "run cases/full-6205.toml +bearing.balls=6 +start.gaps=bunched +start.state=rolling +solver.duration_s=0.05 --out OUT";
    drop_compared: "drop cases/touchdown-d.toml +solver.duration_s=0.01 --compare conventional --samples 2 --csv --out OUT";
    drop_verified: "drop cases/touchdown-6205.toml +solver.duration_s=0.01 --verify --out OUT";
    drop_rotor: "drop cases/rotors/two-bearings.toml +solver.duration_s=0.005 --compare conventional --samples 2 --verify --csv --out OUT";
    compare: "compare cases/zhao-d.toml --with-conventional --draws 2 +solver.duration_s=0.02 +steady.transient_orbits=1 +steady.measured_orbits=3 --out OUT";
    export_step: "export cases/zhao-d.toml --format step +bearing.outer_ring_outer_radius_mm=31 +bearing.outer_ring_width_mm=16 --out OUT";
    export_others: "export cases/zhao-d.toml --format stl --chord-um 50 +bearing.outer_ring_outer_radius_mm=31 +bearing.outer_ring_width_mm=16 --out OUT/ring.stl; export cases/zhao-d.toml --format csv +bearing.outer_ring_outer_radius_mm=31 +bearing.outer_ring_width_mm=16 --json --out OUT/ring.csv";
    sweep: "sweep OUT/plan.toml --out OUT; report OUT --high static_inner_force_max_n";
    sweep_shards: "sweep OUT/plan.toml --shard 1/2 --out OUT --quiet; sweep OUT/plan.toml --shard 2/2 --out OUT --json; sweep merge OUT/sweep.shard-1-of-2.parquet OUT/sweep.shard-2-of-2.parquet";
    refused: "run cases/zhao-d.toml +bearing.ball=3; static none.toml; run cases/rotors/two-bearings.toml; compare cases/rotors/two-bearings.toml --with-conventional; studio cases/rotors/two-bearings.toml; drop cases/zhao-d.toml; rnu; man rnu; run cases/zhao-d.toml --open; check cases/zhao-d.toml --open --out OUT; report cases";
    bits_zhao_a_paper: "run cases/zhao-a.toml +model.formulation=paper +solver.method=abm4 +solver.step_us=1 +solver.duration_s=0.01 --quiet --out OUT";
    bits_zhao_d: "run cases/zhao-d.toml +solver.duration_s=0.1 --quiet --out OUT";
    bits_cb74: "run cases/cb74.toml +solver.duration_s=0.02 --quiet --out OUT";
    bits_bunched: "run cases/conventional.toml +start.gaps=bunched +contact.friction_law=coulomb +solver.duration_s=0.02 --quiet --out OUT";
    bits_random: "run cases/full-6203.toml +start.gaps=random +solver.seed=7 +contact.friction_law=stribeck +contact.static_friction_coefficient=0.02 +contact.stribeck_speed_m_s=0.1 +solver.duration_s=0.02 --quiet --out OUT";
    bits_housing: "run cases/experiment-3000rpm.toml +solver.duration_s=0.02 --quiet --out OUT";
    bits_adaptive: "run cases/zhao-j.toml +solver.method=adaptive +contact.friction_law=table +contact.friction_coefficient=0.01 +contact.friction_table=[[0,0.02],[0.5,0.01]] +solver.duration_s=0.004 --quiet --out OUT";
    bits_preload: "run cases/full-6205.toml +bearing.inner_groove_bottom_radius_mm=15.554 +solver.duration_s=0.02 --quiet --out OUT";
    bits_in_time: "run cases/zhao-g.toml +operation.radial_load_n=[[0,500],[0.02,3000]] +operation.inner_speed_rpm=[[0,3000],[0.02,0]] +solver.duration_s=0.02 --quiet --out OUT";
    bits_drop: "drop cases/touchdown-d.toml +solver.duration_s=0.02 --quiet --out OUT";
    bits_drop_coulomb: "drop cases/touchdown-conventional.toml +contact.friction_law=coulomb +rotor.friction_law=coulomb +rotor.eccentricity_um=3 +solver.duration_s=0.02 --quiet --out OUT";
    bits_drop_rotor: "drop cases/rotors/two-bearings.toml +solver.duration_s=0.015 --quiet --out OUT";
}

/// `OUT/plan.toml`, for a copy of structure (d) beside it.
const PLAN: &str = "\
case = \"case.toml\"
seed = 3
compute = [\"static\", \"design\", \"run\"]
[set]
solver.duration_s = 0.002
[grid]
raceway.axial_span_mm = [5.0, 5.1]
[samples]
method = \"sobol\"
count = 3
operation.radial_load_n = { from = 500.0, to = 2000.0 }
";

fn pin(name: &str, commands: &str) {
    let (root, dir) = (repository_case(".."), tempfile::tempdir().unwrap());
    let out = dir.path().to_str().unwrap();
    if commands.contains("plan.toml") {
        std::fs::write(dir.path().join("plan.toml"), PLAN).unwrap();
        std::fs::copy(root.join("cases/zhao-d.toml"), dir.path().join("case.toml")).unwrap();
    }
    let mut text = String::new();
    for command in commands.split("; ") {
        let mut process = cageless();
        process.current_dir(&root).env("COLUMNS", "100");
        for word in command.split(' ') {
            match word.strip_prefix('+') {
                Some(set) => process.args(["--set", set]),
                None => process.arg(word.replace("OUT", out)),
            };
        }
        let answer = Answer::from(process.output().unwrap());
        let Answer {
            code,
            stdout,
            stderr,
        } = answer;
        text += &format!(
            "$ cageless {command}\n{stdout}{stderr}exit code {}\n\n",
            code.unwrap()
        );
    }
    text += &written(dir.path(), Path::new(""), name.starts_with("bits"));
    text = redacted(&folded(&text.replace(out, "OUT")));
    if rounding() != ROUNDING {
        let stored = root.join(format!("crates/cageless-cli/tests/snapshots/{name}.snap"));
        let stored = std::fs::read_to_string(stored).unwrap();
        let stored = stored.splitn(3, "---\n").nth(2).unwrap_or_default();
        assert_eq!(words(stored), words(&text), "{name}");
        return;
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// The words of the text that have no digit.
fn words(text: &str) -> Vec<&str> {
    let words = text.split_whitespace();
    words
        .filter(|word| !word.contains(|c: char| c.is_ascii_digit()))
        .collect()
}

/// The text with each list of numbers on one line.
fn folded(text: &str) -> String {
    let mut folded = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        folded += line;
        if line.ends_with('[') {
            let rest = lines.clone().map(str::trim);
            let items: Vec<&str> = rest.take_while(|item| !item.starts_with(']')).collect();
            if items.iter().all(|item| !item.contains(['{', '[', '"'])) {
                folded += &items.join(" ");
                folded += lines.nth(items.len()).unwrap_or_default().trim();
            }
        }
        folded.push('\n');
    }
    folded
}

/// Beginnings of what depends on the machine, the time or the version, up to the next of its ends.
const REDACTED: [(&str, &str); 8] = [
    ("\"isa\": \"", "\""),
    ("\"software\": \"", "\""),
    ("\"version\": \"", "\""),
    (".parquet\": \"", "\""),
    ("wall_s\": ", ",\n"),
    ("variants_per_s\": ", ",\n"),
    ("\nrate ", "\n"),
    ("\nspeed ", "\n"),
];

fn redacted(text: &str) -> String {
    let mut text = text.to_owned();
    for (start, ends) in REDACTED {
        let mut at = 0;
        while let Some(found) = text[at..].find(start) {
            at += found + start.len();
            let end = at + text[at..].find(|c| ends.contains(c)).unwrap_or(0);
            text.replace_range(at..end, "…");
        }
    }
    text
}

/// Names of the files in a folder, with the bits of tables and, unless they are `tables_only`, JSON, the outlines of
/// pages and the sums of the others.
fn written(root: &Path, folder: &Path, tables_only: bool) -> String {
    let mut text = String::new();
    for name in names(&root.join(folder)) {
        let (path, name) = (root.join(folder).join(&name), folder.join(&name));
        if path.is_dir() {
            text += &written(root, &name, tables_only);
            continue;
        }
        let bytes = std::fs::read(&path).unwrap();
        text += &format!("OUT/{}", name.display());
        text += &match path.extension().and_then(OsStr::to_str) {
            Some("parquet") => format!("\n{}", bits(&path)),
            _ if tables_only => "\n".to_owned(),
            // The time of the run is among them.
            _ if name.ends_with("summary.csv") => "\n".to_owned(),
            Some("html") => format!("\n{}", outline(&String::from_utf8(bytes).unwrap())),
            // Page data; the page and the summary have their numbers.
            _ if name.ends_with("report.json") => "\n".to_owned(),
            Some("json") => format!("\n{}\n", pretty(&bytes)),
            _ => format!(": {:016x}\n", sum(bytes)),
        };
    }
    text
}

/// A JSON document on lines, if it is all on one.
fn pretty(bytes: &[u8]) -> String {
    let text = std::str::from_utf8(bytes).unwrap();
    match text.trim_end().contains('\n') {
        true => text.trim_end().to_owned(),
        false => {
            serde_json::to_string_pretty(&serde_json::from_str::<serde_json::Value>(text).unwrap())
                .unwrap()
        }
    }
}

/// FNV-1a of bytes.
fn sum(bytes: impl IntoIterator<Item = u8>) -> u64 {
    let add = |sum: u64, byte| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.into_iter().fold(0xcbf2_9ce4_8422_2325, add)
}

/// The sum of each column of a table.
fn bits(path: &Path) -> String {
    let reader = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
    let mut columns: Vec<(String, Vec<u8>)> = vec![];
    for row in reader.get_row_iter(None).unwrap() {
        for (k, (name, field)) in row.unwrap().get_column_iter().enumerate() {
            if columns.len() == k {
                columns.push((name.clone(), vec![]));
            }
            match field {
                Field::Double(value) => columns[k].1.extend(value.to_bits().to_le_bytes()),
                other => columns[k].1.extend(other.to_string().into_bytes()),
            }
        }
    }
    let line = |(name, bytes): (String, Vec<u8>)| match name.ends_with("wall_s") {
        true => format!("  {name} …\n"),
        false => format!("  {name} {:016x}\n", sum(bytes)),
    };
    columns.into_iter().map(line).collect()
}

/// Headings of a page, titles of its figures, and titles, heads and row labels of its tables.
fn outline(page: &str) -> String {
    let mut outline = String::new();
    let (mut inside, mut caption, mut row, mut code) = (false, false, false, false);
    for piece in page.split('<').skip(1) {
        let (tag, text) = piece.split_once('>').unwrap_or((piece, ""));
        let name = tag.split([' ', '\n']).next().unwrap_or_default();
        code = matches!(name, "script" | "style") || code && name != "/script" && name != "/style";
        if code {
            continue;
        }
        caption |= name == "figcaption";
        row |= name == "tr";
        let begin = match name {
            "h1" => Some("# "),
            "h2" => Some("## "),
            "h3" | "h4" => Some("### "),
            "b" if std::mem::take(&mut caption) => Some("> "),
            "th" if tag.contains("scope=\"col") => Some(" | "),
            "td" | "th" if std::mem::take(&mut row) => Some("  - "),
            _ => None,
        };
        outline += begin.unwrap_or_default();
        inside |= begin.is_some();
        if let "/h1" | "/h2" | "/h3" | "/h4" | "/b" | "/td" | "/th" = name
            && inside
        {
            inside = false;
            if !outline
                .lines()
                .last()
                .is_some_and(|line| line.starts_with(" |"))
            {
                outline.push('\n');
            }
        } else if name == "/thead" {
            outline.push('\n');
        }
        if inside {
            outline += text;
        }
    }
    outline
        .lines()
        .map(str::trim_end)
        .filter(|line| !matches!(*line, "" | "  -"))
        .map(|line| format!("  {line}\n"))
        .collect()
}

/// Sum of the bits of functions of the C library. Another library may round otherwise, which moves last digits
/// and, where balls collide, more than these.
const ROUNDING: u64 = 0xcc82_37df_ebb1_7490;

fn rounding() -> u64 {
    let bits = (1..2000).flat_map(|k| {
        let x = 0.0137 * f64::from(k);
        [
            x.sin(),
            x.cos(),
            x.tan().atan(),
            x.atan2(1.3),
            (-x).exp(),
            x.ln(),
            x.cbrt(),
            x.powf(1.1),
            x.hypot(0.7),
            (0.03 * x).asin(),
        ]
    });
    sum(bits.flat_map(|value| value.to_bits().to_le_bytes()))
}
