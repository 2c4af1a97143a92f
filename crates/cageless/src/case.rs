//! A case: everything that one computation needs, in SI units.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! let case = common::structure(5.1, 25.2); // Zhao 2022, Table 2, structure (d)
//! assert_eq!(case.bearing.balls(), 14);
//! assert!(case.check().is_ok());
//! // Balls orbit at somewhat less than half the speed of the inner ring.
//! let ratio = case.rolling_orbit_speed_rad_s() / case.operation.inner_speed_rad_s;
//! assert!(0.35 < ratio && ratio < 0.45);
//! ```

use std::f64::consts::TAU;

use crate::bearing::Bearing;
use crate::contact::hertz::DEFLECTION_FRACTION_MAX;
use crate::error::{Allowed, InputError, not_negative, positive};
use crate::kinematics::rolling_orbit_speed_rad_s;
use crate::raceway::Raceway;

/// Set of equations that is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Profile {
    /// As published: centrifugal force added in Zhao 2022, Eq. (12), spin of
    /// Eq. (13) taken relative to the frame that turns with the ball's orbit,
    /// friction on the discrete raceway along the contact path.
    Paper,
    /// Consistent mechanics: inertial frame, absolute spin, friction along the
    /// sliding velocity.
    Physical,
}

/// Friction against sliding speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrictionLaw {
    /// μ·tanh(ΔV/scale)·N.
    Smooth,
    /// μ·sign(ΔV)·N while sliding, whatever holds within the cone while rolling: exact in
    /// `symplectic`; relaxed over a few steps in the explicit methods, whose results are of
    /// order one in `step_s`.
    Coulomb,
    /// (μ + (μs − μ)·exp(−|ΔV|/v))·tanh(ΔV/scale)·N: friction that drops from static to
    /// sliding, as dry pairs do.
    Stribeck,
}

/// Loads and speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Operation {
    /// ωi, counter-clockwise.
    pub inner_speed_rad_s: f64,
    /// Fr, along −Y.
    pub radial_load_n: f64,
    /// g, along −Y.
    pub gravity_m_s2: f64,
}

/// Contact and friction parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// μ.
    pub friction_coefficient: f64,
    /// Law of friction.
    pub friction_law: FrictionLaw,
    /// μs of the Stribeck law, at least μ; of no other law.
    pub static_friction_coefficient: Option<f64>,
    /// v of the Stribeck law, m/s; of no other law.
    pub stribeck_speed_m_s: Option<f64>,
    /// ΔV at the knee of the smooth and Stribeck laws.
    pub slip_scale_m_s: f64,
    /// c of the raceway contacts, F = K δ^(3/2) + c √δ dδ/dt, N·s·m^(−3/2).
    pub damping_n_s_m1_5: f64,
    /// Coefficient of restitution between balls, above 0, at most 1.
    pub ball_restitution: f64,
    /// K at the inner raceway, N·m^(−3/2); from Hertz if `None`.
    pub inner_stiffness_n_m1_5: Option<f64>,
    /// K at the outer raceway, N·m^(−3/2); from Hertz if `None`.
    pub outer_stiffness_n_m1_5: Option<f64>,
    /// K between balls, N·m^(−3/2); from Hertz if `None`.
    pub ball_stiffness_n_m1_5: Option<f64>,
}

/// Gaps between neighbouring balls at the start.
#[derive(Debug, Clone, PartialEq)]
pub enum Gaps {
    /// 2π/N − ε everywhere.
    Uniform,
    /// N gaps; gap k lies between ball k and ball k+1 (the last: ball N and ball 1).
    List(Vec<f64>),
}

/// Initial state.
#[derive(Debug, Clone, PartialEq)]
pub enum Start {
    /// Static equilibrium at speed, balls rolling.
    Settled {
        /// Gaps at the start.
        gaps: Gaps,
        /// ψ of ball 1.
        lead_ball_angle_rad: f64,
    },
    /// Every ball on Rm in pure rolling, the ring at rest where it is put.
    Rolling {
        /// Gaps at the start.
        gaps: Gaps,
        /// ψ of ball 1.
        lead_ball_angle_rad: f64,
        /// Centre of the inner ring.
        ring_x_m: f64,
        /// Centre of the inner ring.
        ring_y_m: f64,
    },
}

impl Start {
    /// Gaps at the start.
    pub fn gaps(&self) -> &Gaps {
        match self {
            Self::Settled { gaps, .. } | Self::Rolling { gaps, .. } => gaps,
        }
    }

