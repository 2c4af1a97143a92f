//! Tables of runs and drops: columns that grow, arrays of numpy, files of a folder.

use std::path::{Path, PathBuf};

use cageless::simulation::ObserverError;
use cageless::{Collision, RingSnapshot, RotorSnapshot, Snapshot};
use cageless_io::results::{
    COLLISIONS, Column, ColumnKind, Metadata, ResultFolder, collision_values, read_run_table,
    run_columns, summary_of_tables,
};
use cageless_study::drop::BearingRecord;
use cageless_study::run::Rows;
use numpy::ndarray::{ArrayD, Dimension, IxDyn};
use numpy::{Element, IntoPyArray, PyArray, PyArrayMethods, PyReadonlyArrayDyn};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{Found, input, other};

/// Names and columns of the tables, and how many of these have no arrays: those of the balls are over times
/// and balls, so that they need neither column.
fn specified() -> [(&'static str, &'static [Column], usize); 4] {
    let [balls, ring, rotor] = run_columns(true);
    [
        ("balls", balls, 2),
        ("ring", ring, 0),
        ("collisions", COLLISIONS, 0),
        ("rotor", rotor, 0),
    ]
}

/// Units of the columns of each table.
#[pyfunction]
pub fn table_units(py: Python<'_>) -> Found<Bound<'_, PyDict>> {
    let tables = PyDict::new(py);
    for (name, columns, _) in specified() {
        let units = PyDict::new(py);
        for column in columns {
            units.set_item(&column.name, &column.unit)?;
        }
        tables.set_item(name, units)?;
    }
    Ok(tables)
}

/// Columns of each table in the order of [`specified`]; those of a rotor are empty without one.
#[derive(Default)]
pub struct Tables([Vec<Vec<f64>>; 4]);

fn extend<'a>(columns: &mut Vec<Vec<f64>>, values: impl ExactSizeIterator<Item = &'a [f64]>) {
    columns.resize_with(values.len(), Vec::new);
    for (column, values) in columns.iter_mut().zip(values) {
        column.extend_from_slice(values);
    }
}

/// A row that begins with a time.
fn row<const N: usize>(columns: &mut Vec<Vec<f64>>, time_s: f64, values: [f64; N]) {
    columns.resize_with(N + 1, Vec::new);
    let values = [time_s].into_iter().chain(values);
    columns.iter_mut().zip(values).for_each(|(c, v)| c.push(v));
}

impl Rows for Tables {
    fn snapshot(&mut self, snapshot: &Snapshot) -> Result<(), ObserverError> {
        let [balls, ring, _, rotor] = &mut self.0;
        extend(balls, snapshot.arrays().into_iter());
        row(ring, snapshot.time_s, snapshot.ring.values());
        if let Some(values) = snapshot.rotor {
            row(rotor, snapshot.time_s, values.values());
        }
        if !snapshot.is_in_space() {
            let [_, ring_columns, rotor_columns] = run_columns(false);
            ring.truncate(ring_columns.len());
            rotor.truncate(rotor_columns.len());
        }
        Ok(())
    }

    fn collision(&mut self, collision: &Collision) -> Result<(), ObserverError> {
        let values = collision_values(collision);
        extend(&mut self.0[2], values.iter().map(std::slice::from_ref));
        Ok(())
    }
}

impl Tables {
    /// Tables of one bearing of a drop.
    pub fn of_drop(record: &BearingRecord) -> Found<Self> {
        let mut tables = Self::default();
        for snapshot in &record.snapshots {
            tables.snapshot(snapshot).map_err(other)?;
        }
        for collision in &record.collisions {
            tables.collision(collision).map_err(other)?;
        }
        Ok(tables)
    }

    /// Reads the tables of a folder.
    pub fn read(dir: &Path) -> Found<Self> {
        let mut tables = Self::default();
        for (table, (name, columns, skipped)) in tables.0.iter_mut().zip(specified()) {
            let path = dir.join(name).with_extension("parquet");
            if name != "rotor" || path.is_file() {
                let found = read_run_table(&path, columns)?.into_iter();
                *table = found.skip(skipped).collect();
            }
        }
        Ok(tables)
    }

    /// `{"balls": {name: times × balls}, "ring": {name: times}, "collisions": {name: …}}`, with a
    /// rotor `"rotor"` as well. The arrays take over the memory of the columns and are not for
    /// writing: figures would not follow.
    pub fn into_arrays(self, py: Python<'_>) -> Found<Py<PyDict>> {
        let times = self.0[1].first().map_or(0, Vec::len);
        let tables = PyDict::new(py);
        for ((name, columns, skipped), mut values) in specified().into_iter().zip(self.0) {
            let columns = &columns[skipped..];
            if name == "rotor" && values.is_empty() {
                continue;
            }
            let table = PyDict::new(py);
            if values.is_empty() {
                values.resize_with(columns.len(), Vec::new);
            }
            for (column, values) in columns.iter().zip(values) {
                if column.kind == ColumnKind::Ordinal {
                    let values: Vec<i32> = values.into_iter().map(|v| v as i32).collect();
                    table.set_item(&column.name, frozen(values.into_pyarray(py)))?;
                    continue;
                }
                let shape = match name {
                    "balls" => vec![times, values.len() / times.max(1)],
                    _ => vec![values.len()],
                };
                let array = ArrayD::from_shape_vec(IxDyn(&shape), values).map_err(other)?;
                table.set_item(&column.name, frozen(array.into_pyarray(py)))?;
            }
            tables.set_item(name, table)?;
        }
        Ok(tables.unbind())
    }

