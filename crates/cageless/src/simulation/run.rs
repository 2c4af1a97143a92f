//! The loop over the steps.

use std::cell::RefCell;
use std::f64::consts::TAU;

use super::guard::{Cause, Guard, Stop};
use super::observer::{Observer, Scene, View};
use crate::case::Case;
use crate::dynamics::{InstructionSet, Model, RightHandSide};
use crate::equilibrium::EquilibriumError;
use crate::error::InputError;
use crate::integrator::{Abm4, Integrator, RungeKutta, Step, System};
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
    let mut rhs = RightHandSide::new(&model);
    let bearing = &case.bearing;
    let guard = Guard::new(
        &model,
        start,
        bearing.ball_radius_m(),
        bearing.radial_clearance_m(),
    );
    let h = case.solver.step_s;
    let mut method = Abm4::new(model.layout().len(), h);
    method.restart(&mut rhs, 0.0, start.values());
    let mut turns: Vec<i64> = (0..model.balls())
        .map(|k| {
            let wrapped = start.x_m()[k].atan2(-start.y_m()[k]);
            ((start_angle_rad[k] - wrapped) / TAU).round() as i64
        })
        .collect();

    let probe = RefCell::new(RightHandSide::new(&model));
    let scene = Scene {
        case,
        model: &model,
        start,
        start_angle_rad,
    };
    let mut ending = Ending::Complete;
    for observer in observers.iter_mut() {
        if let Err(error) = observer.begin(&scene) {
            ending = Ending::ObserverFailed(error);
        }
    }
    // Dividing rounds: a duration of 10000 steps must not become 9999 and a rest.
    let whole = (case.solver.duration_s / h + 1e-6).floor();
    let rest = case.solver.duration_s - whole * h;
    let whole = whole as u64;
    let mut steps = 0;
    while steps < whole && matches!(ending, Ending::Complete) {
        if let Err(error) = method.advance(&mut rhs) {
            ending = Ending::Stopped(Stop {
                time_s: error.time_s,
                cause: Cause::NotResolved,
            });
            break;
        }
        steps += 1;
        let step = method.step();
        if let Err(cause) = guard.check(steps, &rhs, step.after) {
            ending = Ending::Stopped(Stop {
                time_s: step.to_s,
                cause,
            });
            break;
        }
        ending = show(&step, &rhs, &probe, &mut turns, observers);
        if matches!(ending, Ending::Complete)
            && steps.is_multiple_of(ASK_EVERY)
            && control(step.to_s) == Control::Interrupt
        {
            ending = Ending::Interrupted;
        }
    }
    let mut last = Last {
        time_s: 0.0,
        values: start.values().to_vec(),
        rate: vec![],
    };
    if steps > 0 {
        let step = method.step();
        last = Last {
            time_s: step.to_s,
            values: step.after.to_vec(),
            rate: step.rate_after.to_vec(),
        };
    }
    if matches!(ending, Ending::Complete) && rest > 1e-6 * h {
        ending = finish(rest, &mut last, &mut rhs, &probe, &mut turns, observers);
        steps += 1;
    }
    if matches!(ending, Ending::Complete)
        && let Err(cause) = guard.look(&rhs, &last.values)
    {
        ending = Ending::Stopped(Stop {
            time_s: last.time_s,
            cause,
        });
    }
    let state = State::from_values(model.layout(), last.values);
    let (residual, flows) = model.energy_residual_j(guard.start_energy_j(), &state);
    Ok(RunOutcome {
        ending,
        end_s: last.time_s,
        steps,
        rhs_evaluations: rhs.evaluations(),
        end_energy_j: model.energy_j(&state),
        state,
        start_energy_j: guard.start_energy_j(),
        energy_residual_relative: if flows > 0.0 { residual / flows } else { 0.0 },
        instruction_set: rhs.instruction_set(),
    })
}

/// The end of what was computed.
struct Last {
    time_s: f64,
    values: Vec<f64>,
    rate: Vec<f64>,
}

/// The last, shorter step of a duration that is not a multiple of the step.
fn finish<'m>(
    rest: f64,
    last: &mut Last,
    rhs: &mut RightHandSide<'m>,
    probe: &RefCell<RightHandSide<'m>>,
    turns: &mut [i64],
    observers: &mut [&mut dyn Observer],
) -> Ending {
    let before = last.values.clone();
    let from_s = last.time_s;
    last.rate.resize(before.len(), 0.0);
    rhs.derivative(from_s, &before, &mut last.rate);
    let rate_before = last.rate.clone();
    let mut starter = RungeKutta::new(before.len());
    if let Err(error) = starter.cross(rhs, from_s, rest, &mut last.values, &mut last.rate) {
        return Ending::Stopped(Stop {
            time_s: error.time_s,
            cause: Cause::NotResolved,
        });
    }
    last.time_s = from_s + rest;
    let step = Step {
        from_s,
        to_s: last.time_s,
        before: &before,
        rate_before: &rate_before,
        after: &last.values,
        rate_after: &last.rate,
    };
    show(&step, rhs, probe, turns, observers)
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