    /// ψ of ball 1.
    pub fn lead_ball_angle_rad(&self) -> f64 {
        match *self {
            Self::Settled {
                lead_ball_angle_rad,
                ..
            }
            | Self::Rolling {
                lead_ball_angle_rad,
                ..
            } => lead_ball_angle_rad,
        }
    }
}

/// Integration method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Fourth-order Adams–Bashforth–Moulton, predict–evaluate–correct–evaluate.
    Abm4,
    /// Velocity Verlet (leapfrog): one evaluation per step, no artificial damping,
    /// unbiased statistics.
    Symplectic,
    /// Order 8(5,3) with error control, for references.
    Adaptive,
}

/// Method and step of the integration.
#[derive(Debug, Clone, PartialEq)]
pub struct Solver {
    /// Method.
    pub method: Method,
    /// Step; the largest one of the adaptive method.
    pub step_s: f64,
    /// Error per step of the adaptive method, in the scales 10 µm, 1 m/s, 200 rad/s (ring
    /// 0.1 m/s).
    pub tolerance: f64,
    /// Simulated time.
    pub duration_s: f64,
}

/// Housing that carries the outer ring: one mass on a spring and a damper in
/// each direction. It turns the reaction on the outer ring into an acceleration;
/// the ring itself stays fixed in the equations of motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Housing {
    /// Mass of housing and outer ring.
    pub mass_kg: f64,
    /// Stiffness of the support.
    pub stiffness_n_m: f64,
    /// Damping of the support.
    pub damping_n_s_m: f64,
}

/// Observations of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Time between rows.
    pub interval_s: f64,
}

/// One computation, complete.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Free text.
    pub title: String,
    /// Rings and balls.
    pub bearing: Bearing,
    /// Discrete raceways; none for a conventional outer ring.
    pub raceways: Vec<Raceway>,
    /// Loads and speed.
    pub operation: Operation,
    /// Contact and friction.
    pub contact: Contact,
    /// Equations.
    pub profile: Profile,
    /// Initial state.
    pub start: Start,
    /// Integration.
    pub solver: Solver,
    /// Seed of whatever is random.
    pub seed: u64,
    /// Housing for the vibration of the outer ring.
    pub housing: Option<Housing>,
    /// Output.
    pub output: Output,
}

impl Contact {
    /// Largest coefficient of friction of the law.
    pub fn friction_coefficient_max(&self) -> f64 {
        self.static_friction_coefficient
            .map_or(self.friction_coefficient, |s| {
                s.max(self.friction_coefficient)
            })
    }

    fn check_stribeck(&self) -> Result<(), InputError> {
        let given = [
            (
                "static_friction_coefficient",
                self.static_friction_coefficient,
            ),
            ("stribeck_speed_m_s", self.stribeck_speed_m_s),
        ];
        for (field, value) in given {
            match (self.friction_law, value) {
                (FrictionLaw::Stribeck, None) => {
                    let rule = "given: the Stribeck law needs it";
                    return Err(InputError::rule(field, f64::NAN, rule));
                }
                (FrictionLaw::Stribeck, Some(value)) => positive(field, value)?,
                (_, Some(value)) => {
                    let rule = "left out: only the Stribeck law has it";
                    return Err(InputError::rule(field, value, rule));
                }
                (_, None) => {}
            }
        }
        if self.friction_coefficient_max() > self.static_friction_coefficient.unwrap_or(f64::MAX) {
            return Err(InputError::new(
                "static_friction_coefficient",
                self.static_friction_coefficient.unwrap_or_default(),
                Allowed::AtLeast(self.friction_coefficient, "friction drops once balls slide"),
            ));
        }
        Ok(())
    }
}

/// Longest run that is accepted, in steps.
pub const STEPS_MAX: f64 = 1e12;

/// Shortest time between rows.
pub const INTERVAL_MIN_S: f64 = 1e-9;

