//! A bearing of a drop with what its tables and figures are made of.

use cageless::Case;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseFile;
use cageless_results::{Particulars, Record, bearing_number};
use cageless_study::drop::{BearingRecord, DropStudy};
use cageless_study::{Provenance, provenance};

use crate::figure::Figure;
use crate::plot::Plot;

/// A bearing of a drop.
pub(super) struct Bearing<'s> {
    /// Number of the bearing among several; `None` of an only bearing.
    pub number: Option<usize>,
    pub case: &'s Case,
    pub particulars: &'s Particulars,
    pub record: &'s BearingRecord,
    /// Record of the same drop with a conventional outer ring, to compare with.
    pub conventional: Option<&'s BearingRecord>,
    /// Record of the first of its drops in succession.
    pub succession: Option<&'s Record>,
    pub source: Provenance,
}

impl<'s> Bearing<'s> {
    /// The bearings of the drop of a file.
    pub fn all(file: &'s BearingArrangement, study: &'s DropStudy) -> Vec<Self> {
        let bearing = |(k, file): (usize, &'s CaseFile)| Self {
            number: bearing_number(k, study.record.bearings.len()),
            case: &study.drop.cases()[k],
            particulars: file.particulars(),
            record: &study.record.bearings[k],
            conventional: study.conventional.as_ref().map(|other| &other.bearings[k]),
            succession: study.succession.records.get(k),
            source: provenance(
                &file.particulars().title,
                &study.drop.cases()[k],
                String::new(),
            ),
        };
        file.cases().iter().enumerate().map(bearing).collect()
    }

    /// Label of a table, figure or section of the bearing, among several with its number.
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
