//! Verdict on a raceway in oil, without its oil.

use crate::Results;

/// Verdict without oil beside one with a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DryVerdict<'a> {
    /// Whether the raceway passes; `None` if it is not judged.
    pub passes: Option<bool>,
    /// Whether it works, with its reason.
    pub headline: &'a str,
}

impl<'a> DryVerdict<'a> {
    /// Beginning of the line that says it.
    pub const NAME: &'static str = "without oil";

    /// Dry verdict of the results of `design` or `tolerance`; `None` of a dry case.
    pub fn of(results: &'a Results) -> Option<Self> {
        let headline = results.text("dry_headline");
        (!headline.is_empty()).then_some(Self {
            passes: results.flag("dry_passes"),
            headline,
        })
    }

    /// The line that says it.
    pub fn line(&self) -> String {
        format!("{}: {}", Self::NAME, self.headline)
    }
}
