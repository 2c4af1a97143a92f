//! The loop over the steps.

use std::cell::RefCell;
use std::f64::consts::TAU;

use super::guard::{Cause, Guard, Stop};
use super::observer::{Observer, Scene, View};
use crate::case::{Case, Method};
use crate::dynamics::{InstructionSet, Model, RightHandSide};
use crate::equilibrium::EquilibriumError;
use crate::error::InputError;
use crate::integrator::{Abm4, Adaptive, Integrator, Step, Symplectic};
use crate::start::initial_state;
use crate::state::State;

/// How a run ended.
#[derive(Debug)]
pub enum Ending {
    /// At its full duration.
    Complete,
    /// At the wish of the caller.
    Interrupted,
    /// Because it had left the physical range.
    Stopped(Stop),
    /// Because an observer failed.
    ObserverFailed(super::ObserverError),
}

/// What a run came to.
#[derive(Debug)]
pub struct RunOutcome {
    /// How it ended.
    pub ending: Ending,
    /// Simulated time reached.
    pub end_s: f64,
    /// Steps made.
    pub steps: u64,
    /// Evaluations of the right-hand side.
    pub rhs_evaluations: u64,
    /// Last state, with the energy ledger.
    pub state: State,
    /// Kinetic and elastic energy at the start.
    pub start_energy_j: f64,
    /// Kinetic and elastic energy at the end.
    pub end_energy_j: f64,
    /// Energy now − energy at the start − net work, over the sum of absolute flows.
    pub energy_residual_relative: f64,
    /// Instructions used.
    pub instruction_set: InstructionSet,
}

/// What the caller wants of a run in progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// Go on.
    Continue,
    /// End here.
    Interrupt,
}

/// The caller is asked this often, steps.
const ASK_EVERY: u64 = 1024;

/// Runs a case. `control` is called every thousand steps or so with the simulated time.
///
/// # Errors
/// The case is impossible or its start has no equilibrium. Everything later is an
/// [`Ending`].
pub fn run(
    case: &Case,
    observers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<RunOutcome, EquilibriumError> {
    let (state, angles) = initial_state(case)?;
    Ok(run_from(case, &state, &angles, observers, control)?)
}

/// Runs a case from a given state and ψ of its balls.
///
/// # Errors
/// The case is impossible.
pub fn run_from(
    case: &Case,
    start: &State,
    start_angle_rad: &[f64],
    observers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<RunOutcome, InputError> {
    let model = Model::new(case)?;
    let (size, h) = (model.layout().len(), case.solver.step_s);
    let problem = Problem {
        case,
        model: &model,
        start,
        start_angle_rad,
    };
    Ok(match case.solver.method {
        Method::Abm4 => problem.run(Abm4::new(size, h), observers, control),
        Method::Symplectic => problem.run(Symplectic::new(size, h), observers, control),
        Method::Adaptive => {
            let method = Adaptive::new(size, h, case.solver.tolerance);
            problem.run(method, observers, control)
        }
    })
}

/// What is to be integrated, from where.
struct Problem<'a> {
    case: &'a Case,
    model: &'a Model,
    start: &'a State,
    start_angle_rad: &'a [f64],
}

impl Problem<'_> {
    fn run(
        &self,
        mut method: impl Integrator,
        observers: &mut [&mut dyn Observer],
        control: &mut dyn FnMut(f64) -> Control,
    ) -> RunOutcome {
        let Self {
            case,
            model,
            start,
            start_angle_rad,
        } = *self;
        let mut rhs = RightHandSide::new(model);
        let probe = RefCell::new(RightHandSide::new(model));
        let guard = Guard::new(
            model,
            start,
            case.bearing.ball_radius_m(),
            case.bearing.radial_clearance_m(),
        );
        method.restart(&mut rhs, 0.0, start.values());
        let mut turns: Vec<i64> = (0..model.balls())
            .map(|k| {
                let wrapped = start.x_m()[k].atan2(-start.y_m()[k]);
                ((start_angle_rad[k] - wrapped) / TAU).round() as i64
            })
            .collect();

        let scene = Scene {
            case,
            model,
            start,
            start_angle_rad,
        };
        let mut ending = Ending::Complete;
        for observer in observers.iter_mut() {
            if let Err(error) = observer.begin(&scene) {
                ending = Ending::ObserverFailed(error);
            }
        }
        let duration = case.solver.duration_s;
        let mut steps = 0;
        let mut end_s = 0.0;
        let mut last = start.values().to_vec();
        while end_s < duration && matches!(ending, Ending::Complete) {
            if let Err(error) = method.advance(&mut rhs, duration) {
                ending = Ending::Stopped(Stop {
                    time_s: error.time_s,
                    cause: Cause::NotResolved,
                });
                break;
            }
            steps += 1;
            let step = method.step();
            end_s = step.to_s;
            let checked = if end_s < duration {
                guard.check(steps, &rhs, step.after)
            } else {
                guard.look(&rhs, step.after)
            };
            if let Err(cause) = checked {
                ending = Ending::Stopped(Stop {
                    time_s: end_s,
                    cause,
                });
                break;
            }
            ending = show(&step, &rhs, &probe, &mut turns, observers);
            if matches!(ending, Ending::Complete)
                && steps.is_multiple_of(ASK_EVERY)
                && control(end_s) == Control::Interrupt
            {
                ending = Ending::Interrupted;
            }
        }
        if steps > 0 {
            last.copy_from_slice(method.step().after);
        }
        let state = State::from_values(model.layout(), last);
        let (residual, flows) = model.energy_residual_j(guard.start_energy_j(), &state);
        RunOutcome {
            ending,
            end_s,
            steps,
            rhs_evaluations: rhs.evaluations(),
            end_energy_j: model.energy_j(&state),
            state,
            start_energy_j: guard.start_energy_j(),
            energy_residual_relative: if flows > 0.0 { residual / flows } else { 0.0 },
            instruction_set: rhs.instruction_set(),
        }
    }
}

/// Counts turns and lets the observers see the step.
fn show<'m>(
    step: &Step<'_>,
    rhs: &RightHandSide<'m>,
    probe: &RefCell<RightHandSide<'m>>,
    turns: &mut [i64],
    observers: &mut [&mut dyn Observer],
) -> Ending {
    let layout = rhs.model().layout();
    for (k, turn) in turns.iter_mut().enumerate() {
        let (x0, x1) = (
            step.before[layout.group(0) + k],
            step.after[layout.group(0) + k],
        );
        // At the top, where atan2(x, −y) jumps from π to −π.
        if step.after[layout.group(1) + k] > 0.0 {
            if x0 >= 0.0 && x1 < 0.0 {
                *turn += 1;
            } else if x0 < 0.0 && x1 >= 0.0 {
                *turn -= 1;
            }
        }
    }
    let view = View {
        step: *step,
        rhs,
        probe,
        turns,
    };
    let mut ending = Ending::Complete;
    for observer in observers.iter_mut() {
        match observer.step(&view) {
            Ok(Control::Continue) => {}
            Ok(Control::Interrupt) => ending = Ending::Interrupted,
            Err(error) => return Ending::ObserverFailed(error),
        }
    }
    ending
}
