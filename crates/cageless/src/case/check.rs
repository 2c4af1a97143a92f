//! What a case may be.

use super::{Case, DURATION_MIN_S, Gaps, INTERVAL_MIN_S, Operation, STEPS_MAX, Start};
use crate::contact::hertz::DEFLECTION_FRACTION_MAX;
use crate::error::{Allowed, InputError};
use crate::flank_model::FlankModel;
use crate::limits::{not_negative, positive};
use crate::profile::Profile;
use crate::raceway::{Raceway, RacewayShape};
use crate::time_table::TimeTable;

/// Refuses a time in which nothing moves.
fn at_least_s(field: &'static str, value_s: f64, least_s: f64) -> Result<(), InputError> {
    if value_s >= least_s {
        return Ok(());
    }
    let allowed = Allowed::AtLeast(least_s, "nothing moves in less");
    Err(InputError::new(field, value_s, allowed))
}

impl Operation {
    fn check(&self) -> Result<(), InputError> {
        not_negative("radial_load_n", self.radial_load_n)?;
        not_negative("gravity_m_s2", self.gravity_m_s2)?;
        for (field, start, table) in self.given() {
            let Some(table) = table else { continue };
            if let Some(&value) = table.values().iter().find(|v| **v < 0.0) {
                let rule = match field {
                    "inner_speed_rad_s" => {
                        "0 or more at all times, or 0 or less: one sense of rotation"
                    }
                    _ => "0 or more",
                };
                return Err(InputError::rule(field, value, rule));
            }
            let first = table.value(0.0);
            if start != first {
                let rule = format!("{first}, the value of its table at t = 0");
                return Err(InputError::rule(field, start, rule));
            }
        }
        Ok(())
    }

    /// Speed and load: field, value at the start, and the table of one that changes.
    fn given(&self) -> [(&'static str, f64, Option<&TimeTable>); 2] {
        let (speeds, loads) = (&self.inner_speed_table, &self.radial_load_table);
        [
            ("inner_speed_rad_s", self.inner_speed_rad_s, speeds.as_ref()),
            ("radial_load_n", self.radial_load_n, loads.as_ref()),
        ]
    }
}

impl Case {
    /// Checks everything that [`crate::Bearing::new`] and [`crate::Raceway::new`] have not.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be.
    pub fn check(&self) -> Result<(), InputError> {
        if self.rotor.is_none() && self.operation.inner_speed_table.is_none() {
            positive("inner_speed_rad_s", self.operation.inner_speed_rad_s)?;
        }
        self.operation.check()?;
        self.check_space()?;
        self.check_rotor()?;
        self.check_flanks()?;
        if self.profile == Profile::Paper {
            self.check_published_form(
                "the published equations have friction along the quartic contact path",
            )?;
        }
        self.contact.check()?;
        self.lubrication.as_ref().map_or(Ok(()), |l| l.check())?;
        self.thermal.check()?;
        for raceway in &self.raceways {
            raceway.fits(&self.bearing)?;
        }
        crate::raceway::apart(&self.raceways)?;
        crate::outer_contact_geometry::check(&self.bearing, &self.raceways)?;
        self.check_elastic()?;
        self.check_start()?;
        positive("step_s", self.solver.step_s)?;
        positive("tolerance", self.solver.tolerance)?;
        positive("duration_s", self.solver.duration_s)?;
        at_least_s("duration_s", self.solver.duration_s, DURATION_MIN_S)?;
        let steps = self.solver.duration_s / self.solver.step_s;
        if steps > STEPS_MAX {
            return Err(InputError::new(
                "duration_s",
                self.solver.duration_s,
                Allowed::AtMost(
                    STEPS_MAX * self.solver.step_s,
                    "1e12 steps are the limit; solver.step_us sets their size",
                ),
            ));
        }
        positive("interval_s", self.output.interval_s)?;
        at_least_s("interval_s", self.output.interval_s, INTERVAL_MIN_S)?;
        if let Some(h) = &self.housing {
            positive("mass_kg", h.mass_kg)?;
            positive("stiffness_n_m", h.stiffness_n_m)?;
            not_negative("damping_n_s_m", h.damping_n_s_m)?;
        }
        Ok(())
    }

