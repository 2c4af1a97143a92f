//! Many drops whose conditions scatter.

use cageless::simulation::RotorDrop;
use cageless::touchdown::{Drawn, Scatter};
use rayon::prelude::*;
use serde::Serialize;

use cageless_results::{DropResult, DropRun};

use super::distribution::whirls_backward;
use super::length::micrometres;
use super::record::steps;
use super::side_by_side::{drop_task, run_drops, worth_together};
use super::{BearingRow, Distribution, FiledDrop, PassProbability, WhirlProbability, check_drops};
use crate::StudyError;
use crate::progress::{Progress, Work};
use crate::task::Task;
use crate::threads::groups_of;

/// Drops whose conditions scatter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Ensemble {
    /// Seed of the draws: that of the case of the first bearing.
    pub seed: u64,
    /// Drops that ran to their end.
    pub completed: usize,
    /// Drops that stopped early, with the reasons.
    pub stopped: Vec<String>,
    /// Probability that a drop passes its verdict.
    #[serde(flatten)]
    pub passing: PassProbability,
    /// Probability of backward whirl in any bearing, at any time.
    #[serde(flatten)]
    pub in_any_bearing: WhirlProbability,
    /// Distributions of the results of each bearing over the completed drops.
    pub bearings: Vec<Distribution>,
    /// The drops, in the order of their numbers.
    pub drops: Vec<DropRow>,
}

impl Ensemble {
    /// Number of drops that stopped, the reason of the first, and what lacks a result for it; `None` if none did.
    pub fn stopped_text(&self) -> Option<String> {
        let first = self.stopped.first()?;
        Some(format!(
            "{} of {} drops stopped, the first {first}: the probability is that of all drops whichever way they \
             would have ended, and there are no quantiles",
            self.stopped.len(),
            self.drops.len(),
        ))
    }
}

/// One drop of an ensemble.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DropRow {
    /// Number of the drop, from 1.
    pub drop: u64,
    /// Direction of the unbalance of the rotor of a case at the start, degrees; `None` of another.
    pub eccentricity_phase_deg: Option<f64>,
    /// Angle by which all unbalances of a linear rotor are turned at the start, degrees; `None` of another.
    pub unbalance_turn_deg: Option<f64>,
    /// Mass centre at the start, µm; `None` if it is not drawn.
    pub x_um: Option<f64>,
    /// Mass centre at the start, µm; `None` if it is not drawn.
    pub y_um: Option<f64>,
    /// Energy balance error of the rotor alone, relative.
    pub rotor_energy_residual_relative: f64,
    /// Reason why the drop stopped early, if it did, with the bearing of several.
    pub stopped: Option<String>,
    /// Whether the drop passes its verdict; `None` if it was not judged.
    #[serde(skip)]
    pub passes: Option<bool>,
    /// The bearings.
    pub bearings: Vec<BearingRow>,
}

/// Name of the task of an ensemble.
const TASK: &str = "drops";

/// The task of [`ensemble`].
pub(super) fn task(drop: &RotorDrop, count: u64) -> Task {
    let (together, all) = (worth_together(drop), count as f64 * steps(drop));
    let pieces = count.div_ceil(together as u64) as usize;
    drop_task(Task::new(TASK), drop, count as usize, all, pieces)
}

/// Drops the rotor `count` times, on all threads; the result is the same on any number of them.
///
/// # Errors
/// A case is impossible, or the progress cancelled.
pub fn ensemble(
    filed: &FiledDrop<'_>,
    count: u64,
    scatter: &Scatter,
    progress: &dyn Progress,
) -> Result<Ensemble, StudyError> {
    check_drops("samples", count)?;
    let drop = &filed.drop;
    let work = progress.begin(TASK, count as f64 * steps(drop));
    let indices: Vec<u64> = (0..count).collect();
    let rows: Result<Vec<Vec<DropRow>>, StudyError> = groups_of(&indices, worth_together(drop))
        .map(|chunk| together(filed, chunk, scatter, &work))
        .collect();
    Ok(evaluate(
        drop.cases().len(),
        filed.seed(),
        rows?.into_iter().flatten().collect(),
    ))
}

