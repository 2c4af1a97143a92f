//! Guard against states outside the physical range.

use std::sync::Arc;

use crate::bearing::{Bearing, BeyondGroove};
use crate::case::{Case, InnerRingDrive};
use crate::contact::friction::FrictionFault;
use crate::contact::hertz::DEFLECTION_FRACTION_MAX;
use crate::dynamics::coordinates::SlidingCoordinate;
use crate::dynamics::energy::EnergyBalance;
use crate::dynamics::layout::Layout;
use crate::dynamics::state::State;
use crate::dynamics::{Contacts, Model};
use crate::rotor::Rotor;
use crate::step_limits::StepLimits;

/// Cause for which a run stopped.
#[derive(Debug, Clone, PartialEq)]
pub enum Cause {
    /// NaN or infinity in the state.
    NotFinite,
    /// The inner ring between the balls, its shoulders at those of the outer ring.
    RingsMeet {
        /// Distance of the centres of the two rings.
        displacement_m: f64,
        /// Least number of balls between which the ring cannot fall; `None` if there are as many.
        balls_that_hold: Option<usize>,
    },
    /// A ball (index from 0) pressed into or through the inner ring.
    ThroughInnerRing(usize),
    /// A ball (index from 0) pressed into or through the outer ring.
    ThroughOuterRing(usize),
    /// A ball (index from 0) pressed into or through the ball ahead.
    ThroughBall(usize),
    /// A ball pressed over the shoulder of a ring.
    BeyondGroove {
        /// The ball, from 0, through all rows.
        ball: usize,
        /// The ring: 0 for the inner, 1 for the outer one.
        ring: usize,
        /// Contact angle of the ball.
        angle_rad: f64,
        /// Contact angle at which the groove ends.
        shoulder_rad: f64,
    },
    /// The rotor pressed into or through the inner ring.
    RotorThroughInnerRing,
    /// The outer ring is further off its rest place than the radius of a ball.
    OffSupport,
    /// The outer ring of a row (index from 0) slid further than that along the axis, against its preload
    /// spring or behind it.
    OffSpring(usize),
    /// Spurious energy gain.
    EnergyFromNowhere {
        /// Energy now − energy at the start − net work.
        residual_j: f64,
        /// Sum of the absolute flows.
        flows_j: f64,
    },
    /// Energy balance error at the end of a run.
    Unbalanced {
        /// Energy now − energy at the start − net work, over the sum of the absolute flows.
        residual_fraction: f64,
    },
    /// The error control could not resolve a step.
    NotResolved,
    /// The time asked for is no number, or lies before that of the simulation, s.
    TimeNotAhead(f64),
    /// A method did not make a step that goes on and ends at its limit at the latest.
    NotForward {
        /// End of the step, s.
        end_s: f64,
        /// Limit of the end of the step, s.
        limit_s: f64,
    },
    /// A law of friction of one's own returned what cannot be.
    Friction {
        /// Name of the law.
        law: String,
        /// Sliding speed, m/s.
        sliding_m_s: f64,
        /// μ that the law returned.
        coefficient: f64,
        /// Slope of μ that it returned, s/m.
        slope_s_m: f64,
    },
}

/// Time and cause at which a run stopped.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// Simulated time.
    pub time_s: f64,
    /// Step of the run.
    pub step_s: f64,
    /// Step that the case has where none is given.
    pub automatic_step_s: f64,
    /// Whether it was the drop of a rotor.
    pub drop: bool,
    /// Cause of the stop.
    pub cause: Cause,
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NotFinite => f.write_str("a state is no longer a finite number"),
            Self::RingsMeet { displacement_m, .. } => write!(
                f,
                "the inner ring fell between the balls and met the outer ring, {:.3} mm off its \
                 centre",
                1e3 * displacement_m
            ),
            Self::ThroughInnerRing(k) => write!(f, "ball {} went through the inner ring", k + 1),
            Self::ThroughOuterRing(k) => write!(f, "ball {} went through the outer ring", k + 1),
            Self::ThroughBall(k) => write!(f, "ball {} went through the ball ahead of it", k + 1),
            Self::BeyondGroove {
                ball,
                ring,
                angle_rad,
                shoulder_rad,
            } => {
                let beyond = BeyondGroove {
                    ball: *ball,
                    ring: *ring,
                    angle_rad: *angle_rad,
                    shoulder_rad: *shoulder_rad,
                };
                write!(f, "the forces pressed {beyond}")
            }
            Self::RotorThroughInnerRing => f.write_str("the rotor went through the inner ring"),
            Self::OffSupport => f.write_str("the outer ring left its support"),
            Self::OffSpring(row) => write!(
                f,
                "the outer ring of row {} slid off its seat: the spring alone held it along the axis",
                row + 1
            ),
            Self::EnergyFromNowhere {
                residual_j,
                flows_j,
            } => write!(
                f,
                "{residual_j:.3e} J of energy appeared that nothing supplied ({:.1} % of all flows)",
                100.0 * residual_j.abs() / flows_j
            ),
            Self::Unbalanced { residual_fraction } => write!(
                f,
                "{:.1} % of all energy flows are unaccounted for",
                100.0 * residual_fraction.abs()
            ),
            Self::NotResolved => f.write_str("a step could not be resolved"),
            Self::TimeNotAhead(asked_s) => {
                write!(f, "the time asked for, {asked_s} s, does not lie ahead")
            }
            Self::NotForward { end_s, limit_s } => write!(
                f,
                "the method ended a step at {end_s} s, which is not after its start, or beyond its limit of \
                 {limit_s} s"
            ),
            Self::Friction {
                law,
                sliding_m_s,
                coefficient,
                slope_s_m,
            } => write!(
                f,
                "the law of friction {law} returned μ = {coefficient} with slope {slope_s_m} s/m at a sliding speed \
                 of {sliding_m_s} m/s"
            ),
        }
    }
}

