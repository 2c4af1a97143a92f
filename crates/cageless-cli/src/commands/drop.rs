//! `cageless drop`.

use cageless::dynamics::InstructionSet;
use cageless::simulation::Ending;
use cageless::touchdown::Scatter;
use cageless_io::results::{Metadata, RunWriter, write_atomically};
use cageless_report::drop::{DropReport, drop_page};
use cageless_study::drop::{
    DropRecord, DropResult, EnsembleResult, check_drops, check_rotor, conventional, drop_rotor,
    ensemble,
};
use cageless_study::run::Rows;
use serde::Serialize;

use super::{make_folder, print, read_case, tell, writable};
use crate::args::{DropArgs, Reference};
use crate::failure::Failure;
use crate::format::{columns, page_line, pairs};
use crate::progress::{Bars, catch_interrupt};

const SUMMARY: &str = "summary.json";
const PAGE: &str = "report.html";

/// `summary.json` of a drop.
#[derive(Serialize)]
struct DropFile<'a> {
    schema: u64,
    version: &'static str,
    isa: &'static str,
    case: cageless_io::case_file::CaseDocument,
    #[serde(flatten)]
    drop: &'a DropResult,
    #[serde(skip_serializing_if = "Option::is_none")]
    conventional: Option<&'a DropResult>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ensemble: Option<&'a EnsembleResult>,
}

/// Drops the rotor of a case.
pub fn touchdown(args: &DropArgs) -> Result<(), Failure> {
    let file = read_case(&args.case)?;
    let case = file.case();
    check_rotor(case, &args.case.case.display().to_string())?;
    if let Some(count) = args.samples {
        check_drops(count)?;
    }
    let document = file.document_as_run();
    let footer = serde_json::to_string(&document)?;
    let isa = InstructionSet::chosen().name();
    let mut writer = match &args.case.out {
        Some(dir) => {
            make_folder(dir)?;
            for name in [SUMMARY, PAGE] {
                writable(&dir.join(name))?;
            }
            let metadata = Metadata { isa, case: &footer };
            Some(RunWriter::create(dir, &metadata)?)
        }
        None => None,
    };
    let stop = catch_interrupt();
    let bars = Bars::new(&stop);
    let rows = (writer.as_mut()).map(|writer| writer as &mut (dyn Rows + Send));
    let record = drop_rotor(case, rows, &bars)?;
    if let Some(writer) = writer {
        writer.finish()?;
    }
    let complete = matches!(record.outcome.ending, Ending::Complete);
    let beside = match args.compare {
        Some(Reference::Conventional) if complete => {
            Some(drop_rotor(&conventional(case), None, &bars)?)
        }
        _ => None,
    };
    let many = match args.samples {
        Some(count) if complete => Some(ensemble(case, count, &Scatter::default(), &bars)?),
        _ => None,
    };
    let summary = DropFile {
        schema: cageless_io::results::SCHEMA,
        version: cageless_io::results::VERSION,
        isa,
        case: document,
        drop: &record.result,
        conventional: beside.as_ref().map(|other| &other.result),
        ensemble: many.as_ref(),
    };
    let json = serde_json::to_string_pretty(&summary)? + "\n";
    if let Some(dir) = &args.case.out {
        write_atomically(&dir.join(SUMMARY), json.as_bytes())?;
        let report = DropReport {
            case,
            drop: &record,
            conventional: beside.as_ref(),
            ensemble: many.as_ref(),
        };
        write_atomically(&dir.join(PAGE), drop_page(&report).as_bytes())?;
    }
    drop(bars);
    if args.case.json {
        print(&json)?;
    } else {
        let text = text(&record, beside.as_ref(), many.as_ref());
        tell(&(text + &page_line(args.case.out.as_deref(), PAGE)))?;
    }
    let kept = match &args.case.out {
        Some(dir) => format!(" What was computed until then is in {}.", dir.display()),
        None => String::new(),
    };
    match record.outcome.ending {
        Ending::Complete => Ok(()),
        Ending::Interrupted => Err(Failure::Interrupted(format!(
            "interrupted at t = {:.6} s.{kept}",
            record.outcome.end_s
        ))),
        Ending::Stopped(stop) => Err(Failure::stopped(&stop, &kept)),
        Ending::ObserverFailed(error) => Err(Failure::Other(anyhow::anyhow!(error))),
    }
}

fn text(record: &DropRecord, beside: Option<&DropRecord>, many: Option<&EnsembleResult>) -> String {
    let mut head = vec!["result".to_owned(), "value".to_owned()];
    if beside.is_some() {
        head.push("conventional".to_owned());
    }
    head.push("unit".to_owned());
    let mut rows = vec![head];
    let mut end = vec![
        "state at the end".to_owned(),
        record.result.end_state.clone(),
    ];
    end.extend(beside.map(|other| other.result.end_state.clone()));
    end.push(String::new());
    rows.push(end);
    let other = beside.map(|other| other.result.quantities());
    for (k, (name, unit, value)) in record.result.quantities().into_iter().enumerate() {
        let mut row = vec![name.to_owned(), significant(value)];
        row.extend(other.as_ref().map(|other| significant(other[k].2)));
        row.push(unit.to_owned());
        rows.push(row);
    }
    let mut text = columns(&rows);
    if let Some(many) = many {
        text += &ensemble_text(many);
    }
    text
}

fn ensemble_text(many: &EnsembleResult) -> String {
    let ends: Vec<String> = (many.end_states.iter())
        .map(|entry| format!("{} {}", entry.count, entry.end_state))
        .collect();
    let mut lines = vec![(
        "drops",
        format!("{} completed: {}", many.completed, ends.join(", ")),
    )];
    if let (Some(p), Some([low, high])) = (
        many.backward_whirl_probability,
        many.backward_whirl_interval,
    ) {
        lines.push((
            "probability of backward whirl",
            format!(
                "{:.1} % (95 %: {:.1} to {:.1} %)",
                100.0 * p,
                100.0 * low,
                100.0 * high
            ),
        ));
    }
    for reason in &many.stopped {
        lines.push(("stopped", reason.clone()));
    }
    let head = ["result", "least", "median", "95 %", "most", "unit"].map(str::to_owned);
    let mut rows = vec![head.to_vec()];
    for q in &many.quantiles {
        let numbers = [q.least, q.median, q.high, q.most].map(|v| significant(Some(v)));
        let mut row = vec![q.name.clone()];
        row.extend(numbers);
        row.push(q.unit.clone());
        rows.push(row);
    }
    format!("\n{}\n{}", pairs(&lines), columns(&rows))
}

/// A number to five significant digits; a dash where there is none.
fn significant(value: Option<f64>) -> String {
    let Some(v) = value else {
        return "-".to_owned();
    };
    if v == 0.0 || (v.fract() == 0.0 && v.abs() < 1e6) {
        return format!("{v:.0}");
    }
    if !(1e-3..1e6).contains(&v.abs()) {
        return format!("{v:.3e}");
    }
    let digits = 4 - v.abs().log10().floor() as i32;
    format!("{v:.*}", digits.max(0) as usize)
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn numbers_have_five_digits() {
        for (value, text) in [
            (0.0, "0"),
            (12.0, "12"),
            (6.38527, "6.3853"),
            (-0.0123456, "-0.012346"),
            (123_456.7, "123457"),
            (2.5e-7, "2.500e-7"),
        ] {
            assert_eq!(significant(Some(value)), text);
        }
    }
}
