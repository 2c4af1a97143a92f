//! Whether a ring helps against another: what the balls do in steady operation, what it costs and what it breaks.

use cageless::contact::STRESS_LIMIT_PA;
use cageless::steady::{BenefitWeights, Settling, Stationarity};
use cageless_io::estimate::{Change, Estimate};
use serde::{Serialize, Serializer};

use super::ring_results::{RingResults, compared_named};
use cageless_results::{Aim, with_unit};

/// Result that is asked of a remedy.
struct Asked {
    name: &'static str,
    /// Name in sentences.
    said: &'static str,
    /// Quantity of the result in the test of stationarity.
    settling: Settling,
    weight: fn(&BenefitWeights) -> f64,
}

/// Scatter of the gaps.
const SCATTER: &str = "gap_deviation_deg";

/// Fewer contacts, even spacing, steady force.
const ASKED: [Asked; 3] = [
    Asked {
        name: "contact_rate_hz",
        said: "contacts",
        settling: Settling::Contacts,
        weight: |weights| weights.contacts,
    },
    Asked {
        name: SCATTER,
        said: "scatter of the gaps",
        settling: Settling::Spacing,
        weight: |weights| weights.spacing,
    },
    Asked {
        name: "outer_ring_force_deviation_n",
        said: "variation of the force",
        settling: Settling::Force,
        weight: |weights| weights.force,
    },
];

/// Whether a result is asked of a remedy.
pub(super) fn is_asked(name: &str) -> bool {
    ASKED.iter().any(|asked| asked.name == name)
}

/// Result that a remedy may cost.
struct Cost {
    name: &'static str,
    /// Name in sentences; without one the cost is in tables alone.
    said: Option<&'static str>,
}

const fn cost(name: &'static str, said: Option<&'static str>) -> Cost {
    Cost { name, said }
}

const COSTS: [Cost; 10] = [
    cost("contact_rate_above_0_1_m_s_hz", None),
    cost(
        "contact_rate_above_0_5_m_s_hz",
        Some("contacts above 0.5 m/s"),
    ),
    cost("impulse_rate_n", None),
    cost("ball_wear_kn_m_h", None),
    cost("passing_force_n", None),
    cost("vibration_rms_m_s2", Some("vibration of the housing")),
    cost("ball_pressure_max_mpa", Some("pressure between balls")),
    cost("power_loss_w", Some("losses")),
    cost("l10r_at_speed_h", Some("life L10r")),
    cost("basic_static_rating_n", None),
];

/// Pressures that a contact must not exceed; 4200 MPa leaves a permanent deformation of a ten-thousandth of the
/// diameter of a ball (ISO 76).
const LIMITED: [&str; 3] = [
    "ball_pressure_max_mpa",
    "inner_pressure_max_mpa",
    "outer_pressure_max_mpa",
];

/// Change over the value with the reference below which nothing is said of it.
pub(crate) const TRIFLE: f64 = 0.01;

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

impl Serialize for BenefitWord {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl BenefitWord {
    /// Whether it helps; `None` if that is not judged or cannot be measured.
    pub fn helps(self) -> Option<bool> {
        match self {
            Self::Helps => Some(true),
            Self::Harms => Some(false),
            Self::NoMeasurableBenefit | Self::NotJudged => None,
        }
    }

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
    /// The word.
    pub benefit: BenefitWord,
    /// One sentence.
    pub headline: String,
    /// The sentence without the rings and the word.
    #[serde(skip)]
    pub why: String,
    /// Reasons of the benefit: gains, costs, limits that are broken, or missing results.
    pub benefit_reasons: Vec<String>,
    /// Weighted mean of ln(ratio) of what is asked for, below 0 better; `None` if it is not judged.
    pub score: Option<Estimate>,
    /// Criteria of the benefit, one for each result that was compared.
    pub criteria: Vec<BenefitCriterion>,
    /// Weighted mean of ln(ratio) with each draw, judged or not; empty without results.
    #[serde(skip)]
    pub(crate) scores: Vec<f64>,
    /// Order among rings that are compared with one: lower is better, judged or not.
    #[serde(skip)]
    pub rank: BenefitRank,
}

/// Place of a ring among others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BenefitRank {
    /// Whether it breaks a limit.
    pub breaks_limit: bool,
    /// Mean of the score; infinite without one.
    pub score: f64,
}

impl BenefitRank {
    /// Order by limits, then score.
    pub fn compare(&self, other: &Self) -> std::cmp::Ordering {
        let limits = self.breaks_limit.cmp(&other.breaks_limit);
        limits.then(self.score.total_cmp(&other.score))
    }
}

