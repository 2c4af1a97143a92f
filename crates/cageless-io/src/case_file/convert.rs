//! Conversion of the document to the case in SI units, with the checks of [`cageless`].

use cageless::design::search::Request;
use cageless::step_limits::StepLimits;
use cageless::{
    Bearing, BearingDimensions, Case, Contact, Gaps, Housing, InputError, Material, Operation,
    Output, Raceway, RacewayDimensions, Solver, Start,
};

use super::SCHEMA;
use super::document::{CaseDocument, GapsDocument, RacewayDocument, StartState, StepDocument};
use super::error::CaseError;
use super::keys;
use super::messages;
use super::read::nth;
use super::spanned_toml::{Places, join};
use super::unit::{Side, decimal, round};

/// Outer radius of the outer ring at most, and half its width, over the radius of its groove.
const OUTER_RADII_MAX: f64 = 10.0;

/// No contact of a bearing needs steps this short.
const NO_STEP_S: f64 = 1e-12;

/// Step of a case whose step is still to be chosen.
const PROVISIONAL_STEP_S: f64 = 1e-6;

/// Converts and checks.
pub(super) fn case(document: &CaseDocument, places: &Places) -> Result<(Case, Request), CaseError> {
    let converter = Converter { document, places };
    let case = converter.case()?;
    let search = converter.search(&case)?;
    Ok((case, search))
}

/// Conversion of one document; `places` says where its values come from.
pub(super) struct Converter<'a> {
    pub document: &'a CaseDocument,
    pub places: &'a Places,
}

