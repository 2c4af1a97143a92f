//! Reader of plans.

use std::path::Path;

use super::conflict;
use super::key::{key_in_case, order};
use super::{
    Axis, Kept, PlanBase, PlanFile, SampleMethod, Samples, Scatter, ScatteredKey, VariantFile,
};
use cageless_results::Computation;

use crate::case_file::format::SCHEMA;
use crate::case_file::named::Named;
use crate::case_file::sections::CASE_FILE;
use crate::case_file::spanned_toml::{self, Node, Section, Value};
use crate::case_file::{
    CaseDocument, CaseError, CaseValue, Change, former, keys, nearest, read_text,
};
use crate::rotor_file::address::{address, is_number};
use crate::rotor_file::keys::ROTOR_FILE;
use crate::rotor_file::{RotorBase, RotorFile};

/// Keys of the top level of a plan, sections last.
const HEAD: [&str; 10] = [
    "schema", "title", "seed", "compute", "keep", "case", "set", "grid", "samples", "scatter",
];
/// Keys of a case that say nothing about the bearing.
const FIXED: [&str; 2] = ["schema", "title"];

impl PlanFile {
    /// Reads a plan and its base case, whose path counts from the folder of the plan.
    ///
    /// # Errors
    /// A [`CaseError`] if one of the files cannot be read, or for anything but a complete
    /// plan of a possible base case.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let name = path.display().to_string();
        let text = read_text(path, "plan").map_err(|m| CaseError::of_file(&name, m))?;
        Self::parse(&text, &name, path.parent().unwrap_or(Path::new("")))
    }

    /// Parses the text of a plan; `name` stands for it in messages, `folder` is where the
    /// path of its case counts from.
    ///
    /// # Errors
    /// Those of [`PlanFile::read`].
    pub fn parse(text: &str, name: &str, folder: &Path) -> Result<Self, CaseError> {
        plan(text, name, folder)
    }
}

fn plan(text: &str, name: &str, folder: &Path) -> Result<PlanFile, CaseError> {
    let mut root = spanned_toml::parse(text, name)?;
    former::rename(&mut root, name)?;
    let mut reader = PlanReader {
        root: &root,
        name,
        of_rotor: false,
    };
    reader.check_head()?;
    reader.schema()?;
    let case = reader.base(folder)?;
    reader.of_rotor = matches!(case, PlanBase::Rotor(_));
    let mut base = case.clone();
    let set = reader.set()?;
    let changes: Vec<_> = set
        .iter()
        .map(|(key, value, line)| Change {
            key,
            value,
            place: (name, *line),
        })
        .collect();
    base.change(&changes)?;
    let base_file = base.with(&[])?;
    let plan = PlanFile {
        name: name.to_owned(),
        title: reader.text("title")?.unwrap_or_default(),
        seed: reader.count("", "seed", reader.root, 0)?.unwrap_or(0),
        grid: reader.grid()?,
        samples: reader.samples()?,
        scatter: reader.scatter()?,
        compute: reader.compute(&base_file)?,
        keep: reader.keep()?,
        base,
        base_file,
    };
    conflict::check(&plan, &case, &changes)?;
    Ok(plan)
}

pub(super) struct PlanReader<'a> {
    root: &'a Section,
    name: &'a str,
    /// Whether the keys are those of a rotor above several bearings.
    of_rotor: bool,
}

/// A key of the base somewhere below a section of the plan.
pub(super) struct Entry<'a> {
    pub key: String,
    pub node: &'a Node,
}

impl<'a> PlanReader<'a> {
    fn check_head(&self) -> Result<(), CaseError> {
        let unknown = self.root.iter().filter(|(key, _)| !HEAD.contains(&&***key));
        let Some((key, node)) = unknown.min_by_key(|(_, node)| node.line()) else {
            return Ok(());
        };
        let hint = match nearest(key, HEAD.into_iter()) {
            Some(near) => format!("did you mean {near}?"),
            None => format!("a plan has {}", HEAD.join(", ")),
        };
        Err(self.error(node, key, format!("{key} is not a key of a plan; {hint}")))
    }