impl Benefit {
    /// Benefit of `ring` against `reference`.
    pub(super) fn of(ring: &RingResults, reference: &RingResults) -> Self {
        let missing: Vec<String> = [reference, ring]
            .into_iter()
            .flat_map(|r| {
                let limit = |s: &Stationarity| change_limit(s.of, ring, reference);
                let reasons = r.settling.iter().filter_map(move |s| s.reason(limit(s)));
                reasons.map(move |reason| format!("{}: {reason}", r.name))
            })
            .collect();
        let stopped = [reference, ring]
            .into_iter()
            .filter_map(|r| r.stopped.clone());
        let stopped: Vec<String> = stopped.collect();
        let scores = scores(ring, reference);
        let score = Estimate::new(&scores);
        let criteria: Vec<BenefitCriterion> = (asked(reference))
            .chain(COSTS.iter().map(|cost| (cost.name, 0.0)))
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
            _ if !missing.is_empty() || !stopped.is_empty() => BenefitWord::NotJudged,
            None => BenefitWord::NotJudged,
            Some(_) if !broken.is_empty() => BenefitWord::Harms,
            Some(score) => match score.change() {
                Change::Lower => BenefitWord::Helps,
                Change::Higher => BenefitWord::Harms,
                Change::Undecided => BenefitWord::NoMeasurableBenefit,
            },
        };
        // Each kind with the word before it in a sentence, and in the list.
        let kinds = [
            (broken.clone(), "", ""),
            match word {
                BenefitWord::Helps => (gains, "", ""),
                _ => (gains, "better ", "better: "),
            },
            (losses, "worse ", "worse: "),
            (costs, "at the cost of ", "cost: "),
        ];
        let reasons: Vec<String> = match word {
            BenefitWord::NotJudged if !stopped.is_empty() => stopped,
            BenefitWord::NotJudged if missing.is_empty() => {
                vec!["a result that is asked for is missing".to_owned()]
            }
            BenefitWord::NotJudged => {
                let more = "steady.measured_orbits or steady.transient_orbits larger, or more draws, which narrow \
                            the error";
                missing.into_iter().chain([more.to_owned()]).collect()
            }
            _ => {
                let of = |(texts, _, listed): &(Vec<String>, &str, &str)| {
                    let listed = texts.iter().map(|text| format!("{listed}{text}"));
                    listed.collect::<Vec<_>>()
                };
                kinds.iter().flat_map(of).collect()
            }
        };
        let sentence = match word {
            BenefitWord::NotJudged => in_short(&reasons),
            _ => {
                let said = kinds.iter().filter(|(texts, ..)| !texts.is_empty());
                let said = said.map(|(texts, before, _)| format!("{before}{}", texts.join(", ")));
                said.collect::<Vec<_>>().join("; ")
            }
        };
        let colon = if sentence.is_empty() { "" } else { ": " };
        Self {
            benefit: word,
            headline: format!(
                "{}: {} against {}{colon}{sentence}",
                ring.name,
                word.label(),
                reference.name
            ),
            why: sentence,
            benefit_reasons: reasons,
            rank: BenefitRank {
                breaks_limit: !broken.is_empty(),
                score: score.map_or(f64::INFINITY, |score| score.mean),
            },
            score: score.filter(|_| word != BenefitWord::NotJudged),
            criteria,
            scores,
        }
    }
}

impl Benefit {
    /// Whether its score says worse than the reference by more than its error, judged or not.
    pub(crate) fn loses(&self) -> bool {
        Estimate::new(&self.scores).is_some_and(|score| score.change() == Change::Higher)
    }

    /// Whether it breaks a limit that the other keeps, or its score with the same draws is higher by more than its
    /// error.
    pub(crate) fn is_clearly_worse(&self, than: &Self) -> bool {
        let difference = Estimate::of_differences(&self.scores, &than.scores);
        let is_higher = difference.is_some_and(|difference| difference.change() == Change::Higher);
        self.scores.is_empty() || is_higher || self.rank.breaks_limit && !than.rank.breaks_limit
    }
}

/// The first reason, how many more there are, and the last, which is the advice.
fn in_short(reasons: &[String]) -> String {
    match reasons {
        [first, _, .., advice] => format!("{first}, and {} more; {advice}", reasons.len() - 2),
        _ => reasons.join("; "),
    }
}

