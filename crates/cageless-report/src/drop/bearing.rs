//! A bearing of a drop with what its tables and figures are made of.

use cageless::Case;
use cageless_results::Record;
use cageless_study::drop::{BearingRecord, DropStudy};
use cageless_study::{Provenance, provenance};

use crate::figure::Figure;
use crate::plot::Plot;

/// A bearing of a drop.
pub(super) struct Bearing<'s> {
    /// Its number below a linear rotor; `None` of the only bearing of a case.
    pub number: Option<usize>,
    pub case: &'s Case,
    pub record: &'s BearingRecord,
    /// Record of the same drop with a conventional outer ring, to compare with.
    pub conventional: Option<&'s BearingRecord>,
    /// Its first drop of those in succession.
    pub succession: Option<&'s Record>,
    pub source: Provenance,
}

impl<'s> Bearing<'s> {
    /// The bearings of a drop.
    pub fn all(study: &'s DropStudy) -> Vec<Self> {
        let bearing = |(k, case): (usize, &'s Case)| Self {
            number: study.drop.rotor().map(|_| k + 1),
            case,
            record: &study.record.bearings[k],
            conventional: study.conventional.as_ref().map(|other| &other.bearings[k]),
            succession: study.succession.records.get(k),
            source: provenance(case, String::new()),
        };
        study.drop.cases().iter().enumerate().map(bearing).collect()
    }

    /// Label of a table, figure or section of the bearing, below a linear rotor with its number.
    pub fn label(&self, name: &str) -> String {
        match self.number {
            None => name.to_owned(),
            Some(number) => format!("{name}, bearing {number}"),
        }
    }

    /// A figure of the bearing.
    pub fn figure(&self, name: &str, caption: &str, plot: Plot) -> Figure {
        Figure::new(&self.label(name), caption, &self.source, plot)
    }
}