    fn schema(&self) -> Result<(), CaseError> {
        match self.root.get("schema") {
            None => Ok(()),
            Some(node) if matches!(node.value, Value::Integer(v) if v == SCHEMA as i64) => Ok(()),
            Some(node) => Err(self.refuse(
                "schema",
                node,
                &format!("{SCHEMA}, the only schema of plans that this version of Cageless reads"),
            )),
        }
    }

    fn base(&self, folder: &Path) -> Result<PlanBase, CaseError> {
        match self.root.get("case").map(|node| (&node.value, node)) {
            Some((Value::Text(path), node)) => {
                let path = folder.join(path);
                let base = match RotorFile::is_at(&path) {
                    true => RotorBase::read(&path).map(PlanBase::Rotor),
                    false => CaseDocument::read(&path).map(PlanBase::Case),
                };
                base.map_err(|error| node.error_of_its_file(self.name, "case", error))
            }
            Some((Value::Section(root), _)) if RotorBase::is_in(root) => {
                RotorBase::from_sections(root.clone(), self.name, folder).map(PlanBase::Rotor)
            }
            Some((Value::Section(root), _)) => {
                let base = CaseDocument::from_sections(root.clone(), self.name);
                Ok(PlanBase::Case(base))
            }
            Some((_, node)) => Err(self.refuse(
                "case",
                node,
                "the path of a case file or of a rotor file in quotes, or the case itself, [case]",
            )),
            None => Err(CaseError::of_file(
                self.name,
                "case is missing: the path of a case file or of a rotor file, or the case itself, \
                 [case]"
                    .to_owned(),
            )
            .with_key("case")),
        }
    }

    fn set(&self) -> Result<Vec<(String, CaseValue, usize)>, CaseError> {
        let mut changes = Vec::new();
        for Entry { key, node } in self.entries("set", &[])? {
            let Some(value) = CaseValue::from_toml(&node.value) else {
                return Err(self.refuse(&key, node, "a number, a name or a list of numbers"));
            };
            changes.push((key, value, node.line()));
        }
        Ok(changes)
    }

    fn grid(&self) -> Result<Vec<Axis>, CaseError> {
        let mut axes = Vec::new();
        for entry in self.entries("grid", &[])? {
            axes.push(self.axis(entry, true)?);
        }
        Ok(axes)
    }

    fn samples(&self) -> Result<Option<Samples>, CaseError> {
        let Some(section) = self.section("samples")? else {
            return Ok(None);
        };
        let head = &self.root["samples"];
        let allowed = SampleMethod::choices();
        let Some(node) = section.get("method") else {
            let message = format!("samples.method is missing: {allowed}");
            return Err(self.error(head, "samples.method", message));
        };
        let method = SampleMethod::of_node(node)
            .ok_or_else(|| self.refuse("samples.method", node, &allowed))?;
        let Some(count) = self.count("samples", "count", section, 1)? else {
            let message = "samples.count is missing: the number of points".to_owned();
            return Err(self.error(head, "samples.count", message));
        };
        let mut axes = Vec::new();
        for entry in self.entries("samples", &["method", "count"])? {
            axes.push(self.axis(entry, false)?);
        }
        if axes.is_empty() {
            let message = "samples has no axes: section.key = { from = …, to = … }".to_owned();
            return Err(self.error(head, "samples", message));
        }
        Ok(Some(Samples {
            method,
            count,
            axes,
        }))
    }

    fn scatter(&self) -> Result<Option<Scatter>, CaseError> {
        let Some(section) = self.section("scatter")? else {
            return Ok(None);
        };
        let repeats = self.count("scatter", "repeats", section, 1)?.unwrap_or(1);
        let mut list = Vec::new();
        for Entry { key, node } in self.entries("scatter", &["repeats"])? {
            let law = self.law(&key, node)?;
            let line = node.line();
            list.push(ScatteredKey { key, law, line });
        }
        if list.is_empty() {
            let message =
                "scatter has no keys: section.key = { normal = … } or { uniform = … }".to_owned();
            return Err(self.error(&self.root["scatter"], "scatter", message));
        }
        Ok(Some(Scatter {
            repeats,
            keys: list,
        }))
    }

