//! Bearings with the rotor above them: what a case file or a rotor file describes, a plan varies
//! and a drop computes.
//!
//! A case file has one bearing, with or without a rotor. A rotor file lists its bearings, each with
//! a case of its own.

mod document;

use std::path::Path;

use cageless::Case;
use cageless::linear_rotor::{LinearRotor, RotorError};
use cageless::simulation::RotorDrop;
use toml::Value;

use crate::case_file::{CASE_KIND, CaseDocument, CaseError, CaseFile, CaseValue, Change};
use crate::rotor_file::address::{Address, address};
use crate::rotor_file::{ReadRotor, RotorDescription, RotorFileDocument};

pub use document::ArrangementDocument;

/// Bearings with the rotor above them, read and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingArrangement {
    /// The rotor file with the cases as it gives them; `None` of a case file.
    rotor_file: Option<RotorFileDocument>,
    bearings: Vec<CaseFile>,
    drop: Option<RotorDrop>,
}

impl From<CaseFile> for BearingArrangement {
    fn from(file: CaseFile) -> Self {
        Self {
            rotor_file: None,
            drop: RotorDrop::of_case(file.case()),
            bearings: vec![file],
        }
    }
}

impl BearingArrangement {
    /// A rotor at `speed_rpm` under `drive_torque_n_m` above the bearings of `cases`. Steps are as
    /// long as the shortest that a case gives, and automatic if none gives one.
    ///
    /// # Errors
    /// Those of [`RotorDescription::linear`] and [`RotorDrop::new`].
    pub fn new(
        title: &str,
        rotor: &RotorDescription,
        speed_rpm: f64,
        drive_torque_n_m: f64,
        cases: &[CaseFile],
    ) -> Result<Self, RotorError> {
        let document = RotorFileDocument {
            title: title.to_owned(),
            rotor: rotor.clone(),
            speed_rpm,
            drive_torque_n_m,
            cases: cases.iter().map(|case| case.document().clone()).collect(),
        };
        Self::below(rotor.linear()?, document, cases)
    }

    /// The bearings of `cases` below the rotor of a document whose lateral motion is `rotor`.
    fn below(
        rotor: LinearRotor,
        document: RotorFileDocument,
        cases: &[CaseFile],
    ) -> Result<Self, RotorError> {
        let (title, speed_rpm) = (document.title.as_str(), document.speed_rpm);
        let drive_torque_n_m = document.drive_torque_n_m;
        let given = cases.iter().filter_map(|file| {
            let automatic = file.has_automatic_step();
            (!automatic).then_some(file.case().solver.step_s)
        });
        let step = given.reduce(f64::min);
        let speed_rad_s = speed_rpm * std::f64::consts::TAU / 60.0;
        let own = cases.iter().map(|file| file.case().clone()).collect();
        let drop = RotorDrop::new(rotor, speed_rad_s, drive_torque_n_m, own, step)?;
        let mut bearings = vec![];
        for (k, (file, case)) in cases.iter().zip(drop.cases()).enumerate() {
            let mut document = file.document().clone();
            document.set("title", bearing_title(title, k, cases.len()).as_str());
            document.set("solver.step_us", 1e6 * case.solver.step_s);
            if let Some(rotor) = &case.rotor {
                document.set("rotor.mass_kg", rotor.mass_kg);
                document.set("rotor.polar_inertia_kg_m2", rotor.polar_inertia_kg_m2);
                document.set("rotor.speed_rpm", speed_rpm);
                document.set("rotor.eccentricity_um", 0.0);
                document.set("rotor.drive_torque_n_m", drive_torque_n_m);
            }
            let carried = CaseFile::from_document(document, &format!("bearing {}", k + 1))
                .map_err(|error| RotorError::Bearings(error.to_string()))?;
            bearings.push(carried.with_defaults_of(file));
        }
        Ok(Self {
            rotor_file: Some(document),
            bearings,
            drop: Some(drop),
        })
    }

