//! TOML as a tree that remembers where each value stands.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::error::CaseError;
use crate::text_file::excerpt;

/// Keys of a section with their values.
pub(crate) type Section = BTreeMap<String, Node>;

/// A value and its place.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    pub value: Value,
    pub place: Place,
}

impl Node {
    pub(crate) fn new(value: Value, origin: Origin, written: String) -> Self {
        let place = Place { origin, written };
        Self { value, place }
    }

    /// A value that stands in no file.
    pub(crate) fn nowhere(value: Value) -> Self {
        Self::new(value, Origin::Nowhere, String::new())
    }

    /// Forgets where the value and all below it come from.
    pub(crate) fn forget_place(&mut self) {
        self.place.origin = Origin::Nowhere;
        match &mut self.value {
            Value::Section(entries) => entries.values_mut().for_each(Self::forget_place),
            Value::List(items) => items.iter_mut().for_each(Self::forget_place),
            _ => {}
        }
    }

    /// The sections of a list, or the one that this is.
    pub(crate) fn items(&self) -> &[Self] {
        match &self.value {
            Value::List(items) => items,
            _ => std::slice::from_ref(self),
        }
    }

    /// Line in a file, from 1; 0 without one.
    pub(crate) fn line(&self) -> usize {
        match self.place.origin {
            Origin::Line(line) | Origin::Elsewhere(_, line) => line,
            Origin::Override(_) | Origin::File | Origin::Nowhere => 0,
        }
    }

    /// An error at this value of `file`.
    pub(crate) fn error(&self, file: &str, key: &str, message: String) -> CaseError {
        self.place.error(file, key, message)
    }

    /// "KEY = VALUE is not possible: it must be ALLOWED", at this value of `file`.
    pub(crate) fn refusal(&self, file: &str, key: &str, allowed: &str) -> CaseError {
        let written = &self.place.written;
        let message = format!("{key} = {written} is not possible: it must be {allowed}");
        self.error(file, key, message)
    }

    /// The error of the file whose path this value of `file` is. One that names a line or an
    /// option speaks for itself.
    pub(crate) fn error_of_its_file(&self, file: &str, key: &str, error: CaseError) -> CaseError {
        if error.line().is_some() || error.is_of_override() {
            return error;
        }
        let message = format!("{key} = {}: {error}", self.place.written);
        self.error(file, key, message)
    }
}

/// A value of TOML.
#[derive(Debug, Clone)]
pub(crate) enum Value {
    Integer(i64),
    Number(f64),
    Text(String),
    List(Vec<Node>),
    Section(Section),
    /// Value that no key accepts: a Boolean or a date.
    Other,
}

/// Place of a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Origin {
    /// Line of the file, counted from 1.
    Line(usize),
    /// In a file whose lines are not kept.
    File,
    /// In a `--set` of this text.
    Override(String),
    /// Line of another file, counted from 1: a plan.
    Elsewhere(String, usize),
    /// In no file: a default, or a value that the program gives.
    Nowhere,
}

/// Place and text of a value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Place {
    pub origin: Origin,
    pub written: String,
}

impl Place {
    /// An error at this place of `file`, or wherever else the value comes from.
    pub(crate) fn error(&self, file: &str, key: &str, message: String) -> CaseError {
        let named = Some(key.to_owned());
        match &self.origin {
            Origin::Line(line) => CaseError::on_line(file, *line, named, message),
            Origin::File | Origin::Nowhere => CaseError::of_file(file, message).with_key(key),
            Origin::Override(text) => CaseError::of_override(text, named, message),
            Origin::Elsewhere(other, line) => CaseError::on_line(other, *line, named, message),
        }
    }
}

/// A file as a tree of values with their places: what `--set`, axes and changes replace, and
/// what is read and written.
#[derive(Debug, Clone)]
pub(crate) struct Tree {
    pub root: Section,
    /// Name of the file, for messages.
    pub name: String,
}

impl Tree {
    pub(crate) fn new(root: Section, name: &str) -> Self {
        let name = name.to_owned();
        Self { root, name }
    }

