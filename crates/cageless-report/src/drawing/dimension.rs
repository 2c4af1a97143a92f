//! Numbers on a drawing: lengths in mm, angles in degrees.

use cageless_results::number_text::significant;

use crate::length::mm;

/// A length in mm, to a tenth of a micrometre.
pub(super) fn length_text(m: f64) -> String {
    short(decimals(mm(m), 4))
}

/// An angle in degrees, to a thousandth.
pub(super) fn angle_text(rad: f64) -> String {
    format!("{}°", short(decimals(rad.to_degrees(), 3)))
}

/// A number as drawings have it, without zeros at its end.
pub(super) fn short(value: f64) -> String {
    significant(value, 6).replace('−', "–")
}

fn decimals(value: f64, count: i32) -> f64 {
    let unit = 10f64.powi(count);
    (value * unit).round() / unit
}
