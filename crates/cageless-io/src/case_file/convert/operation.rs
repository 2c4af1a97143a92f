//! Operation of a case.

use cageless::time_table::TimeTable;
use cageless::{Operation, SpatialLoad, Tilt};

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;
use crate::case_file::fields::OverTime;

impl Converter<'_> {
    /// Speed and load.
    pub(in crate::case_file) fn operation(&self) -> Result<Operation, CaseError> {
        let o = &self.sections.operation;
        let (speed, speeds) = self.over_time("inner_speed_rpm", o.inner_speed_rad_s.as_ref())?;
        // Clockwise is counter-clockwise seen from the other face.
        let values = || speeds.iter().flatten().map(|[_, value]| *value);
        let clockwise = speed < 0.0 || values().any(|v| v < 0.0);
        let reversed = values().any(|v| v > 0.0);
        let (speed, speeds) = if clockwise && !reversed {
            let turned = |rows: Vec<[f64; 2]>| rows.into_iter().map(|[t, v]| [t, -v]).collect();
            (-speed, speeds.map(turned))
        } else {
            (speed, speeds)
        };
        let (load, loads) = self.over_time("radial_load_n", o.radial_load_n.as_ref())?;
        let table = |field, rows: Option<Vec<[f64; 2]>>| {
            let table = |rows: Vec<[f64; 2]>| {
                let (times, values) = rows.into_iter().map(|[t, v]| (t, v)).unzip();
                TimeTable::new(field, times, values).map_err(|e| self.refused(&e, None))
            };
            rows.map(table).transpose()
        };
        Ok(Operation {
            clockwise,
            inner_speed_rad_s: speed,
            radial_load_n: load,
            gravity_m_s2: o.gravity_m_s2,
            inner_speed_table: table("inner_speed_rad_s", speeds)?,
            radial_load_table: table("radial_load_n", loads)?,
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

    /// Value at the start and the table of a quantity, in SI units; 0 under a rotor, where
    /// the key is left out.
    #[expect(clippy::type_complexity, reason = "a value and its table")]
    fn over_time(
        &self,
        name: &str,
        given: Option<&OverTime>,
    ) -> Result<(f64, Option<Vec<[f64; 2]>>), CaseError> {
        match given {
            None if self.sections.rotor.is_some() => Ok((0.0, None)),
            None => Err(self.missing("operation", name)),
            Some(OverTime::Constant(value)) => Ok((*value, None)),
            Some(OverTime::Table(rows)) => Ok((
                rows.first().map_or(0.0, |[_, value]| *value),
                Some(rows.clone()),
            )),
        }
    }
}
