//! Reading of rotor files.

use std::path::Path;
use std::sync::Arc;

use cageless::linear_rotor::{RotorError, RotorMatrices};

use super::document::SCHEMA;
use super::keys::{self, HEAD};
use super::{RotorBody, RotorClearance, RotorDescription, RotorPlace, RotorUnbalance};
use crate::case_file::spanned_toml::{Node, Section, Value, join};
use crate::case_file::{CaseDocument, CaseError, nearest};

/// Keys of a rigid rotor alone.
const RIGID: [&str; 3] = ["mass_kg", "polar_inertia_kg_m2", "transverse_inertia_kg_m2"];
/// Keys of a rotor by matrices alone.
const REDUCED: [&str; 2] = ["frequency_max_hz", "kept_nodes"];

/// Section of a rotor file.
pub(super) struct Part<'a> {
    file: &'a str,
    /// Name of the section in the table of keys; empty for the head of the file.
    section: &'static str,
    /// `bearing.2` for the second of several.
    path: String,
    pub entries: &'a Section,
}

/// The sections of a rotor file, whose keys are all known.
pub(super) struct Head<'a> {
    head: Part<'a>,
    pub rotor: Part<'a>,
    pub bearings: Vec<Part<'a>>,
    unbalances: Vec<Part<'a>>,
    clearances: Vec<Part<'a>>,
}

impl<'a> Head<'a> {
    pub(super) fn new(root: &'a Section, name: &'a str) -> Result<Self, CaseError> {
        let head = Part {
            file: name,
            section: "",
            path: String::new(),
            entries: root,
        };
        head.only_known()?;
        if let Some(node) = root.get("schema")
            && !matches!(node.value, Value::Integer(SCHEMA))
        {
            return Err(head.refuse("schema", node, &format!("{SCHEMA}")));
        }
        let Some(Value::Section(entries)) = root.get("rotor").map(|node| &node.value) else {
            let message = "[rotor] is missing: the rotor above the bearings".to_owned();
            return Err(CaseError::of_file(name, message).with_key("rotor"));
        };
        let rotor = Part {
            file: name,
            section: "rotor",
            path: "rotor".to_owned(),
            entries,
        };
        rotor.only_known()?;
        let (foreign, allowed) = match entries.contains_key("matrices") {
            true => (&RIGID[..], "left out: it follows from the matrices"),
            false => (&REDUCED[..], "left out: it belongs to a rotor by matrices"),
        };
        let mut foreign = foreign
            .iter()
            .filter_map(|key| Some((key, entries.get(*key)?)));
        if let Some((key, node)) = foreign.next() {
            return Err(rotor.refuse(key, node, allowed));
        }
        Ok(Self {
            bearings: head.list("bearing")?,
            unbalances: head.list("unbalance")?,
            clearances: head.list("clearance")?,
            head,
            rotor,
        })
    }

    /// Line of the section `[rotor]`.
    pub(super) fn line(&self) -> usize {
        self.head.entries.get("rotor").map_or(0, Node::line)
    }

    pub(super) fn title(&self) -> Result<String, CaseError> {
        match self.head.entries.get("title") {
            None => Ok(String::new()),
            Some(node) => self.head.text("title", node),
        }
    }

    pub(super) fn speed_rpm(&self) -> Result<f64, CaseError> {
        self.rotor.required("speed_rpm")
    }

    pub(super) fn drive(&self) -> Result<f64, CaseError> {
        Ok(self.rotor.number("drive_torque_n_m")?.unwrap_or(0.0))
    }
}

/// The rotor with the places of its bearings.
pub(super) fn description(
    head: &Head<'_>,
    matrices: Option<&Arc<RotorMatrices>>,
) -> Result<RotorDescription, CaseError> {
    let rotor = &head.rotor;
    let by_matrices = matrices.is_some();
    let body = match matrices {
        None => RotorBody::Rigid {
            mass_kg: rotor.required("mass_kg")?,
            polar_inertia_kg_m2: rotor.required("polar_inertia_kg_m2")?,
            transverse_inertia_kg_m2: rotor.required("transverse_inertia_kg_m2")?,
        },
        Some(matrices) => RotorBody::Matrices {
            matrices: Arc::clone(matrices),
            frequency_max_hz: rotor.number("frequency_max_hz")?,
            kept_nodes: rotor.nodes("kept_nodes")?,
        },
    };
    let bearings = head.bearings.iter().map(|part| part.place(by_matrices));
    let unbalances = head.unbalances.iter().map(|part| {
        Ok(RotorUnbalance {
            place: part.place(by_matrices)?,
            amount_g_mm: part.required("amount_g_mm")?,
            angle_deg: part.number("angle_deg")?.unwrap_or(0.0),
        })
    });
    let clearances = head.clearances.iter().map(|part| {
        let name = match part.entries.get("name") {
            Some(node) => part.text("name", node)?,
            None => return Err(part.missing("name")),
        };
        let radial_um = part.required("radial_um")?;
        if let (Some(node), true) = (part.entries.get("radial_um"), radial_um <= 0.0) {
            return Err(part.refuse("radial_um", node, "more than 0"));
        }
        Ok(RotorClearance {
            name,
            place: part.place(by_matrices)?,
            radial_um,
        })
    });
    Ok(RotorDescription {
        clearances: clearances.collect::<Result<_, CaseError>>()?,
        body,
        bearings: bearings.collect::<Result<_, _>>()?,
        unbalances: unbalances.collect::<Result<_, CaseError>>()?,
    })
}