    /// Reads a case file, once, or a rotor file with the files that it names, whose paths count
    /// from its folder. `overrides` are the texts of `--set`: below a rotor file
    /// `section.key=value` of the cases of all bearings, `bearing.2.section.key=value` of one.
    ///
    /// # Errors
    /// A [`CaseError`] if one of the files cannot be read, or for anything but possible bearings
    /// and a complete and possible rotor.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let (document, text) = ArrangementDocument::read_with_text(path)?;
        document.overridden(overrides)?.file(CaseFile::of, &text)
    }

    /// [`Self::read`] for a computation without steps, to which the step of a case file is all one.
    ///
    /// # Errors
    /// Those of [`Self::read`], apart from that of a step too long for the method of a case.
    pub fn read_at_rest(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let (document, text) = ArrangementDocument::read_with_text(path)?;
        document
            .overridden(overrides)?
            .file(CaseFile::of_at_rest, &text)
    }

    /// Parses the text of a case file or rotor file; `name` stands for it in messages, paths in it
    /// count from `folder`.
    ///
    /// # Errors
    /// Those of [`Self::read`].
    pub fn parse(
        text: &str,
        name: &str,
        folder: &Path,
        overrides: &[String],
    ) -> Result<Self, CaseError> {
        let document = ArrangementDocument::parse(text, name, folder)?;
        document.overridden(overrides)?.file(CaseFile::of, text)
    }

    /// The file with changes, as [`Self::read`] takes them.
    ///
    /// # Errors
    /// Those of [`Self::parse`].
    pub fn changed(&self, changes: &[String]) -> Result<Self, CaseError> {
        Self::parse(&self.to_toml()?, self.kind(), Path::new(""), changes)
    }

    /// Kind of the file: `case` or `rotor`.
    pub fn kind(&self) -> &'static str {
        match self.rotor_file {
            None => CASE_KIND,
            Some(_) => "rotor",
        }
    }

    /// Passes a file whose motion can be computed.
    ///
    /// # Errors
    /// A [`CaseError`] that names what motion in space does not have, or a step that does not resolve it.
    pub fn check_motion(&self) -> Result<(), CaseError> {
        let mut cases = self.bearings.iter();
        cases.try_for_each(|file| file.checked(Case::check_run))
    }

    /// Free text.
    pub fn title(&self) -> &str {
        match &self.rotor_file {
            None => &self.bearings[0].particulars().title,
            Some(file) => &file.title,
        }
    }

    /// The drop of the rotor; `None` of a case without one.
    pub fn drop(&self) -> Option<&RotorDrop> {
        self.drop.as_ref()
    }

    /// The rotor file with its cases and every default; `None` of a case file.
    pub fn rotor_file(&self) -> Option<&RotorFileDocument> {
        self.rotor_file.as_ref()
    }

    /// The case of each bearing, below a rotor file as one plane of the rotor: with the part of the
    /// mass that the bearing carries and without unbalance.
    pub fn cases(&self) -> &[CaseFile] {
        &self.bearings
    }

    /// The case of a case file; `None` of a rotor file.
    pub fn case(&self) -> Option<&CaseFile> {
        match self.rotor_file {
            None => self.bearings.first(),
            Some(_) => None,
        }
    }

    /// The cases of the bearings that a key concerns; none of a key of the rotor of a rotor file.
    pub fn cases_of(&self, key: &str) -> &[CaseFile] {
        let path: Vec<&str> = key.split('.').collect();
        match self.address(&path) {
            Ok(Address::Case(Some(k), _)) => self.bearings.get(k..=k).unwrap_or_default(),
            Ok(Address::Case(None, _)) => &self.bearings,
            _ => &[],
        }
    }

    /// The values of a key as `--set` names it, its default if it has one: one of a key of the
    /// rotor or of one bearing, one for each bearing of a key of all cases; `None` where it is left
    /// out or no key.
    pub fn values(&self, key: &str) -> Vec<Option<CaseValue>> {
        let path: Vec<&str> = key.split('.').collect();
        match self.address(&path) {
            Err(_) => vec![None],
            Ok(Address::Rotor) => {
                vec![self.rotor_file.as_ref().and_then(|file| file.value(key))]
            }
            Ok(Address::Case(Some(k), key)) => {
                vec![self.given(k).and_then(|case| case.value(&key.join(".")))]
            }
            Ok(Address::Case(None, _)) => (0..self.bearings.len())
                .map(|k| self.given(k)?.value(key))
                .collect(),
        }
    }

    /// The name that a key of the case of bearing `k`, from 0, has in `--set`.
    pub fn key_in(&self, k: usize, key: &str) -> String {
        match self.rotor_file {
            None => key.to_owned(),
            Some(_) => format!("bearing.{}.{key}", k + 1),
        }
    }

    /// The file with every default filled in, which needs no other.
    ///
    /// # Errors
    /// A [`CaseError`] if TOML cannot hold it.
    pub fn to_toml(&self) -> Result<String, CaseError> {
        match &self.rotor_file {
            None => self.bearings[0].document().to_toml(),
            Some(file) => file.to_toml(),
        }
    }

    /// [`Self::to_toml`] of a rotor file; `None` of a case file.
    ///
    /// # Errors
    /// Those of [`Self::to_toml`].
    pub fn rotor_toml(&self) -> Result<Option<String>, CaseError> {
        let file = self.rotor_file.as_ref();
        file.map(RotorFileDocument::to_toml).transpose()
    }

    /// [`Self::to_toml`] as a value.
    ///
    /// # Errors
    /// Those of [`Self::to_toml`].
    pub fn to_value(&self) -> Result<Value, CaseError> {
        match &self.rotor_file {
            None => self.bearings[0].document().to_value(),
            Some(file) => file.to_value(),
        }
    }

    /// The case of bearing `k` as the file gives it.
    fn given(&self, k: usize) -> Option<&CaseDocument> {
        match &self.rotor_file {
            None => self.bearings.get(k).map(CaseFile::document),
            Some(file) => file.cases.get(k),
        }
    }

    /// The file with the text of a case file that it was read from.
    fn with_text(mut self, text: &str) -> Self {
        if self.rotor_file.is_none() {
            let bearings = self.bearings.into_iter();
            self.bearings = bearings.map(|file| file.with_text(text)).collect();
        }
        self
    }

    fn address<'k>(&self, path: &'k [&'k str]) -> Result<Address<'k>, String> {
        address(self.rotor_file.is_some(), path)
    }
}

