//! Checks of a case.

use std::f64::consts::TAU;

use super::{Case, DURATION_MIN_S, Gaps, InnerRingDrive, Operation, STEPS_MAX, StartState};
use crate::contact::hertz::DEFLECTION_FRACTION_MAX;
use crate::equations::CasePart;
use crate::error::{Allowed, InputError};
use crate::formulation::Formulation;
use crate::limits::{from_to, not_negative, positive, require};
use crate::raceway::RacewayShape;
use crate::time_table::TimeTable;

impl Operation {
    fn check(&self) -> Result<(), InputError> {
        not_negative("radial_load_n", self.radial_load_n)?;
        not_negative("gravity_m_s2", self.gravity_m_s2)?;
        not_negative("unbalance_kg_m", self.unbalance.amount_kg_m)?;
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
            let rule = format!("{first}, the value of its table at t = 0");
            require(field, start, start == first, rule)?;
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
    /// Checks speed and load of a bearing in motion, which may come to a stand.
    ///
    /// # Errors
    /// An [`InputError`] naming the first of them that cannot be.
    pub(crate) fn check_operation(&self) -> Result<(), InputError> {
        if let InnerRingDrive::Constant(speed) = self.inner_ring_drive() {
            not_negative("inner_speed_rad_s", speed)?;
        }
        self.operation.check()?;
        self.check_elastic()
    }

    /// Checks everything that [`crate::Bearing::new`] and [`crate::Raceway::new`] have not.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be.
    pub fn check(&self) -> Result<(), InputError> {
        if let InnerRingDrive::Constant(speed) = self.inner_ring_drive() {
            let field = "inner_speed_rad_s";
            let rule = "other than 0: the balls of a ring at rest do not roll";
            require(field, speed, speed != 0.0, rule)?;
            positive(field, speed)?;
        }
        self.operation.check()?;
        self.check_space()?;
        self.check_rotor()?;
        self.check_flanks()?;
        if self.formulation.equations().friction_along_path {
            self.check_published_form(
                "the published equations have friction along the quartic contact path",
            )?;
        }
        self.contact.check()?;
        self.check_creep()?;
        self.check_film()?;
        self.check_unbalance()?;
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
        Allowed::AtLeast(DURATION_MIN_S, "nothing moves in less")
            .check("duration_s", self.solver.duration_s)?;
        let why = "1e12 steps are the limit; solver.step_us sets their size";
        Allowed::AtMost(STEPS_MAX * self.solver.step_s, why)
            .check("duration_s", self.solver.duration_s)?;
        if let Some(transient_s) = self.solver.transient_s {
            let less = transient_s < self.solver.duration_s;
            let rule = format!("less than solver.duration_s, {}", self.solver.duration_s);
            require("transient_s", transient_s, less, rule)?;
        }
        if let Some(h) = &self.housing {
            positive("mass_kg", h.mass_kg)?;
            positive("stiffness_n_m", h.stiffness_n_m)?;
            not_negative("damping_n_s_m", h.damping_n_s_m)?;
        }
        Ok(())
    }

    /// Refuses an unbalance where the equations have none.
    fn check_unbalance(&self) -> Result<(), InputError> {
        if self.operation.unbalance.amount_kg_m == 0.0 {
            return Ok(());
        }
        let of_equations = self.formulation.refusal(CasePart::Unbalance);
        match (of_equations, self.inner_ring_drive()) {
            (Some(why), _) => self.refuse_unbalance(why),
            (None, InnerRingDrive::Rotor(_)) => {
                self.refuse_unbalance("the rotor has one, by its eccentricity")
            }
            (None, InnerRingDrive::Constant(_) | InnerRingDrive::OverTime(_)) => Ok(()),
        }
    }

    /// Passes a case without an unbalance; `what` needs a load that stands still.
    ///
    /// # Errors
    /// An [`InputError`] naming the unbalance.
    pub fn check_balanced(&self, what: &str) -> Result<(), InputError> {
        match self.operation.unbalance.amount_kg_m == 0.0 {
            true => Ok(()),
            false => self.refuse_unbalance(&format!("{what} needs a load that stands still")),
        }
    }

    fn refuse_unbalance(&self, why: &str) -> Result<(), InputError> {
        let amount = self.operation.unbalance.amount_kg_m;
        Err(InputError::rule(
            "unbalance_kg_m",
            amount,
            format!("0: {why}"),
        ))
    }

    /// Refuses oil that cannot be, and a film where the equations have none.
    fn check_film(&self) -> Result<(), InputError> {
        let Some(film) = &self.film else {
            return Ok(());
        };
        film.check()?;
        let Some(why) = self.why_without_film() else {
            return self.check_traction();
        };
        let rule = format!("left out, with all of [film]: {why}");
        Err(InputError::rule("supply", film.supply, rule))
    }

    /// Why the equations of the case have no film; `None` where they have one.
    pub fn why_without_film(&self) -> Option<&'static str> {
        match () {
            () if self.formulation == Formulation::Paper => {
                Some("the published equations have no film")
            }
            () if self.rotor.is_some() => Some("the film under a falling rotor is not computed"),
            () => None,
        }
    }

