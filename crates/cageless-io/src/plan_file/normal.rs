//! Normal form of a plan, independent of its notation.

use toml::Value;

use super::axis::Axis;
use super::{AxisValues, PlanFile, ScatterLaw};
use crate::case_file::CaseError;
use crate::case_file::format::SCHEMA;
use crate::case_file::value::quoted;
use crate::text_file::excerpt;

impl PlanFile {
    /// The plan as flat TOML: every default filled in, the case in it, one key per line,
    /// nothing of comments and order. It reads back as the same plan.
    ///
    /// # Errors
    /// None that a plan from a file can cause.
    pub fn normal(&self) -> Result<String, CaseError> {
        let mut lines = vec![
            format!("schema = {SCHEMA}"),
            format!("title = {}", quoted(&self.title)),
            format!("seed = {}", self.seed),
        ];
        let names: Vec<_> = self.compute.iter().map(|c| quoted(c.name())).collect();
        lines.push(format!("compute = [{}]", names.join(", ")));
        if let Some(keep) = &self.keep {
            let names: Vec<_> = keep.iter().map(|k| quoted(&k.name)).collect();
            lines.push(format!("keep = [{}]", names.join(", ")));
        }
        for axis in &self.grid {
            lines.push(format!("grid.{} = {}", axis.key, specification(axis)));
        }
        if let Some(samples) = &self.samples {
            let method = samples.method.name();
            lines.push(format!("samples.method = {}", quoted(method)));
            lines.push(format!("samples.count = {}", samples.count));
            for axis in &samples.axes {
                lines.push(format!("samples.{} = {}", axis.key, specification(axis)));
            }
        }
        if let Some(scatter) = &self.scatter {
            lines.push(format!("scatter.repeats = {}", scatter.repeats));
            for key in &scatter.keys {
                let law = match key.law {
                    ScatterLaw::Normal(width) => format!("{{ normal = {} }}", Value::from(width)),
                    ScatterLaw::Uniform(width) => format!("{{ uniform = {} }}", Value::from(width)),
                    ScatterLaw::Random => quoted("random"),
                };
                lines.push(format!("scatter.{} = {law}", key.key));
            }
        }
        let case = self.base_file.to_value()?;
        flatten("case", &case, &mut lines);
        Ok(lines.join("\n") + "\n")
    }
}

fn flatten(prefix: &str, value: &Value, lines: &mut Vec<String>) {
    match value {
        Value::Table(table) => {
            for (key, value) in table {
                flatten(&format!("{prefix}.{key}"), value, lines);
            }
        }
        Value::String(text) => lines.push(format!("{prefix} = {}", quoted(text))),
        value => lines.push(format!("{prefix} = {value}")),
    }
}

fn specification(axis: &Axis) -> String {
    match &axis.values {
        AxisValues::List(list) => {
            let list: Vec<_> = list.iter().map(|v| v.written()).collect();
            format!("[{}]", list.join(", "))
        }
        AxisValues::Range(range) => {
            let count = range.count.map(|n| format!("count = {n}, "));
            format!(
                "{{ from = {}, to = {}, {}scale = {} }}",
                Value::from(range.from),
                Value::from(range.to),
                count.unwrap_or_default(),
                quoted(range.scale.name()),
            )
        }
    }
}

/// The text of a key of a plan in its normal form; `None` if the key is not there or no text.
pub fn text_of(plan: &str, key: &str) -> Option<String> {
    let mut lines = plan.lines();
    let value = lines.find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "))?;
    let mut table: toml::Table = toml::from_str(&format!("value = {value}")).ok()?;
    match table.remove("value")? {
        Value::String(text) => Some(text),
        _ => None,
    }
}

/// Differences between two plans in their normal form, a line for each key; empty if
/// nothing does.
pub fn difference(before: &str, now: &str) -> Vec<String> {
    let keys = |text: &str| -> Vec<(String, String)> {
        text.lines()
            .filter_map(|line| line.split_once(" = "))
            .map(|(key, value)| (key.to_owned(), value.to_owned()))
            .collect()
    };
    let (before, now) = (keys(before), keys(now));
    let find = |list: &[(String, String)], key: &str| {
        let found = list.iter().find(|(k, _)| k == key);
        found.map(|(_, value)| value.clone())
    };
    let mut lines = Vec::new();
    for (key, old) in &before {
        let was = format!("{key} was {}", shortened(old));
        match find(&now, key) {
            Some(new) if new == *old => {}
            Some(new) => lines.push(format!("{was}, is {}", shortened(&new))),
            None => lines.push(format!("{was}, is left out")),
        }
    }
    for (key, new) in &now {
        if find(&before, key).is_none() {
            lines.push(format!("{key} was left out, is {}", shortened(new)));
        }
    }
    lines
}

/// A value of a plan for readers: the matrices of a rotor are as long as a book.
pub fn shortened(value: &str) -> String {
    excerpt(value)
}
