//! Parts of a case outside its plane: axial load, moments or tilt, contact angles, rows.

use super::{Case, InnerRingDrive, Motion, Row, SpatialLoad, Tilt};
use crate::contact::FrictionModel;
use crate::equations::CasePart;
use crate::error::{Allowed, InputError};
use crate::limits::{finite, from_to, not_negative, positive, require};
use crate::linear_rotor::ROUNDING;
use crate::raceway::Raceway;
use crate::rotor::{Rotor, Shaft};

/// Largest tilt, rad: more is beyond all shoulders.
const TILT_MAX_RAD: f64 = 0.1;
/// Largest distance of a row from the origin over the pitch diameter.
const ROW_PLACE_MAX: f64 = 100.0;

/// Fields that can take a bearing out of its plane.
pub const SPATIAL_FIELDS: [&str; 15] = [
    "motion",
    "axial_load_n",
    "tilt_x_rad",
    "tilt_y_rad",
    "moment_x_n_m",
    "moment_y_n_m",
    "contact_angle_rad",
    "raceway_contact_angle_rad",
    "edge_radius_m",
    "axial_position_m",
    "shaft",
    "axial_clearance_m",
    "rotor_axial_load_n",
    "rotor_z_m",
    "rotor_vz_m_s",
];

impl Case {
    /// The first field that takes the bearing out of its plane, with its value; `None` for a
    /// planar case.
    pub(crate) fn spatial_field(&self) -> Option<(&'static str, f64)> {
        let angle = self.bearing.contact_angle_rad();
        let turned = self.raceways.iter().map(|r| r.section_angle_rad());
        let turned = turned.map(|a| ("raceway_contact_angle_rad", a, a != 0.0));
        let slots = self.raceways.iter().filter_map(Raceway::slot);
        let slots = slots.map(|slot| ("edge_radius_m", slot.edge_radius_m, true));
        let rows = self.rows.iter();
        let rows = rows.map(|row| ("axial_position_m", row.axial_position_m, true));
        Self::spatial_load(&self.operation.space)
            .into_iter()
            .chain([("contact_angle_rad", angle, angle != 0.0)])
            .chain(turned)
            .chain(slots)
            .chain(rows)
            .find(|(_, _, given)| *given)
            .map(|(field, value, _)| (field, value))
            .or_else(|| self.rotor.as_ref()?.spatial_field())
    }