    /// Refuses speeds and loads whose deflection exceeds that of any elastic contact, the
    /// most loaded ball taking 5/N of the load (Stribeck) and its own centrifugal force.
    fn check_elastic(&self) -> Result<(), InputError> {
        let bearing = &self.bearing;
        let [inner, outer, _] = self.stiffness_n_m1_5();
        let deflection = DEFLECTION_FRACTION_MAX * bearing.ball_radius_m();
        let bears = inner.min(outer) * deflection.powf(1.5);
        let gravity_m_s2 = self.operation.gravity_m_s2;
        let turning_n = self.operation.unbalance_force_n();
        let radial_load_n = self.largest_radial_load_n();
        let mass = bearing.ball_mass_kg();
        let centrifugal = self.centrifugal_force_n();
        let elastic = "an elastic contact bears a deflection of 5 % of the ball radius";
        if !(centrifugal <= bears) {
            let (field, speed) = match self.inner_ring_drive() {
                InnerRingDrive::Constant(speed) => ("inner_speed_rad_s", speed),
                InnerRingDrive::OverTime(table) => ("inner_speed_rad_s", table.range()[1]),
                InnerRingDrive::Rotor(rotor) => ("rotor_speed_rad_s", rotor.speed_rad_s.abs()),
            };
            let most = speed * (bears / centrifugal).sqrt();
            let allowed = match most > 0.0 {
                true => Allowed::AtMost(most, elastic),
                false => Allowed::Rule(format!("less: {elastic}")),
            };
            return Err(InputError::new(field, speed, allowed));
        }
        let weight = (bearing.dimensions().inner_ring_mass_kg + mass) * gravity_m_s2;
        let most = (bears - centrifugal) * bearing.balls() as f64 / 5.0 - weight;
        let rule = format!("less: {elastic}, and the weight of the ring is too much");
        require("gravity_m_s2", gravity_m_s2, most >= 0.0, rule)?;
        Allowed::AtMost(most, elastic).check("radial_load_n", radial_load_n)?;
        if turning_n == 0.0 {
            return Ok(());
        }
        let amount = self.operation.unbalance.amount_kg_m;
        Allowed::AtMost(amount * (most - radial_load_n) / turning_n, elastic)
            .check("unbalance_kg_m", amount)
    }

    /// Refuses elastic flanks where the equations have none.
    fn check_flanks(&self) -> Result<(), InputError> {
        let of_equations = self.formulation.refusal(CasePart::ElasticFlanks);
        let of_equations = of_equations.filter(|_| self.flanks.yields());
        let sticks = self.flanks.drags() && self.contact.friction_law.sticks();
        let of_law = sticks.then_some(
            "flanks that slide in two directions and spin need a law with a regularisation speed",
        );
        let Some(why) = of_equations.or(of_law) else {
            return Ok(());
        };
        let rule = format!("\"rigid\": {why}");
        Err(InputError::rule("flanks", f64::NAN, rule))
    }

    /// Passes raceways of Zhao 2022, with the quartic contact path up to their ends.
    ///
    /// # Errors
    /// An [`InputError`] of the form of another, with `why` it cannot be.
    pub(crate) fn check_published_form(&self, why: &str) -> Result<(), InputError> {
        for raceway in &self.raceways {
            let form = raceway.form();
            let quartic = form.shape == RacewayShape::Quartic;
            require("shape", f64::NAN, quartic, format!("\"quartic\": {why}"))?;
            for (field, value) in [("blend_m", raceway.blend_m()), ("depth_m", form.depth_m)] {
                require(field, value, value <= 0.0, format!("0: {why}"))?;
            }
        }
        Ok(())
    }

