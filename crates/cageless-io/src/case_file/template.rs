//! The case file to start from.

use super::format::Heading;
use super::key::{Key, Line};
use super::sections::CASE_FILE;

const INTRODUCTION: &str = "\
# Case file of Cageless, a cageless ball bearing with a discrete raceway.
# Numbers marked (paper) are those of Zhao, Zhou, Wang, \"Discrete Dynamics of
# Balls in Cageless Ball Bearings\", Symmetry 2022, 14, 2242, Table 1 and 2. The
# others are not in the paper; they are assumptions to be replaced by your own.
";

const DEFAULTS: &str = "
# The sections bearing and operation are required. A key of the sections material, contact, model,
# solver and output that is left out takes the value that is written here, and so does gravity_m_s2;
# flanks are elastic then.
";

/// Line of a template that stands for the section `[raceway]`.
pub(super) const CONVENTIONAL: &str = "# No [raceway] section: the outer ring is conventional.";

/// Column of the comments.
const COLUMN: usize = 43;
/// Longest line.
const WIDTH: usize = 104;

/// A commented case file: the bearing of Zhao 2022 with structure (d), or with a
/// conventional outer ring.
pub fn template(conventional: bool) -> String {
    let mut text = INTRODUCTION.to_owned();
    for key in CASE_FILE.head {
        push_key(&mut text, key, false);
    }
    text.push_str(DEFAULTS);
    for section in CASE_FILE.sections {
        if matches!(section.heading, Heading::Absent) {
            continue;
        }
        text.push('\n');
        if conventional && section.name == "raceway" {
            push_line(&mut text, CONVENTIONAL, "");
            continue;
        }
        let (heading, comment, out) = match section.heading {
            Heading::Shown(comment) => (format!("[{}]", section.name), comment, false),
            Heading::Commented(comment) => (format!("# [{}]", section.name), comment, true),
            Heading::Absent => continue,
        };
        push_line(&mut text, &heading, comment);
        for key in section.keys {
            push_key(&mut text, key, out);
        }
    }
    text
}

/// The sections `[rotor]` and `[support]` of a drop, with assumed values, as in `cases/touchdown-d.toml`.
pub fn drop_template() -> String {
    let mut text = String::new();
    for section in CASE_FILE.sections {
        if !["rotor", "support"].contains(&section.name) {
            continue;
        }
        text.push('\n');
        push_line(&mut text, &format!("[{}]", section.name), "assumed");
        for key in section.keys {
            push_key(&mut text, key, false);
        }
    }
    text
}

fn push_key(text: &mut String, key: &Key, out: bool) {
    let (value, comment, out) = match key.line {
        Line::Shown(value, comment) => (value, comment, out),
        Line::Commented(value, comment) => (value, comment, true),
        Line::Absent => return,
    };
    let sign = if out { "# " } else { "" };
    push_line(text, &format!("{sign}{} = {value}", key.name), comment);
}

/// A line with its comment, which continues on lines of its own where it is too long.
fn push_line(text: &mut String, line: &str, comment: &str) {
    let mut line = line.to_owned();
    for (k, part) in comment.split('\n').enumerate() {
        let mut words = part.split(' ').peekable();
        while words.peek().is_some_and(|w| !w.is_empty()) {
            let mut row = String::new();
            while let Some(word) = words.next_if(|w| {
                row.is_empty() || COLUMN + 2 + row.chars().count() + w.chars().count() <= WIDTH
            }) {
                row = format!("{row} {word}");
            }
            text.push_str(&format!("{line:<COLUMN$}#{row}\n"));
            line.clear();
        }
        debug_assert!(k == 0 || line.is_empty());
    }
    if !line.is_empty() {
        text.push_str(&line);
        text.push('\n');
    }
}
