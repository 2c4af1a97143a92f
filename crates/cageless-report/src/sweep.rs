//! A finished sweep.

pub use cageless_study::sweep::analysis::{
    BestVariant, BestVariants, FailureGroup, HeatMap, Levels, MainEffect, SweepData, SweepOutput,
    SweepQuantity,
};

use cageless_study::parameter;

use crate::figures::sweep;
use crate::head::Head;
use crate::names;
use crate::page::{Note, Page};
use crate::table::{Column, Table};
use crate::text::short;

/// Tables of best variants that are shown at once.
const TABLES_SHOWN: usize = 2;
/// Outputs of which effects and a map are shown at once.
const OUTPUTS_SHOWN: usize = 3;

/// The page of a sweep.
pub fn sweep_page(data: &SweepData) -> String {
    let mut lead = data.lead.clone();
    for input in &data.inputs {
        lead = lead.replace(&input.name, &names::name(input));
    }
    let mut page = Page::new(&data.title, &lead, &data.software);
    page.head(&head(data));
    for warning in &data.warnings {
        page.note(Note::Warning, warning);
    }
    page.section("Best variants");
    let tables = |page: &mut Page, best: &[BestVariants]| {
        best.iter().for_each(|b| page.table(&best_table(data, b)));
    };
    let (first, others) = data.best.split_at(TABLES_SHOWN.min(data.best.len()));
    tables(&mut page, first);
    let summary = format!("Best variants by {} more outputs", others.len());
    page.fold(&summary, |page| tables(page, others));
    let given = |output: &SweepOutput| output.shares.iter().any(Option::is_some);
    let drawn = |output: &SweepOutput| given(output) || output.map.is_some();
    if data.outputs.iter().any(drawn) {
        page.section("Sensitivity (main effects)");
        if data.outputs.iter().any(given) {
            page.figure(&sweep::shares(data));
        }
        let figures = |page: &mut Page, outputs: &[SweepOutput]| {
            outputs.iter().for_each(|o| output_figures(page, o, data));
        };
        let shown = data.chosen.min(OUTPUTS_SHOWN).min(data.outputs.len());
        let (first, others) = data.outputs.split_at(shown);
        figures(&mut page, first);
        let summary = format!("Effects on {} more outputs", others.len());
        page.fold(&summary, |page| figures(page, others));
    }
    page.section("Failed variants");
    if !data.failures.is_empty() {
        page.table(&failure_table(data));
    }
    page.section("Plan and constants");
    let folded = |page: &mut Page, label, summary, lines| {
        let caption = format!("{summary}.");
        page.fold(summary, |page| {
            page.parameters(label, &caption, lines, None)
        });
    };
    let constants = "Outputs that do not depend on any input";
    folded(&mut page, "Constants", constants, &data.constants);
    folded(
        &mut page,
        "Plan",
        "Every key of the plan and of its case",
        &data.plan,
    );
    page.html()
}

/// Effects of the inputs on one output, and its map.
fn output_figures(page: &mut Page, output: &SweepOutput, data: &SweepData) {
    if !output.effects.is_empty() {
        page.figure(&sweep::effects(output, &data.provenance));
    }
    // An input without an effect makes no map.
    if let Some(map) = &output.map
        && (output.effects.len() > 1 || output.missing > 0)
    {
        page.figure(&sweep::map(output, map, &data.provenance));
    }
}

/// Variants that pass, and the best values of the first goals.
fn head(data: &SweepData) -> Head {
    let mut head = Head::default();
    if let Some([passed, judged]) = data.passed {
        let share = 100.0 * passed as f64 / judged.max(1) as f64;
        head = head.verdict(
            (judged > 0).then_some(passed > 0),
            &format!("{passed} of {judged} variants pass ({share:.0} %)"),
        );
    }
    let mut facts = vec![
        parameter("variants", data.variants.to_string(), ""),
        parameter("failed", data.failed.to_string(), ""),
    ];
    let goals = data.best.iter();
    let goals = goals.filter(|b| b.quantity.name != "verdict_passes");
    for best in goals.take(4) {
        let (which, better): (_, fn(f64, f64) -> f64) = match best.high {
            true => ("highest", f64::max),
            false => ("lowest", f64::min),
        };
        if let Some(value) = best.variants.iter().map(|v| v.value).reduce(better) {
            let name = format!("{which} {}", names::name(&best.quantity));
            facts.push(parameter(&name, short(value), &best.quantity.sign()));
        }
    }
    head.facts(facts)
}

fn best_table(data: &SweepData, best: &BestVariants) -> Table {
    // Conditions first: the best are sought at each of them.
    let mut order: Vec<usize> = (0..data.inputs.len()).collect();
    order.sort_by_key(|k| !data.inputs[*k].is_condition());
    let inputs = order.iter().map(|k| names::label(&data.inputs[*k]));
    let numbers = inputs.chain([names::label(&best.quantity)]);
    let mut columns: Vec<_> = numbers.map(|name| (name, Column::Number)).collect();
    columns.push(("Variant".to_owned(), Column::Dim));
    let row = |variant: &BestVariant| {
        let input = |k: &usize| variant.inputs.get(*k).cloned().unwrap_or_default();
        let own = [short(variant.value), variant.variant.to_string()];
        order
            .iter()
            .map(input)
            .chain(own)
            .collect::<Vec<_>>()
            .into()
    };
    let name = names::name(&best.quantity);
    Table {
        label: format!("Best by {name}"),
        caption: format!(
            "{} {name}{} (`{}`).",
            if best.high { "Highest" } else { "Lowest" },
            if best.per_condition {
                " at each combination of the conditions of operation"
            } else {
                ""
            },
            best.quantity.name
        ),
        columns,
        rows: best.variants.iter().map(row).collect(),
        provenance: Some(data.provenance.clone()),
        ..Table::default()
    }
}

fn failure_table(data: &SweepData) -> Table {
    let row = |group: &FailureGroup| {
        let counts = [group.count, group.variant].map(|n| n.to_string());
        counts.into_iter().chain([group.reason.clone()]).collect()
    };
    let head = ["Variants", "First", "Reason of the first"].map(str::to_owned);
    let rows = [head.to_vec()]
        .into_iter()
        .chain(data.failures.iter().map(row));
    let caption = "Variants that failed, by their reason, and the first of each.";
    Table::of("Failed", caption, rows.collect(), None)
}