impl Case {
    /// Checks everything that [`Bearing::new`] and [`Raceway::new`] have not.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be.
    pub fn check(&self) -> Result<(), InputError> {
        let Operation {
            inner_speed_rad_s,
            radial_load_n,
            gravity_m_s2,
        } = self.operation;
        positive("inner_speed_rad_s", inner_speed_rad_s)?;
        not_negative("radial_load_n", radial_load_n)?;
        not_negative("gravity_m_s2", gravity_m_s2)?;
        let c = &self.contact;
        not_negative("friction_coefficient", c.friction_coefficient)?;
        positive("slip_scale_m_s", c.slip_scale_m_s)?;
        c.check_stribeck()?;
        not_negative("damping_n_s_m1_5", c.damping_n_s_m1_5)?;
        if !(c.ball_restitution > 0.0 && c.ball_restitution <= 1.0) {
            return Err(InputError::rule(
                "ball_restitution",
                c.ball_restitution,
                "more than 0 and at most 1",
            ));
        }
        for (field, stiffness) in [
            ("inner_stiffness_n_m1_5", c.inner_stiffness_n_m1_5),
            ("outer_stiffness_n_m1_5", c.outer_stiffness_n_m1_5),
            ("ball_stiffness_n_m1_5", c.ball_stiffness_n_m1_5),
        ] {
            if let Some(value) = stiffness {
                positive(field, value)?;
            }
        }
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
        let limits = crate::step_limits::StepLimits::new(self);
        if self.solver.step_s > limits.largest_s(self.solver.method) {
            return Err(InputError::new(
                "step_s",
                self.solver.step_s,
                Allowed::AtMost(
                    limits.largest_s(self.solver.method),
                    "the method is unstable beyond it for the stiffest contact of this case",
                ),
            ));
        }
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
        if self.output.interval_s < INTERVAL_MIN_S {
            return Err(InputError::new(
                "interval_s",
                self.output.interval_s,
                Allowed::AtLeast(INTERVAL_MIN_S, "nothing moves in less"),
            ));
        }
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
        let Operation {
            inner_speed_rad_s,
            radial_load_n,
            gravity_m_s2,
        } = self.operation;
        let mass = bearing.ball_mass_kg();
        let centrifugal = self.centrifugal_force_n();
        let elastic = "an elastic contact bears a deflection of 5 % of the ball radius";
        if !(centrifugal <= bears) {
            let most = inner_speed_rad_s * (bears / centrifugal).sqrt();
            return Err(InputError::new(
                "inner_speed_rad_s",
                inner_speed_rad_s,
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
            let most = self.bearing.radial_clearance_m() + 0.1 * self.bearing.ball_radius_m();
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

    /// Orbital speed of a nominal ball that rolls on the plain raceway, rad/s.
    pub fn rolling_orbit_speed_rad_s(&self) -> f64 {
        let bearing = &self.bearing;
        rolling_orbit_speed_rad_s(
            bearing,
            self.operation.inner_speed_rad_s,
            bearing.ball_radius_m(),
        )
    }

    /// Time of one orbit of such a ball, s.
    pub fn rolling_orbit_s(&self) -> f64 {
        TAU / self.rolling_orbit_speed_rad_s()
    }

    /// Centrifugal force on such a ball, N.
    pub(crate) fn centrifugal_force_n(&self) -> f64 {
        let bearing = &self.bearing;
        let speed = self.rolling_orbit_speed_rad_s() * bearing.pitch_radius_m();
        bearing.ball_mass_kg() * speed.powi(2) / bearing.pitch_radius_m()
    }

    /// K at the inner raceway, at the outer raceway and between balls, N·m^(−3/2): as
    /// given, else from Hertz.
    pub fn stiffness_n_m1_5(&self) -> [f64; 3] {
        let (c, b) = (&self.contact, &self.bearing);
        [
            c.inner_stiffness_n_m1_5
                .unwrap_or(b.inner_contact().stiffness_n_m1_5),
            c.outer_stiffness_n_m1_5
                .unwrap_or(b.outer_contact().stiffness_n_m1_5),
            c.ball_stiffness_n_m1_5
                .unwrap_or(b.ball_contact().stiffness_n_m1_5),
        ]
    }

    /// K of ball `k` at the inner raceway, at the outer raceway and against the ball ahead,
    /// N·m^(−3/2): as given, else from Hertz with the radii of these balls.
    pub fn ball_stiffness_n_m1_5(&self, k: usize) -> [f64; 3] {
        let c = &self.contact;
        let [inner, outer, ball] = self.bearing.ball_stiffness_n_m1_5(k);
        [
            c.inner_stiffness_n_m1_5.unwrap_or(inner),
            c.outer_stiffness_n_m1_5.unwrap_or(outer),
            c.ball_stiffness_n_m1_5.unwrap_or(ball),
        ]
    }

    /// Whether every ball sits in the outer ring where a nominal one does in a raceway as
    /// designed.
    pub fn has_nominal_geometry(&self) -> bool {
        self.bearing.ball_radius_deviations_m().is_empty()
            && self.raceways.iter().all(|r| r.depth_error_m() == 0.0)
    }

    /// Case with other raceways.
    pub fn with_raceways(&self, raceways: Vec<Raceway>) -> Self {
        Self {
            raceways,
            ..self.clone()
        }
    }
}