/// Change of a quantity over the measured time that a verdict bears: the limit of stationary runs, or in runs as long
/// as those of the default, where more is left of the difference between the rings, a third of ln(ratio).
fn change_limit(of: Settling, ring: &RingResults, reference: &RingResults) -> f64 {
    let asked = ASKED.iter().find(|asked| asked.settling == of);
    let name = asked.map_or("", |asked| asked.name);
    let means = [ring, reference].map(|r| Estimate::new(&beside(r, reference, name)));
    match means {
        [Some(value), Some(from)] if ring.is_long && reference.is_long => {
            let difference = ratio(value.mean, from.mean).ln().abs();
            of.limit().max(difference / 3.0)
        }
        _ => of.limit(),
    }
}

/// Names of the requested results, with their weights.
fn asked(reference: &RingResults) -> impl Iterator<Item = (&'static str, f64)> {
    let weight = |asked: &Asked| (asked.weight)(&reference.weights);
    ASKED.iter().map(move |asked| (asked.name, weight(asked)))
}

/// Weighted mean of ln(ratio) of what is asked for with each draw; none if a ring lacks one of them.
fn scores(ring: &RingResults, reference: &RingResults) -> Vec<f64> {
    let draws = asked(reference).map(|(name, _)| ring.of(name).len().min(reference.of(name).len()));
    let count = draws.min().unwrap_or(0);
    let all: f64 = asked(reference).map(|(_, weight)| weight).sum();
    let of_draw = |k: usize| {
        let ln = |name: &str| ratio(beside(ring, reference, name)[k], reference.of(name)[k]).ln();
        asked(reference)
            .map(|(name, weight)| weight * ln(name))
            .sum::<f64>()
            / all
    };
    let values: Vec<f64> = (0..count).map(of_draw).collect();
    let complete = values.iter().all(|value| value.is_finite());
    match complete && count >= 2 {
        true => values,
        false => vec![],
    }
}

/// Ratio of two results of one draw; none at all over none is 1, none over something the least that counts, and what is
/// no number stays none.
pub(crate) fn ratio(value: f64, reference: f64) -> f64 {
    /// Nothing counts as a thousandth of what it is compared with.
    const LEAST: f64 = 1e-3;
    match (value, reference) {
        (0.0, 0.0) => 1.0,
        (_, 0.0) => 1.0 / LEAST,
        _ if value / reference < LEAST => LEAST,
        _ => value / reference,
    }
}

/// Factor that takes the scatter of the gaps of a ring to the mean gap of the reference: with fewer balls there is more
/// room, in which gaps scatter by more without being less even.
fn room(ring: &RingResults, reference: &RingResults) -> f64 {
    let factor = reference.mean_gap_rad / ring.mean_gap_rad;
    match factor.is_finite() && factor > 0.0 {
        true => factor,
        false => 1.0,
    }
}

/// Values of a result beside those of the reference: the scatter of the gaps at its mean gap.
fn beside(ring: &RingResults, reference: &RingResults, name: &str) -> Vec<f64> {
    let factor = match name == SCATTER {
        true => room(ring, reference),
        false => 1.0,
    };
    ring.of(name).iter().map(|value| factor * value).collect()
}

