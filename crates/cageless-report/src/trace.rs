//! A trace of a plot, in the JSON that plotly.js reads.

use serde_json::{Value, json};

use crate::axes::Axes;
use crate::sampling::Points;

/// Drawing of one series of values on its axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace(pub(crate) Value);

impl From<Value> for Trace {
    fn from(value: Value) -> Self {
        Self(value)
    }
}

/// A line through (`x`, `y`), every point of it; the name is plain text.
pub fn line(name: &str, x: &[f64], y: &[f64], colour: &str) -> Trace {
    Trace(json!({
        "type": "scatter", "mode": "lines", "name": plain(name),
        "x": numbers(x), "y": numbers(y), "line": { "color": colour, "width": 1.4, "simplify": false },
    }))
}

/// [`line()`] through thinned points.
pub fn line_of(name: &str, points: Points, colour: &str) -> Trace {
    line(name, &points.x, &points.y, colour)
}

/// A line through points in space, without labels on hover.
pub fn line_in_space(name: &str, points: &[[f64; 3]], colour: &str, width: u32) -> Trace {
    let of = |k: usize| numbers(&points.iter().map(|p| p[k]).collect::<Vec<f64>>());
    Trace(json!({
        "type": "scatter3d", "mode": "lines", "name": name, "hoverinfo": "skip",
        "x": of(0), "y": of(1), "z": of(2), "line": { "color": colour, "width": width },
    }))
}

/// Markers at (`x`, `y`).
pub fn markers(name: &str, x: &[f64], y: &[f64], colour: &str) -> Trace {
    Trace(json!({
        "type": "scatter", "mode": "markers", "name": plain(name),
        "x": numbers(x), "y": numbers(y), "marker": { "color": colour, "size": 8 },
    }))
}

impl Trace {
    /// The trace with further keys, merged at every level.
    pub fn with(self, more: Value) -> Self {
        Self(with(self.0, more))
    }

    /// Sets the width of its line, pixels.
    pub fn width(self, width_px: f64) -> Self {
        self.with(json!({ "line": { "width": number(width_px) } }))
    }

    /// Sets the dashes of its line.
    pub fn dash(self, dash: &str) -> Self {
        self.with(json!({ "line": { "dash": dash } }))
    }

    /// Puts it on a pair of axes.
    pub fn on(self, axes: Axes<'_>) -> Self {
        self.with(json!({ "xaxis": axes.x, "yaxis": axes.y }))
    }

    /// Makes it one of a group of traces of which one is in the legend.
    pub fn in_group(self, group: &str, in_legend: bool) -> Self {
        self.with(json!({ "legendgroup": group, "showlegend": in_legend }))
    }
}

/// `value` with further keys, merged at every level.
pub fn with(mut value: Value, more: Value) -> Value {
    merge(&mut value, more);
    value
}

fn merge(into: &mut Value, more: Value) {
    match (into, more) {
        (Value::Object(into), Value::Object(more)) => {
            for (key, value) in more {
                merge(into.entry(key).or_insert(Value::Null), value);
            }
        }
        (into, more) => *into = more,
    }
}

/// Text without the markup that plotly.js would read in it; lC and β0 get their index.
pub fn plain(text: &str) -> String {
    let escaped = text
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;");
    crate::text::symbols(&escaped)
}

/// Six significant digits; `null` for what is not a number.
pub fn number(value: f64) -> Value {
    if !value.is_finite() {
        return Value::Null;
    }
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if rounded == rounded.trunc() && rounded.abs() < 1e9 {
        (rounded as i64).into()
    } else {
        rounded.into()
    }
}

/// [`number`] of each.
pub fn numbers(values: &[f64]) -> Value {
    values.iter().copied().map(number).collect()
}
