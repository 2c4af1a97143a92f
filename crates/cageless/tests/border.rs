//! The border of the crate: what is public is what somebody outside names.
//!
//! A public item is named if another crate, an example or the front page has its name as a word. All else is
//! `pub(crate)`; tests of it lie in `inside/`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Public items at most.
const ITEMS_MAX: usize = 749;

/// The sources below a folder without those of tests.
fn sources(folder: &Path, tests: bool) -> Vec<PathBuf> {
    let mut found = vec![];
    for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
        let is_tests = path.file_stem().is_some_and(|stem| stem == "tests");
        if path.ends_with("target") || is_tests && !tests {
            continue;
        } else if path.is_dir() {
            found.extend(sources(&path, tests));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_'))
}

/// The name of the public item that a line declares.
fn public_item(line: &str) -> Option<&str> {
    let declared = line.trim_start().strip_prefix("pub ")?;
    let declared = declared.strip_prefix("unsafe ").unwrap_or(declared);
    let declared = match declared.strip_prefix("const ") {
        Some(rest) if rest.starts_with("fn ") => rest,
        _ => declared,
    };
    let (kind, rest) = declared.split_once(' ')?;
    let kinds = [
        "fn", "struct", "enum", "trait", "mod", "const", "static", "type",
    ];
    let name = words(rest).next().filter(|name| !name.is_empty());
    name.filter(|_| kinds.contains(&kind))
}

/// Names of the public items of the crate, and of how many items.
fn public_items(folder: &Path) -> (BTreeSet<String>, usize) {
    let (mut names, mut count) = (BTreeSet::new(), 0);
    for file in sources(&folder.join("src"), false) {
        let text = fs::read_to_string(file).unwrap();
        for name in text.lines().filter_map(public_item) {
            names.insert(name.to_owned());
            count += 1;
        }
    }
    (names, count)
}

/// Words of the other crates, of the examples and of the front pages.
fn named_outside(folder: &Path) -> BTreeSet<String> {
    let own = ["src", "tests"].map(|name| folder.join(name));
    let crates = sources(&folder.join(".."), true);
    let outside = crates.iter().filter(|file| {
        let file = fs::canonicalize(file).unwrap();
        own.iter().all(|own| !file.starts_with(own))
    });
    let mut pages: Vec<String> = outside.map(|f| fs::read_to_string(f).unwrap()).collect();
    pages.push(fs::read_to_string(folder.join("README.md")).unwrap());
    let front = fs::read_to_string(folder.join("src/lib.rs")).unwrap();
    let front = front.lines().filter(|line| line.starts_with("//!"));
    pages.extend(front.map(str::to_owned));
    let words = pages.iter().flat_map(|page| words(page));
    words.map(str::to_owned).collect()
}

#[test]
fn what_is_public_is_named_outside() {
    let folder = fs::canonicalize(env!("CARGO_MANIFEST_DIR")).unwrap();
    let ((items, count), named) = (public_items(&folder), named_outside(&folder));
    assert!((500..=ITEMS_MAX).contains(&count), "{count} public items");
    let unnamed: Vec<_> = items.difference(&named).collect();
    assert!(
        unnamed.is_empty(),
        "public, but named by nobody outside: {unnamed:?}"
    );
}
