//! How a key of the case file is declared: one row holds its type, unit, field in
//! [`cageless`], meaning, what happens if it is left out, and its line in the template.
//! Reader, writer, conversion to SI, messages, template, table of the documentation and
//! Python class follow from the row.

use super::base::CaseValue;
use super::convert::Converter;
use super::error::CaseError;
use super::reader::Reader;
use super::spanned_toml::Node;
use super::unit::Unit;

/// What happens if a key is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Presence<T> {
    /// The case is refused.
    Required,
    /// The key takes this value.
    Default(T),
    /// The key takes a value that follows from the rest of the case, and counts as a default.
    Derived,
    /// The key has no value.
    Optional,
}

/// Line of a key in the template: its value and a comment.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Line {
    /// In force.
    Shown(&'static str, &'static str),
    /// Commented out.
    Commented(&'static str, &'static str),
    /// Not in the template.
    Absent,
}

/// Type of a value as a reader of the documentation meets it.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Kind {
    Number,
    Whole,
    Text,
    /// One of these names.
    Choice(fn() -> Vec<&'static str>),
    Numbers,
    /// A number, or the lowest and the highest.
    Range,
    /// A number, or rows of time and value.
    OverTime,
    /// Rows of two numbers.
    Rows(&'static str),
    /// One of these names or a number.
    NumberOr(&'static [&'static str]),
    /// One of these names or a list of numbers.
    NumbersOr(&'static [&'static str]),
}

/// One key.
#[derive(Debug)]
pub(crate) struct Key {
    pub name: &'static str,
    pub unit: Unit,
    /// Field of [`cageless::InputError`]; empty if none.
    pub field: &'static str,
    pub meaning: &'static str,
    pub kind: Kind,
    pub presence: fn() -> Presence<Option<CaseValue>>,
    pub line: Line,
}

/// A type of value that a key can have.
pub(crate) trait Field: Sized {
    /// Type of the value in SI units.
    type Si;
    const KIND: Kind;

    /// The value of a key as the file has it.
    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError>;

    /// The value of a key that is left out and has no default; `None` if it must be given.
    fn absent() -> Option<Self> {
        None
    }

    /// The value as it is written into a case file; `None` if it is left out.
    fn written(&self) -> Option<CaseValue>;

    /// The value in SI units; `path` is its dotted key.
    fn si(&self, converter: &Converter<'_>, path: &str) -> Result<Self::Si, CaseError>;
}

impl<T: Field> Presence<T> {
    /// The default as it is written.
    pub(crate) fn written(&self) -> Presence<Option<CaseValue>> {
        match self {
            Self::Required => Presence::Required,
            Self::Default(value) => Presence::Default(value.written()),
            Self::Derived => Presence::Derived,
            Self::Optional => Presence::Optional,
        }
    }
}

/// The keys of one section with their values.
pub(crate) type Values = Vec<(&'static str, CaseValue)>;

/// A section of the case file.
pub(crate) trait SectionDocument: Sized {
    const KEYS: &'static [Key];

    fn read(reader: &mut Reader<'_>) -> Result<Self, CaseError>;

    /// The keys that have a value, in the order of the file format.
    fn values(&self) -> Values;
}

/// Declares a section. A row is
/// `key => field of cageless: type = presence, unit, meaning, template line;`. With
/// `Document => Struct`, the fields of the rows are those of `cageless::Struct`, and
/// `Document::to_si` makes one; `key -> field` is of another struct.
macro_rules! section {
    ($(#[$doc:meta])* $Document:ident => $Si:ident { $($rows:tt)* }) => {
        section! { $(#[$doc])* $Document { $($rows)* } }
        section! { @convert $Document $Si { $($rows)* } }
    };
    ($(#[$doc:meta])* $Document:ident { $(
        $key:ident $(=> $field:ident)? $(-> $named:ident)?: $type:ty = $presence:expr, $unit:expr, $meaning:literal,
            $line:expr;
    )* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        // `[rotor]` in a meaning is a section of the file.
        #[allow(rustdoc::broken_intra_doc_links)]
        pub struct $Document { $( #[doc = $meaning] pub $key: $type, )* }

        impl $crate::case_file::declaration::SectionDocument for $Document {
            const KEYS: &'static [$crate::case_file::declaration::Key] = &[ $(
                $crate::case_file::declaration::Key {
                    name: stringify!($key),
                    unit: $unit,
                    field: concat!($(stringify!($field))? $(stringify!($named))?),
                    meaning: $meaning,
                    kind: <$type as $crate::case_file::declaration::Field>::KIND,
                    presence: || {
                        let presence: $crate::case_file::declaration::Presence<$type> = $presence;
                        presence.written()
                    },
                    line: $line,
                },
            )* ];

            fn read(
                reader: &mut $crate::case_file::reader::Reader<'_>,
            ) -> Result<Self, $crate::case_file::CaseError> {
                Ok(Self { $( $key: reader.field(stringify!($key), $presence)?, )* })
            }

            fn values(&self) -> $crate::case_file::declaration::Values {
                use $crate::case_file::declaration::Field as _;
                [ $( (stringify!($key), self.$key.written()), )* ]
                    .into_iter()
                    .filter_map(|(name, value)| Some((name, value?)))
                    .collect()
            }
        }
    };
    (@convert $Document:ident $Si:ident { $(
        $key:ident $(=> $field:ident)? $(-> $named:ident)?: $type:ty = $presence:expr, $unit:expr, $meaning:literal,
            $line:expr;
    )* }) => {
        impl $Document {
            /// The section in SI units; `path` is its dotted name.
            pub(in $crate::case_file) fn to_si(
                &self,
                converter: &$crate::case_file::convert::Converter<'_>,
                path: &str,
            ) -> Result<cageless::$Si, $crate::case_file::CaseError> {
                use $crate::case_file::declaration::Field as _;
                let key = |name| $crate::case_file::spanned_toml::join(path, name);
                Ok(cageless::$Si { $( $(
                    $field: self.$key.si(converter, &key(stringify!($key)))?,
                )? )* })
            }
        }
    };
}
pub(crate) use section;
