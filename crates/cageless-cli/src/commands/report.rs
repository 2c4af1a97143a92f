//! `cageless report`.

use std::path::Path;

use cageless_report::{SweepData, sweep_page, to_json};
use cageless_results::Aim;
use cageless_study::sweep::analysis::{Goal, analyse};

use crate::args::{Output, ReportArgs};
use crate::driver::{Answer, PAGE, PAGE_DATA};
use crate::failure::Failure;
use crate::format::{columns, pairs};

/// Analyses a finished sweep.
pub fn report(args: &ReportArgs) -> Result<(), Failure> {
    let path = args.sweep.as_path();
    let folder = match &args.out {
        Some(folder) => folder,
        None if path.is_dir() => path,
        None => path.parent().unwrap_or(Path::new("")),
    };
    let goals = |names: &[String], aim| {
        let goal = |column: &String| Goal {
            column: column.clone(),
            aim,
        };
        names.iter().map(goal).collect::<Vec<_>>()
    };
    let goals = [goals(&args.low, Aim::Low), goals(&args.high, Aim::High)].concat();
    let data = analyse(path, &goals)?;
    let output = Output::of_page(args.json, args.open, folder);
    output.drive(&[PAGE, PAGE_DATA], |_| {
        Ok(Answer {
            files: output.files(|| Ok(vec![(PAGE, Some(sweep_page(&data)))]))?,
            ..Answer::new(PAGE_DATA, to_json(&data)? + "\n", text(&data))
        })
    })
}

fn text(data: &SweepData) -> String {
    let mut text = pairs(&[
        ("variants", data.variants.to_string()),
        ("failed", data.failed.to_string()),
    ]);
    let mut rows = vec![
        ["output", "explained most by", "%"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for output in &data.outputs {
        let mut shares: Vec<_> = data.inputs.iter().zip(&output.shares).collect();
        shares.sort_by(|a, b| b.1.unwrap_or(-1.0).total_cmp(&a.1.unwrap_or(-1.0)));
        if let Some((input, Some(share))) = shares.first() {
            rows.push(vec![
                output.quantity.label(),
                input.name.clone(),
                format!("{:.0}", 100.0 * share),
            ]);
        }
    }
    text += "\n";
    text + &columns(&rows)
}
