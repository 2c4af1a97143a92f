//! Operation of a case.

use cageless::TimeTable;
use cageless::{Operation, SpatialLoad, Tilt, Unbalance};

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;
use crate::case_file::fields::OverTime;

impl Converter<'_> {
    /// Speed and load.
    pub(in crate::case_file) fn operation(&self) -> Result<Operation, CaseError> {
        let o = &self.sections.operation;
        let mut speed = self.over_time("inner_speed_rpm", o.inner_speed_rad_s.as_ref())?;
        // Clockwise is counter-clockwise seen from the other face.
        let values = || speed.rows.iter().flatten().map(|[_, value]| *value);
        let clockwise = speed.start < 0.0 || values().any(|v| v < 0.0);
        if clockwise && !values().any(|v| v > 0.0) {
            speed.start = -speed.start;
            let values = speed.rows.iter_mut().flatten();
            values.for_each(|[_, value]| *value = -*value);
        }
        let load = self.over_time("radial_load_n", o.radial_load_n.as_ref())?;
        let table = |field, rows: Option<Vec<[f64; 2]>>| {
            let table = |rows: Vec<[f64; 2]>| {
                let (times, values) = rows.into_iter().map(|[t, v]| (t, v)).unzip();
                TimeTable::new(field, times, values).map_err(|e| self.refused(&e, None))
            };
            rows.map(table).transpose()
        };
        Ok(Operation {
            clockwise,
            inner_speed_rad_s: speed.start,
            radial_load_n: load.start,
            gravity_m_s2: o.gravity_m_s2,
            inner_speed_table: table("inner_speed_rad_s", speed.rows)?,
            radial_load_table: table("radial_load_n", load.rows)?,
            unbalance: Unbalance {
                amount_kg_m: o.unbalance_kg_m.unwrap_or(0.0),
                phase_rad: 0.0,
            },
            space: self.spatial_load()?,
        })
    }

    /// Load out of the plane. A tilt is held, or moments turn the ring.
    fn spatial_load(&self) -> Result<SpatialLoad, CaseError> {
        let o = &self.sections.operation;
        let is_free = o.moment_x_n_m.or(o.moment_y_n_m).is_some();
        let held = [("tilt_x_mrad", o.tilt_x_rad), ("tilt_y_mrad", o.tilt_y_rad)];
        if let (true, Some((name, _))) = (is_free, held.iter().find(|(_, tilt)| tilt.is_some())) {
            let allowed = "left out: moments turn the ring, or its tilt is given";
            return Err(self.refuse(&format!("operation.{name}"), allowed));
        }
        let or_none = |value: Option<f64>| value.unwrap_or(0.0);
        let inertias = [
            (
                "shaft_transverse_inertia_kg_m2",
                o.shaft_transverse_inertia_kg_m2,
            ),
            ("shaft_polar_inertia_kg_m2", o.shaft_polar_inertia_kg_m2),
        ];
        let inertias_kg_m2 = match inertias.map(|(_, value)| value) {
            [None, None] => None,
            [Some(transverse), Some(polar)] => Some([transverse, polar]),
            [given, _] => {
                let (missing, _) = inertias[usize::from(given.is_some())];
                return Err(self.missing("operation", missing));
            }
        };
        Ok(SpatialLoad {
            inertias_kg_m2,
            axial_load_n: or_none(o.axial_load_n),
            tilt: match is_free {
                true => Tilt::Free {
                    moment_x_n_m: or_none(o.moment_x_n_m),
                    moment_y_n_m: or_none(o.moment_y_n_m),
                },
                false => Tilt::Held {
                    x_rad: or_none(o.tilt_x_rad),
                    y_rad: or_none(o.tilt_y_rad),
                },
            },
        })
    }

    /// A quantity, in SI units; 0 under a rotor, where the key is left out.
    fn over_time(&self, name: &str, given: Option<&OverTime>) -> Result<OverTime, CaseError> {
        match given {
            None if self.sections.rotor.is_some() => Ok(OverTime::default()),
            None => Err(self.missing("operation", name)),
            Some(given) => Ok(given.clone()),
        }
    }
}
