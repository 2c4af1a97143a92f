//! Results of rings side by side, with the differences that are significant.

use std::collections::BTreeMap;

use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_io::estimate::{Change, Estimate, SIGNIFICANCE};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use serde_json::{Map, Value};

use cageless_results::{Aim, COMPARED, Kind, Quantity, RUN};

use super::RingVerdict;

/// What a discrete raceway is there to change, and what it costs, in the order of the verdict.
const SUBJECT: [&str; 6] = [
    "gap_deviation_deg",
    "vibration_rms_m_s2",
    "outer_ring_force_deviation_n",
    "collisions",
    "power_loss_w",
    "ball_pressure_max_mpa",
];

/// Results that are compared.
fn compared() -> impl Iterator<Item = &'static Quantity> {
    let scalar = |q: &&Quantity| matches!(q.kind, Kind::Number | Kind::Integer);
    RUN.iter()
        .chain(COMPARED)
        .filter(|q| q.in_tables)
        .filter(scalar)
}

/// Name and unit of a result.
fn named<S: Serializer>(quantity: &Quantity, serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(2))?;
    map.serialize_entry("name", quantity.name)?;
    map.serialize_entry("unit", &quantity.unit_text())?;
    map.end()
}

/// Scalar results of a ring, a value for each start; of a finished run one.
#[derive(Debug, Clone, PartialEq)]
pub struct RingResults {
    name: String,
    /// The case without what does not change the motion and without its raceways.
    apart_from_raceway: Option<CaseDocument>,
    has_raceway: bool,
    verdict: RingVerdict,
    values: BTreeMap<String, Vec<f64>>,
}

