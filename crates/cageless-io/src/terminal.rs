//! Text that is not ours, on a terminal.

use std::borrow::Cow;
use std::fmt::Write;

/// The text with `\u001b` and the like for the characters that would command a terminal instead of
/// being shown on it: control characters but for line feeds and tabs, and those that turn the
/// direction of writing. Within strings of JSON and TOML it means the same.
pub fn on_terminal(text: &str) -> Cow<'_, str> {
    if !text.contains(commands) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 5);
    for c in text.chars() {
        if commands(c) {
            // Writing to a string cannot fail.
            let _ = write!(shown, "\\u{:04x}", u32::from(c));
        } else {
            shown.push(c);
        }
    }
    Cow::Owned(shown)
}

/// Longest message about a text that is not ours, in characters.
const MESSAGE_MAX: usize = 2000;

/// A message that holds text that is not ours: without its middle if that is long.
pub fn bounded(message: String) -> String {
    let count = message.chars().count();
    if count <= MESSAGE_MAX {
        return message;
    }
    let half: usize = MESSAGE_MAX / 2;
    let ends = |from: usize| message.chars().skip(from).take(half);
    ends(0)
        .chain(" … ".chars())
        .chain(ends(count - half))
        .collect()
}

fn commands(c: char) -> bool {
    let turns =
        matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || (c.is_control() && !matches!(c, '\n' | '\t'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_commands_a_terminal() {
        let text = "\u{1b}[2J\u{7}\u{9b}31m\r\u{202e}";
        let shown = on_terminal(text);
        assert_eq!(shown, "\\u001b[2J\\u0007\\u009b31m\\u000d\\u202e");
        let json = format!("\"{shown}\"");
        assert_eq!(serde_json::from_str::<String>(&json).unwrap(), text);
        assert_eq!(on_terminal("ε = 1°\t\n"), "ε = 1°\t\n");
    }

    #[test]
    fn long_messages_lose_their_middle() {
        let text = |n: usize| format!("a{}b", "ε".repeat(n));
        assert_eq!(bounded(text(MESSAGE_MAX - 2)), text(MESSAGE_MAX - 2));
        let short = bounded(text(1 << 20));
        assert_eq!(short.chars().count(), MESSAGE_MAX + 3);
        assert!(short.starts_with("aε") && short.ends_with("εb") && short.contains("ε … ε"));
    }
}
