//! The experiment of Section 5 with balls of several grades: conventional ring, structure (d)
//! and raceways found by search, from the same starts with the same balls.

mod outcome;

use std::f64::consts::TAU;

use cageless::collision::{Collision, CollisionDetector};
use cageless::recorder::keeping;
use cageless::simulation::{Control, Observer, ObserverError, StepView, batches, run_batch};
use cageless::vibration::VibrationRecorder;
use cageless::{BallGrade, ball_grade};
use cageless::{Case, Gaps, IntegrationMethod, Raceway, RacewayDimensions, Start, StartState};
use cageless_design::tolerance::ball_lot_m;
use cageless_report::run_report::filter_note;
use cageless_report::{
    ComparisonCell, Estimate, Provenance, RacewayLabel, RecordChange, RingComparison, RingNumbers,
};
use cageless_study::threads::each;
use cageless_study::{SAMPLING_HZ, StudyError, Task, Work, provenance};
use rayon::prelude::*;

use outcome::{Outcome, Recorded, outcome};

use crate::cases;
use crate::error::housing;
use crate::experiment::{STRETCHES, Stretch};
use crate::load_zone::load_zone_rad;

/// Seed of starts and lots.
const SEED: u64 = 5;
/// Starts per combination: as many as run side by side.
const STARTS: u64 = 8;
/// Starts of equal balls in the conventional ring, whose contacts are counted over ψ: the error of the density is
/// then well below its distance from chance.
pub const TRANSITION_STARTS: u64 = 32;
/// Bunches of balls at the start.
const BUNCHES: usize = 4;
/// Gap within a bunch.
const GAP_IN_BUNCH_DEG: f64 = 0.05;
/// Grades of ISO 3290-1 besides equal balls.
pub const GRADES: [u32; 3] = [5, 10, 28];

/// A speed with a raceway near that which `design --search` recommends for it.
struct Speed {
    rpm: f64,
    duration_s: f64,
    found_axial_span_mm: f64,
    found_half_angle_deg: f64,
}

/// Twenty orbits of the balls at the lower speed, forty at the higher; the first half is
/// discarded.
const SPEEDS: [Speed; 2] = [
    Speed {
        rpm: 3000.0,
        duration_s: 1.0,
        found_axial_span_mm: 5.921,
        found_half_angle_deg: 13.16,
    },
    Speed {
        rpm: 12_000.0,
        duration_s: 0.5,
        found_axial_span_mm: 5.093,
        found_half_angle_deg: 24.06,
    },
];

/// Names of the rings, in the order of the cells.
pub const CONVENTIONAL: &str = "conventional";
/// The paper's sample.
pub const STRUCTURE_D: &str = "structure (d)";
/// Ring recommended by `design --search`.
pub const FOUND: &str = "found by search";

/// Differences of the model from the paper's experiment.
const LEFT_OUT: [&str; 4] = [
    "tilt of the rings",
    "waviness of rings and balls",
    "the lubricant film",
    "starting and touching down",
];

/// One combination.
struct Plan {
    case: Case,
    rpm: f64,
    /// Grade of the balls; `None` if they are equal.
    grade: Option<BallGrade>,
    ring: &'static str,
}

/// Runs every combination of equal balls and of lots of these grades.
pub fn compute(progress: &Work<'_>, grades: &[u32]) -> Result<RingComparison, StudyError> {
    let plans = plans(grades)?;
    let found: Vec<Vec<Outcome>> = each(&plans)
        .map(|plan| outcomes(plan, progress, plan.steps()))
        .collect::<Result<_, StudyError>>()?;
    let rings = plans.len() / SPEEDS.len() / (1 + grades.len());
    let cells = plans
        .iter()
        .zip(&found)
        .enumerate()
        .map(|(k, (plan, outcomes))| {
            let conventional = &found[k - k % rings];
            cell(plan, outcomes, (k % rings > 0).then_some(conventional))
        })
        .collect::<Result<_, StudyError>>()?;
    Ok(RingComparison {
        cells,
        starts: format!(
            "{STARTS} starts per combination, the same for every ring: {BUNCHES} bunches of balls \
             whose sizes are drawn at random, gaps of {GAP_IN_BUNCH_DEG}° within a bunch; radii \
             of the balls drawn for each start, uniform within what the grade admits (seed \
             {SEED})."
        ),
        command: "cargo run --release -- reproduce".to_owned(),
        search_commands: SPEEDS
            .iter()
            .map(|speed| {
                format!(
                    "cageless design cases/zhao-d.toml --set operation.inner_speed_rpm={} --search",
                    speed.rpm
                )
            })
            .collect(),
        left_out: LEFT_OUT.map(str::to_owned).to_vec(),
        provenance: source(&plans),
    })
}

