//! Rotors with linear lateral motion.

use std::path::PathBuf;
use std::sync::Arc;

use cageless::linear_rotor::{self, DMatrix, RotorError, RotorMatrices};
use cageless_io::rotor_file::{
    RotorBody, RotorClearance, RotorDescription, RotorPlace, RotorUnbalance, write_matrices,
};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

use crate::errors::{input, of_results};

/// Lateral motion of a rotor with the nodes of its bearings.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct LinearRotor {
    pub description: RotorDescription,
    rotor: linear_rotor::LinearRotor,
}

/// Axial place in mm or node, m·ε in g·mm, direction in degrees.
type Unbalance<T> = (T, f64, f64);

pub fn refused(error: &RotorError) -> PyErr {
    input(error.to_string())
}

fn unbalances<T: Copy>(
    values: &[Unbalance<T>],
    place: impl Fn(T) -> RotorPlace,
) -> Vec<RotorUnbalance> {
    let unbalance = |(at, amount_g_mm, angle_deg): &Unbalance<T>| RotorUnbalance {
        place: place(*at),
        amount_g_mm: *amount_g_mm,
        angle_deg: *angle_deg,
    };
    values.iter().map(unbalance).collect()
}

/// Name, axial place in mm or node, radial clearance in µm.
type Clearance<T> = (String, T, f64);

fn clearances<T: Copy>(
    values: &[Clearance<T>],
    place: impl Fn(T) -> RotorPlace,
) -> Vec<RotorClearance> {
    let clearance = |(name, at, radial_um): &Clearance<T>| RotorClearance {
        name: name.clone(),
        place: place(*at),
        radial_um: *radial_um,
    };
    values.iter().map(clearance).collect()
}

impl LinearRotor {
    /// The rotor of a description.
    pub fn new(description: RotorDescription) -> PyResult<Self> {
        let rotor = description.linear().map_err(|error| refused(&error))?;
        Ok(Self { description, rotor })
    }
}

#[pymethods]
impl LinearRotor {
    /// A rigid rotor.
    #[staticmethod]
    fn rigid(
        mass_kg: f64,
        polar_inertia_kg_m2: f64,
        transverse_inertia_kg_m2: f64,
        bearing_axial_mm: Vec<f64>,
        unbalances: Vec<Unbalance<f64>>,
        clearances: Vec<Clearance<f64>>,
    ) -> PyResult<Self> {
        Self::new(RotorDescription {
            body: RotorBody::Rigid {
                mass_kg,
                polar_inertia_kg_m2,
                transverse_inertia_kg_m2,
            },
            bearings: bearing_axial_mm
                .into_iter()
                .map(RotorPlace::AxialMm)
                .collect(),
            unbalances: self::unbalances(&unbalances, RotorPlace::AxialMm),
            clearances: self::clearances(&clearances, RotorPlace::AxialMm),
        })
    }

    /// A rotor by M, C, G, K and Ksdt, four coordinates a node.
    #[staticmethod]
    #[expect(clippy::too_many_arguments, reason = "the matrices of a rotor")]
    fn from_matrices(
        mass: PyReadonlyArray2<'_, f64>,
        damping: PyReadonlyArray2<'_, f64>,
        gyroscopic: PyReadonlyArray2<'_, f64>,
        stiffness: PyReadonlyArray2<'_, f64>,
        spin_up: PyReadonlyArray2<'_, f64>,
        polar_inertia_kg_m2: f64,
        nodes: Vec<usize>,
        kept_nodes: Vec<usize>,
        unbalances: Vec<Unbalance<usize>>,
        clearances: Vec<Clearance<usize>>,
        frequency_max_hz: Option<f64>,
    ) -> PyResult<Self> {
        let matrix = |array: &PyReadonlyArray2<'_, f64>| {
            let array = array.as_array();
            let (rows, columns) = array.dim();
            DMatrix::from_fn(rows, columns, |row, column| array[[row, column]])
        };
        let matrices = RotorMatrices {
            mass: matrix(&mass),
            damping: matrix(&damping),
            gyroscopic: matrix(&gyroscopic),
            stiffness: matrix(&stiffness),
            spin_up: matrix(&spin_up),
            polar_inertia_kg_m2,
        };
        Self::new(RotorDescription {
            body: RotorBody::Matrices {
                matrices: Arc::new(matrices),
                frequency_max_hz,
                kept_nodes,
            },
            bearings: nodes.into_iter().map(RotorPlace::Node).collect(),
            unbalances: self::unbalances(&unbalances, RotorPlace::Node),
            clearances: self::clearances(&clearances, RotorPlace::Node),
        })
    }

    #[getter]
    fn mass_kg(&self) -> f64 {
        self.rotor.mass_kg()
    }

    #[getter]
    fn polar_inertia_kg_m2(&self) -> f64 {
        self.rotor.polar_inertia_kg_m2()
    }

    #[getter]
    fn mass_shares_kg(&self) -> Vec<f64> {
        self.rotor.mass_shares_kg()
    }

    #[getter]
    fn coordinates(&self) -> usize {
        self.rotor.coordinates()
    }

    /// Real and imaginary parts of the eigenvalues at a speed, 1/s.
    fn eigenvalues(&self, speed_rad_s: f64) -> Vec<(f64, f64)> {
        let values = self.rotor.eigenvalues(speed_rad_s).into_iter();
        values.map(|value| (value.re, value.im)).collect()
    }

    /// Writes the matrices for a rotor file.
    fn save_matrices(&self, path: PathBuf) -> PyResult<()> {
        let RotorBody::Matrices { matrices, .. } = &self.description.body else {
            return Err(input(
                "a rigid rotor has no matrices: a rotor file gives its mass and inertia".to_owned(),
            ));
        };
        write_matrices(&path, matrices).map_err(|error| of_results(&error))
    }
}
