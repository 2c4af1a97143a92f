//! Results of a run as numpy arrays that take over the memory of the vectors.

use cageless::simulation::ObserverError;
use cageless::{Collision, Snapshot};
use cageless_io::results::{BALLS, COLLISIONS, RING, collision_values};
use cageless_study::run::Rows;
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::other;

/// Columns of the three tables, as they grow.
#[derive(Default)]
pub struct Recording {
    time_s: Vec<f64>,
    balls: Vec<Vec<f64>>,
    ring: Vec<Vec<f64>>,
    collisions: Vec<Collision>,
}

impl Rows for Recording {
    fn snapshot(&mut self, snapshot: &Snapshot) -> Result<(), ObserverError> {
        let (balls, ring) = (snapshot.arrays(), snapshot.ring.values());
        self.time_s.push(snapshot.time_s);
        self.balls.resize_with(balls.len(), Vec::new);
        self.ring.resize_with(ring.len(), Vec::new);
        for (column, values) in self.balls.iter_mut().zip(balls) {
            column.extend_from_slice(values);
        }
        for (column, value) in self.ring.iter_mut().zip(ring) {
            column.push(value);
        }
        Ok(())
    }

    fn collision(&mut self, collision: &Collision) -> Result<(), ObserverError> {
        self.collisions.push(*collision);
        Ok(())
    }
}

impl Recording {
    /// `{"balls": {name: times × balls}, "ring": {name: times}, "collisions": {name: …}}`.
    pub fn into_arrays(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let times = self.time_s.len();
        let tables = PyDict::new(py);
        let balls = PyDict::new(py);
        // The first two columns of the file say what the axes of the arrays do.
        for (column, values) in BALLS[2..].iter().zip(self.balls) {
            let shape = (times, values.len() / times.max(1));
            let array = Array2::from_shape_vec(shape, values).map_err(other)?;
            balls.set_item(column.name, frozen(array.into_pyarray(py)))?;
        }
        tables.set_item("balls", balls)?;
        let ring = PyDict::new(py);
        for (column, values) in RING.iter().zip([self.time_s].into_iter().chain(self.ring)) {
            ring.set_item(column.name, frozen(values.into_pyarray(py)))?;
        }
        tables.set_item("ring", ring)?;
        tables.set_item("collisions", collisions(py, &self.collisions)?)?;
        Ok(tables)
    }
}

fn collisions<'py>(py: Python<'py>, list: &[Collision]) -> PyResult<Bound<'py, PyDict>> {
    let rows: Vec<_> = list.iter().map(collision_values).collect();
    let columns = PyDict::new(py);
    for (k, column) in COLLISIONS.iter().enumerate() {
        let values = rows.iter().map(|row| row[k]);
        if column.integer {
            let values: Vec<i32> = values.map(|v| v as i32).collect();
            columns.set_item(column.name, frozen(values.into_pyarray(py)))?;
        } else {
            let values: Vec<f64> = values.collect();
            columns.set_item(column.name, frozen(values.into_pyarray(py)))?;
        }
    }
    Ok(columns)
}

/// Results are not for writing: their figures would not follow.
pub fn frozen<'py, T: numpy::Element, D: numpy::ndarray::Dimension>(
    array: Bound<'py, numpy::PyArray<T, D>>,
) -> Bound<'py, numpy::PyArray<T, D>> {
    array.readwrite().make_nonwriteable();
    array
}
