//! A finished sweep.

pub use cageless_study::sweep::analysis::{
    BestVariant, BestVariants, FailureGroup, HeatMap, Levels, MainEffect, SweepData, SweepOutput,
    SweepQuantity,
};

use crate::figures::sweep;
use crate::page::{Note, Page};
use crate::table::{Cell, Row, Table};
use crate::tables::parameter_table;
use crate::text::short;

/// The page of a sweep.
pub fn sweep_page(data: &SweepData) -> String {
    let mut page = Page::new(&data.title, &data.lead, &data.software);
    if data.failed > 0 {
        let message = format!(
            "{} of {} variants failed; they are left out of all means.",
            data.failed, data.variants
        );
        page.note(Note::Warning, &message);
    }
    if !data.outputs.is_empty() && !data.inputs.is_empty() {
        page.section("Sensitivity (main effects)");
        page.figure(&sweep::shares(data));
    }
    if !data.best.is_empty() {
        page.section("Best variants");
        for best in &data.best {
            page.table(&best_table(data, best));
        }
    }
    let effects = data.outputs.iter().filter(|o| !o.effects.is_empty());
    if effects.clone().next().is_some() {
        page.section("Main effects");
        effects.for_each(|output| page.figure(&sweep::effects(output, &data.provenance)));
    }
    let maps = || {
        data.outputs
            .iter()
            .filter_map(|o| Some((o, o.map.as_ref()?)))
    };
    if maps().next().is_some() {
        page.section("Maps");
        maps().for_each(|(output, map)| page.figure(&sweep::map(output, map, &data.provenance)));
    }
    if !data.failures.is_empty() {
        page.section("Failed variants");
        page.table(&failure_table(data));
    }
    if !data.constants.is_empty() {
        page.section("Constant outputs");
        let caption = "Outputs that do not depend on any input.";
        page.table(&parameter_table(
            "Constants",
            caption,
            &data.constants,
            None,
        ));
    }
    if !data.plan.is_empty() {
        page.section("The plan");
        let caption = "Every key of the plan and of its case.";
        page.table(&parameter_table("Plan", caption, &data.plan, None));
    }
    page.html()
}

fn best_table(data: &SweepData, best: &BestVariants) -> Table {
    let mut columns = vec![("Variant".to_owned(), true), (best.quantity.label(), true)];
    columns.extend(data.inputs.iter().map(|input| (input.label(), true)));
    let row = |variant: &BestVariant| {
        let mut cells = vec![
            Cell::number(variant.variant.to_string()),
            Cell::number(short(variant.value)),
        ];
        cells.extend(variant.inputs.iter().map(Cell::number));
        Row {
            cells,
            ..Row::default()
        }
    };
    Table {
        label: format!("Best by {}", best.quantity.name),
        caption: format!(
            "{} {}.",
            if best.high { "Highest" } else { "Lowest" },
            best.quantity.name
        ),
        columns,
        rows: best.variants.iter().map(row).collect(),
        provenance: Some(data.provenance.clone()),
        ..Table::default()
    }
}

fn failure_table(data: &SweepData) -> Table {
    let row = |group: &FailureGroup| Row {
        cells: vec![
            Cell::number(group.count.to_string()),
            Cell::number(group.variant.to_string()),
            Cell::text(&group.reason),
        ],
        ..Row::default()
    };
    Table {
        label: "Failed".to_owned(),
        caption: "Variants that failed, by their reason, and the first of each.".to_owned(),
        columns: vec![
            ("Variants".to_owned(), true),
            ("First".to_owned(), true),
            ("Reason of the first".to_owned(), false),
        ],
        rows: data.failures.iter().map(row).collect(),
        ..Table::default()
    }
}
