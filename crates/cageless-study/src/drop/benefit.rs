//! Benefit of a discrete raceway over the plain outer ring in the same scattered drops.

use cageless_io::estimate::{Change, Estimate};
use cageless_results::{Across, DROP, Quantity, with_unit};
use serde::Serialize;

use super::Ensemble;
use super::ensemble::DropRow;
use crate::comparison::{BenefitWord, TRIFLE, ratio};

/// Results asked of a raceway in a drop, each with the same weight, with its name in sentences.
const ASKED: [(&str, &str); 4] = [
    ("collisions", "contacts between balls"),
    ("ball_pressure_max_mpa", "pressure between balls"),
    ("rotor_force_max_n", "force on the rotor"),
    ("dissipated_j", "heat"),
];

/// Benefit of a raceway in scattered drops.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DropBenefit {
    /// The word.
    pub benefit: BenefitWord,
    /// One sentence.
    pub headline: String,
    /// Reasons of the benefit: gains, losses, limits that are broken, or missing results.
    pub benefit_reasons: Vec<String>,
    /// Mean of ln(ratio) of what is asked for, below 0 better; `None` if it is not judged.
    pub score: Option<Estimate>,
    /// Criteria of the benefit, one for each result that was compared.
    pub criteria: Vec<DropCriterion>,
}

/// One result with both rings.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DropCriterion {
    /// Name of the result; of several bearings their sum or the largest of them.
    pub name: &'static str,
    /// Mean with the raceway.
    pub raceway: Estimate,
    /// Mean with the plain ring.
    pub conventional: Estimate,
    /// Whether it is better by more than 1 % and the error of the ratio in the same drops; `None` if it is neither.
    pub better: Option<bool>,
}

impl DropBenefit {
    /// Benefit of the raceway of one ensemble against the plain ring of the other, with the same draws.
    pub(super) fn new(raceway: &Ensemble, conventional: &Ensemble) -> Self {
        let both = [raceway, conventional];
        let count = raceway.drops.len();
        let stopped = both.iter().map(|of| of.stopped.len()).sum::<usize>();
        let missing = match (count, stopped) {
            (0 | 1, _) => Some("two scattered drops at least have an error".to_owned()),
            (_, 0) => None,
            _ => Some(format!("{stopped} of the drops stopped")),
        };
        if let Some(reason) = missing {
            return Self {
                benefit: BenefitWord::NotJudged,
                headline: format!("raceway: not judged against the plain ring: {reason}"),
                benefit_reasons: vec![reason],
                score: None,
                criteria: vec![],
            };
        }
        let asked = ASKED.iter().filter_map(|(name, said)| {
            let quantity = DROP.iter().find(|quantity| quantity.name == *name)?;
            Some((quantity, *said, both.map(|of| values(of, quantity))))
        });
        let asked: Vec<(&Quantity, &str, [Vec<f64>; 2])> = asked.collect();
        // Drops differ by far more than rings do: ratios of the same drops tell.
        let ln = |[value, from]: &[Vec<f64>; 2], k: usize| ratio(value[k], from[k]).ln();
        let of_draw = |k: usize| {
            let all = asked.iter().map(|(.., pair)| ln(pair, k));
            all.sum::<f64>() / asked.len() as f64
        };
        let score = Estimate::new(&(0..count).map(of_draw).collect::<Vec<_>>());
        let mut said: [Vec<String>; 2] = [vec![], vec![]];
        let mut criteria = vec![];
        for (quantity, name, pair) in &asked {
            let [raceway, conventional] = pair.each_ref().map(|values| Estimate::new(values));
            let ratios: Vec<f64> = (0..count).map(|k| ln(pair, k)).collect();
            let (Some(raceway), Some(conventional), Some(ratio)) =
                (raceway, conventional, Estimate::new(&ratios))
            else {
                continue;
            };
            let better = match ratio.change() {
                _ if ratio.mean.abs() < TRIFLE => None,
                Change::Lower => Some(true),
                Change::Higher => Some(false),
                Change::Undecided => None,
            };
            if let Some(better) = better {
                let (factor, unit) = quantity.printed();
                let [value, from] = [raceway, conventional].map(|e| e.times(factor).text());
                let from = with_unit(&from, &unit);
                said[usize::from(!better)].push(format!("{name} {value} instead of {from}"));
            }
            criteria.push(DropCriterion {
                name: quantity.name,
                raceway,
                conventional,
                better,
            });
        }
        let [gains, losses] = said;
        let fail = both.map(|of| of.drops.iter().filter(|d| d.passes == Some(false)).count());
        let broken = (fail[0] > 0 && fail[1] == 0).then(|| {
            format!(
                "limit broken in {} of {count} drops, with the plain ring in none",
                fail[0]
            )
        });
        let change = score.filter(|score| score.mean.abs() > TRIFLE);
        let word = match change.map(|score| score.change()) {
            _ if broken.is_some() => BenefitWord::Harms,
            Some(Change::Lower) => BenefitWord::Helps,
            Some(Change::Higher) => BenefitWord::Harms,
            Some(Change::Undecided) | None => BenefitWord::NoMeasurableBenefit,
        };
        let worse = losses.iter().map(|text| format!("worse: {text}"));
        let reasons: Vec<String> = (broken.iter().chain(&gains).cloned())
            .chain(worse)
            .collect();
        let listed = match reasons.is_empty() {
            true => "no difference beyond its error, or of less than 1 %".to_owned(),
            false => reasons.join("; "),
        };
        Self {
            benefit: word,
            headline: format!(
                "raceway: {} against the plain ring in the same {count} drops: {listed}",
                word.label()
            ),
            benefit_reasons: reasons,
            score,
            criteria,
        }
    }
}

