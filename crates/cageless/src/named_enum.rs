//! Enums whose variants have names.

/// Declares an enum whose variants have a name each, with the list of all and the name of one.
///
/// ```
/// cageless::named_enum! {
///     /// Side of a coin.
///     #[derive(Debug, Clone, Copy, PartialEq)]
///     pub enum Side {
///         /// The one with the number.
///         Tail = "tail",
///         /// The other.
///         Head = "head",
///     }
/// }
///
/// assert_eq!(Side::Head.name(), "head");
/// assert_eq!(Side::NAMES[0], ("tail", Side::Tail));
/// assert_eq!(Side::ALL, [Side::Tail, Side::Head]);
/// ```
#[macro_export]
macro_rules! named_enum {
    (
        $(#[$meta:meta])*
        $vis:vis enum $enum:ident {
            $($(#[$of:meta])* $variant:ident = $name:literal,)*
        }
    ) => {
        $(#[$meta])*
        $vis enum $enum {
            $($(#[$of])* $variant,)*
        }

        impl $enum {
            /// All, in the order of their discriminants.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$variant),*];

            /// All with their names.
            pub const NAMES: &'static [(&'static str, Self)] = &[$(($name, Self::$variant)),*];

            /// The name of one.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }
        }
    };
}
