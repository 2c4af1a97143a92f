//! Reader of the document: keys, their types and defaults.

use super::declaration::SectionDocument;
use super::document::{
    BearingDocument, CaseDocument, ContactDocument, HEAD, MaterialDocument, SCHEMA, StartDocument,
};
use super::error::CaseError;
use super::file_reader::FileReader;
use super::key::Presence;
use super::keys::{self, hint};
use super::missing;
use super::spanned_toml::{Node, Places, Section, Value, join, nth};

/// Reads the document and the dotted keys that took their default.
pub(super) fn document(
    root: &Section,
    places: &Places,
) -> Result<(CaseDocument, Vec<String>), CaseError> {
    let mut file = FileReader {
        root: root.clone(),
        places,
        defaults: Vec::new(),
    };
    // A later schema may have other keys: say so before complaining about them.
    let schema = file.schema()?;
    file.check_names()?;
    missing::check(root, places)?;
    file.move_seed()?;
    let title = file
        .section("", HEAD)?
        .field("title", Presence::Default(String::new()))?;
    let mut document = CaseDocument::read(schema, title, &mut file)?;
    document
        .bearing
        .complete(&mut file.section("bearing", BearingDocument::KEYS)?);
    document
        .contact
        .complete(&mut file.section("contact", ContactDocument::KEYS)?);
    document
        .material
        .complete(&mut file.section("material", MaterialDocument::KEYS)?);
    let rotor = document.rotor.is_some();
    document
        .start
        .complete(rotor, &mut file.section("start", StartDocument::KEYS)?);
    Ok((document, file.defaults))
}

impl FileReader<'_> {
    /// Puts a seed at the head of the file into its section.
    fn move_seed(&mut self) -> Result<(), CaseError> {
        let Some(seed) = self.root.remove("seed") else {
            return Ok(());
        };
        let solver = self.root.entry("solver".to_owned()).or_insert(Node {
            value: Value::Section(Section::new()),
            place: seed.place.clone(),
        });
        let Value::Section(solver) = &mut solver.value else {
            return Ok(());
        };
        match solver.insert("seed".to_owned(), seed) {
            None => Ok(()),
            Some(_) => {
                let why = "solver.seed is at the head of the file as well: drop one";
                Err(self.places.error("solver.seed", why.to_owned()))
            }
        }
    }

    fn schema(&mut self) -> Result<u64, CaseError> {
        let mut head = self.section("", HEAD)?;
        let Some(node) = head.get("schema") else {
            head.note_default("schema");
            return Ok(SCHEMA);
        };
        match head.count("schema", node)? {
            SCHEMA => Ok(SCHEMA),
            _ => Err(head.refuse(
                "schema",
                node,
                &format!("{SCHEMA}, the only schema that this version of Cageless reads"),
            )),
        }
    }

    /// Refuses names that the table of keys does not have; the first in the file
    /// if there are several.
    fn check_names(&self) -> Result<(), CaseError> {
        let mut wrong: Vec<CaseError> = Vec::new();
        for (name, node) in &self.root {
            if keys::section_meaning(name).is_some() {
                match &node.value {
                    Value::Section(entries) => self.check_section(name, name, entries, &mut wrong),
                    Value::List(items) => {
                        for (k, item) in items.iter().enumerate() {
                            if let Value::Section(entries) = &item.value {
                                let path = nth(name, k, items.len());
                                self.check_section(name, &path, entries, &mut wrong);
                            }
                        }
                    }
                    _ => {}
                }
            } else if keys::find("", name).is_none() {
                wrong.push(self.unknown("", "", name, node));
            }
        }
        let first = wrong
            .into_iter()
            .min_by_key(|e| e.line().unwrap_or(usize::MAX));
        first.map_or(Ok(()), Err)
    }

    fn check_section(&self, name: &str, path: &str, entries: &Section, wrong: &mut Vec<CaseError>) {
        for (key, node) in entries {
            if keys::find(name, key).is_none() {
                wrong.push(self.unknown(name, path, key, node));
            }
        }
    }

    fn unknown(&self, section: &str, path: &str, name: &str, node: &Node) -> CaseError {
        let dotted = join(path, name);
        let hint = hint(section, name);
        let what = match node.value {
            Value::Section(_) if section.is_empty() => {
                format!("[{name}] is not a section of a case file")
            }
            _ if section.is_empty() => format!("{dotted} is not a key of a case file"),
            _ => format!("{dotted} is not a key of [{section}]"),
        };
        self.places
            .error_at(&node.place, &dotted, format!("{what}; {hint}"))
    }
}
