//! Runs and drops in folders: those of `--out`.

use std::path::Path;

use cageless::{Collision, RingSnapshot, RotorSnapshot, Snapshot};
use cageless_io::results::{
    BALLS, COLLISIONS, Column, Metadata, RING, ROTOR, RunWriter, read_run_table,
};
use cageless_study::Stopped;
use numpy::ndarray::{ArrayD, IxDyn};
use numpy::{IntoPyArray, PyReadonlyArrayDyn};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::frozen;
use crate::errors::{input, of_results, other};

/// Units of the columns of each table of a run.
#[pyfunction]
pub fn run_units(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let tables = PyDict::new(py);
    for (name, columns) in [
        ("balls", BALLS),
        ("ring", RING),
        ("collisions", COLLISIONS),
        ("rotor", ROTOR),
    ] {
        let units = PyDict::new(py);
        for column in columns {
            units.set_item(column.name, column.unit)?;
        }
        tables.set_item(name, units)?;
    }
    Ok(tables)
}

/// The arrays of a run as columns.
pub struct Arrays {
    balls: Vec<Vec<f64>>,
    ring: Vec<Vec<f64>>,
    collisions: Vec<Vec<f64>>,
    /// Columns of `rotor.parquet`; a run without a rotor has none.
    rotor: Option<Vec<Vec<f64>>>,
}

impl Arrays {
    /// Copies what [`crate::arrays::Recording::into_arrays`] made.
    pub fn read(tables: &Bound<'_, PyDict>) -> PyResult<Self> {
        Ok(Self {
            balls: columns(tables, "balls", &BALLS[2..])?,
            ring: columns(tables, "ring", RING)?,
            collisions: columns(tables, "collisions", COLLISIONS)?,
            rotor: match tables.contains("rotor")? {
                true => Some(columns(tables, "rotor", ROTOR)?),
                false => None,
            },
        })
    }

    /// Snapshots of the output times from `from` to `to`, s.
    pub fn snapshots(&self, from: f64, to: f64) -> PyResult<Vec<Snapshot>> {
        let times = &self.ring[0];
        let rows = times.partition_point(|t| *t < from)..times.partition_point(|t| *t <= to);
        if rows.len() < 2 {
            return Err(input(format!(
                "time_s = ({from}, {to}) is not possible: it must hold two of the output times or \
                 more, which are from {} to {} s",
                times.first().unwrap_or(&0.0),
                times.last().unwrap_or(&0.0)
            )));
        }
        Ok(rows.map(|row| self.snapshot(row)).collect())
    }

    fn snapshot(&self, row: usize) -> Snapshot {
        let times = self.ring[0].len();
        let ring: [f64; 9] = std::array::from_fn(|column| self.ring[column][row]);
        let [time_s, ring @ ..] = ring;
        let arrays: Vec<f64> = self
            .balls
            .iter()
            .flat_map(|column| {
                let balls = column.len() / times;
                &column[row * balls..][..balls]
            })
            .copied()
            .collect();
        let rotor = self.rotor.as_ref().map(|columns| {
            RotorSnapshot::from_values(std::array::from_fn(|k| columns[k + 1][row]))
        });
        Snapshot::from_parts(time_s, RingSnapshot::from_values(ring), rotor, &arrays)
    }

    /// Writes the tables.
    pub fn write(&self, dir: &Path, isa: &str, case: &str) -> PyResult<()> {
        let write = || {
            let mut writer = RunWriter::create(dir, &Metadata { isa, case })?;
            for row in 0..self.ring[0].len() {
                writer.snapshot(&self.snapshot(row))?;
            }
            for row in 0..self.collisions[0].len() {
                let value = |column: usize| self.collisions[column][row];
                writer.collision(&Collision {
                    start_s: value(0),
                    duration_s: value(1),
                    ball: value(2) as usize - 1,
                    next_ball: value(3) as usize - 1,
                    angle_rad: value(4),
                    approach_speed_m_s: value(5),
                    peak_force_n: value(6),
                    impulse_n_s: value(7),
                })?;
            }
            writer.finish()
        };
        write().map_err(|error| of_results(&error))
    }
}

