//! Results of rings side by side, with the differences that are significant.

use cageless_io::estimate::{Change, Estimate};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use serde_json::Value;

use cageless_results::{Aim, LimitJudgement, Quantity};

use super::benefit::is_asked;
use super::differing_keys::{DifferingKey, differing_keys};
use super::left_out::LeftOut;
use super::ring_results::{RingResults, compared};
use super::{Benefit, Draws, RingVerdict};

/// Names of the results on aims and costs of a discrete raceway, in the order of the verdict.
const SUBJECT: [&str; 17] = [
    "contact_rate_hz",
    "contact_rate_above_0_1_m_s_hz",
    "contact_rate_above_0_5_m_s_hz",
    "impulse_rate_n",
    "gap_deviation_deg",
    "gap_min_deg",
    "outer_ring_force_deviation_n",
    "turning_force_n",
    "passing_force_n",
    "vibration_rms_m_s2",
    "ball_pressure_max_mpa",
    "transient_ball_pressure_mpa",
    "power_loss_ball_friction_w",
    "power_loss_w",
    "ball_wear_kn_m_h",
    "l10r_at_speed_h",
    "basic_static_rating_n",
];

/// Name and unit of a result.
fn named<S: Serializer>(quantity: &Quantity, serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(2))?;
    map.serialize_entry("name", quantity.name)?;
    map.serialize_entry("unit", &quantity.unit_text())?;
    map.end()
}

/// Whether no ring has a limit.
fn has_none(limits: &[LimitJudgement]) -> bool {
    limits
        .iter()
        .all(|of_ring| *of_ring == LimitJudgement::default())
}

/// A scalar result of every ring.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ComparedResult {
    /// The result.
    #[serde(flatten, serialize_with = "named")]
    pub quantity: &'static Quantity,
    /// Means over the starts in the order of the rings; `None` where a ring has none.
    pub values: Vec<Option<Estimate>>,
    /// Differences from the first ring, start by start; `None` for that itself.
    pub differences: Vec<Option<Estimate>>,
    /// Whether a ring is better than the first: only where the two cases differ in nothing but
    /// the raceway, the difference is significant, and one direction is better.
    pub better: Vec<Option<bool>>,
}

impl ComparedResult {
    /// Whether it is asked of a remedy, or a ring differs from the first by more than its error; of single runs, at
    /// all.
    pub fn is_telling(&self) -> bool {
        let differs = |difference: &Estimate| match difference.starts {
            0 | 1 => difference.mean != 0.0,
            _ => difference.change() != Change::Undecided,
        };
        is_asked(self.quantity.name) || self.differences.iter().flatten().any(differs)
    }
}

/// Rings side by side: `compare --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RingComparison {
    /// Names of the rings; differences are from the first.
    pub runs: Vec<String>,
    /// Draws of each ring.
    pub draws: Draws,
    /// Benefit of each ring against the first, `None` of that itself and of finished runs.
    pub benefits: Vec<Option<Benefit>>,
    /// Verdicts in the order of the rings: whether single balls are slowed as intended.
    pub verdicts: Vec<RingVerdict>,
    /// Limits of the case of each ring on its means.
    #[serde(skip_serializing_if = "has_none")]
    pub limits: Vec<LimitJudgement>,
    /// Keys in which the cases differ; none where all were made from one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub differing_keys: Vec<DifferingKey>,
    /// Changes by the rings, in sentences; of finished runs, how they were run.
    pub statement: String,
    /// Rings that could not be compared.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<LeftOut>,
    /// Scalar results.
    pub results: Vec<ComparedResult>,
}

