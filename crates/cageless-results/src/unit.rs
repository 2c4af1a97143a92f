//! Units of keys and results, for readers.

use std::f64::consts::TAU;

/// A unit with its symbols.
pub fn unit_text(unit: &str) -> String {
    match unit {
        "deg" => "°".to_owned(),
        "deg/s" => "°/s".to_owned(),
        "C" => "°C".to_owned(),
        "um" => "µm".to_owned(),
        "us" => "µs".to_owned(),
        unit => (unit.replace(' ', "·").replace("^2", "²")).replace("^3", "³"),
    }
}

/// A number with a unit in its symbols: `12.5 µm`, `90°`.
pub fn with_unit(number: &str, unit: &str) -> String {
    let space = if matches!(unit, "" | "°") { "" } else { " " };
    format!("{number}{space}{unit}")
}

/// Factor and unit for readers of values in a unit with its symbols: one unit for pressures, one for torques, one for
/// speeds of rotation.
pub(crate) fn printed(unit: &str) -> (f64, String) {
    match unit {
        "N·m" => (1e3, "N·mm".to_owned()),
        "N/m" => (1e-6, "N/µm".to_owned()),
        "Mrev" => (1.0, "million revolutions".to_owned()),
        "rad/s" => (rpm(1.0), "rpm".to_owned()),
        unit => (1.0, unit.to_owned()),
    }
}

/// A speed of rotation in rpm.
pub(crate) fn rpm(speed_rad_s: f64) -> f64 {
    speed_rad_s * 60.0 / TAU
}
