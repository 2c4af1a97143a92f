//! Typed access to one section.

use super::error::CaseError;
use super::key::Key;
use super::spanned_toml::{Node, Places, Section, Value, join};
use super::unit::Unit;

/// Reads the keys of one section and notes the defaults that it filled in.
pub(crate) struct Reader<'a> {
    /// Name of the section in the table of keys.
    section: &'static str,
    /// Keys of the section.
    keys: &'static [Key],
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
        keys: &'static [Key],
        path: String,
        entries: Option<&'a Section>,
        places: &'a Places,
        defaults: &'a mut Vec<String>,
    ) -> Self {
        Self {
            section,
            keys,
            path,
            entries,
            places,
            defaults,
        }
    }

    fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }

    fn unit(&self, name: &str) -> Unit {
        self.key(name).map_or(Unit::None, |key| key.unit)
    }

    /// A whole number, 0 or more.
    pub(super) fn count(&self, name: &str, node: &Node) -> Result<u64, CaseError> {
        // Above 2^53 a float does not tell neighbouring integers apart.
        const EXACT: f64 = 9_007_199_254_740_992.0;
        let count = match node.value {
            Value::Integer(i) => u64::try_from(i).ok(),
            Value::Number(f) if f >= 0.0 && f.fract() == 0.0 && f <= EXACT => Some(f as u64),
            _ => None,
        };
        count.ok_or_else(|| {
            let allowed = self.unit(name).whole_numbers();
            self.refuse(name, node, &allowed)
        })
    }

    /// A list of numbers.
    pub(super) fn list(&self, name: &str, node: &Node) -> Result<Vec<f64>, CaseError> {
        let Value::List(items) = &node.value else {
            return Err(self.refuse(name, node, "a list of numbers in brackets"));
        };
        items.iter().map(|item| self.number(name, item)).collect()
    }

    /// A number, in the unit of the file.
    pub(super) fn number(&self, name: &str, node: &Node) -> Result<f64, CaseError> {
        match node.value {
            // More than 2^53 units of anything is rounded, which nobody will notice.
            Value::Integer(i) => Ok(i as f64),
            // -0.0 is 0: friction would have no direction otherwise.
            Value::Number(f) => Ok(f + 0.0),
            _ => {
                let allowed = match self.unit(name).symbol() {
                    "" => "a number, without quotes".to_owned(),
                    unit => format!("a number in {unit}, without quotes and unit"),
                };
                Err(self.refuse(name, node, &allowed))
            }
        }
    }

    /// The value of a key as it stands in the file.
    pub(super) fn get(&self, name: &str) -> Option<&'a Node> {
        debug_assert!(self.key(name).is_some(), "{name} is not in the table");
        self.entries?.get(name)
    }

    /// Notes that a key took its default.
    pub(super) fn note_default(&mut self, name: &str) {
        let key = self.dotted(name);
        if !self.defaults.contains(&key) {
            self.defaults.push(key);
        }
    }

    /// Takes back that a key took its default.
    pub(super) fn drop_default(&mut self, name: &str) {
        let key = self.dotted(name);
        self.defaults.retain(|d| *d != key);
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

    fn dotted(&self, name: &str) -> String {
        join(&self.path, name)
    }

    pub(super) fn missing(&self, name: &str) -> CaseError {
        self.places
            .error(&self.dotted(name), self.missing_text(name))
    }

    fn missing_text(&self, name: &str) -> String {
        let meaning = self.key(name).map_or_else(String::new, Key::describe);
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
