//! How a key is declared: one row holds its type, unit, limits, field of [`cageless`], meaning,
//! what happens if it is left out, and its line in the template. Reader, writer, conversion to SI,
//! messages, template, documentation, JSON schema and Python class follow from the row.

use super::error::CaseError;
use super::key::{Key, Kind};
use super::reader::Reader;
use super::spanned_toml::Node;

/// A type of value that a key can have, in SI units.
pub(crate) trait Field: Sized {
    const KIND: Kind;

    /// The value of a key, from the unit of the file.
    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError>;

    /// The value of a key that is left out and has no default; `None` if it must be given.
    fn absent() -> Option<Self> {
        None
    }
}

/// Declares a type of value: its kind, and the function of reader, name and node that reads it.
macro_rules! field {
    ($Type:ty, $kind:expr, $read:expr) => {
        impl $crate::case_file::declaration::Field for $Type {
            const KIND: Kind = $kind;

            fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
                let read: fn(&Reader<'_>, &str, &Node) -> Result<Self, CaseError> = $read;
                read(reader, name, node)
            }
        }
    };
}
pub(crate) use field;

impl Reader<'_> {
    /// The value of a key in SI units.
    pub(crate) fn field<T: Field>(&self, name: &str) -> Result<T, CaseError> {
        match self.get(name) {
            Some(node) => T::read(self, name, node),
            None => T::absent().ok_or_else(|| self.missing(name)),
        }
    }
}

/// A section of a file, in SI units.
pub(crate) trait SectionKeys: Sized {
    const KEYS: &'static [Key];

    fn read(reader: &Reader<'_>) -> Result<Self, CaseError>;
}

/// Declares a section. A row is `key => field: type = presence, unit, meaning, template line;`, with
/// the former name of a key as `key formerly name` and limits as `unit; limit`. `struct` makes a
/// struct of the fields, `impl` takes one of [`cageless`]; `@field: Type { rows }` between its rows
/// fills in a struct of its own, whose errors name the keys.
macro_rules! section {
    ($(#[$doc:meta])* struct $Name:ident { $(
        $key:ident $(formerly $former:ident)? => $field:ident: $type:ty = $presence:expr, $unit:expr $(; $limit:expr)?, $meaning:expr, $line:expr;
    )* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        pub(crate) struct $Name { $( pub $field: $type, )* }

        section! { impl $Name { $(
            $key $(formerly $former)? => $field: $type = $presence, $unit $(; $limit)?, $meaning, $line;
        )* } }
    };
    ($(#[$doc:meta])* impl $Name:ty {
        $( $key:ident $(formerly $former:ident)? => $field:ident: $type:ty = $presence:expr, $unit:expr $(; $limit:expr)?, $meaning:expr, $line:expr; )*
        $( @$group:ident: $($Group:ident)::+ {
            $( $inner:ident $(formerly $inner_former:ident)? => $part:ident: $inner_type:ty = $inner_presence:expr, $inner_unit:expr $(; $inner_limit:expr)?, $inner_meaning:expr, $inner_line:expr; )*
        }
        $( $later:ident $(formerly $later_former:ident)? => $later_field:ident: $later_type:ty = $later_presence:expr, $later_unit:expr $(; $later_limit:expr)?, $later_meaning:expr, $later_line:expr; )* )?
    }) => {
        $(#[$doc])*
        impl $crate::case_file::declaration::SectionKeys for $Name {
            const KEYS: &'static [$crate::case_file::key::Key] = &[
                $( $crate::case_file::declaration::key!($key [$($former)?] $field, $type, $presence, $unit $(; $limit)?, $meaning, $line), )*
                $( $( $crate::case_file::declaration::key!($inner [$($inner_former)?] $inner, $inner_type, $inner_presence, $inner_unit $(; $inner_limit)?, $inner_meaning, $inner_line), )*
                $( $crate::case_file::declaration::key!($later [$($later_former)?] $later_field, $later_type, $later_presence, $later_unit $(; $later_limit)?, $later_meaning, $later_line), )* )?
            ];

            fn read(
                reader: &$crate::case_file::reader::Reader<'_>,
            ) -> Result<Self, $crate::case_file::error::CaseError> {
                Ok(Self {
                    $( $field: reader.field(stringify!($key))?, )*
                    $( $group: {
                        // The rest is what no file can say.
                        let mut group = <$($Group)::+>::default();
                        $( group.$part = reader.field(stringify!($inner))?; )*
                        group
                    },
                    $( $later_field: reader.field(stringify!($later))?, )* )?
                })
            }
        }
    };
}
pub(crate) use section;

/// The row of a key.
macro_rules! key {
    ($key:ident [$($former:ident)?] $field:ident, $type:ty, $presence:expr, $unit:expr $(; $limit:expr)?, $meaning:expr, $line:expr) => {
        $crate::case_file::key::Key {
            name: stringify!($key),
            formerly: concat!($(stringify!($former))?),
            unit: $unit,
            limit: [$($limit,)? $crate::case_file::key::Limit::None][0],
            field: stringify!($field),
            meaning: $meaning,
            kind: <$type as $crate::case_file::declaration::Field>::KIND,
            presence: || $presence,
            line: $line,
        }
    };
}
pub(crate) use key;

/// Names for declarations of sections, keys and formats.
pub(crate) mod prelude {
    pub(crate) use super::super::error::CaseError;
    pub(crate) use super::super::format::{Heading, SCHEMA, sections};
    pub(crate) use super::super::key::Limit::{Above, AtLeast, Inside, Within};
    pub(crate) use super::super::key::Line::{Absent, Commented, Shown};
    pub(crate) use super::super::key::Presence::{Derived, Optional, Required};
    pub(crate) use super::super::key::{Key, Kind, Line, default};
    pub(crate) use super::super::named::{Named, named};
    pub(crate) use super::super::reader::Reader;
    pub(crate) use super::super::spanned_toml::{Node, Value};
    pub(crate) use super::super::unit::Unit::{
        Degree, Gigapascal, GramMillimetre, Micrometre, Microsecond, Millimetre, MillipascalSecond,
        Milliradian, None as Plain, RevolutionPerMinute, Si, SquareMillimetrePerSecond,
    };
    pub(crate) use super::{SectionKeys, field, section};
}
