//! Scalar results of one ring of a comparison.

use std::collections::BTreeMap;

use cageless::steady::{BenefitWeights, Stationarity, SteadyOperation};
use cageless::touchdown::Limit;
use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_io::estimate::Estimate;
use serde_json::{Map, Value};

use cageless_results::{COMPARED, Kind, LimitJudgement, Quantity, RUN, STATIC, STEADY};

use super::RingVerdict;

/// Results at rest that the number of balls changes.
pub(super) const AT_REST: [&str; 2] = ["l10r_at_speed_h", "basic_static_rating_n"];

/// Results that are compared.
pub(super) fn compared() -> impl Iterator<Item = &'static Quantity> {
    let scalar = |q: &&Quantity| matches!(q.kind, Kind::Number | Kind::Integer);
    STEADY
        .iter()
        .chain(RUN)
        .chain(COMPARED)
        .chain(STATIC.iter().filter(|q| AT_REST.contains(&q.name)))
        .filter(|q| q.in_tables)
        .filter(scalar)
}

/// The compared result of a name.
pub(super) fn compared_named(name: &str) -> Option<&'static Quantity> {
    compared().find(|quantity| quantity.name == name)
}

/// Scalar results of a ring, a value for each start; of a finished run one.
#[derive(Debug, Clone, PartialEq)]
pub struct RingResults {
    pub(super) name: String,
    /// The case without what does not change the motion and without its raceways and number of balls.
    pub(super) apart_from_remedies: Option<CaseDocument>,
    pub(super) verdict: RingVerdict,
    values: BTreeMap<String, Vec<f64>>,
    /// Mean gap of the bearing, rad; not a number of a finished run.
    pub(super) mean_gap_rad: f64,
    /// Limits of the case.
    limits: Vec<Limit>,
    /// Weights of what is asked of a remedy.
    pub(super) weights: BenefitWeights,
    /// Whether the runs leave out and measure as many orbits as those of the default.
    pub(super) is_long: bool,
    /// Whether the measured time is stationary; of a finished run nothing.
    pub(super) settling: Vec<Stationarity>,
    /// Run that stopped early, when and why; then there are no results.
    pub(super) stopped: Option<String>,
}

impl RingResults {
    /// Results of a ring with its draws.
    pub(super) fn of_draws(
        name: &str,
        file: &CaseFile,
        draws: &[Vec<(&'static str, f64)>],
        verdict: RingVerdict,
    ) -> Self {
        let mut values: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for (k, draw) in draws.iter().enumerate() {
            for (name, value) in draw {
                let all = values.entry((*name).to_owned());
                // A result that this draw lacks is no number.
                let all = all.or_insert_with(|| vec![f64::NAN; draws.len()]);
                all[k] = *value;
            }
        }
        let (steady, usual) = (file.steady(), SteadyOperation::default());
        Self {
            name: name.to_owned(),
            apart_from_remedies: Some(file.apart_from_remedies()),
            verdict,
            values,
            mean_gap_rad: file.case().bearing.mean_gap_rad(),
            limits: file.particulars().limits.clone(),
            weights: steady.weights,
            is_long: steady.transient_orbits >= usual.transient_orbits
                && steady.measured_orbits >= usual.measured_orbits,
            settling: vec![],
            stopped: None,
        }
    }

    /// A ring of which a run stopped early.
    pub(super) fn stopped(name: &str, file: &CaseFile, why: String) -> Self {
        Self {
            stopped: Some(why),
            ..Self::of_draws(name, file, &[], RingVerdict::of_summary(&Map::new()))
        }
    }

    /// The results with the answer of the test of stationarity.
    pub(super) fn settled_by(self, settling: Vec<Stationarity>) -> Self {
        Self { settling, ..self }
    }

    /// The limits of its case on means over the draws.
    pub(super) fn limited(&self) -> LimitJudgement {
        LimitJudgement::new(&self.limits, |name| {
            let quantity = compared_named(name)?;
            Some((quantity, Estimate::new(self.of(name)).map(|mean| mean.mean)))
        })
    }

    /// Values of a result with every draw; none if the ring has none.
    pub(super) fn of(&self, name: &str) -> &[f64] {
        self.values.get(name).map_or(&[], Vec::as_slice)
    }

    /// Results of one run from its `summary.json`.
    pub fn of_summary(name: &str, summary: &Map<String, Value>) -> Self {
        let numbers = summary.iter();
        let numbers = numbers.filter_map(|(name, v)| Some((name.clone(), vec![v.as_f64()?])));
        Self {
            name: name.to_owned(),
            apart_from_remedies: None,
            verdict: RingVerdict::of_summary(summary),
            values: numbers.collect(),
            mean_gap_rad: f64::NAN,
            limits: vec![],
            weights: BenefitWeights::default(),
            is_long: false,
            settling: vec![],
            stopped: None,
        }
    }
}
