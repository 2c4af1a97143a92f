//! Units of the case file and the way to SI and back.

use std::f64::consts::TAU;

use cageless_results::{unit_text, with_unit};

/// Unit of a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unit {
    /// No unit.
    None,
    /// A unit of the SI system, as [`cageless`] has it.
    Si(&'static str),
    Millimetre,
    Micrometre,
    Degree,
    Milliradian,
    RevolutionPerMinute,
    Gigapascal,
    Microsecond,
    SquareMillimetrePerSecond,
    MillipascalSecond,
    GramMillimetre,
}

impl Unit {
    /// Symbol of the unit; empty if there is none.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Si(symbol) => symbol,
            Self::Millimetre => "mm",
            Self::Micrometre => "um",
            Self::Degree => "deg",
            Self::Milliradian => "mrad",
            Self::RevolutionPerMinute => "rpm",
            Self::Gigapascal => "GPa",
            Self::Microsecond => "us",
            Self::SquareMillimetrePerSecond => "mm^2/s",
            Self::MillipascalSecond => "mPa s",
            Self::GramMillimetre => "g mm",
        }
    }

    /// [`Unit::symbol`] as it is set in print.
    pub(crate) fn printed(self) -> String {
        unit_text(self.symbol())
    }

    /// From the file's unit to SI. 0.2 us is the same number as 2e-7 s, so that a case
    /// file and a program that uses [`cageless`] itself start from the same bits.
    pub(crate) fn to_si(self, value: f64) -> f64 {
        match self {
            Self::None | Self::Si(_) => value,
            Self::Millimetre | Self::Milliradian | Self::MillipascalSecond => shift(value, -3),
            Self::Micrometre
            | Self::Microsecond
            | Self::SquareMillimetrePerSecond
            | Self::GramMillimetre => shift(value, -6),
            Self::Degree => value.to_radians(),
            Self::RevolutionPerMinute => value * TAU / 60.0,
            Self::Gigapascal => shift(value, 9),
        }
    }

    /// From SI to the file's unit.
    pub(super) fn of_si(self, value: f64) -> f64 {
        match self {
            Self::None | Self::Si(_) => value,
            Self::Millimetre | Self::Milliradian | Self::MillipascalSecond => shift(value, 3),
            Self::Micrometre
            | Self::Microsecond
            | Self::SquareMillimetrePerSecond
            | Self::GramMillimetre => shift(value, 6),
            Self::Degree => value.to_degrees(),
            Self::RevolutionPerMinute => value * 60.0 / TAU,
            Self::Gigapascal => shift(value, -9),
        }
    }

    /// A number of this unit, given in SI, for a message: `7.40173 mm`.
    pub(super) fn show(self, si: f64, side: Side) -> String {
        self.with(round(self.of_si(si), side))
    }

    /// A number in this unit with its symbol.
    pub(super) fn with(self, value: f64) -> String {
        with_unit(&decimal(value), &self.printed())
    }
}

/// A number as people write it: neither three hundred zeros nor an exponent without need.
pub(crate) fn decimal(value: f64) -> String {
    if value == 0.0 || !value.is_finite() || (1e-6..1e12).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// Moves the decimal point: value·10^places of the decimal number that `value` stands
/// for. Multiplication or division would round a second time.
fn shift(value: f64, places: i32) -> f64 {
    let decimal = format!("{value:e}");
    let shifted = decimal.split_once('e').and_then(|(digits, exponent)| {
        let exponent = exponent.parse::<i32>().ok()? + places;
        format!("{digits}e{exponent}").parse().ok()
    });
    // Without an exponent it is an infinity or not a number.
    shifted.unwrap_or(value)
}

/// Direction in which a number in a message may be rounded so that the statement stays true.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// A value: to the nearest.
    Nearest,
    /// A lower limit: up.
    Lower,
    /// An upper limit: down.
    Upper,
}

/// Rounds to six digits, which hides the rounding errors of a change of units.
pub(super) fn round(value: f64, side: Side) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let nearest: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    let last_digit = 10f64.powf(value.abs().log10().floor() - 5.0);
    let off = nearest - value;
    // What is a rounding error off is the limit itself.
    if off.abs() < 1e-9 * value.abs() {
        return nearest;
    }
    let moved = match side {
        Side::Lower if off < 0.0 => nearest + last_digit,
        Side::Upper if off > 0.0 => nearest - last_digit,
        _ => return nearest,
    };
    format!("{moved:.5e}").parse().unwrap_or(moved)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_go_to_si_exactly_and_back() {
        assert_eq!(Unit::Millimetre.to_si(4.7625), 4.7625e-3);
        assert_eq!(Unit::Microsecond.to_si(0.2), 2e-7);
        assert_eq!(Unit::Degree.to_si(90.0), std::f64::consts::FRAC_PI_2);
        assert_eq!(Unit::Gigapascal.to_si(206.0), 206e9);
        assert_eq!(
            Unit::RevolutionPerMinute.to_si(12000.0),
            400.0 * std::f64::consts::PI
        );
        for unit in [
            Unit::None,
            Unit::Si("kg"),
            Unit::Millimetre,
            Unit::Micrometre,
            Unit::Degree,
            Unit::RevolutionPerMinute,
            Unit::Gigapascal,
            Unit::Microsecond,
            Unit::MillipascalSecond,
            Unit::GramMillimetre,
        ] {
            let back = unit.of_si(unit.to_si(7.3));
            assert!((back - 7.3).abs() < 1e-14 * 7.3, "{unit:?}: {back}");
        }
    }

    #[test]
    fn numbers_are_as_short_as_people_write_them() {
        assert_eq!(decimal(4.7625), "4.7625");
        assert_eq!(decimal(-0.00001), "-0.00001");
        assert_eq!(decimal(0.0), "0");
        assert_eq!(decimal(1e-300), "1e-300");
        assert_eq!(decimal(-2.5e295), "-2.5e295");
        assert_eq!(Unit::Millimetre.show(1e-308, Side::Nearest), "1e-305 mm");
    }

    #[test]
    fn limits_round_to_the_allowed_side() {
        assert_eq!(round(7.401_732_9, Side::Upper), 7.40173);
        assert_eq!(round(7.401_738_9, Side::Upper), 7.40173);
        assert_eq!(round(7.401_732_9, Side::Lower), 7.40174);
        assert_eq!(round(4.762_500_000_000_001, Side::Upper), 4.7625);
        assert_eq!(round(-476.250_01, Side::Lower), -476.25);
        assert_eq!(round(0.0, Side::Lower), 0.0);
        assert_eq!(
            Unit::Degree.show(std::f64::consts::FRAC_PI_2, Side::Upper),
            "90°"
        );
    }
}
