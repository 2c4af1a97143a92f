//! A rotor with the places of its bearings, in the units of a rotor file.

use std::sync::Arc;

use cageless::linear_rotor::{
    Clearance, ClearancePlane, LinearRotor, Reduction, RigidRotor, RotorError, RotorMatrices,
    Unbalance,
};

use serde::Serialize;

use super::matrices::as_in_file;

const MM: f64 = 1e-3;
const UM: f64 = 1e-6;
const G_MM: f64 = 1e-6;

/// A rotor with the places of its bearings.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorDescription {
    /// Mass and elasticity.
    pub body: RotorBody,
    /// Place of each bearing.
    pub bearings: Vec<RotorPlace>,
    /// The unbalances.
    pub unbalances: Vec<RotorUnbalance>,
    /// The clearances to the stator.
    pub clearances: Vec<RotorClearance>,
}

/// Mass and elasticity of a rotor.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum RotorBody {
    /// A rigid rotor.
    Rigid {
        /// m, kg.
        mass_kg: f64,
        /// Ip about its axis, kg·m².
        polar_inertia_kg_m2: f64,
        /// It across its axis through the mass centre, kg·m².
        transverse_inertia_kg_m2: f64,
    },
    /// A rotor by its matrices.
    Matrices {
        /// The matrices.
        #[serde(serialize_with = "as_in_file")]
        matrices: Arc<RotorMatrices>,
        /// Modes with the kept nodes held are kept up to this frequency; all of them without it.
        #[serde(skip_serializing_if = "Option::is_none")]
        frequency_max_hz: Option<f64>,
        /// Further nodes whose displacements are kept.
        kept_nodes: Vec<usize>,
    },
}

/// Place on a rotor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RotorPlace {
    /// Distance from the mass centre of a rigid rotor along its axis, mm.
    AxialMm(f64),
    /// Node of a rotor by matrices, from 0.
    Node(usize),
}

/// An unbalance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RotorUnbalance {
    /// Plane of the unbalance.
    #[serde(flatten)]
    pub place: RotorPlace,
    /// m·ε, g·mm.
    pub amount_g_mm: f64,
    /// Direction at the start, degrees from +X, counter-clockwise.
    pub angle_deg: f64,
}

/// A clearance between rotor and stator.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RotorClearance {
    /// Name of its plane.
    pub name: String,
    /// Plane of the clearance.
    #[serde(flatten)]
    pub place: RotorPlace,
    /// Radial clearance, µm.
    pub radial_um: f64,
}

impl RotorPlace {
    fn axial_m(self) -> Result<f64, RotorError> {
        match self {
            Self::AxialMm(z) => Ok(MM * z),
            Self::Node(_) => Err(RotorError::Bearings(
                "a rigid rotor has places, axial_mm".to_owned(),
            )),
        }
    }

    fn node(self) -> Result<usize, RotorError> {
        match self {
            Self::Node(node) => Ok(node),
            Self::AxialMm(_) => Err(RotorError::Bearings(
                "a rotor by matrices has nodes, node".to_owned(),
            )),
        }
    }
}

/// Places of bearings, unbalances and clearances.
type Planes<P> = (Vec<P>, Vec<Unbalance<P>>, Vec<ClearancePlane<P>>);

impl RotorDescription {
    /// The lateral motion of the rotor.
    ///
    /// # Errors
    /// The rotor is impossible, or a place is none of its own.
    pub fn linear(&self) -> Result<LinearRotor, RotorError> {
        match &self.body {
            RotorBody::Rigid {
                mass_kg,
                polar_inertia_kg_m2,
                transverse_inertia_kg_m2,
            } => {
                let (bearing_axial_m, unbalances, clearances) = self.planes(RotorPlace::axial_m)?;
                let rigid = RigidRotor {
                    mass_kg: *mass_kg,
                    polar_inertia_kg_m2: *polar_inertia_kg_m2,
                    transverse_inertia_kg_m2: *transverse_inertia_kg_m2,
                    bearing_axial_m,
                    unbalances,
                    clearances,
                };
                rigid.linear()
            }
            RotorBody::Matrices {
                matrices,
                frequency_max_hz,
                kept_nodes,
            } => {
                let (bearing_nodes, unbalances, clearances) = self.planes(RotorPlace::node)?;
                matrices.reduce(&Reduction {
                    bearing_nodes,
                    kept_nodes: kept_nodes.clone(),
                    unbalances,
                    clearances,
                    frequency_max_hz: *frequency_max_hz,
                })
            }
        }
    }

    /// Bearings, unbalances and clearances at places of one kind.
    fn planes<P>(
        &self,
        of: fn(RotorPlace) -> Result<P, RotorError>,
    ) -> Result<Planes<P>, RotorError> {
        let unbalance = |u: &RotorUnbalance| {
            Ok(Unbalance {
                place: of(u.place)?,
                moment_kg_m: G_MM * u.amount_g_mm,
                phase_rad: u.angle_deg.to_radians(),
            })
        };
        let clearance = |c: &RotorClearance| {
            Ok(ClearancePlane {
                place: of(c.place)?,
                clearance: Clearance {
                    name: c.name.clone(),
                    radial_m: UM * c.radial_um,
                },
            })
        };
        Ok((
            self.bearings
                .iter()
                .map(|b| of(*b))
                .collect::<Result<_, _>>()?,
            self.unbalances
                .iter()
                .map(unbalance)
                .collect::<Result<_, _>>()?,
            self.clearances
                .iter()
                .map(clearance)
                .collect::<Result<_, _>>()?,
        ))
    }
}
