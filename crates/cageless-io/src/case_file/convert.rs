//! Conversion of the document to the case in SI units, with the checks of [`cageless`].

use cageless::design::search::Request;
use cageless::step_limits::StepLimits;
use cageless::{Case, InputError, Solver};

use super::SCHEMA;
use super::document::{CaseDocument, StepDocument, nth};
use super::error::CaseError;
use super::keys;
use super::messages;
use super::spanned_toml::{Places, join};
use super::unit::Side;

/// No contact of a bearing needs steps this short.
const NO_STEP_S: f64 = 1e-12;

/// Converts and checks.
pub(super) fn case(document: &CaseDocument, places: &Places) -> Result<(Case, Request), CaseError> {
    let converter = Converter { document, places };
    let case = converter.case()?;
    let search = converter.search(&case)?;
    Ok((case, search))
}

/// Conversion of one document; `places` says where its values come from.
pub(crate) struct Converter<'a> {
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
        self.check_export_dimensions(&bearing)?;
        let raceways = self.raceways(&bearing)?;
        let housing = document.housing.as_ref();
        let start = self.start(&bearing)?;
        let rotor = document.rotor.as_ref();
        let mut case = Case {
            title: document.title.clone(),
            bearing,
            raceways,
            operation: self.operation()?,
            contact: document.contact.to_si(self, "contact")?,
            profile: document.model.profile,
            start,
            solver: self.solver()?,
            seed: self.seed()?,
            housing: housing.map(|h| h.to_si(self, "housing")).transpose()?,
            rotor: rotor.map(|r| r.to_si(self, "rotor")).transpose()?,
            support: self.support()?,
            output: document.output.to_si(self, "output")?,
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

    /// The value of a dotted key in SI units; refuses what is not finite.
    pub(super) fn si(&self, path: &str, value: f64) -> Result<f64, CaseError> {
        let (section, name) = split(path);
        let unit = keys::unit(section, name);
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
        self.refused_in(None, error, raceway)
    }

    /// Error of the case file for `error` of the library, in `section` where several sections have
    /// such a field.
    pub(super) fn refused_in(
        &self,
        section: Option<&str>,
        error: &InputError,
        raceway: Option<usize>,
    ) -> CaseError {
        let Some((section, key)) = keys::of_field(section, error.field) else {
            return self.places.error("", error.to_string());
        };
        let path = match raceway {
            Some(index) => nth(section, index, self.document.raceway.len()),
            None => section.to_owned(),
        };
        let path = join(&path, key.name);
        let allowed = messages::in_file_units(error, key, self.document, raceway);
        // A key that is optional by itself, and that something else in the case needs.
        if error.value.is_nan() && self.document.value(&path).is_none() {
            let meaning = keys::describe(key);
            let message =
                format!("{path} is missing in [{section}]: {meaning}; it must be {allowed}");
            return self.places.error(&path, message);
        }
        let value = key.unit.show(error.value, Side::Nearest);
        if let Some((origin, how)) = self.origin_of(&path) {
            let message = format!("{path} = {value} ({how}) is not possible: it must be {allowed}");
            return self.places.error(origin, message);
        }
        self.refuse(&path, &value, &allowed)
    }

    fn refused_case(&self, error: &InputError, case: &Case) -> CaseError {
        match error.field {
            "gaps" => {
                let (value, allowed) = messages::gaps(self.document, &case.bearing);
                self.refuse("start.gaps", &value, &allowed)
            }
            "ring_x_m" | "ring_y_m" => {
                let path = keys::of_field(None, error.field)
                    .map_or_else(String::new, |(s, k)| join(s, k.name));
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

    /// An error of a key that is left out.
    pub(super) fn missing(&self, section: &str, name: &str) -> CaseError {
        let path = join(section, name);
        let meaning = keys::find(section, name).map_or_else(String::new, keys::describe);
        let message = match self.places.written(section) {
            Some(_) => format!("{path} is missing in [{section}]: {meaning}"),
            None => format!("{path} is missing, as is its section [{section}]: {meaning}"),
        };
        self.places.error(&path, message)
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
