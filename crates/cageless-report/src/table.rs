//! A table with units in its header and numbers aligned right.

use crate::data::Provenance;
use crate::figure::captioned;
use crate::text::{escape, rich, slug};

/// Bytes of a number from which on it is a list that needs several lines.
const LONG: usize = 60;

/// A cell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cell {
    /// Text as printed.
    pub text: String,
    /// Whether it is a number, to be aligned right.
    pub numeric: bool,
    /// Whether it recedes: a difference beside its value.
    pub dim: bool,
    /// Columns it takes up; 0 counts as 1.
    pub columns: usize,
}

impl Cell {
    /// Text, aligned left.
    pub fn text(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            ..Self::default()
        }
    }

    /// A number, aligned right.
    pub fn number(text: impl Into<String>) -> Self {
        Self {
            numeric: true,
            ..Self::text(text)
        }
    }

    /// A number that recedes.
    pub fn dim(text: impl Into<String>) -> Self {
        Self {
            dim: true,
            ..Self::number(text)
        }
    }
}

/// A row.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Row {
    /// Cells from left to right.
    pub cells: Vec<Cell>,
    /// Whether the row is called out.
    pub marked: bool,
    /// Whether it is a summary under a rule.
    pub summary: bool,
}

impl From<Vec<Cell>> for Row {
    fn from(cells: Vec<Cell>) -> Self {
        Self {
            cells,
            ..Self::default()
        }
    }
}

/// A table.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// `Table 2`; its slug is the anchor.
    pub label: String,
    /// Caption of the table.
    pub caption: String,
    /// Headings over several columns, as `(text, columns)`; may be empty.
    pub groups: Vec<(String, usize)>,
    /// Headings with units, and whether the column holds numbers.
    pub columns: Vec<(String, bool)>,
    /// Rows.
    pub rows: Vec<Row>,
    /// Provenance; `None` where the rows carry their own.
    pub provenance: Option<Provenance>,
}

/// Whether all cells are numbers, ranges of them, or dashes.
fn numeric<'c>(cells: impl Iterator<Item = &'c String>) -> bool {
    let is_number = |text: &str| text == "–" || text.replace('−', "-").parse::<f64>().is_ok();
    let is_numeric = |cell: &String| {
        let cell = cell.replace(" × 10", "e");
        let mut parts = cell.split([' ', 'e']).filter(|p| !matches!(*p, "…" | "±"));
        parts.all(|part| is_number(part) || part.chars().all(|c| "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c)))
    };
    let mut cells = cells;
    cells.all(is_numeric)
}

impl Table {
    /// A table of texts, the first row the head.
    pub fn of(
        label: &str,
        caption: &str,
        rows: Vec<Vec<String>>,
        provenance: Option<Provenance>,
    ) -> Self {
        let mut rows = rows.into_iter();
        let head = rows.next().unwrap_or_default();
        let rows: Vec<Vec<String>> = rows.collect();
        let numeric: Vec<bool> = (0..head.len())
            .map(|k| !rows.is_empty() && numeric(rows.iter().filter_map(|row| row.get(k))))
            .collect();
        let cell = |(text, numeric): (String, &bool)| match numeric {
            true => Cell::number(text),
            false => Cell::text(text),
        };
        let row = |row: Vec<String>| -> Row {
            let cells: Vec<Cell> = row.into_iter().zip(&numeric).map(cell).collect();
            cells.into()
        };
        Self {
            label: label.to_owned(),
            caption: caption.to_owned(),
            rows: rows.into_iter().map(row).collect(),
            columns: head.into_iter().zip(numeric.iter().copied()).collect(),
            provenance,
            ..Self::default()
        }
    }

    /// HTML with the anchor `id`.
    pub fn html(&self, id: &str) -> String {
        let mut out = format!(
            "<figure id=\"{id}\" class=\"tab\">{}</figcaption><div class=\"scroll\" role=\"region\" \
             tabindex=\"0\" aria-label=\"{}\"><table><thead>",
            captioned(&self.label, &self.caption, self.provenance.iter()),
            escape(&self.label)
        );
        if !self.groups.is_empty() {
            out.push_str("<tr class=\"groups\">");
            for (text, span) in &self.groups {
                if text.is_empty() {
                    out.push_str(&format!("<td colspan=\"{span}\"></td>"));
                } else {
                    out.push_str(&format!(
                        "<th scope=\"colgroup\" colspan=\"{span}\">{}</th>",
                        rich(text)
                    ));
                }
            }
            out.push_str("</tr>");
        }
        out.push_str("<tr>");
        for (text, numeric) in &self.columns {
            let class = if *numeric { " class=\"num\"" } else { "" };
            if text.is_empty() {
                out.push_str("<td></td>");
            } else {
                out.push_str(&format!("<th scope=\"col\"{class}>{}</th>", rich(text)));
            }
        }
        out.push_str("</tr></thead><tbody>\n");
        for row in &self.rows {
            let class = match (row.marked, row.summary) {
                (true, _) => " class=\"marked\"",
                (_, true) => " class=\"summary\"",
                _ => "",
            };
            out.push_str(&format!("<tr{class}>"));
            for cell in &row.cells {
                let class = match (cell.numeric, cell.dim) {
                    // A list of numbers breaks.
                    (true, _) if cell.text.len() > LONG => " class=\"list\"",
                    (_, true) => " class=\"num dim\"",
                    (true, _) => " class=\"num\"",
                    _ => "",
                };
                let span = match cell.columns {
                    0 | 1 => String::new(),
                    columns => format!(" colspan=\"{columns}\""),
                };
                out.push_str(&format!("<td{class}{span}>{}</td>", rich(&cell.text)));
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody></table></div></figure>\n");
        out
    }

    /// Anchor that the label asks for.
    pub fn slug(&self) -> String {
        slug(&self.label)
    }
}
