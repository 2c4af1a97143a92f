//! The case file: one computation, in TOML and in the units of the workshop.
//!
//! Every key is declared once, in the table of its section in `sections`: type, default, unit,
//! limits, field of [`cageless`], meaning and template line (`key` has the columns, `declaration`
//! what follows from a row). A case file is a tree of values with their places, a [`CaseDocument`].
//! Reading goes through four steps: `spanned_toml` (TOML to the tree), `overrides` (`--set`), `read`
//! (known keys and defaults) and `convert` (sections in SI units and the checks of [`cageless`]).
//! Every error becomes one [`CaseError`] that names the place, the key, the
//! value and what is allowed, in the unit of the file.

mod convert;
mod converter;
pub(crate) mod declaration;
mod document;
#[cfg(feature = "files")]
mod edited;
pub(crate) mod error;
mod fields;
pub(crate) mod format;
pub(crate) mod former;
mod heat;
mod json;
pub(crate) mod key;
pub(crate) mod keys;
mod messages;
mod missing;
pub(crate) mod named;
mod oil_temperature;
pub(crate) mod overrides;
pub(crate) mod read;
pub(crate) mod reader;
mod reference;
mod resting;
mod ring;
mod search_in_oil;
pub(crate) mod sections;
mod source;
pub(crate) mod spanned_toml;
mod template;
pub(crate) mod unit;
pub(crate) mod value;

use std::path::Path;

pub use document::{CaseDocument, SectionValues};
pub use error::CaseError;
pub use format::{SCHEMA, SectionTable, nearest};
pub use former::on_former_name;
pub(crate) use json::CASE_KIND;
pub use key::{Key, Kind, Presence};
pub use keys::{is_spatial, missing_rotor};
pub use overrides::Change;
pub use reference::{RangeEnd, reference};
pub use sections::bearing::Assumption;
pub use sections::material::{MaterialHeat, MaterialPreset};
pub(crate) use source::{is_json, read_named, source};
pub use template::{drop_template, template};
pub use value::CaseValue;

use cageless::Gaps;
use cageless::steady::{SteadyDraw, SteadyOperation};
use cageless::step_limits;
use cageless_design::search::Request;
use cageless_results::Particulars;
use convert::Check;
use spanned_toml::{Origin, join, nth};
use unit::Unit;

/// A case file that was read, checked and converted.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseFile {
    case: cageless::Case,
    particulars: Particulars,
    search: Request,
    steady: SteadyOperation,
    document: CaseDocument,
    defaults: Vec<String>,
    /// The text that was read; `None` of a document that was made by other means.
    text: Option<String>,
}

