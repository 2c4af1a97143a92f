//! Plain text tables for the terminal.

pub use cageless_report::text::shown;

/// Lines up columns: text to the left, numbers to the right. The first row is the head.
pub fn columns(rows: &[Vec<String>]) -> String {
    let width = |k: usize| {
        rows.iter()
            .filter_map(|r| r.get(k))
            .map(|c| c.chars().count())
            .max()
    };
    let widths: Vec<usize> = (0..).map_while(width).collect();
    let numeric: Vec<bool> = (0..widths.len())
        .map(|k| {
            rows.iter()
                .skip(1)
                .filter_map(|r| r.get(k))
                .all(|c| c == "-" || c.parse::<f64>().is_ok())
        })
        .collect();
    rows.iter()
        .map(|row| {
            let line: String = row
                .iter()
                .enumerate()
                .map(|(k, cell)| {
                    let pad = " ".repeat(widths[k] - cell.chars().count());
                    if numeric[k] {
                        format!("{pad}{cell}  ")
                    } else {
                        format!("{cell}{pad}  ")
                    }
                })
                .collect();
            line.trim_end().to_owned() + "\n"
        })
        .collect()
}

/// `name = value unit` lines, names lined up.
pub fn pairs(rows: &[(&str, String)]) -> String {
    let width = rows
        .iter()
        .map(|(name, _)| name.chars().count())
        .max()
        .unwrap_or(0);
    rows.iter()
        .map(|(name, value)| {
            format!(
                "{name}{}  {value}\n",
                " ".repeat(width - name.chars().count())
            )
        })
        .collect()
}

/// A line for each warning.
pub fn warnings(all: &[String]) -> String {
    all.iter().map(|w| format!("warning: {w}\n")).collect()
}