impl<'a> Part<'a> {
    /// The case of a bearing, from its file or from the section itself.
    pub(super) fn case(&self, folder: &Path) -> Result<CaseDocument, CaseError> {
        let Some(node) = self.entries.get("case") else {
            return Err(self.missing("case"));
        };
        match &node.value {
            Value::Section(root) => Ok(CaseDocument::from_sections(root.clone(), self.file)),
            _ => CaseDocument::read(&folder.join(self.text("case", node)?))
                .map_err(|error| node.error_of_its_file(self.file, "case", error)),
        }
    }

    /// Place on the rotor, a node of one by matrices.
    fn place(&self, by_matrices: bool) -> Result<RotorPlace, CaseError> {
        let (other, allowed) = match by_matrices {
            true => ("axial_mm", "left out: a rotor by matrices has nodes, node"),
            false => ("node", "left out: a rigid rotor has places, axial_mm"),
        };
        if let Some(node) = self.entries.get(other) {
            return Err(self.refuse(other, node, allowed));
        }
        if !by_matrices {
            return Ok(RotorPlace::AxialMm(self.required("axial_mm")?));
        }
        match self.entries.get("node") {
            Some(node) => Ok(RotorPlace::Node(self.whole("node", node)?)),
            None => Err(self.missing("node")),
        }
    }

    /// A list of nodes; none if the key is left out.
    fn nodes(&self, key: &str) -> Result<Vec<usize>, CaseError> {
        match self.entries.get(key).map(|node| (&node.value, node)) {
            None => Ok(vec![]),
            Some((Value::List(items), _)) => {
                items.iter().map(|item| self.whole(key, item)).collect()
            }
            Some((_, node)) => Err(self.refuse(key, node, "a list of nodes in brackets")),
        }
    }

    /// Refuses keys that the section does not have.
    fn only_known(&self) -> Result<(), CaseError> {
        let keys: Vec<&str> = match self.section {
            "" => HEAD.to_vec(),
            section => keys::of_section(section).iter().map(|k| k.name).collect(),
        };
        let unknown = self
            .entries
            .iter()
            .find(|(key, _)| !keys.contains(&&***key));
        let Some((key, node)) = unknown else {
            return Ok(());
        };
        let hint = match nearest(key, keys.iter().copied()) {
            Some(near) => format!("did you mean {near}?"),
            None => format!("it has {}", keys.join(", ")),
        };
        let place = match self.section {
            "" => "a rotor file".to_owned(),
            section => format!("[{section}] of a rotor file"),
        };
        Err(node.error(
            self.file,
            key,
            format!("{key} is not a key of {place}; {hint}"),
        ))
    }

    /// The sections of a list `[[key]]`.
    fn list(&self, key: &'static str) -> Result<Vec<Part<'a>>, CaseError> {
        let Some(node) = self.entries.get(key) else {
            return Ok(vec![]);
        };
        let wrong = |node: &Node| self.refuse(key, node, &format!("sections [[{key}]]"));
        let Value::List(items) = &node.value else {
            return Err(wrong(node));
        };
        let parts = items.iter().enumerate().map(|(k, item)| {
            let Value::Section(entries) = &item.value else {
                return Err(wrong(item));
            };
            let part = Part {
                file: self.file,
                section: key,
                path: format!("{key}.{}", k + 1),
                entries,
            };
            part.only_known()?;
            Ok(part)
        });
        parts.collect()
    }

    fn number(&self, key: &str) -> Result<Option<f64>, CaseError> {
        let Some(node) = self.entries.get(key) else {
            return Ok(None);
        };
        match node.value {
            Value::Integer(value) => Ok(Some(value as f64)),
            Value::Number(value) if value.is_finite() => Ok(Some(value)),
            _ => Err(self.refuse(key, node, "a number, without quotes and unit")),
        }
    }

    fn required(&self, key: &str) -> Result<f64, CaseError> {
        self.number(key)?.ok_or_else(|| self.missing(key))
    }

    fn whole(&self, key: &str, node: &Node) -> Result<usize, CaseError> {
        match node.value {
            Value::Integer(value) if value >= 0 => Ok(value as usize),
            // From an axis of a plan.
            Value::Number(value) if (0.0..1e9).contains(&value) && value.fract() == 0.0 => {
                Ok(value as usize)
            }
            _ => Err(self.refuse(key, node, "a whole number, 0 or more")),
        }
    }

    fn text(&self, key: &str, node: &Node) -> Result<String, CaseError> {
        match &node.value {
            Value::Text(text) => Ok(text.clone()),
            _ => Err(self.refuse(key, node, "text in quotes")),
        }
    }

    fn missing(&self, key: &str) -> CaseError {
        let meaning = keys::find(self.section, key).map_or("", |key| key.meaning);
        let message = format!("{} is missing: {meaning}", join(&self.path, key));
        let place = self
            .entries
            .values()
            .map(Node::line)
            .filter(|line| *line > 0)
            .min();
        match place {
            Some(line) => CaseError::on_line(self.file, line, Some(key.to_owned()), message),
            None => CaseError::of_file(self.file, message).with_key(key),
        }
    }

    fn refuse(&self, key: &str, node: &Node, allowed: &str) -> CaseError {
        node.refusal(self.file, &join(&self.path, key), allowed)
    }

    /// The error of a rotor that these values give.
    pub(super) fn of_rotor(&self, error: &RotorError) -> CaseError {
        let key = match error {
            RotorError::Value { name, .. } => *name,
            RotorError::Node { .. } => "node",
            RotorError::Shape { .. } | RotorError::Property { .. } => "matrices",
            RotorError::Bearings(_) => "",
        };
        match self.entries.get(key) {
            Some(node) => node.error(self.file, &join(&self.path, key), error.to_string()),
            None => CaseError::of_file(self.file, error.to_string()),
        }
    }
}
