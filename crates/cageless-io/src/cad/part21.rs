//! ISO 10303-21, the text of a STEP file: numbered entities, reals and strings.

use std::fmt::Write;

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
    fn strings_are_ascii() {
        assert_eq!(
            string("it's a \\ θ\n"),
            "'it\\X\\27s a \\\\ \\X2\\03B8\\X0\\ '"
        );
        assert_eq!(string("Ring');"), "'Ring\\X\\27);'");
        assert_eq!(string("🙂"), "'\\X4\\0001F642\\X0\\'");
    }
}
