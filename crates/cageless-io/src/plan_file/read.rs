//! Reader of plans.

use std::path::Path;

use super::conflict;
use super::key::order;
use super::keys::{BaseKeys, PLAN, PlanSections};
use super::{Axis, PlanFile, Samples, Scatter, ScatteredKey};
use cageless_results::Computation;

use crate::arrangement::{ArrangementDocument, BearingArrangement};
use crate::case_file::sections::CASE_FILE;
use crate::case_file::spanned_toml::{self, Node, Tree, Value};
use crate::case_file::{CaseError, CaseValue, Change, former, keys, nearest, read_named};
use crate::rotor_file::address::{address, is_number};
use crate::rotor_file::keys::ROTOR_FILE;

impl PlanFile {
    /// Reads a plan and its base case, whose path counts from the folder of the plan.
    ///
    /// # Errors
    /// A [`CaseError`] if one of the files cannot be read, or for anything but a complete
    /// plan of a possible base case.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let (name, text) = read_named(path, "plan")?;
        Self::parse(&text, &name, path.parent().unwrap_or(Path::new("")))
    }

    /// Parses the text of a plan; `name` stands for it in messages, `folder` is where the
    /// path of its case counts from.
    ///
    /// # Errors
    /// Those of [`PlanFile::read`].
    pub fn parse(text: &str, name: &str, folder: &Path) -> Result<Self, CaseError> {
        let mut root = spanned_toml::parse(text, name)?;
        former::rename(&mut root, name)?;
        let mut tree = Tree::new(root, name);
        check_head(&tree)?;
        PLAN.fill_in(&mut tree)?;
        let PlanSections {
            head,
            set: BaseKeys,
            grid: BaseKeys,
            samples,
            scatter,
        } = PlanSections::read(&tree)?;
        let case = base(&tree, folder)?;
        let reader = PlanReader {
            tree: &tree,
            of_rotor: case.is_rotor_file(),
        };
        let mut base = case.clone();
        let set = reader.set()?;
        let changes: Vec<_> = set
            .iter()
            .map(|(key, value, line)| Change::new(key, value, (name, *line)))
            .collect();
        base.change(&changes)?;
        let base_file = base.with(&[])?;
        check_computations(&tree, &head.compute, &base_file)?;
        let grid = reader.entries("grid")?.into_iter();
        let samples = samples.map(|given| {
            Ok(Samples {
                method: given.method,
                count: given.count,
                axes: reader.sampled_axes()?,
            })
        });
        let scatter = scatter.map(|given| {
            Ok(Scatter {
                repeats: given.repeats,
                keys: reader.scattered_keys()?,
            })
        });
        let plan = Self {
            name: name.to_owned(),
            title: head.title,
            seed: head.seed,
            grid: grid
                .map(|entry| reader.axis(entry, true))
                .collect::<Result<_, _>>()?,
            samples: samples.transpose()?,
            scatter: scatter.transpose()?,
            compute: head.compute,
            keep: head.keep,
            base,
            base_file,
        };
        conflict::check(&plan, &case, &changes)?;
        Ok(plan)
    }
}

/// Hint for a key without its section, of one bearing or of all.
fn hint_without_section(bearing: &str, key: &str) -> String {
    match keys::all().find(|(_, k)| k.name == key) {
        Some((of, k)) if !of.is_empty() => format!("did you mean {bearing}{of}.{}?", k.name),
        Some(_) => "it does not vary".to_owned(),
        None => format!("a key is written {bearing}section.key"),
    }
}

/// Refuses another schema, and unknown names at the head of the plan.
fn check_head(tree: &Tree) -> Result<(), CaseError> {
    PLAN.check_schema(tree)?;
    let keys = PLAN.head.iter().map(|key| key.name);
    let names: Vec<&str> = keys.chain(PLAN.sections.iter().map(|s| s.name)).collect();
    let unknown = tree
        .root
        .iter()
        .filter(|(key, _)| !names.contains(&&***key));
    let Some((key, node)) = unknown.min_by_key(|(_, node)| node.line()) else {
        return Ok(());
    };
    let hint = match nearest(key, names.iter().copied()) {
        Some(near) => format!("did you mean {near}?"),
        None => format!("a plan has {}", names.join(", ")),
    };
    let message = format!("{key} is not a key of a plan; {hint}");
    Err(node.error(&tree.name, key, message))
}

