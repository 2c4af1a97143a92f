//! Files use each other in one direction: no crate has a circle.
//!
//! A file uses the file that *defines* a name which it takes by a path: `use crate::a::B`, `super::a::B`,
//! `$crate::a::B` in a macro, or `a::b()` where `a` is a child or was imported. Re-exports are followed to
//! the definition. Declaring (`mod a;`) and handing on (`pub use a::B;`) are no use, unless the file itself
//! names the type that it hands on. Methods are not followed; comments and unit tests are not read.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The source of a module.
#[derive(Default)]
struct Module {
    /// Words, and paths as one.
    words: Vec<String>,
    defined: BTreeSet<String>,
    /// Name in this module (`*` for all names), its path, and whether it is only handed on.
    imports: Vec<(String, String, bool)>,
}

/// Modules by their path, such as `crate::contact::hertz`.
type Modules = BTreeMap<String, Module>;
/// Paths that each module takes of others.
type Uses = BTreeMap<String, BTreeMap<String, BTreeSet<String>>>;

/// The code before the unit tests, without comments and strings.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let text = text
        .replace("\\\\", "")
        .replace("\\\"", "")
        .replace("'\"'", "");
    let lines = text.lines().map(|line| {
        let mut comments = line.match_indices("//").map(|(at, _)| &line[..at]);
        let code = comments.find(|before| before.matches('"').count() % 2 == 0);
        format!("{}\n", code.unwrap_or(line))
    });
    lines.collect::<String>().split('"').step_by(2).collect()
}

/// The paths of a tree of imports.
fn expand(path: &str, tree: &str, into: &mut Vec<String>) {
    let Some((head, list)) = tree.split_once('{') else {
        return into.push(format!("{path}{}", tree.trim()));
    };
    let mut depth = 0;
    let items = list.trim_end().trim_end_matches('}').split(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    let items = items.filter(|item| !item.trim().is_empty());
    items.for_each(|item| expand(&format!("{path}{}", head.trim()), item, into));
}

fn read(text: &str) -> Module {
    let mut module = Module::default();
    for statement in code(text).split_inclusive(';') {
        let (before, tree) = statement.rsplit_once("use ").unwrap_or((statement, ""));
        let own = before.rsplit('\n').next().unwrap().trim();
        let is_use = tree.ends_with(';') && (own.is_empty() || own.starts_with("pub"));
        let mut paths = vec![];
        if is_use {
            expand("", tree.trim_end_matches(';'), &mut paths);
        }
        for path in paths {
            let path = path.trim_end_matches("::self");
            let (path, name) = path.split_once(" as ").unwrap_or((path, path));
            let name = name.rsplit("::").next().unwrap();
            module
                .imports
                .push((name.to_owned(), path.to_owned(), !own.is_empty()));
        }
        let code = if is_use { before } else { statement };
        let words = code.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
        let words = words.map(|word| word.trim_matches(':').to_owned());
        module.words.extend(words.filter(|word| !word.is_empty()));
    }
    let defining = [
        "struct",
        "enum",
        "trait",
        "type",
        "fn",
        "const",
        "static",
        "macro_rules",
    ];
    let pairs = module
        .words
        .windows(2)
        .filter(|pair| defining.contains(&pair[0].as_str()));
    module.defined = pairs.map(|pair| pair[1].clone()).collect();
    module
}

fn modules(folder: &Path, path: &str, into: &mut Modules) {
    for entry in fs::read_dir(folder).unwrap() {
        let file = entry.unwrap().path();
        let stem = file.file_stem().unwrap().to_str().unwrap();
        let root = ["lib", "mod"].contains(&stem);
        let inner = if root {
            path.to_owned()
        } else {
            format!("{path}::{stem}")
        };
        if file.is_dir() {
            modules(&file, &inner, into);
        } else if file.extension().is_some_and(|e| e == "rs") && stem != "tests" {
            into.insert(inner, read(&fs::read_to_string(file).unwrap()));
        }
    }
}

/// The module that defines what a path in the module `place` means; none for modules and for names
/// of other crates.
fn definition(all: &Modules, place: &str, path: &str, depth: u8) -> Option<String> {
    let (name, rest) = path.split_once("::").unwrap_or((path, ""));
    let child = format!("{place}::{name}");
    let module = all.get(place).filter(|_| depth < 20)?;
    let at = |place: &str, path: &str| definition(all, place, path, depth + 1);
    match name {
        "crate" => at("crate", rest),
        "self" => at(place, rest),
        "super" => at(place.rsplit_once("::")?.0, rest),
        _ if all.contains_key(&child) => at(&child, rest),
        _ if module.defined.contains(name) => Some(place.to_owned()),
        _ => module
            .imports
            .iter()
            .find_map(|(own, import, _)| match own {
                own if own == name => at(place, &format!("{import}::{rest}")),
                own if own == "*" => at(place, &import.replace('*', path)),
                _ => None,
            }),
    }
}

fn crate_modules(name: &str) -> Modules {
    let mut all = Modules::new();
    let crates = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    modules(&crates.join(name).join("src"), "crate", &mut all);
    all
}

fn crate_uses(name: &str) -> Uses {
    let (all, mut uses) = (crate_modules(name), Uses::new());
    for (from, module) in &all {
        // A lower-case word by itself may be a variable.
        let is_name = |word: &&String| word.contains("::") || word.starts_with(char::is_uppercase);
        let imports = module.imports.iter().filter(|import| !import.2);
        for path in imports
            .map(|import| &import.1)
            .chain(module.words.iter().filter(is_name))
        {
            if let Some(to) = definition(&all, from, path, 0).filter(|to| to != from) {
                uses.entry(from.clone())
                    .or_default()
                    .entry(to)
                    .or_default()
                    .insert(path.clone());
            }
        }
    }
    uses
}

/// What a module uses, by others as well.
fn reached(uses: &Uses, from: &str) -> BTreeSet<String> {
    let (mut seen, mut open) = (BTreeSet::new(), vec![from]);
    while let Some(from) = open.pop() {
        let next = uses.get(from).into_iter().flat_map(BTreeMap::keys);
        open.extend(
            next.filter(|to| seen.insert((*to).clone()))
                .map(String::as_str),
        );
    }
    seen
}

#[test]
fn no_circle_between_files() {
    let mut report = String::new();
    for folder in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).unwrap() {
        let name = folder.unwrap().file_name().into_string().unwrap();
        let uses = crate_uses(&name);
        let mut circles = BTreeMap::<_, Vec<_>>::new();
        for (from, to, paths) in uses
            .iter()
            .flat_map(|(f, t)| t.iter().map(move |t| (f, t.0, t.1)))
        {
            let back = |m: &String| reached(&uses, m).contains(from);
            if back(to) {
                let circle: BTreeSet<_> = reached(&uses, from).into_iter().filter(back).collect();
                circles
                    .entry(circle)
                    .or_default()
                    .push(format!("{from} uses {to}: {paths:?}"));
            }
        }
        for (circle, uses) in circles {
            report += &format!(
                "\n{name}: circle of {} files\n{}\n",
                circle.len(),
                uses.join("\n")
            );
        }
    }
    assert!(report.is_empty(), "{report}");
}