impl RingComparison {
    /// Differences of rings; the first is what the others are compared with.
    pub fn new(rings: &[RingResults], draws: Draws) -> Self {
        let alike: Vec<bool> = rings
            .iter()
            .map(|ring| {
                let cases = rings[0].apart_from_remedies.as_ref();
                cases.is_some() && cases == ring.apart_from_remedies.as_ref()
            })
            .collect();
        let results = compared().filter_map(|quantity| {
            let of = |ring: &RingResults| ring.of(quantity.name).to_vec();
            let values: Vec<Vec<f64>> = rings.iter().map(of).collect();
            let means: Vec<_> = values.iter().map(|v| Estimate::new(v)).collect();
            means.iter().any(Option::is_some).then(|| {
                let difference = |k: usize| {
                    let other = (k > 0).then_some(&values[k])?;
                    Estimate::of_differences(other, &values[0])
                };
                let differences: Vec<_> = (0..rings.len()).map(difference).collect();
                let better = differences.iter().zip(&alike).map(|(difference, alike)| {
                    let low = match difference.filter(|_| *alike)?.change() {
                        Change::Undecided => return None,
                        change => change == Change::Lower,
                    };
                    Some(low == (quantity.aim? == Aim::Low))
                });
                ComparedResult {
                    quantity,
                    better: better.collect(),
                    values: means,
                    differences,
                }
            })
        });
        let statement = |benefits: &[Option<Benefit>]| {
            let headlines = benefits
                .iter()
                .flatten()
                .map(|b| format!("{}.", b.headline));
            headlines.collect::<Vec<_>>().join(" ")
        };
        let benefits: Vec<Option<Benefit>> = (rings.iter().enumerate())
            .map(|(k, ring)| (k > 0 && draws.grade.is_some()).then(|| Benefit::of(ring, &rings[0])))
            .collect();
        Self {
            limits: rings.iter().map(RingResults::limited).collect(),
            runs: rings.iter().map(|ring| ring.name.clone()).collect(),
            statement: match draws.grade {
                Some(_) => statement(&benefits),
                None => draws.text(),
            },
            left_out: vec![],
            benefits,
            differing_keys: vec![],
            draws,
            verdicts: rings.iter().map(|ring| ring.verdict.clone()).collect(),
            results: results.collect(),
        }
    }

    /// The comparison with the keys in which the cases of its rings differ, by their documents as JSON.
    pub fn of_cases(self, documents: &[Value]) -> Self {
        Self {
            differing_keys: differing_keys(documents),
            ..self
        }
    }

    /// Results on aims and costs of a raceway, in the order of the verdict.
    pub fn subject(&self) -> Vec<&ComparedResult> {
        let of = |name: &&str| {
            self.results
                .iter()
                .find(|result| result.quantity.name == *name)
        };
        SUBJECT.iter().filter_map(of).collect()
    }

    /// [`Self::subject`] with the change of the scatter over time.
    pub fn subject_over_time(&self) -> Vec<&ComparedResult> {
        let mut all = self.subject();
        let change = |result: &&ComparedResult| result.quantity.name == "gap_deviation_change_deg";
        if let (Some(change), false) = (self.results.iter().find(change), all.is_empty()) {
            all.insert(1, change);
        }
        all
    }

    /// Rows for readers: result, value of the first ring, then value, difference and judgement of
    /// each other ring, unit.
    pub fn rows<'r>(&self, results: impl Iterator<Item = &'r ComparedResult>) -> Vec<Vec<String>> {
        // A mean over some of the draws is none over all.
        let count = self.draws.count;
        let row = |result: &ComparedResult| {
            let (factor, unit) = result.quantity.printed();
            let scaled = |value: Option<Estimate>| value.map(|v| v.times(factor));
            let text = |value| match scaled(value) {
                None => "–".to_owned(),
                Some(v) if (v.starts as u64) < count => {
                    format!("{} ({} of {count})", v.text(), v.starts)
                }
                Some(v) => v.text(),
            };
            let mut row = vec![result.quantity.label.to_owned(), text(result.values[0])];
            for k in 1..self.runs.len() {
                row.push(text(result.values[k]));
                row.push(signed(scaled(result.differences[k])));
                row.push(judged(result.better[k]).to_owned());
            }
            row.push(unit);
            row
        };
        results.map(row).collect()
    }

    /// Headings of [`Self::rows`].
    pub fn headings(&self) -> Vec<String> {
        let mut head = vec!["result".to_owned(), self.runs[0].clone()];
        for name in &self.runs[1..] {
            head.extend([name.clone(), "difference".to_owned(), String::new()]);
        }
        head.push("unit".to_owned());
        head
    }
}