/// Adds every combination to a task.
pub fn add_to(task: Task, grades: &[u32]) -> Result<Task, StudyError> {
    let plans = plans(grades)?;
    let steps = plans.iter().map(Plan::steps).sum();
    let case = plans[0].start(0)?;
    Ok(task.with_together(vec![case; STARTS as usize], steps, plans.len()))
}

/// The combinations, by speed, lot and ring.
fn plans(grades: &[u32]) -> Result<Vec<Plan>, StudyError> {
    let [conventional, discrete] = cases::experiment()?.map(|file| file.case().clone());
    let mut plans = vec![];
    for speed in &SPEEDS {
        let found = with_raceway(&discrete, speed)?;
        let rings = [
            (CONVENTIONAL, &conventional),
            (STRUCTURE_D, &discrete),
            (FOUND, &found),
        ];
        let graded = grades.iter().filter_map(|&number| ball_grade(number));
        for grade in std::iter::once(None).chain(graded.map(Some)) {
            for (ring, case) in rings {
                let mut case = case.clone();
                case.operation.inner_speed_rad_s = speed.rpm * TAU / 60.0;
                case.solver.duration_s = speed.duration_s;
                case.set_method(IntegrationMethod::VelocityVerlet);
                plans.push(Plan {
                    case,
                    rpm: speed.rpm,
                    grade,
                    ring,
                });
            }
        }
    }
    Ok(plans)
}

fn with_raceway(case: &Case, speed: &Speed) -> Result<Case, StudyError> {
    let dimensions = RacewayDimensions {
        axial_span_m: speed.found_axial_span_mm * 1e-3,
        half_angle_rad: speed.found_half_angle_deg.to_radians(),
        ..*case.raceways[0].dimensions()
    };
    let raceway = Raceway::new(dimensions, &case.bearing)?;
    Ok(Case {
        raceways: vec![raceway],
        ..case.clone()
    })
}

impl Plan {
    fn starts(&self) -> u64 {
        match (self.ring, self.grade) {
            (CONVENTIONAL, None) => TRANSITION_STARTS,
            _ => STARTS,
        }
    }

    /// Steps of all starts.
    fn steps(&self) -> f64 {
        self.starts() as f64 * self.case.solver.steps()
    }

    fn settled_after_s(&self) -> f64 {
        self.case.solver.duration_s / 2.0
    }

    /// The case of start `start`, with its own lot of balls.
    fn start(&self, start: u64) -> Result<Case, StudyError> {
        let mut case = self.case.clone();
        if let Some(grade) = self.grade {
            let lot = ball_lot_m(grade, case.bearing.balls(), SEED, start);
            case.bearing = case.bearing.with_ball_radius_deviations(lot)?;
        }
        case.start = Start::new(
            StartState::Settled,
            Gaps::List(bunched_gaps_rad(&case, start)),
            case.start.lead_ball_angle_rad,
        );
        cageless::step_limits::check(&case)?;
        Ok(case)
    }
}

/// Gaps of [`BUNCHES`] bunches: the places between them are drawn at random and share what the
/// gaps within the bunches leave.
fn bunched_gaps_rad(case: &Case, start: u64) -> Vec<f64> {
    let n = case.bearing.balls();
    let drawn = Gaps::uneven_rad(&case.bearing, SEED, start);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| drawn[*b].total_cmp(&drawn[*a]));
    let within = GAP_IN_BUNCH_DEG.to_radians();
    let room = n as f64 * case.bearing.mean_gap_rad() - (n - BUNCHES) as f64 * within;
    let mut gaps = vec![within; n];
    for k in &order[..BUNCHES] {
        gaps[*k] = room / BUNCHES as f64;
    }
    gaps
}

