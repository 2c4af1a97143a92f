//! ISO 10303-21, the text of a STEP file: numbered entities, reals and strings.

use std::fmt::Write;
use std::time::{SystemTime, UNIX_EPOCH};

/// The data section of a file as it grows.
#[derive(Debug, Default)]
pub(super) struct Part21 {
    text: String,
    count: usize,
}

/// Number of an entity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Id(usize);

impl std::fmt::Display for Id {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "#{}", self.0)
    }
}

impl Part21 {
    /// Adds an entity.
    pub(super) fn add(&mut self, entity: impl AsRef<str>) -> Id {
        self.count += 1;
        self.text
            .push_str(&format!("#{}={};\n", self.count, entity.as_ref()));
        Id(self.count)
    }

    /// The entities, a line each.
    pub(super) fn text(&self) -> &str {
        &self.text
    }
}

/// Variable with the date of reproducible builds, in seconds since 1970.
const DATE: &str = "SOURCE_DATE_EPOCH";

/// Last second of the year 9999: further years have more digits than a date has room for.
const SECONDS_MAX: u64 = 253_402_300_799;

/// A date of reproducible builds that is none.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "the environment variable {DATE} = {0:?} is not possible: it must be a whole number of seconds since \
     1970-01-01, at most {SECONDS_MAX}; without it a file has the date of today"
)]
pub struct DateError(String);

/// The date of a file in the making, in UTC.
///
/// # Errors
/// The date of reproducible builds is not one.
pub(super) fn now() -> Result<String, DateError> {
    let given = std::env::var_os(DATE).map(|given| given.to_string_lossy().into_owned());
    let seconds = match given {
        Some(given) => seconds(&given)?,
        None => {
            let since = SystemTime::now().duration_since(UNIX_EPOCH);
            since.map_or(0, |since| since.as_secs())
        }
    };
    Ok(time_stamp(seconds))
}

/// Seconds since 1970 as text has them.
fn seconds(text: &str) -> Result<u64, DateError> {
    let digits = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let seconds = digits.then(|| text.parse().ok()).flatten();
    let seconds = seconds.filter(|seconds| *seconds <= SECONDS_MAX);
    seconds.ok_or_else(|| DateError(text.to_owned()))
}

/// ISO 8601 of seconds since 1970, in UTC.
fn time_stamp(seconds: u64) -> String {
    const DAY: u64 = 86_400;
    let leap =
        |year: u64| year.is_multiple_of(4) && !year.is_multiple_of(100) || year.is_multiple_of(400);
    let (mut days, second) = (seconds / DAY, seconds % DAY);
    let mut year = 1970;
    while days >= 365 + u64::from(leap(year)) {
        days -= 365 + u64::from(leap(year));
        year += 1;
    }
    let lengths = [
        31,
        28 + u64::from(leap(year)),
        31,
        30,
        31,
        30,
        31,
        31,
        30,
        31,
        30,
        31,
    ];
    let mut month = 0;
    while days >= lengths[month] {
        days -= lengths[month];
        month += 1;
    }
    let (hour, minute) = (second / 3600, second / 60 % 60);
    let day = days + 1;
    let month = month + 1;
    format!(
        "{year}-{month:02}-{day:02}T{hour:02}:{minute:02}:{:02}",
        second % 60
    )
}

/// `(a,b,c)`.
pub(super) fn list<T: std::fmt::Display>(items: impl IntoIterator<Item = T>) -> String {
    let mut text = String::from("(");
    for (k, item) in items.into_iter().enumerate() {
        let comma = if k == 0 { "" } else { "," };
        // Writing to a string cannot fail.
        let _ = write!(text, "{comma}{item}");
    }
    text + ")"
}

/// A real: the shortest decimal that reads back as the same number, with the point that
/// the standard demands.
pub(super) fn real(value: f64) -> String {
    // −0 would be another text for the same number.
    let text = format!("{:?}", value + 0.0);
    match text.split_once('e') {
        Some((digits, exponent)) => {
            let point = if digits.contains('.') { "" } else { "." };
            format!("{digits}{point}E{exponent}")
        }
        None => text,
    }
}

/// A string: backslashes doubled, quotes and what is not ASCII by their codes. The standard allows
/// doubled quotes as well, but OpenCASCADE takes one of them before `)` for the end of the text.
pub(super) fn string(text: &str) -> String {
    let mut encoded = String::from("'");
    for c in text.chars() {
        match c {
            '\'' => encoded.push_str("\\X\\27"),
            '\\' => encoded.push_str("\\\\"),
            ' '..='~' => encoded.push(c),
            _ if c.is_control() => encoded.push(' '),
            _ => {
                let code = u32::from(c);
                encoded.push_str(&if code <= 0xFFFF {
                    format!("\\X2\\{code:04X}\\X0\\")
                } else {
                    format!("\\X4\\{code:08X}\\X0\\")
                });
            }
        }
    }
    encoded + "'"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_have_a_point_and_read_back() {
        for value in [
            0.0,
            -0.0,
            1.0,
            -27.765,
            1e-7,
            1.5e-17,
            1e22,
            -3e300,
            0.1 + 0.2,
        ] {
            let text = real(value);
            assert!(text.contains('.'), "{text}");
            assert_eq!(text.parse::<f64>().unwrap(), value, "{text}");
        }
        assert_eq!(real(1e-7), "1.E-7");
        assert_eq!(real(-0.0), "0.0");
    }

    #[test]
    fn dates_are_those_of_the_calendar() {
        for (seconds, date) in [
            (0, "1970-01-01T00:00:00"),
            (951_782_399, "2000-02-28T23:59:59"),
            (951_782_400, "2000-02-29T00:00:00"),
            (4_107_542_400, "2100-03-01T00:00:00"),
            (1_798_761_599, "2026-12-31T23:59:59"),
            (SECONDS_MAX, "9999-12-31T23:59:59"),
        ] {
            assert_eq!(time_stamp(seconds), date);
        }
        assert!(now().is_ok_and(|date| *date >= *"2026"));
    }

    #[test]
    fn dates_of_reproducible_builds_are_whole_seconds() {
        assert_eq!(seconds("951782400"), Ok(951_782_400));
        assert_eq!(seconds("253402300799"), Ok(SECONDS_MAX));
        for wrong in [
            "",
            "yesterday",
            "-1",
            "+1",
            "1.5",
            " 1",
            "0x10",
            "253402300800",
            "99999999999999999999",
        ] {
            let error = seconds(wrong).unwrap_err().to_string();
            let named = format!("SOURCE_DATE_EPOCH = {wrong:?} is not possible");
            assert!(error.contains(&named), "{error}");
        }
    }

    #[test]
    fn strings_are_ascii() {
        assert_eq!(
            string("it's a \\ θ\n"),
            "'it\\X\\27s a \\\\ \\X2\\03B8\\X0\\ '"
        );
        assert_eq!(string("Ring');"), "'Ring\\X\\27);'");
        assert_eq!(string("🙂"), "'\\X4\\0001F642\\X0\\'");
    }
}