/// The case or the rotor file, unchanged.
fn base(tree: &Tree, folder: &Path) -> Result<ArrangementDocument, CaseError> {
    let node = &tree.root["case"];
    match &node.value {
        Value::Section(root) => {
            ArrangementDocument::from_sections(root.clone(), &tree.name, folder)
        }
        Value::Text(path) => ArrangementDocument::read(&folder.join(path))
            .map_err(|error| node.error_of_its_file(&tree.name, "case", error)),
        _ => Err(node.refusal(&tree.name, "case", "a path")),
    }
}

/// Refuses computations that are not of such a base.
fn check_computations(
    tree: &Tree,
    list: &[Computation],
    base: &BearingArrangement,
) -> Result<(), CaseError> {
    let is_foreign = |computation: &&Computation| match **computation {
        Computation::Drop => base.drop().is_none(),
        _ => base.case().is_none(),
    };
    let why = match list.iter().find(is_foreign) {
        None => return Ok(()),
        Some(Computation::Drop) => format!("\"drop\", but {}", keys::missing_rotor()),
        Some(other) => format!(
            "\"{}\", which is for the case of one bearing; of a rotor on several there is \"drop\"",
            other.name()
        ),
    };
    Err(tree.error("compute", format!("compute has {why}")))
}

/// Reader of the keys of the base below the sections of a plan.
pub(super) struct PlanReader<'a> {
    pub tree: &'a Tree,
    /// Whether the keys are those of a rotor above several bearings.
    of_rotor: bool,
}

/// A key of the base somewhere below a section of the plan.
pub(super) struct Entry<'a> {
    pub key: String,
    pub node: &'a Node,
}

