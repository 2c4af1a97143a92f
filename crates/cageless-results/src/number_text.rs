//! Numbers as text for readers.

/// `value` with `decimals` decimals and a true minus sign, which no zero has; a dash if there is none.
pub fn fixed(value: Option<f64>, decimals: usize) -> String {
    match value {
        Some(v) if v.is_finite() => minus(&unsigned_zero(format!("{v:.decimals$}"))),
        _ => "–".to_owned(),
    }
}

/// [`fixed`] with a sign in any case.
pub fn signed(value: Option<f64>, decimals: usize) -> String {
    match value {
        Some(v) if v.is_finite() => match fixed(value, decimals) {
            text if text.starts_with(MINUS) => text,
            text => format!("+{text}"),
        },
        _ => "–".to_owned(),
    }
}

/// Three significant digits, without needless zeros.
pub fn short(value: f64) -> String {
    significant(value, 3)
}

/// `value` with so many significant digits, without needless zeros; by powers of ten where it is
/// very large or small.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return fixed(Some(value), 0);
    }
    let magnitude = value.abs().log10().floor();
    if !(-4.0..6.0).contains(&magnitude) {
        let text = format!("{value:.*e}", digits.min(3) - 1);
        return match text.split_once('e') {
            Some((digits, power)) => format!("{} × 10{}", minus(digits), raised(power)),
            None => text,
        };
    }
    let decimals = (digits as f64 - 1.0 - magnitude).max(0.0) as usize;
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    minus(text)
}

/// `value` to one digit beyond the first of `error`.
pub(crate) fn rounded(value: f64, error: f64) -> String {
    let decimals = if error > 0.0 {
        (1.0 - error.log10().floor()).clamp(0.0, 9.0) as usize
    } else {
        6
    };
    unsigned_zero(format!("{value:.decimals$}"))
}

/// Text of a number, without a minus sign where all its digits are zero.
fn unsigned_zero(text: String) -> String {
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits.to_owned(),
        _ => text,
    }
}

/// A whole number in superscript digits.
pub fn raised(power: &str) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raise = |c: char| c.to_digit(10).map_or('⁻', |d| digits[d as usize]);
    power.chars().map(raise).collect()
}

const MINUS: char = '\u{2212}';

fn minus(text: &str) -> String {
    text.replace('-', &MINUS.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_readable() {
        assert_eq!(fixed(Some(-1.25), 1), "\u{2212}1.2");
        assert_eq!(fixed(None, 4), "–");
        assert_eq!(fixed(Some(f64::NAN), 4), "–");
        assert_eq!(signed(Some(0.0105), 4), "+0.0105");
        for zero in [0.0, -0.0, -0.00004] {
            assert_eq!(fixed(Some(zero), 4), "0.0000");
            assert_eq!(signed(Some(zero), 4), "+0.0000");
            assert_eq!(short(zero.trunc()), "0");
            assert_eq!(rounded(zero, 0.01), "0.000");
        }
        assert_eq!(signed(Some(-0.00006), 4), "\u{2212}0.0001");
        assert_eq!(rounded(-0.0006, 0.01), "-0.001");
        assert_eq!(short(12345.0), "12345");
        assert_eq!(short(0.050), "0.05");
        assert_eq!(short(1.5e-7), "1.50 × 10⁻⁷");
    }
}
