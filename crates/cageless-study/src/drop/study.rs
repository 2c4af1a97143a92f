//! A drop with what is shown beside it.

use cageless::Case;
use cageless::simulation::{Ending, RotorDrop};
use cageless::touchdown::Scatter;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::missing_rotor;
use cageless_results::number_text::short;
use cageless_results::{DropJudgement, DropResult, Record, bearing_number, on_bearing};

use super::length::um;
use super::record::{TASK, steps};
use super::side_by_side::drop_task;
use super::verification::verify;
use super::{
    BearingRecord, DropBenefit, DropRecord, Ensemble, FiledDrop, Succession, check_drops, ensemble,
};
use crate::StudyError;
use crate::progress::Progress;
use crate::run::Rows;
use crate::task::Task;
use crate::warnings::{of_drop, of_scattered};

/// Requested computations of a drop study beside the drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct DropRequest {
    /// Whether the rotor drops onto the same bearings with conventional outer rings as well.
    pub compare: bool,
    /// Number of drops with scattered conditions; those of a comparison are judged.
    pub samples: Option<u64>,
    /// Whether the drop is verified.
    pub verify: bool,
    /// Number of drops one after the other, each with the spin-down after it; one without it unless
    /// given.
    pub drops: Option<u64>,
}

impl DropRequest {
    /// Whether the raceways are judged by scattered drops onto both rings.
    fn judges(&self, drop: &RotorDrop) -> bool {
        let mut cases = drop.cases().iter();
        self.compare && cases.any(|case| !case.raceways.is_empty())
    }

    /// The tasks of [`study`].
    fn tasks(&self, filed: &FiledDrop<'_>) -> Vec<Task> {
        let drop = &filed.drop;
        let drops = self.drops.unwrap_or(1) + u64::from(self.compare);
        let one = drops as f64 * steps(drop);
        let own = drop_task(Task::new(TASK), drop, 1, one, 1);
        let rings = if self.judges(drop) { 2 } else { 1 };
        let samples = (self.samples).map(|count| super::ensemble::task(drop, rings * count));
        let verification = self.verify.then(|| super::verification::task(filed));
        [own]
            .into_iter()
            .chain(samples)
            .chain(verification)
            .collect()
    }

    /// The drop of a file, which can be studied; `name` is what messages call the file.
    ///
    /// # Errors
    /// The case has no rotor, or one that cannot be dropped, the number of drops is impossible, or drops
    /// one after the other lack numbers of a material.
    pub fn check(&self, file: &BearingArrangement, name: &str) -> Result<RotorDrop, StudyError> {
        let missing = || {
            StudyError::Input(format!(
                "{name}: {}; `cageless run` computes a bearing at speed",
                missing_rotor()
            ))
        };
        file.check_motion()?;
        let drop = file.drop().cloned().ok_or_else(missing)?;
        for (option, count) in [("samples", self.samples), ("drops", self.drops)] {
            count.map_or(Ok(()), |count| check_drops(option, count))?;
        }
        if let Some(drops) = self.drops {
            check_heat(file, name, drops)?
        }
        let refused = (self.compare && !self.judges(&drop)).then(|| {
            "--compare conventional: the outer rings are conventional themselves; leave the option out, or give a \
             case with a [raceway]"
                .to_owned()
        });
        match refused.or_else(|| turned_back(&drop)) {
            Some(reason) => Err(StudyError::Input(format!("{name}: {reason}"))),
            None => Ok(drop),
        }
    }
}

/// Passes a file with all numbers of materials that drops one after the other need.
fn check_heat(file: &BearingArrangement, name: &str, drops: u64) -> Result<(), StudyError> {
    let cases = file.cases().iter().enumerate();
    let missing = cases.flat_map(|(k, case)| {
        let keys = case.missing_of_heat(drops > 1).into_iter();
        keys.map(move |key| file.key_in(k, key))
    });
    let missing: Vec<String> = missing.collect();
    match missing.is_empty() {
        true => Ok(()),
        false => Err(StudyError::Input(format!(
            "{name}: --drops needs {}: rings or balls are not of steel, and of no material by name \
             (ball_material.preset, say)",
            missing.join(", ")
        ))),
    }
}