impl RingResults {
    /// Results of a ring from its starts.
    pub(super) fn of_starts(
        name: &str,
        file: &CaseFile,
        starts: &[Vec<(&'static str, f64)>],
        verdict: RingVerdict,
    ) -> Self {
        let mut values: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for (k, start) in starts.iter().enumerate() {
            for (name, value) in start {
                let all = values.entry((*name).to_owned());
                // A result that this start lacks is no number.
                let all = all.or_insert_with(|| vec![f64::NAN; starts.len()]);
                all[k] = *value;
            }
        }
        Self {
            name: name.to_owned(),
            apart_from_raceway: Some(file.apart_from_raceway()),
            has_raceway: !file.case().raceways.is_empty(),
            verdict,
            values,
        }
    }

    /// Results of one run from its `summary.json`.
    pub fn of_summary(name: &str, summary: &Map<String, Value>) -> Self {
        let numbers = summary.iter();
        let numbers = numbers.filter_map(|(name, v)| Some((name.clone(), vec![v.as_f64()?])));
        Self {
            name: name.to_owned(),
            apart_from_raceway: None,
            has_raceway: false,
            verdict: RingVerdict::of_summary(summary),
            values: numbers.collect(),
        }
    }
}

/// Starts of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Starts {
    /// Runs of each ring.
    pub count: u64,
    /// Seed of their gaps; `None` where each run has the start of its case.
    pub seed: Option<u64>,
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

/// Rings side by side: `compare --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RingComparison {
    /// Names of the rings; differences are from the first.
    pub runs: Vec<String>,
    /// Starts of each ring.
    pub starts: Starts,
    /// Verdicts in the order of the rings.
    pub verdicts: Vec<RingVerdict>,
    /// What changes, in sentences.
    pub statement: String,
    /// Scalar results.
    pub results: Vec<ComparedResult>,
}

impl RingComparison {
    /// Differences of rings; the first is what the others are compared with.
    pub fn new(rings: &[RingResults], starts: Starts) -> Self {
        let alike: Vec<bool> = rings
            .iter()
            .map(|ring| {
                let cases = rings[0].apart_from_raceway.as_ref();
                cases.is_some() && cases == ring.apart_from_raceway.as_ref()
            })
            .collect();
        let results = compared().filter_map(|quantity| {
            let of =
                |ring: &RingResults| ring.values.get(quantity.name).cloned().unwrap_or_default();
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
        let mut comparison = Self {
            runs: rings.iter().map(|ring| ring.name.clone()).collect(),
            starts,
            verdicts: rings.iter().map(|ring| ring.verdict.clone()).collect(),
            statement: String::new(),
            results: results.collect(),
        };
        comparison.statement = comparison.sentences(rings, &alike);
        comparison
    }

    /// What a raceway is there to change, and what it costs.
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

    /// How the rings were started.
    pub fn starts_text(&self) -> String {
        match self.starts.seed {
            Some(seed) => format!(
                "Every ring runs from the same {} starts: the gaps between the balls are drawn at \
                 random, each between 0 and twice the mean (seed {seed}). Values are means over \
                 the starts ± standard error, differences are taken start by start; significant \
                 means Student's test at {} %, by which one in {} differences that are none is \
                 called significant.",
                self.starts.count,
                100.0 * SIGNIFICANCE,
                1.0 / SIGNIFICANCE
            ),
            None => {
                "One run each, from the start of its own case, so that nothing is judged. Ideal \
                     balls that start evenly all roll at one speed and keep their gaps with any \
                     ring; after a contact the motion is chaotic, and counts and extremes scatter. \
                     Compare case files instead of finished runs: they start alike and unevenly."
                    .to_owned()
            }
        }
    }

    fn sentences(&self, rings: &[RingResults], alike: &[bool]) -> String {
        if self.starts.seed.is_none() {
            return self.starts_text();
        }
        let sentence = |k: usize| {
            let (mut changes, mut same) = (vec![], vec![]);
            for result in self.subject() {
                let (Some(from), Some(to), Some(difference)) =
                    (result.values[0], result.values[k], result.differences[k])
                else {
                    continue;
                };
                let word = match difference.change() {
                    Change::Lower => "lowers",
                    Change::Higher => "raises",
                    Change::Undecided => {
                        same.push(result.quantity.label.trim());
                        continue;
                    }
                };
                let (label, unit) = (result.quantity.label.trim(), result.quantity.unit_text());
                let change = format!(
                    "{word} the {label} from {} to {} {unit}",
                    from.text(),
                    to.text()
                );
                changes.push(change.trim_end().to_owned());
            }
            let first = &rings[0];
            let subject = if alike[k] && rings[k].has_raceway && !first.has_raceway {
                format!("The discrete raceway of {}", rings[k].name)
            } else {
                format!("{}, compared with {},", rings[k].name, first.name)
            };
            let mut text = match changes.as_slice() {
                [] => format!("{subject} changes nothing of this significantly"),
                changes => format!("{subject} {}", changes.join("; it ")),
            };
            if !same.is_empty() {
                text += &format!("; no significant change: {}", same.join(", "));
            }
            text + "."
        };
        let all: Vec<String> = (1..rings.len()).map(sentence).collect();
        all.join(" ")
    }

    /// Rows for readers: result, value of the first ring, then value, difference and judgement of
    /// each other ring, unit.
    pub fn rows<'r>(&self, results: impl Iterator<Item = &'r ComparedResult>) -> Vec<Vec<String>> {
        let text = |value: Option<Estimate>| value.map_or("–".to_owned(), |v| v.text());
        let row = |result: &ComparedResult| {
            let mut row = vec![result.quantity.label.to_owned(), text(result.values[0])];
            for k in 1..self.runs.len() {
                row.push(text(result.values[k]));
                row.push(signed(result.differences[k]));
                row.push(judged(result.better[k]).to_owned());
            }
            row.push(result.quantity.unit_text());
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
        RingResults::of_starts(name, &file, &starts, verdict)
    }

    const STARTS: Starts = Starts {
        count: 4,
        seed: Some(1),
    };

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
        let comparison = RingComparison::new(&[conventional.clone(), a], STARTS);
        let found = |name: &str| {
            comparison
                .results
                .iter()
                .find(|r| r.quantity.name == name)
                .unwrap()
        };
        assert_eq!(found("gap_deviation_deg").better, [None, Some(true)]);
        assert_eq!(found("collisions").better, [None, None]);
        assert_eq!(
            comparison.statement,
            "The discrete raceway of A lowers the standard deviation of the gaps from \
             0.90 ± 0.13 to 0.30 ± 0.13 °; no significant change: collisions between balls."
        );
        // Another load: whatever differs does not follow from the raceway.
        let b = ring(
            "B",
            true,
            1000.0,
            [0.0, 0.2, 0.4, 0.6],
            [9.0, 11.0, 10.0, 30.0],
        );
        let comparison = RingComparison::new(&[conventional, b], STARTS);
        assert!(comparison.results.iter().all(|r| r.better[1].is_none()));
        assert!(
            comparison
                .statement
                .starts_with("B, compared with conventional, lowers")
        );
    }

    #[test]
    fn single_runs_are_not_judged() {
        let summary = |loss: f64| Map::from_iter([("power_loss_w".to_owned(), loss.into())]);
        let rings = [
            RingResults::of_summary("A", &summary(1.0)),
            RingResults::of_summary("B", &summary(0.5)),
        ];
        let starts = Starts {
            count: 1,
            seed: None,
        };
        let comparison = RingComparison::new(&rings, starts);
        assert_eq!(comparison.results[0].better, [None, None]);
        assert_eq!(comparison.results[0].differences[1].unwrap().mean, -0.5);
        assert!(comparison.statement.contains("keep their gaps"));
    }
}
