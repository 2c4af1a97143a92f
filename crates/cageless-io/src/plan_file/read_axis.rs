//! Axes and distributions in the text of a plan.

use super::key::{GAPS, is_per_ball, key_in_case};
use super::keys::RangeKeys;
use super::read::{Entry, PlanReader};
use super::{Axis, AxisValues, Range, Scale, ScatterLaw};
use crate::case_file::declaration::SectionKeys;
use crate::case_file::reader::Reader;
use crate::case_file::spanned_toml::{Node, Section, Value};
use crate::case_file::{CaseError, CaseValue};

impl PlanReader<'_> {
    /// An axis: a list or a range. On an axis of the grid a range needs a count.
    pub(super) fn axis(&self, entry: Entry<'_>, counted: bool) -> Result<Axis, CaseError> {
        let Entry { key, node } = entry;
        let allowed = if counted {
            "a list, or { from = …, to = …, count = …, scale = \"linear\" or \"log\" }"
        } else {
            "a list, or { from = …, to = …, scale = \"linear\" or \"log\" }"
        };
        if is_per_ball(&key) {
            let message = format!("{key} has a value for each ball: it varies in [scatter]");
            return Err(self.error(node, &key, message));
        }
        let values = match &node.value {
            Value::List(items) => {
                let list: Option<Vec<_>> = items
                    .iter()
                    .map(|i| CaseValue::from_toml(&i.value))
                    .collect();
                let list = list.filter(|list| alike(list));
                AxisValues::List(list.ok_or_else(|| {
                    self.refuse(&key, node, "a list of numbers or of names, at least one")
                })?)
            }
            Value::Section(range) => {
                AxisValues::Range(self.range(&key, node, range, counted, allowed)?)
            }
            _ => return Err(self.refuse(&key, node, allowed)),
        };
        Ok(Axis {
            key,
            values,
            line: node.line(),
        })
    }

    fn range(
        &self,
        key: &str,
        node: &Node,
        range: &Section,
        counted: bool,
        allowed: &str,
    ) -> Result<Range, CaseError> {
        let known = |name: &str| {
            let keys = RangeKeys::KEYS.iter().map(|key| key.name);
            keys.into_iter().any(|key| key == name) && (counted || name != "count")
        };
        if let Some((name, inner)) = range.iter().find(|(name, _)| !known(name)) {
            let message = format!("{key}.{name} is not part of an axis: it must be {allowed}");
            return Err(self.error(inner, &format!("{key}.{name}"), message));
        }
        let mut needed = ["from", "to"].into_iter().chain(counted.then_some("count"));
        if let Some(name) = needed.find(|name| !range.contains_key(*name)) {
            let path = format!("{key}.{name}");
            let message = format!("{path} is missing: an axis is {allowed}");
            return Err(self.error(node, &path, message));
        }
        let RangeKeys {
            from,
            to,
            scale,
            count,
        } = RangeKeys::read(&Reader {
            tree: self.tree,
            keys: RangeKeys::KEYS,
            path: key.to_owned(),
            entries: Some(range),
        })?;
        let scale = scale.unwrap_or(Scale::Linear);
        if scale == Scale::Log && !(from > 0.0 && to > 0.0) {
            let allowed = "a range above 0 at both ends, as scale is \"log\"";
            return Err(self.refuse(key, node, allowed));
        }
        Ok(Range {
            from,
            to,
            count,
            scale,
        })
    }

    pub(super) fn law(&self, key: &str, node: &Node) -> Result<ScatterLaw, CaseError> {
        let gaps = key_in_case(key) == GAPS;
        let allowed = format!(
            "{{ normal = STANDARD_DEVIATION }} or {{ uniform = HALF_WIDTH }}{}",
            if gaps { ", or \"random\"" } else { "" }
        );
        match &node.value {
            Value::Text(text) if gaps && text == "random" => return Ok(ScatterLaw::Random),
            Value::Section(section) => {
                let mut entries = section.iter();
                if let (Some((name, node)), None) = (entries.next(), entries.next()) {
                    let width = number(node).filter(|w| w.is_finite() && *w >= 0.0);
                    let law = match name.as_str() {
                        "normal" => ScatterLaw::Normal as fn(f64) -> ScatterLaw,
                        "uniform" => ScatterLaw::Uniform,
                        _ => return Err(self.refuse(key, node, &allowed)),
                    };
                    let path = format!("{key}.{name}");
                    return width
                        .map(law)
                        .ok_or_else(|| self.refuse(&path, node, "a number, 0 or more"));
                }
            }
            _ => {}
        }
        Err(self.refuse(key, node, &allowed))
    }
}

fn number(node: &Node) -> Option<f64> {
    match node.value {
        Value::Integer(i) => Some(i as f64),
        Value::Number(f) => Some(f),
        _ => None,
    }
}

/// Test of the values of an axis: at least one, each a number or a name, no lists.
fn alike(list: &[CaseValue]) -> bool {
    !list.is_empty() && !list.iter().any(|v| matches!(v, CaseValue::Numbers(_)))
}
