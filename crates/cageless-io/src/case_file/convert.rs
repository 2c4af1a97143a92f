//! Conversion of the sections to the case, with the checks of [`cageless`].

mod bearing;
mod film;
mod material;
mod operation;
mod search;
mod start;
mod steady;

use cageless::SupportStop;
use cageless::film::Film;
use cageless::steady::SteadyOperation;
use cageless::step_limits::StepLimits;
use cageless::touchdown::Limit;
use cageless::{
    Bearing, Case, Ends, FlankModel, InputError, Lubrication, OperatingClearance, Raceway,
    RacewayDimensions, RacewayForm, Row, Solver, Support,
};
use cageless_design::search::Request;

use cageless_results::{Kind, LIMITED, Particulars, Quantity};

use super::converter::Converter;
use super::document::CaseDocument;
use super::error::CaseError;
use super::fields::FlankRows;
use super::format::nearest;
use super::sections::CaseSections;
use super::spanned_toml::{join, nth};
use super::unit::Side;
use super::unit::Unit::{Micrometre, Millimetre};
use super::unit::round;
use super::{keys, messages};

/// No contact of a bearing needs steps this short.
const NO_STEP_S: f64 = 1e-12;
/// Step of a case whose step is still to be chosen.
const PROVISIONAL_STEP_S: f64 = 1e-6;

/// Key of the regularisation speed of the balls, which follows from the rolling speed unless given.
pub(super) const REGULARISATION: &str = "contact.regularisation_speed_m_s";
/// Key of the viscosity for ratings, which follows from the oil of a film.
const RATED_VISCOSITY: &str = "lubrication.viscosity_mm2_s";
/// Viscosity of a case whose oil is still to be read.
const PROVISIONAL_VISCOSITY: f64 = 1.0;
/// Regularisation speed of a case until it is chosen, and of drops, in which balls slide, m/s.
const PROVISIONAL_SPEED_M_S: f64 = 0.02;

/// A check of a case.
pub(super) type Check = fn(&Case) -> Result<(), InputError>;

/// A document with the keys that its sections need.
pub(super) fn completed(document: &CaseDocument) -> CaseDocument {
    let mut completed = document.clone();
    if !completed.has(REGULARISATION) {
        completed.set(REGULARISATION, PROVISIONAL_SPEED_M_S);
    }
    if completed.count("film") * completed.count("lubrication") > 0
        && !completed.has(RATED_VISCOSITY)
    {
        completed.set(RATED_VISCOSITY, PROVISIONAL_VISCOSITY);
    }
    completed
}

/// Contents of a document: case, particulars, search and steady operation.
pub(super) struct Converted {
    /// The case.
    pub case: Case,
    /// Particulars of the case.
    pub particulars: Particulars,
    /// Request of the search.
    pub search: Request,
    /// Steady operation.
    pub steady: SteadyOperation,
}

/// Converts and checks, with `check` as last word on the case.
pub(super) fn converted(document: &CaseDocument, check: Check) -> Result<Converted, CaseError> {
    let regularised = document.has(REGULARISATION);
    if document.count("film") > 0 && document.has(RATED_VISCOSITY) {
        let value = document.value(RATED_VISCOSITY).map(|value| value.written());
        let allowed = "left out with [film], whose oil gives the viscosity";
        let refused = document
            .tree
            .refusal(RATED_VISCOSITY, &value.unwrap_or_default(), allowed);
        return Err(refused);
    }
    let completed = completed(document);
    let sections = &CaseSections::read(&completed.tree)?;
    let converter = Converter {
        sections,
        document: &completed,
        regularised,
    };
    let (bearing, fit) = converter.bearing()?;
    let case = converter.case(bearing, check)?;
    let particulars = converter.particulars(fit, case.film.as_ref())?;
    let refused = |error| converter.refused_case(&error, &case);
    particulars.check(&case.bearing).map_err(refused)?;
    Ok(Converted {
        search: converter.search(&case)?,
        steady: converter.steady()?,
        case,
        particulars,
    })
}