impl ArrangementDocument {
    /// The bearings and the rotor with `changes`.
    ///
    /// # Errors
    /// Those of [`ArrangementDocument::change`], and for anything but possible bearings and a complete
    /// and possible rotor; the error names file and line of the change at fault, or of the base.
    pub fn with(&self, changes: &[Change<'_>]) -> Result<BearingArrangement, CaseError> {
        let mut base = self.clone();
        base.change(changes)?;
        base.arrangement(CaseFile::of)
    }

    /// The bearings and the rotor; `read` takes the case of a case file.
    fn arrangement(
        mut self,
        read: fn(CaseDocument) -> Result<CaseFile, CaseError>,
    ) -> Result<BearingArrangement, CaseError> {
        let Some(source) = &self.rotor else {
            return Ok(read(self.cases.swap_remove(0))?.into());
        };
        let ReadRotor {
            document,
            rotor,
            cases,
        } = source.read(&self.cases)?;
        BearingArrangement::below(rotor, document, &cases).map_err(|error| source.refused(&error))
    }

    /// [`Self::arrangement`] of the text of a file.
    fn file(
        self,
        read: fn(CaseDocument) -> Result<CaseFile, CaseError>,
        text: &str,
    ) -> Result<BearingArrangement, CaseError> {
        Ok(self.arrangement(read)?.with_text(text))
    }
}

/// "title: bearing 1 of 2".
fn bearing_title(title: &str, k: usize, count: usize) -> String {
    let bearing = format!("bearing {} of {count}", k + 1);
    if title.is_empty() {
        bearing
    } else {
        format!("{title}: {bearing}")
    }
}