    /// The value of a dotted key, or a section. A single `[[raceway]]` goes by the same keys as
    /// `[raceway]`.
    pub(crate) fn find(&self, path: &str) -> Option<&Node> {
        let mut parts = path.split('.');
        let mut node = self.root.get(parts.next()?)?;
        for part in parts {
            node = match &node.value {
                Value::Section(section) => match section.get(part) {
                    None if part == "1" => node,
                    found => found?,
                },
                Value::List(list) => match (part.parse::<usize>(), list.as_slice()) {
                    (Ok(number), _) => list.get(number.checked_sub(1)?)?,
                    (Err(_), [one]) => match &one.value {
                        Value::Section(section) => section.get(part)?,
                        _ => return None,
                    },
                    _ => return None,
                },
                _ => return None,
            };
        }
        Some(node)
    }

    /// The value of a dotted key, or a section, if a file or an option has it.
    pub(crate) fn given(&self, path: &str) -> Option<&Node> {
        let is_given = |node: &&Node| node.place.origin != Origin::Nowhere;
        self.find(path).filter(is_given)
    }

    /// An error at a dotted key, or at its section if the key is not written.
    pub(crate) fn error(&self, path: &str, message: String) -> CaseError {
        let mut known = path;
        while !known.is_empty() {
            if let Some(node) = self.given(known) {
                return node.error(&self.name, path, message);
            }
            known = known.rsplit_once('.').map_or("", |(front, _)| front);
        }
        CaseError::of_file(&self.name, message).with_key(path)
    }

    /// "KEY = VALUE is not possible: it must be ALLOWED", the value as written if it is, otherwise
    /// `value`.
    pub(crate) fn refusal(&self, path: &str, value: &str, allowed: &str) -> CaseError {
        let given = self.given(path);
        let value = given.map_or(value, |node| &node.place.written);
        let message = format!("{path} = {value} is not possible: it must be {allowed}");
        self.error(path, message)
    }
}

/// `section.key`, or the key alone at the head of the file.
pub(crate) fn join(section: &str, key: &str) -> String {
    if section.is_empty() {
        key.to_owned()
    } else {
        format!("{section}.{key}")
    }
}

/// Path of the k-th of several sections of one name.
pub(crate) fn nth(name: &str, k: usize, count: usize) -> String {
    if count == 1 {
        name.to_owned()
    } else {
        format!("{name}.{}", k + 1)
    }
}

/// The section of a key and the name of the key in it; makes the section if there is none.
pub(crate) fn section_at<'r, 'p>(
    root: &'r mut Section,
    path: &[&'p str],
    place: &Place,
) -> Result<(&'r mut Section, &'p str), String> {
    let (name, index, key) = match *path {
        [key] => return Ok((root, key)),
        [name, key] => (name, None, key),
        [name, index, key] => (name, Some(index), key),
        _ => {
            let key = path.join(".");
            return Err(format!("`{key}` is not a key: write section.key=value"));
        }
    };
    let new = || Node {
        value: Value::Section(BTreeMap::new()),
        place: place.clone(),
    };
    let section = root.entry(name.to_owned()).or_insert_with(new);
    match (&mut section.value, index) {
        (Value::Section(section), None) => Ok((section, key)),
        (Value::List(list), index) => Ok((section_of(list, name, index, key)?, key)),
        (Value::Section(_), Some(_)) => Err(format!("there is only one [{name}]")),
        _ => Err(format!("`{name}` is not a section in the case file")),
    }
}

/// One of the `[[name]]` sections, `index` counting from 1.
fn section_of<'a>(
    list: &'a mut [Node],
    name: &str,
    index: Option<&str>,
    key: &str,
) -> Result<&'a mut Section, String> {
    let count = list.len();
    let index: usize = match index {
        Some(index) => index.parse().unwrap_or(0),
        None if count == 1 => 1,
        None => {
            return Err(format!(
                "there are {count} [[{name}]] sections: write {name}.1.{key} for the first"
            ));
        }
    };
    match index.checked_sub(1).and_then(|k| list.get_mut(k)) {
        Some(Node {
            value: Value::Section(section),
            ..
        }) => Ok(section),
        _ => Err(format!(
            "there are {count} [[{name}]] sections, counted from 1"
        )),
    }
}

/// Parses a case file.
pub(crate) fn parse(text: &str, name: &str) -> Result<Section, CaseError> {
    // Windows editors put it there; it is not part of the text.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let table = DeTable::parse(text).map_err(|e| syntax_error(text, name, &e))?;
    let lines = Lines::new(text);
    let origin = |span: &Range<usize>| Origin::Line(lines.at(span.start));
    Ok(section(table.get_ref(), text, &origin))
}