impl CaseFile {
    /// Reads a case file and applies `overrides`, each the text of one
    /// `--set section.key=value`.
    ///
    /// # Errors
    /// A [`CaseError`] if the file cannot be read, is not UTF-8 or is refused by
    /// [`CaseFile::parse`].
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let (name, text) = read_named(path, "case file")?;
        Self::parse(&text, &name, overrides)
    }

    /// Parses the text of a case file; `name` stands for it in messages.
    ///
    /// # Errors
    /// A [`CaseError`] for anything but a complete and possible case: bad TOML,
    /// unknown or missing keys, wrong types, impossible values.
    pub fn parse(text: &str, name: &str, overrides: &[String]) -> Result<Self, CaseError> {
        let mut document = CaseDocument::parse(text, name)?;
        overrides::apply(&mut document.tree.root, overrides)?;
        Ok(Self::of(document)?.with_text(text))
    }

    /// Completes and checks a document.
    pub(crate) fn of(document: CaseDocument) -> Result<Self, CaseError> {
        Self::checked_by(document, step_limits::check)
    }

    /// [`Self::of`] for a computation without steps, to which the step of the case is all one.
    #[cfg(feature = "files")]
    pub(crate) fn of_at_rest(document: CaseDocument) -> Result<Self, CaseError> {
        Self::checked_by(document, cageless::Case::check)
    }

    /// The case with the text that it was read from.
    pub(crate) fn with_text(self, text: &str) -> Self {
        Self {
            text: Some(text.to_owned()),
            ..self
        }
    }

    fn checked_by(mut document: CaseDocument, check: Check) -> Result<Self, CaseError> {
        let defaults = read::complete(&mut document)?;
        let convert::Converted {
            case,
            particulars,
            search,
            steady,
        } = convert::converted(&document, check)?;
        Ok(Self {
            case,
            particulars,
            search,
            steady,
            document,
            defaults,
            text: None,
        })
    }

    /// Checks a document that was made by other means than a file; `name` stands
    /// for it in messages. No key counts as a default.
    ///
    /// # Errors
    /// A [`CaseError`] without a line if the case is impossible.
    pub fn from_document(document: CaseDocument, name: &str) -> Result<Self, CaseError> {
        let mut document = document;
        name.clone_into(&mut document.tree.name);
        let nodes = document.tree.root.values_mut();
        nodes.for_each(spanned_toml::Node::forget_place);
        Ok(Self {
            defaults: Vec::new(),
            ..Self::of(document)?
        })
    }

    /// The case, of which is a default what is one in `other` with the same value.
    #[cfg(feature = "files")]
    pub(crate) fn with_defaults_of(mut self, other: &Self) -> Self {
        let same = |key: &&String| self.value(key) == other.value(key);
        self.defaults = other.defaults.iter().filter(same).cloned().collect();
        self
    }

    /// The case in SI units.
    pub fn case(&self) -> &cageless::Case {
        &self.case
    }

    /// Particulars of the case, for results and commands.
    pub fn particulars(&self) -> &Particulars {
        &self.particulars
    }

    /// Result of `check` on the case.
    ///
    /// # Errors
    /// A [`CaseError`] naming the key of the field that is refused.
    pub fn checked<T>(
        &self,
        check: impl FnOnce(&cageless::Case) -> Result<T, cageless::InputError>,
    ) -> Result<T, CaseError> {
        check(&self.case).map_err(|e| converter::refused_in(&self.document, None, &e, None))
    }

    /// Request of `[search]`, in SI units; without the section, the case's own operating
    /// point and one raceway anywhere that the geometry allows.
    pub fn search(&self) -> &Request {
        &self.search
    }

    /// The TOML that was read; `None` of JSON and of a document that was made by other means.
    #[cfg(feature = "files")]
    pub fn toml(&self) -> Option<&str> {
        self.text.as_deref().filter(|text| !source::is_json(text))
    }

    /// The case file with the values of `document`, which is this one changed: comments, order and
    /// what is as before stay as they are written, what nobody gave is not written. A case that
    /// was read from JSON is written in TOML.
    ///
    /// # Errors
    /// A [`CaseError`] if TOML cannot hold the document.
    #[cfg(feature = "files")]
    pub fn edited(&self, document: &CaseDocument) -> Result<String, CaseError> {
        match self.toml() {
            Some(text) => edited::edited(text, document, &self.defaults),
            None => document.to_toml_without(&self.defaults),
        }
    }

    /// The case in the units of the file, every default filled in. Values that follow from
    /// others are the exception: the Hertz stiffnesses and what is estimated stay out,
    /// so that the document can be changed; see [`CaseFile::document_as_run`].
    pub fn document(&self) -> &CaseDocument {
        &self.document
    }

    /// [`CaseFile::document`] with the stiffnesses that Hertz gives and the
    /// automatic step filled in as well: what a run used, for the record.
    pub fn document_as_run(&self) -> CaseDocument {
        let mut document = self.document.clone();
        let bearing = &self.case.bearing;
        sections::bearing::fill_in(&mut document.tree, bearing);
        let keys = [
            "contact.inner_stiffness_n_m1_5",
            "contact.outer_stiffness_n_m1_5",
            "contact.ball_stiffness_n_m1_5",
        ];
        for (key, stiffness) in keys.into_iter().zip(self.case.stiffness_n_m1_5()) {
            document.tree.set_missing(key, stiffness);
        }
        let raceways = &self.case.raceways;
        for (index, raceway) in raceways.iter().enumerate() {
            let section = nth("raceway", index, raceways.len());
            let d = raceway.dimensions();
            if raceway.slot().is_none() {
                let blend_mm = Unit::Millimetre.of_si(raceway.blend_m());
                document
                    .tree
                    .set_missing(&join(&section, "blend_mm"), blend_mm);
            }
            for (key, value) in [
                ("axial_span_mm", Unit::Millimetre.of_si(d.axial_span_m)),
                ("half_angle_deg", Unit::Degree.of_si(d.half_angle_rad)),
            ] {
                document.tree.set_missing(&join(&section, key), value);
            }
        }
        let knee_m_s = self.case.contact.friction.regularisation_speed_m_s;
        document.tree.set_missing(convert::REGULARISATION, knee_m_s);
        if self.has_automatic_step() {
            // Steps are chosen in decimals of a microsecond; the product has rounding in it.
            let step_us = (self.case.solver.step_s * 1e15).round() / 1e9;
            document.set("solver.step_us", step_us);
        }
        document
    }

    /// Whether the step follows from the case.
    pub(crate) fn has_automatic_step(&self) -> bool {
        self.value("solver.step_us") == Some("auto".into())
    }

    /// The case from uneven start number `start` under `seed`: each gap drawn evenly between 0
    /// and twice the mean, and scaled to the free angle. Bearings with the same gap 360°/N − ε
    /// get the same gaps.
    ///
    /// # Errors
    /// A [`CaseError`] if the case cannot start with these gaps.
    pub fn with_uneven_start(&self, seed: u64, start: u64) -> Result<Self, CaseError> {
        let gaps = Gaps::uneven_rad(&self.case.bearing, seed, start);
        let mut document = self.document.clone();
        let degrees = gaps.into_iter().map(f64::to_degrees);
        document.set("start.gaps", CaseValue::Numbers(degrees.collect()));
        self.with_document(document)
    }

    /// Steady operation of `[steady]`; without the section, the default.
    pub fn steady(&self) -> &SteadyOperation {
        &self.steady
    }

    /// The case with the balls and the start of one draw of its steady operation, for as long.
    ///
    /// # Errors
    /// A [`CaseError`] if the case cannot start so.
    pub fn with_draw(&self, seed: u64, draw: u64) -> Result<Self, CaseError> {
        let SteadyDraw {
            deviations_m,
            gaps_rad,
            lead_ball_angle_rad,
        } = self.steady.draw(&self.case, seed, draw);
        let list = |values: Vec<f64>, unit: Unit| {
            CaseValue::Numbers(values.into_iter().map(|v| unit.of_si(v)).collect())
        };
        let mut document = self.document.clone();
        document.set(
            "bearing.ball_radius_deviation_um",
            list(deviations_m, Unit::Micrometre),
        );
        document.set("start.gaps", list(gaps_rad, Unit::Degree));
        document.set(
            "start.lead_ball_angle_deg",
            Unit::Degree.of_si(lead_ball_angle_rad),
        );
        document.set("solver.duration_s", self.steady.duration_s(&self.case));
        document.set("solver.transient_s", self.steady.transient_s(&self.case));
        self.with_document(document)
    }

    /// The case with the simulated time of another, without a transient of its own.
    ///
    /// # Errors
    /// A [`CaseError`] if the case cannot be so.
    pub fn for_as_long_as(&self, other: &Self) -> Result<Self, CaseError> {
        let mut document = self.document.clone();
        document.set("solver.duration_s", other.case.solver.duration_s);
        document.remove("solver.transient_s");
        self.with_document(document)
    }

    /// The case with another number of balls in a row, without what depends on it.
    ///
    /// # Errors
    /// A [`CaseError`] if the bearing does not take them.
    pub fn with_balls(&self, balls: usize) -> Result<Self, CaseError> {
        let mut document = self.document.clone();
        document.set("bearing.balls", balls as i64);
        if let Some(given) = self.case.bearing.ball_radius_deviations_m().get(..balls) {
            let um = given.iter().map(|v| Unit::Micrometre.of_si(*v)).collect();
            document.set("bearing.ball_radius_deviation_um", CaseValue::Numbers(um));
        }
        document.remove("start.gaps");
        self.with_document(document)
    }

    /// The case with a conventional outer ring, without discrete raceways, and the step of this
    /// one.
    ///
    /// # Errors
    /// A [`CaseError`] if the case is not possible without its raceways.
    pub fn with_conventional_ring(&self) -> Result<Self, CaseError> {
        let mut document = self.document_as_run();
        document.remove("raceway");
        self.with_document(document)
    }

    /// The case with raceways as they may be machined.
    ///
    /// # Errors
    /// A [`CaseError`] if such a raceway is not possible, or has no dimensions of its own, such as a measured one.
    pub fn with_machined_raceways(&self, errors: &MachiningErrors) -> Result<Self, CaseError> {
        let mut document = self.document.clone();
        for (k, raceway) in self.case.raceways.iter().enumerate() {
            let section = nth("raceway", k, self.case.raceways.len());
            let designed = raceway.dimensions();
            let span_m = designed.axial_span_m + errors.axial_span_m;
            let half_rad = designed.half_angle_rad + errors.half_angle_rad;
            let depth_m = raceway.depth_error_m() + errors.groove_depth_m;
            for (key, unit, value) in [
                ("axial_span_mm", Unit::Millimetre, span_m),
                ("half_angle_deg", Unit::Degree, half_rad),
                ("depth_error_um", Unit::Micrometre, depth_m),
            ] {
                document.set(&join(&section, key), unit.of_si(value));
            }
        }
        self.with_document(document)
    }

    /// The case with ends of its raceways that are as sharp as they can be, where the file does not say how long a blend is.
    ///
    /// # Errors
    /// A [`CaseError`] if the case cannot be so.
    pub(crate) fn without_default_blends(&self) -> Result<Self, CaseError> {
        let mut document = self.document.clone();
        let count = self.case.raceways.len();
        for (k, raceway) in self.case.raceways.iter().enumerate() {
            let key = join(&nth("raceway", k, count), "blend_mm");
            if raceway.blend_m() > 0.0 && !document.has(&key) {
                document.set(&key, 0.0);
            }
        }
        self.with_document(document)
    }

    /// The case without its raceways, the number of its balls and what does not change the motion: equal for two
    /// cases that differ in nothing but these.
    pub fn apart_from_remedies(&self) -> CaseDocument {
        let mut document = self.document_as_run();
        document.remove("raceway");
        for of_balls in [
            "bearing.balls",
            "bearing.ball_radius_deviation_um",
            "start.gaps",
        ] {
            document.remove(of_balls);
        }
        document.set("title", "");
        document.remove("search");
        // An automatic step follows the raceway.
        document.set("solver.step_us", "auto");
        document
    }

    fn with_document(&self, document: CaseDocument) -> Result<Self, CaseError> {
        Ok(Self {
            defaults: self.defaults.clone(),
            ..Self::of(document)?
        })
    }

    /// Values of `[bearing]` that are left out and estimated from its dimensions.
    pub fn assumptions(&self) -> Vec<Assumption> {
        sections::bearing::assumptions(&self.document.tree, self.case.bearing.dimensions())
    }

    /// The value of a dotted key, its default if it has one; `None` if it is left out or
    /// not a key.
    pub fn value(&self, key: &str) -> Option<CaseValue> {
        self.document.value(key)
    }

    /// Origin of the value of a dotted key of [`CaseFile::document_as_run`].
    pub fn source(&self, key: &str) -> Source {
        if self.defaults.iter().any(|d| d == key) {
            return Source::Default;
        }
        match self.document.tree.find(key).map(|node| &node.place.origin) {
            Some(Origin::Override(_)) => Source::Override,
            Some(Origin::Elsewhere(..)) => Source::Plan,
            _ => Source::CaseFile,
        }
    }

    /// Dotted keys that the file left out and that took their default, in the
    /// order of the file format.
    pub fn defaults(&self) -> &[String] {
        &self.defaults
    }
}

