//! Texts of bearings and rotor whose values are replaced before they are read.

use std::path::Path;

use crate::case_file::overrides::Replacement;
use crate::case_file::spanned_toml::Section;
use crate::case_file::{CaseDocument, CaseError, Change, is_json, read_named, source};
use crate::rotor_file::RotorSource;
use crate::rotor_file::address::{Address, address};

/// The text of a case file, or those of a rotor file and of its cases, parsed but not yet read.
#[derive(Debug, Clone)]
pub struct ArrangementDocument {
    /// The sections of a rotor file; `None` of a case file.
    pub(super) rotor: Option<RotorSource>,
    pub(super) cases: Vec<CaseDocument>,
}

impl ArrangementDocument {
    /// Reads a case file, once (it may be a pipe), or a rotor file with the files that it names,
    /// whose paths count from its folder.
    ///
    /// # Errors
    /// A [`CaseError`] if a file cannot be read or is not TOML, or a bearing has no case.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        Self::read_with_text(path).map(|(document, _)| document)
    }

    pub(super) fn read_with_text(path: &Path) -> Result<(Self, String), CaseError> {
        let (name, text) = read_named(path, "case file")?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Ok((Self::parse(&text, &name, folder)?, text))
    }

    pub(super) fn parse(text: &str, name: &str, folder: &Path) -> Result<Self, CaseError> {
        let root = source(text, name)?;
        match is_json(text) {
            // A document in JSON has one case.
            true => Ok(CaseDocument::from_sections(root, name).into()),
            false => Self::from_sections(root, name, folder),
        }
    }

    /// Takes the sections of the file `name`; paths in it are relative to `folder`.
    pub(crate) fn from_sections(
        root: Section,
        name: &str,
        folder: &Path,
    ) -> Result<Self, CaseError> {
        if !RotorSource::is_in(&root) {
            return Ok(CaseDocument::from_sections(root, name).into());
        }
        let (rotor, cases) = RotorSource::from_sections(root, name, folder)?;
        Ok(Self {
            rotor: Some(rotor),
            cases,
        })
    }

    /// Whether this is a rotor file.
    pub(crate) fn is_rotor_file(&self) -> bool {
        self.rotor.is_some()
    }

    /// Replaces values for good: keys of the rotor file, `section.key` of the cases of all
    /// bearings, `bearing.2.section.key` of one.
    ///
    /// # Errors
    /// A [`CaseError`] if a key has no place. Whether it exists and the value fits,
    /// [`ArrangementDocument::with`] says.
    pub fn change(&mut self, changes: &[Change<'_>]) -> Result<(), CaseError> {
        let mut changes = changes.iter().map(Replacement::from_change);
        changes.try_for_each(|change| self.replace(&change))
    }

    /// The document with the replacements of `--set` of these texts.
    pub(super) fn overridden(mut self, overrides: &[String]) -> Result<Self, CaseError> {
        for text in overrides {
            self.replace(&Replacement::from_override(text)?)?;
        }
        Ok(self)
    }

    fn replace(&mut self, replacement: &Replacement) -> Result<(), CaseError> {
        let path: Vec<&str> = replacement.path.iter().map(String::as_str).collect();
        match address(self.is_rotor_file(), &path) {
            Err(message) => Err(replacement.error(message)),
            Ok(Address::Rotor) => {
                let mut rotor = self.rotor.iter_mut();
                rotor.try_for_each(|rotor| rotor.replace(replacement))
            }
            Ok(Address::Case(None, _)) => {
                let mut cases = self.cases.iter_mut();
                cases.try_for_each(|case| case.replace(replacement))
            }
            Ok(Address::Case(Some(k), key)) => match self.cases.get_mut(k) {
                Some(case) => case.replace(&Replacement {
                    path: key.iter().map(|part| (*part).to_owned()).collect(),
                    node: replacement.node.clone(),
                }),
                None => {
                    let count = self.cases.len();
                    let message = format!("there are {count} [[bearing]] sections, counted from 1");
                    Err(replacement.error(message))
                }
            },
        }
    }
}

impl From<CaseDocument> for ArrangementDocument {
    fn from(case: CaseDocument) -> Self {
        Self {
            rotor: None,
            cases: vec![case],
        }
    }
}
