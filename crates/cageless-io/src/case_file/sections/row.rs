//! `[[row]]`.

use crate::case_file::declaration::prelude::*;

section! {
    /// `[[row]]`: a row of balls on the common inner ring.
    impl cageless::Row {
        axial_position_mm => axial_position_m: f64 = Required, Millimetre,
            "z of the middle of the row", Absent;
        contact_sign => contact_sign: f64 = default(1.0), Plain,
            "1: its balls press the outer ring towards +z; -1: towards -z. 1 below -1: back to back; -1 below 1: face to face; equal: tandem", Absent;
        preload_um => preload_m: f64 = default(0.0), Micrometre; AtLeast(0.0),
            "preload by displacement of its outer ring against the contact sign; with [fit] that before fits and temperatures", Absent;
        preload_n => preload_n: f64 = default(0.0), Si("N"); AtLeast(0.0),
            "preload by a soft spring, in place of preload_um: force on its outer ring against the contact sign; only in `static`, which finds the displacement", Absent;
        balls => balls: Option<usize> = Optional, Plain,
            "balls of the row, evenly spaced if fewer than those of [bearing], which it has unless given, and in motion always", Absent;
    }
}