impl Converter<'_> {
    fn case(&self) -> Result<Case, CaseError> {
        let document = self.document;
        if document.schema != SCHEMA {
            let allowed = format!("{SCHEMA}, the only schema that this version of Cageless reads");
            return Err(self.refuse("schema", &document.schema.to_string(), &allowed));
        }
        let bearing = self.bearing()?;
        self.check_export_dimensions()?;
        let mut raceways = Vec::new();
        for (k, raceway) in document.raceway.iter().enumerate() {
            raceways.push(self.raceway(k, raceway, &bearing)?);
        }
        let mut case = Case {
            title: document.title.clone(),
            bearing,
            raceways,
            operation: self.operation()?,
            contact: self.contact()?,
            profile: document.model.profile,
            start: self.start()?,
            solver: self.solver()?,
            seed: self.seed()?,
            housing: self.housing()?,
            rotor: None,
            support: None,
            output: Output {
                interval_s: self.si("output.interval_us", document.output.interval_us)?,
            },
        };
        let automatic = document.solver.step_us == StepDocument::Auto;
        if automatic {
            let step_s = StepLimits::new(&case).automatic_s(case.solver.method);
            if step_s.is_finite() {
                case.solver.step_s = step_s;
            }
        }
        case.check().map_err(|e| match e.field {
            "step_s" | "duration_s" if automatic && case.solver.step_s < NO_STEP_S => {
                self.no_step(&case)
            }
            _ => self.refused_case(&e, &case),
        })?;
        Ok(case)
    }

    fn bearing(&self) -> Result<Bearing, CaseError> {
        let (b, m) = (&self.document.bearing, &self.document.material);
        let si = |name: &str, value| self.si(&join("bearing", name), value);
        let dimensions = BearingDimensions {
            balls: b.balls,
            ball_radius_m: si("ball_radius_mm", b.ball_radius_mm)?,
            inner_groove_bottom_radius_m: si(
                "inner_groove_bottom_radius_mm",
                b.inner_groove_bottom_radius_mm,
            )?,
            outer_groove_bottom_radius_m: si(
                "outer_groove_bottom_radius_mm",
                b.outer_groove_bottom_radius_mm,
            )?,
            outer_shoulder_radius_m: si("outer_shoulder_radius_mm", b.outer_shoulder_radius_mm)?,
            inner_groove_curvature_radius_m: si(
                "inner_groove_curvature_radius_mm",
                b.inner_groove_curvature_radius_mm,
            )?,
            outer_groove_curvature_radius_m: si(
                "outer_groove_curvature_radius_mm",
                b.outer_groove_curvature_radius_mm,
            )?,
            inner_ring_mass_kg: si("inner_ring_mass_kg", b.inner_ring_mass_kg)?,
            inner_ring_drag_n_s_m: si("inner_ring_drag_n_s_m", b.inner_ring_drag_n_s_m)?,
        };
        let si = |name: &str, value| self.si(&join("material", name), value);
        let material = Material {
            density_kg_m3: si("density_kg_m3", m.density_kg_m3)?,
            youngs_modulus_pa: si("youngs_modulus_gpa", m.youngs_modulus_gpa)?,
            poisson_ratio: si("poisson_ratio", m.poisson_ratio)?,
        };
        let bearing = Bearing::new(dimensions, material).map_err(|e| self.refused(&e, None))?;
        self.scattered(bearing)
    }

    /// Keys that only `export` needs and any file may contain.
    fn check_export_dimensions(&self) -> Result<(), CaseError> {
        let b = &self.document.bearing;
        if let Some(radius) = b.outer_ring_outer_radius_mm {
            self.si("bearing.outer_ring_outer_radius_mm", radius)?;
            let least = b.outer_groove_bottom_radius_mm;
            let most = decimal(round(OUTER_RADII_MAX * least, Side::Upper));
            if radius <= least {
                return Err(self.refuse(
                    "bearing.outer_ring_outer_radius_mm",
                    &radius.to_string(),
                    &format!("more than {least} mm (the bottom of the groove)"),
                ));
            }
            if radius > OUTER_RADII_MAX * least {
                return Err(self.refuse(
                    "bearing.outer_ring_outer_radius_mm",
                    &radius.to_string(),
                    &format!("at most {most} mm (ten times the bottom of the groove)"),
                ));
            }
        }
        if let Some(width) = b.outer_ring_width_mm {
            self.si("bearing.outer_ring_width_mm", width)?;
            if width <= 0.0 {
                let key = "bearing.outer_ring_width_mm";
                return Err(self.refuse(key, &width.to_string(), "more than 0 mm"));
            }
            let widest = 2.0 * OUTER_RADII_MAX * b.outer_groove_bottom_radius_mm;
            if width > widest {
                let key = "bearing.outer_ring_width_mm";
                let most = decimal(round(widest, Side::Upper));
                let allowed = format!("at most {most} mm (ten times the diameter of the groove)");
                return Err(self.refuse(key, &width.to_string(), &allowed));
            }
        }
        Ok(())
    }

    /// Gives the balls their own radii.
    fn scattered(&self, bearing: Bearing) -> Result<Bearing, CaseError> {
        let b = &self.document.bearing;
        let Some(deviations) = &b.ball_radius_deviation_um else {
            return Ok(bearing);
        };
        let key = "bearing.ball_radius_deviation_um";
        if deviations.len() != b.balls {
            let allowed = format!("a list of {} numbers in um, one per ball", b.balls);
            return Err(self.refuse(key, &format!("a list of {}", deviations.len()), &allowed));
        }
        let deviations_m = deviations
            .iter()
            .map(|d| self.si(key, *d))
            .collect::<Result<_, _>>()?;
        bearing
            .with_ball_radius_deviations(deviations_m)
            .map_err(|e| self.refused(&e, None))
    }

    fn raceway(
        &self,
        index: usize,
        raceway: &RacewayDocument,
        bearing: &Bearing,
    ) -> Result<Raceway, CaseError> {
        let path = nth("raceway", index, self.document.raceway.len());
        let si = |name: &str, value| self.si(&join(&path, name), value);
        let dimensions = RacewayDimensions {
            axial_span_m: si("axial_span_mm", raceway.axial_span_mm)?,
            half_angle_rad: si("half_angle_deg", raceway.half_angle_deg)?,
            centre_angle_rad: si("centre_angle_deg", raceway.centre_angle_deg)?,
        };
        let depth_error_m = si("depth_error_um", raceway.depth_error_um)?;
        Raceway::new(dimensions, bearing)
            .and_then(|raceway| raceway.with_depth_error(depth_error_m))
            .map_err(|e| self.refused(&e, Some(index)))
    }

    fn operation(&self) -> Result<Operation, CaseError> {
        let o = &self.document.operation;
        Ok(Operation {
            inner_speed_rad_s: self.si("operation.inner_speed_rpm", o.inner_speed_rpm)?,
            radial_load_n: self.si("operation.radial_load_n", o.radial_load_n)?,
            gravity_m_s2: self.si("operation.gravity_m_s2", o.gravity_m_s2)?,
            inner_speed_table: None,
            radial_load_table: None,
        })
    }

    fn contact(&self) -> Result<Contact, CaseError> {
        let c = &self.document.contact;
        let si = |name: &str, value| self.si(&join("contact", name), value);
        let optional = |name: &str, value: Option<f64>| value.map(|v| si(name, v)).transpose();
        Ok(Contact {
            friction_coefficient: si("friction_coefficient", c.friction_coefficient)?,
            friction_law: c.friction_law,
            static_friction_coefficient: optional(
                "static_friction_coefficient",
                c.static_friction_coefficient,
            )?,
            stribeck_speed_m_s: optional("stribeck_speed_m_s", c.stribeck_speed_m_s)?,
            slip_scale_m_s: si("slip_scale_m_s", c.slip_scale_m_s)?,
            damping_n_s_m1_5: si("damping", c.damping)?,
            ball_restitution: si("ball_restitution", c.ball_restitution)?,
            inner_stiffness_n_m1_5: optional("inner_stiffness", c.inner_stiffness)?,
            outer_stiffness_n_m1_5: optional("outer_stiffness", c.outer_stiffness)?,
            ball_stiffness_n_m1_5: optional("ball_stiffness", c.ball_stiffness)?,
        })
    }

    fn start(&self) -> Result<Start, CaseError> {
        let s = &self.document.start;
        let gaps = match &s.gaps {
            GapsDocument::Uniform => Gaps::Uniform,
            GapsDocument::ListDeg(gaps) => {
                let gaps = gaps.iter().map(|&g| self.si("start.gaps", g));
                Gaps::List(gaps.collect::<Result<_, _>>()?)
            }
        };
        let lead_ball_angle_rad = self.si("start.lead_ball_angle_deg", s.lead_ball_angle_deg)?;
        match s.state {
            StartState::Settled => {
                for (key, value) in [
                    ("start.ring_x_um", s.ring_x_um),
                    ("start.ring_y_um", s.ring_y_um),
                ] {
                    if let Some(value) = value {
                        let allowed = "left out unless start.state = \"rolling\": a settled start \
                                       finds the place of the ring itself";
                        return Err(self.refuse(key, &value.to_string(), allowed));
                    }
                }
                Ok(Start::Settled {
                    gaps,
                    lead_ball_angle_rad,
                })
            }
            StartState::Rolling => Ok(Start::Rolling {
                gaps,
                lead_ball_angle_rad,
                ring_x_m: self.si("start.ring_x_um", s.ring_x_um.unwrap_or(0.0))?,
                ring_y_m: self.si("start.ring_y_um", s.ring_y_um.unwrap_or(0.0))?,
            }),
        }
    }

    fn solver(&self) -> Result<Solver, CaseError> {
        let s = &self.document.solver;
        Ok(Solver {
            method: s.method,
            step_s: match s.step_us {
                StepDocument::FixedUs(step) => self.si("solver.step_us", step)?,
                // Put right once the case is known.
                StepDocument::Auto => PROVISIONAL_STEP_S,
            },
            tolerance: self.si("solver.tolerance", s.tolerance)?,
            duration_s: self.si("solver.duration_s", s.duration_s)?,
        })
    }

    fn seed(&self) -> Result<u64, CaseError> {
        let seed = self.document.solver.seed;
        // TOML holds no larger integer, and the document must be able to go back.
        if i64::try_from(seed).is_err() {
            return Err(self.refuse("solver.seed", &seed.to_string(), "less than 2^63"));
        }
        Ok(seed)
    }

    fn housing(&self) -> Result<Option<Housing>, CaseError> {
        let Some(h) = &self.document.housing else {
            return Ok(None);
        };
        Ok(Some(Housing {
            mass_kg: self.si("housing.mass_kg", h.mass_kg)?,
            stiffness_n_m: self.si("housing.stiffness_n_m", h.stiffness_n_m)?,
            damping_n_s_m: self.si("housing.damping_n_s_m", h.damping_n_s_m)?,
        }))
    }

    /// The value of a dotted key in SI units; refuses what is not finite.
    pub(super) fn si(&self, path: &str, value: f64) -> Result<f64, CaseError> {
        let (section, name) = split(path);
        let unit = keys::find(section, name).map_or(super::unit::Unit::None, |k| k.unit);
        let si = unit.to_si(value);
        if si.is_finite() {
            return Ok(si);
        }
        let allowed = match unit.symbol() {
            "" => "a finite number".to_owned(),
            symbol => format!("a finite number of {symbol}"),
        };
        Err(self.refuse(path, &value.to_string(), &allowed))
    }

    /// An error of [`cageless`] in terms of the file. `raceway` is the index of the
    /// raceway at fault, if one is.
    pub(super) fn refused(&self, error: &InputError, raceway: Option<usize>) -> CaseError {
        let Some(key) = keys::of_field(error.field) else {
            return self.places.error("", error.to_string());
        };
        let section = match raceway {
            Some(index) => nth(key.section, index, self.document.raceway.len()),
            None => key.section.to_owned(),
        };
        let path = join(&section, key.name);
        let allowed = messages::in_file_units(error, key, self.document, raceway);
        self.refuse(&path, &key.unit.show(error.value, Side::Nearest), &allowed)
    }

    fn refused_case(&self, error: &InputError, case: &Case) -> CaseError {
        match error.field {
            "gaps" => {
                let (value, allowed) = messages::gaps(self.document, &case.bearing);
                self.refuse("start.gaps", &value, &allowed)
            }
            "ring_x_m" | "ring_y_m" => {
                let path = join("start", keys::of_field(error.field).map_or("", |k| k.name));
                let value = error.value * 1e6;
                self.refuse(
                    &path,
                    &format!("{value} um"),
                    &messages::ring(&case.bearing),
                )
            }
            "centre_angle_rad" => match messages::overlap(case) {
                Some((one, other, allowed)) => {
                    let count = self.document.raceway.len();
                    let path = join(&nth("raceway", other, count), "centre_angle_deg");
                    let value = self.document.raceway[other].centre_angle_deg;
                    debug_assert!(one < other);
                    self.refuse(&path, &value.to_string(), &allowed)
                }
                None => self.refused(error, None),
            },
            _ => self.refused(error, None),
        }
    }

    /// The contacts of a case need steps too short for its duration. Which of the many values
    /// that decide is at fault cannot be determined.
    fn no_step(&self, case: &Case) -> CaseError {
        let Solver {
            step_s, duration_s, ..
        } = case.solver;
        let message = format!(
            "solver.step_us = \"auto\" is not possible: the contacts of this case need steps of \
             {:e} s, too many for solver.duration_s = {duration_s}; speed, load, material, \
             mass and drag of the inner ring, stiffness and damping of the contacts decide",
            step_s.max(f64::MIN_POSITIVE)
        );
        self.places.error("solver.step_us", message)
    }

    /// "KEY = VALUE is not possible: it must be ALLOWED", the value as written if it
    /// is, otherwise `value`.
    pub(super) fn refuse(&self, path: &str, value: &str, allowed: &str) -> CaseError {
        let value = self.places.written(path).unwrap_or(value);
        let message = format!("{path} = {value} is not possible: it must be {allowed}");
        self.places.error(path, message)
    }
}

/// Section and key of a dotted path: `raceway.2.axial_span_mm` is in `raceway`.
fn split(path: &str) -> (&str, &str) {
    let section = path.split_once('.').map_or("", |(section, _)| section);
    let name = path.rsplit_once('.').map_or(path, |(_, name)| name);
    (section, name)
}
