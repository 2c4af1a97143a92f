//! Conversion of the document to the case in SI units, with the checks of [`cageless`].

mod bearing;
mod material;
mod operation;
mod raceway;
mod search;
mod solver;
mod start;
mod support;

use cageless::design::search::Request;
use cageless::step_limits::StepLimits;
use cageless::{Case, InputError, Solver};

use super::converter::Converter;
use super::document::{CaseDocument, SCHEMA};
use super::error::CaseError;
use super::fields::StepDocument;
use super::spanned_toml::{Places, join, nth};
use super::{keys, messages};

/// No contact of a bearing needs steps this short.
const NO_STEP_S: f64 = 1e-12;

/// Converts and checks.
pub(super) fn case(document: &CaseDocument, places: &Places) -> Result<(Case, Request), CaseError> {
    let converter = Converter { document, places };
    let case = converter.case()?;
    let search = converter.search(&case)?;
    Ok((case, search))
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
        let si =
            |section: &'static str| move |key: &str, value| self.si(&join(section, key), value);
        let start = self.start(&bearing)?;
        let rotor = document.rotor.as_ref();
        let mut case = Case {
            title: document.title.clone(),
            bearing,
            raceways,
            operation: self.operation()?,
            contact: document.contact.to_si(&si("contact"))?,
            profile: document.model.formulation,
            start,
            solver: self.solver()?,
            seed: self.seed()?,
            housing: housing.map(|h| h.to_si(&si("housing"))).transpose()?,
            rotor: rotor.map(|r| r.to_si(&si("rotor"))).transpose()?,
            support: self.support()?,
            output: document.output.to_si(&si("output"))?,
        };
        let automatic = document.solver.step_us == StepDocument::Auto;
        if automatic {
            let step_s = StepLimits::new(&case).automatic_s(case.solver.method);
            if step_s.is_finite() {
                case.solver.step_s = step_s;
            }
        }
        cageless::step_limits::check(&case).map_err(|e| match e.field {
            "step_s" | "duration_s" if automatic && case.solver.step_s < NO_STEP_S => {
                self.no_step(&case)
            }
            _ => self.refused_case(&e, &case),
        })?;
        Ok(case)
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
}
