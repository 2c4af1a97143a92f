//! A finished sweep.

use serde::Serialize;

use crate::data::{Parameter, Provenance};
use crate::figures::sweep;
use crate::page::{Note, Page};
use crate::table::{Cell, Row, Table};
use crate::tables::parameter_table;
use crate::text::short;

/// All that the page of a sweep shows. What is left empty is left out of the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct SweepData {
    /// Title of the plan.
    pub title: String,
    /// Name and version of the program, instruction set.
    pub software: String,
    /// First paragraph: what was computed.
    pub lead: String,
    /// Number of variants.
    pub variants: u64,
    /// Those that failed.
    pub failed: u64,
    /// Inputs with more than one value.
    pub inputs: Vec<SweepQuantity>,
    /// Outputs with more than one value, with what they depend on.
    pub outputs: Vec<SweepOutput>,
    /// Outputs that are the same in all variants.
    pub constants: Vec<Parameter>,
    /// The best variants.
    pub best: Vec<BestVariants>,
    /// Why variants failed.
    pub failures: Vec<FailureGroup>,
    /// The plan, one line per key.
    pub plan: Vec<Parameter>,
    /// Provenance of every figure.
    pub provenance: Provenance,
}

/// An input or an output.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct SweepQuantity {
    /// Its column.
    pub name: String,
    /// Unit; may be empty.
    pub unit: String,
}

impl SweepQuantity {
    /// `name (unit)`.
    pub fn label(&self) -> String {
        match self.sign() {
            "" => self.name.clone(),
            unit => format!("{} ({unit})", self.name),
        }
    }

    /// The unit as people write it.
    pub fn sign(&self) -> &str {
        match self.unit.as_str() {
            "um" => "µm",
            "us" => "µs",
            "deg" => "°",
            unit => unit,
        }
    }
}

/// What an output depends on.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct SweepOutput {
    /// The output.
    pub quantity: SweepQuantity,
    /// Share of its variance that each of [`SweepData::inputs`] explains alone, 0 to 1.
    pub shares: Vec<Option<f64>>,
    /// How it changes with the inputs that explain most, these first.
    pub effects: Vec<MainEffect>,
    /// Its mean over the two inputs that explain most.
    pub map: Option<HeatMap>,
}

/// An output over one input.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct MainEffect {
    /// The input.
    pub input: SweepQuantity,
    /// Its levels.
    pub levels: Levels,
    /// Mean of the output at each level.
    pub mean: Vec<f64>,
    /// Least.
    pub min: Vec<f64>,
    /// Most.
    pub max: Vec<f64>,
}

/// Values of an input: those that it takes, or the middles of equal stretches.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Levels {
    /// Numbers.
    Numbers(Vec<f64>),
    /// Names.
    Names(Vec<String>),
}

impl Default for Levels {
    fn default() -> Self {
        Self::Numbers(Vec::new())
    }
}

/// Mean of an output over two inputs.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct HeatMap {
    /// Input along x.
    pub x_input: SweepQuantity,
    /// Its levels.
    pub x: Levels,
    /// Input along y.
    pub y_input: SweepQuantity,
    /// Its levels.
    pub y: Levels,
    /// Mean at each y, at each x; NaN where there is no variant.
    pub mean: Vec<Vec<f64>>,
}

/// The best variants by one output.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct BestVariants {
    /// The output.
    pub quantity: SweepQuantity,
    /// Whether more is better.
    pub high: bool,
    /// The best first.
    pub variants: Vec<BestVariant>,
}

/// One of the best variants.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct BestVariant {
    /// Its index.
    pub variant: u64,
    /// The output.
    pub value: f64,
    /// [`SweepData::inputs`] as they are to be printed.
    pub inputs: Vec<String>,
}

/// Variants that failed for one reason, numbers apart.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct FailureGroup {
    /// How many.
    pub count: u64,
    /// The first.
    pub variant: u64,
    /// Its reason.
    pub reason: String,
}

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
        page.section("What matters");
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
        page.section("The same in all variants");
        let caption = "Outputs that no input changes.";
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
            "The variants with the {} {}.",
            if best.high { "most" } else { "least" },
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
            ("Its reason".to_owned(), false),
        ],
        rows: data.failures.iter().map(row).collect(),
        ..Table::default()
    }
}
