//! Claims of a paper. A status is never stated: it follows from computed numbers through the
//! requirements of a criterion, and so do the sentences of a finding.
//!
//! ```
//! use cageless_report::{Claim, ClaimStatus, Requirement};
//!
//! let claim = |difference_deg: f64| {
//!     let requirement = Requirement::at_most("largest difference", difference_deg, 5e-5, "°");
//!     let requirement = requirement.says("All values agree.", "Not all values agree.");
//!     Claim::of_the_model("Table 2", "The theoretical values.", vec![requirement])
//! };
//! assert_eq!(claim(4e-5).status(), ClaimStatus::Confirmed);
//! assert_eq!(claim(6e-5).status(), ClaimStatus::NotConfirmed);
//! assert_eq!(claim(6e-5).finding, "Not all values agree.");
//! assert_eq!(claim(f64::NAN).status(), ClaimStatus::NotTested);
//! ```

use serde::{Deserialize, Serialize};

use crate::text::{escape, rich, significant};

/// Status of a claim of the paper, given by [`Claim::of_the_model`] and [`Claim::as_printed`]
/// alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ClaimStatus {
    /// Every requirement is met.
    Confirmed,
    /// Some requirements are met.
    Partly,
    /// No requirement is met.
    NotConfirmed,
    /// The paper contradicts itself or mechanics: a requirement on what it prints is missed.
    Erratum,
    /// No requirement has a number that decides.
    NotTested,
}

impl ClaimStatus {
    const ALL: [Self; 5] = [
        Self::Confirmed,
        Self::Partly,
        Self::NotConfirmed,
        Self::Erratum,
        Self::NotTested,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::Confirmed => "confirmed",
            Self::Partly => "partly",
            Self::NotConfirmed => "not confirmed",
            Self::Erratum => "erratum",
            Self::NotTested => "not tested",
        }
    }
}

/// How many claims have each status: `38 claims: 9 confirmed, 17 partly, …`.
pub(crate) fn counts(claims: &[Claim]) -> String {
    let count = |status| {
        claims
            .iter()
            .filter(|claim| claim.verdict == status)
            .count()
    };
    let counts = ClaimStatus::ALL.map(|status| format!("{} {}", count(status), status.name()));
    format!("{} claims: {}.", claims.len(), counts.join(", "))
}

/// How far a requirement is met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Holds {
    /// The number keeps its limit.
    Met,
    /// Some cases of several do.
    InPart,
    /// The number is nearer to its limit than its error.
    Undecided,
    /// The number misses its limit.
    Missed,
    /// There is no number.
    Unknown,
}

/// A quantity of a claim with its computed value and its limit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Requirement {
    quantity: String,
    value: f64,
    unit: String,
    /// In words: `at most 0.033°`.
    limit: String,
    holds: Holds,
    /// The value with its unit.
    shown: String,
    /// The value beside the limit: `0.07° > 0.02°`, `9 of 10`.
    brief: String,
    /// If it is met and if it is missed.
    #[serde(skip)]
    sentences: [String; 2],
}

/// Side of a limit on which a value must be.
struct LimitSide {
    words: &'static str,
    /// Sign between a value and the limit that it keeps.
    kept: &'static str,
    /// Sign between a value and the limit that it misses.
    missed: &'static str,
}

const AT_MOST: LimitSide = LimitSide {
    words: "at most",
    kept: "≤",
    missed: ">",
};
const AT_LEAST: LimitSide = LimitSide {
    words: "at least",
    kept: "≥",
    missed: "<",
};

impl Requirement {
    fn new(quantity: &str, value: f64, unit: &str, met: bool) -> Self {
        Self {
            quantity: quantity.to_owned(),
            value,
            unit: unit.trim().to_owned(),
            limit: String::new(),
            holds: match met {
                _ if value.is_nan() => Holds::Unknown,
                true => Holds::Met,
                false => Holds::Missed,
            },
            shown: String::new(),
            brief: String::new(),
            sentences: Default::default(),
        }
    }

    /// The requirement with its limit and its value in the unit that follows the numbers.
    fn limited(mut self, side: &LimitSide, limit: f64, unit: &str) -> Self {
        // So few digits that the value still lies on its side of the limit.
        let apart =
            |digits: &usize| significant(self.value, *digits) != significant(limit, *digits);
        let digits = (2..4).find(apart).unwrap_or(4);
        let sign = match self.holds {
            Holds::Met => side.kept,
            _ => side.missed,
        };
        let limit = significant(limit, digits.max(3)) + unit;
        self.shown = significant(self.value, digits) + unit;
        self.brief = format!("{} {sign} {limit}", self.shown);
        self.limit = format!("{} {limit}", side.words);
        self
    }

