//! Whether a ring helps against another: what the balls do in steady operation, what it costs and what it breaks.

use cageless::contact::hertz::STRESS_LIMIT_PA;
use cageless_io::estimate::{Change, Estimate};
use serde::Serialize;

use super::ring_results::{RingResults, compared_named};
use cageless_results::{Aim, with_unit};

/// What a user asks of a remedy unless told otherwise, each with the same weight: fewer contacts, even spacing,
/// steady force.
const ASKED: [&str; 3] = [
    "contact_rate_hz",
    "gap_deviation_deg",
    "outer_ring_force_deviation_n",
];

/// What it may cost.
const COSTS: [&str; 9] = [
    "contact_rate_above_0_1_m_s_hz",
    "contact_rate_above_0_5_m_s_hz",
    "impulse_rate_n",
    "passing_force_n",
    "vibration_rms_m_s2",
    "ball_pressure_max_mpa",
    "power_loss_w",
    "l10r_at_speed_h",
    "basic_static_rating_n",
];

/// Pressures that a contact must not exceed; 4200 MPa leaves a permanent deformation of a ten-thousandth of the
/// diameter of a ball (ISO 76).
const LIMITED: [&str; 3] = [
    "ball_pressure_max_mpa",
    "inner_pressure_max_mpa",
    "outer_pressure_max_mpa",
];

/// Change over the value with the reference below which nothing is said of it.
const TRIFLE: f64 = 0.01;

cageless::named_enum! {
    /// Benefit in a word.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum BenefitWord {
        /// Better in what is asked by more than its error, no limit broken.
        Helps = "helps",
        /// Neither better nor worse by more than the error.
        NoMeasurableBenefit = "no-measurable-benefit",
        /// A limit broken, or worse in what is asked by more than the error.
        Harms = "harms",
        /// Not stationary, or without the results.
        NotJudged = "not-judged",
    }
}

impl BenefitWord {
    /// The word in sentences.
    pub fn label(self) -> &'static str {
        match self {
            Self::Helps => "helps",
            Self::NoMeasurableBenefit => "no measurable benefit",
            Self::Harms => "harms",
            Self::NotJudged => "not judged",
        }
    }
}

/// One result of both rings.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BenefitCriterion {
    /// Name of the result.
    pub name: &'static str,
    /// Mean with the ring over that with the reference; `None` where that is 0.
    pub ratio: Option<f64>,
    /// Whether it is asked for, by weight; 0 of costs.
    pub weight: f64,
    /// Whether it is better by more than its error; `None` if it is neither.
    pub better: Option<bool>,
}

/// Benefit of a ring against the first of a comparison.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Benefit {
    /// Name of the [`BenefitWord`].
    pub benefit: &'static str,
    /// One sentence.
    pub headline: String,
    /// What decides: gains, costs, limits that are broken, or what is missing.
    pub benefit_reasons: Vec<String>,
    /// Weighted mean of ln(ratio) of what is asked for, below 0 better; `None` if it is not judged.
    pub score: Option<Estimate>,
    /// What was compared.
    pub criteria: Vec<BenefitCriterion>,
}

impl Benefit {
    /// That of `ring` against `reference`.
    pub(super) fn of(ring: &RingResults, reference: &RingResults) -> Self {
        let missing: Vec<String> = [reference, ring]
            .into_iter()
            .flat_map(|r| {
                let reasons = r.settling.iter().filter_map(|s| s.reason());
                reasons.map(move |reason| format!("{}: {reason}", r.name))
            })
            .collect();
        let score = score(ring, reference);
        let criteria: Vec<BenefitCriterion> = (ASKED.iter().map(|name| (*name, 1.0)))
            .chain(COSTS.iter().map(|name| (*name, 0.0)))
            .filter_map(|(name, weight)| criterion(ring, reference, name, weight))
            .collect();
        let said = |weighted: bool, better: bool| {
            let wanted = move |c: &&BenefitCriterion| {
                (c.weight > 0.0) == weighted && c.better == Some(better)
            };
            let of = criteria.iter().filter(wanted);
            of.filter_map(|c| changed(ring, reference, c.name))
                .collect::<Vec<_>>()
        };
        let broken: Vec<String> = LIMITED
            .iter()
            .filter_map(|name| broken(ring, name))
            .collect();
        let (gains, losses) = (said(true, true), said(true, false));
        let costs = said(false, false);
        let word = match score {
            _ if !missing.is_empty() => BenefitWord::NotJudged,
            None => BenefitWord::NotJudged,
            Some(_) if !broken.is_empty() => BenefitWord::Harms,
            Some(score) => match score.change() {
                Change::Lower => BenefitWord::Helps,
                Change::Higher => BenefitWord::Harms,
                Change::Undecided => BenefitWord::NoMeasurableBenefit,
            },
        };
        let reasons: Vec<String> = match word {
            BenefitWord::NotJudged if missing.is_empty() => {
                vec!["a result that is asked for is missing".to_owned()]
            }
            BenefitWord::NotJudged => {
                let more = "steady.measured_orbits or steady.transient_orbits larger";
                missing.into_iter().chain([more.to_owned()]).collect()
            }
            _ => {
                let worse = (losses.into_iter()).map(|text| format!("worse: {text}"));
                let costs = costs.into_iter().map(|text| format!("cost: {text}"));
                (broken.into_iter().chain(gains).chain(worse).chain(costs)).collect()
            }
        };
        Self {
            benefit: word.name(),
            headline: format!(
                "{}: {} against {}{}",
                ring.name,
                word.label(),
                reference.name,
                if reasons.is_empty() {
                    String::new()
                } else {
                    format!("; {}", reasons.join("; "))
                }
            ),
            benefit_reasons: reasons,
            score: score.filter(|_| word != BenefitWord::NotJudged),
            criteria,
        }
    }