fn together(
    filed: &FiledDrop<'_>,
    indices: &[u64],
    scatter: &Scatter,
    work: &Work<'_>,
) -> Result<Vec<DropRow>, StudyError> {
    let drop = &filed.drop;
    let scattered = |index: &u64| {
        let (scattered, drawn) = scatter.draw(drop, filed.seed(), *index);
        (filed.like(scattered), drawn)
    };
    let (drops, drawn): (Vec<FiledDrop<'_>>, Vec<Drawn>) = indices.iter().map(scattered).unzip();
    let duration_s = drop.cases()[0].solver.duration_s;
    let control = |drops: usize| work.run_control(duration_s, drops as f64 * steps(drop));
    let runs = run_drops(&drops, control).ok_or(StudyError::Interrupted)?;
    let rows = indices.iter().zip(&drawn).zip(runs);
    rows.map(|((index, drawn), run)| {
        let run = run.map_err(|error| StudyError::Input(error.to_string()))?;
        Ok(DropRow::new(*index + 1, drawn, run, drop.rotor().is_some()))
    })
    .collect()
}

impl DropRow {
    fn new(number: u64, drawn: &Drawn, run: DropRun, is_linear: bool) -> Self {
        let unbalance_deg = drawn.unbalance_rad.map(f64::to_degrees);
        let passes = run.judgement().passes();
        let centre_um = drawn.centre_m.map(|centre| centre.map(micrometres));
        let bearings = drawn.bearings.iter().zip(run.bearings);
        let bearings = bearings.map(|(drawn, result)| BearingRow::new(drawn, result));
        Self {
            drop: number,
            eccentricity_phase_deg: unbalance_deg.filter(|_| !is_linear),
            unbalance_turn_deg: unbalance_deg.filter(|_| is_linear),
            x_um: centre_um.map(|[x, _]| x),
            y_um: centre_um.map(|[_, y]| y),
            rotor_energy_residual_relative: run.rotor.energy_residual_relative,
            stopped: run.stopped,
            passes,
            bearings: bearings.collect(),
        }
    }

    /// Whether the drop fails by backward whirl in any of its bearings.
    fn whirls_backward(&self) -> bool {
        let mut results = self.bearings.iter().map(|bearing| &bearing.result);
        results.any(whirls_backward)
    }
}

/// The distributions of drops into so many bearings.
pub(super) fn evaluate(bearings: usize, seed: u64, drops: Vec<DropRow>) -> Ensemble {
    let complete: Vec<&DropRow> = drops.iter().filter(|d| d.stopped.is_none()).collect();
    let whirls = complete.iter().filter(|d| d.whirls_backward()).count();
    let stopped = drops.len() - complete.len();
    let of_bearing = |k: usize| {
        let results: Vec<&DropResult> = complete.iter().map(|d| &d.bearings[k].result).collect();
        Distribution::new(&results, stopped)
    };
    Ensemble {
        seed,
        completed: complete.len(),
        stopped: drops.iter().filter_map(|d| d.stopped.clone()).collect(),
        passing: PassProbability::new(drops.iter().map(|drop| drop.passes)),
        in_any_bearing: WhirlProbability::new(whirls, complete.len(), stopped),
        bearings: (0..bearings).map(of_bearing).collect(),
        drops,
    }
}
#[cfg(test)]
pub(super) mod tests {
    use cageless_results::{Cell, DROP, DropJudgement, Results};

    use super::*;

    /// A bearing of a drop with these results.
    pub(in crate::drop) fn bearing_with(results: &[(&str, Cell)]) -> BearingRow {
        BearingRow {
            rotor_friction: 0.1,
            rotor_static_friction: None,
            rotor_friction_table: None,
            ball_friction: 0.1,
            ball_static_friction: None,
            ball_friction_table: None,
            radial_clearance_um: 200.0,
            support_damping_n_s_m: None,
            lead_ball_angle_deg: None,
            gaps_deg: None,
            result: DropResult {
                results: Results::only(DROP, results),
                judgement: DropJudgement::default(),
                stopped: None,
                end_power: None,
                unheated: vec![],
                windows: vec![],
            },
        }
    }

    /// A bearing in which the rotor bounces, after a whirl or not.
    fn bearing(whirls: bool, force: f64) -> BearingRow {
        let mut results = vec![
            ("end_state", Cell::Text("bouncing".to_owned())),
            ("rotor_force_max_n", Cell::Number(force)),
        ];
        results.extend(whirls.then_some(("backward_whirl_hz", Cell::Number(80.0))));
        bearing_with(&results)
    }

    pub(in crate::drop) fn row(bearings: Vec<BearingRow>, stopped: Option<&str>) -> DropRow {
        DropRow {
            drop: 1,
            eccentricity_phase_deg: None,
            unbalance_turn_deg: None,
            x_um: None,
            y_um: None,
            rotor_energy_residual_relative: 0.0,
            stopped: stopped.map(str::to_owned),
            passes: None,
            bearings,
        }
    }

    #[test]
    fn a_whirl_in_any_bearing_counts_once_and_a_drop_that_stopped_leaves_it_open() {
        let (whirl, bounce) = (true, false);
        let drops = vec![
            row(vec![bearing(whirl, 1.0), bearing(whirl, 5.0)], None),
            row(vec![bearing(bounce, 3.0), bearing(whirl, 4.0)], None),
            row(vec![bearing(bounce, 2.0), bearing(bounce, 6.0)], None),
            row(vec![bearing(bounce, 2.5), bearing(bounce, 7.0)], None),
            row(
                vec![bearing(whirl, 9.0), bearing(whirl, 9.0)],
                Some("in bearing 1 at t = 0.1 s"),
            ),
        ];
        let many = evaluate(2, 3, drops);
        assert_eq!((many.seed, many.completed), (3, 4));
        assert_eq!(many.stopped, ["in bearing 1 at t = 0.1 s"]);
        // Nothing is the mean or a quantile of the rest: by Wilson 1927 from 2 of 5 to 3 of 5.
        let any = many.in_any_bearing;
        let [low, high] = any.interval.unwrap();
        assert!((low - 0.118).abs() < 1e-3 && (high - 0.882).abs() < 1e-3);
        assert_eq!(
            (any.fraction, any.percent().unwrap().as_str()),
            (None, "11.8 to 88.2 % (95 %)")
        );
        let bearings = [0, 1].map(|k: usize| &many.bearings[k]);
        assert!(bearings.iter().all(|b| b.backward_whirl.fraction.is_none()));
        assert!(
            bearings
                .iter()
                .all(|b| b.quantiles.is_empty() && b.rows().is_empty())
        );
        let text = many.stopped_text().unwrap();
        assert!(text.starts_with("1 of 5 drops stopped, the first in bearing 1 at t = 0.1 s"));

        let many = evaluate(2, 3, many.drops[..4].to_vec());
        assert_eq!(many.stopped_text(), None);
        assert_eq!(many.in_any_bearing.fraction, Some(0.5));
        let fractions = [0, 1].map(|k: usize| many.bearings[k].backward_whirl.fraction);
        assert_eq!(fractions, [Some(0.25), Some(0.5)]);
        let most = |k: usize| many.bearings[k].quantiles[0].most;
        assert_eq!([most(0), most(1)], [Some(3.0), Some(7.0)]);
        // Wilson 1927: 2 of 4.
        let [low, high] = many.in_any_bearing.interval.unwrap();
        assert!((low - 0.150).abs() < 1e-3 && (high - 0.850).abs() < 1e-3);
    }

    /// Results 0, 1, …, 20 of 21 drops have the median 10, and a twentieth of them lies above 19. An event that some drops
    /// have not seen lies beyond their time; another result that some lack has the quantiles of the others.
    #[test]
    fn quantiles_are_those_of_the_result_that_they_name() {
        let drops = (0..21u32).map(|k| {
            // In any order.
            let rank = f64::from(k * 8 % 21);
            let mut one = bearing(false, 1000.0 + 10.0 * rank);
            let mut values = vec![
                ("end_state", Cell::Text("bouncing".to_owned())),
                ("rotor_force_max_n", Cell::Number(1000.0 + 10.0 * rank)),
                ("inner_pressure_max_mpa", Cell::Number(rank * rank)),
                ("impacts", Cell::Integer(21 - rank as i64)),
            ];
            values.push(("simulated_s", Cell::Number(0.5)));
            // An event that a third has not seen, and what two thirds do not have.
            if rank < 14.0 {
                values.push(("spin_up_ms", Cell::Number(4.0 * rank)));
            }
            if rank < 7.0 {
                values.push(("backward_whirl_hz", Cell::Number(80.0 + rank)));
            }
            one.result.results = Results::only(DROP, &values);
            row(vec![one, bearing(false, 7.0)], None)
        });
        let many = evaluate(2, 0, drops.collect());
        let found = &many.bearings[0].quantiles;
        for (name, expected) in [
            ("rotor_force_max_n", [1000.0, 1100.0, 1190.0, 1200.0]),
            ("inner_pressure_max_mpa", [0.0, 100.0, 361.0, 400.0]),
            ("impacts", [1.0, 11.0, 20.0, 21.0]),
            ("spin_up_ms", [0.0, 40.0, f64::INFINITY, f64::INFINITY]),
            ("backward_whirl_hz", [80.0, 83.0, 85.7, 86.0]),
        ] {
            let q = found.iter().find(|q| q.quantity.name == name).unwrap();
            for (found, expected) in [q.least, q.median, q.high, q.most].iter().zip(expected) {
                assert!(
                    found.map_or(expected.is_infinite(), |found| (found - expected).abs()
                        < 1e-9),
                    "{name}: {found:?} {expected}"
                );
            }
        }
        assert_eq!(found.len(), 7);
        let row = |label: &str| {
            let rows = many.bearings[0].rows();
            rows.into_iter()
                .find(|row| row[0].starts_with(label))
                .unwrap()
        };
        assert_eq!(
            row("spin-up"),
            [
                "spin-up of the inner ring (14 of 21)",
                "0",
                "40",
                "> 500",
                "> 500",
                "ms"
            ]
        );
        assert_eq!(
            row("backward whirl")[0],
            "backward whirl round the bore, largest (7 of 21)"
        );
        let json = serde_json::to_value(&many.bearings[0].quantiles).unwrap();
        let spin_up = json
            .as_array()
            .unwrap()
            .iter()
            .find(|q| q["name"] == "spin_up_ms")
            .unwrap();
        let expected = serde_json::json!({"name": "spin_up_ms", "count": 14, "not_within": 500.0,
            "least": 0.0, "median": 40.0, "high": null, "most": null});
        assert_eq!(*spin_up, expected);
        let rows = many.bearings[0].rows();
        let pressure = found
            .iter()
            .position(|q| q.quantity.name == "inner_pressure_max_mpa");
        let shown = &rows[1 + pressure.unwrap()];
        assert_eq!(shown[1..], ["0", "100", "361", "400", "MPa"]);
        let other = &many.bearings[1].quantiles[0];
        assert_eq!(
            [other.least, other.median, other.high, other.most],
            [Some(7.0); 4]
        );
    }

    /// A drop that was not judged leaves the probability open; the verdict takes 95 % of all drops.
    #[test]
    fn the_probability_of_passing_is_that_of_the_verdicts() {
        let [yes, no, open] = [Some(true), Some(false), None];
        let of = |verdicts: &[Option<bool>]| PassProbability::new(verdicts.iter().copied());
        let found = of(&[yes, no, no, yes]);
        // Wilson 1927: 2 of 4.
        let [low, high] = found.interval.unwrap();
        assert_eq!(
            (found.fraction, found.count.passes()),
            (Some(0.5), Some(false))
        );
        assert!((low - 0.150).abs() < 1e-3 && (high - 0.850).abs() < 1e-3);
        // From 1 of 4 to 2 of 4.
        let found = of(&[yes, open, no, no]);
        let [low, high] = found.interval.unwrap();
        assert_eq!(found.fraction, None);
        assert!(
            (low - 0.046).abs() < 1e-3 && (high - 0.850).abs() < 1e-3,
            "{low} {high}"
        );
        assert_eq!(of(&[open]).percent(), None);
        assert_eq!(of(&[open]).count.passes(), None);
        let text = "12 of 12 scattered drops pass, probability of passing 100.0 % (95 % interval 75.8 to 100.0 %, \
                    95 % needed); at least 73 scattered drops are needed to show 95 %";
        assert_eq!(of(&[yes; 12]).text(), text);
        assert_eq!(of(&[yes; 73]).count.passes(), Some(true));
    }
}