fn columns(tables: &Bound<'_, PyDict>, of: &str, names: &[Column]) -> PyResult<Vec<Vec<f64>>> {
    let missing = || input(format!("a run has no {of}"));
    let table = tables.get_item(of)?.ok_or_else(missing)?;
    let column = |column: &Column| -> PyResult<Vec<f64>> {
        let array = table.get_item(column.name)?;
        if column.integer {
            let array: PyReadonlyArrayDyn<'_, i32> = array.extract()?;
            return Ok(array.as_array().iter().map(|v| f64::from(*v)).collect());
        }
        let array: PyReadonlyArrayDyn<'_, f64> = array.extract()?;
        Ok(array.as_array().iter().copied().collect())
    };
    names.iter().map(column).collect()
}

/// Contents of a folder: arrays, and the texts asked for.
pub type Contents<'py> = (Bound<'py, PyDict>, [String; 2]);

/// Reads the tables of a folder that runs and drops have in common, and files of text.
pub fn read<'py>(py: Python<'py>, dir: &Path, texts: [&str; 2]) -> PyResult<Contents<'py>> {
    let text = |name: &str| {
        let path = dir.join(name);
        std::fs::read_to_string(&path)
            .map_err(|e| input(format!("{}: cannot be read: {e}", path.display())))
    };
    let texts = [text(texts[0])?, text(texts[1])?];
    let table = |name: &str, columns| table_of(dir, name, columns);
    let (balls, ring, collisions) = py.detach(|| -> PyResult<_> {
        Ok((
            table("balls.parquet", BALLS)?,
            table("ring.parquet", RING)?,
            table("collisions.parquet", COLLISIONS)?,
        ))
    })?;
    let times = ring[0].len();
    let tables = PyDict::new(py);
    let balls = balls.into_iter().skip(2).collect();
    tables.set_item("balls", dict(py, &BALLS[2..], balls, Some(times))?)?;
    tables.set_item("ring", dict(py, RING, ring, None)?)?;
    tables.set_item("collisions", dict(py, COLLISIONS, collisions, None)?)?;
    Ok((tables, texts))
}

/// Adds `rotor.parquet` of a folder to the tables of a drop.
pub fn read_rotor(py: Python<'_>, dir: &Path, tables: &Bound<'_, PyDict>) -> PyResult<()> {
    let rotor = py.detach(|| table_of(dir, "rotor.parquet", ROTOR))?;
    tables.set_item("rotor", dict(py, ROTOR, rotor, None)?)
}

fn table_of(dir: &Path, name: &str, columns: &[Column]) -> PyResult<Vec<Vec<f64>>> {
    read_run_table(&dir.join(name), columns).map_err(|error| of_results(&error))
}

/// Columns as arrays, of `times` rows where they are over times and balls.
fn dict<'py>(
    py: Python<'py>,
    names: &[Column],
    columns: Vec<Vec<f64>>,
    times: Option<usize>,
) -> PyResult<Bound<'py, PyDict>> {
    let found = PyDict::new(py);
    for (column, values) in names.iter().zip(columns) {
        if column.integer {
            let values: Vec<i32> = values.into_iter().map(|v| v as i32).collect();
            found.set_item(column.name, frozen(values.into_pyarray(py)))?;
            continue;
        }
        let shape = match times {
            Some(times) => vec![times, values.len() / times.max(1)],
            None => vec![values.len()],
        };
        let array = ArrayD::from_shape_vec(IxDyn(&shape), values).map_err(other)?;
        found.set_item(column.name, frozen(array.into_pyarray(py)))?;
    }
    Ok(found)
}

/// Reason of an early stop of a drop, from its `summary.json`.
pub fn reason(summary: &str) -> Option<String> {
    let summary: serde_json::Value = serde_json::from_str(summary).ok()?;
    summary["stopped"].as_str().map(str::to_owned)
}

/// Message of an early stop by the physics, from `summary.json`.
pub fn stopped(summary: &str) -> Option<String> {
    let summary: serde_json::Value = serde_json::from_str(summary).ok()?;
    let stop = summary.get("stopped")?;
    let text = |key: &str| stop[key].as_str().unwrap_or_default();
    (text("cause") != Stopped::INTERRUPTED).then(|| {
        format!(
            "at t = {:.6} s {}. To change: {}.",
            stop["time_s"].as_f64().unwrap_or(f64::NAN),
            text("cause"),
            text("advice")
        )
    })
}
