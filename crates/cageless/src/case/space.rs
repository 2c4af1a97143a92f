//! What takes a case out of its plane: axial load, moments or tilt, contact angles, rows.

use super::{Case, Row, Tilt};
use crate::error::{Allowed, InputError};
use crate::limits::finite;

/// Largest tilt, rad: more is beyond all shoulders.
const TILT_MAX_RAD: f64 = 0.1;

impl Case {
    /// The first field that takes the bearing out of its plane, with its value; `None` for a
    /// planar case.
    pub fn spatial_field(&self) -> Option<(&'static str, f64)> {
        let load = &self.operation.space;
        let tilts = match load.tilt {
            Tilt::Held { x_rad, y_rad } => [
                ("tilt_x_rad", x_rad, x_rad != 0.0),
                ("tilt_y_rad", y_rad, y_rad != 0.0),
            ],
            // Free moments are spatial even where they are 0.
            Tilt::Free {
                moment_x_n_m,
                moment_y_n_m,
            } => [
                (
                    "moment_x_n_m",
                    moment_x_n_m,
                    moment_x_n_m != 0.0 || moment_y_n_m == 0.0,
                ),
                ("moment_y_n_m", moment_y_n_m, true),
            ],
        };
        let angle = self.bearing.contact_angle_rad();
        let turned = self.raceways.iter().map(|r| r.section_angle_rad());
        let turned = turned.map(|a| ("raceway_contact_angle_rad", a, a != 0.0));
        let rows = self.rows.iter();
        let rows = rows.map(|row| ("axial_position_m", row.axial_position_m, true));
        [("axial_load_n", load.axial_load_n, load.axial_load_n != 0.0)]
            .into_iter()
            .chain(tilts)
            .chain([("contact_angle_rad", angle, angle != 0.0)])
            .chain(turned)
            .chain(rows)
            .find(|(_, _, given)| *given)
            .map(|(field, value, _)| (field, value))
    }

    /// Passes a planar case.
    ///
    /// # Errors
    /// An [`InputError`] naming what takes it out of the plane.
    pub fn check_planar(&self) -> Result<(), InputError> {
        self.spatial_field().map_or(Ok(()), |(field, value)| {
            let rule =
                "left out here: only `cageless static` computes in space, all else is planar";
            Err(InputError::rule(field, value, rule))
        })
    }

    /// Checks what takes the case out of its plane.
    pub(super) fn check_space(&self) -> Result<(), InputError> {
        let load = &self.operation.space;
        finite("axial_load_n", load.axial_load_n)?;
        match load.tilt {
            Tilt::Held { x_rad, y_rad } => {
                for (field, value) in [("tilt_x_rad", x_rad), ("tilt_y_rad", y_rad)] {
                    if !(value.abs() <= TILT_MAX_RAD) {
                        let allowed = Allowed::Between(
                            -TILT_MAX_RAD,
                            TILT_MAX_RAD,
                            "more is beyond all shoulders",
                        );
                        return Err(InputError::new(field, value, allowed));
                    }
                }
            }
            Tilt::Free {
                moment_x_n_m,
                moment_y_n_m,
            } => {
                finite("moment_x_n_m", moment_x_n_m)?;
                finite("moment_y_n_m", moment_y_n_m)?;
            }
        }
        for row in &self.rows {
            self.check_row(row)?;
        }
        if let (Some((field, value)), Some(_)) = (self.spatial_field(), &self.rotor) {
            let rule = "left out: a rotor falls in the plane";
            return Err(InputError::rule(field, value, rule));
        }
        Ok(())
    }

    fn check_row(&self, row: &Row) -> Result<(), InputError> {
        finite("axial_position_m", row.axial_position_m)?;
        let most = self.bearing.balls();
        if row.balls.is_some_and(|balls| balls < 1 || balls > most) {
            let balls = row.balls.unwrap_or(0) as f64;
            let rule =
                format!("1 to {most}, the balls of [bearing]: a row without balls carries nothing");
            return Err(InputError::rule("row_balls", balls, rule));
        }
        if row.contact_sign.abs() != 1.0 {
            let rule = "1 or -1: the side on which the balls press the outer ring, +z or -z";
            return Err(InputError::rule("contact_sign", row.contact_sign, rule));
        }
        let most = self.bearing.axial_preload_max_m();
        if !(row.preload_m >= 0.0 && row.preload_m <= most) {
            let allowed = Allowed::Between(
                0.0,
                most,
                "more presses the balls of a pair with over 4200 MPa, the limit of ISO 76",
            );
            return Err(InputError::new("preload_m", row.preload_m, allowed));
        }
        Ok(())
    }
}
