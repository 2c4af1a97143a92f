//! Text for HTML, numbers for readers.

/// `text` with the five characters escaped that mean something in HTML.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

/// [`escape`], with the paper's symbols lC and β0 set with their index and with what stands
/// between backticks as code.
pub fn rich(text: &str) -> String {
    code(&symbols(&escape(text)))
}

/// Pairs of backticks as elements; one without its partner stays.
fn code(escaped: &str) -> String {
    let mut out = String::with_capacity(escaped.len());
    let mut rest = escaped;
    while let Some((before, after)) = rest.split_once('`') {
        let Some((inside, after)) = after.split_once('`') else {
            break;
        };
        out.push_str(&format!("{before}<code>{inside}</code>"));
        rest = after;
    }
    out + rest
}

/// PASS, FAIL, or that nothing was judged.
pub fn pass_word(passes: Option<bool>) -> &'static str {
    match passes {
        Some(true) => "PASS",
        Some(false) => "FAIL",
        None => "not judged",
    }
}

/// lC and β0 with a subscript, in text that is already escaped. A small l beside a
/// capital C cannot be told from an I otherwise.
pub(crate) fn symbols(escaped: &str) -> String {
    let mut out = String::with_capacity(escaped.len());
    let mut rest = escaped;
    while let Some(at) = rest.find("lC") {
        let inside = rest[..at]
            .chars()
            .next_back()
            .is_some_and(char::is_alphanumeric)
            || rest[at + 2..]
                .chars()
                .next()
                .is_some_and(char::is_alphanumeric);
        out.push_str(&rest[..at]);
        out.push_str(if inside { "lC" } else { "<i>l</i><sub>C</sub>" });
        rest = &rest[at + 2..];
    }
    out.push_str(rest);
    out.replace("β0", "β<sub>0</sub>")
}

/// JSON that can stand inside a `script` element.
pub fn script_json(value: &serde_json::Value) -> String {
    value
        .to_string()
        .replace('<', "\\u003c")
        .replace('\u{2028}', "\\u2028")
}

/// Letters and digits in lower case, joined by hyphens; never empty.
pub fn slug(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        if c.is_ascii_alphanumeric() {
            out.push(c.to_ascii_lowercase());
        } else if !out.is_empty() && !out.ends_with('-') {
            out.push('-');
        }
    }
    let out = out.trim_end_matches('-');
    if out.is_empty() {
        "part".to_owned()
    } else {
        out.to_owned()
    }
}

/// `value` with `decimals` decimals and a true minus sign; a dash if there is none.
pub fn fixed(value: Option<f64>, decimals: usize) -> String {
    match value {
        Some(v) if v.is_finite() => minus(&format!("{v:.decimals$}")),
        _ => "–".to_owned(),
    }
}

/// [`fixed`] with a sign in any case.
pub fn signed(value: Option<f64>, decimals: usize) -> String {
    match value {
        Some(v) if v.is_finite() => minus(&format!("{v:+.decimals$}")),
        _ => "–".to_owned(),
    }
}

/// Three significant digits, without needless zeros.
pub fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return fixed(Some(value), 0);
    }
    let magnitude = value.abs().log10().floor();
    if !(-4.0..6.0).contains(&magnitude) {
        let text = format!("{value:.2e}");
        return match text.split_once('e') {
            Some((digits, power)) => format!("{} × 10{}", minus(digits), raised(power)),
            None => text,
        };
    }
    let decimals = (2.0 - magnitude).max(0.0) as usize;
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    };
    minus(&text)
}

/// A whole number in superscript digits.
fn raised(power: &str) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raise = |c: char| c.to_digit(10).map_or('⁻', |d| digits[d as usize]);
    power.chars().map(raise).collect()
}

fn minus(text: &str) -> String {
    text.replace('-', "\u{2212}")
}

/// A number with its unit; a dash if there is none (no statistics of a run too short).
pub fn shown(value: f64, digits: usize, unit: &str) -> String {
    if value.is_finite() {
        format!("{value:.digits$}{unit}")
    } else {
        "-".to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_and_numbers_are_readable() {
        assert_eq!(escape("<b a='\"'>&"), "&lt;b a=&#39;&quot;&#39;&gt;&amp;");
        assert_eq!(
            rich("lC < 5, calC, β0"),
            "<i>l</i><sub>C</sub> &lt; 5, calC, β<sub>0</sub>"
        );
        assert_eq!(
            rich("`a < b` and `c`, one ` left"),
            "<code>a &lt; b</code> and <code>c</code>, one ` left"
        );
        let value = serde_json::json!("</script><!--");
        assert!(!script_json(&value).contains('<'));
        assert_eq!(
            serde_json::from_str::<serde_json::Value>(&script_json(&value)).ok(),
            Some(value)
        );
        assert_eq!(slug("Fig. 6, paper"), "fig-6-paper");
        assert_eq!(slug("ψ"), "part");
        assert_eq!(fixed(Some(-1.25), 1), "\u{2212}1.2");
        assert_eq!(fixed(None, 4), "–");
        assert_eq!(fixed(Some(f64::NAN), 4), "–");
        assert_eq!(signed(Some(0.0105), 4), "+0.0105");
        assert_eq!(short(12345.0), "12345");
        assert_eq!(short(0.050), "0.05");
        assert_eq!(short(1.5e-7), "1.50 × 10⁻⁷");
    }
}