    fn compute(&self, base: &VariantFile) -> Result<Vec<Computation>, CaseError> {
        let allowed = format!("a list of {}", Computation::choices());
        let Some(node) = self.root.get("compute") else {
            let message = format!("compute is missing: {allowed}");
            return Err(CaseError::of_file(self.name, message).with_key("compute"));
        };
        let refused = || self.refuse("compute", node, &allowed);
        let Value::List(items) = &node.value else {
            return Err(refused());
        };
        let list: Option<Vec<_>> = items.iter().map(Computation::of_node).collect();
        let Some(mut list) = list.filter(|list| !list.is_empty()) else {
            return Err(refused());
        };
        // In the order in which they are done.
        list.sort_unstable();
        list.dedup();
        match base {
            VariantFile::Case(file)
                if list.contains(&Computation::Drop) && file.case().rotor.is_none() =>
            {
                let message = format!("compute has \"drop\", but {}", keys::missing_rotor());
                return Err(self.error(node, "compute", message));
            }
            VariantFile::Rotor(_) => {
                if let Some(other) = list.iter().find(|c| **c != Computation::Drop) {
                    let message = format!(
                        "compute has \"{}\", which is for the case of one bearing; of a rotor \
                         on several there is \"drop\"",
                        other.name()
                    );
                    return Err(self.error(node, "compute", message));
                }
            }
            VariantFile::Case(_) => {}
        }
        Ok(list)
    }

    fn keep(&self) -> Result<Option<Vec<Kept>>, CaseError> {
        let Some(node) = self.root.get("keep") else {
            return Ok(None);
        };
        let refused = || self.refuse("keep", node, "a list of columns in quotes");
        let Value::List(items) = &node.value else {
            return Err(refused());
        };
        let column = |item: &Node| match &item.value {
            Value::Text(name) => Some(Kept {
                name: name.clone(),
                line: item.line(),
            }),
            _ => None,
        };
        let list: Option<Vec<_>> = items.iter().map(column).collect();
        list.map(Some).ok_or_else(refused)
    }