fn criterion(
    ring: &RingResults,
    reference: &RingResults,
    name: &'static str,
    weight: f64,
) -> Option<BenefitCriterion> {
    let quantity = compared_named(name)?;
    let values = beside(ring, reference, name);
    let (value, from) = (Estimate::new(&values)?, Estimate::new(reference.of(name))?);
    let difference = Estimate::of_differences(&values, reference.of(name))?;
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

/// A result of both rings in words, `contacts 231 ± 8 instead of 610 ± 9 Hz`; `None` of what stands in tables alone.
fn changed(ring: &RingResults, reference: &RingResults, name: &str) -> Option<String> {
    let quantity = compared_named(name)?;
    let (factor, unit) = quantity.printed();
    let text = |r: &RingResults| Some(Estimate::new(r.of(name))?.times(factor).text());
    let (value, from) = (text(ring)?, text(reference)?);
    let asked = ASKED.iter().map(|asked| (asked.name, Some(asked.said)));
    let mut all = asked.chain(COSTS.iter().map(|cost| (cost.name, cost.said)));
    let (_, said) = all.find(|(known, _)| *known == name)?;
    let label = said?;
    if name == SCATTER && room(ring, reference) != 1.0 {
        let of = |r: &RingResults| {
            let gap_deg = r.mean_gap_rad.to_degrees();
            Some(Estimate::new(r.of(name))?.times(1.0 / gap_deg).text())
        };
        return Some(format!(
            "{label} {} instead of {} mean gaps",
            of(ring)?,
            of(reference)?
        ));
    }
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

#[cfg(test)]
mod tests {
    use cageless_io::case_file::{CaseFile, template};
    use serde_json::Map;

    use super::*;
    use crate::comparison::RingVerdict;

    /// A ring with these contacts, scatters and forces of four draws, and pressure.
    fn ring(name: &str, set: &str, asked: [f64; 3], pressure: f64) -> RingResults {
        let file = CaseFile::parse(&template(false), "case", &[set.to_owned()]).unwrap();
        let draws: Vec<Vec<(&'static str, f64)>> = [0.99, 1.01, 0.98, 1.02]
            .iter()
            .map(|scatter| {
                let values = ASKED.iter().zip(asked);
                let values = values.map(|(asked, value)| (asked.name, scatter * value));
                values
                    .chain([("ball_pressure_max_mpa", pressure)])
                    .collect()
            })
            .collect();
        RingResults::of_draws(name, &file, &draws, RingVerdict::of_summary(&Map::new()))
    }

    const PLAIN: [f64; 3] = [500.0, 6.0, 20.0];
    /// Half the contacts, half the scatter, and four times the variation of the force.
    const MIXED: [f64; 3] = [250.0, 3.0, 80.0];

    fn judged(set: &str, asked: [f64; 3], pressure: f64) -> Benefit {
        let plain = ring("plain", set, PLAIN, 900.0);
        Benefit::of(&ring("A", set, asked, pressure), &plain)
    }

    /// A slow change is borne where the difference between the rings is three times as large, in runs of the default
    /// length alone.
    #[test]
    fn a_large_difference_bears_a_slow_change() {
        let settling = |change| {
            vec![Stationarity {
                of: Settling::Spacing,
                change,
                error: 0.13,
            }]
        };
        let word = |set: &str, change: f64, spacing: f64| {
            let plain = ring("plain", set, PLAIN, 900.0).settled_by(settling(change));
            let asked = [250.0, spacing, 10.0];
            Benefit::of(&ring("A", set, asked, 900.0), &plain).benefit
        };
        // ln 2/3 = 0.23.
        assert_eq!(word("title=x", 0.09, 3.0), BenefitWord::Helps);
        assert_eq!(word("title=x", 0.11, 3.0), BenefitWord::NotJudged);
        assert_eq!(word("title=x", -0.11, 3.0), BenefitWord::NotJudged);
        assert_eq!(word("title=x", 0.09, 5.0), BenefitWord::NotJudged);
        for short in ["steady.measured_orbits=319", "steady.transient_orbits=119"] {
            assert_eq!(word(short, 0.09, 3.0), BenefitWord::NotJudged, "{short}");
        }
    }

    /// Whatever still changes is in the list; a headline names the first and counts the others.
    #[test]
    fn a_headline_that_is_not_judged_is_short() {
        let changing = ASKED.map(|asked| Stationarity {
            of: asked.settling,
            change: 0.4,
            error: 0.1,
        });
        let plain = ring("plain", "title=x", PLAIN, 900.0).settled_by(changing.to_vec());
        let benefit = Benefit::of(&ring("A", "title=x", PLAIN, 900.0), &plain);
        let [first, .., advice] = &benefit.benefit_reasons[..] else {
            panic!("{benefit:?}")
        };
        let others = ASKED.len() - 1;
        assert_eq!(benefit.benefit_reasons.len(), others + 2);
        assert_eq!(benefit.why, format!("{first}, and {others} more; {advice}"));
        assert!(advice.contains("more draws"), "{advice}");
    }

    /// A ball fewer leaves more room: gaps that scatter by as much of their mean are as even, and are given in mean gaps.
    #[test]
    fn scatter_is_compared_in_mean_gaps() {
        let plain = ring("plain", "title=x", PLAIN, 900.0);
        let fewer = |scatter: f64| {
            ring(
                "13 balls",
                "bearing.balls=13",
                [500.0, scatter, 20.0],
                900.0,
            )
        };
        let room = fewer(6.0).mean_gap_rad / plain.mean_gap_rad;
        assert!(room > 1.5, "{room}");
        let benefit = |scatter: f64| Benefit::of(&fewer(scatter), &plain);
        let even = benefit(6.0 * room);
        assert_eq!(even.benefit, BenefitWord::NoMeasurableBenefit);
        let twice = benefit(12.0 * room);
        assert_eq!(twice.benefit, BenefitWord::Harms);
        assert!((twice.score.unwrap().mean - 2f64.ln() / 3.0).abs() < 1e-9);
        let of = |benefit: &Benefit| {
            let all = &benefit.criteria;
            all.iter()
                .find(|c| c.name == SCATTER)
                .map(|c| (c.ratio, c.better))
                .unwrap()
        };
        assert!((of(&twice).0.unwrap() - 2.0).abs() < 1e-9 && of(&twice).1 == Some(false));
        assert!(twice.why.contains("mean gaps"), "{}", twice.why);
        // What is better stands as such in what harms.
        let plain = ring("plain", "title=x", PLAIN, 900.0);
        let mixed = Benefit::of(&ring("A", "title=x", [50.0, 60.0, 400.0], 900.0), &plain);
        assert_eq!(mixed.benefit, BenefitWord::Harms);
        assert!(mixed.why.starts_with("better contacts"), "{}", mixed.why);
    }

    /// ln ½ + ln ½ + ln 4 = 0, with equal weights; with others their mean.
    #[test]
    fn the_weights_of_the_user_decide() {
        let benefit = judged("title=x", MIXED, 900.0);
        assert_eq!(benefit.benefit, BenefitWord::NoMeasurableBenefit);
        for (set, word, score) in [
            ("steady.weight_force=0", BenefitWord::Helps, 0.5f64.ln()),
            (
                "steady.weight_contacts=0",
                BenefitWord::Harms,
                0.5 * 2f64.ln(),
            ),
            (
                "steady.weight_spacing=6",
                BenefitWord::Helps,
                (5.0 * 0.5f64.ln()) / 8.0,
            ),
        ] {
            let benefit = judged(set, MIXED, 900.0);
            assert_eq!(benefit.benefit, word, "{set}");
            let found = benefit.score.unwrap().mean;
            assert!((found - score).abs() < 1e-12, "{set}: {found} {score}");
        }
    }

    /// The scatter between draws is the same with both and leaves their difference; without results none contends.
    #[test]
    fn a_raceway_is_clearly_worse_by_the_same_draws() {
        let plain = ring("plain", "title=x", PLAIN, 900.0);
        let of = |contacts: [f64; 4], pressure: f64| {
            let draws: Vec<Vec<(&'static str, f64)>> = (contacts.iter())
                .map(|contacts| {
                    let values = [*contacts, 3.0, 10.0];
                    let values = ASKED.iter().zip(values).map(|(a, value)| (a.name, value));
                    values
                        .chain([("ball_pressure_max_mpa", pressure)])
                        .collect()
                })
                .collect();
            let file = CaseFile::parse(&template(false), "case", &[]).unwrap();
            let verdict = RingVerdict::of_summary(&Map::new());
            Benefit::of(&RingResults::of_draws("A", &file, &draws, verdict), &plain)
        };
        let leader = of([100.0, 200.0, 400.0, 800.0], 900.0);
        // The means differ by far less than the draws do.
        let worse = of([110.0, 222.0, 438.0, 885.0], 900.0);
        let unclear = of([110.0, 182.0, 438.0, 805.0], 900.0);
        assert!(worse.is_clearly_worse(&leader) && !leader.is_clearly_worse(&worse));
        assert!(!unclear.is_clearly_worse(&leader) && !leader.is_clearly_worse(&leader));
        assert!(of([50.0, 100.0, 200.0, 400.0], 4201.0).is_clearly_worse(&leader));
        assert!(of([f64::NAN; 4], 900.0).is_clearly_worse(&leader));
        // Half the scatter and half the variation of the force, at almost 5 times the contacts, and at 1 to 50 times.
        assert!(of([2400.0, 2450.0, 2500.0, 2450.0], 900.0).loses());
        assert!(!of([500.0, 5000.0, 1000.0, 25_000.0], 900.0).loses());
        assert!(!leader.loses() && !of([f64::NAN; 4], 900.0).loses());
    }

    /// A broken limit harms whatever is gained, and puts a ring behind all that keep theirs.
    #[test]
    fn a_broken_limit_harms() {
        let better = PLAIN.map(|value| 0.5 * value);
        let [kept, broken] = [4199.0, 4201.0].map(|pressure| judged("title=x", better, pressure));
        assert_eq!(kept.benefit, BenefitWord::Helps);
        assert_eq!(broken.benefit, BenefitWord::Harms);
        assert!(
            broken.benefit_reasons[0].contains("at most 4200 MPa"),
            "{broken:?}"
        );
        let worse = judged("title=x", MIXED, 900.0);
        assert_eq!(worse.rank.compare(&broken.rank), std::cmp::Ordering::Less);
        assert_eq!(
            kept.rank.compare(&judged("title=x", MIXED, 900.0).rank),
            std::cmp::Ordering::Less
        );
    }
}
