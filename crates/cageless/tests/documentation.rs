//! The documents and the sources say the same: the table "Equation → code" of the theory pages,
//! the paths in the guides for contributors, an example in every public module.

use std::fs;
use std::path::{Path, PathBuf};

fn crate_folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Rows of the table: first cell, third cell.
fn rows() -> Vec<(String, String)> {
    let path = crate_folder().join("../../docs/theory/README.md");
    let text = fs::read_to_string(path).unwrap();
    let (_, table) = text.split_once("## Equation → code").unwrap();
    let (table, _) = table.split_once("\n## ").unwrap();
    table
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| equation"))
        .map(|line| {
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            (cells[1].to_owned(), cells[3].to_owned())
        })
        .collect()
}

/// The pairs of name and path in "`a`, `b` in `path`; `c` in `path`".
fn names_and_paths(cell: &str) -> Vec<(String, String)> {
    let mut pairs = vec![];
    for group in cell.split(';') {
        let quoted: Vec<&str> = group.split('`').skip(1).step_by(2).collect();
        let (path, names) = quoted.split_last().unwrap();
        assert!(group.contains("` in `"), "no path in {cell}");
        pairs.extend(names.iter().map(|n| ((*n).to_owned(), (*path).to_owned())));
    }
    pairs
}

/// The place of a path of the table: below `src` of this crate, or of the crate that it begins with.
fn place(path: &str) -> PathBuf {
    match path.strip_prefix("cageless-design/") {
        Some(path) => crate_folder().join("../cageless-design/src").join(path),
        None => crate_folder().join("src").join(path),
    }
}

/// The source files at a path of the table: a file, or those of a folder and below.
fn sources(path: &Path) -> Vec<PathBuf> {
    if !path.is_dir() {
        return vec![path.to_owned()];
    }
    let entries = fs::read_dir(path).unwrap();
    entries.flat_map(|e| sources(&e.unwrap().path())).collect()
}

fn declares(text: &str, name: &str) -> bool {
    let name = name.rsplit("::").next().unwrap();
    let ends = |rest: &str| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_');
    ["fn", "struct", "enum", "const", "trait", "type"]
        .iter()
        .any(|kind| {
            let declaration = format!("{kind} {name}");
            text.match_indices(&declaration)
                .any(|(at, _)| ends(&text[at + declaration.len()..]))
        })
}

#[test]
fn every_name_is_declared_where_the_table_says() {
    let rows = rows();
    assert!(rows.len() > 40, "{} rows", rows.len());
    for (row, cell) in rows {
        for (name, path) in names_and_paths(&cell) {
            let files = sources(&place(&path));
            let declared = files.iter().any(|file| {
                let text =
                    fs::read_to_string(file).unwrap_or_else(|e| panic!("row {row}: {path}: {e}"));
                declares(&text, &name)
            });
            assert!(declared, "row {row}: no `{name}` in {path}");
        }
    }
}

/// A function with its doc comment and its body up to the closing brace in its column.
struct Function {
    name: String,
    doc: String,
    body: String,
}

fn functions(text: &str) -> Vec<Function> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = vec![];
    let mut doc = String::new();
    for (k, line) in lines.iter().enumerate() {
        let trimmed = line.trim_start();
        if let Some(comment) = trimmed.strip_prefix("///") {
            doc.push_str(comment);
            continue;
        }
        if trimmed.starts_with('#') {
            continue;
        }
        let visible = trimmed.replacen("pub(crate) ", "pub ", 1);
        let before = visible.split('(').next().unwrap();
        if let Some((qualifiers, name)) = before.split_once("fn ")
            && (qualifiers.is_empty() || qualifiers.ends_with(' '))
        {
            let indent = &line[..line.len() - trimmed.len()];
            let end = format!("{indent}}}");
            let body = lines[k..].iter().take_while(|l| **l != end);
            found.push(Function {
                name: name.split('<').next().unwrap().to_owned(),
                doc: doc.clone(),
                body: body.copied().collect::<Vec<_>>().join("\n"),
            });
        }
        doc.clear();
    }
    found
}

#[test]
fn every_equation_names_itself_above_one_scalar_function() {
    let rows = rows();
    for n in 1..=22 {
        let equation = format!("Eq. ({n})");
        let (_, cell) = rows
            .iter()
            .find(|(row, _)| *row == equation)
            .unwrap_or_else(|| panic!("no row for {equation}"));
        let (name, path) = names_and_paths(cell).remove(0);
        let name = name.rsplit("::").next().unwrap();
        let text = fs::read_to_string(place(&path)).unwrap();
        let function = functions(&text)
            .into_iter()
            .find(|f| f.name == name && f.doc.contains(&equation))
            .unwrap_or_else(|| panic!("no `{name}` with {equation} above it in {path}"));
        for word in ["lane", "LANES", "[l]"] {
            assert!(
                !function.body.contains(word),
                "{equation}: {word} in {name}"
            );
        }
    }
}

/// Public modules below a module file or `lib.rs`.
fn public_modules(file: &Path) -> Vec<PathBuf> {
    let text = fs::read_to_string(file).unwrap();
    let folder = match file.file_stem().unwrap().to_str().unwrap() {
        "lib" | "mod" => file.parent().unwrap().to_owned(),
        _ => file.with_extension(""),
    };
    let names = text.lines().filter_map(|line| {
        let name = line.strip_prefix("pub mod ")?.strip_suffix(';')?;
        Some(name.to_owned())
    });
    let mut found = vec![];
    for name in names {
        let [flat, nested] = [format!("{name}.rs"), format!("{name}/mod.rs")];
        let file = [flat, nested].map(|f| folder.join(f));
        let file = file.into_iter().find(|f| f.is_file()).unwrap();
        found.extend(public_modules(&file));
        found.push(file);
    }
    found
}

#[test]
fn every_public_module_begins_with_an_example() {
    let fronts = ["src/lib.rs", "../cageless-design/src/lib.rs"].map(|f| crate_folder().join(f));
    let modules: Vec<_> = fronts.iter().flat_map(|f| public_modules(f)).collect();
    assert!(modules.len() > 20, "{} modules", modules.len());
    for module in modules {
        let text = fs::read_to_string(&module).unwrap();
        let head = text.lines().take_while(|line| line.starts_with("//!"));
        let fences = head.filter(|line| line.starts_with("//! ```")).count();
        assert!(
            fences >= 2,
            "no example at the head of {}",
            module.display()
        );
    }
}

#[test]
fn paths_in_the_guides_exist() {
    let root = crate_folder().join("../..");
    let mut paths = 0;
    for guide in ["ARCHITECTURE.md", "CONTRIBUTING.md", "RECIPES.md"] {
        let text = fs::read_to_string(root.join(guide)).unwrap();
        for quoted in text.split('`').filter(|q| q.starts_with("crates/")) {
            assert!(root.join(quoted).exists(), "{guide}: no {quoted}");
            paths += 1;
        }
    }
    assert!(paths > 30, "{paths} paths");
}