    /// Refuses speeds and loads whose deflection exceeds that of any elastic contact, the
    /// most loaded ball taking 5/N of the load (Stribeck) and its own centrifugal force.
    fn check_elastic(&self) -> Result<(), InputError> {
        let bearing = &self.bearing;
        let [inner, outer, _] = self.stiffness_n_m1_5();
        let deflection = DEFLECTION_FRACTION_MAX * bearing.ball_radius_m();
        let bears = inner.min(outer) * deflection.powf(1.5);
        let gravity_m_s2 = self.operation.gravity_m_s2;
        let radial_load_n = self.largest_radial_load_n();
        let mass = bearing.ball_mass_kg();
        let centrifugal = self.centrifugal_force_n();
        let elastic = "an elastic contact bears a deflection of 5 % of the ball radius";
        if !(centrifugal <= bears) {
            let (field, speed) = match &self.rotor {
                Some(rotor) => ("rotor_speed_rad_s", rotor.speed_rad_s.abs()),
                None => ("inner_speed_rad_s", self.largest_inner_speed_rad_s()),
            };
            let most = speed * (bears / centrifugal).sqrt();
            return Err(InputError::new(
                field,
                speed,
                if most > 0.0 {
                    Allowed::AtMost(most, elastic)
                } else {
                    Allowed::Rule(format!("less: {elastic}"))
                },
            ));
        }
        let weight = (bearing.dimensions().inner_ring_mass_kg + mass) * gravity_m_s2;
        let most = (bears - centrifugal) * bearing.balls() as f64 / 5.0 - weight;
        if !(radial_load_n <= most) {
            return Err(if most >= 0.0 {
                InputError::new(
                    "radial_load_n",
                    radial_load_n,
                    Allowed::AtMost(most, elastic),
                )
            } else {
                InputError::rule(
                    "gravity_m_s2",
                    gravity_m_s2,
                    format!("less: {elastic}, and the weight of the ring is too much"),
                )
            });
        }
        Ok(())
    }

    /// Refuses elastic flanks where the equations have none.
    fn check_flanks(&self) -> Result<(), InputError> {
        let why = match (self.flanks, self.profile) {
            (FlankModel::Elastic, Profile::Paper) => "the published equations have rigid flanks",
            (FlankModel::Elastic, _) if self.contact.friction_law.sticks() => {
                "flanks that slide in two directions and spin need a law with a \
                 regularisation speed"
            }
            _ => return Ok(()),
        };
        let rule = format!("\"rigid\": {why}");
        Err(InputError::rule("flanks", f64::NAN, rule))
    }

    /// Passes raceways of Zhao 2022, with the quartic contact path up to their ends.
    ///
    /// # Errors
    /// An [`InputError`] of the form of another, with `why` it cannot be.
    pub(crate) fn check_published_form(&self, why: &str) -> Result<(), InputError> {
        for form in self.raceways.iter().map(Raceway::form) {
            if form.shape != RacewayShape::Quartic {
                let rule = format!("\"quartic\": {why}");
                return Err(InputError::rule("shape", f64::NAN, rule));
            }
            for (field, value) in [("blend_m", form.blend_m), ("depth_m", form.depth_m)] {
                if value > 0.0 {
                    return Err(InputError::rule(field, value, format!("0: {why}")));
                }
            }
        }
        Ok(())
    }