fn signed(value: Option<Estimate>) -> String {
    match value {
        None => "–".to_owned(),
        Some(v) if v.mean == 0.0 => "0".to_owned(),
        Some(v) if v.mean > 0.0 => format!("+{}", v.text()),
        Some(v) => v.text(),
    }
}

fn judged(better: Option<bool>) -> &'static str {
    match better {
        Some(true) => "better",
        Some(false) => "worse",
        None => "",
    }
}

#[cfg(test)]
mod tests {
    use cageless_io::case_file::CaseFile;
    use serde_json::Map;

    use super::*;

    #[test]
    fn every_subject_is_a_result() {
        for name in SUBJECT {
            assert!(compared().any(|known| known.name == name), "{name}");
        }
    }

    fn ring(
        name: &str,
        raceway: bool,
        load: f64,
        gaps: [f64; 4],
        collisions: [f64; 4],
    ) -> RingResults {
        let conventional = cageless_io::case_file::template(!raceway);
        let set = [format!("operation.radial_load_n={load}")];
        let file = CaseFile::parse(&conventional, "case", &set).unwrap();
        let starts: Vec<Vec<(&'static str, f64)>> = (0..4)
            .map(|k| {
                vec![
                    ("gap_deviation_deg", gaps[k]),
                    ("collisions", collisions[k]),
                ]
            })
            .collect();
        let verdict = RingVerdict::of_summary(&Map::new());
        RingResults::of_draws(name, &file, &starts, verdict)
    }

    fn draws() -> Draws {
        let file = CaseFile::parse(&cageless_io::case_file::template(false), "case", &[]).unwrap();
        Draws::of(&file, crate::comparison::Sampling::Draws(4))
    }

    /// The scatter falls by 0.6 ± 0.01 in pairs whose own scatter is 0.2; contacts scatter.
    #[test]
    fn only_what_follows_from_the_raceway_is_better() {
        let conventional = ring(
            "conventional",
            false,
            1500.0,
            [0.6, 0.8, 1.0, 1.2],
            [9.0, 11.0, 10.0, 30.0],
        );
        let a = ring(
            "A",
            true,
            1500.0,
            [0.0, 0.21, 0.4, 0.59],
            [10.0, 9.0, 25.0, 14.0],
        );
        let comparison = RingComparison::new(&[conventional.clone(), a], draws());
        let found = |name: &str| {
            comparison
                .results
                .iter()
                .find(|r| r.quantity.name == name)
                .unwrap()
        };
        assert_eq!(found("gap_deviation_deg").better, [None, Some(true)]);
        assert_eq!(found("collisions").better, [None, None]);
        // Another load: whatever differs does not follow from the raceway.
        let b = ring(
            "B",
            true,
            1000.0,
            [0.0, 0.2, 0.4, 0.6],
            [9.0, 11.0, 10.0, 30.0],
        );
        let comparison = RingComparison::new(&[conventional, b], draws());
        assert!(comparison.results.iter().all(|r| r.better[1].is_none()));
    }

    /// A result that some starts lack says over how many its mean is.
    #[test]
    fn a_mean_over_some_of_the_starts_says_so() {
        let of = |gaps| ring("A", true, 1500.0, gaps, [1.0, 2.0, 3.0, 4.0]);
        let part = [0.2, f64::NAN, 0.4, f64::NAN];
        let comparison = RingComparison::new(&[of([0.1, 0.3, 0.1, 0.3]), of(part)], draws());
        let rows = comparison.rows(comparison.results.iter());
        let gaps = rows.iter().find(|row| row[0].contains("gaps")).unwrap();
        assert_eq!(gaps[1..3], ["0.200 ± 0.058", "0.30 ± 0.10 (2 of 4)"]);
        let whole = rows
            .iter()
            .find(|row| row[0].contains("collisions"))
            .unwrap();
        assert!(!whole[2].contains("of"), "{whole:?}");
    }

    /// A result that a start lacks takes part in no mean and no difference.
    #[test]
    fn a_result_that_a_start_lacks_is_left_out() {
        let file = CaseFile::parse(&cageless_io::case_file::template(false), "case", &[]).unwrap();
        let of = |starts: &[Vec<(&'static str, f64)>]| {
            RingResults::of_draws("A", &file, starts, RingVerdict::of_summary(&Map::new()))
        };
        let (gaps, loss) = ("gap_deviation_deg", "power_loss_w");
        let first = of(&[
            vec![(gaps, 3.0), (loss, 10.0)],
            vec![(gaps, 5.0)],
            vec![(gaps, 4.0), (loss, 14.0)],
            vec![(loss, 18.0)],
        ]);
        let second = of(&[
            vec![(loss, 11.0), (gaps, 2.0)],
            vec![(loss, 13.0), (gaps, 7.0)],
            vec![(loss, 12.0)],
            vec![(loss, 20.0), (gaps, 1.0)],
        ]);
        let comparison = RingComparison::new(&[first, second], draws());
        let all = || comparison.results.iter();
        let found = |name: &str| all().find(|r| r.quantity.name == name).unwrap();
        let close = |estimate: Option<Estimate>, mean: f64, starts: usize| {
            let found = estimate.unwrap();
            let alike = (found.mean - mean).abs() < 1e-12;
            assert!(alike && found.starts == starts, "{found:?} {mean}");
        };
        let (gaps, loss) = (found(gaps), found(loss));
        close(gaps.values[0], 4.0, 3);
        close(gaps.values[1], 10.0 / 3.0, 3);
        close(loss.values[0], 14.0, 3);
        // Start by start, over those that have both: 2 − 3 and 7 − 5; 11 − 10, 12 − 14 and 20 − 18.
        close(gaps.differences[1], 0.5, 2);
        close(loss.differences[1], 1.0 / 3.0, 3);
    }

    /// Rows for readers have the units of `run`: torque in N·mm.
    #[test]
    fn rows_have_the_units_of_readers() {
        let summary =
            |torque: f64| Map::from_iter([("friction_torque_n_m".to_owned(), torque.into())]);
        let rings = [
            RingResults::of_summary("A", &summary(2.5e-3)),
            RingResults::of_summary("B", &summary(1.5e-3)),
        ];
        let comparison = RingComparison::new(&rings, Draws::finished());
        let torque = |r: &&ComparedResult| r.quantity.name == "friction_torque_n_m";
        let rows = comparison.rows(comparison.results.iter().filter(torque));
        assert_eq!(rows[0][1..], ["2.5", "1.5", "\u{2212}1", "", "N·mm"]);
    }

    #[test]
    fn single_runs_are_not_judged() {
        let summary = |loss: f64| Map::from_iter([("power_loss_w".to_owned(), loss.into())]);
        let rings = [
            RingResults::of_summary("A", &summary(1.0)),
            RingResults::of_summary("B", &summary(0.5)),
        ];
        let comparison = RingComparison::new(&rings, Draws::finished());
        assert_eq!(comparison.results[0].better, [None, None]);
        assert_eq!(comparison.results[0].differences[1].unwrap().mean, -0.5);
        assert!(comparison.statement.contains("keep their gaps"));
    }

    /// Student's limit at 5 % with 7 degrees of freedom is 2.365: 2.4 standard errors tell, 2.3 do not.
    #[test]
    fn a_result_tells_by_its_difference() {
        let result = |name: &str, mean: f64, starts| ComparedResult {
            quantity: compared().find(|quantity| quantity.name == name).unwrap(),
            values: vec![None, None],
            differences: vec![
                None,
                Some(Estimate {
                    mean,
                    standard_error: 1.0,
                    starts,
                }),
            ],
            better: vec![None, None],
        };
        for (name, mean, starts, telling) in [
            ("power_loss_w", 2.4, 8, true),
            ("power_loss_w", -2.4, 8, true),
            ("power_loss_w", 2.3, 8, false),
            ("power_loss_w", 0.1, 1, true),
            ("power_loss_w", 0.0, 1, false),
            ("gap_deviation_deg", 0.0, 8, true),
        ] {
            let found = result(name, mean, starts).is_telling();
            assert_eq!(found, telling, "{name} {mean} {starts}");
        }
    }
}
