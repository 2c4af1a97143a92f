//! Typed access to one section.

use super::document::RangeDocument;
use super::error::CaseError;
use super::keys::{self, Key};
use super::named::Named;
use super::spanned_toml::{Node, Places, Section, Value, join};

/// Reads the keys of one section and notes the defaults that it filled in.
pub(super) struct Reader<'a> {
    /// Name of the section in the table of keys.
    section: &'static str,
    /// Dotted path: `raceway.2` for the second of several.
    path: String,
    entries: Option<&'a Section>,
    places: &'a Places,
    defaults: &'a mut Vec<String>,
}

impl<'a> Reader<'a> {
    /// A reader of `entries`; without entries, every key is missing.
    pub(super) fn new(
        section: &'static str,
        path: String,
        entries: Option<&'a Section>,
        places: &'a Places,
        defaults: &'a mut Vec<String>,
    ) -> Self {
        Self {
            section,
            path,
            entries,
            places,
            defaults,
        }
    }

    /// A required number, in the unit of the file.
    pub(super) fn number(&self, name: &str) -> Result<f64, CaseError> {
        self.optional_number(name)?
            .ok_or_else(|| self.missing(name))
    }

    /// A number that has a default.
    pub(super) fn number_or(&mut self, name: &str, default: f64) -> Result<f64, CaseError> {
        let given = self.optional_number(name)?;
        Ok(self.or_default(name, given, default))
    }

    /// A number that may be left out.
    pub(super) fn optional_number(&self, name: &str) -> Result<Option<f64>, CaseError> {
        self.get(name)
            .map(|node| self.as_number(name, node))
            .transpose()
    }

    /// A number that may be left out and then counts as a default that the model
    /// derives itself.
    pub(super) fn derived_number(&mut self, name: &str) -> Result<Option<f64>, CaseError> {
        let given = self.optional_number(name)?;
        if given.is_none() {
            self.note_default(name);
        }
        Ok(given)
    }

    /// A required whole number, 0 or more.
    pub(super) fn count(&self, name: &str) -> Result<u64, CaseError> {
        self.optional_count(name)?.ok_or_else(|| self.missing(name))
    }

    /// A whole number, 0 or more, that may be left out.
    pub(super) fn optional_count(&self, name: &str) -> Result<Option<u64>, CaseError> {
        let Some(node) = self.get(name) else {
            return Ok(None);
        };
        // Above 2^53 a float does not tell neighbouring integers apart.
        const EXACT: f64 = 9_007_199_254_740_992.0;
        let count = match node.value {
            Value::Integer(i) => u64::try_from(i).ok(),
            Value::Number(f) if f >= 0.0 && f.fract() == 0.0 && f <= EXACT => Some(f as u64),
            _ => None,
        };
        match count {
            Some(count) => Ok(Some(count)),
            None => {
                let rule = keys::whole_number(self.section, name);
                Err(self.refuse(name, node, &rule.allowed()))
            }
        }
    }

    /// A whole number, 0 or more, that has a default.
    pub(super) fn count_or(&mut self, name: &str, default: u64) -> Result<u64, CaseError> {
        let given = self.optional_count(name)?;
        Ok(self.or_default(name, given, default))
    }

    /// A number or the lowest and the highest, that may be left out.
    pub(super) fn optional_range(&self, name: &str) -> Result<Option<RangeDocument>, CaseError> {
        let Some(node) = self.get(name) else {
            return Ok(None);
        };
        let numbers = match &node.value {
            Value::List(_) => self.optional_list(name)?.unwrap_or_default(),
            _ => vec![self.as_number(name, node)?],
        };
        match *numbers {
            [one] => Ok(Some(RangeDocument {
                low: one,
                high: one,
            })),
            [low, high] if low <= high => Ok(Some(RangeDocument { low, high })),
            _ => Err(self.refuse(name, node, "a number, or [lowest, highest]")),
        }
    }

