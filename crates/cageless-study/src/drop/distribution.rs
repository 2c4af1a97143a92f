//! Distributions over drops whose conditions scatter.

use cageless::FrictionParameters;
use cageless::numerics::wilson_interval;
use cageless::touchdown::{DrawnBearing, EndState};
use cageless_design::tolerance::SampleCount;
use cageless_io::OptionError;
use serde::Serialize;

use crate::StudyError;
use cageless_results::{DROP, DropResult, Kind, ROTOR_DROP, end_state_text};

use super::Quantiles;
use super::length::micrometres;

/// Most drops of an ensemble.
pub const DROPS_MAX: u64 = 1_000_000;

/// Distributions of the results of one bearing over completed drops.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Distribution {
    /// How often each state came out at the end.
    pub end_states: Vec<EndStateCount>,
    /// Probability of backward whirl in this bearing, at any time.
    #[serde(flatten)]
    pub backward_whirl: WhirlProbability,
    /// Distributions of the scalar results; empty if a drop stopped.
    pub quantiles: Vec<Quantiles>,
}

/// Probability that a drop fails by backward whirl, at any time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct WhirlProbability {
    /// Fraction of the drops; `None` if one stopped, or without any.
    #[serde(rename = "backward_whirl_probability")]
    pub fraction: Option<f64>,
    /// 95 % interval (Wilson 1927), however the drops that stopped would end.
    #[serde(rename = "backward_whirl_interval")]
    pub interval: Option<[f64; 2]>,
}

/// Probability that a drop passes its verdict.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PassProbability {
    /// Fraction of the drops; `None` if one was not judged.
    #[serde(rename = "pass_probability")]
    pub fraction: Option<f64>,
    /// 95 % interval (Wilson 1927), however the drops that were not judged would end.
    #[serde(rename = "pass_interval")]
    pub interval: Option<[f64; 2]>,
    /// How many pass.
    #[serde(skip)]
    pub count: SampleCount,
}

/// How often a state came out.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EndStateCount {
    /// State.
    pub end_state: String,
    /// Drops.
    pub count: usize,
}

impl Distribution {
    /// Distributions of the results as a table for readers, empty without any; the first row is the head.
    pub fn rows(&self) -> Vec<Vec<String>> {
        if self.quantiles.is_empty() {
            return vec![];
        }
        let head = ["result", "least", "median", "95 %", "most", "unit"];
        let mut rows = vec![head.map(str::to_owned).to_vec()];
        let shown = self.quantiles.iter().filter(|q| q.quantity.in_tables);
        rows.extend(shown.map(Quantiles::row));
        rows
    }
}

/// One bearing in one drop of an ensemble.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BearingRow {
    /// Friction coefficient between rotor and inner ring.
    pub rotor_friction: f64,
    /// μs of the Stribeck law there; `None` of any other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rotor_static_friction: Option<f64>,
    /// Points of sliding speed, m/s, and μ there; `None` without a table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rotor_friction_table: Option<Vec<[f64; 2]>>,
    /// Friction coefficient of the balls.
    pub ball_friction: f64,
    /// μs of the Stribeck law of the balls; `None` of any other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball_static_friction: Option<f64>,
    /// Points of sliding speed, m/s, and μ of the balls; `None` without a table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball_friction_table: Option<Vec<[f64; 2]>>,
    /// Radial air gap, µm.
    pub radial_clearance_um: f64,
    /// Damping of the support, N·s/m; `None` without a support.
    pub support_damping_n_s_m: Option<f64>,
    /// Place of ball 1 at the start, degrees; `None` if it is not drawn.
    pub lead_ball_angle_deg: Option<f64>,
    /// Gaps of the balls to the next at the start, degrees; `None` if they are not drawn.
    pub gaps_deg: Option<Vec<f64>>,
    /// Results.
    pub result: DropResult,
}

impl BearingRow {
    pub(super) fn new(drawn: &DrawnBearing, result: DropResult) -> Self {
        let arrangement = drawn.arrangement_rad.as_ref();
        let (rotor, balls) = (&drawn.rotor_friction, &drawn.ball_friction);
        let points = |friction: &FrictionParameters| {
            let table = friction.table.as_ref();
            table.map(|table| table.points().to_vec())
        };
        Self {
            rotor_friction: rotor.coefficient,
            rotor_static_friction: rotor.static_coefficient,
            rotor_friction_table: points(rotor),
            ball_friction: balls.coefficient,
            ball_static_friction: balls.static_coefficient,
            ball_friction_table: points(balls),
            radial_clearance_um: micrometres(drawn.radial_clearance_m),
            support_damping_n_s_m: drawn.support_damping_n_s_m,
            lead_ball_angle_deg: arrangement.map(|(_, lead_rad)| lead_rad.to_degrees()),
            gaps_deg: arrangement
                .map(|(gaps_rad, _)| gaps_rad.iter().map(|g| g.to_degrees()).collect()),
            result,
        }
    }
}

