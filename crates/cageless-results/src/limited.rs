//! Limits of a user on results.

use cageless::touchdown::{Limit, LimitSide};
use serde::Serialize;

use crate::table::{
    CLEARANCE_RANGE, COMPARED, CONTACT_ANGLE, DEFECTS, DESIGN, DROP, FILM, FILM_VERDICT, FIT,
    LUBRICATION, PASSAGES, RUN, SPACE, STATIC, STEADY, SUCCESSION, VERDICT, milliseconds,
};
use crate::{Aim, DropJudgement, Quantity, Results};

/// Tables whose results a limit can be on.
pub const LIMITED: [&[Quantity]; 17] = [
    DROP,
    SUCCESSION,
    STATIC,
    FIT,
    CLEARANCE_RANGE,
    LUBRICATION,
    FILM,
    SPACE,
    DEFECTS,
    RUN,
    STEADY,
    COMPARED,
    DESIGN,
    CONTACT_ANGLE,
    VERDICT,
    FILM_VERDICT,
    PASSAGES,
];

/// A limit with the result that it is on.
struct Allowed<'l> {
    limit: &'l Limit,
    quantity: &'l Quantity,
}

impl Allowed<'_> {
    fn is_least(&self) -> bool {
        match self.limit.side {
            Some(side) => side == LimitSide::AtLeast,
            None => self.quantity.aim == Some(Aim::High),
        }
    }

    fn by_magnitude(&self) -> bool {
        self.limit.side.is_none() && self.quantity.is_limited_in_magnitude()
    }

    fn exceeded_by(&self, value: f64) -> bool {
        match (self.is_least(), self.by_magnitude()) {
            (true, _) => value < self.limit.value,
            (false, true) => value.abs() > self.limit.value,
            (false, false) => value > self.limit.value,
        }
    }

    /// `at most 12 kN (API 617)` for a value.
    fn text(&self, value: Option<f64>) -> String {
        let negative = value.is_some_and(|value| value < 0.0);
        let side = match (self.is_least(), self.by_magnitude() && negative) {
            (true, _) => "at least",
            (false, true) => "in magnitude at most",
            (false, false) => "at most",
        };
        let limit = self.quantity.with_unit(self.limit.value);
        format!("{side} {limit} ({})", self.limit.source)
    }
}

/// Limits of a user on the results of a computation, in sentences.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct LimitJudgement {
    /// Limits that are exceeded, a least value that is not reached among them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub limits_exceeded: Vec<String>,
    /// Limits that are kept.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub limits_kept: Vec<String>,
    /// Limits on results without a value.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub limits_not_judged: Vec<String>,
}

/// Tables of a computation that only some cases have: with a fit, an oil, a film, motion in space.
const OF_SOME_CASES: [&[Quantity]; 7] = [
    FIT,
    CLEARANCE_RANGE,
    LUBRICATION,
    FILM,
    SPACE,
    DEFECTS,
    FILM_VERDICT,
];

/// A result of this name that other cases have of the computation behind these results.
fn of_other_cases(results: &Results, name: &str) -> Option<&'static Quantity> {
    let mut all = OF_SOME_CASES.into_iter().flatten();
    all.find(|quantity| {
        let is_computed = || {
            results
                .iter()
                .any(|(q, _)| q.computation() == quantity.computation())
        };
        quantity.name == name && is_computed()
    })
}

impl LimitJudgement {
    /// The limits on those results that the computation has; `value` is of a name, `Some(None)` without a value.
    pub fn new<'q>(
        limits: &[Limit],
        value: impl Fn(&str) -> Option<(&'q Quantity, Option<f64>)>,
    ) -> Self {
        let mut judged = Self::default();
        for limit in limits {
            let Some((quantity, value)) = value(&limit.result) else {
                continue;
            };
            let allowed = Allowed { limit, quantity };
            let (label, text) = (quantity.label.trim(), allowed.text(value));
            match value.filter(|value| value.is_finite()) {
                None => {
                    let text = format!("{label} has no value here; {text}");
                    judged.limits_not_judged.push(text);
                }
                Some(value) => {
                    let found = format!("{label} {}, {text}", quantity.with_unit(value));
                    match allowed.exceeded_by(value) {
                        true => judged.limits_exceeded.push(found),
                        false => judged.limits_kept.push(found),
                    }
                }
            }
        }
        judged
    }

    /// The limits on these results, and on those that only other cases have of the same computation.
    pub fn of(limits: &[Limit], results: &Results) -> Self {
        Self::new(limits, |name| {
            let found = results.iter().find(|(q, _)| q.name == name);
            let found = found.map(|(quantity, cell)| (quantity, cell.number()));
            found.or_else(|| Some((of_other_cases(results, name)?, None)))
        })
    }