    /// Checks the rotor and what a case with one must and must not have.
    fn check_rotor(&self) -> Result<(), InputError> {
        let Some(rotor) = &self.rotor else {
            let rule = "left out: the outer ring moves on a support only under a falling rotor";
            return self.support.as_ref().map_or(Ok(()), |support| {
                Err(InputError::rule("support_mass_kg", support.mass_kg, rule))
            });
        };
        let Some(bore) = self.bearing.inner_ring_bore() else {
            let rule = "given, and inner_ring_bore_radius_mm: the rotor spins the inner ring up in its bore";
            let field = "inner_ring_polar_inertia_kg_m2";
            return Err(InputError::rule(field, f64::NAN, rule));
        };
        let groove_m = self.bearing.dimensions().inner_groove_bottom_radius_m;
        rotor.check(bore.radius_m, groove_m)?;
        if let Some(support) = &self.support {
            support.check()?;
        }
        for (field, value, table) in self.operation.given() {
            let rule = "left out: the rotor drives and loads the inner ring";
            require(field, value, value == 0.0 && table.is_none(), rule)?;
        }
        if let Some(housing) = &self.housing {
            let rule = "left out: with a rotor the outer ring moves on its support";
            return Err(InputError::rule("mass_kg", housing.mass_kg, rule));
        }
        if let Some(why) = self.formulation.refusal(CasePart::Rotor) {
            let rule = format!("\"physical\": {why}");
            return Err(InputError::rule("formulation", f64::NAN, rule));
        }
        let at_rest = self.start.state == StartState::AtRest;
        let rule = "\"at-rest\": the rotor falls onto a bearing at rest";
        require("start_state", f64::NAN, at_rest, rule)
    }

    /// Passes a case whose inner ring turns at constant speed under a constant load; `what`
    /// needs that.
    ///
    /// # Errors
    /// An [`InputError`] naming the rotor or the table.
    pub fn check_constant_operation(&self, what: &str) -> Result<(), InputError> {
        if let InnerRingDrive::Rotor(_) = self.inner_ring_drive() {
            let why = format!("{what} needs an inner ring at constant speed");
            return Err(InputError::rotor_left_out(why));
        }
        for (field, start, table) in self.operation.given() {
            let rule = format!("one number, not a table over time: {what} needs that");
            require(field, start, table.is_none(), rule)?;
        }
        Ok(())
    }

    /// Passes a case without a rotor; with tables over time a static equilibrium is that of t = 0.
    ///
    /// # Errors
    /// An [`InputError`] naming the rotor.
    pub(crate) fn check_without_rotor(&self) -> Result<(), InputError> {
        match self.rotor {
            Some(_) => {
                let why = "a bearing under a falling rotor has no static equilibrium";
                Err(InputError::rotor_left_out(why))
            }
            None => Ok(()),
        }
    }

    fn check_start(&self) -> Result<(), InputError> {
        let start = &self.start;
        from_to(
            "lead_ball_angle_rad",
            start.lead_ball_angle_rad,
            -TAU..=TAU,
            "",
        )?;
        if let StartState::Rolling { ring_x_m, ring_y_m } = start.state {
            // A ball pressed in by a tenth of its radius is far past any elastic contact.
            let most = 0.5 * self.bearing.radial_internal_clearance_m()
                + 0.1 * self.bearing.ball_radius_m();
            for (field, value) in [("ring_x_m", ring_x_m), ("ring_y_m", ring_y_m)] {
                let rule = format!("within ±{most:e} of the centre");
                require(field, value, value.abs() <= most, rule)?;
            }
        }
        if let Gaps::List(gaps) = &start.gaps {
            let n = self.bearing.balls();
            let rule = format!("a list of {n} gaps, one per ball");
            require("gaps", gaps.len() as f64, gaps.len() == n, rule)?;
            for &gap in gaps {
                let rule = "0 or more each: balls cannot overlap";
                require("gaps", gap, gap >= 0.0, rule)?;
            }
            let sum: f64 = gaps.iter().sum();
            let room = n as f64 * self.bearing.mean_gap_rad();
            // A list printed with four decimals of a degree passes, and one for nominal
            // balls: the last gap takes what is left.
            let nominal = n as f64 * self.bearing.nominal_gap_rad();
            let slack = n as f64 * 1e-4_f64.to_radians() + (room - nominal).abs();
            let rule = format!("gaps that add up to 2π − N ε = {room}");
            require("gaps", sum, (sum - room).abs() <= slack, rule)?;
        }
        Ok(())
    }
}
