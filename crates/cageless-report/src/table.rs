//! A table with units in its header and numbers aligned right.

use crate::data::Provenance;
use crate::figure::captioned;
use crate::text::{escape, rich, slug};

/// Bytes of a number from which on it is a list that needs several lines.
const LONG: usize = 60;

/// Content of a column, with its alignment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// Text, aligned left.
    Text,
    /// Numbers, aligned right.
    Number,
    /// Numbers that recede: differences beside their values.
    Dim,
}

/// A row.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Row {
    /// Texts from left to right.
    pub cells: Vec<String>,
    /// Whether the row is called out.
    pub marked: bool,
    /// Number of columns that the first cell takes up, in a summary row under a rule.
    pub summary: Option<usize>,
}

impl From<Vec<String>> for Row {
    fn from(cells: Vec<String>) -> Self {
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
    /// Headings with units, and what the columns hold.
    pub columns: Vec<(String, Column)>,
    /// Rows.
    pub rows: Vec<Row>,
    /// Provenance; `None` where the rows carry their own.
    pub provenance: Option<Provenance>,
}

/// Test that every cell is a number, a range of numbers or a dash.
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
        let kind =
            |k: usize| match !rows.is_empty() && numeric(rows.iter().filter_map(|r| r.get(k))) {
                true => Column::Number,
                false => Column::Text,
            };
        let columns = head.into_iter().zip((0..).map(kind)).collect();
        Self {
            label: label.to_owned(),
            caption: caption.to_owned(),
            columns,
            rows: rows.into_iter().map(Row::from).collect(),
            provenance,
            ..Self::default()
        }
    }

    /// HTML with the anchor `id`, and with its provenance if it is `sourced`.
    pub fn html(&self, id: &str, sourced: bool) -> String {
        let source = self.provenance.iter().filter(|_| sourced);
        let mut out = format!(
            "<figure id=\"{id}\" class=\"tab\">{}</figcaption><div class=\"scroll\" role=\"region\" \
             tabindex=\"0\" aria-label=\"{}\"><table><thead>",
            captioned(&self.label, &self.caption, source),
            escape(&self.label)
        );
        self.head_html(&mut out);
        out.push_str("</tr></thead><tbody>\n");
        for row in &self.rows {
            self.row_html(row, &mut out);
        }
        out.push_str("</tbody></table></div></figure>\n");
        out
    }

    /// Adds the groups of columns and the heads of the columns.
    fn head_html(&self, out: &mut String) {
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
        for (text, kind) in &self.columns {
            let class = match kind {
                Column::Text => "",
                Column::Number | Column::Dim => " class=\"num\"",
            };
            if text.is_empty() {
                out.push_str("<td></td>");
            } else {
                out.push_str(&format!("<th scope=\"col\"{class}>{}</th>", rich(text)));
            }
        }
    }

    fn row_html(&self, row: &Row, out: &mut String) {
        let class = match (row.marked, row.summary) {
            (true, _) => " class=\"marked\"",
            (_, Some(_)) => " class=\"summary\"",
            _ => "",
        };
        out.push_str(&format!("<tr{class}>"));
        let skipped = row.summary.map_or(0, |columns| columns - 1);
        let columns = self.columns.iter().skip(skipped);
        for (k, (text, (_, kind))) in row.cells.iter().zip(columns).enumerate() {
            let class = match (row.summary, kind) {
                (Some(columns), _) if k == 0 => &format!(" colspan=\"{columns}\""),
                (_, Column::Text) => "",
                // A list of numbers breaks.
                (_, Column::Number) if text.len() > LONG => " class=\"list\"",
                (None, Column::Dim) => " class=\"num dim\"",
                _ => " class=\"num\"",
            };
            let indent = if text.starts_with("  ") {
                "\u{2003}"
            } else {
                ""
            };
            out.push_str(&format!(
                "<td{class}>{indent}{}</td>",
                rich(text.trim_start())
            ));
        }
        out.push_str("</tr>\n");
    }

    /// Anchor that the label asks for.
    pub fn slug(&self) -> String {
        slug(&self.label)
    }
}