/// A drop with what is shown beside it.
pub struct DropStudy {
    /// The drop.
    pub drop: RotorDrop,
    /// Record of the drop.
    pub record: DropRecord,
    /// The verdict on it and the drops after it.
    pub judgement: DropJudgement,
    /// The record of the drop of the same rotor onto conventional outer rings.
    pub conventional: Option<DropRecord>,
    /// Scattered drops.
    pub ensemble: Option<Ensemble>,
    /// Benefit of the raceways by the same drops onto conventional outer rings.
    pub benefit: Option<DropBenefit>,
    /// The drop, its spin-down to standstill and the drops after it; empty of one drop alone.
    pub succession: Succession,
    /// Verification of the drop.
    pub verification: Option<Record>,
    /// Warnings: effects that the numbers do not show, conditions that no bearing stands, and requests that could not
    /// be computed, with reasons.
    pub warnings: Vec<String>,
    /// Whether the progress cancelled it.
    pub interrupted: bool,
}

/// Drops a rotor, and computes whatever else is asked for; `rows` has a store for each bearing, or
/// none. What there is when the progress cancels is kept; a drop that does not complete has nothing
/// beside it.
///
/// # Errors
/// A bearing cannot start, or its rows could not be stored.
pub fn study<'r>(
    file: &BearingArrangement,
    drop: RotorDrop,
    request: DropRequest,
    rows: Vec<Option<&'r mut (dyn Rows + Send + 'r)>>,
    progress: &dyn Progress,
) -> Result<DropStudy, StudyError> {
    let files = file.cases();
    let filed = FiledDrop { drop, files };
    if request != DropRequest::default() {
        progress.whole(&request.tasks(&filed));
    }
    let record = DropRecord::of(&filed, rows, progress)?;
    let mut study = DropStudy::new(filed.drop.clone(), record);
    if !matches!(study.record.ending(), Ending::Complete) {
        return Ok(study);
    }
    if let Some(drops) = request.drops {
        study.succession = Succession::new(file, &filed, &mut study.record, drops, progress)?;
        study.judge();
        study.interrupted = study.succession.interrupted;
        let Succession {
            cut_short,
            without_standstill,
            ..
        } = &study.succession;
        let missing = [cut_short, without_standstill];
        let doubts = study.succession.doubts.iter();
        let all = missing.into_iter().flatten().chain(doubts).cloned();
        study.warnings.extend(all);
    }
    if request.compare && !study.interrupted {
        let none = files.iter().map(|_| None).collect();
        let other = DropRecord::of(&filed.like(filed.drop.conventional()), none, progress)?;
        study.interrupted = matches!(other.ending(), Ending::Interrupted);
        study.conventional = Some(other);
    }
    if let (Some(count), false) = (request.samples, study.interrupted) {
        let done = ensemble(&filed, count, &Scatter::default(), progress);
        study.ensemble = study.keep("the scattered drops", done);
        if let Some(ensemble) = &study.ensemble {
            let passing = &ensemble.passing;
            let judgement = std::mem::take(&mut study.judgement);
            study.judgement = judgement.with_samples(passing.count.passes(), &passing.text());
            let warnings = scattered_warnings(&study.drop, ensemble);
            study.warnings.extend(warnings);
        }
        if request.judges(&study.drop) && !study.interrupted {
            let plain = filed.like(filed.drop.conventional());
            let done = ensemble(&plain, count, &Scatter::default(), progress);
            let other = study.keep("the scattered drops onto the plain ring", done);
            let pair = study.ensemble.as_ref().zip(other.as_ref());
            study.benefit = pair.map(|(own, other)| DropBenefit::new(own, other));
        }
    }
    if request.verify && !study.interrupted {
        let done = verify(&filed, &study.record, progress);
        study.verification = study.keep("the verification", done);
    }
    Ok(study)
}

