//! The box on top of a page: verdicts and key numbers.

use cageless_results::{DryVerdict, Results, open_benefit};

use crate::data::Parameter;
use crate::text::{escape, rich, significant};

/// Key numbers that fit on a line.
const FACTS: usize = 6;

/// The important result of a page.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Head {
    /// Verdicts, the most important first: whether it passes (`None`: not judged), and the
    /// headline.
    pub verdicts: Vec<(Option<bool>, String)>,
    /// Key numbers, the most important first; the source of one stands behind it on hover.
    pub facts: Vec<Parameter>,
}

impl Head {
    /// A box with one verdict.
    pub fn new(passes: Option<bool>, headline: &str) -> Self {
        Self::default().verdict(passes, headline)
    }

    /// Adds a verdict; an empty one is left out.
    pub fn verdict(mut self, passes: Option<bool>, headline: &str) -> Self {
        if !headline.is_empty() {
            self.verdicts.push((passes, headline.to_owned()));
        }
        self
    }

    /// Adds the verdict without oil beside that of a raceway in oil.
    pub fn dry(self, results: &Results) -> Self {
        match DryVerdict::of(results) {
            Some(dry) => self.verdict(dry.passes, &dry.line()),
            None => self,
        }
    }

    /// Adds limits of the user with whether they are kept.
    pub fn limits(self, limits: &[(Option<bool>, String)]) -> Self {
        let add = |head: Self, (kept, text): &(Option<bool>, String)| head.verdict(*kept, text);
        limits.iter().fold(self, add)
    }

    /// Adds what the verdict on a raceway leaves open, if it works.
    pub fn open_benefit(self, passes: Option<bool>) -> Self {
        match open_benefit(passes) {
            Some(open) => self.verdict(None, &format!("Benefit {open}")),
            None => self,
        }
    }

    /// Adds key numbers.
    pub fn facts(mut self, facts: impl IntoIterator<Item = Parameter>) -> Self {
        self.facts.extend(facts);
        self
    }

    /// HTML; empty if there is nothing to say.
    pub fn html(&self) -> String {
        if self.verdicts.is_empty() && self.facts.is_empty() {
            return String::new();
        }
        let verdicts: String = self
            .verdicts
            .iter()
            .map(|(passes, headline)| verdict_html(*passes, headline))
            .collect();
        let facts: String = self.facts.iter().take(FACTS).map(fact_html).collect();
        let facts = match facts.as_str() {
            "" => String::new(),
            facts => format!("<dl class=\"facts\">{facts}</dl>\n"),
        };
        let class = self.verdicts.first().map_or("", |(p, _)| class_of(*p));
        format!(
            "<section class=\"head {class}\" aria-label=\"Result\">\n{verdicts}{facts}</section>\n"
        )
    }
}

fn fact_html(fact: &Parameter) -> String {
    let title = match fact.source.as_str() {
        "" => String::new(),
        source => format!(" title=\"{}\"", escape(source)),
    };
    let unit = match fact.unit.as_str() {
        "" => String::new(),
        unit => format!(" <span class=\"unit\">{}</span>", rich(unit)),
    };
    format!(
        "<div{title}><dt>{}</dt><dd>{}{unit}</dd></div>",
        rich(&fact.name),
        rich(&of_four_digits(&fact.value))
    )
}

/// A number to four digits; other text as it is.
fn of_four_digits(value: &str) -> String {
    match value.replace('−', "-").parse::<f64>() {
        Ok(number) => significant(number, 4),
        Err(_) => value.to_owned(),
    }
}

fn class_of(passes: Option<bool>) -> &'static str {
    match passes {
        Some(true) => "pass",
        Some(false) => "fail",
        None => "unjudged",
    }
}

/// Characters of a verdict that stand unfolded.
const UNFOLDED: usize = 180;

/// A verdict with its sign: green if it passes, red if it fails, grey if nothing was judged. Of a long one the first
/// reasons stand, and the rest is folded.
pub fn verdict_html(passes: Option<bool>, headline: &str) -> String {
    let sign = match passes {
        Some(true) => "✔ ",
        Some(false) => "✘ ",
        None => "",
    };
    let class = class_of(passes);
    match folded(headline) {
        None => format!(
            "<p class=\"judged {class}\" role=\"status\">{sign}{}</p>\n",
            rich(headline)
        ),
        Some((first, rest)) => format!(
            "<div class=\"judged {class}\" role=\"status\"><details><summary>{sign}{}; …</summary>{}\
             </details></div>\n",
            rich(first),
            rich(rest)
        ),
    }
}

/// The reasons of a long verdict that stand, and those that are folded.
fn folded(headline: &str) -> Option<(&str, &str)> {
    let (end, _) = headline.char_indices().nth(UNFOLDED)?;
    let first = headline[..end]
        .rfind("; ")
        .or_else(|| headline.find("; "))?;
    Some((&headline[..first], &headline[first + 2..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every reason stands once, before or behind the fold.
    #[test]
    fn a_long_verdict_folds_between_two_reasons() {
        let reasons: Vec<String> = (0..9)
            .map(|k| format!("reason {k} with its number β"))
            .collect();
        let long = reasons.join("; ");
        let html = verdict_html(None, &long);
        let (stands, rest) = html.split_once("; …</summary>").expect("a fold");
        assert!(
            stands.ends_with(&reasons[5]) && rest.starts_with(&reasons[6]),
            "{html}"
        );
        assert!(
            reasons
                .iter()
                .all(|reason| html.matches(reason.as_str()).count() == 1)
        );
        for whole in [&reasons[..6].join("; "), &"a".repeat(400)] {
            assert!(verdict_html(Some(true), whole).contains(&format!("✔ {whole}</p>")));
        }
    }
}