impl Converter<'_> {
    /// Particulars of the case, for results and commands.
    fn particulars(
        &self,
        fit: Option<OperatingClearance>,
        film: Option<&Film>,
    ) -> Result<Particulars, CaseError> {
        let s = self.sections;
        Ok(Particulars {
            title: s.head.title.clone(),
            seed: s.solver.seed,
            interval_s: s.output.interval_s,
            fit,
            lubrication: s.lubrication.clone().map(|lubrication| Lubrication {
                viscosity_m2_s: film.map_or(lubrication.viscosity_m2_s, |film| {
                    film.oil.kinematic_viscosity_m2_s()
                }),
                ..lubrication
            }),
            thermal: self.thermal(),
            limits: self.limits()?,
        })
    }

    fn case(&self, bearing: Bearing, check: Check) -> Result<Case, CaseError> {
        let s = self.sections;
        self.check_export_dimensions(&bearing)?;
        let raceways = self.raceways(&bearing)?;
        let rows = self.rows(&bearing)?;
        let start = self.start(&bearing)?;
        let film = self.film()?;
        let mut case = Case {
            bearing,
            raceways,
            operation: self.operation()?,
            contact: s.contact.clone(),
            formulation: s.model.formulation,
            motion: s.model.motion,
            flanks: s.model.flanks,
            start,
            solver: Solver {
                method: s.solver.method,
                // An automatic step is put right once the case is known.
                step_s: s.solver.step_s.0.unwrap_or(PROVISIONAL_STEP_S),
                tolerance: s.solver.tolerance,
                duration_s: s.solver.duration_s,
                transient_s: s.solver.transient_s,
            },
            housing: s.housing.clone(),
            rotor: s.rotor.clone(),
            support: self.support()?,
            rows,
            film,
        };
        if !self.regularised && case.rotor.is_none() {
            case.contact.friction.regularisation_speed_m_s = case.automatic_regularisation_m_s();
        }
        let automatic = s.solver.step_s.0.is_none();
        if automatic {
            let step_s = StepLimits::new(&case).automatic_s(case.solver.method);
            if step_s.is_finite() {
                case.solver.step_s = step_s;
            }
        }
        check(&case).map_err(|e| match e.field {
            "step_s" | "duration_s" if automatic && case.solver.step_s < NO_STEP_S => {
                self.no_step(&case)
            }
            _ => self.refused_case(&e, &case),
        })?;
        if let Some(film) = self.starved(&case)? {
            case.film = Some(film);
        }
        Ok(case)
    }

    /// The rows; of opposed ones with the preload that fits and temperatures leave.
    fn rows(&self, bearing: &Bearing) -> Result<Vec<Row>, CaseError> {
        let mut rows = self.sections.row.clone();
        self.check_places(&rows, bearing)?;
        let change_m = bearing.preload_change_m();
        let held = |row: &&Row| row.preload_n == 0.0;
        let opposed = [1.0, -1.0].map(|sign| {
            let mut held = rows.iter().filter(held);
            held.any(|row| row.contact_sign == sign)
        });
        if change_m == 0.0 || opposed != [true; 2] {
            return Ok(rows);
        }
        let most_m = bearing.axial_preload_max_m();
        let held = rows
            .iter_mut()
            .enumerate()
            .filter(|(_, row)| row.preload_n == 0.0);
        for (index, row) in held {
            row.preload_m += change_m;
            if !(row.preload_m >= 0.0 && row.preload_m <= most_m) {
                let [change, left, most] =
                    [change_m, row.preload_m, most_m].map(|m| Micrometre.of_si(m));
                let message = format!(
                    "[fit] changes the preload of row {} by {change:.2} µm to {left:.2} µm: it must be \
                     from 0 to {most:.2} µm (preload_um, which two opposed rows may share between them)",
                    index + 1
                );
                return Err(self.document.tree.error("fit", message));
            }
        }
        Ok(rows)
    }

    /// Refuses rows whose balls overlap along the axis.
    fn check_places(&self, rows: &[Row], bearing: &Bearing) -> Result<(), CaseError> {
        let least_m = 2.0 * bearing.ball_radius_m();
        for (k, row) in rows.iter().enumerate() {
            let near =
                |other: &Row| (row.axial_position_m - other.axial_position_m).abs() < least_m;
            let Some(other) = rows[..k].iter().position(near) else {
                continue;
            };
            let [at, least] = [rows[other].axial_position_m, least_m].map(|m| Millimetre.of_si(m));
            let allowed = format!(
                "{} or more from row {}, at {}: nearer than the diameter of a ball the balls of both rows \
                 overlap",
                Millimetre.with(round(least, Side::Lower)),
                other + 1,
                Millimetre.with(at)
            );
            let path = join(&nth("row", k, rows.len()), "axial_position_mm");
            return Err(self.refuse(&path, &allowed));
        }
        Ok(())
    }

    /// The discrete raceways.
    fn raceways(&self, bearing: &Bearing) -> Result<Vec<Raceway>, CaseError> {
        let unless_given = match self.sections.model.flanks {
            FlankModel::Elastic => Ends::Machined,
            FlankModel::Rigid => Ends::default(),
        };
        let raceways = self.sections.raceway.iter().enumerate();
        let raceways = raceways.map(|(index, raceway)| {
            let section = nth("raceway", index, self.sections.raceway.len());
            let mut form = RacewayForm::default();
            form.shape = raceway.shape;
            form.ends = raceway.blend_m.map_or(unless_given, Ends::Blended);
            form.depth_m = raceway.depth_m;
            form.edge_radius_m = raceway.edge_radius_m.unwrap_or(0.0);
            form.slot_depth_m = raceway.slot_depth_m;
            if let Some(FlankRows(rows)) = &raceway.profile {
                let key = join(&section, "profile");
                form = form
                    .with_profile(rows)
                    .map_err(|e| self.refuse(&key, &e.allowed.to_string()))?;
            }
            let given = |value: Option<f64>, name: &str, own: Option<f64>| {
                let missing = || self.missing(&section, name);
                value.or(own).ok_or_else(missing)
            };
            let own = form.profile_rad();
            let span = own.map(|[middle, _]| 2.0 * bearing.ball_radius_m() * middle.sin());
            let half_angle = own.map(|[_, theta]| theta);
            let dimensions = RacewayDimensions {
                axial_span_m: given(raceway.axial_span_m, "axial_span_mm", span)?,
                half_angle_rad: given(raceway.half_angle_rad, "half_angle_deg", half_angle)?,
                centre_angle_rad: raceway.centre_angle_rad,
            };
            Raceway::formed(dimensions, form, bearing)
                .and_then(|made| made.with_depth_error(raceway.depth_error_m))
                .and_then(|made| match raceway.contact_angle_rad {
                    Some(angle) => made.with_section_angle(angle, bearing),
                    None => Ok(made),
                })
                .map_err(|e| self.refused(&e, Some(index)))
        });
        raceways.collect()
    }

    /// Limits on results, which must be among those that can be limited.
    fn limits(&self) -> Result<Vec<Limit>, CaseError> {
        let limits = &self.sections.limit;
        let names = || {
            let all = LIMITED.iter().copied().flatten();
            let numbers = all.filter(|q| matches!(q.kind, Kind::Number | Kind::Integer));
            numbers.map(|quantity| quantity.name)
        };
        for (index, limit) in limits.iter().enumerate() {
            if limit.source.trim().is_empty() {
                let path = join(&nth("limit", index, limits.len()), "source");
                return Err(self.refuse(&path, "whose limit it is, which the verdict names"));
            }
            let mut all = LIMITED.iter().copied().flatten();
            let found = all.find(|q| q.name == limit.result);
            if limit.side.is_none()
                && limit.value < 0.0
                && found.is_some_and(Quantity::is_limited_in_magnitude)
            {
                let path = join(&nth("limit", index, limits.len()), "value");
                let allowed = "0 or more: the most that this result may be in magnitude";
                return Err(self.refuse(&path, allowed));
            }
            if names().any(|name| name == limit.result) {
                continue;
            }
            let path = join(&nth("limit", index, limits.len()), "result");
            let near = nearest(&limit.result, names());
            let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
            let allowed = format!(
                "the name of a number among the results of static, run, design, compare or drop \
                 (docs/results.md), l10_h or rotor_force_max_n say{near}"
            );
            return Err(self.refuse(&path, &allowed));
        }
        Ok(limits.clone())
    }

    /// The support of the outer ring.
    fn support(&self) -> Result<Option<Support>, CaseError> {
        let Some(s) = &self.sections.support else {
            return Ok(None);
        };
        let stop = match (s.stop_gap_m, s.stop_stiffness_n_m) {
            (None, None) => None,
            (Some(gap_m), Some(stiffness_n_m)) => Some(SupportStop {
                gap_m,
                stiffness_n_m,
            }),
            (None, Some(_)) => return Err(self.missing("support", "stop_gap_um")),
            (Some(_), None) => return Err(self.missing("support", "stop_stiffness_n_m")),
        };
        Ok(Some(Support {
            mass_kg: s.support_mass_kg,
            stiffness_n_m: s.support_stiffness_n_m,
            damping_n_s_m: s.support_damping_n_s_m,
            stop,
        }))
    }

    fn refused_case(&self, error: &InputError, case: &Case) -> CaseError {
        match error.field {
            "gaps" => {
                let allowed = messages::gaps(self.document, &case.bearing);
                self.refuse("start.gaps", &allowed)
            }
            "ring_x_m" | "ring_y_m" => {
                let path = keys::of_field(None, error.field)
                    .map_or_else(String::new, |(s, k)| join(s, k.name));
                self.refuse(&path, &messages::ring(&case.bearing))
            }
            "centre_angle_rad" => match messages::overlap(case) {
                Some((other, allowed)) => {
                    let count = self.sections.raceway.len();
                    let path = join(&nth("raceway", other, count), "centre_angle_deg");
                    self.refuse(&path, &allowed)
                }
                None => self.refused(error, None),
            },
            // What the formulation does not have.
            "shape" | "blend_m" => {
                let formed = |r: &Raceway| r.form() != RacewayForm::default();
                self.refused(error, case.raceways.iter().position(formed))
            }
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
        self.document.tree.error("solver.step_us", message)
    }
}
