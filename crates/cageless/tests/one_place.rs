//! What has one place: the computation of one bearing and of several, the factors between SI and the units of
//! readers, and the start of threads. The list of exceptions may only shrink.

use std::fs;
use std::path::{Path, PathBuf};

/// Places of each crate that convert units outside [`CONVERTERS`], at most.
const CONVERSIONS: [(&str, usize); 11] = [
    ("cageless", 40),
    ("cageless-bench", 2),
    ("cageless-cli", 10),
    ("cageless-design", 34),
    ("cageless-io", 41),
    ("cageless-live", 22),
    ("cageless-paper", 50),
    ("cageless-py", 3),
    ("cageless-report", 70),
    ("cageless-results", 17),
    ("cageless-study", 75),
];

/// The reader of documents, the table of quantities and the lengths of figures and drawings: where units are converted.
const CONVERTERS: [&str; 5] = [
    "cageless/src/reference.rs",
    "case_file/unit.rs",
    "cageless-results/src/table/",
    "drawing/dimension.rs",
    "cageless-report/src/length.rs",
];

/// Conversions of angles and speeds; those of other units are powers of 1000.
const FACTORS: [&str; 4] = ["to_degrees", "to_radians", "60.0 / TAU", "TAU / 60.0"];

/// The sources below a folder, Rust and Python.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = vec![];
    for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
        if path.is_dir() && !["tests", "target"].iter().any(|name| path.ends_with(name)) {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs" || e == "py") {
            found.push(path);
        }
    }
    found
}

fn crates() -> Vec<(String, Vec<PathBuf>)> {
    let all = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).unwrap();
    let folders = all.map(|e| e.unwrap().path());
    let name = |folder: &Path| folder.file_name().unwrap().to_str().unwrap().to_owned();
    folders
        .map(|folder| (name(&folder), sources(&folder)))
        .collect()
}

/// A list of length one is the case of one bearing: it has no file of its own.
#[test]
fn no_file_for_several_beside_one_for_one() {
    for file in crates().into_iter().flat_map(|(_, files)| files) {
        let stem = file.file_stem().unwrap().to_str().unwrap();
        let one = stem
            .strip_prefix("rotor_")
            .or(stem.strip_suffix("_several"));
        let ending = file.extension().unwrap();
        let beside =
            one.is_some_and(|one| file.with_file_name(one).with_extension(ending).exists());
        assert!(!beside, "{} beside {one:?}", file.display());
    }
}

/// Threads start in one file, which also knows what to do where none can.
#[test]
fn no_further_start_of_threads() {
    let starts = [
        ".par_iter(",
        ".into_par_iter(",
        ".par_chunks(",
        "rayon::join",
        "rayon::scope",
        "rayon::current_num_threads",
        "rayon::spawn",
        "ThreadPoolBuilder",
        "thread::spawn",
    ];
    for file in crates().into_iter().flat_map(|(_, files)| files) {
        let text = fs::read_to_string(&file).unwrap();
        let found: Vec<_> = starts.iter().filter(|s| text.contains(**s)).collect();
        let place = file.ends_with("cageless-study/src/threads.rs");
        assert!(place || found.is_empty(), "{}: {found:?}", file.display());
    }
}

/// Units are converted in the reader of documents and in the table of quantities.
#[test]
fn no_further_conversion_of_units() {
    let powers = ["e3", "e6", "e9", "e-3", "e-6", "e-9"];
    let products = powers.map(|p| [format!("* 1{p}"), format!("/ 1{p}"), format!("1{p} *")]);
    let factors: Vec<String> = FACTORS
        .map(str::to_owned)
        .into_iter()
        .chain(products.concat())
        .collect();
    let mut further = vec![];
    for (name, files) in crates() {
        let inside = |file: &&PathBuf| file.components().any(|c| c.as_os_str() == "src");
        let files = files.iter().filter(inside);
        let converts = |file: &PathBuf| {
            CONVERTERS
                .iter()
                .any(|c| file.to_str().unwrap().contains(c))
        };
        let files = files.filter(|file| !converts(file));
        let count = |file: &PathBuf| {
            let text = fs::read_to_string(file).unwrap();
            let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            let code: Vec<&str> = text
                .lines()
                .filter_map(|line| line.split("//").next())
                .collect();
            factors
                .iter()
                .map(|factor| code.join("\n").matches(factor).count())
                .sum::<usize>()
        };
        let found: usize = files.map(count).sum();
        let most = CONVERSIONS.iter().find(|c| c.0 == name).map_or(0, |c| c.1);
        if found > most {
            further.push(format!(
                "{name}: {found} conversions of units, {most} are allowed"
            ));
        }
    }
    assert!(further.is_empty(), "{further:#?}");
}
