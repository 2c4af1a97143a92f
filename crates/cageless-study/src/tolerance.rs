//! Sensitivity of the verdict on a raceway to machining errors, scatter and operation.

use cageless::film::{Film, VISCOSITIES_PA_S};
use cageless::{Case, Raceway};
use cageless::{ball_grade, ball_grades_text};
use cageless_design::critical_gap::CriticalGapError;
use cageless_design::tolerance::{Outcome, Tolerances, Trial, assess, trials};
use cageless_design::{RacewayVerdict, judge, verdict_steps};
use cageless_io::OptionError;
use cageless_io::case_file::CaseFile;
use cageless_results::number_text::significant;
use cageless_results::{Record, tolerance_record, with_unit};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::error::StudyError;
use crate::interruption::unless_interrupted;
use crate::progress::Progress;
use crate::task::Task;
use crate::threads::each;
use crate::toleranced_benefit::{TolerancedBenefit, TolerancedRings};

/// More would take days.
const SAMPLES_MAX: u64 = 100_000;
/// Largest deviation of the viscosity, per cent: what is left of an oil is thin.
const VISCOSITY_PERCENT_MAX: f64 = 90.0;
/// Nobody knows a supply worse.
const SUPPLY_FACTOR_MAX: f64 = 100.0;

/// Tolerances in the units of drawings, and Monte Carlo sample size.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Request {
    /// Bearings in which everything deviates at once.
    pub samples: u64,
    /// Depth of the raceways, µm to either side.
    pub groove_depth_um: f64,
    /// Axial span lC, µm to either side.
    pub axial_span_um: f64,
    /// Half angle θ, degrees to either side.
    pub half_angle_deg: f64,
    /// Contact angle of the raceway, degrees to either side, of a case in space.
    pub contact_angle_deg: f64,
    /// Grade of the balls by ISO 3290-1, 0 for balls all equal.
    pub ball_grade: u32,
    /// Friction coefficient, to either side.
    pub friction: f64,
    /// Radial internal clearance Gr, µm to either side.
    pub clearance_um: f64,
    /// Speed, per cent to either side.
    pub speed_percent: f64,
    /// Load, per cent to either side.
    pub load_percent: f64,
    /// Viscosity of the oil of a film, per cent to either side.
    pub viscosity_percent: f64,
    /// Factor of the supply of a film to either side.
    pub supply_factor: f64,
    /// Whether the raceway and those at the ends of its machining tolerances are judged in steady operation.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub benefit: bool,
}

/// Results of `tolerance`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ToleranceResult {
    /// Verdicts within the tolerances.
    #[serde(flatten)]
    pub record: Record,
    /// Benefit in steady operation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub benefit: Option<TolerancedBenefit>,
}

impl Default for Request {
    /// Tolerances of a workshop with five-axis grinding, and 200 bearings.
    fn default() -> Self {
        Self {
            samples: 200,
            groove_depth_um: 2.0,
            axial_span_um: 20.0,
            half_angle_deg: 0.1,
            contact_angle_deg: 0.1,
            ball_grade: 10,
            friction: 0.002,
            clearance_um: 10.0,
            speed_percent: 5.0,
            load_percent: 20.0,
            viscosity_percent: 30.0,
            supply_factor: 2.0,
            benefit: false,
        }
    }
}

/// Tolerance analysis of a case, with the benefit if it is asked for. `name` is the name of the case in messages. If
/// the progress ends the work, it is that of the bearings judged until then, without a verdict, and says so in
/// `warnings`.
///
/// # Errors
/// A tolerance is impossible, there is no raceway, a run did not converge, or the progress ended
/// the work before the nominal bearing was judged.
pub fn tolerance(
    file: &CaseFile,
    name: &str,
    request: &Request,
    progress: &dyn Progress,
) -> Result<ToleranceResult, StudyError> {
    file.checked(|case| case.check_balanced("`tolerance`"))?;
    file.checked(Case::check_run)?;
    let case = file.case();
    let tolerances = request.check(case, name)?;
    let rings = request
        .benefit
        .then(|| TolerancedRings::new(file, &tolerances));
    let rings = rings.transpose()?;
    let trials = trials(case, &tolerances, request.samples, file.particulars().seed);
    let mut tasks = vec![task(case, &trials)];
    tasks.extend(rings.as_ref().map(TolerancedRings::task).transpose()?);
    progress.whole(&tasks);
    let assessment = assess(&trials, &judge_all(case, &trials, progress)?);
    let mut ended = false;
    let benefit = match rings {
        Some(rings) => unless_interrupted(rings.judge(progress), &mut ended)?,
        None => None,
    };
    let interrupted = assessment.is_interrupted().then(|| {
        let [judged, asked] = [assessment.judged, assessment.asked];
        let left_out: Vec<&str> = assessment.incomplete.iter().map(|i| i.name()).collect();
        let left_out = match left_out.as_slice() {
            [] => String::new(),
            names => format!("; one at a time, these lack bearings: {}", names.join(", ")),
        };
        format!("{INTERRUPTED}these are {judged} of {asked} bearings{left_out}")
    });
    let stopped = assessment.stopped().map(|(count, first)| match count {
        1 => format!("a bearing neither passes nor fails, as {first}"),
        _ => format!(
            "{count} bearings neither pass nor fail, as a run stopped; of the first {first}"
        ),
    });
    let unjudged = || format!("{INTERRUPTED}the benefit is not judged");
    let interrupted = interrupted.or_else(|| ended.then(unjudged));
    let warnings = interrupted.into_iter().chain(stopped).collect();
    let grade = request.ball_grade;
    Ok(ToleranceResult {
        record: tolerance_record(
            case,
            file.particulars(),
            grade,
            &tolerances,
            &assessment,
            warnings,
        ),
        benefit,
    })
}

