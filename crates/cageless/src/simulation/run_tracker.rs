//! One bearing on its way through a run.

use std::cell::RefCell;

use super::guard::{ENERGY_MIN_J, Guard, Stop};
use super::observer::{Observer, RunContext, StepView};
use super::outcome::{Ending, RunOutcome};
use crate::control::Control;
use crate::dynamics::coordinates::BallCoordinate;
use crate::dynamics::layout::Layout;
use crate::dynamics::state::State;
use crate::dynamics::{Contacts, InstructionSet, RightHandSide};
use crate::integrator::StepState;
use crate::numerics::angle::unwrap_angle_rad;

/// ψ is brought up to date when a rolling ball has gone this far: well below the half turn
/// beyond which it would be lost, even for a ball that is thrown.
const RECENT_RAD: f64 = 0.3;

/// Speed of balls that nothing drives and something pushes: a rolling one would not move.
const SLOW_ORBIT_RAD_S: f64 = 100.0;

/// Flows of less than this fraction of the energy at the start are rounding: nothing flows.
const ROUNDING_FRACTION: f64 = 1e-6;

/// Tracks one bearing through the steps of a run, alone or in a batch.
pub(super) struct RunTracker<'s, 'm, 'o> {
    pub context: RunContext<'m>,
    /// Index of the bearing among those that are advanced together.
    bearing: usize,
    /// Places of the bearing in the vectors of the steps.
    layout: Layout,
    guard: Guard<'m>,
    interpolator: RefCell<RightHandSide<'m>>,
    observers: &'o mut [&'s mut dyn Observer],
    recent_angle: Vec<f64>,
    recent_s: f64,
    recent_for_s: f64,
    ending: Option<Ending>,
    end_s: f64,
    steps: u64,
    last: State,
    pub rhs_evaluations: u64,
    pub instruction_set: InstructionSet,
}

impl<'s, 'm, 'o> RunTracker<'s, 'm, 'o> {
    pub fn new(
        context: RunContext<'m>,
        layout: Layout,
        observers: &'o mut [&'s mut dyn Observer],
    ) -> Self {
        let RunContext {
            case, model, start, ..
        } = context;
        let mut ending = None;
        for observer in observers.iter_mut() {
            if let Err(error) = observer.begin(&context) {
                ending = Some(Ending::ObserverFailed(error));
            }
        }
        let rolling = case.rolling_orbit_speed_rad_s();
        let orbit = if case.has_constant_operation() {
            rolling
        } else {
            rolling.max(SLOW_ORBIT_RAD_S)
        };
        Self {
            context,
            bearing: layout.bearing(),
            layout,
            guard: Guard::new(model, layout, case, start),
            interpolator: RefCell::new(RightHandSide::new(model)),
            observers,
            recent_angle: context.start_angle_rad.to_vec(),
            recent_s: 0.0,
            recent_for_s: RECENT_RAD / orbit,
            ending,
            end_s: 0.0,
            steps: 0,
            last: start.clone(),
            rhs_evaluations: 0,
            instruction_set: InstructionSet::Baseline,
        }
    }

    /// Sets the index of the bearing among those that are advanced together.
    pub fn numbered(self, bearing: usize) -> Self {
        Self { bearing, ..self }
    }

    /// Whether the run of the bearing has not ended.
    pub fn under_way(&self) -> bool {
        self.ending.is_none()
    }

    /// Ends here, unless it has already, at the state in `values`.
    pub fn end(&mut self, ending: Ending, values: &[f64]) {
        if self.under_way() {
            self.last = State::from_vector(self.layout, values);
            self.ending = Some(ending);
        }
    }

    /// Looks at a step, at whose end a bearing has these contacts, shows it to the observers, and ends at
    /// `duration_s`.
    pub fn follow<'c>(
        &mut self,
        step: &StepState,
        contacts_of: impl Fn(usize) -> Contacts<'c>,
        steps: u64,
        duration_s: f64,
    ) {
        (self.end_s, self.steps) = (step.t1_s, steps);
        let at_end = step.t1_s >= duration_s;
        if at_end || Guard::is_due(steps) {
            let contacts = contacts_of(self.bearing);
            let checked = match at_end {
                true => self.guard.look(&contacts, &step.y1),
                false => self.guard.check(steps, &contacts, &step.y1),
            };
            if let Err(cause) = checked {
                let stop = Stop::new(self.context.case, step.t1_s, cause);
                self.end(Ending::Stopped(stop), &step.y1);
                return;
            }
        }
        if step.t1_s - self.recent_s > self.recent_for_s {
            self.update_angles(step);
        }
        let view = StepView {
            step,
            contacts: contacts_of(self.bearing),
            interpolator: &self.interpolator,
            recent_angle_rad: &self.recent_angle,
            layout: &self.layout,
        };
        let mut ending = at_end.then_some(Ending::Complete);
        for observer in self.observers.iter_mut() {
            match observer.step(&view) {
                Ok(Control::Continue(())) => {}
                Ok(Control::Break(())) => ending = Some(Ending::Interrupted),
                Err(error) => {
                    ending = Some(Ending::ObserverFailed(error));
                    break;
                }
            }
        }
        if let Some(ending) = ending {
            self.end(ending, &step.y1);
        }
    }

    #[inline(never)] // most steps do without
    fn update_angles(&mut self, step: &StepState) {
        let x = self.layout.balls_of(&step.y1, BallCoordinate::X);
        let y = self.layout.balls_of(&step.y1, BallCoordinate::Y);
        let centre = self.layout.outer_ring_motion(&step.y1);
        for (k, recent) in self.recent_angle.iter_mut().enumerate() {
            *recent = unwrap_angle_rad((x[k] - centre.x).atan2(-(y[k] - centre.y)), *recent);
        }
        self.recent_s = step.t1_s;
    }

    /// Outcome of a whole run.
    pub fn whole_outcome(self) -> RunOutcome {
        let case = self.context.case;
        self.outcome().of_whole_run(case)
    }

    /// Outcome of the run.
    pub fn outcome(self) -> RunOutcome {
        let model = self.context.model;
        let (residual, flows) = model.energy_residual_j(self.guard.start_energy_j(), &self.last);
        let least = ENERGY_MIN_J.max(ROUNDING_FRACTION * self.guard.start_energy_j());
        let turned_over = flows.max(least);
        RunOutcome {
            ending: self.ending.unwrap_or(Ending::Interrupted),
            end_s: self.end_s,
            steps: self.steps,
            rhs_evaluations: self.rhs_evaluations,
            end_energy_j: model.energy_j(&self.last),
            state: self.last,
            start_energy_j: self.guard.start_energy_j(),
            energy_residual_relative: residual / turned_over,
            instruction_set: self.instruction_set,
        }
    }
}
