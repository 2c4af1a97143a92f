//! The specification of one plot: traces, axes, marks, in the JSON that plotly.js reads.

use serde_json::{Map, Value, json};

pub use crate::axes::Axes;
use crate::description;
pub use crate::margin::Margin;
pub use crate::trace::{
    Trace, line, line_in_space, line_of, markers, number, numbers, plain, with,
};

/// Colours that stay apart for colour-blind readers (Okabe and Ito).
pub const PALETTE: [&str; 7] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#444444",
];
/// Lines that recede.
pub const GREY: &str = "#9a9a9a";
/// Shade of what is discarded.
pub const DISCARDED: &str = "rgba(120,120,120,0.16)";
/// Shade of the discrete raceway.
pub const SECTOR: &str = "rgba(230,159,0,0.16)";
/// Fonts of figures.
pub const FONT: &str = "Helvetica Neue, Helvetica, Arial, Liberation Sans, sans-serif";
/// Points of a trace of which a figure has few.
pub const POINTS: usize = 4000;

/// A plot under construction.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    data: Vec<Value>,
    layout: Map<String, Value>,
    shapes: Vec<Value>,
    annotations: Vec<Value>,
    /// Height on the page, pixels.
    pub height_px: u32,
    /// Finding of the plot in words, for readers who do not see it; may be empty.
    pub finding: String,
    /// Stretches of the x-axis that get a button: name, from, to. The first is shown first.
    pub views: Vec<(String, [f64; 2])>,
}

impl Plot {
    /// An empty plot.
    pub fn new(height_px: u32) -> Self {
        let layout = json!({
            "font": { "family": FONT, "size": 13, "color": "#222" },
            "paper_bgcolor": "#fff",
            "plot_bgcolor": "#fff",
            "margin": Margin::default().json(),
            "hovermode": "closest",
            "showlegend": false,
            "legend": {
                "orientation": "h", "x": 0, "y": 1.0, "yanchor": "bottom",
                "font": { "size": 12 }, "bgcolor": "rgba(255,255,255,0)",
            },
        });
        let Value::Object(layout) = layout else {
            unreachable!("an object literal")
        };
        Self {
            data: Vec::new(),
            layout,
            shapes: Vec::new(),
            annotations: Vec::new(),
            height_px,
            finding: String::new(),
            views: Vec::new(),
        }
    }

    /// States what the plot shows, in a sentence for readers who do not see it.
    pub fn finding(mut self, finding: &str) -> Self {
        self.finding = finding.to_owned();
        self
    }

    /// Adds a stretch of the x-axis that gets a button; the first one is shown first.
    pub fn view(mut self, name: &str, range: [f64; 2]) -> Self {
        if self.views.is_empty()
            && let Some(axis) = self.layout.get_mut("xaxis")
        {
            axis["range"] = numbers(&range);
        }
        self.views.push((name.to_owned(), range));
        self
    }

    /// Shows the last of its views first.
    pub fn last_view_first(mut self) -> Self {
        self.views.reverse();
        let first = self.views.first().map(|(_, range)| numbers(range));
        if let (Some(range), Some(axis)) = (first, self.layout.get_mut("xaxis")) {
            axis["range"] = range;
        }
        self
    }

    /// The finding and the ranges of the quantities, in words.
    pub fn description(&self) -> String {
        let ranges = description::ranges(&self.data, &self.layout);
        match (self.finding.as_str(), ranges.as_str()) {
            ("", ranges) => ranges.to_owned(),
            (finding, "") => finding.to_owned(),
            (finding, ranges) => format!("{finding} {ranges}"),
        }
    }

    /// Sets a key of the layout.
    pub fn set(mut self, key: &str, value: Value) -> Self {
        self.layout.insert(key.to_owned(), value);
        self
    }

    /// Shows the legend above the plot.
    pub fn legend(self) -> Self {
        self.set("showlegend", true.into())
    }

    /// Shows the legend from the height `y` on, 1 being the top of the plot.
    pub fn legend_above(self, y: f64) -> Self {
        let font = json!({ "size": 12 });
        let at = json!({ "orientation": "h", "x": 0, "y": y, "yanchor": "bottom", "font": font });
        self.legend().set("legend", at)
    }

    /// Sets the size of all text that has none of its own, and of the legend, pixels.
    pub fn font_px(mut self, size: u32) -> Self {
        for key in ["font", "legend"] {
            let of = self.layout.entry(key).or_insert(json!({}));
            let size = json!({ "size": size });
            let more = if key == "font" {
                size
            } else {
                json!({ "font": size })
            };
            *of = with(of.take(), more);
        }
        self
    }

    /// Sets the room around its panels.
    pub fn margin(self, margin: Margin) -> Self {
        self.set("margin", margin.json())
    }

