//! A rotor above several touchdown bearings, and its drop.

use std::path::PathBuf;

use cageless::linear_rotor::{
    self, DMatrix, NodeUnbalance, PlaneUnbalance, Reduction, RigidRotor, RotorError, RotorMatrices,
};
use cageless_io::rotor_file::{RotorFile, write_matrices};
use cageless_report::drop::rotor_page;
use cageless_study::drop::rotor_study;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

use crate::background::Background;
use crate::case_file::{CaseFile, requested};
use crate::drop::Drop;
use crate::errors::{input, of_results, of_run, of_study, other, reason};

/// Lateral motion of a rotor with the nodes of its bearings.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct LinearRotor {
    rotor: linear_rotor::LinearRotor,
    /// The matrices that it was reduced from.
    matrices: Option<RotorMatrices>,
}

/// Axial place in mm or node, m·ε in g·mm, direction in degrees.
type Unbalance<T> = (T, f64, f64);
/// A drop with what its bearings went through: bearings, summary, page, reason of an early stop.
type Dropped = (Vec<Drop>, String, String, Option<String>);

fn refused(error: &RotorError) -> PyErr {
    input(error.to_string())
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
    ) -> PyResult<Self> {
        let rigid = RigidRotor {
            mass_kg,
            polar_inertia_kg_m2,
            transverse_inertia_kg_m2,
            bearing_axial_m: bearing_axial_mm.iter().map(|z| 1e-3 * z).collect(),
            unbalances: (unbalances.iter())
                .map(|(axial_mm, moment_g_mm, phase_deg)| PlaneUnbalance {
                    axial_m: 1e-3 * axial_mm,
                    moment_kg_m: 1e-6 * moment_g_mm,
                    phase_rad: phase_deg.to_radians(),
                })
                .collect(),
        };
        let rotor = rigid.linear().map_err(|error| refused(&error))?;
        Ok(Self {
            rotor,
            matrices: None,
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
        let reduction = Reduction {
            bearing_nodes: nodes,
            kept_nodes,
            unbalances: (unbalances.iter())
                .map(|(node, moment_g_mm, phase_deg)| NodeUnbalance {
                    node: *node,
                    moment_kg_m: 1e-6 * moment_g_mm,
                    phase_rad: phase_deg.to_radians(),
                })
                .collect(),
            frequency_max_hz,
        };
        let rotor = matrices.reduce(&reduction).map_err(|e| refused(&e))?;
        Ok(Self {
            rotor,
            matrices: Some(matrices),
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
        let Some(matrices) = &self.matrices else {
            return Err(input(
                "a rigid rotor has no matrices: a rotor file gives its mass and inertia".to_owned(),
            ));
        };
        write_matrices(&path, matrices).map_err(|error| of_results(&error))
    }

    /// Drops the rotor.
    #[expect(clippy::too_many_arguments, reason = "the values of a rotor file")]
    fn drop(
        &self,
        py: Python<'_>,
        cases: Vec<PyRef<'_, CaseFile>>,
        title: &str,
        speed_rpm: f64,
        drive_torque_n_m: f64,
        compare: bool,
        samples: Option<i64>,
        verify: bool,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Dropped> {
        let request = requested(compare, samples, verify)?;
        request.check_samples().map_err(|e| of_study(&e))?;
        let files: Vec<_> = cases.iter().map(|case| case.file.clone()).collect();
        let rotor = self.rotor.clone();
        let file = RotorFile::new(title, rotor, speed_rpm, drive_torque_n_m, &files)
            .map_err(|error| refused(&error))?;
        let rows = || files.iter().map(|_| None).collect();
        let background = Background::new(threads, progress)?;
        let done = background.run(py, |progress| rotor_study(&file, request, rows(), progress))?;
        let study = done.map_err(of_run)?;
        let summary = study.to_json(&file).map_err(other)?;
        let page = py.detach(|| rotor_page(&file, &study));
        let last = study.drop.last_index();
        let stopped = reason(&study.drop.last().outcome.ending)
            .map(|reason| format!("bearing {}: {reason}", last + 1));
        let bearings = (file.bearings().iter().cloned())
            .zip(study.drop.bearings)
            .map(|(file, record)| Drop::of_bearing(py, file, record))
            .collect::<PyResult<_>>()?;
        Ok((bearings, summary, page, stopped))
    }
}