    /// `value` of `quantity` must be `limit` or less; the unit follows the numbers: `"°"`, `" N"`.
    pub fn at_most(quantity: &str, value: f64, limit: f64, unit: &str) -> Self {
        Self::new(quantity, value, unit, value <= limit).limited(&AT_MOST, limit, unit)
    }

    /// `value` of `quantity` must be `limit` or more.
    pub fn at_least(quantity: &str, value: f64, limit: f64, unit: &str) -> Self {
        Self::new(quantity, value, unit, value >= limit).limited(&AT_LEAST, limit, unit)
    }

    /// `value` of `quantity`, known to ± `error`, must be more than `limit`; within its error it is undecided.
    pub fn above(quantity: &str, value: f64, error: f64, limit: f64) -> Self {
        let mut found = Self::new(quantity, value, "", value - error > limit);
        if !value.is_nan() && (value - limit).abs() <= error {
            found.holds = Holds::Undecided;
        }
        let limit = significant(limit, 4);
        found.limit = format!("more than {limit}");
        found.shown = format!("{} ± {}", significant(value, 3), significant(error, 2));
        let sign = match found.holds {
            Holds::Met => ">",
            Holds::Undecided => "≈",
            _ => "<",
        };
        found.brief = format!("{} {sign} {limit}", found.shown);
        found
    }

    /// Something must hold in all of `cases`; it holds in `value` of them.
    pub fn in_all(quantity: &str, value: usize, cases: usize) -> Self {
        let number = if cases == 0 { f64::NAN } else { value as f64 };
        let mut found = Self::new(quantity, number, "", value >= cases);
        if (1..cases).contains(&value) {
            found.holds = Holds::InPart;
        }
        found.limit = format!("all of {cases}");
        found.shown = value.to_string();
        found.brief = format!("{value} of {cases}");
        found
    }

    /// Sentence of the finding if the requirement is met, and if it is not.
    pub fn says(mut self, met: impl Into<String>, missed: impl Into<String>) -> Self {
        self.sentences = [met.into(), missed.into()];
        self
    }

    /// The requirement on one of several things, whose name stands before the quantity.
    pub fn on(mut self, name: &str) -> Self {
        self.quantity = format!("{name}: {}", self.quantity);
        self
    }

    /// How far it is met.
    pub fn holds(&self) -> Holds {
        self.holds
    }

    fn sentence(&self) -> &str {
        match self.holds {
            Holds::Met => &self.sentences[0],
            Holds::InPart | Holds::Undecided | Holds::Missed => &self.sentences[1],
            Holds::Unknown => "",
        }
    }

    /// `<li>` of a page: mark, quantity, value, limit.
    fn html(&self) -> String {
        let (mark, word) = match self.holds {
            Holds::Met => ("✓", "met"),
            Holds::InPart => ("~", "met in part"),
            Holds::Undecided => ("?", "undecided"),
            Holds::Missed => ("✗", "missed"),
            Holds::Unknown => ("–", "no number"),
        };
        format!(
            "<li><span role=\"img\" aria-label=\"{word}\">{mark}</span> {}: <b>{}</b> ({})</li>",
            rich(&self.quantity),
            escape(&self.shown),
            escape(&self.limit)
        )
    }
}

/// A claim of the paper with what was found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// Quoted or paraphrased.
    pub claim: String,
    /// Place in the paper: `Section 4.3, Fig. 8`.
    pub place: String,
    /// Finding: the sentences of the requirements, and remarks that hold whatever the numbers.
    pub finding: String,
    /// Further numbers, without a requirement; may be empty.
    pub numbers: String,
    /// Requirements that decide.
    criterion: Vec<Requirement>,
    /// Status that follows.
    verdict: ClaimStatus,
}

impl Claim {
    fn new(place: &str, claim: &str, criterion: Vec<Requirement>, verdict: ClaimStatus) -> Self {
        let said = criterion.iter().map(Requirement::sentence);
        let finding: Vec<&str> = said.filter(|s| !s.is_empty()).collect();
        Self {
            claim: claim.to_owned(),
            place: place.to_owned(),
            finding: finding.join(" "),
            numbers: String::new(),
            criterion,
            verdict,
        }
    }

