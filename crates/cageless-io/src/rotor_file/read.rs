//! Reading of rotor files.

use std::path::Path;

use cageless::linear_rotor::{
    LinearRotor, NodeUnbalance, PlaneUnbalance, Reduction, RigidRotor, RotorError,
};

use super::{RotorFile, read_matrices};
use crate::case_file::spanned_toml::{self, Node, Section, Value, join};
use crate::case_file::{CaseError, CaseFile, nearest};

/// The only schema of rotor files so far.
const SCHEMA: i64 = 1;
const HEAD: [&str; 5] = ["schema", "title", "rotor", "bearing", "unbalance"];
const RIGID: [&str; 3] = ["mass_kg", "polar_inertia_kg_m2", "transverse_inertia_kg_m2"];
const ROTOR: [&str; 8] = [
    "mass_kg",
    "polar_inertia_kg_m2",
    "transverse_inertia_kg_m2",
    "matrices",
    "frequency_max_hz",
    "kept_nodes",
    "speed_rpm",
    "drive_torque_n_m",
];
const BEARING: [&str; 3] = ["case", "axial_mm", "node"];
const UNBALANCE: [&str; 4] = ["axial_mm", "node", "moment_g_mm", "phase_deg"];

const MM: f64 = 1e-3;
const G_MM: f64 = 1e-6;

/// Section of a rotor file.
struct Part<'a> {
    file: &'a str,
    /// `bearing.2` for the second of several.
    path: String,
    entries: &'a Section,
}

pub(super) fn rotor_file(
    text: &str,
    name: &str,
    folder: &Path,
    overrides: &[String],
) -> Result<RotorFile, CaseError> {
    let root = spanned_toml::parse(text, name)?;
    let head = Part {
        file: name,
        path: String::new(),
        entries: &root,
    };
    head.only(&HEAD)?;
    if let Some(node) = root.get("schema")
        && !matches!(node.value, Value::Integer(SCHEMA))
    {
        return Err(head.refuse("schema", node, &format!("{SCHEMA}")));
    }
    let title = match root.get("title") {
        None => String::new(),
        Some(node) => head.text("title", node)?,
    };
    let Some(Value::Section(entries)) = root.get("rotor").map(|node| &node.value) else {
        let message = "[rotor] is missing: the rotor above the bearings".to_owned();
        return Err(CaseError::of_file(name, message).with_key("rotor"));
    };
    let rotor = Part {
        file: name,
        path: "rotor".to_owned(),
        entries,
    };
    rotor.only(&ROTOR)?;
    let bearings = head.list("bearing", &BEARING)?;
    let unbalances = head.list("unbalance", &UNBALANCE)?;
    let speed_rpm = rotor.required("speed_rpm", "speed of the rotor when the magnets let go")?;
    let torque = rotor.number("drive_torque_n_m")?.unwrap_or(0.0);
    let linear = match entries.get("matrices") {
        None => rigid(&rotor, &bearings, &unbalances)?,
        Some(node) => by_matrices(&rotor, node, folder, &bearings, &unbalances)?,
    };
    let mut cases = vec![];
    for bearing in &bearings {
        let Some(node) = bearing.entries.get("case") else {
            return Err(bearing.missing("case", "path of the case file of this bearing"));
        };
        let path = folder.join(bearing.text("case", node)?);
        let mut changes = overrides.to_vec();
        // What belongs to the rotor as a whole need not stand in the case of a bearing.
        for (key, value) in [
            ("mass_kg", linear.mass_kg() / bearings.len() as f64),
            ("polar_inertia_kg_m2", linear.polar_inertia_kg_m2()),
            ("speed_rpm", speed_rpm),
        ] {
            changes.push(format!("rotor.{key}={value}"));
        }
        let file = CaseFile::read(&path, &changes);
        cases.push(file.map_err(|error| node.error_of_its_file(name, "case", error))?);
    }
    RotorFile::new(&title, linear, speed_rpm, torque, &cases).map_err(|e| rotor.of_rotor(&e))
}

