//! The loop over the steps.

use super::course::Course;
use super::guard::{Cause, Stop};
use super::observer::{Observer, Scene};
use crate::case::{Case, Method};
use crate::dynamics::state::State;
use crate::dynamics::{InstructionSet, Model, RightHandSide};
use crate::equilibrium::EquilibriumError;
use crate::error::InputError;
use crate::integrator::{self, Abm4, Adaptive, Integrator, VelocityVerlet};
use crate::start::initial_state;

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
    /// Energy now − energy at the start − net work, over the sum of absolute flows, at least
    /// 1e-6 of the energy at the start.
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
    let rhs = RightHandSide::new(&model);
    let scene = Scene {
        case,
        model: &model,
        start,
        start_angle_rad,
    };
    let mut course = Course::new(scene, rhs.layout(), observers);
    drive(rhs, std::slice::from_mut(&mut course), control);
    Ok(course.outcome())
}

/// Advances bearings of one kind, method, step and duration, alone or side by side, until
/// each has come to its end.
pub(super) fn drive<'m>(
    mut rhs: RightHandSide<'m>,
    courses: &mut [Course<'_, 'm, '_>],
    control: &mut dyn FnMut(f64) -> Control,
) {
    let solver = &courses[0].scene.case.solver;
    let (size, h) = (rhs.layout().len(), solver.step_s);
    let mut start = vec![0.0; size];
    rhs.layout().spread_padding(&mut start);
    for bearing in 0..rhs.layout().width() {
        // Lanes without a bearing of their own repeat the last.
        let course = &courses[bearing.min(courses.len() - 1)];
        let places = rhs.layout().of_bearing(bearing);
        course.scene.start.write_to(places, &mut start);
    }
    match solver.method {
        Method::Abm4 => advance(Abm4::new(size, h), &mut rhs, &start, courses, control),
        Method::Symplectic => {
            advance(VelocityVerlet::new(h), &mut rhs, &start, courses, control);
        }
        Method::Adaptive => {
            let method = Adaptive::new(size, h, solver.tolerance);
            advance(method, &mut rhs, &start, courses, control);
        }
    }
}

fn advance<'m>(
    method: impl integrator::Method,
    rhs: &mut RightHandSide<'m>,
    start: &[f64],
    courses: &mut [Course<'_, 'm, '_>],
    control: &mut dyn FnMut(f64) -> Control,
) {
    let mut integrator = Integrator::new(method, start.len());
    integrator.restart(rhs, 0.0, start);
    let duration = courses[0].scene.case.solver.duration_s;
    let mut steps = 0;
    while courses.iter().any(Course::under_way) {
        if let Err(error) = rhs.advance(&mut integrator, duration) {
            for course in courses.iter_mut() {
                let stop = Stop {
                    time_s: error.time_s,
                    step_s: course.scene.case.solver.step_s,
                    cause: Cause::NotResolved,
                };
                course.end(Ending::Stopped(stop), &integrator.step().y1);
            }
            break;
        }
        steps += 1;
        let step = integrator.step();
        for course in courses.iter_mut().filter(|c| c.under_way()) {
            course.follow(step, rhs, steps, duration);
        }
        if step.t1_s >= duration {
            break;
        }
        if steps.is_multiple_of(ASK_EVERY) && control(step.t1_s) == Control::Interrupt {
            for course in courses.iter_mut() {
                course.end(Ending::Interrupted, &step.y1);
            }
        }
    }
    for course in courses {
        course.rhs_evaluations = rhs.evaluations();
        course.instruction_set = rhs.instruction_set();
    }
}
