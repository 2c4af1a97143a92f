//! Rotors with linear lateral motion.

use std::f64::consts::PI;
use std::path::PathBuf;
use std::sync::Arc;

use cageless::linear_rotor::{self, DMatrix, RotorMatrices};
use cageless_io::rotor_file::{
    RotorBody, RotorClearance, RotorDescription, RotorPlace, RotorUnbalance, write_matrices,
};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

use crate::errors::{Found, input};

/// Lateral motion of a rotor with the nodes of its bearings.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct LinearRotor {
    pub description: RotorDescription,
    rotor: linear_rotor::LinearRotor,
}

/// Node, or axial place in mm.
#[derive(FromPyObject)]
enum Place {
    Node(usize),
    AxialMm(f64),
}

impl From<Place> for RotorPlace {
    fn from(place: Place) -> Self {
        match place {
            Place::Node(node) => Self::Node(node),
            Place::AxialMm(axial_mm) => Self::AxialMm(axial_mm),
        }
    }
}

type Matrix<'py> = PyReadonlyArray2<'py, f64>;

/// Mass and elasticity.
#[derive(FromPyObject)]
enum Body<'py> {
    /// m, Ip and It of a rigid rotor.
    Rigid(f64, f64, f64),
    /// [M, Ma, C, G, K, Ksdt], number of housings, Ip, nodes that are kept, largest frequency.
    Matrices([Matrix<'py>; 6], usize, f64, Vec<usize>, Option<f64>),
}

impl LinearRotor {
    /// The rotor of a description.
    pub fn of(description: RotorDescription) -> Found<Self> {
        let rotor = description.linear()?;
        Ok(Self { description, rotor })
    }
}

#[pymethods]
impl LinearRotor {
    /// A rotor with the places of its bearings, its unbalances (place, m·ε in g·mm, direction in
    /// degrees) and clearances (name, place, radial in µm).
    #[new]
    fn new(
        body: Body<'_>,
        bearings: Vec<Place>,
        unbalances: Vec<(Place, f64, f64)>,
        clearances: Vec<(String, Place, f64)>,
    ) -> Found<Self> {
        let body = match body {
            Body::Rigid(mass_kg, polar_inertia_kg_m2, transverse_inertia_kg_m2) => {
                RotorBody::Rigid {
                    mass_kg,
                    polar_inertia_kg_m2,
                    transverse_inertia_kg_m2,
                }
            }
            Body::Matrices(arrays, housings, polar_inertia_kg_m2, kept_nodes, frequency_max_hz) => {
                let [mass, added_mass, damping, gyroscopic, stiffness, spin_up] =
                    arrays.map(|array| {
                        let array = array.as_array();
                        let (rows, columns) = array.dim();
                        DMatrix::from_fn(rows, columns, |row, column| array[[row, column]])
                    });
                RotorBody::Matrices {
                    matrices: Arc::new(RotorMatrices {
                        mass,
                        added_mass,
                        damping,
                        gyroscopic,
                        stiffness,
                        spin_up,
                        housings,
                        polar_inertia_kg_m2,
                    }),
                    frequency_max_hz,
                    kept_nodes,
                }
            }
        };
        let unbalance = |(place, amount_g_mm, angle_deg): (Place, f64, f64)| RotorUnbalance {
            place: place.into(),
            amount_g_mm,
            angle_deg,
        };
        let clearance = |(name, place, radial_um): (String, Place, f64)| RotorClearance {
            name,
            place: place.into(),
            radial_um,
        };
        Self::of(RotorDescription {
            body,
            bearings: bearings.into_iter().map(Place::into).collect(),
            unbalances: unbalances.into_iter().map(unbalance).collect(),
            clearances: clearances.into_iter().map(clearance).collect(),
        })
    }

    /// Mass, moment of inertia about the axis, part of the mass that each bearing carries and number of
    /// coordinates.
    fn numbers(&self) -> (f64, f64, Vec<f64>, usize) {
        let rotor = &self.rotor;
        let (mass_kg, inertia_kg_m2) = (rotor.mass_kg, rotor.polar_inertia_kg_m2);
        (
            mass_kg,
            inertia_kg_m2,
            rotor.mass_shares_kg(),
            rotor.coordinates(),
        )
    }

    /// Natural frequencies at rest without damping, Hz.
    fn frequencies_hz(&self) -> Vec<f64> {
        self.rotor.frequencies_hz()
    }

    /// Real and imaginary parts of the eigenvalues at a speed, 1/s.
    fn eigenvalues(&self, speed_rpm: f64) -> Found<Vec<(f64, f64)>> {
        let values = self.rotor.eigenvalues(speed_rpm * PI / 30.0);
        let values = values.ok_or_else(|| {
            input(format!(
                "speed_rpm = {speed_rpm:?} is not possible: forces at this speed are beyond the range \
                 of numbers"
            ))
        })?;
        Ok(values.iter().map(|value| (value.re, value.im)).collect())
    }

    /// Writes the matrices for a rotor file.
    fn save_matrices(&self, path: PathBuf) -> Found<()> {
        match &self.description.body {
            RotorBody::Matrices { matrices, .. } => Ok(write_matrices(&path, matrices)?),
            RotorBody::Rigid { .. } => Err(input(
                "a rigid rotor has no matrices: a rotor file gives its mass and inertia",
            )),
        }
    }
}
