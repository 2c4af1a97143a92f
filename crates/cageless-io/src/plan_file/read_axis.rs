//! Axes and distributions in the text of a plan.

use super::key::key_in_case;
use super::read::{Entry, PlanReader};
use super::{Axis, AxisValues, Range, Scale, ScatterLaw};
use crate::case_file::named::Named;
use crate::case_file::spanned_toml::{Node, Section, Value};
use crate::case_file::{CaseError, CaseValue};

/// Keys that are lists with an item for each ball.
const PER_BALL: [&str; 2] = ["bearing.ball_radius_deviation_um", "start.gaps"];

impl PlanReader<'_> {
    /// An axis: a list or a range. On an axis of the grid a range needs a count.
    pub(super) fn axis(&self, entry: Entry<'_>, counted: bool) -> Result<Axis, CaseError> {
        let Entry { key, node } = entry;
        let allowed = if counted {
            "a list, or { from = …, to = …, count = …, scale = \"linear\" or \"log\" }"
        } else {
            "a list, or { from = …, to = …, scale = \"linear\" or \"log\" }"
        };
        if PER_BALL.contains(&key_in_case(&key)) {
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
        let known =
            |name: &str| matches!(name, "from" | "to" | "scale") || counted && name == "count";
        if let Some((name, inner)) = range.iter().find(|(name, _)| !known(name)) {
            let message = format!("{key}.{name} is not part of an axis: it must be {allowed}");
            return Err(self.error(inner, &format!("{key}.{name}"), message));
        }
        let end = |name: &str| match range.get(name) {
            None => Err(self.error(
                node,
                &format!("{key}.{name}"),
                format!("{key}.{name} is missing: an axis is {allowed}"),
            )),
            Some(inner) => number(inner)
                .filter(|v| v.is_finite())
                .ok_or_else(|| self.refuse(&format!("{key}.{name}"), inner, "a finite number")),
        };
        let (from, to) = (end("from")?, end("to")?);
        let scale = match range.get("scale") {
            None => Scale::Linear,
            Some(inner) => Scale::of_node(inner)
                .ok_or_else(|| self.refuse(&format!("{key}.scale"), inner, &Scale::choices()))?,
        };
        if scale == Scale::Log && !(from > 0.0 && to > 0.0) {
            let allowed = "a range above 0 at both ends, as scale is \"log\"";
            return Err(self.refuse(key, node, allowed));
        }
        let count = match (counted, self.count(key, "count", range, 2)?) {
            (true, None) => {
                let message = format!("{key}.count is missing: an axis is {allowed}");
                return Err(self.error(node, &format!("{key}.count"), message));
            }
            (_, count) => count,
        };
        Ok(Range {
            from,
            to,
            count,
            scale,
        })
    }

    pub(super) fn law(&self, key: &str, node: &Node) -> Result<ScatterLaw, CaseError> {
        let gaps = key_in_case(key) == "start.gaps";
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

/// Whether all are numbers, or all are names or numbers; not empty, no lists.
fn alike(list: &[CaseValue]) -> bool {
    !list.is_empty() && !list.iter().any(|v| matches!(v, CaseValue::Numbers(_)))
}
