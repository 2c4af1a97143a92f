//! Typed access to one section.

use super::declaration::{Field, Presence};
use super::error::CaseError;
use super::keys;
use super::spanned_toml::{Node, Places, Section, Value, join};

/// Reads the keys of one section and notes the defaults that it filled in.
pub(crate) struct Reader<'a> {
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

    /// The value of a key, or what it takes if it is left out.
    pub(super) fn field<T: Field>(
        &mut self,
        name: &str,
        presence: Presence<T>,
    ) -> Result<T, CaseError> {
        if let Some(node) = self.get(name) {
            return T::read(self, name, node);
        }
        if matches!(presence, Presence::Default(_) | Presence::Derived) {
            self.note_default(name);
        }
        match presence {
            Presence::Default(value) => Ok(value),
            Presence::Derived | Presence::Optional => T::absent().ok_or_else(|| self.missing(name)),
            Presence::Required => Err(self.missing(name)),
        }
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
            let allowed = keys::unit(self.section, name).whole_numbers();
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
                let allowed = match keys::unit(self.section, name).symbol() {
                    "" => "a number, without quotes".to_owned(),
                    unit => format!("a number in {unit}, without quotes and unit"),
                };
                Err(self.refuse(name, node, &allowed))
            }
        }
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

    fn missing(&self, name: &str) -> CaseError {
        self.places
            .error(&self.dotted(name), self.missing_text(name))
    }

    fn missing_text(&self, name: &str) -> String {
        let meaning = keys::find(self.section, name).map_or_else(String::new, keys::describe);
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
