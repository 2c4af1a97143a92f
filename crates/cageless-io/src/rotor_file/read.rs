//! Reading of rotor files.

use std::path::Path;
use std::sync::Arc;

use cageless::linear_rotor::{RotorError, RotorMatrices};

use super::keys::{AsGiven, ROTOR_FILE, RotorSections};
use super::{RotorBody, RotorClearance, RotorDescription, RotorPlace, RotorUnbalance};
use crate::case_file::reader::missing;
use crate::case_file::spanned_toml::{Tree, Value, join, nth};
use crate::case_file::{CaseDocument, CaseError};

/// Keys of a rigid rotor alone.
const RIGID: [&str; 3] = ["mass_kg", "polar_inertia_kg_m2", "transverse_inertia_kg_m2"];
/// Keys of a rotor by matrices alone.
const REDUCED: [&str; 2] = ["frequency_max_hz", "kept_nodes"];

/// Refuses unknown keys, and keys of the other kind of rotor.
pub(super) fn check(tree: &Tree) -> Result<(), CaseError> {
    ROTOR_FILE.check_names(tree)?;
    let (foreign, allowed) = match tree.find("rotor.matrices") {
        Some(_) => (&RIGID[..], "left out: it follows from the matrices"),
        None => (&REDUCED[..], "left out: it belongs to a rotor by matrices"),
    };
    let mut foreign = foreign.iter().map(|key| join("rotor", key));
    match foreign.find(|key| tree.find(key).is_some()) {
        Some(key) => Err(tree.refusal(&key, "", allowed)),
        None => Ok(()),
    }
}

/// The case of each bearing, from its file or from the section itself.
pub(super) fn cases(tree: &Tree, folder: &Path) -> Result<Vec<CaseDocument>, CaseError> {
    let count = tree.count("bearing");
    let case = |k: usize| {
        let key = join(&nth("bearing", k, count), "case");
        let Some(node) = tree.find(&key) else {
            return Err(missing(tree, &key, ROTOR_FILE.find("bearing", "case")));
        };
        match &node.value {
            Value::Section(root) => Ok(CaseDocument::from_sections(root.clone(), &tree.name)),
            Value::Text(path) => CaseDocument::read(&folder.join(path))
                .map_err(|error| node.error_of_its_file(&tree.name, "case", error)),
            _ => Err(tree.refusal(&key, "", "the path of its file in quotes")),
        }
    };
    (0..count).map(case).collect()
}

/// Sections of a rotor file with their defaults.
pub(super) fn sections(tree: &Tree) -> Result<RotorSections, CaseError> {
    let mut tree = tree.clone();
    check(&tree)?;
    ROTOR_FILE.fill_in(&mut tree)?;
    RotorSections::read(&tree)
}

/// The rotor with the places of its bearings.
pub(super) fn description(
    tree: &Tree,
    s: &RotorSections,
    matrices: Option<&Arc<RotorMatrices>>,
) -> Result<RotorDescription, CaseError> {
    let need = |key: &str, value: Option<f64>| {
        let absent = || missing(tree, &join("rotor", key), ROTOR_FILE.find("rotor", key));
        value.ok_or_else(absent)
    };
    let rotor = &s.rotor;
    let body = match matrices {
        None => RotorBody::Rigid {
            mass_kg: need("mass_kg", rotor.mass_kg)?,
            polar_inertia_kg_m2: need("polar_inertia_kg_m2", rotor.polar_inertia_kg_m2)?,
            transverse_inertia_kg_m2: need(
                "transverse_inertia_kg_m2",
                rotor.transverse_inertia_kg_m2,
            )?,
        },
        Some(matrices) => RotorBody::Matrices {
            matrices: Arc::clone(matrices),
            frequency_max_hz: rotor.frequency_max_hz,
            kept_nodes: rotor.kept_nodes.clone().unwrap_or_default(),
        },
    };
    let by_matrices = matrices.is_some();
    let place = |section, k, axial_mm, node| place(tree, by_matrices, section, k, axial_mm, node);
    let bearings = s.bearing.iter().enumerate();
    let bearings = bearings.map(|(k, b)| place("bearing", k, b.axial_mm, b.node));
    let unbalances = s.unbalance.iter().enumerate().map(|(k, u)| {
        Ok(RotorUnbalance {
            place: place("unbalance", k, u.axial_mm, u.node)?,
            amount_g_mm: u.amount_g_mm.0,
            angle_deg: u.angle_deg.0,
        })
    });
    let clearances = s.clearance.iter().enumerate().map(|(k, c)| {
        Ok(RotorClearance {
            name: c.name.clone(),
            place: place("clearance", k, c.axial_mm, c.node)?,
            radial_um: c.radial_um.0,
        })
    });
    Ok(RotorDescription {
        body,
        bearings: bearings.collect::<Result<_, _>>()?,
        unbalances: unbalances.collect::<Result<_, CaseError>>()?,
        clearances: clearances.collect::<Result<_, CaseError>>()?,
    })
}

/// Place of section `k`, from 0, on the rotor: a node of one by matrices.
fn place(
    tree: &Tree,
    by_matrices: bool,
    section: &str,
    k: usize,
    axial_mm: Option<AsGiven>,
    node: Option<usize>,
) -> Result<RotorPlace, CaseError> {
    let (own, other, allowed) = match by_matrices {
        true => (
            "node",
            "axial_mm",
            "left out: a rotor by matrices has nodes, node",
        ),
        false => (
            "axial_mm",
            "node",
            "left out: a rigid rotor has places, axial_mm",
        ),
    };
    let path = nth(section, k, tree.count(section));
    match (by_matrices, axial_mm, node) {
        (true, Some(_), _) | (false, _, Some(_)) => {
            Err(tree.refusal(&join(&path, other), "", allowed))
        }
        (true, None, Some(node)) => Ok(RotorPlace::Node(node)),
        (false, Some(AsGiven(z)), None) => Ok(RotorPlace::AxialMm(z)),
        _ => Err(missing(
            tree,
            &join(&path, own),
            ROTOR_FILE.find(section, own),
        )),
    }
}

/// The error of a rotor that the values of a file give.
pub(super) fn of_rotor(tree: &Tree, error: &RotorError) -> CaseError {
    let key = match error {
        RotorError::Value { name, .. } => *name,
        RotorError::Node { .. } => "node",
        RotorError::Shape { .. } | RotorError::Property { .. } => "matrices",
        RotorError::Bearings(_) => "",
    };
    let key = join("rotor", key);
    match tree.find(&key) {
        Some(_) => tree.error(&key, error.to_string()),
        None => CaseError::of_file(&tree.name, error.to_string()),
    }
}
