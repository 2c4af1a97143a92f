//! Verdict and design results of the raceways of a case.

use std::path::Path;

use cageless::Case;
use cageless::Snapshot;
use cageless::raceway::RacewayDimensions;
use cageless::recorder::{Recorder, keeping};
use cageless::simulation::Stop;
use cageless_design::critical_gap::CriticalGapError;
use cageless_design::search::Found;
use cageless_design::{
    Judgement, Recommendation, judge_watched, recommend, recommendation_steps, steady_case,
    verdict_steps,
};
use cageless_io::case_file::CaseFile;

use cageless_results::{Recommended, Record, axial_record, design_record};
use serde::Serialize;

use crate::benefit_search::{self, BenefitSearch, Candidate, search_benefit};
use crate::entered::{entered, entered_raceway};
use crate::error::StudyError;
use crate::interruption::unless_interrupted;
use crate::progress::Progress;
use crate::structure::RacewayLabel;
use crate::task::Task;
use crate::{axial, search};

/// Results of `design`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DesignResult {
    /// Closed forms, verdict and recommendation.
    #[serde(flatten)]
    pub record: Record,
    /// Lags that axial load and tilt leave.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial: Option<Record>,
    /// Result of a search.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search: Option<Record>,
    /// Benefit in steady operation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub benefit: Option<BenefitSearch>,
}

impl DesignResult {
    /// Results of the verdict on the raceways of a case.
    pub fn new(file: &CaseFile, judgement: &Judgement, near: Option<&Recommendation>) -> Self {
        Self {
            record: design_record(file.case(), file.particulars(), judgement, near),
            axial: None,
            search: None,
            benefit: None,
        }
    }

    /// The structure that a search recommends: where benefit was asked for, the one that helps most.
    pub fn found(&self) -> Option<&Record> {
        let search = self.search.as_ref()?;
        match &self.benefit {
            Some(benefit) => benefit.recommended.as_ref(),
            None => search.part("recommended"),
        }
    }

    /// The raceway near the curve of Eq. (11), if there is one.
    pub fn recommendation(&self) -> Option<Recommended<'_>> {
        self.record.part("recommendation").map(Recommended)
    }
}

/// Work beside the verdict.
#[derive(Debug, Clone, Copy, Default)]
pub struct Asked<'a> {
    /// Motion in space under axial loads and tilts.
    pub axial: bool,
    /// A search for a raceway, with the structures of the paper for the bearing.
    pub search: Option<&'a [RacewayLabel]>,
    /// Steady operation of the raceway, or of those of the search, against a plain ring.
    pub benefit: bool,
    /// Folder in which a search that was ended resumes.
    pub folder: Option<&'a Path>,
}

/// A design and what it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct Designed {
    /// The results.
    pub result: DesignResult,
    /// The end of the run that was judged.
    pub snapshots: Vec<Snapshot>,
    /// Cause of a run of the verdict that stopped early.
    pub stopped: Option<Stop>,
    /// Why a search recommends nothing.
    pub none_found: Option<String>,
    /// Why an axial load that was asked for is not known.
    pub axial_unknown: Option<String>,
    /// Whether the progress ended the work after the verdict: what was to follow is left out.
    pub interrupted: bool,
}

/// Tasks of what is asked of a case.
fn tasks(
    file: &CaseFile,
    asked: &Asked<'_>,
    progress: &dyn Progress,
) -> Result<Vec<Task>, StudyError> {
    let case = file.case();
    let mut tasks = vec![Task::new(TASK).with(case, verdict_steps(case), 1)];
    if asked.search.is_none() {
        let steps = recommendation_steps(case);
        tasks.push(Task::new(RECOMMENDATION).with(case, steps, 1));
    }
    if asked.axial {
        tasks.push(axial::task(file)?);
    }
    if asked.search.is_some() && progress.workload().is_some() {
        tasks.extend(search::tasks(file, progress.announces())?);
    }
    if asked.benefit {
        let count = match asked.search {
            Some(_) => benefit_search::CANDIDATES,
            None => usize::from(!case.raceways.is_empty()),
        };
        tasks.extend(benefit_search::tasks(file, count)?);
    }
    Ok(tasks)
}