#[test]
fn cases_know_nothing_of_dynamics() {
    let uses = crate_uses("cageless");
    let dynamic = ["crate::dynamics", "crate::simd", "crate::simulation"];
    for case in uses
        .keys()
        .filter(|module| *module == "crate::case" || module.starts_with("crate::case::"))
    {
        let mut known = reached(&uses, case);
        known.retain(|module| dynamic.iter().any(|d| module.starts_with(d)));
        assert!(known.is_empty(), "{case} uses {known:?}");
    }
}

/// Layers of the core from below, by module: each uses its own layer and those below it.
const LAYERS: [(&str, &[&str]); 7] = [
    (
        "numbers",
        &[
            "control",
            "error",
            "limits",
            "named_enum",
            "numerics",
            "scope",
        ],
    ),
    (
        "geometry and contact",
        &[
            "assembly",
            "ball",
            "bearing",
            "contact",
            "equations",
            "film",
            "flank_model",
            "formulation",
            "kinematics",
            "material",
            "outer_contact_geometry",
            "raceway",
            "raceway_contact",
            "ring_support",
            "rotating_ring",
            "time_table",
            "unbalance",
        ],
    ),
    (
        "case",
        &[
            "case",
            "fit",
            "integrator",
            "linear_rotor",
            "rotor",
            "surface",
        ],
    ),
    ("equilibrium", &["equilibrium"]),
    (
        "world",
        &[
            "dynamics",
            "initial_conditions",
            "simd",
            "snapshot",
            "step_limits",
            "world",
            "film::motion",
        ],
    ),
    ("simulation", &["simulation"]),
    (
        "questions",
        &[
            "film::rest",
            "film::rolling_ball",
            "film::traction_at_rest",
            "film::unreached_arc",
            "*",
        ],
    ),
];

/// Index of the layer of a module.
fn layer(module: &str) -> usize {
    let own = module.trim_start_matches("crate::");
    let of = |name: &str| LAYERS.iter().position(|(_, names)| names.contains(&name));
    let folder = own.split("::").next().unwrap();
    [own, folder, "*"].into_iter().find_map(of).unwrap()
}

#[test]
fn no_layer_uses_one_above_it() {
    let mut up = vec![];
    for (from, to) in crate_uses("cageless") {
        for (to, paths) in to {
            if layer(&to) > layer(&from) && from != "crate" {
                up.push(format!("{from} uses {to}: {paths:?}"));
            }
        }
    }
    assert!(up.is_empty(), "{} arrows up\n{}", up.len(), up.join("\n"));
}

/// Pages take a result or a function of a study, from its module: nothing below that.
#[test]
fn pages_know_nothing_of_the_insides_of_studies() {
    let pages = crate_modules("cageless-report");
    for (page, module) in &pages {
        let imports = module.imports.iter().map(|import| &import.1);
        for path in imports.chain(&module.words) {
            let inside = path.strip_prefix("cageless_study::").is_some_and(|path| {
                path.matches("::").count() > 1 && !path.starts_with("sweep::analysis::")
            });
            let mut names = path.split("::").skip(2);
            let of_type = names
                .next()
                .is_some_and(|name| name.starts_with(char::is_uppercase));
            assert!(!inside || of_type, "{page}: {path}");
        }
    }
}
