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
            "preload by a soft spring, in place of preload_um: force on its outer ring against the contact sign, whatever its displacement; the ring slides along the axis, the other rows are held", Absent;
        sliding_mass_kg => sliding_mass_kg: Option<f64> = Optional, Si("kg"); Above(0.0),
            "with preload_n: mass that slides with its outer ring in motion; that of a ring 0.3 Dw thick behind its groove and 1.6 Dw wide unless given", Absent;
        sliding_damping_n_s_m => sliding_damping_n_s_m: Option<f64> = Optional, Si("N s/m"); AtLeast(0.0),
            "with preload_n: viscous damping of its outer ring in the housing, without dry friction; that of a film of oil of 0.03 Pa·s, 5 µm thick, on the seat of such a ring unless given", Absent;
        balls => balls: Option<usize> = Optional, Plain,
            "balls of the row, evenly spaced if fewer than those of [bearing], which it has unless given, and in motion always", Absent;
    }
}