    /// The keys of the base below a section of the plan, in the order of the file format; `own`
    /// are keys of the plan itself.
    fn entries(&self, name: &str, own: &[&str]) -> Result<Vec<Entry<'a>>, CaseError> {
        let mut entries = Vec::new();
        for (section, node) in self.section(name)?.into_iter().flatten() {
            if !own.contains(&section.as_str()) {
                self.of_section(name, "", section, node, &mut entries)?;
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

    /// The keys of a section of the case, or with `prefix` of the case of one bearing.
    fn of_section(
        &self,
        name: &str,
        prefix: &str,
        section: &str,
        node: &'a Node,
        entries: &mut Vec<Entry<'a>>,
    ) -> Result<(), CaseError> {
        let path = format!("{prefix}{section}");
        let Value::Section(inner) = &node.value else {
            // A key in quotes, as in Python: "solver.duration_s".
            let in_case = key_in_case(section);
            if let Some((of, numbered)) = in_case.split_once('.') {
                let bearing = &section[..section.len() - in_case.len()];
                let key = numbered.rsplit_once('.').map_or(numbered, |(_, key)| key);
                let prefix = format!("{prefix}{bearing}");
                return self.entry(&prefix, of, numbered, key, node, entries);
            }
            let hint = match keys::all().find(|(_, k)| k.name == section) {
                Some((of, k)) if !of.is_empty() => format!("did you mean {prefix}{of}.{}?", k.name),
                Some(_) => "it does not vary".to_owned(),
                None => format!("a key is written {prefix}section.key"),
            };
            let message = format!("{name}.{path} is not a key of a case file; {hint}");
            return Err(self.error(node, &path, message));
        };
        let of_rotor = self.of_rotor && prefix.is_empty();
        let is_of_rotor = of_rotor && ROTOR_FILE.has_section(section);
        if !is_of_rotor && !CASE_FILE.has_section(section) {
            let message = format!(
                "{path} is not a section of a case file; {}",
                CASE_FILE.hint("", section)
            );
            return Err(self.error(node, &path, message));
        }
        for (key, node) in inner {
            let of_one = match &node.value {
                Value::Section(of_one) if is_number(key) => of_one,
                _ => {
                    self.entry(prefix, section, key, key, node, entries)?;
                    continue;
                }
            };
            for (inner_key, node) in of_one {
                let in_case = of_rotor
                    && section == "bearing"
                    && ROTOR_FILE.find(section, inner_key).is_none();
                if in_case {
                    let prefix = format!("bearing.{key}.");
                    self.of_section(name, &prefix, inner_key, node, entries)?;
                } else {
                    let numbered = format!("{key}.{inner_key}");
                    self.entry(prefix, section, &numbered, inner_key, node, entries)?;
                }
            }
        }
        Ok(())
    }

    /// The key `key` of a section, after its number if there is one: `numbered`.
    fn entry(
        &self,
        prefix: &str,
        section: &str,
        numbered: &str,
        key: &str,
        node: &'a Node,
        entries: &mut Vec<Entry<'a>>,
    ) -> Result<(), CaseError> {
        let path = format!("{prefix}{section}.{numbered}");
        let of_rotor = self.of_rotor && prefix.is_empty();
        let in_case = keys::find(section, key).is_some() && !FIXED.contains(&key);
        let is_key = in_case || of_rotor && ROTOR_FILE.find(section, key).is_some();
        if !is_key {
            let own = ROTOR_FILE.of_section(section).iter().map(|key| key.name);
            let is_own =
                of_rotor && (!CASE_FILE.has_section(section) || nearest(key, own).is_some());
            let format = if is_own { &ROTOR_FILE } else { &CASE_FILE };
            let hint = format.hint(section, key);
            let message = format!("{path} is not a key of [{section}]; {hint}");
            return Err(self.error(node, &path, message));
        }
        if self.of_rotor {
            let parts: Vec<&str> = path.split('.').collect();
            if let Err(why) = address(&parts) {
                return Err(self.error(node, &path, format!("{path}: {why}")));
            }
        }
        if section == "search" {
            let message = format!(
                "{path} is for `cageless design --search`: it changes nothing that a sweep computes"
            );
            return Err(self.error(node, &path, message));
        }
        entries.push(Entry { key: path, node });
        Ok(())
    }

    fn section(&self, name: &str) -> Result<Option<&'a Section>, CaseError> {
        match self.root.get(name).map(|node| (&node.value, node)) {
            None => Ok(None),
            Some((Value::Section(section), _)) => Ok(Some(section)),
            Some((_, node)) => Err(self.refuse(name, node, &format!("a section, [{name}]"))),
        }
    }

    fn text(&self, name: &str) -> Result<Option<String>, CaseError> {
        match self.root.get(name).map(|node| (&node.value, node)) {
            None => Ok(None),
            Some((Value::Text(text), _)) => Ok(Some(text.clone())),
            Some((_, node)) => Err(self.refuse(name, node, "text in quotes")),
        }
    }

    pub(super) fn count(
        &self,
        prefix: &str,
        name: &str,
        section: &Section,
        least: i64,
    ) -> Result<Option<u64>, CaseError> {
        let Some(node) = section.get(name) else {
            return Ok(None);
        };
        match node.value {
            Value::Integer(n) if n >= least => Ok(Some(n as u64)),
            _ => Err(self.refuse(
                &spanned_toml::join(prefix, name),
                node,
                &format!("a whole number, {least} or more"),
            )),
        }
    }

    pub(super) fn refuse(&self, key: &str, node: &Node, allowed: &str) -> CaseError {
        node.refusal(self.name, key, allowed)
    }

    pub(super) fn error(&self, node: &Node, key: &str, message: String) -> CaseError {
        node.error(self.name, key, message)
    }
}