impl DropStudy {
    /// A drop with nothing beside it.
    fn new(drop: RotorDrop, record: DropRecord) -> Self {
        let mut warnings = foreseen(&drop);
        for (k, (case, bearing)) in drop.cases().iter().zip(&record.bearings).enumerate() {
            let own = of_drop(case, &bearing.result).into_iter();
            warnings.extend(own.map(|text| on_bearing(k, record.bearings.len(), &text)));
        }
        Self {
            interrupted: matches!(record.ending(), Ending::Interrupted),
            judgement: record.judgement(),
            drop,
            record,
            conventional: None,
            ensemble: None,
            benefit: None,
            succession: Succession::default(),
            verification: None,
            warnings,
        }
    }

    /// Judges the drop with those after it.
    fn judge(&mut self) {
        let Succession {
            later,
            cut_short,
            runaway,
            ..
        } = &self.succession;
        let first = self.record.judgement();
        let all = first.with_later(later, cut_short.as_ref());
        self.judgement = all.failed(runaway.clone());
    }

    /// A result, or the reason why there is none among the warnings.
    fn keep<T>(&mut self, what: &str, done: Result<T, StudyError>) -> Option<T> {
        match done {
            Ok(done) => Some(done),
            Err(error) => {
                self.interrupted |= matches!(error, StudyError::Interrupted);
                self.warnings.push(format!("{what}: {error}"));
                None
            }
        }
    }

    /// Names and records of the bearings, those with conventional outer rings last, each with its
    /// case: `own` and `conventional` of an only bearing, several by their numbers.
    pub fn columns(&self, own: &str, conventional: &str) -> Vec<(String, Case, &BearingRecord)> {
        let count = self.record.bearings.len();
        let named = |k: usize, alone: &str, note: &str| match bearing_number(k, count) {
            None => alone.to_owned(),
            Some(number) => format!("bearing {number}{note}"),
        };
        let cases = || self.drop.cases().iter().enumerate();
        let bearings = cases().zip(&self.record.bearings);
        let bearings = bearings.map(|((k, case), b)| (named(k, own, ""), case.clone(), b));
        let others = self.conventional.iter().flat_map(|record| &record.bearings);
        let others = cases().zip(others).map(|((k, case), b)| {
            let name = named(k, conventional, ", conventional");
            (name, case.conventional(), b)
        });
        bearings.chain(others).collect()
    }

    /// Names and results of the bearings as [`Self::columns`].
    pub fn results(&self, own: &str, conventional: &str) -> Vec<(String, &DropResult)> {
        let columns = self.columns(own, conventional).into_iter();
        columns.map(|(name, _, b)| (name, &b.result)).collect()
    }
}

/// Warnings of the worst of scattered drops.
fn scattered_warnings(drop: &RotorDrop, ensemble: &Ensemble) -> Vec<String> {
    let of_bearing = |(k, case): (usize, &Case)| {
        let drops = ensemble.drops.iter();
        let drops = drops.map(|row| (row.drop, &row.bearings[k].result));
        let own = of_scattered(case, drops).into_iter();
        own.map(|text| on_bearing(k, drop.cases().len(), &text))
            .collect::<Vec<_>>()
    };
    drop.cases()
        .iter()
        .enumerate()
        .flat_map(of_bearing)
        .collect()
}

/// Warnings of a drop before it is computed: a rotor that rests in its bearings in another way than a drop has it, a
/// journal that meets the stator first, a drive that turns the rotor backwards.
pub fn foreseen(drop: &RotorDrop) -> Vec<String> {
    let mut warnings = unloaded(drop);
    warnings.extend(held(drop));
    warnings.extend(meets_the_stator(drop));
    warnings.extend(turned_back(drop));
    warnings
}