    /// A claim on how the bearing moves, which the model tests.
    pub fn of_the_model(place: &str, claim: &str, criterion: Vec<Requirement>) -> Self {
        let all = |of: &[Holds]| criterion.iter().all(|one| of.contains(&one.holds));
        let status = if all(&[Holds::Unknown, Holds::Undecided]) {
            ClaimStatus::NotTested
        } else if all(&[Holds::Met]) {
            ClaimStatus::Confirmed
        } else if all(&[Holds::Missed, Holds::Unknown, Holds::Undecided]) {
            ClaimStatus::NotConfirmed
        } else {
            ClaimStatus::Partly
        };
        Self::new(place, claim, criterion, status)
    }

    /// A formula or number as the paper prints it, compared with its other statements or with
    /// mechanics. One missed requirement makes an erratum.
    pub fn as_printed(place: &str, claim: &str, criterion: Vec<Requirement>) -> Self {
        let model = Self::of_the_model(place, claim, criterion);
        Self {
            verdict: match model.verdict {
                ClaimStatus::Partly | ClaimStatus::NotConfirmed => ClaimStatus::Erratum,
                status => status,
            },
            ..model
        }
    }

    /// Adds further numbers.
    pub fn numbers(mut self, numbers: &str) -> Self {
        self.numbers = numbers.to_owned();
        self
    }

    /// Adds to the finding what holds whatever the numbers.
    pub fn remark(mut self, remark: &str) -> Self {
        if !self.finding.is_empty() {
            self.finding.push(' ');
        }
        self.finding.push_str(remark);
        self
    }

    /// Status of the claim.
    pub fn status(&self) -> ClaimStatus {
        self.verdict
    }

    /// Requirements that decide.
    pub fn criterion(&self) -> &[Requirement] {
        &self.criterion
    }

    /// The requirement that decides: the first that is not met, or else the first.
    fn deciding(&self) -> Option<&Requirement> {
        let mut missed = self.criterion.iter().filter(|one| one.holds != Holds::Met);
        missed.next().or(self.criterion.first())
    }

    /// Line of a page with status, claim and number, which unfolds to the finding.
    pub(crate) fn html(&self) -> String {
        let status = self.verdict.name();
        let class = status.replace(' ', "-");
        let mut below: String = self.criterion.iter().map(Requirement::html).collect();
        if !below.is_empty() {
            below = format!("<ul class=\"numbers\">{below}</ul>");
        }
        if !self.numbers.is_empty() {
            below += &format!("<p class=\"numbers\">{}</p>", rich(&self.numbers));
        }
        let number = match self.deciding() {
            Some(one) if one.holds != Holds::Unknown => one.brief.as_str(),
            _ => "",
        };
        format!(
            "<details class=\"claim {class}\"><summary><span class=\"verdict\">{status}</span> \
             <span class=\"said\">{}</span> <span class=\"number\">{}</span></summary>\n\
             <p><span class=\"place\">{}.</span> {}</p>{below}</details>\n",
            rich(&self.claim),
            escape(number),
            rich(&self.place),
            rich(&self.finding),
        )
    }
}

/// How a status follows, for the head of a list of claims.
pub(crate) const RULE: &str = "Each status follows from the requirements listed with it: confirmed \
    if all are met, partly confirmed if some are, not confirmed if none is. What the paper prints \
    is an erratum if it misses a requirement of its own other numbers or of mechanics. A claim \
    without a computed number beyond its error is not tested.";

#[cfg(test)]
mod tests {
    use super::*;

    /// A number within its error of the limit decides nothing, on either side.
    #[test]
    fn a_number_within_its_error_is_undecided() {
        let status = |values: &[(f64, f64)]| {
            let above = |(value, error): &(f64, f64)| {
                Requirement::above("density over chance", *value, *error, 1.0)
                    .says("It is denser.", "It is not clearly denser.")
            };
            let claim = Claim::of_the_model("§", "Denser.", values.iter().map(above).collect());
            (claim.status(), claim.finding.clone())
        };
        let denser = "It is denser.".to_owned();
        let not = "It is not clearly denser.".to_owned();
        assert_eq!(status(&[(1.44, 0.2)]), (ClaimStatus::Confirmed, denser));
        assert_eq!(
            status(&[(1.44, 0.45)]),
            (ClaimStatus::NotTested, not.clone())
        );
        assert_eq!(status(&[(0.8, 0.3)]), (ClaimStatus::NotTested, not.clone()));
        assert_eq!(status(&[(0.7, 0.2)]), (ClaimStatus::NotConfirmed, not));
        assert_eq!(
            status(&[(0.7, 0.2), (1.1, 0.2)]).0,
            ClaimStatus::NotConfirmed
        );
        assert_eq!(status(&[(1.4, 0.2), (1.1, 0.2)]).0, ClaimStatus::Partly);
        assert_eq!(status(&[(f64::NAN, 0.2)]).0, ClaimStatus::NotTested);
    }
}
