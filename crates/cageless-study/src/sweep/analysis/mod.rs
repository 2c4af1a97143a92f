//! Analysis of a finished sweep: main effects, maps, best and failed variants.
//!
//! The result is read group by group, three times; memory does not grow with it.

mod best;
mod effects;
mod failed;
mod quantities;
mod result;
mod sampling;
mod table;

use std::path::{Path, PathBuf};

pub use best::Goal;
use cageless_io::plan_file::{shortened, text_of};
use cageless_io::results::TableReader;
pub use result::{
    BestVariant, BestVariants, FailureGroup, HeatMap, Levels, MainEffect, SweepData, SweepOutput,
    SweepQuantity,
};

use crate::{Parameter, Provenance, StudyError};

use crate::sweep::footer::Identity;
use cageless_results::Aim;

use quantities::{Input, Output, POINTS_MIN, Quantities};
use sampling::Sampling;
use table::Table;

/// Result of a sweep in its folder.
const RESULT: &str = "sweep.parquet";

/// Numbers that other commands leave in their folder, and the command.
const OTHERS: [(&str, &str); 6] = [
    ("summary.json", "run` or `drop"),
    ("design.json", "design"),
    ("tolerance.json", "tolerance"),
    ("static.json", "static"),
    ("export.json", "export"),
    ("check.json", "check"),
];

/// The folder at `path` or around it and the command that left its result there, if there is
/// nothing of a sweep.
fn other_result(path: &Path) -> Option<(&Path, &'static str)> {
    let folder = if path.is_dir() { path } else { path.parent()? };
    let table = path.is_file() && path.extension().is_some_and(|e| e == "parquet");
    if table || folder.join(RESULT).exists() {
        return None;
    }
    let made = OTHERS.iter().find(|(file, _)| folder.join(file).exists())?;
    Some((folder, made.1))
}

/// Table of the result of a sweep, of which `path` is the file or the folder.
fn table_of_result(path: &Path) -> Result<PathBuf, StudyError> {
    if let Some((folder, command)) = other_result(path) {
        return Err(StudyError::Input(format!(
            "{} is the result of `cageless {command}`, not of a sweep: its page is report.html in \
             that folder; `cageless report` takes the folder of `cageless sweep`",
            folder.display()
        )));
    }
    Ok(match path.is_dir() {
        true => path.join(RESULT),
        false => path.to_owned(),
    })
}

/// Reads the result of a sweep, its file or the folder of it, and works out what its report
/// shows. Without `goals`,
/// the best variants are sought by every output of which it can be said what is better.
///
/// # Errors
/// If the file is not the complete result of a sweep, cannot be read, or a goal is not
/// one of its numbers.
pub fn analyse(path: &Path, goals: &[Goal]) -> Result<SweepData, StudyError> {
    let path = &table_of_result(path)?;
    let reader = TableReader::open(path)?;
    let identity = Identity::read(&reader).ok_or_else(|| {
        StudyError::Input(format!("{} is not the result of a sweep", path.display()))
    })?;
    let isa = reader.footer("isa").unwrap_or_default().to_owned();
    let shard = reader.footer("shard").map(str::to_owned);
    let table = Table::new(reader)?;
    let sampling = Sampling::of(&identity.plan);
    let quantities = Quantities::scan(&table, &sampling)?;
    let goals = best::goals(&table, &quantities, goals)?;
    let effects = effects::gather(&table, &quantities, &sampling)?;
    let maps = effects::maps(&table, &quantities, &effects)?;
    let outputs: Vec<SweepOutput> = effects
        .into_iter()
        .zip(maps)
        .map(|(output, map)| SweepOutput { map, ..output })
        .collect();
    let passed = passed(&table, &outputs, &quantities.constants)?;
    let (outputs, chosen) = ordered(outputs, &goals);
    let failures = failed::groups(&table)?;
    let failed = failures.iter().map(|group| group.count).sum();
    let rows = table.reader.rows();
    let inputs: Vec<_> = quantities
        .inputs
        .iter()
        .map(|i| i.quantity.clone())
        .collect();
    Ok(SweepData {
        title: title(&identity).unwrap_or_else(|| "A sweep".to_owned()),
        software: format!(
            "Cageless {}, {isa}, seed {}",
            identity.version, identity.seed
        ),
        lead: lead(rows, &identity, &inputs),
        warnings: warnings(
            rows,
            &identity,
            shard.as_deref(),
            &quantities,
            &sampling,
            &failures,
        ),
        variants: rows,
        failed,
        inputs,
        outputs,
        chosen,
        passed,
        constants: quantities.constants.clone(),
        best: best::find(&table, &quantities, &goals)?,
        failures,
        plan: parameters(&identity.plan),
        provenance: provenance(&table, &identity, path),
    })
}

/// Title of a plan, if it has one.
fn title(identity: &Identity) -> Option<String> {
    text_of(&identity.plan, "title").filter(|title| !title.is_empty())
}

/// Where the numbers of a result come from.
fn provenance(table: &Table, identity: &Identity, path: &Path) -> Provenance {
    let setting = |key: &str| text_of(&identity.plan, key);
    Provenance {
        case: title(identity).unwrap_or_else(|| path.display().to_string()),
        formulation: Some(match table.column("model_formulation") {
            Some(_) => "varies".to_owned(),
            None => (setting("case.model.formulation"))
                .or_else(|| setting("case.bearing.1.case.model.formulation"))
                .unwrap_or_default(),
        }),
        discarded: match table.column("run_settled_after_s") {
            Some(_) => "the transient of each run".to_owned(),
            None => String::new(),
        },
        ..Provenance::default()
    }
}

