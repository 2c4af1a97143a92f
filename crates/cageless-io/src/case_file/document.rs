//! A case file as a tree: exactly the keys of the TOML, in the units of the file.

use std::path::Path;

use cageless::surface::MeasuredSlot;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::error::CaseError;
use super::key::Key;
use super::keys;
use super::overrides::{Change, Replacement};
use super::sections::CASE_FILE;
use super::source::{read_named, source};
use super::spanned_toml::{Node, Origin, Section, Tree, Value, join, nth, section_at};
use super::unit::Unit;
use super::value::CaseValue;

/// More than half of the last of nine decimals of a degree, rad.
const ROUNDING_RAD: f64 = 1e-11;

/// A case file as a tree. Serialised, it is the case in `summary.json`. One discrete raceway is
/// written as a `[raceway]`, several as `[[raceway]]`.
#[derive(Debug, Clone)]
pub struct CaseDocument {
    pub(crate) tree: Tree,
}

/// The keys of one section with their values.
pub type SectionValues = Vec<(&'static str, CaseValue)>;

impl CaseDocument {
    /// Reads the text of a case file.
    ///
    /// # Errors
    /// A [`CaseError`] if the file cannot be read or is not TOML.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let (name, text) = read_named(path, "case file")?;
        Self::parse(&text, &name)
    }

    /// Parses the text of a case file; `name` stands for it in messages.
    ///
    /// # Errors
    /// A [`CaseError`] if the text is not TOML.
    pub fn parse(text: &str, name: &str) -> Result<Self, CaseError> {
        Ok(Self::from_sections(source(text, name)?, name))
    }

    pub(crate) fn from_sections(root: Section, name: &str) -> Self {
        let tree = Tree::new(root, name);
        Self { tree }
    }

    /// Replaces values.
    ///
    /// # Errors
    /// A [`CaseError`] if a key has no place in this case. Whether it exists and the
    /// value fits, [`CaseDocument::with`] says.
    pub fn change(&mut self, changes: &[Change<'_>]) -> Result<(), CaseError> {
        let mut changes = changes.iter().map(Replacement::from_change);
        changes.try_for_each(|change| self.replace(&change))
    }

    pub(crate) fn replace(&mut self, replacement: &Replacement) -> Result<(), CaseError> {
        replacement.apply(&mut self.tree.root)
    }

    /// Gives a dotted key a value, and leaves keys that say the same as they are; nothing happens
    /// where no section can have it.
    pub fn set(&mut self, key: &str, value: impl Into<CaseValue>) {
        self.tree.set(key, value);
    }

    /// Replaces the sections of a name by these.
    pub fn set_sections(&mut self, name: &str, sections: &[SectionValues]) {
        let section = |values: &SectionValues| {
            let node = |(key, value): &(&str, CaseValue)| {
                ((*key).to_owned(), value.node(&Origin::Nowhere))
            };
            Node::nowhere(Value::Section(values.iter().map(node).collect()))
        };
        self.remove(name);
        if !sections.is_empty() {
            let list = Value::List(sections.iter().map(section).collect());
            let root = &mut self.tree.root;
            root.insert(name.to_owned(), Node::nowhere(list));
        }
    }

    /// Removes a dotted key, or all sections of a name.
    pub fn remove(&mut self, key: &str) {
        let path: Vec<&str> = key.split('.').collect();
        let nowhere = Node::nowhere(Value::Other).place;
        if let Ok((section, key)) = section_at(&mut self.tree.root, &path, &nowhere) {
            section.remove(key);
        }
    }

    /// Enters rows of ψ and flank angle, rad, as the profile of a raceway, and its depth error, in the place of what
    /// was designed.
    pub fn enter_profile(&mut self, index: usize, rows: &[[f64; 2]], depth_error_m: f64) {
        let section = nth("raceway", index, self.count("raceway"));
        for designed in ["axial_span_mm", "half_angle_deg", "blend_mm"] {
            self.remove(&join(&section, designed));
        }
        let error_um = rounded(Unit::Micrometre, depth_error_m, 3);
        self.set(&join(&section, "depth_error_um"), error_um);
        let rounded = |angle: f64| rounded(Unit::Degree, angle, 6);
        let rows = rows.iter().map(|row| row.map(rounded)).collect();
        self.set(&join(&section, "shape"), "measured");
        self.set(&join(&section, "profile"), CaseValue::Table(rows));
    }

    /// Enters where the middle of a raceway was measured.
    pub fn enter_centre(&mut self, index: usize, centre_angle_rad: f64) {
        let section = nth("raceway", index, self.count("raceway"));
        let centre = rounded(Unit::Degree, centre_angle_rad, 6);
        self.set(&join(&section, "centre_angle_deg"), centre);
    }

    /// Enters the dimensions of a slot that was measured in the place of those of a raceway.
    pub fn enter_slot(&mut self, index: usize, slot: &MeasuredSlot) {
        let section = nth("raceway", index, self.count("raceway"));
        // Rounding must not make the slot shorter than its ends.
        let long_rad = slot.half_angle_rad.value + ROUNDING_RAD;
        let lengths = [
            ("axial_span_mm", Some(slot.axial_span_m.value)),
            ("edge_radius_mm", Some(slot.edge_radius_m.value)),
            ("slot_depth_mm", slot.slot_depth_m),
        ];
        let lengths = (lengths.into_iter())
            .filter_map(|(key, length)| Some((key, rounded(Unit::Millimetre, length?, 6))));
        let others = [
            ("half_angle_deg", rounded(Unit::Degree, long_rad, 9)),
            (
                "centre_angle_deg",
                rounded(Unit::Degree, slot.centre_angle_rad.value, 6),
            ),
            (
                "depth_error_um",
                rounded(Unit::Micrometre, slot.depth_error_m.value, 3),
            ),
        ];
        for (key, value) in lengths.chain(others) {
            self.set(&join(&section, key), value);
        }
    }

    /// The value of a dotted key; `None` if it is left out or not a key.
    pub fn value(&self, key: &str) -> Option<CaseValue> {
        let section = key.split_once('.').map_or("", |(section, _)| section);
        let name = key.rsplit_once('.').map_or(key, |(_, name)| name);
        let kind = keys::find(section, name)?.kind;
        kind.value(&self.tree.find(key)?.value)
    }

    /// The number of a dotted key; `None` if it is left out or no number.
    pub fn number(&self, key: &str) -> Option<f64> {
        self.tree.number(key)
    }

    /// Whether a dotted key has a value.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.tree.find(key).is_some()
    }

    /// Number of sections of a name.
    pub fn count(&self, section: &str) -> usize {
        self.tree.count(section)
    }

    /// The keys and values of every section, in the order of the file format.
    fn values(&self) -> Vec<(&'static str, Vec<SectionValues>)> {
        let value = |key: &Key, entries: &Section| {
            Some((key.name, key.kind.value(&entries.get(key.name)?.value)?))
        };
        let values = |keys: &'static [Key], entries: &Section| -> SectionValues {
            keys.iter().filter_map(|key| value(key, entries)).collect()
        };
        let mut all = vec![("", vec![values(CASE_FILE.head, &self.tree.root)])];
        for table in CASE_FILE.sections {
            let sections = self.tree.sections(table).unwrap_or_default();
            let sections = sections
                .iter()
                .map(|(_, entries)| values(table.keys, entries));
            all.push((table.name, sections.collect()));
        }
        all
    }

    /// The document as a case file.
    ///
    /// # Errors
    /// A [`CaseError`] if TOML cannot hold it.
    pub fn to_toml(&self) -> Result<String, CaseError> {
        self.to_toml_without(&[])
    }

    /// The document as a value of TOML.
    ///
    /// # Errors
    /// Those of [`CaseDocument::to_toml`].
    #[cfg(feature = "files")]
    pub fn to_value(&self) -> Result<toml::Value, CaseError> {
        toml::Value::try_from(self).map_err(unwritable)
    }

    /// The document as a case file without these dotted keys, those that took their default say;
    /// raceways are complete.
    ///
    /// # Errors
    /// Those of [`CaseDocument::to_toml`].
    pub fn to_toml_without(&self, left_out: &[String]) -> Result<String, CaseError> {
        toml::to_string(&Without(self, left_out)).map_err(unwritable)
    }
}

