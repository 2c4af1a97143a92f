//! `cageless report`.

use std::path::Path;

use cageless_report::{SweepData, sweep_page, to_json};
use cageless_results::Aim;
use cageless_study::sweep::analysis::{Goal, analyse};

use super::sweep::{SHARD, file_name};
use crate::args::{Output, ReportArgs};
use crate::driver::{Answer, PAGE, PAGE_DATA};
use crate::failure::Failure;
use crate::format::{columns, pairs, warnings};

/// Analyses a finished sweep.
pub fn report(args: &ReportArgs) -> Result<(), Failure> {
    let path = args.sweep.as_path();
    let folder = match &args.out {
        Some(folder) => folder,
        None if path.is_dir() => path,
        None => path.parent().unwrap_or(Path::new("")),
    };
    let merged = folder.join(file_name(None));
    if args.out.is_none() && is_shard(path) && merged.exists() {
        return Err(Failure::Input(format!(
            "{}: is a shard of {}, whose report has all variants; --out writes one of the shard to \
             another folder",
            path.display(),
            merged.display()
        )));
    }
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
            files: output.files(|| Ok(vec![(PAGE, Some(sweep_page(&data).into()))]))?,
            ..Answer::new(PAGE_DATA, to_json(&data)? + "\n", text(&data))
        })
    })
}

/// Whether a file has the name of a shard, as `sweep` gives it.
fn is_shard(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.starts_with(SHARD)
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
        let (input, share) = match output.strongest(&data.inputs) {
            Some((input, share)) => (input.name.clone(), format!("{:.0}", 100.0 * share)),
            None => ("–".to_owned(), "–".to_owned()),
        };
        rows.push(vec![output.quantity.label(), input, share]);
    }
    text += "\n";
    text + &columns(&rows) + &warnings(&data.warnings)
}
