//! Zhao, Zhou, Wang, *Discrete Dynamics of Balls in Cageless Ball Bearings*, Symmetry 2022:
//! every table and figure computed beside the published numbers, and every claim judged.
//!
//! [`reproduce`] computes all of it; [`structures_of`] names the ten structures of Table 2.

mod cases;
mod claims;
mod comparison;
mod error;
mod experiment;
mod extra;
mod histories;
mod load_zone;
mod mechanics;
mod parameters;
mod printed;
mod steady;
mod structures;
mod table2;

use cageless_report::run_report::ball_pass_mark;
use cageless_report::{DesignCurve, ReproduceData, RingComparison};
use cageless_study::comparison::RingComparison as Steady;
use cageless_study::threads::in_order;
use cageless_study::{Progress, StudyError, Task, Work};

use cases::READINGS;
use error::not_computed;

pub use cases::{ODD_ROW, PUBLISHED, Published, Reading, experiment, structure, structures_of};

/// Computes every table and figure, in parallel on the threads of the caller's rayon pool.
///
/// # Errors
/// [`StudyError::Interrupted`] if `progress` ended the work; else the first computation that
/// failed.
pub fn reproduce(progress: &dyn Progress) -> Result<ReproduceData, StudyError> {
    let task = task(&comparison::GRADES)?;
    progress.whole(std::slice::from_ref(&task));
    let progress = progress.begin(TASK, task.steps());
    let progress = &progress;
    let computed = Simulations::new(progress, &comparison::GRADES)?;
    let file_d = cases::structure_file(3, READINGS[1], &[])?;
    let case_d = file_d.case().clone();
    let design_curve = parameters::design_curve(&file_d);
    let evidence = computed.evidence(&design_curve)?;
    Ok(ReproduceData {
        software: cageless_results::software(),
        lead: claims::lead(&evidence),
        table1: parameters::table1(&case_d),
        contact_track: Some(parameters::contact_track(&case_d)),
        surface: Some(parameters::surface(&case_d)),
        design_curve: Some(design_curve),
        claims: claims::claims(&evidence),
        table2: Some(computed.table2.table),
        gap_histories: computed.histories.iter().map(|h| h.gap.clone()).collect(),
        neighbours: computed
            .histories
            .into_iter()
            .map(|h| h.neighbours)
            .collect(),
        phase_portraits: computed
            .structures
            .iter()
            .map(|s| s.portraits.clone())
            .collect(),
        orbit_speeds: computed.structures.into_iter().map(|s| s.speeds).collect(),
        vibrations: vec![computed.experiment.vibration],
        ring_comparison: Some(computed.comparison),
        motions: computed.experiment.motions,
        case_toml: file_d.document().to_toml()?,
    })
}

/// All that is simulated.
struct Simulations {
    table2: table2::Computed,
    structures: [structures::Ten; 2],
    between: Vec<structures::Between>,
    histories: [histories::History; 2],
    experiment: experiment::Experiment,
    comparison: RingComparison,
    steady: Steady,
    extra: extra::Extra,
}

impl Simulations {
    /// Everything, rings with equal balls and with balls of these grades.
    fn new(progress: &Work<'_>, grades: &[u32]) -> Result<Self, StudyError> {
        let (mut table2, mut structures, mut between) =
            (not_computed(), not_computed(), not_computed());
        let (mut histories, mut experiment, mut extra) =
            (not_computed(), not_computed(), not_computed());
        let (mut comparison, mut steady) = (not_computed(), not_computed());
        // The threads take up the parts in this order: those that divide worst come first, the
        // many small tasks of Table 2 last, so that no thread waits long for another at the end.
        in_order(|scope| {
            scope.spawn_fifo(|_| extra = extra::compute(progress));
            scope.spawn_fifo(|_| comparison = comparison::compute(progress, grades));
            scope.spawn_fifo(|_| steady = steady::compute(progress));
            scope.spawn_fifo(|_| experiment = experiment::compute(progress));
            scope.spawn_fifo(|_| histories = histories::compute(progress));
            scope.spawn_fifo(|_| structures = structures::compute(progress));
            scope.spawn_fifo(|_| between = structures::between(progress));
            scope.spawn_fifo(|_| table2 = table2::compute(progress));
        });
        if progress.interrupted() {
            return not_computed();
        }
        Ok(Self {
            table2: table2?,
            structures: structures?,
            between: between?,
            histories: histories?,
            experiment: experiment?,
            comparison: comparison?,
            steady: steady?,
            extra: extra?,
        })
    }

    /// The numbers on which claims rest.
    fn evidence(&self, curve: &DesignCurve) -> Result<claims::Evidence, StudyError> {
        let [published, consistent] = [0, 1].map(|k| cases::structure(3, READINGS[k], &[]));
        let (published, consistent) = (published?, consistent?);
        Ok(claims::Evidence {
            printed: printed::PRINTED,
            mechanics: mechanics::Mechanics::new(&published, &consistent)?,
            ball_pass_hz: ball_pass_mark(&consistent).frequency_hz,
            half_angles_deg: curve.half_angle_deg.clone(),
            table2: self.table2.clone(),
            structures: self.structures.each_ref().map(|ten| ten.found.clone()),
            between: self.between.clone(),
            stages: self.histories.each_ref().map(|h| h.stages),
            bearings: self.experiment.bearings.clone(),
            comparison: self.comparison.clone(),
            steady: self.steady.clone(),
            extra: self.extra.clone(),
        })
    }
}

/// Name of the task of a reproduction.
const TASK: &str = "reproduce";

/// The task of a reproduction with balls of these grades.
fn task(grades: &[u32]) -> Result<Task, StudyError> {
    let case = cases::structure(3, READINGS[1], &[])?;
    let alone = Task::new(TASK).with(&case, WORK, PIECES);
    steady::add_to(comparison::add_to(alone, grades)?)
}

/// Pieces of what runs alone, about: structures, histories and gaps.
const PIECES: usize = 60;
/// Steps of what runs alone, about.
const WORK: f64 = table2::WORK
    + structures::WORK
    + structures::WORK_BETWEEN
    + histories::WORK
    + experiment::WORK
    + extra::WORK;