    /// Copies what [`Self::into_arrays`] made.
    pub fn of_arrays(arrays: &Bound<'_, PyDict>) -> Found<Self> {
        let mut tables = Self::default();
        for (table, (name, columns, skipped)) in tables.0.iter_mut().zip(specified()) {
            let Some(arrays) = arrays.get_item(name)? else {
                continue;
            };
            let column = |column: &Column| -> Found<Vec<f64>> {
                let array = arrays.get_item(&column.name)?;
                if column.kind == ColumnKind::Ordinal {
                    let array: PyReadonlyArrayDyn<'_, i32> = array.extract()?;
                    return Ok(array.as_array().iter().map(|v| f64::from(*v)).collect());
                }
                let array: PyReadonlyArrayDyn<'_, f64> = array.extract()?;
                Ok(array.as_array().iter().copied().collect())
            };
            // Those of space come last, and are not there in the plane.
            let given = columns[skipped..]
                .iter()
                .filter(|c| arrays.contains(&*c.name).unwrap_or(false));
            *table = given.map(column).collect::<Found<_>>()?;
        }
        Ok(tables)
    }

    /// Snapshots of the output times from `from` to `to`, s.
    pub fn snapshots(&self, from: f64, to: f64) -> Found<Vec<Snapshot>> {
        let times = &self.0[1][0];
        let rows = times.partition_point(|t| *t < from)..times.partition_point(|t| *t <= to);
        if rows.len() < 2 || from.is_nan() || to.is_nan() {
            return Err(input(format!(
                "time_s = ({from}, {to}) is not possible: it must hold two of the output times or \
                 more, which are from {} to {} s",
                times.first().unwrap_or(&0.0),
                times.last().unwrap_or(&0.0)
            )));
        }
        Ok(rows.map(|row| self.snapshot_of(row)).collect())
    }

    /// Whether balls move in space.
    fn in_space(&self) -> bool {
        self.0[1].len() > run_columns(false)[1].len()
    }

    fn snapshot_of(&self, row: usize) -> Snapshot {
        let [balls, ring, _, rotor] = &self.0;
        let times = ring[0].len();
        let arrays = balls.iter().flat_map(|column| {
            let balls = column.len() / times;
            &column[row * balls..][..balls]
        });
        let arrays: Vec<f64> = arrays.copied().collect();
        // Those of space are 0 in the plane.
        let of = |table: &[Vec<f64>], k: usize| table.get(k + 1).map_or(0.0, |column| column[row]);
        let rotor = (!rotor.is_empty())
            .then(|| RotorSnapshot::from_values(std::array::from_fn(|k| of(rotor, k))));
        let values = RingSnapshot::from_values(std::array::from_fn(|k| of(ring, k)));
        Snapshot::from_parts(ring[0][row], values, rotor, &arrays, self.in_space())
    }
}

/// Text of `summary.json` in a folder without its list of tables, and the arrays of the tables in each of the folders
/// `places` within, which are those of the list.
#[pyfunction]
pub fn read_tables(
    py: Python<'_>,
    dir: PathBuf,
    summary: &str,
    places: Vec<String>,
) -> Found<(String, Vec<Py<PyDict>>)> {
    let (summary, tables) = py.detach(|| -> Found<_> {
        let summary = summary_of_tables(&dir, summary, &places)?;
        let tables = places.iter().map(|place| Tables::read(&dir.join(place)));
        Ok((summary, tables.collect::<Found<Vec<_>>>()?))
    })?;
    let arrays = tables.into_iter().map(|tables| tables.into_arrays(py));
    Ok((summary, arrays.collect::<Found<_>>()?))
}

/// Arrays of a run or of a bearing of a drop, with its folder, instruction set and case as run.
#[derive(FromPyObject)]
pub struct Recorded<'py>(String, Bound<'py, PyDict>, String, String);

impl Recorded<'_> {
    /// Writes the arrays as tables of a folder.
    pub fn write(&self, folder: &mut ResultFolder) -> Found<()> {
        let Self(place, arrays, isa, case) = self;
        let tables = Tables::of_arrays(arrays)?;
        let [_, ring, collisions, _] = &tables.0;
        let metadata = Metadata {
            isa,
            case,
            in_space: tables.in_space(),
        };
        let mut writer = folder.tables(place, &metadata)?;
        for row in 0..ring[0].len() {
            writer.snapshot(&tables.snapshot_of(row))?;
        }
        for row in 0..collisions[0].len() {
            let value = |column: usize| collisions[column][row];
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
        Ok(folder.add_tables(writer, false)?)
    }
}

fn frozen<'py, T: Element, D: Dimension>(
    array: Bound<'py, PyArray<T, D>>,
) -> Bound<'py, PyArray<T, D>> {
    array.readwrite().make_nonwriteable();
    array
}
