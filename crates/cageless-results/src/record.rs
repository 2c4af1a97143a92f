//! Results of a computation with its parts.

use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::Results;

/// Results of a computation: values by name, lists of sentences, and parts with results of their own.
/// Serialised as one map.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Record {
    /// Values.
    pub results: Results,
    /// Lists of sentences by name: reasons, warnings, notes.
    pub sentences: Vec<(&'static str, Vec<String>)>,
    /// Parts by name.
    pub parts: Vec<(&'static str, Part)>,
}

/// Part of the results of a computation.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// Results that this computation may lack.
    One(Option<Box<Record>>),
    /// Results of each of several things.
    Many(Vec<Record>),
}

impl From<Results> for Record {
    fn from(results: Results) -> Self {
        Self {
            results,
            ..Self::default()
        }
    }
}

impl From<Option<Record>> for Part {
    fn from(record: Option<Record>) -> Self {
        Self::One(record.map(Box::new))
    }
}

impl Record {
    /// Adds a list of sentences.
    pub fn with_sentences(mut self, name: &'static str, sentences: Vec<String>) -> Self {
        self.sentences.push((name, sentences));
        self
    }

    /// Adds a part.
    pub fn with_part(mut self, name: &'static str, part: impl Into<Part>) -> Self {
        self.parts.push((name, part.into()));
        self
    }

    /// Sentences of a list; empty if there is none of that name.
    pub fn sentences(&self, name: &str) -> &[String] {
        let found = self.sentences.iter().find(|(n, _)| *n == name);
        found.map_or(&[], |(_, sentences)| sentences)
    }

    /// A part, if the computation has it.
    pub fn part(&self, name: &str) -> Option<&Self> {
        match self.parts.iter().find(|(n, _)| *n == name) {
            Some((_, Part::One(record))) => record.as_deref(),
            _ => None,
        }
    }

    /// Records of a part; empty if there are none.
    pub fn parts(&self, name: &str) -> &[Self] {
        match self.parts.iter().find(|(n, _)| *n == name) {
            Some((_, Part::Many(records))) => records,
            _ => &[],
        }
    }
}

impl Serialize for Record {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        self.results.serialize_entries(&mut map)?;
        for (name, sentences) in &self.sentences {
            map.serialize_entry(name, sentences)?;
        }
        for (name, part) in &self.parts {
            match part {
                Part::One(record) => map.serialize_entry(name, record)?,
                Part::Many(records) => map.serialize_entry(name, records)?,
            }
        }
        map.end()
    }
}
