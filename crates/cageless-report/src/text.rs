//! Text for HTML.

pub use cageless_results::number_text::{fixed, short, signed, significant};

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

/// Text with a capital letter at the beginning, unless it begins with a symbol.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    match letters.next() {
        Some(first) if first.is_ascii_lowercase() => {
            first.to_ascii_uppercase().to_string() + letters.as_str()
        }
        _ => text.to_owned(),
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

/// A long title or remark in two lines.
pub fn broken(title: &str) -> String {
    const LONG: usize = 24;
    if title.chars().count() <= LONG {
        return title.to_owned();
    }
    let middle = title.len() / 2;
    let spaces = title.match_indices(' ').map(|(at, _)| at);
    match spaces.min_by_key(|at| at.abs_diff(middle)) {
        Some(at) => format!("{}<br>{}", &title[..at], &title[at + 1..]),
        None => title.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped() {
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
    }
}