/// Mean orbital frequency of the balls in the part of a run that is not discarded.
struct OrbitMeter {
    after_s: f64,
    first: Option<[f64; 2]>,
    last: [f64; 2],
    until_s: f64,
}

impl OrbitMeter {
    fn new(after_s: f64, until_s: f64) -> Self {
        Self {
            after_s,
            first: None,
            last: [f64::NAN; 2],
            until_s,
        }
    }

    fn orbit_hz(&self) -> Option<f64> {
        let [from_s, from] = self.first?;
        let [to_s, to] = self.last;
        Some((to - from) / (to_s - from_s) / TAU)
    }
}

impl Observer for OrbitMeter {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let time_s = view.step.t1_s;
        if time_s >= self.after_s && (self.first.is_none() || time_s >= self.until_s) {
            let balls = view.layout().balls;
            let mean = (0..balls).map(|k| view.angle_after_rad(k)).sum::<f64>() / balls as f64;
            self.last = [time_s, mean];
            self.first.get_or_insert(self.last);
        }
        Ok(Control::Continue(()))
    }
}

/// Runs every start of a combination, side by side.
fn outcomes(plan: &Plan, progress: &Work<'_>, units: f64) -> Result<Vec<Outcome>, StudyError> {
    let cases: Vec<Case> = (0..plan.starts())
        .map(|k| plan.start(k))
        .collect::<Result<_, _>>()?;
    let mut outcomes = vec![];
    for members in batches(&cases) {
        let together: Vec<&Case> = members.iter().map(|k| &cases[*k]).collect();
        let share = units * together.len() as f64 / cases.len() as f64;
        outcomes.extend(side_by_side(&together, plan, progress, share)?);
    }
    Ok(outcomes)
}

fn side_by_side(
    cases: &[&Case],
    plan: &Plan,
    progress: &Work<'_>,
    units: f64,
) -> Result<Vec<Outcome>, StudyError> {
    let (duration_s, after_s) = (plan.case.solver.duration_s, plan.settled_after_s());
    let housing = housing(&plan.case)?;
    let recorders = |_: &&Case| {
        let vibration = VibrationRecorder::new(housing, SAMPLING_HZ, 0.0);
        let quiet = VibrationRecorder::without_contacts(housing, SAMPLING_HZ, after_s);
        (vibration, quiet, OrbitMeter::new(after_s, duration_s))
    };
    let mut recorders: Vec<_> = cases.iter().map(recorders).collect();
    let mut contacts: Vec<Vec<Collision>> = vec![vec![]; cases.len()];
    let ended = {
        let mut detectors: Vec<_> = contacts
            .iter_mut()
            .map(|contacts| CollisionDetector::new(keeping(contacts, |_| true)))
            .collect();
        let mut observers: Vec<Vec<&mut dyn Observer>> = (recorders.iter_mut())
            .zip(&mut detectors)
            .map(|((v, q, o), d)| vec![v as &mut dyn Observer, q, o, d])
            .collect();
        let ended = run_batch(
            cases,
            &mut observers,
            &mut progress.run_control(duration_s, units),
        );
        drop(observers);
        for detector in &mut detectors {
            detector.close(duration_s).map_err(StudyError::Rows)?;
        }
        ended
    };
    let load_zone_rad = load_zone_rad(&plan.case)?;
    let mut outcomes = vec![];
    for (k, (ended, (vibration, quiet, orbits))) in ended.into_iter().zip(&recorders).enumerate() {
        let ended = ended?;
        StudyError::unless_complete(&ended.ending)?;
        let Some(orbit_hz) = orbits.orbit_hz() else {
            return crate::error::not_computed();
        };
        let recorded = Recorded {
            ended: &ended,
            vertical: &vibration.measurements()[1],
            quiet: &quiet.measurements()[1],
            orbit_hz,
            contacts: &contacts[k],
        };
        outcomes.push(outcome(cases[k], &recorded, load_zone_rad)?);
    }
    Ok(outcomes)
}

