//! Plots in words: labels of hovered points, and ranges for readers who do not see them.

use serde_json::{Map, Value};

use crate::text::short;

/// Quantities of a plot that its description names.
const QUANTITIES: usize = 4;

/// Adds the names and units of the axes to every point that a pointer may rest on.
pub fn with_hover(data: &[Value], layout: &Map<String, Value>) -> Vec<Value> {
    data.iter()
        .map(|trace| {
            let mut trace = trace.clone();
            let known = ["hovertemplate", "hoverinfo"];
            if let Some(fields) = trace.as_object_mut()
                && !known.iter().any(|key| fields.contains_key(*key))
                && let Some(template) = hover(fields, layout)
            {
                fields.insert("hovertemplate".to_owned(), template.into());
            }
            trace
        })
        .collect()
}

/// Key of the axis of a trace: `xaxis2` for its `x2`.
fn axis_of(trace: &Map<String, Value>, letter: &str) -> String {
    let key = format!("{letter}axis");
    let reference = trace.get(&key).and_then(Value::as_str).unwrap_or(letter);
    key + &reference[letter.len()..]
}

/// Title of an axis; empty if it has none.
fn title_of(axis: String, layout: &Map<String, Value>) -> String {
    let title = &layout.get(&axis).unwrap_or(&Value::Null)["title"]["text"];
    title.as_str().unwrap_or_default().replace("<br>", " ")
}

fn hover(trace: &Map<String, Value>, layout: &Map<String, Value>) -> Option<String> {
    let kind = trace.get("type")?.as_str()?;
    let line = |letter: &str| {
        let title = title_of(axis_of(trace, letter), layout);
        match title.as_str() {
            "" => format!("%{{{letter}}}"),
            title => format!("{title}: %{{{letter}}}"),
        }
    };
    let mut lines = match kind {
        "scatter" | "bar" => vec![line("x"), line("y")],
        "heatmap" => {
            let unit = colour_title(trace, layout);
            vec![line("x"), line("y"), format!("{unit}: %{{z}}")]
        }
        "scatterpolar" => vec!["ψ: %{theta}°".to_owned(), "%{r}".to_owned()],
        _ => return None,
    };
    if trace.contains_key("name") {
        lines.insert(0, "<b>%{fullData.name}</b>".to_owned());
    }
    Some(format!("{}<extra></extra>", lines.join("<br>")))
}

/// Title of the scale of colours of a heat map.
fn colour_title(trace: &Map<String, Value>, layout: &Map<String, Value>) -> String {
    let own = &trace.get("colorbar").unwrap_or(&Value::Null)["title"]["text"];
    let shared = &layout.get("coloraxis").unwrap_or(&Value::Null)["colorbar"]["title"]["text"];
    let title = own.as_str().or(shared.as_str()).unwrap_or_default();
    title.replace("<br>", " ")
}

/// Ranges of the quantities of a plot: `Gap (°) from 0.01 to 0.6 over Time t (s) from 0 to 0.5`.
pub fn ranges(data: &[Value], layout: &Map<String, Value>) -> String {
    let mut seen: Vec<(String, [f64; 2], String, [f64; 2])> = vec![];
    for trace in data.iter().filter_map(Value::as_object) {
        let (value, title) = match trace.get("type").and_then(Value::as_str) {
            Some("heatmap" | "surface") => ("z", colour_title(trace, layout)),
            Some("scatterpolar") => ("r", String::new()),
            Some("bar") if trace.get("orientation").is_some_and(|o| o == "h") => {
                ("x", title_of(axis_of(trace, "x"), layout))
            }
            Some("scatter" | "bar") => ("y", title_of(axis_of(trace, "y"), layout)),
            _ => continue,
        };
        let key = if trace.contains_key("surfacecolor") {
            "surfacecolor"
        } else {
            value
        };
        let (Some(range), false) = (extent(trace.get(key)), title.is_empty()) else {
            continue;
        };
        let along = match value {
            "y" => title_of(axis_of(trace, "x"), layout),
            _ => String::new(),
        };
        let over = extent(trace.get("x")).unwrap_or([f64::NAN; 2]);
        let wider = |a: &mut [f64; 2], b: [f64; 2]| *a = [a[0].min(b[0]), a[1].max(b[1])];
        match seen.iter_mut().find(|s| s.0 == title && s.2 == along) {
            Some(known) => {
                wider(&mut known.1, range);
                wider(&mut known.3, over);
            }
            None => seen.push((title, range, along, over)),
        }
    }
    let said = seen.iter().take(QUANTITIES);
    let said: Vec<String> = said
        .map(|(title, [low, high], along, over)| {
            let mut text = format!("{title} from {} to {}", short(*low), short(*high));
            if !along.is_empty() && over[0].is_finite() {
                text += &format!(
                    " over {along} from {} to {}",
                    short(over[0]),
                    short(over[1])
                );
            }
            text
        })
        .collect();
    without_markup(&said.join("; "))
}

/// Text without the tags that plotly.js reads.
fn without_markup(text: &str) -> String {
    let mut out = String::new();
    for (k, part) in text.split('<').enumerate() {
        let shown = if k == 0 {
            part
        } else {
            part.split_once('>').map_or(part, |(_, after)| after)
        };
        out.push_str(shown);
    }
    out.replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&amp;", "&")
}

/// Lowest and highest number in lists within lists.
fn extent(values: Option<&Value>) -> Option<[f64; 2]> {
    match values? {
        Value::Number(n) => n.as_f64().map(|v| [v, v]),
        Value::Array(list) => list
            .iter()
            .filter_map(|v| extent(Some(v)))
            .reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]),
        _ => None,
    }
}