    /// The word.
    pub fn word(&self) -> BenefitWord {
        let found = BenefitWord::NAMES
            .iter()
            .find(|(name, _)| *name == self.benefit);
        found.map_or(BenefitWord::NotJudged, |(_, word)| *word)
    }
}

/// Mean of ln(ratio) of what is asked for over the draws; `None` if a ring lacks one of them.
fn score(ring: &RingResults, reference: &RingResults) -> Option<Estimate> {
    let draws = ASKED.map(|name| ring.of(name).len().min(reference.of(name).len()));
    let count = draws.into_iter().min().unwrap_or(0);
    let of_draw = |k: usize| {
        let ln = |name: &str| ratio(ring.of(name)[k], reference.of(name)[k]).ln();
        ASKED.iter().map(|name| ln(name)).sum::<f64>() / ASKED.len() as f64
    };
    let values: Vec<f64> = (0..count).map(of_draw).collect();
    let complete = values.iter().all(|value| value.is_finite());
    Estimate::new(&values).filter(|_| complete && count >= 2)
}

/// Ratio of two results of one draw; none at all over none is 1, none over something the least that counts.
fn ratio(value: f64, reference: f64) -> f64 {
    /// Nothing counts as a thousandth of what it is compared with.
    const LEAST: f64 = 1e-3;
    match (value, reference) {
        (0.0, 0.0) => 1.0,
        (_, 0.0) => 1.0 / LEAST,
        _ => (value / reference).max(LEAST),
    }
}

fn criterion(
    ring: &RingResults,
    reference: &RingResults,
    name: &'static str,
    weight: f64,
) -> Option<BenefitCriterion> {
    let quantity = compared_named(name)?;
    let [value, from] = [ring, reference].map(|r| Estimate::new(r.of(name)));
    let (value, from) = (value?, from?);
    let difference = Estimate::of_differences(ring.of(name), reference.of(name))?;
    Some(BenefitCriterion {
        name: quantity.name,
        ratio: (from.mean != 0.0).then(|| value.mean / from.mean),
        weight,
        better: match difference.change() {
            _ if difference.mean.abs() < TRIFLE * from.mean.abs() => None,
            Change::Undecided => None,
            change => quantity
                .aim
                .map(|aim| (change == Change::Lower) == (aim == Aim::Low)),
        },
    })
}

/// A result of both rings in words: `contacts 231 ± 8 instead of 610 ± 9 1/s`.
fn changed(ring: &RingResults, reference: &RingResults, name: &str) -> Option<String> {
    let quantity = compared_named(name)?;
    let (factor, unit) = quantity.printed();
    let text = |r: &RingResults| Some(Estimate::new(r.of(name))?.times(factor).text());
    let (value, from) = (text(ring)?, text(reference)?);
    let label = quantity.label.trim();
    Some(format!(
        "{label} {value} instead of {}",
        with_unit(&from, &unit)
    ))
}

fn broken(ring: &RingResults, name: &str) -> Option<String> {
    let quantity = compared_named(name)?;
    let most = ring.of(name).iter().copied().fold(0.0, f64::max);
    let limit = STRESS_LIMIT_PA * 1e-6;
    (most > limit).then(|| {
        format!(
            "limit broken: {} {most:.0} MPa (at most {limit:.0} MPa, ISO 76)",
            quantity.label.trim()
        )
    })
}