impl From<BeyondGroove> for Cause {
    fn from(beyond: BeyondGroove) -> Self {
        Self::BeyondGroove {
            ball: beyond.ball,
            ring: beyond.ring,
            angle_rad: beyond.angle_rad,
            shoulder_rad: beyond.shoulder_rad,
        }
    }
}

impl From<FrictionFault> for Cause {
    fn from(fault: FrictionFault) -> Self {
        let [coefficient, slope_s_m] = fault.returned;
        Self::Friction {
            law: fault.law,
            sliding_m_s: fault.sliding_m_s,
            coefficient,
            slope_s_m,
        }
    }
}

impl Cause {
    /// Whether the bearing gave way, a result of its physics; else the computation failed.
    pub fn gives_way(&self) -> bool {
        match self {
            Self::RingsMeet { .. }
            | Self::BeyondGroove { .. }
            | Self::OffSupport
            | Self::OffSpring(_) => true,
            Self::NotFinite
            | Self::ThroughInnerRing(_)
            | Self::ThroughOuterRing(_)
            | Self::ThroughBall(_)
            | Self::RotorThroughInnerRing
            | Self::EnergyFromNowhere { .. }
            | Self::Unbalanced { .. }
            | Self::NotResolved
            | Self::TimeNotAhead(_)
            | Self::NotForward { .. }
            | Self::Friction { .. } => false,
        }
    }
}

impl Stop {
    pub(super) fn new(case: &Case, time_s: f64, cause: Cause) -> Self {
        let solver = &case.solver;
        Self {
            time_s,
            step_s: solver.step_s,
            automatic_step_s: StepLimits::new(case).automatic_s(solver.method),
            drop: matches!(case.inner_ring_drive(), InnerRingDrive::Rotor(_)),
            cause,
        }
    }

    /// Time and cause, without the advice.
    pub fn reason(&self) -> String {
        format!("at t = {:.6} s {}", self.time_s, self.cause)
    }
}

/// Steps between two checks of the state.
const LOOK_EVERY: u64 = 8;
/// Steps between two checks of the energy balance.
const BALANCE_EVERY: u64 = 512;
/// Largest tolerated spurious energy gain, as a fraction of the sum of all flows or of the
/// energy at the start, whichever is larger.
const RESIDUAL_MAX: f64 = 0.05;
/// Least energy that a spurious gain is compared with: below it the sums round.
pub(super) const ENERGY_MIN_J: f64 = 1e-12;

/// Guard against states outside the physical range.
pub(super) struct Guard {
    model: Arc<Model>,
    /// Places of the bearing.
    layout: Layout,
    start_energy: f64,
    /// Energy that a spurious gain is compared with: that of the start, without the spin of a
    /// rotor, which hides everything else, but with the fall that awaits it.
    energy_scale: f64,
    /// The shoulders of the rings meet this far off.
    ring_max: f64,
    balls_that_hold: Option<usize>,
    deflection_max: f64,
    /// Sines of the contact angles at the shoulders: inner, outer.
    shoulder_sines: [f64; 2],
    rotor_deflection_max: f64,
    support_max: f64,
    /// Rows whose outer rings slide, from 0.
    sprung_rows: Vec<usize>,
}

