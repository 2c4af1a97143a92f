//! Typed access to one section of a tree.

use super::error::CaseError;
use super::key::{Key, Kind, Limit};
use super::named::quoted;
use super::spanned_toml::{Node, Origin, Section, Tree, Value, join};
use super::unit::Unit;

/// Reads the keys of one section.
pub(crate) struct Reader<'a> {
    pub tree: &'a Tree,
    /// Keys of the section.
    pub keys: &'static [Key],
    /// Dotted path: `raceway.2` for the second of several.
    pub path: String,
    /// `None` where the file does not have the section: every key is missing.
    pub entries: Option<&'a Section>,
}

impl<'a> Reader<'a> {
    fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }

    fn unit(&self, name: &str) -> Unit {
        self.key(name).map_or(Unit::None, |key| key.unit)
    }

    fn limit(&self, name: &str) -> Limit {
        self.key(name).map_or(Limit::None, |key| key.limit)
    }

    /// A whole number, 0 or more.
    pub(crate) fn count(&self, name: &str, node: &Node) -> Result<u64, CaseError> {
        // Above 2^53 a float does not tell neighbouring integers apart.
        const EXACT: f64 = 9_007_199_254_740_992.0;
        let count = match node.value {
            Value::Integer(i) => u64::try_from(i).ok(),
            Value::Number(f) if f >= 0.0 && f.fract() == 0.0 && f <= EXACT => Some(f as u64),
            _ => None,
        };
        let limit = self.limit(name);
        count
            .filter(|count| limit.has(*count as f64))
            .ok_or_else(|| self.refuse(name, node, &limit.whole_numbers()))
    }

    /// A list of numbers in SI units.
    pub(crate) fn list(&self, name: &str, node: &Node) -> Result<Vec<f64>, CaseError> {
        let Value::List(items) = &node.value else {
            return Err(self.refuse(name, node, "a list of numbers in brackets"));
        };
        items.iter().map(|item| self.number(name, item)).collect()
    }

    /// Items of a list, in its order.
    pub(crate) fn items<T>(
        &self,
        name: &str,
        node: &Node,
        allowed: &str,
        of: impl Fn(&Node) -> Option<T>,
    ) -> Result<Vec<T>, CaseError> {
        let items = match &node.value {
            Value::List(items) => items.iter().map(of).collect(),
            _ => None,
        };
        items.ok_or_else(|| self.refuse(name, node, allowed))
    }

    /// A number in SI units, finite and within the limits of its key.
    pub(crate) fn number(&self, name: &str, node: &Node) -> Result<f64, CaseError> {
        let value = self.plain_number(name, node)?;
        let (unit, limit) = (self.unit(name), self.limit(name));
        let si = unit.to_si(value);
        if !si.is_finite() {
            let allowed = match unit.printed().as_str() {
                "" => "a finite number".to_owned(),
                symbol => format!("a finite number of {symbol}"),
            };
            return Err(self.refuse(name, node, &allowed));
        }
        if !limit.has(value) {
            return Err(self.refuse(name, node, &limit.allowed(unit)));
        }
        Ok(si)
    }

    /// A number as it is in the file.
    pub(crate) fn plain_number(&self, name: &str, node: &Node) -> Result<f64, CaseError> {
        match node.value {
            // More than 2^53 units of anything is rounded, which nobody will notice.
            Value::Integer(i) => Ok(i as f64),
            // -0.0 is 0: friction would have no direction otherwise.
            Value::Number(f) => Ok(f + 0.0),
            _ => {
                let allowed = match self.unit(name).printed().as_str() {
                    "" => "a number, without quotes".to_owned(),
                    unit => format!("a number in {unit}, without quotes and unit"),
                };
                Err(self.refuse(name, node, &allowed))
            }
        }
    }

    /// The value of a key as it stands in the file.
    pub(crate) fn get(&self, name: &str) -> Option<&'a Node> {
        debug_assert!(self.key(name).is_some(), "{name} is not in the table");
        self.entries?.get(name)
    }

    /// "KEY = VALUE is not possible: it must be ALLOWED".
    pub(crate) fn refuse(&self, name: &str, node: &Node, allowed: &str) -> CaseError {
        let key = join(&self.path, name);
        match node.place.origin {
            Origin::Nowhere => self.tree.refusal(&key, &node.place.written, allowed),
            _ => node.refusal(&self.tree.name, &key, allowed),
        }
    }

    /// The error of a key that is left out.
    pub(crate) fn missing(&self, name: &str) -> CaseError {
        missing(self.tree, &join(&self.path, name), self.key(name))
    }
}

/// The error of a key that is left out.
pub(crate) fn missing(tree: &Tree, path: &str, key: Option<&Key>) -> CaseError {
    let front = path.rsplit_once('.').map_or("", |(front, _)| front);
    let section = front.split('.').next().unwrap_or_default();
    let place = match tree.given(front) {
        _ if section.is_empty() => String::new(),
        Some(_) => format!(" in [{section}]"),
        None => format!(", as is its section [{section}]"),
    };
    let choices = match key.map(|key| key.kind) {
        Some(Kind::Choice(names)) => format!(", {}", quoted(&names())),
        _ => String::new(),
    };
    let meaning = key.map_or_else(String::new, Key::describe) + &choices;
    tree.error(path, format!("{path} is missing{place}: {meaning}"))
}
