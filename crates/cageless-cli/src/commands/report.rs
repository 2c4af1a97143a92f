//! `cageless report`.

use std::path::Path;

use cageless_io::results::write_atomically;
use cageless_report::{SweepData, sweep_page, to_json};
use cageless_results::Aim;
use cageless_study::sweep::analysis::{Goal, analyse};

use super::files::{make_folder, open_page, print, tell, writable};
use crate::args::ReportArgs;
use crate::failure::Failure;
use crate::format::{columns, pairs};

const PAGE: &str = "report.html";
const PAGE_DATA: &str = "report.json";

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
    if !folder.as_os_str().is_empty() {
        make_folder(folder)?;
    }
    let (page, numbers) = (folder.join(PAGE), folder.join(PAGE_DATA));
    writable(&page)?;
    writable(&numbers)?;
    let json = to_json(&data)?;
    write_atomically(&page, sweep_page(&data).as_bytes())?;
    write_atomically(&numbers, json.as_bytes())?;
    if args.json {
        print(&(json + "\n"))?;
    } else {
        tell(&text(&data, &page))?;
    }
    if args.open {
        open_page(&page);
    }
    Ok(())
}

fn text(data: &SweepData, page: &Path) -> String {
    let mut text = pairs(&[
        ("page", page.display().to_string()),
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
