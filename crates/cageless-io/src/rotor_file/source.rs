//! The sections of a rotor file, whose values are replaced before they are read.

use std::path::Path;
use std::sync::Arc;

use cageless::linear_rotor::{LinearRotor, RotorMatrices};

use super::address::is_number;
use super::matrices::matrices_of_section;
use super::read;
use super::{RotorFileDocument, read_matrices};
use crate::case_file::overrides::Replacement;
use crate::case_file::spanned_toml::{Node, Section, Tree, Value};
use crate::case_file::{CaseDocument, CaseError, CaseFile, CaseValue, Change};

/// The sections of a rotor file beside the cases of its bearings, parsed but not yet read.
#[derive(Debug, Clone)]
pub(crate) struct RotorSource {
    tree: Tree,
    matrices: Option<Arc<RotorMatrices>>,
}

/// A rotor file that was read.
pub(crate) struct ReadRotor {
    /// The file with its cases and every default.
    pub document: RotorFileDocument,
    /// The lateral motion of the rotor.
    pub rotor: LinearRotor,
    /// The case of each bearing, as the file gives it.
    pub cases: Vec<CaseFile>,
}

/// The sections that a file has in any number.
const LISTS: [&str; 3] = ["bearing", "unbalance", "clearance"];

impl RotorSource {
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

    /// Takes the sections of the file `name`, with the case of each bearing; paths in it are
    /// relative to `folder`. Bearings and unbalances may be sections with the numbers 1, 2 and so
    /// on, in place of lists.
    pub(crate) fn from_sections(
        mut root: Section,
        name: &str,
        folder: &Path,
    ) -> Result<(Self, Vec<CaseDocument>), CaseError> {
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
        Ok((Self { tree, matrices }, cases))
    }

    /// Replaces the value of a key of the rotor file.
    pub(crate) fn replace(&mut self, replacement: &Replacement) -> Result<(), CaseError> {
        let section = replacement.path[0].as_str();
        match LISTS.contains(&section) && !self.tree.root.contains_key(section) {
            true => Err(replacement.error(format!("there is no [[{section}]] section"))),
            false => replacement.apply(&mut self.tree.root),
        }
    }

    /// Reads the rotor and the cases of its bearings.
    pub(crate) fn read(&self, cases: &[CaseDocument]) -> Result<ReadRotor, CaseError> {
        let tree = &self.tree;
        let sections = read::sections(tree)?;
        let (speed_rpm, drive_torque_n_m) =
            (sections.rotor.speed_rpm.0, sections.rotor.drive_torque_n_m);
        let rotor = read::description(tree, &sections, self.matrices.as_ref())?;
        let linear = rotor.linear().map_err(|error| self.refused(&error))?;
        // What belongs to the rotor as a whole need not stand in the case of a bearing.
        let own = [
            ("rotor.mass_kg", linear.mass_kg / cases.len() as f64),
            ("rotor.polar_inertia_kg_m2", linear.polar_inertia_kg_m2),
            ("rotor.speed_rpm", speed_rpm),
        ]
        .map(|(key, value)| (key, CaseValue::Number(value)));
        let line = tree.find("rotor").map_or(0, Node::line);
        let place = (tree.name.as_str(), line);
        let own = own
            .each_ref()
            .map(|(key, value)| Change { key, value, place });
        let cases = cases.iter().enumerate().map(|(k, case)| {
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
        Ok(ReadRotor {
            document,
            rotor: linear,
            cases,
        })
    }

    /// The error of a rotor that the values of the file give.
    pub(crate) fn refused(&self, error: &cageless::linear_rotor::RotorError) -> CaseError {
        read::of_rotor(&self.tree, error)
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