/// Judges the raceways of a case, finds one near the curve of Eq. (11) that passes, and does what else is
/// asked.
///
/// # Errors
/// The case is impossible, a run did not converge, or the progress ended the work before the verdict, or in a search,
/// which resumes.
pub fn design(
    file: &CaseFile,
    asked: Asked<'_>,
    progress: &dyn Progress,
) -> Result<Designed, StudyError> {
    file.checked(Case::check_run)?;
    file.checked(|case| case.check_balanced("a verdict"))?;
    let case = file.case();
    progress.whole(&tasks(file, &asked, progress)?);
    let (judgement, snapshots) = judged(file, progress)?;
    // A search finds better, and one recommendation is enough.
    let mut interrupted = false;
    let near = match asked.search {
        None => unless_interrupted(recommended(file, progress), &mut interrupted)?.flatten(),
        Some(_) => None,
    };
    let judgement = judgement.map_err(|error| StudyError::of_run(file, error))?;
    let mut designed = Designed {
        result: DesignResult::new(file, &judgement, near.as_ref()),
        snapshots,
        stopped: judgement.stopped,
        none_found: None,
        axial_unknown: None,
        interrupted,
    };
    if asked.axial && !designed.interrupted {
        add_axial_lags(file, &mut designed, progress)?;
    }
    if let Some(paper) = asked.search.filter(|_| !designed.interrupted) {
        let (found, record) = search::run(file, asked.folder, paper, progress)?;
        designed.none_found = search::refusal(file, &found);
        designed.result.search = Some(record);
        if asked.benefit {
            most_helpful(file, &found, &mut designed, progress)?;
        }
    } else if asked.benefit && !designed.interrupted {
        let own = Candidate {
            name: "raceway".to_owned(),
            file: file.clone(),
        };
        let own = match case.raceways.is_empty() {
            true => vec![],
            false => vec![own],
        };
        let found = search_benefit(file, &own, &|_| Ok(true), progress);
        designed.result.benefit = unless_interrupted(found, &mut designed.interrupted)?;
    }
    Ok(designed)
}

/// Adds the axial loads that a case stands.
fn add_axial_lags(
    file: &CaseFile,
    designed: &mut Designed,
    progress: &dyn Progress,
) -> Result<(), StudyError> {
    let lags = unless_interrupted(axial::axial_lags(file, progress), &mut designed.interrupted)?;
    if let Some(lags) = lags {
        let record = axial_record(&lags);
        let unknown = axial::stops_a_limit(&lags);
        designed.axial_unknown = unknown.then(|| record.sentences("findings")[0].clone());
        designed.result.axial = Some(record);
    }
    Ok(())
}

/// Chooses the raceway of a search that helps most; without one nothing is recommended.
fn most_helpful(
    file: &CaseFile,
    found: &Found,
    designed: &mut Designed,
    progress: &dyn Progress,
) -> Result<(), StudyError> {
    let (indices, candidates): (Vec<usize>, Vec<Candidate>) =
        search::candidates(file, found)?.into_iter().unzip();
    // The recommended one has its verdicts.
    let works = |k: usize| match Some(indices[k]) == found.recommended {
        true => Ok(true),
        false => search::works(file, found, indices[k], progress),
    };
    let mut benefit = search_benefit(file, &candidates, &works, progress)?;
    let structure = |k: usize| search::structure(&found.evaluations[indices[k]]);
    benefit.recommended = benefit.best.map(structure);
    let none = || format!("no raceway is recommended. {}", benefit.answer);
    designed.none_found = designed
        .none_found
        .take()
        .or_else(|| benefit.best.is_none().then(none));
    designed.result.benefit = Some(benefit);
    Ok(())
}

/// Orbits of the balls whose motion is kept.
pub const PORTRAIT_ORBITS: f64 = 3.0;
/// Moments of the motion that are kept.
const SNAPSHOTS: f64 = 400.0;

/// Names of the tasks of the verdict and of the recommendation.
const TASK: &str = "design";
const RECOMMENDATION: &str = "recommendation";

/// The verdict on the raceways of a case, and the end of the run that was judged.
fn judged(
    file: &CaseFile,
    progress: &dyn Progress,
) -> Result<(Result<Judgement, CriticalGapError>, Vec<Snapshot>), StudyError> {
    let case = file.case();
    let steady = steady_case(case);
    let end_s = steady.solver.duration_s;
    let from_s = end_s * (1.0 - PORTRAIT_ORBITS / 32.0);
    let steps = verdict_steps(case);
    let task = progress.begin(TASK, steps);
    let mut snapshots = vec![];
    let judgement = {
        let interval_s = (end_s - from_s) / SNAPSHOTS;
        let kept = keeping(&mut snapshots, |s: &Snapshot| s.time_s >= from_s);
        let mut recorder = Recorder::new(interval_s, kept);
        judge_watched(
            case,
            &mut [&mut recorder],
            &mut task.run_control(1.0, steps),
        )
    };
    match progress.interrupted() {
        true => Err(StudyError::Interrupted),
        false => Ok((judgement, snapshots)),
    }
}

/// A raceway near the curve of Eq. (11).
fn recommended(
    file: &CaseFile,
    progress: &dyn Progress,
) -> Result<Option<Recommendation>, StudyError> {
    let case = file.case();
    let steps = recommendation_steps(case);
    let task = progress.begin(RECOMMENDATION, steps);
    let entered = |dimensions: RacewayDimensions| {
        let depth_error_um = file.document().number("raceway.1.depth_error_um");
        let raceway = entered_raceway(&dimensions, depth_error_um.unwrap_or(0.0));
        entered(file, &[raceway], None)
    };
    let mut control = task.run_control(1.0, steps);
    match recommend(case, &entered, &mut *control) {
        Ok(found) => Ok(found),
        Err(CriticalGapError::Interrupted) => Err(StudyError::Interrupted),
        Err(error @ CriticalGapError::Case(_)) => Err(StudyError::of_run(file, error)),
        // No run of a pair can be judged here; the verdict says why.
        Err(_) => Ok(None),
    }
}