fn rigid(
    rotor: &Part<'_>,
    bearings: &[Part<'_>],
    unbalances: &[Part<'_>],
) -> Result<LinearRotor, CaseError> {
    for key in ["frequency_max_hz", "kept_nodes"] {
        if let Some(node) = rotor.entries.get(key) {
            return Err(rotor.refuse(key, node, "left out: it belongs to a rotor by matrices"));
        }
    }
    let value = |key: &str| rotor.required(key, "of a rigid rotor; or matrices, of a flexible one");
    let place = |part: &Part<'_>| -> Result<f64, CaseError> {
        if let Some(node) = part.entries.get("node") {
            let allowed = "left out: a rigid rotor has places, axial_mm";
            return Err(part.refuse("node", node, allowed));
        }
        Ok(MM * part.required("axial_mm", "place from the mass centre along the axis")?)
    };
    let rigid = RigidRotor {
        mass_kg: value(RIGID[0])?,
        polar_inertia_kg_m2: value(RIGID[1])?,
        transverse_inertia_kg_m2: value(RIGID[2])?,
        bearing_axial_m: bearings.iter().map(place).collect::<Result<_, _>>()?,
        unbalances: (unbalances.iter())
            .map(|part| {
                Ok(PlaneUnbalance {
                    axial_m: place(part)?,
                    moment_kg_m: moment(part)?,
                    phase_rad: phase(part)?,
                })
            })
            .collect::<Result<_, CaseError>>()?,
    };
    rigid.linear().map_err(|error| rotor.of_rotor(&error))
}

fn by_matrices(
    rotor: &Part<'_>,
    matrices: &Node,
    folder: &Path,
    bearings: &[Part<'_>],
    unbalances: &[Part<'_>],
) -> Result<LinearRotor, CaseError> {
    for key in RIGID {
        if let Some(node) = rotor.entries.get(key) {
            return Err(rotor.refuse(key, node, "left out: it follows from the matrices"));
        }
    }
    let path = folder.join(rotor.text("matrices", matrices)?);
    let full = read_matrices(&path)
        .map_err(|error| matrices.error_of_its_file(rotor.file, "matrices", error))?;
    let node = |part: &Part<'_>| -> Result<usize, CaseError> {
        if let Some(node) = part.entries.get("axial_mm") {
            let allowed = "left out: a rotor by matrices has nodes, node";
            return Err(part.refuse("axial_mm", node, allowed));
        }
        match part.entries.get("node") {
            Some(node) => part.whole("node", node),
            None => Err(part.missing("node", "node of the rotor, from 0")),
        }
    };
    let kept_nodes = match rotor.entries.get("kept_nodes") {
        None => vec![],
        Some(list) => match &list.value {
            Value::List(items) => (items.iter())
                .map(|item| rotor.whole("kept_nodes", item))
                .collect::<Result<_, _>>()?,
            _ => return Err(rotor.refuse("kept_nodes", list, "a list of nodes in brackets")),
        },
    };
    let reduction = Reduction {
        bearing_nodes: bearings.iter().map(node).collect::<Result<_, _>>()?,
        kept_nodes,
        unbalances: (unbalances.iter())
            .map(|part| {
                Ok(NodeUnbalance {
                    node: node(part)?,
                    moment_kg_m: moment(part)?,
                    phase_rad: phase(part)?,
                })
            })
            .collect::<Result<_, CaseError>>()?,
        frequency_max_hz: rotor.number("frequency_max_hz")?,
    };
    full.reduce(&reduction).map_err(|e| rotor.of_rotor(&e))
}

fn moment(part: &Part<'_>) -> Result<f64, CaseError> {
    Ok(G_MM * part.required("moment_g_mm", "m·ε of the unbalance")?)
}

fn phase(part: &Part<'_>) -> Result<f64, CaseError> {
    Ok(part.number("phase_deg")?.unwrap_or(0.0).to_radians())
}

impl<'a> Part<'a> {
    /// Refuses keys that the section does not have.
    fn only(&self, keys: &[&str]) -> Result<(), CaseError> {
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
        let place = match self.path.as_str() {
            "" => "a rotor file".to_owned(),
            path => format!(
                "[{}] of a rotor file",
                path.split('.').next().unwrap_or(path)
            ),
        };
        Err(node.error(
            self.file,
            key,
            format!("{key} is not a key of {place}; {hint}"),
        ))
    }

    /// The sections of a list `[[key]]`.
    fn list(&self, key: &str, keys: &[&str]) -> Result<Vec<Part<'a>>, CaseError> {
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
                path: format!("{key}.{}", k + 1),
                entries,
            };
            part.only(keys)?;
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

    fn required(&self, key: &str, meaning: &str) -> Result<f64, CaseError> {
        self.number(key)?.ok_or_else(|| self.missing(key, meaning))
    }

    fn whole(&self, key: &str, node: &Node) -> Result<usize, CaseError> {
        match node.value {
            Value::Integer(value) if value >= 0 => Ok(value as usize),
            _ => Err(self.refuse(key, node, "a whole number, 0 or more")),
        }
    }

    fn text(&self, key: &str, node: &Node) -> Result<String, CaseError> {
        match &node.value {
            Value::Text(text) => Ok(text.clone()),
            _ => Err(self.refuse(key, node, "text in quotes")),
        }
    }

    fn missing(&self, key: &str, meaning: &str) -> CaseError {
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
    fn of_rotor(&self, error: &RotorError) -> CaseError {
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
