//! The case file to start from.

/// Section that a conventional bearing does not have.
const RACEWAY: &str = "[raceway]";
/// Section after it.
const AFTER_RACEWAY: &str = "[operation]";

/// A commented case file: the bearing of Zhao 2022 with structure (d), or with a
/// conventional outer ring.
pub fn template(conventional: bool) -> String {
    let text = include_str!("template.toml");
    if !conventional {
        return text.to_owned();
    }
    let conventional = text.split_once(RACEWAY).and_then(|(before, rest)| {
        let (_, after) = rest.split_once(AFTER_RACEWAY)?;
        Some(format!(
            "{before}# No [raceway] section: the outer ring is conventional.\n\n{AFTER_RACEWAY}{after}"
        ))
    });
    conventional.unwrap_or_else(|| text.to_owned())
}