/// Checks the number of drops.
///
/// # Errors
/// [`StudyError::Option`].
pub fn check_drops(option: &'static str, count: u64) -> Result<(), StudyError> {
    if (1..=DROPS_MAX).contains(&count) {
        return Ok(());
    }
    let allowed = format!("from 1 to {DROPS_MAX}");
    Err(OptionError::not_possible(option, count, &allowed).into())
}

/// Fraction of `yes` of `decided` drops, none where others are open, and its 95 % interval however those would end;
/// none without a decided one.
fn proportion(yes: usize, decided: usize, open: usize) -> (Option<f64>, Option<[f64; 2]>) {
    let all = decided + open;
    let interval = || {
        let [least, most] = [yes, yes + open].map(|count| wilson_interval(count, all));
        [least[0], most[1]]
    };
    (
        (decided > 0 && open == 0).then(|| yes as f64 / decided as f64),
        (decided > 0).then(interval),
    )
}

/// Percentages: "10.0 % (95 %: 0.6 to 40.4 %)", where drops are open the interval alone.
fn percent(fraction: Option<f64>, interval: Option<[f64; 2]>) -> Option<String> {
    let [low, high] = interval?.map(|p| 1e2 * p);
    Some(match fraction {
        Some(p) => format!("{:.1} % (95 %: {low:.1} to {high:.1} %)", 1e2 * p),
        None => format!("{low:.1} to {high:.1} % (95 %)"),
    })
}

impl WhirlProbability {
    /// The probability where `whirls` of `completed` drops do and `stopped` others might.
    pub(super) fn new(whirls: usize, completed: usize, stopped: usize) -> Self {
        let (fraction, interval) = proportion(whirls, completed, stopped);
        Self { fraction, interval }
    }

    /// Percentages; `None` without a completed drop.
    pub fn percent(&self) -> Option<String> {
        percent(self.fraction, self.interval)
    }
}

impl PassProbability {
    /// The probability from the verdict on each drop.
    pub(super) fn new(verdicts: impl Iterator<Item = Option<bool>>) -> Self {
        let [mut passes, mut fails, mut open] = [0; 3];
        for verdict in verdicts {
            match verdict {
                Some(true) => passes += 1,
                Some(false) => fails += 1,
                None => open += 1,
            }
        }
        let (fraction, interval) = proportion(passes, passes + fails, open);
        let count = SampleCount {
            passed: passes,
            count: passes + fails + open,
            open,
        };
        Self {
            fraction,
            interval,
            count,
        }
    }

    /// How many of the drops pass, and what keeps them from deciding.
    pub fn text(&self) -> String {
        const WHAT: &str = "scattered drops";
        let open = self.count.why_open(WHAT);
        self.count.text(WHAT) + &open.map_or(String::new(), |why| format!("; {why}"))
    }

    /// Percentages; `None` where no drop was judged.
    pub fn percent(&self) -> Option<String> {
        percent(self.fraction, self.interval)
    }
}

/// Whether a drop fails by backward whirl.
pub(super) fn whirls_backward(drop: &DropResult) -> bool {
    drop.results.value("backward_whirl_hz").is_some()
}

impl Distribution {
    /// The distribution over the results of completed drops; so many others stopped.
    pub(super) fn new(complete: &[&DropResult], stopped: usize) -> Self {
        let count = |state: EndState| {
            let ended = |d: &&&DropResult| d.end_state() == state.name();
            complete.iter().filter(ended).count()
        };
        Self {
            end_states: (EndState::ALL.into_iter())
                .map(|state| EndStateCount {
                    end_state: state.name().to_owned(),
                    count: count(state),
                })
                .filter(|entry| entry.count > 0)
                .collect(),
            backward_whirl: WhirlProbability::new(
                complete.iter().filter(|drop| whirls_backward(drop)).count(),
                complete.len(),
                stopped,
            ),
            quantiles: match stopped {
                0 => quantiles(complete),
                _ => vec![],
            },
        }
    }

    /// "7 intermittent contact, 1 backward whirl".
    pub fn end_states_text(&self) -> String {
        let states: Vec<String> = (self.end_states.iter())
            .map(|entry| format!("{} {}", entry.count, end_state_text(&entry.end_state)))
            .collect();
        states.join(", ")
    }
}

fn quantiles(complete: &[&DropResult]) -> Vec<Quantiles> {
    let numbers =
        (DROP.iter().chain(ROTOR_DROP)).filter(|q| matches!(q.kind, Kind::Number | Kind::Integer));
    numbers
        .filter_map(|quantity| Quantiles::new(quantity, complete))
        .collect()
}
