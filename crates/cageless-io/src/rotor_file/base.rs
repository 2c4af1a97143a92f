//! A rotor file whose values, and those of its cases, are replaced before they are read.

use std::path::Path;
use std::sync::Arc;

use cageless::linear_rotor::RotorMatrices;

use super::address::{Address, address, is_number};
use super::matrices::matrices_of_section;
use super::read;
use super::{RotorFile, RotorFileDocument, read_matrices};
use crate::case_file::former;
use crate::case_file::overrides::Replacement;
use crate::case_file::spanned_toml::{self, Node, Section, Tree, Value};
use crate::case_file::{CaseDocument, CaseError, CaseValue, Change, read_named};

/// The texts of a rotor file and of its cases, parsed but not yet read.
#[derive(Debug, Clone)]
pub struct RotorBase {
    tree: Tree,
    cases: Vec<CaseDocument>,
    matrices: Option<Arc<RotorMatrices>>,
}

/// The sections that a file has in any number.
const LISTS: [&str; 3] = ["bearing", "unbalance", "clearance"];

impl RotorBase {
    /// Reads a rotor file and the files that it names, whose paths count from its folder.
    ///
    /// # Errors
    /// A [`CaseError`] if one of the files cannot be read or is not TOML, or a bearing has no case.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let (name, text) = read_named(path, "rotor file")?;
        Self::parse(&text, &name, path.parent().unwrap_or(Path::new("")))
    }

    pub(crate) fn parse(text: &str, name: &str, folder: &Path) -> Result<Self, CaseError> {
        let mut root = spanned_toml::parse(text, name)?;
        former::rename(&mut root, name)?;
        Self::from_sections(root, name, folder)
    }

    /// Whether this text is a rotor file rather than a case.
    pub(crate) fn is_text(text: &str) -> bool {
        spanned_toml::parse(text, "").is_ok_and(|root| Self::is_in(&root))
    }

    /// Whether these sections are of a rotor file rather than of a case: they list bearings, and
    /// not what the one bearing of a case has.
    pub(crate) fn is_in(root: &Section) -> bool {
        let of_a_case = |item: &Node| matches!(&item.value, Value::Section(section) if section.contains_key("balls"));
        match root.get("bearing").map(|node| &node.value) {
            Some(Value::List(bearings)) => !bearings.iter().any(of_a_case),
            Some(Value::Section(section)) => is_numbered(section),
            _ => false,
        }
    }

    /// Takes the sections of the file `name`; paths in it are relative to `folder`. Bearings and
    /// unbalances may be sections with the numbers 1, 2 and so on, in place of lists.
    pub(crate) fn from_sections(
        mut root: Section,
        name: &str,
        folder: &Path,
    ) -> Result<Self, CaseError> {
        for key in LISTS {
            if let Some(node) = root.get_mut(key)
                && let Value::Section(section) = &node.value
                && is_numbered(section)
            {
                node.value = listed(section).map_err(|message| {
                    let message = format!("{key}: {message}");
                    node.error(name, key, message)
                })?;
            }
        }
        let tree = Tree::new(root, name);
        read::check(&tree)?;
        let cases = read::cases(&tree, folder)?;
        let matrices = match tree.find("rotor.matrices") {
            None => None,
            Some(node) => Some(Arc::new(match &node.value {
                Value::Text(path) => read_matrices(&folder.join(path))
                    .map_err(|error| node.error_of_its_file(name, "matrices", error))?,
                Value::Section(section) => matrices_of_section(section).map_err(|message| {
                    node.error(name, "rotor.matrices", format!("rotor.matrices: {message}"))
                })?,
                _ => return Err(node.refusal(name, "rotor.matrices", "the path of their file")),
            })),
        };
        Ok(Self {
            tree,
            cases,
            matrices,
        })
    }

    /// Replaces values for good: keys of the rotor file, `section.key` of the cases of all
    /// bearings, `bearing.2.section.key` of one.
    ///
    /// # Errors
    /// A [`CaseError`] if a key has no place in the rotor file or its cases. Whether the value
    /// fits, [`RotorBase::with`] says.
    pub fn change(&mut self, changes: &[Change<'_>]) -> Result<(), CaseError> {
        let mut changes = changes.iter().map(Replacement::from_change);
        changes.try_for_each(|change| self.replace(&change))
    }

    /// The rotor with the replacements of `--set` of these texts.
    pub(super) fn overridden(mut self, overrides: &[String]) -> Result<RotorFile, CaseError> {
        for text in overrides {
            self.replace(&Replacement::from_override(text)?)?;
        }
        self.file()
    }

    fn replace(&mut self, replacement: &Replacement) -> Result<(), CaseError> {
        let path: Vec<&str> = replacement.path.iter().map(String::as_str).collect();
        let refused = |message: String| Err(replacement.error(message));
        match address(&path) {
            Err(message) => refused(message),
            Ok(Address::Rotor)
                if LISTS.contains(&path[0]) && !self.tree.root.contains_key(path[0]) =>
            {
                refused(format!("there is no [[{}]] section", path[0]))
            }
            Ok(Address::Rotor) => replacement.apply(&mut self.tree.root),
            Ok(Address::Case(None, _)) => {
                let mut cases = self.cases.iter_mut();
                cases.try_for_each(|case| case.replace(replacement))
            }
            Ok(Address::Case(Some(k), key)) => match self.cases.get_mut(k) {
                Some(case) => case.replace(&Replacement {
                    path: key.iter().map(|part| (*part).to_owned()).collect(),
                    node: replacement.node.clone(),
                }),
                None => {
                    let count = self.cases.len();
                    refused(format!(
                        "there are {count} [[bearing]] sections, counted from 1"
                    ))
                }
            },
        }
    }

    /// The rotor with `changes`.
    ///
    /// # Errors
    /// Those of [`RotorBase::change`], and for anything but a complete and possible rotor and
    /// possible cases.
    pub fn with(&self, changes: &[Change<'_>]) -> Result<RotorFile, CaseError> {
        let mut base = self.clone();
        base.change(changes)?;
        base.file()
    }

    /// The rotor with its bearings.
    fn file(&self) -> Result<RotorFile, CaseError> {
        let tree = &self.tree;
        let of_rotor = |error| read::of_rotor(tree, &error);
        let sections = read::sections(tree)?;
        let (speed_rpm, drive_torque_n_m) =
            (sections.rotor.speed_rpm.0, sections.rotor.drive_torque_n_m);
        let rotor = read::description(tree, &sections, self.matrices.as_ref())?;
        let linear = rotor.linear().map_err(of_rotor)?;
        // What belongs to the rotor as a whole need not stand in the case of a bearing.
        let own = [
            ("rotor.mass_kg", linear.mass_kg() / self.cases.len() as f64),
            ("rotor.polar_inertia_kg_m2", linear.polar_inertia_kg_m2()),
            ("rotor.speed_rpm", speed_rpm),
        ]
        .map(|(key, value)| (key, CaseValue::Number(value)));
        let line = tree.find("rotor").map_or(0, Node::line);
        let place = (tree.name.as_str(), line);
        let own = own
            .each_ref()
            .map(|(key, value)| Change { key, value, place });
        let cases = self.cases.iter().enumerate().map(|(k, case)| {
            let file = case.with(&own).and_then(|file| {
                file.checked(cageless::Case::check_motion)?;
                Ok(file)
            });
            file.map_err(|error| error.in_bearing(k))
        });
        let cases: Vec<_> = cases.collect::<Result<_, _>>()?;
        let document = RotorFileDocument {
            title: sections.head.title,
            rotor,
            speed_rpm,
            drive_torque_n_m,
            cases: cases.iter().map(|case| case.document().clone()).collect(),
        };
        RotorFile::assemble(document, linear, &cases).map_err(of_rotor)
    }
}

impl RotorFile {
    /// Reads a rotor file and the files that it names, whose paths count from its folder.
    /// `overrides` are the texts of `--set`: of keys of the rotor file, `section.key=value` of the
    /// cases of all bearings, `bearing.2.section.key=value` of one.
    ///
    /// # Errors
    /// A [`CaseError`] if one of the files cannot be read, or for anything but a complete and
    /// possible rotor and possible cases.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        RotorBase::read(path)?.overridden(overrides)
    }

    /// Parses the text of a rotor file; `name` stands for it in messages, paths in it count from
    /// `folder`.
    ///
    /// # Errors
    /// Those of [`RotorFile::read`].
    pub fn parse(
        text: &str,
        name: &str,
        folder: &Path,
        overrides: &[String],
    ) -> Result<Self, CaseError> {
        RotorBase::parse(text, name, folder)?.overridden(overrides)
    }

    /// The rotor with changes, as [`RotorFile::read`] takes them.
    ///
    /// # Errors
    /// A [`CaseError`] for anything but a complete and possible rotor and possible cases.
    pub fn changed(&self, overrides: &[String]) -> Result<Self, CaseError> {
        Self::parse(&self.document.to_toml()?, "rotor", Path::new(""), overrides)
    }
}

fn is_numbered(section: &Section) -> bool {
    !section.is_empty() && section.keys().all(|key| is_number(key))
}

/// Sections with the numbers 1, 2 and so on, as a list.
fn listed(section: &Section) -> Result<Value, String> {
    let node = |number: usize| -> Result<Node, String> {
        let found = section.get(&number.to_string()).cloned();
        found.ok_or_else(|| format!("number {number} is missing: sections are numbered from 1"))
    };
    let nodes: Result<_, _> = (1..=section.len()).map(node).collect();
    nodes.map(Value::List)
}