/// Beginning of the warning of an analysis that was interrupted.
const INTERRUPTED: &str = "interrupted: ";

/// Warning that an analysis was interrupted, if it was.
pub fn interruption(record: &Record) -> Option<&str> {
    let warnings = record.sentences("warnings").iter().map(String::as_str);
    warnings
        .into_iter()
        .find(|warning| warning.starts_with(INTERRUPTED))
}

/// Why there is no verdict on the nominal bearing; `None` where there is one.
pub fn nominal_stopped(record: &Record) -> Option<&str> {
    let headline = record.text("headline");
    let open = record.text("nominal_verdict") == RacewayVerdict::NotJudged.name();
    open.then_some(headline)
}

impl Request {
    /// Deviations of a case that these tolerances allow.
    ///
    /// # Errors
    /// [`StudyError::Option`] or [`StudyError::Input`]; `name` is what the message calls the case.
    pub fn check(&self, case: &Case, name: &str) -> Result<Tolerances, StudyError> {
        if case.raceways.is_empty() {
            return Err(StudyError::Input(format!(
                "{name}: there is no [raceway] to be judged"
            )));
        }
        if !case.has_constant_operation() {
            return Err(StudyError::Input(format!(
                "{name}: a tolerance study needs constant speed and load: leave out [rotor] and \
                 tables over time"
            )));
        }
        if self.samples > SAMPLES_MAX {
            let allowed = format!("at most {SAMPLES_MAX}");
            return Err(OptionError::not_possible("samples", self.samples, &allowed).into());
        }
        self.check_applies(case)?;
        self.check_limits(case)?;
        let grade = ball_grade(self.ball_grade);
        if grade.is_none() && self.ball_grade != 0 {
            let allowed = format!("a grade of ISO 3290-1 ({}), or 0", ball_grades_text());
            let given = self.ball_grade;
            return Err(OptionError::not_possible("ball_grade", given, &allowed).into());
        }
        Ok(Tolerances {
            groove_depth_m: self.groove_depth_um * 1e-6,
            axial_span_m: self.axial_span_um * 1e-6,
            half_angle_rad: self.half_angle_deg.to_radians(),
            section_angle_rad: match case.moves_in_space() {
                true => self.contact_angle_deg.to_radians(),
                false => 0.0,
            },
            ball_grade: grade,
            friction: self.friction,
            clearance_m: self.clearance_um * 1e-6,
            speed_fraction: self.speed_percent / 100.0,
            load_fraction: self.load_percent / 100.0,
            viscosity_fraction: self.viscosity_percent / 100.0,
            supply_factor: self.supply_factor,
        })
    }

    /// Refuses deviations of what a case does not have.
    fn check_applies(&self, case: &Case) -> Result<(), StudyError> {
        if !case.moves_in_space()
            && ![0.0, Self::default().contact_angle_deg].contains(&self.contact_angle_deg)
        {
            let allowed = "0 in the plane: model.motion = \"space\" has contact angles";
            let given = self.contact_angle_deg;
            return Err(OptionError::not_possible("contact_angle_deg", given, allowed).into());
        }
        let usual = Self::default();
        for (option, given, usual) in [
            (
                "viscosity_percent",
                self.viscosity_percent,
                usual.viscosity_percent,
            ),
            ("supply_factor", self.supply_factor, usual.supply_factor),
        ] {
            if case.film.is_none() && given != usual {
                let allowed = "left out: a case without [film] has no oil";
                return Err(OptionError::not_possible(option, given, allowed).into());
            }
        }
        if !(1.0..=SUPPLY_FACTOR_MAX).contains(&self.supply_factor) {
            let allowed = format!("from 1 to {SUPPLY_FACTOR_MAX}");
            let given = self.supply_factor;
            return Err(OptionError::not_possible("supply_factor", given, &allowed).into());
        }
        Ok(())
    }

