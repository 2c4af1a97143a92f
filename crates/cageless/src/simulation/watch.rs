//! Guard and position angles of one bearing on its way through a run.

use std::cell::RefCell;
use std::sync::Arc;

use super::guard::{Cause, ENERGY_MIN_J, Guard, Stop};
use super::observer::{RunContext, StepView};
use super::outcome::{Ending, RunOutcome};
use crate::case::Case;
use crate::dynamics::coordinates::BallCoordinate;
use crate::dynamics::energy::EnergyBalance;
use crate::dynamics::layout::Layout;
use crate::dynamics::state::State;
use crate::dynamics::{Contacts, InstructionSet, Model, RightHandSide};
use crate::integrator::StepState;
use crate::numerics::angle::unwrap_angle_rad;

/// ψ is brought up to date when a rolling ball has gone this far: well below the half turn
/// beyond which it would be lost, even for a ball that is thrown.
const RECENT_RAD: f64 = 0.3;

/// Speed of balls that nothing drives and something pushes: a rolling one would not move.
const SLOW_ORBIT_RAD_S: f64 = 100.0;

/// Flows of less than this fraction of the energy at the start are rounding: nothing flows.
const ROUNDING_FRACTION: f64 = 1e-6;

/// Guard and position angles of one bearing, alone or among others.
pub(super) struct Watch {
    model: Arc<Model>,
    /// Index of the bearing among those that are advanced together.
    bearing: usize,
    /// Places of the bearing in the vectors of the steps.
    layout: Layout,
    guard: Guard,
    interpolator: RefCell<RightHandSide>,
    recent_angle: Vec<f64>,
    recent_s: f64,
    recent_for_s: f64,
    end_s: f64,
    steps: u64,
    longest_s: f64,
}

impl Watch {
    /// The watch of the bearing with these places, numbered among those that are advanced together.
    pub(super) fn new(context: &RunContext<'_>, layout: Layout, bearing: usize) -> Self {
        let RunContext { case, model, .. } = context;
        let mut watch = Self {
            model: Arc::clone(model),
            bearing,
            layout,
            guard: Guard::new(model, layout, case, context.start),
            interpolator: RefCell::new(RightHandSide::new(model)),
            recent_angle: context.start_angle_rad.to_vec(),
            recent_s: 0.0,
            recent_for_s: f64::INFINITY,
            end_s: 0.0,
            steps: 0,
            longest_s: 0.0,
        };
        watch.look_as_often_as(case);
        watch
    }

    /// Brings position angles up to date at least as often as the speed of a case asks for; balls coast on when it
    /// falls.
    pub(super) fn look_as_often_as(&mut self, case: &Case) {
        let rolling = case.rolling_orbit_speed_rad_s();
        let orbit = if case.has_constant_operation() {
            rolling
        } else {
            rolling.max(SLOW_ORBIT_RAD_S)
        };
        self.recent_for_s = self.recent_for_s.min(RECENT_RAD / orbit);
    }

    /// Right-hand side of snapshots within a step.
    pub(super) fn interpolator(&mut self) -> &mut RightHandSide {
        self.interpolator.get_mut()
    }

    /// Looks at a step, at whose end a bearing has these contacts; `thorough` where it is the last.
    ///
    /// # Errors
    /// The state has left the physical range.
    pub(super) fn look<'c>(
        &mut self,
        case: &Case,
        step: &StepState,
        contacts_of: &impl Fn(usize) -> Contacts<'c>,
        thorough: bool,
    ) -> Result<(), Stop> {
        (self.end_s, self.steps) = (step.t1_s, self.steps + 1);
        self.longest_s = self.longest_s.max(step.size_s());
        if thorough || Guard::is_due(self.steps) {
            let contacts = contacts_of(self.bearing);
            let checked = match thorough {
                true => self.guard.look(&contacts, &step.y1),
                false => self.guard.check(self.steps, &contacts, &step.y1),
            };
            checked.map_err(|cause| self.stop(case, step.t1_s, cause))?;
        }
        if step.t1_s - self.recent_s > self.recent_for_s {
            self.update_angles(step);
        }
        Ok(())
    }

    /// Stop for this cause; its step is at most the longest that was made, as a method of one's own has its own.
    pub(super) fn stop(&self, case: &Case, time_s: f64, cause: Cause) -> Stop {
        let mut stop = Stop::new(case, time_s, cause);
        if self.longest_s > 0.0 {
            stop.step_s = stop.step_s.min(self.longest_s);
        }
        stop
    }

    /// Stop at a step that could not be made, for what a law of one's own returned if that cannot be.
    pub(super) fn stop_unresolved(&self, case: &Case, time_s: f64) -> Stop {
        let fault = self.model.friction_fault().cloned();
        let cause = fault.map_or(Cause::NotResolved, Cause::from);
        self.stop(case, time_s, cause)
    }

    #[inline(never)] // most steps do without
    fn update_angles(&mut self, step: &StepState) {
        self.recent_angle = self.angles_rad(step);
        self.recent_s = step.t1_s;
    }

    /// View of the step.
    pub(super) fn view<'a>(&'a self, step: &'a StepState, contacts: Contacts<'a>) -> StepView<'a> {
        StepView {
            step,
            contacts,
            model: &self.model,
            interpolator: &self.interpolator,
            recent_angle_rad: &self.recent_angle,
            layout: &self.layout,
        }
    }

    /// Continuous ψ of each ball at the end of a step, rad; as given before the first.
    pub(super) fn angles_rad(&self, step: &StepState) -> Vec<f64> {
        if self.steps == 0 {
            return self.recent_angle.clone();
        }
        let x = self.layout.balls_of(&step.y1, BallCoordinate::X);
        let y = self.layout.balls_of(&step.y1, BallCoordinate::Y);
        let centre = self.layout.outer_ring_motion(&step.y1);
        let recent = self.recent_angle.iter().enumerate();
        let angle = |(k, recent): (usize, &f64)| {
            unwrap_angle_rad((x[k] - centre.x).atan2(-(y[k] - centre.y)), *recent)
        };
        recent.map(angle).collect()
    }

    /// Index of the bearing among those that are advanced together.
    pub(super) fn bearing(&self) -> usize {
        self.bearing
    }

    /// State of the bearing in a vector of all.
    pub(super) fn state_in(&self, values: &[f64]) -> State {
        State::from_vector(self.layout, values)
    }

    /// Outcome of a run that ended so.
    pub(super) fn outcome(&self, ending: Ending, last: State, made: Made) -> RunOutcome {
        let start_energy_j = self.guard.start_energy_j();
        let balance = self.model.energy_balance(start_energy_j, &last);
        RunOutcome {
            ending,
            end_s: self.end_s,
            steps: self.steps,
            rhs_evaluations: made.evaluations,
            end_energy_j: self.model.energy_j(&last),
            state: last,
            start_energy_j,
            energy_residual_relative: residual_relative(&balance),
            rotor_energy_residual_relative: made.rotor_balance.as_ref().map(residual_relative),
            instruction_set: made.instruction_set,
        }
    }
}

/// Residual of an energy ledger over its flows.
fn residual_relative(balance: &EnergyBalance) -> f64 {
    let least = ENERGY_MIN_J.max(ROUNDING_FRACTION * balance.start_j);
    balance.residual_j / balance.flows_j.max(least)
}

/// Work of a world.
#[derive(Debug, Clone, Copy)]
pub(super) struct Made {
    /// Evaluations.
    pub evaluations: u64,
    /// Instructions in use.
    pub instruction_set: InstructionSet,
    /// Energy balance of the rotor, if there is one.
    pub rotor_balance: Option<EnergyBalance>,
}
