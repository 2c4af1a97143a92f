//! Access to the sections of a whole file.

use super::error::CaseError;
use super::key::Key;
use super::reader::Reader;
use super::spanned_toml::{Node, Places, Section, Value, nth};

/// More sections of one name than fit: discrete raceways into any ring that balls roll in.
const SECTIONS_MAX: usize = 64;

/// Reader of a whole file.
pub(crate) struct FileReader<'a> {
    pub(super) root: Section,
    pub(super) places: &'a Places,
    pub(super) defaults: Vec<String>,
}

impl FileReader<'_> {
    /// Whether the file has a section.
    pub(super) fn has(&self, name: &str) -> bool {
        self.root.contains_key(name)
    }

    /// A reader of a section; without the section, every key is missing.
    pub(super) fn section(
        &mut self,
        name: &'static str,
        keys: &'static [Key],
    ) -> Result<Reader<'_>, CaseError> {
        let entries = match self.root.get(name) {
            _ if name.is_empty() => Some(&self.root),
            None => None,
            Some(Node {
                value: Value::Section(entries),
                ..
            }) => Some(entries),
            Some(node) => return Err(Self::not_a_section(self.places, name, node)),
        };
        Ok(Reader::new(
            name,
            keys,
            name.to_owned(),
            entries,
            self.places,
            &mut self.defaults,
        ))
    }

    fn not_a_section(places: &Places, name: &str, node: &Node) -> CaseError {
        let message = match node.value {
            Value::List(_) => format!("{name} may be given once only: [{name}]"),
            _ => format!(
                "{name} = {} is not possible: it must be a section, [{name}]",
                node.place.written
            ),
        };
        places.error_at(&node.place, name, message)
    }

    /// The sections of one name, each read by `read`.
    pub(super) fn sections<T>(
        &mut self,
        name: &'static str,
        keys: &'static [Key],
        read: impl Fn(&mut Reader<'_>) -> Result<T, CaseError>,
    ) -> Result<Vec<T>, CaseError> {
        let Some(node) = self.root.get(name) else {
            return Ok(Vec::new());
        };
        let items = match &node.value {
            Value::List(items) => items.as_slice(),
            _ => std::slice::from_ref(node),
        };
        if items.len() > SECTIONS_MAX {
            let message = format!(
                "{} sections [[{name}]] are not possible: there may be at most {SECTIONS_MAX}",
                items.len()
            );
            let place = &items[SECTIONS_MAX].place;
            return Err(self.places.error_at(place, name, message));
        }
        let mut sections = Vec::new();
        for (k, item) in items.iter().enumerate() {
            let Value::Section(entries) = &item.value else {
                return Err(Self::not_a_section(self.places, name, item));
            };
            let path = nth(name, k, items.len());
            let mut r = Reader::new(
                name,
                keys,
                path,
                Some(entries),
                self.places,
                &mut self.defaults,
            );
            sections.push(read(&mut r)?);
        }
        Ok(sections)
    }
}
