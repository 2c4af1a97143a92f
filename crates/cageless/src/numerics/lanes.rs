//! One number per lane, and structs of them derived from plain structs of `f64`.
//!
//! ```
//! use cageless::numerics::BATCH_WIDTH;
//!
//! assert!(BATCH_WIDTH.is_power_of_two());
//! ```

/// Length of a block: what the arrays over the balls are padded to.
pub(crate) const LANES: usize = 16;

/// Bearings side by side; two balls of each fill a block.
pub const BATCH_WIDTH: usize = 8;

/// One number of each lane of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub(crate) struct Lanes(pub [f64; LANES]);

impl Lanes {
    pub(crate) const ZERO: Self = Self([0.0; LANES]);

    pub(crate) fn all(value: f64) -> Self {
        Self([value; LANES])
    }

    /// Adds others times a factor.
    #[inline(always)]
    pub(crate) fn add(&mut self, others: &Self, factor: f64) {
        for lane in 0..LANES {
            self.0[lane] += factor * others.0[lane];
        }
    }

    /// Sum of all lanes, one after the other.
    #[inline(always)]
    pub(crate) fn sum(&self) -> f64 {
        let mut sum = 0.0;
        for lane in 0..LANES {
            sum += self.0[lane];
        }
        sum
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

/// The larger of two numbers; `a` where one is none.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Largest of the lanes of each bearing; that of the only bearing comes first.
#[inline(always)]
pub(crate) fn lane_maxima(lanes: &Lanes, alone: bool) -> [f64; BATCH_WIDTH] {
    let mut maxima = [0.0; BATCH_WIDTH];
    for lane in 0..LANES {
        maxima[lane % BATCH_WIDTH] = larger(maxima[lane % BATCH_WIDTH], lanes.0[lane]);
    }
    let mut half = BATCH_WIDTH / 2;
    while alone && half > 0 {
        for k in 0..half {
            maxima[k] = larger(maxima[k], maxima[k + half]);
        }
        half /= 2;
    }
    maxima
}

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
            $(pub $field: $crate::numerics::lanes::Lanes),*
        }

        #[allow(dead_code)] // some are only read, some only written
        impl $lanes {
            pub(crate) const ZERO: Self = Self {
                $($field: $crate::numerics::lanes::Lanes::ZERO),*
            };

            #[inline(always)]
            pub(crate) fn get(&self, lane: usize) -> $name {
                $name { $($field: self.$field.0[lane]),* }
            }

            #[inline(always)]
            pub(crate) fn put(&mut self, lane: usize, value: $name) {
                $(self.$field.0[lane] = value.$field;)*
            }

            /// The lanes filled one by one.
            pub(crate) fn from_fn(value: impl Fn(usize) -> $name) -> Self {
                let mut lanes = Self::ZERO;
                for lane in 0..$crate::numerics::lanes::LANES {
                    lanes.put(lane, value(lane));
                }
                lanes
            }
        }
    };
}
pub(crate) use lane_struct;