    /// Lists of sentences by their names in files.
    pub fn sentences(&self) -> [(&'static str, &[String]); 3] {
        [
            ("limits_exceeded", &self.limits_exceeded),
            ("limits_kept", &self.limits_kept),
            ("limits_not_judged", &self.limits_not_judged),
        ]
    }

    /// Whether each limit is kept (`None`: not judged), in a sentence, the exceeded ones first.
    pub fn verdicts(&self) -> Vec<(Option<bool>, String)> {
        let lists = [
            (Some(false), &self.limits_exceeded),
            (None, &self.limits_not_judged),
            (Some(true), &self.limits_kept),
        ];
        let of = |(kept, texts): (Option<bool>, &Vec<String>)| {
            texts
                .iter()
                .map(move |text| (kept, text.clone()))
                .collect::<Vec<_>>()
        };
        lists.into_iter().flat_map(of).collect()
    }

    /// A line for each limit, the exceeded ones first.
    pub fn lines(&self) -> Vec<(&'static str, String)> {
        let words = ["limit exceeded", "limit kept", "limit not judged"];
        let lists = self.sentences().into_iter().zip(words);
        let lines = lists.flat_map(|((_, texts), word)| texts.iter().map(move |text| (word, text)));
        lines.map(|(word, text)| (word, text.clone())).collect()
    }
}

/// A limit on a result of a drop: the result, the limit with its source in words, and whether these results keep it;
/// `None` where that cannot be judged. Nothing of a limit on other results.
pub fn judged_limit(
    limit: &Limit,
    results: &Results,
) -> Option<(&'static Quantity, String, Option<bool>)> {
    let mut all = DROP.iter().chain(SUCCESSION);
    let quantity = all.find(|q| q.name == limit.result)?;
    let text = Allowed { limit, quantity }.text(results.value(quantity.name));
    let mut judgement = DropJudgement::default();
    add(&mut judgement, limit, quantity, results);
    Some((quantity, text, judgement.keeps()))
}

/// The verdict with those of the limits that concern a drop with these results.
pub(crate) fn limited(
    mut judgement: DropJudgement,
    limits: &[Limit],
    results: &Results,
) -> DropJudgement {
    for limit in limits {
        let mut all = DROP.iter().chain(SUCCESSION);
        let Some(quantity) = all.find(|q| q.name == limit.result) else {
            continue;
        };
        add(&mut judgement, limit, quantity, results);
    }
    judgement
}

/// The verdict on a drop in succession: limits on its results are judged by these.
pub(crate) fn limited_in_succession(
    mut judgement: DropJudgement,
    limits: &[Limit],
    results: &Results,
) -> DropJudgement {
    for limit in limits {
        let of_drop = DROP.iter().any(|q| q.name == limit.result);
        let found = results
            .iter()
            .find(|(q, _)| q.name == limit.result && !of_drop);
        if let Some((quantity, _)) = found {
            judgement.judge_again(quantity.name);
            add(&mut judgement, limit, quantity, results);
        }
    }
    judgement
}

fn add(judgement: &mut DropJudgement, limit: &Limit, quantity: &Quantity, results: &Results) {
    let of_limit = Allowed { limit, quantity };
    let least = of_limit.is_least();
    let text = |value: f64| quantity.with_unit(value);
    let label = quantity.label.trim();
    let allowed = of_limit.text(results.value(quantity.name));
    if let Some(value) = results.value(quantity.name) {
        if value.is_nan() {
            let text =
                format!("{label} is not known, so that its limit cannot be judged: {allowed}");
            judgement.not_judged(quantity.name, text);
            return;
        }
        let exceeded = of_limit.exceeded_by(value);
        judgement.limit(exceeded, format!("{label} {}, {allowed}", text(value)));
        return;
    }
    if quantity.occurs && !least {
        judgement.limit(false, format!("{label} none, {allowed}"));
        return;
    }
    let end_ms = results.value("simulated_s").map(milliseconds);
    let missing = match end_ms.filter(|_| quantity.awaited) {
        Some(end_ms) => {
            let so_far = format!("{label} not reached within {}", text(end_ms));
            if !least && end_ms > limit.value {
                judgement.limit(true, format!("{so_far}, {allowed}"));
                return;
            }
            format!("{so_far} (solver.duration_s)")
        }
        None if results.get(quantity.name).is_none() => {
            format!("{label} is computed of drops in succession alone (drop --drops)")
        }
        None => format!("{label} has no value in this drop"),
    };
    judgement.not_judged(
        quantity.name,
        format!("{missing}, so that its limit cannot be judged: {allowed}"),
    );
}