fn unwritable(error: toml::ser::Error) -> CaseError {
    CaseError::of_file("case", format!("cannot be written as TOML: {error}"))
}

/// A value in SI in the unit of a file: the conversion leaves rounding.
fn rounded(unit: Unit, value: f64, decimals: usize) -> f64 {
    let value = unit.of_si(value);
    format!("{value:.decimals$}").parse().unwrap_or(value)
}

/// Two documents are equal if they have the same keys and values, wherever those come from.
impl PartialEq for CaseDocument {
    fn eq(&self, other: &Self) -> bool {
        self.values() == other.values()
    }
}

impl Serialize for CaseDocument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Without(self, &[]).serialize(serializer)
    }
}

/// Whether the sections of a name are a list, also where there is only one.
fn is_list(name: &str) -> bool {
    let mut sections = CASE_FILE.sections.iter();
    name != "raceway" && sections.any(|section| section.name == name && section.several)
}

/// Keys and values as a map.
struct Keys<'a>(&'a SectionValues);

impl Serialize for Keys<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

/// A document without some dotted keys.
struct Without<'a>(&'a CaseDocument, &'a [String]);

impl Serialize for Without<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(document, left_out) = self;
        let mut map = serializer.serialize_map(None)?;
        for (name, mut each) in document.values() {
            if name.is_empty() {
                for (key, value) in each.iter().flatten() {
                    map.serialize_entry(key, value)?;
                }
                continue;
            }
            if let ([one], false) = (each.as_mut_slice(), name == "raceway") {
                one.retain(|(key, _)| !left_out.contains(&join(name, key)));
                if one.is_empty() && !left_out.is_empty() {
                    continue;
                }
            }
            match each.as_slice() {
                [] => {}
                [one] if !is_list(name) => map.serialize_entry(name, &Keys(one))?,
                several => {
                    let several: Vec<_> = several.iter().map(Keys).collect();
                    map.serialize_entry(name, &several)?;
                }
            }
        }
        map.end()
    }
}