fn values(outcomes: &[Outcome], of: impl Fn(&Outcome) -> f64) -> Vec<f64> {
    outcomes.iter().map(of).collect()
}

fn estimate(outcomes: &[Outcome], of: impl Fn(&Outcome) -> f64) -> Option<Estimate> {
    Estimate::new(&values(outcomes, of))
}

/// Numbers of a ring of which `of` estimates each.
fn numbers(
    of: impl Fn(fn(&Outcome) -> f64) -> Option<Estimate>,
) -> Result<RingNumbers, StudyError> {
    let of = |number| of(number).ok_or_else(no_value);
    Ok(RingNumbers {
        rms_m_s2: of(|o| o.mean_square.sqrt())?,
        rms_at_passing_m_s2: of(|o| o.at_passing.sqrt())?,
        rms_between_m_s2: of(|o| o.between.sqrt())?,
        rms_without_contacts_m_s2: of(|o| o.without_contacts)?,
        rms_from_contacts_m_s2: of(|o| o.from_contacts)?,
        gap_deviation_deg: of(|o| o.gap_deviation_deg)?,
        contacts_per_s: of(|o| o.contacts_per_s)?,
        impulse_rate_n: of(|o| o.impulse_rate_n)?,
    })
}

fn cell(
    plan: &Plan,
    all: &[Outcome],
    conventional: Option<&Vec<Outcome>>,
) -> Result<ComparisonCell, StudyError> {
    let outcomes = &all[..STARTS as usize];
    let difference = conventional.map(|conventional| {
        numbers(|of| Estimate::of_differences(&values(outcomes, of), &values(conventional, of)))
    });
    let changed_since = |first: usize| {
        let change = |of: fn(&Stretch) -> f64| {
            estimate(outcomes, |o| {
                of(&o.stretches[STRETCHES - 1]) - of(&o.stretches[first])
            })
            .ok_or_else(no_value)
        };
        Ok::<_, StudyError>(RecordChange {
            rms_m_s2: change(|s| s.rms_m_s2)?,
            contacts_per_s: change(|s| s.contacts_per_s)?,
            impulse_rate_n: change(|s| s.impulse_rate_n)?,
        })
    };
    let raceway = plan.case.raceways.first();
    Ok(ComparisonCell {
        speed_rpm: plan.rpm,
        lot: (plan.grade).map_or("equal balls".to_owned(), |g| format!("G{}", g.number)),
        lot_diameter_variation_um: plan.grade.map_or(0.0, |g| g.lot_variation_m) * 1e6,
        ring: plan.ring.to_owned(),
        raceway: raceway.map(|one| RacewayLabel::new("", Some(one))),
        numbers: numbers(|of| estimate(outcomes, of))?,
        approach_speed_m_s: estimate(outcomes, |o| o.approach_speed_m_s),
        impulse_n_s: estimate(outcomes, |o| o.impulse_n_s),
        transition_density: [0, 1, 2].map(|part| {
            estimate(all, |o| {
                let [found, chance] = o.transition_shares[part];
                found / chance
            })
        }),
        last_quarter_less: [changed_since(0)?, changed_since(1)?],
        difference: difference.transpose()?,
    })
}

fn no_value() -> StudyError {
    StudyError::Input("a start of the comparison of rings gave no number".to_owned())
}

fn source(plans: &[Plan]) -> Provenance {
    let case = &plans[0].case;
    let mut steps: Vec<f64> = plans.iter().map(|p| p.case.solver.step_s * 1e6).collect();
    steps.sort_by(f64::total_cmp);
    steps.dedup();
    let steps: Vec<String> = steps
        .into_iter()
        .map(cageless_results::number_text::short)
        .collect();
    let durations = SPEEDS.map(|s| format!("{} s at {} rpm", s.duration_s, s.rpm));
    Provenance {
        case: "Zhao 2022, experiment: 1.5 kN".to_owned(),
        method: Some(format!("velocity Verlet, step {} µs", steps.join(" to "))),
        step_us: None,
        ..provenance(
            "",
            case,
            format!(
                "the first half of {}; {}",
                durations.join(" and "),
                filter_note(case)
            ),
        )
    }
}

#[cfg(test)]
mod tests;