impl CaseDocument {
    /// The case with `changes`.
    ///
    /// # Errors
    /// A [`CaseError`] that names file and line of the change at fault, or of the document.
    pub fn with(&self, changes: &[Change<'_>]) -> Result<CaseFile, CaseError> {
        let mut document = self.clone();
        document.change(changes)?;
        CaseFile::of(document)
    }
}

/// Errors of the machining of all raceways of a ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MachiningErrors {
    /// Depth in the middle, m; positive: deeper.
    pub groove_depth_m: f64,
    /// Axial span lC, m.
    pub axial_span_m: f64,
    /// Half angle θ, rad.
    pub half_angle_rad: f64,
}

cageless::named_enum! {
    /// Origin of a value of a case.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Source {
        /// The key is left out.
        Default = "default",
        /// The case file, or the document that stands for it.
        CaseFile = "case file",
        /// A `--set` of the command line, or a replacement.
        Override = "--set",
        /// The plan of a sweep.
        Plan = "plan",
    }
}

/// The unit of a dotted key as it is printed; empty if it has none.
pub fn unit(key: &str) -> String {
    let section = key.split_once('.').map_or("", |(section, _)| section);
    let name = key.rsplit_once('.').map_or(key, |(_, name)| name);
    keys::find(section, name).map_or_else(String::new, Key::unit)
}

/// Every key of a case file with its dotted name, `raceway.axial_span_mm`, in the order of the file
/// format.
pub fn keys() -> impl Iterator<Item = (String, &'static Key)> {
    keys::all().map(|(section, key)| (join(section, key.name), key))
}