    /// Checks the rotor and what a case with one must and must not have.
    fn check_rotor(&self) -> Result<(), InputError> {
        let Some(rotor) = &self.rotor else {
            return match &self.support {
                None => Ok(()),
                Some(support) => Err(InputError::rule(
                    "support_mass_kg",
                    support.mass_kg,
                    "left out: the outer ring moves on a support only under a falling rotor",
                )),
            };
        };
        let Some(bore) = self.bearing.inner_ring_bore() else {
            return Err(InputError::rule(
                "inner_ring_polar_inertia_kg_m2",
                f64::NAN,
                "given, and inner_ring_bore_radius_mm: the rotor spins the inner ring up in its bore",
            ));
        };
        let groove_m = self.bearing.dimensions().inner_groove_bottom_radius_m;
        rotor.check(bore.radius_m, groove_m)?;
        if let Some(support) = &self.support {
            support.check()?;
        }
        for (field, value, table) in self.operation.given() {
            if value != 0.0 || table.is_some() {
                let rule = "left out: the rotor drives and loads the inner ring";
                return Err(InputError::rule(field, value, rule));
            }
        }
        if let Some(housing) = &self.housing {
            let rule = "left out: with a rotor the outer ring moves on its support";
            return Err(InputError::rule("mass_kg", housing.mass_kg, rule));
        }
        if self.profile != Profile::Physical {
            let rule = "\"physical\": the published equations have no rotor";
            return Err(InputError::rule("formulation", f64::NAN, rule));
        }
        if !matches!(self.start, Start::AtRest { .. }) {
            let rule = "\"at-rest\": the rotor falls onto a bearing at rest";
            return Err(InputError::rule("start_state", f64::NAN, rule));
        }
        Ok(())
    }

    /// Passes a case whose inner ring turns at constant speed under a constant load; `what`
    /// needs that.
    ///
    /// # Errors
    /// An [`InputError`] naming the rotor or the table.
    pub fn check_constant_operation(&self, what: &str) -> Result<(), InputError> {
        if self.rotor.is_some() {
            let why = format!("{what} needs an inner ring at constant speed");
            return Err(InputError::rotor_left_out(why));
        }
        for (field, start, table) in self.operation.given() {
            if table.is_some() {
                let rule = format!("one number, not a table over time: {what} needs that");
                return Err(InputError::rule(field, start, rule));
            }
        }
        Ok(())
    }

    fn check_start(&self) -> Result<(), InputError> {
        let start = &self.start;
        if !start.lead_ball_angle_rad().is_finite() {
            return Err(InputError::rule(
                "lead_ball_angle_rad",
                start.lead_ball_angle_rad(),
                "a finite angle",
            ));
        }
        if let &Start::Rolling {
            ring_x_m, ring_y_m, ..
        } = start
        {
            // A ball pressed in by a tenth of its radius is far past any elastic contact.
            let most = 0.5 * self.bearing.radial_internal_clearance_m()
                + 0.1 * self.bearing.ball_radius_m();
            for (field, value) in [("ring_x_m", ring_x_m), ("ring_y_m", ring_y_m)] {
                if !(value.abs() <= most) {
                    return Err(InputError::rule(
                        field,
                        value,
                        format!("within ±{most:e} of the centre"),
                    ));
                }
            }
        }
        if let Gaps::List(gaps) = start.gaps() {
            let n = self.bearing.balls();
            if gaps.len() != n {
                return Err(InputError::rule(
                    "gaps",
                    gaps.len() as f64,
                    format!("a list of {n} gaps, one per ball"),
                ));
            }
            if let Some(&bad) = gaps.iter().find(|g| !(**g >= 0.0)) {
                return Err(InputError::rule(
                    "gaps",
                    bad,
                    "0 or more each: balls cannot overlap",
                ));
            }
            let sum: f64 = gaps.iter().sum();
            let room = n as f64 * self.bearing.mean_gap_rad();
            // A list printed with four decimals of a degree passes, and one for nominal
            // balls: the last gap takes what is left.
            let nominal = n as f64 * self.bearing.nominal_gap_rad();
            let slack = n as f64 * 1e-4_f64.to_radians() + (room - nominal).abs();
            if (sum - room).abs() > slack {
                return Err(InputError::rule(
                    "gaps",
                    sum,
                    format!("gaps that add up to 2π − N ε = {room}"),
                ));
            }
        }
        Ok(())
    }
}