impl<'a> PlanReader<'a> {
    fn set(&self) -> Result<Vec<(String, CaseValue, usize)>, CaseError> {
        let entries = self.entries("set")?.into_iter();
        let change = |Entry { key, node }: Entry<'_>| match CaseValue::from_toml(&node.value) {
            Some(value) => Ok((key, value, node.line())),
            None => Err(self.refuse(&key, node, "a number, a name or a list of numbers")),
        };
        entries.map(change).collect()
    }

    /// [`PlanReader::entries`], one at least.
    fn entries_of(&self, name: &str, what: &str) -> Result<Vec<Entry<'a>>, CaseError> {
        let entries = self.entries(name)?;
        if entries.is_empty() {
            return Err(self.tree.error(name, format!("{name} has no {what}")));
        }
        Ok(entries)
    }

    /// The keys of the base below a section of the plan, in the order of the file format.
    fn entries(&self, name: &str) -> Result<Vec<Entry<'a>>, CaseError> {
        let mut entries = Vec::new();
        if let Some(Value::Section(section)) = self.tree.root.get(name).map(|node| &node.value) {
            for (key, node) in section {
                if PLAN.find(name, key).is_none() {
                    self.collect(name, key.clone(), node, &mut entries)?;
                }
            }
        }
        entries.sort_by_key(|entry: &Entry<'_>| order(&entry.key));
        let twice = entries.windows(2).find(|pair| pair[0].key == pair[1].key);
        if let Some([_, Entry { key, node }]) = twice {
            let message = format!("{name}.{key} is given twice, in quotes and without");
            return Err(self.error(node, key, message));
        }
        Ok(entries)
    }

    fn sampled_axes(&self) -> Result<Vec<Axis>, CaseError> {
        let axes = self.entries_of("samples", "axes: section.key = { from = …, to = … }")?;
        let axes = axes.into_iter().map(|entry| self.axis(entry, false));
        axes.collect()
    }

    fn scattered_keys(&self) -> Result<Vec<ScatteredKey>, CaseError> {
        let keys = "keys: section.key = { normal = … } or { uniform = … }";
        let keys = self.entries_of("scatter", keys)?.into_iter();
        let keys = keys.map(|Entry { key, node }| {
            let (law, line) = (self.law(&key, node)?, node.line());
            Ok(ScatteredKey { key, law, line })
        });
        keys.collect()
    }

    /// Adds the keys of the base at `path` below the section `name` of the plan. A part of the path
    /// may be a dotted key in quotes, as in Python: "solver.duration_s".
    fn collect(
        &self,
        name: &str,
        path: String,
        node: &'a Node,
        entries: &mut Vec<Entry<'a>>,
    ) -> Result<(), CaseError> {
        let (bearing, in_case) = self.of_bearing(&path);
        let parts: Vec<&str> = in_case.split('.').collect();
        let (section, key) = (parts[0], parts[parts.len() - 1]);
        let refused = |path: &str, what: &str, hint: String| {
            Err(self.error(node, path, format!("{what}; {hint}")))
        };
        if !matches!(node.value, Value::Section(_)) && parts.len() == 1 {
            let what = format!("{name}.{path} is not a key of a case file");
            return refused(&path, &what, hint_without_section(bearing, key));
        }
        let of_rotor = self.of_rotor && bearing.is_empty();
        if !(CASE_FILE.has_section(section) || of_rotor && ROTOR_FILE.has_section(section)) {
            let (path, hint) = (format!("{bearing}{section}"), CASE_FILE.hint("", section));
            return refused(
                &path,
                &format!("{path} is not a section of a case file"),
                hint,
            );
        }
        if let (Value::Section(inner), true) = (&node.value, is_section(&parts)) {
            let mut inner = inner.iter();
            return inner.try_for_each(|(key, node)| {
                self.collect(name, format!("{path}.{key}"), node, entries)
            });
        }
        let own = of_rotor && ROTOR_FILE.find(section, key).is_some();
        if !own && keys::find(section, key).is_none() {
            let own = ROTOR_FILE.of_section(section).iter().map(|key| key.name);
            let is_own =
                of_rotor && (!CASE_FILE.has_section(section) || nearest(key, own).is_some());
            let format = if is_own { &ROTOR_FILE } else { &CASE_FILE };
            let what = format!("{path} is not a key of [{section}]");
            return refused(&path, &what, format.hint(section, key));
        }
        let parts: Vec<&str> = path.split('.').collect();
        if let Err(why) = address(self.of_rotor, &parts) {
            return Err(self.error(node, &path, format!("{path}: {why}")));
        }
        if section == "search" {
            let what = format!("{path} is for `cageless design --search`");
            let message = format!("{what}: it changes nothing that a sweep computes");
            return Err(self.error(node, &path, message));
        }
        entries.push(Entry { key: path, node });
        Ok(())
    }

    /// `bearing.2.` of a key in the case of one of several bearings, and the key there.
    fn of_bearing<'p>(&self, path: &'p str) -> (&'p str, &'p str) {
        let parts: Vec<&str> = path.split('.').collect();
        match *parts {
            ["bearing", number, key, ..]
                if self.of_rotor
                    && is_number(number)
                    && ROTOR_FILE.find("bearing", key).is_none() =>
            {
                path.split_at("bearing..".len() + number.len())
            }
            _ => ("", path),
        }
    }

    pub(super) fn refuse(&self, key: &str, node: &Node, allowed: &str) -> CaseError {
        node.refusal(&self.tree.name, key, allowed)
    }

    pub(super) fn error(&self, node: &Node, key: &str, message: String) -> CaseError {
        node.error(&self.tree.name, key, message)
    }
}

/// Whether keys stand below a path: of a section, or of one of several.
fn is_section(parts: &[&str]) -> bool {
    match parts {
        [_] => true,
        [_, number] => is_number(number),
        _ => false,
    }
}
