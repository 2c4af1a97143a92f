//! How a key of the case file is declared: one row holds its type, unit, field in
//! [`cageless`], meaning, what happens if it is left out, and its line in the template.
//! Reader, writer, conversion to SI, messages, template, table of the documentation and
//! Python class follow from the row.

use super::error::CaseError;
use super::key::{Key, Kind, Presence, Values};
use super::reader::Reader;
use super::spanned_toml::Node;
use super::value::CaseValue;

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

    /// The value in SI units, its numbers converted by `si`.
    fn si(&self, si: ToSi<'_>) -> Result<Self::Si, CaseError>;
}

/// Conversion of the numbers of one key to SI units.
pub(crate) type ToSi<'a> = &'a dyn Fn(f64) -> Result<f64, CaseError>;

impl Reader<'_> {
    /// The value of a key, or what it takes if it is left out.
    pub(super) fn field<T: Field>(
        &mut self,
        name: &str,
        presence: Presence<T>,
    ) -> Result<T, CaseError> {
        if let Some(node) = self.get(name) {
            return T::read(self, name, node);
        }
        if matches!(presence, Presence::Default(_) | Presence::Derived) {
            self.note_default(name);
        }
        match presence {
            Presence::Default(value) => Ok(value),
            Presence::Derived | Presence::Optional => T::absent().ok_or_else(|| self.missing(name)),
            Presence::Required => Err(self.missing(name)),
        }
    }
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

/// A section of the case file.
pub(crate) trait SectionDocument: Sized {
    const KEYS: &'static [Key];

    fn read(reader: &mut Reader<'_>) -> Result<Self, CaseError>;

    /// The keys that have a value, in the order of the file format.
    fn values(&self) -> Values;
}

/// Declares a section. A row is
/// `key => field of cageless: type = presence, unit, meaning, template line;`, with the former name of
/// a key as `key formerly name`. With
/// `Document => Struct`, the fields of the rows are those of `cageless::Struct`, and
/// `Document::to_si` makes one; `key -> field` is of another struct.
macro_rules! section {
    ($(#[$doc:meta])* $Document:ident => $Si:ident { $($rows:tt)* }) => {
        section! { $(#[$doc])* $Document { $($rows)* } }
        section! { @convert $Document $Si { $($rows)* } }
    };
    ($(#[$doc:meta])* $Document:ident { $(
        $key:ident $(formerly $former:ident)? $(=> $field:ident)? $(-> $named:ident)?: $type:ty = $presence:expr, $unit:expr, $meaning:literal,
            $line:expr;
    )* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        // `[rotor]` in a meaning is a section of the file.
        #[allow(rustdoc::broken_intra_doc_links)]
        pub struct $Document { $( #[doc = $meaning] pub $key: $type, )* }

        impl $crate::case_file::declaration::SectionDocument for $Document {
            const KEYS: &'static [$crate::case_file::key::Key] = &[ $(
                $crate::case_file::key::Key {
                    name: stringify!($key),
                    formerly: concat!($(stringify!($former))?),
                    unit: $unit,
                    field: concat!($(stringify!($field))? $(stringify!($named))?),
                    meaning: $meaning,
                    kind: <$type as $crate::case_file::declaration::Field>::KIND,
                    presence: || {
                        let presence: $crate::case_file::key::Presence<$type> = $presence;
                        presence.written()
                    },
                    line: $line,
                },
            )* ];

            fn read(
                reader: &mut $crate::case_file::reader::Reader<'_>,
            ) -> Result<Self, $crate::case_file::error::CaseError> {
                Ok(Self { $( $key: reader.field(stringify!($key), $presence)?, )* })
            }

            fn values(&self) -> $crate::case_file::key::Values {
                use $crate::case_file::declaration::Field as _;
                [ $( (stringify!($key), self.$key.written()), )* ]
                    .into_iter()
                    .filter_map(|(name, value)| Some((name, value?)))
                    .collect()
            }
        }
    };
    (@convert $Document:ident $Si:ident { $(
        $key:ident $(formerly $former:ident)? $(=> $field:ident)? $(-> $named:ident)?: $type:ty = $presence:expr, $unit:expr, $meaning:literal,
            $line:expr;
    )* }) => {
        impl $Document {
            /// The section in SI units, the numbers of its keys converted by `si`.
            pub(in $crate::case_file) fn to_si(
                &self,
                si: &dyn Fn(&str, f64) -> Result<f64, $crate::case_file::error::CaseError>,
            ) -> Result<cageless::$Si, $crate::case_file::error::CaseError> {
                use $crate::case_file::declaration::Field as _;
                Ok(cageless::$Si { $( $(
                    $field: self.$key.si(&|value| si(stringify!($key), value))?,
                )? )* })
            }
        }
    };
}
pub(crate) use section;