/// Parses the value of a `--set`; the error is what is wrong with it.
pub(crate) fn parse_override(value: &str, whole: &str) -> Result<Node, String> {
    let parsed = DeValue::parse(value).map_err(|e| e.message().to_owned())?;
    let origin = |_: &Range<usize>| Origin::Override(whole.to_owned());
    let converted = convert(parsed.get_ref(), value, &origin);
    Ok(Node::new(converted, origin(&(0..0)), value.to_owned()))
}

type OriginOf<'a> = dyn Fn(&Range<usize>) -> Origin + 'a;

fn section(table: &DeTable<'_>, text: &str, origin: &OriginOf<'_>) -> Section {
    let entry = |(key, value): (&Spanned<DeString<'_>>, &Spanned<DeValue<'_>>)| {
        let node = node(value, key.span(), text, origin);
        (key.get_ref().to_string(), node)
    };
    table.iter().map(entry).collect()
}

/// A value whose place is that of `span`.
fn node(
    value: &Spanned<DeValue<'_>>,
    span: Range<usize>,
    text: &str,
    origin: &OriginOf<'_>,
) -> Node {
    let written = excerpt(text.get(value.span()).unwrap_or(""));
    Node::new(
        convert(value.get_ref(), text, origin),
        origin(&span),
        written,
    )
}

fn convert(value: &DeValue<'_>, text: &str, origin: &OriginOf<'_>) -> Value {
    match value {
        DeValue::String(s) => Value::Text(s.to_string()),
        DeValue::Integer(i) => match i64::from_str_radix(i.as_str(), i.radix()) {
            Ok(integer) => Value::Integer(integer),
            // Too many digits for an integer, yet a number.
            Err(_) => Value::Number(i.as_str().parse().unwrap_or(f64::INFINITY)),
        },
        DeValue::Float(f) => Value::Number(f.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(_) | DeValue::Datetime(_) => Value::Other,
        DeValue::Array(items) => {
            let item = |item: &Spanned<DeValue<'_>>| node(item, item.span(), text, origin);
            Value::List(items.iter().map(item).collect())
        }
        DeValue::Table(table) => Value::Section(section(table, text, origin)),
    }
}

/// Offsets of the ends of all lines, so that a file is read once however many values it has.
struct Lines(Vec<usize>);

impl Lines {
    fn new(text: &str) -> Self {
        Self(text.match_indices('\n').map(|(at, _)| at).collect())
    }

    /// Line of an offset, counted from 1.
    fn at(&self, offset: usize) -> usize {
        1 + self.0.partition_point(|end| *end < offset)
    }
}

fn syntax_error(text: &str, name: &str, error: &toml::de::Error) -> CaseError {
    let Some(span) = error.span() else {
        return CaseError::of_file(name, format!("is not TOML: {}", error.message()));
    };
    let line = Lines::new(text).at(span.start);
    let source = text.lines().nth(line - 1).unwrap_or("").trim();
    let hint = match has_decimal_comma(source) {
        true => "; a decimal sign is a point",
        false => "",
    };
    let message = format!(
        "is not TOML: {}: `{}`{hint}",
        error.message(),
        excerpt(source)
    );
    CaseError::on_line(name, line, key_on_line(text, line), message)
}

/// Whether the value on a line is a number with a comma: `key = 4,7625`.
fn has_decimal_comma(line: &str) -> bool {
    let value = line.split_once('=').map_or("", |(_, value)| value);
    let value = value.split('#').next().unwrap_or_default().trim();
    value.matches(',').count() == 1 && value.replace(',', ".").parse::<f64>().is_ok()
}

/// The dotted key that a line seems to set. A file that is not TOML has no tree
/// to ask.
fn key_on_line(text: &str, line: usize) -> Option<String> {
    let bare = |s: &str| {
        !s.is_empty()
            && s.chars()
                .all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.'))
    };
    let header = |line: &str| {
        let name = line
            .trim()
            .strip_prefix('[')?
            .split([']', '#'])
            .next()?
            .trim_matches(['[', ' ']);
        bare(name).then(|| name.to_owned())
    };
    let current = text.lines().nth(line - 1)?;
    if let Some(section) = header(current) {
        return Some(section);
    }
    let key = current.split('=').next()?.trim();
    let before: Vec<_> = text.lines().take(line - 1).collect();
    let section = before
        .into_iter()
        .rev()
        .find_map(header)
        .unwrap_or_default();
    bare(key).then(|| join(&section, key))
}
