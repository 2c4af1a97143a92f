//! Results of a computation with its parts.

use std::ops::Deref;

use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::Value;

use crate::{LimitJudgement, Provenance, Quantity, Results, Subject};
use cageless::touchdown::Limit;

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
    /// Settings under which they were computed, where the record has them.
    pub provenance: Option<Provenance>,
}

/// Names of what a kind of record holds.
#[derive(Debug)]
pub struct Shape {
    /// Values.
    pub values: &'static [Quantity],
    /// Lists of sentences.
    pub sentences: &'static [&'static str],
    /// Parts, by name.
    pub parts: &'static [(&'static str, &'static Shape)],
}

impl Shape {
    /// A record of values alone.
    pub const fn of(values: &'static [Quantity]) -> Self {
        Self {
            values,
            sentences: &[],
            parts: &[],
        }
    }
}

impl Deref for Record {
    type Target = Results;

    fn deref(&self) -> &Results {
        &self.results
    }
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
    /// Results `rows` of a subject.
    pub fn of(rows: &'static [Quantity], subject: Subject<'_>) -> Self {
        Results::of(rows, subject).into()
    }

    /// Adds a list of sentences, in place of one of the same name.
    pub fn with_sentences(mut self, name: &'static str, sentences: Vec<String>) -> Self {
        self.sentences.retain(|(known, _)| *known != name);
        self.sentences.push((name, sentences));
        self
    }

    /// Adds a user's limits on its results.
    pub(crate) fn with_limits(self, limits: &[Limit]) -> Self {
        let judged = LimitJudgement::of(limits, &self.results);
        let lists = judged.sentences().into_iter();
        lists
            .filter(|(_, texts)| !texts.is_empty())
            .fold(self, |record, (name, texts)| {
                record.with_sentences(name, texts.to_vec())
            })
    }

    /// A user's limits on its results.
    pub fn limits(&self) -> LimitJudgement {
        let list = |name: &str| self.sentences(name).to_vec();
        LimitJudgement {
            limits_exceeded: list("limits_exceeded"),
            limits_kept: list("limits_kept"),
            limits_not_judged: list("limits_not_judged"),
        }
    }

    /// Adds a part.
    pub fn with_part(mut self, name: &'static str, part: impl Into<Part>) -> Self {
        self.parts.push((name, part.into()));
        self
    }

    /// Adds the settings under which the results were computed.
    pub fn with_provenance(mut self, provenance: Provenance) -> Self {
        self.provenance = Some(provenance);
        self
    }

    /// The record of this shape that was written as this JSON.
    ///
    /// # Errors
    /// It is no object, or a list of sentences, a part or the provenance is something else.
    pub fn read(shape: &Shape, value: &Value) -> Result<Self, String> {
        let object = value.as_object().ok_or("is not a record of results")?;
        let wrong = |name: &'static str| move |error: String| format!("{name}: {error}");
        let mut record = Self::from(Results::read(shape.values, object)?);
        for &name in shape.sentences {
            let sentences = serde_json::from_value(object.get(name).cloned().unwrap_or_default());
            record =
                record.with_sentences(name, sentences.map_err(|e| wrong(name)(e.to_string()))?);
        }
        for &(name, shape) in shape.parts {
            let part = match object.get(name).unwrap_or(&Value::Null) {
                Value::Null => Part::One(None),
                Value::Array(items) => {
                    let items = items.iter().map(|item| Self::read(shape, item));
                    Part::Many(items.collect::<Result<_, _>>().map_err(wrong(name))?)
                }
                value => Some(Self::read(shape, value).map_err(wrong(name))?).into(),
            };
            record = record.with_part(name, part);
        }
        if let Some(provenance) = object.get("provenance") {
            let provenance = serde_json::from_value(provenance.clone());
            record.provenance = provenance.map_err(|e| wrong("provenance")(e.to_string()))?;
        }
        Ok(record)
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

    /// All parts that are one record.
    pub fn members(&self) -> impl Iterator<Item = &Self> {
        self.parts.iter().filter_map(|(_, part)| match part {
            Part::One(record) => record.as_deref(),
            Part::Many(_) => None,
        })
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
        if let Some(provenance) = &self.provenance {
            map.serialize_entry("provenance", provenance)?;
        }
        map.end()
    }
}