    /// A text that has a default.
    pub(super) fn text_or(&mut self, name: &str, default: &str) -> Result<String, CaseError> {
        let given = match self.get(name) {
            None => None,
            Some(Node {
                value: Value::Text(text),
                ..
            }) => Some(text.clone()),
            Some(node) => return Err(self.refuse(name, node, "text in quotes")),
        };
        Ok(self.or_default(name, given, default.to_owned()))
    }

    /// A choice by name that has a default.
    pub(super) fn choice_or<T: Named>(&mut self, name: &str, default: T) -> Result<T, CaseError> {
        let given = self.optional_choice(name)?;
        Ok(self.or_default(name, given, default))
    }

    fn optional_choice<T: Named>(&self, name: &str) -> Result<Option<T>, CaseError> {
        let Some(node) = self.get(name) else {
            return Ok(None);
        };
        let choice = match &node.value {
            Value::Text(text) => T::from_name(text),
            _ => None,
        };
        choice
            .map(Some)
            .ok_or_else(|| self.refuse(name, node, &T::choices()))
    }

    /// A list of numbers that may be left out.
    pub(super) fn optional_list(&self, name: &str) -> Result<Option<Vec<f64>>, CaseError> {
        let Some(node) = self.get(name) else {
            return Ok(None);
        };
        let Value::List(items) = &node.value else {
            return Err(self.refuse(name, node, "a list of numbers in brackets"));
        };
        items
            .iter()
            .map(|item| self.as_number(name, item))
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// The value of a key as it stands in the file.
    pub(super) fn get(&self, name: &str) -> Option<&'a Node> {
        debug_assert!(
            keys::find(self.section, name).is_some(),
            "{name} is not in the table"
        );
        self.entries?.get(name)
    }

    /// Notes that a key took its default.
    pub(super) fn note_default(&mut self, name: &str) {
        let key = self.dotted(name);
        if !self.defaults.contains(&key) {
            self.defaults.push(key);
        }
    }

    /// "KEY = VALUE is not possible: it must be ALLOWED".
    pub(super) fn refuse(&self, name: &str, node: &Node, allowed: &str) -> CaseError {
        let key = self.dotted(name);
        let message = format!(
            "{key} = {} is not possible: it must be {allowed}",
            node.place.written
        );
        self.places.error_at(&node.place, &key, message)
    }

    /// An error at a key that the file must not have here.
    pub(super) fn misplaced(&self, name: &str, why: &str) -> CaseError {
        let key = self.dotted(name);
        self.places.error(&key, format!("{key} {why}"))
    }

    fn or_default<T>(&mut self, name: &str, given: Option<T>, default: T) -> T {
        given.unwrap_or_else(|| {
            self.note_default(name);
            default
        })
    }

    fn as_number(&self, name: &str, node: &Node) -> Result<f64, CaseError> {
        match node.value {
            // More than 2^53 units of anything is rounded, which nobody will notice.
            Value::Integer(i) => Ok(i as f64),
            Value::Number(f) => Ok(f),
            _ => {
                let unit = keys::find(self.section, name).map_or("", |k| k.unit.symbol());
                let allowed = match unit {
                    "" => "a number, without quotes".to_owned(),
                    unit => format!("a number in {unit}, without quotes and unit"),
                };
                Err(self.refuse(name, node, &allowed))
            }
        }
    }

    fn dotted(&self, name: &str) -> String {
        join(&self.path, name)
    }

    fn missing(&self, name: &str) -> CaseError {
        self.places
            .error(&self.dotted(name), self.missing_text(name))
    }

    fn missing_text(&self, name: &str) -> String {
        let meaning = keys::find(self.section, name).map_or_else(String::new, describe);
        match self.entries {
            Some(_) => format!(
                "{} is missing in [{}]: {meaning}",
                self.dotted(name),
                self.section
            ),
            None => format!(
                "{} is missing, as is its section [{}]: {meaning}",
                self.dotted(name),
                self.section
            ),
        }
    }
}

/// Meaning of a key, with its unit.
pub(super) fn describe(key: &Key) -> String {
    match key.unit.symbol() {
        "" => key.meaning.to_owned(),
        unit => format!("{}, in {unit}", key.meaning),
    }
}
