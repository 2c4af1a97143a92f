//! Data of the page of a comparison.

use cageless_study::comparison::{ComparedRing, RingComparison};

use crate::data::Provenance;
use crate::run_data::RunData;
use crate::run_report::run_data;

/// One of the runs of a comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedRun {
    /// Name in tables and legends.
    pub name: String,
    /// Data of its page.
    pub data: RunData,
}

/// The runs of a comparison from the same starts.
pub fn compared_runs(rings: &[ComparedRing], comparison: &RingComparison) -> Vec<ComparedRun> {
    let runs = rings.iter().zip(&comparison.runs);
    runs.map(|(ring, name)| ComparedRun {
        name: name.clone(),
        data: run_data(&ring.file, &ring.record),
    })
    .collect()
}

/// Film of each run, in words; empty where the runs do not differ in it.
pub fn films(runs: &[ComparedRun]) -> Vec<String> {
    let film = |run: &ComparedRun| match &run.data.provenance.film {
        Some(film) => format!("; film: {film}"),
        None => "; no film".to_owned(),
    };
    let films: Vec<String> = runs.iter().map(film).collect();
    match films.iter().all(|film| *film == films[0]) {
        true => vec![String::new(); films.len()],
        false => films,
    }
}

/// Provenance of what shows all runs; settings in which they differ stand side by side.
pub(crate) fn provenance(runs: &[ComparedRun]) -> Provenance {
    let all = || runs.iter().map(|run| &run.data.provenance);
    let joined = |of: fn(&Provenance) -> Option<String>| {
        let mut values: Vec<String> = all().filter_map(of).collect();
        values.dedup();
        (!values.is_empty()).then(|| values.join(" / "))
    };
    let oiled = all().any(|from| from.film.is_some());
    let cases = runs.iter().zip(all());
    let cases = cases.map(|(run, from)| format!("{}: {}", run.name, from.case));
    let step_us = all().next().and_then(|from| from.step_us);
    Provenance {
        case: cases.collect::<Vec<_>>().join("; "),
        formulation: joined(|from| from.formulation.clone()),
        friction_law: joined(|from| from.friction_law.clone()),
        film: joined(|from| from.film.clone().or(Some("none".to_owned()))).filter(|_| oiled),
        method: joined(|from| from.method.clone()),
        step_us: step_us.filter(|_| all().all(|from| from.step_us == step_us)),
        discarded: joined(|from| Some(from.discarded.clone())).unwrap_or_default(),
    }
}