    /// Sets axis `name` (`xaxis`, `yaxis2`), titled `title`, with further keys.
    pub fn axis(mut self, name: &str, title: &str, more: Value) -> Self {
        let axis = json!({
            "title": { "text": crate::text::symbols(title), "standoff": 8 },
            "showline": true, "linecolor": "#555", "linewidth": 1,
            "ticks": "outside", "ticklen": 4, "tickcolor": "#555",
            "gridcolor": "#e6e6e6", "zeroline": false, "automargin": true,
        });
        self.layout.insert(name.to_owned(), with(axis, more));
        self
    }

    /// Sets the first axis along x, with further keys.
    pub fn x(self, title: &str, more: Value) -> Self {
        self.axis("xaxis", title, more)
    }

    /// Sets the first axis along y, with further keys.
    pub fn y(self, title: &str, more: Value) -> Self {
        self.axis("yaxis", title, more)
    }

    /// Sets axes of one scale, with further keys of the one along x.
    pub fn to_scale(self, x: &str, y: &str, x_more: Value) -> Self {
        let across = json!({ "scaleanchor": "y", "constrain": "domain" });
        let plot = self.x(x, with(across, x_more));
        plot.y(y, json!({ "constrain": "domain" }))
    }

    /// Sets the axes of a plot of one panel.
    pub fn axes(self, x: &str, y: &str) -> Self {
        self.x(x, json!({})).y(y, json!({}))
    }

    /// Adds a trace.
    pub fn trace(mut self, trace: impl Into<Trace>) -> Self {
        self.data.push(trace.into().0);
        self
    }

    /// Shades `from` to `to` along x over the whole height of the axis `y`
    /// (`y`, `y2`), or of all panels (`paper`).
    pub fn band(mut self, x: &str, y: &str, from: f64, to: f64, colour: &str) -> Self {
        self.shapes.push(json!({
            "type": "rect", "layer": "below", "line": { "width": 0 }, "fillcolor": colour,
            "xref": x, "yref": domain(y), "x0": number(from), "x1": number(to), "y0": 0, "y1": 1,
        }));
        self
    }

    /// Draws a vertical line at `at` over the whole height of the axis `y`.
    pub fn vertical(self, x: &str, y: &str, at: f64, dash: &str) -> Self {
        let at = number(at);
        self.rule(
            json!({ "xref": x, "yref": domain(y), "x0": at, "x1": at, "y0": 0, "y1": 1 }),
            dash,
        )
    }

    /// Draws a vertical line at `at` with a label above it.
    pub fn marked(self, axes: Axes<'_>, at: f64, label: &str, dash: &str) -> Self {
        let Axes { x, y } = axes;
        self.vertical(x, y, at, dash).text(
            label,
            (at, 1.0),
            (x, &domain(y)),
            json!({ "yanchor": "bottom", "font": { "size": 11, "color": "#555" } }),
        )
    }

    /// Draws a horizontal line at `at` over the whole width of the axis `x`.
    pub fn horizontal(self, x: &str, y: &str, at: f64, dash: &str) -> Self {
        let at = number(at);
        self.rule(
            json!({ "xref": domain(x), "yref": y, "y0": at, "y1": at, "x0": 0, "x1": 1 }),
            dash,
        )
    }

    fn rule(mut self, ends: Value, dash: &str) -> Self {
        let line = json!({ "width": 1, "color": "#555", "dash": dash });
        let rule = json!({ "type": "line", "layer": "above", "opacity": 0.75, "line": line });
        self.shapes.push(with(rule, ends));
        self
    }

    /// Writes `text` at (`x`, `y`) of the references `xref`, `yref`.
    pub fn text(mut self, text: &str, at: (f64, f64), refs: (&str, &str), more: Value) -> Self {
        let annotation = json!({
            "text": text, "showarrow": false, "font": { "size": 12, "color": "#333" },
            "x": number(at.0), "y": number(at.1), "xref": refs.0, "yref": refs.1,
        });
        self.annotations.push(with(annotation, more));
        self
    }

    /// Shades the time up to `until` as discarded and says so, from the left end of the shade
    /// on: centred in a short one, the label would lie across the axis.
    pub fn discarded(self, x: &str, y: &str, from: f64, until: f64) -> Self {
        if until <= from {
            return self;
        }
        self.band(x, y, from, until, DISCARDED).text(
            "discarded",
            (from, 1.0),
            (x, &domain(y)),
            json!({ "xanchor": "left", "xshift": 3, "yanchor": "top", "font": { "size": 11, "color": "#666" } }),
        )
    }

    /// The specification that plotly.js reads.
    pub fn spec(&self) -> Value {
        let mut layout = self.layout.clone();
        layout.insert("shapes".to_owned(), self.shapes.clone().into());
        layout.insert("annotations".to_owned(), self.annotations.clone().into());
        json!({ "data": description::with_hover(&self.data, &self.layout), "layout": layout })
    }
}

/// `paper` or the domain of an axis.
fn domain(axis: &str) -> String {
    if axis == "paper" {
        axis.to_owned()
    } else {
        format!("{axis} domain")
    }
}