    /// Refuses deviations that are too large.
    fn check_limits(&self, case: &Case) -> Result<(), StudyError> {
        for (option, value, most) in self.limits(case) {
            if !(value >= 0.0 && value <= most && value.is_finite()) {
                let unit = match option.rsplit('_').next() {
                    Some("um") => "µm",
                    Some("deg") => "°",
                    Some("percent") => "%",
                    _ => "",
                };
                let oil = match (option, case.film.as_ref()) {
                    ("viscosity_percent", Some(film)) => within_oils(film),
                    _ => String::new(),
                };
                let most = with_unit(&significant(most, 6), unit);
                let allowed = format!("from 0 to {most}{oil}");
                return Err(OptionError::not_possible(option, value, &allowed).into());
            }
        }
        Ok(())
    }

    /// Name, value and largest possible value of each deviation.
    fn limits(&self, case: &Case) -> [(&'static str, f64, f64); 9] {
        let least = |of: &dyn Fn(&Raceway) -> f64| {
            let values = case.raceways.iter().map(of);
            values.fold(f64::INFINITY, f64::min)
        };
        let half_angle = least(&|r| r.half_angle_rad().to_degrees());
        let span = least(&|r| r.dimensions().axial_span_m * 1e6);
        let depth = least(&|r| r.depth_error_max_m() * 1e6);
        let [_, shoulder] = case.bearing.shoulder_angles_rad();
        let turned = |r: &Raceway| {
            let flank = r.contact_angle_rad(0.0)[0] + r.section_angle_rad().abs();
            (shoulder - flank).to_degrees()
        };
        let turned = least(&turned);
        // A ring this far off its centre presses no ball against the other side.
        let clearance = 0.2 * case.bearing.ball_radius_m() * 1e6;
        [
            ("groove_depth_um", self.groove_depth_um, depth),
            ("axial_span_um", self.axial_span_um, span),
            ("half_angle_deg", self.half_angle_deg, half_angle),
            ("contact_angle_deg", self.contact_angle_deg, turned),
            ("friction", self.friction, case.contact.friction.coefficient),
            ("clearance_um", self.clearance_um, clearance),
            ("speed_percent", self.speed_percent, 100.0),
            ("load_percent", self.load_percent, 100.0),
            (
                "viscosity_percent",
                self.viscosity_percent,
                case.film
                    .as_ref()
                    .map_or(VISCOSITY_PERCENT_MAX, viscosity_percent_max),
            ),
        ]
    }
}

/// Largest deviation of the viscosity of a film that leaves an oil that can be, %.
fn viscosity_percent_max(film: &Film) -> f64 {
    let viscosity_pa_s = film.oil.viscosity_pa_s;
    let [least, most] = VISCOSITIES_PA_S;
    let either = (1.0 - least / viscosity_pa_s).min(most / viscosity_pa_s - 1.0);
    (100.0 * either).clamp(0.0, VISCOSITY_PERCENT_MAX)
}

/// Reason for the largest deviation of the viscosity of a film where an end of the range of oils sets it.
fn within_oils(film: &Film) -> String {
    if viscosity_percent_max(film) == VISCOSITY_PERCENT_MAX {
        return String::new();
    }
    let mpa_s = |viscosity_pa_s: f64| significant(1e3 * viscosity_pa_s, 4);
    let [least, most] = VISCOSITIES_PA_S.map(mpa_s);
    let own = mpa_s(film.oil.viscosity_pa_s);
    format!(
        ", as oils have {least} to {most} mPa·s, and that of the film has {own} mPa·s (film.viscosity_mpa_s)"
    )
}

/// Name of the task of an analysis.
const TASK: &str = "tolerance";

/// The task of judging the trials.
fn task(case: &Case, trials: &[Trial]) -> Task {
    let steps = trials.len() as f64 * verdict_steps(case);
    Task::new(TASK).with(case, steps, trials.len())
}

/// Outcomes of the trials; `None` of those that the progress ended, of which the first, nominal, is none.
fn judge_all(
    case: &Case,
    trials: &[Trial],
    progress: &dyn Progress,
) -> Result<Vec<Option<Outcome>>, StudyError> {
    let steps = verdict_steps(case);
    let task = progress.begin(TASK, trials.len() as f64 * steps);
    let outcome = |trial: &Trial| {
        if progress.interrupted() {
            return Ok(None);
        }
        let judged = match trial.deviation.apply(case) {
            Err(error) => {
                let _ = task.add(steps);
                return Ok(Some(Outcome::impossible(error.to_string())));
            }
            Ok(varied) => judge(&varied, &mut task.run_control(1.0, steps)),
        };
        match judged {
            Ok(judgement) => Ok(Some(Outcome::judged(&judgement))),
            Err(CriticalGapError::Case(error)) => Ok(Some(Outcome::impossible(error.to_string()))),
            Err(CriticalGapError::Interrupted) => Ok(None),
            Err(error) => Err(StudyError::from(error)),
        }
    };
    let outcomes: Result<Vec<_>, _> = each(trials).map(outcome).collect();
    let outcomes = outcomes?;
    match outcomes[0] {
        Some(_) => Ok(outcomes),
        None => Err(StudyError::Interrupted),
    }
}

#[cfg(test)]
mod tests;