/// A result of every drop, over its bearings.
fn values(ensemble: &Ensemble, quantity: &Quantity) -> Vec<f64> {
    let of_drop = |row: &DropRow| {
        let of_bearings = row.bearings.iter();
        let found = of_bearings.filter_map(|b| b.result.results.value(quantity.name));
        match quantity.across {
            Some(Across::Sum) => found.sum(),
            _ => found.fold(0.0, f64::max),
        }
    };
    ensemble.drops.iter().map(of_drop).collect()
}

#[cfg(test)]
mod tests {
    use cageless_results::Cell;

    use super::*;
    use crate::drop::ensemble::evaluate;
    use crate::drop::ensemble::tests::{bearing_with, row};

    /// Drops with these contacts, pressures, forces and heat, each scaled by the draw and all by a factor.
    fn drops(values: [f64; 4], factors: &[f64], stopped: bool) -> Ensemble {
        let rows = (1..).zip(factors).map(|(number, factor)| {
            // Pressure, force and heat scatter less than contacts.
            let [contacts, others @ ..] = values;
            let [pressure, force, heat] = others.map(|value| value * factor.sqrt());
            let results = [
                ("collisions", Cell::Integer((contacts * factor) as i64)),
                ("ball_pressure_max_mpa", Cell::Number(pressure)),
                ("rotor_force_max_n", Cell::Number(force)),
                ("dissipated_j", Cell::Number(heat)),
            ];
            let stop = stopped.then_some("at t = 0.001 s a cause");
            DropRow {
                drop: number,
                ..row(vec![bearing_with(&results)], stop)
            }
        });
        evaluate(1, 0, rows.collect())
    }

    const PLAIN: [f64; 4] = [1000.0, 3000.0, 900.0, 20.0];
    const DRAWS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];

    fn word(raceway: [f64; 4], factors: &[f64]) -> BenefitWord {
        DropBenefit::new(
            &drops(raceway, factors, false),
            &drops(PLAIN, factors, false),
        )
        .benefit
    }

    /// The scatter between the draws, eightfold, is the same with both rings and hides no difference of a fifth. With
    /// the rings exchanged the word is the opposite.
    #[test]
    fn the_same_drops_show_a_small_difference() {
        let fewer = [800.0, 3000.0, 900.0, 20.0];
        assert_eq!(word(fewer, &DRAWS), BenefitWord::Helps);
        assert_eq!(word(PLAIN, &DRAWS), BenefitWord::NoMeasurableBenefit);
        let (own, plain) = (drops(fewer, &DRAWS, false), drops(PLAIN, &DRAWS, false));
        let found = DropBenefit::new(&plain, &own);
        assert_eq!(found.benefit, BenefitWord::Harms);
        let score = 0.25 * (1000.0f64 / 800.0).ln();
        assert!((found.score.unwrap().mean - score).abs() < 2e-3);
        let better: Vec<_> = found.criteria.iter().map(|c| c.better).collect();
        assert_eq!(better, [Some(false), None, None, None]);
        assert!(
            found.headline.contains("worse: contacts between balls"),
            "{}",
            found.headline
        );
        // Two fifths of the contacts at a quarter more of everything else: 0.4 · 1.25³ < 1.
        let mixed = [400.0, 3750.0, 1125.0, 25.0];
        assert_eq!(word(mixed, &DRAWS), BenefitWord::Helps);
        // A hundredth is a trifle.
        let trifle = [1000.0, 3000.0, 900.0, 20.3];
        assert_eq!(word(trifle, &DRAWS), BenefitWord::NoMeasurableBenefit);
    }

    #[test]
    fn one_drop_or_one_that_stopped_judges_nothing() {
        let half = [500.0, 1500.0, 450.0, 10.0];
        assert_eq!(word(half, &DRAWS[..1]), BenefitWord::NotJudged);
        let found = DropBenefit::new(&drops(half, &DRAWS, true), &drops(PLAIN, &DRAWS, false));
        assert_eq!(found.benefit, BenefitWord::NotJudged);
        assert!(
            found.headline.contains("4 of the drops stopped"),
            "{}",
            found.headline
        );
        assert_eq!((found.score, found.criteria.len()), (None, 0));
    }
}
