//! The tables: parameters (Table 1), critical gaps (Table 2) and their spread.

use crate::data::{Parameter, Provenance};
use crate::reproduce_data::{Table2, Table2Row};
use crate::table::{Column, Row, Table};
use crate::text::{fixed, signed};

/// Table 1 and what the paper leaves out.
pub fn table1(parameters: &[Parameter]) -> Table {
    parameter_table(
        "Table 1",
        "Parameters of the paper, and those that it does not give.",
        parameters,
        None,
    )
}

/// A table of parameters or results.
pub fn parameter_table(
    label: &str,
    caption: &str,
    parameters: &[Parameter],
    provenance: Option<Provenance>,
) -> Table {
    let symbols = parameters.iter().any(|p| !p.symbol.is_empty());
    let sources = parameters.iter().any(|p| !p.source.is_empty());
    let shown = [true, symbols, true, true, sources];
    let columns = [
        ("Parameter", Column::Text),
        ("Symbol", Column::Text),
        ("Value", Column::Number),
        ("Unit", Column::Text),
        ("Source", Column::Text),
    ];
    let row = |p: &Parameter| -> Row {
        let texts = chosen([&p.name, &p.symbol, &p.value, &p.unit, &p.source], shown);
        texts.cloned().collect::<Vec<_>>().into()
    };
    Table {
        label: label.to_owned(),
        caption: caption.to_owned(),
        columns: chosen(columns, shown)
            .map(|(name, kind)| (name.to_owned(), kind))
            .collect(),
        rows: parameters.iter().map(row).collect(),
        provenance,
        ..Table::default()
    }
}

fn chosen<T>(all: [T; 5], shown: [bool; 5]) -> impl Iterator<Item = T> {
    let all = all.into_iter().zip(shown);
    all.filter(|(_, shown)| *shown).map(|(one, _)| one)
}

/// Table 2: theory and critical gap, computed beside the paper's.
pub fn table2(table: &Table2) -> Table {
    let polar = table.rows.iter().any(|r| r.theory_polar_deg.is_some());
    let remarks = table.rows.iter().any(|r| !r.remark.is_empty());
    let mut groups = vec![
        ("Structure".to_owned(), 2),
        ("Theory β0, Eq. (11) (°)".to_owned(), 2 + usize::from(polar)),
        ("Paper, simulated (°)".to_owned(), 2),
    ];
    let number = |text: &str| (text.to_owned(), Column::Number);
    let less = |text: &str| (text.to_owned(), Column::Dim);
    let mut columns = vec![
        number("lC (mm)"),
        number("θ (°)"),
        number("computed"),
        number("paper"),
    ];
    if polar {
        columns.push(number("own ψ"));
    }
    columns.extend([number("gap"), less("less theory")]);
    for variant in &table.variants {
        let compared = variant.is_of_the_paper();
        groups.push((
            format!("{}, {} (°)", variant.formulation, variant.friction_law),
            1 + usize::from(compared),
        ));
        columns.push(number("gap"));
        columns.extend(compared.then(|| less("Δ paper")));
    }
    let mut rows: Vec<Row> = table
        .rows
        .iter()
        .map(|r| table2_row(table, r, polar))
        .collect();
    rows.push(summary(table, "largest |Δ|, all rows", polar, |_| true));
    let mut caption = "Discrete angular spacing of the ten structures: theory, the paper's \
                       simulated values, and the computed critical gap, the largest with which a \
                       pair still touches on its way through the raceway. Δ: computed less the \
                       paper's simulated value. paper, physical: the equations as published and as mechanics \
                       has them; elastic: the latter on flanks that yield."
        .to_owned();
    if remarks {
        rows.push(summary(table, "without the marked rows", polar, |r| {
            r.remark.is_empty()
        }));
        for row in table.rows.iter().filter(|r| !r.remark.is_empty()) {
            let span = fixed(Some(row.structure.axial_span_mm), 2);
            caption.push_str(&format!(" Marked: lC {span} mm {}.", row.remark));
        }
    }
    Table {
        label: "Table 2".to_owned(),
        caption,
        groups,
        columns,
        rows,
        provenance: Some(table.provenance.clone()),
    }
}