    /// Fields of a load, their values, and whether they take the bearing out of its plane.
    fn spatial_load(load: &SpatialLoad) -> [(&'static str, f64, bool); 3] {
        let [first, second] = match load.tilt {
            Tilt::Held { x_rad, y_rad } => [
                ("tilt_x_rad", x_rad, x_rad != 0.0),
                ("tilt_y_rad", y_rad, y_rad != 0.0),
            ],
            // Free moments are spatial even where they are 0.
            Tilt::Free {
                moment_x_n_m: x,
                moment_y_n_m: y,
            } => [
                ("moment_x_n_m", x, x != 0.0 || y == 0.0),
                ("moment_y_n_m", y, true),
            ],
        };
        let axial_load_n = load.axial_load_n;
        [
            ("axial_load_n", axial_load_n, axial_load_n != 0.0),
            first,
            second,
        ]
    }

    /// The axis against which weights act: 1 for Y, 2 for Z.
    pub(crate) fn upward(&self) -> usize {
        let vertical = |rotor: &Rotor| rotor.shaft == Shaft::Vertical;
        1 + usize::from(self.rotor.as_ref().is_some_and(vertical))
    }

    /// Whether the balls of a run move in space.
    pub fn moves_in_space(&self) -> bool {
        self.motion == Motion::Space || self.spatial_field().is_some()
    }

    /// Whether the flanks of the raceways yield under load, and balls slide and spin on them: in space, and in
    /// the plane with elastic flanks.
    pub fn has_elastic_flanks(&self) -> bool {
        self.moves_in_space() || self.flanks.yields()
    }

    /// Passes a case whose motion can be computed.
    ///
    /// # Errors
    /// An [`InputError`] naming what motion in space does not have.
    pub fn check_motion(&self) -> Result<(), InputError> {
        if !self.moves_in_space() {
            return Ok(());
        }
        let load = &self.operation.space;
        let most = self.bearing.balls();
        let mut fewer = self.rows.iter().filter_map(|row| row.balls);
        if let Some(balls) = fewer.find(|balls| *balls != most) {
            let rule =
                format!("{most}, or left out: in motion every row has the balls of [bearing]");
            return Err(InputError::rule("row_balls", balls as f64, rule));
        }
        if let Some(why) = self.formulation.refusal(CasePart::Space) {
            let rule = format!("physical: {why}");
            return Err(InputError::rule("formulation", 0.0, rule));
        }
        let of_rotor = self.rotor.as_ref().map(|rotor| rotor.friction_law);
        let laws = [
            ("friction_law", Some(self.contact.friction_law)),
            ("rotor_friction_law", of_rotor),
        ];
        for (field, law) in laws {
            let rule = "smooth, stribeck or table: sliding in two directions needs a smooth knee";
            require(field, 0.0, !law.is_some_and(FrictionModel::sticks), rule)?;
        }
        if let (
            Tilt::Free {
                moment_x_n_m: x,
                moment_y_n_m: y,
            },
            None,
        ) = (load.tilt, load.inertias_kg_m2)
        {
            let rule = "given with shaft_transverse_inertia_kg_m2 and shaft_polar_inertia_kg_m2 of what it turns";
            return Err(match x != 0.0 || y == 0.0 {
                true => InputError::rule("moment_x_n_m", x, rule),
                false => InputError::rule("moment_y_n_m", y, rule),
            });
        }
        Ok(())
    }

    /// Passes a planar case.
    ///
    /// # Errors
    /// An [`InputError`] naming what takes it out of the plane.
    pub(crate) fn check_planar(&self) -> Result<(), InputError> {
        const IN_SPACE: &str = "`cageless static`, `run`, `compare`, `design` without `--axial`, `tolerance`, \
                                `studio`, `drop` and sweeps";
        if let Some((field, value)) = self.spatial_field() {
            let shape = match field {
                "edge_radius_m" => ", with another shape",
                _ => "",
            };
            let rule = format!(
                "left out here{shape}: only {IN_SPACE}, and `export` take it, all else is planar"
            );
            return Err(InputError::rule(field, value, rule));
        }
        let rule = format!("auto here: only {IN_SPACE} compute in space");
        require("motion", 0.0, self.motion != Motion::Space, rule)
    }

    /// Passes a case that nothing but the edges of slots takes out of its plane.
    ///
    /// # Errors
    /// Those of `check_planar`.
    pub fn check_planar_but_for_slots(&self) -> Result<(), InputError> {
        let counts = |r: &&Raceway| r.slot().is_none() || r.section_angle_rad() != 0.0;
        let others = self.raceways.iter().filter(counts).cloned();
        self.with_raceways(others.collect()).check_planar()
    }

    /// Checks what takes the case out of its plane.
    pub(super) fn check_space(&self) -> Result<(), InputError> {
        let load = &self.operation.space;
        finite("axial_load_n", load.axial_load_n)?;
        match load.tilt {
            Tilt::Held { x_rad, y_rad } => {
                for (field, value) in [("tilt_x_rad", x_rad), ("tilt_y_rad", y_rad)] {
                    let why = "more is beyond all shoulders";
                    from_to(field, value, -TILT_MAX_RAD..=TILT_MAX_RAD, why)?;
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
        if let Some([transverse, polar]) = load.inertias_kg_m2 {
            positive("shaft_transverse_inertia_kg_m2", transverse)?;
            positive("shaft_polar_inertia_kg_m2", polar)?;
            // Ip = ∫(x² + y²)dm and 2·It = ∫(x² + y² + 2z²)dm: equal for a thin disc.
            let most = 2.0 * transverse;
            if polar > most * (1.0 + ROUNDING) {
                let why = "twice shaft_transverse_inertia_kg_m2: no body exceeds a thin disc";
                let allowed = Allowed::AtMost(most, why);
                return Err(InputError::new("shaft_polar_inertia_kg_m2", polar, allowed));
            }
        }
        for row in &self.rows {
            self.check_row(row)?;
        }
        if let Some(last) = self.rows.last()
            && self.rows.iter().all(|row| row.preload_n > 0.0)
        {
            let rule = "0 for one row at least, whose outer ring is held: springs alone do not place the \
                        inner ring along the axis";
            return Err(InputError::rule("preload_n", last.preload_n, rule));
        }
        let sprung = self.rows.iter().filter(|row| row.preload_n > 0.0);
        let sliding_kg: f64 = sprung.map(|row| row.sliding(&self.bearing)[0]).sum();
        if let Some(support) = &self.support
            && sliding_kg >= support.mass_kg
        {
            let why = "the mass of the outer rings that springs push is part of it";
            let allowed = Allowed::Above(sliding_kg, why);
            return Err(InputError::new("support_mass_kg", support.mass_kg, allowed));
        }
        if let InnerRingDrive::Rotor(_) = self.inner_ring_drive() {
            let of_load = Self::spatial_load(load)
                .into_iter()
                .find(|(.., given)| *given);
            if let Some((field, value, _)) = of_load {
                let rule = "left out: the rotor loads the inner ring, which keeps its axis along that of the rotor";
                return Err(InputError::rule(field, value, rule));
            }
        }
        Ok(())
    }

    fn check_row(&self, row: &Row) -> Result<(), InputError> {
        let most = ROW_PLACE_MAX * 2.0 * self.bearing.pitch_radius_m();
        let why = "100 pitch diameters from where the load acts: the rows sit on one rigid ring";
        from_to("axial_position_m", row.axial_position_m, -most..=most, why)?;
        let most = self.bearing.balls();
        let balls = row.balls.unwrap_or(most);
        let rule =
            format!("1 to {most}, the balls of [bearing]: a row without balls carries nothing");
        let kept = (1..=most).contains(&balls);
        require("row_balls", balls as f64, kept, rule)?;
        let rule = "1 or -1: the side on which the balls press the outer ring, +z or -z";
        let kept = row.contact_sign.abs() == 1.0;
        require("contact_sign", row.contact_sign, kept, rule)?;
        let most = self.bearing.axial_preload_max_m();
        let why = "more presses the balls of a pair with over 4200 MPa, the limit of ISO 76";
        from_to("preload_m", row.preload_m, 0.0..=most, why)?;
        let rule = "0 or left out: the outer ring of the row is displaced already, and held there";
        let kept = row.preload_m == 0.0 || row.preload_n == 0.0;
        require("preload_n", row.preload_n, kept, rule)?;
        let most = self.axial_preload_max_n(balls);
        let why = "more presses its balls with over 4200 MPa, the limit of ISO 76";
        from_to("preload_n", row.preload_n, 0.0..=most, why)?;
        let [mass_kg, damping] = row.sliding(&self.bearing);
        positive("sliding_mass_kg", mass_kg)?;
        not_negative("sliding_damping_n_s_m", damping)
    }
}