/// Output that says whether the raceways pass: 1 or 0.
const PASSES: &str = "verdict_passes";
/// Outputs about the computation and not about the bearing.
const BOOKKEEPING: [&str; 6] = [
    "verdict_passages",
    "run_settled_after_s",
    "run_energy_residual_relative",
    "run_simulated_s",
    "run_steps",
    "run_rhs_evaluations",
];
/// Outputs that a page shows at once, at most.
const CHOSEN_MAX: usize = 8;

/// The outputs in the order in which they are shown, and the number of those chosen: the verdict
/// and the goals.
fn ordered(mut outputs: Vec<SweepOutput>, goals: &[(&Output, Aim)]) -> (Vec<SweepOutput>, usize) {
    let rank = |output: &SweepOutput| {
        let name = output.quantity.name.as_str();
        let is_it = |(goal, _): &(&Output, Aim)| goal.quantity.name == name;
        let goal = goals.iter().position(is_it);
        match goal {
            _ if name == PASSES => 0,
            Some(k) => 1 + k,
            None if BOOKKEEPING.contains(&name) => usize::MAX,
            None => usize::MAX - 1,
        }
    };
    outputs.sort_by_key(rank);
    let chosen = outputs.iter().filter(|o| rank(o) < usize::MAX - 1).count();
    // Without goals the first results stand in for them.
    let chosen = if chosen == 0 { outputs.len() } else { chosen };
    (outputs, chosen.min(CHOSEN_MAX))
}

/// Variants of which the raceways pass, and those judged; `None` without verdicts.
fn passed(
    table: &Table,
    outputs: &[SweepOutput],
    constants: &[Parameter],
) -> Result<Option<[u64; 2]>, StudyError> {
    let is_shown = outputs.iter().any(|o| o.quantity.name == PASSES)
        || constants.iter().any(|c| c.name == PASSES);
    let Some(column) = table.column(PASSES).filter(|_| is_shown) else {
        return Ok(None);
    };
    let (mut passed, mut judged) = (0, 0);
    table.each(&[column], |row| {
        let passes = row[0].number();
        judged += u64::from(passes.is_some());
        passed += u64::from(passes == Some(1.0));
    })?;
    Ok(Some([passed, judged]))
}

fn lead(rows: u64, identity: &Identity, inputs: &[SweepQuantity]) -> String {
    let part = if rows < identity.variants {
        format!(" of {}", identity.variants)
    } else {
        String::new()
    };
    let names: Vec<_> = inputs.iter().map(|i| i.name.as_str()).collect();
    format!("{rows}{part} variants. What varies: {}.", names.join(", "))
}

/// Warnings on the numbers of a page, for its reader.
fn warnings(
    rows: u64,
    identity: &Identity,
    shard: Option<&str>,
    quantities: &Quantities,
    sampling: &Sampling,
    failures: &[FailureGroup],
) -> Vec<String> {
    let mut warnings = vec![];
    if let Some(shard) = shard {
        warnings.push(format!(
            "These are {rows} of {} variants, shard {shard}: `cageless sweep merge` joins the shards to \
             {RESULT}, whose report has all.",
            identity.variants
        ));
    }
    let failed: u64 = failures.iter().map(|group| group.count).sum();
    let (stopped, impossible): (Vec<_>, Vec<_>) =
        (failures.iter()).partition(|group| failed::is_of_computation(&group.reason));
    let count = |groups: &[&FailureGroup]| groups.iter().map(|group| group.count).sum::<u64>();
    if let Some(first) = stopped.first() {
        warnings.push(format!(
            "{} of {rows} variants lack results, as a computation failed, the most frequent reason: {}. Means, \
             shares and cells of maps that would need them have no value, and none of the best is one of them.",
            count(&stopped),
            first.reason
        ));
    }
    if !impossible.is_empty() {
        warnings.push(format!(
            "{} of {rows} variants are impossible cases, which means leave out.",
            count(&impossible)
        ));
    }
    if let Some(first) = failures.first().filter(|_| failed == rows) {
        warnings.push(format!("All variants failed: {}", first.reason));
    }
    let few = |input: &&Input| {
        let points = input.drawn.map(|drawn| sampling.points(drawn, rows));
        points.is_some_and(|points| points < POINTS_MIN * POINTS_MIN)
    };
    let few: Vec<_> = (quantities.inputs.iter().filter(few))
        .map(|input| input.quantity.name.as_str())
        .collect();
    if !few.is_empty() {
        warnings.push(format!(
            "No share is given for {}: it takes {} or more points of [samples] or draws of [scatter].",
            few.join(", "),
            POINTS_MIN * POINTS_MIN
        ));
    }
    warnings
}

/// Bytes of the longest value that a page shows in full: not the matrices of a rotor.
const VALUE_MAX: usize = 2000;

fn parameters(plan: &str) -> Vec<Parameter> {
    plan.lines()
        .filter_map(|line| line.split_once(" = "))
        .map(|(name, value)| Parameter {
            name: name.to_owned(),
            value: match value.len() {
                0..=VALUE_MAX => value.to_owned(),
                _ => shortened(value),
            },
            ..Parameter::default()
        })
        .collect()
}
