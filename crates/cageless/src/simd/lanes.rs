//! One number per lane, and structs of them derived from plain structs of `f64`.

use crate::dynamics::layout::LANES;

/// One number of each lane of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub(crate) struct Lanes(pub [f64; LANES]);

impl Lanes {
    pub const ZERO: Self = Self([0.0; LANES]);

    pub fn all(value: f64) -> Self {
        Self([value; LANES])
    }
}

/// The numbers of consecutive blocks.
#[inline(always)]
pub(crate) fn flat(blocks: &[Lanes]) -> &[f64] {
    // SAFETY: `Lanes` is an array of LANES f64 and has no padding (repr C; its size is a
    // multiple of its alignment, as asserted below).
    unsafe { std::slice::from_raw_parts(blocks.as_ptr().cast(), blocks.len() * LANES) }
}

/// The numbers of consecutive blocks.
#[inline(always)]
pub(crate) fn flat_mut(blocks: &mut [Lanes]) -> &mut [f64] {
    // SAFETY: see `flat`; the exclusive borrow covers the same bytes.
    unsafe { std::slice::from_raw_parts_mut(blocks.as_mut_ptr().cast(), blocks.len() * LANES) }
}

const _: () = assert!(size_of::<Lanes>() == LANES * size_of::<f64>());

/// Declares a plain struct of `f64` and, from the same fields, the struct that holds one of
/// them per lane, with `get` and `put` for a lane.
macro_rules! lane_struct {
    (
        $(#[$meta:meta])*
        $vis:vis struct $name:ident per lane $lanes:ident {
            $($(#[$field_meta:meta])* $field:ident),* $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Default)]
        $vis struct $name {
            $($(#[$field_meta])* pub $field: f64),*
        }

        #[doc = concat!("[`", stringify!($name), "`] of each lane.")]
        #[derive(Debug, Clone)]
        pub(crate) struct $lanes {
            $(pub $field: $crate::simd::lanes::Lanes),*
        }

        #[allow(dead_code)] // some are only read, some only written
        impl $lanes {
            pub const ZERO: Self = Self {
                $($field: $crate::simd::lanes::Lanes::ZERO),*
            };

            #[inline(always)]
            pub fn get(&self, lane: usize) -> $name {
                $name { $($field: self.$field.0[lane]),* }
            }

            #[inline(always)]
            pub fn put(&mut self, lane: usize, value: $name) {
                $(self.$field.0[lane] = value.$field;)*
            }

            /// The lanes filled one by one.
            pub fn from_fn(value: impl Fn(usize) -> $name) -> Self {
                let mut lanes = Self::ZERO;
                for lane in 0..$crate::dynamics::layout::LANES {
                    lanes.put(lane, value(lane));
                }
                lanes
            }
        }
    };
}
pub(crate) use lane_struct;
