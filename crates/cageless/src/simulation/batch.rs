//! Batches: several bearings integrated side by side in the lanes of the vectors.

use std::sync::Arc;

use super::front::run;
use super::observer::{Observer, RunContext};
use super::outcome::RunOutcome;
use super::run::drive;
use super::run_tracker::RunTracker;
use super::watch::Watch;
use crate::case::Case;
use crate::contact::{FrictionModel, Regularisation};
use crate::control::Control;
use crate::dynamics::state::State;
use crate::dynamics::world::World;
use crate::dynamics::{InstructionSet, Model};
use crate::equilibrium::EquilibriumError;
use crate::flank_model::FlankModel;
use crate::formulation::Formulation;
use crate::initial_conditions::initial_state_controlled;
use crate::numerics::lanes::BATCH_WIDTH;
use crate::step_limits::{self, StepLimits};

/// Properties that all cases of a batch share. Methods with a memory or a step of
/// their own would let one bearing change the steps of another.
#[derive(PartialEq)]
struct Kind {
    balls: usize,
    formulation: Formulation,
    law: FrictionModel,
    regularisation: Regularisation,
    has_film: bool,
    mixes_friction: bool,
    flanks: FlankModel,
    implicit_friction: bool,
    has_nominal_geometry: bool,
    step_s: f64,
    duration_s: f64,
}

impl Kind {
    fn from_case(case: &Case) -> Option<Self> {
        let alone = !case.solver.method.properties().side_by_side || case.moves_in_space();
        (!alone).then(|| Self {
            balls: case.bearing.balls(),
            formulation: case.formulation,
            law: case.contact.friction_law,
            regularisation: case.contact.regularisation,
            has_film: case.film.is_some(),
            mixes_friction: case.mixes_friction(),
            flanks: case.flanks,
            implicit_friction: StepLimits::friction_is_stiff(case),
            has_nominal_geometry: case.has_nominal_geometry(),
            step_s: case.solver.step_s,
            duration_s: case.solver.duration_s,
        })
    }
}

/// Fewer bearings than this are as fast one after the other.
const LEAST: usize = 4;

/// Groups cases that can run side by side, up to [`BATCH_WIDTH`] each, and the others one by one; the
/// entries are indices. How cases are grouped changes no bit of their results.
pub fn batches(cases: &[Case]) -> Vec<Vec<usize>> {
    let mut open: Vec<(Kind, Vec<usize>)> = vec![];
    let mut batches = vec![];
    for (k, case) in cases.iter().enumerate() {
        let Some(kind) = Kind::from_case(case) else {
            batches.push(vec![k]);
            continue;
        };
        match open.iter_mut().find(|(other, _)| *other == kind) {
            Some((_, bearings)) => bearings.push(k),
            None => open.push((kind, vec![k])),
        }
    }
    for (_, bearings) in open {
        for group in bearings.chunks(BATCH_WIDTH) {
            if group.len() < LEAST {
                batches.extend(group.iter().map(|k| vec![*k]));
            } else {
                batches.push(group.to_vec());
            }
        }
    }
    batches.sort();
    batches
}

/// Runs the cases of one of the [`batches`], each watched by its own observers. Outcomes have
/// the bits that [`run`] gives.
///
/// # Errors
/// Errors of [`run`] per case.
///
/// # Panics
/// If the cases cannot run side by side.
pub fn run_batch(
    cases: &[&Case],
    observers: &mut [Vec<&mut dyn Observer>],
    control: &mut dyn FnMut(f64) -> Control,
) -> Vec<Result<RunOutcome, EquilibriumError>> {
    assert_eq!(cases.len(), observers.len(), "observers for each case");
    if let ([case], [observers]) = (cases, &mut *observers) {
        return vec![run(case, observers, control)];
    }
    // Impossible cases have no kind; each gets its own error below.
    let possible = cases.iter().filter(|case| step_limits::check(case).is_ok());
    let mut kinds = possible.map(|case| Kind::from_case(case));
    let first = kinds.next();
    assert!(
        cases.len() <= BATCH_WIDTH
            && first.is_none_or(|first| first.is_some() && kinds.all(|kind| kind == first)),
        "cases side by side must be of one kind"
    );
    let prepared: Vec<Result<Prepared, EquilibriumError>> = cases
        .iter()
        .map(|case| Prepared::new(case, &mut || control(0.0)))
        .collect();
    let ready: Vec<(&Case, &Prepared)> = cases
        .iter()
        .zip(&prepared)
        .filter_map(|(case, p)| Some((*case, p.as_ref().ok()?)))
        .collect();
    let mut outcomes = side_by_side(&ready, observers, &prepared, control).into_iter();
    prepared
        .into_iter()
        .map(|p| {
            p.map(|_| {
                outcomes
                    .next()
                    .expect("one outcome per case that could start")
            })
        })
        .collect()
}

/// A case with its model and initial state.
struct Prepared {
    model: Arc<Model>,
    start: State,
    angles: Vec<f64>,
}

impl Prepared {
    fn new(case: &Case, control: &mut dyn FnMut() -> Control) -> Result<Self, EquilibriumError> {
        let (start, angles) = initial_state_controlled(case, control)?;
        Ok(Self {
            model: Model::new(case)?,
            start,
            angles,
        })
    }
}

fn side_by_side(
    ready: &[(&Case, &Prepared)],
    observers: &mut [Vec<&mut dyn Observer>],
    prepared: &[Result<Prepared, EquilibriumError>],
    control: &mut dyn FnMut(f64) -> Control,
) -> Vec<RunOutcome> {
    let Some(last) = ready.last() else {
        return vec![];
    };
    let models = std::array::from_fn(|lane| Arc::clone(&ready.get(lane).unwrap_or(last).1.model));
    let mut world = World::side_by_side(models, InstructionSet::chosen());
    let start = world.vector(ready.iter().map(|(_, prepared)| &prepared.start));
    let watched = observers
        .iter_mut()
        .zip(prepared)
        .filter(|(_, p)| p.is_ok());
    let contexts = ready.iter().map(|(case, prepared)| RunContext {
        case,
        model: &prepared.model,
        start: &prepared.start,
        start_angle_rad: &prepared.angles,
    });
    let contexts: Vec<RunContext<'_>> = contexts.collect();
    let watch = |(bearing, context)| Watch::new(context, world.layout(bearing), bearing);
    let mut watches: Vec<Watch> = contexts.iter().enumerate().map(watch).collect();
    let mut trackers: Vec<RunTracker<'_, '_>> = contexts
        .iter()
        .zip(&mut watches)
        .zip(watched)
        .map(|((context, watch), (observers, _))| RunTracker::new(*context, watch, observers))
        .collect();
    drive(&start, &mut world, &mut trackers, control);
    trackers
        .into_iter()
        .map(RunTracker::whole_outcome)
        .collect()
}
