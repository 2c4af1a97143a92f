//! A case file as data: exactly the keys of the TOML, in the units of the file.
//! The last words of each name are its unit; [`cageless::Case`] says what each
//! quantity is.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::declaration::SectionDocument;
use super::error::CaseError;
use super::file_reader::FileReader;
use super::key::Line::Shown;
use super::key::{Key, Kind, Line, Presence, Values};
pub use super::sections::bearing::{Assumption, BearingDocument};
pub use super::sections::contact::ContactDocument;
pub use super::sections::housing::HousingDocument;
pub use super::sections::material::{MaterialDocument, MaterialPreset, PartMaterialDocument};
pub use super::sections::model::ModelDocument;
pub use super::sections::operation::OperationDocument;
pub use super::sections::output::OutputDocument;
pub use super::sections::raceway::RacewayDocument;
pub use super::sections::rotor::RotorDocument;
pub use super::sections::search::SearchDocument;
pub use super::sections::solver::SolverDocument;
pub use super::sections::start::StartDocument;
pub use super::sections::support::SupportDocument;
use super::spanned_toml::join;
use super::unit::Unit;
use super::value::CaseValue;

/// The only schema of case files so far.
pub const SCHEMA: u64 = 1;

/// One section of the file format.
#[derive(Debug)]
pub(crate) struct SectionTable {
    pub name: &'static str,
    /// What the section holds.
    pub meaning: &'static str,
    pub keys: &'static [Key],
    /// Whether the section may be left out as a whole, and then has no values.
    pub optional: bool,
    /// Its heading in the template: in force or not, with a comment.
    pub heading: Heading,
}