/// Warnings of journals whose clearance to the stator is not above that to the bearing.
fn meets_the_stator(drop: &RotorDrop) -> Vec<String> {
    let cases = drop.cases().iter().enumerate();
    cases
        .filter_map(|(k, case)| {
            let rotor = case.rotor.as_ref()?;
            let limit_m = rotor.clearance_limit_m?;
            let text = format!(
                "the rotor meets the stator before its bearing: rotor.clearance_limit_um = {} is not above the \
                 touch-down clearance rotor.radial_clearance_um = {}",
                um(limit_m),
                um(rotor.radial_clearance_m)
            );
            let first = limit_m <= rotor.radial_clearance_m;
            first.then(|| on_bearing(k, drop.cases().len(), &text))
        })
        .collect()
}

/// Reason against a drive that brakes the rotor beyond standstill, alone, within the simulated time.
fn turned_back(drop: &RotorDrop) -> Option<String> {
    let rotor = drop.cases()[0].rotor.as_ref()?;
    let (torque_n_m, speed_rad_s) = (rotor.drive_torque_n_m, rotor.speed_rad_s);
    let duration_s = drop.cases()[0].solver.duration_s;
    let momentum = rotor.polar_inertia_kg_m2 * speed_rad_s;
    let most_s = -momentum / torque_n_m;
    let brakes = torque_n_m * speed_rad_s < 0.0;
    (brakes && most_s < duration_s).then(|| {
        format!(
            "rotor.drive_torque_n_m = {} brings the rotor to rest after {} s and then turns it backwards: {} N·m at {} \
             within solver.duration_s = {}, or a shorter duration",
            short(torque_n_m),
            short(most_s),
            short(-momentum / duration_s),
            if torque_n_m < 0.0 { "least" } else { "most" },
            short(duration_s)
        )
    })
}

/// Warning of springs of a horizontal linear rotor to the ground that carry it within all clearances.
fn held(drop: &RotorDrop) -> Option<String> {
    let rotor = drop.rotor().filter(|_| !drop.is_vertical())?;
    let gravity_m_s2 = drop.cases()[0].operation.gravity_m_s2;
    let sags_m = rotor.own_sags_m()?.into_iter().zip(drop.cases());
    let sags = sags_m.map(|(sag_m, case)| {
        let clearance_m = case.rotor.as_ref()?.radial_clearance_m;
        let sag_m = gravity_m_s2 * sag_m;
        let text = format!("{} of {} µm", um(sag_m), um(clearance_m));
        (sag_m < clearance_m && gravity_m_s2 > 0.0).then_some(text)
    });
    let sags = sags.collect::<Option<Vec<_>>>()?.join(", ");
    Some(format!(
        "the rotor does not fall onto its touch-down bearings: springs in its own matrices carry it, and it \
         sags by {sags} of the touch-down clearances. What stands for a magnetic bearing must be left out \
         of the matrices"
    ))
}

/// Warnings of bearings that carry nothing of a horizontal linear rotor at rest, or hold it down.
fn unloaded(drop: &RotorDrop) -> Vec<String> {
    let Some(rotor) = drop.rotor().filter(|_| !drop.is_vertical()) else {
        return vec![];
    };
    let shares = rotor.mass_shares_kg().into_iter();
    let shares = shares.zip(drop.carried_n()).enumerate();
    let unloaded = shares.filter(|(_, (_, carried_n))| carried_n.is_none());
    unloaded
        .map(|(k, (share_kg, _))| {
            let what = match share_kg < -1e-9 * rotor.mass_kg {
                true => format!(
                    "the rotor pulls it upwards, with {} kg: the mass centre is not between the \
                     bearings, and the rotor tips over at rest",
                    short(-share_kg)
                ),
                false => "it carries nothing of the rotor at rest: the mass centre is at another \
                          bearing"
                    .to_owned(),
            };
            let text = format!("{what}; its forces have no weight to be compared with");
            on_bearing(k, drop.cases().len(), &text)
        })
        .collect()
}