fn table2_row(table: &Table2, row: &Table2Row, polar: bool) -> Row {
    let less = |difference: Option<f64>| signed(difference, 4);
    let mut cells = vec![
        fixed(Some(row.structure.axial_span_mm), 2),
        fixed(Some(row.structure.half_angle_deg), 3),
        fixed(Some(row.theory_deg), 4),
        fixed(Some(row.paper_theory_deg), 4),
    ];
    if polar {
        cells.push(fixed(row.theory_polar_deg, 3));
    }
    cells.push(fixed(Some(row.paper_simulated_deg), 4));
    cells.push(less(Some(row.paper_simulated_deg - row.paper_theory_deg)));
    for (k, variant) in table.variants.iter().enumerate() {
        let gap = row.critical_gap_deg.get(k).copied().flatten();
        let compared = variant.is_of_the_paper();
        cells.push(fixed(gap, if compared { 4 } else { 3 }));
        let difference = gap.map(|g| g - row.paper_simulated_deg);
        cells.extend(compared.then(|| less(difference)));
    }
    Row {
        cells,
        marked: !row.remark.is_empty(),
        summary: None,
    }
}

/// Largest difference to the paper per variant, over the rows that `counts`.
fn summary(table: &Table2, name: &str, polar: bool, counts: impl Fn(&Table2Row) -> bool) -> Row {
    let mut cells = vec![name.to_owned()];
    for (k, variant) in table.variants.iter().enumerate() {
        cells.push(String::new());
        if !variant.is_of_the_paper() {
            continue;
        }
        let difference = |row: &Table2Row| {
            let gap = row.critical_gap_deg.get(k).copied().flatten()?;
            Some((gap - row.paper_simulated_deg).abs()).filter(|d| d.is_finite())
        };
        let counted = table.rows.iter().filter(|row| counts(row));
        let most = counted.filter_map(difference).reduce(f64::max);
        cells.push(fixed(most, 4));
    }
    Row {
        cells,
        marked: false,
        summary: Some(6 + usize::from(polar)),
    }
}

/// Sensitivity of the critical gaps to parameters that the paper does not give; `None` if nothing
/// was varied.
pub fn spread(table: &Table2) -> Option<Table> {
    if table.spreads.is_empty() {
        return None;
    }
    let spans = table.rows.iter();
    let spans = spans.map(|row| fixed(Some(row.structure.axial_span_mm), 2));
    let mut rows = vec![vec!["Changed".to_owned(), "Variant".to_owned()]];
    rows[0].extend(spans.chain(["largest".to_owned()]));
    rows.extend(table.spreads.iter().map(|s| {
        let change = |k: usize| s.change_deg.get(k).copied().flatten();
        let finite = s
            .change_deg
            .iter()
            .flatten()
            .copied()
            .filter(|c| c.is_finite());
        let most = finite.reduce(|a, b| if b.abs() > a.abs() { b } else { a });
        let changes = (0..table.rows.len()).map(change).chain([most]);
        let changes = changes.map(|change| signed(change, 3));
        let first = [s.cause.clone(), s.variant.clone()];
        first.into_iter().chain(changes).collect()
    }));
    let caption = "How far the computed critical gaps move with what the paper leaves open: change in \
                   degrees per structure, in the order of Table 2.";
    let changes = "Change of the critical gap (°) at lC (mm)".to_owned();
    let empty = String::new;
    Some(Table {
        groups: vec![(empty(), 2), (changes, table.rows.len()), (empty(), 1)],
        ..Table::of(
            "Spread of Table 2",
            caption,
            rows,
            Some(table.provenance.clone()),
        )
    })
}
