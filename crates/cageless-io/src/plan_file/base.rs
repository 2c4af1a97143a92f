//! What the variants of a plan share: a case, or a rotor above several bearings.

use std::path::Path;
use std::slice;

use cageless::Case;
use cageless::simulation::RotorDrop;
use toml::Value;

use crate::case_file::{CaseDocument, CaseError, CaseFile, CaseValue, Change, read_named};
use crate::rotor_file::{RotorBase, RotorFile};

/// A case or a rotor file whose values are replaced before it is read.
#[derive(Debug, Clone)]
pub enum PlanBase {
    /// The case of one bearing.
    Case(CaseDocument),
    /// A rotor above several bearings.
    Rotor(RotorBase),
}

/// A case or a rotor file, read and checked: what a variant or a drop computes.
#[derive(Debug, Clone, PartialEq)]
pub enum VariantFile {
    /// The case of one bearing.
    Case(Box<CaseFile>),
    /// A rotor above several bearings.
    Rotor(Box<RotorFile>),
}

impl PlanBase {
    /// Reads the text of a case file or of a rotor file, once: it may be a pipe.
    ///
    /// # Errors
    /// A [`CaseError`] if a file cannot be read or is not TOML, or a bearing has no case.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let (name, text) = read_named(path, "case file")?;
        match RotorBase::is_text(&text) {
            false => CaseDocument::parse(&text, &name).map(Self::Case),
            true => RotorBase::parse(&text, &name, folder(path)).map(Self::Rotor),
        }
    }

    /// Replaces values for good.
    ///
    /// # Errors
    /// A [`CaseError`] if a key has no place. Whether it exists and the value fits,
    /// [`PlanBase::with`] says.
    pub fn change(&mut self, changes: &[Change<'_>]) -> Result<(), CaseError> {
        match self {
            Self::Case(base) => base.change(changes),
            Self::Rotor(base) => base.change(changes),
        }
    }

    /// The case or the rotor with `changes`.
    ///
    /// # Errors
    /// A [`CaseError`] that names file and line of the change at fault, or of the base.
    pub fn with(&self, changes: &[Change<'_>]) -> Result<VariantFile, CaseError> {
        match self {
            Self::Case(base) => Ok(base.with(changes)?.into()),
            Self::Rotor(base) => Ok(base.with(changes)?.into()),
        }
    }
}

/// The folder of a file, from which paths in it count.
fn folder(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

impl From<CaseFile> for VariantFile {
    fn from(file: CaseFile) -> Self {
        Self::Case(Box::new(file))
    }
}

impl From<RotorFile> for VariantFile {
    fn from(file: RotorFile) -> Self {
        Self::Rotor(Box::new(file))
    }
}

impl VariantFile {
    /// Passes a file whose motion can be computed.
    ///
    /// # Errors
    /// A [`CaseError`] that names what motion in space does not have.
    pub fn check_motion(&self) -> Result<(), CaseError> {
        let mut cases = self.cases().iter();
        cases.try_for_each(|file| file.checked(Case::check_motion))
    }

    /// Reads a case file, once, or a rotor file with the files that it names.
    ///
    /// # Errors
    /// Those of [`CaseFile::read`] and [`RotorFile::read`].
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        Self::read_by(CaseFile::parse, path, overrides)
    }

    /// [`Self::read`] for a computation without steps, see [`CaseFile::parse_at_rest`].
    ///
    /// # Errors
    /// Those of [`CaseFile::parse_at_rest`] and [`RotorFile::read`].
    pub fn read_at_rest(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        Self::read_by(CaseFile::parse_at_rest, path, overrides)
    }

    fn read_by(
        parse: impl Fn(&str, &str, &[String]) -> Result<CaseFile, CaseError>,
        path: &Path,
        overrides: &[String],
    ) -> Result<Self, CaseError> {
        let (name, text) = read_named(path, "case file")?;
        Ok(match RotorBase::is_text(&text) {
            false => parse(&text, &name, overrides)?.into(),
            true => RotorFile::parse(&text, &name, folder(path), overrides)?.into(),
        })
    }

    /// The file with changes, each `section.key=value`, of one bearing of several
    /// `bearing.2.section.key=value`.
    ///
    /// # Errors
    /// Those of [`CaseFile::parse`] and [`RotorFile::changed`].
    pub fn changed(&self, changes: &[String]) -> Result<Self, CaseError> {
        Ok(match self {
            Self::Case(file) => {
                CaseFile::parse(&file.document().to_toml()?, "case", changes)?.into()
            }
            Self::Rotor(file) => file.changed(changes)?.into(),
        })
    }

    /// Free text.
    pub fn title(&self) -> &str {
        match self {
            Self::Case(file) => &file.particulars().title,
            Self::Rotor(file) => file.title(),
        }
    }

    /// The drop of the rotor; `None` of a case without one.
    pub fn drop(&self) -> Option<RotorDrop> {
        match self {
            Self::Case(file) => RotorDrop::of_case(file.case()),
            Self::Rotor(file) => Some(RotorFile::drop(file).clone()),
        }
    }

    /// The rotor file with its cases and matrices, which needs no other; `None` of a case.
    ///
    /// # Errors
    /// None that a file can cause.
    pub fn rotor_toml(&self) -> Result<Option<String>, CaseError> {
        match self {
            Self::Case(_) => Ok(None),
            Self::Rotor(file) => file.document().to_toml().map(Some),
        }
    }

    /// The case of each bearing.
    pub fn cases(&self) -> &[CaseFile] {
        match self {
            Self::Case(file) => slice::from_ref(file),
            Self::Rotor(file) => file.bearings(),
        }
    }

    /// The cases of the bearings that a key concerns; none of a key of the rotor.
    pub fn cases_of(&self, key: &str) -> &[CaseFile] {
        match self {
            Self::Case(file) => slice::from_ref(file),
            Self::Rotor(file) => &file.bearings()[file.bearings_of(key)],
        }
    }

    /// The value of a dotted key, its default if it has one, for each bearing that it concerns;
    /// `None` if it is left out or not a key.
    pub fn values(&self, key: &str) -> Vec<Option<CaseValue>> {
        match self {
            Self::Case(file) => vec![file.value(key)],
            Self::Rotor(file) => file.values(key),
        }
    }

    /// The document of the case or of the rotor, every default filled in.
    pub(super) fn document(&self) -> Result<Value, CaseError> {
        match self {
            Self::Case(file) => Value::try_from(file.document()).map_err(|e| {
                CaseError::of_file("", format!("the case cannot be written as TOML: {e}"))
            }),
            Self::Rotor(file) => file.document().to_value(),
        }
    }
}
