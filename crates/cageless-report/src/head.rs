//! The box on top of a page: verdicts and key numbers.

use cageless_results::open_benefit;

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

/// A verdict with its sign: green if it passes, red if it fails, grey if nothing was judged.
pub fn verdict_html(passes: Option<bool>, headline: &str) -> String {
    let sign = match passes {
        Some(true) => "✔ ",
        Some(false) => "✘ ",
        None => "",
    };
    format!(
        "<p class=\"judged {}\" role=\"status\">{sign}{}</p>\n",
        class_of(passes),
        rich(headline)
    )
}