/// Heading of a section in the template.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Heading {
    /// In force.
    Shown(&'static str),
    /// The whole section is commented out.
    Commented(&'static str),
    /// The template does not have it.
    Absent,
}

/// A kind of section: required or with defaults, optional, or several of one name.
pub(super) trait SectionField: Sized {
    const KEYS: &'static [Key];
    const OPTIONAL: bool;

    fn read(file: &mut FileReader<'_>, name: &'static str) -> Result<Self, CaseError>;

    /// The keys of each section of the name.
    fn each(&self) -> Vec<Values>;
}

impl<D: SectionDocument> SectionField for D {
    const KEYS: &'static [Key] = D::KEYS;
    const OPTIONAL: bool = false;

    fn read(file: &mut FileReader<'_>, name: &'static str) -> Result<Self, CaseError> {
        D::read(&mut file.section(name, D::KEYS)?)
    }

    fn each(&self) -> Vec<Values> {
        vec![self.values()]
    }
}

impl<D: SectionDocument> SectionField for Option<D> {
    const KEYS: &'static [Key] = D::KEYS;
    const OPTIONAL: bool = true;

    fn read(file: &mut FileReader<'_>, name: &'static str) -> Result<Self, CaseError> {
        file.has(name)
            .then(|| D::read(&mut file.section(name, D::KEYS)?))
            .transpose()
    }

    fn each(&self) -> Vec<Values> {
        self.iter().map(D::values).collect()
    }
}

impl<D: SectionDocument> SectionField for Vec<D> {
    const KEYS: &'static [Key] = D::KEYS;
    const OPTIONAL: bool = true;

    fn read(file: &mut FileReader<'_>, name: &'static str) -> Result<Self, CaseError> {
        file.sections(name, D::KEYS, D::read)
    }

    fn each(&self) -> Vec<Values> {
        self.iter().map(D::values).collect()
    }
}

/// Declares the sections in the order of the file format.
macro_rules! case_document {
    ($( $section:ident: $Document:ty, $meaning:literal, $heading:expr; )*) => {
        /// A whole case file, every default filled in. Serialised, it is the case in
        /// `summary.json`. One discrete raceway is written as a `[raceway]`, several as
        /// `[[raceway]]`.
        #[derive(Debug, Clone, PartialEq)]
        pub struct CaseDocument {
            /// Version of the file format.
            pub schema: u64,
            /// Free text.
            pub title: String,
            $( #[doc = $meaning] pub $section: $Document, )*
        }

        /// Sections and what each holds, in the order of the template.
        pub(crate) const SECTIONS: &[SectionTable] = &[ $( SectionTable {
            name: stringify!($section),
            meaning: $meaning,
            keys: <$Document as SectionField>::KEYS,
            optional: <$Document as SectionField>::OPTIONAL,
            heading: $heading,
        }, )* ];

        impl CaseDocument {
            pub(super) fn read(
                schema: u64,
                title: String,
                file: &mut FileReader<'_>,
            ) -> Result<Self, CaseError> {
                $( let $section = SectionField::read(file, stringify!($section))?; )*
                Ok(Self { schema, title, $( $section, )* })
            }

            /// Every section with its keys and values.
            fn sections(&self) -> Vec<(&'static str, Vec<Values>)> {
                vec![ $( (stringify!($section), self.$section.each()), )* ]
            }
        }
    };
}

case_document! {
    bearing: BearingDocument, "dimensions and masses of rings and balls", Heading::Shown("");
    material: MaterialDocument, "elastic material of rings and balls",
        Heading::Shown("of rings and balls: bearing steel");
    ball_material: Option<PartMaterialDocument>, "material of the balls, if different",
        Heading::Commented("of the balls, if different (hybrid bearing)");
    ring_material: Option<PartMaterialDocument>, "material of the rings, if different",
        Heading::Commented("of the rings, if different");
    raceway: Vec<RacewayDocument>, "the discrete raceway",
        Heading::Shown("several: [[raceway]] sections; none: a conventional ring");
    operation: OperationDocument, "speed and load", Heading::Shown("");
    contact: ContactDocument, "friction, damping and stiffness", Heading::Shown("");
    model: ModelDocument, "the set of equations", Heading::Shown("");
    start: StartDocument, "the initial state",
        Heading::Commented("the whole section may be left out");
    solver: SolverDocument, "integration", Heading::Shown("");
    housing: Option<HousingDocument>, "the support of the outer ring",
        Heading::Commented("support of the outer ring; gives its vibration");
    rotor: Option<RotorDocument>, "a rotor that falls onto the inner ring",
        Heading::Absent;
    support: Option<SupportDocument>, "support of the outer ring under a falling rotor",
        Heading::Absent;
    output: OutputDocument, "what a run writes", Heading::Shown("");
    search: Option<SearchDocument>, "what a search for the raceway looks at",
        Heading::Commented("ranges of `design --search`");
}

const fn head(
    name: &'static str,
    kind: Kind,
    presence: fn() -> Presence<Option<CaseValue>>,
    meaning: &'static str,
    line: Line,
) -> Key {
    Key {
        name,
        formerly: "",
        unit: Unit::None,
        field: "",
        meaning,
        kind,
        presence,
        line,
    }
}

/// Keys of the head of the file.
pub(crate) const HEAD: &[Key] = &[
    head(
        "schema",
        Kind::Whole,
        || Presence::Default(Some(CaseValue::Integer(SCHEMA as i64))),
        "version of the file format",
        Shown("1", "version of this file format"),
    ),
    head(
        "title",
        Kind::Text,
        || Presence::Default(Some(CaseValue::Text(String::new()))),
        "free text",
        Shown("\"Zhao 2022, structure (d)\"", "free text"),
    ),
    head(
        "seed",
        Kind::Whole,
        || Presence::Optional,
        "solver.seed, which may be given here as well",
        Line::Absent,
    ),
];

impl CaseDocument {
    /// The document as a case file.
    ///
    /// # Errors
    /// A [`CaseError`] if TOML cannot hold it.
    pub fn to_toml(&self) -> Result<String, CaseError> {
        self.to_toml_without(&[])
    }

    /// The document as a case file without these dotted keys, those that took their default say;
    /// raceways are complete.
    ///
    /// # Errors
    /// Those of [`CaseDocument::to_toml`].
    pub fn to_toml_without(&self, left_out: &[String]) -> Result<String, CaseError> {
        toml::to_string(&Without(self, left_out))
            .map_err(|e| CaseError::of_file("case", format!("cannot be written as TOML: {e}")))
    }

    /// The value of a dotted key; `None` if it is left out or not a key.
    pub(crate) fn value(&self, key: &str) -> Option<CaseValue> {
        let (section, rest) = key.split_once('.').unwrap_or(("", key));
        if section.is_empty() {
            return match rest {
                "schema" => Some(CaseValue::Integer(self.schema as i64)),
                "title" => Some(CaseValue::Text(self.title.clone())),
                _ => None,
            };
        }
        let (_, each) = self.sections().into_iter().find(|(s, _)| *s == section)?;
        let (number, name) = match rest.split_once('.') {
            Some((number, name)) => (number.parse::<usize>().ok()?, name),
            None if each.len() == 1 => (1, rest),
            None => return None,
        };
        let values = each.into_iter().nth(number.checked_sub(1)?)?;
        let (_, value) = values.into_iter().find(|(k, _)| *k == name)?;
        Some(value)
    }
}

/// Keys and values as a map.
struct Keys<'a>(&'a Values);

impl Serialize for Keys<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

impl Serialize for CaseDocument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Without(self, &[]).serialize(serializer)
    }
}

/// A document without some dotted keys.
struct Without<'a>(&'a CaseDocument, &'a [String]);

impl Serialize for Without<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(document, left_out) = self;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("schema", &document.schema)?;
        map.serialize_entry("title", &document.title)?;
        for (name, mut each) in document.sections() {
            if let ([one], false) = (each.as_mut_slice(), name == "raceway") {
                one.retain(|(key, _)| !left_out.contains(&join(name, key)));
                if one.is_empty() && !left_out.is_empty() {
                    continue;
                }
            }
            match each.as_slice() {
                [] => {}
                [one] => map.serialize_entry(name, &Keys(one))?,
                several => {
                    let several: Vec<_> = several.iter().map(Keys).collect();
                    map.serialize_entry(name, &several)?;
                }
            }
        }
        map.end()
    }
}