impl Guard {
    pub(super) fn new(model: &Arc<Model>, layout: Layout, case: &Case, start: &State) -> Self {
        let bearing = &case.bearing;
        let start_energy = model.energy_j(start);
        let gravity = case.operation.gravity_m_s2;
        let translation = |r: &Rotor| {
            let whirl = r.eccentricity_m * r.speed_rad_s;
            let square = r.vx_m_s.powi(2) + r.vy_m_s.powi(2) + r.vz_m_s.powi(2) + whirl * whirl;
            let fall = r.radial_clearance_m.max(r.axial_clearance_m.unwrap_or(0.0));
            ENERGY_MIN_J + r.mass_kg * (gravity * fall + 0.5 * square)
        };
        let holding =
            Bearing::balls_that_hold_ring(bearing.ball_radius_m(), bearing.pitch_radius_m());
        Self {
            model: Arc::clone(model),
            layout,
            start_energy,
            energy_scale: case.rotor.as_ref().map_or(start_energy, translation),
            ring_max: bearing.shoulder_clearance_m(),
            balls_that_hold: (bearing.balls() < holding).then_some(holding),
            deflection_max: DEFLECTION_FRACTION_MAX * bearing.ball_radius_m(),
            shoulder_sines: bearing.shoulder_angles_rad().map(f64::sin),
            rotor_deflection_max: bearing.inner_ring_bore().map_or(f64::INFINITY, |bore| {
                DEFLECTION_FRACTION_MAX * bore.radius_m
            }),
            support_max: bearing.ball_radius_m(),
            sprung_rows: case.sprung_rows(),
        }
    }

    pub(super) fn start_energy_j(&self) -> f64 {
        self.start_energy
    }

    /// Whether the state after `steps` steps is to be checked.
    #[inline]
    pub(super) fn is_due(steps: u64) -> bool {
        steps.is_multiple_of(LOOK_EVERY)
    }

    /// Checks the state after `steps` steps, with its contacts.
    pub(super) fn check(
        &self,
        steps: u64,
        contacts: &Contacts<'_>,
        values: &[f64],
    ) -> Result<(), Cause> {
        self.look(contacts, values)?;
        match steps.is_multiple_of(BALANCE_EVERY) {
            true => self.balance(values),
            false => Ok(()),
        }
    }

    /// Checks a state with its contacts.
    pub(super) fn look(&self, contacts: &Contacts<'_>, values: &[f64]) -> Result<(), Cause> {
        let layout = self.layout;
        if let Some(fault) = self.model.friction_fault() {
            return Err(fault.clone().into());
        }
        if !layout.is_finite(values) {
            return Err(Cause::NotFinite);
        }
        let (inner, outer) = (layout.ring_motion(values), layout.outer_ring_motion(values));
        let [x, y] = [inner.x - outer.x, inner.y - outer.y];
        // Through the outer ring, between one look and the next.
        if x * x + y * y > self.model.bearing().pitch_radius_m().powi(2) {
            return Err(Cause::NotResolved);
        }
        if x * x + y * y > self.ring_max * self.ring_max {
            return Err(Cause::RingsMeet {
                displacement_m: x.hypot(y),
                balls_that_hold: self.balls_that_hold,
            });
        }
        for (ring, row) in self.sprung_rows.iter().enumerate() {
            let z = values[layout.sliding(SlidingCoordinate::Z, ring)];
            if z.abs() > self.support_max {
                return Err(Cause::OffSpring(*row));
            }
        }
        if let Some(k) = contacts.deeper(self.deflection_max) {
            return Err(if contacts.outer_deflection_m(k) > self.deflection_max {
                Cause::ThroughOuterRing(k)
            } else if contacts.inner_deflection_m(k) > self.deflection_max {
                Cause::ThroughInnerRing(k)
            } else {
                Cause::ThroughBall(k)
            });
        }
        self.on_grooves(contacts)?;
        if let Some(rotor) = contacts.rotor() {
            let face = contacts.face().map_or(0.0, |face| face.deflection);
            if rotor.contact.deflection.max(face) > self.rotor_deflection_max {
                return Err(Cause::RotorThroughInnerRing);
            }
            let z = layout.outer_ring_along_axis(values).z;
            if outer.x.hypot(outer.y).hypot(z) > self.support_max {
                return Err(Cause::OffSupport);
            }
        }
        Ok(())
    }

    /// Looks for a ball that bears beyond a shoulder.
    fn on_grooves(&self, contacts: &Contacts<'_>) -> Result<(), Cause> {
        for (k, ball) in contacts.balls_in_space() {
            for (ring, point) in ball.bearing_points() {
                let [cosine, sine] = point.normal;
                if sine.abs() > self.shoulder_sines[ring] {
                    let angle = sine.atan2(cosine);
                    if let Some(beyond) = self.model.bearing().beyond_groove(k, ring, angle) {
                        return Err(beyond.into());
                    }
                }
            }
        }
        Ok(())
    }

    fn balance(&self, values: &[f64]) -> Result<(), Cause> {
        let state = State::from_vector(self.layout, values);
        let EnergyBalance {
            residual_j,
            flows_j,
            ..
        } = self.model.energy_balance(self.start_energy, &state);
        if residual_j > RESIDUAL_MAX * flows_j.max(self.energy_scale) {
            return Err(Cause::EnergyFromNowhere {
                residual_j,
                flows_j,
            });
        }
        Ok(())
    }
}
